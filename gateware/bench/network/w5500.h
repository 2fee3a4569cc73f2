// SPDX-License-Identifier: BSD-3-Clause
//
// Model of a W5500 on SPI, according to its datasheet (version 1.0.9), for raw frames: registers, buffers, commands,
// and checks of its pins. A byte takes 80 ns on its cable.
//
// Tests can put faults into it: it does not report that a frame was sent, reports an impossible length, or loses its
// power.

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace w5500 {

constexpr unsigned MEMORY = 1 << 14;
constexpr unsigned COMMON = 0, SOCKET = 1, TX = 2, RX = 3;
constexpr unsigned MR = 0x00, SHAR = 0x09;
constexpr unsigned SN_MR = 0x00, SN_CR = 0x01, SN_IR = 0x02, SN_SR = 0x03, RX_SIZE = 0x1E, TX_SIZE = 0x1F;
constexpr unsigned TX_RD = 0x22, TX_WR = 0x24, RX_RSR = 0x26, RX_RD = 0x28;
constexpr uint8_t OPEN = 0x01, CLOSE = 0x10, SEND = 0x20, RECV = 0x40;
constexpr uint8_t SEND_OK = 0x10, MACRAW = 0x42;
constexpr size_t SHORTEST = 60, LONGEST = 1514, AROUND = 24;

using Bytes = std::vector<uint8_t>;

struct Pins {
	bool sck, cs_n, mosi, rst_n;
};

class Chip {
public:
	// The first violation of the datasheet.
	std::string complaint;
	// Frames on the cable towards the host, with the cycles of their begin and end.
	struct Sent {
		Bytes frame;
		uint64_t began, ended;
	};
	std::deque<Sent> sent;
	std::deque<Bytes> towards;
	unsigned resets = 0, dropped = 0;
	// Faults: number of frames sent without a report; length of the next frame if not -1; value of the pointers when the
	// socket is opened; number of polls before a command is accepted.
	unsigned unsaid = 0, busy = 0;
	int length = -1;
	uint16_t first = 0;

	explicit Chip(unsigned cycles_of_byte) : cycles_of_byte(cycles_of_byte) {
		lose_power();
	}

	void lose_power() {
		common.assign(64, 0);
		for (auto &socket : sockets) {
			socket.assign(48, 0);
			socket[RX_SIZE] = socket[TX_SIZE] = 2;
		}
		rx.assign(MEMORY, 0);
		tx.assign(MEMORY, 0);
		sending = false;
	}

	bool is_open() const {
		return sockets[0][SN_SR] == MACRAW;
	}

	// Simulates a cycle with these pins; returns MISO for the next cycle.
	bool tick(const Pins &pins) {
		cycle++;
		the_cable();
		if (!pins.rst_n && was.rst_n) {
			resets++;
			lose_power();
			reset_at = cycle;
		}
		// The datasheet requires RSTn to be low for 500 us.
		if (pins.rst_n && !was.rst_n && was_up && (cycle - reset_at) * 1000 < 500 * cycles_of_ms())
			complain("RSTn is low for too short a time");
		was_up = was_up || pins.rst_n;
		if (!pins.cs_n && was.cs_n)
			begin(pins);
		// A reset of the gateway may end an access at any point.
		if (pins.cs_n && !was.cs_n && pins.rst_n)
			end();
		if (!pins.cs_n && !was.cs_n && pins.sck != was.sck)
			edge(pins);
		was = pins;
		return miso;
	}

private:
	const unsigned cycles_of_byte;
	std::vector<uint8_t> common, rx, tx, sockets[8];
	Pins was{false, true, false, false};
	bool was_up = false, miso = false, sending = false;
	uint64_t cycle = 0, reset_at = 0, ended_at = 0, done_at = 0, free_at = 0;
	unsigned bits = 0, looks = 0;
	uint16_t rx_write = 0, address = 0;
	uint8_t came = 0, given = 0;
	Bytes head;

	// A byte on the cable takes 80 ns.
	uint64_t cycles_of_ms() const {
		return uint64_t(cycles_of_byte) * 12500;
	}

	void complain(const std::string &what) {
		if (complaint.empty())
			complaint = what;
	}

	uint16_t get(unsigned place) const {
		return uint16_t(sockets[0][place] << 8 | sockets[0][place + 1]);
	}

	void put(unsigned place, uint16_t value) {
		sockets[0][place] = uint8_t(value >> 8);
		sockets[0][place + 1] = uint8_t(value);
	}

	unsigned size_of(unsigned place) {
		unsigned sum = 0;
		for (auto &socket : sockets)
			sum += socket[place];
		if (sum > 16)
			complain("the sockets have more than 16 KiB");
		return unsigned(sockets[0][place]) << 10;
	}

	void the_cable() {
		if (sending && cycle >= done_at) {
			sending = false;
			if (unsaid)
				unsaid--;
			else
				sockets[0][SN_IR] |= SEND_OK;
		}
		if (!towards.empty() && cycle >= free_at) {
			Bytes frame = towards.front();
			towards.pop_front();
			receive(frame);
			if (!towards.empty())
				free_at = cycle + (towards.front().size() + AROUND) * cycles_of_byte;
		}
	}

	void receive(const Bytes &frame) {
		bool own = true;
		for (unsigned place = 0; place < 6; place++)
			own = own && frame[place] == common[SHAR + place];
		if (!is_open() || frame.size() + 2 + get(RX_RSR) > size_of(RX_SIZE)) {
			dropped++;
			return;
		}
		if ((sockets[0][SN_MR] & 0x80) && !own && !(frame[0] & 1))
			return;
		unsigned told = length >= 0 ? unsigned(length) : unsigned(frame.size() + 2);
		length = -1;
		keep(uint8_t(told >> 8));
		keep(uint8_t(told));
		for (uint8_t byte : frame)
			keep(byte);
		put(RX_RSR, uint16_t(rx_write - get(RX_RD)));
	}

	void keep(uint8_t byte) {
		rx[rx_write++ % size_of(RX_SIZE)] = byte;
	}

	void begin(const Pins &pins) {
		if (pins.sck)
			complain("SCLK is high where SCSn falls");
		if (ended_at && (cycle - ended_at) * 12500000 < 30 * cycles_of_ms() / 1000 * 12500)
			complain("SCSn is high for too short a time");
		head.clear();
		bits = 0;
		came = given = 0;
		miso = false;
	}

	void end() {
		if (bits % 8)
			complain("an access ends within a byte");
		ended_at = cycle;
	}

	void edge(const Pins &pins) {
		if (pins.sck) {
			came = uint8_t(came << 1 | pins.mosi);
			bits++;
		} else {
			if (bits % 8 == 0)
				given = exchange(came);
			miso = given >> (7 - bits % 8) & 1;
		}
	}

	// Receives a byte, and returns the byte to send while the next one is received.
	uint8_t exchange(uint8_t byte) {
		if (head.size() < 3) {
			head.push_back(byte);
			address = uint16_t(head[0] << 8 | (head.size() > 1 ? head[1] : 0));
			if (head.size() == 3 && (byte & 3))
				complain("an access has a fixed length");
		} else {
			if (head[2] & 4)
				write(head[2] >> 3, address, byte);
			address++;
		}
		return head.size() == 3 && !(head[2] & 4) ? read(head[2] >> 3, address) : 0;
	}

	uint8_t read(unsigned block, unsigned place) {
		if (block == COMMON)
			return place < common.size() ? common[place] : 0;
		if (block == TX)
			return tx[place % size_of(TX_SIZE)];
		if (block == RX)
			return rx[place % size_of(RX_SIZE)];
		if (block % 4 != SOCKET) {
			complain("the buffer of another socket is read");
			return 0;
		}
		auto &socket = sockets[block / 4];
		if (place == SN_CR && socket[SN_CR] && looks-- == 0)
			socket[SN_CR] = 0;
		return place < socket.size() ? socket[place] : 0;
	}

	void write(unsigned block, unsigned place, uint8_t byte) {
		if (block == TX) {
			if (sending)
				complain("a frame is written before the last one was sent");
			tx[place % size_of(TX_SIZE)] = byte;
		} else if (block == COMMON && place == MR && (byte & 0x80)) {
			lose_power();
		} else if (block == COMMON && place < common.size()) {
			common[place] = byte;
		} else if (block % 4 == SOCKET && place < sockets[0].size()) {
			auto &socket = sockets[block / 4];
			if (place == SN_IR) {
				socket[SN_IR] &= uint8_t(~byte);
			} else {
				if (place == SN_CR && socket[SN_CR])
					complain("a command comes before the last one was accepted");
				socket[place] = byte;
				if (place == SN_CR && block == SOCKET)
					command(byte);
			}
		} else {
			complain("a place is written that there is not");
		}
	}

	void command(uint8_t byte) {
		looks = busy;
		if (byte == OPEN) {
			if ((sockets[0][SN_MR] & 0x0F) != 0x04)
				complain("the socket is not opened for raw frames");
			sockets[0][SN_SR] = MACRAW;
			for (unsigned place : {TX_RD, TX_WR, RX_RD})
				put(place, first);
			put(RX_RSR, 0);
			rx_write = first;
		} else if (byte == CLOSE) {
			sockets[0][SN_SR] = 0;
			sending = false;
		} else if (byte == RECV) {
			put(RX_RSR, uint16_t(rx_write - get(RX_RD)));
		} else if (byte == SEND) {
			send();
		} else {
			complain("a command is not known");
		}
	}

	void send() {
		uint16_t from = get(TX_RD), size = uint16_t(get(TX_WR) - from);
		if (size < SHORTEST || size > LONGEST) {
			complain("a frame has " + std::to_string(size) + " bytes");
			return;
		}
		Bytes frame;
		for (unsigned place = 0; place < size; place++)
			frame.push_back(tx[uint16_t(from + place) % size_of(TX_SIZE)]);
		put(TX_RD, get(TX_WR));
		sending = true;
		done_at = cycle + (size + AROUND) * cycles_of_byte;
		sent.push_back({frame, cycle, done_at});
	}
};

}  // namespace w5500

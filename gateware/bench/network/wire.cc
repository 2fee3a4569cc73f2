// SPDX-License-Identifier: BSD-3-Clause
//
// A compiled gateway with RMII or a W5500 at a cable: frames are transferred symbol by symbol, or byte by byte with the
// chip, and its bus is a memory. Core and PHY have the same clock of 50 MHz.
//
// UL_MODEL is the C++ of `unity_link` with physical = "rmii" or "w5500"; UL_HAS_PHY is defined for the first.

#include <cstdint>
#include <cstring>
#include <deque>
#include <vector>

#include UL_MODEL

#include "w5500.h"

namespace {

struct Symbol {
	uint8_t data;
	bool valid;
	bool error;
};

struct Frame {
	uint64_t began;
	uint64_t ended;
	std::vector<uint8_t> symbols;
};

// Answer of the bus at an address.
enum class Answer : uint8_t { Word, Error, None };

struct Wire {
	cxxrtl_design::p_unity__link top;
	std::deque<Symbol> towards;
	std::deque<Frame> back;
	std::vector<uint8_t> symbols;
	uint64_t cycle = 0;
	uint64_t began = 0;
	bool acknowledged = false;
	uint32_t memory[256] = {};
	Answer answers[256] = {};
	std::vector<uint64_t> log;
	// A byte takes 80 ns.
	w5500::Chip chip{4};

	Wire() {
		top.p_clk.set<bool>(true);
		top.p_phy__rx__clk.set<bool>(true);
		top.p_phy__tx__clk.set<bool>(true);
		reset();
	}

	void reset() {
		top.p_rst.set<bool>(true);
		for (int i = 0; i < 10; i++)
			tick();
		top.p_rst.set<bool>(false);
		for (int i = 0; i < 30; i++)
			tick();
	}

	void tick() {
		Symbol now{0, false, false};
		if (!towards.empty()) {
			now = towards.front();
			towards.pop_front();
		}
		top.p_phy__rxd.set<uint8_t>(now.data);
		top.p_phy__rx__dv.set<bool>(now.valid);
		top.p_phy__rx__er.set<bool>(now.error);
		top.p_spi__miso.set<bool>(chip.tick(
		    {top.p_spi__sck.get<bool>(), top.p_spi__cs__n.get<bool>(), top.p_spi__mosi.get<bool>(), top.p_spi__rst__n.get<bool>()}));
		while (!chip.sent.empty() && cycle >= chip.sent.front().ended) {
			back.push_back({chip.sent.front().began, chip.sent.front().ended, chip.sent.front().frame});
			chip.sent.pop_front();
		}
		// Like a memory with a register for `ack`: an access is answered in the next cycle.
		bool asked = top.p_wb__cyc.get<bool>() && top.p_wb__stb.get<bool>() && !acknowledged;
		uint32_t address = top.p_wb__adr.get<uint32_t>() & 255;
		top.p_wb__ack.set<bool>(asked && answers[address] == Answer::Word);
		top.p_wb__err.set<bool>(asked && answers[address] == Answer::Error);
		top.p_wb__dat__i.set<uint32_t>(memory[address]);
		if (asked && answers[address] == Answer::Word && top.p_wb__we.get<bool>()) {
			memory[address] = top.p_wb__dat__o.get<uint32_t>();
			log.push_back(uint64_t(address) << 32 | memory[address]);
		}
		acknowledged = asked && answers[address] != Answer::None;
		// One evaluation with rising clocks settles the logic and computes the next values of the registers.
		top.prev_p_clk.set<bool>(false);
#ifdef UL_HAS_PHY
		top.prev_p_phy__rx__clk.set<bool>(false);
		top.prev_p_phy__tx__clk.set<bool>(false);
#endif
		top.eval();
		cycle++;
		if (top.p_phy__tx__en.get<bool>()) {
			if (symbols.empty())
				began = cycle;
			symbols.push_back(top.p_phy__txd.get<uint8_t>() & 3);
		} else if (!symbols.empty()) {
			back.push_back({began, cycle, symbols});
			symbols.clear();
		}
		top.commit();
	}
};

}  // namespace

extern "C" {

Wire *ul_wire() {
	return new Wire;
}

void ul_free(Wire *wire) {
	delete wire;
}

void ul_reset(Wire *wire) {
	wire->reset();
}

// Adds symbols for the PHY: data in bits 0 and 1, valid in bit 2, error in bit 3.
void ul_put(Wire *wire, const uint8_t *symbols, size_t count) {
	for (size_t i = 0; i < count; i++)
		wire->towards.push_back({uint8_t(symbols[i] & 3), bool(symbols[i] & 4), bool(symbols[i] & 8)});
}

// Adds a frame for the chip, without its frame check sequence.
void ul_put_frame(Wire *wire, const uint8_t *bytes, size_t count) {
	wire->chip.towards.emplace_back(bytes, bytes + count);
}

// Returns the number of symbols, and of frames for the chip, that were not sent to the gateway yet.
uint64_t ul_waiting(Wire *wire) {
	return wire->towards.size() + wire->chip.towards.size();
}

// Puts faults into the chip; w5500.h describes them.
void ul_spoil(Wire *wire, unsigned unsaid, int length, uint16_t first, unsigned busy) {
	wire->chip.unsaid = unsaid;
	wire->chip.length = length;
	wire->chip.first = first;
	wire->chip.busy = busy;
}

void ul_lose_power(Wire *wire) {
	wire->chip.lose_power();
}

bool ul_is_open(Wire *wire) {
	return wire->chip.is_open();
}

unsigned ul_resets(Wire *wire) {
	return wire->chip.resets;
}

const char *ul_complaint(Wire *wire) {
	return wire->chip.complaint.c_str();
}

// Runs for a number of cycles, or until a number of frames are waiting; returns the cycle.
uint64_t ul_run(Wire *wire, uint64_t cycles, uint64_t frames) {
	for (uint64_t i = 0; i < cycles && wire->back.size() < frames; i++)
		wire->tick();
	return wire->cycle;
}

// Reads the oldest frame of the gateway, if there is one, as symbols, or as bytes with a chip; and its begin and end.
size_t ul_get(Wire *wire, uint8_t *symbols, size_t most, uint64_t *began, uint64_t *ended) {
	if (wire->back.empty())
		return 0;
	Frame &frame = wire->back.front();
	size_t count = frame.symbols.size() < most ? frame.symbols.size() : most;
	std::memcpy(symbols, frame.symbols.data(), count);
	*began = frame.began;
	*ended = frame.ended;
	wire->back.pop_front();
	return count;
}

uint64_t ul_writes(Wire *wire) {
	return wire->log.size();
}

// Returns a write to the bus by its number: the address in the upper half, the word in the lower one.
uint64_t ul_write(Wire *wire, uint64_t number) {
	return wire->log[number];
}

void ul_poke(Wire *wire, uint32_t address, uint32_t word) {
	wire->memory[address & 255] = word;
}

// Sets the answer of the bus at an address: 0 is a word of the memory, 1 an error, 2 no answer.
void ul_answer(Wire *wire, uint32_t address, uint8_t answer) {
	wire->answers[address & 255] = Answer(answer);
}

uint32_t ul_dropped(Wire *wire) {
	return wire->top.p_phy__dropped.get<uint32_t>();
}

}

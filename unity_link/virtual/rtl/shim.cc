// SPDX-License-Identifier: BSD-3-Clause
// The environment of compiled gateware in a process: a clock, the medium, and a bus with memory and devices.
//
// The generated C++ (UL_MODEL is the name of the file) is the entity `unity_link_fifo`, cycle by cycle, or a whole
// design around a gateway (UL_TOP). In each cycle this file drives the inputs as a medium and a Wishbone bus do. Its C
// interface is for ctypes. Time is the number of clock cycles; it passes only in `ul_run`, `ul_run_until_quiet`,
// `ul_run_at_pins` and `ul_skip`.
//
// Order within a cycle: inputs are set, then one evaluation with a rising clock computes the logic and the next values
// of registers. The signals of both sides are read before the registers change, as a register would read them at that
// edge, so handshakes are exact. A further evaluation with a low clock would double the time, and CXXRTL does not need
// it if the logic has no feedback.
//
// The bus answers each access in the next cycle, as block RAM does: `ack` is a register. In classic mode a strobe in
// the same cycle as `ack` belongs to the access that was answered; in pipelined mode it is the next access. A `Slave`
// replaces this bus, and may answer at any time and any number of times, even against the rules of the bus. A whole
// design contains its own bus, and may have classic Wishbone masters (UL_MASTERS), each with its own first address.
//
// The caller uses the other ports of a whole design (UL_PORTS). It sets inputs now or in a later cycle, reads outputs
// directly in memory, and can be called in the cycles of a pulse.

#include UL_MODEL

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace {

// The generated file has macros for the registers that this file reads, because it knows GHDL's names for them;
// memories keep their names. UL_DIVISORS has the divisor of each group, which is 0 for a group that is not periodic.
#ifdef UL_TOP
using Top = cxxrtl_design::UL_TOP;
#else
using Top = cxxrtl_design::p_unity__link__fifo;
#define UL_PORTS(input, output)
#define UL_TIMESTAMP p_timestamp
#define UL_DIVISORS                                                                                                    \
	memory_p_unity__link__inst_2e_core__inst_2e_with__groups__subscription__manager__inst_2e_timer__inst_2e_divisors
#endif

// Callback for a bus access. `value` is the written word, or gets the read word. Returns an Answer.
using Device = int (*)(void *context, uint64_t address, int write, uint64_t *value);

// Largest number of evaluations until logic with feedback is stable.
constexpr int MOST_EVALUATIONS = 1000;

enum Answer { ANSWER_ACK = 0, ANSWER_ERROR = 1, ANSWER_NONE = 2, ANSWER_RETRY = 3 };

// An answer of a slave, `after` cycles after the strobe.
struct Reply {
	uint64_t word;
	uint32_t after;
	uint32_t answer;
};

// Callback for a bus slave that may break the rules of the bus. `value` is the written word. Returns the number of
// replies that it has stored, at most two.
using Slave = int (*)(void *context, uint64_t address, int write, uint64_t value, Reply *replies);

// Callback for an event: in a cycle in which the bits of a watch are '1', with the number of the watch; or before the
// cycle of the alarm, with a negative number.
using Event = void (*)(void *context, int watch);

// Kind of an address: memory, device, or a fixed answer (ANSWER_ERROR or ANSWER_NONE).
constexpr uint8_t BEHIND_MEMORY = 0;
constexpr uint8_t BEHIND_DEVICE = 3;

// Up to this width of addresses, memory is an array; above, it is a table of the written words.
constexpr size_t MOST_DIRECT_BITS = 20;

// The gateway is idle after QUIET_CYCLES cycles without a byte and without a bus access, if its registers then have the
// values of cycle QUIET_AT_PINS: with the same state and the same inputs, the next cycles repeat.
constexpr uint64_t QUIET_CYCLES = 96;
constexpr uint64_t QUIET_AT_PINS = 64;

// The names of all registers of the gateway contain GATEWAY. Registers whose names contain one of CLOCKS count time,
// even while the gateway is idle.
constexpr const char *GATEWAY = "unity_link_inst.";
constexpr const char *CLOCKS[] = {"clock_inst.", "timer_inst.", ".base_tick", ".timestamp"};

// Number of idle cycles that a waveform shows.
constexpr uint64_t SHOWN_QUIET_CYCLES = 24;

template<size_t Bits>
uint64_t get(const cxxrtl::value<Bits> &signal) { return signal.template get<uint64_t>(); }

template<size_t Bits>
uint64_t get(const cxxrtl::wire<Bits> &signal) { return signal.curr.template get<uint64_t>(); }

template<size_t Bits>
void set(cxxrtl::value<Bits> &signal, uint64_t value) { signal.template set<uint64_t>(value); }

template<size_t Bits>
size_t width(const cxxrtl::value<Bits> &) { return Bits; }

template<size_t Bits>
size_t width(const cxxrtl::wire<Bits> &) { return Bits; }

template<size_t Bits>
void fill(cxxrtl::value<Bits> &signal, bool level) {
	for (auto &chunk : signal.data)
		chunk = level ? std::numeric_limits<cxxrtl::chunk_t>::max() : 0;
	signal.data[cxxrtl::value<Bits>::chunks - 1] &= cxxrtl::value<Bits>::msb_mask;
}

template<size_t Bits>
void set_bit(cxxrtl::value<Bits> &signal, size_t bit) {
	if (bit < Bits)
		signal.data[bit / 32] |= cxxrtl::chunk_t{1} << bit % 32;
}

template<size_t Bits>
const cxxrtl::chunk_t *chunks(const cxxrtl::value<Bits> &signal) { return signal.data; }

template<size_t Bits>
const cxxrtl::chunk_t *chunks(const cxxrtl::wire<Bits> &signal) { return signal.curr.data; }

// A port of the design. An input keeps its value until it is set again.
struct Port {
	const char *name;
	bool is_input;
	size_t bits;
	cxxrtl::chunk_t *data;

	size_t chunks() const { return (bits + 31) / 32; }
	bool bit() const { return *data & 1; }
};

template<size_t Bits>
Port input(const char *name, cxxrtl::value<Bits> &signal) { return {name, true, Bits, signal.data}; }

template<typename Signal>
Port output(const char *name, Signal &signal) {
	return {name, false, width(signal), const_cast<cxxrtl::chunk_t *>(chunks(signal))};
}

// Counts for each bit of a port the cycles in which it was '1', and its changes, up to the cycle `cycles`.
class Counter {
public:
	Counter(const Port &port, uint64_t cycles)
		: port_(port), last_(port.data, port.data + port.chunks()), since_(cycles), high_(port.bits), edges_(port.bits) {}

	void look(uint64_t cycles) {
		if (!std::memcmp(port_.data, last_.data(), last_.size() * sizeof(cxxrtl::chunk_t)))
			return;
		settle(cycles);
		for (size_t bit = 0; bit < port_.bits; ++bit)
			edges_[bit] += (port_.data[bit / 32] ^ last_[bit / 32]) >> bit % 32 & 1;
		std::copy(port_.data, port_.data + last_.size(), last_.begin());
	}

	// Stores both counts of each bit, and restarts them at 0.
	void take(uint64_t cycles, uint64_t *high, uint64_t *edges) {
		settle(cycles);
		std::copy(high_.begin(), high_.end(), high);
		std::copy(edges_.begin(), edges_.end(), edges);
		std::fill(high_.begin(), high_.end(), 0);
		std::fill(edges_.begin(), edges_.end(), 0);
	}

private:
	void settle(uint64_t cycles) {
		for (size_t bit = 0; bit < port_.bits; ++bit)
			if (last_[bit / 32] >> bit % 32 & 1)
				high_[bit] += cycles - since_;
		since_ = cycles;
	}

	Port port_;
	std::vector<cxxrtl::chunk_t> last_;
	uint64_t since_;
	std::vector<uint64_t> high_;
	std::vector<uint64_t> edges_;
};

// Counts the steps of a motor driver: pulses that began with the direction '0', minus pulses that began with '1'.
class StepCounter {
public:
	StepCounter(const Port &pulse, const Port &direction) : pulse_(pulse), direction_(direction), was_(pulse.bit()) {}

	void look() {
		if (pulse_.bit() && !was_)
			steps += direction_.bit() ? -1 : 1;
		was_ = pulse_.bit();
	}

	int64_t steps = 0;

private:
	Port pulse_;
	Port direction_;
	bool was_;
};

constexpr uint64_t NEVER = std::numeric_limits<uint64_t>::max();

// Writes signals over time to a file for waveform viewers (VCD, IEEE 1364). Idle cycles are omitted.
class Waveform {
public:
	// Opens `path`; `failure` is the system's error number, or 0.
	Waveform(const char *path, Top &top) : file_(std::fopen(path, "w")) {
		if (!file_) {
			failure = errno;
			return;
		}
		std::setvbuf(file_, buffer_.data(), _IOFBF, buffer_.size());
#define UL_ADD(name, member) add(name, chunks(top.member), width(top.member));
		UL_SIGNALS(UL_ADD)
#undef UL_ADD
		declare();
	}

	~Waveform() { close(); }

	// Closes the file; returns the number of the first error of all writing, or 0.
	int close() {
		if (file_) {
			check(std::fprintf(file_, "#%llu\n", static_cast<unsigned long long>(last_)));
			errno = 0;
			if (std::fclose(file_) && !failure)
				failure = errno ? errno : EIO;
			file_ = nullptr;
		}
		return failure;
	}

	// Writes a cycle. `begin` is its beginning, and `half` the beginning of its second half, in nanoseconds.
	void show(uint64_t begin, uint64_t half) {
		if (!file_)
			return;
		begin = std::max(begin, last_ + !first_);
		std::string text = "#" + std::to_string(begin) + "\n" + (first_ ? "$dumpvars\n" : "") + "1!\n";
		for (auto &signal : signals_)
			if (first_ || std::memcmp(signal.now, signal.shown.data(), signal.shown.size() * sizeof(cxxrtl::chunk_t)))
				change(signal, text);
		if (first_)
			text += "$end\n";
		last_ = std::max(half, begin + 1);
		text += "#" + std::to_string(last_) + "\n0!\n";
		check(std::fwrite(text.data(), 1, text.size(), file_) == text.size() ? 0 : -1);
		first_ = false;
	}

	int failure = 0;

private:
	struct Signal {
		std::string name;
		std::string identifier;
		const cxxrtl::chunk_t *now;
		size_t bits;
		std::vector<cxxrtl::chunk_t> shown;
	};

	void add(const char *name, const cxxrtl::chunk_t *now, size_t bits) {
		// The clock is written by `show`, with both of its edges.
		if (!bits || name == std::string("clk"))
			return;
		const size_t size = (bits + 31) / 32;
		signals_.push_back({name, identifier(signals_.size() + 1), now, bits, std::vector<cxxrtl::chunk_t>(size)});
	}

	// VCD identifiers consist of printable characters from `!` on.
	static std::string identifier(size_t number) {
		std::string text;
		do {
			text += static_cast<char>('!' + number % 94);
			number /= 94;
		} while (number);
		return text;
	}

	void declare() {
		std::string text = "$version unity-link retrace $end\n$timescale 1 ns $end\n"
				   "$scope module unity_link_fifo $end\n$var wire 1 ! clk $end\n";
		std::vector<std::string> scope;
		for (auto &signal : signals_) {
			auto place = split(signal.name);
			const std::string name = place.back();
			place.pop_back();
			size_t common = 0;
			while (common < scope.size() && common < place.size() && scope[common] == place[common])
				++common;
			for (; scope.size() > common; scope.pop_back())
				text += "$upscope $end\n";
			for (; scope.size() < place.size(); scope.push_back(place[scope.size()]))
				text += "$scope module " + place[scope.size()] + " $end\n";
			text += "$var wire " + std::to_string(signal.bits) + " " + signal.identifier + " " + name;
			if (signal.bits > 1)
				text += " [" + std::to_string(signal.bits - 1) + ":0]";
			text += " $end\n";
		}
		for (size_t depth = scope.size() + 1; depth; --depth)
			text += "$upscope $end\n";
		text += "$enddefinitions $end\n";
		check(std::fwrite(text.data(), 1, text.size(), file_) == text.size() ? 0 : -1);
	}

	static std::vector<std::string> split(const std::string &name) {
		std::vector<std::string> parts(1);
		for (char character : name)
			if (character == '.')
				parts.emplace_back();
			else
				parts.back() += character;
		return parts;
	}

	static void change(Signal &signal, std::string &text) {
		std::copy(signal.now, signal.now + signal.shown.size(), signal.shown.begin());
		if (signal.bits == 1) {
			text += (signal.shown[0] & 1 ? '1' : '0') + signal.identifier + '\n';
			return;
		}
		text += 'b';
		for (size_t bit = signal.bits; bit--;)
			text += signal.shown[bit / 32] >> bit % 32 & 1 ? '1' : '0';
		text += ' ' + signal.identifier + '\n';
	}

	void check(int result) {
		if (result < 0 && !failure)
			failure = errno ? errno : EIO;
	}

	std::vector<char> buffer_ = std::vector<char>(1 << 20);
	std::FILE *file_;
	std::vector<Signal> signals_;
	uint64_t last_ = 0;
	bool first_ = true;
};

// The registers of the gateway, except those that count time.
class Registers {
public:
	explicit Registers(const Top &top) {
#define UL_ADD(name, member) add(name, top.member);
		UL_SIGNALS(UL_ADD)
#undef UL_ADD
	}

	void keep() {
		auto kept = kept_.begin();
		for (auto &place : places_)
			kept = std::copy(place.first, place.first + place.second, kept);
	}

	// Returns true if the registers have the values of the last call of `keep`.
	bool are_kept() const {
		auto kept = kept_.begin();
		for (auto &place : places_) {
			if (!std::equal(place.first, place.first + place.second, kept))
				return false;
			kept += place.second;
		}
		return true;
	}

private:
	template<size_t Bits>
	void add(const std::string &name, const cxxrtl::wire<Bits> &signal) {
		for (const char *clock : CLOCKS)
			if (name.find(clock) != std::string::npos)
				return;
		if (name.find(GATEWAY) == std::string::npos)
			return;
		places_.emplace_back(signal.curr.data, size_t{cxxrtl::value<Bits>::chunks});
		kept_.resize(kept_.size() + places_.back().second);
	}

	// Signals that are computed from registers are not stored.
	template<size_t Bits>
	void add(const std::string &, const cxxrtl::value<Bits> &) {}

	std::vector<std::pair<const cxxrtl::chunk_t *, size_t>> places_;
	std::vector<cxxrtl::chunk_t> kept_;
};

class Memory {
public:
	explicit Memory(size_t address_bits) : direct_(address_bits <= MOST_DIRECT_BITS) {
		if (direct_)
			words_.resize(size_t{1} << address_bits);
	}

	uint64_t read(uint64_t address) const {
		if (direct_)
			return words_[address];
		auto found = table_.find(address);
		return found == table_.end() ? 0 : found->second;
	}

	void write(uint64_t address, uint64_t value) {
		if (direct_)
			words_[address] = value;
		else
			table_[address] = value;
	}

	// Returns the addresses of all words that are not 0.
	std::vector<uint64_t> used() const {
		std::vector<uint64_t> addresses;
		for (size_t address = 0; address < words_.size(); ++address)
			if (words_[address])
				addresses.push_back(address);
		for (auto &entry : table_)
			if (entry.second)
				addresses.push_back(entry.first);
		return addresses;
	}

private:
	bool direct_;
	std::vector<uint64_t> words_;
	std::unordered_map<uint64_t, uint64_t> table_;
};

class Gateway {
	// Declared first, because other members refer to it.
	Top top_;

public:
#ifdef UL_TOP
	Gateway() : memory(MOST_DIRECT_BITS + 1) {
		// The generated file has the first address and the name of each master.
#define UL_MASTER(base, name) add_master(base, name);
		UL_MASTERS(UL_MASTER)
#undef UL_MASTER
		reset();
	}
#else
	Gateway() : memory(width(top_.p_wb__adr)) { reset(); }
#endif

	// Restores the state after power-up, except memory, the kinds of addresses, and inputs of a whole design.
	void reset() {
		std::vector<std::vector<cxxrtl::chunk_t>> inputs;
		for (const Port &port : ports)
			inputs.emplace_back(port.data, port.data + port.chunks());
		top_.reset();
		for (size_t index = 0; index < ports.size(); ++index)
			if (ports[index].is_input)
				std::copy(inputs[index].begin(), inputs[index].end(), ports[index].data);
		for (Master &master : masters_)
			master.asked = false;
		later_.clear();
		pulses_.clear();
		alarm = NEVER;
		to_gateway.clear();
		from_gateway.clear();
		lost_before_next = false;
		ack_ = err_ = rty_ = false;
		is_slaves_ = false;
		replies_.clear();
		read_data_ = 0;
		set(top_.p_rst, 1);
		run(2);
		set(top_.p_rst, 0);
		cycles = 0;
		for (auto &counter : counters_)
			counter.second = Counter(ports[counter.first], 0);
		for (auto &counter : step_counters_)
			counter.second = StepCounter(ports[counter.first.first], ports[counter.first.second]);
		flushes = 0;
		quiet_ = 0;
		stalled = false;
		in_due_ = out_due_ = 0;
	}

	void run(uint64_t count) {
		for (; count; --count)
			cycle();
	}

	// Runs until the gateway is idle, or its bytes wait for room: at most `most` cycles, or `most_with_groups` cycles
	// while a periodic group runs, because the gateway is never idle then. Returns the number of cycles.
	uint64_t run_until_quiet(uint64_t most, uint64_t most_with_groups) {
		uint64_t count = 0;
		quiet_ = 0;
		while (!is_quiet() && count < (ticking() ? most_with_groups : most)) {
			cycle();
			++count;
		}
		return count;
	}

	// Returns true if each cycle must be computed, for example because a periodic group is running.
	bool ticking() {
		if (never_rests || !later_.empty() || !pulses_.empty())
			return true;
#ifdef UL_RUNNING
		const uint64_t running = get(top_.UL_RUNNING);
		for (size_t group = 0; running >> group; ++group)
			if (running >> group & 1 && !top_.UL_DIVISORS[group].is_zero())
				return true;
#endif
		return false;
	}

	// Has the effect of `run` for a gateway that is idle and not ticking, without computing the cycles: only the clock
	// advances. The phase of the base tick changes unless `count` is a multiple of the base tick's period.
	void skip(uint64_t count) {
#ifdef UL_TIMESTAMP
		auto &timestamp = top_.UL_TIMESTAMP;
		const uint64_t all = std::numeric_limits<uint64_t>::max() >> (64 - width(timestamp));
		set(timestamp.curr, (get(timestamp.curr) + count) & all);
		timestamp.next = timestamp.curr;
#endif
		cycles += count;
	}

	// Runs until a flush, or with `stop_when_quiet` until the gateway is idle: at most `most` cycles. Returns the number
	// of cycles without the idle ones at the end.
	uint64_t run_at_pins(uint64_t most, bool stop_when_quiet) {
		const uint64_t flushed = flushes;
		uint64_t count = 0;
		quiet_ = 0;
		while (count < most && flushes == flushed && !(stop_when_quiet && is_quiet())) {
			cycle();
			++count;
		}
		const bool stopped = stop_when_quiet && is_quiet();
		return stopped ? count - quiet_ : count;
	}

	std::deque<uint8_t> to_gateway;
	std::vector<uint8_t> from_gateway;
	// Cycles for each byte at the medium, in each direction; 0 for a byte in each cycle.
	double pace = 0;
	Memory memory;
	std::unordered_map<uint64_t, uint8_t> behind;
	Device device = nullptr;
	void *device_context = nullptr;
	Slave slave = nullptr;
	void *slave_context = nullptr;
	// Pattern of 64 cycles: in cycles whose bit is 1 a pipelined slave stalls.
	uint64_t stalls = 0;
	uint64_t cycles = 0;
	uint64_t flushes = 0;
	size_t room = std::numeric_limits<size_t>::max();
	bool lost_before_next = false;
	bool trigger = false;
	// Group of the trigger; negative for the triggers of all groups.
	int triggered_group = -1;
	// True if a byte to send found no room in the last cycle.
	bool stalled = false;
	// True if all addresses belong to the device.
	bool only_device = false;
	// True if no cycle may be skipped, because hardware moves by itself.
	bool never_rests = false;
	// Ports of a whole design, sorted by name.
#define UL_INPUT(name, member) input(name, top_.member),
#define UL_OUTPUT(name, member) output(name, top_.member),
	const std::vector<Port> ports = {UL_PORTS(UL_INPUT, UL_OUTPUT)};
#undef UL_INPUT
#undef UL_OUTPUT
	Event event = nullptr;
	void *event_context = nullptr;
	// The alarm event is called once, before this cycle.
	uint64_t alarm = NEVER;

	// Calls the event in each cycle in which the lowest bits of both ports are '1'; `second` may be negative for one port.
	// Returns the number of the watch.
	int watch(int first, int second) {
		const Port &port = ports[first];
		watches_.push_back({port.data, second < 0 ? port.data : ports[second].data});
		return static_cast<int>(watches_.size()) - 1;
	}

	// Sets an input before a cycle; at once, if the cycle has passed.
	void set_at(uint64_t cycle, size_t index, const cxxrtl::chunk_t *value) {
		const Port &port = ports[index];
		if (cycle <= cycles)
			std::copy(value, value + port.chunks(), port.data);
		else
			later_.emplace(cycle, std::make_pair(index, std::vector<cxxrtl::chunk_t>(value, value + port.chunks())));
	}

	void count(size_t index) { counters_.emplace(index, Counter(ports[index], cycles)); }
	void take_counts(size_t index, uint64_t *high, uint64_t *edges) { counters_.at(index).take(cycles, high, edges); }

	// Returns the steps since the reset, or since the first call for these ports.
	int64_t steps(size_t pulse, size_t direction) {
		const auto key = std::make_pair(pulse, direction);
		return step_counters_.emplace(key, StepCounter(ports[pulse], ports[direction])).first->second.steps;
	}

	// Sets the external trigger of a group to '1' for `count` cycles from the next one on.
	void pulse(int group, uint64_t count) { pulses_[group] = cycles + count; }

	// Connects a master of a whole design to the bus. An unconnected master gets an error for each access at once.
	void connect(size_t master) {
		masters_.at(master).connected = true;
		*masters_.at(master).err.data = 0;
	}

	// For an access during a call of the device: the sample's word, packed into a byte each for the group's number, the
	// sequence number and the index of the word; negative for an access of a request.
	int sample_word() {
#ifdef UL_FOR_SAMPLE
		if (get(top_.UL_FOR_SAMPLE))
			return get(top_.UL_GROUP) << 16 | get(top_.UL_SEQUENCE) << 8 | ((get(top_.UL_ASKED) - 1) & 0xFF);
#endif
		return -1;
	}

	// Opens a waveform, which gets all cycles while `shows` is true; returns the system's error number, or 0.
	int open_waveform(const char *path) {
		waveform.reset(new Waveform(path, top_));
		return waveform->failure;
	}

	// Sets the time of the next cycle, and the length of a cycle, in nanoseconds.
	void set_time(double now, double of_a_cycle) {
		began_ = now;
		began_at_ = cycles;
		of_a_cycle_ = of_a_cycle;
	}

	std::unique_ptr<Waveform> waveform;
	bool shows = false;

private:
	// A classic Wishbone master of a whole design.
	struct Master {
		uint64_t base;
		Port cyc, stb, we, adr, dat_o, dat_i, ack, err;
		bool connected;
		// True if the present access was passed to the device or memory.
		bool asked;
	};

	bool is_quiet() const { return quiet_ >= QUIET_CYCLES; }

	void cycle() {
		if (cycles >= alarm && event) {
			alarm = NEVER;
			event(event_context, -1);
		}
		while (!later_.empty() && later_.begin()->first <= cycles) {
			const auto &set = later_.begin()->second;
			std::copy(set.second.begin(), set.second.end(), ports[set.first].data);
			later_.erase(later_.begin());
		}
		const bool offered = !to_gateway.empty() && cycles >= in_due_;
		const bool room_left = from_gateway.size() < room && cycles >= out_due_;
		set(top_.p_in__valid, offered);
		set(top_.p_in__data, offered ? to_gateway.front() : 0);
		set(top_.p_in__lost, offered && lost_before_next);
		set(top_.p_out__ready, room_left);
#ifndef UL_TOP
		set(top_.p_wb__ack, ack_);
		set(top_.p_wb__err, err_);
		set(top_.p_wb__rty, rty_);
		set(top_.p_wb__stall, stalls >> cycles % 64 & 1);
		set(top_.p_wb__dat__i, read_data_);
#endif
		fill(top_.p_trigger, trigger && triggered_group < 0);
		if (trigger && triggered_group >= 0)
			set_bit(top_.p_trigger, triggered_group);
		for (auto pulse = pulses_.begin(); pulse != pulses_.end();) {
			set_bit(top_.p_trigger, pulse->first);
			pulse = pulse->second <= cycles + 1 ? pulses_.erase(pulse) : std::next(pulse);
		}
#ifdef UL_FEEDBACK
		settle();
#endif
		set(top_.prev_p_clk, 0);
		set(top_.p_clk, 1);
		top_.eval();
		if (shows && (quiet_ < SHOWN_QUIET_CYCLES || offered))
			show();

		const bool taken = offered && get(top_.p_in__ready);
		const bool sent = room_left && get(top_.p_out__valid);
		stalled = !room_left && get(top_.p_out__valid);
		if (taken) {
			to_gateway.pop_front();
			lost_before_next = false;
			in_due_ = next_due(in_due_);
		}
		if (sent) {
			from_gateway.push_back(get(top_.p_out__data));
			out_due_ = next_due(out_due_);
		}
		if (get(top_.p_out__flush))
			++flushes;
		const bool on_bus = pass_bus();
		for (size_t index = 0; index < watches_.size(); ++index)
			if (*watches_[index].first & *watches_[index].second & 1)
				event(event_context, static_cast<int>(index));
		for (auto &counter : counters_)
			counter.second.look(cycles);
		for (auto &counter : step_counters_)
			counter.second.look();

		top_.commit();
		++cycles;
		quiet_ = taken || sent || on_bus ? 0 : quiet_ + 1;
		if (quiet_ == QUIET_AT_PINS)
			registers_.keep();
		else if (quiet_ == QUIET_CYCLES && (is_paced() || !registers_.are_kept()))
			quiet_ = 0;
	}

	// Returns true if a byte waits only because of the medium's rate.
	bool is_paced() const {
		return (!to_gateway.empty() && cycles < in_due_) ||
			(get(top_.p_out__valid) && from_gateway.size() < room && cycles < out_due_);
	}

#ifdef UL_FEEDBACK
	// Logic with feedback, for example through the bits of a vector, needs several evaluations, here with a low clock. For
	// a loop that never becomes stable, their number is limited.
	void settle() {
		set(top_.prev_p_clk, 0);
		set(top_.p_clk, 0);
		for (int evaluation = 0; evaluation < MOST_EVALUATIONS; ++evaluation) {
			top_.eval();
			if (!top_.commit())
				return;
		}
	}
#endif

	void show() {
		const double begin = began_ + (cycles - began_at_) * of_a_cycle_;
		waveform->show(std::llround(begin), std::llround(begin + of_a_cycle_ / 2));
	}

	// Returns the time at which the next byte may pass after one in this cycle, in cycles; fractions of cycles accumulate
	// while bytes follow each other.
	double next_due(double due) const { return (cycles - due < 1 ? due : cycles) + pace; }

#ifdef UL_TOP
	// Answers the masters of a whole design; returns true if the design's own bus or a master is busy.
	bool pass_bus() {
		bool busy = get(top_.UL_OWED);
		for (Master &master : masters_) {
			const bool strobe = master.cyc.bit() && master.stb.bit();
			busy |= strobe;
			if (!master.connected)
				continue;
			if (!strobe || *master.ack.data || *master.err.data) {
				*master.ack.data = *master.err.data = 0;
				master.asked = false;
			} else if (!master.asked) {
				master.asked = true;
				access(master.base + word_of(master.adr), master.we.bit(), word_of(master.dat_o));
				*master.ack.data = ack_;
				*master.err.data = err_;
				for (size_t chunk = 0; chunk < master.dat_i.chunks(); ++chunk)
					master.dat_i.data[chunk] = read_data_ >> 32 * chunk;
			}
		}
		return busy;
	}

	void add_master(uint64_t base, const std::string &name) {
		const auto pin = [&](const char *ending) {
			const std::string wanted = name + ending;
			for (const Port &port : ports)
				if (wanted == port.name)
					return port;
			std::abort();
		};
		masters_.push_back({base, pin("_cyc"), pin("_stb"), pin("_we"), pin("_adr"), pin("_dat_o"), pin("_dat_i"),
				    pin("_ack"), pin("_err"), false, false});
		*masters_.back().err.data = 1;
	}

	static uint64_t word_of(const Port &port) {
		return port.data[0] | (port.bits > 32 ? uint64_t{port.data[1]} << 32 : 0);
	}
#else
	// Answers the bus; returns true if the bus is busy.
	bool pass_bus() {
		const bool on_bus = get(top_.p_wb__cyc);
		const bool answered = ack_ || err_ || rty_;
		const bool strobe = on_bus && get(top_.p_wb__stb);
		ack_ = err_ = rty_ = false;
		if (slave)
			pass_to_slave(strobe, answered);
		else if (strobe && (UL_PIPELINED || !answered))
			access(get(top_.p_wb__adr), get(top_.p_wb__we), get(top_.p_wb__dat__o));
		return on_bus;
	}

	// Runs one cycle of a slave. The slave is called once for each access. Replies that are due in the next cycle are put
	// into the registers.
	void pass_to_slave(bool strobe, bool answered) {
		const bool begins = UL_PIPELINED ? !(stalls >> cycles % 64 & 1) : !is_slaves_;
		if (strobe && begins) {
			Reply replies[2];
			const bool write = get(top_.p_wb__we);
			const uint64_t value = write ? get(top_.p_wb__dat__o) : 0;
			const int count = slave(slave_context, get(top_.p_wb__adr), write, value, replies);
			for (int index = 0; index < count; ++index)
				replies_.emplace(cycles + replies[index].after, replies[index]);
		}
		is_slaves_ = strobe && !answered;
		while (!replies_.empty() && replies_.begin()->first <= cycles + 1) {
			const Reply reply = replies_.begin()->second;
			replies_.erase(replies_.begin());
			ack_ = reply.answer == ANSWER_ACK;
			err_ = reply.answer == ANSWER_ERROR;
			rty_ = reply.answer == ANSWER_RETRY;
			read_data_ = reply.word;
		}
	}
#endif

	// Executes one bus access; the registers have the answer from the next cycle on.
	void access(uint64_t address, bool write, uint64_t written) {
		uint64_t value = write ? written : 0;
		int answer = ANSWER_ACK;
		uint8_t kind = only_device ? BEHIND_DEVICE : BEHIND_MEMORY;
		if (!behind.empty()) {
			auto found = behind.find(address);
			if (found != behind.end())
				kind = found->second;
		}
		if (kind == BEHIND_DEVICE && device)
			answer = device(device_context, address, write, &value);
		else if (kind != BEHIND_MEMORY)
			answer = kind;
		else if (write)
			memory.write(address, value);
		else
			value = memory.read(address);
		ack_ = answer == ANSWER_ACK;
		err_ = answer == ANSWER_ERROR;
		read_data_ = value;
	}

	bool ack_ = false;
	bool err_ = false;
	bool rty_ = false;
	// True if the slave was called for the access of the present strobe.
	bool is_slaves_ = false;
	// Replies of the slave, by the cycle in which they are on the bus.
	std::multimap<uint64_t, Reply> replies_;
	std::vector<Master> masters_;
	std::vector<std::pair<const cxxrtl::chunk_t *, const cxxrtl::chunk_t *>> watches_;
	std::map<size_t, Counter> counters_;
	std::map<std::pair<size_t, size_t>, StepCounter> step_counters_;
	// Values of inputs, by the cycle before which they are set; and end of the pulse of each trigger, by group.
	std::multimap<uint64_t, std::pair<size_t, std::vector<cxxrtl::chunk_t>>> later_;
	std::map<int, uint64_t> pulses_;
	uint64_t read_data_ = 0;
	Registers registers_{top_};
	// Number of cycles since the last byte or bus access.
	uint64_t quiet_ = 0;
	double in_due_ = 0;
	double out_due_ = 0;
	double began_ = 0;
	uint64_t began_at_ = 0;
	double of_a_cycle_ = 1;
};

} // namespace

extern "C" {

// Returns a gateway in reset state, whose memory is 0. Free it with ul_destroy.
Gateway *ul_create() { return new Gateway; }
void ul_destroy(Gateway *gateway) { delete gateway; }
void ul_reset(Gateway *gateway) { gateway->reset(); }

void ul_run(Gateway *gateway, uint64_t cycles) { gateway->run(cycles); }
uint64_t ul_run_until_quiet(Gateway *gateway, uint64_t most, uint64_t most_with_groups) {
	return gateway->run_until_quiet(most, most_with_groups);
}
uint64_t ul_run_at_pins(Gateway *gateway, uint64_t most, int stop_when_quiet) {
	return gateway->run_at_pins(most, stop_when_quiet != 0);
}
void ul_set_pace(Gateway *gateway, double cycles_per_byte) { gateway->pace = cycles_per_byte; }
int ul_ticking(Gateway *gateway) { return gateway->ticking(); }
int ul_stalled(const Gateway *gateway) { return gateway->stalled; }
void ul_skip(Gateway *gateway, uint64_t cycles) { gateway->skip(cycles); }
uint64_t ul_cycles(const Gateway *gateway) { return gateway->cycles; }
uint64_t ul_flushes(const Gateway *gateway) { return gateway->flushes; }

// Adds bytes, which wait until the gateway's receive FIFO has room for them.
void ul_push(Gateway *gateway, const uint8_t *data, size_t size) {
	gateway->to_gateway.insert(gateway->to_gateway.end(), data, data + size);
}
size_t ul_waiting(const Gateway *gateway) { return gateway->to_gateway.size(); }
void ul_take_back(Gateway *gateway) { gateway->to_gateway.clear(); }

// Marks the next byte to the gateway: bytes before it were lost.
void ul_lose(Gateway *gateway) { gateway->lost_before_next = true; }

// Limits the number of bytes that the gateway can send before they are pulled.
void ul_set_room(Gateway *gateway, size_t bytes) { gateway->room = bytes; }
size_t ul_available(const Gateway *gateway) { return gateway->from_gateway.size(); }
size_t ul_pull(Gateway *gateway, uint8_t *data, size_t size) {
	auto &bytes = gateway->from_gateway;
	const size_t count = std::min(size, bytes.size());
	std::memcpy(data, bytes.data(), count);
	bytes.erase(bytes.begin(), bytes.begin() + count);
	return count;
}

// Set the level of the external trigger of a group or of all groups; other triggers are low.
void ul_set_trigger(Gateway *gateway, int level) { gateway->trigger = level != 0; }
void ul_choose_trigger(Gateway *gateway, int group) { gateway->triggered_group = group; }

uint64_t ul_read_memory(const Gateway *gateway, uint64_t address) { return gateway->memory.read(address); }
void ul_write_memory(Gateway *gateway, uint64_t address, uint64_t value) { gateway->memory.write(address, value); }

// Stores at most `size` addresses of words that are not 0; returns the number of all such words.
size_t ul_used_memory(const Gateway *gateway, uint64_t *addresses, size_t size) {
	auto used = gateway->memory.used();
	std::copy(used.begin(), used.begin() + std::min(size, used.size()), addresses);
	return used.size();
}

// Sets the kind of an address: 0 memory, 1 an error, 2 no answer, 3 the device.
void ul_set_behind(Gateway *gateway, uint64_t address, uint8_t kind) {
	if (kind == BEHIND_MEMORY)
		gateway->behind.erase(address);
	else
		gateway->behind[address] = kind;
}

void ul_set_device(Gateway *gateway, Device device, void *context) {
	gateway->device = device;
	gateway->device_context = context;
}
// Set a slave in place of memory and devices, and the cycles in which it stalls.
void ul_set_slave(Gateway *gateway, Slave slave, void *context) {
	gateway->slave = slave;
	gateway->slave_context = context;
}
void ul_set_stalls(Gateway *gateway, uint64_t pattern) { gateway->stalls = pattern; }
void ul_set_only_device(Gateway *gateway) { gateway->only_device = true; }
int ul_sample_word(Gateway *gateway) { return gateway->sample_word(); }

// Ports of a whole design, by numbers from 0 on. The address of a port's 32-bit words, lowest first, never changes.
size_t ul_ports(const Gateway *gateway) { return gateway->ports.size(); }
const char *ul_port_name(const Gateway *gateway, size_t port) { return gateway->ports[port].name; }
int ul_port_is_input(const Gateway *gateway, size_t port) { return gateway->ports[port].is_input; }
size_t ul_port_bits(const Gateway *gateway, size_t port) { return gateway->ports[port].bits; }
const uint32_t *ul_port_data(const Gateway *gateway, size_t port) { return gateway->ports[port].data; }
void ul_set_at(Gateway *gateway, uint64_t cycle, size_t port, const uint32_t *value) {
	gateway->set_at(cycle, port, value);
}
void ul_count(Gateway *gateway, size_t port) { gateway->count(port); }
void ul_take_counts(Gateway *gateway, size_t port, uint64_t *high, uint64_t *edges) {
	gateway->take_counts(port, high, edges);
}
int64_t ul_steps(Gateway *gateway, size_t pulse, size_t direction) { return gateway->steps(pulse, direction); }
void ul_connect(Gateway *gateway, size_t master) { gateway->connect(master); }

// Events: the callback, and its causes.
void ul_set_event(Gateway *gateway, Event event, void *context) {
	gateway->event = event;
	gateway->event_context = context;
}
int ul_watch(Gateway *gateway, int first, int second) { return gateway->watch(first, second); }
void ul_set_alarm(Gateway *gateway, uint64_t cycle) { gateway->alarm = cycle; }
void ul_pulse(Gateway *gateway, int group, uint64_t cycles) { gateway->pulse(group, cycles); }
void ul_never_rests(Gateway *gateway, int never) { gateway->never_rests = never != 0; }

// Waveforms: these functions return 0, or the system's error number.
int ul_open_waveform(Gateway *gateway, const char *path) { return gateway->open_waveform(path); }
int ul_close_waveform(Gateway *gateway) {
	gateway->shows = false;
	return gateway->waveform ? gateway->waveform->close() : 0;
}
void ul_show(Gateway *gateway, int shows) { gateway->shows = shows && gateway->waveform; }
void ul_set_time(Gateway *gateway, double nanoseconds, double of_a_cycle) {
	gateway->set_time(nanoseconds, of_a_cycle);
}

}

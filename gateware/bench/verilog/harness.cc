// SPDX-License-Identifier: BSD-3-Clause
// A gateway that Verilator has compiled, with a Wishbone slave, driven by commands on the standard input:
//
//   send N DATA     bytes for the gateway
//   lose            mark the first byte of the next `send`: bytes before it were lost
//   wait N          wait states of the slave from now on
//   quiet N         run until no byte has passed for N cycles; write the number of bytes sent (a line), and the bytes
//   reset           one cycle of reset
//
// As in unity_link_bench.vhd, every address is memory except two: one answers with err, one never.
//
//   harness ERROR_AT SILENT_AT PIPELINED PAUSE_IN PAUSE_OUT SEED      (pauses: in percent of all cycles)

#include <cstdint>
#include <cstdlib>
#include <deque>
#include <iostream>
#include <random>
#include <string>
#include <unordered_map>

#include "Vtop.h"

namespace {

struct Byte {
  uint8_t data;
  bool lost_before;
};

class Bench {
 public:
  Bench(char** arguments)
      : error_at_(std::strtoull(arguments[1], nullptr, 0)),
        silent_at_(std::strtoull(arguments[2], nullptr, 0)),
        pipelined_(std::atoi(arguments[3]) != 0),
        pause_in_(std::atoi(arguments[4])),
        pause_out_(std::atoi(arguments[5])),
        random_(std::atoi(arguments[6])) {
    reset();
  }

  void send(const std::string& data) {
    for (const char byte : data) {
      waiting_.push_back({static_cast<uint8_t>(byte), lose_next_});
      lose_next_ = false;
    }
  }

  void lose() { lose_next_ = true; }

  void set_wait_states(unsigned count) { wait_states_ = count; }

  void reset() {
    top_.rst = 1;
    cycle();
    top_.rst = 0;
    waited_ = 0;
    taken_ = false;
  }

  std::string quiet(unsigned cycles) {
    for (unsigned still = 0; still < cycles; ++still) {
      if (cycle() || !waiting_.empty()) still = 0;
    }
    std::string got;
    got.swap(received_);
    return got;
  }

 private:
  // Simulates a cycle; returns whether a byte was transferred.
  bool cycle() {
    const bool offers = !top_.rst && !waiting_.empty() && !pauses(pause_in_);
    top_.in_valid = offers;
    top_.in_data = offers ? waiting_.front().data : 0;
    top_.in_lost = offers && waiting_.front().lost_before;
    top_.out_ready = !pauses(pause_out_);
    top_.clk = 0;
    top_.eval();
    const bool answered = answer();
    top_.eval();
    const bool came = offers && top_.in_ready;
    const bool left = !top_.rst && top_.out_valid && top_.out_ready;
    if (came) waiting_.pop_front();
    if (left) received_.push_back(static_cast<char>(top_.out_data));
    serve(answered);
    top_.clk = 1;
    top_.eval();
    return came || left;
  }

  bool pauses(int percent) { return percent != 0 && static_cast<int>(random_() % 100) < percent; }

  // Sets the slave's outputs for this cycle; returns whether it accepts the access.
  bool answer() {
    const bool asked = top_.wb_cyc && top_.wb_stb && top_.wb_adr != silent_at_;
    const bool answered = asked && waited_ >= wait_states_;
    const bool ends = pipelined_ ? taken_ && top_.wb_cyc : answered;
    const bool fails = pipelined_ ? taken_error_ : top_.wb_adr == error_at_;
    top_.wb_ack = ends && !fails;
    top_.wb_err = ends && fails;
    top_.wb_dat_i = pipelined_ ? taken_data_ : answered ? memory_[top_.wb_adr] : ~uint64_t{0};
    top_.wb_stall = pipelined_ && waited_ < wait_states_;
    return answered;
  }

  void serve(bool answered) {
    taken_ = answered;
    taken_error_ = top_.wb_adr == error_at_;
    taken_data_ = memory_[top_.wb_adr];
    if (answered && top_.wb_we && top_.wb_adr != error_at_) memory_[top_.wb_adr] = top_.wb_dat_o;
    waited_ = top_.wb_cyc && top_.wb_stb && !answered ? waited_ + 1 : 0;
  }

  Vtop top_;
  uint64_t error_at_;
  uint64_t silent_at_;
  bool pipelined_;
  int pause_in_;
  int pause_out_;
  std::minstd_rand random_;
  std::deque<Byte> waiting_;
  std::string received_;
  std::unordered_map<uint64_t, uint64_t> memory_;
  bool lose_next_ = false;
  unsigned wait_states_ = 0;
  unsigned waited_ = 0;
  bool taken_ = false;
  bool taken_error_ = false;
  uint64_t taken_data_ = 0;
};

}  // namespace

double sc_time_stamp() { return 0; }

int main(int count, char** arguments) {
  if (count != 7) return 2;
  Bench bench(arguments);
  std::string command;
  while (std::cin >> command) {
    unsigned number = 0;
    if (command == "reset") {
      bench.reset();
    } else if (command == "lose") {
      bench.lose();
    } else if (command == "wait" && std::cin >> number) {
      bench.set_wait_states(number);
    } else if (command == "send" && std::cin >> number) {
      std::string data(number, '\0');
      std::cin.get();
      std::cin.read(&data[0], number);
      bench.send(data);
    } else if (command == "quiet" && std::cin >> number) {
      const std::string got = bench.quiet(number);
      std::cout << got.size() << '\n' << got << std::flush;
    } else {
      return 2;
    }
  }
  return 0;
}

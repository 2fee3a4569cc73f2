// SPDX-License-Identifier: BSD-3-Clause
// A gateway in Icarus Verilog: sends it the bytes of the file +stimulus (hex, one byte per line), and writes its answer
// bytes, in hex too, to the file +answers. Every address is memory, except one that answers with err and one that never
// answers. gateware/bench/verilog/simulators.py replaces the names between $.

`timescale 1ns / 1ns

module testbench;
  localparam quiet_cycles = $quiet_cycles$;
  localparam places = 65536;

  reg clk = 0;
  reg rst = 1;
  reg [7:0] stimulus[0:$longest$];
  reg [8*256-1:0] path;
  integer count = $count$;
  integer next = 0;
  integer quiet = 0;
  integer answers;

  wire [7:0] in_data = stimulus[next];
  wire in_valid = !rst && next < count;
  wire in_ready;
  wire [7:0] out_data;
  wire out_valid;
  wire wb_cyc;
  wire wb_stb;
  wire wb_we;
  wire [$address_bits$-1:0] wb_adr;
  wire [$data_bits$-1:0] wb_dat_o;

  // Addresses of up to 32 bits share entries of the memory: a test must not use two that share one.
  reg [$data_bits$-1:0] memory[0:places-1];
  reg [$address_bits$-1:0] keys[0:places-1];
  wire [31:0] wide = wb_adr;
  wire [15:0] place = wide[15:0] + 3 * wide[31:16];
  wire known = keys[place] === wb_adr;
  wire answered = wb_cyc && wb_stb && wb_adr != $silent_at$;
  wire wb_ack = answered && wb_adr != $error_at$;
  wire wb_err = answered && wb_adr == $error_at$;
  wire [$data_bits$-1:0] wb_dat_i = known ? memory[place] : 0;

  $instance$

  always #10 clk = !clk;

  always @(posedge clk) begin
    if (wb_ack && wb_we) begin
      if (!known && keys[place] !== {$address_bits${1'bx}}) begin
        $display("two addresses share place %h of the memory", place);
        $finish;
      end
      keys[place] <= wb_adr;
      memory[place] <= wb_dat_o;
    end
    if (in_valid && in_ready) next <= next + 1;
    if (!rst && out_valid) $fwrite(answers, "%02x\n", out_data);
    quiet <= rst || (in_valid && in_ready) || out_valid ? 0 : quiet + 1;
    if (quiet == quiet_cycles) begin
      $fclose(answers);
      $finish;
    end
  end

  initial begin
    if (!$value$plusargs("stimulus=%s", path)) $finish;
    $readmemh(path, stimulus);
    if (!$value$plusargs("answers=%s", path)) $finish;
    answers = $fopen(path, "w");
    repeat (5) @(posedge clk);
    #1 rst = 0;
  end
endmodule

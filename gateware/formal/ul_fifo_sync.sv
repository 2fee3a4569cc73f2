// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of the synchronous FIFO for all sequences of inputs and readiness: an entry leaves unchanged and in order,
// none is lost and none is duplicated; an output is stable until it is accepted; the capacity equals the depth, and
// `level` is the number of stored entries.
//
// An input that is not accepted may change or be withdrawn: the FIFO must not rely on a stable source. The followed
// entry is arbitrary (`follow`), so its properties hold for all entries. The second half has the invariants that make
// the proof hold without a bound: the place of the entry, and the relations of the pointers.

module ul_fifo_sync_properties #(
	parameter WIDTH = 2,
	parameter DEPTH = 4,
	parameter ADDRESS = $clog2(DEPTH)
) (
	input clk,
	input [WIDTH-1:0] in_data,
	input in_valid,
	input out_ready,
	input follow
);
	wire in_ready, out_valid;
	wire [WIDTH-1:0] out_data;
	wire [ADDRESS:0] level;
	reg rst = 1;

	ul_fifo_sync dut (.*);

	wire push = !rst && in_valid && in_ready;
	wire pop = !rst && out_valid && out_ready;
	reg [ADDRESS:0] inside = 0, before = 0;
	reg followed = 0;
	reg [WIDTH-1:0] value;
	reg offered = 0;
	reg [WIDTH-1:0] offer;
	reg [3:0] gone = 0;

	always @(posedge clk) begin
		rst <= 0;
		if (rst)
			assert (inside == 0 && !followed && !offered);
	end

	always @(posedge clk) if (!rst) begin
		inside <= inside + push - pop;
		if (push && follow && !followed) begin
			followed <= 1;
			value <= in_data;
			before <= inside - pop;
		end else if (followed && pop) begin
			followed <= before != 0;
			before <= before - 1;
		end
		offered <= out_valid && !pop;
		offer <= out_data;
		if (pop && gone != 15)
			gone <= gone + 1;

		assert (level == inside);
		assert (out_valid == (inside != 0));
		assert (in_ready == (inside != DEPTH));
		if (followed && before == 0)
			assert (out_data == value);
		if (offered)
			assert (out_data == offer);

		// The FIFO can be filled, drained, and passed through, each after its memory has wrapped around.
		cover (inside == DEPTH && gone == 2 * DEPTH);
		cover (inside == 0 && gone == 2 * DEPTH + 1);
		cover (push && pop && inside == 1 && gone > DEPTH);
	end

	(* hierconn *) wire [ADDRESS-1:0] \dut.write_at , \dut.read_next ;
	(* hierconn *) wire [WIDTH-1:0] \dut.memory[0] , \dut.memory[1] , \dut.memory[2] , \dut.memory[3] ;
	wire [WIDTH-1:0] memory [0:DEPTH-1];
	assign memory[0] = \dut.memory[0] ;
	assign memory[1] = \dut.memory[1] ;
	assign memory[2] = \dut.memory[2] ;
	assign memory[3] = \dut.memory[3] ;

	wire [ADDRESS-1:0] next_after = \dut.read_next - 1 + inside;
	wire [ADDRESS-1:0] place = \dut.read_next - 1 + before;

	always @(posedge clk) if (!rst) begin
		assert (inside <= DEPTH);
		assert (\dut.write_at == next_after);
		if (followed) begin
			assert (before < inside);
			if (before != 0)
				assert (memory[place] == value);
		end
	end
endmodule

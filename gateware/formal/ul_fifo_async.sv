// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of the dual-clock FIFO for any two clocks: an entry leaves unchanged and in order, none is lost and none
// is duplicated; an output is stable until it is accepted; the FIFO never stores more entries than its depth, and
// `in_level` is never less than the number stored.
//
// Each step of the proof is an instant; `in_clk` or `out_clk` at '1' means that this clock has its edge then (the tool
// converts the design to this form). So every order of edges is covered. If both clocks have an edge at once, each side
// reads the other's pointer before the change. A pointer sampled during a change reads as its old or its new value if
// only one bit changes at a time; that is proved below.
//
// The followed entry is arbitrary (`follow`), so its properties hold for all entries. The second half has the
// invariants that make the proof hold without a bound: the place of the entry, and the relations of the pointers.

module ul_fifo_async_properties #(
	parameter WIDTH = 2,
	parameter DEPTH = 4,
	parameter ADDRESS = $clog2(DEPTH)
) (
	input clk,
	input in_clk,
	input out_clk,
	input [WIDTH-1:0] in_data,
	input in_valid,
	input out_ready,
	input follow
);
	wire in_ready, out_valid;
	wire [WIDTH-1:0] out_data;
	wire [ADDRESS:0] in_level;
	reg rst = 1;
	wire in_rst = rst, out_rst = rst;

	ul_fifo_async dut (.*);

	wire push = !rst && in_clk && in_valid && in_ready;
	wire pop = !rst && out_clk && out_valid && out_ready;
	reg [ADDRESS:0] inside = 0, before = 0;
	reg followed = 0;
	reg [WIDTH-1:0] value;
	reg offered = 0;
	reg [WIDTH-1:0] offer;
	reg [3:0] gone = 0;

	always @(posedge clk) begin
		rst <= 0;
		if (rst) begin
			assume (in_clk && out_clk);
			assert (inside == 0 && !followed && !offered);
		end
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

		assert (inside <= DEPTH + 1);
		if (inside == 0)
			assert (!out_valid);
		if (inside == DEPTH + 1)
			assert (!in_ready);
		assert (in_level <= DEPTH);
		assert (in_level + out_valid >= inside);
		if (followed && before == 0 && out_valid)
			assert (out_data == value);
		if (offered)
			assert (out_valid && out_data == offer);

		// The FIFO can be filled, drained, and passed through, each after its memory has wrapped around.
		cover (inside == DEPTH + 1 && gone == DEPTH);
		cover (inside == 0 && gone == 2 * DEPTH);
		cover (push && pop && gone > DEPTH);
	end

	(* hierconn *) wire [ADDRESS:0] \dut.write_at , \dut.write_gray , \dut.write_crossing.meta , \dut.write_seen ;
	(* hierconn *) wire [ADDRESS:0] \dut.read_at , \dut.read_gray , \dut.read_crossing.meta , \dut.read_seen ;
	(* hierconn *) wire [WIDTH-1:0] \dut.memory[0] , \dut.memory[1] , \dut.memory[2] , \dut.memory[3] ;
	wire [WIDTH-1:0] memory [0:DEPTH-1];
	assign memory[0] = \dut.memory[0] ;
	assign memory[1] = \dut.memory[1] ;
	assign memory[2] = \dut.memory[2] ;
	assign memory[3] = \dut.memory[3] ;

	function [ADDRESS:0] binary(input [ADDRESS:0] code);
		integer i;
		begin
			binary = code;
			for (i = ADDRESS - 1; i >= 0; i = i - 1)
				binary[i] = binary[i + 1] ^ code[i];
		end
	endfunction

	// Distance of a pointer from the oldest pointer that either side sees.
	function [ADDRESS:0] beyond(input [ADDRESS:0] pointer);
		beyond = pointer - binary(\dut.read_seen );
	endfunction

	reg [ADDRESS:0] write_gray_before = 0, read_gray_before = 0;
	wire [ADDRESS:0] place = \dut.read_at - out_valid + before;

	always @(posedge clk) if (rst)
		assert (write_gray_before == 0 && read_gray_before == 0);

	always @(posedge clk) if (!rst) begin
		write_gray_before <= \dut.write_gray ;
		read_gray_before <= \dut.read_gray ;
		assert ($onehot0(write_gray_before ^ \dut.write_gray ));
		assert ($onehot0(read_gray_before ^ \dut.read_gray ));
		assert (binary(\dut.write_gray ) == \dut.write_at );
		assert (binary(\dut.read_gray ) == \dut.read_at );
		assert (beyond(binary(\dut.read_crossing.meta )) <= beyond(\dut.read_at ));
		assert (beyond(\dut.read_at ) <= beyond(binary(\dut.write_seen )));
		assert (beyond(binary(\dut.write_seen )) <= beyond(binary(\dut.write_crossing.meta )));
		assert (beyond(binary(\dut.write_crossing.meta )) <= beyond(\dut.write_at ));
		assert (beyond(\dut.write_at ) <= DEPTH);
		assert (inside == ((\dut.write_at - \dut.read_at ) & (2 * DEPTH - 1)) + out_valid);
		if (followed) begin
			assert (before < inside);
			if (before != 0 || !out_valid)
				assert (memory[place[ADDRESS-1:0]] == value);
		end
	end
endmodule

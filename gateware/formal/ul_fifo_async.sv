// SPDX-License-Identifier: BSD-3-Clause
//
// What the dual-clock FIFO promises, for any two clocks: an entry that went in comes out as it went in and in its turn,
// none is lost and none appears; what is offered stands until it is taken; it never takes more than it holds, and
// `in_level` never says less than is inside.
//
// A step of the proof is an instant, and `in_clk` or `out_clk` at '1' says that this clock has its edge then: the tool
// puts it so into the converted design. Every order of edges is one of these. An edge that both have at once reads the
// pointer of the other side as it was; that a pointer caught while it changes is its old or its new value needs no
// more than that one bit of it changes at a time, which is proved below.
//
// Which entry is followed is left open (`follow`), so what holds for it holds for all. The second half are the
// invariants that make the proof hold without a bound: where the entry waits, and how the pointers stand to each other.

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

		// It can be filled, drained, and passed through, each after its memory was gone round.
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

	// How far a pointer is beyond the oldest one that anybody sees.
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

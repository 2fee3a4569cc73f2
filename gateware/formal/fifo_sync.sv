// What the synchronous FIFO promises, for every sequence of offers and readiness from reset on (bounded by the depth of
// the search): entry number `chosen` (any number, picked by the solver) comes out as it went in, and as number `chosen`;
// no entry comes out that did not go in; it never takes more than it holds, and `level` counts what is inside.
//
// An offer that is not taken may be changed or taken back: the FIFO must not rely on a source that behaves better.

module fifo_sync_properties #(
	parameter WIDTH = 2,
	parameter DEPTH = 4
) (
	input clk,
	input [WIDTH-1:0] in_data,
	input in_valid,
	input out_ready
);
	wire in_ready, out_valid;
	wire [WIDTH-1:0] out_data;
	wire [$clog2(DEPTH):0] level;
	reg rst = 1;
	always @(posedge clk)
		rst <= 0;

	fifo_sync dut (.*);

	(* anyconst *) wire [4:0] chosen;
	reg [4:0] entered = 0, left = 0;
	reg [WIDTH-1:0] value;
	wire push = in_valid && in_ready;
	wire pop = out_valid && out_ready;

	always @(posedge clk) if (!rst) begin
		assume (entered < 30);
		if (push) begin
			entered <= entered + 1;
			if (entered == chosen)
				value <= in_data;
		end
		if (pop)
			left <= left + 1;

		assert (level == entered - left);
		assert (out_valid == (level != 0));
		assert (in_ready == (level != DEPTH));
		if (out_valid && left == chosen)
			assert (out_data == value);

		// The search is deep enough to fill it, drain it, and go round its memory twice.
		cover (level == DEPTH && left == 2 * DEPTH);
		cover (level == 0 && left == 2 * DEPTH + 1);
		cover (push && pop && level == 1 && left > DEPTH);
	end
endmodule

// What the dual-clock FIFO promises, whatever the two clocks do: the solver decides at each step which of them rises.
// Entry number `chosen` comes out as it went in and as number `chosen`, no entry comes out that did not go in, and what
// the writing side believes to be inside is never less than what is.
//
// Both sides are reset together before the first step. Metastability is not modelled: that a caught pointer is old or
// new and nothing else is what Gray code is for, and that one bit of it changes in a step is a property here.

module fifo_async_properties #(
	parameter WIDTH = 1,
	parameter DEPTH = 4
) (
	input gclk_unused,
	input [WIDTH-1:0] in_data,
	input in_valid,
	input out_ready
);
	(* gclk *) wire gclk;
	(* anyseq *) wire in_rises, out_rises;
	reg in_clk = 0, out_clk = 0;
	reg [3:0] steps = 0;
	wire resetting = steps < 6;
	wire in_rst = resetting, out_rst = resetting;
	wire in_ready, out_valid;
	wire [WIDTH-1:0] out_data;
	wire [$clog2(DEPTH):0] in_level;

	// During reset both clocks run; then each falls after it rose, and rises when the solver says so.
	always @(posedge gclk) begin
		if (resetting)
			steps <= steps + 1;
		in_clk <= !in_clk && (resetting || in_rises);
		out_clk <= !out_clk && (resetting || out_rises);
	end

	// Inputs change with their own clock, as registers do.
	reg [WIDTH-1:0] data = 0;
	reg valid = 0, ready = 0;
	always @(posedge in_clk) begin
		data <= in_data;
		valid <= in_valid && !in_rst;
	end
	always @(posedge out_clk)
		ready <= out_ready;

	fifo_async dut (
		.in_clk(in_clk), .in_rst(in_rst), .in_data(data), .in_valid(valid), .in_ready(in_ready), .in_level(in_level),
		.out_clk(out_clk), .out_rst(out_rst), .out_data(out_data), .out_valid(out_valid), .out_ready(ready)
	);

	(* anyconst *) wire [3:0] chosen;
	reg [3:0] entered = 0, left = 0;
	reg [WIDTH-1:0] value;

	always @(posedge in_clk) if (!in_rst && valid && in_ready) begin
		entered <= entered + 1;
		if (entered == chosen)
			value <= data;
	end
	always @(posedge out_clk) if (!out_rst && out_valid && ready)
		left <= left + 1;

	always @(posedge gclk) if (!resetting) begin
		assume (entered < 15);
		assert (entered - left <= DEPTH + 1);
		if (out_valid) begin
			assert (entered != left);
			if (left == chosen)
				assert (out_data == value);
		end
		cover (left == DEPTH + 2);
		cover (entered - left == DEPTH + 1);
	end
endmodule

// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of ul_gpio for all pins, resets and registers: its level follows the pin once the pin was stable for
// STANDS cycles, and no sooner; each change of the level, and no other event, is an edge, is counted, and stores the
// time; a pin is driven if requested, but not in the cycle after one in which the axis is not armed.
//
// DIRECT selects an entity without debouncing. The invariants at the end make the proof hold without a bound.

module ul_gpio_properties (
	input clk,
	input rst,
	input [63:0] now,
	input armed,
	input to_drive,
	input drive,
	input pin_in
);
`ifdef DIRECT
	localparam STANDS = 1;
`else
	localparam STANDS = 3;
`endif

	wire level, has_edge, pin_out, pin_oe;
	wire [15:0] edges;
	wire [31:0] last;

	ul_gpio dut (
		.clk(clk), .rst(rst), .now(now), .armed(armed), .level(level), .\output (to_drive), .output_written(1'b0),
		.drive(drive), .drive_written(1'b0), .edges(edges), .last(last), .\edge (has_edge), .pin_in(pin_in),
		.pin_out(pin_out), .pin_oe(pin_oe)
	);

	// The first reset lasts until the pin has passed the synchroniser.
	reg [2:0] age = 0;
	wire begun = age[2];
	// Values of earlier cycles; bit 0 is the last one.
	reg [STANDS+1:0] pins, resets = -1;
	reg was_level, was_armed, was_to_drive, was_driven;
	reg [15:0] were_edges;
	reg [31:0] was_last, was_now;
	// Number of consecutive cycles, up to the last one, in which the pin differed from the level, two cycles late.
	reg [1:0] differed;
	wire settled = pins[1];

	always @(posedge clk) begin
		age <= age + !begun;
		assume (begun || rst);
		pins <= {pins, pin_in};
		resets <= {resets, rst};
		was_level <= level;
		was_armed <= armed;
		was_to_drive <= to_drive;
		was_driven <= drive;
		were_edges <= edges;
		was_last <= last;
		was_now <= now[31:0];
		differed <= rst || settled == level || differed == STANDS - 1 ? 0 : differed + 1;
	end

	wire was_reset = resets[0];
	wire [STANDS-1:0] stood = pins[STANDS+1:2];

	always @(posedge clk) if (begun) begin
		if (was_reset) begin
			assert (edges == 0 && !has_edge && !pin_oe);
			assert (level == pins[2]);
		end else begin
			assert (has_edge == (level != was_level));
			assert (edges == were_edges + has_edge);
			assert (last == (has_edge ? was_now : was_last));
			assert (pin_oe == (was_driven && was_armed));
			assert (pin_out == was_to_drive);
			if (has_edge)
				assert (stood == {STANDS{level}});
			if (resets == 0)
				assert (stood != {STANDS{!level}});
		end

		cover (has_edge && edges == 2 && !level);
		cover (!pin_oe && was_driven && !was_armed);
`ifndef DIRECT
		// The pin bounces once, and is then accepted.
		cover (has_edge && level && edges == 1 && pins[4:2] == 3'b111 && !resets[4]);
		cover (differed == 2 && settled == level && !was_reset);
`endif
	end

	(* hierconn *) wire \dut.settled , \dut.pins_crossing.meta ;
	(* hierconn *) wire [2-(STANDS==1):0] \dut.all_axes_n1_left ;

	always @(posedge clk) begin
		if (age > 0)
			assert (\dut.pins_crossing.meta == pins[0]);
		if (age > 1)
			assert (\dut.settled == settled);
	end

	always @(posedge clk) if (begun) begin
		assert (differed < STANDS);
		assert ($signed(\dut.all_axes_n1_left ) == STANDS - 2 - $signed({1'b0, differed}));
		assert (pins[2 + differed] == level);
		if (differed > 0)
			assert (pins[2] != level);
		if (differed > 1)
			assert (pins[3] != level);
	end
endmodule

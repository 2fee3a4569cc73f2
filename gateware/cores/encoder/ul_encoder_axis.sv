// SPDX-License-Identifier: BSD-3-Clause
//
// What an axis of an encoder promises, whatever its pins do: a level changes when so many samples in a row have shown
// another, and not before. The position moves by one at most, and only where exactly one of the two signals changes; an
// error counts exactly where both do. The edge's time, its direction and the index are those of that cycle.

module ul_encoder_axis_properties #(
	parameter FILTER = 3,
	parameter TIME = 3
) (
	input clk,
	input settled,
	input [TIME-1:0] time_now,
	input a, b, z,
	input taken
);
	wire [2:0] filtered;
	wire [31:0] position, index_position;
	wire [15:0] index_count, errors;
	wire [TIME-1:0] edge_time;
	wire down, moved;
	reg rst = 1;

	ul_encoder_axis dut (.*);

	// As the pins come out of their synchronisers: the newest sample is the lowest one.
	reg [2:0] meta = 0;
	reg [2:0] samples [0:FILTER-1];
	reg [2:0] old = 0;
	reg [2:0] last_filtered, last_old;
	reg [31:0] last_position, last_index_position;
	reg [15:0] last_index_count, last_errors;
	reg [TIME-1:0] last_time;
	reg last_moved, last_taken, last_settled, last_down;
	reg [TIME-1:0] last_edge_time;
	reg valid = 0;
	reg [2:0] differ, last_differ;
	integer age;

	initial
		for (age = 0; age < FILTER; age = age + 1)
			samples[age] = 0;

	always @(posedge clk) begin
		rst <= 0;
		valid <= !rst;
		meta <= rst ? 0 : {z, b, a};
		samples[0] <= rst ? 0 : meta;
		for (age = 1; age < FILTER; age = age + 1)
			samples[age] <= rst ? 0 : samples[age-1];
		old <= rst ? 0 : filtered;
		last_filtered <= filtered;
		last_old <= old;
		last_position <= position;
		last_index_position <= index_position;
		last_index_count <= index_count;
		last_errors <= errors;
		last_time <= time_now;
		last_moved <= moved;
		last_taken <= taken;
		last_settled <= settled;
		last_down <= down;
		last_edge_time <= edge_time;
		// Pins that have differed from the level in all of the samples.
		differ = 3'b111;
		for (age = 0; age < FILTER; age = age + 1)
			differ = differ & (samples[age] ^ filtered);
		last_differ <= differ;
	end

	wire change_a = last_filtered[0] ^ last_old[0];
	wire change_b = last_filtered[1] ^ last_old[1];
	wire [31:0] step = position - last_position;
`ifdef COUNTER
	wire count = last_settled && change_a && last_filtered[0];
	wire backwards = last_filtered[1];
	wire error = 0;
`else
	wire count = last_settled && (change_a != change_b);
	// b, a: 00, 01, 11, 10 upwards.
	wire [3:0] way = {last_old[1:0], last_filtered[1:0]};
	wire forwards = way == 4'b0001 || way == 4'b0111 || way == 4'b1110 || way == 4'b1000;
	wire backwards = !forwards;
	wire error = last_settled && change_a && change_b;
`endif
	wire index = last_settled && last_filtered[2] && !last_old[2];

	always @(posedge clk) if (!rst && valid) begin
		if (last_settled)
			assert ((filtered ^ last_filtered) == last_differ);

		assert (step == (count ? (backwards ? -32'd1 : 32'd1) : 32'd0));
		assert (errors == last_errors + error);
		assert (index_count == last_index_count + index);
		assert (index_position == (index ? position : last_index_position));
		assert (moved == (count || (last_moved && !last_taken)));
		assert (edge_time == (count ? last_time : last_edge_time));
		assert (down == (count ? backwards : last_down));

		cover (last_settled && position == 3 && index_count == 1);
		cover (last_settled && position == -32'd2 && count);
`ifndef COUNTER
		cover (errors == 2 && position == 1);
`endif
	end
endmodule

// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of ul_pwm for all values, arming and resets: each pin is '1' in exactly those cycles of a period to which
// the value sampled at its beginning rounds; both are '0' from the cycle after one that is not armed until a period
// begins; `dir` of "sign" changes when a period begins; the two pins of a bridge are never '1' together, nor within the
// dead time.
//
// UP_DOWN or OFFSET selects the mode (otherwise "sign"), CENTRE the alignment, SHORT a period of 4 cycles instead of
// 12, which does not resolve a value of 4 bits. The properties multiply; the entity steps along a ramp. The invariants
// at the end make the proof hold without a bound: they state the values of ramp and rest in each cycle of a period.

module ul_pwm_properties (
	input clk,
	input rst,
	input armed,
	input [3:0] value,
	input value_written
);
`ifdef UP_DOWN
	localparam UP_DOWN = 1, OFFSET = 0, DEAD = 2;
`elsif OFFSET
	localparam UP_DOWN = 0, OFFSET = 1, DEAD = 2;
`else
	localparam UP_DOWN = 0, OFFSET = 0, DEAD = 0;
`endif
`ifdef CENTRE
	localparam CENTRE = 1;
`else
	localparam CENTRE = 0;
`endif
`ifdef SHORT
	localparam HALF = 2;
`else
	localparam HALF = 6;
`endif
	localparam PERIOD = 2 * HALF, FULL = OFFSET ? 14 : 7;

	wire pwm, dir;

	ul_pwm dut (.*);

	// The number of a cycle in its period: for the ramp, and one cycle later for the comparison.
	reg begun = 0, known, compares;
	reg [3:0] number, at;
	// The sampled value, and whether the axis outputs its pulse.
	reg follows;
	reg signed [3:0] taken;
	reg was_armed, was_reset, did_follow, was_first, last_dir;

	always @(posedge clk) begin
		begun <= 1;
		assume (begun || rst);
		known <= !rst;
		number <= rst ? PERIOD - 1 : number == PERIOD - 1 ? 0 : number + 1;
		compares <= known && !rst;
		at <= number;
		if (known && number == 0) begin
			taken <= value;
			follows <= 1;
		end
		if (!armed || rst)
			follows <= 0;
		was_armed <= armed;
		was_reset <= rst;
		did_follow <= follows;
		was_first <= at == 0;
		last_dir <= dir;
	end

	// From 0 to FULL; the most negative number equals its successor.
	wire signed [4:0] clamped = taken == -8 ? -7 : taken;
	wire [3:0] size = OFFSET ? clamped + 7 : clamped < 0 ? -clamped : clamped;
	// Rounded to the nearest cycle. No value is exactly between two cycles, because FULL is odd, and in "offset" PERIOD is
	// even.
	wire [9:0] edge_aligned = (2 * at + 1) * FULL;
	wire [9:0] before_centre = (4 * (HALF - 1 - at) + 1) * FULL, behind_centre = (4 * (at - HALF) + 3) * FULL;
	wire high = CENTRE ? 4 * HALF * size > (at < HALF ? before_centre : behind_centre) : 2 * PERIOD * size > edge_aligned;
	wire wants_pwm = UP_DOWN ? high && taken >= 0 : high;
	wire wants_dir = UP_DOWN ? high && taken < 0 : OFFSET ? !high : taken < 0;
	reg expect_pwm, expect_dir;

	always @(posedge clk) begin
		expect_pwm <= follows && armed && !rst && wants_pwm;
		expect_dir <= follows && armed && !rst && wants_dir;
	end

	always @(posedge clk) if (begun) begin
		if (!was_armed || was_reset || !did_follow)
			assert (!pwm && !dir);
		if (DEAD == 0) begin
			assert (pwm == expect_pwm);
			assert (dir == expect_dir);
			if (was_armed && !was_reset && !was_first)
				assert (dir == last_dir);
		end
	end

	// Cycles since each pin was '1', and cycles for which it was wanted, both saturated at 7; and the pin that was '1'
	// last.
	reg [2:0] since_pwm = 7, since_dir = 7, for_pwm = 0, for_dir = 0;
	reg last_was_pwm = 0, last_was_dir = 0;

	always @(posedge clk) if (begun) begin
		since_pwm <= pwm ? 0 : since_pwm + (since_pwm != 7);
		since_dir <= dir ? 0 : since_dir + (since_dir != 7);
		for_pwm <= expect_pwm ? for_pwm + (for_pwm != 7) : 0;
		for_dir <= expect_dir ? for_dir + (for_dir != 7) : 0;
		if (pwm || dir) begin
			last_was_pwm <= pwm;
			last_was_dir <= dir;
		end
		if (DEAD != 0) begin
			assert (!(pwm && dir));
			assert (!pwm || since_dir >= DEAD);
			assert (!dir || since_pwm >= DEAD);
			// A pin is '1' only if it is wanted; at once, or after the dead time.
			assert (!pwm || expect_pwm);
			assert (!dir || expect_dir);
			if (expect_pwm && (last_was_pwm || for_pwm >= DEAD))
				assert (pwm);
			if (expect_dir && (last_was_dir || for_dir >= DEAD))
				assert (dir);
		end

		cover (dir && taken == -8 && was_first && did_follow);
		cover (pwm && taken == 1);
`ifdef OFFSET
		cover (dir && since_pwm == DEAD);
		cover (pwm && since_dir == DEAD && !was_first);
`else
		cover (!pwm && !dir && taken == 0 && at == PERIOD - 1 && did_follow);
`endif
`ifdef UP_DOWN
		cover (dir && since_pwm == DEAD && did_follow);
`elsif OFFSET
`else
		cover (pwm && taken > 0 && last_dir);
`endif
		// The axis is armed again in the middle of a period, and idle until its end.
		cover (was_armed && armed && !follows && compares && at == PERIOD - 3);
	end

	(* hierconn *) wire [4-CENTRE-2*(HALF==2):0] \dut.left ;
	(* hierconn *) wire [4-CENTRE-2*(HALF==2):0] \dut.rest ;
	(* hierconn *) wire \dut.is_second , \dut.begins ;
	(* hierconn *) wire [2+OFFSET:0] \dut.ramp , \dut.beyond , \dut.all_axes_n1_size ;
	(* hierconn *) wire \dut.all_axes_n1_runs , \dut.all_axes_n1_is_negative ;

	localparam STEPS = CENTRE ? HALF : PERIOD;
	localparam FALLS_FROM = FULL - 1 - FULL / 4 + STEPS;
	localparam RISES_FROM = (CENTRE ? 3 * FULL / 4 : FULL / 2) + (OFFSET ? STEPS : 0);

	function [8:0] scaled_ramp (input [3:0] of);
		scaled_ramp = CENTRE && of < HALF ? of * FULL + FALLS_FROM : (of - CENTRE * HALF) * FULL + RISES_FROM;
	endfunction

	wire second = !CENTRE || number >= HALF;
	wire [3:0] step = CENTRE && second ? number - HALF : number;
	wire [8:0] scaled = scaled_ramp(number), compared = scaled_ramp(at);
	wire [2+OFFSET:0] ramp_compared = compared / STEPS;
	wire signed [5:0] left = STEPS - 2 - step;
	wire signed [5:0] rest = scaled % STEPS + FULL % STEPS - STEPS;

	always @(posedge clk) if (begun) begin
		assert (number < PERIOD);
		assert (\dut.begins == (known && number == 0));
		assert (\dut.all_axes_n1_runs == follows);
		assert (!follows || compares);
		assert (!did_follow || was_reset || compares);
		if (known) begin
			assert ($signed(\dut.left ) == left);
			assert (\dut.is_second == second);
			assert (\dut.ramp == scaled / STEPS);
			assert ($signed(\dut.rest ) == rest);
		end else begin
			assert (&\dut.left && \dut.is_second && number == PERIOD - 1);
		end
		assert (!compares || known);
		if (compares) begin
			assert (at == (number == 0 ? PERIOD - 1 : number - 1));
			assert (\dut.beyond == (CENTRE && at < HALF ? ramp_compared : ~ramp_compared));
		end
		if (follows) begin
			assert (\dut.all_axes_n1_is_negative == (!OFFSET && taken < 0));
			assert (\dut.all_axes_n1_size == (OFFSET ? {~taken[3], taken[2:0]} : taken[2:0] ^ {3{taken[3]}}));
		end
	end
endmodule

// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of ul_lease for all words, e-stops and resets, from any initial time: `armed` is '1' exactly in the cycles
// after an arm and before the end that the owner named last, until a disarm or an e-stop. `end_at` and the registers
// beside it are a model in absolute time; the entity counts down instead.
//
// With FINISH > 0, a lease whose owner wants it continues after its end while `empty` is '0', for at most FINISH
// cycles: it accepts no word then, and a disarm and the e-stop end it as usual. NO_ESTOP selects an entity without an
// e-stop, whose leases end at their ends; words that ask for more are ignored.
//
// Also proved: a lease lasts less than MOST cycles after the last accepted word; a word with another token, or with an
// end that is past or too far ahead, changes nothing; the end of a lease never moves earlier; `armed` falls in the
// cycle after its cause, and rises only by an arm that was written since. The invariants at the end make the proof hold
// without a bound.

module ul_lease_properties (
	input clk,
	input rst,
	input [63:0] now,
	input empty,
	input [63:0] arm,
	input arm_written,
	input [63:0] kick,
	input kick_written,
	input disarm,
	input disarm_written,
	input estop
);
	localparam MOST = 6;
`ifdef NO_ESTOP
	localparam FINISH = 0;
`else
	localparam FINISH = 5;
`endif
	localparam DISARMED = 0, ARMED = 1, FAULT = 2, FINISHING = 3;
	localparam NONE = 0, BY_DISARM = 1, SILENCE = 2, ESTOP = 3;

	wire [63:0] clock, fault_time;
	wire armed, finishing, estop_open, enable;
	wire [1:0] state;
	wire [2:0] reason;
	wire [15:0] arms;

	ul_lease dut (.*);

	// Values of the cycle before.
	reg begun = 0;
	reg was_reset, was_armed, was_open, was_disarmed, was_finishing, was_empty;
	reg [1:0] was_state;
	reg [2:0] was_reason;
	reg [15:0] was_arms;
	reg [63:0] was_now, was_fault_time;

	// The pin in the cycle before, and in the one before that.
	reg was_estop, estop_before, was_reset_before;

	// The word written in the cycle before, and whether its end was near enough then.
	reg asked, is_arm, in_reach;
	reg [23:0] token_asked;
	reg [39:0] end_asked;

	// Owner and end of the lease, according to the model.
	reg [23:0] owner;
	reg [39:0] end_at;

	wire [63:0] word = arm_written ? arm : kick;
	wire [39:0] ahead = word[39:0] - now[39:0];

	// The word of the cycle before takes effect in this cycle: from the next one on, if its end is later than that.
	wire [39:0] left_asked = end_asked - now[39:0], left = end_at - now[39:0];
	wire is_owner = token_asked == owner;
	wire takes = asked && in_reach && !rst && !finishing && !estop_open && !disarm_written &&
		(armed ? is_owner && left_asked > left : is_arm && left_asked > 1 && left_asked <= MOST);
	reg took, did_end, did_go_on;

	// The lease does not stop at its end, but continues.
	wire goes_on = FINISH != 0 && armed && !finishing && owner[23] && left == 1 && !takes && !empty && !estop_open &&
		!disarm_written && !rst;

	// Cycles since the last accepted word was written.
	reg [3:0] since = 15;

	always @(posedge clk) begin
		begun <= 1;
		assume (begun || rst);
		{was_reset, was_armed, was_open, was_disarmed} <= {rst, armed, estop_open, disarm_written};
		{was_finishing, was_empty, did_go_on} <= {finishing, empty, goes_on};
		{was_state, was_reason, was_arms, was_fault_time, was_now} <= {state, reason, arms, fault_time, now};
		{was_estop, estop_before, was_reset_before} <= {estop, was_estop, was_reset};
		// The time may jump to any value at a reset.
		if (begun && !was_reset)
			assume (now == was_now + 1);

		asked <= (arm_written || kick_written) && !disarm_written && !rst && !(FINISH == 0 && word[63]);
		is_arm <= arm_written;
		token_asked <= word[63:40];
		end_asked <= word[39:0];
		in_reach <= ahead > 0 && ahead <= MOST;

		took <= takes;
		did_end <= left == 1;
		if (takes) begin
			owner <= token_asked;
			end_at <= end_asked;
		end else if (goes_on)
			end_at <= end_at + FINISH;
		// `since` becomes 2, because the word was written a cycle ago and is in effect in the next one.
		since <= takes ? 2 : since + (since != 15);
	end

	wire fell = was_armed && !armed;

	always @(posedge clk) if (begun) begin
		assert (enable == armed);
		assert (clock == now);
		assert (state == (finishing ? FINISHING : armed ? ARMED : was_reset ? DISARMED :
			fell && (was_open || !was_disarmed) ? FAULT : fell ? DISARMED : was_state));

		// armed is '1' during a lease, and only then.
		if (was_reset)
			assert (!armed && reason == NONE && arms == 0 && fault_time == 0);
		else begin
			assert (armed == (took || did_go_on ||
				(was_armed && !was_open && !was_disarmed && !did_end && !(was_finishing && was_empty))));
			assert (finishing == (armed && (did_go_on || was_finishing)));
			assert (reason == (!fell ? was_reason : was_open ? ESTOP : was_disarmed ? BY_DISARM : SILENCE));
			// The count rises with armed: an arm by the owner of a running lease counts as a kick.
			assert (arms == (was_armed || !armed ? was_arms : was_arms + 16'd1));
			assert (fault_time == (state == FAULT && fell ? was_now : was_fault_time));
		end

		// The end is never exceeded, and is never more than MOST cycles after the word that named it; then at most FINISH
		// more.
		if (armed)
			assert (left > 0 && (finishing ? left <= FINISH : left + since <= MOST));
		if (finishing)
			assert (owner[23] && !took && FINISH != 0);
		if (was_open || was_disarmed)
			assert (!armed);
`ifdef NO_ESTOP
		assert (!estop_open);
`else
		// The pin, two cycles ago; a reset opens the e-stop.
		assert (estop_open == (was_reset || !estop_before || was_reset_before));
`endif
		// A lease that ends by silence ends in the very cycle of the end.
		if (fell && state == FAULT && reason == SILENCE && !was_reset)
			assert (was_finishing && was_empty ? left < FINISH : now[39:0] == end_at);

		cover (armed && left == MOST - 2);
		cover (fell && reason == SILENCE && since == MOST);
`ifndef NO_ESTOP
		cover (fell && reason == ESTOP);
		cover (finishing && left == FINISH);
		cover (fell && was_finishing && did_end && state == FAULT);
		cover (fell && was_finishing && left == 3 && state == FAULT);
		cover (fell && was_finishing && state == DISARMED && !was_reset);
		cover (finishing && asked && in_reach && is_owner && left_asked > left);
`endif
		cover (fell && state == DISARMED && !was_reset);
		// A kick moves the end, in the last cycle in which that is possible.
		cover (took && was_armed && did_end && armed);
		// A word with another token, one that would shorten the lease, and one that is too late.
		cover (asked && armed && in_reach && !is_owner && left_asked > left && !takes);
		cover (asked && armed && in_reach && is_owner && left_asked < left);
		cover (asked && !armed && is_arm && in_reach && left_asked == 1 && !estop_open && !disarm_written);
		// A lease that includes the overflow of the 40 bits.
		cover (armed && now[39:0] == 0 && !took);
		cover (took && was_state == FAULT);
	end

	(* hierconn *) wire [2:0] \dut.all_axes_n1_left ;
	(* hierconn *) wire [23:0] \dut.all_axes_n1_token ;
	(* hierconn *) wire \dut.all_axes_n1_is_fault ;

	always @(posedge clk) if (begun) begin
		assert (\dut.all_axes_n1_left == (armed ? left + 1 : 2));
		if (armed)
			assert (\dut.all_axes_n1_token == owner && !\dut.all_axes_n1_is_fault );
	end
endmodule

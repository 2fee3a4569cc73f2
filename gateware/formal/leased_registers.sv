// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of a generated register bank for registers that a lease guards and a schedule writes (those of leased.ul),
// for any Wishbone master, lease and schedule, in any cycle. After a cycle in which the lease is not armed, each
// guarded register has its safe value, or keeps its value (HOLD); a write ends with err then, and changes nothing. A
// register keeps its safe value until it is written again under the new lease, by the bus or from its shadow. While the
// lease is finishing, a write ends with err too, and only shadows change registers. Values written before the lease
// ended are discarded, whether parts of a value or values in a shadow. New values in the shadows are transferred in the
// cycle of `commit`, all of them and once. A register without a lease is not affected by one.

module leased_registers_properties (
	input clk,
	input rst,
	input wb_cyc,
	input wb_stb,
	input wb_we,
	input [7:0] wb_adr,
	input [31:0] wb_dat_i,
	input sample_access,
	input [63:0] drive_clock_from_core,
	input [63:0] drive_fault_time_from_core,
	input drive_armed_from_core,
	input drive_finishing_from_core,
	input [1:0] drive_state_from_core,
	input [2:0] drive_reason_from_core,
	input drive_estop_open_from_core,
	input [15:0] drive_arms_from_core,
	input [63:0] plan_clock_from_core,
	input [63:0] plan_fates_from_core,
	input [31:0] plan_late_from_core,
	input [31:0] plan_refused_from_core,
	input [15:0] plan_room_from_core,
	input [31:0] plan_slack_from_core,
	input plan_stage_write,
	input [15:0] plan_stage_index,
	input [31:0] plan_stage_data,
	input plan_stage_clear,
	input plan_commit,
	input [31:0] elsewhere_dat_i,
	input elsewhere_ack,
	input elsewhere_err
);
	localparam GOAL = 0, DUTY = 1, SPEED = 2, FIELDS = 3, WIDE = 4, OTHER = 6;
	localparam GOAL_PLACE = 0, SPEED_PLACE = 1, WIDE_PLACE = 2, OTHER_PLACE = 4;

	wire wb_ack, wb_err;
	wire [7:0] goal, duty, speed, other;
	wire [3:0] low, high;
	wire [39:0] wide;
	wire goal_written, duty_written, speed_written, low_written, high_written, wide_written, other_written;

	leased_registers dut (
		.wb_dat_o(), .wb_stall(),
		.drive_arm_to_core(), .drive_arm_written(), .drive_kick_to_core(), .drive_kick_written(),
		.drive_disarm_to_core(), .drive_disarm_written(),
		.plan_entry_to_core(), .plan_entry_written(), .plan_cancel_to_core(), .plan_cancel_written(),
		.elsewhere_cyc(), .elsewhere_stb(), .elsewhere_we(), .elsewhere_adr(), .elsewhere_dat_o(),
		.axis_goal_to_core(goal), .axis_goal_written(goal_written),
		.to_hardware_duty(duty), .to_hardware_duty_written(duty_written),
		.to_hardware_speed(speed), .to_hardware_speed_written(speed_written),
		.to_hardware_low(low), .to_hardware_low_written(low_written),
		.to_hardware_high(high), .to_hardware_high_written(high_written),
		.to_hardware_wide(wide), .to_hardware_wide_written(wide_written),
		.to_hardware_other(other), .to_hardware_other_written(other_written),
		.*
	);

	(* hierconn *) wire [31:0] \dut.wide_gathered ;
	(* hierconn *) wire [7:0] \dut.axis_goal_shadow , \dut.speed_shadow , \dut.other_shadow ;
	(* hierconn *) wire [39:0] \dut.wide_shadow ;
	(* hierconn *) wire \dut.axis_goal_pending , \dut.speed_pending , \dut.other_pending ;
	(* hierconn *) wire [1:0] \dut.wide_pending ;

	wire armed = drive_armed_from_core;
	// The bus may write; a schedule may write while the lease is armed.
	wire open = armed && !drive_finishing_from_core;
	wire begins = wb_cyc && wb_stb && !wb_ack && !wb_err;
	wire guarded = wb_adr < OTHER;
	wire writes = begins && wb_we && (open || !guarded);

	// Expected value of each register, its new value in the shadow, and the words received of a value that is not
	// complete.
	reg first = 1;
	reg [7:0] is_goal = 0, is_duty = 8'h5A, is_speed = 7, is_other = 0;
	reg [3:0] is_low = 9, is_high = 3;
	reg [39:0] is_wide = 40'h1234567890;
	reg [31:0] gathered = 0;
	reg [4:0] is_new = 0;
	reg [7:0] new_goal, new_speed, new_other;
	reg [39:0] new_wide;
	reg [6:0] pulses = 0;
	// Written since the lease was armed.
	reg [5:0] is_fresh = 0;
	// A write was rejected in the last cycle; a write was allowed.
	reg refused = 0, allowed = 0;
	// The lease was not armed in the last cycle.
	reg unarmed = 1;

	wire [4:0] takes = plan_commit ? is_new & {1'b1, {4{armed}}} : 5'b0;

	always @(posedge clk) begin
		first <= 0;
		assume (rst == first);
		assume (!first || !wb_cyc);
	end

	always @(posedge clk) if (!first) begin
		unarmed <= !armed;
		refused <= begins && wb_we && guarded && !open;
		allowed <= writes && wb_adr <= OTHER;
		pulses <= 0;
		if (writes) case (wb_adr)
			GOAL: begin is_goal <= wb_dat_i[7:0]; pulses[0] <= 1; is_fresh[0] <= 1; end
			DUTY: begin is_duty <= wb_dat_i[7:0]; pulses[1] <= 1; is_fresh[1] <= 1; end
			SPEED: begin is_speed <= wb_dat_i[7:0]; pulses[2] <= 1; is_fresh[2] <= 1; end
			FIELDS: begin {is_high, is_low} <= wb_dat_i[7:0]; pulses[4:3] <= 3; is_fresh[4:3] <= 3; end
			WIDE: gathered <= wb_dat_i;
			WIDE + 1: begin is_wide <= {wb_dat_i[7:0], gathered}; pulses[5] <= 1; is_fresh[5] <= 1; end
			OTHER: begin is_other <= wb_dat_i[7:0]; pulses[6] <= 1; end
			default: ;
		endcase
		// A commit takes effect whatever the bus writes.
		if (takes[0]) begin is_goal <= new_goal; pulses[0] <= 1; is_fresh[0] <= 1; end
		if (takes[1]) begin is_speed <= new_speed; pulses[2] <= 1; is_fresh[2] <= 1; end
		if (takes[2]) begin is_wide[31:0] <= new_wide[31:0]; pulses[5] <= 1; is_fresh[5] <= 1; end
		if (takes[3]) begin is_wide[39:32] <= new_wide[39:32]; pulses[5] <= 1; is_fresh[5] <= 1; end
		if (takes[4]) begin is_other <= new_other; pulses[6] <= 1; end
		if (plan_commit)
			is_new <= 0;
		if (plan_stage_write) case (plan_stage_index)
			GOAL_PLACE: begin new_goal <= plan_stage_data[7:0]; is_new[0] <= 1; end
			SPEED_PLACE: begin new_speed <= plan_stage_data[7:0]; is_new[1] <= 1; end
			WIDE_PLACE: begin new_wide[31:0] <= plan_stage_data; is_new[2] <= 1; end
			WIDE_PLACE + 1: begin new_wide[39:32] <= plan_stage_data[7:0]; is_new[3] <= 1; end
			OTHER_PLACE: begin new_other <= plan_stage_data[7:0]; is_new[4] <= 1; end
			default: ;
		endcase
		if (plan_stage_clear)
			is_new <= 0;
		if (!armed) begin
			is_duty <= 8'h5A;
			is_speed <= 7;
			{is_high, is_low} <= 8'h39;
			is_wide <= 40'h1234567890;
			gathered <= 0;
			is_new[3:0] <= 0;
			is_fresh <= 0;
		end

		assert (goal == is_goal && duty == is_duty && speed == is_speed && low == is_low && high == is_high);
		assert (wide == is_wide && other == is_other);
		assert ({other_written, wide_written, high_written, low_written, speed_written, duty_written, goal_written} == pulses);
		assert (!refused || (wb_err && !wb_ack));
		assert (!allowed || (wb_ack && !wb_err));
		// The same requirement stated directly: safe values after a cycle without a lease, and until written again.
		if (unarmed)
			assert (is_fresh == 0);
		if (!is_fresh[1])
			assert (duty == 8'h5A);
		if (!is_fresh[2])
			assert (speed == 7);
		if (!is_fresh[3] && !is_fresh[4])
			assert ({high, low} == 8'h39);
		if (!is_fresh[5])
			assert (wide == 40'h1234567890);

		// Invariants that make the proof hold without a bound.
		assert (\dut.wide_gathered == gathered);
		assert ({\dut.other_pending , \dut.wide_pending , \dut.speed_pending , \dut.axis_goal_pending } == is_new);
		if (is_new[0]) assert (\dut.axis_goal_shadow == new_goal);
		if (is_new[1]) assert (\dut.speed_shadow == new_speed);
		if (is_new[2]) assert (\dut.wide_shadow [31:0] == new_wide[31:0]);
		if (is_new[3]) assert (\dut.wide_shadow [39:32] == new_wide[39:32]);
		if (is_new[4]) assert (\dut.other_shadow == new_other);

		cover (is_fresh == 6'h3F && unarmed == 0);
		cover (refused && goal != 0);
		cover (refused && !unarmed && pulses[5]);
		cover (pulses[6] && pulses[5] && pulses[2] && pulses[0]);
		cover (unarmed && armed && is_other != 0 && is_goal != 0);
	end
endmodule

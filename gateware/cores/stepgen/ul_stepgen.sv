// SPDX-License-Identifier: BSD-3-Clause
//
// What the pins of a step generator promise, for any commands and arming: a pulse and the pause behind it are as long as
// they are to be; the direction is stable before a pulse and behind it. A pulse begins exactly where the axis comes to
// another step, in the direction of its motion. An axis follows a position only if that was written while it was armed.
// A new acceleration acts in a round of an axis that stands or follows nothing, and in no other one.
// The motion is proved in ul_stepgen_ramp.sv.
//
// The last part are invariants that make the proof hold without a bound: a round has seven cycles at least, so the rounds
// that are counted are as many cycles.

module ul_stepgen_properties #(
	// Cycles.
	parameter LENGTH = 8,
	parameter SPACE = 6,
	parameter SETUP = 15,
	parameter HOLD = 22
) (
	input clk,
	input armed,
	input [31:0] position_cmd,
	input position_cmd_written,
	input [28:0] velocity_cmd,
	input velocity_cmd_written,
	input mode,
	input mode_written,
	input [27:0] maxvel,
	input maxvel_written,
	input [27:0] maxaccel,
	input maxaccel_written
);
	wire [31:0] position;
	wire [28:0] velocity;
	wire in_position, holding, step, dir;
	reg rst = 1;

	ul_stepgen dut (.*);

	(* hierconn *) wire [39:0] \dut.place , \dut.next_place ;
	(* hierconn *) wire [2:0] \dut.stage , \dut.age ;
	(* hierconn *) wire \dut.is_busy , \dut.writes , \dut.moves , \dut.clearing , \dut.down ;
	(* hierconn *) wire [27:0] \dut.accels , \dut.maxaccel_now ;
	(* hierconn *) wire \dut.stands , \dut.each_n1_stood ;
	(* hierconn *) wire \dut.is_high , \dut.points_down , \dut.has_turned , \dut.takes , \dut.follows , \dut.fresh , \dut.axis , \dut.write_axis ;

	// Cycles, this one included and without end at 63, since a level has changed, and since a round ended.
	reg [5:0] before_high = 0, before_low = 0, before_dir = 0, since_round = 0;
	reg last_step = 0, last_dir = 0, valid = 0, commanded = 0;
	reg last_writes, last_down, last_moves, last_takes, last_holding;
	reg [39:0] last_place;
	// The acceleration that the register had when the round began, and that of the round before.
	reg [27:0] given_accel = 0, last_accel = 0;
	reg has_looked = 0;

	function [5:0] longer (input [5:0] cycles);
		longer = cycles == 63 ? cycles : cycles + 1;
	endfunction

	// For how long step was and is high, was and is low, and dir is what it is; before this cycle, and with it.
	wire [5:0] high_for = step ? longer(before_high) : 0;
	wire [5:0] low_for = step ? 0 : longer(before_low);
	wire [5:0] dir_for = dir == last_dir ? longer(before_dir) : 1;

	always @(posedge clk) begin
		rst <= 0;
		valid <= !rst;
		before_high <= rst ? 0 : high_for;
		before_low <= rst ? 0 : low_for;
		before_dir <= rst ? 0 : dir_for;
		since_round <= rst ? 0 : \dut.writes ? 1 : longer(since_round);
		last_step <= rst ? 0 : step;
		last_dir <= rst ? 0 : dir;
		last_writes <= \dut.writes && !\dut.clearing ;
		last_down <= \dut.down ;
		last_moves <= \dut.moves ;
		last_place <= \dut.place ;
		last_takes <= \dut.takes ;
		last_holding <= holding;
		if (\dut.takes )
			given_accel <= maxaccel;
		if (\dut.stage == 2)
			last_accel <= \dut.maxaccel_now ;
		has_looked <= !rst && (has_looked || \dut.stage == 2);
		commanded <= !rst && armed && (commanded || position_cmd_written);
	end

	wire rises = step && !last_step, falls = !step && last_step, turns = dir != last_dir;
	// Nearest steps are even where these bits are alike.
	wire parity = \dut.place [16] ^ \dut.place [15], last_parity = last_place[16] ^ last_place[15];

	always @(posedge clk) if (!rst && valid) begin
		if (rises)
			assert (before_low >= SPACE && before_dir >= SETUP && !turns);
		if (falls)
			assert (before_high >= LENGTH && !turns);
		if (turns)
			assert (!step && before_low >= HOLD);

		if (last_writes) begin
			assert (rises == (parity != last_parity));
			assert (!rises || dir == last_down);
		end else
			assert (!rises && !falls && !turns);

		assert (holding == !(armed && (mode || commanded)));
		if (last_takes)
			assert (\dut.follows == !last_holding);
		if (\dut.stage == 2 && !\dut.clearing )
			assert (\dut.maxaccel_now == (\dut.stands || !\dut.follows ? given_accel : last_accel));
		if (\dut.stage > 2)
			assert (has_looked && \dut.maxaccel_now == last_accel);

		cover (rises);
		cover (falls && position > 32'h8000_0000 && !\dut.has_turned );
	end

`ifdef COVER
	// As fast as it can be, downwards.
	always @* assume (mode && armed && &maxvel && maxaccel == 0 && velocity_cmd == 29'h1000_0000);
`endif

	// Rounds of `age` in cycles: what has happened was so long ago at least.
	wire [5:0] age_for = \dut.age == 0 ? 0 : 7 * (\dut.age - 1) + (since_round > 7 ? 7 : since_round);

	always @(posedge clk) if (!rst) begin
		assert (\dut.fresh == commanded);
		if (\dut.stage == 1 && !\dut.clearing )
			assert (\dut.accels == (\dut.stands || !\dut.follows ? given_accel : last_accel));
		if (\dut.stage == 2)
			assert (\dut.accels == \dut.maxaccel_now );
		if (has_looked && (\dut.stage == 0 || \dut.stage > 2))
			assert (\dut.accels == last_accel);
		assert (has_looked || (\dut.clearing && \dut.stage <= 2 && !\dut.writes ));
		assert (\dut.clearing || \dut.each_n1_stood == \dut.stands );
		assert (!\dut.axis && !\dut.write_axis );
		assert (\dut.stage < 7);
		assert (!\dut.writes || \dut.stage == 0);
		if (\dut.is_busy || \dut.stage != 0)
			assert (since_round >= \dut.stage );
		if (\dut.writes )
			assert (since_round >= 7);
		if (\dut.stage != 0)
			assert (\dut.is_busy );
		assert (!last_step || !valid || before_low == 0);
		if (!\dut.clearing ) begin
			assert (position == \dut.place [39:8]);
			assert (\dut.is_high == step && \dut.points_down == dir);
			assert (\dut.age > 0 && \dut.age <= 4);
			if (step)
				assert (high_for >= age_for && dir_for >= high_for && !\dut.has_turned );
			else if (\dut.has_turned )
				assert (dir_for >= age_for && low_for >= dir_for);
			else
				assert (low_for >= age_for && dir_for >= low_for);
			if (!\dut.has_turned )
				assert (dir_for >= SETUP);
		end else
			assert (!step && !dir && low_for >= dir_for);
	end
endmodule

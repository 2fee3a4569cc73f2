// SPDX-License-Identifier: BSD-3-Clause
//
// What the motion of an axis promises, for any commands, which change in any round: no speed differs from the last one by
// more than the acceleration, none is above the limit but one that slows down, and the direction changes at standstill
// alone. An axis that can stop before its target, or stands, never passes it, and is told to be there exactly where it
// stands there. One that follows nothing slows down, stands, and stays. Where the acceleration has no limit, the speed is
// in each round the limit, or all of the way that is left. The acceleration changes in a round of an axis that stands or
// follows nothing, and may come a cycle later than the other commands, as ul_stepgen has it.
//
// A round has seven cycles, as in ul_stepgen. The last part is the invariant that makes the proof hold without a bound:
// `needed` is the sum of the speeds from now on, if the axis slows down.

module ul_stepgen_ramp_properties #(
	parameter PLACE = 6,
	parameter SPEED = 3
) (
	input clk,
	input some_is_position, some_follows, some_is_down, some_is_sudden,
	input [PLACE-1:0] some_target,
	input [SPEED-1:0] some_wanted, some_limit, some_accel
);
	reg [2:0] stage = 0;
	reg clear = 1, begun = 0;
	// Commands of this round, and the acceleration of the round before.
	reg is_position, follows, is_down;
	reg [PLACE-1:0] target;
	reg [SPEED-1:0] taken_wanted, taken_limit, taken_accel, last_accel, passed_wanted, wanted, limit, accel;
	reg taken_sudden, last_sudden, is_sudden;
	// The axis.
	reg [PLACE-1:0] place, unneeded;
	reg [SPEED-1:0] speed;
	reg down, known, stands;

	wire [PLACE-1:0] next_place, next_unneeded;
	wire [PLACE-1:0] needed = ~unneeded, next_needed = ~next_unneeded;
	wire [SPEED-1:0] next_speed;
	wire next_down, next_known, next_stands, arrived;
	// The acceleration is another one only in a round of an axis that stands or follows nothing.
	wire takes_accel = !begun || next_stands || !some_follows;

	ul_stepgen_ramp dut (.*);

	always @(posedge clk) begin
		stage <= stage == 6 ? 0 : stage + 1;
		passed_wanted <= taken_wanted;
		wanted <= passed_wanted;
		limit <= taken_limit;
		accel <= taken_accel;
		is_sudden <= taken_sudden;
		if (stage == 0) begin
			begun <= 1;
			clear <= !begun;
			is_position <= some_is_position;
			follows <= some_follows;
			is_down <= some_is_down;
			target <= some_target;
			taken_wanted <= some_wanted > some_limit ? some_limit : some_wanted;
			taken_limit <= some_limit;
			if (takes_accel) begin
				taken_accel <= some_is_sudden ? 0 : some_accel == 0 ? 1 : some_accel;
				taken_sudden <= some_is_sudden;
			end
			last_accel <= taken_accel;
			last_sudden <= taken_sudden;
			place <= next_place;
			unneeded <= next_unneeded;
			speed <= next_speed;
			down <= next_down;
			known <= next_known;
			stands <= next_stands;
		end
	end

	// The way to the target in the direction of the axis, and what it goes until it stands if it slows down.
	wire signed [PLACE-1:0] ahead = down ? place - target : target - place;
	wire signed [PLACE-1:0] next_ahead = down ? next_place - target : target - next_place;
	wire signed [PLACE:0] stop = is_sudden ? 0 : {1'b0, needed} - speed;
	wire signed [PLACE:0] next_stop = is_sudden ? 0 : {1'b0, next_needed} - next_speed;
	wire [SPEED-1:0] slower = is_sudden || accel > speed ? 0 : speed - accel;
	wire [SPEED-1:0] most_wanted = is_position ? taken_limit : taken_wanted;
	wire [SPEED:0] faster = is_sudden ? taken_limit : speed + (accel > taken_limit ? taken_limit : accel);
	wire [SPEED:0] most = is_sudden ? taken_limit : speed + accel;

	always @(posedge clk) if (begun && !clear && stage == 0) begin
		assert (next_place == (down ? place - next_speed : place + next_speed));
		assert (next_stands == (next_speed == 0));
		assert (next_down == down || (speed == 0 && next_speed == 0));

		// Acceleration and speed.
		assert (next_speed >= slower);
		assert (next_speed <= most);
		assert (next_speed <= most_wanted || next_speed == slower);
		if (!follows)
			assert (next_speed == slower && next_down == down);
		if (follows && !is_position && down != is_down)
			assert (next_speed == slower && next_down == (speed == 0 ? is_down : down));
		if (follows && !is_position && down == is_down && (is_sudden || speed <= most_wanted))
			assert (next_speed == (faster < most_wanted ? faster : most_wanted));

		// The target.
		if (follows && is_position && known && ahead >= 0 && stop <= ahead) begin
			assert (next_ahead >= 0 && next_stop <= next_ahead);
			assert (next_known && next_down == down);
		end
		if (follows && is_position && known && is_sudden && ahead >= 0)
			assert (next_speed == (ahead < taken_limit ? ahead[SPEED-1:0] : taken_limit));
		if (follows && is_position && !known)
			assert (next_speed == slower);
		if (follows && is_position && speed == 0 && ahead < 0)
			assert (next_speed == 0 && next_down != down);
		if (follows && is_position && speed == 0 && ahead > 0 && taken_limit != 0)
			assert (next_speed != 0);
		assert (arrived == (follows && is_position && (speed == 0 || (known && is_sudden)) && place == target
				    && next_speed == 0));

		cover (arrived && target == 3);
		cover (next_speed == 5 && down);
	end

	integer round;
	reg [PLACE+SPEED:0] sum;

	always @* begin
		sum = last_sudden ? 0 : speed;
		for (round = 1; round < 1 << SPEED; round = round + 1)
			if (!last_sudden && round * last_accel < speed)
				sum = sum + speed - round * last_accel;
	end

	always @(posedge clk) begin
		assert (stage < 7 && (begun || clear));
		assert (begun || stage == 0);
		if (!clear) begin
			assert (stands == (speed == 0));
			assert (!stands || known);
			// The state stays for a round.
			if (stage == 1)
				assert (!known || needed == sum);
			assert (taken_accel != 0 || taken_sudden);
			assert (!known || stands || !follows || (taken_accel == last_accel && taken_sudden == last_sudden));
		end
	end
endmodule

// SPDX-License-Identifier: BSD-3-Clause
//
// What ul_schedule promises, for all words, cancels, arming and resets: a batch ends once, in its turn. It acts if it
// came whole and well formed, fitted, and met no cancel and no cycle that was not armed up to that of `commit`, nor one that
// was `finishing` up to its last word; then in the cycle of its instant, with all of its values and none of another. Else it is counted: as late only where its
// instant was too near by then, as refused only where one of the others has failed.
//
// Which batch is followed is left open (`follow`), as are the word of it that is kept (`nth`) and the shadow that is
// looked at (`shadow`), so what holds for them holds for all. That values reach their shadows is proved in two steps:
// each word that is read of a batch is the one that was sent in its place, and a second reading of the words that are
// read, by the datasheet, has for each shadow what stands there at `commit`.
//
// These are four proofs: of the queue; of the order of batches (ENDS) and of what is read and counted (READS), which
// take for granted what is proved of the queue; of the batch that is followed (FOLLOWED), which takes all of that for
// granted. With each promise stand the invariants that make it hold without a bound. The queue has 8 words here; all
// else has all bits.

// Where states are searched for, what is granted would only be more work.
`ifdef COVER
	`define GRANTED assert
`else
	`define GRANTED assume
`endif
`ifdef FOLLOWED
	`define QUEUE `GRANTED
	`define END `GRANTED
	`define READ `GRANTED
	`define BATCH assert
`elsif READS
	`define QUEUE `GRANTED
	`define READ assert
`elsif ENDS
	`define QUEUE `GRANTED
	`define END assert
`else
	`define QUEUE assert
`endif

module ul_schedule_properties (
	input clk,
	input rst,
	input [63:0] now,
	input armed,
	input finishing,
	input [31:0] entry,
	input entry_written,
	input cancel_written,
	input follow
);
	localparam DEPTH = 8;

	wire [63:0] clock, fates;
	wire [31:0] late, refused, slack, stage_data;
	wire [15:0] room, stage_index;
	wire stage_write, stage_clear, commit, empty;
	wire cancel = 0;

	ul_schedule dut (.*);

	(* hierconn *) wire [3:0] \dut.base , \dut.write_at , \dut.read_at , \dut.state ;
	(* hierconn *) wire [1:0] \dut.part ;
	(* hierconn *) wire [7:0] \dut.words_left , \dut.words , \dut.run_rest , \dut.upper ;
	(* hierconn *) wire [15:0] \dut.ended , \dut.stage_at ;
	(* hierconn *) wire [39:0] \dut.instant_not , \dut.ahead , \dut.gap_not ;
	(* hierconn *) wire [31:0] \dut.word , \dut.data ;
	(* hierconn *) wire \dut.drops , \dut.refuses , \dut.has_gap ;
	(* hierconn *) wire \dut.is_good , \dut.has_batch , \dut.is_first , \dut.is_wrong ;
	(* hierconn *) wire [31:0] \dut.queue.memory[0] , \dut.queue.memory[1] , \dut.queue.memory[2] ,
		\dut.queue.memory[3] , \dut.queue.memory[4] , \dut.queue.memory[5] , \dut.queue.memory[6] , \dut.queue.memory[7] ;

	wire [31:0] memory [0:DEPTH-1];
	assign memory[0] = \dut.queue.memory[0] ;
	assign memory[1] = \dut.queue.memory[1] ;
	assign memory[2] = \dut.queue.memory[2] ;
	assign memory[3] = \dut.queue.memory[3] ;
	assign memory[4] = \dut.queue.memory[4] ;
	assign memory[5] = \dut.queue.memory[5] ;
	assign memory[6] = \dut.queue.memory[6] ;
	assign memory[7] = \dut.queue.memory[7] ;

	localparam HEADER = 0, NUMBERED = 1, RUN = 2, VALUE = 3, INSTANT = 4, SETTLING = 5, WAITING = 6, ACTING = 7,
		DROPPING = 8;
	wire [3:0] state = \dut.state ;
	wire reads = state >= RUN;
	wire in_words = state == RUN || state == VALUE;

	wire voids = cancel_written || !armed;
	wire given = entry_written && !cancel_written;

	// The batch that comes: words to come with the instant, whether it can act, and how many end before it.
	reg coming, good, has_instant;
	reg [8:0] left;
	reg [7:0] length;
	reg [39:0] instant;
	reg [15:0] ended, turns;
	wire [3:0] used = \dut.base - \dut.read_at ;
	wire fits = entry[31:24] + 10'd2 <= DEPTH - used;
	wire last = coming && given && left == 1;
	wire accepted = last && good && armed && !finishing;
	wire has_come = last || (coming && cancel_written);
	wire ends = commit || \dut.drops || \dut.refuses ;
	wire [7:0] arrived = has_instant ? length - left : 0;

	// The batch that is followed; `turn` of those before it have not ended.
	reg followed = 0, open, whole, fitted, voided;
	reg [15:0] number, turn;
	reg [31:0] head, low;
	reg [3:0] place;
	wire [7:0] count = head[31:24];
	wire [39:0] at = {head[7:0], low};
	(* anyconst *) reg [7:0] nth;
	reg [31:0] sent;

	// The batch that is read, word by word.
	wire [31:0] word = \dut.word ;
	wire takes = in_words && !voids && !rst;
	reg [7:0] length_read, taken;
	reg [15:0] run_left, run_at;
	reg malformed;
	wire [7:0] behind = length_read - taken - 1;

	// The shadow: what is to stand in it, and what does.
	(* anyconst *) reg [15:0] shadow;
	reg is_meant, pending;
	reg [31:0] meant, held;

	// The cycle before.
	reg begun = 0, was_reset, was_void, was_finishing, did_commit, did_end;
	reg [63:0] was_now, was_fates;
	reg [31:0] was_late, was_refused;
	reg [3:0] was_used;
	wire [15:0] finished = fates[15:0];
	wire its_end = followed && did_end && was_fates[15:0] == number;

	// The least time from a whole batch to its instant.
	reg gap_known;
	reg signed [39:0] gap;
	reg signed [31:0] least;

	always @(posedge clk) begin
		begun <= 1;
		assume (begun || rst);
		{was_reset, was_void, was_finishing, did_commit, did_end} <= {rst, voids, finishing, commit, ends};
		{was_now, was_fates, was_late, was_refused, was_used} <= {now, fates, late, refused, used};
		// A reset begins the time again, from anywhere.
		if (begun && !was_reset)
			assume (now == was_now + 1);
		// A writer keeps fewer batches under way than have numbers.
		if (begun)
			assume (turns < 16'hfffe);

		if (given) begin
			coming <= !last;
			left <= coming ? left - 1 : entry[31:24] + 1;
			has_instant <= coming;
			if (!coming) begin
				length <= entry[31:24];
				instant[39:32] <= entry[7:0];
				good <= fits && armed && !finishing && entry[31:24] != 0 && entry[23:8] == 0;
			end else if (!has_instant)
				instant[31:0] <= entry;
		end
		if (!armed || finishing)
			good <= 0;
		ended <= ended + has_come;
		turns <= turns + has_come - ends;
		if (cancel_written)
			coming <= 0;

		if (given && !coming && follow && !followed) begin
			{followed, open, whole, voided} <= {3'b110, !armed || finishing};
			fitted <= fits;
			{number, turn} <= {ended, turns - ends};
			head <= entry;
			place <= \dut.base ;
		end else if (followed) begin
			if (open && given) begin
				if (!has_instant)
					low <= entry;
				else if (arrived == nth)
					sent <= entry;
				{open, whole} <= {!last, last};
			end
			if (cancel_written)
				open <= 0;
			voided <= voided || voids || (open && finishing);
			followed <= !its_end;
			turn <= turn - ends;
		end

		if (state == NUMBERED) begin
			length_read <= \dut.words ;
			{taken, run_left, malformed, is_meant} <= 0;
		end
		if (takes) begin
			taken <= taken + 1;
			if (run_left == 0) begin
				{run_left, run_at} <= word;
				malformed <= malformed || word[31:16] == 0 || word[31:16] > behind;
			end else begin
				{run_left, run_at} <= {run_left - 16'd1, run_at + 16'd1};
				if (run_at == shadow)
					{is_meant, meant} <= {1'b1, word};
			end
		end

		if (stage_write && stage_index == shadow)
			{pending, held} <= {1'b1, stage_data};
		if (commit || stage_clear || !armed)
			pending <= 0;

		gap <= instant - now[39:0];
		gap_known <= accepted && !cancel_written;
		if (gap_known && gap < least)
			least <= gap < -40'sd2147483648 ? -32'sd2147483648 : gap[31:0];
		if (cancel_written)
			{least, gap_known} <= {32'h7fffffff, 1'b0};

		if (rst) begin
			{coming, ended, turns, followed, pending, gap_known} <= 0;
			least <= 32'h7fffffff;
		end
	end

	// What the queue has.

	// Where the batch that is read ends, and the two behind it: a queue of 8 words has no more.
	wire [3:0] first = !reads ? \dut.read_at : \dut.read_at + (in_words ? \dut.words : 0) + 1;
	wire [31:0] first_head = memory[first[2:0]];
	wire [3:0] second = first + first_head[31:24] + 2;
	wire [31:0] second_head = memory[second[2:0]];
	wire [3:0] third = second + second_head[31:24] + 2;
	wire [3:0] first_from = first - \dut.read_at , second_from = second - \dut.read_at ;
	wire has_first = first != \dut.base , has_second = has_first && second != \dut.base ;

	always @(posedge clk) if (begun) begin
		`QUEUE (clock == now);
		`QUEUE (!commit || (!rst && !voids && !stage_write && !stage_clear));
		`QUEUE (!was_reset || (!commit && !stage_write));
		`QUEUE (room == (was_reset ? DEPTH : DEPTH - was_used));
		`QUEUE (used <= DEPTH);
		`QUEUE (empty == (used == 0));
		`QUEUE (!commit || !empty);

		`QUEUE (\dut.ended == ended);
		`QUEUE (\dut.part == (!coming ? 0 : !has_instant ? 1 : 2));
		if (coming) begin
			`QUEUE (\dut.is_good == good);
			`QUEUE (\dut.words_left == (has_instant ? left : left - 1));
			`QUEUE (\dut.instant_not [39:32] == ~instant[39:32]);
			`QUEUE (has_instant ? left != 0 && left <= length : left == length + 1);
			`QUEUE (!has_instant || \dut.instant_not [31:0] == ~instant[31:0]);
			if (good) begin
				`QUEUE (length != 0 && used + length + 2 <= DEPTH);
				`QUEUE (\dut.write_at == \dut.base + 4'd1 + arrived[3:0]);
				`QUEUE (memory[\dut.base [2:0]] == {length, ended, instant[39:32]});
			end
		end else
			`QUEUE (\dut.write_at == \dut.base );

		// Whole batches, one behind another.
		if (has_first)
			`QUEUE (first_head[31:24] != 0 && first_head[31:24] + first_from + 2 <= used);
		if (has_second) begin
			`QUEUE (second_head[31:24] != 0 && second_head[31:24] + second_from + 2 <= used);
			`QUEUE (third == \dut.base );
		end

		// The batch that is read.
		`QUEUE (state <= DROPPING);
		`QUEUE (!reads || (used != 0 && !was_void && !stage_clear));
		`QUEUE (!in_words || (\dut.words != 0 && \dut.words < used));
		`QUEUE (!stage_write || in_words || state == INSTANT);
		if (used != 0 || (coming && good && has_instant))
			`QUEUE (word == memory[\dut.read_at [2:0]]);
		if (state == NUMBERED && \dut.has_batch )
			`QUEUE (used != 0 && !stage_clear && \dut.data == word && !\dut.is_wrong &&
				{\dut.words , \dut.upper } == {word[31:24], word[7:0]});
	end

`ifdef END
	// How batches end.

	// For each header in the queue, the batches before it that have not ended.
	reg [15:0] turn_at [0:DEPTH-1];
	wire [15:0] first_turn = turn_at[first[2:0]], second_turn = turn_at[second[2:0]];
	integer i;
	always @(posedge clk)
		for (i = 0; i < DEPTH; i = i + 1)
			turn_at[i] <= (given && !coming && fits && i == \dut.base [2:0] ? turns : turn_at[i]) - ends;

	always @(posedge clk) if (begun) begin
		// Each of a batch that has come, in the order of their numbers.
		`END (!ends || turns != 0);
		`END (ended == finished + turns);
		`END (!reads || turns != 0);
		if (coming && good)
			`END (turn_at[\dut.base [2:0]] == turns);
		if (has_first) begin
			`END (first_head[23:8] == finished + first_turn);
			`END (first_turn < turns && (!reads || first_turn != 0));
		end
		if (has_second) begin
			`END (second_head[23:8] == finished + second_turn);
			`END (first_turn < second_turn && second_turn < turns);
		end
		if (state == NUMBERED && !\dut.has_batch )
			`END (turns != 0 && (!has_first || first_turn != 0));
	end
`endif

`ifdef READ
	// What is counted, what is read, and what the shadow has of it.

	// What will be found to be malformed, and the word that is on its way to the shadow.
	wire is_odd = \dut.is_wrong || (state == VALUE && (\dut.run_rest == 0 || \dut.run_rest > \dut.words ||
		(\dut.is_first && \dut.data [31:24] != 0)));
	wire arrives = stage_write && stage_index == shadow;

	always @(posedge clk) if (begun) begin
		// Batches end singly; a commit is an end, and all others are counted, once.
		if (was_reset)
			`READ (fates == 0 && late == 0 && refused == 0);
		else begin
			`READ (finished == was_fates[15:0] + {15'b0, did_end});
			`READ (fates[63:16] == (did_end ? {was_fates[62:16], !did_commit} : was_fates[63:16]));
			`READ (!did_commit || did_end);
			`READ (late == was_late + (did_end && !did_commit && refused == was_refused));
			`READ (refused == was_refused + (did_end && !did_commit && late == was_late));
		end
		`READ ($signed(slack) == least);
		`READ (gap_known == \dut.has_gap );
		`READ (!gap_known || \dut.gap_not == ~gap);

		// All words were read, and the shadow has what they say: a value, or none.
		if (commit) begin
			`READ (!malformed && run_left == 0 && taken == length_read);
			`READ (pending == is_meant && (!pending || held == meant));
		end

		// It is empty where a batch begins.
		if (!reads)
			`READ (!stage_write && (!pending || stage_clear));
		else begin
			`READ (length_read == taken + (in_words ? \dut.words : 0));
			`READ (malformed == is_odd);
			if (!malformed) begin
				`READ ((state == VALUE) == (run_left != 0));
				if (state == VALUE)
					`READ (\dut.run_rest == run_left && \dut.stage_at + !\dut.is_first == run_at);
				`READ ((pending || arrives) == is_meant && (!is_meant || (arrives ? stage_data : held) == meant));
			end
			`READ (state < SETTLING || state == DROPPING || !malformed);
		end
	end
`endif

`ifdef BATCH
	// The batch that is followed.

	wire is_sound = whole && fitted && !voided && count != 0 && head[23:8] == 0;
	wire is_read = followed && reads && turn == 0;
	wire waits = is_sound && !is_read;
	// To the instant, as this cycle counts, and as it was when it was found to be too near, one or two cycles ago.
	wire [39:0] from_now = at - now[39:0];
	wire signed [39:0] left_now = from_now + 1, left_then = from_now + 2;

	always @(posedge clk) if (begun) begin
		// It acts in the cycle of its instant, or is ended for a reason.
		if (followed && commit && turn == 0)
			`BATCH (is_read && from_now == 1);
		if (its_end && !was_reset) begin
			`BATCH (!open);
			if (did_commit)
				`BATCH (is_sound || was_void);
			else if (late != was_late)
				`BATCH (is_sound && !malformed && left_then < 2);
			else
				`BATCH (!is_sound || malformed);
		end
		// Its words are read as they were sent.
		if (is_read) begin
			`BATCH (is_sound && length_read == count);
			if (takes && taken == nth)
				`BATCH (word == sent);
		end
		cover (its_end && did_commit && nth == 1 && sent == 5 && count == 2);
		cover (its_end && late != was_late);
		cover (its_end && did_commit && was_finishing);
		cover (is_read && state == ACTING && cancel_written);
		cover (is_read && state == ACTING && !armed);

		// Nowhere else, and where it is all of its words are there.
		if (followed && !its_end) begin
			`BATCH (number == finished + turn);
			`BATCH (open ? coming && turn == turns : turn < turns);
			`BATCH (!open || (!whole && number == ended && length == count));
			`BATCH (open || whole || voided);
			if (open) begin
				`BATCH (good == (fitted && !voided && count != 0 && head[23:8] == 0));
				`BATCH (instant[39:32] == head[7:0] && (!has_instant || instant[31:0] == low));
			end
			if (!is_sound)
				`BATCH (!(has_first && first_turn == turn) && !(has_second && second_turn == turn));
			if (waits)
				`BATCH ((has_first && first == place) || (has_second && second == place));
			if (waits || (open && good)) begin
				`BATCH (!open || place == \dut.base );
				`BATCH (memory[place[2:0]] == {count, number, head[7:0]} && turn_at[place[2:0]] == turn);
				if (nth < (open ? arrived : count))
					`BATCH (memory[place[2:0] + 3'd1 + nth[2:0]] == sent);
				if (!open || has_instant)
					`BATCH (memory[place[2:0] + 3'd1 + count[2:0]] == low);
			end
			if (is_read) begin
				`BATCH (\dut.upper == head[7:0]);
				if (in_words && nth >= taken && nth < count)
					`BATCH (memory[\dut.read_at [2:0] - taken[2:0] + nth[2:0]] == sent);
				`BATCH (memory[first[2:0] - 3'd1] == low);
				`BATCH (state != SETTLING || \dut.data == low);
				`BATCH (state != WAITING || (\dut.data == low && \dut.ahead == from_now));
				`BATCH (state != ACTING || from_now == 1);
				`BATCH (state != DROPPING || malformed || left_now < 2);
			end
		end
	end
`elsif READ
	always @(posedge clk) if (begun) begin
		cover (commit && pending);
		cover (state == DROPPING && \dut.is_wrong );
		cover (late == 1 && now[39:0] == 0);
		cover (refused == 1 && !was_void);
		cover (slack == 0);
	end
`elsif END
	always @(posedge clk) if (begun) begin
		cover (commit && turns == 2 && has_first);
	end
`else
	always @(posedge clk) if (begun) begin
		cover (has_second && state == WAITING);
		cover (commit && room == 0);
	end
`endif
endmodule

// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of decoder and executor together ("Exactly once, in order" in docs/protocol.md), for all received bytes,
// including damage and resets, and for any behaviour of bus, groups, response ring and frame writer. A request with an
// ID is executed only in a session, and only if its ID is the expected one, which then increases by one; so no ID is
// executed again before all others were. One request executes at a time, with no more accesses than it requests, each
// at its address. Neither a damaged frame nor a request that a program's session excludes executes anything. A
// repetition accesses the bus only to read again. Each frame has exactly the answer that it should have, with the
// numbers after it, within a bounded number of cycles.
//
// The values read from the memories of outcomes and of kept words are arbitrary. The properties state the values
// written to them and their addresses, and that the answer to a repetition is the value read from its own address.
//
// The expected meaning of a frame is computed here from its characters and their positions, independently of the
// decoder. IDs have two digits, words eight bits and addresses four; a block has at most two words, and there is one
// group of two. The contents of the request memory are arbitrary, so these properties do not cover the words of blocks.

module at_most_once_properties (
	input clk
`ifndef COVER
	, input rst,
	input [7:0] in_data,
	input in_valid,
	input in_last,
	input in_plain,
	input [3:0] in_error,
	input in_silent,
	input [7:0] memory_word,
	input [1:0] ring_room,
	input access_granted,
	input access_done,
	input access_last,
	input [3:0] access_failure,
	input [7:0] access_read_data,
	input group_is_set,
	input group_done,
	input answer_taken,
	input [7:0] in_residue,
	input no_session,
	input tail_taken
`endif
);
	localparam R = 0, RM = 1, RQ = 2, WK = 3, W = 4, WM = 5, WQ = 6, WS = 7;
	localparam GS = 8, GN = 9, GX = 10, GP = 11, I = 12, H = 13, Q = 14, K = 15;
	localparam SET = 0, START = 1, STOP_GROUP = 2, PUBLISH = 3, STOP_ALL = 4, NOTHING = 5;
	localparam MESSAGE_ERROR = 16, OUT_OF_SEQUENCE = 17;
	localparam COMMAND = 2, MALFORMED = 3, RANGE = 6, BUS = 4, NO_SESSION = 10, SHUT_OUT = 11;
	localparam SILENCE = 0, NORMAL = 1, ERROR = 2, GAP = 3;
	localparam IDLE = 0, ROOM = 1, LOAD = 2, ACCESS = 3, STOP = 4, COPY = 5, GROUP = 6, ANSWER = 7, TAIL = 8, LOOK = 9;
	localparam IN_COMMAND = 0, IN_ID = 1, IN_ADDRESS = 2, IN_COUNT = 3, IN_WORDS = 4, IN_GROUP = 5, IN_FLAGS = 6,
		IN_DIVISOR = 7, IN_LIST_COUNT = 8, IN_LIST = 9, IN_SESSION = 10, IN_NONE = 11;
	localparam BLOCK_WORDS = 2, GROUP_WORDS = 2;
	// More digits than any request has: the digit counter then alternates between this number and the next.
	localparam MANY = 900;

	wire in_ready;
	wire request_valid, request_accept, hold, request_has_id, request_plain, request_silent, request_out_of_range;
	wire [3:0] request_command, request_error;
	wire [7:0] request_id, request_count, request_group, request_word;
	wire [3:0] request_address;
	wire [5:0] request_flags;
	wire hold_letters, request_asks, number_shift, in_session, for_program, access_kept, drop_samples, tail;
	wire [15:0] request_number;
	wire [7:0] session, kept_word;
	wire [2:0] tail_more, tail_left;
	wire [3:0] tail_digit;
	// Frames without a session take no part in the current session.
	wire takes_ids = in_session && !no_session;
	wire store, busy;
	wire [7:0] store_index, store_word, memory_index;
	wire ring_write, ring_commit, ring_rollback;
	wire access_request, access_write, access_more, access_exclusive;
	wire [3:0] access_address;
	wire [7:0] access_data;
	wire group_request;
	wire [2:0] group_operation;
	wire list_write;
	wire [7:0] list_index;
	wire epoch;
	wire answer_valid, answer_lower, answer_plain, answer_has_id, answer_has_address, answer_has_pair;
	wire [4:0] answer_message;
	wire [1:0] answer_mark;
	wire [7:0] answer_id, answer_pair, answer_words;

`ifdef COVER
	// The properties are proved for any input. The cover statements use this fixed input, because a search for them takes
	// too long: a frame ends at `.`, and a damaged one at `!`; all ready inputs are '1'.
	localparam LENGTH = 17;
	localparam [8 * LENGTH - 1:0] EXECUTED = "K0001.w00A01.h00.", LOST = {"K0001.h02.w!", 40'b0};
	(* anyconst *) reg loses;
	reg [4:0] told = 0;
	reg on = 0, accessing = 0;
	wire [8 * LENGTH - 1:0] story = (loses ? LOST : EXECUTED) << {told, 3'b0};
	wire rst = !on;
	wire [7:0] in_data = story[8 * LENGTH - 1 -: 8];
	wire in_valid = on && in_data != 0;
	wire in_plain = 0, in_silent = 0, in_last = in_data == "." || in_data == "!";
	wire [3:0] in_error = in_data == "!";
	wire [7:0] memory_word = 0, access_read_data = 0;
	wire [1:0] ring_room = 3;
	wire access_granted = access_request && !accessing, access_done = accessing;
	wire access_last = 1;
	wire [3:0] access_failure = 0;
	wire group_is_set = 1, group_done = 1, answer_taken = 1, no_session = 0, tail_taken = tail;
	wire [7:0] in_residue = 0;

	always @(posedge clk) begin
		on <= 1;
		accessing <= on && access_granted;
		if (in_valid && in_ready)
			told <= told + 1;
	end
`endif

	ul_request_decoder decoder (.*, .in_session(takes_ids));
	ul_request_executor executor (.*);

	// Records begin with their first field, at the lowest bit.
	(* hierconn *) wire [114:0] \decoder.r ;
	wire [4:0] d_node = \decoder.r [4:0];
	wire d_has_id = \decoder.r [5], d_lower = \decoder.r [6], d_upper = \decoder.r [7];
	wire [3:0] d_field = \decoder.r [11:8], d_left = \decoder.r [15:12];
	wire d_bad = \decoder.r [16];
	wire [7:0] d_id = \decoder.r [24:17];
	wire [3:0] d_address = \decoder.r [28:25];
	wire [7:0] d_count = \decoder.r [36:29], d_group = \decoder.r [44:37], d_flags = \decoder.r [52:45];
	wire [15:0] d_number = \decoder.r [68:53];
	wire d_some_number = \decoder.r [69];
	wire [7:0] d_word = \decoder.r [77:70];
	wire [8:0] d_words = \decoder.r [86:78];
	wire d_partial = \decoder.r [87], d_exceeds = \decoder.r [88], d_flushed = \decoder.r [98];

	(* hierconn *) wire [96:0] \executor.r ;
	wire [3:0] e_state = \executor.r [3:0];
	wire e_live = \executor.r [4], e_programs = \executor.r [5];
	wire [7:0] e_expected = \executor.r [21:14];
	wire e_gap_told = \executor.r [22];
	wire [7:0] e_failures = \executor.r [30:23];
	wire [1:0] e_mode = \executor.r [32:31];
	wire e_is_same = \executor.r [33], e_is_expected = \executor.r [34], e_is_ahead = \executor.r [35];
	wire [3:0] e_command = \executor.r [39:36];
	wire e_has_id = \executor.r [40], e_plain = \executor.r [41], e_silent = \executor.r [42];
	wire [7:0] e_id = \executor.r [50:43];
	wire e_asks = \executor.r [51], e_counted = \executor.r [52], e_replays = \executor.r [55];
	wire [1:0] e_fate = \executor.r [54:53];
	wire [3:0] e_address = \executor.r [59:56];
	wire [7:0] e_left = \executor.r [67:60], e_index = \executor.r [75:68];
	wire e_enough_room = \executor.r [76], e_access_request = \executor.r [77], e_modifying = \executor.r [78];
	wire [3:0] e_error = \executor.r [95:92];
	wire e_out_of_order = \executor.r [96];

	// Write ports of the memories.
	(* hierconn *) wire \executor.fate_write , \executor.with_kept_keep ;
	(* hierconn *) wire [1:0] \executor.new_fate ;
	(* hierconn *) wire [7:0] \executor.with_kept_place ;

	// The command of these letters, and whether they name one.
	function [4:0] meaning(input [1:0] letters, input [4:0] first, input [4:0] second);
		case ({letters, first, letters == 1 ? 5'd0 : second})
			{2'd1, 5'd18, 5'd0}: meaning = 16 + R;
			{2'd1, 5'd23, 5'd0}: meaning = 16 + W;
			{2'd1, 5'd9, 5'd0}: meaning = 16 + I;
			{2'd1, 5'd8, 5'd0}: meaning = 16 + H;
			{2'd1, 5'd17, 5'd0}: meaning = 16 + Q;
			{2'd1, 5'd11, 5'd0}: meaning = 16 + K;
			{2'd2, 5'd18, 5'd13}: meaning = 16 + RM;
			{2'd2, 5'd18, 5'd17}: meaning = 16 + RQ;
			{2'd2, 5'd23, 5'd11}: meaning = 16 + WK;
			{2'd2, 5'd23, 5'd13}: meaning = 16 + WM;
			{2'd2, 5'd23, 5'd17}: meaning = 16 + WQ;
			{2'd2, 5'd23, 5'd19}: meaning = 16 + WS;
			{2'd2, 5'd7, 5'd19}: meaning = 16 + GS;
			{2'd2, 5'd7, 5'd14}: meaning = 16 + GN;
			{2'd2, 5'd7, 5'd24}: meaning = 16 + GX;
			{2'd2, 5'd7, 5'd16}: meaning = 16 + GP;
			default: meaning = 0;
		endcase
	endfunction

	// The frame being received, and after its end (`ended`) the result of its checks.
	reg begun = 0;
	reg [1:0] letters;
	reg [4:0] first, second;
	reg lower, upper, named, fields, wrong;
	reg [9:0] digits;
	reg [7:0] id, count, group, flags, word, label, residue;
	// The residue has replaced the number of the frame.
	reg has_residue;
	reg [3:0] address;
	reg [15:0] divisor;
	reg ended, plain, silent, in_range;
	reg [3:0] error;
	reg [7:0] words;

	wire known;
	wire [3:0] kind;
	assign {known, kind} = meaning(letters, first, second);
	wire numbered = named || kind == K;
	wire [9:0] place = digits - (numbered ? 2 : 0);
	wire past_id = !numbered || digits >= 2;
	wire is_write = kind[3:2] == 1 || kind == WK;
	wire is_about_group = kind[3:2] == 2;
	wire is_count = kind == RM || kind == RQ;

	wire is_letter = !fields && (in_data >= "G" && in_data <= "Z" || in_data >= "g" && in_data <= "z");
	wire is_digit = in_data >= "0" && in_data <= "9" || in_data >= "A" && in_data <= "F"
		|| in_data >= "a" && in_data <= "f";
	wire [3:0] nibble = in_data[6] ? in_data[3:0] + 9 : in_data[3:0];

	wire is_short = in_plain && !named && (kind == W || kind == WS) && place == 2;
	wire asks = !fields;
	wire well_formed = !wrong && (kind == K && asks || past_id) && (
		kind == K && asks ? 1 :
		kind == R ? place == 1 :
		is_count ? place == 3 :
		kind == WK ? place == 5 :
		kind == W || kind == WS ? place == 3 || is_short :
		kind == WM || kind == WQ ? place >= 3 && place[0] && place <= 511 :
		kind == GS ? place >= 10 && place - 10 == count :
		is_about_group || kind == I ? place == 2 :
		kind == K ? place == 2 :
		place == 0);
	wire [9:0] word_count = (place - 1) >> 1;
	wire all_in_range =
		is_count ? count != 0 && count <= BLOCK_WORDS :
		kind == WM || kind == WQ ? word_count <= BLOCK_WORDS :
		kind == K ? asks || label != 0 && label < 128 :
		kind == GS ? group == 0 && flags < 64 && !(flags[5] && programs) && divisor != 0 && count != 0 && count <= GROUP_WORDS :
		is_about_group ? group == 0 :
		kind != I || group <= 2;

	// The session, and its decision on a request.
	reg live, programs, gap_told;
	reg [7:0] current, expected, failures;
	reg [1:0] mode;
	wire [7:0] distance = id - expected;
	wire judged = request_valid && request_accept;
	wire damaged = error != 0;
	wire begins = kind == K && !asks;
	wire looks = kind == R || kind == RM || kind == H || kind == Q || kind == K;
	wire nobody = silent && (damaged || named || kind != WS || (programs && plain));
	wire shut_out = !damaged && ((programs && named && plain && !no_session) || (programs && !named && !silent && !looks)
		|| (live && begins && label[6:0] == current[6:0] && !no_session));
	wire without = !damaged && !shut_out && ((named && !live) || (no_session && (named || begins)));
	wire orderly = !nobody && !damaged && named && live && !no_session && !(programs && plain);
	wire next = orderly && distance == 0;
	wire ahead = orderly && distance != 0 && distance < 128;
	wire again = orderly && distance >= 128;
	wire admitted = !nobody && !damaged && !shut_out && !without && (!named || next);
	wire needs_set = kind == GN || kind == GX || kind == GP;
	wire runs = admitted && in_range && (!needs_set || group_is_set);
	wire [1:0] owed =
		nobody || again ? SILENCE :
		damaged || shut_out || without || (admitted && !runs) ? ERROR :
		ahead ? (gap_told ? SILENCE : GAP) :
		kind == WS ? SILENCE : NORMAL;

	// The request that is being executed or answered.
	reg c_damaged, c_named, c_plain, c_silent, c_runs, c_fresh, c_again, c_asks, c_open;
	reg [3:0] c_kind, c_error, c_address;
	reg [7:0] c_id, c_count, c_group, c_word, c_label, c_residue;
	reg [1:0] c_owed;
	reg [7:0] grants, dones, reads, listed, own;
	reg failed, settled;
	// A request was decided on in the cycle before, and its execution or answer begins.
	reg judged_before, starts_before, held;
	wire c_replays = c_again && (c_kind == RQ || c_kind == WK);
	wire c_opens = c_kind == K && !c_asks;
	wire [7:0] needed = c_kind == WK && !c_replays ? 2 : c_count;
	wire about_groups = c_kind[3:2] == 2 || c_opens;
	wire has_tail = (c_owed == ERROR && c_error == NO_SESSION && c_named)
		|| (c_owed == NORMAL && (c_kind == K || (c_kind == H && c_named)));
	wire opening = hold && c_opens && c_owed == NORMAL && !c_damaged;
	wire ends = tail && tail_taken && tail_left == 0;
	wire [1:0] c_fate = c_owed != ERROR ? 0 : c_error - BUS + 1;
	// Outcome written for the request in the cycle before.
	reg fate_written;
	reg [1:0] written_fate;
	reg outside_before;
	// Number of digits after the one being sent.
	reg [2:0] digits_left;
	assign tail_left = digits_left;

	wire outstanding = grants != dones;
	reg room_short;
	wire waits = ((access_request || outstanding) && !access_done) || (group_request && !group_done)
		|| (answer_valid && !answer_taken) || (e_state == ROOM && room_short) || tail;

	// One arbitrary ID: whether it was executed in this session, and how many others were executed since.
	(* anyconst *) reg [7:0] watched;
	reg seen;
	reg [8:0] others;

	// While the stream is stalled, its values are stable.
	reg offered, late, was_last, was_plain, was_silent;
	reg [3:0] was_error;
	reg [7:0] was_data;

	always @(posedge clk) begin
		begun <= 1;
		assume (begun || rst);

		// A frame's end and its characters are stable until accepted.
		offered <= in_valid && !in_ready;
		{was_data, was_last, was_plain, was_silent, was_error} <= {in_data, in_last, in_plain, in_silent, in_error};
		if (begun && offered)
			assume (in_valid && {in_data, in_last, in_plain, in_silent, in_error}
				== {was_data, was_last, was_plain, was_silent, was_error});
		// The frame writer reads digits only after an answer, and knows their number.
		assume (!tail_taken || tail);
		digits_left <= tail ? digits_left - tail_taken : tail_more;
		// no_session is stable as long as the frame.
		outside_before <= no_session;
		assume (!begun || !ended || no_session == outside_before);

		late <= in_valid && !in_ready && !ended && !hold;

		// Guarantees of ul_bus_master.
		if (begun) begin
			assume (!access_granted || (access_request && grants - dones <= (c_kind == RM ? 3 : 0)));
			assume (!access_done || (outstanding && access_last == (grants - dones == 1)));
			assume (access_failure == 0 || access_failure == BUS || access_failure == BUS + 1);
		end

		if (in_valid && in_ready && !in_last) begin
			if (is_letter) begin
				letters <= letters == 3 ? 3 : letters + 1;
				if (letters == 0)
					first <= in_data[4:0];
				if (letters == 1)
					second <= in_data[4:0];
				named <= in_data[5];
				lower <= lower || in_data[5];
				upper <= upper || !in_data[5];
			end else begin
				fields <= 1;
				if (!is_digit)
					wrong <= 1;
			end
			if (is_digit) begin
				digits <= digits == MANY + 1 ? MANY : digits + 1;
				if (!past_id)
					id <= {id[3:0], nibble};
				else if (kind == K)
					label <= {label[3:0], nibble};
				else if (!kind[3]) begin
					if (place == 0)
						address <= nibble;
					if (is_count && (place == 1 || place == 2))
						count <= {count[3:0], nibble};
					if (is_write && place >= 1)
						word <= place[0] ? nibble : {word[3:0], nibble};
				end else begin
					if (place < 2)
						group <= {group[3:0], nibble};
					else if (place < 4)
						flags <= {flags[3:0], nibble};
					else if (place < 8)
						divisor <= {divisor[11:0], nibble};
					else if (place < 10)
						count <= {count[3:0], nibble};
				end
			end
		end
		if (in_valid && in_ready && in_last) begin
			ended <= 1;
			has_residue <= named && !takes_ids;
			residue <= in_plain ? 0 : in_residue;
			{plain, silent, in_range} <= {in_plain, in_silent, all_in_range};
			error <= in_error != 0 ? in_error :
				!known || (lower && upper) || (named && (kind == Q || kind == K)) ? COMMAND :
				!well_formed ? MALFORMED : 0;
			words <= kind == R || kind == WK ? 1 : is_count || kind == GS ? count : is_short ? 1 : word_count;
		end
		if (rst || judged) begin
			{ended, has_residue, letters, lower, upper, named, fields, wrong} <= 0;
			digits <= 0;
		end

		judged_before <= judged;
		held <= hold;
		starts_before <= judged && (owed != SILENCE || runs || again);
		{fate_written, written_fate} <= {\executor.fate_write , \executor.new_fate };
		room_short <= ring_room < request_count;
		if (judged) begin
			{c_damaged, c_named, c_plain, c_silent, c_runs} <= {damaged, named && !damaged, plain, silent, runs};
			{c_fresh, c_again, c_asks, c_open, c_owed} <= {next, again, asks, owed != SILENCE && !silent, owed};
			{c_label, c_residue} <= {label, residue};
			{c_kind, c_address, c_count, c_group, c_word} <= {kind, address, words, group, word};
			c_id <= owed == GAP ? expected : id;
			c_error <= damaged ? error : shut_out ? SHUT_OUT : without ? NO_SESSION : RANGE;
			{grants, dones, reads, listed, own, failed, settled} <= 0;
			if (next) begin
				expected <= expected + 1;
				gap_told <= 0;
			end
			if (owed == GAP)
				gap_told <= 1;
			if (runs && begins) begin
				expected <= id;
				gap_told <= 0;
				failures <= 0;
				mode <= 2;
			end
			if (runs && kind == I)
				mode <= group;
		end else begin
			grants <= grants + access_granted;
			dones <= dones + access_done;
			reads <= reads + ring_write;
			listed <= listed + list_write;
			if (group_request && group_done && group_operation != NOTHING && !(c_kind == GS && group_operation == STOP_GROUP))
				settled <= 1;
			// The outcome of a repetition is read from its own address.
			if (e_state == LOOK) begin
				c_error <= e_fate == 0 ? RANGE : e_fate + BUS - 1;
				if (e_fate != 0 || (c_kind[3:2] == 0 && !in_range))
					{c_owed, c_open} <= {2'(ERROR), 1'b1};
				else if (c_kind != WS)
					{c_owed, c_open, c_runs} <= {2'(NORMAL), 1'b1, c_kind[3:2] == 0};
			end
			if (answer_valid && answer_taken && c_fresh && c_kind == WS)
				failures <= failures + 1;
			if (ends && opening)
				{live, programs, current} <= {1'b1, !c_plain, c_label};
			if (access_done && access_failure != 0) begin
				failed <= 1;
				// The remaining accesses in flight are not reported.
				dones <= grants + access_granted;
				{c_owed, c_error} <= {2'(ERROR), access_failure};
				c_open <= !c_silent;
			end
			if (answer_valid && answer_taken)
				c_open <= 0;
			if (hold && !waits)
				own <= own + 1;
		end

		if (judged && next) begin
			if (begun && seen && id == watched)
				assert (others == 255);
			others <= id == watched ? 0 : others + 1;
			seen <= seen || id == watched;
		end
		if (judged && runs && begins)
			seen <= 0;

		if (rst) begin
			{live, programs, current, failures, label, residue, c_again, c_asks, c_label, c_residue, fate_written} <= 0;
			{gap_told, expected, judged_before, starts_before, held, seen} <= 0;
			mode <= 2;
			room_short <= 1;
			{grants, dones, c_open, offered, late} <= 0;
			{id, address, count, group, flags, divisor, word, words, first, second, others} <= 0;
			{c_damaged, c_named, c_plain, c_silent, c_runs, c_fresh, c_kind, c_error, c_address} <= 0;
			{c_id, c_count, c_group, c_word, c_owed, reads, listed, own, failed, settled} <= 0;
			{error, plain, silent, in_range} <= 0;
		end

		if (begun) begin
			// One request at a time, in the order in which their frames end; none is overtaken.
			assert (request_valid == ended);
			assert (request_accept == !hold);
			if (in_valid && in_ready && in_last)
				assert (!ended && !hold);
			if (judged_before)
				assert (hold == starts_before);

			// No accesses except those of the request, and none for a request that may not be executed.
			if (access_granted) begin
				assert (hold && c_runs && !failed && !c_kind[3] && grants < needed);
				assert (access_address == 4'(c_kind == RQ || c_kind == WQ || c_kind == WK ? c_address : c_address + grants));
				assert (access_write == (c_kind[2] || (c_kind == WK && grants == 1)));
				assert (!c_named || c_fresh || !access_write);
				assert (access_kept == c_replays);
				if (c_replays)
					assert (\executor.with_kept_place == 8'(c_id + grants));
				if (c_kind == W || c_kind == WS)
					assert (access_data == c_word);
			end
			if (list_write)
				assert (hold && c_runs && c_kind == GS && listed < c_count && list_index == listed);
			if (group_request && group_operation != NOTHING) begin
				assert (hold && c_runs && !settled && (!c_named || c_fresh));
				assert (group_operation == (c_kind == GS ? (listed == 0 ? STOP_GROUP : SET) : c_kind == GN ? START :
					c_kind == GX ? STOP_GROUP : c_kind == GP ? PUBLISH : STOP_ALL));
				assert (about_groups);
				assert (group_operation != SET || listed == c_count);
			end

			// The answer is the expected one, there is no other, and it comes before another request begins.
			if (!hold)
				assert (!c_open);
			if (answer_valid) begin
				assert (c_open && !c_silent && answer_plain == c_plain);
				assert (answer_message == (c_owed == ERROR ? MESSAGE_ERROR : c_owed == GAP ? OUT_OF_SEQUENCE : c_kind));
				assert (answer_lower == c_named);
				assert (answer_has_id == (c_named || (c_opens && c_owed == NORMAL)));
				if (answer_has_id)
					assert (answer_id == c_id);
				assert (answer_words == (c_owed == NORMAL && c_kind[3:2] == 0 ? c_count : 0));
				assert (answer_has_address == (c_owed == NORMAL && !c_named && !c_kind[3]));
				if (answer_has_address)
					assert (request_address == c_address);
				if (c_owed == ERROR)
					assert (answer_has_pair && answer_pair == c_error);
				else
					assert (answer_has_pair == (!c_named && (c_kind == RM || c_kind == RQ || c_kind == WM || c_kind == WQ
						|| c_kind[3:2] == 2 || c_kind == I)));
				if (c_owed != ERROR && answer_has_pair)
					assert (answer_pair == (c_kind[3] ? c_group : c_count));
				assert (answer_mark == (mode == 0 ? 0 : mode == 1 ? 2 : 1));
				// The request has been executed completely.
				if (c_runs && c_owed == NORMAL && !c_kind[3])
					assert (grants == needed && dones == needed && reads == answer_words);
				if (c_runs && c_owed == NORMAL && about_groups)
					assert (settled);
			end
			assert (drop_samples == (answer_valid && answer_taken && c_opens && c_owed == NORMAL));
			// After the answer: the numbers of the new and of the previous session, or of the current one; the number of failed
			// posted writes; or the CRC residue.
			assert (tail == (e_state == TAIL));
			if (tail) begin
				assert (hold && has_tail && !c_open);
				assert (tail_more == (opening ? 3 : 1) && tail_left <= tail_more);
				assert (tail_digit == 4'((c_owed == ERROR ? c_residue : c_kind == H ? failures : tail_left[1] ? c_label : current)
					>> (tail_left[0] ? 4 : 0)));
			end
			assert (in_session == live && for_program == programs);
			if (!hold)
				assert (session == current);

			// Exactly these outcomes and words are written.
			assert (\executor.fate_write == (hold && c_fresh));
			assert (!hold || !c_fresh || e_id[6:0] == c_id[6:0]);
			if (held && !hold && c_fresh)
				assert (fate_written && written_fate == c_fate);
			assert (\executor.with_kept_keep == (ring_write && c_fresh && (c_kind == RQ || c_kind == WK)));
			if (\executor.with_kept_keep )
				assert (\executor.with_kept_place == 8'(c_id + reads));

			if (held && !hold && c_runs && c_kind == WS && c_owed == SILENCE)
				assert (dones == 1);

			// Bounded time: number of cycles without a stall by another entity. At the end of the request the count is one more.
			if (hold)
				assert (own <= 3 + (c_runs && (!c_kind[3] || c_kind == GS) ? needed : 0));
			if (in_valid && !in_ready && !ended && !hold)
				assert (in_last && in_plain && !late);

			// Invariants that make the proof hold without a bound: the session,
			assert (live == e_live && programs == e_programs && (live || !programs));
			assert (expected == e_expected && gap_told == e_gap_told && mode == e_mode && failures == e_failures);
			assert (session == (!tail || tail_left != 0 || c_kind != K || c_owed != NORMAL ? current :
				{current[3:0], c_asks ? current[7:4] : c_label[7:4]}));
			if (seen)
				assert (others <= 255 && expected == 8'(watched + 1 + others) && live);
			if (ended)
				assert (e_is_expected == (d_id == expected) && e_is_ahead == !(8'(d_id - expected) >> 7));
			if (ended && !has_residue)
				assert (e_is_same == (d_number[6:0] == current[6:0]));
			if (ended && has_residue)
				assert (d_number[7:0] == residue && named && !takes_ids);
			if (ended && named && !has_residue)
				assert (takes_ids);
			assert (ended || !has_residue);
			assert (!ended || !hold);
			if (hold && known && fields && !wrong && !d_bad)
				assert (numbered && digits <= 2);

			// the frame,
			assert (d_node == (known ? {1'b0, kind} : letters == 0 ? 5'd16 : letters == 1 && first == 7 ? 5'd17 : 5'd31));
			assert (d_has_id == named && d_lower == lower && d_upper == upper && !d_exceeds);
			assert (letters == 0 || (named ? lower : upper));
			assert (letters != 0 || !named && !lower && !upper);
			assert (digits <= MANY + 1 && (digits == 0 || fields) && (!wrong || fields) && (fields == wrong || digits != 0 || wrong));
			if (!fields)
				assert (d_field == IN_COMMAND && !d_bad && digits == 0 && !d_some_number);
			else
				assert (d_field != IN_COMMAND);
			if (wrong)
				assert (d_bad);
			if (known && fields && !wrong) begin
				assert (d_bad == (digits > (numbered ? 2 : 0) && place > (kind == R ? 1 : is_count ? 3 : is_write || kind == GS ? 1023 :
					is_about_group || kind == I || kind == K ? 2 : 0)));
				if (!d_bad) begin
					if (!past_id)
						assert (d_field == IN_ID && d_left == 0 && d_id[3:0] == id[3:0] && !d_some_number);
					else begin
						if (numbered)
							assert (d_id == id);
						if (kind == K) begin
							assert (d_field == (place < 2 ? IN_SESSION : IN_NONE));
							if (place < 2)
								assert (d_left == 1 - place);
							if (place == 0)
								assert (!d_some_number);
							if (place == 1)
								assert ((has_residue || d_number[3:0] == label[3:0]) && d_some_number == (label[3:0] != 0));
							if (place == 2)
								assert ((has_residue || d_number[7:0] == label) && d_some_number == (label != 0));
						end else if (!kind[3]) begin
							assert (d_field == (place == 0 ? IN_ADDRESS : is_write ? IN_WORDS : is_count && place < 3 ? IN_COUNT : IN_NONE));
							if (place == 0)
								assert (d_left == 0);
							else begin
								assert (d_address == address);
								if (is_write && !d_flushed)
									assert (d_partial == !place[0] && d_left == place[0] && (place < MANY - 4 ?
										d_words == (word_count > 256 ? 256 : word_count) : d_words == 256));
								if (is_write && place > 1)
									assert (d_word == word);
								if (kind == R || kind == WK)
									assert (d_count == 1);
								if (is_count && place == 1)
									assert (d_left == 1);
								if (is_count && place == 2)
									assert (d_left == 0 && d_count[3:0] == count[3:0]);
								if (is_count && place == 3)
									assert (d_count == count);
							end
						end else if (is_about_group || kind == I) begin
							assert (d_field == (place < 2 ? IN_GROUP : kind != GS ? IN_NONE : place < 4 ? IN_FLAGS :
								place < 8 ? IN_DIVISOR : place < 10 ? IN_LIST_COUNT : IN_LIST));
							if (place < 2)
								assert (d_left == 1 - place);
							if (place == 1)
								assert (d_group[3:0] == group[3:0]);
							if (place >= 2)
								assert (d_group == group);
							if (kind == GS) begin
								if (place >= 1 && place <= 10)
									assert (d_words == 0 && !d_partial);
								if (place == 2 || place == 3)
									assert (d_left == 3 - place);
								if (place == 3)
									assert (d_flags[3:0] == flags[3:0]);
								if (place >= 4)
									assert (d_flags == flags);
								if (place >= 4 && place < 8)
									assert (d_left == 7 - place);
								if (place == 5)
									assert ((has_residue || d_number[3:0] == divisor[3:0]) && d_some_number == (divisor[3:0] != 0));
								if (place == 6)
									assert ((has_residue || d_number[7:0] == divisor[7:0]) && d_some_number == (divisor[7:0] != 0));
								if (place == 7)
									assert ((has_residue || d_number[11:0] == divisor[11:0]) && d_some_number == (divisor[11:0] != 0));
								if (place >= 8)
									assert ((has_residue || d_number == divisor) && d_some_number == (divisor != 0));
								if (place <= 4)
									assert (!d_some_number);
								if (place == 8 || place == 9)
									assert (d_left == 9 - place);
								if (place == 9)
									assert (d_count[3:0] == count[3:0]);
								if (place >= 10)
									assert (d_count == count && !d_partial && d_left == 0 && (place < MANY - 4 ?
										d_words == (place - 10 > 256 ? 256 : place - 10) : d_words == 256));
							end
						end else
							assert (d_field == IN_NONE);
					end
				end
			end
			if (d_flushed && !ended)
				assert (!hold && offered && was_last && was_plain && late);
			if (late)
				assert (d_flushed);
			if (d_flushed && !ended && known && fields && !wrong && !d_bad && is_write && past_id && place > 0) begin
				if (!named && !lower && (kind == W || kind == WS) && place == 2)
					assert (!d_partial && d_words == 1);
				else
					assert (d_partial == !place[0] && (place < MANY - 4 ?
						d_words == (word_count > 256 ? 256 : word_count) : d_words == 256));
			end

			// the result of the checks,
			if (ended) begin
				assert (request_error == error && request_plain == plain && request_silent == silent);
				if (error == 0) begin
					assert (known && request_command == kind && request_has_id == named && !(named && (kind == Q || kind == K)));
					assert (request_out_of_range == !in_range);
					if (named || (kind == K && !asks))
						assert (request_id == id);
					if (!kind[3])
						assert (request_address == address);
					if (!kind[3] || kind == GS)
						assert (request_count == words);
					if (is_about_group || kind == I)
						assert (request_group == group);
					if (begins)
						assert (d_number[7:0] == label);
					if (kind == W || kind == WS)
						assert (request_word == word && words == 1);
					if (kind == I && in_range)
						assert (group <= 2);
					if (kind == RM || kind == RQ || kind == WM || kind == WQ || kind == GS)
						assert (!in_range || (words > 0 && words <= 2));
					if (kind == R || kind == WK)
						assert (words == 1);
				end
			end

			// and the request in progress.
			assert (e_state <= LOOK && d_field <= IN_NONE);
			assert (hold == (e_state != IDLE) && e_access_request == (e_state == ACCESS));
			assert (e_enough_room == !room_short);
			assert (!list_write || e_state == COPY);
			if (hold) begin
				assert (e_has_id == c_named && e_plain == c_plain && e_silent == c_silent);
				assert (e_counted == c_fresh && e_replays == (c_again && c_kind[1]) && e_asks == c_asks);
				assert (!c_again || (c_named && !c_fresh && !c_silent) );
				assert (!c_fresh || (c_named && !c_silent && live));
				if (opening && e_state != TAIL)
					assert (d_number[7:0] == c_label);
				if (tail && opening)
					assert (d_number[7:0] == (tail_left[0] ? c_label : {c_label[3:0], c_label[7:4]}));
				if (c_owed == ERROR && c_error == NO_SESSION && c_named)
					assert (d_number[7:0] == (!tail || tail_left == 1 ? c_residue : {c_residue[3:0], c_residue[7:4]}));
				if (c_named || (c_opens && !c_damaged))
					assert (e_id == c_id);
				assert (e_error == (c_owed == ERROR ? c_error : 0) && e_out_of_order == (c_owed == GAP));
				assert (c_open == (c_owed != SILENCE && !c_silent && e_state != TAIL));
				assert (!has_tail || !c_silent);
				assert (c_owed != ERROR || c_error != 0);
				assert (!c_damaged || (c_owed == ERROR && !c_runs && !c_named));
				assert (!c_runs || !c_named || c_fresh || (c_again && c_kind[3:2] == 0));
				assert (!c_runs || failed == (c_owed == ERROR));
				assert (c_runs || !failed);
				assert (!failed || c_error == BUS || c_error == BUS + 1);
				assert (!c_fresh || c_owed != ERROR || failed || c_error == RANGE);
				assert (c_owed != GAP || c_named);
				assert (c_owed != SILENCE || e_state == LOOK || (c_runs && c_kind == WS && e_state == ACCESS));
				if (e_state == LOOK)
					assert (c_again && !c_runs && !c_damaged && c_owed == SILENCE && own == 0 && e_index == 0 && in_range == !request_out_of_range
						&& (c_kind[3] || (e_left == c_count && e_address == c_address)) && !e_modifying);
				assert (c_kind != K || !c_named);
				if (c_runs)
					assert (c_owed == ERROR || c_owed == (c_kind == WS ? SILENCE : NORMAL));
				if (!c_damaged) begin
					assert (e_command == c_kind);
					if (!c_kind[3])
						assert (request_address == c_address);
					if (!c_kind[3] || c_kind == GS)
						assert (request_count == c_count);
					if (c_kind[3:2] == 2 || c_kind == I)
						assert (request_group == c_group);
					if (c_kind == W || c_kind == WS)
						assert (request_word == c_word);
				end
				if (e_state == LOOK && c_kind[3:2] == 0)
					assert (c_kind == R || c_kind == WK ? c_count == 1 : !in_range || (c_count > 0 && c_count <= 2));
				if (c_runs && (!c_kind[3] || c_kind == GS))
					assert (c_count > 0 && c_count <= 2);
				if (c_kind == R || c_kind == WK || c_kind == W || c_kind == WS)
					assert (c_count == 1 || !c_runs);
				if (!c_runs)
					assert (grants == 0 && dones == 0 && reads == 0 && listed == 0 && !settled
						&& (e_state == ANSWER || e_state == TAIL || e_state == LOOK || (e_state == GROUP && group_operation == NOTHING)));
				assert (grants <= 2 && (!c_runs || c_kind[3] || grants <= needed) && dones <= grants && reads <= dones && listed <= 2);
				if (e_state != ACCESS)
					assert (!outstanding);
				if (e_state == ROOM || e_state == LOAD || e_state == STOP)
					assert (c_runs && !failed && grants == 0 && reads == 0 && listed == 0 && !settled && own == c_again);
				if (e_state == ROOM || e_state == LOAD)
					assert (e_left == c_count && e_address == c_address && !e_modifying);
				if (e_state == ROOM || e_state == LOAD)
					assert (e_index == 0);
				if (e_state == ROOM)
					assert (c_kind[3:2] == 0);
				if (e_state == LOAD)
					assert (c_kind == WM || c_kind == WQ);
				if (e_state == STOP)
					assert (c_kind == GS && e_index == 0 && group_operation == STOP_GROUP);
				if (e_state == ACCESS) begin
					assert (c_runs && !failed && !c_kind[3] && own <= 1 + c_again + dones && grants - dones <= (c_kind == RM ? 4 : 1));
					assert (e_modifying == (c_kind == WK && !c_replays && dones == 1));
					assert (e_index == (c_kind == RQ ? dones : c_kind[2] ? grants : 0));
					assert (dones < needed && e_left == (c_kind == WK && !c_replays ? !(dones == 1 && grants == 2) : c_count - grants));
					assert (e_address == 4'(c_kind == RQ || c_kind == WQ || (c_kind == WK && !c_replays) ? c_address : c_address + grants));
					assert (reads == (c_kind[2] ? 0 : dones));
				end
				if (e_state == COPY)
					assert (c_runs && c_kind == GS && !failed && !settled && e_index <= c_count && listed + list_write == e_index
						&& own == 1 + e_index && grants == 0);
				if (e_state == GROUP) begin
					assert (!c_runs || (!failed && about_groups && group_operation != NOTHING));
					assert (c_runs || own == c_again);
					if (c_runs) begin
						assert (!settled && grants == 0 && group_operation == (c_kind == GS ? SET : c_kind == GN ? START :
							c_kind == GX ? STOP_GROUP : c_kind == GP ? PUBLISH : STOP_ALL));
						assert (listed == (c_kind == GS ? c_count : 0) && own == (c_kind == GS ? 2 + c_count : 0));
					end
				end
				if (e_state == ANSWER) begin
					if (c_runs && !c_kind[3])
						assert (own <= 1 + c_again + dones && dones <= needed && (failed ? dones > 0 : (dones == needed && reads == (c_kind[2] ? 0 : c_count))));
					else
						assert (own <= (c_runs && c_kind == GS ? 3 + c_count : 1 + c_again));
					if (c_runs && about_groups)
						assert (settled);
				end
				if (tail)
					assert (own <= 2 + c_again && !outstanding);
			end else
				assert (!outstanding);

			cover (answer_valid && c_fresh && c_kind == W && dones == 1);
			cover (answer_valid && c_named && !c_fresh && seen && c_id == watched && c_owed == NORMAL);
			cover (answer_valid && c_owed == GAP);
			cover (tail && opening && tail_left == 0);
			cover (answer_valid && c_damaged && live && c_error == 1 && gap_told);
		end
	end
endmodule

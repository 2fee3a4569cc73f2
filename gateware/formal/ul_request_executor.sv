// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of the executor about sessions, for any behaviour of decoder, bus and groups, and for resets. Between a
// reset and the end of the answer to the next K that begins a session, and for requests from outside of every session,
// no request with an ID begins an access, changes a group or writes its list of addresses; and each is answered by
// error 0A with its ID and its CRC residue, except that a request to all nodes is ignored.

module ul_request_executor_properties (
	input clk,
	input rst,
	input request_valid,
	input [3:0] request_command,
	input request_has_id,
	input request_plain,
	input request_silent,
	input [3:0] request_error,
	input request_out_of_range,
	input [7:0] request_id,
	input [7:0] request_address,
	input [7:0] request_count,
	input [7:0] request_group,
	input [7:0] request_word,
	input request_asks,
	input [15:0] request_number,
	input no_session,
	input [7:0] memory_word,
	input [2:0] ring_room,
	input access_granted,
	input access_done,
	input access_last,
	input [3:0] access_failure,
	input [7:0] access_read_data,
	input group_is_set,
	input group_done,
	input answer_taken,
	input [2:0] tail_left,
	input tail_taken
);
	localparam WS = 7, GS = 8, K = 15;
	localparam NOTHING = 5, MESSAGE_ERROR = 16, NO_SESSION = 10;
	localparam ACCESS = 3, COPY = 5, GROUP = 6, ANSWER = 7, TAIL = 8, LOOK = 9;
	localparam STOP_ALL = 4, CHECK_DIGITS = 2;

	wire request_accept, hold, hold_letters, number_shift, in_session, for_program, access_kept, drop_samples, tail;
	wire [7:0] session, kept_word;
	wire [2:0] tail_more;
	wire [3:0] tail_digit;
	wire [7:0] memory_index;
	wire ring_write, ring_commit, ring_rollback;
	wire access_request, access_write, access_more, access_exclusive;
	wire [7:0] access_address, access_data;
	wire group_request;
	wire [2:0] group_operation;
	wire list_write;
	wire [7:0] list_index;
	wire epoch;
	wire answer_valid, answer_lower, answer_plain, answer_has_id, answer_has_address, answer_has_pair;
	wire [4:0] answer_message;
	wire [1:0] answer_mark;
	wire [7:0] answer_id, answer_pair, answer_words;

	ul_request_executor dut (.*);

	reg begun = 0;
	// under_way: a session exists. same: the number of the request in the cycle before is that of the session. opening: a
	// K that begins a session is being answered.
	reg under_way, same, opening;
	// refused: a request that must be rejected was accepted, and is not finished. The other registers describe it.
	reg refused, answered, plain;
	// A request with an ID to all nodes was accepted in the cycle before.
	reg ignored;
	reg [3:0] command;
	reg [7:0] id;
	reg executed;

	// Records begin with their first field, at the lowest bit.
	(* hierconn *) wire [100:0] \dut.r ;
	wire [3:0] state = \dut.r [3:0];
	wire [3:0] its_command = \dut.r [39:36];

	wire taken = request_valid && request_accept;
	wire without = taken && request_has_id && request_error == 0 && (!under_way || no_session);
	wire refuse = without && !request_silent;
	wire opens = taken && request_command == K && request_error == 0 && !request_asks && !request_silent && !no_session
		&& !request_out_of_range && !(under_way && same);
	wire ends = tail && tail_taken && tail_left == 0;

	always @(posedge clk) begin
		begun <= 1;
		assume (begun || rst);
		// `k` is not a command.
		assume (request_command != K || !request_has_id || request_error != 0);

		same <= request_number[6:0] == session[6:0];
		if (opening && ends)
			under_way <= 1;
		if (taken)
			opening <= opens;
		else if (ends)
			opening <= 0;
		ignored <= without && request_silent;
		if (taken) begin
			refused <= refuse;
			answered <= 0;
			{command, plain, id} <= {request_command, request_plain, request_id};
		end
		if (answer_valid && answer_taken)
			answered <= 1;
		executed <= taken && request_has_id && under_way && !no_session;
		if (rst) begin
			under_way <= 0;
			same <= 0;
			opening <= 0;
			refused <= 0;
			ignored <= 0;
			executed <= 0;
		end

		if (begun) begin
			assert (in_session == under_way && (under_way || !for_program));
			if (refused && hold) begin
				assert (!access_request && !list_write && !drop_samples);
				assert (!group_request || group_operation == NOTHING);
				assert (!answer_valid || (answer_message == MESSAGE_ERROR && answer_pair == NO_SESSION && answer_has_pair));
				assert (!answer_valid || (answer_id == id && answer_has_id && answer_lower && answer_plain == plain));
				assert (!answer_valid || (answer_words == 0 && !answer_has_address));
				assert (!tail || (answered && tail_more == CHECK_DIGITS - 1 && tail_digit == request_number[7:4]));
			end
			if (refused && !hold)
				assert (answered);
			if (ignored)
				assert (!hold && !access_request && !group_request && !list_write && !answer_valid);

			// Invariants that make the proof hold without a bound.
			assert (under_way == \dut.r [4] && for_program == \dut.r [5] && same == \dut.r [33]);
			assert (\dut.r [81] == (state == ACCESS) && (!access_request || \dut.r [81]));
			assert (!list_write || state == COPY);
			assert (state <= LOOK && hold == (state != 0) && request_accept == !hold && tail == (state == TAIL));
			if (refused && hold) begin
				assert (state == ANSWER || state == TAIL || (state == GROUP && group_operation == NOTHING));
				assert (\dut.r [99:96] == NO_SESSION && \dut.r [50:40] == {id, 1'b0, plain, 1'b1} && !\dut.r [100]);
				assert (answered == (state == TAIL) && !opening);
			end
			// A K that is being answered.
			assert (!opening || hold);
			if (hold && its_command == K) begin
				assert (state == ANSWER || state == TAIL || state == GROUP);
				assert (!\dut.r [40] && !\dut.r [42]);
				assert (opening == (!\dut.r [51] && \dut.r [99:96] == 0) && !\dut.r [100] && (state != TAIL || \dut.r [99:96] == 0));
				if (state == GROUP)
					assert (opening && group_operation == STOP_ALL);
			end else
				assert (!opening);

			cover (refused && answer_valid && command == WS);
			cover (refused && answer_valid && command == GS && epoch);
			cover (ignored && under_way);
			cover (refused && under_way && tail);
			cover (executed && access_request);
		end
	end
endmodule

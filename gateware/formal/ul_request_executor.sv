// SPDX-License-Identifier: BSD-3-Clause
//
// What the executor promises about sessions, whatever the decoder, the bus and the groups do, resets included: between a
// reset and the next K no request with an ID begins an access, changes a group or writes its list of addresses; and each
// is answered by error 0A under its ID, unless it was sent to all nodes.

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
	input [7:0] memory_word,
	input [2:0] ring_room,
	input access_granted,
	input access_done,
	input access_last,
	input [3:0] access_failure,
	input [7:0] access_read_data,
	input group_is_set,
	input group_done,
	input answer_taken
);
	localparam WS = 7, GS = 8, K = 15;
	localparam NOTHING = 5, MESSAGE_ERROR = 16, NO_SESSION = 10;
	localparam ACCESS = 3, COPY = 5, GROUP = 6, ANSWER = 7;

	wire request_accept, hold;
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
	reg in_session;
	// A request that must be refused has been accepted, and was not done with yet; what it was.
	reg refused, answered, silent, plain;
	reg [3:0] command;
	reg [7:0] id;
	reg executed;

	// A record is laid out from its first field on, the lowest bit first.
	(* hierconn *) wire [77:0] \dut.r ;
	wire [2:0] state = \dut.r [2:0];

	wire taken = request_valid && request_accept;
	wire refuse = taken && request_has_id && request_error == 0 && !in_session;

	always @(posedge clk) begin
		begun <= 1;
		assume (begun || rst);
		// `k` is no command.
		assume (request_command != K || !request_has_id || request_error != 0);

		if (taken && request_command == K && request_error == 0 && !request_out_of_range)
			in_session <= 1;
		if (taken) begin
			refused <= refuse;
			answered <= 0;
			{command, silent, plain, id} <= {request_command, request_silent, request_plain, request_id};
		end
		if (answer_valid && answer_taken)
			answered <= 1;
		executed <= taken && request_has_id && in_session;
		if (rst) begin
			in_session <= 0;
			refused <= 0;
			executed <= 0;
		end

		if (begun) begin
			if (refused && hold) begin
				assert (!access_request && !list_write);
				assert (!group_request || group_operation == NOTHING);
				assert (!answer_valid || (answer_message == MESSAGE_ERROR && answer_pair == NO_SESSION && answer_has_pair));
				assert (!answer_valid || (answer_id == id && answer_has_id && answer_lower && answer_plain == plain));
				assert (!answer_valid || (answer_words == 0 && !answer_has_address && !silent));
			end
			if (refused && !hold)
				assert (answered || silent);

			// What makes the proof hold without a bound.
			assert (in_session == \dut.r [3]);
			assert (\dut.r [57] == (state == ACCESS) && (!access_request || \dut.r [57]));
			assert (!list_write || state == COPY);
			assert (hold == (state != 0) && request_accept == !hold);
			if (refused && hold) begin
				assert (state == ANSWER || (state == GROUP && group_operation == NOTHING));
				assert (\dut.r [76:72] == NO_SESSION && \dut.r [31:21] == {id, silent, plain, 1'b1});
				assert (!answered);
			end

			cover (refused && answer_valid && command == WS);
			cover (refused && answer_valid && command == GS && epoch);
			cover (refused && silent && hold);
			cover (executed && access_request);
		end
	end
endmodule

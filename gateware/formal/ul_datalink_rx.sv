// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of the datalink receiver for all received bytes and any readiness of its sink: an output is stable until
// it is accepted; it outputs no more characters and ends than it received; an end has an error of the datalink layer or
// none, and a CRC error only if the frame has a CRC; the residue of a good frame is 0, unless the frame begins with a
// small letter and no session exists; and the receiver never stops for longer than it takes to empty its delay line.
// (The benches test which error is reported for which frame.)
//
// Assumed: the session is stable from a frame's first letter to its end, as decoder and executor ensure.

module ul_datalink_rx_properties (
	input clk,
	input [7:0] in_data,
	input in_lost,
	input in_valid,
	input [7:0] session,
	input in_session,
	input out_ready
);
	localparam CHECK_DIGITS = 2;

	wire in_ready, out_valid, out_last, out_plain, out_silent, busy;
	wire [7:0] out_data, out_residue;
	wire [3:0] out_error;
	reg rst = 1;

	ul_datalink_rx dut (.*);

	wire take = !rst && in_valid && in_ready;
	wire give = !rst && out_valid && out_ready;
	wire is_end = in_data == 8'h0A || in_data == 8'h0D;
	reg offered = 0;
	reg [22:0] offer;
	reg [7:0] characters = 0;
	reg [2:0] ends = 0;
	reg [2:0] refused = 0;
	reg [2:0] frames = 0;
	// text: a letter was output. small: the first one is small. session_before: the session in the cycle before.
	reg text = 0, small = 0;
	reg [8:0] session_before;

	// The record of registers, its first element at the lowest bits.
	(* hierconn *) wire [53:0] \dut.r ;

	always @(posedge clk) begin
		rst <= 0;
		if (rst)
			assert (!offered && characters == 0 && ends == 0 && refused == 0 && !text);
	end

	always @(posedge clk) if (!rst) begin
		// Bounded so that they can be counted; the count restarts with each frame, because an end discards all of them.
		assume (characters < 200);
		offered <= out_valid && !give;
		offer <= {out_data, out_last, out_plain, out_error, out_silent, out_residue};
		session_before <= {session, in_session};
		assume (!text || {session, in_session} == session_before);
		if (give) begin
			text <= !out_last;
			small <= !out_last && (text ? small : out_data >= "a" && out_data <= "z");
		end
		characters <= characters + (take && !is_end) - (give && !out_last);
		if (give && out_last)
			characters <= take && !is_end;
		ends <= ends + (take && is_end) - (give && out_last);
		if (take && is_end && !(give && out_last) && ends == 2)
			ends <= 2;
		refused <= out_ready && !in_ready ? refused + 1 : 0;
		if (give && out_last && out_error == 0 && frames != 7)
			frames <= frames + 1;

		if (offered)
			assert (out_valid && {out_data, out_last, out_plain, out_error, out_silent, out_residue} == offer);
		if (out_valid && out_last) begin
			assert (out_error == 0 || out_error == 1 || out_error == 7 || out_error == 9);
			assert (!(out_plain && out_error == 1));
		end
		if (out_valid && out_last && out_error == 0 && !out_plain && (in_session || !small))
			assert (out_residue == 0);
		assert (!out_silent);
		assert (refused <= CHECK_DIGITS + 1);

		// Invariant that makes the proof hold without a bound.
		assert (\dut.r [26] == text && \dut.r [27] == small && (text || !small));

		cover (frames == 2 && give && out_last && out_plain);
		cover (frames == 1 && give && out_last && out_error == 0 && !out_plain);
		cover (give && out_last && out_error == 9);
		cover (give && out_last && out_error == 7);
		cover (give && out_last && out_error == 0 && small && !in_session && out_residue != 0);
	end
endmodule

// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of the datalink transmitter for all bodies and any readiness of its sink: an output is stable until it is
// accepted; each character of a body is output once and in order; after the last one it outputs CR LF (plain) or the
// digits of the CRC and LF; the mark of a frame is output beside its LF only. (The benches test the value of the CRC.)

module ul_datalink_tx_properties (
	input clk,
	input [7:0] in_data,
	input in_valid,
	input in_last,
	input in_plain,
	input [1:0] in_mark,
	input [7:0] session,
	input in_session,
	input no_session,
	input out_ready
);
	localparam BODY = 0, CHECK_1 = 1, CHECK_2 = 2, CR = 3, LF = 4;

	localparam STATE_BODY = 1, STATE_CHECK = 2, STATE_CR = 3, STATE_LF = 4;

	wire in_ready, out_valid, busy;
	wire [7:0] out_data;
	wire [1:0] out_mark;
	reg rst = 1;

	ul_datalink_tx dut (.*);

	wire take = !rst && in_valid && in_ready;
	wire give = !rst && out_valid && out_ready;
	reg offered = 0;
	reg [9:0] offer;
	// Part of the frame to which the next output belongs, and the character of a body that is in the output register.
	reg [2:0] part = BODY;
	reg held = 0;
	reg [7:0] character;
	reg last = 0, plain;
	reg [1:0] mark;
	reg [2:0] frames = 0;
	wire [1:0] expected_mark = part == LF ? mark : 0;
	wire is_digit = (out_data >= "0" && out_data <= "9") || (out_data >= "A" && out_data <= "F");

	// The record of registers, its first element at the lowest bits.
	(* hierconn *) wire [26:0] \dut.r ;
	wire [2:0] state = \dut.r [2:0];
	wire [1:0] left = \dut.r [4:3];
	wire [1:0] its_mark = \dut.r [15:14];

	always @(posedge clk) begin
		rst <= 0;
		if (rst)
			assert (!held && !last && part == BODY && !offered);
	end

	always @(posedge clk) if (!rst) begin
		offered <= out_valid && !give;
		offer <= {out_data, out_mark};
		if (give) begin
			case (part)
				BODY: begin
					held <= 0;
					if (last)
						part <= plain ? CR : CHECK_1;
				end
				CHECK_1: part <= CHECK_2;
				CHECK_2: part <= LF;
				CR: part <= LF;
				default: begin
					part <= BODY;
					last <= 0;
					if (frames != 7)
						frames <= frames + 1;
				end
			endcase
		end
		if (take) begin
			held <= 1;
			character <= in_data;
			last <= in_last;
			plain <= in_plain;
			mark <= in_mark;
		end

		if (offered)
			assert (out_valid && {out_data, out_mark} == offer);
		if (take)
			assert (part == BODY && !last && (!held || give) || part == LF && give);
		if (out_valid) begin
			if (part == BODY)
				assert (held && out_data == character);
			if (part == CHECK_1 || part == CHECK_2)
				assert (is_digit);
			if (part == CR)
				assert (out_data == 8'h0D);
			if (part == LF)
				assert (out_data == 8'h0A);
			assert (out_mark == expected_mark);
		end
		// Within a body, the transmitter inserts no pauses.
		assert (out_valid == (part != BODY || held));
		if (part != BODY)
			assert (last && !held && part <= LF && (part == LF || plain == (part == CR)));

		// Invariants that make the proof hold without a bound: the state of the transmitter is one character ahead.
		if (!out_valid || part == LF || part == BODY && !last)
			assert (state == STATE_BODY && part == LF == last);
		else if (part == BODY)
			assert (plain ? state == STATE_CR : state == STATE_CHECK && left == 2);
		else if (part == CHECK_1)
			assert (state == STATE_CHECK && left == 1);
		else
			assert (state == STATE_LF);
		if (last && part != LF)
			assert (its_mark == mark);

		cover (frames == 2 && part == BODY && held);
		cover (frames == 1 && part == LF && plain && mark == 2);
		cover (frames == 1 && part == LF && !plain && give && take);
	end
endmodule

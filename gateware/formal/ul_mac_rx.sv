// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of the MAC receiver for all input signals: a frame reported as good has an allowed number of bytes, all of
// which were output, and a right frame check sequence; and the receiver never locks up: if the line is idle and the
// status is accepted, it searches for the next frame within four cycles, whatever its previous state.
//
// The frame check sequence is computed here from the bytes that were output, bit by bit as in IEEE 802.3. The proof
// uses frames of 6 to 8 bytes. The second half has the invariants that make the proof hold for any number of cycles:
// the receiver's CRC is that of these bytes and of the symbol after them.

module ul_mac_rx_properties (
	input clk,
	input [3:0] data,
	input valid,
	input error,
	input out_ready
);
	localparam LANES = 4;

	wire [7:0] out_data;
	wire out_end, out_valid;
	reg rst = 1;

	ul_mac_rx dut (.*);

	localparam PASSING_OVER = 0, HUNTING = 1, INSIDE = 2, ENDING = 3;
	(* hierconn *) wire [1:0] \dut.state ;
	(* hierconn *) wire [31:0] \dut.crc ;
	(* hierconn *) wire [10:0] \dut.length ;
	(* hierconn *) wire [7:0] \dut.gathered ;
	(* hierconn *) wire \dut.place , \dut.right , \dut.bad ;

	function [31:0] one(input [31:0] crc, input d);
		one = (crc >> 1) ^ (crc[0] ^ d ? 32'hEDB88320 : 0);
	endfunction

	function [31:0] four(input [31:0] crc, input [3:0] d);
		four = one(one(one(one(crc, d[0]), d[1]), d[2]), d[3]);
	endfunction

	function [31:0] eight(input [31:0] crc, input [7:0] d);
		eight = four(four(crc, d[3:0]), d[7:4]);
	endfunction

	wire give = !rst && out_valid && out_ready;
	reg [31:0] check = 32'hFFFFFFFF;
	reg [10:0] bytes = 0;
	reg offered = 0;
	reg [8:0] offer;
	reg [2:0] silent = 0;
	reg bad_one = 0;

	always @(posedge clk) begin
		rst <= 0;
		if (rst)
			assert (!offered && bytes == 0 && check == 32'hFFFFFFFF && silent == 0);
	end

	always @(posedge clk) if (!rst) begin
		if (give && !out_end) begin
			check <= eight(check, out_data);
			bytes <= bytes + 1;
		end
		if (give && out_end) begin
			check <= 32'hFFFFFFFF;
			bytes <= 0;
			if (!out_data[0])
				bad_one <= 1;
		end
		offered <= out_valid && out_end && !out_ready;
		offer <= {out_end, out_data};
		silent <= valid || !out_ready ? 0 : silent == 4 ? 4 : silent + 1;

		if (out_valid && out_end && out_data[0]) begin
			assert (check == 32'hDEBB20E3);
			assert (bytes >= 6 && bytes <= 8);
		end
		if (offered)
			assert (out_valid && {out_end, out_data} == offer);
		assert (silent == 0 || \dut.state != INSIDE);
		assert (silent <= 1 || \dut.state != ENDING || out_end);
		assert (silent <= 2 || \dut.state != ENDING);
		if (silent == 4)
			assert (\dut.state == HUNTING && !out_valid);

		// A frame that is too long, and a good one after it.
		cover (\dut.length == 9);
		cover (give && out_end && out_data[0] && bad_one);
	end

`ifdef COVER
	// The input that reaches the cover statements.
	localparam STEPS = 57;
	localparam [4*STEPS-1:0] SYMBOLS = 228'h189996993412d55000000077777777777777777777d550000;
	localparam [STEPS-1:0] VALID = 57'h1fffc07fffff0;
	reg [6:0] step = 0;
	always @(posedge clk) begin
		step <= step + 1;
		assume (data == SYMBOLS[4*step +: 4] && valid == VALID[step] && !error && out_ready);
	end
`endif

	// Includes the byte at the output.
	wire pending = out_valid && !out_end;
	wire [31:0] check_all = pending ? eight(check, out_data) : check;
	wire [10:0] bytes_all = bytes + pending;

	always @(posedge clk) if (!rst) begin
		assert (!out_end || out_valid);
		if (\dut.state == PASSING_OVER || \dut.state == HUNTING)
			assert (!out_valid && check == 32'hFFFFFFFF && bytes == 0);
		if (\dut.state == INSIDE)
			assert (!out_end);
		if (\dut.state == INSIDE || \dut.state == ENDING)
			assert (bytes_all <= \dut.length );
		if (out_end)
			assert (\dut.state == ENDING);
		assert (\dut.length <= 9 && bytes <= 9);
		if (\dut.state == INSIDE && !\dut.bad ) begin
			assert (\dut.crc == (\dut.place ? four(check_all, \dut.gathered [7:4]) : check_all));
			assert (\dut.length == bytes_all);
			if (\dut.place )
				assert (\dut.right == (check_all == 32'hDEBB20E3));
		end
		if (\dut.state == ENDING && !out_end && !\dut.bad ) begin
			assert (!\dut.right || check_all == 32'hDEBB20E3);
			assert (\dut.length == bytes_all);
		end
	end
endmodule

// SPDX-License-Identifier: BSD-3-Clause
//
// Rules of AXI4-Lite for a master and a slave (AMBA IHI 0022, A3.2, A3.3 and B1), with at most one access in flight.
//
// The rules of one side are asserted if the proof is about that side, and assumed otherwise.

module axi4_lite_channel #(
	parameter BITS = 8,
	parameter PROVED = 1
) (
	input clk,
	input rst,
	input valid,
	input ready,
	input [BITS-1:0] payload
);
	reg first = 1, was_reset = 0, held = 0;
	reg [BITS-1:0] offered;

	// A valid transfer stays valid and unchanged until it is accepted; after a reset, valid is '0'.
	wire holds = (!held || (valid && payload == offered)) && (!was_reset || !valid);

	always @(posedge clk) begin
		first <= 0;
		was_reset <= rst;
		held <= !rst && valid && !ready;
		offered <= payload;
		if (!first && !rst && PROVED)
			assert (holds);
		if (!first && !rst && !PROVED)
			assume (holds);
	end
endmodule

module axi4_lite #(
	parameter ADDRESS_BITS = 10,
	parameter DATA_BITS = 32,
	parameter MASTER = 1
) (
	input clk,
	input rst,
	input [ADDRESS_BITS-1:0] awaddr,
	input [2:0] awprot,
	input awvalid,
	input awready,
	input [DATA_BITS-1:0] wdata,
	input [DATA_BITS/8-1:0] wstrb,
	input wvalid,
	input wready,
	input [1:0] bresp,
	input bvalid,
	input bready,
	input [ADDRESS_BITS-1:0] araddr,
	input [2:0] arprot,
	input arvalid,
	input arready,
	input [DATA_BITS-1:0] rdata,
	input [1:0] rresp,
	input rvalid,
	input rready,
	// For each channel: a transfer has passed that no response has closed yet.
	output reg has_aw,
	output reg has_w,
	output reg has_ar
);
	axi4_lite_channel #(.BITS(ADDRESS_BITS + 3), .PROVED(MASTER))
		aw (.valid(awvalid), .ready(awready), .payload({awaddr, awprot}), .*);
	axi4_lite_channel #(.BITS(DATA_BITS + DATA_BITS / 8), .PROVED(MASTER))
		w (.valid(wvalid), .ready(wready), .payload({wdata, wstrb}), .*);
	axi4_lite_channel #(.BITS(ADDRESS_BITS + 3), .PROVED(MASTER))
		ar (.valid(arvalid), .ready(arready), .payload({araddr, arprot}), .*);
	axi4_lite_channel #(.BITS(2), .PROVED(!MASTER))
		b (.valid(bvalid), .ready(bready), .payload(bresp), .*);
	axi4_lite_channel #(.BITS(DATA_BITS + 2), .PROVED(!MASTER))
		r (.valid(rvalid), .ready(rready), .payload({rdata, rresp}), .*);

	initial {has_aw, has_w, has_ar} = 0;

	// One response for each access, and none before all parts of the access have passed.
	wire answers_what_was_asked = (!bvalid || (has_aw && has_w)) && (!rvalid || has_ar);
	// No second access before the response to the first.
	wire one_at_a_time = !(awvalid && has_aw) && !(wvalid && has_w) && !(arvalid && has_ar);

	always @(posedge clk) begin
		has_aw <= !rst && !(bvalid && bready) && (has_aw || (awvalid && awready));
		has_w <= !rst && !(bvalid && bready) && (has_w || (wvalid && wready));
		has_ar <= !rst && !(rvalid && rready) && (has_ar || (arvalid && arready));
		if (!rst && MASTER) begin
			assume (answers_what_was_asked);
			assert (one_at_a_time);
		end
		if (!rst && !MASTER) begin
			assert (answers_what_was_asked);
			assume (one_at_a_time);
		end
	end
endmodule

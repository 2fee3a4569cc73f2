// SPDX-License-Identifier: BSD-3-Clause
//
// What AXI4-Lite asks of a master and of a slave (AMBA IHI 0022, A3.2, A3.3 and B1), one access under way at most.
//
// The rules of one side are asserted or assumed, as the proof is about it or about the other.

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

	// What is valid stays, and stays the same, until it is taken; behind a reset nothing is.
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
	// Of each channel, whether something has passed that no answer has closed.
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

	// One answer to each access, and none before the access has passed as a whole.
	wire answers_what_was_asked = (!bvalid || (has_aw && has_w)) && (!rvalid || has_ar);
	// No second access before the answer to the first.
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

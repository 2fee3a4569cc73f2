// SPDX-License-Identifier: BSD-3-Clause
//
// Rules of Wishbone B4 for a master and a slave on the bus between them (revision B4, sections 3 and 5).
//
// The rules of one side are asserted if the proof is about that side, and assumed otherwise. A master may deassert
// `cyc` at any time; a slave with registers may then still answer in the following cycle.

module wishbone_b4 #(
	parameter ADDRESS_BITS = 8,
	parameter DATA_BITS = 8,
	parameter PIPELINED = 0,
	// 1: this side is proved. 0: it is assumed to follow the rules. 2: no assumptions about it.
	parameter MASTER = 1,
	parameter SLAVE = 0
) (
	input clk,
	input rst,
	input cyc,
	input stb,
	input we,
	input [ADDRESS_BITS-1:0] adr,
	input [DATA_BITS-1:0] dat,
	input [(DATA_BITS+7)/8-1:0] sel,
	input ack,
	input err,
	input rty,
	input stall,
	// Number of accesses that a pipelined slave has accepted but not answered.
	output reg [2:0] open
);
	wire answered = ack || err || rty;
	wire waits = PIPELINED ? stall : !answered;
	wire took = PIPELINED && cyc && stb && !stall;

	reg first = 1, was_reset = 0;
	reg held = 0, strobe = 0;
	reg [ADDRESS_BITS+DATA_BITS+(DATA_BITS+7)/8:0] access;
	initial open = 0;
	// The data signals of a read are ignored.
	wire [ADDRESS_BITS+DATA_BITS+(DATA_BITS+7)/8:0] asked = {we, adr, we ? dat : {DATA_BITS{1'b0}}, sel};

	// Rule 3.20: a reset ends accesses. 3.25: `cyc` includes the strobe. 3.60: an access is stable until it is accepted.
	wire ends_by_reset = !was_reset || (!cyc && !stb);
	wire is_in_cycle = !stb || cyc;
	wire stands_still = !(held && cyc) || (stb && asked == access);
	// Rule 3.45: at most one kind of answer. 3.35 and 3.50: no answer without an access.
	wire one_answer = ack + err + rty <= 1;
	wire is_asked = PIPELINED ? !answered || open != 0 || took || (strobe && !cyc) : !answered || (cyc && stb) || (strobe && !stb);

	always @(posedge clk) begin
		first <= 0;
		was_reset <= rst && !first;
		held <= !rst && cyc && stb && waits;
		strobe <= !rst && cyc && (stb || open != 0);
		access <= asked;
		open <= rst || !cyc ? 0 : open + took - (answered && (open != 0 || took));
		if (!first && !rst && MASTER == 1) begin
			assert (ends_by_reset && is_in_cycle && stands_still);
		end
		if (!first && !rst && MASTER == 0) begin
			assume (ends_by_reset && is_in_cycle && stands_still);
		end
		if (!first && !rst && SLAVE == 1)
			assert (one_answer && is_asked);
		if (!first && !rst && SLAVE == 0)
			assume (one_answer && is_asked);
	end
endmodule

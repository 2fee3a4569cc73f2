// SPDX-License-Identifier: BSD-3-Clause
//
// What the Wishbone wrapper promises, whatever the core does within the rules at its top and the slave beyond any:
// it keeps to Wishbone B4; an answer is passed on where the access is the slave's, and nowhere else; what has been sent
// away is asked again after one cycle; `cyc` stands while the lock does, and falls in an access only where the core
// gives that up or the slave sends it away.

module ul_wishbone_master_properties (
	input clk,
	input rst,
	input bus_request,
	input bus_write,
	input bus_lock,
	input [7:0] bus_address,
	input [7:0] bus_write_data,
	input [7:0] dat_i,
	input ack,
	input err,
	input rty,
	input stall
);
`ifdef PIPELINED
	localparam IS_PIPELINED = 1;
	(* hierconn *) wire \dut.taken ;
`else
	localparam IS_PIPELINED = 0;
`endif
	wire [7:0] bus_read_data, adr, dat_o;
	wire bus_done, bus_error, cyc, stb, we, sel;
	wire [2:0] open;

	ul_wishbone_master dut (.*);
	wishbone_b4 #(.PIPELINED(IS_PIPELINED), .MASTER(1), .SLAVE(2)) rules (.dat(dat_o), .*);

	(* hierconn *) wire \dut.sent_away ;

	reg first = 1, was_reset = 0;
	reg asked = 0, answered = 0;
	reg [16:0] access;
	// The last cycle: an access was the slave's and not answered, and whether it was sent away.
	reg pending = 0, away = 0;
	reg [2:0] done = 0, tries = 0;

	wire taken = IS_PIPELINED ? open != 0 || (stb && !stall) : stb;

	always @(posedge clk) begin
		first <= 0;
		assume (rst == first);
	end

	always @(posedge clk) if (!first) begin
		// The core's rules: an access stands still until it is answered, and is taken back for a cycle behind that.
		asked <= bus_request && !bus_done;
		answered <= bus_done;
		access <= {bus_write, bus_address, bus_write_data};
		if (asked && bus_request)
			assume ({bus_write, bus_address, bus_write_data} == access);
		if (answered)
			assume (!bus_request);
		// One that is given up takes its transaction with it.
		if (asked && !bus_request)
			assume (!bus_lock);

		pending <= cyc && bus_request && !bus_done && !(taken && rty);
		away <= bus_request && cyc && taken && rty && !bus_done;
		if (bus_done)
			done <= done + (done != 7);
		tries <= bus_request ? tries + (away && tries != 7) : 0;

		assert (bus_done == (cyc && bus_request && taken && (ack || err)));
		if (bus_done)
			assert (bus_error == err && bus_read_data == dat_i);
		if (stb)
			assert (bus_request && sel && {we, adr, dat_o} == {bus_write, bus_address, bus_write_data});
		if (bus_lock || (pending && bus_request))
			assert (cyc);
		if (away)
			assert (!stb && cyc == bus_lock);
		if (bus_request && !away)
			assert (cyc && (stb || open != 0));
		assert (!cyc || bus_lock || bus_request);

		// What makes the proof hold without a bound.
		assert (away == \dut.sent_away );
		assert (open <= 1);
`ifdef PIPELINED
		assert (\dut.taken == (open != 0));
		assert (!\dut.taken || asked);
`endif
		cover (done == 2 && bus_done && tries == 3 && bus_lock);
		cover (done == 3 && answered && asked == 0 && ack);
		cover (asked && !bus_request && tries == 1);
	end
endmodule

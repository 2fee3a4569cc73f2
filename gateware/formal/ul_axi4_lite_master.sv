// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of the AXI4-Lite wrapper, for a core that follows the rules at its top and a slave that follows AXI4-Lite,
// with any delays: it follows AXI4-Lite; it reports an access to the core once, with the response to that access and no
// other, however many accesses the core has given up before; and an access on the bus is the one that the core
// requested.

module ul_axi4_lite_master_properties (
	input clk,
	input rst,
	input bus_request,
	input bus_write,
	input [7:0] bus_address,
	input [31:0] bus_write_data,
	input awready,
	input wready,
	input [1:0] bresp,
	input bvalid,
	input arready,
	input [31:0] rdata,
	input [1:0] rresp,
	input rvalid
);
	wire [31:0] bus_read_data, wdata;
	wire bus_done, bus_error, awvalid, wvalid, bready, arvalid, rready;
	wire [9:0] awaddr, araddr;
	wire [2:0] awprot, arprot;
	wire [3:0] wstrb;
	wire has_aw, has_w, has_ar;

	ul_axi4_lite_master dut (.*);
	axi4_lite rules (.*);

	(* hierconn *) wire \dut.waiting , \dut.wanted , \dut.write , \dut.address_valid , \dut.data_valid ;
	(* hierconn *) wire [9:0] \dut.address ;

	reg first = 1;
	reg asked = 0, answered = 0;
	reg [40:0] access;
	// open: an access has begun on the bus and has no response yet. own: the core has requested it all the time.
	reg open = 0, own = 0;
	reg [2:0] done = 0, lost = 0;

	wire begins = bus_request && !open;
	wire closes = (bvalid && bready) || (rvalid && rready);

	always @(posedge clk) begin
		first <= 0;
		assume (rst == first);
	end

	always @(posedge clk) if (!first) begin
		// Assumptions on the core: an access is stable until it is answered, and deasserted for a cycle after that.
		asked <= bus_request && !bus_done;
		answered <= bus_done;
		access <= {bus_write, bus_address, bus_write_data};
		if (asked && bus_request)
			assume ({bus_write, bus_address, bus_write_data} == access);
		if (answered)
			assume (!bus_request);

		open <= begins || (open && !closes);
		own <= begins || (own && bus_request && !closes);
		if (bus_done)
			done <= done + (done != 7);
		if (closes && !bus_done)
			lost <= lost + (lost != 7);

		assert (bus_done == (closes && own && bus_request));
		if (bus_done) begin
			assert (bus_write ? bvalid && bready : rvalid && rready);
			assert (bus_error == (bus_write ? bresp[1] : rresp[1]));
			assert (bus_write || bus_read_data == rdata);
		end
		if ((awvalid || wvalid || arvalid) && own && bus_request)
			assert (bus_write ? !arvalid : !awvalid && !wvalid);
		if (awvalid && own && bus_request)
			assert (awaddr == {bus_address, 2'b00});
		if (arvalid && own && bus_request)
			assert (araddr == {bus_address, 2'b00});
		if (wvalid && own && bus_request)
			assert (wdata == bus_write_data && wstrb == 4'hF);
		assert (!(awvalid || wvalid || arvalid) || open);
		// An access that has begun waits only for the slave.
		if (open)
			assert ((bready && (awvalid || has_aw) && (wvalid || has_w)) || (rready && (arvalid || has_ar)));

		// Invariants that make the proof hold without a bound.
		assert (open == \dut.waiting );
		if (open)
			assert (own == \dut.wanted );
		assert (open || !\dut.address_valid && !\dut.data_valid );
		assert (open || (!has_aw && !has_w && !has_ar));
		assert (!own || open);
		if (own && bus_request)
			assert (\dut.write == bus_write && \dut.address == {bus_address, 2'b00} &&
				wdata == bus_write_data);
		if (own)
			assert (asked);
		if (open) begin
			assert (\dut.write ? !has_ar : !has_aw && !has_w && !\dut.data_valid );
			assert (\dut.write ? \dut.address_valid != has_aw && \dut.data_valid != has_w : \dut.address_valid != has_ar);
		end

		cover (done == 2 && lost == 2 && bus_done && bus_write);
		cover (done == 2 && lost == 2 && bus_done && !bus_write && bus_error);
		cover (lost == 1 && bus_request && !own && open && done == 1);
	end
endmodule

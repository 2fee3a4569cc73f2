// SPDX-License-Identifier: BSD-3-Clause
//
// What the bus master promises to a bus and to its two clients, whatever these do within the rules at its top:
// an access stands still until it is answered, is taken back for at least one cycle, and never lasts longer than the
// time-out; each access that was granted is told as done once, to the client that it was granted to; the lock falls
// with a time-out, and for as many cycles nothing more is asked of the bus; and no sample comes between the accesses of an exclusive transaction, nor a request into a sample.

module ul_bus_master_properties #(
	parameter TIMEOUT = 3
) (
	input clk,
	input request,
	input request_write,
	input request_more,
	input request_exclusive,
	input [7:0] request_address,
	input [7:0] request_data,
	input sample,
	input sample_more,
	input [7:0] sample_address,
	input [7:0] bus_read_data,
	input bus_done,
	input bus_error
);
	localparam IDLE = 0, ACTIVE = 1, TOLD = 2, REST = 3;

	wire request_granted, request_done, sample_granted, sample_done, sample_strobe, sample_access;
	wire [3:0] failure;
	wire [7:0] read_data;
	wire bus_request, bus_write, bus_lock;
	wire [7:0] bus_address, bus_write_data;
	reg rst = 1;

	ul_bus_master dut (.*);

	reg asked = 0;
	reg [16:0] access;
	reg [2:0] lasts = 0;
	// An access that was granted and not yet told, whose it is, and what is still to follow in its transaction.
	reg open = 0, open_sample = 0;
	reg exclusive = 0, sampling = 0;
	reg request_kept = 0, sample_kept = 0;
	reg [4:0] done = 0;
	// Cycles for which nothing more may be asked after a time-out.
	reg [2:0] rest = 0;
	// The words that are read belong to the last instant.
	reg instant = 0;

	(* hierconn *) wire [1:0] \dut.state ;
	(* hierconn *) wire [2:0] \dut.time_left ;
	(* hierconn *) wire \dut.exclusive , \dut.sample_lock , \dut.for_sample , \dut.request_lock , \dut.timed_out ;

	always @(posedge clk) begin
		rst <= 0;
		if (rst)
			assert (!asked && !open && !exclusive && !sampling && lasts == 0);
	end

	always @(posedge clk) if (!rst) begin
		// The rules for clients: a request stands until it is done, and until its transaction is over.
		request_kept <= request && !request_done;
		sample_kept <= sample && !sample_done;
		assume (!request_kept || request);
		assume (!sample_kept || sample);
		assume (!exclusive || request_exclusive);

		asked <= bus_request && !bus_done;
		access <= {bus_write, bus_address, bus_write_data};
		lasts <= bus_request ? lasts + 1 : 0;
		if (bus_request && lasts == TIMEOUT - 1 && !bus_done)
			rest <= TIMEOUT + 1;
		else if (rest != 0)
			rest <= rest - 1;
		if (rest != 0)
			assert (!bus_request && !bus_lock && !request_granted && !sample_granted);
		if (request_granted || sample_granted) begin
			open <= 1;
			open_sample <= sample_granted;
			if (sample_granted)
				sampling <= sample_more;
			else
				exclusive <= request_more && request_exclusive;
		end
		if (request_done || sample_done) begin
			open <= 0;
			if (failure != 0 && open_sample)
				sampling <= 0;
			if (failure != 0 && !open_sample)
				exclusive <= 0;
			if (done != 31)
				done <= done + 1;
		end

		assert (lasts <= TIMEOUT);
		if (lasts == TIMEOUT)
			assert (!bus_request);
		if (asked && lasts < TIMEOUT)
			assert (bus_request && {bus_write, bus_address, bus_write_data} == access);
		if (!asked && lasts != 0)
			assert (!bus_request);
		assert (!(request_granted && sample_granted));
		assert (!(request_done && sample_done));
		if (request_granted || sample_granted)
			assert (!open);
		if (request_done)
			assert (open && !open_sample);
		if (sample_done)
			assert (open && open_sample);
		if (bus_request)
			assert (open);
		if (sample_granted)
			assert (!exclusive && sample);
		if (request_granted)
			assert (!sampling && request);
		if ((request_done || sample_done) && failure == 5)
			assert (!bus_lock);
		if (exclusive || sampling)
			assert (bus_lock || ((request_done || sample_done) && failure == 5));

		// A sample has one instant, in front of its first access, and no access of a request until it is over.
		assert (sample_strobe == (sample_granted && !sampling));
		assert (!sample_strobe || !sample_access);
		if (bus_request)
			assert (sample_access == open_sample);
		if (request_granted)
			assert (!sample_access);
		instant <= sample_strobe || (instant && sample_access);
		if (sample_access || (bus_request && open_sample))
			assert (instant);
		if (sampling && !((request_done || sample_done) && failure != 0))
			assert (sample_access);

		// What makes the proof hold without a bound.
		assert (bus_request == (\dut.state == ACTIVE));
		assert (open == (\dut.state == ACTIVE || \dut.state == TOLD));
		assert (exclusive == \dut.exclusive && sampling == \dut.sample_lock );
		if (open)
			assert (open_sample == \dut.for_sample && !(open_sample ? exclusive : sampling));
		if (bus_request)
			assert (\dut.time_left + lasts == TIMEOUT - 1);
		assert (\dut.state <= REST);
		if (bus_request)
			assert (asked == (lasts != 0));
		if (exclusive)
			assert (\dut.request_lock );
		if (\dut.timed_out )
			assert (\dut.state == TOLD ? failure == 5 :
				\dut.state == REST && !exclusive && !sampling);
		assert (\dut.state != REST || \dut.timed_out );
		assert (rest == (\dut.state == REST ? \dut.time_left + 1 :
			\dut.state == TOLD && \dut.timed_out ? TIMEOUT + 1 : 0));
		if (\dut.state == TOLD && \dut.timed_out )
			assert (\dut.time_left == TIMEOUT - 1);
		if (\dut.state == TOLD && failure == 5)
			assert (\dut.timed_out );

		cover (done == 3 && request_granted && sample);
		cover (done == 3 && sample_done && failure == 5);
		cover (done == 3 && request_granted && $past(rest) == 1);
		cover (done == 2 && request_done && failure == 4 && exclusive);
		cover (done == 2 && sample_granted && request && bus_lock);
	end
endmodule

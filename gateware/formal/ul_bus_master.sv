// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of the bus master for a bus and two clients that follow the rules at its top. An access is stable until it
// is accepted or answered. At most four accesses are in flight, all reads of one client, and none for longer than the
// timeout after the last answer. Each granted access is reported done once and in order, to the client to which it was
// granted, with the word of its answer, up to the first failure; the accesses in flight after that one are completed
// before any other access begins. A kept word is reported without a bus access. bus_lock is '0' after a timeout, and
// the bus is not used for as many cycles, or twice as many if several accesses may have been in flight. No sample comes
// between the accesses of an exclusive transaction, and no request during a sample.
//
// ONE_BY_ONE: the bus master is configured for a bus with one access at a time.

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
	input request_kept,
	input [7:0] kept_word,
	input sample,
	input sample_more,
	input [7:0] sample_address,
	input [7:0] bus_read_data,
	input bus_next,
	input bus_done,
	input bus_error
);
	localparam IDLE = 0, ACTIVE = 1, DRAIN = 2, TOLD = 3, REST = 4;

	wire request_granted, request_done, request_last, sample_granted, sample_done, sample_strobe, sample_access;
	wire [3:0] failure;
	wire [7:0] read_data;
	wire bus_request, bus_write, bus_lock, bus_ahead;
	wire [7:0] bus_address, bus_write_data;
	reg rst = 1;

`ifdef ONE_BY_ONE
	localparam ONE_BY_ONE = 1;
`else
	localparam ONE_BY_ONE = 0;
`endif

	ul_bus_master dut (.*);

	reg asked = 0;
	reg [16:0] access;
	reg [2:0] lasts = 0;
	// Number of accesses that the bus has accepted but not answered.
	reg [2:0] taken = 0;
	// Answer in the last cycle.
	reg answered = 0;
	reg [7:0] word;
	// A kept word is being reported now; one was in the last cycle.
	reg keeping = 0, kept_before = 0;
	// Number of granted accesses not yet reported, their client, and whether their transaction has further accesses.
	reg [2:0] open = 0;
	reg open_sample = 0;
	reg exclusive = 0, sampling = 0, block = 0;
	// The accesses in flight belong to a block or to a sample of several words; one of them has failed.
	reg ahead = 0, failed = 0;
	reg request_waits = 0, sample_waits = 0;
	reg [4:0] done = 0;
	// Number of cycles for which the bus must not be used after a timeout.
	reg [3:0] rest = 0;
	// The words being read belong to the last sample strobe.
	reg instant = 0;

	wire told = request_done || sample_done;
	wire under_way = bus_request || taken != 0;
	wire leaves = bus_next || (bus_done && taken == 0);
	wire gives_up = under_way && lasts == TIMEOUT - 1 && !bus_done;

	(* hierconn *) wire [2:0] \dut.state , \dut.time_left , \dut.under_way ;
	(* hierconn *) wire \dut.exclusive , \dut.sample_lock , \dut.for_sample , \dut.request_lock , \dut.timed_out ;
	(* hierconn *) wire \dut.told_ahead , \dut.ahead , \dut.kept ;

	always @(posedge clk) begin
		rst <= 0;
		if (rst)
			assert (!asked && open == 0 && taken == 0 && !exclusive && !sampling && !block && lasts == 0 && !keeping && !kept_before);
	end

	always @(posedge clk) if (!rst) begin
		// Assumption on the bus: it accepts an access before its answer only if others may follow.
		assume (!bus_next || (bus_request && bus_ahead));
		// Assumptions on the clients: a request is stable until it is granted, and its transaction is of one kind; after its
		// last access a client requests nothing until that access is reported.
		request_waits <= request && !request_granted && !(request_done && failure != 0);
		sample_waits <= sample && !sample_granted && !(sample_done && failure != 0);
		assume (!request_waits || request);
		assume (!sample_waits || sample);
		assume (!exclusive || request_exclusive);
		assume (!block || !(request_exclusive || request_write));
		assume (!(request && request_write && request_more) || request_exclusive);
		assume (!(request && request_kept) || !(request_write || request_more || request_exclusive || block));
		assume (!(ahead && open != 0 && !open_sample && !block) || !request);
		assume (!(ahead && open != 0 && open_sample && !sampling) || !sample);

		asked <= bus_request && !leaves && !gives_up;
		access <= {bus_write, bus_address, bus_write_data};
		taken <= gives_up ? 0 : taken + bus_next - (bus_done && (taken != 0 || bus_next));
		lasts <= under_way && !bus_done && !gives_up ? lasts + 1 : 0;
		keeping <= request_granted && request_kept;
		kept_before <= keeping;
		answered <= (bus_done && under_way) || keeping;
		word <= keeping ? kept_word : bus_read_data;
		if (gives_up)
			rest <= (ahead ? 2 * TIMEOUT : TIMEOUT) + !failed;
		else if (rest != 0)
			rest <= rest - 1;
		if (rest != 0)
			assert (!bus_request && !bus_lock && !request_granted && !sample_granted);
		if (request_granted || sample_granted) begin
			open_sample <= sample_granted;
			if (sample_granted)
				sampling <= sample_more;
			else begin
				exclusive <= request_more && request_exclusive;
				block <= request_more && !request_exclusive;
			end
			if (!under_way) begin
				ahead <= !ONE_BY_ONE && (sample_granted ? sample_more : request_more && !request_exclusive);
				failed <= 0;
			end
		end
		if (under_way && bus_done && bus_error)
			failed <= 1;
		open <= told && failure != 0 ? 0 : open + (request_granted || sample_granted) - told;
		if (told) begin
			if (failure != 0 && open_sample)
				sampling <= 0;
			if (failure != 0 && !open_sample) begin
				exclusive <= 0;
				block <= 0;
			end
			if (done != 31)
				done <= done + 1;
		end

		assert (lasts < TIMEOUT);
		if (asked)
			assert (bus_request && {bus_write, bus_address, bus_write_data} == access);
		assert (!(request_granted && sample_granted));
		assert (!(request_done && sample_done));
		if (request_granted || sample_granted)
			assert (!under_way || (ahead && !failed && open_sample == sample_granted && (leaves || !bus_request)));
		if (keeping)
			assert (!bus_request && taken == 0 && !bus_lock && !request_granted && !sample_granted);
		if (kept_before)
			assert (request_done && request_last && failure == 0);
		assert (taken + bus_request <= 4);
		if (taken != 0)
			assert (ahead && bus_lock);
		if (under_way && ahead)
			assert (!bus_write);
		if (told)
			assert (open != 0 && open_sample == sample_done);
		if (told && failure != 5)
			assert (answered && read_data == word);
		if (under_way && !failed)
			assert (open != 0);
		if (request_done && request_last)
			assert (!under_way && (open == 1 || failure == 5));
		if (request_done && failure == 0 && !request_last)
			assert (under_way);
		if (sample_granted)
			assert (!exclusive && sample);
		if (request_granted)
			assert (!sampling && request);
		if (told && failure == 5)
			assert (!bus_lock);
		if (exclusive || sampling)
			assert (bus_lock || (told && failure == 5));

		// A sample has one strobe, before its first access; no access of a request occurs until the sample is over.
		assert (sample_strobe == (sample_granted && !sampling));
		assert (!sample_strobe || !sample_access);
		if (bus_request)
			assert (sample_access == open_sample);
		if (request_granted)
			assert (!sample_access);
		instant <= sample_strobe || (instant && sample_access);
		if (sample_access || (bus_request && open_sample))
			assert (instant);
		if (sampling && !(told && failure != 0))
			assert (sample_access);

		// Invariants that make the proof hold without a bound.
		assert (\dut.state <= REST);
		assert ((under_way || keeping) == (\dut.state == ACTIVE || \dut.state == DRAIN));
		assert (!(under_way && keeping) && keeping == (\dut.state == ACTIVE && \dut.kept ));
		assert (taken == \dut.under_way );
		if (under_way) begin
			assert (failed == (\dut.state == DRAIN) && ahead == \dut.ahead );
			assert (\dut.time_left + lasts == TIMEOUT - 1);
		end else
			assert (lasts == 0 && !asked);
		if (\dut.state == ACTIVE)
			assert (open == taken + bus_request + keeping + \dut.told_ahead );
		if (\dut.state == DRAIN)
			assert (\dut.told_ahead ? open == taken + bus_request + 1 && failure == 4 : open == 0);
		if (\dut.state == TOLD)
			assert (failure == 5 ? open != 0 : open == 1);
		if (\dut.state == IDLE || \dut.state == REST)
			assert (open == 0);
		if (\dut.told_ahead )
			assert (under_way && answered && ahead && failure == (failed ? 4 : 0));
		if (\dut.state == TOLD && failure != 5)
			assert (answered);
		if (answered)
			assert (read_data == word || failed);
		if (told)
			assert (failure == 0 || failure == 4 || failure == 5);
		if (under_way || open != 0)
			assert (open_sample == \dut.for_sample && !(open_sample ? exclusive : sampling));
		if (under_way && exclusive)
			assert (!ahead);
		assert (!exclusive || !block);
		assert (exclusive == \dut.exclusive && sampling == \dut.sample_lock );
		assert ((exclusive || block) == \dut.request_lock );
		if (\dut.timed_out )
			assert (\dut.state == TOLD ? failure == 5 : \dut.state == REST && !exclusive && !sampling);
		assert (\dut.state != REST || \dut.timed_out );
		assert (rest == (\dut.state == REST ? \dut.time_left + 1 :
			\dut.state == TOLD && \dut.timed_out ? \dut.time_left + 2 : 0));
		if (\dut.state == TOLD && \dut.timed_out )
			assert (\dut.time_left == (\dut.ahead ? 2 * TIMEOUT : TIMEOUT) - 1);
		if (\dut.state == TOLD && failure == 5)
			assert (\dut.timed_out );

		cover (done == 3 && request_granted && sample);
		cover (done == 3 && request_done && kept_before && sample);
		cover (done == 3 && sample_done && failure == 5);
		cover (done == 3 && request_granted && $past(rest) == 1);
		cover (done == 2 && request_done && failure == 4 && exclusive);
		cover (done == 2 && sample_granted && request && bus_lock);
`ifdef ONE_BY_ONE
		assert (!bus_ahead && taken == 0);
		cover (done == 2 && sample_granted && block && request);
`else
		cover (done == 1 && taken == 3 && bus_request && !open_sample);
		cover (done == 4 && request_done && failure == 4 && taken == 2);
		cover (done == 2 && failed && lasts == TIMEOUT - 1 && !bus_done);
		cover (done == 3 && sample_granted && $past(failed) && ahead);
`endif
	end
endmodule

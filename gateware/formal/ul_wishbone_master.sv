// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of the Wishbone wrapper, for a core that follows the rules at its top and any slave: it follows Wishbone
// B4; an answer is passed on only while the slave has the access; after `rty` the access is requested again after one
// cycle; `cyc` is '1' while bus_lock is, and falls during an access only if the core gives it up or the slave answers
// `rty`. Each of several pipelined accesses gets its own answer, in order, even if some are answered by `rty`, and only
// those are requested twice.

`ifdef PIPELINED
module ul_wishbone_master_properties (
	input clk,
	input rst,
	input bus_request,
	input bus_write,
	input bus_lock,
	input bus_ahead,
	input [7:0] bus_address,
	input [7:0] bus_write_data,
	input [7:0] dat_i,
	input ack,
	input err,
	input rty,
	input stall,
	// Selects the access that is followed.
	input pick
);
	localparam WAITS = 0, AWAY = 1, ANSWERED = 2;

	wire [7:0] bus_read_data, adr, dat_o;
	wire bus_done, bus_error, bus_next, cyc, stb, we, sel;
	wire [2:0] open;

	ul_wishbone_master dut (.*);
	wishbone_b4 #(.PIPELINED(1), .MASTER(1), .SLAVE(2)) rules (.dat(dat_o), .*);

	(* hierconn *) wire [2:0] \dut.with_pipeline_held , \dut.with_pipeline_owed ;
	(* hierconn *) wire [1:0] \dut.with_pipeline_head , \dut.with_pipeline_middle , \dut.with_pipeline_tail ;
	(* hierconn *) wire [3:0] \dut.with_pipeline_again ;
	(* hierconn *) wire \dut.with_pipeline_gathers , \dut.with_pipeline_replays , \dut.with_pipeline_sent_away ;
	(* hierconn *) wire [7:0] \dut.with_pipeline_addresses[0] , \dut.with_pipeline_addresses[1] ;
	(* hierconn *) wire [7:0] \dut.with_pipeline_addresses[2] , \dut.with_pipeline_addresses[3] ;
	(* hierconn *) wire [7:0] \dut.with_pipeline_words[0] , \dut.with_pipeline_words[1] ;
	(* hierconn *) wire [7:0] \dut.with_pipeline_words[2] , \dut.with_pipeline_words[3] ;
	(* hierconn *) wire \dut.with_pipeline_failed[0] , \dut.with_pipeline_failed[1] ;
	(* hierconn *) wire \dut.with_pipeline_failed[2] , \dut.with_pipeline_failed[3] ;

	wire [2:0] held = \dut.with_pipeline_held , owed = \dut.with_pipeline_owed ;
	wire [1:0] head = \dut.with_pipeline_head ;
	wire gathers = \dut.with_pipeline_gathers , replays = \dut.with_pipeline_replays ;

	reg first = 1;
	reg asked = 0, requested = 0, ahead = 0, answered = 0, away = 0;
	reg [16:0] access;
	// Number of accesses accepted from the core and not reported yet.
	reg [2:0] flight = 0;
	// One of these accesses: number of accesses before it at the core and at the slave, and its state.
	reg follows = 0;
	reg [7:0] followed, word;
	reg failed;
	reg [2:0] before, waits;
	reg [1:0] known;
	reg [1:0] tries = 0;
	// Cycles without progress although an access is requested.
	reg [1:0] idle = 0;
	reg [2:0] done = 0;

	wire lives = bus_request || bus_lock;
	wire strobe = stb && !stall;
	wire repeats = strobe && replays;
	wire begins = strobe && !replays;
	wire hit = cyc && (ack || err || rty) && (open != 0 || strobe);
	wire leaves = bus_next || (bus_done && flight == 0);
	wire [2:0] before_now = begins && !follows ? held : before;
	wire [2:0] waits_now = begins && !follows ? open : repeats ? 0 : waits;
	wire is_new = begins && !follows && pick;
	wire waits_here = is_new || (follows && (known == WAITS || (repeats && before == 0)));
	wire is_hit = hit && waits_here && waits_now == 0;
	wire is_done = bus_done && (is_new || follows) && before_now == 0;

	always @(posedge clk) begin
		first <= 0;
		assume (rst == first);
	end

	always @(posedge clk) if (!first) begin
		// Assumptions on the core: an access is stable until it is accepted or answered. Several accesses in flight are reads
		// of one transaction, and at most four. Otherwise the request is deasserted for a cycle after its answer. Giving up
		// an access ends its whole transaction.
		asked <= bus_request && !leaves;
		requested <= bus_request;
		ahead <= bus_ahead;
		answered <= bus_done;
		access <= {bus_write, bus_address, bus_write_data};
		flight <= lives ? flight + bus_next - (bus_done && (bus_next || flight != 0)) : 0;
		if (asked && bus_request)
			assume ({bus_write, bus_address, bus_write_data} == access);
		if (asked && !bus_request)
			assume (!bus_lock);
		if (answered && !ahead)
			assume (!bus_request);
		assume (bus_ahead == ahead || (!requested && flight == 0));
		assume (!(bus_ahead && bus_request) || (bus_lock && !bus_write));
		assume (flight + bus_request <= 4);
		assume (flight == 0 || (!bus_write && (bus_lock || !bus_request)));

		away <= hit && !ack && !err;
		idle <= lives && (bus_request || held != 0) && !stb && open == 0 && !bus_done ? idle + 1 : 0;
		tries <= !bus_request || bus_done ? 0 : tries + (repeats && tries != 3);
		if (bus_done)
			done <= done + (done != 7);

		if (is_new) begin
			follows <= 1;
			followed <= bus_address;
		end
		if (is_new || follows) begin
			before <= before_now - bus_done;
			waits <= waits_now - (hit && waits_now != 0);
			if (waits_here)
				known <= WAITS;
			if (is_hit) begin
				known <= ack || err ? ANSWERED : AWAY;
				{failed, word} <= {err, dat_i};
			end
		end
		if (is_done || !lives)
			follows <= 0;

		// The core gets exactly the slave's answer to the access followed, once and in order.
		if (is_done)
			assert (is_hit ? (ack || err) && {bus_error, bus_read_data} == {err, dat_i} :
				!is_new && known == ANSWERED && {bus_error, bus_read_data} == {failed, word});
		// No word is requested twice except after `rty`.
		if (repeats && follows && before == 0)
			assert (known == AWAY && adr == followed);
		if (repeats)
			assert (held != 0 && open == 0);
		if (begins)
			assert ({we, adr, dat_o} == {bus_write, bus_address, bus_write_data} && bus_request);
		assert (bus_next == (begins && bus_ahead));
		if (stb)
			assert (sel && cyc);
		if (bus_done)
			assert (held != 0 || begins);
		if (bus_lock)
			assert (cyc);
		if (away && !ahead)
			assert (!stb && cyc == bus_lock);
		assert (!cyc || lives);
		assert (idle <= 2);

		// Invariants that make the proof hold without a bound.
		assert (held <= 4 && owed == open && owed <= held);
		assert (\dut.with_pipeline_sent_away == (away && lives) || !lives || !$past(lives));
		assert (ahead || flight == 0);
		if (ahead)
			assert (held == flight);
		else
			assert (held <= 1 && (held == 0 || asked));
		assert (!(gathers && replays));
		assert (\dut.with_pipeline_tail == head + held[1:0]);
		if (!gathers && !replays)
			assert (owed == held);
		if (gathers)
			assert (owed < held && \dut.with_pipeline_middle == head + held[1:0] - owed[1:0] && \dut.with_pipeline_again [head]);
		if (replays)
			assert (held != 0 && owed <= \dut.with_pipeline_again [head]);
		if (follows) begin : row
			reg [1:0] place;
			reg [7:0] kept_address, kept_word;
			reg kept_failed;
			place = head + before[1:0];
			case (place)
			0: {kept_address, kept_word, kept_failed} = {\dut.with_pipeline_addresses[0] , \dut.with_pipeline_words[0] , \dut.with_pipeline_failed[0] };
			1: {kept_address, kept_word, kept_failed} = {\dut.with_pipeline_addresses[1] , \dut.with_pipeline_words[1] , \dut.with_pipeline_failed[1] };
			2: {kept_address, kept_word, kept_failed} = {\dut.with_pipeline_addresses[2] , \dut.with_pipeline_words[2] , \dut.with_pipeline_failed[2] };
			3: {kept_address, kept_word, kept_failed} = {\dut.with_pipeline_addresses[3] , \dut.with_pipeline_words[3] , \dut.with_pipeline_failed[3] };
			endcase
			assert (before < held && kept_address == followed);
			if (!gathers && !replays)
				assert (known == WAITS && waits == before);
			else if (gathers && before >= held - owed)
				assert (known == WAITS && waits == before - (held - owed));
			else if (replays && before == 0 && owed == 1)
				assert (known == WAITS && waits == 0);
			else
				assert (known == (\dut.with_pipeline_again [place] ? AWAY : ANSWERED));
			if (known == ANSWERED)
				assert ({kept_failed, kept_word} == {failed, word});
		end

		cover (done == 2 && bus_done && tries == 3 && bus_lock);
		cover (done == 3 && answered && asked == 0 && ack);
		cover (asked && !bus_request && tries == 1);
		cover (follows && before == 3 && known == ANSWERED && replays && done == 1);
		cover (follows && before == 1 && known == AWAY && replays && \dut.with_pipeline_again [head]);
		cover (done == 6 && flight == 3 && bus_next && bus_done);
	end
endmodule
`else
module ul_wishbone_master_properties (
	input clk,
	input rst,
	input bus_request,
	input bus_write,
	input bus_lock,
	input bus_ahead,
	input [7:0] bus_address,
	input [7:0] bus_write_data,
	input [7:0] dat_i,
	input ack,
	input err,
	input rty,
	input stall
);
	wire [7:0] bus_read_data, adr, dat_o;
	wire bus_done, bus_error, bus_next, cyc, stb, we, sel;
	wire [2:0] open;

	ul_wishbone_master dut (.*);
	wishbone_b4 #(.MASTER(1), .SLAVE(2)) rules (.dat(dat_o), .*);

	(* hierconn *) wire \dut.classic_sent_away ;

	reg first = 1, was_reset = 0;
	reg asked = 0, answered = 0;
	reg [16:0] access;
	// In the last cycle: an access was pending at the slave, and whether it was answered by `rty`.
	reg pending = 0, away = 0;
	reg [2:0] done = 0, tries = 0;

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
		// Giving up an access ends its transaction.
		if (asked && !bus_request)
			assume (!bus_lock);

		pending <= cyc && bus_request && !bus_done && !(stb && rty);
		away <= bus_request && cyc && stb && rty && !bus_done;
		if (bus_done)
			done <= done + (done != 7);
		tries <= bus_request ? tries + (away && tries != 7) : 0;

		assert (bus_done == (cyc && bus_request && stb && (ack || err)));
		if (bus_done)
			assert (bus_error == err && bus_read_data == dat_i);
		if (stb)
			assert (bus_request && sel && {we, adr, dat_o} == {bus_write, bus_address, bus_write_data});
		if (bus_lock || (pending && bus_request))
			assert (cyc);
		if (away)
			assert (!stb && cyc == bus_lock);
		if (bus_request && !away)
			assert (cyc && stb);
		assert (!cyc || bus_lock || bus_request);
		assert (!bus_next);

		// Invariant that makes the proof hold without a bound.
		assert (away == \dut.classic_sent_away );
		cover (done == 2 && bus_done && tries == 3 && bus_lock);
		cover (done == 3 && answered && asked == 0 && ack);
		cover (asked && !bus_request && tries == 1);
	end
endmodule
`endif

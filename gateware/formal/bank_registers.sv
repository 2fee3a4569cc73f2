// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of a generated register bank (that of bank.ul), for a Wishbone master that follows the standard and any
// hardware signals. It follows Wishbone B4 as a slave. It accepts an access to a register at once, and one to a FIFO
// port within the allowed time, and answers exactly in the next cycle. All words read in a sample are from one instant,
// that of its strobe, and those of a value read in a block are from one instant. A value of several words changes as a
// whole. A FIFO port transfers a word exactly when an access is answered by it. A module's strobe is '0' for a cycle
// after its answer.
//
// PIPELINED: the master is pipelined. IN_A_ROW: the bank is generated for a pipelined master; otherwise, it stalls
// beside each strobe that it has not answered.

module bank_registers_properties #(
	parameter STREAM_WAIT = 3
) (
	input clk,
	input rst,
	input wb_cyc,
	input wb_stb,
	input wb_we,
	input [7:0] wb_adr,
	input [7:0] wb_dat_i,
	input sample_access,
	input [15:0] from_hardware_position,
	input [7:0] from_hardware_speed,
	input [7:0] from_hardware_log,
	input from_hardware_log_valid,
	input [7:0] elsewhere_dat_i,
	input elsewhere_ack,
	input elsewhere_err
);
	localparam POSITION = 0, SPEED = 2, GOAL = 4, FIELDS = 6, LOG = 7;

	wire [7:0] wb_dat_o;
	wire wb_ack, wb_err, wb_stall;
	wire [2:0] open;
	wire [15:0] to_hardware_goal;
	wire [3:0] to_hardware_low, to_hardware_high;
	wire to_hardware_goal_written, to_hardware_low_written, to_hardware_high_written, to_hardware_log_ready;

	wire elsewhere_cyc, elsewhere_stb, elsewhere_we;
	wire [7:0] elsewhere_adr, elsewhere_dat_o;

	bank_registers dut (.*);
`ifdef PIPELINED
	localparam PIPELINED = 1;
`else
	localparam PIPELINED = 0;
`endif
	wishbone_b4 #(.PIPELINED(PIPELINED), .MASTER(0), .SLAVE(1)) rules (
		.cyc(wb_cyc), .stb(wb_stb), .we(wb_we), .adr(wb_adr), .dat(wb_dat_i), .sel(1'b1),
		.ack(wb_ack), .err(wb_err), .rty(1'b0), .stall(wb_stall), .*
	);

	(* hierconn *) wire [1:0] \dut.waited ;
	(* hierconn *) wire [15:0] \dut.position_sampled , \dut.position_held ;
	(* hierconn *) wire [7:0] \dut.speed_sampled , \dut.goal_gathered ;
	(* hierconn *) wire \dut.position_kept , \dut.taken , \dut.elsewhere_stood , \dut.rests ;

	reg first = 1;
	// Values from hardware in the cycle before, or at the instant of the sample; and one cycle earlier.
	reg [15:0] position, older;
	reg [7:0] speed;
	// Value of the words in the block that is being read.
	reg in_block = 0;
	reg [15:0] of_block;
	// Expected answer to the access of the last cycle.
	reg read = 0, moved = 0, given = 0;
	reg [7:0] due;
	// Expected values of the outputs to hardware.
	reg [7:0] lower = 0;
	reg [15:0] goal = 0;
	reg written = 0;
	reg [2:0] lasts = 0;
	// An access was accepted in the last cycle, and in the one before.
	reg took = 0, took_before = 0;
	// stood: a module's answer was present in the last cycle. ended: it ended an access.
	reg stood = 0, ended = 0;

	// Counts the two cycles after the reset that the registers of the hardware inputs take: before, their values are
	// unknown and no access occurs.
	reg [1:0] settled = 0;

	wire moves = from_hardware_log_valid && to_hardware_log_ready;
`ifdef IN_A_ROW
	wire begins = wb_cyc && wb_stb;
	wire takes = begins && !wb_stall;
`else
	wire begins = wb_cyc && wb_stb && !wb_ack && !wb_err;
	wire takes = begins && \dut.taken ;
`endif
	wire is_known = wb_adr <= SPEED || (wb_adr >= GOAL && wb_adr <= LOG);
	wire is_position = wb_adr[7:1] == POSITION;
	wire reads_block = begins && !wb_we && is_position && !sample_access;
	wire [15:0] value = sample_access ? position : in_block ? of_block : older;

	always @(posedge clk) begin
		first <= 0;
		assume (rst == first);
		assume (!first || (!wb_cyc && !sample_access));
		lasts <= begins && is_known && !takes ? lasts + 1 : 0;
		took <= takes && !rst;
		took_before <= took;
		stood <= elsewhere_ack || elsewhere_err;
		ended <= !rst && elsewhere_stb && (elsewhere_ack || elsewhere_err) && !stood;
	end

	always @(posedge clk) if (!first) begin
		older <= position;
		if (!sample_access) begin
			position <= from_hardware_position;
			speed <= from_hardware_speed;
		end
		settled <= {settled[0], 1'b1};
		assume (settled[1] || (!wb_cyc && !sample_access));
		if (reads_block && !in_block)
			of_block <= older;
		in_block <= (wb_cyc || sample_access) && (in_block || reads_block);

		given <= begins && !wb_we && (is_position || wb_adr == SPEED);
		moved <= from_hardware_log_valid && to_hardware_log_ready;
		due <= moves ? from_hardware_log : wb_adr == SPEED ? speed : wb_adr[0] ? value[15:8] : value[7:0];
		if (given || moved)
			assert (wb_ack && wb_dat_o == due);
		assert (!to_hardware_log_ready || (begins && !wb_we && wb_adr == LOG));

		written <= begins && wb_we && wb_adr == GOAL + 1;
		if (begins && wb_we && wb_adr == GOAL)
			lower <= wb_dat_i;
		if (begins && wb_we && wb_adr == GOAL + 1)
			goal <= {wb_dat_i, lower};
		assert (to_hardware_goal == goal && to_hardware_goal_written == written);

		assert (lasts <= STREAM_WAIT);
		assert ((wb_ack || wb_err) == took);
		if (begins && is_known && wb_adr != LOG)
			assert (takes);
		if (moves)
			assert (takes);
		assert (!(ended && elsewhere_stb));
`ifdef PIPELINED
		// At most one access is open, and it is answered in this cycle.
`ifdef IN_A_ROW
		assert (open == took);
`else
		assert (open == 0);
`endif
`endif

		// Invariants that make the proof hold without a bound.
		assert (\dut.goal_gathered == lower);
		assert (in_block == \dut.position_kept );
		assert (settled[0] >= settled[1] && (settled[1] || (!in_block && !given)));
		if (settled[0])
			assert (position == \dut.position_sampled && speed == \dut.speed_sampled );
		if (settled[1])
			assert (\dut.position_held == (in_block ? of_block : older));
		if (begins && is_known)
			assert (lasts == \dut.waited );
		assert (first || (stood == \dut.elsewhere_stood && ended == \dut.rests ));

		cover (in_block && sample_access && given && position != of_block);
		cover (wb_err && took && $past(lasts) == STREAM_WAIT);
		cover (ended && wb_cyc && wb_stb && elsewhere_ack);
`ifdef IN_A_ROW
		cover (took && took_before && moved && $past(given));
`endif
		cover (moved && wb_ack && $past(lasts) == 2);
		cover (written && goal[15:8] != goal[7:0]);
	end
endmodule

# SPDX-License-Identifier: BSD-3-Clause
#
# ul_fifo_async in Vivado: read_xdc -ref ul_fifo_async ul_fifo_async.xdc, after the create_clock of both clocks (with
# PROCESSING_ORDER LATE if those are in a file of a project).
#
# Made by `make lists` from the VHDL. Unchecked: see README.md.
#
# The delays of the bits of a Gray pointer must differ by less than a cycle of the sending clock, and be below a cycle
# of the receiving clock. An entry is stable for more than a cycle before it is read.

set in_ns [get_property -min PERIOD [get_clocks -of_objects [get_ports in_clk]]]
set out_ns [get_property -min PERIOD [get_clocks -of_objects [get_ports out_clk]]]

set from [get_cells {write_gray_reg[*]}]
set to   [get_cells {write_crossing/meta_reg[*]}]
set_max_delay -datapath_only -from $from -to $to $out_ns
set_bus_skew -from $from -to $to $in_ns

set from [get_cells {read_gray_reg[*]}]
set to   [get_cells {read_crossing/meta_reg[*]}]
set_max_delay -datapath_only -from $from -to $to $in_ns
set_bus_skew -from $from -to $to $out_ns

# For a memory of LUTs: a block RAM is read by the receiving clock.
set_max_delay -quiet -datapath_only -from [get_clocks -of_objects [get_ports in_clk]] \
    -to [get_cells -quiet {out_data_reg[*]}] $out_ns

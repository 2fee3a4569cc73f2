# SPDX-License-Identifier: BSD-3-Clause
#
# ul_fifo_async in Vivado: read_xdc -ref ul_fifo_async ul_fifo_async.xdc. Unchecked: see README.md.
#
# The bits of a Gray pointer must differ by less than a cycle of the clock that makes them, and arrive within one of the
# clock that takes them. What is read has stood in the memory for more than a cycle of that clock.

set in_ns  [get_property -min PERIOD [get_clocks -of_objects [get_ports in_clk]]]
set out_ns [get_property -min PERIOD [get_clocks -of_objects [get_ports out_clk]]]

set_max_delay -datapath_only -from [get_cells {write_gray_reg[*]}] -to [get_cells {write_crossing/meta_reg[*]}] $out_ns
set_bus_skew -from [get_cells {write_gray_reg[*]}] -to [get_cells {write_crossing/meta_reg[*]}] $in_ns

set_max_delay -datapath_only -from [get_cells {read_gray_reg[*]}] -to [get_cells {read_crossing/meta_reg[*]}] $in_ns
set_bus_skew -from [get_cells {read_gray_reg[*]}] -to [get_cells {read_crossing/meta_reg[*]}] $out_ns

# Where the memory is one of LUTs: a block RAM reads by the clock that takes.
set_max_delay -quiet -datapath_only -from [get_clocks -of_objects [get_ports in_clk]] \
    -to [get_cells -quiet {out_data_reg[*]}] $out_ns

# SPDX-License-Identifier: BSD-3-Clause
#
# ul_ft245_sync in Vivado: read_xdc -ref ul_ft245_sync ul_ft245_sync.xdc. Unchecked: see README.md.
#
# Its FIFOs are in ul_fifo_async.xdc, its pins in ul_ft245_sync_pins.xdc. Each of these is one bit: any delay is right, a cycle
# of the clock that takes it keeps it short.

set clk_ns    [get_property -min PERIOD [get_clocks -of_objects [get_ports clk]]]
set clkout_ns [get_property -min PERIOD [get_clocks -of_objects [get_ports clkout]]]

set_max_delay -datapath_only -from [get_cells chip_up_reg] -to [get_cells {up_crossing/meta_reg[0]}] $clk_ns
set_max_delay -datapath_only -from [get_cells driving_reg] -to [get_cells {driving_crossing/meta_reg[0]}] $clk_ns
set_max_delay -datapath_only -from [get_cells {question_crossing/*_reg*}] \
    -to [get_cells {answer_crossing/meta_reg[0]}] $clk_ns
set_max_delay -datapath_only -from [get_cells asked_reg] -to [get_cells {question_crossing/meta_reg[0]}] $clkout_ns

# Resets begin at any instant; their end is timed, from the last register of their row on.
set_false_path -to [get_pins {chip_reset/meta_reg[*]/PRE chip_quiet/meta_reg[*]/PRE chip_quiet_data/meta_reg[*]/PRE}]

# SPDX-License-Identifier: BSD-3-Clause
#
# ul_ft245_sync in Vivado: read_xdc -ref ul_ft245_sync ul_ft245_sync.xdc
#
# Made by `make lists` from the VHDL. Unchecked: see README.md.
#
# Asynchronous inputs and single bits: any delay is right. A reset is asserted asynchronously; its end is timed from the
# last register of its synchroniser.

set_false_path -quiet -to [get_cells -quiet -hierarchical -filter {NAME =~ *up_crossing/meta_reg*}]
set_false_path -quiet -to [get_cells -quiet -hierarchical -filter {NAME =~ *question_crossing/meta_reg*}]
set_false_path -quiet -to [get_cells -quiet -hierarchical -filter {NAME =~ *answer_crossing/meta_reg*}]
set_false_path -quiet -to [get_cells -quiet -hierarchical -filter {NAME =~ *driving_crossing/meta_reg*}]
set_false_path -quiet -to [get_pins -quiet -hierarchical -filter {NAME =~ *chip_reset/meta_reg*/PRE}]
set_false_path -quiet -to [get_pins -quiet -hierarchical -filter {NAME =~ *chip_quiet/meta_reg*/PRE}]
set_false_path -quiet -to [get_pins -quiet -hierarchical -filter {NAME =~ *chip_quiet_data/meta_reg*/PRE}]

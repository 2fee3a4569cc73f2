# SPDX-License-Identifier: BSD-3-Clause
#
# ul_mac in Vivado: read_xdc -ref ul_mac ul_mac.xdc
#
# Made by `make lists` from the VHDL. Unchecked: see README.md.
#
# Asynchronous inputs and single bits: any delay is right. A reset is asserted asynchronously; its end is timed from the
# last register of its synchroniser.

set_false_path -quiet -to [get_cells -quiet -hierarchical -filter {NAME =~ *rx_up_crossing/meta_reg*}]
set_false_path -quiet -to [get_cells -quiet -hierarchical -filter {NAME =~ *tx_up_crossing/meta_reg*}]
set_false_path -quiet -to [get_cells -quiet -hierarchical -filter {NAME =~ *carrier_crossing/meta_reg*}]
set_false_path -quiet -to [get_pins -quiet -hierarchical -filter {NAME =~ *rx_reset/meta_reg*/PRE}]
set_false_path -quiet -to [get_pins -quiet -hierarchical -filter {NAME =~ *tx_reset/meta_reg*/PRE}]

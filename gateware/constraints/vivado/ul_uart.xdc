# SPDX-License-Identifier: BSD-3-Clause
#
# ul_uart in Vivado: read_xdc -ref ul_uart ul_uart.xdc
#
# Made by `make lists` from the VHDL. Unchecked: see README.md.
#
# Asynchronous inputs and single bits: any delay is right. A reset is asserted asynchronously; its end is timed from the
# last register of its synchroniser.

set_false_path -quiet -to [get_cells -quiet -hierarchical -filter {NAME =~ *rx_crossing/meta_reg*}]
set_false_path -quiet -to [get_cells -quiet -hierarchical -filter {NAME =~ *cts_crossing/meta_reg*}]

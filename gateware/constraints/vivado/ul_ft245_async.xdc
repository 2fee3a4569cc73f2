# SPDX-License-Identifier: BSD-3-Clause
#
# ul_ft245_async in Vivado: read_xdc -ref ul_ft245_async ul_ft245_async.xdc
#
# Made by `make lists` from the VHDL. Unchecked: see README.md.
#
# Asynchronous inputs and single bits: any delay is right. A reset is asserted asynchronously; its end is timed from the
# last register of its synchroniser.

set_false_path -quiet -to [get_cells -quiet -hierarchical -filter {NAME =~ *receive_flag/*}]
set_false_path -quiet -to [get_cells -quiet -hierarchical -filter {NAME =~ *transmit_flag/*}]

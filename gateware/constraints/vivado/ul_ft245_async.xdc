# SPDX-License-Identifier: BSD-3-Clause
#
# ul_ft245_async in Vivado: read_xdc -ref ul_ft245_async ul_ft245_async.xdc. Unchecked: see README.md.
#
# Its pins have no clock: the intervals are counted in cycles of clk, and `skew_ns` is what two pins may differ by. The
# registers behind RXF# and TXE# are the first of two.

set_false_path -to [get_cells {pins/receive_flag/pad_register pins/transmit_flag/pad_register}]

# SPDX-License-Identifier: BSD-3-Clause
#
# The pins of a synchronous FT245 in Vivado: read_xdc ft245_sync_pins.xdc, for the top. Unchecked: see README.md.
#
# FT232H (FT_000288, table 4.1): its outputs change from 0 to 9 ns after CLKOUT, its inputs are taken 7.5 ns after they
# are there and held for 0. FT2232H: outputs from 1 to 7.15 ns, setup 8 ns.

set ft_output_min 0
set ft_output_max 9
set ft_setup 7.5
set ft_hold 0

create_clock -name ft_clkout -period 16.667 [get_ports ft_clkout]

set from_chip [get_ports {ft_rxf_n ft_txe_n ft_data[*]}]
set to_chip   [get_ports {ft_rd_n ft_wr_n ft_oe_n ft_siwu_n ft_data[*]}]

set_input_delay  -clock ft_clkout -max $ft_output_max $from_chip
set_input_delay  -clock ft_clkout -min $ft_output_min $from_chip
set_output_delay -clock ft_clkout -max $ft_setup $to_chip
set_output_delay -clock ft_clkout -min [expr -$ft_hold] $to_chip

# Of gateware/pads/xilinx; the attribute IOB asks for it already.
set_property IOB TRUE $from_chip
set_property IOB TRUE $to_chip

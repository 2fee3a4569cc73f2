# SPDX-License-Identifier: BSD-3-Clause
#
# The pins of a synchronous FT245 in Vivado: read_xdc ul_ft245_sync_pins.xdc, for the top, with ports named as those of
# unity_link.
#
# Made by `make lists` from the VHDL. Unchecked: see README.md.
#
# FT232H, table 4.1 of FT_000288: outputs from 0 to 9 ns after CLKOUT, setup 7.5 ns, hold 0. FT2232H: outputs from 1 to
# 7.15 ns, setup 8 ns.

create_clock -name ft_clkout -period 16.667 [get_ports {ft_clkout}]

set_input_delay -clock ft_clkout -max 9 [get_ports {ft_rxf_n ft_txe_n ft_data[*]}]
set_input_delay -clock ft_clkout -min 0 [get_ports {ft_rxf_n ft_txe_n ft_data[*]}]
set_output_delay -clock ft_clkout -max 7.5 [get_ports {ft_rd_n ft_wr_n ft_oe_n ft_siwu_n ft_data[*]}]
set_output_delay -clock ft_clkout -min 0 [get_ports {ft_rd_n ft_wr_n ft_oe_n ft_siwu_n ft_data[*]}]

# gateware/pads/xilinx has the attribute IOB already.
set_property IOB TRUE [get_ports {ft_rxf_n ft_txe_n ft_data[*]}]
set_property IOB TRUE [get_ports {ft_rd_n ft_wr_n ft_oe_n ft_siwu_n ft_data[*]}]

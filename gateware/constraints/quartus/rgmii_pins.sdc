# SPDX-License-Identifier: BSD-3-Clause
#
# The pins of a PHY by RGMII in Quartus, for the top, with ports named as those of unity_link.
#
# Made by `make lists` from the VHDL. Unchecked: see README.md.
#
# RGMII 2.0 at 100 Mb/s, with the delay of RXC on in the PHY (RGMII-ID) or in the board's wires: inputs change 1.0 to
# 2.6 ns before each edge of RXC, of 20 ns between edges (TskewR). TXC leaves 10 ns after the data, so the PHY may delay
# it or not: setup 1.0 ns (TsetupR), and hold 1.0 ns (TholdR) after a delay of 2.6 ns at most.
#
# clk is the clock of 50 MHz at phy_tx_clk of unity_link. If a PLL generates it, put the output of the PLL in its place.

create_clock -name phy_rx_clk -period 40 [get_ports {phy_rx_clk}]
create_generated_clock -name phy_txc -source [get_ports {clk}] -divide_by 2 [get_ports {phy_txc}]

set_input_delay -clock phy_rx_clk -max 19 [get_ports {phy_rxd[*] phy_rx_dv}]
set_input_delay -clock phy_rx_clk -min 17.4 [get_ports {phy_rxd[*] phy_rx_dv}]
set_input_delay -clock phy_rx_clk -clock_fall -add_delay -max 19 [get_ports {phy_rxd[*] phy_rx_dv}]
set_input_delay -clock phy_rx_clk -clock_fall -add_delay -min 17.4 [get_ports {phy_rxd[*] phy_rx_dv}]
set_output_delay -clock phy_txc -max 1 [get_ports {phy_txd[*] phy_tx_en}]
set_output_delay -clock phy_txc -min -3.6 [get_ports {phy_txd[*] phy_tx_en}]
set_output_delay -clock phy_txc -clock_fall -add_delay -max 1 [get_ports {phy_txd[*] phy_tx_en}]
set_output_delay -clock phy_txc -clock_fall -add_delay -min -3.6 [get_ports {phy_txd[*] phy_tx_en}]

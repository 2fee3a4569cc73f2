# SPDX-License-Identifier: BSD-3-Clause
#
# The pins of a PHY by MII in Vivado: read_xdc ul_mac_mii_pins.xdc, for the top, with ports named as those of
# unity_link.
#
# Made by `make lists` from the VHDL. Unchecked: see README.md.
#
# IEEE 802.3, 22.3: RXD, RX_DV and RX_ER stand 10 ns before and after RX_CLK, of 40 ns; TXD and TX_EN change 0 to 25 ns
# after TX_CLK.

create_clock -name phy_rx_clk -period 40 [get_ports {phy_rx_clk}]
create_clock -name phy_tx_clk -period 40 [get_ports {phy_tx_clk}]

set_input_delay -clock phy_rx_clk -max 30 [get_ports {phy_rxd[*] phy_rx_dv phy_rx_er}]
set_input_delay -clock phy_rx_clk -min 10 [get_ports {phy_rxd[*] phy_rx_dv phy_rx_er}]
set_output_delay -clock phy_tx_clk -max 15 [get_ports {phy_txd[*] phy_tx_en}]
set_output_delay -clock phy_tx_clk -min 0 [get_ports {phy_txd[*] phy_tx_en}]

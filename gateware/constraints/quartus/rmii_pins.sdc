# SPDX-License-Identifier: BSD-3-Clause
#
# The pins of a PHY by RMII in Quartus, for the top, with ports named as those of unity_link; phy_clk is REF_CLK, which
# both phy_rx_clk and phy_tx_clk are connected to.
#
# Made by `make lists` from the VHDL. Unchecked: see README.md.
#
# RMII specification, revision 1.2: setup 4 ns and hold 2 ns at either side. Outputs of a PHY from 2 to 14 ns after
# REF_CLK, as in the datasheets of DP83848 and LAN8720A. CRS_DV comes up at any instant, and its register is one of a
# crossing. A design with phy_rx_er adds it to the inputs.

create_clock -name phy_clk -period 20 [get_ports {phy_clk}]

set_input_delay -clock phy_clk -max 14 [get_ports {phy_rxd[*] phy_rx_dv}]
set_input_delay -clock phy_clk -min 2 [get_ports {phy_rxd[*] phy_rx_dv}]
set_output_delay -clock phy_clk -max 4 [get_ports {phy_txd[*] phy_tx_en}]
set_output_delay -clock phy_clk -min -2 [get_ports {phy_txd[*] phy_tx_en}]

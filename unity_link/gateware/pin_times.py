"""Timing at the pins of chips that share a clock with the FPGA: an FT245, and Ethernet PHYs.

The constraints for vendors' tools (`gateware/tools/constraints.py`) and the report of `unity-link build` use these
figures. At 100 Mb/s the clock of RGMII has 25 MHz, and the data are the same at both of its edges.
"""

from __future__ import annotations

from typing import NamedTuple


class ChipPins(NamedTuple):
    """Pins that belong to one clock, by their names in the entity `unity_link` and in generated designs."""

    clock: str
    """Pin of the clock."""
    period_ns: float
    from_chip: tuple[str, ...] = ()
    """Inputs of the FPGA; `[*]` follows the name of a vector."""
    arrival_ns: tuple[float, float] = (0, 0)
    """Shortest and longest time from a clock edge to a change of an input."""
    to_chip: tuple[str, ...] = ()
    """Outputs of the FPGA."""
    setup_ns: float = 0
    """Time before a clock edge during which outputs must be stable."""
    hold_ns: float = 0
    """Time after a clock edge during which outputs must be stable."""
    both_edges: bool = False
    """True if data belong to both edges of the clock."""
    is_made: bool = False
    """True if the FPGA makes the clock, by halving another one."""

    @property
    def interval_ns(self) -> float:
        """Time between two clock edges that data belong to, in ns."""
        return self.period_ns / 2 if self.both_edges else self.period_ns


_TXD, _RXD = ("phy_txd[*]", "phy_tx_en"), ("phy_rxd[*]", "phy_rx_dv")
PIN_TIMES: dict[str, tuple[ChipPins, ...]] = {
    "ft245_sync": (
        ChipPins(
            "ft_clkout",
            16.667,
            ("ft_rxf_n", "ft_txe_n", "ft_data[*]"),
            (0, 9),
            ("ft_rd_n", "ft_wr_n", "ft_oe_n", "ft_siwu_n", "ft_data[*]"),
            setup_ns=7.5,
            hold_ns=0,
        ),
    ),
    "rmii": (ChipPins("phy_clk", 20, _RXD, (2, 14), _TXD, setup_ns=4, hold_ns=2),),
    "mii": (
        ChipPins("phy_rx_clk", 40, (*_RXD, "phy_rx_er"), (10, 30)),
        ChipPins("phy_tx_clk", 40, to_chip=_TXD, setup_ns=15, hold_ns=0),
    ),
    "rgmii": (
        ChipPins("phy_rx_clk", 40, _RXD, (17.4, 19), both_edges=True),
        ChipPins("phy_txc", 40, to_chip=_TXD, setup_ns=1, hold_ns=3.6, both_edges=True, is_made=True),
    ),
}
"""Timing of the pins of each medium."""
SOURCES = {
    "ft245_sync": (
        "FT232H, table 4.1 of FT_000288: outputs from 0 to 9 ns after CLKOUT, setup 7.5 ns, hold 0. FT2232H: outputs "
        "from 1 to 7.15 ns, setup 8 ns."
    ),
    "rmii": (
        "RMII specification, revision 1.2: setup 4 ns and hold 2 ns at either side. Outputs of a PHY from 2 to 14 ns "
        "after REF_CLK, as in the datasheets of DP83848 and LAN8720A. CRS_DV comes up at any instant, and its register "
        "is one of a crossing. A design with phy_rx_er adds it to the inputs."
    ),
    "mii": (
        "IEEE 802.3, 22.3: RXD, RX_DV and RX_ER stand 10 ns before and after RX_CLK, of 40 ns; TXD and TX_EN change "
        "0 to 25 ns after TX_CLK."
    ),
    "rgmii": (
        "RGMII 2.0 at 100 Mb/s, with the delay of RXC on in the PHY (RGMII-ID) or in the board's wires: inputs change "
        "1.0 to 2.6 ns before each edge of RXC, of 20 ns between edges (TskewR). TXC leaves 10 ns after the data, so "
        "the PHY may delay it or not: setup 1.0 ns (TsetupR), and hold 1.0 ns (TholdR) after a delay of 2.6 ns at most."
    ),
}
"""Source of the figures of each medium, as a text for reports."""

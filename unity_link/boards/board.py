"""The description of a board: its FPGA, its clock, the medium of its link, and the pins of both."""

from __future__ import annotations

from typing import Literal

import msgspec

_DATA_PINS = tuple(f"ft_data[{bit}]" for bit in range(8))
_CHAIN = {"chain_clk": "output", "chain_load_n": "output", "chain_out": "output", "chain_in": "input"}
_FT245 = {
    **dict.fromkeys(_DATA_PINS, "inout"),
    "ft_rxf_n": "input",
    "ft_txe_n": "input",
    "ft_rd_n": "output",
    "ft_wr_n": "output",
    "ft_siwu_n": "output",
}
PINS = {
    "uart": {"clk": "input", "uart_rxd": "input", "uart_txd": "output", **_CHAIN},
    "ft245": {"clk": "input", **_FT245, **_CHAIN},
    "ft245_sync": {"clk": "input", "ft_clkout": "input", **_FT245, "ft_oe_n": "output", **_CHAIN},
}
"""The pins of a whole generated design, as `generate vhdl` makes it for each medium, and their directions."""
FT_CLKOUT_HZ = 60_000_000


class BoardClock(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The clock of a board."""

    hz: int
    """At the pin."""
    core_hz: int | None = None
    """Core clock in Hz that a PLL makes of the board's; None for no PLL."""


class Board(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A board, as its file says it."""

    title: str
    family: Literal["ice40", "ecp5", "gowin", "gatemate", "artix7", "cyclonev"]
    device: str
    """Device as the family's nextpnr calls it; the whole part number where the vendor's tool places."""
    package: str
    """Package as the family's nextpnr calls it; for Gowin the whole part number."""
    speed: int = 6
    """Speed grade of an ECP5."""
    medium: Literal["uart", "ft245", "ft245_sync"]
    baud: int | None = None
    """Baud rate of a UART."""
    io_type: str = "LVCMOS33"
    programmer: tuple[str, ...] = ()
    """Options of openFPGALoader."""
    clock: BoardClock
    pins: dict[str, str]
    """The site of each pin of `PINS`."""

    @property
    def core_hz(self) -> int:
        """The frequency that the gateway runs at."""
        return self.clock.core_hz or self.clock.hz

    @property
    def clocks(self) -> dict[str, int]:
        """The frequencies that come in at pins."""
        other = {"ft_clkout": FT_CLKOUT_HZ} if self.medium == "ft245_sync" else {}
        return {"clk": self.clock.hz, **other}

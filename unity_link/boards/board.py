"""The description of a board: its FPGA, its clock, the medium of its link, and the pins of both."""

from __future__ import annotations

from typing import Literal, NamedTuple

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
_IDLE_HIGH = ("uart_rxd", "ft_rxf_n", "ft_txe_n")
"""Inputs that are pulled up, so that one without a wire says nothing."""

Pull = Literal["up", "down", "none"]


class Pin(NamedTuple):
    """A pin of a design on a board."""

    site: str
    pull: Pull
    io_type: str


class BoardClock(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The clock of a board."""

    hz: int
    """At the pin."""
    core_hz: int | None = None
    """Core clock in Hz that a PLL makes of the board's; None for no PLL."""


class Io(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """An LED, a button or a pin of a header, or a row of them, beside what a generated design needs."""

    site: str | None = None
    """Place of one pin."""
    sites: tuple[str, ...] = ()
    """Places of pins that are counted."""
    first: int = 0
    """Number of the first of `sites`."""
    pull: Pull = "none"
    io_type: str | None = None
    """None: that of the board."""
    about: str = ""
    """Words of the board's own for it."""

    def named(self, name: str) -> dict[str, str]:
        """Return the site of each pin, by its name: `led` or, counted, `led0`, `led1`, ...; `pmod2_0` of `pmod2`."""
        if self.site is not None:
            return {name: self.site}
        return {bit_name(name, number): site for number, site in enumerate(self.sites, self.first)}


def bit_name(name: str, number: int) -> str:
    """Return the name of one of counted pins."""
    return f"{name}{'_' if name[-1].isdigit() else ''}{number}"


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
    io: dict[str, Io] = {}
    """LEDs, buttons and headers by name, for designs of a user's own."""

    @property
    def core_hz(self) -> int:
        """The frequency that the gateway runs at."""
        return self.clock.core_hz or self.clock.hz

    @property
    def clocks(self) -> dict[str, int]:
        """The frequencies that come in at pins."""
        other = {"ft_clkout": FT_CLKOUT_HZ} if self.medium == "ft245_sync" else {}
        return {"clk": self.clock.hz, **other}

    @property
    def generics(self) -> dict[str, int]:
        """Values of the generics of a whole design."""
        return {"clock_hz": self.core_hz} | ({"baud": self.baud} if self.medium == "uart" and self.baud else {})

    @property
    def medium_pins(self) -> dict[str, Pin]:
        """The pins of a whole generated design."""
        pulls: dict[str, Pull] = dict.fromkeys(_IDLE_HIGH, "up")
        # An iCE40 has none that pull down, and the end of a chain is not left to itself.
        pulls["chain_in"] = "up" if self.family == "ice40" else "down"
        return {pin: Pin(site, pulls.get(pin, "none"), self.io_type) for pin, site in self.pins.items()}

    @property
    def io_pins(self) -> dict[str, Pin]:
        """The pins of `io`, each by its name."""
        return {
            pin: Pin(site, io.pull, io.io_type or self.io_type)
            for name, io in self.io.items()
            for pin, site in io.named(name).items()
        }

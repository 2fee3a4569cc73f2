"""The description of a board: its FPGA, its clock, the medium of its link, and their pins."""

from __future__ import annotations

from typing import Literal, NamedTuple

import msgspec

from unity_link.protocol.wire.discovery import parse_ip, parse_mac

_DATA_PINS = tuple(f"ft_data[{bit}]" for bit in range(8))
CHAIN = {"chain_clk": "output", "chain_load_n": "output", "chain_out": "output", "chain_in": "input"}
"""Pins of a chain of shift registers, with their directions; optional in a board file."""
_FT245 = {
    **dict.fromkeys(_DATA_PINS, "inout"),
    "ft_rxf_n": "input",
    "ft_txe_n": "input",
    "ft_rd_n": "output",
    "ft_wr_n": "output",
    "ft_siwu_n": "output",
}


def _row(name: str, count: int, way: str) -> dict[str, str]:
    return {f"{name}[{bit}]": way for bit in range(count)}


_PHY_OF_FOUR = {
    "phy_rx_clk": "input",
    **_row("phy_rxd", 4, "input"),
    "phy_rx_dv": "input",
    **_row("phy_txd", 4, "output"),
    "phy_tx_en": "output",
    "phy_rst_n": "output",
}
PINS = {
    "uart": {"clk": "input", "uart_rxd": "input", "uart_txd": "output", **CHAIN},
    "ft245": {"clk": "input", **_FT245, **CHAIN},
    "ft245_sync": {"clk": "input", "ft_clkout": "input", **_FT245, "ft_oe_n": "output", **CHAIN},
    "rmii": {
        "clk": "input",
        "phy_clk": "input",
        **_row("phy_rxd", 2, "input"),
        "phy_rx_dv": "input",
        **_row("phy_txd", 2, "output"),
        "phy_tx_en": "output",
        **CHAIN,
    },
    "mii": {
        "clk": "input",
        "phy_clk_25": "output",
        "phy_tx_clk": "input",
        "phy_rx_er": "input",
        **_PHY_OF_FOUR,
        **CHAIN,
    },
    "rgmii": {"clk": "input", **_PHY_OF_FOUR, "phy_txc": "output", **CHAIN},
    "w5500": {
        "clk": "input",
        "spi_sck": "output",
        "spi_cs_n": "output",
        "spi_mosi": "output",
        "spi_miso": "input",
        "spi_rst_n": "output",
        **CHAIN,
    },
}
"""Pins of a whole generated design (`generate vhdl`) for each medium, with their directions."""
CLOCKS = {
    "ft245_sync": {"ft_clkout": 60_000_000},
    "rmii": {"phy_clk": 50_000_000},
    "mii": {"phy_rx_clk": 25_000_000, "phy_tx_clk": 25_000_000},
    "rgmii": {"phy_rx_clk": 25_000_000},
}
"""Clocks that external chips feed into pins, for each medium: frequency in Hz by pin."""
_IDLE_HIGH = ("uart_rxd", "ft_rxf_n", "ft_txe_n")
"""Inputs with a pull-up resistor, so that an unconnected one is inactive."""

Pull = Literal["up", "down", "none"]


class Pin(NamedTuple):
    """A pin of a design on a board."""

    site: str
    pull: Pull
    io_type: str


class BoardClock(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The clock of a board."""

    hz: int
    """Frequency at the pin, in Hz."""
    core_hz: int | None = None
    """Core clock in Hz that a PLL makes from the board's clock; None for no PLL."""


class Io(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """An LED, a button or a header pin, or a numbered row of these, that the link does not use."""

    site: str | None = None
    """Site of a single pin."""
    sites: tuple[str, ...] = ()
    """Sites of numbered pins."""
    first: int = 0
    """Number of the first of `sites`."""
    pull: Pull = "none"
    io_type: str | None = None
    """I/O standard; None for that of the board."""
    about: str = ""
    """Label on the board or in its manual."""

    def named(self, name: str) -> dict[str, str]:
        """Return the site of each pin, by its name: `led` or, counted, `led0`, `led1`, ...; `pmod2_0` of `pmod2`."""
        if self.site is not None:
            return {name: self.site}
        return {bit_name(name, number): site for number, site in enumerate(self.sites, self.first)}


def bit_name(name: str, number: int) -> str:
    """Return the name of a numbered pin."""
    return f"{name}{'_' if name[-1].isdigit() else ''}{number}"


class Board(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A board, as its file describes it."""

    title: str
    family: Literal["ice40", "ecp5", "gowin", "gatemate", "artix7", "cyclonev"]
    device: str
    """Device, as the family's nextpnr names it; the full part number if the vendor's tool places the design."""
    package: str
    """Package, as the family's nextpnr names it; for Gowin the full part number."""
    speed: int = 6
    """Speed grade of an ECP5."""
    medium: Literal["uart", "ft245", "ft245_sync", "rmii", "mii", "rgmii", "w5500"]
    baud: int | None = None
    """Baud rate of a UART."""
    mac: str | None = None
    """MAC address of the Ethernet port, as 02:55:4c:00:00:01; None for the default of the entity `unity_link`."""
    ip: str | None = None
    """IP address of the Ethernet port, as 192.168.1.100; None for the default of the entity `unity_link`."""
    io_type: str = "LVCMOS33"
    programmer: tuple[str, ...] = ()
    """Options of openFPGALoader."""
    clock: BoardClock
    pins: dict[str, str]
    """The site of each pin of `PINS`."""
    io: dict[str, Io] = {}
    """LEDs, buttons and headers by name, for users' designs."""

    @property
    def core_hz(self) -> int:
        """Clock frequency of the gateway, in Hz."""
        return self.clock.core_hz or self.clock.hz

    @property
    def clocks(self) -> dict[str, int]:
        """Frequency in Hz of each clock pin."""
        return {"clk": self.clock.hz, **CLOCKS.get(self.medium, {})}

    @property
    def generics(self) -> dict[str, int | str]:
        """Values of the generics of a whole design: numbers, and vectors as strings of bits."""
        found: dict[str, int | str] = {"clock_hz": self.core_hz}
        if self.medium == "uart" and self.baud:
            found["baud"] = self.baud
        if self.mac is not None:
            found["mac_address"] = _bits(parse_mac(self.mac))
        if self.ip is not None:
            found["ip_address"] = _bits(parse_ip(self.ip))
        return found

    @property
    def has_pads(self) -> bool:
        """True if the pins use registers in the vendor's pads, as those of an FT245 do."""
        return self.medium.startswith("ft245")

    @property
    def medium_pins(self) -> dict[str, Pin]:
        """Pins of a whole generated design."""
        pulls: dict[str, Pull] = dict.fromkeys(_IDLE_HIGH, "up")
        # The end of a chain must not float; an iCE40 has no pull-down resistors.
        pulls["chain_in"] = "up" if self.family == "ice40" else "down"
        return {pin: Pin(site, pulls.get(pin, "none"), self.io_type) for pin, site in self.pins.items()}

    @property
    def io_pins(self) -> dict[str, Pin]:
        """Pins of `io` by name."""
        return {
            pin: Pin(site, io.pull, io.io_type or self.io_type)
            for name, io in self.io.items()
            for pin, site in io.named(name).items()
        }


def _bits(octets: bytes) -> str:
    return f"{int.from_bytes(octets, 'big'):0{8 * len(octets)}b}"

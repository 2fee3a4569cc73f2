"""The description of a board: its FPGA, its clock, the medium of its link, and the pins of both."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Literal

import msgspec

from unity_link.boards.checking import misuse, name_fault, spelling_fault
from unity_link.errors import ArgumentError, did_you_mean

_DATA = Path(__file__).with_name("data")
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


def board_names() -> list[str]:
    """Return the names of the boards that are known."""
    return sorted(path.stem for path in _DATA.glob("*.toml"))


def load_board(name: str) -> tuple[str, Board]:
    """Return the name of a board and what it is.

    Args:
        name: of a known board, or the path of a file that describes one: ``boards/mine.toml``.

    Raises:
        ArgumentError: where there is none, or its file does not describe a board.
    """
    given = Path(name)
    path = given if given.suffix == ".toml" or given.name != name else _DATA / f"{name}.toml"
    try:
        data = tomllib.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        known, hint = ", ".join(board_names()), did_you_mean(name, board_names())
        raise ArgumentError(
            f"there is no board {name}: one of {known} was expected, or a file NAME.toml"
            + (f"; {hint}" if hint else "")
        ) from None
    except OSError as error:
        raise ArgumentError(f"{path} cannot be read: {error.strerror}") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError, RecursionError) as error:
        raise ArgumentError(f"{path} describes no board: {error}") from None
    if fault := name_fault(path.stem) or misuse(data, Board):
        raise ArgumentError(f"{path} describes no board: {fault}")
    board = msgspec.convert(data, Board)
    if fault := spelling_fault(board) or _fault(board):
        raise ArgumentError(f"{path} describes no board: {fault}")
    return path.stem, board


def _fault(board: Board) -> str:
    """Return what is wrong with a board, or nothing."""
    needed = PINS[board.medium]
    faults = [f"the pin {pin} has no site" for pin in needed if pin not in board.pins]
    faults += [f"{pin} is no pin of {board.medium}" for pin in board.pins if pin not in needed]
    sites = list(board.pins.values())
    faults += [f"the site {site} belongs to two pins" for site in sites if sites.count(site) > 1]
    if min(board.clock.hz, board.core_hz) <= 0:
        faults.append("a clock has more than 0 Hz")
    if board.medium == "uart" and board.baud is None:
        faults.append("a uart needs baud")
    elif board.baud is not None and not 0 < 4 * board.baud <= board.core_hz:
        faults.append(f"baud = {board.baud}, and the most of a clock of {board.core_hz} Hz is {board.core_hz // 4}")
    return faults[0] if faults else ""

"""Loads boards by name, or from a user's file."""

from __future__ import annotations

import tomllib
from pathlib import Path

import msgspec

from unity_link.boards.board import CHAIN, PINS, Board
from unity_link.boards.checking import io_fault, misuse, name_fault, shown, spelling_fault
from unity_link.errors import ArgumentError, did_you_mean
from unity_link.gateware.limits import ETHERNET
from unity_link.protocol.wire.discovery import parse_ip, parse_mac

_DATA = Path(__file__).with_name("data")
_LEAST_HZ, _STEP_HZ = 25_000_000, 50_000_000


def board_names() -> list[str]:
    """Return the names of the boards that come with the package, sorted."""
    return sorted(path.stem for path in _DATA.glob("*.toml"))


def load_board(name: str) -> tuple[str, Board]:
    """Return the name and the description of a board.

    Args:
        name: name of a known board, or path of a file that describes one, such as ``boards/mine.toml``.

    Raises:
        ArgumentError: if there is no such board, or the file does not describe a board.
    """
    given = Path(name)
    path = given if given.suffix == ".toml" or given.name != name else _DATA / f"{name}.toml"
    try:
        data = _read(path)
    except FileNotFoundError:
        known, hint = ", ".join(board_names()), did_you_mean(name, board_names())
        raise ArgumentError(
            f"there is no board {name}: one of {known} was expected, or a file NAME.toml"
            + (f"; {hint}" if hint else "")
        ) from None
    except OSError as error:
        raise ArgumentError(f"{path} cannot be read: {error.strerror}") from None
    except RecursionError:
        raise ArgumentError(f"{path} describes no board: it is nested too deeply") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ArgumentError(f"{path} describes no board: {error}") from None
    if fault := name_fault(path.stem) or _fault_of_io(data) or misuse(data, Board):
        raise ArgumentError(f"{path} describes no board: {fault}")
    board = msgspec.convert(data, Board)
    if fault := spelling_fault(board) or io_fault(board) or _fault(board):
        raise ArgumentError(f"{path} describes no board: {fault}")
    return path.stem, board


def _read(path: Path) -> dict[str, object]:
    return tomllib.loads(path.read_text(encoding="utf-8"))


def _fault_of_io(data: dict[str, object]) -> str:
    """Replace the short forms of `io` in `data` by tables; return a sentence about a fault, or an empty string."""
    io = data.get("io")
    while isinstance(io, str):
        if io not in board_names():
            hint = did_you_mean(io, board_names())
            return f"io is {shown(io)}, a table or the name of a board was expected" + (f"; {hint}" if hint else "")
        io = _read(_DATA / f"{io}.toml")["io"]
    if not isinstance(io, dict | None):
        return f"io is {shown(io)}, a table or the name of a board was expected"
    if io is not None:
        data["io"] = {name: _long_form(one) for name, one in io.items()}
    return ""


def _long_form(io: object) -> object:
    if isinstance(io, str):
        return {"site": io}
    return {"sites": io} if isinstance(io, list) else io


def _fault(board: Board) -> str:
    """Return a sentence about the first fault of a board, or an empty string."""
    needed = PINS[board.medium]
    has_chain = not CHAIN.keys().isdisjoint(board.pins)
    faults = [
        f"the pin {pin} has no site" for pin in needed if pin not in board.pins and (has_chain or pin not in CHAIN)
    ]
    faults += [f"{pin} is no pin of {board.medium}" for pin in board.pins if pin not in needed]
    sites = list(board.pins.values())
    faults += [f"the site {site} belongs to two pins" for site in sites if sites.count(site) > 1]
    if min(board.clock.hz, board.core_hz) <= 0:
        faults.append("a clock has more than 0 Hz")
    if board.medium in ETHERNET:
        faults += _faults_of_ethernet(board)
    elif board.mac is not None or board.ip is not None:
        faults.append(f"mac and ip are of an Ethernet port, and medium is {board.medium!r}")
    if board.medium == "uart" and board.baud is None:
        faults.append("a uart needs baud")
    elif board.baud is not None and not 0 < 4 * board.baud <= board.core_hz:
        faults.append(f"baud = {board.baud}, and the most of a clock of {board.core_hz} Hz is {board.core_hz // 4}")
    return faults[0] if faults else ""


def _faults_of_ethernet(board: Board) -> list[str]:
    """Return a sentence for each fault of the clock and the addresses of a board with an Ethernet port."""
    faults = []
    if board.core_hz < _LEAST_HZ:
        faults.append(f"the core's clock is {board.core_hz} Hz, and an Ethernet port needs {_LEAST_HZ} at least")
    if board.medium == "rgmii" and board.core_hz != _STEP_HZ:
        faults.append(f"the core's clock is {board.core_hz} Hz, and rgmii makes TXC of one of {_STEP_HZ}")
    if board.medium == "mii" and board.core_hz % _STEP_HZ:
        faults.append(f"the core's clock is {board.core_hz} Hz, and mii makes phy_clk_25 of a multiple of {_STEP_HZ}")
    for parse, text in ((parse_mac, board.mac), (parse_ip, board.ip)):
        try:
            if text is not None:
                parse(text)
        except ArgumentError as error:
            faults.append(str(error))
    return faults

"""The pins of a board that the ports of a user's top are."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.boards.board import PINS, bit_name
from unity_link.errors import ArgumentError, did_you_mean

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.boards.board import Board, Pin
    from unity_link.gateware.own_vhdl import Port

READY = "clk_ready"
"""Port that is no pin: a PLL's lock."""
_CHAIN = "chain_"


def pins_of(top: str, ports: tuple[Port, ...], board_name: str, board: Board) -> dict[str, Pin]:
    """Return the pin of each port, or of each bit of one, as ``led[3]``.

    Args:
        top: name of the entity.
        ports: of the entity.
        board_name: what messages call the board.
        board: that has the pins.

    Raises:
        ArgumentError: where a port is no pin of the board, or of another width or direction; where two ports are one
            pin; or where a pin of the medium has no port.
    """
    ways = {pin: way for pin, way in PINS[board.medium].items() if not pin.startswith(_CHAIN)}
    taken: dict[str, str] = {}
    pins: dict[str, Pin] = {}
    for port in ports:
        if port.name == READY:
            _check(port, "input", 0, f"{top}: ")
            continue
        if port.name in {pin.partition("[")[0] for pin in ways}:
            found = _of_medium(top, port, ways, board)
        else:
            found = dict(_of_io(top, port, board_name, board))
        for name, pin in found.items():
            if pin.site in taken:
                raise ArgumentError(f"{top} has {taken[pin.site]} and {name} at one pin of {board_name}, {pin.site}")
            taken[pin.site] = name
        pins |= found
    lacking = [pin for pin in ways if pin not in pins]
    if lacking:
        raise ArgumentError(
            f"{top} has no port {lacking[0].partition('[')[0]}, which {board_name} needs: its clock and its link are "
            f"{', '.join(dict.fromkeys(pin.partition('[')[0] for pin in ways))}"
        )
    return pins


def _of_medium(top: str, port: Port, ways: dict[str, str], board: Board) -> dict[str, Pin]:
    names = [pin for pin in ways if pin.partition("[")[0] == port.name]
    _check(port, ways[names[0]], len(names) if "[" in names[0] else 0, f"{top}: ")
    return {name: board.medium_pins[name] for name in names}


def _check(port: Port, way: str, width: int, before: str) -> None:
    """Refuse a port of another direction or width."""
    words = {"input": "in", "output": "out", "inout": "inout"}
    expected = "std_logic" if not width else f"std_logic_vector({width - 1} downto 0)"
    if port.way != way or port.width != width or (port.indexes is None) != (not width):
        raise ArgumentError(f"{before}{port.name} is {_shown(port)}, {words[way]} {expected} was expected")
    if width and port.indexes != tuple(range(width)):
        raise ArgumentError(f"{before}{port.name} counts otherwise than {expected}, which was expected")


def _shown(port: Port) -> str:
    way = {"input": "in", "output": "out"}.get(port.way, port.way)
    return f"{way} of {max(port.width, 1)} bits" if port.width or port.indexes else f"{way} of one bit"


def _of_io(top: str, port: Port, board_name: str, board: Board) -> Iterator[tuple[str, Pin]]:
    """Find the pins of `io` that a port is."""
    known = board.io_pins
    if port.indexes is None and port.width:
        raise ArgumentError(f"{top}: {port.name} is no std_logic and no std_logic_vector with numbers for its ends")
    wanted = [port.name] if port.indexes is None else [bit_name(port.name, index) for index in port.indexes]
    for place, name in enumerate(wanted):
        if name not in known:
            what = port.name if port.indexes is None else f"{port.name}({port.indexes[place]})"
            raise ArgumentError(f"{top}: {what} is no pin of {board_name}, {_there(port.name, board)}")
        yield (f"{port.name}[{place}]" if port.width else port.name), known[name]


def _there(name: str, board: Board) -> str:
    """Return words for the pins that a user may have meant."""
    rows = {io_name: _row(list(io.named(io_name))) for io_name, io in board.io.items()}
    medium = [pin for pin in PINS[board.medium] if not pin.startswith(_CHAIN) and "[" not in pin]
    if name in rows:
        return f"which has {rows[name]}"
    if not rows:
        return f"whose file has no [io], so that {', '.join(medium)} are all"
    hint = did_you_mean(name, [*board.io_pins, *board.io, *medium])
    return f"which has {', '.join([*medium, *rows.values()])}" + (f"; {hint}" if hint else "")


def _row(names: list[str]) -> str:
    return names[0] if len(names) == 1 else f"{names[0]} to {names[-1]}"

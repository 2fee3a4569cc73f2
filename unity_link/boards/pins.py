"""Maps the ports of a generated design, or of a user's top, to pins of a board."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.boards.board import CHAIN, PINS, bit_name
from unity_link.errors import ArgumentError, did_you_mean
from unity_link.gateware.limits import ETHERNET
from unity_link.gateware.own_vhdl import Port
from unity_link.generate.vhdl import block_words
from unity_link.spec import Way

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.boards.board import Board, Pin
    from unity_link.generate.vhdl.bank import Bank
    from unity_link.spec import Interface


def generics_on(board: Board, interface: Interface) -> dict[str, object]:
    """Return the generics of `unity_link` that depend on the board of a generated design."""
    of_ethernet = {"block_words": block_words(interface)} if board.medium in ETHERNET else {}
    return {"physical": board.medium, "clock_hz": board.core_hz, **of_ethernet}


READY = "clk_ready"
"""Port that is not a pin: the lock signal of a PLL."""
_MOST_NAMED = 3
_WAYS = {Way.IN: "input", Way.OUT: "output", Way.INOUT: "inout"}


def generated_ports(board: Board, bank: Bank | None = None) -> tuple[Port, ...]:
    """Return the ports of a whole generated design.

    Args:
        board: the board of the design.
        bank: its register bank; None for the ports of the medium and the chain of shift registers alone.
    """
    ways = _ways(board, has_chain=bank is None or bank.has_chain)
    names = [pin.partition("[")[0] for pin in ways]
    widths = {name: names.count(name) if f"{name}[0]" in ways else 0 for name in names}
    ports = [
        Port(name, name, ways.get(name) or ways[f"{name}[0]"], width, tuple(range(width)) or None)
        for name, width in widths.items()
    ]
    ports += [
        Port(pin.name, pin.name, _WAYS[pin.way], pin.width, tuple(range(pin.width)) or None)
        for pin in (bank.wiring.pins if bank is not None else ())
    ]
    return (*ports, Port(READY, READY, "input", 0, None))


def generated_pins(bank: Bank, board_name: str, board: Board) -> dict[str, Pin]:
    """Return the pin of each port of a generated design, or of each bit of a vector.

    Args:
        bank: registers, cores and pins of the design.
        board_name: name of the board in messages.
        board: description of the board.

    Raises:
        ArgumentError: if signals need the chain of shift registers and the board has no pins for it; if a pin of the
            spec names no pin of the board, or one that does not exist or is in use.
    """
    open_pins = [pin.path for pin in bank.wiring.pins if pin.at is None]
    if open_pins:
        raise ArgumentError(
            f"{bank.interface.name} has pins without a place on a board, {', '.join(open_pins)}: name one for each "
            'in the declaration of its core, as in @(0x10, pwm="led0"), or none'
        )
    if bank.has_chain and CHAIN.keys().isdisjoint(board.pins):
        raise ArgumentError(
            f"{board_name} has no pins for the chain of shift registers that holds the signals without a pin, "
            f"{_hung(bank)}: give {', '.join(CHAIN)} sites under [pins]"
        )
    pins = {name: board.medium_pins[name] for name in _ways(board, has_chain=bank.has_chain)}
    taken = {pin.site: name for name, pin in pins.items()}
    for port in bank.wiring.pins:
        assert port.at is not None
        names = [bit_name(port.at, index) for index in range(port.width)] if port.width else [port.at]
        for index, name in enumerate(names):
            if name not in board.io_pins:
                row = f"{port.at} of {port.width} bits" if port.width else port.at
                raise ArgumentError(
                    f"{port.path} is at {row}, and {name} is no pin of {board_name}, {_there(name, board)}"
                )
            pin = board.io_pins[name]
            if pin.site in taken:
                other = taken[pin.site]
                chain = f": a chain of shift registers is there for the signals without a pin, {_hung(bank)}"
                hint = f"{chain}; take another pin" if other in CHAIN else ""
                raise ArgumentError(
                    f"{port.path} is at {name} of {board_name}, which is the pin {pin.site} of {other} as well{hint}"
                )
            taken[pin.site] = port.path
            pins[f"{port.name}[{index}]" if port.width else port.name] = pin
    return pins


def _hung(bank: Bank) -> str:
    """Return the names of the signals on the chain of shift registers: the first ones, and how many follow."""
    names = [register.signal.path for register in (*bank.chained_to, *bank.chained_from)]
    return ", ".join(names[:_MOST_NAMED]) + (f" and {len(names) - _MOST_NAMED} more" if names[_MOST_NAMED:] else "")


def _ways(board: Board, *, has_chain: bool) -> dict[str, str]:
    return {pin: way for pin, way in PINS[board.medium].items() if has_chain or pin not in CHAIN}


def pins_of(top: str, ports: tuple[Port, ...], board_name: str, board: Board) -> dict[str, Pin]:
    """Return the pin of each port of a user's top, or of each bit of a vector, by names such as ``led[3]``.

    Args:
        top: name of the entity.
        ports: ports of the entity.
        board_name: name of the board in messages.
        board: description of the board.

    Raises:
        ArgumentError: if a port is not a pin of the board, or has another width or direction; if two ports share a pin;
            or if a pin of the medium has no port.
    """
    ways = _ways(board, has_chain=False)
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
    """Raise `ArgumentError` if a port has another direction or width than expected."""
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
    """Yield the name and the pin of each bit of a port that belongs to the board's `io`."""
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
    """Return the end of a message: the pins of the board that a user may have meant."""
    rows = {io_name: _row(list(io.named(io_name))) for io_name, io in board.io.items()}
    medium = [pin for pin in PINS[board.medium] if pin not in CHAIN and "[" not in pin]
    if name in rows:
        return f"which has {rows[name]}"
    if not rows:
        return f"whose file has no [io], so that {', '.join(medium)} are all"
    hint = did_you_mean(name, [*board.io_pins, *medium])
    return f"which has {', '.join([*medium, *rows.values()])}" + (f"; {hint}" if hint else "")


def _row(names: list[str]) -> str:
    return names[0] if len(names) == 1 else f"{names[0]} to {names[-1]}"

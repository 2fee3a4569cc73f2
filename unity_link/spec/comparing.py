"""Compares the interface of a program with the interface that a board was generated from, by their facts."""

from __future__ import annotations

from pathlib import PurePath
from typing import TYPE_CHECKING

from unity_link.spec.model import WHOLE, Interface

if TYPE_CHECKING:
    from collections.abc import Iterator

_LEFT_OUT = {"SCALE": "1", "OFFSET": "0", "its word": "its own"}
"""Values of properties that `facts` leaves out; for all other properties the value is "none"."""


def compare(mine: Interface, board: Interface) -> tuple[str, ...]:
    """Return the differences that matter to a program, one sentence each; empty if the board has everything alike.

    Additional signals, groups or cores on the board are no difference.

    Args:
        mine: interface of the program's spec.
        board: interface of the spec that the board was generated from.
    """
    here, there = mine.facts, board.facts
    if board.address_bits >= mine.address_bits:
        there[WHOLE] |= {"address bits": here[WHOLE]["address bits"]}
    name = source_name(mine)
    return tuple(one for thing in here for one in _differences(thing, here[thing], there.get(thing), name))


def source_name(interface: Interface) -> str:
    """Return the name of the file that an interface was read from, or "the spec" if it was not read from a file."""
    name = PurePath(interface.span.file).name
    return name if name.endswith(".ul") else "the spec"


def _differences(thing: str, mine: dict[str, str], board: dict[str, str] | None, name: str) -> Iterator[str]:
    if board is None:
        yield f"{thing} is not on the board"
        return
    for what in dict.fromkeys((*mine, *board)):
        usual = _LEFT_OUT.get(what, "none")
        ours, other = mine.get(what, usual), board.get(what, usual)
        if ours != other:
            yield f"{thing}: {what} is {ours} in {name} and {other} on the board"

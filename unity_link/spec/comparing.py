"""The comparison of a program's interface with that of the spec which a board was generated from, by their facts."""

from __future__ import annotations

from pathlib import PurePath
from typing import TYPE_CHECKING

from unity_link.spec.model import WHOLE, Interface

if TYPE_CHECKING:
    from collections.abc import Iterator

_LEFT_OUT = {"SCALE": "1", "OFFSET": "0", "its word": "its own"}
"""Values of properties that are left out; those of all others are none."""


def compare(mine: Interface, board: Interface) -> tuple[str, ...]:
    """Return the differences that matter to a program, in words; none where the board has all of its spec alike.

    What the board has beside it is no difference.

    Args:
        mine: interface of the program's spec.
        board: that of the spec which the board was generated from.
    """
    here, there = mine.facts, board.facts
    if board.address_bits >= mine.address_bits:
        there[WHOLE] |= {"address bits": here[WHOLE]["address bits"]}
    name = source_name(mine)
    return tuple(one for thing in here for one in _differences(thing, here[thing], there.get(thing), name))


def source_name(interface: Interface) -> str:
    """Return the name of the file that an interface was read from, or else that it is a spec."""
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

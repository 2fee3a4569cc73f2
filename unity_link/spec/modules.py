"""The hardware modules that a spec can name, and their parameters. To add a module, add a row to `MODULES`.

This table has only the words of the language and the number of addresses of each module, for the checks; the meaning of
a module's registers is in `unity_link.network`. Each module has `BASE`, relative to the module around it (default 0),
and `SIZE`, which overrides the number of addresses computed from the other parameters.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from unity_link.spec.arguments import ADDRESS, ArgumentSlot, Shape

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

TOSNET_NODES = 16
TOSNET_NODE_WORDS = 64
"""Words of shared memory of one TosNet node; the words of node n begin at 64 n."""


def _unknown(_: Mapping[str, Any]) -> int | None:
    return None


class ModuleType(NamedTuple):
    """The definition of a module's word."""

    doc: str
    slots: tuple[ArgumentSlot, ...]
    words: Callable[[Mapping[str, Any]], int | None] = _unknown
    """Returns the number of addresses for the arguments; None if they do not determine it."""
    offset: Callable[[Mapping[str, Any]], int] = lambda _: 0
    """Returns the first address for the arguments, before BASE is added."""


COMMON = (ArgumentSlot("BASE", Shape.WHOLE, *ADDRESS), ArgumentSlot("SIZE", Shape.WHOLE, 1, ADDRESS[1] + 1))
_HANDLES = (ArgumentSlot("CTRL", Shape.HANDLE, *ADDRESS), ArgumentSlot("COMM", Shape.HANDLE, *ADDRESS))

MODULES: dict[str, ModuleType] = {
    "TOSNET": ModuleType(
        "a TosNet network: the shared memory of all its nodes",
        (*_HANDLES, ArgumentSlot("NODES", Shape.WHOLE, 1, TOSNET_NODES)),
        lambda arguments: TOSNET_NODE_WORDS * arguments["NODES"] if "NODES" in arguments else None,
    ),
    "TOSNET_NODE": ModuleType(
        "the shared memory of one node of a TosNet network",
        (ArgumentSlot("NODE", Shape.WHOLE, 0, TOSNET_NODES - 1, required=True),),
        lambda _: TOSNET_NODE_WORDS,
        lambda arguments: TOSNET_NODE_WORDS * arguments.get("NODE", 0),
    ),
    "MEMORY": ModuleType("plain memory, or any registers", ()),
    "FIFO": ModuleType(
        "a queue behind one address",
        (ArgumentSlot("WORDS", Shape.WHOLE, 1, 1 << 32),),
    ),
}

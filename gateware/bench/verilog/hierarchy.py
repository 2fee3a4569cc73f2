"""All registers of a released Verilog file by their place, as the vendors' tools name them."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Iterator

_MODULE = re.compile(r"^module (\w+)$(.*?)^endmodule$", re.MULTILINE | re.DOTALL)
_INSTANCE = re.compile(r"^  (\w+) (\w+) \($", re.MULTILINE)
_REGISTER = re.compile(r"\breg (?:\[\d+:0\] )?(\w+)")


class Place(NamedTuple):
    """A register."""

    entities: tuple[str, ...]
    """The entities that contain it, from the top on."""
    labels: tuple[str, ...]
    """The labels of their instances, without that of the top."""
    name: str


def registers(text: str, top: str) -> list[Place]:
    """Return all registers of a design."""
    modules = dict(_MODULE.findall(text))

    def entity(module: str) -> str:
        return re.sub(r"_\d+$", "", module.removeprefix(f"{top}_"))

    def inside(module: str, entities: tuple[str, ...], labels: tuple[str, ...]) -> Iterator[Place]:
        here = (*entities, entity(module))
        for name in _REGISTER.findall(modules[module]):
            yield Place(here, labels, name)
        for other, label in _INSTANCE.findall(modules[module]):
            if other in modules:
                yield from inside(other, here, (*labels, label))

    return list(inside(top, (), ()))

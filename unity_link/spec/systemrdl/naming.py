"""Names that are told apart, and the values of an enumeration as a spec writes them, for both directions."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable


def unique_name(name: str, taken: set[str]) -> str:
    """Return a name that is not taken yet: ``a.b`` and ``a_b`` would be the same."""
    number, unique = 1, name
    while unique in taken:
        number += 1
        unique = f"{name.removeprefix(chr(92))}_{number}"
    taken.add(unique)
    return unique


def doc_lines(text: str) -> str:
    """Return a doc string as it stands in a spec; nothing for an empty one."""
    return "".join(f"/// {line}\n" for line in text.split("\n")) if text else ""


def values_text(values: Iterable[tuple[str, int, str]]) -> str:
    """Return what stands between the braces of an enumeration, of names, numbers and doc strings."""
    return ", ".join(f"{doc_lines(doc)}{name} = {number}" for name, number, doc in values)

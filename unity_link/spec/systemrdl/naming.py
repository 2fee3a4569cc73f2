"""Names that are told apart, and the values of an enumeration as a spec writes them, for both directions."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

_CONTROLS = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028\u2029]")


def unique_name(name: str, taken: set[str]) -> str:
    """Return a name that is not taken yet, and take it.

    ``a.b`` and ``a_b`` would be the same, and so are ``A`` and ``a``, which VHDL does not tell apart.

    Args:
        name: the one that is wanted.
        taken: those that are taken, in small letters.
    """
    number, unique = 1, name
    while unique.lower() in taken:
        number += 1
        unique = f"{name.removeprefix(chr(92))}_{number}"
    taken.add(unique.lower())
    return unique


def doc_lines(text: str) -> str:
    """Return a doc string as it stands in a spec; nothing for an empty one. Control characters become spaces."""
    return "".join(f"/// {_CONTROLS.sub(' ', line)}\n" for line in text.split("\n")) if text else ""


def values_text(values: Iterable[tuple[str, int, str]]) -> str:
    """Return what stands between the braces of an enumeration, of names, numbers and doc strings."""
    return ", ".join(f"{doc_lines(doc)}{name} = {number}" for name, number, doc in values)

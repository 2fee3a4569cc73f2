"""Unique names, doc strings and enumeration values for the import from and the export to SystemRDL."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

_CONTROLS = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028\u2029]")


def unique_name(name: str, taken: set[str]) -> str:
    """Return a name that differs from all taken names, and add it to them.

    Numbers are appended until the name differs: ``a.b`` and ``a_b`` give the same identifier, and VHDL ignores case.

    Args:
        name: the preferred name.
        taken: the taken names, in lower case.
    """
    number, unique = 1, name
    while unique.lower() in taken:
        number += 1
        unique = f"{name.removeprefix(chr(92))}_{number}"
    taken.add(unique.lower())
    return unique


def doc_lines(text: str) -> str:
    """Return a doc string in the syntax of a spec; empty for an empty one. Control characters become spaces."""
    return "".join(f"/// {_CONTROLS.sub(' ', line)}\n" for line in text.split("\n")) if text else ""


def values_text(values: Iterable[tuple[str, int, str]]) -> str:
    """Return the text between the braces of an enumeration, from names, numbers and doc strings."""
    return ", ".join(f"{doc_lines(doc)}{name} = {number}" for name, number, doc in values)

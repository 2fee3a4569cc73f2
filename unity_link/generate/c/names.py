"""Names of a spec as identifiers of C and C++, and numbers as literals.

Both languages share the identifiers, for a C++ program includes the C header. All of them come from `Names`, one for
each scope: a name that a language, a library or the generated code has for itself (`reserved`) gets a ``_`` behind it:
`class` becomes `class_`.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from unity_link.generate.c.reserved import is_word

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable


class Names:
    """The names of one scope, each given once.

    Args:
        taken: identifiers that are in the scope already.
        is_reserved: whether an identifier cannot be had at all.
    """

    def __init__(self, taken: Iterable[str] = (), is_reserved: Callable[[str], bool] = is_word) -> None:
        self._taken = set(taken)
        self._is_reserved = is_reserved

    def take(self, name: str, endings: Iterable[str] = ("",)) -> str:
        """Return an identifier for a name, and keep it from being given again.

        With endings, the identifier has all of them free: those of the functions that are named after a type.
        """
        identifier = re.sub(r"\W+", "_", name, flags=re.ASCII).strip("_") or "_"
        if identifier[0].isdigit():
            identifier = f"n{identifier}"
        while any(self._has(f"{identifier}{ending}") for ending in endings):
            identifier += "_"
        self._taken.update(f"{identifier}{ending}" for ending in endings)
        return identifier

    def _has(self, identifier: str) -> bool:
        return identifier in self._taken or self._is_reserved(identifier)


def number(value: float) -> str:
    """Return a literal of a double that has exactly this value."""
    if value in (float("inf"), float("-inf")):
        return "INFINITY" if value > 0 else "-INFINITY"
    literal = repr(float(value))
    return literal[:-2] if literal.endswith(".0") and len(literal) < len("1234567.0") else literal

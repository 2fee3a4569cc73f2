"""Names of a spec as identifiers of C and C++, and numbers as literals.

Both languages use the same identifiers, because a C++ program includes the C header. `Names` makes them, one object for
each scope: a name that a language, a library or the generated code reserves (`reserved`) gets a ``_`` appended: `class`
becomes `class_`.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from unity_link.generate.c.reserved import is_word

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable


class Names:
    """The identifiers of one scope, all different.

    Args:
        taken: identifiers that exist in the scope.
        is_reserved: returns whether an identifier must not be used.
    """

    def __init__(self, taken: Iterable[str] = (), is_reserved: Callable[[str], bool] = is_word) -> None:
        self._taken = set(taken)
        self._is_reserved = is_reserved

    def take(self, name: str, endings: Iterable[str] = ("",)) -> str:
        """Return an identifier for a name, and reserve it.

        With endings, the identifier is free with each of them: functions named after a type have such names.
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
    """Return a C literal of type double with exactly this value."""
    if value in (float("inf"), float("-inf")):
        return "INFINITY" if value > 0 else "-INFINITY"
    literal = repr(float(value))
    return literal[:-2] if literal.endswith(".0") and len(literal) < len("1234567.0") else literal

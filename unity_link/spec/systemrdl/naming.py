"""Names that are told apart, for both directions."""

from __future__ import annotations


def unique_name(name: str, taken: set[str]) -> str:
    """Return a name that is not taken yet: ``a.b`` and ``a_b`` would be the same."""
    number, unique = 1, name
    while unique in taken:
        number += 1
        unique = f"{name.removeprefix(chr(92))}_{number}"
    taken.add(unique)
    return unique

"""Names of a spec as identifiers of C and C++, and texts as comments and strings.

Both languages share the identifiers, for a C++ program includes the C header. A name that one of them keeps for itself
gets a ``_`` behind it: `class` becomes `class_`.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

_C = """
    auto break case char const continue default do double else enum extern float for goto if inline int long register
    restrict return short signed sizeof static struct switch typedef union unsigned void volatile while
"""
_CPP = """
    alignas alignof and and_eq asm bitand bitor bool catch char8_t char16_t char32_t class co_await co_return co_yield
    compl concept const_cast consteval constexpr constinit decltype delete dynamic_cast explicit export false friend
    mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public reinterpret_cast
    requires static_assert static_cast template this thread_local throw true try typeid typename using virtual wchar_t
    xor xor_eq
"""
_MACROS = """
    assert complex errno i386 imaginary linux major minor noreturn offsetof setjmp stderr stdin
    stdout unix va_arg
"""
"""Names without capitals that headers of C and POSIX define as macros, which may stand before ours."""
_GLOBAL = """
    abort abs accept access alarm atoi bind brk calloc clock close connect div dup environ exit fork free getenv index
    kill labs link listen log main malloc open pause pipe poll pow printf rand read realloc recv remove rename rint
    round select send shutdown signal sin sleep socket sqrt stat std stime strcpy sync system time times truncate
    unity_link unlink wait write y0 y1 yn j0 j1 jn
"""
"""Functions and variables whose names an interface cannot have."""
_OURS = "place std the_link unity_link"
"""What the members of generated classes must leave visible."""
RESERVED = frozenset(f"{_C}{_CPP}{_MACROS}{_OURS}".split())
GLOBAL = RESERVED | frozenset(_GLOBAL.split())


class Names:
    """The names of one scope, each given once."""

    def __init__(self, reserved: Iterable[str] = RESERVED) -> None:
        self._taken = set(reserved)

    def take(self, name: str) -> str:
        """Give an identifier for a name, and keep it from being given again."""
        identifier = re.sub(r"\W+", "_", name, flags=re.ASCII).strip("_") or "_"
        if identifier[0].isdigit():
            identifier = f"n{identifier}"
        while identifier in self._taken:
            identifier += "_"
        self._taken.add(identifier)
        return identifier


def string(text: str) -> str:
    """Give a string literal; ``??`` is parted, for it begins a trigraph."""
    escaped = "".join(
        f"\\{character}" if character in '"\\' else character if character >= " " else f"\\{ord(character):03o}"
        for character in text
    )
    return f'"{escaped.replace("??", "?" + chr(92) + "?")}"'


def comment(text: str, indent: str = "") -> str:
    """Give a text of one or more lines as a comment."""
    safe = text.replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?").rstrip("\\")
    lines = [line.rstrip().rstrip("\\") for line in safe.split("\n")]
    return f"{indent}/* " + f"\n{indent} * ".join(lines) + " */"


def number(value: float) -> str:
    """Give a literal of a double that has exactly this value."""
    if value in (float("inf"), float("-inf")):
        return "INFINITY" if value > 0 else "-INFINITY"
    literal = repr(float(value))
    return literal[:-2] if literal.endswith(".0") and len(literal) < len("1234567.0") else literal

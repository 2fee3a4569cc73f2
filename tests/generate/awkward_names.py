"""Specs with names that mean something in C and C++: to the languages, to libraries, or in generated code."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hypothesis import strategies as st

from unity_link.generate.c.reserved import GLOBALS, INTERFACES, WORDS
from unity_link.spec import KindName

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

BEGINNINGS = ("Robot", "X", "_x", "size", "uint64", "ul", "ul_link", "unity_link", "x", "xY", "x_", "x_Y", "x_y")
ENDINGS = ("H", "HPP", "decode", "get", "name", "next", "post", "read", "set", "signals", "subscribe", "t", "write")
MADE = [*BEGINNINGS, *ENDINGS, *(f"{beginning}_{ending}" for beginning in BEGINNINGS for ending in ENDINGS)]
OTHERS = ["INT_MAX", "M_PI", "SIGNAL", "UL_WINDOW", "legs_2", "link_", "of", "uint64_t", "unity_link_posix"]
LONG = [f"{'long_' * 59}{number:05}" for number in range(8)]
"""Names of 300 characters that differ only at the end."""
NO_NAMES = {"enum", "group", "import", "public", "i", "pi", "true", "false", *(kind.value for kind in KindName)}
IN_C = (*WORDS, *GLOBALS, *INTERFACES)

GROUPS_BY_KEYWORDS = """\
public robot() { @a = 1: signed READ(PUBLISH(class)); @b = 2: READWRITE(PUBLISH(new)); @NULL = 3: READWRITE(); }
group class(1, 10);
group new(2, 10);
"""
INTERFACE_AS_A_PARAMETER = """\
enum mode { off, NULL }
public values() { @a = 1: signed READWRITE(PUBLISH(words)); @b = 2: mode READWRITE(PUBLISH(words)); }
group words(1, 10);
"""
FUNCTIONS_OF_A_FAMILY = """\
enum mode { off, on }
public ul_x() { @a = 1: mode READWRITE(PUBLISH(words)); }
group words(1, 10);
"""
PARAMETERS_OF_NETWORKS = """\
public robot(words, status, network) {
  GATEWAY(ADDRESS_BITS=12);
  TOSNET(CTRL=words, COMM=status, NODES=2) { @a = 1: READWRITE(); }
  more: TOSNET(CTRL=network, BASE=0x400, NODES=2);
}
"""
NOTHING_INSIDE = """\
public robot() { @a = 1: READ(); b: nothing(); c[2]: nothing(); d: around(); }
around() { e: nothing(); }
nothing() { }
"""
NOTHING_AT_ALL = "public robot() { }"
TRIGRAPHS = """\
/// Is it so??/
/// At the end: \\
public robot() { @a = 1: READ(); }
"""


def names(words: Iterable[str]) -> st.SearchStrategy[str]:
    """Return a strategy for names: words of a language, words of generated code, and long names that differ little."""
    pools = (words, [*MADE, *OTHERS], LONG)
    return st.one_of(*(st.sampled_from(sorted(set(pool) - NO_NAMES)) for pool in pools))


@st.composite
def awkward_specs(draw: st.DrawFn, words: Iterable[str] = IN_C) -> str:
    """Draw a spec that has each kind of declaration twice, each with its own name."""
    drawn = draw(st.lists(names(words), min_size=38, max_size=38, unique_by=str.lower))
    # A value of an enumeration is a member of a class in Python, which cannot begin with an underscore.
    values = [name for name in drawn if not name.startswith("_")][:6]
    # The name of the interface becomes the name of files, which cannot have 300 characters.
    interface = next(name for name in drawn if name not in {*values, *LONG})
    given = iter([name for name in drawn if name not in {*values, interface}])
    modes, parts, groups = ([next(given), next(given)] for _ in range(3))
    kinds = ["", "float", *modes]
    text = draw(st.text(st.characters(codec="utf-8", exclude_categories=["Cs", "Cc"]), max_size=12))
    quoted = text.replace("\\", "\\\\").replace('"', '\\"')
    return "\n".join(
        [
            f"/// {text}".rstrip(),
            *(f"enum {mode} {{ {', '.join(values[place::2])} }}" for place, mode in enumerate(modes)),
            *(f"group {group}({number}, 10);" for number, group in enumerate(groups)),
            f"public {interface}() {{ GATEWAY(ADDRESS_BITS=12);",
            *_signals(given, kinds, [f'UNIT="{quoted}", PUBLISH({group})' for group in groups]),
            *(f"{next(given)}[2]: {part}() @({0x40 * (place + 1)} + 16 * i);" for place, part in enumerate(parts)),
            "}",
            *(f"{part}(): @(base) {{ {' '.join(_signals(given, kinds[1:], ['', f'GROUP({group})']))} }}"
              for part, group in zip(parts, groups, strict=True)),
        ]
    )  # fmt: skip


def _signals(given: Iterator[str], kinds: list[str], groups: list[str]) -> list[str]:
    pairs = [(kind, group) for kind in kinds for group in groups]
    place = "base + " if "" in groups else ""
    heads = [f"@{next(given)}{'[2]' * (at % 2)} = {place}{2 * at}{' + i' * (at % 2)}" for at in range(len(pairs))]
    return [f"{head}: {kind} READWRITE({group});" for head, (kind, group) in zip(heads, pairs, strict=True)]

"""Hashes of the inputs of a design: the sources of its top, and the Verilog that GHDL makes of them.

The figures of `make synth` record both. If the sources are the same, so is the Verilog; if they differ, the Verilog may
still be the same, and then the figures remain valid.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import msgspec

from unity_link.gateware.cache import hash_of

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from pathlib import Path

_REMARK = re.compile(r"--.*")
_UNIT = re.compile(r"^(?:entity|package) (\w+) is$", re.MULTILINE)
_USED = re.compile(r"\b(?:entity|use) (?:work|unity_link)\.(\w+)", re.IGNORECASE)
_COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/|("[^"\n]*")', re.DOTALL)
_NAME_DIGITS = 12


class Origin(msgspec.Struct, frozen=True):
    """Hashes of the inputs from which figures were made."""

    verilog: str
    """Hash of the Verilog, from `verilog_of`."""
    sources: str
    """Hash of the VHDL, from `sources_of`."""
    tools: str
    """Hash of the tools with their versions and options."""


def sources_of(top: str, generics: Mapping[str, object], sources: Iterable[Path]) -> str:
    """Return a hash of an entity with generics, of all entities below it, and of the packages that these use.

    Args:
        top: name of the entity.
        generics: their values.
        sources: VHDL files. Only those that the top needs are hashed, without their comments.

    Raises:
        KeyError: if no file contains the top.
    """
    texts = [_REMARK.sub("", source.read_text()) for source in sources]
    text_of = {unit: text for text in texts for unit in _UNIT.findall(text)}
    needed: dict[str, str] = {}
    waiting = [top]
    while waiting:
        unit = waiting.pop()
        if unit not in needed:
            needed[unit] = " ".join(text_of[unit].split())
            waiting += (used for used in _USED.findall(text_of[unit]) if used in text_of)
    given = [f"{name}={value}" for name, value in sorted(generics.items())]
    return hash_of([top, *given, *(text for _, text in sorted(needed.items()))])[:_NAME_DIGITS]


def verilog_of(text: str) -> str:
    """Return a hash of a Verilog text, without its comments, empty lines and indentation."""
    code = _COMMENT.sub(lambda found: found[1] or "", text)
    return hash_of(["\n".join(line for line in map(str.strip, code.splitlines()) if line)])[:_NAME_DIGITS]

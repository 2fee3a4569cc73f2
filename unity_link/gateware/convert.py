"""VHDL to Verilog: one entity with chosen generics, all of its hierarchy in one file.

A warning is an error here, but for those of attributes, as is what is never assigned. GHDL itself refuses latches.
"""

from __future__ import annotations

import itertools
import re
import subprocess
from pathlib import Path
from typing import TYPE_CHECKING

from unity_link.errors import UnityLinkError
from unity_link.files import write_file
from unity_link.gateware.cache import LIBRARY, cache_folder, hash_of, is_whole, library_of, sealed, sources_for
from unity_link.gateware.external import temporary_folder
from unity_link.gateware.ghdl import converting_ghdl

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

STD = "--std=08"
# Only the vendors' primitives are components, and bound to nothing: they go as they are into the result.
UNBOUND = "-Wno-binding"
# VHDL does not tell small letters from capitals, Verilog does: these names, and all of their ports, are capitals.
_PRIMITIVES = re.compile(r"^  (?:delayg|ifs1p3bx|ofs1p3bx|dffp|fdpe)\b.*?\);$", re.MULTILINE | re.DOTALL)
_THEIR_NAMES = re.compile(r"^  \w+|\.\w+\(", re.MULTILINE)
_ERROR_LINES = 12
# Attributes speak to the vendors' tools, each to its own.
_FOR_OTHER_TOOLS = "[-Wunhandled-attribute]"


class ConversionError(UnityLinkError):
    """A tool refused the sources; the message is what it said."""


def to_verilog(
    top: str,
    generics: Mapping[str, object] | None = None,
    extra_sources: Sequence[Path] = (),
    pads: str | None = None,
) -> Path:
    """Return a Verilog file of the entity `top`, converted unless that was done before.

    Args:
        top: name of the entity in the gateware or `extra_sources`.
        generics: values for its generics; what is not named keeps its default. Booleans may be Python's.
        extra_sources: VHDL files beside those of the gateware, of the library `work`.
        pads: whose registers are at the pins, as in `vhdl_sources`.

    Raises:
        ConversionError: if GHDL refuses the sources, or warns of something in them.
        ToolMissingError: if there is no GHDL that can be used.
    """
    libraries = {
        LIBRARY: sources_for(top, extra_sources, pads),
        "work": [Path(source).resolve() for source in extra_sources],
    }
    sources = itertools.chain(*libraries.values())
    options = as_options(generics or {})
    ghdl = converting_ghdl()
    name = hash_of([ghdl.version(), _PRIMITIVES.pattern, top, *options, *(source.read_bytes() for source in sources)])
    result = cache_folder("verilog") / f"{top}-{name}.v"
    if is_whole(result):
        return result
    with temporary_folder() as scratch:
        try:
            # Imported first, so that GHDL itself finds the order in which the sources depend on each other.
            anywhere = [STD, UNBOUND, f"--workdir={scratch}"]
            work = [*anywhere, f"--work={library_of(top)}"]
            steps = (
                *(
                    ghdl.run("import", *anywhere, f"--work={library}", *map(str, files), cwd=scratch)
                    for library, files in libraries.items()
                    if files
                ),
                ghdl.run("make", *work, top, cwd=scratch),
                ghdl.run("synth", *work, "--out=verilog", *options, top, cwd=scratch),
            )
        except subprocess.CalledProcessError as error:
            first_lines = "\n".join(error.stderr.strip().splitlines()[:_ERROR_LINES])
            raise ConversionError(f"{top} with {dict(generics or {})}: {first_lines}") from error
    lines = [line for step in steps for line in step.stderr.splitlines()]
    warnings = [line for line in lines if ":warning:" in line and _FOR_OTHER_TOOLS not in line]
    # GHDL says nothing of what is never assigned. (Where a `case` names all values, its default is unknown, too.)
    warnings += re.findall(r"^ *assign \w+ = [^?\n]*'b[01X]*X[^?\n]*;.*$", steps[-1].stdout, re.MULTILINE)
    if warnings:
        raise ConversionError(f"{top} with {dict(generics or {})}: " + "\n".join(warnings[:_ERROR_LINES]))
    write_file(result, sealed(cleaned(steps[-1].stdout).encode()), overwrite=True)
    return result


def as_options(generics: Mapping[str, object]) -> list[str]:
    """Return the options that give generics to GHDL."""
    return [f"-g{name}={_as_vhdl(value)}" for name, value in sorted(generics.items())]


def cleaned(verilog: str) -> str:
    """Return GHDL's Verilog with primitives as vendors spell them, and without the remarks, which name files."""
    text = re.sub(r"^ */\*.*?\*/\n", "", verilog, flags=re.MULTILINE)
    return _PRIMITIVES.sub(lambda cell: _THEIR_NAMES.sub(lambda name: name[0].upper(), cell[0]), text)


def _as_vhdl(value: object) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)

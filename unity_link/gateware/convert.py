"""VHDL to Verilog: one entity with chosen generics, all of its hierarchy in one file.

A warning about the gateware is an error here, but for those of attributes, as is what is never assigned. GHDL itself
refuses latches. What GHDL is known to convert wrongly is refused.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from unity_link.files import write_file
from unity_link.gateware.cache import cache_folder, hash_of, is_whole, library_of, sealed, sources_for
from unity_link.gateware.design import ConversionError, GhdlDesign, as_options
from unity_link.gateware.external import temporary_folder
from unity_link.gateware.ghdl import converting_ghdl
from unity_link.gateware.refused import refusals

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

__all__ = ["ConversionError", "cleaned", "to_verilog"]

# VHDL does not tell small letters from capitals, Verilog does: these names, and all of their ports, are capitals.
_PRIMITIVES = re.compile(r"^  (?:delayg|ifs1p3bx|ofs1p3bx|dffp|fdpe)\b.*?\);$", re.MULTILINE | re.DOTALL)
_THEIR_NAMES = re.compile(r"^  \w+|\.\w+\(", re.MULTILINE)
_MOST_FAULTS = 12
# Attributes speak to the vendors' tools, each to its own.
_FOR_OTHER_TOOLS = "[-Wunhandled-attribute]"


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
    gateware = sources_for(top, extra_sources, pads)
    sources = [*gateware, *extra_sources]
    options = as_options(generics or {})
    version = converting_ghdl().version()
    name = hash_of([version, _PRIMITIVES.pattern, top, *options, *(source.read_bytes() for source in sources)])
    result = cache_folder("verilog") / f"{top}-{name}.v"
    if is_whole(result):
        return result
    about = f"{top} with {dict(generics or {})}"
    library = library_of(top)
    with temporary_folder() as scratch:
        try:
            design = GhdlDesign(scratch, gateware, extra_sources)
            design.make(top, library)
            verilog = design.verilog(top, generics or {}, library)
        except ConversionError as error:
            raise ConversionError(f"{about}: {error}") from error
        faults = [str(message) for message in design.messages if _FOR_OTHER_TOOLS not in message.words]
        faults += never_assigned(verilog)
        faults += map(str, refusals(verilog, design, lambda: design.netlist(top, generics or {}, library)))
    if faults:
        raise ConversionError(f"{about}: " + "\n".join(faults[:_MOST_FAULTS]))
    write_file(result, sealed(cleaned(verilog).encode()), overwrite=True)
    return result


def never_assigned(verilog: str) -> list[str]:
    """Return the lines of GHDL's Verilog that give a net no value, of which GHDL does not warn."""
    # Where a `case` names all values, its default is unknown, too.
    return re.findall(r"^ *assign \w+ = [^?\n]*'b[01X]*X[^?\n]*;.*$", verilog, re.MULTILINE)


def cleaned(verilog: str) -> str:
    """Return GHDL's Verilog with primitives as vendors spell them, and without the remarks, which name files."""
    text = re.sub(r"^ */\*.*?\*/\n", "", verilog, flags=re.MULTILINE)
    return _PRIMITIVES.sub(lambda cell: _THEIR_NAMES.sub(lambda name: name[0].upper(), cell[0]), text)

"""Converts VHDL to Verilog: one entity with given values of generics, and all of its hierarchy, into one file.

Warnings about the gateware are errors here, except for those about attributes; so are nets without a driver. GHDL
refuses latches. `refused` finds VHDL that GHDL is known to convert wrongly.
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

# Primitives of vendors: their names and those of their ports are in capitals in Verilog, which is case-sensitive.
_PRIMITIVES = re.compile(r"^  (?:delayg|ifs1p3bx|ofs1p3bx|dffp|fdpe)\b.*?\);$", re.MULTILINE | re.DOTALL)
_THEIR_NAMES = re.compile(r"^  \w+|\.\w+\(", re.MULTILINE)
_MOST_FAULTS = 12
# Attributes are instructions for vendors' tools, which GHDL does not handle.
_FOR_OTHER_TOOLS = "[-Wunhandled-attribute]"


def to_verilog(
    top: str,
    generics: Mapping[str, object] | None = None,
    extra_sources: Sequence[Path] = (),
    pads: str | None = None,
) -> Path:
    """Return the path of a Verilog file of the entity `top`; convert it if the cache does not have it.

    Args:
        top: name of the entity in the gateware or `extra_sources`.
        generics: values of its generics; other generics keep their defaults. Booleans may be Python's.
        extra_sources: VHDL files of the library `work`, besides those of the gateware.
        pads: vendor of the registers at the pins, as in `vhdl_sources`.

    Raises:
        ConversionError: if GHDL refuses the sources or warns about them, or would convert them wrongly.
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
    """Return the lines of GHDL's Verilog that assign unknown bits to a net; GHDL does not warn about these."""
    # Skip conditional assignments: the default of a `case` that names all values is unknown as well.
    return re.findall(r"^ *assign \w+ = [^?\n]*'b[01X]*X[^?\n]*;.*$", verilog, re.MULTILINE)


def cleaned(verilog: str) -> str:
    """Return GHDL's Verilog with the vendors' spelling of primitives, and without comments that name source files."""
    text = re.sub(r"^ */\*.*?\*/\n", "", verilog, flags=re.MULTILINE)
    return _PRIMITIVES.sub(lambda cell: _THEIR_NAMES.sub(lambda name: name[0].upper(), cell[0]), text)

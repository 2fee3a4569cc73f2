"""A Verilog-2005 file of a design, for those who have no VHDL: a netlist, of which every module bears the file's name.

Two such files go into one design, because no two of their modules have one name. At its top a file says what it is, and
how it is instantiated: Verilog has no defaults of ports, so the header says to what an input may be tied.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NamedTuple

import unity_link
from unity_link.gateware import LICENCE
from unity_link.gateware.cache import vhdl_sources
from unity_link.gateware.convert import to_verilog
from unity_link.gateware.registers import SETTINGS, with_names
from unity_link.gateware.words import SYSTEMVERILOG

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

# What a netlist cannot help: signals and comparisons that its generics have made needless.
_NEEDLESS = ("UNUSEDSIGNAL", "PINCONNECTEMPTY", "CMPCONST", "UNSIGNED")
_MODULE = re.compile(r"^module (\w+)$", re.MULTILINE)
_MENTION = re.compile(r"^(module |  )(\w+)(?=$| \w+ \()", re.MULTILINE)
# What is a word of Verilog is written so that it ends at a space.
_PORT = re.compile(r"^ +\(?(input|output)(?: reg)? +(?:\[(\d+):0\] )?(\w+|\\\w+ )[,)]", re.MULTILINE)
# Comments, texts and names behind a backslash are passed over.
_WORD = re.compile(rf'//.*|"[^"\n]*"|\\\S+|\b({"|".join(sorted(SYSTEMVERILOG))})\b')
_DEFAULT = re.compile(r"^\s*(\w+)\s*:\s*in\s[^:;]*:=\s*('[01]'|\(others => '[01]'\))", re.MULTILINE)


class ModulePort(NamedTuple):
    """A port of a module."""

    name: str
    """Name as Verilog writes it: one that is a word of Verilog with its backslash and its space."""
    width: int
    is_input: bool
    default: str
    """Value that Verilog ties an unconnected input to; empty for inputs that must be connected."""


def release(name: str, about: Sequence[str], top: str, generics: Mapping[str, object] | None = None) -> str:
    """Return the file of an entity of the gateware as the module `name`.

    Args:
        name: of the module that a design instantiates; all others begin with it.
        about: lines that say of what configuration it is.
        top: the entity.
        generics: as those of `to_verilog`.

    Raises:
        ConversionError: if GHDL refuses the sources.
        ToolMissingError: if there is no GHDL that can be used.
    """
    return released(name, about, top, to_verilog(top, generics).read_text(), vhdl_sources())


def released(name: str, about: Sequence[str], top: str, verilog: str, sources: Sequence[Path]) -> str:
    """Return the file of a converted entity as the module `name`.

    Args:
        name: as of `release`.
        about: as of `release`.
        top: the entity.
        verilog: GHDL's Verilog.
        sources: all VHDL, that of the entity among it.
    """
    text = _without_words(with_names(verilog, sources))
    found = ports(text, top, top, sources)
    lines = [
        *([] if LICENCE in about else [LICENCE, ""]),
        *about,
        "",
        f"A netlist in Verilog-2005, converted by GHDL from the VHDL of Unity-Link {unity_link.__version__}: its",
        "generics are fixed, and who wants to read or change it should do so in the VHDL.",
        "",
        "To instantiate it (behind `or` is what an input is tied to that a design has no use for):",
        "",
        *_instance_template(name, found),
    ]
    head = "".join(f"// {line}".rstrip() + "\n" for line in lines)
    body = "\n".join(line.rstrip() for line in _named(text, top, name).replace("\t", " ").splitlines())
    off, on = ("".join(f"/* verilator lint_{way} {rule} */\n" for rule in _NEEDLESS) for way in ("off", "on"))
    return f"{head}\n{off}\n{body}\n\n{on}"


def ports(verilog: str, module: str, entity: str, sources: Sequence[Path]) -> list[ModulePort]:
    """Return the ports of a module that an entity has become, with the defaults that they have in its VHDL."""
    start = re.search(rf"^module {module}$", verilog, re.MULTILINE)
    assert start is not None
    head = verilog[start.end() : verilog.index(");", start.end()) + 1]
    declaration = re.compile(rf"^entity {entity} is$.*?^end entity", re.MULTILINE | re.DOTALL)
    declared = next(match[0] for source in sources if (match := declaration.search(source.read_text())))
    defaults = dict(_DEFAULT.findall(declared))
    return [
        ModulePort(
            port, width := int(high or 0) + 1, way == "input", _constant(defaults.get(port.strip("\\ "), ""), width)
        )
        for way, high, port in _PORT.findall(head)
    ]


def _instance_template(name: str, found: Sequence[ModulePort]) -> list[str]:
    """Return lines of Verilog that instantiate a module."""
    ends = [*[","] * (len(found) - 1), ""]
    return [
        f"{name} {name}_inst (",
        *(
            f"  .{port.name}({port.name}){end}" + (f"  // or {port.default}" if port.default else "")
            for port, end in zip(found, ends, strict=True)
        ),
        ");",
    ]


def _constant(default: str, width: int) -> str:
    if not default:
        return ""
    bit = "1" if "'1'" in default else "0"
    return f"1'b{bit}" if width == 1 else f"{{{width}{{1'b{bit}}}}}"


def _without_words(text: str) -> str:
    """Return Verilog in which no name is a word of SystemVerilog: such a name gets ``_x``, as in generated VHDL.

    By the standard a backslash would do, but Verilator 5.006 refuses ``super`` behind one.
    """
    ending = "_x"
    while re.search(rf"\b({'|'.join(SYSTEMVERILOG)}){ending}\b", text):
        ending += "_x"
    return _WORD.sub(lambda found: f"{found[1]}{ending}" if found[1] else found[0], text)


def _named(text: str, top: str, name: str) -> str:
    """Return a design of which the top bears a name, and all other modules that with their entity's behind it."""
    names: dict[str, str] = {}
    for module in _MODULE.findall(text):
        wanted = name if module == top else f"{name}_{SETTINGS.sub('', module)}"
        number = sum(SETTINGS.sub("", known) == SETTINGS.sub("", module) for known in names)
        names[module] = f"{wanted}_{number + 1}" if number else wanted
    return _MENTION.sub(lambda mention: mention[1] + names.get(mention[2], mention[2]), text)

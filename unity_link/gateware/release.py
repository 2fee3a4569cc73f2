"""Makes a Verilog-2005 netlist in one file, for users without VHDL tools.

The names of all modules begin with the file's name, so that two such files fit into one design. The header of the file
has an instance to copy, with constants for inputs that may be left open in VHDL, because Verilog ports have no
defaults.
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

# Verilator warnings that a netlist cannot avoid: with fixed generics some signals and comparisons have no effect.
_NEEDLESS = ("UNUSEDSIGNAL", "PINCONNECTEMPTY", "CMPCONST", "UNSIGNED")
_MODULE = re.compile(r"^module (\w+)$", re.MULTILINE)
_MENTION = re.compile(r"^(module |  )(\w+)(?=$| \w+ \()", re.MULTILINE)
# A port; a name that is a keyword of Verilog is escaped, and ends with a space.
_PORT = re.compile(r"^ +\(?(input|output)(?: reg)? +(?:\[(\d+):0\] )?(\w+|\\\w+ )[,)]", re.MULTILINE)
# A keyword of SystemVerilog; the other alternatives skip comments, strings and escaped names.
_WORD = re.compile(rf'//.*|"[^"\n]*"|\\\S+|\b({"|".join(sorted(SYSTEMVERILOG))})\b')
_DEFAULT = re.compile(r"^\s*(\w+)\s*:\s*in\s[^:;]*:=\s*('[01]'|\(others => '[01]'\))", re.MULTILINE)


class ModulePort(NamedTuple):
    """A port of a module."""

    name: str
    """Name in Verilog; a keyword of Verilog is escaped, with its backslash and its final space."""
    width: int
    is_input: bool
    default: str
    """Constant for an input that the design does not use; empty for inputs that must be connected."""


def release(name: str, about: Sequence[str], top: str, generics: Mapping[str, object] | None = None) -> str:
    """Return the file of an entity of the gateware as the module `name`.

    Args:
        name: name of the module that a design instantiates; the names of all other modules begin with it.
        about: lines for the header that describe the configuration.
        top: name of the entity.
        generics: as in `to_verilog`.

    Raises:
        ConversionError: if GHDL refuses the sources.
        ToolMissingError: if there is no GHDL that can be used.
    """
    return released(name, about, top, to_verilog(top, generics).read_text(), vhdl_sources())


def released(name: str, about: Sequence[str], top: str, verilog: str, sources: Sequence[Path]) -> str:
    """Return the file of a converted entity as the module `name`.

    Args:
        name: as in `release`.
        about: as in `release`.
        top: name of the entity.
        verilog: GHDL's Verilog.
        sources: all VHDL, including that of the entity.
    """
    text = _without_words(with_names(verilog, sources))
    found = ports(text, top, top, sources)
    lines = [
        *([] if LICENCE in about else [LICENCE, ""]),
        *about,
        "",
        f"A netlist in Verilog-2005, converted by GHDL from the VHDL of Unity-Link {unity_link.__version__}: its",
        "generics are fixed. To read or change the design, use the VHDL.",
        "",
        "To instantiate it (after `or`: the constant for an input that the design does not use):",
        "",
        *_instance_template(name, found),
    ]
    head = "".join(f"// {line}".rstrip() + "\n" for line in lines)
    body = "\n".join(line.rstrip() for line in _named(text, top, name).replace("\t", " ").splitlines())
    off, on = ("".join(f"/* verilator lint_{way} {rule} */\n" for rule in _NEEDLESS) for way in ("off", "on"))
    return f"{head}\n{off}\n{body}\n\n{on}"


def ports(verilog: str, module: str, entity: str, sources: Sequence[Path]) -> list[ModulePort]:
    """Return the ports of an entity's module, with their defaults in the entity's VHDL."""
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
    """Return Verilog in which keywords of SystemVerilog have the suffix ``_x``, as in generated VHDL.

    Escaping with a backslash would be legal, but Verilator 5.006 refuses an escaped ``super``.
    """
    ending = "_x"
    while re.search(rf"\b({'|'.join(SYSTEMVERILOG)}){ending}\b", text):
        ending += "_x"
    return _WORD.sub(lambda found: f"{found[1]}{ending}" if found[1] else found[0], text)


def _named(text: str, top: str, name: str) -> str:
    """Return a design whose top has a given name; other modules are named after it and their entity."""
    names: dict[str, str] = {}
    for module in _MODULE.findall(text):
        wanted = name if module == top else f"{name}_{SETTINGS.sub('', module)}"
        number = sum(SETTINGS.sub("", known) == SETTINGS.sub("", module) for known in names)
        names[module] = f"{wanted}_{number + 1}" if number else wanted
    return _MENTION.sub(lambda mention: mention[1] + names.get(mention[2], mention[2]), text)

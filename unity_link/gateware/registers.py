"""Restores the VHDL names and attributes of registers in converted Verilog.

GHDL names registers by numbers and drops attributes. Constraints, however, find a register by its name, and attributes
keep vendors' tools from optimising registers of clock domain crossings.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

_MODULE = re.compile(r"^module (\w+)$.*?^endmodule$", re.MULTILINE | re.DOTALL)
# Suffix that GHDL appends to the name of an entity with generics.
SETTINGS = re.compile(r"(_(\d+|[0-9a-f]{40}))+$")
_REGISTER = re.compile(r"^  reg ((?:\[\d+:0\] )?)(n\d+_(?:q|data));.*\n", re.MULTILINE)
_NAMED = re.compile(r"^  assign (\w+) = (n\d+_(?:q|data)); // ?\((signal|module output)\)\n", re.MULTILINE)
_ROW = re.compile(r"^  assign (\w+) = (n\d+_o); // \(signal\)$", re.MULTILINE)
_ATTRIBUTE = re.compile(r'^ *attribute (\w+) of ([\w, ]+?) *: signal is\s+("[^"]*"|true);', re.MULTILINE)
_FOR_SYNPLIFY = "syn_"
"""Prefix of attributes that some tools read only from comments."""


def with_names(verilog: str, sources: Iterable[Path]) -> str:
    """Return a design whose registers have the names and attributes of their VHDL signals or ports.

    Args:
        verilog: the design as GHDL writes it.
        sources: the VHDL.
    """
    attributes = {path.stem: found for path in sources if (found := _attributes(path.read_text()))}
    return _MODULE.sub(lambda module: _renamed(module[0], attributes.get(SETTINGS.sub("", module[1]), {})), verilog)


def _attributes(vhdl: str) -> dict[str, dict[str, str]]:
    """Return the attributes of each signal; values are in Verilog."""
    found: dict[str, dict[str, str]] = {}
    for attribute, signals, value in _ATTRIBUTE.findall(vhdl):
        for name in signals.split(","):
            found.setdefault(name.strip(), {})[attribute] = "1" if value == "true" else value
    return found


def _renamed(module: str, attributes: dict[str, dict[str, str]]) -> str:
    names: dict[str, str] = {}
    outputs: set[str] = set()
    # If a register is a signal and a port, use the signal's name; the signal drives the port.
    for name, register, kind in sorted(_NAMED.findall(module), key=lambda found: found[2] != "signal"):
        if register not in names:
            names[register] = name
            alias = rf"^  (?:wire (?:\[\d+:0\] )?{name};|assign {name} = {register}; //.*)\n"
            module = re.sub(alias, "", module, flags=re.MULTILINE)
            if kind == "module output":
                outputs.add(register)
                module = re.sub(rf"\boutput (?=(?:\[\d+:0\] )?{name}\b)", "output reg ", module, count=1)
    given = {register: attributes.get(name, {}) for register, name in names.items()}
    for signal, row in _ROW.findall(module):
        elements = re.search(rf"^  assign {row} = {{(.*)}};$", module, re.MULTILINE)
        for place, register in enumerate(elements[1].split(", ") if elements and signal in attributes else (), 1):
            if register not in names and _REGISTER.search(f"  reg {register};\n"):
                names[register], given[register] = f"{signal}_{place}", attributes[signal]

    def declared(register: re.Match[str]) -> str:
        width, name = register.groups()
        return "" if name in outputs else _declaration(width, name, given[name]) if name in names else register[0]

    module = _REGISTER.sub(declared, module)
    return re.sub(r"\bn\d+_(?:q|data)\b", lambda found: names.get(found[0], found[0]), module)


def _declaration(width: str, name: str, attributes: dict[str, str]) -> str:
    """Return a register's declaration, preceded by its attributes."""
    if not attributes:
        return f"  reg {width}{name};\n"
    told = ", ".join(f"{attribute} = {value}" for attribute, value in attributes.items())
    comment = " ".join(f"{key}={value}" for key, value in attributes.items() if key.startswith(_FOR_SYNPLIFY))
    return f"  (* {told} *)\n  reg {width}{name} /* synthesis {comment} */;\n"

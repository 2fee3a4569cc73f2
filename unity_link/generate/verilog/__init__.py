"""Verilog: a gateway with the register bank of an interface, for those who have no VHDL, one file for each medium.

The VHDL of the target ``vhdl`` is converted, behind an entity that has a port for each signal, because Verilog-2005
knows no records (`flat.vhd.jinja`).
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from unity_link.gateware.release import release
from unity_link.generate import GeneratedFile, write
from unity_link.generate.verilog.flat import flat_ports
from unity_link.generate.vhdl import FILTERS as VHDL_FILTERS
from unity_link.generate.vhdl import files as vhdl_files
from unity_link.generate.vhdl.bank import Bank
from unity_link.generate.vhdl.names import identifier

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.generate import Templates
    from unity_link.spec import Interface

DOC = "Verilog: gateway and register bank as a netlist, one file for each medium; needs GHDL"
_MEDIA = {
    "uart": "a UART of 1 Mbaud",
    "ft245": "an FT245 (asynchronous)",
    "ft245_sync": "an FT245 (synchronous)",
}


def files(interface: Interface, templates: Templates) -> Iterator[GeneratedFile]:
    """Make the files of an interface.

    Raises:
        ConversionError: if GHDL refuses the sources.
        ToolMissingError: if there is no GHDL of version 4 or later.
        UnsupportedError: where addresses belong to two modules alike.
    """
    name = identifier(interface.name)
    bank = Bank(interface)
    vhdl = list(vhdl_files(interface, templates.of("vhdl", VHDL_FILTERS)))
    wanted = {f"{name}_{part}.vhd" for part in ("map", "registers", "gateway")}
    flat = templates.render("flat.vhd", prefix=name, bank=bank, interface=interface, ports=list(flat_ports(bank)))
    with tempfile.TemporaryDirectory() as scratch:
        sources = [*(file for file in vhdl if file.name in wanted), GeneratedFile(f"{name}_flat.vhd", flat)]
        paths = write(sources, Path(scratch))
        for medium, described in _MEDIA.items():
            about = [*templates.origin, "", f"The gateway of {interface.name} on {described}, at 50 MHz."]
            text = release(f"{name}_on_{medium}", about, f"{name}_flat", {"physical": medium}, paths)
            yield GeneratedFile(f"{name}_on_{medium}.v", text)

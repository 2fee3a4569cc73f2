"""Verilog: a gateway with the register bank of an interface, for users without VHDL; one file for each medium.

The VHDL of the target ``vhdl`` is converted. Verilog-2005 has no records, so an entity with a port for each signal is
put around the gateway (`flat.vhd.jinja`).
"""

from __future__ import annotations

import logging
from typing import TYPE_CHECKING, NamedTuple

from unity_link.errors import ArgumentError
from unity_link.gateware.cache import vhdl_sources
from unity_link.gateware.convert import to_verilog
from unity_link.gateware.external import temporary_folder
from unity_link.gateware.limits import check_generics
from unity_link.gateware.own_vhdl import convert_own, read_own
from unity_link.gateware.release import released
from unity_link.generate import GeneratedFile, write
from unity_link.generate.verilog.flat import MEDIA, OtherPort, flat_ports, pads, triggers
from unity_link.generate.vhdl import FILTERS as VHDL_FILTERS
from unity_link.generate.vhdl import files as vhdl_files
from unity_link.generate.vhdl import gateway_generics
from unity_link.generate.vhdl.bank import Bank
from unity_link.generate.vhdl.names import identifier
from unity_link.quoting import hdl_comment

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from unity_link.generate import Templates
    from unity_link.spec import Interface

log = logging.getLogger("unity_link.generate")
DOC = "Verilog: gateway and register bank as a netlist, one file for each medium; needs GHDL"
_MEDIA = {
    "uart": "a UART of {baud} baud",
    "ft245": "an FT245 (asynchronous)",
    "ft245_sync": "an FT245 (synchronous)",
}
_GENERICS = {
    "physical": 'string := "uart"',
    "clock_hz": "positive := 50_000_000",
    "baud": "positive := 1_000_000",
}


class Options(NamedTuple):
    """Generics that are fixed in the Verilog netlist, so that the user sets them here."""

    clock_hz: int = 50_000_000
    """Frequency of `clk` in Hz."""
    baud: int = 1_000_000
    """Baud rate of the UART."""
    unchecked: bool = False
    """True if the VHDL of the spec's own cores is not compared with its conversion."""


def files(interface: Interface, templates: Templates, options: Options) -> Iterator[GeneratedFile]:
    """Yield the Verilog files of an interface.

    Raises:
        ArgumentError: if the gateware does not support the clock or the baud rate.
        ConversionError: if GHDL rejects the sources, or converts a core of the user wrongly.
        ToolMissingError: if GHDL 4 or later, or Yosys for cores of the user, is not installed.
        UnsupportedError: if two modules have the same addresses.
    """
    name = identifier(interface.name)
    clock = {"clock_hz": options.clock_hz, "baud": options.baud}
    if min(clock.values()) <= 0:
        raise ArgumentError(f"clock_hz is {options.clock_hz} and baud {options.baud}: more than 0 was expected of both")
    check_generics({**gateway_generics(interface), **clock})
    groups = int(gateway_generics(interface)["groups"])
    sources = flat_design(interface, templates, _GENERICS, [*MEDIA, triggers(groups)])
    origin = list(map(hdl_comment, templates.origin))
    with temporary_folder() as scratch:
        paths = write(sources, scratch)
        own = read_own(None, templates.vhdl)._replace(unchecked=options.unchecked) if templates.vhdl else None
        remarks: dict[str, None] = {}
        for medium, described in _MEDIA.items():
            link = described.format(baud=options.baud)
            about = [
                *origin,
                "",
                f"The gateway of {interface.name} on {link}, at {options.clock_hz / 1e6:g} MHz.",
            ]
            top = f"{name}_flat"
            generics: dict[str, int | str] = {"physical": medium, **clock}
            if own is None:
                verilog = to_verilog(top, generics, paths).read_text()
            else:
                instances = Bank(interface).wiring.own_instances(options.clock_hz)
                converted = convert_own(own, generics, paths, None, top, instances)
                verilog = converted.verilog
                remarks |= dict.fromkeys(converted.remarks)
            text = released(f"{name}_on_{medium}", about, top, verilog, [*paths, *templates.vhdl, *vhdl_sources()])
            yield GeneratedFile(f"{name}_on_{medium}.v", text)
    for remark in remarks:
        log.warning("%s", remark)


def flat_design(
    interface: Interface,
    templates: Templates,
    generics: Mapping[str, str],
    others: Sequence[OtherPort],
    *,
    has_pads: bool = False,
) -> list[GeneratedFile]:
    """Return the VHDL of a gateway with its register bank inside the entity ``NAME_flat``, which has no records.

    Args:
        interface: the interface.
        templates: templates of this target.
        generics: generics of the gateway that the entity has, with type and default.
        others: ports of the gateway that the entity has besides those of the signals and of the Wishbone masters.
        has_pads: connect the output of an INOUT pin back to its input while the pin drives, like a pad.

    Raises:
        UnsupportedError: if two modules have the same addresses.
    """
    name, bank = identifier(interface.name), Bank(interface)
    wanted = {f"{name}_{part}.vhd" for part in ("map", "registers", "gateway")}
    vhdl = vhdl_files(interface, templates.of("vhdl", VHDL_FILTERS), whole=False)
    flat = templates.render(
        "flat.vhd",
        prefix=name,
        bank=bank,
        interface=interface,
        generics=generics,
        others=others,
        ports=list(flat_ports(bank, others)),
        pads=pads(bank, others) if has_pads else [],
    )
    return [*(file for file in vhdl if file.name in wanted), GeneratedFile(f"{name}_flat.vhd", flat)]

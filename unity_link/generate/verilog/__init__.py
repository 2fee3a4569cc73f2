"""Verilog: a gateway with the register bank of an interface, for those who have no VHDL, one file for each medium.

The VHDL of the target ``vhdl`` is converted, behind an entity that has a port for each signal, because Verilog-2005
knows no records (`flat.vhd.jinja`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from unity_link.errors import ArgumentError
from unity_link.gateware.external import temporary_folder
from unity_link.gateware.limits import check_generics
from unity_link.gateware.release import release
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
    """Generics that a netlist has no more, and the user chooses."""

    clock_hz: int = 50_000_000
    """Frequency of `clk`."""
    baud: int = 1_000_000
    """Baud of the UART."""


def files(interface: Interface, templates: Templates, options: Options) -> Iterator[GeneratedFile]:
    """Make the files of an interface.

    Raises:
        ArgumentError: where the gateware refuses the clock or the baud rate.
        ConversionError: if GHDL refuses the sources.
        ToolMissingError: if there is no GHDL of version 4 or later.
        UnsupportedError: where addresses belong to two modules alike.
    """
    name = identifier(interface.name)
    if min(options) <= 0:
        raise ArgumentError(f"clock_hz is {options.clock_hz} and baud {options.baud}: more than 0 was expected of both")
    check_generics({**gateway_generics(interface), **options._asdict()})
    groups = int(gateway_generics(interface)["groups"])
    sources = flat_design(interface, templates, _GENERICS, [*MEDIA, triggers(groups)])
    origin = list(map(hdl_comment, templates.origin))
    with temporary_folder() as scratch:
        paths = [*write(sources, scratch), *templates.vhdl]
        for medium, described in _MEDIA.items():
            link = described.format(baud=options.baud)
            about = [
                *origin,
                "",
                f"The gateway of {interface.name} on {link}, at {options.clock_hz / 1e6:g} MHz.",
            ]
            generics = {"physical": medium, **options._asdict()}
            text = release(f"{name}_on_{medium}", about, f"{name}_flat", generics, paths)
            yield GeneratedFile(f"{name}_on_{medium}.v", text)


def flat_design(
    interface: Interface,
    templates: Templates,
    generics: Mapping[str, str],
    others: Sequence[OtherPort],
    *,
    has_pads: bool = False,
) -> list[GeneratedFile]:
    """Return the VHDL of a gateway with its register bank behind the entity ``NAME_flat``, which has no records.

    Args:
        interface: of a spec.
        templates: of this target.
        generics: of the gateway that the entity has, with type and default.
        others: ports of the gateway that the entity has beside those of the signals and of the Wishbone masters.
        has_pads: have a pin of both directions read the level that it drives, as at a pad, where it drives one.

    Raises:
        UnsupportedError: where addresses belong to two modules alike.
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

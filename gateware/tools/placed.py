"""The pins and crossings of a design that nextpnr has placed on an ECP5: read from its netlist.

A pin's registers count only if they are in its I/O cell (`IOLOGIC`), whatever the sources request. A crossing is every
register with data from another clock, or from a pin without a register. A good crossing is a wire from a register to
the first register of a row, in which each register except the last drives only the next one.
"""

from __future__ import annotations

import collections
import dataclasses
import functools
from typing import Any

_REGISTERS = {"FF.INREGMODE": "in", "OUTREG.OUTREGMODE": "out", "TSREG.OUTREGMODE": "driver"}
_DATA = ("DI", "M")
_OUTPUTS = {
    "TRELLIS_FF": ("Q",),
    "TRELLIS_COMB": ("F", "OFX", "FCO", "F1"),
    "TRELLIS_IO": ("O",),
    "IOLOGIC": ("INFF",),
}


@dataclasses.dataclass(frozen=True)
class Pin:
    """Cells at one pin."""

    registers: tuple[str, ...]
    """Registers of its I/O cell: "in", "out" and "driver"."""
    bypassed: bool
    """True if logic of the fabric is connected to the pin itself."""
    delay_steps: int = 0
    """Steps of the I/O cell's delay, in front of the register "in"."""


@dataclasses.dataclass(frozen=True)
class Crossing:
    """All bits that cross to another clock at one place."""

    bits: int
    stages: int
    """Registers in series; 0 if the crossing is not a plain wire, or if logic uses a register before the last one."""
    longest_ns: float
    """Longest delay between the two clocks."""
    skew_ns: float
    """Difference between the delays of the bits."""


class Placed:
    """A placed design: nextpnr's netlist (`--write`) and its report with the delays of all nets."""

    def __init__(self, netlist: dict[str, Any], report: dict[str, Any]) -> None:
        """Store the netlist and the report of nextpnr."""
        (self._module,) = netlist["modules"].values()
        self._cells: dict[str, dict[str, Any]] = self._module["cells"]
        self._driver: dict[int, str] = {}
        self._loads: dict[int, list[tuple[str, str]]] = collections.defaultdict(list)
        for name, cell in self._cells.items():
            outputs = {port for port, way in cell["port_directions"].items() if way == "output"}
            for port, bits in cell["connections"].items():
                for bit in bits:
                    if port in outputs:
                        self._driver[bit] = name
                    else:
                        self._loads[bit].append((name, port))
        self._delay = {
            endpoint["cell"]: max(endpoint["delay"])
            for net in report["detailed_net_timings"]
            for endpoint in net["endpoints"]
            if endpoint["port"] in _DATA
        }

    def pins(self) -> dict[str, Pin]:
        """Return the cells at each pin, by its name."""
        names = {
            bit: f"{name}[{index}]" if len(port["bits"]) > 1 else name
            for name, port in self._module["ports"].items()
            for index, bit in enumerate(port["bits"])
        }
        found: dict[str, Pin] = {}
        for cell in self._cells.values():
            if cell["type"] == "TRELLIS_IO":
                found[names[cell["connections"]["B"][0]]] = self._pin(cell)
        return found

    def _pin(self, pad: dict[str, Any]) -> Pin:
        at = {port: bits[0] for port, bits in pad["connections"].items() if bits}
        outside = [self._driver.get(at[port]) for port in ("I", "T") if port in at]
        readers = [name for name, _ in self._loads[at["O"]]] if "O" in at else []
        logic = {*readers, *(self._driver[at[port]] for port in ("IOLDO", "IOLTO") if port in at)}
        cells = [name for name in logic if self._cells[name]["type"] == "IOLOGIC"]
        modes = self._cells[cells[0]]["parameters"] if cells else {}
        registers = tuple(what for parameter, what in _REGISTERS.items() if modes.get(parameter) == "FF")
        bypassed = bool([*outside, *(name for name in readers if name not in cells)])
        return Pin(registers, bypassed=bypassed, delay_steps=int(modes.get("DELAY.DEL_VALUE", "0"), 2))

    def crossings(self) -> dict[str, Crossing]:
        """Return the crossings, except those of resets and memories, by the place of their first registers."""
        found: dict[str, list[str]] = collections.defaultdict(list)
        for name, cell in self._cells.items():
            if cell["type"] == "TRELLIS_FF" and any(clock != self._clock(cell) for clock in self._sources(name)):
                found[_place(name)].append(name)
        return {place: self._crossing(names) for place, names in sorted(found.items())}

    def _crossing(self, names: list[str]) -> Crossing:
        delays = [self._delay.get(name, 0.0) for name in names]
        return Crossing(
            bits=len(names),
            stages=min(self._row(name) if self._on_a_wire(name) else 0 for name in names),
            longest_ns=round(max(delays), 2),
            skew_ns=round(max(delays) - min(delays), 2),
        )

    def _sources(self, name: str) -> set[int | None]:
        """Return the clocks of the registers on which a register's data depends, without memories; None for a pin."""
        cell = self._cells[name]
        return functools.reduce(set.union, (self._clocks_behind(bit) for bit in _data_bits(cell)), set[int | None]())

    def _clocks_behind(self, bit: int) -> set[int | None]:
        found: set[int | None] = set()
        seen: set[int] = set()
        open_bits = [bit]
        while open_bits:
            bit = open_bits.pop()
            if bit in seen or bit not in self._driver:
                continue
            seen.add(bit)
            cell = self._cells[self._driver[bit]]
            if cell["type"] == "TRELLIS_COMB":
                if cell["parameters"].get("MODE") != "DPRAM":
                    inputs = (port for port, way in cell["port_directions"].items() if way == "input")
                    open_bits += [bits[0] for port in inputs if (bits := cell["connections"].get(port))]
            elif cell["type"] in ("TRELLIS_FF", "IOLOGIC"):
                found.add(self._clock(cell))
            elif cell["type"] == "TRELLIS_IO":
                found.add(None)
        return found

    def _on_a_wire(self, name: str) -> bool:
        driven = [bit for bit in _data_bits(self._cells[name]) if bit in self._driver]
        drivers = [self._cells[self._driver[bit]]["type"] for bit in driven]
        return drivers in (["TRELLIS_FF"], ["TRELLIS_IO"], ["IOLOGIC"])

    def _row(self, name: str) -> int:
        """Return the number of registers in series from this one on; each drives only the next one."""
        stages = 1
        while True:
            loads = self._loads[self._cells[name]["connections"]["Q"][0]]
            cells = [self._cells[load] for load, _ in loads]
            if len(loads) != 1 or cells[0]["type"] != "TRELLIS_FF" or loads[0][1] not in _DATA:
                return stages
            if self._clock(cells[0]) != self._clock(self._cells[name]):
                return stages
            stages, name = stages + 1, loads[0][0]

    @staticmethod
    def _clock(cell: dict[str, Any]) -> int | None:
        bits = cell["connections"].get("CLK")
        return bits[0] if bits else None


def gowin_registers(netlist: dict[str, Any]) -> dict[str, int]:
    """Return the number of registers that nextpnr-himbaechel has placed in the I/O cells of a Gowin FPGA, by kind."""
    (module,) = netlist["modules"].values()
    attributes = [cell["attributes"] for cell in module["cells"].values()]
    kinds = {"in": "IREG_TYPE", "out": "OREG_TYPE", "driver": "TREG_TYPE"}
    return {what: sum(kind in own for own in attributes) for what, kind in kinds.items()}


def _data_bits(cell: dict[str, Any]) -> list[int]:
    return [bits[0] for port in _DATA if (bits := cell["connections"].get(port))]


def _place(name: str) -> str:
    """Return the place of a register in the hierarchy: its name without the last part."""
    return name.rpartition(".")[0]

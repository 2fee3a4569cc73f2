"""Compares the Verilog of a user's entity with GHDL's simulation of its VHDL, on random inputs.

Both get the same inputs step by step, including the clocks: a bench reads them from a file for GHDL, and `netlist` runs
the Verilog. Output bits that are neither '0' nor '1' in the simulation are not compared.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NamedTuple

from unity_link.gateware import yowasp
from unity_link.gateware.design import ConversionError
from unity_link.gateware.netlist import NetPort, netlist_of, part_of, ports_of
from unity_link.gateware.random_inputs import Input, RandomInputs

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    from unity_link.gateware.design import GhdlDesign
    from unity_link.gateware.netlist import Netlist, Unknown

CYCLES = 4000
"""Number of cycles to compare, for a small entity."""
_LEAST_CYCLES = 300
_OPERATIONS = 15_000_000
"""Limit on the operations of the Verilog's logic in one comparison, so that a comparison takes only seconds."""
_TRIES = 4
"""Number of seeds to try if a simulation ends early, for example because an integer leaves its range."""
_UNASSIGNED = re.compile(r"^  localparam (?:\[\d+:0\] )?(\w+) = \d+'bZ;", re.MULTILINE)
_KNOWN = str.maketrans("UXZW-01LH", "000001111")
_VALUE = str.maketrans("UXZW-01LH", "000000101")
_TYPES = {
    "std_ulogic": "{}",
    "std_ulogic_vector": "{}",
    "unresolved_unsigned": "unsigned({})",
    "unresolved_signed": "signed({})",
}
_BENCH = """\
library ieee;
  use ieee.std_logic_1164.all;
  use ieee.numeric_std.all;

library std;
  use std.textio.all;

library {library};

entity ul_bench is
end entity ul_bench;

architecture sim of ul_bench is
  signal ul_given : std_logic_vector({givens} downto 0) := (others => '0');
  signal ul_shown : std_logic_vector({shows} downto 0);
begin

  ul_unit : entity {library}.{entity}{generics}
    port map (
      {ports}
    );

  main : process is
    file steps, seen : text;
    variable words   : line;
    variable given   : bit_vector({givens} downto 0);
  begin
    file_open(steps, "{steps}", read_mode);
    file_open(seen, "{seen}", write_mode);
    while not endfile(steps) loop
      readline(steps, words);
      read(words, given);
      ul_given <= to_stdlogicvector(given);
      wait for 1 us;
      write(words, to_string(ul_given) & " " & to_string(ul_shown));
      writeline(seen, words);
    end loop;
    file_close(seen);
    wait;
  end process main;

end architecture sim;
"""


class Subject(NamedTuple):
    """A user's entity in a design."""

    entity: str
    place: str
    """Name of its file."""
    module: str
    """Name of its module in the Verilog."""
    generics: Mapping[str, str]
    """Values of its generics in VHDL."""
    library: str = "work"
    """Its library."""


class Deviation(NamedTuple):
    """An output whose value differs from the simulation."""

    output: str
    cycle: int
    simulated: str
    """Bits in the simulation."""
    converted: str
    """Bits in the Verilog."""
    given: Mapping[str, str]
    """Bits of the inputs."""


class UncomparedError(ConversionError):
    """An entity cannot be compared; the message is the reason."""


def compare(subject: Subject, types: Mapping[str, str], design: GhdlDesign, verilog: str, folder: Path) -> int:
    """Compare an entity with its Verilog; return the number of cycles.

    Args:
        subject: the entity.
        types: base types of its ports, by port name.
        design: all sources; the entity must be analysed already.
        verilog: the design in Verilog.
        folder: a folder for intermediate files.

    Raises:
        ConversionError: if they differ.
        ToolMissingError: if Yosys is not installed.
        UncomparedError: if they cannot be compared.
    """
    comparison = Comparison(subject, types, design, verilog, folder)
    deviations = comparison.deviations()
    if deviations:
        raise ConversionError(_sentence(subject, deviations))
    return comparison.cycles


class Comparison:
    """A comparison of an entity with its Verilog.

    Attributes:
        cycles: number of cycles compared so far.
    """

    def __init__(
        self, subject: Subject, types: Mapping[str, str], design: GhdlDesign, verilog: str, folder: Path
    ) -> None:
        self.cycles = 0
        self._phases = 1
        self._subject = subject
        self._design = design
        self._verilog = verilog
        self._folder = folder
        self._ports = ports_of(verilog, subject.module)
        for port in self._ports:
            kind = types.get(port.name.lower(), "")
            if kind not in _TYPES:
                raise UncomparedError(f"its port {port.name} has the type {kind or 'of a record or an array'}")
        self._inputs = [port for port in self._ports if port.way != "output"]
        self._outputs = [port for port in self._ports if port.way == "output"]
        if not self._outputs:
            raise UncomparedError("it has no outputs")
        try:
            self._netlist = self._read("-zero")
        except yowasp.RefusedError as error:
            raise UncomparedError(str(error)) from error
        self._bench(types)

    def deviations(self, seed: int = 0) -> list[Deviation]:
        """Return the first deviation of each output that differs.

        Raises:
            UncomparedError: if the simulation ends before enough cycles, or has no value for an output.
        """
        wanted = min(CYCLES, max(_LEAST_CYCLES, _OPERATIONS // max(self._netlist.operations, 1)))
        known: dict[str, int] = dict.fromkeys((port.name for port in self._outputs), 0)
        reason = ""
        for attempt in range(_TRIES):
            steps = self._steps(wanted, seed * _TRIES + attempt, tame=attempt % 2 == 1)
            self._phases = len(steps) // wanted
            seen, reason = self._simulated(steps)
            found = self._differing(seen, known)
            if found:
                return found
            self.cycles += len(seen) // self._phases
            if self.cycles >= wanted:
                break
        if self.cycles < _LEAST_CYCLES:
            raise UncomparedError(f"its simulation ends after {self.cycles} cycles of random inputs: {reason}")
        self._check_known(known)
        return []

    def _read(self, unknown: Unknown) -> Netlist:
        return netlist_of(self._verilog, self._subject.module, unknown)

    def _bench(self, types: Mapping[str, str]) -> None:
        """Add the bench of the entity to the design."""
        maps: list[str] = []
        for ports, vector in ((self._inputs, "ul_given"), (self._outputs, "ul_shown")):
            place = sum(port.width for port in ports)
            for port in ports:
                place -= port.width
                kind = types[port.name.lower()]
                one = f"{vector}({place})"
                part = one if kind == "std_ulogic" else f"{vector}({place + port.width - 1} downto {place})"
                outer, inner = _TYPES[kind].format(part), port.name
                if port.way != "input" and kind not in ("std_ulogic", "std_ulogic_vector"):
                    inner, outer = f"std_logic_vector({inner})", part
                maps.append(f"{inner} => {outer}")
        generics = ", ".join(f"{name} => {value}" for name, value in self._subject.generics.items())
        bench = _BENCH.format(
            library=self._subject.library,
            entity=self._subject.entity,
            generics=f" generic map ({generics})" if generics else "",
            ports=",\n      ".join(maps),
            givens=max(sum(port.width for port in self._inputs), 1) - 1,
            shows=sum(port.width for port in self._outputs) - 1,
            steps=self._folder / "steps",
            seen=self._folder / "seen",
        )
        self._design.add("ul_bench.vhd", bench)
        self._design.make("ul_bench")

    def _steps(self, cycles: int, seed: int, *, tame: bool) -> list[tuple[int, ...]]:
        inputs = [Input(port.name, port.width, port.name in self._netlist.clocks) for port in self._inputs]
        part = part_of(self._verilog, self._subject.module)
        made = RandomInputs(inputs, self._netlist.constants, seed, both_edges="negedge" in part, tame=tame)
        return list(made.steps(cycles))

    def _simulated(self, steps: Sequence[tuple[int, ...]]) -> tuple[list[tuple[str, str]], str]:
        """Return the bits of all inputs and outputs after each step, and the reason if the simulation ended early."""
        widths = [port.width for port in self._inputs]
        rows = ("".join(f"{value:0{width}b}" for value, width in zip(step, widths, strict=True)) for step in steps)
        (self._folder / "steps").write_text("".join(f"{row or '0'}\n" for row in rows))
        (self._folder / "seen").unlink(missing_ok=True)
        reason = self._design.simulate("ul_bench")
        lines = (self._folder / "seen").read_text().splitlines() if (self._folder / "seen").exists() else []
        seen = [(given, shown) for given, _, shown in (line.partition(" ") for line in lines)]
        size = sum(port.width for port in self._outputs)
        return [row for row in seen if len(row[1]) == size], reason

    def _converted(self, seen: Sequence[tuple[str, str]], circuit: Netlist, unknown: str) -> list[dict[str, int]]:
        """Return the outputs of the Verilog after each step.

        Args:
            seen: bits of the inputs and outputs after each step of the simulation.
            circuit: the Verilog.
            unknown: bit that replaces input bits without a value.
        """
        state = circuit.start()
        found = []
        others = str.maketrans("UXZW-LH", unknown * 5 + "01")
        names = [port.name for port in self._inputs]
        for given, _ in seen:
            bits = given if given.isdigit() else given.translate(others)
            values = dict(zip(names, _cut(bits, self._inputs), strict=True))
            outputs, state = circuit.step([int(values[name], 2) for name in circuit.inputs], state)
            found.append(dict(zip(circuit.outputs, outputs, strict=True)))
        return found

    def _differing(self, seen: Sequence[tuple[str, str]], known: dict[str, int]) -> list[Deviation]:
        """Return the first deviation of each output that differs; add to `known` the bits that were '0' or '1'."""
        converted = self._converted(seen, self._netlist, "0")
        suspects: dict[str, list[int]] = {}
        for step, ((_, shown), values) in enumerate(zip(seen, converted, strict=True)):
            for port, bits in zip(self._outputs, _cut(shown, self._outputs), strict=True):
                mask = int(bits.translate(_KNOWN), 2)
                known[port.name] |= mask
                if (int(bits.translate(_VALUE), 2) ^ values[port.name]) & mask:
                    suspects.setdefault(port.name, []).append(step)
        if not suspects:
            return []
        # Ignore bits that change with the values assumed for unknown bits.
        others = [self._converted(seen, self._read("-one"), "1"), self._converted(seen, self._read("-random 1"), "1")]
        found = []
        for port in self._outputs:
            for step in suspects.get(port.name, ()):
                bits = _cut(seen[step][1], self._outputs)[self._outputs.index(port)]
                mask, value = int(bits.translate(_KNOWN), 2), int(bits.translate(_VALUE), 2)
                for other in (converted, *others):
                    mask &= other[step][port.name] ^ value
                if mask:
                    names = (one.name for one in self._inputs)
                    given = dict(zip(names, _cut(seen[step][0], self._inputs), strict=True))
                    other_bits = f"{converted[step][port.name]:0{port.width}b}"
                    found.append(Deviation(port.name, step // self._phases, bits, other_bits, given))
                    break
        return found

    def _check_known(self, known: Mapping[str, int]) -> None:
        """Raise `UncomparedError` if the VHDL assigns an output, but the output never has a value in simulation."""
        part = part_of(self._verilog, self._subject.module)
        unassigned = set(_UNASSIGNED.findall(part))
        for port in self._outputs:
            driver = re.search(rf"^  assign \\?{port.name} ?= (\w+); //\(module output\)$", part, re.MULTILINE)
            if not known[port.name] and not (driver and driver[1] in unassigned):
                raise UncomparedError(
                    f"its output {port.name} is never '0' or '1': reset its registers, or give them initial values"
                )


def _cut(bits: str, ports: Sequence[NetPort]) -> list[str]:
    """Divide a string of bits into those of each port."""
    parts, start = [], 0
    for port in ports:
        parts.append(bits[start : start + port.width])
        start += port.width
    return parts


def _sentence(subject: Subject, deviations: Sequence[Deviation]) -> str:
    first = deviations[0]
    inputs = ", ".join(f"{name} = {bits}" for name, bits in list(first.given.items())[:6])
    more = f" (and {len(deviations) - 1} more outputs)" if deviations[1:] else ""
    return (
        f"{subject.place}: GHDL makes another circuit of the entity {subject.entity}: in cycle {first.cycle} of random "
        f"inputs its output {first.output} is {first.simulated} in simulation and {first.converted} in the Verilog "
        f"for {inputs}{more}"
    )

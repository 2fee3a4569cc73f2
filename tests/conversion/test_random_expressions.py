"""A random expression in a user's entity is either converted to the same circuit, or refused.

An entity with many expressions is converted and checked as by `build`. Icarus Verilog then simulates the expressions
that passed, with other inputs.
"""

from __future__ import annotations

import random
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path
from typing import NamedTuple

import pytest

from support.random_vhdl import HEAD, Entity, Expression, entity
from unity_link.gateware.comparing import Comparison, Subject
from unity_link.gateware.design import ConversionError, GhdlDesign, OwnFile
from unity_link.gateware.entity import SyntaxTree
from unity_link.gateware.refused import INTEGER_MINUS_SIGNED, refusals

EXPRESSIONS = 40
"""Expressions in an entity."""
VECTORS = 300
"""Inputs for the simulation by Icarus Verilog."""
pytestmark = [
    pytest.mark.rtl,
    pytest.mark.skipif(shutil.which("iverilog") is None, reason="no Icarus Verilog: apt install iverilog"),
]


class Judged(NamedTuple):
    """Outcomes of the expressions of an entity."""

    counts: Counter[str]
    wrong: list[str]
    """Wrong expressions that passed the checks, each with an example."""


def converted(found: Entity, folder: Path, counts: Counter[str]) -> tuple[Entity, GhdlDesign, str]:
    """Return an entity without the expressions that GHDL or `refusals` refuse, with its sources and its Verilog."""
    while True:
        text = found.text()
        design = GhdlDesign(Path(tempfile.mkdtemp(dir=folder)), own=[OwnFile(Path("mine.vhd"), text.encode())])
        try:
            design.make(found.name)
            verilog = design.verilog(found.name, {})
        except ConversionError as error:
            lines = {int(line) for line in re.findall(r"mine\.vhd:(\d+)", str(error))}
            # GHDL reports no line for an internal error: try each expression by itself.
            refused = _at(lines, text) or {one.name for one in found.outputs if is_refused(found, one, folder)}
            counts["refused by GHDL"] += len(refused)
        else:
            turned = SyntaxTree(design.description(*design.copies.values())).operators(INTEGER_MINUS_SIGNED)
            wrong = refusals(verilog, design, lambda: design.netlist(found.name, {}), turned)  # noqa: B023
            refused = _at({int(refusal.place.split(":")[1]) for refusal in wrong}, text)
            counts["refused by its place"] += len(refused)
            if not refused:
                return found, design, verilog
        assert refused
        found = found.without(refused)


def _at(lines: set[int], text: str) -> set[str]:
    """Return the outputs that are assigned on the given lines."""
    return {text.splitlines()[line - 1].split()[0] for line in lines}


def is_refused(found: Entity, one: Expression, folder: Path) -> bool:
    """Return True if GHDL refuses an entity that has only this expression."""
    text = found._replace(outputs=[one]).text()
    design = GhdlDesign(Path(tempfile.mkdtemp(dir=folder)), own=[OwnFile(Path("mine.vhd"), text.encode())])
    try:
        design.make(found.name)
        design.verilog(found.name, {})
    except ConversionError:
        return True
    return False


def judge(seed: int, folder: Path) -> Judged:
    """Convert and check an entity of random expressions; compare those that pass with Icarus Verilog."""
    counts: Counter[str] = Counter()
    found, design, verilog = converted(entity("mine", seed, EXPRESSIONS), folder, counts)
    types = {
        name: port.base
        for name, port in SyntaxTree(design.description(*design.copies.values())).entities()["mine"].ports.items()
    }
    comparison = Comparison(Subject("mine", "mine.vhd", "mine", {}), types, design, verilog, folder)
    differing = {deviation.output for deviation in comparison.deviations(seed)}
    counts["refused by comparison"] += len(differing)
    counts["passed"] += len(found.outputs) - len(differing)
    simulated, in_icarus = outputs(found, design, verilog, random.Random(seed), folder)
    wrong = []
    for one in found.outputs:
        if one.name not in differing:
            pairs = zip(simulated[one.name], in_icarus[one.name], strict=True)
            different = [(first, second) for first, second in pairs if set(first) <= {"0", "1"} and first != second]
            wrong += [f"seed {seed}: {one.text} is {different[0]}" for _ in different[:1]]
    return Judged(counts, wrong)


def outputs(
    found: Entity, design: GhdlDesign, verilog: str, chance: random.Random, folder: Path
) -> tuple[dict[str, list[str]], dict[str, list[str]]]:
    """Return the bits of all outputs for random inputs: of the VHDL by GHDL, and of the Verilog by Icarus Verilog."""
    inputs = {f"i_{name}": width for name, (_, width) in found.inputs.items()}
    rows = [{name: word(width, chance) for name, width in inputs.items()} for _ in range(VECTORS)]
    names = [*inputs, *(one.name for one in found.outputs)]
    widths = inputs | {one.name: one.width for one in found.outputs}
    signals = "".join(f"  signal {name} : std_logic_vector({width - 1} downto 0);\n" for name, width in widths.items())
    shown = ' & " " & '.join(f"to_string({one.name})" for one in found.outputs)
    steps = "".join(
        "".join(f'{name} <= "{bits}"; ' for name, bits in row.items()) + "wait for 1 ns; show;\n" for row in rows
    )
    design.add(
        "judge.vhd",
        f"{HEAD}use std.textio.all;\nentity judge is end entity;\narchitecture sim of judge is\n{signals}begin\n"
        f"  unit : entity work.mine port map ({', '.join(f'{name} => {name}' for name in names)});\n"
        f'  process\n  file seen : text open write_mode is "{folder / "judged"}";\n  variable words : line;\n'
        f"  procedure show is begin write(words, {shown}); writeline(seen, words); end procedure;\n"
        f"  begin\n{steps}wait; end process;\nend architecture;\n",
    )
    design.make("judge")
    assert design.simulate("judge") == ""
    declared = "".join(
        f"{'reg' if name in inputs else 'wire'} [{width - 1}:0] {name}; " for name, width in widths.items()
    )
    tries = "".join(
        "".join(f"{name} = {len(bits)}'b{bits}; " for name, bits in row.items())
        + f'#1 $display("{" ".join("%b" for _ in found.outputs)}", {", ".join(one.name for one in found.outputs)});\n'
        for row in rows
    )
    ports = ", ".join(f".{name}({name})" for name in names)
    (folder / "judge.v").write_text(
        f"{verilog}\nmodule judge; {declared}\nmine unit({ports});\ninitial begin\n{tries}end endmodule\n"
    )
    subprocess.run(["iverilog", "-g2005", "-s", "judge", "-o", folder / "judge", folder / "judge.v"], check=True)
    said = subprocess.run(["vvp", "-n", folder / "judge"], check=True, capture_output=True, text=True).stdout
    return _columns((folder / "judged").read_text(), found), _columns(said, found)


def word(width: int, chance: random.Random) -> str:
    """Return a random number of a width, often one at a limit."""
    some = [
        chance.getrandbits(width),
        chance.getrandbits(width),
        0,
        -1,
        1 << (width - 1),
        (1 << (width - 1)) - 1,
        1,
        -2,
    ]
    return f"{chance.choice(some) & (1 << width) - 1:0{width}b}"


def _columns(text: str, found: Entity) -> dict[str, list[str]]:
    rows = [line.split() for line in text.splitlines()]
    return {one.name: [row[place] for row in rows] for place, one in enumerate(found.outputs)}


def run(seeds: range, folder: Path) -> None:
    """Judge entities, print the number of each outcome, and fail if a wrong expression passed."""
    counts: Counter[str] = Counter()
    wrong: list[str] = []
    for seed in seeds:
        (folder / str(seed)).mkdir()
        judged = judge(seed, folder / str(seed))
        shutil.rmtree(folder / str(seed))
        counts += judged.counts
        wrong += judged.wrong
    sys.stdout.write(f"{dict(counts)}\n")
    assert wrong == []
    assert counts["passed"] > counts.total() / 3


@pytest.mark.slow
def test_300_random_expressions_are_converted_rightly_or_refused(tmp_path: Path) -> None:
    run(range(300 // EXPRESSIONS + 1), tmp_path)


@pytest.mark.campaign
@pytest.mark.parametrize("hundred", range(25))
def test_100000_random_expressions_are_converted_rightly_or_refused(hundred: int, tmp_path: Path) -> None:
    run(range(1000 + 100 * hundred, 1100 + 100 * hundred), tmp_path)

"""The complexity of an interface in lines, as in the paper: the lines that a user writes for the 18-DOF walker."""

from __future__ import annotations

from pathlib import Path

from benchmarks.paper.results import Lines
from unity_link.generate import generate
from unity_link.spec import compile_file

ROOT = Path(__file__).parents[2]
SPEC = ROOT / "examples" / "walker.ul"
PINS = ROOT / "gateware" / "boards" / "walker" / "ulx3s.lpf"


def count_lines() -> Lines:
    """Count the lines of the walker's interface that are not blank."""
    spec = _lines(SPEC.read_text())
    return Lines(
        spec=len(spec),
        comments=sum(line.startswith("///") for line in spec),
        configuration=0,
        boilerplate=0,
        pins=len(_lines(PINS.read_text())),
        generated=sum(len(_lines(file.text)) for file in generate("vhdl", compile_file(SPEC))),
    )


def _lines(text: str) -> list[str]:
    return [line for line in text.splitlines() if line.strip()]

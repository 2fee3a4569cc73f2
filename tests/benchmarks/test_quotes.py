"""Quotations of the paper in documents: each figure is in `benchmarks.paper.published`.

A quotation is a number with a unit between the word "paper" and the end of its sentence or table cell, or any number
with
a unit in a table column whose head has that word. It may be rounded, and may use another unit of the same kind.
"""

from __future__ import annotations

import re
import subprocess
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import pytest

from benchmarks.paper.published import BURST_ANSWERS, EFFECT, FIGURES, LATENCY, TABLE_1, find

if TYPE_CHECKING:
    from collections.abc import Iterator

ROOT = Path(__file__).parents[2]
SUFFIXES = {".md", ".py", ".ul", ".ipynb", ".vhd", ".toml"}
# For each unit: the unit of the paper, and the factor to convert it.
UNITS: dict[str, tuple[str, float]] = {
    **dict.fromkeys(("s",), ("us", 1e6)),
    "ms": ("us", 1e3),
    "µs": ("us", 1.0),
    "us": ("us", 1.0),
    "ns": ("us", 1e-3),
    "b/s": ("b/s", 1.0),
    "kb/s": ("b/s", 1e3),
    "Kb/s": ("b/s", 1e3),
    "Mb/s": ("b/s", 1e6),
    "Hz": ("Hz", 1.0),
    "kHz": ("Hz", 1e3),
    "MHz": ("Hz", 1e6),
    "Mbaud": ("baud", 1e6),
    "MBaud": ("baud", 1e6),
    "samples a second": ("Hz", 1.0),
    "values a second": ("Hz", 1.0),
    **{unit: (unit, 1.0) for unit in ("bytes", "requests", "messages", "writes", "lines", "minutes", "groups")},
    "%": ("nothing of the paper", 1.0),
}
NUMBER = r"(?<![\w.,#])(\d{1,3}(?:,\d{3})+(?:\.\d+)?|\d+(?:\.\d+)?)"
FIGURE = re.compile(rf"{NUMBER}[ \u00a0-]?({'|'.join(sorted(map(re.escape, UNITS), key=len, reverse=True))})(?!\w)")
# A dot within a link's address does not end a quotation, and a file name with the word begins none.
PROSE = re.compile(r"\bpaper\b(?![\w./]*\.(?:md|py)|/)(.*?)(?=[.;:!?](?:\s|$)|\||\n\s*\n|$(?![\s\S]))", re.DOTALL)


class Quote(NamedTuple):
    text: str
    value: float
    unit: str
    precision: float

    @property
    def right(self) -> bool:
        """Return True if the paper has the figure, rounded to as many digits."""
        values = [value for row in FIGURES if row.unit == self.unit for value in (row.value, row.deviation or 0.0)]
        return any(abs(value - self.value) <= self.precision * (0.5 + 1e-9) for value in values)


def quotes_in(text: str) -> Iterator[Quote]:
    for passage in PROSE.findall(text):
        yield from _figures(re.sub(r"\s*\n\s*(?:#|///?|--)?\s*", " ", passage))
    head: list[str] = []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")] if line.lstrip().startswith("|") else []
        if not head:
            head = cells
        elif not cells:
            head = []
        for name, cell in zip(head, cells, strict=False):
            if re.search(r"\bpaper\b", name) and cells is not head:
                unit = re.search(rf", ({'|'.join(sorted(map(re.escape, UNITS), key=len, reverse=True))})$", name)
                yield from _figures(re.sub(rf"{NUMBER}(?![\d.]| ?[a-zµ%])", rf"\1 {unit[1]}", cell) if unit else cell)


def _figures(text: str) -> Iterator[Quote]:
    for number, name in FIGURE.findall(text):
        unit, scale = UNITS[name]
        decimals = len(number.partition(".")[2])
        yield Quote(f"{number} {name}", float(number.replace(",", "")) * scale, unit, scale * 10.0**-decimals)


def documents() -> list[Path]:
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=False, text=True)
    files = [ROOT / name for name in listed.stdout.split("\0") if name]
    if not files:
        folders = ("docs", "benchmarks", "unity_link", "gateware", "examples")
        files = [ROOT / "README.md", *(file for folder in folders for file in (ROOT / folder).rglob("*"))]
    chosen = [file for file in files if file.suffix in SUFFIXES and "tests" not in file.parts and file.is_file()]
    return [file for file in chosen if file.stat().st_size < 1 << 20 and "paper" in file.read_text(errors="replace")]


@pytest.mark.parametrize("file", documents(), ids=lambda file: str(file.relative_to(ROOT)))
def test_quotations_of_the_paper_have_its_figures(file: Path) -> None:
    wrong = [quote.text for quote in quotes_in(file.read_text()) if not quote.right]
    assert not wrong, (
        f"{file.relative_to(ROOT)} quotes of the paper: {', '.join(wrong)}; benchmarks/paper/published.py has no such "
        "figure (one of ours goes before the word 'paper', or into another sentence)"
    )


def test_documents_that_quote_the_paper_are_checked() -> None:
    names = {str(file.relative_to(ROOT)) for file in documents()}
    assert {"README.md", "docs/paper.md", "docs/gateware.md", "docs/how-to/ft232h.md", "benchmarks/TABLE1.md"} <= names
    for name in ("docs/paper.md", "docs/gateware.md", "benchmarks/TABLE1.md"):
        assert list(quotes_in((ROOT / name).read_text()))


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        ("the paper measured 223.6 µs on its board", []),
        ("the paper measured 224 µs on its board", []),
        ("the paper measured 225 µs on its board", ["225 µs"]),
        ("the paper's stack took 0.65 ms,\nand its bursts 0.89 Mb/s", []),
        ("the paper's stack took 0.66 ms,\n# and its bursts\n# 0.9 Mb/s", ["0.66 ms"]),
        ("a read takes 0.24 ms. The paper's took 0.65 ms. Ours is 0.5 MHz.", []),
        ("1,800 samples a second to ROS are the paper's: 1,900 samples a second", []),
        ("the paper has 1,900 samples a second", ["1,900 samples a second"]),
        ("the paper's walker has 23 lines and 14 lines", []),
        ("the paper's walker has 24 lines", ["24 lines"]),
        ("it fills 1 % in the paper, it fills 1 % of it", ["1 %"]),
        ("| a | the paper |\n|---|---|\n| 5 µs | 1.14 µs |\n| 5 µs | 1.15 µs |\n\nnow 7 µs", ["1.15 µs"]),
        ("| paper, µs | ours |\n|---|---|\n| 974.0 (120) | 7 |\n| 975 (121) | 8 |", ["975 µs", "121 µs"]),
        ("see [the paper's experiment](docs/paper.md), 7 µs of benchmarks/paper.py", ["7 µs"]),
    ],
)  # fmt: skip
def test_a_quotation_that_is_not_the_papers_is_found(text: str, wrong: list[str]) -> None:
    assert [quote.text for quote in quotes_in(text) if not quote.right] == wrong


def test_each_figure_of_table_1_is_listed_once() -> None:
    keys = [(row.what, row.level, row.access, row.mode) for row in FIGURES]
    assert len(keys) == len(set(keys))
    assert {(row.access, row.mode): len(rows_of(row.place)) for row in TABLE_1} == {
        ("read", "off"): 10,
        ("read", "always"): 10,
        ("write", "off"): 12,
        ("write", "always"): 12,
    }
    assert len([row for row in TABLE_1 if row.deviation is not None]) == 10


def rows_of(place: str) -> list[object]:
    return [row for row in TABLE_1 if row.place == place]


def test_a_figure_is_found_by_its_terms() -> None:
    read = find(LATENCY, "full stack", "read", "always")
    assert read is not None
    assert (read.value, read.unit, read.deviation, read.place) == (652, "us", 11.7, "Table I, Read:SI")
    assert find(BURST_ANSWERS, "full stack", "read", "off") is None
    assert find(EFFECT, "low-level", "write", "off") != find(EFFECT, "low-level", "write", "always")

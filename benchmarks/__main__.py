"""Runs all benchmarks and writes their figures to RESULTS.md, with a description of the machine: `make bench`.

With names, as in `python -m benchmarks posts`, only these benchmarks run, and no file is written.
"""

from __future__ import annotations

import argparse
import asyncio
import datetime as dt
import os
import platform
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console
from rich.table import Table

import unity_link
from benchmarks import (
    alternating_samples,
    batch_posts,
    batch_reads,
    block_reads,
    blocking_read,
    c_read,
    command_time,
    concurrent_reads,
    gathered_reads,
    group_reads,
    group_samples,
    import_time,
    many_links,
    memory,
    octave_read,
    posts,
    read_beside_protocol,
    read_beside_spinning,
    samples,
    sequential_read,
    shared_batches,
    shared_link,
)
from benchmarks.measure import RUNS, Row

if TYPE_CHECKING:
    from collections.abc import Callable

BENCHMARKS = (
    sequential_read,
    read_beside_spinning,
    read_beside_protocol,
    blocking_read,
    c_read,
    octave_read,
    concurrent_reads,
    gathered_reads,
    many_links,
    batch_reads,
    posts,
    batch_posts,
    block_reads,
    samples,
    alternating_samples,
    group_reads,
    group_samples,
    memory,
    shared_link,
    shared_batches,
    import_time,
    command_time,
)
NAMED = {benchmark.__name__.rpartition(".")[2]: benchmark for benchmark in BENCHMARKS}
_MET = {True: "yes", False: "**no**", None: ""}
RESULTS = Path(__file__).with_name("RESULTS.md")
_COLUMNS = ("Question", "Unity-Link", "Bare loop", "Time, ours to bare", "Processor, both", "Target", "Met")


def machine() -> str:
    """Return a description of the machine."""
    model = platform.processor() or platform.machine()
    for line in Path("/proc/cpuinfo").read_text().splitlines() if Path("/proc/cpuinfo").exists() else ():
        if line.startswith("model name"):
            model = line.partition(": ")[2]
            break
    return f"{model}, {os.cpu_count()} cores, {platform.system()}, Python {platform.python_version()}"


def document(rows: list[Row]) -> str:
    """Return the text of RESULTS.md."""
    lines = [
        "# Results",
        "",
        "The host's software alone, through a pseudo-terminal to a responder in C in another process; and, in the",
        "same run, the same bytes through a bare asyncio loop (only `add_reader`, `os.read` and `os.write`). If",
        "the question names another program to compare with, the second column has that one. A single outstanding",
        "read polls for its answer as long as answers arrive quickly, while the bare loop sleeps: so the read is",
        "quicker, and uses a whole processor. The processor shares are those of the reading processes and of the",
        "programs that they start, without the responder.",
        f"Medians of {RUNS} alternating runs. `make bench` runs them again and writes this file.",
        "",
        f"Seen on {dt.datetime.now(dt.UTC):%Y-%m-%d} by unity-link {unity_link.__version__}: {machine()}.",
        "Ratios for many requests are similar on other machines, rates are not. The ratio of a single outstanding read",
        "is not either: it depends on the time in which a system wakes a sleeping process, and on the speed of its",
        "Python.",
        "",
        "| " + " | ".join(_COLUMNS) + " |",
        "|---" * len(_COLUMNS) + "|",
    ]
    for row in rows:
        cells = (row.question, row.ours, row.bare, row.ratio, row.processor, row.target, _MET[row.met])
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def missing_tools(name: str) -> str:
    """Return the requirement of a benchmark that this machine lacks; empty if the benchmark can run."""
    needs: Callable[[], str] | None = getattr(NAMED[name], "missing_tools", None)
    return "" if needs is None else needs()


async def run(console: Console, names: list[str]) -> list[Row]:
    """Run the named benchmarks, and show each result; those that cannot run are listed first."""
    rows: list[Row] = []
    missing = {name: text for name in names if (text := missing_tools(name))}
    for name, text in missing.items():
        console.print(f"{name} is not measured: {text}", markup=False)
    for name in names:
        if name in missing:
            rows.append(Row(f"`{name}`", f"not measured: {missing[name]}", "", "", "", None))
            continue
        with console.status(NAMED[name].__doc__ or ""):
            rows.append(await NAMED[name].measure())
        console.print(f"{rows[-1].question}: {rows[-1].ours} (target: {rows[-1].target})")
    return rows


def add_names(parser: argparse.ArgumentParser) -> None:
    """Add the command-line argument for names of benchmarks."""
    parser.add_argument(
        "names", nargs="*", type=_named, metavar="NAME", help=f"all by default; there are {', '.join(NAMED)}"
    )


def _named(name: str) -> str:
    if name not in NAMED:
        raise argparse.ArgumentTypeError(f"there is no benchmark {name!r}, expected {', '.join(NAMED)}")
    return name


def main() -> int:
    """Run the benchmarks, show and write their results, and return 1 if a target was missed."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    add_names(parser)
    arguments = parser.parse_args()
    console = Console()
    rows = asyncio.run(run(console, arguments.names or list(NAMED)))
    table = Table(*_COLUMNS)
    for row in rows:
        met = "[red]no" if row.met is False else _MET[row.met]
        table.add_row(row.question, row.ours, row.bare, row.ratio, row.processor, row.target, met)
    console.print(table)
    if not arguments.names:
        RESULTS.write_text(document(rows))
    return 1 if any(row.met is False for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())

"""Compares Unity-Link with its peers, and writes the results into docs/performance.md: `make bench-peers`.

With media, as in `python -m benchmarks.peers udp`, only these run, and no file is written.
"""

from __future__ import annotations

import argparse
import os
from contextlib import ExitStack
from importlib.util import find_spec
from pathlib import Path

from rich.console import Console

from benchmarks.__main__ import machine
from benchmarks.measure import RUNS
from benchmarks.peers import on_pty, on_tcp, on_udp, report
from benchmarks.peers.race import QUICK, Finish, Size, run_race

DOCS = Path(__file__).parents[2] / "docs"
PAGE = DOCS / "performance.md"
PICTURE = "images/peers.png"
MEDIA = {"pty": on_pty, "udp": on_udp, "tcp": on_tcp}
NEEDED = {"pty": ("litex", "pymodbus"), "udp": ("uhal",), "tcp": ("pymodbus",)}


def main() -> None:
    """Run the races, show the results, and write them."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.peers", description=__doc__)
    parser.add_argument("--rounds", type=int, default=RUNS, help="how often each contender runs")
    parser.add_argument("--quick", action="store_true", help="a round of little work, to try it; writes nothing")
    parser.add_argument("media", nargs="*", choices=[*MEDIA, []], help="all by default")
    arguments = parser.parse_args()
    media = arguments.media or list(MEDIA)
    needed = {name for medium in media for name in NEEDED[medium]}
    missing = sorted(name for name in needed if find_spec(name) is None)
    if missing:
        parser.error(f"{', '.join(missing)} cannot be imported here: `make bench-peers` installs what it needs")
    rounds, size = (1, QUICK) if arguments.quick else (arguments.rounds, Size())
    seen_on = f"{machine()}, with a load of {os.getloadavg()[0]:.1f} before the run"
    console = Console()
    finishes: list[Finish] = []
    for medium in media:
        with ExitStack() as stack:
            for race in MEDIA[medium].races(stack, size):
                with console.status(f"{race.question}, {race.medium}"):
                    finishes += run_race(race, rounds)
                for finish in finishes[-len(race.contenders) :]:
                    beside = "" if finish.ratio is None else f", {report.beside(finish)}"
                    console.print(f"{finish.medium}, {finish.question}, {finish.contender}: {finish.figure}{beside}")
    if not arguments.quick and not arguments.media:
        PAGE.write_text(report.replaced(PAGE.read_text(), report.text(finishes, seen_on, rounds, PICTURE)))
        report.draw(finishes, DOCS / PICTURE)


if __name__ == "__main__":
    main()

"""Run seeds of the simulation: ``python -m simulation FIRST [COUNT]``, from the directory of the tests.

The command prints a trace for each failing scenario and exits with status 1. The last lines list the injected faults.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter

from simulation.report import Report
from simulation.story import shrink, tell
from simulation.world import run_seed


def say(*lines: str) -> None:
    """Write lines and flush them."""
    sys.stdout.writelines(f"{line}\n" for line in lines)
    sys.stdout.flush()


def main() -> int:
    """Run the seeds that the command line names."""
    parser = argparse.ArgumentParser(prog="python -m simulation", description="Run scenarios of the simulation.")
    parser.add_argument("first", type=int, help="the first seed")
    parser.add_argument("count", type=int, nargs="?", default=1, help="number of seeds")
    parser.add_argument("--stories", type=int, default=3, help="largest number of failures that are printed in full")
    parser.add_argument("--json", action="store_true", help="print the report for programs")
    parser.add_argument("--trace", action="store_true", help="print all events")
    parser.add_argument("--build", action="append", default=[], help="a build of the gateware to run on, compiled")
    parser.add_argument("--nodes", action="store_true", help="the gateways are nodes that share a half-duplex line")
    options = parser.parse_args()
    report, kinds = Report(), Counter[str]()
    for seed in range(options.first, options.first + options.count):
        outcome = run_seed(seed, options.build, nodes=options.nodes)
        report.add(outcome)
        if options.trace:
            say(*(f"{when:.6f} {what}" for when, *what in outcome.trace))
        if outcome.error is not None:
            kinds[outcome.error.kind] += 1
            if sum(kinds.values()) <= options.stories:
                say(tell(outcome, shrink(outcome)))
            else:
                say(f"seed {seed}: {outcome.error}"[:300])
    for kind, number in kinds.most_common():
        say(f"{number:7} {kind}")
    say(report.json() if options.json else report.text())
    return 1 if kinds else 0


if __name__ == "__main__":
    sys.exit(main())

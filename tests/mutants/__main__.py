"""Put mutants into `protocol` and `capture`, and count the surviving ones: ``python -m mutants``, from `tests`.

The results are stored in a file, mutant by mutant, so an interrupted run can be continued. The exit status is 1 if
fewer than nine of ten mutants are killed.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import msgspec

from mutants.choosing import FOLDERS, ROOT, Mutant, choose
from mutants.killing import KILLED, SURVIVED, TESTS, file_of, observe, tests_for, verdict

ENOUGH = 0.9


class Result(msgspec.Struct):
    """Result of running tests on a mutant."""

    status: str
    by: str
    difference: str
    seconds: float


def main() -> int:
    """Run as the command line says; return the exit status."""
    options = _options()
    os.chdir(ROOT)
    folder = Path(options.folder)
    seconds, reached = observe(folder / f"reached-{_hash(*FOLDERS, *map(file_of, TESTS))}.json")
    kept = folder / f"results-{_hash(*FOLDERS)}-{options.seed}.json"
    results = msgspec.json.decode(kept.read_bytes(), type=dict[str, Result]) if kept.exists() else {}
    chosen = choose(options.count, options.seed)
    todo = [mutant for mutant in chosen if _is_open(results.get(mutant.name), again=options.again)]
    until = time.monotonic() + 60 * options.minutes

    def tried(mutant: Mutant) -> Result | None:
        if time.monotonic() > until:
            return None
        began = time.monotonic()
        status, by = verdict(mutant, tests_for(mutant, seconds, reached, options.search))
        return Result(status, by, mutant.difference(), round(time.monotonic() - began, 1))

    with ThreadPoolExecutor(options.processes) as pool:
        for mutant, result in zip(todo, pool.map(tried, todo), strict=True):
            if result is not None:
                results[mutant.name] = result
                kept.write_bytes(msgspec.json.format(msgspec.json.encode(results)))
                _say(f"{result.status:8} {mutant.name} {result.by}")
    return _report([(mutant, results[mutant.name]) for mutant in chosen if mutant.name in results], len(chosen))


def _is_open(known: Result | None, *, again: bool) -> bool:
    return known is None or (again and known.status == SURVIVED)


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m mutants", description=__doc__)
    parser.add_argument("--count", type=int, default=500, help="so many mutants (500)")
    parser.add_argument("--seed", type=int, default=0, help="which ones (0)")
    parser.add_argument("--minutes", type=float, default=float("inf"), help="stop after so long, to go on later")
    parser.add_argument("--again", action="store_true", help="try those again that survived")
    parser.add_argument("--search", type=float, default=60, help="seconds of tests, as measured, for a mutant (60)")
    parser.add_argument("--processes", type=int, default=1, help="mutants tried side by side (1)")
    parser.add_argument("--folder", default=".cache/mutants", help="where results stand (.cache/mutants)")
    options = parser.parse_args()
    if min(options.count, options.processes) < 1:
        parser.error(
            f"{options.count} mutants and {options.processes} processes were asked for, expected at least 1 of each"
        )
    return options


def _hash(*places: Path) -> str:
    """Return a hash of source files, or of all sources in folders."""
    found = hashlib.sha256()
    for place in places:
        for path in sorted(place.rglob("*.py")) if place.is_dir() else [place]:
            found.update(path.read_bytes())
    return found.hexdigest()[:8]


def _report(done: list[tuple[Mutant, Result]], wanted: int) -> int:
    survivors = [(mutant, result) for mutant, result in done if result.status != KILLED]
    for mutant, result in survivors:
        _say(f"\n{mutant.name}\n{result.difference}")
    killed = len(done) - len(survivors)
    _say(f"\n{killed} of {len(done)} mutants are killed ({killed / max(1, len(done)):.1%}), {wanted} were asked for")
    return 0 if len(done) == wanted and killed >= ENOUGH * wanted else 1


def _say(text: str) -> None:
    sys.stdout.write(f"{text}\n")
    sys.stdout.flush()


if __name__ == "__main__":
    sys.exit(main())

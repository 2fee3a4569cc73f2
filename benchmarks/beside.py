"""Compares the benchmarks of this tree with those of an earlier revision, run in turn: `make bench-beside`.

Each benchmark runs in a process of its own, alternately from both trees, so that both meet the same machine. The
comparison uses the ratio of our time to that of the bare loop, which every run measures anew. The speed by the clock
alone is shown, too. If the revision lacks a benchmark, it is copied to the revision's tree, provided that the revision
has everything that it needs of the package and of the other benchmarks. Patches in `revisions` add the rest.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
from rich.console import Console
from rich.table import Table

from benchmarks.__main__ import NAMED, add_names
from benchmarks.measure import Row

if TYPE_CHECKING:
    from collections.abc import Iterator

HERE = Path(__file__).parents[1]
PATCHES = Path(__file__).with_name("revisions")
ROUNDS = 3
SLOWER = 1.05
"""Ratio above which a row counts as slower: more than the noise of the medians."""
_MEASURE = (
    "import asyncio, msgspec; from benchmarks import {name}; "
    "print(msgspec.json.encode(asyncio.run({name}.measure())).decode())"
)


class Comparison(msgspec.Struct, frozen=True):
    """One question, with its results in the revision and here."""

    question: str
    before: str
    now: str
    ratio: float
    """Ratio of our time to the bare loop's, divided by that of the revision (median of rounds); above 1 is slower."""
    times_as_quick: float
    """Speed by the clock alone, divided by that of the revision, median over the rounds; above 1 is quicker."""


@contextlib.contextmanager
def checked_out(revision: str) -> Iterator[Path]:
    """Check a revision out into a folder for the duration of the context."""
    commit = commit_of(revision)
    with tempfile.TemporaryDirectory() as folder:
        tree = Path(folder) / "tree"
        _git("worktree", "add", "--detach", "--force", str(tree), commit)
        try:
            # Add the benchmarks that the revision lacks.
            for patch in PATCHES.glob("*.patch"):
                if commit.startswith(patch.stem):
                    _git("-C", str(tree), "apply", str(patch))
            for file in (HERE / "benchmarks").glob("*.py"):
                if not (tree / "benchmarks" / file.name).exists():
                    shutil.copy(file, tree / "benchmarks")
            yield tree
        finally:
            _git("worktree", "remove", "--force", str(tree))


def commit_of(revision: str) -> str:
    """Return the hash of the commit with this branch, tag or abbreviated hash."""
    found = _run_git("rev-parse", "--verify", "--quiet", f"{revision}^{{commit}}")
    if found.returncode:
        raise SystemExit(f"{revision!r} is no revision of this repository: give a branch, a tag or a hash")
    return found.stdout.strip()


def _git(*arguments: str) -> None:
    done = _run_git(*arguments)
    if done.returncode:
        raise SystemExit(f"git {' '.join(arguments)}: {done.stderr.strip()}")


def _run_git(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(["git", *arguments], cwd=HERE, capture_output=True, text=True, check=False)  # noqa: S607


def measure(tree: Path, name: str) -> Row:
    """Run one benchmark of a tree in a process of its own."""
    environment = os.environ | {"PYTHONPATH": str(tree)}
    command = [sys.executable, "-c", _MEASURE.format(name=name)]
    done = subprocess.run(command, cwd=tree, env=environment, capture_output=True, check=False)
    if done.returncode:
        raise SystemExit(f"{name} failed in {tree}: {done.stderr.decode().strip().splitlines()[-1]}")
    return msgspec.json.decode(done.stdout, type=Row)


def why_not(tree: Path, name: str) -> str:
    """Return the reason for which a benchmark cannot run in a tree; empty if it can."""
    environment = os.environ | {"PYTHONPATH": str(tree)}
    command = [sys.executable, "-c", f"from benchmarks import {name}"]
    done = subprocess.run(command, cwd=tree, env=environment, capture_output=True, text=True, check=False)
    return done.stderr.strip().splitlines()[-1] if done.returncode else ""


def compare(there: Path, name: str, rounds: int = ROUNDS) -> Comparison | None:
    """Run one benchmark in both trees in turn; return None if it has no ratio to a bare loop."""
    pairs = [(measure(there, name), measure(HERE, name)) for _ in range(rounds)]
    before, now = pairs[-1]
    if not now.ratio:
        return None
    ratio = statistics.median(_number(new.ratio) / _number(old.ratio) for old, new in pairs)
    times_as_quick = statistics.median(_times_as_quick(old.ours, new.ours) for old, new in pairs)
    return Comparison(now.question, before.ours, now.ours, ratio, times_as_quick)


def _times_as_quick(old: str, new: str) -> float:
    """Return the quotient of two rates, or the inverse quotient of two times."""
    quotient = _number(new) / _number(old)
    return quotient if "/s" in new else 1 / quotient


def _number(text: str) -> float:
    found = re.match(r"[\d.,]+", text)
    assert found is not None
    return float(found[0].replace(",", ""))


def main() -> int:
    """Compare the benchmarks, show a table, and return 1 if one became slower."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.beside", description=__doc__)
    parser.add_argument("revision", help="of this repository")
    add_names(parser)
    parser.add_argument("--rounds", type=int, default=ROUNDS, help="how often each runs here and there")
    arguments = parser.parse_args()
    console = Console()
    table = Table("Question", arguments.revision, "now", "Time, now to then", "Times as quick")
    slower = False
    with checked_out(arguments.revision) as there:
        for name in arguments.names or NAMED:
            if missing := why_not(there, name):
                console.print(f"{name} cannot run at {arguments.revision}: {missing}", markup=False)
                continue
            with console.status(name):
                found = compare(there, name, arguments.rounds)
            if found is not None:
                mark = "[red]" if found.ratio > SLOWER else ""
                slower = slower or found.ratio > SLOWER
                table.add_row(
                    found.question, found.before, found.now, f"{mark}{found.ratio:.2f}", f"{found.times_as_quick:.2f}"
                )
    console.print(table)
    return int(slower)


if __name__ == "__main__":
    sys.exit(main())

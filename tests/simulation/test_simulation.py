"""Worlds, each from one seed, thousands in a campaign, and the proof that they repeat and that they can fail."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from simulation.gallery import BUGS, UNSEEN, Bug
from simulation.report import Report
from simulation.story import shrink, tell
from simulation.world import run_seed
from support.unmeasured import unmeasured_environment
from unity_link.transport.turns import Seat

if TYPE_CHECKING:
    from collections.abc import Iterable

    from simulation.oracle import WorldError

SEEDS = 600
"""Seeds in each run of the suite."""
CAMPAIGN_SEEDS = 10_000
FOUND_SEEDS = 2_000
"""Seeds within which each known bug must be found."""
BUILDS = ("default", "crc_32", "short", "short_ids", "slow", "compact")
"""The gateware, compiled, with as many features as a model has."""
BUILD_SEEDS = 50
"""Seeds that are run on it, in a campaign four times as many."""
NODE_SEEDS = 20
"""Seeds whose gateways are nodes of one line."""
TESTS = Path(__file__).parents[1]


def run_python(*arguments: str) -> subprocess.Popen[str]:
    """Start Python beside this process, on the same sources and without measuring what it covers."""
    environment = unmeasured_environment() | {"PYTHONPATH": os.pathsep.join([str(TESTS.parent), str(TESTS)])}
    return subprocess.Popen([sys.executable, *arguments], stdout=subprocess.PIPE, text=True, env=environment)


@pytest.mark.parametrize(
    "seeds",
    [pytest.param(SEEDS, marks=pytest.mark.slow), pytest.param(CAMPAIGN_SEEDS, marks=pytest.mark.campaign)],
)
def test_no_world_breaks_a_rule_and_the_worlds_are_eventful(seeds: int) -> None:
    processes = os.cpu_count() or 1
    size = -(-seeds // processes)
    runs = [
        run_python("-m", "simulation", str(place * size), str(size), "--json", "--stories", "1")
        for place in range(processes)
    ]
    texts = [run.communicate()[0] for run in runs]
    assert not any(run.returncode for run in runs), "\n".join(texts)
    report = Report.of([json.loads(text.splitlines()[-1]) for text in texts])
    print(report.text())  # noqa: T201  (the histogram of what was injected)
    medians = report.medians()
    assert medians["requests"] >= 200
    assert medians["programs"] >= 2
    assert medians["faults"] >= 3
    assert medians["sessions"] >= 1


@pytest.mark.rtl
@pytest.mark.parametrize(
    "seeds",
    [pytest.param(BUILD_SEEDS, marks=pytest.mark.slow), pytest.param(4 * BUILD_SEEDS, marks=pytest.mark.campaign)],
)
def test_no_world_of_the_gateware_itself_breaks_a_rule(seeds: int) -> None:
    failed = [outcome for seed in range(seeds) if (outcome := run_seed(seed, builds=BUILDS)).error]
    assert not failed, "\n".join(f"seed {outcome.plan.seed}: {outcome.error}" for outcome in failed)


@pytest.mark.slow
def test_no_world_of_nodes_on_one_line_breaks_a_rule_and_two_who_send_at_a_time_do(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    failed = [outcome for seed in range(NODE_SEEDS) if (outcome := run_seed(seed, nodes=True)).error]
    assert not failed, "\n".join(f"seed {outcome.plan.seed}: {outcome.error}" for outcome in failed)

    def take_the_turn(seat: Seat) -> bool:
        seat._line.give_to(seat)
        return True

    monkeypatch.setattr(Seat, "ask", take_the_turn)
    kinds = {outcome.error.kind for seed in range(20) if (outcome := run_seed(seed, nodes=True)).error}
    assert "two who send at a time" in kinds


@pytest.mark.slow
def test_a_seed_repeats_its_world_to_the_byte_also_in_another_process() -> None:
    script = "import sys; from simulation.world import run_seed; print(*(run_seed(seed).digest for seed in range(8)))"
    digests = [run_seed(seed).digest for seed in range(8)]
    assert digests == [run_seed(seed).digest for seed in range(8)]
    assert len(set(digests)) == 8
    for run in [run_python("-c", script) for _ in range(2)]:
        assert run.communicate()[0].split() == digests


@pytest.mark.slow
def test_a_failure_is_told_by_its_seed_and_by_a_shorter_world(monkeypatch: pytest.MonkeyPatch) -> None:
    bug = next(bug for bug in BUGS if bug.name == "a repetition is executed again")
    bug.put_back(monkeypatch)
    failed = next(outcome for seed in range(200) if (outcome := run_seed(seed)).error)
    shortest = shrink(failed)
    assert shortest.error is not None
    assert failed.error is not None
    assert shortest.error.kind == failed.error.kind
    assert shortest.plan.requests() < failed.plan.requests()
    story = tell(failed, shortest)
    assert story.startswith(f"seed {failed.plan.seed}: ")
    assert "write" in story


@pytest.mark.campaign
# A world that a bug has broken leaves coroutines that nothing ends.
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.parametrize("bug", [bug for bug in BUGS if bug.name not in UNSEEN], ids=lambda bug: bug.name)
def test_a_known_bug_that_is_put_back_is_found(bug: Bug) -> None:
    seed, error = find(bug, range(FOUND_SEEDS))
    print(f"{bug.name}: found by seed {seed}: {error}")  # noqa: T201  (what was done, for docs/reliability.md)
    assert error is not None


def find(bug: Bug, seeds: Iterable[int]) -> tuple[int, WorldError | None]:
    """Return the first seed whose world breaks a rule with the bug and none without, and the rule."""
    seed = -1
    for seed in seeds:
        with pytest.MonkeyPatch.context() as patch:
            bug.put_back(patch)
            error = run_seed(seed).error
        if error is not None and run_seed(seed).error is None:
            return seed, error
    return seed, None

"""Scenarios, each from one seed, thousands in a campaign; runs are repeatable, and known bugs are found."""

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

    from simulation.oracle import RuleError

SEEDS = 600
"""Seeds in each run of the suite."""
CAMPAIGN_SEEDS = 10_000
FOUND_SEEDS = 2_000
"""Seeds within which each known bug must be found."""
BUILDS = ("default", "crc_32", "short", "short_ids", "slow", "compact")
"""Builds of the compiled gateware that have all features of a model."""
BUILD_SEEDS = 50
"""Seeds for each build of the gateware; a campaign runs four times as many."""
NODE_SEEDS = 20
"""Seeds whose gateways are nodes of one line."""
TESTS = Path(__file__).parents[1]


def run_python(*arguments: str) -> subprocess.Popen[str]:
    """Start Python beside this process, with the same sources and without measuring coverage."""
    environment = unmeasured_environment() | {"PYTHONPATH": os.pathsep.join([str(TESTS.parent), str(TESTS)])}
    return subprocess.Popen([sys.executable, *arguments], stdout=subprocess.PIPE, text=True, env=environment)


@pytest.mark.parametrize(
    "seeds",
    [pytest.param(SEEDS, marks=pytest.mark.slow), pytest.param(CAMPAIGN_SEEDS, marks=pytest.mark.campaign)],
)
def test_no_scenario_breaks_a_rule_and_scenarios_have_many_events(seeds: int) -> None:
    processes = os.cpu_count() or 1
    size = -(-seeds // processes)
    runs = [
        run_python("-m", "simulation", str(place * size), str(size), "--json", "--stories", "1")
        for place in range(processes)
    ]
    texts = [run.communicate()[0] for run in runs]
    assert not any(run.returncode for run in runs), "\n".join(texts)
    report = Report.of([json.loads(text.splitlines()[-1]) for text in texts])
    print(report.text())  # noqa: T201  (the histogram of injected faults)
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
def test_no_scenario_with_the_compiled_gateware_breaks_a_rule(seeds: int) -> None:
    failed = [outcome for seed in range(seeds) if (outcome := run_seed(seed, builds=BUILDS)).error]
    assert not failed, "\n".join(f"seed {outcome.plan.seed}: {outcome.error}" for outcome in failed)


@pytest.mark.slow
def test_scenarios_with_nodes_break_a_rule_only_if_links_ignore_turns(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    failed = [outcome for seed in range(NODE_SEEDS) if (outcome := run_seed(seed, nodes=True)).error]
    assert not failed, "\n".join(f"seed {outcome.plan.seed}: {outcome.error}" for outcome in failed)

    def take_the_turn(seat: Seat) -> bool:
        seat._line.give_to(seat)
        return True

    monkeypatch.setattr(Seat, "ask", take_the_turn)
    kinds = {outcome.error.kind for seed in range(20) if (outcome := run_seed(seed, nodes=True)).error}
    assert "simultaneous transmissions" in kinds


@pytest.mark.slow
def test_a_seed_repeats_its_scenario_to_the_byte_in_another_process_too() -> None:
    script = "import sys; from simulation.world import run_seed; print(*(run_seed(seed).digest for seed in range(8)))"
    digests = [run_seed(seed).digest for seed in range(8)]
    assert digests == [run_seed(seed).digest for seed in range(8)]
    assert len(set(digests)) == 8
    for run in [run_python("-c", script) for _ in range(2)]:
        assert run.communicate()[0].split() == digests


@pytest.mark.slow
def test_a_failure_is_reported_with_its_seed_and_a_shorter_scenario(monkeypatch: pytest.MonkeyPatch) -> None:
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
# A scenario that a bug has broken leaves unfinished coroutines.
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.parametrize("bug", [bug for bug in BUGS if bug.name not in UNSEEN], ids=lambda bug: bug.name)
def test_each_known_bug_that_is_put_back_is_found(bug: Bug) -> None:
    seed, error = find(bug, range(FOUND_SEEDS))
    print(f"{bug.name}: found by seed {seed}: {error}")  # noqa: T201  (the figures of docs/reliability.md)
    assert error is not None


def find(bug: Bug, seeds: Iterable[int]) -> tuple[int, RuleError | None]:
    """Return the first seed whose scenario breaks a rule only with the bug, and the rule."""
    seed = -1
    for seed in seeds:
        with pytest.MonkeyPatch.context() as patch:
            bug.put_back(patch)
            error = run_seed(seed).error
        if error is not None and run_seed(seed).error is None:
            return seed, error
    return seed, None

"""The simulation's programs on real media: a few thousand requests on each, and a million in a campaign."""

from __future__ import annotations

import asyncio

import pytest

from simulation.media import Media, run_medium
from unity_link.virtual import model_clock

# asyncio leaves a connection to the garbage collector if it accepts it just as its server closes.
pytestmark = pytest.mark.filterwarnings("ignore:.*socket.socket:pytest.PytestUnraisableExceptionWarning")
REQUESTS = 3_000
LATE_REQUESTS = 2_000
CAMPAIGN_REQUESTS = 1_000_000


@pytest.mark.slow
@pytest.mark.parametrize("medium", Media.names)
def test_programs_on_a_disturbed_real_medium_break_no_rule(medium: str) -> None:
    result = asyncio.run(run_medium(medium, REQUESTS))
    assert result.cuts
    assert result.repetitions


def test_a_gateway_that_runs_late_is_compared_by_the_programs_clock(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(model_clock, "MOST_STEPS", 1)
    assert asyncio.run(run_medium("unix", LATE_REQUESTS)).requests


@pytest.mark.campaign
@pytest.mark.parametrize("medium", Media.names)
def test_a_million_requests_on_a_real_medium_break_no_rule(medium: str) -> None:
    result = asyncio.run(run_medium(medium, CAMPAIGN_REQUESTS))
    print(f"{medium}: {result}")  # noqa: T201  (the figures of docs/reliability.md)

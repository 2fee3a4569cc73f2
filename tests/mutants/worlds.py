"""The first scenarios of the simulation, a few at a time; `make test-all` runs thousands."""

from __future__ import annotations

import pytest

from simulation.world import run_seed

TOGETHER = 5


@pytest.mark.parametrize("first", range(0, 60, TOGETHER))
def test_no_scenario_breaks_a_rule(first: int) -> None:
    assert [run_seed(seed).error for seed in range(first, first + TOGETHER)] == [None] * TOGETHER


@pytest.mark.parametrize("first", range(0, 10, TOGETHER))
def test_no_scenario_with_nodes_on_one_line_breaks_a_rule(first: int) -> None:
    assert [run_seed(seed, nodes=True).error for seed in range(first, first + TOGETHER)] == [None] * TOGETHER

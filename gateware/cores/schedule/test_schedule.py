"""ul_schedule against its model, with queues that are soon full and one that takes the longest batch."""

from __future__ import annotations

import json

import pytest

from gateware.bench.runner import BenchError, run_bench

_BENCH = "gateware.cores.schedule.bench_schedule"


@pytest.mark.parametrize("depth", [8, 64, 512])
@pytest.mark.parametrize("cycles", [20_000, pytest.param(1_000_000, marks=pytest.mark.campaign)])
def test_it_is_as_the_model_in_every_cycle(depth: int, cycles: int) -> None:
    generics = {"depth": depth}
    env = {"CYCLES": str(cycles), "GENERICS": json.dumps(generics)}
    run_bench("ul_schedule", _BENCH, generics=generics, extra_env=env)


@pytest.mark.parametrize("depth", [4, 63, 32768])
def test_a_queue_of_another_size_is_refused(depth: int) -> None:
    generics = {"depth": depth}
    with pytest.raises(BenchError, match=f"depth is {depth}: a power of two from 8 to 16384 was expected"):
        run_bench("ul_schedule", _BENCH, generics=generics, extra_env={"CYCLES": "1", "GENERICS": json.dumps(generics)})

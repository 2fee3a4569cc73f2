"""Hundreds of random frames, in a campaign tens of thousands, answered by the gateware in GHDL and by the model."""

from __future__ import annotations

from pathlib import Path

import pytest

from gateware.bench.runner import run_bench

pytestmark = pytest.mark.slow
SOURCES = [Path(__file__).resolve().parent / "unity_link_bench.vhd"]

RUNS = [(400, 1, 0.0, False), (400, 2, 0.2, True)]
# In parts, so that several processors share them.
LONG = [*((4_000, seed, 0.0, False) for seed in (1, 3, 4, 5)), (4_000, 2, 0.2, True)]


@pytest.mark.parametrize(
    ("frames", "seed", "pause", "pipelined"), [*RUNS, *(pytest.param(*run, marks=pytest.mark.campaign) for run in LONG)]
)
def test_the_gateware_answers_as_the_model_does(frames: int, seed: int, pause: float, *, pipelined: bool) -> None:
    run_bench(
        "unity_link_bench",
        "gateware.bench.unity_link.bench_differential",
        generics={"error_at": 0xE0, "silent_at": 0xE8, "wb_pipelined": pipelined},
        extra_sources=SOURCES,
        extra_env={"FRAMES": str(frames), "SEED": str(seed), "PAUSE": str(pause)},
    )

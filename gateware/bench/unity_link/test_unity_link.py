"""The whole gateway at its FIFO port, in the configurations that the behaviours in question need."""

from __future__ import annotations

from pathlib import Path

import pytest

from gateware.bench.runner import GATEWARE, run_bench

FIGURES = GATEWARE / "build" / "figures.txt"
SOURCES = [Path(__file__).resolve().parent / "unity_link_bench.vhd"]


def _run(module: str, **generics: object) -> None:
    FIGURES.parent.mkdir(parents=True, exist_ok=True)
    run_bench(
        "unity_link_bench",
        f"gateware.bench.unity_link.{module}",
        generics=generics,
        extra_sources=SOURCES,
        extra_env={"FIGURES": str(FIGURES)},
    )


def test_the_figures_of_the_project_hold_in_clock_cycles() -> None:
    _run("bench_figures")


@pytest.mark.parametrize("pipelined", [False, True], ids=["classic", "pipelined"])
def test_requests_are_executed_as_the_protocol_says(*, pipelined: bool) -> None:
    _run("bench_requests", wb_pipelined=pipelined, error_at=0xE0, silent_at=0xE8)


def test_groups_are_published_as_the_protocol_says() -> None:
    _run("bench_groups", cycles_at=0xF0, base_frequency_millihertz=250_000_000)


def test_a_gateway_without_a_datalink_layer_answers_a_terminal() -> None:
    _run("bench_plain", checked_frames=False)


@pytest.mark.parametrize("medium", ["uart", "ft245", "ft245_sync"])
def test_a_gateway_answers_at_the_pins_of_its_medium(medium: str) -> None:
    run_bench(
        "unity_link",
        "gateware.bench.unity_link.bench_media",
        generics={"physical": medium, "baud": 12_000_000},
        extra_env={"MEDIUM": medium},
    )

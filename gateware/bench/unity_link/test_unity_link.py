"""The whole gateway at its FIFO port, in the configurations that the tests need."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from gateware.bench.runner import GATEWARE, run_bench

pytestmark = pytest.mark.slow
DOCUMENT = GATEWARE.parent / "docs" / "gateware.md"
SOURCES = [Path(__file__).resolve().parent / "unity_link_bench.vhd"]


def _run(module: str, figures: Path | None = None, **generics: object) -> None:
    run_bench(
        "unity_link_bench",
        f"gateware.bench.unity_link.{module}",
        generics=generics,
        extra_sources=SOURCES,
        extra_env={"FIGURES": str(figures)} if figures else {},
    )


def test_the_figures_of_the_project_hold_and_are_those_of_its_documentation(tmp_path: Path) -> None:
    _run("bench_figures", tmp_path / "figures")
    figures = json.loads((tmp_path / "figures").read_text())
    read, write, effect, share = (figures[name] for name in ("read", "write", "effect", "reads"))
    stated = DOCUMENT.read_text().splitlines()
    for row in (
        f"| read (8 bytes in, 16 out): last byte of the response out | 30 cycles | {read} | {20 * read} ns | 1140 ns |",
        f"| write (16 bytes in, 8 out): effect on the bus | 8 cycles | {effect} | {20 * effect} ns | 840 ns |",
        f"| write: last byte of the response out | 22 cycles | {write} | {20 * write} ns | 1260 ns |",
        f"| pipelined answers | 0.975 bytes a cycle, at least | {share:.3f} | {400 * share:.0f} Mb/s | 200 Mb/s |",
    ):
        assert row in stated


def test_cycles_of_blocks_and_samples_match_the_documentation(tmp_path: Path) -> None:
    columns = []
    for pipelined in (False, True):
        figures = tmp_path / f"figures of {pipelined}"
        _run("bench_blocks", figures, wb_pipelined=pipelined)
        columns.append(json.loads(figures.read_text()))
    stated = DOCUMENT.read_text().splitlines()
    for name, text in (
        ("block of 1", "a block of 1 word"),
        ("block of 16", "a block of 16 words"),
        ("block of 255", "a block of 255 words"),
        ("sample of 16", "a sample of 16 words"),
    ):
        assert f"| {text} | {columns[0][name]} | {columns[1][name]} |" in stated


# `make test-all` measures the jitter of whole samples, below.
@pytest.mark.campaign
@pytest.mark.parametrize("way", ["classic", "pipelined"])
def test_words_of_a_sample_are_read_at_the_documented_cycles_beside_blocks(way: str, tmp_path: Path) -> None:
    stated = DOCUMENT.read_text().splitlines()
    figures = tmp_path / "figures"
    _run("bench_instants", figures, wb_pipelined=way == "pipelined", base_frequency_millihertz=400_000_000)
    found = json.loads(figures.read_text())
    for wait_states in (0, 3):
        first, last, late = (
            found[f"{name} with {wait_states} wait states"] for name in ("first word", "last word", "strobe late")
        )
        assert f"| {way}, {wait_states} wait states | {first} | {last} | 0 | {late} |" in stated


@pytest.mark.parametrize("pipelined", [False, True], ids=["classic", "pipelined"])
def test_requests_are_executed_as_the_protocol_defines(*, pipelined: bool) -> None:
    _run("bench_requests", wb_pipelined=pipelined, error_at=0xE0, silent_at=0xE8)


def test_groups_are_published_by_protocol_with_the_documented_jitter(
    tmp_path: Path,
) -> None:
    _run("bench_groups", tmp_path / "figures", cycles_at=0xF0, base_frequency_millihertz=250_000_000)
    figures = json.loads((tmp_path / "figures").read_text())
    stated = DOCUMENT.read_text().splitlines()
    for wait_states, ours in ((0, figures["jitter with 0 wait states"]), (7, figures["jitter with 7 wait states"])):
        row = f"| jitter of a periodic group's samples under reads of 255 words, {wait_states} wait states "
        assert row + f"| one access: {3 + wait_states} cycles | {ours} | {20 * ours} ns | |" in stated


@pytest.mark.parametrize("groups", [0, 2])
def test_base_tick_and_timestamp_run_freely_with_groups_and_without(groups: int) -> None:
    _run("bench_clock", groups=groups, base_frequency_millihertz=250_000_000)


def test_a_gateway_without_a_datalink_layer_answers_a_terminal() -> None:
    _run("bench_plain", checked_frames=False)


@pytest.mark.parametrize("on", ["half_duplex", "fingerprint", "description"])
def test_gateway_reports_its_enabled_generics(on: str) -> None:
    _run("bench_half_duplex", **{on: True}, build_id=0xCAFE)


@pytest.mark.parametrize("medium", ["uart", "ft245", "ft245_sync"])
def test_a_gateway_answers_at_the_pins_of_its_medium(medium: str) -> None:
    run_bench(
        "unity_link",
        "gateware.bench.unity_link.bench_media",
        generics={"physical": medium, "baud": 12_000_000},
        extra_env={"MEDIUM": medium},
    )


def test_a_gateway_shares_a_pair_of_wires_with_its_host() -> None:
    generics = {"physical": "uart", "baud": 5_000_000, "half_duplex": True}
    run_bench("unity_link", "gateware.bench.unity_link.bench_shared_pair", generics=generics)


def test_there_may_be_256_groups_of_255_addresses() -> None:
    most = {"groups": 256, "group_words": 255, "sample_depth": 512, "data_bits": 8}
    # A tick of 10,000 cycles.
    _run("bench_most_groups", **most, base_frequency_millihertz=5_000_000)

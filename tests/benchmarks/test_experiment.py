"""The paper's experiment: what is clock-exact and modelled, which is the same in every run.

What the program takes is left out here (no test judges the machine); `make table1` measures it.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

import msgspec
import pytest

from benchmarks.paper import Results, run_experiment
from benchmarks.paper.checks import check
from benchmarks.paper.gateware import measure_gateware
from benchmarks.paper.latency import measure_latencies
from benchmarks.paper.plots import draw
from benchmarks.paper.publishing import measure_limits, measure_sustained
from benchmarks.paper.report import write_report
from benchmarks.paper.results import MODES, STACKS
from benchmarks.paper.tables import NOTHING, latency_rows, throughput_rows, to_markdown
from benchmarks.paper.throughput import measure_bursts, measure_throughputs
from benchmarks.paper.workbench import Workbench, available_gateway
from compilers import needs_cxx
from unity_link.errors import ConnectError, UnsupportedError
from unity_link.virtual.rtl.library import load

if TYPE_CHECKING:
    from pathlib import Path

    from benchmarks.paper.stacks import StackName

GATEWAYS = [pytest.param("rtl", marks=[pytest.mark.rtl, needs_cxx]), "model"]
LINK = 64.0
"""Mb/s."""


@pytest.fixture(scope="module", params=GATEWAYS)
def bench(request: pytest.FixtureRequest) -> Workbench:
    return Workbench(request.param, counts_host_time=False)


@pytest.fixture(scope="module")
def results() -> Results:
    return run_experiment(gateway="model", quick=True, host_time=False)


# What is measured


@pytest.mark.rtl
@needs_cxx
def test_the_gateware_alone_is_faster_than_the_papers() -> None:
    figures = measure_gateware()
    assert figures.microseconds(figures.read_cycles) <= 0.60
    assert figures.microseconds(figures.write_cycles) <= 0.45
    assert figures.microseconds(figures.effect_cycles) <= 0.16
    assert figures.bytes_per_cycle >= 0.975


@pytest.mark.parametrize("stack", STACKS)
def test_a_single_access_takes_two_microframes_at_most_or_the_latency_timer(bench: Workbench, stack: StackName) -> None:
    rows = list(measure_latencies(bench, stack, 50))
    assert len(rows) == 2 * 2 * 3
    for row in rows:
        assert row.total == row.modelled
        if row.send_immediate == "off":
            assert 15_500 <= row.modelled <= 16_250
        else:
            assert 125 <= row.modelled <= 250
    medians = {(row.access, row.rhythm, row.send_immediate): row.modelled for row in rows}
    for (access, rhythm, mode), median in medians.items():
        if mode == "adaptive":
            assert median <= 1.05 * medians[access, rhythm, "always"]


@pytest.mark.rtl
@needs_cxx
def test_of_a_single_access_the_gateware_takes_some_microseconds() -> None:
    for stack in STACKS:
        for row in measure_latencies(Workbench("rtl", counts_host_time=False), stack, 10):
            assert row.gateware is not None
            # 20 bytes take 2.5 us at the pins, 24 take 3.
            assert 2.4 <= row.gateware <= 4.0


@pytest.mark.parametrize("stack", STACKS)
def test_long_bursts_fill_the_line_but_for_posts_without_send_immediate(bench: Workbench, stack: StackName) -> None:
    rows = {(row.access, row.send_immediate): row.modelled for row in measure_throughputs(bench, stack, 1500, 1)}
    for access in ("read", "write"):
        for mode in MODES:
            assert rows[access, mode] >= 0.95 * LINK
        assert rows[access, "adaptive"] >= 0.95 * rows[access, "off"]
    for mode in ("always", "adaptive"):
        assert rows["post", mode] >= 0.95 * LINK
    # Their confirmation waits in the chip.
    assert rows["post", "off"] < 0.8 * LINK


def test_one_word_is_published_at_30_khz_with_none_lost(bench: Workbench) -> None:
    found = measure_sustained(bench, 31_250, 0.05)
    assert (found.rate, found.lost) == (31_250, 0)
    assert found.samples >= 1562


def test_the_limit_of_publishing_is_near_what_the_line_carries(bench: Workbench) -> None:
    for limit in measure_limits(bench, [4, 64]):
        assert 0.7 * limit.line <= limit.modelled <= 1.001 * limit.line


def test_longer_bursts_take_longer_and_move_more(bench: Workbench) -> None:
    bursts = list(measure_bursts(bench, "full stack", [1, 32, 1024], 1))
    assert [burst.count for burst in bursts] == [1, 32, 1024] * 3
    for start in range(0, 9, 3):
        times = [burst.microseconds for burst in bursts[start : start + 3]]
        rates = [burst.megabits for burst in bursts[start : start + 3]]
        assert times == pytest.approx(sorted(times))
        assert rates == pytest.approx(sorted(rates))


@pytest.mark.rtl
@needs_cxx
def test_gateware_and_model_differ_by_less_than_a_microframe() -> None:
    pairs = [
        list(measure_latencies(Workbench(kind, counts_host_time=False), "full stack", 30)) for kind in ("rtl", "model")
    ]
    for exact, model in zip(*pairs, strict=True):
        assert exact.modelled == pytest.approx(model.modelled, abs=125)


def test_the_same_is_found_each_time(bench: Workbench) -> None:
    found = [list(measure_latencies(bench, "full stack", 20)) for _ in range(3)]
    assert found[0] == found[1] == found[2]


# All of it


def test_all_that_must_hold_holds_without_the_programs_time(results: Results) -> None:
    assert [row for row in results.checks if not row.met] == []
    assert results.gateware is None
    assert results.parameters.quick


def test_results_are_json_that_reads_back_as_the_same(results: Results) -> None:
    assert msgspec.json.decode(results.to_json(), type=Results) == results
    assert results.to_json(indent=-1).count(b"\n") == 0
    schema = msgspec.json.schema(Results)
    assert set(schema["$defs"]["Results"]["required"]) == set(Results.__struct_fields__)


def test_a_figure_that_is_worse_than_it_must_be_is_told(results: Results) -> None:
    slow = [msgspec.structs.replace(row, total=3 * row.total) for row in results.latencies]
    few = [msgspec.structs.replace(row, total=row.total / 2) for row in results.throughputs]
    lost = msgspec.structs.replace(results.sustained, lost=1)
    spoilt = check(msgspec.structs.replace(results, latencies=slow, throughputs=few, sustained=lost))
    failed = {row.what for row in spoilt if not row.met}
    assert {"read_many, adaptive", "post_many, adaptive"} <= failed
    assert sum("read through the link" in what for what in failed) == 6
    assert sum("published" in what for what in failed) == 1


def test_the_three_parts_of_an_access_add_up_to_all_of_it(results: Results) -> None:
    parts = [msgspec.structs.replace(row, gateware=2.5, total=row.modelled + 40) for row in results.latencies]
    for *_, exact, modelled, measured, together, _known in latency_rows(parts):
        total = sum(float(text.replace(",", "")) for text in (exact, modelled, measured))
        assert total == pytest.approx(float(together.replace(",", "")), abs=0.2)


def test_the_page_has_every_row_and_the_papers_figures(results: Results) -> None:
    page = to_markdown(results)
    rows = [line for line in page.splitlines() if line.startswith("| ") and not line.startswith("| ---")]
    tables = 5
    measured = len(results.latencies) + len(results.throughputs) + len(results.publish_limits) + len(results.checks)
    parameters = len(results.parameters.timing) + 3
    assert len(rows) == measured + parameters + tables
    for known in ("| 652.0 |", "| 223.6 |", "| 0.89 |", "| 62.5 |"):
        assert known in page
    assert NOTHING in page
    assert "quick run" in page


def test_the_papers_bursts_stand_beside_what_they_were_measured_with(results: Results) -> None:
    # Its Table I: from low-level Python, the reads and the answered writes without and with send-immediate.
    known = {row[:3]: row[-1] for row in throughput_rows(results.throughputs) if row[-1] != NOTHING}
    assert known == {
        ("low-level", "read", "off"): "0.89",
        ("low-level", "read", "always"): "0.64",
        ("low-level", "write, answered", "off"): "56.6",
        ("low-level", "write, answered", "always"): "62.5",
    }


@pytest.mark.rtl
@needs_cxx
def test_the_page_has_the_gateware_beside_the_papers(results: Results) -> None:
    page = to_markdown(msgspec.structs.replace(results, gateware=measure_gateware()))
    assert "µs | 1.14 µs |" in page
    assert "| 400 Mb/s | 85.7 Mb/s |" in page


# Files


def test_a_report_is_a_page_with_both_pictures_and_the_data(results: Results, tmp_path: Path) -> None:
    files, reason = write_report(results, tmp_path / "new" / "folder")
    assert [file.name for file in files] == ["TABLE1.md", "table1.json", "figure3.png", "figure4.png"]
    assert reason == ""
    assert all(file.read_bytes().startswith(b"\x89PNG\r\n") for file in files[2:])
    assert "](figure3.png)" in files[0].read_text()
    assert msgspec.json.decode(files[1].read_bytes(), type=Results) == results


def test_the_same_figures_give_the_same_pictures(results: Results, tmp_path: Path) -> None:
    drawn = []
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        drawn.append([file.read_bytes() for file in draw(results, tmp_path / name)])
    assert drawn[0] == drawn[1]


def test_without_matplotlib_there_is_a_page_that_shows_no_picture(
    results: Results, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(UnsupportedError, match=r"pip install 'unity-link\[plot\]'"):
        draw(results, tmp_path)
    files, reason = write_report(results, tmp_path)
    assert [file.name for file in files] == ["TABLE1.md", "table1.json"]
    assert "matplotlib" in reason
    assert "![" not in files[0].read_text()


# Without a compiler


def test_without_a_compiler_the_model_takes_the_gatewares_place(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("CXX", "no-such-compiler")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    load.cache_clear()
    assert available_gateway() == "model"
    with pytest.raises(ConnectError, match="no-such-compiler"):
        run_experiment(gateway="rtl", quick=True)

"""The paper's experiment: the clock-exact and modelled parts, which are the same in every run.

The time of the program is left out, because no test judges the machine; `make table1` measures it.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
import pytest

from benchmarks.paper import Results, published, run_experiment
from benchmarks.paper.checks import check
from benchmarks.paper.gateware import measure_gateware
from benchmarks.paper.latency import measure_arrivals, measure_effects, measure_latencies
from benchmarks.paper.lines import count_lines
from benchmarks.paper.plots import draw
from benchmarks.paper.publishing import measure_limits, measure_sustained, rate_of_a_flood
from benchmarks.paper.report import write_report
from benchmarks.paper.results import STACKS
from benchmarks.paper.stacks import MODES
from benchmarks.paper.table_1 import NOTHING, TITLES, table_1
from benchmarks.paper.tables import latency_rows, quote, table_1_rows, to_markdown
from benchmarks.paper.throughput import measure_bursts, measure_stamps, measure_throughputs
from benchmarks.paper.workbench import Workbench, available_gateway
from support.compilers import needs_cxx
from unity_link.errors import ConnectError, UnsupportedError
from unity_link.virtual.rtl.library import load

if TYPE_CHECKING:
    from benchmarks.paper.stacks import Access, StackName

# The fixture `results` uses the model; single measurements of the model are for the campaign.
GATEWAYS = [
    pytest.param("rtl", marks=[pytest.mark.rtl, needs_cxx]),
    pytest.param("model", marks=pytest.mark.campaign),
]
LINK = 64.0
"""Mb/s."""
COMMITTED = Path(__file__).parents[2] / "benchmarks" / "table1.json"


@pytest.fixture(scope="module", params=GATEWAYS)
def bench(request: pytest.FixtureRequest) -> Workbench:
    return Workbench(request.param, counts_host_time=False)


@pytest.fixture(scope="module")
def results() -> Results:
    return run_experiment(gateway="model", quick=True, host_time=False)


# Measurements


@pytest.mark.slow
@pytest.mark.rtl
@needs_cxx
def test_gateware_without_the_host_is_faster_than_the_papers() -> None:
    figures = measure_gateware([1, 16])
    for cycles, what, access in (
        (figures.read_cycles, published.LATENCY, "read"),
        (figures.write_cycles, published.LATENCY, "write"),
        (figures.effect_cycles, published.EFFECT, "write"),
    ):
        assert figures.microseconds(cycles) <= published.value(what, "gateware", access, "off") / 2  # type: ignore[arg-type]
    assert figures.post_effect_cycles == figures.effect_cycles
    assert figures.bytes_per_cycle >= 0.975
    answers = published.value(published.ANSWERS, "gateware", "read", "off")
    assert figures.megabits(14, figures.cycles_per_read) * 1e6 >= 1.9 * answers
    # The bytes of a block follow each other without idle cycles.
    for block in figures.blocks:
        assert block.last_cycles - block.first_cycles == 8 * block.words + 8
    for sample in figures.publishing:
        assert sample.cycles >= sample.message_bytes
        assert 0.9 * 50e6 / sample.message_bytes <= sample.rate <= 50e6 / sample.message_bytes + 1


@pytest.mark.rtl
@needs_cxx
def test_the_committed_table_has_the_gateware_of_this_tree() -> None:
    committed = msgspec.json.decode(COMMITTED.read_bytes(), type=Results)
    assert committed.gateware is not None
    sizes = [row.words for row in committed.gateware.publishing]
    assert measure_gateware(sizes) == committed.gateware


@pytest.mark.slow
@pytest.mark.parametrize("stack", STACKS)
def test_a_single_access_takes_two_microframes_at_most_or_the_latency_timer(bench: Workbench, stack: StackName) -> None:
    rows = list(measure_latencies(bench, stack, 16))
    assert len(rows) == 3 * 2 * len(MODES)
    for row in rows:
        assert row.total == row.modelled
        for time in (row.modelled.median, row.modelled.mean):
            if row.send_immediate == "off":
                assert 15_500 <= time <= 16_250
            elif row.send_immediate == "off, 1 ms":
                assert 800 <= time <= 1_125
            else:
                assert 125 <= time <= 250
        assert row.modelled.deviation <= 125
    medians = {(row.access, row.rhythm, row.send_immediate): row.modelled.median for row in rows}
    for (access, rhythm, mode), median in medians.items():
        if mode == "adaptive":
            assert median <= 1.05 * medians[access, rhythm, "always"]


@pytest.mark.slow
@pytest.mark.rtl
@needs_cxx
def test_gateware_takes_some_microseconds_of_a_single_access() -> None:
    for stack in STACKS:
        for row in measure_latencies(Workbench("rtl", counts_host_time=False), stack, 4):
            assert row.gateware is not None
            # 20 bytes take 2.5 us at the pins, 24 bytes 3 us, the bytes of a block about 18 us.
            assert 2.4 <= row.gateware <= (20.0 if row.access == "block" else 4.0)


@pytest.mark.slow
@pytest.mark.parametrize("stack", STACKS)
def test_write_takes_effect_in_a_microframe_and_a_burst_at_the_line_rate(bench: Workbench, stack: StackName) -> None:
    for row in measure_effects(bench, stack, 16):
        # A transfer begins with the next microframe; its bytes pass the pins after the effect.
        assert 20 <= row.modelled.mean <= 130
        if bench.gateway == "rtl":
            assert row.burst_modelled == pytest.approx(row.request_bytes / 8, rel=0.01)


@pytest.mark.slow
@pytest.mark.parametrize("stack", STACKS)
def test_sample_waits_for_the_timer_or_a_microframe_with_send_immediate(stack: StackName) -> None:
    rows = list(measure_arrivals(Workbench("model", counts_host_time=False), stack, 6))
    delays = {row.send_immediate: row.modelled for row in rows}
    assert 5_000 <= delays["off"].mean <= 16_250
    assert 250 <= delays["off, 1 ms"].mean <= 1_250
    for mode in ("always", "adaptive"):
        assert 0 <= delays[mode].mean <= 250


@pytest.mark.slow
@pytest.mark.parametrize("stack", STACKS)
def test_long_bursts_fill_the_line_but_for_posts_without_send_immediate(bench: Workbench, stack: StackName) -> None:
    found = {(row.access, row.send_immediate): row for row in measure_throughputs(bench, stack, 750, 1)}
    rates = {key: row.megabits(row.modelled) for key, row in found.items()}
    answered: tuple[Access, ...] = ("read", "block", "write")
    for access in answered:
        for mode in MODES:
            assert rates[access, mode] >= 0.95 * LINK
        assert rates[access, "adaptive"] >= 0.95 * rates[access, "off"]
    assert rates["post", "always"] >= 0.95 * LINK
    assert rates["post", "adaptive"] >= 0.95 * LINK
    # Without send immediate, the confirmations of posted writes wait in the chip.
    assert rates["post", "off"] < 0.8 * LINK


@pytest.mark.slow
def test_one_word_is_published_at_30_khz_with_none_lost(bench: Workbench) -> None:
    found = measure_sustained(bench, 31_250, 0.05)
    assert (found.rate, found.lost) == (31_250, 0)
    assert found.samples >= 1562


@pytest.mark.slow
@pytest.mark.parametrize("stack", STACKS)
def test_publishing_limit_is_near_the_line_rate_and_a_burst_may_exceed_it(stack: StackName) -> None:
    for limit in measure_limits(Workbench("model", counts_host_time=False), stack, [4, 64]):
        assert 0.7 * limit.line <= limit.modelled <= 1.001 * limit.line
        assert limit.modelled <= limit.burst_modelled <= 1e6


@pytest.mark.slow
@pytest.mark.rtl
@needs_cxx
def test_a_group_of_the_most_words_is_published_low_level() -> None:
    bench = Workbench("rtl", counts_host_time=False)
    rate = bench.run("low-level", "adaptive", lambda stack: rate_of_a_flood(stack, 255, 3_800, 40), host_time=False)
    assert rate == pytest.approx(3_800, rel=0.1)


@pytest.mark.slow
def test_longer_bursts_take_longer_and_move_more(bench: Workbench) -> None:
    bursts = list(measure_bursts(bench, "full stack", [1, 32, 1024], 1))
    assert [burst.count for burst in bursts] == [1, 32, 1024] * len(MODES)
    for start in range(0, 3 * len(MODES), 3):
        times = [burst.modelled for burst in bursts[start : start + 3]]
        rates = [burst.megabits(burst.modelled) for burst in bursts[start : start + 3]]
        assert times == pytest.approx(sorted(times))
        assert rates == pytest.approx(sorted(rates))


@pytest.mark.slow
@pytest.mark.rtl
@needs_cxx
def test_short_burst_is_read_faster_than_the_line_by_the_gateway_clock() -> None:
    rows = {(row.send_immediate, row.count): row for row in measure_stamps(Workbench("rtl"), [18, 200])}
    for mode in MODES:
        assert rows[mode, 18].mean_megabits > 1.5 * LINK
        assert 0.9 * LINK <= rows[mode, 200].mean_megabits <= 1.5 * LINK


@pytest.mark.slow
@pytest.mark.rtl
@needs_cxx
def test_gateware_and_model_differ_by_less_than_a_microframe() -> None:
    pairs = [
        list(measure_latencies(Workbench(kind, counts_host_time=False), "full stack", 16)) for kind in ("rtl", "model")
    ]
    for exact, model in zip(*pairs, strict=True):
        assert exact.modelled.mean == pytest.approx(model.modelled.mean, abs=125)


@pytest.mark.slow
def test_modelled_results_are_exactly_repeatable(bench: Workbench) -> None:
    found = [
        [
            *measure_latencies(bench, "full stack", 6),
            *measure_effects(bench, "low-level", 6),
            *measure_bursts(bench, "low-level", [1, 50], 1),
        ]
        for _ in range(2)
    ]
    assert found[0] == found[1]


# The whole experiment


@pytest.mark.slow
def test_all_checks_pass_without_the_time_of_the_program(results: Results) -> None:
    # The bursts of a quick run are so short that the last microframe matters.
    assert [row for row in results.checks if not row.met and "burst" not in row.what and "many" not in row.what] == []
    assert results.gateware is None
    assert results.parameters.quick


def test_results_are_json_that_reads_back_as_the_same(results: Results) -> None:
    assert msgspec.json.decode(results.to_json(), type=Results) == results
    assert results.to_json(indent=-1).count(b"\n") == 0
    schema = msgspec.json.schema(Results)
    assert set(schema["$defs"]["Results"]["required"]) == set(Results.__struct_fields__)


def test_figure_beyond_its_limit_is_reported(results: Results) -> None:
    slow = [
        msgspec.structs.replace(row, total=msgspec.structs.replace(row.total, median=3 * row.total.median))
        for row in results.latencies
    ]
    few = [msgspec.structs.replace(row, total=row.total / 2) for row in results.throughputs]
    lost = msgspec.structs.replace(results.sustained, lost=1)
    spoilt = check(msgspec.structs.replace(results, latencies=slow, throughputs=few, sustained=lost))
    failed = {row.what for row in spoilt if not row.met}
    # The checks of the gateware and of modelled rows were not changed, so they still decide the exit code.
    assert all(row.measured for row in spoilt if not row.met and row not in results.checks)
    assert {"read_many, adaptive", "post_many, adaptive"} <= failed
    assert sum("read through the link" in what for what in failed) == 6
    assert sum("published" in what for what in failed) == 1


def test_sum_of_the_three_parts_of_an_access_is_its_time(results: Results) -> None:
    later = [msgspec.structs.replace(row.modelled, median=row.modelled.median + 40) for row in results.latencies]
    parts = [
        msgspec.structs.replace(row, gateware=2.5, total=total)
        for row, total in zip(results.latencies, later, strict=True)
    ]
    for *_, exact, modelled, measured, median, _mean, _sd in latency_rows(parts):
        total = sum(float(text.replace(",", "")) for text in (exact, modelled, measured))
        assert total == pytest.approx(float(median.replace(",", "")), abs=0.2)


@pytest.mark.slow
@pytest.mark.rtl
@needs_cxx
def test_table_1_of_the_paper_is_complete_beside_ours(results: Results) -> None:
    latencies = [msgspec.structs.replace(row, gateware=2.64) for row in results.latencies]
    whole = msgspec.structs.replace(results, gateware=measure_gateware([1, 16]), latencies=latencies)
    for access in ("read", "write"):
        for mode in ("off", "always"):
            rows = list(table_1(whole, access, mode))
            shown = [row.known for row in rows if row.known is not None]
            known = [row for row in published.TABLE_1 if (row.access, row.mode) == (access, mode)]
            assert sorted(map(str, shown)) == sorted(map(str, known))
            assert all(row.known is None or row.known.level == row.level for row in rows)
    page = to_markdown(whole)
    for figure in published.TABLE_1:
        assert f"| {quote(figure)} |" in page
    assert "µs | 1.14 µs |" in page
    assert "| 400 Mb/s | 200.0 Mb/s |" in page


def test_every_operation_has_a_table_without_and_with_send_immediate(results: Results) -> None:
    page = to_markdown(results)
    for operation, title in TITLES.items():
        for mode, suffix in (("off", ""), ("always", ", send-immediate")):
            assert f"\n### {title}{suffix}\n" in page
            rows = list(table_1_rows(results, operation, mode))  # type: ignore[arg-type]
            assert {row[0] for row in rows} >= set(STACKS)
            assert all(len(row) == 7 for row in rows)
            assert all(re.fullmatch(r".*\d.*", row[3]) or row[3] == NOTHING for row in rows)
    assert "quick run" in page
    for heading in (
        "Complexity",
        "Not without a board",
        "Other media, other FIFOs",
        "Text and compact frames",
        "The limit of publishing",
    ):
        assert f"\n## {heading}\n" in page


def test_each_medium_has_both_fifo_sizes_and_none_exceeds_its_line_rate(results: Results) -> None:
    assert len({(row.medium, row.fifo_bytes) for row in results.media}) == len(results.media) == 10
    for row in results.media:
        assert 0 < row.answers_megabits <= 1.03 * row.line_megabits
        assert 0 < row.posts_megabits <= 1.03 * row.line_megabits
        assert 100 <= row.read.mean <= 700
    lines = {row.medium: row.line_megabits for row in results.media}
    assert lines["synchronous FT245"] * 1e6 == published.value("with D2XX drivers", "ideal link")
    assert lines["UART, 12 Mbaud"] == 9.6


def test_compact_frames_are_more_a_second_than_text_on_each_medium(results: Results) -> None:
    modelled = {(row.medium, row.compact): row for row in results.forms if not row.measured}
    media = {medium for medium, _ in modelled}
    assert len(media) == 3
    for medium in media:
        text, compact = modelled[medium, False], modelled[medium, True]
        assert compact.reads > 1.15 * text.reads
        assert compact.posts >= text.posts
        assert compact.block_words > 1.5 * text.block_words
        assert compact.samples > 1.3 * text.samples


def test_the_walker_takes_fewer_lines_than_the_papers() -> None:
    lines = count_lines()
    assert lines.spec < published.value("specification", "design")
    assert lines.configuration == lines.boilerplate == 0
    assert lines.generated > 1000


# Files


@pytest.mark.slow
def test_a_report_is_a_page_with_its_pictures_and_the_data(results: Results, tmp_path: Path) -> None:
    files, reason = write_report(results, tmp_path / "new" / "folder")
    names = ["TABLE1.md", "table1.json", "figure3.png", "figure4.png", "bursts.png"]
    assert [file.name for file in files] == names
    assert reason == ""
    assert all(file.read_bytes().startswith(b"\x89PNG\r\n") for file in files[2:])
    assert "](figure3.png)" in files[0].read_text()
    # Equal results give equal pictures.
    assert [file.read_bytes() for file in draw(results, tmp_path)] == [file.read_bytes() for file in files[2:]]
    assert msgspec.json.decode(files[1].read_bytes(), type=Results) == results


def test_page_without_pictures_is_written_without_matplotlib(
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

"""Conclusions from the comparison of two revisions."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from benchmarks import beside
from benchmarks.measure import Row

if TYPE_CHECKING:
    from pathlib import Path


def row(ours: str, ratio: str) -> Row:
    return Row("a question", ours, "", ratio, "", met=True)


@pytest.mark.parametrize(
    ("then", "now", "times_as_quick"),
    [("150,000 reads/s", "300,000 reads/s", 2.0), ("30.0 us", "15.0 us", 2.0), ("1,000 us", "2,000 us", 0.5)],
)
def test_rates_and_times_are_compared_as_a_ratio_of_speed(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, then: str, now: str, times_as_quick: float
) -> None:
    answers = {tmp_path: row(then, "4.00"), beside.HERE: row(now, "3.00")}
    monkeypatch.setattr(beside, "measure", lambda tree, _: answers[tree])
    found = beside.compare(tmp_path, "posts", rounds=2)
    assert found == beside.Comparison("a question", then, now, 0.75, times_as_quick)


def test_benchmark_that_a_revision_cannot_run_is_reported(tmp_path: Path) -> None:
    (tmp_path / "benchmarks").mkdir()
    (tmp_path / "benchmarks" / "__init__.py").touch()
    (tmp_path / "benchmarks" / "asks.py").write_text("import what_is_not_there\n")
    (tmp_path / "benchmarks" / "can.py").touch()
    assert beside.why_not(tmp_path, "asks") == "ModuleNotFoundError: No module named 'what_is_not_there'"
    assert beside.why_not(tmp_path, "can") == ""


def test_missing_revision_is_reported() -> None:
    with pytest.raises(
        SystemExit, match="'nonsense' is no revision of this repository: give a branch, a tag or a hash"
    ):
        beside.commit_of("nonsense")

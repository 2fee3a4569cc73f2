"""`python -m benchmarks`: a run of all benchmarks writes the results, a run of named benchmarks prints them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from benchmarks import __main__ as command
from benchmarks.measure import Row

if TYPE_CHECKING:
    from pathlib import Path


class Question:
    """A benchmark with a fixed result."""

    def __init__(self, question: str, *, met: bool) -> None:
        self._row = Row(question, "1 us", "1 us", "1.00", "ratio at most 1", met, "90%, 30%")

    async def measure(self) -> Row:
        return self._row


@pytest.fixture
def results(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    questions = {"quick": Question("quick enough?", met=True), "slow": Question("too slow?", met=False)}
    monkeypatch.setattr(command, "NAMED", questions)
    monkeypatch.setattr(command, "RESULTS", tmp_path / "RESULTS.md")
    return tmp_path / "RESULTS.md"


def test_all_are_written_down_and_a_missed_target_is_the_exit_status(
    monkeypatch: pytest.MonkeyPatch, results: Path
) -> None:
    monkeypatch.setattr("sys.argv", ["benchmarks"])
    assert command.main() == 1
    assert "| quick enough? | 1 us | 1 us | 1.00 | 90%, 30% | ratio at most 1 | yes |" in results.read_text()
    assert "| too slow? | 1 us | 1 us | 1.00 | 90%, 30% | ratio at most 1 | **no** |" in results.read_text()


def test_named_benchmark_runs_alone_and_is_not_written(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], results: Path
) -> None:
    monkeypatch.setattr("sys.argv", ["benchmarks", "quick"])
    assert command.main() == 0
    shown = capsys.readouterr().out
    assert "quick enough?" in shown
    assert "too slow?" not in shown
    assert not results.exists()


def test_benchmark_without_its_tools_is_reported_and_has_a_row(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], results: Path
) -> None:
    lacking = Question("in Octave?", met=True)
    monkeypatch.setattr(lacking, "missing_tools", lambda: "it needs GNU Octave", raising=False)
    monkeypatch.setattr(command, "NAMED", {"quick": Question("quick enough?", met=True), "octave": lacking})
    monkeypatch.setattr("sys.argv", ["benchmarks"])
    assert command.main() == 0
    assert capsys.readouterr().out.startswith("octave is not measured: it needs GNU Octave\n")
    assert "| `octave` | not measured: it needs GNU Octave |  |  |  |  |  |" in results.read_text()

"""`python -m benchmarks.paper`, as a shell runs it."""

from __future__ import annotations

import signal
import subprocess
import sys
from typing import TYPE_CHECKING

import msgspec
import pytest

from benchmarks.paper import Results

if TYPE_CHECKING:
    from pathlib import Path

PROGRAM = (sys.executable, "-m", "benchmarks.paper")
QUICK = ("--quick", "--gateway", "model")


def run(*arguments: str) -> subprocess.CompletedProcess[str]:
    done = subprocess.run([*PROGRAM, *arguments], capture_output=True, text=True, check=False, timeout=600)
    assert "Traceback" not in done.stderr
    return done


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--gateway", "board"], "--gateway is 'board': one of rtl, model was expected"),
        (["--output"], "requires an argument"),
        (["--outpu"], "Try: python -m benchmarks.paper --help"),
        (["5"], "unexpected extra argument"),
        (["--output", __file__], "is no folder"),
        (["--output", f"{__file__}/folder"], "is no folder"),
    ],
    ids=["an unknown gateway", "no folder", "an unknown option", "too much", "a file", "below a file"],
)
def test_wrong_use_is_reported_before_any_measurement(arguments: list[str], words: str) -> None:
    done = run(*arguments)
    assert done.returncode == 2
    assert words in " ".join((done.stdout + done.stderr).replace("│", " ").split())
    assert "..." not in done.stderr


def test_ctrl_c_ends_it_at_once() -> None:
    with subprocess.Popen([*PROGRAM, *QUICK], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        assert process.stdout is not None
        for line in process.stderr:
            if "single accesses" in line:
                break
        process.send_signal(signal.SIGINT)
        rest = process.stderr.read()
        assert process.stdout.read() == ""
    assert process.returncode == 128 + signal.SIGINT
    assert "Traceback" not in rest


@pytest.mark.slow
def test_a_quick_run_prints_data_and_writes_page_and_pictures(tmp_path: Path) -> None:
    done = run(*QUICK, "--json", "--output", str(tmp_path / "out"))
    assert done.returncode == 0
    results = msgspec.json.decode(done.stdout, type=Results)
    assert results.parameters.gateway == "model"
    assert done.stdout.count("\n") == 1
    names = ["TABLE1.md", "bursts.png", "figure3.png", "figure4.png", "table1.json"]
    assert sorted(file.name for file in (tmp_path / "out").iterdir()) == names
    assert "limits of publishing ..." in done.stderr


@pytest.mark.campaign
def test_into_a_pipe_it_prints_markdown() -> None:
    done = run(*QUICK)
    assert done.returncode == 0
    assert done.stdout.startswith("# The paper's experiment, again\n")
    assert "| full stack | latency, request to response | 652 µs (sd 11.7 µs) |" in done.stdout

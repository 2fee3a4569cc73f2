"""Each example runs by one command, without hardware."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"
NOTEBOOKS = sorted(EXAMPLES.glob("*.ipynb"))


def cells(notebook: Path) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = json.loads(notebook.read_text())["cells"]
    return found


def run(name: str) -> list[str]:
    done = subprocess.run([sys.executable, EXAMPLES / name], capture_output=True, text=True, timeout=120, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout.splitlines()


def test_the_scara_goes_through_its_poses() -> None:
    lines = run("scara.py")
    assert lines[0].split()[::3] == ["time", "shoulder", "elbow", "z", "wrist"]
    assert [float(number) for number in lines[-1].split()[1:]] == pytest.approx([0, 0, 0, 0], abs=0.011)
    # As in the last line: a position within 0.01 of the target has arrived, and two digits are printed.
    assert any(float(line.split()[3]) == pytest.approx(120, abs=0.011) for line in lines[1:])


@pytest.mark.slow
def test_the_walker_walks() -> None:
    lines = run("walker.py")
    assert len(lines) == 6
    words = lines[-2].split()
    samples, values = int(words[0]), int(words[3])
    assert samples > 1000
    assert values == 36
    assert lines[-1] == "the fastest joint made 8.0 rad/s"


@pytest.mark.parametrize("name", ["scara.py", "walker.py"])
def test_an_example_without_a_gateway_prints_one_line(name: str) -> None:
    command = [sys.executable, str(EXAMPLES / name), "unix:/nowhere/robot"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    assert (done.returncode, done.stdout) == (1, "")
    assert re.fullmatch(r"error: unix:/nowhere/robot: .*\n", done.stderr)


@pytest.mark.slow
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.name)
def test_a_notebook_runs(path: Path, tmp_path: Path) -> None:
    shutil.copytree(EXAMPLES, tmp_path, dirs_exist_ok=True)
    # Run the command, because sockets that its client leaves to the garbage collector cause warnings in this process.
    execute = [
        str(Path(sys.executable).with_name("jupyter-execute")),
        "--inplace",
        "--timeout=120",
        str(tmp_path / path.name),
    ]
    done = subprocess.run(execute, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    outputs = json.dumps([cell.get("outputs") for cell in cells(tmp_path / path.name)])
    assert "image/png" in outputs
    assert "0 lost" in outputs


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.name)
def test_a_notebook_has_its_outputs_and_no_path_of_a_machine(path: Path) -> None:
    assert all(cell["outputs"] for cell in cells(path)[1:-1] if cell["cell_type"] == "code")
    for machine in ("/home", "/root", "/tmp", "/work", "site-packages"):
        assert machine not in path.read_text()

"""`unity-link example` writes the examples that the wheel contains, and replaces no file of the user."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from support.tracked import tracked_files
from unity_link.cli.example import EXAMPLES

ROOT = Path(__file__).parents[2]
HERE = ROOT / "examples"


def run(folder: Path, *arguments: str, package: Path = ROOT) -> tuple[int, str, str]:
    """Run `unity-link example` in a folder, with the package in another one."""
    done = subprocess.run(
        [sys.executable, "-m", "unity_link", "example", *arguments],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(package)},
        capture_output=True,
        text=True,
        check=False,
    )
    return done.returncode, done.stdout, done.stderr


def test_every_file_of_the_examples_belongs_to_an_example() -> None:
    listed = {
        (HERE / name / file if (HERE / name).is_dir() else HERE / file)
        for name, (_, files) in EXAMPLES.items()
        for file in files
    }
    assert listed == {path for path in tracked_files(ROOT) if HERE in path.parents}


def test_without_a_name_the_examples_are_listed(tmp_path: Path) -> None:
    code, printed, _ = run(tmp_path)
    assert (code, [line.split()[0] for line in printed.splitlines()]) == (0, list(EXAMPLES))
    code, printed, _ = run(tmp_path, "--json")
    assert [json.loads(line)["name"] for line in printed.splitlines()] == list(EXAMPLES)
    assert list(tmp_path.iterdir()) == []


def test_an_example_is_written_and_a_changed_file_is_kept(tmp_path: Path) -> None:
    written = "examples/rover.py\nexamples/rover.ul\n"
    assert run(tmp_path, "rover") == (0, written, "")
    assert run(tmp_path, "rover") == (0, written, "")
    (tmp_path / "examples" / "rover.py").write_text("mine")
    code, _, error = run(tmp_path, "rover")
    assert (code, error.count("\n")) == (2, 1)
    assert "examples/rover.py is there, and Unity-Link did not make it" in error
    assert (tmp_path / "examples" / "rover.py").read_text() == "mine"


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["scarra"], "error: there is no example 'scarra': did you mean 'scara'?\n"),
        (["scara", "-o", "file"], "error: file is a file: the name of a folder was expected\n"),
    ],
)
def test_a_wrong_name_of_an_example_or_folder_is_refused(arguments: list[str], words: str, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    assert run(tmp_path, *arguments) == (2, "", words)


@pytest.mark.slow
def test_the_wheel_writes_every_example_and_the_scara_runs(tmp_path: Path) -> None:
    build = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(tmp_path)]
    subprocess.run(build, cwd=ROOT, check=True, capture_output=True)
    (wheel,) = tmp_path.glob("*.whl")
    package, folder = tmp_path / "package", tmp_path / "folder"
    folder.mkdir()
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(package)
    assert (package / "unity_link" / "examples" / "scara.ul").is_file()
    for name in EXAMPLES:
        code, printed, _ = run(folder, name, package=package)
        assert code == 0
        for line in printed.splitlines():
            assert (folder / line).read_bytes() == (ROOT / line).read_bytes()
    # The program loads the spec that was written beside it.
    program = [sys.executable, "examples/scara.py"]
    done = subprocess.run(program, cwd=folder, env={**os.environ, "PYTHONPATH": str(package)}, check=False)
    assert done.returncode == 0

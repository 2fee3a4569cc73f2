"""File list, FuseSoC core and import scripts have every file of the gateware once, after the files that it needs."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from gateware.tools.constraints import constraints
from gateware.tools.lists import TOP, in_compile_order, lists
from unity_link.gateware.cache import GATEWARE, LIBRARY, vhdl_sources

_PATH = re.compile(r"(?:rtl|cores)/[\w/]+\.vhd")


def test_compile_order_has_every_file_once_after_its_dependencies() -> None:
    order = in_compile_order()
    assert sorted(order) == sorted(path.relative_to(GATEWARE).as_posix() for path in vhdl_sources())
    known: set[str] = set()
    for name in order:
        text = (GATEWARE / name).read_text()
        known |= set(re.findall(r"^(?:entity|package) (\w+) is$", text, re.MULTILINE))
        assert set(re.findall(r"(?:entity|use) work\.(\w+)", text)) <= known, name
    assert order[-1].endswith((f"/{TOP}.vhd", f"/{TOP}_fifo.vhd"))


@pytest.mark.parametrize("name", lists())
def test_lists_in_the_tree_are_up_to_date(name: str) -> None:
    text = (GATEWARE / name).read_text()
    assert text == lists()[name], "run make lists"
    assert list(dict.fromkeys(_PATH.findall(text))) == in_compile_order()


@pytest.mark.parametrize("name", constraints())
def test_the_constraints_in_the_tree_are_those_of_the_vhdl(name: str) -> None:
    assert (GATEWARE / name).read_text() == constraints()[name], "run make lists"


def test_no_constraint_is_written_by_hand() -> None:
    there = {path.relative_to(GATEWARE).as_posix() for path in (GATEWARE / "constraints").glob("*/*")}
    assert there == set(constraints())


@pytest.mark.parametrize("tool", ["vivado", "quartus", "radiant", "diamond", "gowin"])
def test_a_script_adds_each_file_with_its_library(tool: str) -> None:
    """Run the script in Tcl, with substitutes for the tool's commands."""
    tkinter = pytest.importorskip("tkinter")
    seen: list[tuple[str, ...]] = []
    interpreter = tkinter.Tcl()
    for command in ("read_vhdl", "set_global_assignment", "prj_add_source", "prj_src", "prj_strgy", "add_file"):
        interpreter.createcommand(command, lambda *words: seen.append(words) or "")
    files: list[tuple[str, ...]] = []
    for command in ("set_file_prop", "set_option"):
        interpreter.createcommand(command, lambda *words: files.append(words) or "")
    interpreter.eval(f"source {GATEWARE / 'import' / f'{tool}.tcl'}")
    added = [Path(word) for words in seen for word in words if word.endswith(".vhd")]
    assert added == [GATEWARE / name for name in in_compile_order()]
    placed = files[1:] if tool == "gowin" else [words for words in seen if any(word.endswith(".vhd") for word in words)]
    assert all(LIBRARY in words for words in placed)
    assert len(placed) == len(added)


def test_fusesoc_sets_the_gateway_up(tmp_path: Path) -> None:
    pytest.importorskip("fusesoc")
    command = [sys.executable, "-m", "fusesoc.main", "--cores-root", str(GATEWARE), "run", "--setup"]
    done = subprocess.run(
        [*command, "--target", "lint", "--build-root", "made", "unity-link:unity-link:gateway"],
        cwd=tmp_path,
        check=False,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    description = next((tmp_path / "made").rglob("*.eda.yml")).read_text()
    assert [Path(name).name for name in _PATH.findall(description)] == [Path(name).name for name in in_compile_order()]

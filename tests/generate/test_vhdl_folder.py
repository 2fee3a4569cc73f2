"""The gateware for a user's own design: copied as a folder, and beside the files generated from a spec."""

from __future__ import annotations

import subprocess
import sys
import tkinter as tk
from pathlib import Path

import pytest

from unity_link.errors import ArgumentError
from unity_link.gateware.cache import GATEWARE, vhdl_sources
from unity_link.gateware.sources import copy_gateware, gateware_files, in_compile_order
from unity_link.generate import generate, write
from unity_link.generate.vhdl.folder import with_gateware
from unity_link.spec import compile_file

PROGRAM = str(Path(sys.executable).with_name("unity-link"))
WALKER = Path(__file__).parents[2] / "examples" / "walker.ul"


def test_the_copy_is_the_gateware_with_scripts_constraints_and_licence(tmp_path: Path) -> None:
    copied = copy_gateware(tmp_path / "new" / "gateware")
    for source in vhdl_sources():
        assert (copied / source.relative_to(GATEWARE)).read_bytes() == source.read_bytes()
    assert (copied / "LICENSE").read_text().startswith("BSD 3-Clause")
    assert {"import/vivado.tcl", "unity_link.core", "constraints/README.md"} <= gateware_files().keys()
    assert all((copied / line).is_file() for line in in_compile_order())
    # The folder above contains no other file.
    assert list((tmp_path / "new").iterdir()) == [copied]


def test_a_folder_with_files_is_left_as_it_is(tmp_path: Path) -> None:
    (tmp_path / "mine.vhd").write_text("mine")
    done = subprocess.run([PROGRAM, "gateware", "copy", str(tmp_path)], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == f"error: {tmp_path} exists already: a new or empty folder was expected\n"
    assert [path.name for path in tmp_path.iterdir()] == ["mine.vhd"]


def test_a_copy_that_cannot_be_written_leaves_nothing(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(ArgumentError, match="cannot be written: Not a directory"):
        copy_gateware(tmp_path / "file" / "gateware")
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


@pytest.mark.parametrize("vendor", ["ecp5", "gowin", "xilinx"])
def test_pads_of_a_vendor_replace_the_portable_ones(vendor: str) -> None:
    portable, theirs = list(in_compile_order()), list(in_compile_order(vendor))
    assert len(portable) == len(theirs) == len(set(theirs))
    changed = [new for old, new in zip(portable, theirs, strict=True) if old != new]
    assert sorted(changed) == [f"pads/{vendor}/ul_pad_input.vhd", f"pads/{vendor}/ul_pad_output.vhd"]


@pytest.mark.parametrize("tool", ["vivado", "quartus", "radiant", "diamond", "gowin"])
def test_a_generated_folder_with_the_gateware_is_whole_for_each_tool(tool: str, tmp_path: Path) -> None:
    write(list(with_gateware(generate("vhdl", compile_file(WALKER)))), tmp_path)
    added: list[Path] = []
    tcl = tk.Tcl()

    def add(*words: str) -> str:
        added.extend(Path(word) for word in words if word.endswith(".vhd"))
        return ""

    for command in ("read_vhdl", "set_global_assignment", "prj_add_source", "prj_src", "add_file"):
        tcl.createcommand(command, add)
    for command in ("prj_strgy", "set_file_prop", "set_option"):
        tcl.createcommand(command, lambda *_: "")
    tcl.eval(f"source {tmp_path / tool}.tcl")
    assert all(path.is_file() for path in added)
    assert [path.name for path in added[-8:]] == [
        *("walker_gateway.vhd", "walker_on_uart.vhd", "walker_on_ft245.vhd", "walker_on_ft245_sync.vhd"),
        *("walker_on_rmii.vhd", "walker_on_mii.vhd", "walker_on_rgmii.vhd", "walker_on_w5500.vhd"),
    ]
    assert len(added) == len(set(added)) == len(vhdl_sources()) + 2 + 10


def test_only_vhdl_takes_the_gateware_along(tmp_path: Path) -> None:
    command = [PROGRAM, "generate", "c", str(WALKER), "--with-gateware", "-o", str(tmp_path / "out")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (2, "error: --with-gateware belongs to vhdl, and c was asked for\n")
    assert not (tmp_path / "out").exists()

"""The design that docs/gateware.md shows is a design: GHDL elaborates it with the gateware."""

from __future__ import annotations

import re
import subprocess
from typing import TYPE_CHECKING

from gateware.bench.runner import GATEWARE, rtl_sources

if TYPE_CHECKING:
    from pathlib import Path


def test_the_design_in_the_documentation_elaborates(tmp_path: Path) -> None:
    text = (GATEWARE.parent / "docs" / "gateware.md").read_text()
    shown = re.findall(r"```\{code-block\} vhdl\n:caption: (\w+)\.vhd\n\n(.*?)```", text, re.DOTALL)
    assert shown
    for name, code in shown:
        source = tmp_path / f"{name}.vhd"
        source.write_text(code)
        _ghdl(tmp_path, "-i", *map(str, rtl_sources()), str(source))
        _ghdl(tmp_path, "-m", name)


def test_the_boards_elaborate(tmp_path: Path) -> None:
    boards = sorted((GATEWARE / "boards").rglob("*.vhd"))
    _ghdl(tmp_path, "-i", *map(str, rtl_sources()), *map(str, boards))
    for board in (path for path in boards if path.stem == path.parent.name):
        _ghdl(tmp_path, "-m", board.stem)


def _ghdl(folder: Path, command: str, *arguments: str) -> None:
    done = subprocess.run(
        ["ghdl", command, "--std=08", f"--workdir={folder}", *arguments],
        cwd=folder,
        check=False,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr

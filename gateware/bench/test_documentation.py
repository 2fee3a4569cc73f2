"""The statements of docs/gateware.md: its design works, and the boards elaborate."""

from __future__ import annotations

import subprocess
from typing import TYPE_CHECKING

from docs.walkthrough import files_of
from gateware.bench.runner import GATEWARE, run_bench
from unity_link.gateware.cache import LIBRARY, vhdl_sources

if TYPE_CHECKING:
    from pathlib import Path


def test_the_design_in_the_documentation_works(tmp_path: Path) -> None:
    ((name, code),) = files_of(GATEWARE.parent / "docs" / "gateware.md").items()
    source = tmp_path / name
    source.write_text(code)
    run_bench(source.stem, "gateware.bench.unity_link.bench_example", extra_sources=[source])


def test_the_boards_elaborate(tmp_path: Path) -> None:
    boards = sorted((GATEWARE / "boards").rglob("*.vhd"))
    ghdl(tmp_path, "-i", f"--work={LIBRARY}", *map(str, vhdl_sources()))
    ghdl(tmp_path, "-i", *map(str, boards))
    for board in (path for path in boards if path.stem == path.parent.name):
        ghdl(tmp_path, "-m", board.stem)


def ghdl(folder: Path, command: str, *arguments: str) -> None:
    done = subprocess.run(
        ["ghdl", command, "--std=08", f"--workdir={folder}", *arguments],
        cwd=folder,
        check=False,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr

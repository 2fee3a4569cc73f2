"""What docs/gateware.md shows is so: its design works, its tables are whole, and the boards elaborate."""

from __future__ import annotations

import re
import subprocess
from typing import TYPE_CHECKING

from gateware.bench.runner import GATEWARE, rtl_sources, run_bench
from unity_link.gateware.cache import LIBRARY

if TYPE_CHECKING:
    from pathlib import Path


def test_the_design_in_the_documentation_works(tmp_path: Path) -> None:
    text = (GATEWARE.parent / "docs" / "gateware.md").read_text()
    ((name, code),) = re.findall(r"```\{code-block\} vhdl\n:caption: (\w+)\.vhd\n\n(.*?)```", text, re.DOTALL)
    source = tmp_path / f"{name}.vhd"
    source.write_text(code)
    run_bench(name, "gateware.bench.unity_link.bench_example", extra_sources=[source])


def test_the_boards_elaborate(tmp_path: Path) -> None:
    boards = sorted((GATEWARE / "boards").rglob("*.vhd"))
    _ghdl(tmp_path, "-i", f"--work={LIBRARY}", *map(str, rtl_sources()))
    _ghdl(tmp_path, "-i", *map(str, boards))
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


def _entity() -> str:
    return (GATEWARE / "rtl" / "unity_link.vhd").read_text().split("end entity")[0]


def _rows(title: str) -> list[list[str]]:
    """Return the cells of the table below a title of the document."""
    section = (GATEWARE.parent / "docs" / "gateware.md").read_text().split(f"\n## {title}\n")[1].split("\n## ")[0]
    return [[cell.strip() for cell in line.split(" | ")] for line in section.splitlines() if line.startswith("| `")]


def test_the_documentation_has_every_generic_with_its_default() -> None:
    shown: dict[str, str] = {}
    for names, defaults, *_ in _rows("Generics"):
        values = defaults.split(", ")
        for index, name in enumerate(re.findall(r"`(\w+)`", names)):
            shown[name] = values[min(index, len(values) - 1)].strip('`"').replace(",", "")
    generics = re.findall(r"^ {4}(\w+)\s*: [^:]*:= (\S+?);?$", _entity().split("port (")[0], re.MULTILINE)
    expected = {name: default.removeprefix("x").strip('"').replace("_", "") for name, default in generics}
    assert {name: value.lstrip("0") for name, value in shown.items()} == {
        name: value.lstrip("0") for name, value in expected.items()
    }


def test_the_documentation_has_every_port() -> None:
    shown = [name for row in _rows("Ports") for name in re.findall(r"`(\w+)`", row[0])]
    assert sorted(shown) == sorted(re.findall(r"^ {4}(\w+)\s*: (?:in|out) ", _entity(), re.MULTILINE))

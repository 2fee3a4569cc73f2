"""Every file of the gateware, and every generated file, contains its licence."""

from __future__ import annotations

from pathlib import Path

import pytest

from unity_link.gateware import LICENCE
from unity_link.generate import generate
from unity_link.spec import compile_file

ROOT = Path(__file__).parents[2]
COPIED = sorted(
    path
    for folder, pattern in (
        ("gateware/rtl", "*.vhd"),
        ("gateware/cores", "ul_*.*"),
        ("gateware/boards", "*.*"),
        ("gateware/constraints", "*"),
        ("gateware/import", "*"),
        ("gateware/pads", "*.vhd"),
        ("gateware", "unity_link.*"),
        ("gateware/formal", "*.sv"),
        ("unity_link/boards/data", "*.toml"),
    )
    for path in (ROOT / folder).rglob(pattern)
    if path.is_file() and path.suffix != ".md" and "build" not in path.relative_to(ROOT).parts
)
SCARA = compile_file(ROOT / "examples" / "scara.ul")


def test_every_file_of_the_gateware_begins_with_its_licence() -> None:
    assert len(COPIED) > 40
    silent = [path for path in COPIED if LICENCE not in "".join(path.read_text().splitlines(keepends=True)[:2])]
    assert silent == []


@pytest.mark.parametrize("target", ["vhdl", "verilog", "c", "cpp"])
def test_every_generated_source_names_its_licence(target: str) -> None:
    assert [file.name for file in generate(target, SCARA) if file.text.count(LICENCE) != 1] == []

"""docs/how-to/own-vhdl.md: its VHDL is converted as the page says, and the pins are those that builds use."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from docs.walkthrough import blocks
from unity_link.boards.loading import load_board
from unity_link.gateware import ghdl
from unity_link.gateware.convert import to_verilog
from unity_link.generate import generate, write
from unity_link.spec import compile_text

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "how-to" / "own-vhdl.md"
FILES = {block.caption: block.text.lstrip("\n") for block in blocks(PAGE) if block.caption}


def located(port: str) -> list[str]:
    """Return the sites that the page gives the bits of a port, or one port."""
    return re.findall(rf'LOCATE COMP "{port}(?:\[\d\])?" SITE "(\w+)"', FILES["panel_ulx3s.lpf"])


def test_the_pins_are_those_of_the_board() -> None:
    _, board = load_board("ulx3s")
    for port in ("clk", "uart_rxd", "uart_txd"):
        assert located(port) == [board.pins[port]]
    for port in ("led", "btn"):
        assert located(port) == list(board.io[port].sites)


def test_the_page_starts_the_ghdl_of_the_cache_as_builds_do() -> None:
    told = FILES["ghdl.sh"]
    for part in (f"ghdl-{ghdl._SUITE}", ghdl._LOADER, f"usr/lib/{ghdl._MULTIARCH}", "usr/bin/ghdl-mcode"):
        assert part in told


@pytest.mark.rtl
def test_the_top_of_the_page_is_converted(tmp_path: Path) -> None:
    own = tmp_path / "panel_ulx3s.vhd"
    own.write_text(FILES["panel_ulx3s.vhd"])
    made = write(generate("vhdl", compile_text(FILES["panel.ul"])), tmp_path)
    sources = [path for path in made if path.stem.endswith(("_map", "_registers", "_gateway"))]
    board_reset = ROOT / "gateware" / "boards" / "board_reset.vhd"
    verilog = to_verilog("panel_ulx3s", extra_sources=[board_reset, *sources, own]).read_text()
    ports = re.findall(r"(?:input|output) +(?:\[.*?\] +)?(\w+)", verilog[verilog.index("module panel_ulx3s") :])[:5]
    assert {port for port in ports if located(port)} == set(ports)


@pytest.mark.campaign
def test_its_commands_make_a_bitstream(tmp_path: Path) -> None:
    for name, text in FILES.items():
        (tmp_path / name).write_text(text)
    found = ghdl.converting_ghdl()
    start = "" if found.command == ("ghdl",) else ". ./ghdl.sh; "
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    shell = shutil.which("bash")
    assert shell is not None
    subprocess.run([shell, "-c", f"{start}. ./build.sh"], cwd=tmp_path, env=os.environ | {"PATH": path}, check=True)
    assert (tmp_path / "panel_ulx3s.bit").stat().st_size > 50_000

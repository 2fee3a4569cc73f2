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
BOARDS = (ROOT / "docs" / "how-to" / "boards.md").read_text(encoding="utf-8")
LISTED = ("ulx3s", "icebreaker", "colorlight_i5", "tang_nano_9k", "tang_nano_20k", "arty_a7", "de10_nano")
"""Boards of which the page has all pins of the headers that a build uses."""
CHAIN = ("chain_clk", "chain_load_n", "chain_out", "chain_in")


def row_of(board: str) -> list[str]:
    """Return the cells of a board in the table of LEDs, buttons and headers."""
    table = BOARDS[BOARDS.index("## LEDs, buttons and headers") :]
    (row,) = re.findall(rf"^\| `{board}(?:\.\.\.)?` \| (.*) \|$", table, re.MULTILINE)
    return str(row).split(" | ")


def sites_of(text: str) -> list[str]:
    return re.findall(r"(?<![\w\[])(?:[A-Z]{1,2})?\d+(?![\w.\]])", text)


def located(port: str) -> list[str]:
    """Return the sites that the page gives the bits of a port, or one port."""
    return re.findall(rf'LOCATE COMP "{port}(?:\[\d\])?" SITE "(\w+)"', FILES["panel_ulx3s.lpf"])


def test_the_pins_are_those_of_the_boards_table_and_of_builds() -> None:
    _, board = load_board("ulx3s")
    for port in ("clk", "uart_rxd", "uart_txd"):
        assert located(port) == [board.pins[port]]
    leds, buttons, _ = row_of("ulx3s")
    assert located("led") == sites_of(leds)
    assert located("btn") == sites_of(buttons)[:6]


@pytest.mark.parametrize("name", LISTED)
def test_what_a_build_puts_at_a_header_is_in_the_row_of_its_board(name: str) -> None:
    _, board = load_board(name)
    told = BOARDS[BOARDS.index("### The headers of a ULX3S") :] if name == "ulx3s" else row_of(name)[2]
    assert {board.pins[pin] for pin in CHAIN} <= set(re.findall(r"\w+", told))


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

"""A user's own top on a board: its ports are pins, and each fault is reported in one sentence with its name."""

from __future__ import annotations

import hashlib
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from hypothesis import given
from hypothesis import strategies as st

from docs.walkthrough import files_of
from unity_link.boards.board import PINS, Board, Io, Pin
from unity_link.boards.build import design_of, top_text
from unity_link.boards.loading import board_names, load_board
from unity_link.boards.pins import generated_ports, pins_of
from unity_link.boards.projects import VENDORS, make_project
from unity_link.errors import ArgumentError
from unity_link.gateware.convert import ConversionError
from unity_link.gateware.own_vhdl import Port, convert_own, read_own
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from unity_link.gateware.own_vhdl import Own

ROOT = Path(__file__).parents[2]
PAGE = files_of(ROOT / "docs/how-to/own-vhdl.md")
PROGRAM = str(Path(sys.executable).parent / "unity-link")
PANEL = compile_text(PAGE["panel.ul"])
TOP = PAGE["panel_ulx3s.vhd"]
BOARD = load_board("ulx3s")[1]
UART = tuple(Port(name, name, way, 0, None) for name, way in [*PINS["uart"].items()][:3])
SMALL = """\
library ieee;
  use ieee.std_logic_1164.all;

entity small is
  generic (baud : positive; width : natural := 2);
  port (clk, uart_rxd, btn0 : in std_logic; uart_txd : out std_logic; Led : out std_logic_vector(0 to width));
end entity;

architecture rtl of small is
  signal unused : std_logic;
begin
  uart_txd <= uart_rxd; led <= (others => btn0 xor unused);
end architecture;
"""
"""An entity without a gateway, so that it is converted quickly."""


def scalar(name: str, way: str = "input") -> Port:
    return Port(name, name, way, 0, None)


def vector(name: str, *indexes: int, way: str = "output") -> Port:
    return Port(name, name, way, len(indexes), indexes)


def files(folder: Path, text: str = TOP, name: str = "panel_ulx3s.vhd") -> Path:
    (folder / name).write_text(text)
    return folder / name


def own(folder: Path, text: str = SMALL, name: str = "small.vhd") -> Own:
    return read_own(files(folder, text, name))


# The pin of each port


@given(st.data())
def test_each_bit_of_a_port_is_the_board_pin_of_its_name_and_number(data: st.DataObject) -> None:
    name = data.draw(st.sampled_from(board_names()))
    _, board = load_board(name)
    rows = data.draw(st.lists(st.sampled_from([*board.io]), unique=True, min_size=1))
    expected: dict[str, str] = {}
    ports = [port for port in generated_ports(board) if not port.name.startswith("chain_")]
    for row in rows:
        io = board.io[row]
        if io.site is not None:
            ports.append(scalar(row))
            expected[row] = io.site
            continue
        first = data.draw(st.integers(0, len(io.sites) - 1))
        indexes = [*range(io.first + first, io.first + data.draw(st.integers(first, len(io.sites) - 1)) + 1)]
        if data.draw(st.booleans()):
            indexes.reverse()
        ports.append(vector(row, *indexes))
        expected |= {f"{row}[{place}]": io.sites[index - io.first] for place, index in enumerate(indexes)}
    sites = [*expected.values(), *(site for pin, site in board.pins.items() if not pin.startswith("chain_"))]
    if len(set(sites)) < len(sites):
        with pytest.raises(ArgumentError, match=rf"^top has \S+ and \S+ at one pin of {name}, \w+$"):
            pins_of("top", tuple(ports), name, board)
        return
    pins = pins_of("top", tuple(ports), name, board)
    assert {port: pin.site for port, pin in pins.items() if pin.site in expected.values()} == expected
    assert pins.keys() - expected.keys() == {pin for pin in PINS[board.medium] if not pin.startswith("chain_")}


def test_a_pin_brings_its_pull_and_its_voltage_along() -> None:
    _, board = load_board("tang_nano_9k")
    pins = pins_of("top", (*UART, vector("btn_n", 0, 1, way="input")), "tang_nano_9k", board)
    assert pins["btn_n[1]"] == Pin("4", "up", "LVCMOS18")


@pytest.mark.parametrize(
    ("ports", "sentence"),
    [
        ([*UART, scalar("lde0")], r"lde0 is no pin of ulx3s, which has clk, uart_rxd, .*gn27; did you mean 'led0'\?"),
        ([*UART, scalar("led")], "led is no pin of ulx3s, which has led0 to led7"),
        ([*UART, vector("led", *range(9))], r"led\(8\) is no pin of ulx3s, which has led0 to led7"),
        ([*UART, vector("led0", 0, 1)], r"led0\(0\) is no pin of ulx3s"),
        (
            [*UART, Port("led", "led", "output", 8, None)],
            "led is no std_logic and no std_logic_vector with numbers for",
        ),
        ([*UART, scalar("chain_in")], "chain_in is no pin of ulx3s"),
        ([*UART, scalar("led0; exit")], "led0; exit is no pin of ulx3s"),
        (UART[1:], "has no port clk, which ulx3s needs: its clock and its link are clk, uart_rxd, uart_txd"),
        (UART[:2], "has no port uart_txd, which ulx3s needs"),
        ([UART[0], UART[2], scalar("uart_rxd", "output")], "uart_rxd is out of one bit, in std_logic was expected"),
        ([*UART[:2], vector("uart_txd", 0, 1)], "uart_txd is out of 2 bits, out std_logic was expected"),
        ([*UART, scalar("clk_ready", "output")], "clk_ready is out of one bit, in std_logic was expected"),
        ([*UART, scalar("led0"), vector("led", 0, 1)], r"has led0 and led\[0\] at one pin of ulx3s, B2"),
    ],
)
def test_port_without_a_pin_is_refused_with_the_pins_of_the_board(ports: list[Port], sentence: str) -> None:
    with pytest.raises(ArgumentError, match=rf"^top(?:: | ){sentence}"):
        pins_of("top", tuple(ports), "ulx3s", BOARD)


@pytest.mark.parametrize(
    ("port", "sentence"),
    [
        (vector("ft_data", *range(7), way="inout"), "ft_data is inout of 7 bits, inout .*7 downto 0"),
        (
            vector("ft_data", *range(7, -1, -1), way="inout"),
            "ft_data counts otherwise than std_logic_vector.7 downto 0",
        ),
    ],
)
def test_the_data_of_an_ft245_are_eight_bits_in_their_order(port: Port, sentence: str) -> None:
    name = "ulx3s_ft245"
    _, board = load_board(name)
    others = [one for one in generated_ports(board) if one.name != "ft_data" and not one.name.startswith("chain_")]
    with pytest.raises(ArgumentError, match=sentence):
        pins_of("top", (*others, port), name, board)


def test_the_top_in_verilog_takes_a_name_that_is_a_word_of_verilog() -> None:
    text = top_text("Panel", BOARD, (*UART, Port("reg", "Reg", "output", 2, (0, 1)), scalar("clk_ready")))
    assert "  output [1:0] \\reg " in text
    assert ".\\Reg (\\reg )" in text
    assert ".\\clk_ready (ready )" in text
    assert "\\clk_ready ," not in text.partition(");")[0]


def test_board_without_io_is_reported() -> None:
    lonely = Board(**{name: getattr(BOARD, name) for name in BOARD.__struct_fields__} | {"io": {}})
    with pytest.raises(
        ArgumentError, match=r"led0 is no pin of mine, whose file has no \[io\], so that clk, uart_rxd, "
    ):
        pins_of("top", (*UART, scalar("led0")), "mine", lonely)
    assert pins_of("top", UART, "mine", lonely).keys() == {"clk", "uart_rxd", "uart_txd"}
    assert Io(sites=("A1", "A2"), first=4).named("j2") == {"j2_4": "A1", "j2_5": "A2"}


# Ports and generics as GHDL reads them


@pytest.mark.rtl
def test_ports_and_generics_of_an_entity_are_read_and_unassigned_reported(tmp_path: Path) -> None:
    top = own(tmp_path)
    found = convert_own(top, {"baud": 9600, "clock_hz": 25_000_000})
    assert (found.module, found.generics) == ("small", {"baud": 9600})
    ports = {port.name: port for port in found.ports}
    assert ports.keys() == {"clk", "uart_rxd", "uart_txd", "led", "btn0"}
    assert ports["led"] == Port("led", "Led", "output", 3, (2, 1, 0))
    assert ports["btn0"] == Port("btn0", "btn0", "input", 0, None)
    (remark,) = found.remarks
    assert re.match(rf'{re.escape(str(tmp_path))}/small\.vhd:10:\d+: signal "unused" is never assigned', remark)


@pytest.mark.rtl
@pytest.mark.parametrize(
    ("bounds", "indexes"),
    [
        ("std_logic_vector(2 downto 0)", (0, 1, 2)),
        ("std_logic_vector(0 to 2)", (2, 1, 0)),
        ("std_logic_vector(3 downto 1)", (1, 2, 3)),
        ("std_logic_vector(width downto 0)", (0, 1, 2)),
        ("std_logic_vector(0 to width)", (2, 1, 0)),
        ("std_logic_vector(2 downto 2)", (2,)),
    ],
)
def test_a_vector_has_the_indexes_that_it_was_declared_with(
    bounds: str, indexes: tuple[int, ...], tmp_path: Path
) -> None:
    text = SMALL.replace("std_logic_vector(0 to width)", bounds)
    (port,) = (port for port in convert_own(own(tmp_path, text), {"baud": 1}).ports if port.name == "led")
    assert port.indexes == indexes


@pytest.mark.rtl
@pytest.mark.parametrize(
    ("replace", "sentence"),
    [
        (("uart_txd <= uart_rxd;", "uart_txd <= ;"), "12:15: primary expression expected"),
        (("btn0 xor", "btn1 xor"), r'12:43: no declaration for "btn1"'),
    ],
)
def test_fault_in_a_users_file_is_reported_with_file_line_and_message(
    replace: tuple[str, str], sentence: str, tmp_path: Path
) -> None:
    with pytest.raises(ConversionError) as raised:
        convert_own(own(tmp_path, SMALL.replace(*replace)), {})
    assert "\n" not in str(raised.value)
    assert re.match(rf"{re.escape(str(tmp_path))}/small\.vhd:{sentence}", str(raised.value)), str(raised.value)


@pytest.mark.rtl
def test_a_generic_without_a_value_is_refused(tmp_path: Path) -> None:
    text = SMALL.replace("baud : positive;", "baud, clock_hz : positive; depth, more : natural := 4;")
    given = {"clock_hz": 25_000_000, "baud": 9600}
    assert convert_own(own(tmp_path, text), given).generics == given
    top = own(tmp_path, text.replace("depth, more : natural := 4", "more, depth : natural"))
    with pytest.raises(
        ArgumentError, match=r"^small has a generic more without a default; clock_hz and baud get values$"
    ):
        convert_own(top, given)


@pytest.mark.rtl
def test_files_that_are_no_top_are_refused_in_one_sentence(tmp_path: Path) -> None:
    two = "entity a is end entity;\nentity b is end entity;\n"
    cases = [
        (
            files(tmp_path, two, "two.vhd"),
            "two.vhd has the entities a, b, and the top is the entity of its file's name",
        ),
        (files(tmp_path, "package p is end;", "p.vhd"), "p.vhd has no entity, and the top is the entity of its file's"),
        (files(tmp_path, "", "none.vhd"), "none.vhd:1:1: design file is empty"),
        (tmp_path / "missing.vhd", "missing.vhd cannot be read: No such file or directory"),
        (tmp_path, "cannot be read: Is a directory"),
    ]
    (tmp_path / "bytes.vhd").write_bytes(bytes(range(256)))
    for path, sentence in [*cases, (tmp_path / "bytes.vhd", "bytes.vhd:1:1: ")]:
        with pytest.raises((ArgumentError, ConversionError)) as raised:
            read_own(path)
        assert sentence in str(raised.value)
        assert "\n" not in str(raised.value)
    again = files(tmp_path, "entity a is end entity;", "again.vhd")
    with pytest.raises(ArgumentError, match=r"again\.vhd has the entity a, and so has .*a\.vhd$"):
        read_own(again, [files(tmp_path, "entity a is end entity;", "a.vhd")])


@pytest.mark.rtl
def test_unit_with_the_name_of_a_generated_or_gateware_unit_is_refused(tmp_path: Path) -> None:
    for name in ("panel_registers", "ul_uart", "board_reset"):
        other = files(tmp_path, f"entity {name} is end entity;", "other.vhd")
        mine = read_own(files(tmp_path, SMALL, "small.vhd"), [other])
        with pytest.raises(ArgumentError, match=rf"other\.vhd has {name}, which is (made from|one of the gateware)"):
            design_of(PANEL, PANEL.interface(), "ulx3s", BOARD, tmp_path, mine)


@pytest.mark.rtl
@pytest.mark.parametrize("name", ["a b", "x; endmodule", "\xb5", "led0;"])
def test_extended_identifier_is_refused_and_a_word_of_verilog_accepted(name: str, tmp_path: Path) -> None:
    text = SMALL.replace("unused", "reg")
    assert convert_own(own(tmp_path, text), {"baud": 1}).module == "small"
    (tmp_path / "small.vhd").write_bytes(text.replace("reg", f"\\{name}\\").encode("latin-1"))
    with pytest.raises(ConversionError, match=r"^small has the extended identifier \\.*\\, which does not go through"):
        convert_own(read_own(tmp_path / "small.vhd"), {"baud": 1})


@pytest.mark.rtl
def test_latin_letters_in_a_file_are_no_fault(tmp_path: Path) -> None:
    (tmp_path / "small.vhd").write_bytes(b"-- \xb5s\n" + SMALL.encode())
    assert convert_own(read_own(tmp_path / "small.vhd"), {"baud": 1}).module == "small"


# A complete build


@pytest.mark.rtl
@pytest.mark.parametrize("name", ["arty_a7", "de10_nano"])
def test_a_project_has_copies_of_the_users_files_and_the_pins_that_they_use(name: str, tmp_path: Path) -> None:
    text = SMALL.replace("Led : out std_logic_vector(0 to width)", "led : out std_logic_vector(2 downto 0)")
    text = text.replace("btn0", "sw0").replace("uart_txd <= uart_rxd;", "uart_txd <= uart_rxd and work.p.yes;")
    package = "library ieee; use ieee.std_logic_1164.all; package p is constant yes : std_logic := '1'; end package;"
    other = files(tmp_path, package, "a [exit] $p;.vhd")
    _, board = load_board(name)
    opened = make_project(PANEL, name, board, tmp_path, own=read_own(files(tmp_path, text, "small.vhd"), [other]))
    script = opened.with_suffix({"tcl": ".tcl", "qpf": ".qsf"}[VENDORS[board.family].opened])
    assert (opened.parent / "own" / "small.vhd").read_text() == text
    assert (opened.parent / "own" / "a__exit___p_.vhd").read_text() == package
    said = script.read_text()
    assert said.index("own/a__exit___p_.vhd") < said.index("own/small.vhd")
    assert "exit]" not in said
    assert "clock_hz" not in said
    pins = said + (opened.with_suffix(".xdc").read_text() if name == "arty_a7" else "")
    assert "led[2]" in pins
    assert "sw0" in pins
    assert "chain_" not in pins
    assert not list(opened.parent.glob("*_on_*"))


@pytest.mark.rtl
def test_build_makes_a_project_of_a_users_top_and_prints_its_warnings(tmp_path: Path) -> None:
    files(tmp_path, PAGE["panel.ul"], "panel.ul")
    files(tmp_path, SMALL.replace("Led", "led").replace("0 to width", "work.p.high downto 0"), "small.vhd")
    files(tmp_path, "package p is constant high : natural := 2; end package;", "p.vhd")
    command = ["build", "panel.ul", "--board", "arty_a7", "--vhdl", "p.vhd", "--top", "small.vhd"]
    done = subprocess.run([PROGRAM, *command], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout == "panel_arty_a7/panel_arty_a7.tcl\n"
    assert done.stderr.startswith('warning: small.vhd:10:10: signal "unused" is never assigned')


@pytest.mark.rtl
def test_project_needs_ports_in_small_letters(tmp_path: Path) -> None:
    text = SMALL.replace("0 to width", "2 downto 0")
    with pytest.raises(ArgumentError, match=r"^Vivado distinguishes capitals .*: the port Led was expected as led$"):
        make_project(PANEL, *load_board("arty_a7"), tmp_path / "out", own=own(tmp_path, text))
    assert not (tmp_path / "out").exists()


def test_missing_further_file_is_reported_by_name(tmp_path: Path) -> None:
    spec = tmp_path / "panel.ul"
    spec.write_text(PAGE["panel.ul"])
    done = subprocess.run(
        [PROGRAM, "build", str(spec), "--board", "ulx3s", "--vhdl", "x.vhd"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2
    assert done.stderr == "error: x.vhd cannot be read: No such file or directory\n"


@pytest.mark.slow
@pytest.mark.rtl
def test_own_vhdl_page_builds_a_bitstream_and_interruption_leaves_no_files(tmp_path: Path) -> None:
    for name, text in PAGE.items():
        (tmp_path / name).write_text(text)
    (command,) = re.findall(
        r"^unity-link (build .* --top .*)$", (ROOT / "docs/how-to/own-vhdl.md").read_text(), re.MULTILINE
    )
    arguments = [PROGRAM, *command.split(), "-o", "out"]
    with subprocess.Popen(arguments, cwd=tmp_path, stderr=subprocess.PIPE, text=True) as process:
        # Wait until one of the tools runs.
        while not Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text():
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "Traceback" not in said
    assert not (tmp_path / "out").exists()

    subprocess.run(arguments, cwd=tmp_path, check=True, env=os.environ)
    report = (tmp_path / "out" / "panel_ulx3s.md").read_text()
    assert (tmp_path / "out" / "panel_ulx3s.bit").stat().st_size > 50_000
    assert f"- VHDL: panel\\_ulx3s.vhd, SHA-256 {hashlib.sha256(TOP.encode()).hexdigest()}" in report
    sites = dict(re.findall(r"^\| (\S+) \| (?:input|output) \| (\w+) \|$", report, re.MULTILINE))
    expected = {f"led[{bit}]": site for bit, site in enumerate(BOARD.io["led"].sites)}
    expected |= {f"btn[{bit}]": site for bit, site in enumerate(BOARD.io["btn"].sites)}
    assert sites == expected | {pin: BOARD.pins[pin] for pin in ("clk", "uart_rxd", "uart_txd")}

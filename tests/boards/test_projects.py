"""Projects for vendors' tools: all files are present, in an order that GHDL accepts, and every pin has a site."""

from __future__ import annotations

import functools
import re
import subprocess
import tkinter as tk
from fnmatch import fnmatchcase
from pathlib import Path

import msgspec
import pytest

from unity_link.boards import projects
from unity_link.boards.board import PINS, Board
from unity_link.boards.loading import board_names, load_board
from unity_link.boards.projects import VENDORS, make_project
from unity_link.cli import main
from unity_link.errors import ArgumentError
from unity_link.gateware.pin_times import PIN_TIMES
from unity_link.quoting import one_line
from unity_link.spec import compile_text

LAMP_TEXT = "public lamp() { @on = 0[7:0]: unsigned READWRITE(); @current = 1: signed 16 READ(PUBLISH(1, 100)); }\n"
LAMP = compile_text(LAMP_TEXT)
PROJECTS = [name for name in board_names() if load_board(name)[1].family in VENDORS]
_VIVADO = (
    *("create_project", "read_vhdl", "read_xdc", "set_property", "current_fileset", "launch_runs", "wait_on_run"),
    *("get_runs", "create_clock", "create_generated_clock", "get_ports", "get_pins", "set_false_path"),
    *("set_input_delay", "set_output_delay"),
)
_QUARTUS = (
    *("set_global_assignment", "set_parameter", "set_location_assignment", "set_instance_assignment", "create_clock"),
    *("create_generated_clock", "get_ports", "derive_clock_uncertainty", "set_false_path"),
    *("set_input_delay", "set_output_delay", "get_pins", "get_registers", "set_max_delay", "set_max_skew"),
    "set_net_delay",
)


def changed(board: Board, **changes: object) -> Board:
    return msgspec.convert(msgspec.to_builtins(board) | changes, Board)


def evaluated(path: Path, commands: tuple[str, ...], arguments: str = "", slack: str = "-0.1") -> list[tuple[str, ...]]:
    """Return the commands that a script gives to a tool, which Tcl without the tool records.

    Args:
        path: of the script.
        commands: names of the tool's commands.
        arguments: of the script.
        slack: slack in ns that the tool reports.
    """
    said: list[tuple[str, ...]] = []
    tcl = tk.Tcl()

    def note(*words: str) -> str:
        said.append(words)
        return words[-1] if words[0] == "get_ports" else words[0]

    for command in commands:
        tcl.createcommand(command, functools.partial(note, command))
    tcl.createcommand("get_property", lambda *_: slack)
    tcl.createcommand("get_collection_size", lambda *_: "1")
    for bit in range(8):
        # Quartus writes and reads names of pins such as led[0] without braces.
        tcl.createcommand(str(bit), lambda bit=bit: f"[{bit}]")
    tcl.setvar("argv", arguments)
    # Do not use `cd`, which would change the folder of the whole process; relative paths of a .qsf are joined later.
    tcl.eval(f"source {path}")
    return said


def constrained(opened: Path, board: Board) -> list[tuple[str, ...]]:
    """Return the constraints of a project that apply to its whole top."""
    if board.family == "cyclonev":
        said = evaluated(opened.with_suffix(".qsf"), _QUARTUS)
        paths = [opened.parent / words[3] for words in said if "SDC_FILE" in words]
        return [words for path in paths for words in evaluated(path, _QUARTUS)]
    read = [words for words in evaluated(opened, _VIVADO) if words[0] == "read_xdc"]
    return [words for one in read if "-ref" not in one for words in evaluated(Path(one[-1]), _VIVADO)]


def sources(said: list[tuple[str, ...]], folder: Path) -> dict[str, list[str]]:
    """Return the VHDL files of each library, in the order of compilation."""
    found: dict[str, list[str]] = {}
    for words in said:
        (path,) = [word for word in words if word.endswith(".vhd")] or [""]
        if path:
            library = words[words.index("-library") + 1] if "-library" in words else "work"
            assert any("2008" in word for word in words)
            found.setdefault(library, []).append(str(folder / path))
    return found


def ghdl(folder: Path, *arguments: str) -> None:
    done = subprocess.run(["ghdl", *arguments], cwd=folder, check=False, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("name", PROJECTS)
def test_a_project_has_the_whole_design_in_order_and_ghdl_elaborates_its_top(name: str, tmp_path: Path) -> None:
    _, board = load_board(name)
    opened = make_project(LAMP, name, board, tmp_path)
    assert opened.is_file()
    path = opened.with_suffix(".qsf") if board.family == "cyclonev" else opened
    said = evaluated(path, _QUARTUS if board.family == "cyclonev" else _VIVADO)
    libraries = sources(said, opened.parent)
    assert libraries.keys() == {"unity_link", "work"}
    built = tmp_path / "built"
    built.mkdir()
    for library, files in libraries.items():
        ghdl(built, "-a", "--std=08", f"--work={library}", *files)
    generics = [f"-g{generic}={value}" for generic, value in board.generics.items()]
    ghdl(built, "--elab-run", "--std=08", f"lamp_on_{board.medium}", *generics, "--no-run")


@pytest.mark.parametrize("name", PROJECTS)
def test_every_pin_has_its_site_and_the_clock_its_period(name: str, tmp_path: Path) -> None:
    _, board = load_board(name)
    opened = make_project(LAMP, name, board, tmp_path)
    if board.family == "cyclonev":
        said = evaluated(opened.with_suffix(".qsf"), _QUARTUS)
        sites = {words[3]: words[1].removeprefix("PIN_") for words in said if words[0] == "set_location_assignment"}
        parameters = {words[2]: words[3] for words in said if words[0] == "set_parameter"}
    else:
        said = evaluated(opened, _VIVADO)
        text = opened.with_suffix(".xdc").read_text()
        sites = {pin: site for site, pin in re.findall(r"PACKAGE_PIN (\w+) .*\[get_ports \{(\S+)\}\]", text)}
        generics = next(words[2] for words in said if words[:2] == ("set_property", "generic"))
        parameters = dict(pair.split("=") for pair in generics.split())
    assert sites == board.pins
    assert parameters == {generic: str(value) for generic, value in board.generics.items()}
    periods = {
        words[words.index("-name") + 1]: float(words[words.index("-period") + 1])
        for words in constrained(opened, board)
        if words[0] == "create_clock" and words[-1] in board.clocks
    }
    assert periods == {clock: pytest.approx(1e9 / hz) for clock, hz in board.clocks.items()}


def on_medium(name: str, medium: str) -> Board:
    """Return a board of a family with pins for a medium."""
    pins = {pin: f"A{place}" for place, pin in enumerate(PINS[medium])}
    return changed(load_board(name)[1], medium=medium, baud=1_000_000 if medium == "uart" else None, pins=pins)


@pytest.mark.parametrize("name", ["arty_a7", "de10_nano"])
@pytest.mark.parametrize("medium", ["uart", *PIN_TIMES])
def test_each_pin_has_a_delay_or_is_in_no_clock(name: str, medium: str, tmp_path: Path) -> None:
    board = on_medium(name, medium)
    said = constrained(make_project(LAMP, "mine", board, tmp_path), board)
    for command, end, way in (("set_input_delay", "-from", "input"), ("set_output_delay", "-to", "output")):
        ports = " ".join(
            words[-1] for words in said if words[0] == command or words[:2] == ("set_false_path", end)
        ).split()
        wanted = {pin for pin, its in PINS[medium].items() if its in (way, "inout")}
        made = {pins.clock for pins in PIN_TIMES.get(medium, ())}
        named = {pin for pin in wanted if any(fnmatchcase(pin, port.replace("[", "[[]")) for port in ports)}
        assert wanted - named - board.clocks.keys() - made == set()


@pytest.mark.parametrize("medium", ["ft245_sync", "rmii", "mii", "rgmii"])
def test_clock_constraints_precede_the_files_of_entities_that_refer_to_them(medium: str, tmp_path: Path) -> None:
    said = evaluated(make_project(LAMP, "mine", on_medium("arty_a7", medium), tmp_path), _VIVADO)
    is_scoped = ["-ref" in words for words in said if words[0] == "read_xdc"]
    assert is_scoped == sorted(is_scoped)
    assert is_scoped.count(False) == 2


def test_addresses_reach_the_generics_of_vivado_as_bits(tmp_path: Path) -> None:
    board = changed(load_board("arty_a7_mii")[1], mac="02:55:4c:00:00:02")
    said = evaluated(make_project(LAMP, "mine", board, tmp_path), _VIVADO)
    generics = next(words[2] for words in said if words[:2] == ("set_property", "generic"))
    assert generics == f"clock_hz=100000000 mac_address=48'b{0x02554C000002:048b}"


def test_a_bitstream_of_vivado_that_misses_its_clock_is_an_error(tmp_path: Path) -> None:
    opened = make_project(LAMP, *load_board("arty_a7"), tmp_path)
    with pytest.raises(tk.TclError, match="lamp_on_uart does not keep its times on Digilent Arty A7-35T"):
        evaluated(opened, _VIVADO, "bitstream")
    asked = [words for words in evaluated(opened, _VIVADO, "bitstream", slack="0.1") if words[0] == "get_runs"]
    # The first command waits for the run; the other two ask for the worst setup and the worst hold slack.
    assert len(asked) == 2


HOSTILE_TITLE = 'Arty"; exec touch PWNED; [exec touch PWNED] $x } { #\nexec touch PWNED \u2028 \\\\'


@pytest.mark.parametrize("name", PROJECTS)
def test_title_is_not_executed_by_the_tool(name: str, tmp_path: Path) -> None:
    # A title could call `exec`: record the command instead of running it.
    commands = (*(_QUARTUS if load_board(name)[1].family == "cyclonev" else _VIVADO), "exec")
    said = {}
    for kind, title in (("plain", "Arty"), ("hostile", HOSTILE_TITLE)):
        opened = make_project(LAMP, name, changed(load_board(name)[1], title=title), tmp_path / kind)
        scripts = [opened.with_suffix(suffix) for suffix in (".tcl", ".xdc", ".qsf", ".sdc")]
        found = [(path.name, evaluated(path, commands)) for path in scripts if path.exists()]
        said[kind] = repr(found).replace(f"{tmp_path / kind}", "")
    assert said["hostile"] == said["plain"]


def test_title_is_printed_unchanged_if_times_are_not_kept(tmp_path: Path) -> None:
    board = changed(load_board("arty_a7")[1], title=HOSTILE_TITLE)
    with pytest.raises(tk.TclError) as raised:
        evaluated(make_project(LAMP, "mine", board, tmp_path), (*_VIVADO, "exec"), "bitstream")
    assert f"does not keep its times on {one_line(HOSTILE_TITLE)}: see" in str(raised.value)


@pytest.mark.parametrize("name", PROJECTS)
@pytest.mark.parametrize("key", ["device", "package", "io_type", "clk"])
def test_board_with_strings_that_end_a_command_is_refused(name: str, key: str, tmp_path: Path) -> None:
    text = (Path(projects.__file__).with_name("data") / f"{name}.toml").read_text()
    text = text if f"{key} = " in text else f'{key} = "LVCMOS33"\n{text}'
    path = tmp_path / "mine.toml"
    path.write_text(re.sub(rf'^({key} = "[^"]*)"', rf'\1; exec touch {tmp_path}/PWNED"', text, flags=re.MULTILINE))
    with pytest.raises(ArgumentError, match=rf"{key} is '.*; exec touch .*', .* expected"):
        load_board(str(path))


@pytest.mark.parametrize("name", ["a b", "x; exec touch y", "a\nb", "$x"])
def test_the_name_of_a_board_file_is_one_that_projects_can_have(name: str, tmp_path: Path) -> None:
    path = tmp_path / f"{name}.toml"
    path.write_text((Path(projects.__file__).with_name("data") / "arty_a7.toml").read_text())
    with pytest.raises(ArgumentError, match=r"its name is .*, letters, digits, '_', '-' and '\.' were expected"):
        load_board(str(path))


def test_an_ft245_on_a_xilinx_gets_its_pads_and_the_constraints_of_its_pins(tmp_path: Path) -> None:
    pins = {pin: f"A{place}" for place, pin in enumerate(PINS["ft245_sync"])}
    board = changed(load_board("arty_a7")[1], medium="ft245_sync", baud=None, pins=pins)
    said = evaluated(make_project(LAMP, "mine", board, tmp_path), _VIVADO)
    files = sources(said, tmp_path)["unity_link"]
    assert any("pads/xilinx/ul_pad_output.vhd" in file for file in files)
    assert not any("rtl/physical/ul_pad_output.vhd" in file for file in files)
    read = [words[-1] for words in said if words[0] == "read_xdc"]
    assert any(path.endswith("ul_ft245_sync_pins.xdc") for path in read)


def test_pll_in_a_vendors_project_is_refused(tmp_path: Path) -> None:
    board = changed(load_board("arty_a7")[1], clock={"hz": 100_000_000, "core_hz": 50_000_000})
    with pytest.raises(ArgumentError, match=r"^no PLL is made in a project of Vivado, and core_hz = 50000000 asks"):
        make_project(LAMP, "mine", board, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_the_command_prints_the_file_to_open_and_does_not_program(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    spec = tmp_path / "lamp.ul"
    spec.write_text(LAMP_TEXT)
    command = ["unity-link", "build", str(spec), "--board", "de10_nano", "-o", str(tmp_path / "out")]
    for more, code in (["--program"], 2), ([], 0):
        monkeypatch.setattr("sys.argv", [*command, *more])
        with pytest.raises(SystemExit) as ended:
            main()
        assert ended.value.code == code
    said = capsys.readouterr()
    opened = tmp_path / "out" / "lamp_de10_nano" / "lamp_de10_nano.qpf"
    assert said.out.split() == [str(opened)]
    assert "error: --program needs a bitstream, and that of de10_nano is made by Quartus" in said.err
    assert f"quartus {opened}" in said.err

"""`unity-link check`, `fmt`, `show`, `import rdl` and `export rdl`, as a shell runs them."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from support.spec_examples import FIGURE_1
from unity_link.generate import TARGETS
from unity_link.spec import format_text

WRONG = "public robot() {\n  @a = 1: REED();\n}\n"


def run(folder: Path, *arguments: str, stdin: str = "") -> subprocess.CompletedProcess[str]:
    code = "from unity_link.cli import main; main()"
    return subprocess.run(
        [sys.executable, "-c", code, *arguments], cwd=folder, input=stdin, capture_output=True, text=True, check=False
    )


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "scara.ul").write_text(FIGURE_1)
    (tmp_path / "wrong.ul").write_text(WRONG)
    return tmp_path


def test_check_reports_a_valid_spec(folder: Path) -> None:
    done = run(folder, "check", "scara.ul")
    assert (done.returncode, done.stdout, done.stderr) == (0, "scara.ul: no errors; scara with 16 signals\n", "")


def test_check_prints_faults_on_stderr_and_fails(folder: Path) -> None:
    done = run(folder, "check", "wrong.ul")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == (
        "wrong.ul:2:11: error: there is no access 'REED'\n    2 |   @a = 1: REED();\n      |           ^^^^\n"
        "  help: did you mean 'READ'?\n1 error\n"
    )


@pytest.mark.parametrize(("name", "code", "count"), [("scara.ul", 0, 0), ("wrong.ul", 1, 1)])
def test_check_gives_its_findings_as_json(folder: Path, name: str, code: int, count: int) -> None:
    done = run(folder, "check", "--json", name)
    found = json.loads(done.stdout)
    assert (done.returncode, done.stderr, found["valid"], len(found["diagnostics"])) == (code, "", code == 0, count)


def test_check_takes_the_widths_of_a_gateway_and_stdin(folder: Path) -> None:
    text = "public robot() { @a = 0x100: READ(); }"
    assert run(folder, "check", "-", stdin=text).returncode == 1
    assert run(folder, "check", "-", "--address-bits", "16", stdin=text).returncode == 0


def test_missing_file_is_reported_without_a_traceback(folder: Path) -> None:
    for command in (["check"], ["fmt"], ["show"], ["import", "rdl"], ["export", "rdl"]):
        done = run(folder, *command, "nothing.ul")
        assert done.returncode == 1, command
        assert "nothing.ul" in done.stderr
        assert "Traceback" not in done.stderr


def test_fmt_changes_a_file_once(folder: Path) -> None:
    assert run(folder, "fmt", "scara.ul").stderr == "changed scara.ul\n"
    assert (folder / "scara.ul").read_text() == format_text(FIGURE_1)
    assert run(folder, "fmt", "scara.ul").stderr == ""
    assert sorted(path.name for path in folder.iterdir()) == ["scara.ul", "wrong.ul"]


def test_fmt_keeps_the_mode_of_a_file_and_a_link_to_it(folder: Path) -> None:
    (folder / "scara.ul").chmod(0o640)
    (folder / "link.ul").symlink_to("scara.ul")
    run(folder, "fmt", "link.ul")
    assert (folder / "link.ul").is_symlink()
    assert (folder / "scara.ul").stat().st_mode & 0o777 == 0o640
    assert (folder / "scara.ul").read_text() == format_text(FIGURE_1)


def test_fmt_check_and_diff_change_nothing(folder: Path) -> None:
    checked = run(folder, "fmt", "--check", "scara.ul", "wrong.ul")
    assert (checked.returncode, checked.stderr) == (1, "would change scara.ul\n")
    shown = run(folder, "fmt", "--diff", "scara.ul")
    assert shown.returncode == 0
    assert '-  j1: joint("joint 1") @(0x80,0x88,0x8C,0x94);\n' in shown.stdout
    assert '+  j1: joint("joint 1") @(0x80, 0x88, 0x8C, 0x94);\n' in shown.stdout
    assert (folder / "scara.ul").read_text() == FIGURE_1


def test_fmt_leaves_a_file_with_a_wrong_syntax_alone_and_formats_the_others(folder: Path) -> None:
    (folder / "broken.ul").write_text("public x( {")
    done = run(folder, "fmt", "broken.ul", "scara.ul")
    assert done.returncode == 1
    assert "broken.ul:1:11: error" in done.stderr
    assert (folder / "broken.ul").read_text() == "public x( {"
    assert (folder / "scara.ul").read_text() == format_text(FIGURE_1)


def test_fmt_formats_stdin_to_stdout(folder: Path) -> None:
    assert run(folder, "fmt", "-", stdin=FIGURE_1).stdout == format_text(FIGURE_1)


def test_show_gives_a_tree_with_addresses(folder: Path) -> None:
    lines = run(folder, "show", "scara.ul").stdout.splitlines()
    assert lines[0].rstrip() == "scara  8 address bits, 32 data bits"
    assert lines[2].rstrip() == "├── group group_1 1: base frequency / 10, 8 signals in 8 words"
    assert lines[4].rstrip() == '│   ├── 0x88 cpos: signed 32 READ  published by group_1 "joint 1:cpos"'


def test_show_gives_the_model_as_json(folder: Path) -> None:
    model = json.loads(run(folder, "show", "--json", "scara.ul").stdout)
    assert model["name"] == "scara"
    assert model["root"]["parts"][0]["signals"][0]["address"] == 0x88
    assert model["modules"][0]["arguments"]["CTRL"] == {"type": "parameter", "name": "ctrl"}


CORES = """\
public lamp() {
  dimmer: dimmer(among=state) @(0x20, lamp="gp3", key=none);
  @mode = 0x28[1:0]: mode READWRITE(PIN="led", RESET=blink);
  @on = 0x29[0]: bool READWRITE(PIN="led7", RESET=true);
}
dimmer(WIDTH=8, among=none): @(BASE) {
  ENTITY("dimmer", TICK, width=WIDTH, name="a \\"b\\"", fast=true);
  @level = BASE: unsigned WIDTH READWRITE(RESET=200);
  @lamp: PIN(OUT);
  @key: PIN(IN);
  @bus: PIN(INOUT);
  @edge: TRIGGER(among);
  @count = BASE + 1: READ(PUBLISH(among));
}
enum mode { off, blink }
group state(TRIGGER);
"""


def test_show_prints_the_entity_and_pins_of_a_component(folder: Path) -> None:
    (folder / "lamp.ul").write_text(CORES)
    lines = [line.rstrip() for line in run(folder, "show", "lamp.ul").stdout.splitlines()]
    assert lines[2:] == [
        "├── 0x28[1:0] mode: mode 2 READWRITE  blink after a reset, at 2 pins of led",
        "├── 0x29[0] on: bool READWRITE  true after a reset, at led7",
        '├── dimmer: dimmer  work.dimmer(width => 8, name => "a ""b""", fast => true)',
        "│   ├── 0x20[7:0] level: unsigned 8 READWRITE  200 after a reset",
        "│   ├── 0x21 count: unsigned 32 READ  published by state",
        "│   ├── lamp: PIN(OUT)  gp3",
        "│   ├── key: PIN(IN)  not wired",
        "│   ├── bus: PIN(INOUT)  no pin of a board yet",
        "│   └── edge: TRIGGER  group state",
        "└── pins of the board",
        "    ├── led: mode  OUT",
        "    ├── led7: on  OUT",
        "    └── gp3: dimmer.lamp  OUT",
    ]


LEASED = """\
public arm() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE() @(0x80);
  plan: SCHEDULE() @(0xA0);
  @angle = 0x10: signed 16 READWRITE(SCALE=0.1, UNIT="deg", SAFE(90.1, drive), TIMED(plan));
  axis: axis(drive) @(0x11);
  @mode = 0x12[1:0]: mode READWRITE(SAFE(blink, drive));
  @key = 0x13[0]: bool READ(PIN="sw0", PUBLISH(one));
}
axis(LEASE): @(at) { ENTITY("axis", ARMED); @goal = at: READWRITE(SAFE(HOLD, LEASE)); }
enum mode { off, blink }
group one(TRIGGER);
"""


def test_show_gives_safe_values_with_their_lease_schedules_and_pins(folder: Path) -> None:
    (folder / "arm.ul").write_text(LEASED)
    lines = [line.rstrip() for line in run(folder, "show", "arm.ul").stdout.splitlines()]
    while_not = "after a reset and while drive is not armed"
    assert lines[1:5] == [
        "├── group one 0: on its trigger, 1 signal in 1 word",
        f"├── 0x010[15:0] angle: signed 16 READWRITE  x 0.1 deg 90.1 deg {while_not}, TIMED by plan",
        f"├── 0x012[1:0] mode: mode 2 READWRITE  blink {while_not}",
        "├── 0x013[0] key: bool READ  published by one, at sw0",
    ]
    assert lines[-4:] == [
        "├── axis: axis  work.axis",
        "│   └── 0x011 goal: unsigned 32 READWRITE  keeps its value while drive is not armed",
        "└── pins of the board",
        "    └── sw0: key  IN",
    ]


def test_show_lists_the_interfaces(folder: Path) -> None:
    (folder / "two.ul").write_text("public a() { @x = 1: READ(); }\npublic b() { @y = 2: READ(); }")
    assert "0x02 y" in run(folder, "show", "two.ul").stdout
    assert "0x01 x" not in run(folder, "show", "--interface", "b", "two.ul").stdout
    done = run(folder, "show", "--interface", "c", "two.ul")
    assert (done.returncode, done.stderr) == (
        2, "error: the spec has no public interface 'c': a, b was expected\n",
    )  # fmt: skip


def test_systemrdl_goes_out_and_in(folder: Path) -> None:
    assert run(folder, "export", "rdl", "scara.ul", "-o", "scara.rdl").returncode == 0
    done = run(folder, "import", "rdl", "scara.rdl", "-o", "back.ul")
    assert (done.returncode, done.stderr) == (0, "")
    assert run(folder, "check", "back.ul").stdout == "back.ul: no errors; scara with 16 signals\n"
    assert run(folder, "export", "rdl", "scara.ul").stdout == (folder / "scara.rdl").read_text()


MACROS = "".join(f"`define A{index} `A{index - 1} `A{index - 1}\n" for index in range(1, 40))
BOMB = "addrmap top { reg { field { desc = " + '"x";' + " } `A39; } r @0; };"


@pytest.mark.slow
def test_perl_that_never_ends_is_refused_and_ended(folder: Path) -> None:
    (folder / "perl.rdl").write_text("addrmap top {\n<% while (1) {} %> reg { field {} f[8]; } r @0; };")
    done = run(folder, "import", "rdl", "perl.rdl")
    assert (done.returncode, done.stderr.splitlines()[0]) == (
        1, "perl.rdl:2:1: error: this is Perl, a program: it is run only by `import rdl --perl`",
    )  # fmt: skip
    done = run(folder, "import", "rdl", "perl.rdl", "--perl")
    assert (done.returncode, done.stderr.splitlines()[0]) == (
        1, "perl.rdl:2:1: error: the Perl of this file does not end within 5 s",
    )  # fmt: skip


def test_macros_that_take_too_long_end_in_a_sentence(folder: Path) -> None:
    (folder / "macros.rdl").write_text(f"`define A0 a\n{MACROS}{BOMB}")
    done = run(folder, "import", "rdl", "macros.rdl", "--seconds", "1")
    assert (done.returncode, done.stdout, done.stderr) == (
        1, "", "error: macros.rdl takes more than 1 s of processor time; `--seconds` gives it more\n",
    )  # fmt: skip


@pytest.mark.slow
def test_macros_that_take_too_much_memory_end_in_a_sentence(folder: Path) -> None:
    (folder / "macros.rdl").write_text(f"`define A0 {'a' * 8_000_000}\n{MACROS}{BOMB}")
    done = run(folder, "import", "rdl", "macros.rdl")
    assert (done.returncode, done.stdout, done.stderr) == (
        1, "", "error: macros.rdl takes more than 2 GiB of memory\n",
    )  # fmt: skip


def test_path_that_cannot_be_written_is_reported(folder: Path) -> None:
    done = run(folder, "export", "rdl", "scara.ul", "-o", "no/such/folder.rdl")
    assert done.returncode == 2
    assert "no/such/folder.rdl cannot be written: No such file or directory" in done.stderr


def test_generate_writes_and_lists_the_files(folder: Path) -> None:
    done = run(folder, "generate", "docs", "scara.ul", "-o", "made")
    assert (done.returncode, done.stdout.split()) == (0, ["made/scara.html", "made/scara.md"])
    assert all((folder / name).exists() for name in done.stdout.split())


@pytest.mark.parametrize("arguments", [[], ["rust"], ["rust", "scara.ul"]])
def test_generate_lists_its_targets(folder: Path, arguments: list[str]) -> None:
    done = run(folder, "generate", *arguments)
    assert done.returncode == 2
    assert "Traceback" not in done.stderr
    assert all(target in done.stderr for target in TARGETS)

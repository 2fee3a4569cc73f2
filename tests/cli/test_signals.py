"""Names of signals on the command line, and their completion by a shell."""

from __future__ import annotations

import contextlib
import io
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple
from unittest import mock

import pytest

from support.effects import TEXT
from unity_link import cli
from unity_link.cli import completion
from unity_link.cli.spec import url_and_spec
from unity_link.errors import ArgumentError
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.spec import compile_text
from unity_link.transport import parse_url

ROOT = Path(__file__).parents[2]
SCARA = str(ROOT / "examples" / "scara.ul")
SPEC = """
enum mode { IDLE = 0, RUN = 1 }
public rover() {
  @left = 0x10: signed 32 READWRITE(SCALE=0.5, UNIT="m/s", MIN=-10, MAX=10);
  @state = 0x11: mode READWRITE();
  @lamp = 0x12: bool READWRITE();
  @ticks = 0x13: unsigned READ();
}
"""
GROUPED = """
group motion(RATE=10);
public rover() { @left = 0x10: READ(PUBLISH(motion)); @right = 0x11: READ(PUBLISH(motion)); }
"""


class Result(NamedTuple):
    returncode: int
    stdout: str
    stderr: str


def run(*arguments: str, **environment: str) -> Result:
    """Run a command in this process; the tests are about the command line, not about processes."""
    out, err = io.StringIO(), io.StringIO()
    with (
        mock.patch.dict(os.environ, environment),
        mock.patch.object(sys, "argv", ["unity-link", *arguments]),
        contextlib.redirect_stdout(out),
        contextlib.redirect_stderr(err),
        pytest.raises(SystemExit) as ended,
    ):
        cli.main()
    assert isinstance(ended.value.code, int)
    return Result(ended.value.code, out.getvalue(), err.getvalue())


@pytest.fixture
def rover(tmp_path: Path) -> str:
    path = tmp_path / "rover.ul"
    path.write_text(SPEC)
    return str(path)


def test_signals_are_read_by_name_part_and_pattern_in_their_units() -> None:
    assert run("get", "sim:scara", SCARA, "j1.spd_sp").stdout == "j1.spd_sp  74.9988 deg/s\n"
    whole = json.loads(run("get", "sim:scara", SCARA, "j2", "*.cpos", "--json").stdout)
    assert list(whole["values"]) == ["j2.cpos", "j2.spd", "j2.pos_sp", "j2.spd_sp", "j1.cpos", "j3.cpos", "j4.cpos"]
    assert whole["units"]["j3.cpos"] == "mm"


def test_the_environment_may_name_the_spec() -> None:
    assert run("get", "sim:scara", "j4.spd_sp", "--values", UNITY_LINK_SPEC=SCARA).stdout == "225\n"


def test_signals_are_written_by_name_with_units_names_and_truths(rover: str) -> None:
    result = run("set", "sim:", rover, "left=-1.5 m/s", "state=RUN", "lamp=on", "--json")
    assert json.loads(result.stdout)["values"] == {"left": -1.5, "state": "RUN", "lamp": True}


@pytest.mark.parametrize("given", ["0x1A", "0x1A A", "26A", "26 A"])
def test_a_number_that_ends_as_its_unit_does_is_read_whole(given: str, tmp_path: Path) -> None:
    spec = tmp_path / "motor.ul"
    spec.write_text('public motor() { @current = 0: unsigned 16 READWRITE(UNIT="A"); }')
    assert run("set", "sim:", str(spec), f"current={given}").stdout == "current  26 A\n"


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["get", "lfet"], "rover has no signal 'lfet': did you mean 'left'?"),
        (["set", "left=11"], "left: 11 is outside of its limits, -10 to 10 m/s"),
        (["set", "lamp=on", "left=fast"], "left: 'fast' is no value of signed 32: a number in m/s was expected"),
        (["set", "left=1 mm/s"], "left: '1 mm/s' is no value of signed 32: a number in m/s was expected"),
        (["set", "state=STOP"], "state: 'STOP' is no value of mode: IDLE, RUN are"),
        (["set", "ticks=1"], "ticks is a READ signal, and cannot be written"),
        (["set", "left"], "'left' is no SIGNAL=VALUE: write, for example, left=1"),
        (["set"], "no signal was given: SIGNAL=VALUE was expected, such as j1.target=-1.5"),
        (["watch", "left", "--format", "hex"], "--format hex goes with addresses: signals are written in their units"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_wrong_name_or_value_is_reported_before_any_write(
    arguments: list[str], words: str, rover: str, tmp_path: Path
) -> None:
    command, *rest = arguments
    snoop = tmp_path / "nothing"
    result = run(command, f"sim:?snoop={snoop}", rover, *rest)
    assert (result.returncode, result.stdout, result.stderr) == (2, "", f"error: {words}\n")
    assert not snoop.exists()


def test_group_instead_of_a_signal_is_an_error_that_lists_its_signals(tmp_path: Path) -> None:
    spec = tmp_path / "rover.ul"
    spec.write_text(GROUPED)
    result = run("watch", "sim:", str(spec), "motion")
    assert result == (2, "", "error: 'motion' is a group of rover: name its signals, left, right\n")


def test_name_without_a_spec_is_an_error_that_asks_for_a_spec() -> None:
    result = run("get", "sim:scara", "j1.cpos")
    assert result.returncode == 2
    assert "no SPEC says which signals there are, and the gateway of sim:scara carries no description" in result.stderr
    assert "give a spec, such as robot.ul, or set UNITY_LINK_SPEC" in result.stderr
    assert "88 is no signal: an address is written 0x88" in run("get", "sim:scara", "88").stderr


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["get", SCARA, "sim:scara", "j1.cpos"], "URL and SPEC are swapped: sim:scara"),
        (["watch", SCARA, "sim:scara"], "URL and SPEC are swapped: sim:scara"),
        (["live", SCARA, "sim:scara"], "URL and SPEC are swapped: sim:scara"),
        (["record", SCARA, "sim:scara", "--output", "x.mcap"], "URL and SPEC are swapped: sim:scara"),
        (["ros1", SCARA, "sim:scara"], "URL and SPEC are swapped: sim:scara"),
        (["ros2", SCARA, "sim:scara"], "URL and SPEC are swapped: sim:scara"),
        (["zenoh", SCARA, "sim:scara", "--prefix", "a"], "URL and SPEC are swapped: sim:scara"),
        (["show", "sim:scara"], "the gateway of sim:scara carries no description of its own"),
        (["info", SCARA], "is no URL of a gateway: it is a spec"),
        (["read", "0x10", "sim:scara"], "it is a URL, which goes before the addresses"),
    ],
)
def test_swapped_url_and_spec_are_reported(arguments: list[str], said: str) -> None:
    result = run(*arguments)
    assert result.returncode != 0
    assert said in result.stderr


@pytest.mark.parametrize(
    ("arguments", "found"),
    [
        (("sim:a", "a.ul", None), ("sim:a", "a.ul")),
        (("a.ul", None, "sim:a"), ("sim:a", "a.ul")),
        (("sim:a", None, None), ("sim:a", "sim:a")),
        ((None, None, "sim:a"), ("sim:a", "sim:a")),
        (("a.ul", None, None, "sim:a"), ("sim:a", "a.ul")),
        (("sim:b", None, None, "sim:a"), ("sim:b", "sim:b")),
        (("a.ul", None, "sim:b", "sim:a"), ("sim:b", "a.ul")),
    ],
)
def test_bridges_take_the_url_before_the_spec_and_by_an_option(
    arguments: tuple[str | None, ...], found: tuple[str, str]
) -> None:
    assert url_and_spec(*arguments) == found


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (("a.ul", None, None), "nothing says where the gateway is"),
        (("sim:a", "a.ul", "sim:b"), "the gateway is sim:a and --link sim:b: one URL was expected"),
    ],
)
def test_bridges_refuse_arguments_with_no_url_or_two(arguments: tuple[str | None, ...], says: str) -> None:
    with pytest.raises(ArgumentError, match=says):
        url_and_spec(*arguments)


def test_signals_are_watched_by_name() -> None:
    lines = run("watch", "sim:scara", SCARA, "j1.spd_sp", "j3.spd_sp", "--count", "2").stdout.splitlines()
    assert lines[0] == "time\tlost\tj1.spd_sp\tj3.spd_sp"
    assert [line.split("\t")[2:] for line in lines[1:]] == [["74.9988", "125"]] * 2
    (line,) = run("watch", "sim:scara", SCARA, "j1.spd_sp", "--count", "1", "--json").stdout.splitlines()
    assert json.loads(line)["values"] == {"j1.spd_sp": pytest.approx(74.9988)}


def test_spec_of_another_gateway_is_refused_before_writes_unless_map_is_any(
    rover: str,
) -> None:
    fingerprint = compile_text(SPEC).interface().fingerprint
    features = int(GatewayInfo().features | Feature.FINGERPRINT)
    right, wrong = (f"sim:?features={features}&build_id={number}" for number in (fingerprint, 0xCAFE))
    assert run("set", right, rover, "left=1").returncode == 0
    for command in (["set", "left=1"], ["get"], ["watch", "left", "--count", "1"]):
        result = run(command[0], wrong, rover, *command[1:])
        assert (result.returncode, result.stdout) == (1, "")
        assert "the gateway was built for the map 0000CAFE" in result.stderr
        assert len(result.stderr.splitlines()) <= 2
    assert run("set", f"{wrong}&map=any", rover, "left=1").returncode == 0
    assert "map=some" in run("get", "sim:?map=some", rover).stderr


def test_differences_from_the_spec_of_the_board_are_one_sentence(rover: str, tmp_path: Path) -> None:
    other = tmp_path / "board.ul"
    other.write_text(SPEC.replace("SCALE=0.5", "SCALE=0.25").replace("  @ticks", "  @more = 0x20: READ();\n  @ticks"))
    url = f"sim:{other}"
    for command in (
        ["get", url, rover],
        ["set", url, rover, "left=1"],
        ["watch", url, rover, "left", "--count", "1"],
        ["record", url, rover, "--poll", "10", "--output", str(tmp_path / "run.mcap"), "--duration", "5"],
        ["live", url, rover, "--poll", "10", "--no-browser"],
        ["ros2", url, rover, "--poll", "10"],
        ["ros2", rover, "--link", url, "--poll", "10"],
    ):
        result = run(*command)
        assert (result.returncode, result.stdout) == (1, ""), command
        assert "left: SCALE is 0.5 in rover.ul and 0.25 on the board" in result.stderr
        assert "Traceback" not in result.stderr
    result = run("doctor", url, rover)
    assert result.returncode == 1
    assert "wrong spec: left: SCALE is 0.5 in rover.ul and 0.25 on the board" in result.stdout
    other.write_text(SPEC.replace("  @ticks", "  @more = 0x20: READ();\n  @ticks"))
    assert run("set", url, rover, "left=1").stdout == "left  1 m/s\n"
    assert "the gateway has all of rover alike" in run("doctor", url, rover).stdout


def test_signal_that_a_read_clears_is_read_only_if_it_is_named(tmp_path: Path) -> None:
    spec = tmp_path / "robot.ul"
    spec.write_text(TEXT)
    url = f"sim:{spec}"
    every = run("get", url, str(spec)).stdout
    assert "mode" in every
    assert "seen" not in every
    lines = run("get", url, str(spec), "mode", "seen", "hit").stdout.splitlines()
    assert lines == ["mode  0", "seen  0", "hit   false"]
    result = run("watch", url, str(spec), "seen", "--count", "1")
    assert (result.returncode, result.stderr.count("\n")) == (2, 1)
    assert "seen is cleared by each read" in result.stderr


def test_set_prints_the_written_values_also_of_pulses(tmp_path: Path) -> None:
    spec = tmp_path / "robot.ul"
    spec.write_text(TEXT)
    result = run("set", f"sim:{spec}", "alarm[0]=on", "shoot=true", "lost=3")
    assert (result.returncode, result.stdout.splitlines()) == (0, ["alarm[0]  true", "shoot     true", "lost      3"])


def test_the_command_line_is_a_module_too() -> None:
    command = [sys.executable, "-m", "unity_link", "--version"]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout.startswith("unity-link ")


# The shell


def completed(line: str, shell: str = "zsh", **environment: str) -> list[str]:
    """Return the completions that a shell offers for a line."""
    words = {"_TYPER_COMPLETE_ARGS": line}
    if shell == "bash":
        # Bash splits a line at each of its break characters, which become words.
        spaced = line.replace(":", " : ").replace("=", " = ").split(" ")
        parts = [part for part in spaced[:-1] if part] + spaced[-1:]
        words = {"COMP_WORDS": "\n".join(parts), "COMP_CWORD": str(len(parts) - 1)}
    result = run(_UNITY_LINK_COMPLETE=f"complete_{shell}", **words, **environment)
    assert result.returncode == 0
    if shell == "zsh":
        return [part.replace(r"\\:", ":") for part in result.stdout.split('"')[1::2]]
    return result.stdout.split()


def test_the_commands_and_signals_are_completed() -> None:
    assert completed("unity-link ge", "bash") == ["get", "generate"]
    assert completed(f"unity-link get sim:scara {SCARA} j1.s", "bash") == ["j1.spd", "j1.spd_sp"]
    assert completed(f"unity-link set sim:scara {SCARA} j1.pos", "bash") == ["j1.pos_sp="]
    assert completed("unity-link simulate w", "bash") == ["walker"]
    assert completed("unity-link simulate examples/ro", "bash") == ["examples/rover.ul"]
    assert "ulx3s" in completed("unity-link build x.ul --board u", "bash")
    assert completed("unity-link get sim:scara examples/sc", "bash") == ["examples/scara.ul"]


def test_urls_used_with_success_are_completed_without_tokens(tmp_path: Path) -> None:
    memory = {"UNITY_LINK_MEMORY": str(tmp_path / "state" / "urls")}
    assert run("read", "sim:walker", "0x10", **memory).returncode == 0
    assert run("read", "sim:?id_digits=2", "0x10", **memory).returncode == 0
    run("read", "tcp://127.0.0.1:1?token=secret", "0", **memory)
    assert run("info", "serial:/dev/nosuch", **memory).returncode == 1
    assert (tmp_path / "state" / "urls").read_text().splitlines() == ["sim:?id_digits=2", "sim:walker"]
    assert completed("unity-link info si", **memory)[:2] == ["sim:?id_digits=2", "sim:walker"]
    assert completed("unity-link info sim:w", "bash", **memory) == ["walker"]
    assert "//" in completed("unity-link info tcp:", "bash", **memory)


def test_a_memory_that_cannot_be_written_is_no_error(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("UNITY_LINK_MEMORY", str(tmp_path / "file" / "urls"))
    completion.note("sim:")
    completion.remember_used()
    assert completion.remembered() == []


def test_a_user_without_a_home_uses_the_command_line_all_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    for variable in ("UNITY_LINK_MEMORY", "XDG_STATE_HOME"):
        monkeypatch.delenv(variable, raising=False)
    # The system reports this error for a user that it does not know.
    monkeypatch.setattr(Path, "home", mock.Mock(side_effect=RuntimeError("Could not determine home directory.")))
    assert run("read", "sim:", "0").returncode == 0


def test_the_schemes_that_are_offered_are_known() -> None:
    for scheme in completion.SCHEMES:
        if scheme != "zenoh:":
            assert parse_url(f"{scheme}x").scheme == scheme.partition(":")[0]


LEASES = """
public rover() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE() @(0x100);
  arm: LEASE() @(0x200);
  @speed = 0x10: READWRITE(SAFE(0, drive));
}
"""


@pytest.fixture
def leased(tmp_path: Path) -> str:
    path = tmp_path / "rover.ul"
    path.write_text(LEASES)
    return str(path)


def test_stop_disarms_all_leases_of_a_spec_given_in_any_way(leased: str) -> None:
    both = (0, "drive: was not armed\narm: was not armed\n", "")
    assert run("stop", f"sim:{leased}", leased) == both
    assert run("stop", leased, f"sim:{leased}") == both
    assert run("stop", f"sim:{leased}") == both
    assert run("stop", "sim:?address_bits=12", UNITY_LINK_SPEC=leased) == both
    printed = json.loads(run("stop", f"sim:{leased}", "--json").stdout)
    assert printed["leases"] == {"drive": {"was_armed": False}, "arm": {"was_armed": False}}


def test_stop_disarms_the_leases_of_a_board_with_another_spec(leased: str, tmp_path: Path) -> None:
    board = tmp_path / "board.ul"
    board.write_text(LEASES.replace("0x10:", "0x11:").replace("arm: LEASE() @(0x200)", "arm: LEASE() @(0x300)"))
    result = run("stop", f"sim:{board}", leased)
    assert (result.returncode, result.stdout) == (0, "drive: was not armed\narm: was not armed\n")
    assert (
        "speed: address is 0x10 in rover.ul and 0x11 on the board: the leases are those of the board" in result.stderr
    )


def test_a_lease_that_cannot_be_disarmed_leaves_no_other_one_armed(leased: str) -> None:
    result = run("stop", f"sim:{leased}?fault=drive.disarm")
    assert (result.returncode, result.stdout) == (1, "arm: was not armed\n")
    assert result.stderr == "error: write of drive.disarm at 0x112: the bus refused the access\n"


def test_stop_of_an_absent_gateway_fails_with_an_error(leased: str, tmp_path: Path) -> None:
    result = run("stop", f"unix:{tmp_path / 'nowhere'}", leased)
    assert (result.returncode, result.stdout) == (1, "")
    assert result.stderr.startswith("error: ")
    assert "Traceback" not in result.stderr


def test_a_set_that_is_refused_for_want_of_a_lease_names_arm(leased: str) -> None:
    result = run("set", f"sim:{leased}", "speed=1")
    assert (result.returncode, result.stdout) == (1, "")
    assert result.stderr.endswith("drive is not armed: nobody has armed it since the reset; --arm SECONDS arms it\n")


@pytest.mark.parametrize("seconds", ["0", "-1", "nan", "inf", "1e10", "soon"])
def test_a_time_that_no_lease_can_be_armed_for_is_refused(seconds: str, leased: str) -> None:
    result = run("set", f"sim:{leased}", "speed=1", "--arm", seconds)
    words = f"error: --arm is '{seconds}': a number of seconds from 0.001 to 1e+09 was expected\n"
    assert (result.returncode, result.stdout, result.stderr.partition("Try")[0]) == (2, "", words)


def test_arm_is_refused_for_signals_that_no_lease_guards(rover: str) -> None:
    result = run("set", "sim:", rover, "left=1", "lamp=on", "--arm", "1")
    words = "error: --arm arms the lease of a signal, and no lease guards left, lamp\n"
    assert (result.returncode, result.stdout, result.stderr) == (2, "", words)

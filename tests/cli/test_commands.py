"""Commands as a shell runs them: their output, their messages about wrong use, and their exit codes."""

from __future__ import annotations

import errno
import json
import os
import re
import signal
import socket
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
import typer

from unity_link import cli
from unity_link.protocol.wire.configuration import PROTOCOL_VERSION

if TYPE_CHECKING:
    from collections.abc import Iterator

PROGRAM = str(Path(sys.executable).parent / "unity-link")
RTL = pytest.param("rtl", marks=pytest.mark.rtl)
on_model_and_gateware = pytest.mark.parametrize("kind", ["sim", RTL])


def run(*arguments: str, stdin: str = "") -> subprocess.CompletedProcess[str]:
    result = subprocess.run(
        [PROGRAM, *arguments], input=stdin, capture_output=True, text=True, timeout=600, check=False
    )
    assert "Traceback" not in result.stderr
    return result


@contextmanager
def served(*arguments: str) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """Run `unity-link simulate`; yield the process, and the line that it prints when it is ready."""
    with subprocess.Popen([PROGRAM, "simulate", *arguments], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            yield process, process.stdout.readline().strip()
        finally:
            process.terminate()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (["frob"], 2, "No such command 'frob'"),
        (["read", "sim:"], 2, "Missing argument"),
        (["read", "sim:", "abc"], 2, "not a whole number"),
        (["read", "sim:", "300"], 2, "address 0x12c is not from 0 to 0xff"),
        (["read", "sim:", "0", "0"], 2, "at least 1 is needed"),
        (["read", "sim:delta", "0"], 2, "no robot 'delta'"),
        (["read", "nosuch:x", "1"], 2, "it should begin with one of serial:"),
        (["write", "sim:", "0x10", "0x1FFFFFFFF"], 2, "does not fit in a word of 32 bits"),
        (["read", "rtl:delta", "0"], 2, "no robot 'delta'"),
        (["read", "rtl:?data_bits=16", "0"], 2, "no gateware was compiled with data_bits=16: there are data_bits=8"),
        (["simulate", "--pty", "--udp", "0"], 2, "one of --pty, --tcp"),
        (["simulate", "--rtl", "--pty", "--set", "groups=7"], 2, "no gateware was compiled with groups=7"),
        (["simulate", "--tcp", "99999"], 2, "65535"),
        (["read", "serial:/dev/nosuch", "1"], 1, "there is no port /dev/nosuch"),
        (["info", "tcp://127.0.0.1:1"], 1, "is it listening?"),
        (["info", "unix:/nosuch"], 1, "is it served?"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_wrong_use_and_failure_end_in_one_sentence_and_their_code(arguments: list[str], code: int, words: str) -> None:
    result = run(*arguments)
    assert (result.returncode, result.stdout) == (code, "")
    assert words in " ".join(result.stderr.split())


def test_a_port_that_is_taken_is_named() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        result = run("simulate", "--tcp", str(taken.getsockname()[1]))
    assert result.returncode == 1
    assert "in use" in result.stderr


@pytest.mark.slow
@pytest.mark.parametrize("medium", ["--pty", "--tcp", "--unix", "--udp"])
@on_model_and_gateware
def test_a_served_gateway_answers_other_programs(kind: str, medium: str, tmp_path: Path) -> None:
    argument = {"--pty": [], "--tcp": ["0"], "--unix": [str(tmp_path / "socket")], "--udp": ["0"]}[medium]
    with served(medium, *argument, *(["--rtl"] if kind == "rtl" else [])) as (_, url):
        assert run("write", url, "0x10", "-1").returncode == 0
        result = run("read", url, "0x10", "2", "--json")
        assert result.returncode == 0
        assert "4294967295" in result.stdout


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@on_model_and_gateware
def test_a_signal_ends_a_served_gateway_at_once(kind: str, number: signal.Signals, tmp_path: Path) -> None:
    path = tmp_path / "socket"
    with served("--unix", str(path), *(["--rtl"] if kind == "rtl" else [])) as (process, url):
        assert url == f"unix:{path}"
        process.send_signal(number)
        assert process.wait() == 128 + number
    assert not path.exists()


@on_model_and_gateware
def test_output_for_programs_is_json(kind: str) -> None:
    url = f"{kind}:"
    info = json.loads(run("info", url, "--json").stdout)
    assert (info["data_bits"], info["protocol_version"]) == (32, PROTOCOL_VERSION)
    samples = [json.loads(line) for line in run("watch", url, "0x10", "--count", "3", "--json").stdout.splitlines()]
    assert [sample["values"] for sample in samples] == [{"0x10": 0}] * 3


def test_info_reports_if_the_build_id_is_a_fingerprint_of_the_map() -> None:
    assert re.search("^map +0x0000CAFE$", run("info", "sim:?features=0x17F&build_id=0xCAFE").stdout, re.MULTILINE)
    assert re.search("^build +0x0000CAFE$", run("info", "sim:?build_id=0xCAFE").stdout, re.MULTILINE)


def test_info_has_the_rate_that_a_chip_runs_at() -> None:
    speed = run("info", "ftdi://virtual?mode=uart&baud=7000000").stdout
    assert re.search(r"^speed +the chip runs at 6,857,143 baud, not at 7,000,000 \(-2\.04%\)$", speed, re.MULTILINE)
    assert json.loads(run("info", "ftdi://virtual?mode=uart", "--json").stdout)["baud"] == 115_246


@on_model_and_gateware
def test_frames_are_typed_by_hand_and_answers_explained(kind: str) -> None:
    result = run("terminal", f"{kind}:", stdin="W0A0000002A\nR0A\nRZZ\n")
    assert "0x0000002A (42)" in result.stdout


COMMANDS_THAT_PRINT = pytest.mark.parametrize(
    "command",
    ["unity-link demo --duration 1", "unity-link watch sim: 0x10 --duration 1", "echo R0A | unity-link terminal sim:"],
    ids=["demo", "watch", "terminal"],
)


def in_shell(line: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PATH": os.pathsep.join([str(Path(PROGRAM).parent), os.environ["PATH"]])}
    return subprocess.run(["sh", "-c", line], capture_output=True, text=True, timeout=600, env=environment, check=False)


@COMMANDS_THAT_PRINT
def test_output_that_cannot_be_written_ends_a_command_in_one_sentence(command: str) -> None:
    result = in_shell(f"{command} >/dev/full")
    assert result.returncode == 1
    assert result.stderr.splitlines()[-1] == "error: standard output cannot be written: No space left on device"
    assert "Traceback" not in result.stderr


@COMMANDS_THAT_PRINT
def test_a_reader_of_the_output_may_go_before_its_end(command: str) -> None:
    result = in_shell(f"({command}) | head -n 1")
    assert len(result.stdout.splitlines()) == 1
    assert "error" not in result.stderr
    assert "Traceback" not in result.stderr


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (OSError(errno.EMFILE, "Too many open files"), "error: Too many open files"),
        (PermissionError(errno.EACCES, "Permission denied", "/some/file"), "error: /some/file: Permission denied"),
    ],
)
def test_error_of_the_system_is_reported_as_such(
    error: OSError, words: str, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    program = typer.Typer()

    @program.command()
    def refuse() -> None:
        raise error

    monkeypatch.setattr(sys, "argv", ["unity-link"])
    with pytest.raises(SystemExit) as ended:
        cli.main(program)
    assert ended.value.code == 1
    print("stdout is still there", flush=True)  # noqa: T201
    told = capfd.readouterr()
    assert told.err.splitlines() == [words]
    assert told.out == "stdout is still there\n"


def test_a_command_without_stdout_does_its_work() -> None:
    result = in_shell("unity-link watch sim: 0x10 --count 3 >&-")
    assert result.returncode == 0
    assert result.stderr.startswith("3 samples in ")


@pytest.mark.parametrize(
    ("command", "code", "lines"), [("watch sim: 0x10 --count 3", 0, 4), ("read sim: none", 2, 0)], ids=["note", "error"]
)
def test_command_works_although_stderr_is_full(command: str, code: int, lines: int) -> None:
    result = in_shell(f"unity-link {command} 2>/dev/full")
    assert (result.returncode, len(result.stdout.splitlines())) == (code, lines)


def test_watch_counts_only_the_samples_that_it_has_written() -> None:
    fast = "sim:?base_frequency_millihertz=50000000"
    result = run("watch", fast, "0x10", "--rate", "50000", "--count", "3")
    assert len(result.stdout.splitlines()) == 1 + 3
    assert result.stderr.startswith("3 samples in ")


def test_colours_that_are_forced_on_a_pipe_make_no_picture_of_its_lines() -> None:
    assert in_shell("FORCE_COLOR=1 unity-link watch sim: 0x10 --count 1").stdout.startswith("time\tlost\t0x10\n")


def test_characters_that_the_output_cannot_hold_are_written_in_another_way() -> None:
    result = in_shell("PYTHONIOENCODING=ascii unity-link demo --duration 1")
    assert result.returncode == 0
    assert r"\xb5s" in result.stdout


ODD_NAME = os.fsdecode(b"a\xf6")


def in_odd_place(command: str, place: Path) -> subprocess.CompletedProcess[str]:
    environment = f"export UNITY_LINK_MEMORY={place}/memory; cd {place}; name=$(printf 'a\\366'); spec=$name.ul"
    return in_shell(f"{environment}; unity-link {command}")


@pytest.fixture(scope="module")
def odd_place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with a spec and a recording whose names are not UTF-8."""
    place = tmp_path_factory.mktemp("odd")
    (place / f"{ODD_NAME}.ul").write_text("public odd() { @a = 0: READWRITE(POLL(50)); }")
    in_odd_place("record sim: $spec --output $name.mcap --duration 1", place)
    return place


@pytest.mark.slow
@pytest.mark.parametrize(
    "command",
    [
        "show $spec --json",
        "get sim:$spec",
        "generate python $spec --output .",
        "info sim:?snoop=$name",
        "record sim: $spec --output $name.mcap --overwrite --duration 1 --json",
        "export $name.mcap --csv --json",
        "export $name.mcap --parquet",
    ],
)
def test_file_with_a_name_that_is_not_utf_8_works_like_any_other(command: str, odd_place: Path) -> None:
    result = in_odd_place(command, odd_place)
    assert result.returncode == 0, result.stderr
    if "--json" in command:
        json.loads(result.stdout)


@pytest.mark.rtl
def test_missing_compiler_is_reported_with_the_package_to_install(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("CXX", raising=False)
    for arguments in (["read", "rtl:", "0"], ["simulate", "--rtl", "--pty"]):
        result = run(*arguments)
        assert (result.returncode, result.stdout) == (1, "")
        assert result.stderr.strip().endswith("no C++ compiler is there: apt install g++")
        assert len(result.stderr.splitlines()) == 1


@pytest.mark.slow
def test_the_demo_without_a_terminal_ends_by_itself_with_its_summary() -> None:
    result = run("demo")
    assert result.returncode == 0
    assert "\x1b" not in result.stdout
    assert "0 lost" in result.stdout
    assert "round trip" in result.stdout


@pytest.mark.parametrize("options", [[], ["--plain"]], ids=["checked", "plain"])
def test_zeros_may_be_left_out_of_a_word_that_is_typed(options: list[str]) -> None:
    command = [sys.executable, "-m", "unity_link", "terminal", "sim:", *options]
    typed = "W0A2B\nR0A\nWS0B3\nR0B\nW0A0000002C\nR0A\n"

    result = subprocess.run(command, input=typed, capture_output=True, text=True, timeout=60, check=True)

    read = [line.split()[0] for line in result.stdout.splitlines() if line.startswith("R")]
    assert read == ["R0A0000002B", "R0B00000003", "R0A0000002C"]
    assert "error" not in result.stdout

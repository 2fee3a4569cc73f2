"""The help of commands, and their messages for wrong values."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from unity_link.cli.families import PANELS

PROGRAM = str(Path(sys.executable).parent / "unity-link")


def run(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=120, check=False)


def test_help_has_each_command_once_in_the_panel_of_its_group() -> None:
    result = run("--help")
    assert result.returncode == 0
    panels = re.findall(r"╭─ ([^─]*) ─[^╮]*╮\n(.*?)╰", result.stdout, re.DOTALL)
    shown = {title: re.findall(r"^│ ([a-z]\w*) ", body, re.MULTILINE) for title, body in panels}
    assert {title: names for title, names in shown.items() if title != "Options"} == {
        title: list(commands) for title, commands in PANELS.items()
    }


@pytest.mark.parametrize(("command", "extra"), [("ros2", "ros2"), ("zenoh", "zenoh")])
def test_help_names_the_extra_to_install(command: str, extra: str) -> None:
    result = run(command, "--help")
    assert result.returncode == 0
    assert f'"unity-link[{extra}]"' in result.stdout


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["serve", "sim:", "--tcp", "99999"], "error: --tcp is '99999': a whole number from 0 to 65535 was expected"),
        (["live", "sim:", "--watch", "0", "--poll", "often"], "error: --poll is 'often': a number of Hz was expected"),
        (
            ["record", "sim:", "x.ul", "-o", "x", "--duration", "-1"],
            "error: --duration is '-1': a number of seconds from 0 to 1e+09 was expected",
        ),
        (
            ["generate", "ros3", "x.ul"],
            "docs, matlab, python, ros1, ros2, verilog, vhdl was expected; did you mean 'ros2' or 'ros1'?",
        ),
        (["read", "sim:", "-1"], "-1 is no option: to give a negative number, write -- before it"),
        (
            ["live", "sim:", "--watch", "abc"],
            "'abc' is not a whole number like 10, 0x0A or 0b1010; did you mean 0xabc?",
        ),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_a_value_that_does_not_fit_is_named(arguments: list[str], words: str) -> None:
    result = run(*arguments)
    assert result.returncode == 2
    assert result.stderr.splitlines()[0].endswith(words)

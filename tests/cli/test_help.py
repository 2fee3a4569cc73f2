"""What commands say of themselves, and of values that do not fit."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = str(Path(sys.executable).parent / "unity-link")


def run(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=120, check=False)


@pytest.mark.parametrize(("command", "extra"), [("ros2", "ros2"), ("zenoh", "zenoh")])
def test_help_names_the_extra_to_install(command: str, extra: str) -> None:
    result = run(command, "--help")
    assert result.returncode == 0
    assert f'"unity-link[{extra}]"' in result.stdout


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["serve", "sim:", "--tcp", "99999"], "'--tcp': Input should be less than or equal to 65535, not 99999"),
        (["live", "sim:", "--watch", "0", "--poll", "often"], "to parse string as a number, not often"),
        (["record", "sim:", "x.ul", "-o", "x", "--duration", "-1"], "greater than or equal to 0, not -1"),
        (
            ["generate", "ros3", "x.ul"],
            "'ros3' is not one of 'c', 'cpp', 'docs', 'matlab', 'python', 'ros1', 'ros2', 'verilog', 'vhdl'.",
        ),
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

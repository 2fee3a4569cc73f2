"""The gateware's tools print their purpose, and refuse unknown arguments before they do any work."""

from __future__ import annotations

import subprocess
import sys

import pytest

from unity_link.gateware.cache import GATEWARE

TOOLS = sorted(
    path.stem for path in (GATEWARE / "tools").glob("*.py") if 'if __name__ == "__main__"' in path.read_text()
)


@pytest.mark.slow
@pytest.mark.parametrize("tool", TOOLS)
def test_a_tool_shows_its_usage_and_refuses_an_unknown_option(tool: str) -> None:
    for option, status in (("--help", 0), ("--no-such-option", 2)):
        command = [sys.executable, "-m", f"gateware.tools.{tool}", option]
        done = subprocess.run(command, cwd=GATEWARE.parent, capture_output=True, text=True, check=False, timeout=60)
        assert (done.returncode, done.stdout.startswith("usage: ")) == (status, status == 0)
        assert "Traceback" not in done.stderr


def test_missing_file_is_reported_in_one_sentence() -> None:
    command = [sys.executable, "-m", "gateware.tools.subset", "no_such_file.vhd"]
    done = subprocess.run(command, cwd=GATEWARE.parent, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 1
    assert done.stderr.startswith("no_such_file.vhd cannot be read: ")
    assert "Traceback" not in done.stderr

"""Runs the tools of YoWASP (Yosys, nextpnr, SymbiYosys as WebAssembly), which are Python packages.

A warning is an error, unless the caller expects it.
"""

from __future__ import annotations

import contextlib
import re
import shutil
import subprocess
import sysconfig
import time
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING

from unity_link.gateware import external
from unity_link.gateware.cache import ToolMissingError
from unity_link.gateware.convert import ConversionError

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import TextIO

# A row of a progress table of nextpnr's routers. router1 prints one after each 1,000 attempts, with the number of
# connections left to route; router2 prints one after each iteration, with the number of overused wires.
_ROW = re.compile(r"Info:\s+(?:\d+ \|[^|]*\|[^|]*\|\s*(\d+)\||iter=\d+ .*\boverused=(\d+) )")
_ROWS = {1: 50, 2: 1000}
"""Number of rows without progress after which a router is stopped, by router."""
_REMARK = re.compile(r"^Info:|[Ww]arning:")
_SILENT_S = 3600.0
_LOOK_S = 0.2


class RefusedError(ConversionError):
    """A tool refused its input; `output` is all that it printed."""

    def __init__(self, sentence: str, output: str) -> None:
        super().__init__(sentence)
        self.output = output


class EndlessError(ConversionError):
    """A tool did not finish, and was stopped."""


def script(tool: str) -> str:
    """Return the path of one of YoWASP's tools: in the folder of this Python's scripts, or on PATH.

    Raises:
        ToolMissingError: if it is not installed.
    """
    beside = Path(sysconfig.get_path("scripts"), tool)
    command = str(beside) if beside.exists() else shutil.which(tool)
    if command is None:
        raise ToolMissingError(f'{tool} is needed and not there: pip install "unity-link[build]", or make venv')
    return command


def version(tool: str) -> str:
    """Return the version of a tool's package; names of cached files depend on it."""
    return metadata.version(tool)


def run(work: Path, tool: str, *arguments: str, explained: str = "(?!)") -> str:
    """Run one of the tools, and return its standard output.

    Args:
        work: working directory; the tools of YoWASP can access no other folder.
        tool: name of the command.
        arguments: arguments of the command.
        explained: regular expression for the expected warnings.

    Raises:
        RefusedError: if the tool fails.
        ConversionError: if the tool prints an unexpected warning.
        ToolMissingError: if the tool is not installed.
    """
    done = external.run([script(tool), *arguments], work, cwd=work)
    _judge(tool, done.returncode, (done.stdout + done.stderr).splitlines(), explained)
    return done.stdout


def place(work: Path, tool: str, *arguments: str, explained: str = "(?!)") -> None:
    """Run nextpnr as `run` does, but stop it if its router does not finish.

    With some seeds the router rips up and reroutes the same connections for ever. It is stopped after 50 rows of
    router1, or 1,000 of router2, without progress. This limit does not depend on the speed of the machine. nextpnr is
    also stopped if it prints nothing for an hour.

    Raises:
        EndlessError: if nextpnr was stopped.
        RefusedError: if nextpnr fails.
        ConversionError: if nextpnr prints an unexpected warning.
        ToolMissingError: if nextpnr is not installed.
    """
    path = work / "printed"
    with (
        path.open("w") as out,
        path.open(errors="replace") as printed,
        external.running([script(tool), *arguments], work, cwd=work, stdout=out, stderr=subprocess.STDOUT) as process,
    ):
        _watch(tool, process, printed)
    lines = path.read_text(errors="replace").splitlines()
    _judge(tool, process.returncode, lines, explained)


def _watch(tool: str, process: subprocess.Popen[bytes], printed: TextIO) -> None:
    """Wait until nextpnr ends.

    Raises:
        EndlessError: if its router makes no progress, or if it prints nothing for an hour.
    """
    least, rows, rest = dict.fromkeys(_ROWS, float("inf")), dict.fromkeys(_ROWS, 0), ""
    heard = time.monotonic()
    while process.poll() is None:
        *lines, rest = (rest + printed.read()).split("\n")
        for row in filter(None, map(_ROW.match, lines)):
            router = row.lastindex or 1
            left = int(row[router])
            rows[router] = 0 if left < least[router] else rows[router] + 1
            least[router] = min(least[router], left)
            if rows[router] == _ROWS[router]:
                raise EndlessError(f"{tool} was stopped: its router makes no progress, with {left} wires left")
        if lines:
            heard = time.monotonic()
        elif time.monotonic() - heard > _SILENT_S:
            raise EndlessError(f"{tool} was stopped: it has printed nothing for {_SILENT_S:g} s")
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(_LOOK_S)


def _judge(tool: str, status: int, lines: Sequence[str], explained: str) -> None:
    """Check the exit status and the warnings of a tool.

    Raises:
        RefusedError: if the tool failed; the message has its first error, or its last line other than information and
            warnings.
        ConversionError: if the tool printed an unexpected warning.
    """
    if status:
        errors = [line for line in lines if "ERROR" in line]
        last = [line for line in lines if line.strip() and not _REMARK.search(line)][-1:]
        raise RefusedError(f"{tool}: {(errors or last or ['no reason given'])[0]}", "\n".join(lines))
    faults = [line for line in lines if re.search(r"[Ww]arning:", line) and not re.search(explained, line)]
    if faults:
        raise ConversionError(f"{tool} warns: {faults[0]}")

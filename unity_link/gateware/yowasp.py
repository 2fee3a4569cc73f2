"""The commands of YoWASP (Yosys, nextpnr, SymbiYosys as WebAssembly): Python packages, so the same on each machine.

A warning is an error, unless its caller explains it.
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

# A row of a router of nextpnr: router1 has one for 1,000 attempts, with the connections that remain; router2 one for
# each turn, with the wires that have too many.
_ROW = re.compile(r"Info:\s+(?:\d+ \|[^|]*\|[^|]*\|\s*(\d+)\||iter=\d+ .*\boverused=(\d+) )")
_ROWS = {1: 50, 2: 1000}
"""Rows without a lower number after which a router does not end any more, by router."""
_REMARK = re.compile(r"^Info:|[Ww]arning:")
_SILENT_S = 3600.0
_LOOK_S = 0.2


class RefusedError(ConversionError):
    """A tool refused what it was given; `output` is all that it printed."""

    def __init__(self, sentence: str, output: str) -> None:
        super().__init__(sentence)
        self.output = output


class EndlessError(ConversionError):
    """A tool came to no end, and was stopped."""


def script(tool: str) -> str:
    """Return the command of one of YoWASP's tools, beside this Python or on the path.

    Raises:
        ToolMissingError: if it is not installed.
    """
    beside = Path(sysconfig.get_path("scripts"), tool)
    command = str(beside) if beside.exists() else shutil.which(tool)
    if command is None:
        raise ToolMissingError(f'{tool} is needed and not there: pip install "unity-link[build]", or make venv')
    return command


def version(tool: str) -> str:
    """Return the version of a tool's package, which is part of the name of what it made."""
    return metadata.version(tool)


def run(work: Path, tool: str, *arguments: str, explained: str = "(?!)") -> str:
    """Run one of the tools in the folder that it may see; returns what it printed.

    Args:
        work: the folder. YoWASP sees this one and no other.
        tool: name of the command.
        arguments: of the command.
        explained: pattern of the warnings that are expected.

    Raises:
        RefusedError: if it fails.
        ConversionError: if it warns of something that is not explained.
        ToolMissingError: if it is not installed.
    """
    done = external.run([script(tool), *arguments], work, cwd=work)
    _judge(tool, done.returncode, (done.stdout + done.stderr).splitlines(), explained)
    return done.stdout


def place(work: Path, tool: str, *arguments: str, explained: str = "(?!)") -> None:
    """Run nextpnr as `run` does, but stop it where its router does not come to an end.

    With some seeds it rips up the same connections for ever. It is stopped when 50 rows of the table of router1, or
    1,000 of router2, have no fewer left than one before, which is the same on each machine; or when it prints nothing
    for an hour.

    Raises:
        EndlessError: if it was stopped.
        RefusedError: if it fails.
        ConversionError: if it warns of something that is not explained.
        ToolMissingError: if it is not installed.
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
        EndlessError: if its router does not come to an end, or it is silent.
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
                raise EndlessError(f"{tool} was stopped: its router comes to no end, with {left} wires left")
        if lines:
            heard = time.monotonic()
        elif time.monotonic() - heard > _SILENT_S:
            raise EndlessError(f"{tool} was stopped: it has said nothing for {_SILENT_S:g} s")
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(_LOOK_S)


def _judge(tool: str, status: int, lines: Sequence[str], explained: str) -> None:
    """Look whether a tool has done what it should.

    Raises:
        RefusedError: if it has failed; the sentence has its first error, or its last line that is no remark.
        ConversionError: if it warns of something that is not explained.
    """
    if status:
        errors = [line for line in lines if "ERROR" in line]
        last = [line for line in lines if line.strip() and not _REMARK.search(line)][-1:]
        raise RefusedError(f"{tool}: {(errors or last or ['no reason given'])[0]}", "\n".join(lines))
    faults = [line for line in lines if re.search(r"[Ww]arning:", line) and not re.search(explained, line)]
    if faults:
        raise ConversionError(f"{tool} warns: {faults[0]}")

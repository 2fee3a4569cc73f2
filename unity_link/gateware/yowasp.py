"""The commands of YoWASP (Yosys, nextpnr, SymbiYosys as WebAssembly): Python packages, so the same on each machine.

A warning is an error, unless its caller explains it.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sysconfig
from importlib import metadata
from pathlib import Path

from unity_link.gateware.cache import ToolMissingError
from unity_link.gateware.convert import ConversionError


class RefusedError(ConversionError):
    """A tool refused what it was given; `output` is all that it printed."""

    def __init__(self, sentence: str, output: str) -> None:
        super().__init__(sentence)
        self.output = output


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
    done = subprocess.run([script(tool), *arguments], cwd=work, check=False, capture_output=True, text=True)
    lines = (done.stdout + done.stderr).splitlines()
    faults = [line for line in lines if "ERROR" in line]
    if done.returncode:
        last_words = done.stderr.strip().splitlines()[-1:] or ["no reason given"]
        raise RefusedError(f"{tool}: {(faults or last_words)[0]}", "\n".join(lines))
    faults = [line for line in lines if re.search(r"[Ww]arning:", line) and not re.search(explained, line)]
    if faults:
        raise ConversionError(f"{tool} warns: {faults[0]}")
    return done.stdout

"""The commands of YoWASP (Yosys, nextpnr, SymbiYosys as WebAssembly): Python packages, so the same on each machine."""

from __future__ import annotations

import shutil
import sysconfig
from pathlib import Path

from gateware.tools.ghdl import ToolMissingError


def script(tool: str) -> str:
    """Return the command of one of YoWASP's tools, beside this Python or on the path.

    Raises:
        ToolMissingError: if it is not installed.
    """
    beside = Path(sysconfig.get_path("scripts"), tool)
    command = str(beside) if beside.exists() else shutil.which(tool)
    if command is None:
        raise ToolMissingError(f"{tool} is needed and not there: make venv, or pip install {tool}")
    return command

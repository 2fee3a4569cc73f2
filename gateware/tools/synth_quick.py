"""Synthesis of each top and each board without placement, short enough for a CI: `make synth-quick`.

GHDL converts each design; Yosys checks it and maps it to the cells of its FPGA. Placement, and the larger sizes of
cores, are left to `make synth` and `make campaign`. A top is not mapped again if `gateware/placed.json` has figures of
the same Verilog and the same tools.

    python -m gateware.tools.synth_quick          all designs
    python -m gateware.tools.synth_quick ulx3s    only designs whose names contain "ulx3s"
"""

from __future__ import annotations

import os
import sys
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING

from gateware.tools import parser_of
from gateware.tools.synth import CONFIGURATIONS, Configuration, map_only, rows, tools_of, unchanged
from unity_link.boards.build import design_of, synthesise, top_text
from unity_link.boards.families import FAMILIES
from unity_link.boards.loading import board_names, load_board
from unity_link.boards.pins import generated_ports
from unity_link.errors import UnityLinkError
from unity_link.gateware.external import temporary_folder
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.boards.board import Board

# A register of each kind.
_SPEC = """
public lamp() {
  @on = 0[7:0]: unsigned READWRITE();
  @current = 1: signed 16 READ(PUBLISH(1, 100));
  @energy = 2: unsigned 64 READ();
}
"""


def designs() -> dict[str, Callable[[], None]]:
    """Return a function for each design, by its name, that synthesises it and raises if a tool rejects it.

    Boards that differ only in the placement of a design share a function.
    """
    alike: dict[tuple[str, str, int, int | None], dict[str, Board]] = {}
    for name in board_names():
        _, board = load_board(name)
        if board.family in FAMILIES:
            passes = FAMILIES[board.family].synthesis(board)
            alike.setdefault((top_text("", board, generated_ports(board)), passes, board.core_hz, board.baud), {})[
                name
            ] = board
    boards = {", ".join(names): _board(*next(iter(names.items()))) for names in alike.values()}
    tops: dict[str, Callable[[], None]] = {}
    smallest: set[str] = set()
    for name, configuration in CONFIGURATIONS.items():
        kind = name.rpartition("_")[0] if configuration.is_core else name
        if kind not in smallest:
            tops[name] = _top(name, configuration)
        smallest.add(kind)
    return tops | boards


def _top(name: str, configuration: Configuration) -> Callable[[], None]:
    device = configuration.devices[0]

    def attempt() -> None:
        row = rows().get((name, device))
        if row is None or not unchanged(row.origin, name, tools_of(name, device)):
            map_only(configuration)

    return attempt


def _board(name: str, board: Board) -> Callable[[], None]:
    def attempt() -> None:
        spec = compile_text(_SPEC)
        with temporary_folder() as work:
            synthesise(design_of(spec, spec.interface(), name, board, work), board, work)

    return attempt


def faults(tried: dict[str, Callable[[], None]]) -> dict[str, str]:
    """Synthesise designs, one on each processor, and return the faults of those that fail, by name."""

    def fault(name: str) -> str:
        try:
            tried[name]()
        except UnityLinkError as error:
            return str(error)
        sys.stdout.write(f"{name}\n")
        sys.stdout.flush()
        return ""

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        found = dict(zip(tried, pool.map(fault, tried), strict=True))
    return {name: text for name, text in found.items() if text}


def main() -> int:
    """Synthesise the chosen designs, and return the exit status."""
    parser = parser_of(__doc__)
    parser.add_argument("wanted", nargs="?", default="", help="part of the names of the designs")
    wanted = parser.parse_args().wanted
    chosen = {name: attempt for name, attempt in designs().items() if wanted in name}
    if not chosen:
        sys.stderr.write(f"no top and no board has {wanted!r} in its name; there are {', '.join(designs())}\n")
        return 2
    found = faults(chosen)
    for name, text in found.items():
        sys.stderr.write(f"{name}: {text}\n")
    return int(bool(found))


if __name__ == "__main__":
    sys.exit(main())

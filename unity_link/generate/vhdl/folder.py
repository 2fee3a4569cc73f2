"""The generated VHDL with the gateware: a folder that tools can use directly, with a script for each tool."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.gateware import LICENCE
from unity_link.gateware.cache import board_sources
from unity_link.gateware.sources import gateware_files
from unity_link.gateware.vendors import TOOLS, add_vhdl
from unity_link.generate import GeneratedFile

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from pathlib import Path

GATEWARE_FOLDER = "gateware"
CORES_FOLDER = "cores"


def read_vhdl(path: Path) -> str:
    """Return the text of a VHDL file, in UTF-8 or otherwise in Latin-1, which the VHDL standard specifies.

    Raises:
        ArgumentError: if it cannot be read.
    """
    try:
        data = path.read_bytes()
    except OSError as error:
        raise ArgumentError(f"{path} cannot be read: {error.strerror or error}") from None
    try:
        return data.decode()
    except UnicodeDecodeError:
        return data.decode("latin-1")


def design_files(generated: Iterable[GeneratedFile], own: Iterable[str] = ()) -> list[str]:
    """Return the VHDL files of a design besides the gateware in compile order, without the bench.

    Args:
        generated: files that were generated from a spec.
        own: names of the files of the spec's own cores, which the generated gateway uses.
    """
    boards = [f"{GATEWARE_FOLDER}/boards/{source.name}" for source in board_sources()]
    return [*boards, *own, *(file.name for file in generated if not file.name.endswith("_bench.vhd"))]


def with_gateware(generated: list[GeneratedFile], cores: Iterable[Path] = ()) -> Iterator[GeneratedFile]:
    """Yield the files of the target `vhdl`, the gateware in a folder beside them, and a script for each tool.

    Args:
        generated: files that were generated from a spec.
        cores: VHDL files of the spec's own cores, which are copied.

    Raises:
        ArgumentError: if a file of a core cannot be read.
    """
    yield from generated
    own = {f"{CORES_FOLDER}/{path.parent.name}/{path.name}": path for path in cores}
    for name, path in own.items():
        yield GeneratedFile(name, read_vhdl(path))
    for name, text in gateware_files().items():
        yield GeneratedFile(f"{GATEWARE_FOLDER}/{name}", text)
    for tool in TOOLS:
        lines = (
            f"# {LICENCE}",
            f"# The gateware and this design: source {tool}.tcl in an open project. Choose the top by yourself.",
            "set here [file dirname [file normalize [info script]]]",
            f"source [file join $here {GATEWARE_FOLDER} import {tool}.tcl]",
            *(add_vhdl(tool, f"[file join $here {file}]") for file in design_files(generated, own)),
        )
        yield GeneratedFile(f"{tool}.tcl", "".join(f"{line}\n" for line in lines))

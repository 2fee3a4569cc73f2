"""The gateware's files as users take them: in a folder of their own, and in compile order."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.gateware.cache import GATEWARE, board_sources, pads_of, vhdl_sources

if TYPE_CHECKING:
    from collections.abc import Iterator

_TAKEN = ("rtl/**/*.vhd", "pads/**/*.vhd", "constraints/**/*", "import/*", "unity_link.f", "unity_link.core")
_LICENCES = (GATEWARE / "LICENSE", GATEWARE.parent / "LICENSE")
"""Paths of the licence, in an installed package and in the project."""


def gateware_files() -> dict[str, str]:
    """Return the text of each file that a design with the gateware needs, by its path below its folder.

    Raises:
        ToolMissingError: where an installation has none.
    """
    vhdl_sources()
    found = [path for pattern in _TAKEN for path in sorted(GATEWARE.glob(pattern)) if path.is_file()]
    texts = {path.relative_to(GATEWARE).as_posix(): path.read_text() for path in (*found, *board_sources())}
    licence = next(path for path in _LICENCES if path.is_file())
    return texts | {"LICENSE": licence.read_text()}


def in_compile_order(pads: str | None = None) -> Iterator[str]:
    """Return the paths of the sources below the gateware's folder, each behind those that it needs.

    Args:
        pads: the vendor whose registers the FT245 has at its pins, a folder of `gateware/pads`; None: portable ones.
    """
    theirs = pads_of(pads)
    for line in (GATEWARE / "unity_link.f").read_text().splitlines():
        if not line.startswith("#"):
            name = Path(line).name
            yield theirs[name].relative_to(GATEWARE).as_posix() if name in theirs else line


def copy_gateware(folder: Path) -> Path:
    """Copy the gateware into a folder that is not there yet, whole or not at all; return the folder.

    Raises:
        ArgumentError: where the folder is there, or cannot be written.
    """
    files = gateware_files()
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise ArgumentError(f"{folder} is there already: a folder that is not, or is empty, was expected")
    partial = folder.parent / f".{folder.name}.{os.getpid()}"
    try:
        for name, text in files.items():
            path = partial / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        partial.replace(folder)
    except OSError as error:
        raise ArgumentError(f"{folder} cannot be written: {error.strerror or error}") from None
    finally:
        shutil.rmtree(partial, ignore_errors=True)
    return folder

"""The gateware's files for users' designs: as a copy in a folder, and in compile order."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.files import LIST, has_mark, write_texts
from unity_link.gateware.cache import GATEWARE, board_sources, pads_of, vhdl_sources

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.files import Overwrite

_TAKEN = (
    *("rtl/**/*.vhd", "cores/*/ul_*.vhd", "pads/**/*.vhd"),
    *("constraints/**/*", "import/*", "unity_link.f", "unity_link.core"),
)
_LICENCES = (GATEWARE / "LICENSE", GATEWARE.parent / "LICENSE")
"""Path of the licence in an installed package, and in the project."""


def gateware_files() -> dict[str, str]:
    """Return the text of each file that a design with the gateware needs, by path in the gateware's folder.

    Raises:
        ToolMissingError: if the installation has no VHDL.
    """
    vhdl_sources()
    found = [path for pattern in _TAKEN for path in sorted(GATEWARE.glob(pattern)) if path.is_file()]
    texts = {path.relative_to(GATEWARE).as_posix(): path.read_text() for path in (*found, *board_sources())}
    licence = next(path for path in _LICENCES if path.is_file())
    return texts | {"LICENSE": licence.read_text()}


def in_compile_order(pads: str | None = None) -> Iterator[str]:
    """Yield the paths of the sources in the gateware's folder in compile order.

    Args:
        pads: folder of `gateware/pads` with the vendor's registers for the pins of an FT245; None for portable ones.
    """
    theirs = pads_of(pads)
    for line in (GATEWARE / "unity_link.f").read_text().splitlines():
        if not line.startswith("#"):
            name = Path(line).name
            yield theirs[name].relative_to(GATEWARE).as_posix() if name in theirs else line


def copy_gateware(folder: Path, *, overwrite: Overwrite = False) -> Path:
    """Copy the gateware into a folder, and return the folder.

    The folder must be new or empty, or have an unchanged copy of the gateware.

    Args:
        folder: path of the folder.
        overwrite: True if files that this package did not make may be replaced.

    Raises:
        ArgumentError: if the folder has other or changed files, or cannot be written.
    """
    if overwrite is not True and _is_taken(folder):
        raise ArgumentError(f"{folder} exists already: a new or empty folder was expected")
    write_texts(gateware_files(), folder, overwrite=overwrite)
    return folder


def _is_taken(folder: Path) -> bool:
    try:
        return next(folder.iterdir(), None) is not None and not has_mark(folder / LIST)
    except FileNotFoundError:
        return folder.exists()
    except NotADirectoryError:
        return folder.exists()

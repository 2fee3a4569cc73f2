"""Paths of the gateware's sources, and the cache of files made from them, each named by a hash of its inputs."""

from __future__ import annotations

import contextlib
import hashlib
import os
import re
import stat
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from unity_link.errors import UnityLinkError
from unity_link.files import digest_of, write_file

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable


class ToolMissingError(UnityLinkError):
    """A tool is not installed and cannot be fetched; the message names the package to install."""


_HERE = Path(__file__).resolve().parent
GATEWARE = _HERE if (_HERE / "rtl").exists() else _HERE.parent.parent / "gateware"
"""The folder `gateware` of the project, or its copy in an installed package; the VHDL is in its subfolder `rtl`."""
_BEFORE_SEAL = b"\n// SHA-256 of all above this line: "
LIBRARY = "unity_link"
"""VHDL library into which the gateware's sources are compiled; inside these sources it is `work`."""


def cache_folder(*parts: str) -> Path:
    """Return Unity-Link's folder in the user's cache (XDG_CACHE_HOME or ~/.cache); create it if it does not exist.

    For a user without a home directory the folder is among the temporary files.
    """
    named = os.environ.get("XDG_CACHE_HOME")
    if named:
        base = Path(named, "unity-link")
    else:
        try:
            base = Path.home() / ".cache" / "unity-link"
            base.mkdir(parents=True, exist_ok=True)
        except (RuntimeError, OSError):
            # The home directory does not exist or is read-only, as in some containers.
            base = _private_folder()
    folder = base.joinpath(*parts)
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def _private_folder() -> Path:
    """Return a folder among the temporary files that only this user can write, because its files are executed.

    Raises:
        ToolMissingError: if another user owns it or can write into it.
    """
    folder = Path(tempfile.gettempdir(), f"unity-link-{os.getuid() if hasattr(os, 'getuid') else 'cache'}")
    with contextlib.suppress(FileExistsError):
        folder.mkdir(mode=0o700)
    state = folder.lstat()
    mine = not hasattr(os, "getuid") or (state.st_uid == os.getuid() and not state.st_mode & 0o022)
    if not (stat.S_ISDIR(state.st_mode) and mine):
        raise ToolMissingError(f"other users can write into {folder}: name a folder for the cache in XDG_CACHE_HOME")
    return folder


def kept(path: Path, make: Callable[[], str]) -> str:
    """Return a text from the cache, or make it and store it in a file named `path` plus a suffix."""
    file = path.with_name(f"{path.name}.sealed")
    data = _opened(file)
    if data is None:
        data = make().encode()
        write_file(file, sealed(data), overwrite=True)
    return data.decode()


def sealed(data: bytes) -> bytes:
    """Return data with their SHA-256 in an additional last line, which is a comment in Verilog and in C++.

    The hash detects files that a power failure truncated: a file's name can reach the disk before its contents.
    """
    return b"%s%s%s\n" % (data, _BEFORE_SEAL, digest_of(data).encode())


def is_whole(path: Path) -> bool:
    """Return True if a file exists and is unchanged since `sealed` made its contents."""
    return _opened(path) is not None


def _opened(path: Path) -> bytes | None:
    """Return the data that were sealed in a file; None if the file does not exist, or was truncated or changed."""
    try:
        data, _, seal = path.read_bytes().rpartition(_BEFORE_SEAL)
    except OSError:
        return None
    return data if seal == digest_of(data).encode() + b"\n" else None


def pads_of(vendor: str | None) -> dict[str, Path]:
    """Return a vendor's sources that replace portable ones, by file name; without a vendor, an empty dict."""
    return {source.name: source for source in (GATEWARE / "pads" / vendor).glob("*.vhd")} if vendor else {}


def vhdl_sources(pads: str | None = None) -> list[Path]:
    """Return all VHDL sources of the gateware sorted by path, followed by those of its cores.

    Args:
        pads: folder of `gateware/pads` with the vendor's registers for the pins of an FT245; None for portable ones.

    Raises:
        ToolMissingError: if the installation has no VHDL.
    """
    theirs = pads_of(pads)
    found = [theirs.get(source.name, source) for source in sorted((GATEWARE / "rtl").rglob("*.vhd"))]
    if not found:
        raise ToolMissingError(f"the gateware's VHDL is not in {GATEWARE / 'rtl'}: install unity-link anew")
    return found + core_sources()


def core_folders() -> list[Path]:
    """Return the folder of each core of the gateware, sorted by name."""
    return sorted(path.parent for path in (GATEWARE / "cores").glob("*/core.toml"))


def core_sources() -> list[Path]:
    """Return the VHDL sources of the cores of the gateware, sorted by path."""
    return [source for folder in core_folders() for source in sorted(folder.glob("ul_*.vhd"))]


def sources_for(top: str, sources: Iterable[Path | str] = (), pads: str | None = None) -> list[Path]:
    """Return the sources of `vhdl_sources` that a design needs, without the cores that it does not name.

    A change of a core therefore does not invalidate cached files of designs without that core.

    Args:
        top: name of the entity.
        sources: further VHDL files of the design, or their texts.
        pads: as in `vhdl_sources`.

    Raises:
        ToolMissingError: if the installation has no VHDL.
    """
    cores = {folder: [source.stem for source in sorted(folder.glob("ul_*.vhd"))] for folder in core_folders()}
    texts = (source if isinstance(source, str) else source.read_text() for source in sources)
    named = set(re.findall(r"\bul_\w+", "\n".join([top, *texts]).lower()))
    needed = {folder for folder, entities in cores.items() if named & set(entities)}
    return [source for source in vhdl_sources(pads) if source.parent not in cores or source.parent in needed]


def library_of(entity: str) -> str:
    """Return the VHDL library of an entity: that of the gateware for the gateware's entities, `work` for others."""
    return LIBRARY if any(source.stem == entity for source in vhdl_sources()) else "work"


def board_sources() -> list[Path]:
    """Return the additional VHDL sources of designs for a whole board."""
    return [GATEWARE / "boards" / f"{name}.vhd" for name in ("board_reset", "shift_chain")]


def hash_of(texts: Iterable[str | bytes]) -> str:
    """Return the first 16 hex digits of a SHA-256 of texts and their order."""
    digest = hashlib.sha256()
    for text in texts:
        data = text.encode() if isinstance(text, str) else text
        digest.update(len(data).to_bytes(8, "little") + data)
    return digest.hexdigest()[:16]

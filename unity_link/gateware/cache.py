"""The cache of made files, each named by a hash of everything that it was made from."""

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
    """A tool is not there and can't be fetched; the message says what to install."""


_HERE = Path(__file__).resolve().parent
GATEWARE = _HERE if (_HERE / "rtl").exists() else _HERE.parent.parent / "gateware"
"""The folder in which the VHDL is, in `rtl`: that of the project, or what an installed package has of it."""
_BEFORE_SEAL = b"\n// SHA-256 of all above this line: "
LIBRARY = "unity_link"
"""The VHDL library into which the gateware's sources are compiled; they themselves call it `work`."""


def cache_folder(*parts: str) -> Path:
    """Return a folder of ours in the user's cache (XDG_CACHE_HOME or ~/.cache), made if it was not there.

    A user without a home has it among the temporary files.
    """
    named = os.environ.get("XDG_CACHE_HOME")
    if named:
        base = Path(named, "unity-link")
    else:
        try:
            base = Path.home() / ".cache" / "unity-link"
            base.mkdir(parents=True, exist_ok=True)
        except (RuntimeError, OSError):
            # A container's user has no home, or one that cannot be written.
            base = _private_folder()
    folder = base.joinpath(*parts)
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def _private_folder() -> Path:
    """Return a folder for temporary files that this user alone can write: what is kept there is executed.

    Raises:
        ToolMissingError: where another user has made it.
    """
    folder = Path(tempfile.gettempdir(), f"unity-link-{os.getuid() if hasattr(os, 'getuid') else 'cache'}")
    with contextlib.suppress(FileExistsError):
        folder.mkdir(mode=0o700)
    state = folder.lstat()
    mine = not hasattr(os, "getuid") or (state.st_uid == os.getuid() and not state.st_mode & 0o022)
    if not (stat.S_ISDIR(state.st_mode) and mine):
        raise ToolMissingError(f"{folder} is not this user's alone: name a folder for what is kept in XDG_CACHE_HOME")
    return folder


def kept(path: Path, make: Callable[[], str]) -> str:
    """Return a text of the cache, made unless it was made before; its file is `path` with one more suffix."""
    file = path.with_name(f"{path.name}.sealed")
    data = _opened(file)
    if data is None:
        data = make().encode()
        write_file(file, sealed(data), overwrite=True)
    return data.decode()


def sealed(data: bytes) -> bytes:
    """Return data with their SHA-256 in a last line, which is a comment in Verilog and in C++.

    A power failure can cut a file that was written shortly before, although it got its name when all was written.
    """
    return b"%s%s%s\n" % (data, _BEFORE_SEAL, digest_of(data).encode())


def is_whole(path: Path) -> bool:
    """Return whether a file of the cache is there and as `sealed` made it."""
    return _opened(path) is not None


def _opened(path: Path) -> bytes | None:
    """Return what was sealed in a file; None if the file is not there, or was cut or changed since."""
    try:
        data, _, seal = path.read_bytes().rpartition(_BEFORE_SEAL)
    except OSError:
        return None
    return data if seal == digest_of(data).encode() + b"\n" else None


def pads_of(vendor: str | None) -> dict[str, Path]:
    """Return the sources that stand in for portable ones of the same name: none without a vendor."""
    return {source.name: source for source in (GATEWARE / "pads" / vendor).glob("*.vhd")} if vendor else {}


def vhdl_sources(pads: str | None = None) -> list[Path]:
    """Return every VHDL source of the gateware, those of its cores last, sorted by path.

    Args:
        pads: the vendor whose registers the FT245 has at its pins, a folder of `gateware/pads`; None: portable ones.

    Raises:
        ToolMissingError: where an installation has none.
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
    """Return what a design needs of `vhdl_sources`: of the cores only those that it names.

    So a change of a core leaves alone what is kept of a design without it.

    Args:
        top: name of the entity.
        sources: VHDL files of the design beside those of the gateware, or their texts.
        pads: as in `vhdl_sources`.

    Raises:
        ToolMissingError: where an installation has none.
    """
    cores = {folder: [source.stem for source in sorted(folder.glob("ul_*.vhd"))] for folder in core_folders()}
    texts = (source if isinstance(source, str) else source.read_text() for source in sources)
    named = set(re.findall(r"\bul_\w+", "\n".join([top, *texts]).lower()))
    needed = {folder for folder, entities in cores.items() if named & set(entities)}
    return [source for source in vhdl_sources(pads) if source.parent not in cores or source.parent in needed]


def library_of(entity: str) -> str:
    """Return the VHDL library in which an entity is compiled: the gateware's, or for all others that of the user."""
    return LIBRARY if any(source.stem == entity for source in vhdl_sources()) else "work"


def board_sources() -> list[Path]:
    """Return the VHDL sources of what a whole board has beside the gateware."""
    return [GATEWARE / "boards" / f"{name}.vhd" for name in ("board_reset", "shift_chain")]


def hash_of(texts: Iterable[str | bytes]) -> str:
    """Return 16 hex digits that name these texts in this order."""
    digest = hashlib.sha256()
    for text in texts:
        data = text.encode() if isinstance(text, str) else text
        digest.update(len(data).to_bytes(8, "little") + data)
    return digest.hexdigest()[:16]

"""Where made things are kept, and under which name: a hash of everything that they were made from."""

from __future__ import annotations

import hashlib
import os
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

GATEWARE = Path(__file__).resolve().parent.parent


def cache_folder(*parts: str) -> Path:
    """Return a folder of ours in the user's cache (XDG_CACHE_HOME or ~/.cache), made if it was not there."""
    base = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    folder = Path(base, "unity-link", *parts)
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def kept(path: Path, make: Callable[[], str]) -> str:
    """Return the text of a file of the cache, which is made unless it was made before."""
    if not path.exists():
        partial = path.with_suffix(f".{os.getpid()}")
        partial.write_text(make())
        partial.replace(path)
    return path.read_text()


def vhdl_sources(pads: str | None = None) -> list[Path]:
    """Return every VHDL source of the gateware, sorted by path.

    Args:
        pads: the vendor whose registers the FT245 has at its pins, a folder of `gateware/pads`; None: portable ones.
    """
    theirs = {source.name: source for source in (GATEWARE / "pads" / pads).glob("*.vhd")} if pads else {}
    return [theirs.get(source.name, source) for source in sorted((GATEWARE / "rtl").rglob("*.vhd"))]


def hash_of(texts: Iterable[str | bytes]) -> str:
    """Return 16 hex digits that name these texts in this order."""
    digest = hashlib.sha256()
    for text in texts:
        data = text.encode() if isinstance(text, str) else text
        digest.update(len(data).to_bytes(8, "little") + data)
    return digest.hexdigest()[:16]

"""The protocol without I/O, clocks or tasks: bytes and numbers in, bytes and events out.

- `crc`: the check of a frame
- `configuration`: what a gateway says of itself (`Q`), from which all widths follow
- `frames`: what stands between two line ends
- `messages`: what it means, for any widths
- `arrays` and `mixture`: the same for many at a time; imported when one is first asked for, as ``protocol.arrays``
- `constants`: how long and how often a host tries
- `window`: exactly once, in order
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from unity_link.protocol import arrays as arrays
    from unity_link.protocol import mixture as mixture


def __getattr__(name: str) -> Any:
    """Import what needs numpy where some of it is asked for; imports set the names, so this is called once."""
    if name in ("arrays", "mixture"):
        # It imports `arrays`.
        mixture = import_module("unity_link.protocol.mixture")
        return mixture if name == "mixture" else import_module("unity_link.protocol.arrays")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

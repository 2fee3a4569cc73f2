"""The bytes of the protocol and their meaning, for both ends of a line.

- `crc`: the check digits of a frame
- `configuration`: the gateway's answer to `Q`, from which all widths follow
- `frames`: the bytes between two line ends: node number, body, CRC
- `messages`: requests and responses, for the widths of one gateway
- `compact`, `compact_rows`: the compact form, two digits in each byte
- `arrays`, `interleaved_samples`: the same for many messages at a time, by numpy
- `datagrams`, `path`: headers of datagrams, and the longest datagram of a path
- `discovery`: the question that finds gateways in a network
- `description`: the spec that a gateway carries in its memory
- `numbers`: numbers from programs, and in words for people

`arrays` and `interleaved_samples` need numpy, which is slow to import. Write ``wire.arrays``, which imports them at the
first use.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from unity_link.protocol.wire import arrays as arrays
    from unity_link.protocol.wire import interleaved_samples as interleaved_samples


def __getattr__(name: str) -> Any:
    """Import the modules that need numpy. An import sets both names in this package, so this is called once."""
    if name in ("arrays", "interleaved_samples"):
        # It imports `arrays`.
        samples = import_module("unity_link.protocol.wire.interleaved_samples")
        return samples if name == "interleaved_samples" else import_module("unity_link.protocol.wire.arrays")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

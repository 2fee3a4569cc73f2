"""Recognition of wrong speeds by the bytes heard: whether the two ends of a serial line have different speeds.

A port that is much faster than what it hears takes one bit for several: the bits of its bytes hardly change. One that
is slower takes several for one, and hears bytes of all kinds, more of them not text than any protocol of text has.
"""

from __future__ import annotations

FEWEST_BYTES = 4
TEXT = 0.9
"""Part of the bytes that are printable where the speeds are equal, at least."""
FEW_CHANGES = 1.6
"""Changes within a byte, on average, below which the port is at least three times too fast: text has about three."""


def is_text(heard: bytes) -> bool:
    """Return whether bytes are as those of a line of the right speed."""
    printable = sum(32 <= byte < 127 or byte in b"\t\r\n" for byte in heard)
    return printable >= TEXT * len(heard)


def describe(heard: bytes) -> str:
    """Return what the pattern of bytes that are no text says about the speeds."""
    if len(heard) < FEWEST_BYTES:
        return "too few bytes to tell by how much the speeds differ"
    changes = sum(((byte ^ byte >> 1) & 0x7F).bit_count() for byte in heard)
    if changes < FEW_CHANGES * len(heard):
        return "bits hardly change within a byte: the port is several times faster than the gateway"
    return "bits change as in noise: the port is probably slower than the gateway, or nearly as fast"

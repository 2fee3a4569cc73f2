"""Recognition of a wrong speed by the bytes received on a serial line.

A port that is much faster than the sender samples each bit several times, so the bits within a byte hardly change. A
port that is slower merges several bits into one and receives bytes of all values, fewer of them printable than in text.
"""

from __future__ import annotations

FEWEST_BYTES = 4
TEXT = 0.9
"""Smallest share of printable bytes at the right speed, 0 to 1."""
FEW_CHANGES = 1.6
"""Average number of bit changes within a byte below which the port is at least 3 times too fast; text has about 3."""


def is_text(heard: bytes) -> bool:
    """Return whether enough bytes are printable for a line of the right speed."""
    printable = sum(32 <= byte < 127 or byte in b"\t\r\n" for byte in heard)
    return printable >= TEXT * len(heard)


def describe(heard: bytes) -> str:
    """Return the likely relation of the speeds, judged by unprintable bytes, as a phrase for a finding."""
    if len(heard) < FEWEST_BYTES:
        return "too few bytes to tell by how much the speeds differ"
    changes = sum(((byte ^ byte >> 1) & 0x7F).bit_count() for byte in heard)
    if changes < FEW_CHANGES * len(heard):
        return "bits hardly change within a byte: the port is several times faster than the gateway"
    return "bits change as in noise: the port is probably slower than the gateway, or nearly as fast"

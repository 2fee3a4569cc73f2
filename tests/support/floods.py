"""Bytes that fill a line instead of answers."""

from __future__ import annotations

from unity_link.protocol.wire.crc import Crc
from unity_link.protocol.wire.frames import Framing

FLOODS = {
    "damaged lines": b"a\n" * 200,
    "empty lines": b"\n" * 200,
    "empty plain lines": b"\r\n" * 200,
    "errors about damage": Framing(Crc()).checked(b"X01") * 200,
    "one line without an end": b"U" * 4000,
}
"""Sequences of bytes that a line repeats without end, by their names."""

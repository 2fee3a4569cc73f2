"""The blocks of a snoop: pcapng, as far as Unity-Link writes it (docs/reference/snoop.md).

A file is a row of blocks, each with its length at both ends. A section begins with each program that writes to it, a
connection is an interface of its section, and what passed in one read or write is a packet.
"""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    import mmap
    from collections.abc import Iterator

SECTION, INTERFACE, PACKET, STATISTICS = 0x0A0D0D0A, 1, 6, 5
_OURS = (SECTION, INTERFACE, PACKET, STATISTICS)
ORDER = 0x1A2B3C4D
LINK_TYPE = 147
"""LINKTYPE_USER0: what it is, the two ends know."""
FORM = "Unity-Link snoop 1"
"""Marker of the form in a section; a later form has another number."""
SECTION_START = struct.pack("<I", SECTION)
_INBOUND, _OUTBOUND = 1, 2
_COMMENT, _APPLICATION, _NAME, _RESOLUTION, _FLAGS = 1, 4, 2, 9, 2
_TICKS = bytes([9])
"""Resolution of the times of an interface: nanoseconds."""
SMALLEST = 12
"""Bytes of a block without a body."""
LARGEST_BLOCK = 1 << 26
"""Bytes: no read or write is as large, and what says so is damaged."""


class PcapngBlock(NamedTuple):
    """A block, whole."""

    kind: int
    body: bytes


class Packet(NamedTuple):
    """Bytes that passed."""

    connection: int
    time_ns: int
    """Since 1970."""
    sent: bool
    data: bytes


class DamagedFileError(ValueError):
    """A file that goes on as no row of blocks does; `offset` is where that begins."""

    def __init__(self, offset: int, reason: str) -> None:
        super().__init__(f"{reason} at byte {offset:,}")
        self.offset = offset


def section() -> bytes:
    """Return the block that begins a section."""
    return _block(SECTION, struct.pack("<IHHq", ORDER, 1, 0, -1) + _option(_APPLICATION, FORM.encode()) + _END)


def interface(name: str) -> bytes:
    """Return the block of a connection; those of a section are numbered from 0 in their order."""
    options = _option(_NAME, name.encode(errors="backslashreplace")) + _option(_RESOLUTION, _TICKS) + _END
    return _block(INTERFACE, struct.pack("<HHI", LINK_TYPE, 0, 0) + options)


def packet(passed: Packet) -> bytes:
    """Return the block of what passed."""
    size = len(passed.data)
    head = struct.pack("<IIIII", passed.connection, passed.time_ns >> 32, passed.time_ns & 0xFFFFFFFF, size, size)
    flags = _option(_FLAGS, struct.pack("<I", _OUTBOUND if passed.sent else _INBOUND)) + _END
    return _block(PACKET, head + _padded(passed.data) + flags)


def ending(connection: int, time_ns: int, why: str) -> bytes:
    """Return the block that tells the end of a connection."""
    head = struct.pack("<III", connection, time_ns >> 32, time_ns & 0xFFFFFFFF)
    return _block(STATISTICS, head + _option(_COMMENT, why.encode()) + _END)


def _option(code: int, value: bytes) -> bytes:
    return struct.pack("<HH", code, len(value)) + _padded(value)


_END = struct.pack("<HH", 0, 0)


def _padded(data: bytes) -> bytes:
    return data + bytes(-len(data) % 4)


def _block(kind: int, body: bytes) -> bytes:
    total = struct.pack("<I", SMALLEST + len(body))
    return struct.pack("<I", kind) + total + body + total


def blocks(data: bytes | mmap.mmap, offset: int = 0) -> Iterator[PcapngBlock]:
    """Return the blocks of a file, from an offset on.

    Raises:
        DamagedFileError: behind the last whole block, where something else follows.
    """
    while offset < len(data):
        size = _whole(data, offset)
        kind = int.from_bytes(data[offset : offset + 4], "little")
        yield PcapngBlock(kind, data[offset + 8 : offset + size - 4])
        offset += size


def length_of_whole(data: bytes | mmap.mmap) -> int:
    """Return where the last whole block ends."""
    offset = 0
    try:
        while offset < len(data):
            offset += _whole(data, offset)
    except DamagedFileError:
        pass
    return offset


def check_beginning(data: bytes | mmap.mmap) -> None:
    """Check that a file begins with a section of ours.

    Raises:
        ValueError: where it does not, or the section is of another version.
    """
    if data[: len(SECTION_START)] != SECTION_START:
        raise ValueError("it begins as no capture does")
    if (order := data[8:12]) != struct.pack("<I", ORDER):
        raise ValueError("its bytes stand in another order" if order == struct.pack(">I", ORDER) else "it is cut")
    check_section(data[8 : _whole(data, 0) - 4])


def is_begun(rest: bytes) -> bool:
    """Return whether what stands behind the last whole block is nothing but the beginning of one of ours.

    Where a machine loses its power, a file may have got its length and not its last bytes, which are zeros then.
    """
    begun = rest.rstrip(b"\0")
    if len(rest) > LARGEST_BLOCK:
        return False
    if len(begun) < 8:
        return any(struct.pack("<I", kind).startswith(begun[:4]) for kind in _OURS)
    kind, size = struct.unpack_from("<II", begun)
    return kind in _OURS and size % 4 == 0 and len(begun) < size <= LARGEST_BLOCK


def ends_whole(data: bytes | mmap.mmap) -> bool:
    """Return whether the last block is whole, as far as its two lengths tell."""
    size = int.from_bytes(data[-4:], "little")
    if not SMALLEST <= size <= len(data):
        return False
    kind = int.from_bytes(data[-size:][:4], "little")
    return data[-size:][4:8] == data[-4:] and kind in _OURS


def _whole(data: bytes | mmap.mmap, offset: int) -> int:
    """Return the length of the block that begins at an offset."""
    left = len(data) - offset
    if left < SMALLEST:
        raise DamagedFileError(offset, "it is cut")
    size = int.from_bytes(data[offset + 4 : offset + 8], "little")
    if size % 4 or not SMALLEST <= size <= LARGEST_BLOCK:
        raise DamagedFileError(offset, f"a block of {size} bytes is none")
    if size > left:
        raise DamagedFileError(offset, "it is cut")
    if data[offset + size - 4 : offset + size] != data[offset + 4 : offset + 8]:
        raise DamagedFileError(offset, "the two lengths of a block differ")
    return size


# What blocks say.


def check_section(body: bytes, data: bytes | mmap.mmap = b"", end: int = 0) -> None:
    """Check what a section says of who wrote it.

    Args:
        body: of the section.
        data: the file; none where what another program has copied counts as no snoop.
        end: where the section ends in the file.

    Raises:
        ValueError: where it is not ours, and no copy; or of another version.
    """
    if body[:4] != struct.pack("<I", ORDER):
        raise ValueError("no snoop: its bytes stand in another order")
    application = _options(body[16:]).get(_APPLICATION, b"").decode(errors="replace")
    if not application.startswith("Unity-Link snoop"):
        if not _is_connection(data, end):
            raise ValueError(f"no snoop of unity-link, but of {application or 'another program'}")
    elif application != FORM:
        raise ValueError(f"of another version, {application!r}; this program reads {FORM!r}")


def _is_connection(data: bytes | mmap.mmap, offset: int) -> bool:
    """Return whether a connection begins at an offset, by whichever program it was copied."""
    try:
        following = next(blocks(data, offset), None)
    except DamagedFileError:
        return False
    if following is None or following.kind != INTERFACE or following.body[:2] != struct.pack("<H", LINK_TYPE):
        return False
    options = _options(following.body[8:])
    return _NAME in options and options.get(_RESOLUTION) == _TICKS


def read_interface(body: bytes) -> str:
    """Return the name of a connection.

    Raises:
        ValueError: where it is of something else.
    """
    if body[:2] != struct.pack("<H", LINK_TYPE):
        raise ValueError("what is captured is no connection to a gateway")
    return _options(body[8:]).get(_NAME, b"").decode(errors="replace")


def read_packet(body: bytes) -> Packet:
    """Return what passed.

    Raises:
        ValueError: where it does not say which way, or is shorter than it says.
    """
    try:
        connection, high, low, size, _ = struct.unpack_from("<IIIII", body)
        data = body[20 : 20 + size]
        (flags,) = struct.unpack("<I", _options(body[20 + size + -size % 4 :]).get(_FLAGS, b""))
    except struct.error:
        raise ValueError("a record that is not whole") from None
    if len(data) != size or flags & 3 not in (_INBOUND, _OUTBOUND):
        raise ValueError("a record that is not whole")
    return Packet(connection, high << 32 | low, flags & 3 == _OUTBOUND, data)


def read_ending(body: bytes) -> tuple[int, int, str]:
    """Return which connection has ended, when (ns), and why.

    Raises:
        ValueError: where it is not whole.
    """
    try:
        connection, high, low = struct.unpack_from("<III", body)
    except struct.error:
        raise ValueError("a record that is not whole") from None
    return connection, high << 32 | low, _options(body[12:]).get(_COMMENT, b"").decode(errors="replace")


def _options(data: bytes) -> dict[int, bytes]:
    found: dict[int, bytes] = {}
    while len(data) >= 4:
        code, size = struct.unpack_from("<HH", data)
        if code == 0:
            break
        found[code] = data[4 : 4 + size]
        data = data[4 + size + -size % 4 :]
    return found

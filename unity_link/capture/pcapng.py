"""Capture files ("snoops"): the part of pcapng that Unity-Link writes (docs/reference/snoop.md).

A file is a sequence of blocks. Each block contains its length at its beginning and at its end.

- A section header block begins the blocks of one program; several programs may append to one file.
- An interface description block is one connection of that program.
- An enhanced packet block has the bytes of one read or write.
- An interface statistics block marks the end of a connection, with the reason.
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
"""Byte-order magic of a section; only files in little-endian order are read."""
LINK_TYPE = 147
"""LINKTYPE_USER0, reserved for private use."""
FORM = "Unity-Link snoop 1"
"""Name of the format and its version, as the application of a section."""
SECTION_START = struct.pack("<I", SECTION)
_INBOUND, _OUTBOUND = 1, 2
_COMMENT, _APPLICATION, _NAME, _RESOLUTION, _FLAGS = 1, 4, 2, 9, 2
_TICKS = bytes([9])
"""Time resolution of an interface: 10**-9 s."""
SMALLEST = 12
"""Bytes of a block without a body."""
LARGEST_BLOCK = 1 << 26
"""Upper limit of the bytes of a block. No read or write is as large, so a larger length is damaged."""


class PcapngBlock(NamedTuple):
    """A complete block."""

    kind: int
    """Block type."""
    body: bytes
    """Bytes between the two length fields, with padding and options."""


class Packet(NamedTuple):
    """Bytes of one read or write."""

    connection: int
    """Number of the connection in its section, from 0."""
    time_ns: int
    """Nanoseconds since 1970."""
    sent: bool
    """True for bytes that the host has written, False for bytes that it has read."""
    data: bytes


class DamagedFileError(ValueError):
    """The file is not a sequence of complete blocks; `offset` is the first byte after the last complete block."""

    def __init__(self, offset: int, reason: str) -> None:
        super().__init__(f"{reason} at byte {offset:,}")
        self.offset = offset


def section() -> bytes:
    """Return the block that begins a section."""
    return _block(SECTION, struct.pack("<IHHq", ORDER, 1, 0, -1) + _option(_APPLICATION, FORM.encode()) + _END)


def interface(name: str) -> bytes:
    """Return the block of a connection. Its number is its position among the interfaces of its section, from 0."""
    options = _option(_NAME, name.encode(errors="backslashreplace")) + _option(_RESOLUTION, _TICKS) + _END
    return _block(INTERFACE, struct.pack("<HHI", LINK_TYPE, 0, 0) + options)


def packet(passed: Packet) -> bytes:
    """Return the block of one read or write."""
    size = len(passed.data)
    head = struct.pack("<IIIII", passed.connection, passed.time_ns >> 32, passed.time_ns & 0xFFFFFFFF, size, size)
    flags = _option(_FLAGS, struct.pack("<I", _OUTBOUND if passed.sent else _INBOUND)) + _END
    return _block(PACKET, head + _padded(passed.data) + flags)


def ending(connection: int, time_ns: int, why: str) -> bytes:
    """Return the block that marks the end of a connection.

    Args:
        connection: number of the connection in its section.
        time_ns: instant of its end, in nanoseconds since 1970.
        why: reason for the end, in words.
    """
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
        DamagedFileError: after the last complete block, if other bytes follow.
    """
    while offset < len(data):
        size = _block_length(data, offset)
        kind = int.from_bytes(data[offset : offset + 4], "little")
        yield PcapngBlock(kind, data[offset + 8 : offset + size - 4])
        offset += size


def length_of_whole(data: bytes | mmap.mmap) -> int:
    """Return the offset of the end of the last complete block."""
    offset = 0
    try:
        while offset < len(data):
            offset += _block_length(data, offset)
    except DamagedFileError:
        pass
    return offset


def check_beginning(data: bytes | mmap.mmap) -> None:
    """Check that a file begins with a section of ours.

    Raises:
        ValueError: if it does not, or the section has another version.
    """
    if data[: len(SECTION_START)] != SECTION_START:
        raise ValueError("it does not begin with a section of pcapng")
    if (order := data[8:12]) != struct.pack("<I", ORDER):
        raise ValueError("its byte order is big-endian" if order == struct.pack(">I", ORDER) else "it is cut")
    check_section(data[8 : _block_length(data, 0) - 4])


def is_begun(rest: bytes) -> bool:
    """Return whether the bytes after the last complete block are the beginning of a block that we write.

    After a loss of power a file may have its new length but zeros as its last bytes, so zeros at the end are ignored.
    """
    begun = rest.rstrip(b"\0")
    if len(rest) > LARGEST_BLOCK:
        return False
    if len(begun) < 8:
        return any(struct.pack("<I", kind).startswith(begun[:4]) for kind in _OURS)
    kind, size = struct.unpack_from("<II", begun)
    return kind in _OURS and size % 4 == 0 and len(begun) < size <= LARGEST_BLOCK


def ends_whole(data: bytes | mmap.mmap) -> bool:
    """Return whether the two lengths of the last block agree, so that the file probably ends with a complete block."""
    size = int.from_bytes(data[-4:], "little")
    if not SMALLEST <= size <= len(data):
        return False
    kind = int.from_bytes(data[-size:][:4], "little")
    return data[-size:][4:8] == data[-4:] and kind in _OURS


def _block_length(data: bytes | mmap.mmap, offset: int) -> int:
    """Return the length of the block that begins at an offset.

    Raises:
        DamagedFileError: if no complete block begins there.
    """
    left = len(data) - offset
    if left < SMALLEST:
        raise DamagedFileError(offset, "it is cut")
    size = int.from_bytes(data[offset + 4 : offset + 8], "little")
    if size % 4 or not SMALLEST <= size <= LARGEST_BLOCK:
        raise DamagedFileError(
            offset, f"a block has a length of {size}, expected a multiple of 4 from {SMALLEST} to {LARGEST_BLOCK}"
        )
    if size > left:
        raise DamagedFileError(offset, "it is cut")
    if data[offset + size - 4 : offset + size] != data[offset + 4 : offset + 8]:
        raise DamagedFileError(offset, "the two lengths of a block differ")
    return size


# Bodies of blocks


def check_section(body: bytes, data: bytes | mmap.mmap = b"", end: int = 0) -> None:
    """Check that a section comes from this version of Unity-Link, or is a copy by another program of such a section.

    Args:
        body: body of the section header block.
        data: the file; empty if copies are to be rejected.
        end: offset of the end of the section header block.

    Raises:
        ValueError: if the section is neither, or has another version.
    """
    if body[:4] != struct.pack("<I", ORDER):
        raise ValueError("no snoop: its byte order is big-endian")
    application = _options(body[16:]).get(_APPLICATION, b"").decode(errors="replace")
    if not application.startswith("Unity-Link snoop"):
        if not _is_connection(data, end):
            raise ValueError(f"no snoop of unity-link, but of {application or 'another program'}")
    elif application != FORM:
        raise ValueError(f"of another version, {application!r}; this program reads {FORM!r}")


def _is_connection(data: bytes | mmap.mmap, offset: int) -> bool:
    """Return whether the block at an offset is a connection in the form of `interface`, which other programs copy."""
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
        ValueError: if the interface has another link type.
    """
    if body[:2] != struct.pack("<H", LINK_TYPE):
        raise ValueError("an interface that is no connection to a gateway")
    return _options(body[8:]).get(_NAME, b"").decode(errors="replace")


def read_packet(body: bytes) -> Packet:
    """Return the bytes of one read or write.

    Raises:
        ValueError: if the direction is missing, or the body is shorter than its length field.
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
    """Return the number of the connection that ended, the instant in ns since 1970, and the reason.

    Raises:
        ValueError: if the body is cut.
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

"""``mmio:/dev/uio0``, ``mmio:FILE``: a bus that is mapped into memory, without frames and without a gateway.

The file may be a UIO device, a PCIe BAR (``/sys/bus/pci/devices/.../resource0``), physical memory (``/dev/mem``), or a
file that programs share.
"""

from __future__ import annotations

import mmap
import os
import stat
from pathlib import Path
from typing import TYPE_CHECKING, Literal, NamedTuple

from unity_link.errors import ArgumentError, ConnectError
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.transport.channel import refused_as

if TYPE_CHECKING:
    import asyncio

    from unity_link.transport import DriverUrl

OPTIONS = frozenset({"offset", "size", "uio_map", "data_bits", "base_frequency_millihertz"})
UIO = Path("/sys/class/uio")
"""Folder in which Linux lists the mappings of UIO devices."""
_FORMATS: dict[int, Literal["B", "H", "I", "Q"]] = {8: "B", 16: "H", 32: "I", 64: "Q"}
"""Format of a `memoryview` for each width of a word in bits; an element is read or written by one access of this width.
"""
_BASE_MILLIHERTZ = 1_000_000
"""Default base frequency of groups; timers of the host are not much faster than 1 kHz."""
_NANOSECONDS = 1_000_000_000
_MOST_ADDRESS_BITS = 32
_FEATURES = (
    Feature.GROUPS
    | Feature.TIMESTAMPS
    | Feature.SEND_IMMEDIATE
    | Feature.FLOW_CONTROL
    | Feature.MASKED_WRITE
    | Feature.QUEUE_COMMANDS
)


class MappedBus:
    """A bus that is mapped into memory.

    Args:
        path: path of the file.
        place: part of the file to map.
        info: configuration of the bus for a link.
    """

    def __init__(self, path: str, place: _Place, info: GatewayInfo) -> None:
        before = place.offset % mmap.ALLOCATIONGRANULARITY
        # Without O_SYNC, accesses to /dev/mem would be cached.
        descriptor = os.open(path, os.O_RDWR | os.O_SYNC | os.O_CLOEXEC)
        try:
            self._memory = mmap.mmap(descriptor, before + place.size, offset=place.offset - before)
        finally:
            os.close(descriptor)
        self._bytes = memoryview(self._memory)[before : before + place.size]
        self.words = self._bytes.cast(_FORMATS[info.data_bits])
        """Words by address; each access to an element is one bus access."""
        self.info = info

    def close(self) -> None:
        """Unmap the bus; `words` cannot be used any more."""
        self.words.release()
        self._bytes.release()
        self._memory.close()


class _Place(NamedTuple):
    offset: int
    """Offset in the file in bytes, as for mmap(2)."""
    size: int
    """Size in bytes."""


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:  # noqa: ARG001  (as a driver's)
    """Raise an error, because mapped memory has no stream of frames.

    Raises:
        ArgumentError: always.
    """
    raise ArgumentError(
        f"{url.text} is mapped memory and carries no frames, so it cannot be served, snooped or handed on: "
        "let each program of this machine map it"
    )


def open_bus(url: DriverUrl) -> MappedBus:
    """Map the file of a URL.

    Raises:
        ArgumentError: if the offset, the size or the width of words is not possible.
        ConnectError: if the file cannot be mapped.
    """
    if url.host or not url.path:
        raise ArgumentError(f"{url.text} names no file: mmio:/dev/uio0 or mmio:FILE was expected")
    for option in ("node", "snoop", "compact", "echo"):
        if option in url.options:
            raise ArgumentError(f"{option}= in {url.text} is for links with frames, and mapped memory has none")
    data_bits = url.integer("data_bits", 32)
    if data_bits not in _FORMATS:
        raise ArgumentError(f"data_bits={data_bits} in {url.text}: 8, 16, 32 or 64 was expected")
    with refused_as("it cannot be mapped", "it must be there, and this user must be allowed to read and write it"):
        place = _place(url, data_bits // 8)
        info = GatewayInfo(
            data_bits=data_bits,
            address_bits=max(8, (place.size * 8 // data_bits - 1).bit_length()),
            base_frequency_millihertz=_base_frequency(url),
            clock_hz=_NANOSECONDS,
            features=_FEATURES,
        )
        if info.address_bits > _MOST_ADDRESS_BITS:
            raise ArgumentError(
                f"{place.size} bytes of {url.text} are more words than 32 address bits can address: give size="
            )
        try:
            return MappedBus(url.path, place, info)
        except (ValueError, OverflowError) as error:
            raise ConnectError(f"it cannot be mapped ({error})") from None


def _base_frequency(url: DriverUrl) -> int:
    millihertz = url.integer("base_frequency_millihertz", _BASE_MILLIHERTZ)
    if not 1 <= millihertz < 1 << 40:
        raise ArgumentError(f"base_frequency_millihertz={millihertz} in {url.text} is not from 1 to {(1 << 40) - 1}")
    return millihertz


def _place(url: DriverUrl, word_bytes: int) -> _Place:
    """Return the part of the file to map.

    Raises:
        ArgumentError: if an option of the URL is not possible.
        OSError: if the file does not exist.
    """
    for option in ("offset", "size"):
        value = url.integer(option, 0)
        if value < 0 or value % word_bytes:
            raise ArgumentError(
                f"{option}={url.options[option]} in {url.text} is no multiple of the {word_bytes} bytes of a word"
            )
    offset, found = url.integer("offset", 0), os.stat(url.path)  # noqa: PTH116  (it fails as open does)
    if stat.S_ISDIR(found.st_mode):
        raise ArgumentError(f"{url.path} is a folder: a file or a device was expected")
    whole = _whole(url, found)
    size = url.integer("size", 0) if "size" in url.options else None
    if whole is None:
        if not size:
            raise ArgumentError(
                f"{url.path} has no size of its own: give the number of bytes to map, as in ?size=0x1000"
            )
        return _Place(offset, size)
    left = max(0, whole.size - offset)
    if size is None:
        size = left - left % word_bytes
    if not 0 < size <= left:
        wanted = f"{size} bytes from {offset:#x} on were asked for" if size else "no word is left to be mapped"
        raise ArgumentError(f"{url.path} has {whole.size} bytes: {wanted} in {url.text}")
    return _Place(whole.offset + offset, size)


def _whole(url: DriverUrl, found: os.stat_result) -> _Place | None:
    """Return the whole mapping of a file or UIO device; None for other devices, whose size is unknown."""
    mapping = url.integer("uio_map", 0)
    if stat.S_ISCHR(found.st_mode):
        maps = UIO / Path(url.path).resolve().name / "maps"
        if maps.is_dir():
            return uio_place(maps, mapping, url.path)
    if "uio_map" in url.options:
        raise ArgumentError(f"uio_map={mapping} in {url.text} is for UIO devices, and {url.path} is not one")
    return _Place(0, found.st_size) if stat.S_ISREG(found.st_mode) else None


def uio_place(maps: Path, mapping: int, path: str) -> _Place:
    """Return a mapping of a UIO device.

    The offset for mmap(2) is the number of the mapping times the page size (Linux, "The Userspace I/O HOWTO").

    Args:
        maps: the folder in which Linux lists the device's mappings.
        mapping: number of the mapping.
        path: path of the device, for messages.

    Raises:
        ArgumentError: if the device does not have this mapping.
    """
    one = maps / f"map{mapping}"
    if not one.is_dir():
        there = ", ".join(sorted(folder.name.removeprefix("map") for folder in maps.iterdir())) or "none"
        raise ArgumentError(f"{path} has no mapping {mapping}: there is {there}")
    size, offset = (int((one / name).read_text(), 0) for name in ("size", "offset"))
    return _Place(mapping * mmap.PAGESIZE + offset, size)

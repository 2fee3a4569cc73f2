"""``mmio:/dev/uio0``, ``mmio:FILE``: a bus that is mapped into memory, without frames and without a gateway.

What can be mapped is a device of UIO, a BAR of PCIe (``/sys/bus/pci/devices/.../resource0``), physical memory
(``/dev/mem``), or a file that programs share.
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
"""Folder in which Linux lists what the devices of UIO map."""
_FORMATS: dict[int, Literal["B", "H", "I", "Q"]] = {8: "B", 16: "H", 32: "I", 64: "Q"}
"""Format characters of `memoryview` by bits of a word: it makes one access for each, of that width."""
_BASE_MILLIHERTZ = 1_000_000
"""A timer of the host is not much quicker."""
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
    """Words in memory.

    Args:
        path: of what is mapped.
        place: where in it.
        info: what a link is to know of the bus.
    """

    def __init__(self, path: str, place: _Place, info: GatewayInfo) -> None:
        before = place.offset % mmap.ALLOCATIONGRANULARITY
        # Physical memory would be cached without O_SYNC.
        descriptor = os.open(path, os.O_RDWR | os.O_SYNC | os.O_CLOEXEC)
        try:
            self._memory = mmap.mmap(descriptor, before + place.size, offset=place.offset - before)
        finally:
            os.close(descriptor)
        self._bytes = memoryview(self._memory)[before : before + place.size]
        self.words = self._bytes.cast(_FORMATS[info.data_bits])
        """The words by address: each access is one to the bus."""
        self.info = info

    def close(self) -> None:
        """Unmap it; `words` has none from now on."""
        self.words.release()
        self._bytes.release()
        self._memory.close()


class _Place(NamedTuple):
    offset: int
    """Bytes before it, as mmap(2) counts them."""
    size: int
    """Size in bytes."""


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:  # noqa: ARG001  (as a driver's)
    """Refuse, for what asks for a stream of frames.

    Raises:
        ArgumentError: in any case.
    """
    raise ArgumentError(
        f"{url.text} is mapped memory and carries no frames, so it cannot be served, snooped or handed on: "
        "let each program of this machine map it"
    )


def open_bus(url: DriverUrl) -> MappedBus:
    """Map what a URL names.

    Raises:
        ArgumentError: for a place or a width that cannot be.
        ConnectError: where it cannot be mapped.
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
                f"{place.size} bytes of {url.text} are more words than 32 address bits name: give size="
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
    """Return which bytes are to be mapped.

    Raises:
        ArgumentError: where a URL says what cannot be.
        OSError: where there is no such file.
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
            raise ArgumentError(f"{url.path} has no size of its own: say how many bytes to map, as in ?size=0x1000")
        return _Place(offset, size)
    left = max(0, whole.size - offset)
    if size is None:
        size = left - left % word_bytes
    if not 0 < size <= left:
        wanted = f"{size} bytes from {offset:#x} on were asked for" if size else "no word is left to be mapped"
        raise ArgumentError(f"{url.path} has {whole.size} bytes: {wanted} in {url.text}")
    return _Place(whole.offset + offset, size)


def _whole(url: DriverUrl, found: os.stat_result) -> _Place | None:
    """Return all that there is to be mapped, None where a file does not tell."""
    mapping = url.integer("uio_map", 0)
    if stat.S_ISCHR(found.st_mode):
        told = UIO / Path(url.path).resolve().name / "maps"
        if told.is_dir():
            return uio_place(told, mapping, url.path)
    if "uio_map" in url.options:
        raise ArgumentError(f"uio_map={mapping} in {url.text} is for devices of UIO, which {url.path} is none of")
    return _Place(0, found.st_size) if stat.S_ISREG(found.st_mode) else None


def uio_place(told: Path, mapping: int, path: str) -> _Place:
    """Return a mapping of a device of UIO: mmap(2) is told its number in pages (Linux, "The Userspace I/O HOWTO").

    Args:
        told: the folder in which Linux tells of the device's mappings.
        mapping: the number of one.
        path: of the device, for messages.

    Raises:
        ArgumentError: where there is no such mapping.
    """
    one = told / f"map{mapping}"
    if not one.is_dir():
        there = ", ".join(sorted(folder.name.removeprefix("map") for folder in told.iterdir())) or "none"
        raise ArgumentError(f"{path} has no mapping {mapping}: there is {there}")
    size, offset = (int((one / name).read_text(), 0) for name in ("size", "offset"))
    return _Place(mapping * mmap.PAGESIZE + offset, size)

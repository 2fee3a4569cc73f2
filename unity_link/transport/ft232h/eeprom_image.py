"""Contents of the chip's EEPROM, a 93C56 of 256 bytes, in the layout of pyftdi, libftdi and FT_PROG.

A chip ignores an EEPROM that is blank or has a wrong checksum: all of its ports are then UARTs, and it has no serial
number.
"""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Literal

from unity_link.quoting import one_line
from unity_link.transport.ft232h.kinds import FT232H, PORT_A

if TYPE_CHECKING:
    from collections.abc import Collection

    from unity_link.transport.ft232h.kinds import ChipKind

ChannelType = Literal["UART", "FIFO"]

SIZE = 256
BLANK = b"\xff" * SIZE
_CHANNEL_TYPES: dict[ChannelType, int] = {"UART": 0, "FIFO": 1}
"""Values of the port's byte for each mode."""
_VENDOR = 0x0403
_HAS_SERIAL_NUMBER = 0x08
_BUS_POWERED = 0x80
_MODEL_93C56 = 0x56
_STRING_TABLE = 0x0E
_STRING_DESCRIPTOR = 3


def build_eeprom(
    channel_type: ChannelType,
    serial: str = "",
    manufacturer: str = "Unity-Link",
    product: str | None = None,
    *,
    kind: ChipKind = FT232H,
    ports: Collection[int] = (PORT_A,),
) -> bytes:
    """Return the contents of an EEPROM, with its checksum.

    Args:
        channel_type: mode of the pins of `ports`; other ports are UARTs.
        serial: serial number; empty for none.
        manufacturer: name of the manufacturer.
        product: name of the product; None for that of the simulated chip.
        kind: kind of chip.
        ports: numbers of the ports that have the mode `channel_type`.
    """
    image = bytearray(SIZE)
    for port in ports:
        image[port - 1] = _CHANNEL_TYPES[channel_type]
    conf = _HAS_SERIAL_NUMBER if serial else 0
    struct.pack_into("<HHHBBB", image, 2, _VENDOR, kind.product_id, kind.release, _BUS_POWERED, 45, conf)
    image[kind.memory_model] = _MODEL_93C56
    position = kind.strings
    for index, text in enumerate((manufacturer, product or f"Virtual {kind.name}", serial)):
        encoded = text.encode("utf-16-le")
        descriptor = bytes([len(encoded) + 2, _STRING_DESCRIPTOR]) + encoded
        image[_STRING_TABLE + 2 * index] = position
        image[_STRING_TABLE + 2 * index + 1] = len(descriptor)
        image[position : position + len(descriptor)] = descriptor
        position += len(descriptor)
    struct.pack_into("<H", image, SIZE - 2, checksum(image[:-2]))
    return bytes(image)


def checksum(content: bytes | bytearray) -> int:
    """Return the checksum of all words before the last one, which holds the checksum."""
    value = 0xAAAA
    for (word,) in struct.iter_unpack("<H", content):
        value ^= word
        value = (value << 1 | value >> 15) & 0xFFFF
    return value


def is_valid(image: bytes | bytearray) -> bool:
    """Return True if a chip uses these contents, because their checksum is right.

    A memory of 128 bytes is read as two equal halves.
    """
    half = len(image) // 2
    if image[:half] == image[half:]:
        image = image[:half]
    return checksum(image[:-2]) == int.from_bytes(image[-2:], "little")


def channel_type(image: bytes | bytearray, kind: ChipKind = FT232H, port: int = PORT_A) -> ChannelType:
    """Return the mode of a port's pins after power-up."""
    code = image[port - 1] & kind.type_mask
    return "FIFO" if is_valid(image) and code == _CHANNEL_TYPES["FIFO"] else "UART"


def strings(image: bytes | bytearray, kind: ChipKind = FT232H) -> tuple[str, str, str]:
    """Return manufacturer, product and serial number, each as one printable line, which may be empty."""
    if not is_valid(image):
        return ("FTDI", kind.name, "")
    texts = []
    for index in range(3):
        place, length = image[_STRING_TABLE + 2 * index], image[_STRING_TABLE + 2 * index + 1]
        texts.append(one_line(image[place + 2 : place + length].decode("utf-16-le", errors="replace")))
    return (texts[0], texts[1], texts[2] if image[0x0A] & _HAS_SERIAL_NUMBER else "")

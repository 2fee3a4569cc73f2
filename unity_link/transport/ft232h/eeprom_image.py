"""What the chip's EEPROM says: a 93C56 of 256 bytes, by the layout that pyftdi and FT_PROG read.

A chip whose EEPROM is blank, or has a wrong checksum, ignores it: it is a UART then, and has no serial number.
"""

from __future__ import annotations

import struct
from typing import Literal

ChannelType = Literal["UART", "FIFO"]

SIZE = 256
BLANK = b"\xff" * SIZE
_CHANNEL_TYPES: dict[ChannelType, int] = {"UART": 0, "FIFO": 1}
"""Low digit of byte 0."""
_HAS_SERIAL_NUMBER = 0x08
_BUS_POWERED = 0x80
_MODEL_93C56 = 0x56
_STRING_TABLE, _STRINGS = 0x0E, 0xA0
_STRING_DESCRIPTOR = 3


def build_eeprom(
    channel_type: ChannelType, serial: str = "", manufacturer: str = "Unity-Link", product: str = "Virtual FT232H"
) -> bytes:
    """Build the content of an EEPROM, with its checksum."""
    image = bytearray(SIZE)
    conf = _HAS_SERIAL_NUMBER if serial else 0
    struct.pack_into(
        "<BBHHHBBB", image, 0, _CHANNEL_TYPES[channel_type], 0, 0x0403, 0x6014, 0x0900, _BUS_POWERED, 45, conf
    )
    image[0x1E] = _MODEL_93C56
    position = _STRINGS
    for index, text in enumerate((manufacturer, product, serial)):
        encoded = text.encode("utf-16-le")
        descriptor = bytes([len(encoded) + 2, _STRING_DESCRIPTOR]) + encoded
        image[_STRING_TABLE + 2 * index] = position
        image[_STRING_TABLE + 2 * index + 1] = len(descriptor)
        image[position : position + len(descriptor)] = descriptor
        position += len(descriptor)
    struct.pack_into("<H", image, SIZE - 2, checksum(image[:-2]))
    return bytes(image)


def checksum(content: bytes | bytearray) -> int:
    """Return the checksum of the words before the last one."""
    value = 0xAAAA
    for (word,) in struct.iter_unpack("<H", content):
        value ^= word
        value = (value << 1 | value >> 15) & 0xFFFF
    return value


def is_valid(image: bytes | bytearray) -> bool:
    """Return whether a chip heeds this content. A memory of half the size reads as two halves of the same content."""
    half = len(image) // 2
    if image[:half] == image[half:]:
        image = image[:half]
    return checksum(image[:-2]) == int.from_bytes(image[-2:], "little")


def channel_type(image: bytes | bytearray) -> ChannelType:
    """Return what the pins of the chip are after power-up."""
    return "FIFO" if is_valid(image) and image[0] & 0x0F == _CHANNEL_TYPES["FIFO"] else "UART"


def strings(image: bytes | bytearray) -> tuple[str, str, str]:
    """Return manufacturer, product and serial number, empty where there is none."""
    if not is_valid(image):
        return ("FTDI", "FT232H", "")
    texts = []
    for index in range(3):
        place, length = image[_STRING_TABLE + 2 * index], image[_STRING_TABLE + 2 * index + 1]
        texts.append(image[place + 2 : place + length].decode("utf-16-le", errors="replace"))
    return (texts[0], texts[1], texts[2] if image[0x0A] & _HAS_SERIAL_NUMBER else "")

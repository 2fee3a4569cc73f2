"""The chips with a high-speed FIFO, and what sets one apart from the other.

An FT2232H is two chips in one: each port has FIFOs, a latency timer and endpoints of its own, and is an interface of
the one USB device. Only port A has the synchronous FIFO, which takes what port B would need: while it is on, B is dead.
The EEPROM says of each port what its pins are; its layout is near that of the FT232H, and not the same.
"""

from __future__ import annotations

import msgspec


class ChipKind(msgspec.Struct, frozen=True):
    """One kind of chip."""

    name: str
    url_name: str
    """Name in pyftdi's URLs, as in ``ftdi://ftdi:232h/1``."""
    product_id: int
    release: int
    """bcdDevice. The product alone does not do: an FT2232D, without high speed, has that of the FT2232H."""
    ports: int
    fifo_size: int
    """Bytes of each FIFO of a port."""
    type_mask: int
    """Bits of the EEPROM's byte 0 (port A) or 1 (port B) that choose the mode of the pins. An FT2232H has the choice of
    the PC's driver beside three of them, and an FT232H behind four."""
    memory_model: int
    """Offset in the EEPROM of the kind of memory that it is."""
    strings: int
    """Offset of the strings in the EEPROM."""


FT232H = ChipKind("FT232H", "232h", 0x6014, 0x0900, 1, 1024, 0x0F, 0x1E, 0xA0)
FT2232H = ChipKind("FT2232H", "2232h", 0x6010, 0x0700, 2, 4096, 0x07, 0x18, 0x9A)
KINDS = {kind.release: kind for kind in (FT232H, FT2232H)}
PORT_A, PORT_B = 1, 2
"""Their numbers in URLs, and in the index of a request to the chip."""


def in_endpoint(port: int) -> int:
    """Return the endpoint from which a port is read."""
    return 0x81 + 2 * (port - 1)


def out_endpoint(port: int) -> int:
    """Return the endpoint to which a port is written."""
    return 0x02 + 2 * (port - 1)


def port_of(endpoint: int) -> int:
    """Return the port that an endpoint belongs to."""
    return ((endpoint & 0x0F) + 1) // 2


def port_letter(port: int) -> str:
    """Return what data sheets call a port."""
    return "AB"[port - 1]

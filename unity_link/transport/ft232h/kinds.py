"""The supported chips, FT232H and FT2232H, and their differences.

An FT2232H has two ports. Each port has its own FIFOs, latency timer and endpoints, and is an interface of the USB
device. Only port A has the synchronous FIFO mode, which uses resources of port B: port B does not work meanwhile. The
EEPROM sets the mode of each port's pins; its layout differs slightly from that of the FT232H.
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
    """USB descriptor field bcdDevice. An FT2232D, which has no high speed, has the product ID of the FT2232H."""
    ports: int
    fifo_size: int
    """Size of each FIFO of a port, in bytes."""
    type_mask: int
    """Bits of byte 0 (port A) or 1 (port B) of the EEPROM that select the mode of the pins.

    The next higher bit selects the driver of the PC: bit 3 in an FT2232H, bit 4 in an FT232H.
    """
    memory_model: int
    """Offset in the EEPROM of the byte with the memory's type."""
    strings: int
    """Offset of the strings in the EEPROM."""


FT232H = ChipKind("FT232H", "232h", 0x6014, 0x0900, 1, 1024, 0x0F, 0x1E, 0xA0)
FT2232H = ChipKind("FT2232H", "2232h", 0x6010, 0x0700, 2, 4096, 0x07, 0x18, 0x9A)
KINDS = {kind.release: kind for kind in (FT232H, FT2232H)}
PORT_A, PORT_B = 1, 2
"""Port numbers in URLs, and in the index of a request to the chip."""


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
    """Return the name of a port in data sheets, A or B."""
    return "AB"[port - 1]

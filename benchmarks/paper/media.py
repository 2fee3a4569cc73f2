"""Connections between the paper's chip and gateway: a UART at three rates, an asynchronous and a synchronous FIFO."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

import msgspec

from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.virtual.ft232h.port import Mode as Pins

if TYPE_CHECKING:
    from unity_link.transport.ft232h.eeprom_image import ChannelType

MediumName = Literal[
    "UART, 1 Mbaud",
    "UART, 6 Mbaud",
    "UART, 12 Mbaud",
    "asynchronous FT245",
    "synchronous FT245",
    "shared FT245, CRC-16",
]
_POLYNOMIALS = {8: 0x07, 16: 0x1021}


class Medium(msgspec.Struct, frozen=True):
    """A connection between chip and gateway."""

    name: MediumName
    options: str
    """Options of the URL."""
    mode: Pins
    eeprom: ChannelType
    bytes_per_second: float
    """In each direction, or in both together if the bus carries one direction at a time."""
    fifo_bytes: int = 256
    """Bytes of each FIFO of the gateway."""
    compact: bool = False
    """True if frames of a session are in compact form."""
    crc_bits: int = 8

    def of(self, info: GatewayInfo) -> GatewayInfo:
        """Return the configuration of a gateway like another one, but built for this medium."""
        features = info.features
        if self.mode is Pins.UART:
            # With three wires the gateway cannot stop the host, so the host sends no more than fits into the receive
            # FIFO.
            features &= ~Feature.FLOW_CONTROL
        if self.compact:
            features |= Feature.COMPACT
        return msgspec.structs.replace(
            info,
            receive_fifo_bytes=self.fifo_bytes,
            transmit_fifo_bytes=self.fifo_bytes,
            features=features,
            crc_bits=self.crc_bits,
            crc_polynomial=_POLYNOMIALS[self.crc_bits],
        )

    def with_compact_frames(self) -> Medium:
        """Return the same medium with frames in compact form, which end in another character."""
        return msgspec.structs.replace(
            self, compact=True, options=self.options.replace("event_char=10", "event_char=202")
        )


def _uart(name: MediumName, megabaud: int) -> Medium:
    # Each line end makes the chip send at once, because a UART has no SIWU#.
    options = f"mode=uart&baud={megabaud * 1_000_000}&event_char=10"
    return Medium(name, options, Pins.UART, "UART", megabaud * 1e5)


UART_12 = _uart("UART, 12 Mbaud", 12)
ASYNCHRONOUS = Medium("asynchronous FT245", "", Pins.FIFO, "FIFO", 8e6)
MEDIA = (
    _uart("UART, 1 Mbaud", 1),
    _uart("UART, 6 Mbaud", 6),
    UART_12,
    ASYNCHRONOUS,
    Medium("synchronous FT245", "mode=ft245-sync", Pins.SYNC_FIFO, "FIFO", 40e6),
)
FIFO_SIZES = (16, 256)
SHARED = Medium("shared FT245, CRC-16", "mode=ft245-sync", Pins.SYNC_FIFO, "FIFO", 8e6, crc_bits=16)
"""Both directions share the rate that each direction of the asynchronous FIFO has; with a longer CRC."""
FORMED = (ASYNCHRONOUS, UART_12, SHARED)
"""Media on which text and compact frames are compared."""

"""What the paper's chip and gateway can be joined by: a UART of three rates, an asynchronous and a synchronous FIFO."""

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
    """A way between chip and gateway."""

    name: MediumName
    options: str
    """Options of the URL."""
    mode: Pins
    eeprom: ChannelType
    bytes_per_second: float
    """In each direction; of both together, where the bus carries one at a time."""
    fifo_bytes: int = 256
    """Bytes of each FIFO of the gateway."""
    compact: bool = False
    """True if frames of a session are in compact form."""
    crc_bits: int = 8

    def of(self, info: GatewayInfo) -> GatewayInfo:
        """Return what a gateway says of itself that is built for it, and is otherwise like another one."""
        features = info.features
        if self.mode is Pins.UART:
            # Three wires: nothing stops the host, so it sends no more than the receive FIFO holds.
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
        """Return the same with frames in compact form, which end in another character."""
        return msgspec.structs.replace(
            self, compact=True, options=self.options.replace("event_char=10", "event_char=202")
        )


def _uart(name: MediumName, megabaud: int) -> Medium:
    # Each line end is sent at once: there is no SIWU# on a UART.
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
"""Both directions share what the asynchronous FIFO has for each, with a longer check."""
FORMED = (ASYNCHRONOUS, UART_12, SHARED)
"""Media on which text and compact frames are compared."""

"""A bus that records every access in the order in which the gateway made it, to check "exactly once"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual import VirtualGateway
from unity_link.virtual.bus import AccessError

if TYPE_CHECKING:
    from unity_link.virtual import BareGateway

WRITTEN = 0x100
"""Address for writes to a gateway of `gateway_of_short_laps`, after the addresses that are read."""


class RecordedBus:
    """A memory on the bus of a gateway, at the addresses from 0 on.

    Args:
        gateway: the device is attached to this gateway.
        size: number of addresses.
        failing: addresses of which every access ends in a bus error; the attempt is recorded too.
    """

    def __init__(self, gateway: BareGateway, size: int = 256, failing: frozenset[int] = frozenset()) -> None:
        self.words: dict[int, int] = {}
        self.writes: list[tuple[int, int]] = []
        """Address and word of every write, in order."""
        self.reads: list[int] = []
        """Address of every read, in order."""
        self._failing = failing
        gateway.attach(self, range(size))

    def read(self, offset: int, now: float) -> int:
        self.reads.append(offset)
        if offset in self._failing:
            raise AccessError(ErrorCode.BUS_ERROR)
        return self.words.get(offset, 0)

    def write(self, offset: int, value: int, now: float) -> None:
        self.writes.append((offset, value))
        if offset in self._failing:
            raise AccessError(ErrorCode.BUS_ERROR)
        self.words[offset] = value


def gateway_of_short_laps() -> tuple[VirtualGateway, RecordedBus]:
    """Return a gateway with IDs of two digits, and its recorded bus; each word below 256 equals its address."""
    gateway = VirtualGateway(GatewayInfo(id_digits=2, address_bits=16))
    bus = RecordedBus(gateway, WRITTEN + 1)
    bus.words |= {address: address for address in range(256)}
    return gateway, bus

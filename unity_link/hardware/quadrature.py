"""Decoders of incremental encoders: QUADRATURE in a spec.

| offset | read | write |
|---|---|---|
| n | position of channel n in counts, two's complement of WIDTH bits, goes round | sets it, as at an index mark |
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.hardware.channels import Channels, Totals
from unity_link.protocol.numbers import whole_number

if TYPE_CHECKING:
    from unity_link.hardware.bus import Bus


class Quadrature(Channels, word="QUADRATURE"):
    """Decoders of incremental encoders."""

    def __init__(
        self, bus: Bus, base: int = 0, *, size: int | None = None, channels: int | None = None, width: int | None = None
    ) -> None:
        """Stand on a link; the arguments are those of `Channels`."""
        super().__init__(bus, base, size=size, channels=channels, width=width)
        self._totals = Totals(self.width, signed=True)

    async def position(self, channel: int = 0) -> int:
        """Read a position as it stands in the decoder, in counts."""
        return self._totals.number(await self.read(self.offset(channel)))

    async def total(self, channel: int = 0) -> int:
        """Read a position, and go on where the decoder goes round; it must move by less than half a turn in between."""
        return self._totals.follow(channel, await self.read(self.offset(channel)))

    async def set(self, channel: int = 0, position: int = 0) -> None:
        """Set a position, in counts."""
        position = whole_number(position, "a position")
        most = 1 << self.width - 1
        if not -most <= position < most:
            raise ArgumentError(f"position {position} was given, {-most} to {most - 1} expected")
        self._totals.forget(channel)
        await self.write(self.offset(channel), position % (1 << self.width))

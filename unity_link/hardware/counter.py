"""Counters of events: COUNTER in a spec.

| offset | read | write |
|---|---|---|
| n | count of channel n, unsigned, goes round after WIDTH bits | sets it |
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.hardware.channels import Channels, Totals

if TYPE_CHECKING:
    from unity_link.hardware.bus import Bus


class Counter(Channels, word="COUNTER"):
    """Counters of events."""

    def __init__(
        self, bus: Bus, base: int = 0, *, size: int | None = None, channels: int | None = None, width: int | None = None
    ) -> None:
        """Stand on a link; the arguments are those of `Channels`."""
        super().__init__(bus, base, size=size, channels=channels, width=width)
        self._totals = Totals(self.width, signed=False)

    async def count(self, channel: int = 0) -> int:
        """Read a count as it stands in the counter."""
        return self._totals.number(await self.read(self.offset(channel)))

    async def total(self, channel: int = 0) -> int:
        """Read a count, and go on where the counter goes round; it must move by less than half a turn between calls."""
        return self._totals.follow(channel, await self.read(self.offset(channel)))

    async def set(self, channel: int = 0, count: int = 0) -> None:
        """Set a counter."""
        self._totals.forget(channel)
        await self.write(self.offset(channel), count)

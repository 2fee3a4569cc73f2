"""The common part of modules of several like channels: channel n is the word at offset n."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.hardware.module import Module
from unity_link.protocol.numbers import whole_number

if TYPE_CHECKING:
    from unity_link.hardware.bus import Bus


class Channels(Module):
    """A module with one word for each channel."""

    def __init__(
        self, bus: Bus, base: int = 0, *, size: int | None = None, channels: int | None = None, width: int | None = None
    ) -> None:
        """Stand on a link.

        Args:
            bus: as for `Module`.
            base: address of channel 0.
            size: as for `Module`.
            channels: how many there are; None for as many as the size allows, or one.
            width: bits of a channel's number; None for those of a word.

        Raises:
            ArgumentError: where the channels do not fit into the size, or the width not into a word.
        """
        self.channels = channels if channels is not None else size or 1
        super().__init__(bus, base, size=self.channels if size is None else size)
        word = bus.gateway.data_bits
        self.width = word if width is None else width
        if not 1 <= self.width <= word:
            raise ArgumentError(f"{self!r}: a width of {self.width} bits was given, 1 to {word} expected")
        if self.channels > (self.size or 0):
            raise ArgumentError(f"{self!r}: {self.channels} channels do not fit")

    def offset(self, channel: int) -> int:
        """Return the offset of a channel.

        Raises:
            ArgumentError: for a channel that there is not.
        """
        channel = whole_number(channel, "a channel")
        if not 0 <= channel < self.channels:
            raise ArgumentError(f"channel {channel} asked for, 0 to {self.channels - 1} expected")
        return channel


class Totals:
    """Endless counts, made of those that go round after `width` bits.

    Of all that a count may mean, it is the one nearest to the last: right as long as a counter moves by less than half
    a turn between two reads.
    """

    def __init__(self, width: int, *, signed: bool) -> None:
        self._turn = 1 << width
        self._signed = signed
        self._totals: dict[int, int] = {}

    def number(self, word: int) -> int:
        """Return the number that a word says by itself."""
        number = word % self._turn
        return number - self._turn if self._signed and number >= self._turn // 2 else number

    def follow(self, channel: int, word: int) -> int:
        """Return the total of a channel that reads `word` now."""
        last = self._totals.get(channel)
        if last is None:
            total = self.number(word)
        else:
            total = last + (word - last + self._turn // 2) % self._turn - self._turn // 2
        self._totals[channel] = total
        return total

    def forget(self, channel: int) -> None:
        """Begin anew, as after the counter was set."""
        self._totals.pop(channel, None)

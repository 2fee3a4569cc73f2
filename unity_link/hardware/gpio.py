"""Pins: GPIO in a spec.

| offset | read | write |
|---|---|---|
| 0 | level of each pin | level of each output |
| 1 | direction of each pin, 1 for an output | the same; only where directions can change |

Pin n is bit n. An output reads back its own level, so that masked writes change single pins.
"""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING

from unity_link.errors import AnswerLostError, ArgumentError
from unity_link.hardware.module import Module
from unity_link.protocol.numbers import whole_number

if TYPE_CHECKING:
    from unity_link.hardware.bus import Bus

LEVELS, DIRECTIONS = 0, 1


class Gpio(Module, word="GPIO"):
    """Pins."""

    def __init__(self, bus: Bus, base: int = 0, *, size: int | None = None, width: int | None = None) -> None:
        """Stand on a link.

        Args:
            bus: as for `Module`.
            base: address of the levels.
            size: 2, or 1 where directions cannot change.
            width: number of pins; None for as many as a word has bits.
        """
        super().__init__(bus, base, size=size)
        self.width = bus.gateway.data_bits if width is None else width

    async def levels(self) -> int:
        """Read the levels of all pins, pin n as bit n."""
        return await self.read(LEVELS) & self._all

    async def set_levels(self, levels: int) -> None:
        """Set all outputs at once."""
        levels = whole_number(levels, "a set of levels")
        if not 0 <= levels <= self._all:
            raise ArgumentError(f"levels {levels:#x} were given for {self.width} pins, 0 to {self._all:#x} expected")
        await self.write(LEVELS, levels)

    async def get(self, pin: int) -> bool:
        """Read the level of one pin."""
        return bool(await self.read(LEVELS) & self._bit(pin))

    async def set(self, pin: int, level: bool) -> None:  # noqa: FBT001  (a level is what a bool is)
        """Set one output, and leave the others as they are."""
        await self._write_bit(LEVELS, pin, level)

    async def set_direction(self, pin: int, *, output: bool) -> None:
        """Make a pin an output or an input."""
        await self._write_bit(DIRECTIONS, pin, output)

    @property
    def _all(self) -> int:
        return (1 << self.width) - 1

    def _bit(self, pin: int) -> int:
        pin = whole_number(pin, "a pin")
        if not 0 <= pin < self.width:
            raise ArgumentError(f"pin {pin} asked for, 0 to {self.width - 1} expected")
        return 1 << pin

    async def _write_bit(self, offset: int, pin: int, value: bool) -> None:  # noqa: FBT001
        bit = self._bit(pin)
        # It was executed then; only the old word was lost, which is not needed.
        with contextlib.suppress(AnswerLostError):
            await self.write_masked(offset, bit if value else 0, bit)

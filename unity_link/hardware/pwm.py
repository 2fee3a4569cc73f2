"""Pulse-width modulated outputs: PWM in a spec.

| offset | read and write |
|---|---|
| n | duty of channel n: 0 is always low, 2^WIDTH - 1 always high |
"""

from __future__ import annotations

from unity_link.errors import ArgumentError
from unity_link.hardware.channels import Channels
from unity_link.protocol.numbers import real_number


class Pwm(Channels, word="PWM"):
    """Pulse-width modulated outputs."""

    @property
    def steps(self) -> int:
        """The duty that is always high."""
        return (1 << self.width) - 1

    async def set(self, channel: int, duty: float) -> None:
        """Set the duty of a channel, 0 to 1; it goes to the nearest step."""
        await self.write(self.offset(channel), self._step(duty))

    async def get(self, channel: int) -> float:
        """Read the duty of a channel, 0 to 1."""
        return (await self.read(self.offset(channel)) & self.steps) / self.steps

    async def set_all(self, *duties: float) -> None:
        """Set the duties of the channels from 0 on, in one atomic bus transaction."""
        self.offset(len(duties) - 1)
        await self.write_block(0, [self._step(duty) for duty in duties])

    def _step(self, duty: float) -> int:
        if not 0 <= real_number(duty, "a duty is a number from 0 to 1") <= 1:
            raise ArgumentError(f"a duty of {duty} was given, 0 to 1 expected")
        return round(float(duty) * self.steps)

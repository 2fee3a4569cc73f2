"""The gateware itself at the chip's pins: every clock cycle of it passes in modelled time.

The pins are modelled, at the rate of the datasheet for each direction; what the gateware does with a byte, and when it
pulses SIWU#, is its own doing. It is run in slices of at most `SLICE` seconds: at the beginning of one, it is shown
what the chip holds, and at its end, the chip gets what came out. A slice ends early behind a pulse of SIWU#, and when
nothing moves any more, so that a request that comes alone is timed to the cycle. While nothing can move, no cycle is
spent.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.virtual.ft232h.port import Mode

if TYPE_CHECKING:
    from unity_link.virtual.ft232h.port import ChipPort
    from unity_link.virtual.rtl import RtlGateway
    from unity_link.virtual.rtl.gateway import Passage

SLICE = 8e-6
"""Seconds: 64 bytes at 8 MB/s, as `board.STEP`."""
_LOOKS = 4
"""Slices in which nothing moves, behind bytes: to set up a group of 255 words takes the gateware longer than one."""


class RtlBoard:
    """The compiled gateware at the pins of an asynchronous FIFO.

    Args:
        gateway: its `info` must say the clock that it is to run at.
        bytes_per_second: rate of the pins, for each direction (`Timing.fifo_bytes_per_second`).
    """

    def __init__(self, gateway: RtlGateway, bytes_per_second: float) -> None:
        self.gateway = gateway
        gateway.set_pace(bytes_per_second)
        self._clock_hz = gateway.info.clock_hz
        self._slice_cycles = round(SLICE * self._clock_hz)
        self._slice_bytes = round(SLICE * bytes_per_second)
        self._passing: tuple[float, Passage] | None = None
        """Instant at which a slice ends, and the bytes that pass the pins in it."""
        self._moving = False
        """True if the gateway may go on without anything new at the pins."""
        self._looks = 0
        """Slices that are still looked at although nothing moves."""
        self._blocked = False
        """True if what it has to send has found no room."""
        self._began = (0.0, 0)
        """Instant and cycle at which the last slice began."""

    @property
    def next_due(self) -> float | None:
        """Instant at which the slice under way ends."""
        return None if self._passing is None else self._passing[0]

    def time_of(self, cycle: int) -> float:
        """Return the time of a clock cycle of the last slice."""
        began, first = self._began
        return began + (cycle - first) / self._clock_hz

    def advance(self, port: ChipPort, now: float) -> None:
        """End the slice that is done, and begin the next, if there is anything to do."""
        if self._passing is not None:
            end, passage = self._passing
            if end > now:
                return
            self._passing = None
            self._end(port, passage)
        moving = self._moving or port.readable or (self._blocked and port.room)
        if port.mode is Mode.FIFO and (moving or self.gateway.ticking):
            self._begin(port, now)

    def _begin(self, port: ChipPort, now: float) -> None:
        room = port.room
        self._began = (now, self.gateway.cycles)
        passage = self.gateway.pass_pins(bytes(port.to_fpga[: self._slice_bytes]), self._slice_cycles, room)
        self._looks = _LOOKS if passage.taken else max(0, self._looks - 1)
        self._moving = passage.flush or passage.cycles == self._slice_cycles or self._looks > 0
        self._blocked = len(passage.sent) == room
        # What came too late to move anything, like a byte for a full FIFO, is looked at again after a while.
        self._passing = (now + (passage.cycles or self._slice_cycles) / self._clock_hz, passage)

    def _end(self, port: ChipPort, passage: Passage) -> None:
        port.read(passage.taken)
        if passage.sent:
            port.write(passage.sent)
        if passage.flush:
            port.send_immediate()

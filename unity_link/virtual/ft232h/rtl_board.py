"""Compiled gateware at the chip's pins: each of its clock cycles takes simulated time.

The pins are modelled, with the data sheet's rate in each direction; the gateware itself processes the bytes and pulses
SIWU#. It runs in slices of at most `SLICE` seconds. At the beginning of a slice the gateware gets the bytes in the
chip, and at its end the chip gets the gateware's bytes. A slice ends early after a pulse of SIWU#, and when no bytes
move any more, so that a single request is timed to the cycle. No cycles are computed while no bytes can move.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.virtual.ft232h.port import Mode

if TYPE_CHECKING:
    from unity_link.virtual.ft232h.port import ChipPort
    from unity_link.virtual.rtl import RtlGateway
    from unity_link.virtual.rtl.gateway import Passage

SLICE = 8e-6
"""Length of a slice in seconds: 64 bytes at 8 MB/s, as in `board.STEP`."""
_LOOKS = 4
"""Number of further slices after the last byte, because the gateware may need longer than one slice to answer.

For example, setting up a group of 255 words takes more than one slice.
"""


class RtlBoard:
    """The compiled gateware at the pins of an asynchronous FIFO.

    Args:
        gateway: the gateware; its `info` has the frequency of its clock.
        bytes_per_second: rate of the pins in each direction (`Timing.fifo_bytes_per_second`).
    """

    def __init__(self, gateway: RtlGateway, bytes_per_second: float) -> None:
        self.gateway = gateway
        gateway.set_pace(bytes_per_second)
        self._clock_hz = gateway.info.clock_hz
        self._slice_cycles = round(SLICE * self._clock_hz)
        self._slice_bytes = round(SLICE * bytes_per_second)
        self._passing: tuple[float, Passage] | None = None
        """End of the current slice, and the bytes that pass the pins in it."""
        self._moving = False
        """True if the gateway may have more to do without new bytes at the pins."""
        self._looks = 0
        """Number of further slices to run although no bytes move."""
        self._blocked = False
        """True if the chip had no room for all bytes of the gateway."""
        self._began = (0.0, 0)
        """Time and cycle at which the last slice began."""

    @property
    def next_due(self) -> float | None:
        """Time at which the current slice ends; None if there is none."""
        return None if self._passing is None else self._passing[0]

    def time_of(self, cycle: int) -> float:
        """Return the time of a clock cycle of the last slice."""
        began, first = self._began
        return began + (cycle - first) / self._clock_hz

    def advance(self, port: ChipPort, now: float) -> None:
        """End a finished slice, and begin the next one if the gateway has something to do."""
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
        # A slice without any cycle, as for a full FIFO, still takes the time of a whole slice before the next try.
        self._passing = (now + (passage.cycles or self._slice_cycles) / self._clock_hz, passage)

    def _end(self, port: ChipPort, passage: Passage) -> None:
        port.read(passage.taken)
        if passage.sent:
            port.write(passage.sent)
        if passage.flush:
            port.send_immediate()

"""A line with a limited rate, and the FIFOs at the gateway's end.

Only the line takes time, not the gateway. A response fills the transmit FIFO as fast as the line empties it; the
gateway processes the next request once the last byte of the response is in the FIFO. Until then samples wait in the
gateway, and requests in the receive FIFO. If this FIFO is full, further bytes wait with flow control, and are lost
without it (error 09). Bytes passed to `receive` arrive at once, which is the worst case for the FIFO. A frame of the
gateway arrives at the host after its last byte has passed the line.
"""

from __future__ import annotations

import math
from collections import deque
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.frames import end_of_first
from unity_link.virtual.gateway import Gateway

if TYPE_CHECKING:
    from collections.abc import Callable, MutableMapping

    from unity_link.virtual.gateway import BareGateway


class SlowLine(Gateway):
    """A gateway at a line with a limited rate.

    Args:
        gateway: the gateway; its `info` has the sizes of its FIFOs, and whether it has flow control.
        bytes_per_second: rate of the line from the gateway to the host.

    Raises:
        ArgumentError: if the rate is not positive and finite.
    """

    def __init__(self, gateway: BareGateway, bytes_per_second: float) -> None:
        if not 0 < bytes_per_second < math.inf:
            raise ArgumentError(f"bytes_per_second={bytes_per_second} is no rate: more than 0 was expected")
        self.info = gateway.info
        self.wake: Callable[[], None] = lambda: None
        gateway.wake = self._pass_on_wake
        self._gateway = gateway
        self._rate = bytes_per_second
        self._loses = Feature.FLOW_CONTROL not in self.info.features
        self._fifo = bytearray()
        self._lost_at: list[int] = []
        """Indexes of the bytes in the FIFO before which bytes were lost."""
        self._sent_at = float("-inf")
        """Time at which the line will have sent all bytes."""
        self._under_way: deque[tuple[float, bytes]] = deque()
        """Bytes in the transmit FIFO or on the line, with the times at which they arrive."""

    def _pass_on_wake(self) -> None:
        self.wake()

    @property
    def memory(self) -> MutableMapping[int, int]:
        """Words of the gateway's memory, by address."""
        return self._gateway.memory

    @property
    def waiting(self) -> int:
        """Number of bytes in the receive FIFO, and with flow control also before it."""
        return len(self._fifo)

    @property
    def refusal(self) -> str:
        """Reason why the robot refuses all accesses; empty if it does not."""
        return self._gateway.refusal

    @property
    def leaves_time_out(self) -> bool:
        """True if the gateway skips time for which it is too late."""
        return self._gateway.leaves_time_out

    @property
    def next_due(self) -> float | None:
        """Time at which a sample is due, a request can be processed, or a frame arrives."""
        arrival = self._under_way[0][0] if self._under_way else None
        times = (self._next_step, arrival)
        return min((time for time in times if time is not None), default=None)

    def receive(self, data: bytes, now: float) -> bytes:
        """Send bytes to the gateway at the time `now` in seconds, and return the bytes that arrive from it."""
        before = self.advance(now)
        self._fifo += data
        self._look_at_requests(now)
        limit = self.info.receive_fifo_bytes
        if self._loses and len(self._fifo) > limit:
            del self._fifo[limit:]
            if limit not in self._lost_at:
                self._lost_at.append(limit)
        return before + self._arrived(now)

    def advance(self, now: float, room: int | None = None) -> bytes:
        """Advance to the time `now`, and return the bytes that arrive from the gateway; see `Gateway`."""
        while (due := self._next_step) is not None and due <= now:
            self._step(due, room)
        self._step(now, room)
        return self._arrived(now)

    def _arrived(self, now: float) -> bytes:
        arrived = bytearray()
        while self._under_way and self._under_way[0][0] <= now:
            arrived += self._under_way.popleft()[1]
        return bytes(arrived)

    @property
    def _next_step(self) -> float | None:
        """Time of the next event at the gateway's end of the line."""
        free = self._free_at if self._fifo else None
        times = (free, self._gateway.next_due)
        return min((time for time in times if time is not None), default=None)

    @property
    def _free_at(self) -> float:
        """Time at which the last byte of the last response is in the transmit FIFO."""
        return self._sent_at - self.info.transmit_fifo_bytes / self._rate

    def _step(self, now: float, room: int | None) -> None:
        free = 0
        # Pending requests come first: the gateway alternates samples with its responses.
        if now >= self._free_at and not self._fifo:
            free = max(1, self.info.transmit_fifo_bytes - int(max(0.0, self._sent_at - now) * self._rate))
        published = self._gateway.advance(now, free if room is None else min(free, room))
        self._occupy(published, now)
        self._look_at_requests(now)

    def _look_at_requests(self, now: float) -> None:
        """Pass requests to the gateway until a response fills the transmit FIFO."""
        while self._fifo and now >= self._free_at:
            size = end_of_first(self._fifo) or len(self._fifo)
            if self._lost_at and self._lost_at[0] < size:
                self._gateway.overflow()
            self._lost_at = [place - size for place in self._lost_at if place >= size]
            frame = bytes(self._fifo[:size])
            del self._fifo[:size]
            self._occupy(self._gateway.receive(frame, now), now)

    def _occupy(self, data: bytes, now: float) -> None:
        """Put bytes on the line, after the bytes before them."""
        if data:
            self._sent_at = max(self._sent_at, now) + len(data) / self._rate
            self._under_way.append((self._sent_at, data))

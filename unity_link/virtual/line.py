"""A line of limited rate, with the FIFOs at the gateway's end of it.

The gateway itself is quick; what takes time is the line. A response enters the transmit FIFO as fast as the line
empties it, and the gateway looks at the next request when the last byte of the response is in. Meanwhile samples wait
in the gateway, and requests gather in the receive FIFO. Where there is no flow control, bytes that find it full are
lost (error 09); else they wait. Bytes given to `receive` arrive at once, which is the worst that a line can do to the
FIFO; a frame of the gateway arrives at the host when the line has carried its last byte.
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
    """A gateway behind a line of limited rate.

    Args:
        gateway: what is behind the line. The sizes of its FIFOs and whether it has flow control are in its `info`.
        bytes_per_second: rate of the line from the gateway to the host.

    Raises:
        ArgumentError: for a rate of 0 or less, or without an end.
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
        """Places in the FIFO before which bytes were lost."""
        self._sent_at = float("-inf")
        """Instant at which the line will have sent everything."""
        self._under_way: deque[tuple[float, bytes]] = deque()
        """Bytes in the transmit FIFO or on the line, and the instant at which they arrive."""

    def _pass_on_wake(self) -> None:
        self.wake()

    @property
    def memory(self) -> MutableMapping[int, int]:
        """The words behind the gateway, by address."""
        return self._gateway.memory

    @property
    def waiting(self) -> int:
        """Bytes in the receive FIFO and, with flow control, before it."""
        return len(self._fifo)

    @property
    def refusal(self) -> str:
        """The reason why the robot behind the bus refuses each access; empty where it does not."""
        return self._gateway.refusal

    @property
    def leaves_time_out(self) -> bool:
        """Return whether the gateway leaves out what it is too late for."""
        return self._gateway.leaves_time_out

    @property
    def next_due(self) -> float | None:
        """Instant at which a sample is due, a request can be looked at, or a frame arrives."""
        arrival = self._under_way[0][0] if self._under_way else None
        times = (self._next_step, arrival)
        return min((time for time in times if time is not None), default=None)

    def receive(self, data: bytes, now: float) -> bytes:
        """Take bytes at the time `now`, in seconds, and give those that arrive back."""
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
        """Let time pass, and return the bytes that arrive; see `Gateway`."""
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
        """Instant of the next event at the gateway's end of the line."""
        free = self._free_at if self._fifo else None
        times = (free, self._gateway.next_due)
        return min((time for time in times if time is not None), default=None)

    @property
    def _free_at(self) -> float:
        """Instant at which the last byte of the last response is in the transmit FIFO."""
        return self._sent_at - self.info.transmit_fifo_bytes / self._rate

    def _step(self, now: float, room: int | None) -> None:
        free = 0
        # Requests that waited go first: the gateway lets samples take turns with its responses.
        if now >= self._free_at and not self._fifo:
            free = max(1, self.info.transmit_fifo_bytes - int(max(0.0, self._sent_at - now) * self._rate))
        published = self._gateway.advance(now, free if room is None else min(free, room))
        self._occupy(published, now)
        self._look_at_requests(now)

    def _look_at_requests(self, now: float) -> None:
        """Hand on requests until a response fills the transmit FIFO."""
        while self._fifo and now >= self._free_at:
            size = end_of_first(self._fifo) or len(self._fifo)
            if self._lost_at and self._lost_at[0] < size:
                self._gateway.overflow()
            self._lost_at = [place - size for place in self._lost_at if place >= size]
            frame = bytes(self._fifo[:size])
            del self._fifo[:size]
            self._occupy(self._gateway.receive(frame, now), now)

    def _occupy(self, data: bytes, now: float) -> None:
        """Put bytes on the line."""
        if data:
            self._sent_at = max(self._sent_at, now) + len(data) / self._rate
            self._under_way.append((self._sent_at, data))

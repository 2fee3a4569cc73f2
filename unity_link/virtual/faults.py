"""Repeatable faults: addresses whose accesses fail, and bytes or datagrams that are lost, damaged, doubled or late.

`Failing` is a device whose accesses fail. `Noise` damages one stream of bytes; `NoisyLine` is a gateway with `Noise` in
both directions to another gateway. `Straying` loses, doubles and delays datagrams; `unity_link.virtual.udp_relay` has
one for each direction.
"""

from __future__ import annotations

import heapq
import itertools
import math
import random
import sys
from bisect import bisect
from collections import deque
from typing import TYPE_CHECKING, Any, Generic

from typing_extensions import TypeVar

from unity_link.errors import ArgumentError
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.transport.buffered import HIGH_WATER
from unity_link.virtual.bus import AccessError
from unity_link.virtual.gateway import Gateway

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, MutableMapping

T = TypeVar("T", default=Any)


class Failing:
    """A device whose accesses all fail, by default with a timeout, as at an address without a slave."""

    def __init__(self, code: ErrorCode = ErrorCode.BUS_TIMEOUT) -> None:
        self._code = code

    def read(self, offset: int, now: float) -> int:  # noqa: ARG002  (all fail)
        """Fail."""
        raise AccessError(self._code)

    def write(self, offset: int, value: int, now: float) -> None:  # noqa: ARG002
        """Fail."""
        raise AccessError(self._code)


class Noise:
    """Damages a stream of bytes; with the same seed always the same bytes, however the stream is divided.

    Args:
        seed: seed of the random faults.
        loss: probability that a byte is lost.
        flip: probability that one bit of a byte is inverted.
        double: probability that a byte arrives twice.
        stall: probability that the stream pauses before a byte.
        stall_seconds: length of a pause in seconds.

    Raises:
        ArgumentError: if a probability is not from 0 to 1, or their sum exceeds 1.
    """

    def __init__(
        self,
        seed: int = 0,
        *,
        loss: float = 0.0,
        flip: float = 0.0,
        double: float = 0.0,
        stall: float = 0.0,
        stall_seconds: float = 0.01,
    ) -> None:
        chances = {"loss": loss, "flip": flip, "double": double, "stall": stall}
        self._total = _total(chances)
        self.stall_seconds = stall_seconds
        self._kinds = list(chances)
        self._bounds = list(itertools.accumulate(chances.values()))
        self._log_of_passing = math.log(1 - self._total) if self._total < 1 else -math.inf
        self._random = random.Random(seed)  # noqa: S311  (it must be repeatable)
        self._until_next = self._draw()

    def spoil(self, data: bytes) -> list[bytes]:
        """Return the damaged `data`, divided at the pauses of the stream; mostly one piece."""
        index, size = self._until_next, len(data)
        if index >= size:
            self._until_next = index - size
            return [data]
        pieces, piece, position = [], bytearray(), 0
        while index < size:
            piece += data[position:index]
            kind = self._kinds[bisect(self._bounds, self._random.random() * self._total, 0, len(self._bounds) - 1)]
            if kind == "flip":
                piece.append(data[index] ^ 1 << self._random.randrange(8))
            elif kind != "loss":
                if kind == "stall":
                    pieces.append(bytes(piece))
                    piece.clear()
                piece += data[index : index + 1] * (2 if kind == "double" else 1)
            position = index + 1
            index = position + self._draw()
        self._until_next = index - size
        piece += data[position:]
        return [*pieces, bytes(piece)]

    def _draw(self) -> int:
        """Return the number of bytes without a fault before the next byte with one."""
        if self._total == 0:
            return sys.maxsize
        if self._total == 1:
            return 0
        return int(math.log(1 - self._random.random()) / self._log_of_passing)


class Straying(Generic[T]):
    """Faults of a network in one direction: each datagram may be lost, late, or arrive twice.

    Lateness is a number of datagrams, not a time: 1 to `latest` later datagrams overtake a late one. The logarithm of
    this number is uniformly distributed, so that neighbours change places as often as datagrams are very late. The same
    seed always has the same faults.

    Args:
        seed: seed of the random faults.
        loss: probability that a datagram never arrives.
        late: probability that a datagram is late.
        double: probability that a datagram arrives at once, and a second time late.
        latest: largest number of datagrams that overtake a late one.

    Raises:
        ArgumentError: if a probability is not from 0 to 1, or their sum exceeds 1.
    """

    def __init__(
        self, seed: int = 0, *, loss: float = 0.0, late: float = 0.0, double: float = 0.0, latest: int = 1000
    ) -> None:
        chances = {"loss": loss, "late": late, "double": double}
        self._kinds = [*chances, ""]
        self._weights = [*chances.values(), 1 - _total(chances)]
        self._latest = latest
        self._random = random.Random(seed)  # noqa: S311  (it must be repeatable)
        self._numbers = itertools.count()
        self._late: list[tuple[int, int, T]] = []
        """Heap of late datagrams: number of the datagram after which each arrives, its own number, and its data."""

    def carry(self, datagram: T) -> list[T]:
        """Return the datagrams that arrive when a datagram is sent."""
        number = next(self._numbers)
        kind = self._random.choices(self._kinds, self._weights)[0]
        if kind in ("late", "double"):
            lateness = round(self._latest ** self._random.random())
            heapq.heappush(self._late, (number + lateness, number, datagram))
        arrived = [] if kind in ("loss", "late") else [datagram]
        while self._late and self._late[0][0] <= number:
            arrived.append(heapq.heappop(self._late)[2])
        return arrived


def _total(chances: Mapping[str, float]) -> float:
    """Return the sum of probabilities."""
    for name, chance in chances.items():
        if not 0 <= chance <= 1:
            raise ArgumentError(f"{name}={chance} is no probability: 0 to 1 was expected")
    total = sum(chances.values())
    if total > 1:
        raise ArgumentError(f"the probabilities of {', '.join(chances)} are {total} together: at most 1")
    return total


def _earlier(one: float | None, other: float | None) -> float | None:
    """Return the earlier of two times; None is never."""
    return one if other is None or (one is not None and one <= other) else other


class _Direction:
    """One direction of a line: bytes that a pause holds back, with the times at which they arrive."""

    def __init__(self, noise: Noise) -> None:
        self._noise = noise
        self._held: deque[tuple[float, bytes]] = deque()
        self.held_bytes = 0

    def put(self, data: bytes, now: float) -> None:
        due = max(now, self._held[-1][0]) if self._held else now
        for piece in self._noise.spoil(data):
            self._held.append((due, piece))
            self.held_bytes += len(piece)
            due += self._noise.stall_seconds

    @property
    def next_due(self) -> float | None:
        return self._held[0][0] if self._held else None

    def take(self, now: float) -> bytes:
        held, taken = self._held, b""
        while held and held[0][0] <= now:
            taken += held.popleft()[1]
        self.held_bytes -= len(taken)
        return taken


class NoisyLine(Gateway):
    """A gateway at a line that damages bytes.

    Args:
        gateway: the gateway at the other end of the line.
        towards: faults of the bytes to the gateway.
        back: faults of the bytes from the gateway.
    """

    def __init__(self, gateway: Gateway, towards: Noise, back: Noise) -> None:
        self.info = gateway.info
        self.wake: Callable[[], None] = lambda: None
        gateway.wake = self._pass_on_wake
        self._gateway = gateway
        self._towards = _Direction(towards)
        self._back = _Direction(back)

    def _pass_on_wake(self) -> None:
        self.wake()

    @property
    def memory(self) -> MutableMapping[int, int]:
        """Words of the gateway's memory, by address."""
        return self._gateway.memory

    @property
    def waiting(self) -> int:
        """Number of bytes on the line in either direction, and unprocessed in the gateway."""
        return self._towards.held_bytes + self._gateway.waiting + self._back.held_bytes

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
        """Time at which the gateway has something to do, or a pause of the line ends."""
        return _earlier(self._next_at_gateway(), self._back.next_due)

    def receive(self, data: bytes, now: float) -> bytes:
        """Send bytes to the gateway at the time `now` in seconds, and return the bytes that arrive from it at once."""
        self._towards.put(data, now)
        return self.advance(now)

    def advance(self, now: float, room: int | None = None) -> bytes:
        """Advance to the time `now`, and return the bytes that arrive from the gateway; see `Gateway`."""
        arrived, reached = b"", -math.inf
        while (due := self._next_at_gateway()) is not None and due <= now:
            self._step(due, None if room is None else room - len(arrived))
            arrived += self._back.take(now)
            reached = due
        if reached < now:
            self._step(now, None if room is None else room - len(arrived))
            arrived += self._back.take(now)
        return arrived

    def _next_at_gateway(self) -> float | None:
        """Return the time of the next event at the gateway's end of the line."""
        return _earlier(self._towards.next_due, self._gateway.next_due)

    def _step(self, now: float, room: int | None) -> None:
        data = self._towards.take(now)
        if self._back.held_bytes >= HIGH_WATER:
            # While the line pauses, it accepts no bytes, so that the gateway loses its samples.
            room = 0
        # `receive` advances the gateway without a limit of bytes, so apply the limit before.
        if room is not None or not data:
            self._send_back(self._gateway.advance(now, room), now)
        if data:
            self._send_back(self._gateway.receive(data, now), now)

    def _send_back(self, data: bytes, now: float) -> None:
        if data:
            self._back.put(data, now)

"""Faults, on purpose and repeatably: addresses that fail, and bytes that are lost, damaged or doubled.

`Failing` is a device, attached where the bus is to fail. `Noise` spoils one stream of bytes; `NoisyLine` puts two of
them between a gateway and its host, and is a gateway itself. `Straying` does to datagrams what networks do;
`unity_link.virtual.udp_relay` puts two of them between sockets.
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
    """A device of which every access fails, by default as where nothing answers."""

    def __init__(self, code: ErrorCode = ErrorCode.BUS_TIMEOUT) -> None:
        self._code = code

    def read(self, offset: int, now: float) -> int:  # noqa: ARG002  (all fail)
        """Fail."""
        raise AccessError(self._code)

    def write(self, offset: int, value: int, now: float) -> None:  # noqa: ARG002
        """Fail."""
        raise AccessError(self._code)


class Noise:
    """Spoils a stream of bytes; the same seed spoils the same bytes, however the stream is cut into pieces.

    Args:
        seed: chooses one of many courses of events.
        loss: probability that a byte is lost.
        flip: probability that one of its bits is inverted.
        double: probability that it arrives twice.
        stall: probability that the stream stands still before it.
        stall_seconds: for how long.

    Raises:
        ArgumentError: for probabilities that are none, or more than 1 in total.
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
        self._random = random.Random(seed)  # noqa: S311  (repeatable is what is wanted)
        self._until_next = self._draw()

    def spoil(self, data: bytes) -> list[bytes]:
        """Return what becomes of `data`: pieces between which the stream stands still; most often it is one."""
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
        """Return how many bytes pass before the next that does not pass unharmed."""
        if self._total == 0:
            return sys.maxsize
        if self._total == 1:
            return 0
        return int(math.log(1 - self._random.random()) / self._log_of_passing)


class Straying(Generic[T]):
    """Faults that a network makes to the datagrams of one direction: it loses, doubles and delays them, each by itself.

    How late a datagram is counts in others, not in seconds: from one to `latest` of them overtake it, each power of two
    as likely as the next. So neighbours change their places, and what is late by thousands comes as well. The same seed
    does the same to the same datagrams.

    Args:
        seed: chooses one of many courses of events.
        loss: probability that a datagram never arrives.
        late: probability that it is late.
        double: probability that it arrives at once, and once more, late.
        latest: how many others a late one lets pass at most.

    Raises:
        ArgumentError: for probabilities that are none, or more than 1 in total.
    """

    def __init__(
        self, seed: int = 0, *, loss: float = 0.0, late: float = 0.0, double: float = 0.0, latest: int = 1000
    ) -> None:
        chances = {"loss": loss, "late": late, "double": double}
        self._kinds = [*chances, ""]
        self._weights = [*chances.values(), 1 - _total(chances)]
        self._latest = latest
        self._random = random.Random(seed)  # noqa: S311  (repeatable is what is wanted)
        self._numbers = itertools.count()
        self._late: list[tuple[int, int, T]] = []
        """Datagrams that are still on their way, each with the number of the datagram behind which it arrives."""

    def carry(self, datagram: T) -> list[T]:
        """Return what arrives when a datagram is sent."""
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
    """Return the earlier of two times, of which each may be none."""
    return one if other is None or (one is not None and one <= other) else other


class _Direction:
    """One direction of a line: what is held back, and until when."""

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
    """A gateway behind a line that spoils bytes.

    Args:
        gateway: what is behind the line.
        towards: what happens to the bytes on their way to the gateway.
        back: what happens to those that it sends.
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
        """The words behind the gateway, by address."""
        return self._gateway.memory

    @property
    def waiting(self) -> int:
        """Bytes that have not reached the gateway yet, or wait there, or on their way back."""
        return self._towards.held_bytes + self._gateway.waiting + self._back.held_bytes

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
        """Instant at which the gateway has something to do, or a stall ends."""
        return _earlier(self._next_at_gateway(), self._back.next_due)

    def receive(self, data: bytes, now: float) -> bytes:
        """Take bytes at the time `now`, in seconds, and give those that arrive back at once."""
        self._towards.put(data, now)
        return self.advance(now)

    def advance(self, now: float, room: int | None = None) -> bytes:
        """Let time pass, and return the bytes that arrive back; see `Gateway`."""
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
        """Return the instant of the next event at the gateway's end of the line."""
        return _earlier(self._towards.next_due, self._gateway.next_due)

    def _step(self, now: float, room: int | None) -> None:
        data = self._towards.take(now)
        if self._back.held_bytes >= HIGH_WATER:
            # A line that stands still takes nothing from a gateway, which loses its samples.
            room = 0
        # To receive, a gateway advances first; it does not know of a medium without room.
        if room is not None or not data:
            self._send_back(self._gateway.advance(now, room), now)
        if data:
            self._send_back(self._gateway.receive(data, now), now)

    def _send_back(self, data: bytes, now: float) -> None:
        if data:
            self._back.put(data, now)

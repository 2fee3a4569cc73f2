"""The Python host on simulated time, without a link: the reference for clients in other languages."""

from __future__ import annotations

import itertools
import math
import re
from collections import deque
from typing import TYPE_CHECKING, Any

from unity_link.errors import Outcome, UnansweredError
from unity_link.protocol.host.requests import Request
from unity_link.protocol.host.session import Session
from unity_link.protocol.host.trial import FIRST_IDS
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.virtual.faults import Noise, NoisyLine

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.protocol.host.events import Events
    from unity_link.virtual import Gateway

PATIENCE = 600.0
"""Simulated seconds after which a host is considered to hang."""
LATENCY = 0.001
"""Seconds until an answer of the gateway arrives."""


class LineOfASession:
    """A line that spoils bytes from the first request of a session on, so that two hosts meet the same noise.

    It stores the bytes sent in the session. The trial of the compact form comes before, without noise.
    """

    def __init__(self, gateway: Gateway, seed: int, **chances: float) -> None:
        self._clean = gateway
        self._noisy = NoisyLine(gateway, Noise(2 * seed, **chances), Noise(2 * seed + 1, **chances))
        self.sent: list[tuple[float, bytes]] = []
        """Bytes sent in the session, with the instants in seconds."""
        self.chosen: tuple[int, int] | None = None
        """Number that chooses the first ID of the session, and the session's own number."""
        self._is_tried = True

    def receive(self, data: bytes, now: float) -> bytes:
        """Pass bytes to the gateway; return the bytes that arrive from it."""
        if self.chosen is not None and self._is_tried:
            if data:
                self.sent.append((now, data))
            return self._noisy.receive(data, now)
        self._is_tried |= data != b""
        if begun := re.search(rb"K([0-9A-F]{2,3})([0-9A-F]{4})[0-9A-F]{4}\n", data):
            first, asked = int(begun[1], 16), int(begun[2], 16)
            number = asked & GatewayInfo().last_session
            self._is_tried = asked == number
            self.chosen = first if self._is_tried else FIRST_IDS[len(begun[1])].index(first), number
        return self._clean.receive(data, now)


class SimulatedHost:
    """A session of the Python host.

    Args:
        gateway: function of bytes and the time; returns the bytes that arrive after `LATENCY`.
        shortest_timeout: of the medium, in seconds.
        chosen: number that chooses the first ID of the session, and the session's own number.
    """

    def __init__(
        self, gateway: Callable[[bytes, float], bytes], shortest_timeout: float, chosen: tuple[int, int] = (0, 1)
    ) -> None:
        self.now = 0.0
        first, number = chosen
        # Session numbers begin with 1.
        draws = itertools.chain([first], itertools.count(number - 1))
        self.session = Session(None, lambda: next(draws), compact=True)
        self._gateway = gateway
        self._under_way: deque[tuple[float, bytes]] = deque()
        self._events: Events = []
        self._output = b""
        self.session.connect(0.0, shortest_timeout)
        while not self.session.is_open:
            self._turn()

    def do(self, *sources: Any) -> None:
        """Execute all requests, as many at a time as the window allows."""
        left = {id(source) for source in sources}
        for source in sources:
            self._events += self.session.submit(source, self.now)
        give_up = self.now + PATIENCE
        while left:
            assert self.now < give_up, "the host does not end"
            self._turn()
            left.difference_update(map(id, self._events))
            self._events.clear()
        # Take the output now, so that later requests begin a new burst.
        self._output += self.session.take_output()

    def request(self, command: str, *fields: int, words: int = 0) -> Request:
        """Return a request with an address field and word fields."""
        info = self.session.codec.info
        widths = (info.address_digits, *[info.data_digits] * len(fields[1:]))
        text = b"".join(b"%0*X" % (width, field) for width, field in zip(widths, fields, strict=True))
        return Request(self.session.codec, command, text, words * info.data_digits)

    def _turn(self) -> None:
        """Send the pending output; advance the time to the next arrival or deadline."""
        output, self._output = self._output + self.session.take_output(), b""
        answer = self._gateway(output, self.now)
        if answer:
            self._under_way.append((self.now + LATENCY, answer))
        deadline = self.session.deadline
        until = self.now + 1.0 if deadline is None else deadline
        if self._under_way and self._under_way[0][0] <= until:
            self.now, arrived = self._under_way.popleft()
            self._events += self.session.receive(arrived, self.now)
            return
        self.now = max(until, math.nextafter(self.now, math.inf))
        self._events += self.session.expire(self.now)


def outcome_of(request: Request) -> Outcome | None:
    """Return the outcome of a request that ended without an answer, or None if it was answered."""
    return request.error.outcome if isinstance(request.error, UnansweredError) else None

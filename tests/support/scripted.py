"""A gateway to whose output a test adds bytes, divided into reads as the test needs."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING

from support.valve import Valve

if TYPE_CHECKING:
    from collections.abc import Iterable

    from unity_link.virtual import Gateway

APART = 1e-4
"""Seconds between two reads; on simulated time such reads are never joined."""


class Scripted(Valve):
    """Passes bytes to and from a gateway, and sends the host the bytes given to `say` too."""

    def __init__(self, gateway: Gateway) -> None:
        self._pieces: deque[tuple[float, bytes]] = deque()
        self._now = 0.0
        self.before_answer = b""
        """Bytes that the host receives once, just before the next answer."""
        super().__init__(gateway)
        self.wake = lambda: None

    def say(self, pieces: Iterable[bytes]) -> float:
        """Deliver each of `pieces` in its own read, from the next instant on; return the seconds until the end."""
        due = self._now
        for piece in pieces:
            due += APART
            self._pieces.append((due, piece))
        self.wake()
        return due - self._now + APART

    @property
    def next_due(self) -> float | None:
        own = self._pieces[0][0] if self._pieces else None
        return min((due for due in (own, self.gateway.next_due) if due is not None), default=None)

    def receive(self, data: bytes, now: float) -> bytes:
        self._now = max(self._now, now)
        answer = super().receive(data, now)
        if answer:
            answer, self.before_answer = self.before_answer + answer, b""
        return answer

    def advance(self, now: float, room: int | None = None) -> bytes:
        self._now = max(self._now, now)
        said = b""
        while self._pieces and self._pieces[0][0] <= now:
            said += self._pieces.popleft()[1]
        return self.gateway.advance(now, room) + said

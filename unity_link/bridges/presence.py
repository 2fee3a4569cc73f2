"""The state of a gateway, away or there, as its link and its samples show it.

A link whose connection is lost says so itself. Behind a server the connection stays while the gateway is away, and all
that tells is that samples do not come which come by themselves. Where none do, the gateway is asked: a server answers
by an error while it is away.
"""

from __future__ import annotations

import asyncio
import contextlib
from typing import TYPE_CHECKING, NamedTuple

from unity_link.errors import BusTimeoutError, UnityLinkError

if TYPE_CHECKING:
    from unity_link.data import Group
    from unity_link.link.link import Link

SILENCE = 1.0
"""Seconds without a sample after which a gateway is away, at least."""
PERIODS = 5
"""Periods of the quickest samples after which it is, at least."""
LONGEST_LOOK = 0.2
"""Seconds between two looks that count as silence, at most: in the rest this program stood still, so that it polled
nothing and took nothing of what came."""
ASK_EVERY = 0.2
"""Seconds between questions to a gateway of which no samples tell."""


def silence_at(rate_hz: float) -> float:
    """Return after how many seconds without a sample a gateway is away that gives so many a second."""
    return max(SILENCE, PERIODS / rate_hz)


def rate_whatever_happens(group: Group, rate_hz: float | None) -> float | None:
    """Return the rate of a group's samples; None where they come of changes or requests, so that silence says nothing.

    Args:
        group: what is sampled.
        rate_hz: of a subscription of it.
    """
    return None if group.model is not None and group.model.on_change else rate_hz


class Interruption(NamedTuple):
    """Time for which a gateway was away, in seconds of the clock of who looks."""

    began: float
    """Instant at which it was heard last."""
    ended: float


class Presence:
    """State of a gateway, away or there, for callers that look repeatedly.

    Args:
        link: to the gateway.
        now: the time.
    """

    def __init__(self, link: Link, now: float) -> None:
        self.away_since: float | None = None
        """Instant at which it was heard last; None while it is there."""
        self._link = link
        self._reconnections = link.statistics.reconnections
        self._signs = self._answers = 0
        self._asks = self._refuses = False
        self._silence = 0.0
        self._heard = self._looked = now

    def look(self, now: float, samples: int, rate_hz: float | None) -> Interruption | None:
        """Look how things stand; return an interruption that has ended.

        Args:
            now: the time.
            samples: that have come until now.
            rate_hz: of the quickest that come by themselves; None where none do, so that `ask` has to run.
        """
        self._asks = rate_hz is None
        signs = samples if rate_hz is not None else self._answers
        came, self._signs = signs != self._signs, signs
        self._silence = 0.0 if came else self._silence + min(now - self._looked, LONGEST_LOOK)
        is_silent = self._refuses if rate_hz is None else self._silence > silence_at(rate_hz)
        before, self._reconnections = self._reconnections, self._link.statistics.reconnections
        if self.away_since is None and (is_silent or not self._link.connected or self._reconnections != before):
            self.away_since = self._heard
        self._looked = now
        if came:
            self._heard = now
        if self.away_since is None or not self._link.connected or not came:
            return None
        began, self.away_since = self.away_since, None
        return Interruption(began, now)

    async def ask(self) -> None:
        """Ask the gateway again and again, while no samples come by themselves."""
        while True:
            await asyncio.sleep(ASK_EVERY)
            # A link that has ended for good says so to all others.
            with contextlib.suppress(UnityLinkError):
                if self._asks:
                    await self._ask()

    async def _ask(self) -> None:
        try:
            await self._link._ping()  # noqa: SLF001  (of no use to programs, whose calls tell the same)
        except BusTimeoutError:
            self._refuses = True
        else:
            self._refuses = False
            self._answers += 1

"""The connection monitor: whether a gateway is away, as its link and its samples show.

If a connection is lost, the link reports that. Behind a server the connection remains while the gateway is away. Then
the only sign is that periodic samples stop arriving. Without periodic samples, the monitor sends requests: while the
gateway is away, a server answers them with an error.
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
"""Least number of seconds without a sample after which a gateway counts as away."""
PERIODS = 5
"""Least number of periods of the fastest samples, without a sample, after which a gateway counts as away."""
LONGEST_LOOK = 0.2
"""Most seconds between two calls of `look` that count as silence: in a longer time this program was suspended, and did
not read the samples that arrived."""
ASK_EVERY = 0.2
"""Seconds between requests to a gateway without periodic samples."""


def longest_silence(rate_hz: float) -> float:
    """Return the seconds without a sample after which a gateway with this sample rate counts as away."""
    return max(SILENCE, PERIODS / rate_hz)


def periodic_rate(group: Group, rate_hz: float | None) -> float | None:
    """Return the rate of a group's samples; None if they are only sent on changes, so that silence means nothing.

    Args:
        group: the group.
        rate_hz: rate of a subscription to it; None if it is not periodic.
    """
    return None if group.model is not None and group.model.on_change else rate_hz


class Interruption(NamedTuple):
    """Time for which a gateway was away, in seconds of the caller's clock."""

    began: float
    """Instant at which the last sample or answer arrived."""
    ended: float


class Presence:
    """State of a gateway, away or not, for callers that check repeatedly.

    Args:
        link: link to the gateway.
        now: present time in seconds.
    """

    def __init__(self, link: Link, now: float) -> None:
        self.away_since: float | None = None
        """Instant of the last sample or answer before the gateway went away; None if it is not away."""
        self._link = link
        self._reconnections = link.statistics.reconnections
        self._signs = self._answers = 0
        self._asks = self._refuses = False
        self._silence = 0.0
        self._heard = self._looked = now

    def look(self, now: float, samples: int, rate_hz: float | None) -> Interruption | None:
        """Update the state; return an interruption that has ended, if any.

        Args:
            now: present time in seconds.
            samples: number of samples received so far.
            rate_hz: rate of the fastest periodic samples; None if there are none: then `ask` must be running.
        """
        self._asks = rate_hz is None
        signs = samples if rate_hz is not None else self._answers
        came, self._signs = signs != self._signs, signs
        self._silence = 0.0 if came else self._silence + min(now - self._looked, LONGEST_LOOK)
        is_silent = self._refuses if rate_hz is None else self._silence > longest_silence(rate_hz)
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
        """Send requests repeatedly, while there are no periodic samples."""
        while True:
            await asyncio.sleep(ASK_EVERY)
            # If the link has ended for good, its other users get that error.
            with contextlib.suppress(UnityLinkError):
                if self._asks:
                    await self._ask()

    async def _ask(self) -> None:
        try:
            await self._link._ping()  # noqa: SLF001  (private: programs need no ping)
        except BusTimeoutError:
            self._refuses = True
        else:
            self._refuses = False
            self._answers += 1

"""Instants at which samples were taken, on this machine's clock, as exact as a link allows.

The gateway's clock tells the distances exactly, and nothing of where it began; an arrival tells the instant, late by as
much as the sample was on its way. Of all samples the one that was on its way for the shortest time says best when the
gateway's clock was 0, which grows old by as much as quartzes drift apart. What is said of samples follows that slowly:
instants never jump, and never go back in a group, unless this machine's clock is set.
"""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

import numpy as np

from unity_link.link.freshness import MOST_DRIFT

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from unity_link.data import Batch
    from unity_link.link.link import Link

TURN_ON = 10.0
"""Seconds that a sample has come too early: the gateway's clock was read a turn on."""
SET = 0.1
"""Seconds by which this machine's clock was set; less is what passes between two looks at two clocks."""


class SteadyClock:
    """The time since 1970 as this machine's clock told it at first: later settings of that clock are not followed."""

    def __init__(self) -> None:
        self.began = time.time() - time.monotonic()
        """Instant since 1970 at which `time.monotonic` was 0."""
        self._last: dict[int, float] = {}

    def now(self) -> float:
        """Return the instant in seconds since 1970."""
        return self.began + time.monotonic()

    def arrivals(self, group: int, batch: Batch) -> NDArray[np.float64]:
        """Return when the samples of a batch arrived, shape (samples,); they do not go back in a group.

        Where the machine's clock was set while they arrived, their distances within the batch are lost.
        """
        latest = self.began + batch.at
        instants: NDArray[np.float64] = np.clip(
            latest + (batch.arrived - batch.arrived[-1]), self._last.get(group, -np.inf), latest
        )
        self._last[group] = float(instants[-1])
        return instants


class GatewayTime:
    """The time of one gateway; for all its groups the same, so that they stay side by side.

    Args:
        link: to the gateway; with each new session the gateway may have been reset, and its clock with it.
        most_slew: seconds a second by which instants are corrected, below 1: with more of it they are true sooner, and
            with less of it their distances are.
        clock: tells arrivals; without it they are those of this machine's clock, which may be set meanwhile.
    """

    def __init__(self, link: Link, *, most_slew: float = MOST_DRIFT, clock: SteadyClock | None = None) -> None:
        self._link = link
        self._clock = clock
        self._most_slew = most_slew
        self._session = -1
        self._monotonic_began = 0.0
        """Instant since 1970 at which `time.monotonic` was 0."""
        self._earliest = 0.0
        """Instant by `time.monotonic` at which the gateway's clock was 0, by the quickest of all samples."""
        self._epoch = 0.0
        """The same, as it is used."""
        self._latest = 0.0
        self._last: dict[int, float] = {}

    def instants(self, group: int, batch: Batch) -> NDArray[np.float64]:
        """Return the instants of samples of a group, in seconds since 1970, shape (samples,).

        Of samples without timestamps, that is when they arrived.
        """
        if batch.time is None:
            return batch.arrived if self._clock is None else self._clock.arrivals(group, batch)
        began = float(batch.arrived[-1]) - batch.at if self._clock is None else self._clock.began
        if abs(began - self._monotonic_began) > SET:
            self._monotonic_began = began
            self._last.clear()
        self._correct(float(batch.time[-1]), batch.at)
        epoch = self._monotonic_began + self._epoch
        instants: NDArray[np.float64] = np.maximum(epoch + batch.time, self._last.get(group, -np.inf))
        self._last[group] = float(instants[-1])
        return instants

    def _correct(self, time: float, arrived: float) -> None:
        seen, session = arrived - time, self._link.statistics.reconnections
        if session != self._session or seen < self._earliest - TURN_ON:
            self._session, self._latest = session, time
            self._epoch = self._earliest = seen
            self._last.clear()
            return
        passed = max(0.0, time - self._latest)
        self._latest += passed
        self._earliest = min(seen, self._earliest + MOST_DRIFT * passed)
        most = self._most_slew * passed
        self._epoch += min(max(self._earliest - self._epoch, -most), most)

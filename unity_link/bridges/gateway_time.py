"""Instants at which samples were taken, in terms of this machine's clock, as exact as a link allows.

The gateway's clock gives the exact differences between samples, but not its own zero. The arrival of a sample is later
than its instant by the sample's delay. So the sample with the shortest delay gives the best estimate of the zero of the
gateway's clock, which grows inaccurate by the drift between the clocks. The instants follow the estimate slowly: they
never jump, and never go back within a group, unless this machine's clock is set.
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
"""Seconds by which a sample has arrived too early: the timestamps were unwrapped one turn too late."""
SET = 0.1
"""Least change, in seconds, that counts as a setting of this machine's clock; reading two clocks takes less."""


class SteadyClock:
    """The time since 1970 by this machine's clock at the start; later settings of that clock have no effect."""

    def __init__(self) -> None:
        self.began = time.time() - time.monotonic()
        """Instant in seconds since 1970 at which `time.monotonic` was 0."""
        self._last: dict[int, float] = {}

    def now(self) -> float:
        """Return the present instant in seconds since 1970."""
        return self.began + time.monotonic()

    def arrivals(self, group: int, batch: Batch) -> NDArray[np.float64]:
        """Return the arrival times of a batch's samples, shape (samples,); within a group they never go back.

        If this machine's clock was set while they arrived, their differences within the batch are wrong.
        """
        latest = self.began + batch.at
        instants: NDArray[np.float64] = np.clip(
            latest + (batch.arrived - batch.arrived[-1]), self._last.get(group, -np.inf), latest
        )
        self._last[group] = float(instants[-1])
        return instants


class GatewayTime:
    """The time of one gateway, the same for all its groups, so that these stay aligned.

    Args:
        link: link to the gateway. In a new session the gateway may have been reset, and its clock with it.
        most_slew: seconds per second by which instants are corrected, below 1. A higher rate corrects the instants
            sooner, a lower one keeps the differences between them more exact.
        clock: clock for arrivals; None for this machine's clock, which may be set in the meantime.
    """

    def __init__(self, link: Link, *, most_slew: float = MOST_DRIFT, clock: SteadyClock | None = None) -> None:
        self._link = link
        self._clock = clock
        self._most_slew = most_slew
        self._session = -1
        self._monotonic_began = 0.0
        """Instant in seconds since 1970 at which `time.monotonic` was 0."""
        self._earliest = 0.0
        """Instant of `time.monotonic` at which the gateway's clock was 0, by the sample with the least delay."""
        self._epoch = 0.0
        """The same estimate, followed slowly; `instants` uses this one."""
        self._latest = 0.0
        self._last: dict[int, float] = {}

    def instants(self, group: int, batch: Batch) -> NDArray[np.float64]:
        """Return the instants of samples of a group, in seconds since 1970, shape (samples,).

        For samples without timestamps, these are their arrival times.
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

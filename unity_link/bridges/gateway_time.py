"""When samples were taken, by this machine's clock, as true as a link can tell.

The gateway's clock tells the distances exactly, and nothing of where it began; an arrival tells the instant, late by as
much as the link is late. So the first sample sets where the gateway's clock began, and later arrivals correct that
slowly, for no two quartzes agree: by at most `MOST_SLEW`, so that instants never jump, and never go back in a group.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from unity_link.data import Batch

MOST_SLEW = 1e-4
"""Seconds a second: more than quartzes differ by."""
ANOTHER_CLOCK = 1.0
"""Seconds of difference that no delay explains: the gateway was reset, or its counter was read another turn on."""


class GatewayTime:
    """The time of one gateway; for all its groups the same, so that they stay side by side."""

    def __init__(self) -> None:
        self._epoch: float | None = None
        self._latest = 0.0
        self._last: dict[int, float] = {}

    def instants(self, group: int, batch: Batch) -> NDArray[np.float64]:
        """Give the instants of samples of a group, in seconds since 1970, shape (samples,).

        Of samples without timestamps, that is when they arrived.
        """
        if batch.time is None:
            return batch.arrived
        self._correct(float(batch.time[-1]), float(batch.arrived[-1]))
        assert self._epoch is not None
        instants: NDArray[np.float64] = np.maximum(self._epoch + batch.time, self._last.get(group, 0.0))
        self._last[group] = float(instants[-1])
        return instants

    def _correct(self, time: float, arrived: float) -> None:
        seen = arrived - time
        if self._epoch is None or abs(seen - self._epoch) > ANOTHER_CLOCK:
            self._epoch, self._latest = seen, time
            self._last.clear()
        elif time > self._latest:
            most = MOST_SLEW * (time - self._latest)
            self._epoch += min(max(seen - self._epoch, -most), most)
            self._latest = time

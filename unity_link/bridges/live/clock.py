"""The gateway's time on this machine's clock."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from unity_link.data import Batch

_DRIFT = 200e-6
"""How much two oscillators may differ: twice what cheap ones do."""
_SET_ANEW = 1.0
"""Seconds by which time must go back for the gateway to have begun anew."""


class GatewayClock:
    """Places samples in time, steadily: a sample that was long on its way does not stand later for it.

    Of all samples the one that was on its way for the shortest time says best when the gateway's clock was 0; that
    may grow old by as much as the clocks drift apart.
    """

    def __init__(self) -> None:
        self._epoch: float | None = None
        self._last = 0.0

    def place(self, batch: Batch) -> NDArray[np.float64]:
        """Give the instants of samples in seconds since 1970, shape (samples,); as they arrived without timestamps."""
        if batch.time is None:
            return batch.arrived
        time = float(batch.time[-1])
        seen = float(batch.arrived[-1]) - time
        if self._epoch is None or time < self._last - _SET_ANEW:
            self._epoch = seen
        else:
            self._epoch = min(seen, self._epoch + _DRIFT * max(0.0, time - self._last))
        self._last = time
        return batch.time + self._epoch

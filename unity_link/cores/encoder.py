"""An incremental encoder on `sim:`: a model of the plant sets its position, and the rest follows."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from unity_link.cores import Model

if TYPE_CHECKING:
    from unity_link.cores import Surroundings
    from unity_link.spec.model import ComponentSpec

LONGEST = 0.5
"""Seconds without a count after which the velocity is 0."""


class EncoderModel(Model):
    """Velocity by the time between counts, and the index once a turn; the pins are not looked at."""

    def __init__(self, component: ComponentSpec, part: Any, around: Surroundings) -> None:
        super().__init__(component, part, around)
        signals = {signal.name: signal for signal in component.signals}
        self._count = abs(signals["position"].kind.scale)
        """One count, in the unit of the position."""
        self._turn = float(component.arguments.get("COUNTS", 0)) * self._count
        self._limits = signals["velocity"].limits
        self._position = 0.0
        self._at = 0
        """Cycle of the last count."""
        self._between = 0.0
        """Seconds between the last two counts."""

    def reset(self) -> None:
        """Begin at 0."""
        part = self.part
        part.position, part.velocity, part.index_position, part.index_count, part.errors = 0, 0, 0, 0, 0
        self._position, self._at = 0.0, self.around.now

    def step(self, dt: float) -> None:  # noqa: ARG002  (the clock says more)
        """Follow the position."""
        part, moved = self.part, self.part.position - self._position
        passed = (self.around.now - self._at) / self.around.clock_hz
        if not moved:
            # There was no count for so long, so it is no quicker than one in that time. A plant moves in steps, between
            # which there is none either.
            if passed > 1.5 * self._between and part.velocity:
                most = self._count / passed if passed < LONGEST else 0.0
                self._set_velocity(math.copysign(min(abs(part.velocity), most), part.velocity))
            return
        if passed > 0:
            self._between = passed
            self._set_velocity(moved / passed)
        if self._turn and (turns := self._turns(part.position) - self._turns(self._position)):
            part.index_count = (part.index_count + abs(turns)) % (1 << 16)
            at = max(self._turns(part.position), self._turns(self._position)) * self._turn
            part.index_position = at
        self._position, self._at = part.position, self.around.now

    def _turns(self, position: float) -> int:
        return math.floor(position / self._turn + 1e-9)

    def _set_velocity(self, velocity: float) -> None:
        low, high = self._limits
        self.part.velocity = min(max(velocity, low), high)

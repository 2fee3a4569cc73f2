"""An incremental encoder in a simulation: a model of the plant sets its position, and the rest, or its pins, follow."""

from __future__ import annotations

import logging
import math
from typing import TYPE_CHECKING, Any

from unity_link.cores import AtPins, Model

if TYPE_CHECKING:
    from unity_link.cores import Pins, Surroundings
    from unity_link.spec.model import ComponentSpec

_LOG = logging.getLogger("unity_link.virtual")
_LEVELS = ((0, 0), (1, 0), (1, 1), (0, 1))
"""Levels of a and b, by the last two bits of a count."""
LONGEST = 0.5
"""Seconds without a count after which the velocity is 0."""


class EncoderModel(Model):
    """Velocity by the time between counts, and the index once a turn, from the position that a plant sets.

    A pin that is `none` is an input of 0: the model counts the edges of the other pins alone, as the entity does.
    """

    def __init__(self, component: ComponentSpec, part: Any, around: Surroundings) -> None:
        super().__init__(component, part, around)
        signals = {signal.name: signal for signal in component.signals}
        self._scale = signals["position"].kind.step
        self._turn = int(float(component.arguments.get("COUNTS", 0))) if self.is_wired("z") else 0
        """Counts from one index to the next; 0 without one."""
        self._limits = signals["velocity"].limits
        self._is_counter = bool(self.generics.get("counter", False))
        self._has_a, self._has_b = self.is_wired("a"), self.is_wired("b")
        self.reset()

    def reset(self) -> None:
        """Begin at 0."""
        part = self.part
        part.position, part.velocity, part.index_position, part.index_count, part.errors = 0, 0, 0, 0, 0
        self._plant = 0
        """Position of the plant, in counts."""
        self._position = 0.0
        """The position that is counted."""
        self._at = self.around.now
        """Cycle of the last count."""
        self._between = 0.0
        """Seconds between the last two counts."""

    def step(self, dt: float) -> None:  # noqa: ARG002  (the clock says more)
        """Follow the position."""
        part, before = self.part, self._plant
        self._plant = round(part.position / self._scale)
        position = self._counted(self._plant - before)
        if not (self._has_a and self._has_b):
            self.around.put("position", position)
        self._see_index(before, position)
        moved, self._position = position - self._position, position
        passed = (self.around.now - self._at) / self.around.clock_hz
        if not moved:
            # There was no count for so long, so it is no quicker than one in that time. A plant moves in steps, between
            # which there is none either.
            if passed > 1.5 * self._between and part.velocity:
                most = abs(self._scale) / passed if passed < LONGEST else 0.0
                self._set_velocity(math.copysign(min(abs(part.velocity), most), part.velocity))
            return
        self._at = self.around.now
        # An axis that swings over one edge has no velocity.
        swings = not self._is_counter and not (self._has_a and self._has_b)
        if passed > 0 and not swings:
            self._between = passed
            self._set_velocity(moved / passed)

    def _counted(self, moved: int) -> float:
        """Return the position that is counted from the pins that there are, when the plant has moved by some counts."""
        if self._has_a and self._has_b:
            return float(self.part.position)
        if self._is_counter:
            # Each edge of a counts upwards.
            return self._position + self._has_a * abs(moved) * self._scale
        return self._of_one_pin(self._plant)

    def _of_one_pin(self, count: int) -> float:
        """Return the position at a count of the plant if one of a and b is at no pin: it swings over one edge."""
        a, b = _LEVELS[count % 4]
        return self._scale * (self._has_a * a - self._has_b * b)

    def _see_index(self, before: int, position: float) -> None:
        """Count the edges of z, which is 1 for one count in a turn, on the way of the plant."""
        if not self._turn or self._plant == before:
            return
        way = 1 if self._plant > before else -1
        # In turns, the first and the last index on the way.
        last, first = way * (way * self._plant // self._turn), way * (way * before // self._turn + 1)
        passed = way * (last - first) + 1
        if passed <= 0:
            return
        part, at = self.part, last * self._turn
        part.index_count = (part.index_count + passed) % (1 << 16)
        if self._has_a and self._has_b:
            part.index_position = at * self._scale
        elif self._is_counter:
            part.index_position = position - self._has_a * abs(self._plant - at) * self._scale
        else:
            part.index_position = self._of_one_pin(at)

    def _set_velocity(self, velocity: float) -> None:
        low, high = self._limits
        self.part.velocity = min(max(velocity, low), high)


class EncoderAtPins(AtPins):
    """Edges of a, b and z at the instants at which the position passes them, a step of the plant later.

    They are as far apart at least as the filter of the core wants them.
    """

    takes = frozenset({"position"})

    def __init__(self, component: ComponentSpec, part: Any, around: Pins) -> None:
        super().__init__(component, part, around)
        self._scale = next(signal for signal in component.signals if signal.name == "position").kind.scale
        self._turn = int(float(component.arguments.get("COUNTS", 0)))
        self._is_counter = bool(self.generics.get("counter", False))
        samples = int(self.generics.get("filter", 15))
        # Levels of a and b last two counts, one of the index lasts one, and in a counter a has both in one.
        counts = 2.0 if self._is_counter else 1.0 if around.has("z") else 0.5
        self._least = counts * (samples + 1)
        """Cycles from one count to the next."""
        self._shown = 0
        """The count of the last edge, which may be one to come."""
        self._edge = 0.0
        """Cycle of that edge."""
        self._counts = 0.0
        """Position behind the last step, in counts."""
        self._passed, self._span = 0.0, 1.0
        """Cycles since the last step of the plant, and of that."""
        self._is_told = False
        if not (around.has("a") and around.has("b")):
            self.takes = frozenset()

    def reset(self) -> None:
        """Go on from the levels at the pins: edges that were to come are lost."""
        self._edge = 0.0
        if not self._is_counter and self.takes:
            at = _LEVELS.index((self.part.a, self.part.b))
            self._shown -= (self._shown - at) % 4

    def step(self, dt: float) -> None:
        """Move the pins as the position has moved, over as much time as that took, which begins now."""
        self._passed += dt * self.around.clock_hz
        if dt or not self.takes:
            # The plant has not moved yet.
            return
        if self._passed:
            self._span, self._passed = self._passed, 0.0
        begin, self._counts = self._counts, self.part.position / self._scale
        missing, moved = round(self._counts) - self._shown, self._counts - begin
        way = 1 if missing > 0 else -1
        end = self.around.now + self._span
        for left in range(abs(missing), 0, -1):
            part = (self._shown + way / 2 - begin) / moved if moved else 0.0
            cycle = max(self.around.now + min(max(part, 0.0), 1.0) * self._span, self._edge + self._least)
            if cycle > end:
                # Counts that are left of an earlier span say nothing of the speed.
                if min(left, abs(moved)) * self._least > self._span:
                    self._tell()
                break
            self._move(way, cycle)

    def _move(self, way: int, cycle: float) -> None:
        """Show the next count from a cycle on."""
        drive, old, new = self.around.drive, self._shown, self._shown + way
        self._shown, self._edge = new, cycle
        if self._is_counter:
            drive("a", 0, int(cycle - self._least / 2))
            drive("b", int(way < 0), int(cycle - self._least / 2))
            drive("a", 1, int(cycle))
        else:
            for pin, before, level in zip(("a", "b"), _LEVELS[old % 4], _LEVELS[new % 4], strict=True):
                if level != before:
                    drive(pin, level, int(cycle))
        if self._turn and self.around.has("z") and 0 in {old % self._turn, new % self._turn}:
            drive("z", int(new % self._turn == 0), int(cycle))

    def _tell(self) -> None:
        if not self._is_told:
            self._is_told = True
            _LOG.warning(
                "%s turns faster than its pins can: its FILTER wants %g clock cycles for a count, which are %.0f "
                "counts a second (told once); a quicker clock_hz or a smaller FILTER lets it turn faster",
                self.component.path,
                self._least,
                self.around.clock_hz / self._least,
            )

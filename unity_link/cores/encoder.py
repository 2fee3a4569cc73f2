"""Incremental encoders in simulations: a plant sets the position; the other signals, or the pins, follow from it."""

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
"""Levels of the pins a and b, by the last two bits of a count."""
LONGEST = 0.5
"""Seconds without a count after which the velocity is 0."""


class EncoderModel(Model):
    """Sets the velocity, from the time between counts, and the index from the position that a plant sets.

    A pin that is `none` is a constant 0: the model counts only the edges of the other pins, as the entity does.
    """

    def __init__(self, component: ComponentSpec, part: Any, around: Surroundings) -> None:
        super().__init__(component, part, around)
        signals = {signal.name: signal for signal in component.signals}
        self._scale = signals["position"].kind.step
        self._turn = int(float(component.arguments.get("COUNTS", 0))) if self.is_wired("z") else 0
        """Counts from one index to the next; 0 without an index."""
        self._limits = signals["velocity"].limits
        self._is_counter = bool(self.generics.get("counter", False))
        self._has_a, self._has_b = self.is_wired("a"), self.is_wired("b")
        self.reset()

    def reset(self) -> None:
        """Set the position and all signals to 0."""
        part = self.part
        part.position, part.velocity, part.index_position, part.index_count, part.errors = 0, 0, 0, 0, 0
        self._plant = 0
        """Position of the plant, in counts."""
        self._position = 0.0
        """Position as the core counts it, in the signal's unit."""
        self._at = self.around.now
        """Clock cycle of the last count."""
        self._between = 0.0
        """Seconds between the last two counts."""

    def step(self, dt: float) -> None:
        """Update the signals from the position of the plant."""
        part, before = self.part, self._plant
        self._plant = round(part.position / self._scale)
        position = self._counted(self._plant - before)
        if not (self._has_a and self._has_b):
            self.around.put("position", position)
        self._see_index(before, position)
        moved, self._position = position - self._position, position
        passed = (self.around.now - self._at) / self.around.clock_hz
        if not moved:
            # Without a count in this time, the speed is at most one count in it. Wait for 1.5 intervals before the
            # velocity is reduced, because a plant moves in steps, and makes no counts in between.
            if passed > 1.5 * self._between and part.velocity:
                most = abs(self._scale) / passed if passed < LONGEST else 0.0
                self._set_velocity(math.copysign(min(abs(part.velocity), most), part.velocity))
            return
        self._at = self.around.now
        # With one of the pins a and b, the position only alternates over one edge: that is no velocity.
        swings = not self._is_counter and not (self._has_a and self._has_b)
        if passed > 0 and not swings:
            self._between = passed
            self._set_velocity(moved / passed)

    def _counted(self, moved: int) -> float:
        """Return the position that the core counts at the connected pins, after the plant has moved by some counts."""
        if self._has_a and self._has_b:
            return float(self.part.position)
        if self._is_counter:
            # Each edge of a counts up.
            return self._position + self._has_a * abs(moved) * self._scale
        return self._of_one_pin(self._plant)

    def _of_one_pin(self, count: int) -> float:
        """Return the position at a count of the plant, with one of a and b connected: it alternates over one edge."""
        a, b = _LEVELS[count % 4]
        return self._scale * (self._has_a * a - self._has_b * b)

    def _see_index(self, before: int, position: float) -> None:
        """Count the edges of z on the plant's way from `before`; z is 1 during one count of each turn."""
        if not self._turn or self._plant == before:
            return
        way = 1 if self._plant > before else -1
        # Numbers of the first and the last turn with an index on the way.
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
    """Drives edges of a, b and z at the instants at which the position passes them, one step of the plant later.

    The edges are at least as far apart as the filter of the core requires.
    """

    takes = frozenset({"position"})

    def __init__(self, component: ComponentSpec, part: Any, around: Pins) -> None:
        super().__init__(component, part, around)
        self._scale = next(signal for signal in component.signals if signal.name == "position").kind.scale
        self._turn = int(float(component.arguments.get("COUNTS", 0)))
        self._is_counter = bool(self.generics.get("counter", False))
        samples = int(self.generics.get("filter", 15))
        # A level of a or b lasts two counts, one of the index lasts one. In a counter, a rises and falls in one count.
        counts = 2.0 if self._is_counter else 1.0 if around.has("z") else 0.5
        self._least = counts * (samples + 1)
        """Least number of clock cycles from one count to the next."""
        self._shown = 0
        """Count of the last edge, which may be in the future."""
        self._edge = 0.0
        """Clock cycle of that edge."""
        self._counts = 0.0
        """Position after the last step of the plant, in counts."""
        self._passed, self._span = 0.0, 1.0
        """Clock cycles since the last step of the plant, and the duration of that step in cycles."""
        self._has_warned = False
        if not (around.has("a") and around.has("b")):
            self.takes = frozenset()

    def reset(self) -> None:
        """Continue from the levels at the pins; edges that were in the future are lost."""
        self._edge = 0.0
        if not self._is_counter and self.takes:
            at = _LEVELS.index((self.part.a, self.part.b))
            self._shown -= (self._shown - at) % 4

    def step(self, dt: float) -> None:
        """Move the pins as the position has moved in the plant's last step, over the same duration, beginning now."""
        self._passed += dt * self.around.clock_hz
        if dt or not self.takes:
            # This call is before the plant's step, so its position has not changed.
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
                # Warn only if the counts of this step alone are too many: others may be left from earlier steps.
                if min(left, abs(moved)) * self._least > self._span:
                    self._warn()
                break
            self._move(way, cycle)

    def _move(self, way: int, cycle: float) -> None:
        """Drive the pins to the next count, from a clock cycle on."""
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

    def _warn(self) -> None:
        if not self._has_warned:
            self._has_warned = True
            _LOG.warning(
                "%s turns faster than its pins can: its FILTER needs %g clock cycles for a count, which are %.0f "
                "counts a second (told once); a higher clock_hz or a smaller FILTER lets it turn faster",
                self.component.path,
                self._least,
                self.around.clock_hz / self._least,
            )

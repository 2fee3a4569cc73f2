"""A joint with a servo, which moves to its set point as fast as its acceleration and the speed set point allow.

The motion since the last change of a set point is computed in closed form, so it does not depend on the times of reads.
"""

from __future__ import annotations

import math

import msgspec


class JointType(msgspec.Struct, frozen=True):
    """Limits of a joint, in counts and seconds."""

    name: str
    unit: str
    counts_per_unit: float
    lowest: int
    highest: int
    most_speed: int
    acceleration: int


class Segment(msgspec.Struct, frozen=True):
    """A part of a motion with constant acceleration."""

    duration: float
    acceleration: float


def plan(distance: float, speed: float, most_speed: float, acceleration: float) -> list[Segment]:
    """Return the fastest motion to a target that ends at rest.

    Args:
        distance: signed distance to the target.
        speed: signed speed at the beginning; it may exceed `most_speed`.
        most_speed: limit of the speed, which a higher initial speed is reduced to; 0 to stop as fast as possible.
        acceleration: magnitude of acceleration and deceleration.
    """
    braking = Segment(abs(speed) / acceleration, -math.copysign(acceleration, speed))
    overshoot = distance - speed * abs(speed) / (2 * acceleration)
    if most_speed == 0 or overshoot == 0:
        return [braking]
    # From here on use the direction of the target: `towards` is the speed, and `ahead` the distance.
    sign = math.copysign(1.0, overshoot)
    towards, ahead = sign * speed, sign * distance
    peak = min(math.sqrt(acceleration * ahead + towards**2 / 2), most_speed)
    if peak == 0:
        # Braking ends so close to the target that rounding cancels the difference of the squares.
        return [braking]
    to_peak = math.copysign(acceleration, peak - towards)
    cruise = ahead - (peak**2 - towards**2) / (2 * to_peak) - peak**2 / (2 * acceleration)
    return [
        Segment(abs(peak - towards) / acceleration, sign * to_peak),
        Segment(max(0.0, cruise) / peak, 0.0),
        Segment(peak / acceleration, -sign * acceleration),
    ]


class ServoJoint:
    """One joint: its set points, and its motion."""

    def __init__(self, kind: JointType) -> None:
        self.kind = kind
        self.set_point = 0
        self.speed_set_point = kind.most_speed // 4
        self._began = 0.0
        self._position = self._speed = 0.0
        self._segments: list[Segment] = []
        self._target = 0.0

    def command(self, now: float, *, set_point: int | None = None, speed_set_point: int | None = None) -> None:
        """Change one or both set points at the time `now` in seconds."""
        self._position, self._speed = self.state(now)
        self._began = now
        if set_point is not None:
            self.set_point = set_point
        if speed_set_point is not None:
            self.speed_set_point = speed_set_point
        kind = self.kind
        target = min(max(self.set_point, kind.lowest), kind.highest)
        most_speed = min(self.speed_set_point, kind.most_speed)
        self._segments = plan(target - self._position, self._speed, most_speed, kind.acceleration)
        self._target = target if most_speed else self._position + self._braking_distance()

    def _braking_distance(self) -> float:
        return self._speed * abs(self._speed) / (2 * self.kind.acceleration)

    def state(self, now: float) -> tuple[float, float]:
        """Return position in counts and speed in counts/s at the time `now` in seconds."""
        left, position, speed = now - self._began, self._position, self._speed
        for segment in self._segments:
            time = min(left, segment.duration)
            position += speed * time + segment.acceleration * time**2 / 2
            speed += segment.acceleration * time
            left -= time
            if left <= 0:
                return position, speed
        return (self._target, 0.0) if self._segments else (position, speed)

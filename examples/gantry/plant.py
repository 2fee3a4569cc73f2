"""Physics of the gantry, for a gateway without one behind it: unity-link simulate ... --model plant.py:Gantry.

Three stepper motors, each with a mass. What they push is a sine of the way by which the rotor is behind the field, so a
motor that is asked for too much loses steps, and one without current stands still by friction alone.
"""

from __future__ import annotations

import math
from typing import Any

from unity_link.virtual.simulated import Fault, SimulatedRobot

STRENGTH = 8000.0
"""Acceleration in mm/s2 that a motor gives at most."""
DAMPING = 25.0
"""Part of what a rotor is slower than its field that it gains in a second, by induction."""
FRICTION = 4000.0
"""Acceleration in mm/s2 that stops what has no current."""
PITCH = 0.8
"""Way in mm from one rest of a rotor to the next: four full steps, which are 32 steps of x and y."""
PARTS = 4
"""Parts of a step of time: a rotor swings 40 times a second."""
STARTS = (4.0, 3.0, 2.0)
"""Places in mm, from its switch, in which each axis stands at first."""
PAPER = 4.0
"""Place of z in mm in which the pen is on the paper."""


class Motor:
    """A stepper motor with the mass that it moves; places in mm from the switch of its axis."""

    def __init__(self, place: float) -> None:
        self.place = self.field = self._start = place
        """Place of the rotor, and that to which the current pulls it, or one a whole number of pitches away."""
        self.speed = 0.0

    def move(self, position: float, dt: float, *, has_current: bool) -> None:
        """Follow the steps of its driver for some time."""
        way, part = self._start + position - self.field, dt / PARTS
        for _ in range(PARTS):
            self.field += way / PARTS
            if has_current:
                push = STRENGTH * math.sin(2 * math.pi * (self.field - self.place) / PITCH)
                push += DAMPING * (way / dt - self.speed)
            else:
                push = -math.copysign(min(FRICTION, abs(self.speed) / part), self.speed)
            self.speed += push * part
            self.place += self.speed * part


class Gantry(SimulatedRobot):
    """The gantry, whose axes stand near their switches at first."""

    pressed = Fault("the e-stop is pressed")
    visitor = Fault("a visitor presses the e-stop in the middle of the second flower")

    drive: Any
    x: Any
    y: Any
    z: Any
    x_home: Any
    y_home: Any
    z_home: Any

    def start(self) -> None:
        """Put the axes in their places."""
        self.motors = [Motor(place) for place in STARTS]
        self.flowers = 0
        self.drawn = 0.0
        """Seconds for which the pen is on the paper."""

    def step(self, dt: float) -> None:
        """Move the axes by the steps of their drivers, which have current while the lease is armed."""
        axes, switches = (self.x, self.y, self.z), (self.x_home, self.y_home, self.z_home)
        for motor, axis, switch in zip(self.motors, axes, switches, strict=True):
            motor.move(axis.position, dt, has_current=self.drive.armed)
            switch.pin = motor.place <= 0
        if self.motors[2].place < PAPER - 0.5:
            self.drawn = 0.0
        else:
            self.flowers += not self.drawn
            self.drawn += dt
        if self.visitor and self.flowers > 1 and self.drawn > 0.8:
            self.pressed = True
        self.drive.estop = not self.pressed

"""Simulated physics of the gantry: unity-link simulate ... --model plant.py:Gantry.

Three stepper motors, each with a mass. The force is the sine of the distance between rotor and field. So a motor that
is driven too hard loses steps, and friction stops a motor without current.
"""

from __future__ import annotations

import math
from typing import Any

from unity_link.virtual.simulated import Fault, SimulatedRobot

STRENGTH = 8000.0
"""Greatest acceleration of a motor, in mm/s2."""
DAMPING = 25.0
"""Damping by induction, in 1/s: acceleration for each mm/s by which the rotor is slower than the field."""
FRICTION = 4000.0
"""Deceleration of a motor without current, in mm/s2."""
PITCH = 0.8
"""Distance in mm between rest positions of a rotor: four full steps, which are 32 steps of x and y."""
PARTS = 4
"""Number of integration steps in a step of time, because a rotor swings 40 times a second."""
STARTS = (4.0, 3.0, 2.0)
"""First position of each axis, in mm from its switch."""
PAPER = 4.0
"""Position of z in mm at which the pen touches the paper."""


class Motor:
    """A stepper motor with its mass; positions are in mm from the switch of its axis."""

    def __init__(self, place: float) -> None:
        self.place = self.field = self._start = place
        """Position of the rotor, and the position to which the current pulls it, modulo the pitch."""
        self.speed = 0.0

    def move(self, position: float, dt: float, *, has_current: bool) -> None:
        """Move the rotor for `dt` seconds, while the driver moves the field to `position`."""
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
    """The gantry. At first its axes are near their switches."""

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
        """Put the axes into their first positions."""
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

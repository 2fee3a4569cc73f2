"""Simulated physics of the balancer: unity-link simulate ... --model plant.py:Balancer.

An inverted pendulum on wheels with geared motors, whose speed follows the voltage.
"""

from __future__ import annotations

import math
from typing import Any

from unity_link.virtual.simulated import Fault, SimulatedRobot

GRAVITY = 9.81
LENGTH = 0.10
"""Metres from the axle to the centre of mass."""
RADIUS = 0.04
"""Metres."""
SPEED = 3.0
"""Speed of a wheel in rad/s for each volt."""
TIME_CONSTANT = 0.05
"""Time constant of the speed of a wheel, in seconds."""
LYING = math.pi / 2
"""Angle in rad of a robot that lies on the floor."""


class Balancer(SimulatedRobot):
    """The robot. It begins 0.1 rad from upright, and a hand holds it until its motors are armed."""

    pushed = Fault("a hand pushes it")

    drive: Any
    left: Any
    right: Any
    wheel: Any
    gyro: Any

    def start(self) -> None:
        """Put the robot into its first position, held by a hand."""
        self.tilt = 0.1
        self.speed = self.angle = self.turning = 0.0
        self.lean = 0.1
        self.is_held = True

    def step(self, dt: float) -> None:
        """Turn the wheels, and let the robot fall."""
        self.is_held = self.is_held and not self.drive.armed
        volts = (self.left.value + self.right.value) / 2
        gain = (SPEED * volts - self.speed) / TIME_CONSTANT
        self.speed += gain * dt
        self.angle += self.speed * dt
        if not self.is_held:
            force = 5.0 if self.pushed else 0.0
            self.turning += (GRAVITY * math.sin(self.lean) - RADIUS * gain * math.cos(self.lean) + force) / LENGTH * dt
            self.lean = min(max(self.lean + self.turning * dt, -LYING), LYING)
            if abs(self.lean) == LYING:
                self.turning = 0.0
        self.tilt, self.gyro[1] = self.lean, min(max(self.turning, -32.0), 32.0)
        self.wheel.position = self.angle

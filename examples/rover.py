"""Simulated rover of `rover.ul`.

unity-link simulate examples/rover.ul --model examples/rover.py:Rover
unity-link record "sim:examples/rover.ul?model=examples/rover.py:Rover" examples/rover.ul -o run.mcap
"""

from __future__ import annotations

from typing import Any

from unity_link.virtual.simulated import Fault, SimulatedRobot

MOST_SPEED = 6.0
"""In rad/s, at full duty and with a full battery."""
TIME_CONSTANT = 0.1
"""Time constant of the speed of a wheel, in seconds."""


class Rover(SimulatedRobot):
    """Two wheels that follow their duty, a battery that they discharge, and a wall 3 rad ahead."""

    blocked = Fault("the left wheel does not turn")

    left: Any
    right: Any

    def start(self) -> None:
        """Fill the battery."""
        self.battery = 12.0

    def step(self, dt: float) -> None:
        """Turn the wheels."""
        for wheel in (self.left, self.right):
            wanted = MOST_SPEED * wheel.duty * self.battery / 12
            if self.blocked and wheel is self.left:
                wanted = 0.0
            wheel.speed += (wanted - wheel.speed) * dt / TIME_CONSTANT
            wheel.position += wheel.speed * dt
            self.battery -= 0.01 * abs(wheel.duty) * dt
        if self.left.position > 3 and self.hits == 0:
            self.hits += 1
            self.trigger("bump")

    def written(self, path: str, value: float) -> None:
        """Keep a log of the lamps."""
        if path == "lamps":
            self.log.put(value)

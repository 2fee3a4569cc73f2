"""Robots of the examples as a user would simulate them, and their specs: for tests of a user's own robot.

Their joints move by themselves until a program writes to them.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

from unity_link.virtual.simulated import SimulatedRobot

EXAMPLES = Path(__file__).parents[2] / "examples"


class Own(NamedTuple):
    """Spec and URL of a user's own robot, and the signals that a test uses."""

    spec: str
    url: str
    position: str
    set_point: str


OWN = {
    "sim": Own(f"{EXAMPLES}/scara.ul", f"sim:{EXAMPLES}/scara.ul?model={__file__}:Scara", "j1.cpos", "j1.pos_sp"),
    "rtl": Own(
        f"{EXAMPLES}/walker.ul",
        f"rtl:{EXAMPLES}/walker.ul?model={__file__}:Walker",
        "legs[0].coxa.cpos",
        "legs[0].coxa.pos_sp",
    ),
}


class Jointed(SimulatedRobot):
    """Joints that move to their set points, each at the speed of its set point of speed."""

    step_seconds = 0.01

    def joints(self) -> list[Any]:
        raise NotImplementedError

    def start(self) -> None:
        self.told = False

    def step(self, dt: float) -> None:
        for joint in self.joints():
            rest = (joint.pos_sp if self.told else 1) - joint.cpos
            speed = joint.spd_sp or 2
            joint.cpos += max(-speed * dt, min(speed * dt, rest))
            joint.spd = speed if rest else 0

    def written(self, path: str, value: float) -> None:
        self.told = True


class Scara(Jointed):
    j1: Any
    j2: Any
    j3: Any
    j4: Any

    def start(self) -> None:
        super().start()
        # Only here: on compiled gateware (the other robot) only programs can write to a set point.
        for joint in self.joints():
            joint.spd_sp = 2

    def joints(self) -> list[Any]:
        return [self.j1, self.j2, self.j3, self.j4]


class Walker(Jointed):
    legs: Any

    def joints(self) -> list[Any]:
        return [joint for leg in self.legs for joint in (leg.coxa, leg.femur, leg.tibia)]

"""Robots of the examples as a user would simulate them, and where they are: for what is to run on a robot of one's own.

Their joints begin to move by themselves, as far as nobody has told them where to.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

from unity_link.virtual.simulated import SimulatedRobot

EXAMPLES = Path(__file__).parents[2] / "examples"


class Own(NamedTuple):
    """Folder of a robot of one's own, and the signals that a test takes."""

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
    """Joints that go to their set points at the speed that they are told."""

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
        # On compiled gateware only programs set what they write, so the other robot does without.
        for joint in self.joints():
            joint.spd_sp = 2

    def joints(self) -> list[Any]:
        return [self.j1, self.j2, self.j3, self.j4]


class Walker(Jointed):
    legs: Any

    def joints(self) -> list[Any]:
        return [joint for leg in self.legs for joint in (leg.coxa, leg.femur, leg.tibia)]

"""The walking robot of `examples/walker.ul`: 18 servo joints, six legs of coxa, femur and tibia.

Joint j = 0..17 (leg j / 3) has four words at 0x10 + 4 j:

| offset | word                                                                             |
|--------|----------------------------------------------------------------------------------|
| 0      | cpos: current position, counts, signed; read only                                |
| 1      | spd: current speed, counts/s, signed; read only                                  |
| 2      | pos_sp: position set point, counts, signed                                       |
| 3      | spd_sp: speed set point, counts/s, unsigned: the maximum speed while moving      |

A revolution has 65536 counts. After power-up all joints are at rest at 0, with a quarter of their maximum as the speed
set point. Writing an actual value is a bus error. `servo` computes the motion of a joint.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from unity_link.virtual.robot import ServoRobot
from unity_link.virtual.servo import JointType

if TYPE_CHECKING:
    from unity_link.virtual.servo import ServoJoint

BASE = 0x10
"""Address of the first joint."""
LEGS = 6
JOINTS_OF_A_LEG = ("coxa", "femur", "tibia")
REGISTERS = 4
COUNTS_PER_RADIAN = 65536 / (2 * math.pi)
MOST_ANGLE, MOST_SPEED = 2, 10
"""Limits of the joints: angle in rad, and speed in rad/s."""


def joint_type(name: str) -> JointType:
    """Return a joint with the limits of this robot; it reaches its maximum speed in 0.1 s."""
    span, speed = round(MOST_ANGLE * COUNTS_PER_RADIAN), round(MOST_SPEED * COUNTS_PER_RADIAN)
    return JointType(name, "rad", COUNTS_PER_RADIAN, -span, span, speed, 10 * speed)


class Walker(ServoRobot):
    """The robot as a device of 72 addresses."""

    NAME = "walker"

    @staticmethod
    def joint_types() -> list[JointType]:
        """Return the types of the joints."""
        return [joint_type(f"leg {leg + 1} {joint}") for leg in range(LEGS) for joint in JOINTS_OF_A_LEG]

    def addresses(self) -> list[int]:
        """Return the addresses of the device, in the order of its offsets."""
        return list(range(BASE, BASE + REGISTERS * len(self.joints)))

    def find(self, offset: int) -> tuple[ServoJoint, int]:
        """Return the joint and the register at an offset."""
        number, register = divmod(offset, REGISTERS)
        return self.joints[number], register

    def read(self, offset: int, now: float) -> int:
        """Return the value of a register."""
        joint, register = self.find(offset)
        position, speed = joint.state(now)
        return (round(position), round(speed), joint.set_point, joint.speed_set_point)[register]

"""The SCARA robot of the Unity-Link paper: four servo joints at the addresses of the paper's figure 1.

| joint n = 1..4 | address  | word                                                             |
|----------------|----------|------------------------------------------------------------------|
| spd            | 80 + n-1 | actual speed, counts/s, unsigned (its magnitude); read only      |
| cpos           | 88 + n-1 | current position, counts, signed; read only                      |
| pos_sp         | 8C + n-1 | position set point, counts, signed                               |
| spd_sp         | 94 + n-1 | speed set point, counts/s, unsigned: the most speed while moving |

Each joint has a motor with a gear, and an encoder with 4000 counts per revolution of the motor. A servo moves the joint
to its set point as fast as the acceleration and the speed set point allow, with a trapezoidal speed profile. A new set
point may be written at any time; the speed then changes without a jump. Set points outside of the joint's soft limits
are clipped to the limits, and speeds to the joint's maximum. After power-up all joints are at rest at 0, with a quarter
of their maximum as the speed set point. Writing an actual value is a bus error. `servo` computes the motion of a joint.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.virtual.robot import ServoRobot
from unity_link.virtual.servo import JointType

if TYPE_CHECKING:
    from unity_link.virtual.servo import ServoJoint

COUNTS_PER_REVOLUTION = 4000
SPEED, POSITION, POSITION_SET_POINT, SPEED_SET_POINT = 0x80, 0x88, 0x8C, 0x94
"""Addresses of joint 1; those of the other joints follow."""


def _joint_type(name: str, unit: str, counts_per_unit: float, span: tuple[float, float], speed: float) -> JointType:
    """Return a joint from limits in its own units; it reaches its maximum speed in 0.2 s."""
    most_speed = round(speed * counts_per_unit)
    lowest, highest = (round(end * counts_per_unit) for end in span)
    return JointType(name, unit, counts_per_unit, lowest, highest, most_speed, 5 * most_speed)


JOINTS = (
    _joint_type("shoulder", "degree", 50 * COUNTS_PER_REVOLUTION / 360, (-130, 130), 300),
    _joint_type("elbow", "degree", 50 * COUNTS_PER_REVOLUTION / 360, (-145, 145), 450),
    # A ball screw with a pitch of 10 mm per revolution.
    _joint_type("z", "mm", COUNTS_PER_REVOLUTION / 10, (0, 150), 500),
    _joint_type("wrist", "degree", 20 * COUNTS_PER_REVOLUTION / 360, (-360, 360), 900),
)


class Scara(ServoRobot):
    """The robot as a device of 16 addresses: four speeds, positions, position set points and speed set points."""

    NAME = "SCARA"

    @staticmethod
    def joint_types() -> tuple[JointType, ...]:
        """Return the types of the joints."""
        return JOINTS

    def addresses(self) -> list[int]:
        """Return the addresses of the device, in the order of its offsets."""
        return [base + joint for base in (SPEED, POSITION, POSITION_SET_POINT, SPEED_SET_POINT) for joint in range(4)]

    def find(self, offset: int) -> tuple[ServoJoint, int]:
        """Return the joint and the register at an offset."""
        register, number = divmod(offset, len(JOINTS))
        return self.joints[number], register

    def read(self, offset: int, now: float) -> int:
        """Return the value of a register."""
        joint, register = self.find(offset)
        if register == 0:
            return round(abs(joint.state(now)[1]))
        if register == 1:
            return round(joint.state(now)[0])
        return joint.set_point if register == 2 else joint.speed_set_point

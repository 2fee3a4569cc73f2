"""The walking robot of `examples/walker.ul`: 18 servo joints, six legs of coxa, femur and tibia.

Joint j = 0..17 (leg j / 3) has four words at 0x10 + 4 j:

| offset | word                                                                             |
|--------|----------------------------------------------------------------------------------|
| 0      | cpos: current position, counts, signed; read only                                |
| 1      | spd: current speed, counts/s, signed; read only                                  |
| 2      | pos_sp: position set point, counts, signed                                       |
| 3      | spd_sp: speed set point, counts/s, unsigned: the most speed while moving         |

A turn has 65536 counts. `servo` says how a joint moves; all stand at 0 after power-up, with a quarter of
their most speed as set point. Writing an actual value is a bus error.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.virtual.bus import AccessError
from unity_link.virtual.servo import Joint, JointType
from unity_link.wire.messages import ErrorCode

if TYPE_CHECKING:
    from unity_link.virtual.gateway import BareGateway

BASE = 0x10
"""Address of the first joint."""
LEGS = 6
JOINTS_OF_A_LEG = ("coxa", "femur", "tibia")
REGISTERS = 4
WORD_BITS = 32
COUNTS_PER_RADIAN = 65536 / (2 * math.pi)
MOST_ANGLE, MOST_SPEED = 2, 10
"""In rad and rad/s."""


def joint_type(name: str) -> JointType:
    """Describe a joint; it reaches its most speed in 0.1 s."""
    span, speed = round(MOST_ANGLE * COUNTS_PER_RADIAN), round(MOST_SPEED * COUNTS_PER_RADIAN)
    return JointType(name, "rad", COUNTS_PER_RADIAN, -span, span, speed, 10 * speed)


class Walker:
    """The robot as a device of 72 addresses."""

    def __init__(self, word_bits: int = WORD_BITS) -> None:
        names = (f"leg {leg + 1} {joint}" for leg in range(LEGS) for joint in JOINTS_OF_A_LEG)
        self.joints = [Joint(joint_type(name)) for name in names]
        self._sign = 1 << word_bits - 1

    def addresses(self) -> list[int]:
        """Give the addresses of the device, in the order of its offsets."""
        return list(range(BASE, BASE + REGISTERS * len(self.joints)))

    def read(self, offset: int, now: float) -> int:
        """Read a register."""
        number, register = divmod(offset, REGISTERS)
        joint = self.joints[number]
        position, speed = joint.state(now)
        return (round(position), round(speed), joint.set_point, joint.speed_set_point)[register]

    def write(self, offset: int, value: int, now: float) -> None:
        """Write a set point; an actual value refuses."""
        number, register = divmod(offset, REGISTERS)
        if register == 2:
            self.joints[number].command(now, set_point=(value ^ self._sign) - self._sign)
        elif register == 3:
            self.joints[number].command(now, speed_set_point=value)
        else:
            raise AccessError(ErrorCode.BUS_ERROR)


def attach_walker(gateway: BareGateway) -> Walker:
    """Put the robot behind a gateway.

    Raises:
        ArgumentError: where the gateway's words are too narrow for its positions.
    """
    if gateway.info.data_bits < WORD_BITS:
        raise ArgumentError(
            f"the walker needs words of at least {WORD_BITS} bits, not data_bits={gateway.info.data_bits}"
        )
    walker = Walker(gateway.info.data_bits)
    gateway.attach(walker, walker.addresses())
    return walker

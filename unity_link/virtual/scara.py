"""The SCARA robot of the Unity-Link paper: four servo joints behind the addresses of its figure 1.

| joint n = 1..4 | address  | word                                                             |
|----------------|----------|------------------------------------------------------------------|
| spd            | 80 + n-1 | actual speed, counts/s, unsigned (its magnitude); read only      |
| cpos           | 88 + n-1 | current position, counts, signed; read only                      |
| pos_sp         | 8C + n-1 | position set point, counts, signed                               |
| spd_sp         | 94 + n-1 | speed set point, counts/s, unsigned: the most speed while moving |

Each joint has a motor with an encoder of 4000 counts a revolution behind a gear. A servo moves it to its set point as
fast as its acceleration and the speed set point allow, with a trapezoidal speed profile; a new set point may come at
any time, and the motion goes over into the new one without a jump of the speed. Set points beyond the soft limits of
the joint move it to the limit, speeds beyond its most speed count as that. After power-up all joints stand at 0, with
a quarter of their most speed as set point. Writing an actual value is a bus error.

Motion is computed in closed form from the last change of a set point, so it does not depend on when anyone looks.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import msgspec

from unity_link.errors import ArgumentError
from unity_link.virtual.bus import AccessError
from unity_link.wire.messages import ErrorCode

if TYPE_CHECKING:
    from unity_link.virtual.gateway import BareGateway

COUNTS_PER_REVOLUTION = 4000
SPEED, POSITION, POSITION_SET_POINT, SPEED_SET_POINT = 0x80, 0x88, 0x8C, 0x94
"""Addresses of joint 1; those of the other joints follow."""
WORD_BITS = 32
"""Width of a word that holds every position."""


class JointType(msgspec.Struct, frozen=True):
    """What a joint is able to do, in counts and seconds."""

    name: str
    unit: str
    counts_per_unit: float
    lowest: int
    highest: int
    most_speed: int
    acceleration: int


def _joint_type(name: str, unit: str, counts_per_unit: float, span: tuple[float, float], speed: float) -> JointType:
    """Describe a joint in its own units; it reaches its most speed in 0.2 s."""
    most_speed = round(speed * counts_per_unit)
    lowest, highest = (round(end * counts_per_unit) for end in span)
    return JointType(name, unit, counts_per_unit, lowest, highest, most_speed, 5 * most_speed)


JOINTS = (
    _joint_type("shoulder", "degree", 50 * COUNTS_PER_REVOLUTION / 360, (-130, 130), 300),
    _joint_type("elbow", "degree", 50 * COUNTS_PER_REVOLUTION / 360, (-145, 145), 450),
    # A ball screw of 10 mm a revolution.
    _joint_type("z", "mm", COUNTS_PER_REVOLUTION / 10, (0, 150), 500),
    _joint_type("wrist", "degree", 20 * COUNTS_PER_REVOLUTION / 360, (-360, 360), 900),
)


class Segment(msgspec.Struct, frozen=True):
    """A stretch of motion at constant acceleration."""

    duration: float
    acceleration: float


def plan(distance: float, speed: float, most_speed: float, acceleration: float) -> list[Segment]:
    """Plan the quickest motion that ends at rest.

    Args:
        distance: to the target, signed.
        speed: at the beginning, signed; it may be more than `most_speed`.
        most_speed: the speed that the motion keeps to as soon as it can; 0 stops it as soon as it can.
        acceleration: of speeding up and slowing down.
    """
    braking = Segment(abs(speed) / acceleration, -math.copysign(acceleration, speed))
    overshoot = distance - speed * abs(speed) / (2 * acceleration)
    if most_speed == 0 or overshoot == 0:
        return [braking]
    # From here on the target is ahead: `towards` is the speed in its direction.
    sign = math.copysign(1.0, overshoot)
    towards, ahead = sign * speed, sign * distance
    peak = min(math.sqrt(acceleration * ahead + towards**2 / 2), most_speed)
    to_peak = math.copysign(acceleration, peak - towards)
    cruise = ahead - (peak**2 - towards**2) / (2 * to_peak) - peak**2 / (2 * acceleration)
    return [
        Segment(abs(peak - towards) / acceleration, sign * to_peak),
        Segment(max(0.0, cruise) / peak, 0.0),
        Segment(peak / acceleration, -sign * acceleration),
    ]


class Joint:
    """One joint: registers, and the motion that they command."""

    def __init__(self, kind: JointType) -> None:
        self.kind = kind
        self.set_point = 0
        self.speed_set_point = kind.most_speed // 4
        self._began = 0.0
        self._position = self._speed = 0.0
        self._segments: list[Segment] = []
        self._target = 0.0

    def command(self, now: float, *, set_point: int | None = None, speed_set_point: int | None = None) -> None:
        """Change a set point at the time `now`, in seconds."""
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
        """Give position in counts and speed in counts/s at the time `now`, in seconds."""
        left, position, speed = now - self._began, self._position, self._speed
        for segment in self._segments:
            time = min(left, segment.duration)
            position += speed * time + segment.acceleration * time**2 / 2
            speed += segment.acceleration * time
            left -= time
            if left <= 0:
                return position, speed
        return (self._target, 0.0) if self._segments else (position, speed)


class Scara:
    """The robot as a device of 16 addresses: four each of speed, position, position and speed set point."""

    def __init__(self, word_bits: int = WORD_BITS) -> None:
        self.joints = [Joint(kind) for kind in JOINTS]
        self._sign = 1 << word_bits - 1

    @staticmethod
    def addresses() -> list[int]:
        """Give the addresses of the device, in the order of its offsets."""
        return [base + joint for base in (SPEED, POSITION, POSITION_SET_POINT, SPEED_SET_POINT) for joint in range(4)]

    def read(self, offset: int, now: float) -> int:
        """Read a register."""
        register, number = divmod(offset, len(JOINTS))
        joint = self.joints[number]
        if register == 0:
            return round(abs(joint.state(now)[1]))
        if register == 1:
            return round(joint.state(now)[0])
        return joint.set_point if register == 2 else joint.speed_set_point

    def write(self, offset: int, value: int, now: float) -> None:
        """Write a set point; an actual value refuses."""
        register, number = divmod(offset, len(JOINTS))
        joint = self.joints[number]
        if register == 2:
            joint.command(now, set_point=(value ^ self._sign) - self._sign)
        elif register == 3:
            joint.command(now, speed_set_point=value)
        else:
            raise AccessError(ErrorCode.BUS_ERROR)


def attach_scara(gateway: BareGateway) -> Scara:
    """Put the robot behind a gateway.

    Raises:
        ArgumentError: where the gateway's words are too narrow for its positions.
    """
    if gateway.info.data_bits < WORD_BITS:
        raise ArgumentError(
            f"the SCARA needs words of at least {WORD_BITS} bits, not data_bits={gateway.info.data_bits}"
        )
    robot = Scara(gateway.info.data_bits)
    gateway.attach(robot, robot.addresses())
    return robot

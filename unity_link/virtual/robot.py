"""Base class of the built-in robots: servo joints with two set points each, as a device on the bus."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import TYPE_CHECKING, ClassVar, Self

from unity_link.errors import ArgumentError
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual.bus import AccessError
from unity_link.virtual.servo import JointType, ServoJoint

if TYPE_CHECKING:
    from collections.abc import Iterable

    from unity_link.virtual.gateway import BareGateway

WORD_BITS = 32
"""Narrowest word in bits that can hold all positions."""
SET_POINT, SPEED_SET_POINT = 2, 3
"""Indexes of a joint's registers; 0 and 1 are actual values, whose order depends on the robot."""


class ServoRobot(ABC):
    """Joints of four registers each."""

    NAME: ClassVar[str]

    def __init__(self, word_bits: int = WORD_BITS) -> None:
        self.joints = [ServoJoint(kind) for kind in self.joint_types()]
        self.word_bits = word_bits
        self._sign = 1 << word_bits - 1

    @classmethod
    def made_for(cls, gateway: BareGateway) -> Self:
        """Return a robot with the word width of a gateway.

        Raises:
            ArgumentError: if the words are too narrow for positions.
        """
        width = gateway.info.data_bits
        if width < WORD_BITS:
            raise ArgumentError(f"the {cls.NAME} needs words of at least {WORD_BITS} bits, not data_bits={width}")
        return cls(width)

    @classmethod
    def attach(cls, gateway: BareGateway) -> Self:
        """Return a robot that is attached to a gateway.

        Raises:
            ArgumentError: as for `made_for`.
        """
        robot = cls.made_for(gateway)
        gateway.attach(robot, robot.addresses())
        return robot

    @staticmethod
    @abstractmethod
    def joint_types() -> Iterable[JointType]:
        """Return the types of the joints."""

    @abstractmethod
    def addresses(self) -> list[int]:
        """Return the addresses of the device, in the order of its offsets."""

    @abstractmethod
    def find(self, offset: int) -> tuple[ServoJoint, int]:
        """Return the joint and the register at an offset."""

    @abstractmethod
    def read(self, offset: int, now: float) -> int:
        """Return the value of a register."""

    def write(self, offset: int, value: int, now: float) -> None:
        """Write a set point; raise `AccessError` for an actual value."""
        joint, register = self.find(offset)
        if register == SET_POINT:
            joint.command(now, set_point=(value ^ self._sign) - self._sign)
        elif register == SPEED_SET_POINT:
            joint.command(now, speed_set_point=value)
        else:
            raise AccessError(ErrorCode.BUS_ERROR)

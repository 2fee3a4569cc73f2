"""The common part of the virtual robots: servo joints as a device on the bus, with two set points each."""

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
"""Width of a word that holds every position."""
SET_POINT, SPEED_SET_POINT = 2, 3
"""Registers of a joint; 0 and 1 are actual values, in an order that each robot has for itself."""


class ServoRobot(ABC):
    """Joints of four registers each."""

    NAME: ClassVar[str]

    def __init__(self, word_bits: int = WORD_BITS) -> None:
        self.joints = [ServoJoint(kind) for kind in self.joint_types()]
        self.word_bits = word_bits
        self._sign = 1 << word_bits - 1

    @classmethod
    def made_for(cls, gateway: BareGateway) -> Self:
        """Make such a robot with the words of a gateway.

        Raises:
            ArgumentError: where these are too narrow for its positions.
        """
        width = gateway.info.data_bits
        if width < WORD_BITS:
            raise ArgumentError(f"the {cls.NAME} needs words of at least {WORD_BITS} bits, not data_bits={width}")
        return cls(width)

    @classmethod
    def attach(cls, gateway: BareGateway) -> Self:
        """Put such a robot behind a gateway.

        Raises:
            ArgumentError: as by `made_for`.
        """
        robot = cls.made_for(gateway)
        gateway.attach(robot, robot.addresses())
        return robot

    @staticmethod
    @abstractmethod
    def joint_types() -> Iterable[JointType]:
        """Return the joints that it has."""

    @abstractmethod
    def addresses(self) -> list[int]:
        """Return the addresses of the device, in the order of its offsets."""

    @abstractmethod
    def find(self, offset: int) -> tuple[ServoJoint, int]:
        """Return the joint and the register at an offset."""

    @abstractmethod
    def read(self, offset: int, now: float) -> int:
        """Read a register."""

    def write(self, offset: int, value: int, now: float) -> None:
        """Write a set point; an actual value refuses."""
        joint, register = self.find(offset)
        if register == SET_POINT:
            joint.command(now, set_point=(value ^ self._sign) - self._sign)
        elif register == SPEED_SET_POINT:
            joint.command(now, speed_set_point=value)
        else:
            raise AccessError(ErrorCode.BUS_ERROR)

"""The walking robot at its addresses."""

from __future__ import annotations

import math

import pytest

from unity_link.errors import ArgumentError
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.virtual import VirtualGateway
from unity_link.virtual.bus import AccessError
from unity_link.virtual.walker import COUNTS_PER_RADIAN, Walker

LEG_6_TIBIA = 0x10 + 4 * 17


def test_each_of_the_72_addresses_is_a_register_of_its_joint() -> None:
    gateway = VirtualGateway()
    walker = Walker.attach(gateway)
    assert list(gateway.bus.devices) == walker.addresses() == list(range(0x10, 0x10 + 72))
    for number, joint in enumerate(walker.joints):
        gateway.bus.write(0x10 + 4 * number + 2, number, 0)
        assert joint.set_point == number
    assert walker.joints[-1].kind.name == "leg 6 tibia"


def test_a_joint_moves_to_its_set_point_with_a_signed_speed() -> None:
    gateway = VirtualGateway()
    Walker.attach(gateway)
    target = -round(COUNTS_PER_RADIAN)
    gateway.bus.write(LEG_6_TIBIA + 3, round(2 * COUNTS_PER_RADIAN), 0)
    gateway.bus.write(LEG_6_TIBIA + 2, target & 0xFFFF_FFFF, 0)
    on_its_way = gateway.bus.read(LEG_6_TIBIA + 1, 0.3)
    assert on_its_way - (1 << 32) == -round(2 * COUNTS_PER_RADIAN)
    assert gateway.bus.read(LEG_6_TIBIA, 2) == target & 0xFFFF_FFFF
    assert gateway.bus.read(LEG_6_TIBIA + 1, 2) == 0
    assert gateway.bus.read(LEG_6_TIBIA + 2, 2) == target & 0xFFFF_FFFF


def test_a_joint_of_the_walker_stops_at_its_limits() -> None:
    gateway = VirtualGateway()
    Walker.attach(gateway)
    gateway.bus.write(0x12, round(math.pi * COUNTS_PER_RADIAN), 0)
    assert gateway.bus.read(0x10, 100) == round(2 * COUNTS_PER_RADIAN)


def test_actual_values_cannot_be_written() -> None:
    gateway = VirtualGateway()
    Walker.attach(gateway)
    for offset in (0, 1):
        with pytest.raises(AccessError):
            gateway.bus.write(LEG_6_TIBIA + offset, 1, 0)


def test_words_that_are_too_narrow_are_refused() -> None:
    with pytest.raises(ArgumentError, match="the walker needs words of at least 32 bits, not data_bits=16"):
        Walker.attach(VirtualGateway(GatewayInfo(data_bits=16)))

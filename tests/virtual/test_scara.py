"""The robot moves as servos do, independent of when it is read."""

from __future__ import annotations

import itertools
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from unity_link.errors import ArgumentError
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.virtual import VirtualGateway
from unity_link.virtual.scara import JOINTS, Scara
from unity_link.virtual.servo import ServoJoint, plan

COMMANDS = st.lists(
    st.tuples(st.floats(0, 1.5), st.integers(-90_000, 90_000), st.sampled_from([0, 5_000, 50_000, 500_000])), max_size=5
)


def read(gateway: VirtualGateway, address: int, now: float) -> int:
    return int(gateway.receive(b"R%02X\r" % address, now)[3:11], 16)


def write(gateway: VirtualGateway, address: int, value: int, now: float) -> bytes:
    return gateway.receive(b"W%02X%08X\r" % (address, value & 0xFFFFFFFF), now)


def robot() -> VirtualGateway:
    gateway = VirtualGateway()
    Scara.attach(gateway)
    return gateway


@pytest.mark.parametrize("joint", range(4))
def test_every_joint_reaches_its_set_point_and_stays(joint: int) -> None:
    gateway = robot()
    write(gateway, 0x8C + joint, 20_000, 0.0)
    assert read(gateway, 0x80 + joint, 0.3) > 0
    for now in (10.0, 1e6):
        assert read(gateway, 0x88 + joint, now) == 20_000
        assert read(gateway, 0x80 + joint, now) == 0
    assert read(gateway, 0x8C + joint, 1e6) == 20_000


def test_positions_below_zero_read_in_twos_complement() -> None:
    gateway = robot()
    write(gateway, 0x8C, -10_000, 0.0)
    assert read(gateway, 0x88, 10.0) == 2**32 - 10_000
    assert read(gateway, 0x8C, 10.0) == 2**32 - 10_000


def test_all_joints_are_at_rest_and_ready_to_move_after_power_up() -> None:
    gateway = robot()
    for joint in range(4):
        assert [read(gateway, base + joint, 5.0) for base in (0x80, 0x88, 0x8C)] == [0, 0, 0]
        assert read(gateway, 0x94 + joint, 5.0) == JOINTS[joint].most_speed // 4 > 0


def test_set_points_beyond_the_soft_limits_move_to_the_limit() -> None:
    gateway = robot()
    for joint, kind in enumerate(JOINTS):
        write(gateway, 0x8C + joint, 10**9, 0.0)
        assert read(gateway, 0x88 + joint, 60.0) == kind.highest
    write(gateway, 0x8E, -5, 60.0)
    assert read(gateway, 0x8A, 120.0) == JOINTS[2].lowest == 0


def test_the_speed_set_point_is_the_cruising_speed_and_zero_holds() -> None:
    gateway = robot()
    write(gateway, 0x94, 10_000, 0.0)
    write(gateway, 0x8C, 60_000, 0.0)
    assert read(gateway, 0x80, 2.0) == 10_000
    write(gateway, 0x94, 0, 2.0)
    assert read(gateway, 0x80, 3.0) == 0
    held = read(gateway, 0x88, 3.0)
    assert read(gateway, 0x88, 30.0) == held < 60_000
    write(gateway, 0x94, 10_000, 30.0)
    assert read(gateway, 0x88, 60.0) == 60_000


def test_actual_values_cannot_be_written() -> None:
    gateway = robot()
    assert write(gateway, 0x80, 1, 0.0) == b"X04\r\n"
    assert write(gateway, 0x8B, 1, 0.0) == b"X04\r\n"


def test_the_addresses_around_the_robot_are_plain_memory() -> None:
    gateway = robot()
    for address in (0x00, 0x7F, 0x84, 0x93, 0x98):
        write(gateway, address, address, 0.0)
        assert read(gateway, address, 1.0) == address


@pytest.mark.slow
@given(commands=COMMANDS)
def test_speed_and_acceleration_stay_within_limits_for_any_command(commands: list[tuple[float, int, int]]) -> None:
    kind = JOINTS[0]
    joint, now = ServoJoint(kind), 0.0
    for delay, set_point, speed in commands:
        now += delay
        before = joint.state(now)
        joint.command(now, set_point=set_point, speed_set_point=speed)
        assert joint.state(now) == pytest.approx(before, abs=1e-6)
    step = 0.002
    states = [joint.state(now + step * index) for index in range(2000)]
    for (position, velocity), (next_position, next_velocity) in itertools.pairwise(states):
        assert abs(velocity) <= kind.most_speed * (1 + 1e-9)
        assert abs(next_velocity - velocity) <= kind.acceleration * step * (1 + 1e-6) + 1e-3
        mean = (velocity + next_velocity) / 2
        assert next_position - position == pytest.approx(mean * step, abs=kind.acceleration * step**2)


@given(
    distance=st.floats(-1e5, 1e5), speed=st.floats(-2e5, 2e5), most=st.floats(1, 2e5), acceleration=st.floats(1e3, 1e6)
)
def test_a_plan_ends_at_rest_at_its_target(distance: float, speed: float, most: float, acceleration: float) -> None:
    position, velocity = 0.0, speed
    for segment in plan(distance, speed, most, acceleration):
        assert segment.duration >= 0
        position += velocity * segment.duration + segment.acceleration * segment.duration**2 / 2
        velocity += segment.acceleration * segment.duration
    scale = abs(distance) + speed**2 / acceleration + 1
    assert position == pytest.approx(distance, abs=1e-6 * scale)
    assert velocity == pytest.approx(0, abs=1e-6 * (abs(speed) + most))


@given(speed=st.floats(-2e5, 2e5), acceleration=st.floats(1e3, 1e6), way=st.sampled_from([-1.0, 1.0]))
def test_a_target_almost_reached_by_braking_causes_no_division_by_zero(
    speed: float, acceleration: float, way: float
) -> None:
    braking = speed * abs(speed) / (2 * acceleration)
    segments = plan(math.nextafter(braking, way * math.inf), speed, 1e5, acceleration)
    assert all(segment.duration >= 0 for segment in segments)


@pytest.mark.slow
@given(commands=COMMANDS, looks=st.lists(st.floats(0, 20), max_size=20))
def test_reading_does_not_change_the_motion(commands: list[tuple[float, int, int]], looks: list[float]) -> None:
    def position(looking: list[float]) -> int:
        device, now = Scara(), 0.0
        for delay, set_point, speed in commands:
            for look in sorted(look for look in looking if now <= look < now + delay):
                device.read(4, look)
            now += delay
            device.write(8, set_point & 0xFFFFFFFF, now)
            device.write(12, speed, now)
        return device.read(4, now + 0.3)

    assert position(looks) == position([])


def test_words_that_cannot_hold_a_position_are_refused() -> None:
    with pytest.raises(ArgumentError, match="data_bits=16"):
        Scara.attach(VirtualGateway(GatewayInfo(data_bits=16)))

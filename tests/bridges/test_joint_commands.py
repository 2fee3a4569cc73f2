"""Commands for all joints together, and diagnostics: the common parts of both bridges to ROS."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
import pytest_asyncio
from hypothesis import given
from hypothesis import strategies as st

import unity_link
from support.simulated_time import on_simulated_time
from unity_link import ArgumentError, GatewayError
from unity_link.bridges.diagnostics import ERROR, OK, WARN, Diagnostics
from unity_link.bridges.topics import JointCommands, joint_command_topics, published_groups
from unity_link.spec import compile_text
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing

if TYPE_CHECKING:
    from collections.abc import AsyncIterator

    from unity_link.data import Robot

SCARA = Path(__file__).parents[2] / "examples" / "scara.ul"
COUNTED = """
group state(1, 10, JOINTS(POSITION=p, SET_POSITION=p, SET_EFFORT=e));
public arm() { a: joint() @(0); b: fixed() @(8); }
joint(): @(base) { @p = base: signed READWRITE(PUBLISH(state)); @e = base + 1: float WRITE(); }
fixed(): @(base) { @p = base: signed READ(PUBLISH(state)); }
"""
WHOLE_DEGREES = """
group state(1, 10, JOINTS(POSITION=p, SET_POSITION=p, SET_EFFORT=e));
public arm() { a: joint() @(0); }
joint(): @(base) { @p = base: signed READWRITE(UNIT="deg", PUBLISH(state)); @e = base + 1: float WRITE(UNIT="Nmm"); }
"""
NONE: dict[str, list[float]] = {"position": [], "velocity": [], "effort": []}


@pytest_asyncio.fixture
async def scara() -> AsyncIterator[Robot]:
    """Yield the SCARA on an open link."""
    async with unity_link.connect("sim:scara") as link:
        yield unity_link.load(SCARA)(link)


def commands_of(robot: Robot) -> JointCommands:
    return joint_command_topics(robot, published_groups(robot))[0].joints


def by_path(commands: list[Any]) -> dict[str, float]:
    return {proxy.path: value for proxy, value in commands}


@pytest.mark.asyncio
async def test_there_is_a_topic_for_all_and_one_for_each_kind_of_set_points(scara: Robot) -> None:
    topics = joint_command_topics(scara, published_groups(scara))
    assert [(topic.name, topic.part) for topic in topics] == [
        ("joint_commands", None), ("velocity_commands", "velocity"), ("position_commands", "position"),
    ]  # fmt: skip


@pytest.mark.asyncio
async def test_values_are_in_the_units_of_the_spec_and_speed_comes_before_position(scara: Robot) -> None:
    given = {"position": [math.pi / 2, 0.1], "velocity": [math.nan, 0.02], "effort": []}
    commands = commands_of(scara).of_state(["j2", "j3"], given)
    assert [proxy.path for proxy, _ in commands] == ["j3.spd_sp", "j2.pos_sp", "j3.pos_sp"]
    assert by_path(commands) == pytest.approx({"j3.spd_sp": 20, "j2.pos_sp": 90, "j3.pos_sp": 100})


@pytest.mark.asyncio
async def test_joints_without_a_set_point_keep_theirs_and_counts_are_whole_numbers() -> None:
    async with unity_link.connect("sim:") as link:
        joints = commands_of(unity_link.load(compile_text(COUNTED))(link))
        assert by_path(joints.of_array("position", [3.0, math.nan])) == {"a.p": 3}
        assert by_path(joints.of_state((), {**NONE, "effort": [0.5, math.nan]})) == {"a.e": 0.5}
        with pytest.raises(ArgumentError, match="b has no set point of position"):
            joints.of_array("position", [3.0, 4.0])


WRONG = {
    "an unknown joint": (["j5"], {"position": [1.0]}, "no joint is called 'j5'"),
    "a joint named twice": (["j1", "j1"], {"position": [1.0, 2.0]}, "named twice"),
    "too few values": (["j1", "j2"], {"position": [1.0]}, "1 values of position were given for 2 joints"),
    "an infinite value": (["j1"], {"velocity": [math.inf]}, "no finite number"),
    "no set points of this kind": (["j1"], {"effort": [1.0]}, "j1 has no set point of effort"),
}


@pytest.mark.asyncio
@pytest.mark.parametrize(("names", "values", "what"), WRONG.values(), ids=WRONG)
async def test_a_message_that_cannot_be_is_a_sentence(
    scara: Robot, names: list[str], values: dict[str, list[float]], what: str
) -> None:
    with pytest.raises(ArgumentError, match=what):
        commands_of(scara).of_state(names, NONE | values)


@pytest.mark.asyncio
@pytest.mark.parametrize("part", ["position", "effort"])
async def test_a_value_that_no_number_holds_in_the_unit_of_the_spec_is_a_sentence(part: str) -> None:
    async with unity_link.connect("sim:") as link:
        joints = commands_of(unity_link.load(compile_text(WHOLE_DEGREES))(link))
        with pytest.raises(ArgumentError, match="1e\\+308 is no finite number in"):
            joints.of_array(part, [1e308])


@given(
    values=st.lists(st.floats(-2, 2, allow_subnormal=False) | st.just(math.nan), min_size=4, max_size=4),
    order=st.permutations(range(4)),
)
@on_simulated_time
async def test_array_and_state_of_the_same_values_in_any_order_are_one_command(
    values: list[float], order: list[int]
) -> None:
    async with unity_link.connect("sim:scara") as link:
        joints = commands_of(unity_link.load(SCARA)(link))
        named = [joints.names[place] for place in order]
        state = joints.of_state(named, {**NONE, "position": [values[place] for place in order]})
        assert by_path(state) == by_path(joints.of_array("position", values))


@on_simulated_time
async def test_diagnostics_warn_about_faults_since_the_last_report() -> None:
    gateway = VirtualGateway()
    gateway.attach(Failing(unity_link.protocol.wire.messages.ErrorCode.BUS_ERROR), [1])
    async with unity_link.connect(gateway) as link:
        diagnostics = Diagnostics("bridge", link, "here")
        before = diagnostics.status(10, 0, 0)
        with pytest.raises(GatewayError):
            await link.read(1)
        levels = [diagnostics.status(20, lost, 0).level for lost in (0, 0, 3, 3)]
    away = diagnostics.status(20, 3, 0)
    assert (before.level, before.message, before.name, before.hardware_id) == (OK, "connected", "bridge: link", "here")
    assert dict(before.values)["samples published"] == "10"
    assert levels == [WARN, OK, WARN, OK]
    assert (away.level, away.message) == (ERROR, "the gateway is away")

"""The paper's figure 1, unchanged, gives an object to read, write and subscribe to all four joints."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
import pytest_asyncio

import unity_link
from support.spec_examples import FIGURE_1
from unity_link.data import Group
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from collections.abc import AsyncIterator

    from unity_link.data.loading import LoadedRobot

Scara = unity_link.load(compile_text(FIGURE_1))
SET_POINTS = (1200, -700, 345, 2000)
"""Set points of joints 1 to 4, in counts; within the limits of each joint."""


ADDRESSES = {"scara": {}, "tosnet": {"ctrl": 0xF0, "comm": 0xF4}}
"""Addresses of the parameters, by robot."""


@pytest_asyncio.fixture(
    params=[
        "sim:scara",
        "sim:tosnet",
        pytest.param("rtl:scara", marks=pytest.mark.rtl),
        pytest.param("rtl:tosnet", marks=pytest.mark.rtl),
    ]
)
async def robot(request: pytest.FixtureRequest) -> AsyncIterator[LoadedRobot]:
    async with unity_link.connect(request.param) as link:
        yield Scara(link, **ADDRESSES[request.param.partition(":")[2]])


@pytest.mark.asyncio
async def test_all_joints_are_read_written_and_published(robot: LoadedRobot) -> None:
    joints = (robot.j1, robot.j2, robot.j3, robot.j4)
    for joint, set_point in zip(joints, SET_POINTS, strict=True):
        assert await joint.cpos.get() == 0
        await joint.spd_sp.set(100_000)
        await joint.pos_sp.set(set_point)
    async for sample in robot.groups["group_1"]:
        positions = tuple(sample.values[joint.cpos] for joint in joints)
        if positions == SET_POINTS:
            break
    assert [await joint.cpos.get() for joint in joints] == list(SET_POINTS)
    assert [await joint.spd.get() for joint in joints] == [0, 0, 0, 0]


@pytest.mark.asyncio
async def test_each_joint_has_its_own_name_and_samples(robot: LoadedRobot) -> None:
    for number, joint in enumerate((robot.j1, robot.j2, robot.j3, robot.j4), 1):
        assert joint.cpos.id == f"joint {number}:cpos"
        await joint.pos_sp.post(50 * number)
        async for position in joint.cpos:
            if position == 50 * number:
                break
        assert joint.cpos.value == 50 * number


@pytest.mark.asyncio
async def test_an_unknown_or_impossible_parameter_of_a_robot_is_refused(robot: LoadedRobot) -> None:
    Scara(robot.link)
    Scara(robot.link, ctrl=0xF0, comm=0xF4)
    with pytest.raises(unity_link.ArgumentError, match="no parameter 'crtl' to be given: ctrl, comm expected"):
        Scara(robot.link, crtl=0xF0)
    with pytest.raises(unity_link.ArgumentError, match="ctrl=256 was given, an address from 0 to 0xff expected"):
        Scara(robot.link, ctrl=0x100)


@pytest.mark.asyncio
async def test_a_group_of_joints_reads_and_writes_the_signals_that_allow_it(robot: LoadedRobot) -> None:
    arm = Group(robot.j1, robot.j2)
    await arm.set({robot.j1.spd_sp: 90_000, robot.j2.spd_sp: 90_000, robot.j1.pos_sp: 40, robot.j2.pos_sp: -40})
    async for sample in arm:
        if (sample.values[robot.j1.cpos], sample.values[robot.j2.cpos]) == (40, -40):
            break
    # The rounded position arrives a moment before its joint has stopped.
    while (values := await arm.get())[robot.j1.spd] or values[robot.j2.spd]:
        pass
    assert dict(values) == {robot.j1.cpos: 40, robot.j1.spd: 0, robot.j2.cpos: -40, robot.j2.spd: 0}
    with pytest.raises(unity_link.ArgumentError, match="pos_sp can only be written"):
        await Group(robot.j1.cpos, robot.j1.pos_sp).get()
    with pytest.raises(unity_link.ArgumentError, match="cpos can only be read"):
        await arm.set({robot.j1.cpos: 1})

"""Copies and pickles: data can be copied; objects of a link are returned by a copy and refused by a pickle."""

from __future__ import annotations

import copy
import pickle
import subprocess
import sys
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import unity_link
from support.simulated_time import on_simulated_time
from unity_link import ArgumentError, blocking
from unity_link.data import Batch, Group, Proxy
from unity_link.data.blocking import put
from unity_link.errors import UnknownNameError
from unity_link.spec import compile_text
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from collections.abc import Callable

ROBOT = unity_link.load(
    compile_text("""
    enum mode { off, manual = 4 }
    group state(1, 10);
    public robot() {
      @mode = 0x11[3:0]: mode READWRITE(PUBLISH(state));
      @angle = 0x12: signed 16 READ(PUBLISH(state), SCALE=0.5, UNIT="deg", ID="the angle");
      part: part() @(0x20);
    }
    part(): @(base) { @other = base: READ(); }
    """)
)


def pickled(thing: Any) -> Any:
    return pickle.loads(pickle.dumps(thing))


COPIES: tuple[Callable[[Any], Any], ...] = (copy.copy, copy.deepcopy, pickled)


async def some_samples(robot: Any) -> Batch:
    await robot.mode.set("manual")
    async with robot.groups["state"].subscribe() as samples:
        batch: Batch = await samples.take(10)
    return batch


@on_simulated_time
@pytest.mark.parametrize("copied", COPIES)
async def test_a_batch_and_its_table_and_samples_are_copied(copied: Callable[[Any], Any]) -> None:
    async with unity_link.connect(VirtualGateway()) as link:
        robot = ROBOT(link)
        batch = await some_samples(robot)
        manual = ROBOT.enumerations["mode"]["manual"]
        of_batch, of_table, of_samples = copied(batch), copied(batch.table), copied([*batch])
        for name in ("mode", "angle"):
            for copied_columns in (of_batch, of_table, of_batch.table):
                np.testing.assert_array_equal(copied_columns[name], batch[name])
        np.testing.assert_array_equal(of_batch["the angle"], of_batch[robot.angle])
        assert of_batch.samples[3].sequence == batch.samples[3].sequence
        assert of_table.units == batch.table.units == {"angle": "deg"}
        for samples in (of_samples, [*of_batch]):
            assert [sample.time for sample in samples] == [sample.time for sample in batch]
            assert samples[2]["mode"] is samples[2][robot.mode] is manual
        for made in (of_batch, of_table):
            with pytest.raises(ArgumentError, match=r"cannot be assigned to|has no"):
                made.samples = ()
        with pytest.raises(UnknownNameError, match=r"part\.other is not in the group: it has mode, angle"):
            of_batch[robot.part.other]


@on_simulated_time
async def test_an_unpickled_signal_has_its_path_and_no_link() -> None:
    async with unity_link.connect(VirtualGateway()) as link:
        robot = ROBOT(link)
        alone: Any = pickled(robot.angle)
        assert (alone.path, alone.id, alone.unit, alone.value) == ("angle", "the angle", "deg", None)
        assert type(alone) is Proxy
        for name in ("get", "link", "robot"):
            with pytest.raises(AttributeError, match=f"^angle is out of a pickle, without a link: it has no '{name}'$"):
                getattr(alone, name)
        with pytest.raises(AttributeError, match="angle is out of a pickle"):
            await Group(alone).get()


@on_simulated_time
async def test_copies_of_objects_that_belong_to_a_link_are_the_same_objects() -> None:
    async with unity_link.connect(VirtualGateway()) as link:
        robot = ROBOT(link)
        targets = {robot.mode: ["off"]}
        deep = copy.deepcopy(targets)
        deep[robot.mode].append("manual")
        assert targets == {robot.mode: ["off"]}
        for thing in (robot, robot.part, robot.mode):
            assert copy.copy(thing) is copy.deepcopy(thing) is thing
        for thing, name in ((robot, "robot"), (robot.part, "part"), (robot.groups["state"], "the group state")):
            with pytest.raises(ArgumentError, match=f"^{name} cannot be pickled: it is of no use without its link"):
                pickle.dumps(thing)


@on_simulated_time
async def test_copies_of_a_link_and_its_subscriptions_are_the_same_objects() -> None:
    async with unity_link.connect(VirtualGateway()) as link, link.subscribe(0x11, rate_hz=100) as samples:
        of_group = Group(ROBOT(link).angle).subscribe(rate_hz=10)
        for thing, name in ((link, "a link"), (samples, "a subscription"), (of_group, "a subscription of a group")):
            assert copy.copy(thing) is copy.deepcopy([thing])[0] is thing
            with pytest.raises(ArgumentError, match=f"^{name} cannot be pickled: it is of no use without its link"):
                pickle.dumps(thing)


def test_copies_of_views_of_a_blocking_robot_are_the_same_objects() -> None:
    with blocking.connect("sim:") as link:
        robot = put(ROBOT, link)
        for thing in (robot, robot.part, robot.mode):
            assert copy.copy(thing) is copy.deepcopy(thing) is thing
        with robot.groups["state"].subscribe() as samples:
            batch = samples.take(3)
        np.testing.assert_array_equal(pickled(batch)[robot.mode], batch[robot.mode])
        assert pickled(robot.angle).path == "angle"
        for thing in (robot, link, robot.groups["state"]):
            with pytest.raises(ArgumentError, match="cannot be pickled: it is of no use without its link"):
                pickle.dumps(thing)


def test_members_of_an_enumeration_can_be_unpickled_in_other_programs() -> None:
    member = ROBOT.enumerations["mode"]["manual"]
    for copied in COPIES:
        assert copied(member) is member
    for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
        assert pickle.loads(pickle.dumps([member], protocol)) == [member]
    program = "import pickle, sys; member = pickle.load(sys.stdin.buffer); print(repr(member), member.name, member + 1)"
    run = subprocess.run([sys.executable, "-c", program], input=pickle.dumps(member), check=True, capture_output=True)
    assert run.stdout == b"<mode.manual: 4> manual 5\n"

"""Values of signals with WRAPS continue when their registers wrap: in reads, samples, writes, bridges and files."""

from __future__ import annotations

import asyncio
import itertools
import json
import pickle
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mcap.reader import make_reader

import unity_link
from support.simulated_time import on_simulated_time, run_simulated
from unity_link import ArgumentError
from unity_link.bridges.recording import Recorder, Recording
from unity_link.bridges.topics import published_groups
from unity_link.bridges.zenoh.samples import encode
from unity_link.data import Group
from unity_link.data.laps import ColumnLaps, Laps
from unity_link.errors import GatewayResetError
from unity_link.spec import compile_text
from unity_link.virtual.build import simulated
from unity_link.virtual.simulated import SimulatedRobot

if TYPE_CHECKING:
    from pathlib import Path

SPEC = compile_text("""
group state(RATE=100, TIMESTAMPS, JOINTS(POSITION=position, VELOCITY=velocity));
public robot() {
  wheel: ENCODER(COUNTS=1000, SCALE=0.001, UNIT="turn", GROUP=state) @(0x20);
  whole: ENCODER(COUNTS=1000, SCALE=1, UNIT="", GROUP=state) @(0x24);
  x: STEPGEN(STEPS=100, UNIT="mm", MAXVEL=1700, MAXACCEL=100000) @(0x30);
  @odometer = 0x40: unsigned 16 READ(WRAPS, PUBLISH(state));
}
""")
Robot = unity_link.load(SPEC)
ROUND = 1 << 32
LAP = (1 << 24) / 100
"""Millimetres of one lap of x."""


class Plant(SimulatedRobot):
    """Turns all wheels at the same speed, in counts per second."""

    speed = 0.0
    counts = 0.0

    def step(self, dt: float) -> None:
        self.counts += self.speed * dt
        self.wheel.position = self.counts / 1000
        self.whole.position = self.odometer = round(self.counts)


def turning(speed: float, counts: float = 0.0) -> tuple[Any, Any]:
    gateway = simulated(SPEC.interface(), Plant)
    plant: Any = gateway.robot
    plant.speed, plant.counts = speed, counts
    plant.step(0)
    return gateway, plant


SIGNAL = SPEC.interface().signals["odometer"]
NARROW = 1 << 16


@given(
    moves=st.lists(st.integers(-NARROW // 2 + 1, NARROW // 2 - 1), min_size=1, max_size=40),
    cuts=st.sets(st.integers(1, 39)),
    lost=st.sets(st.integers(1, 38)),
    sessions=st.sets(st.integers(1, 39)),
)
def test_values_continue_with_less_than_half_a_lap_between_samples(
    moves: list[int], cuts: set[int], lost: set[int], sessions: set[int]
) -> None:
    """Samples arrive in any batches; any may be lost if less than half a lap is left between the others."""
    places, epochs, truth = [0], [0], [0]
    for number, move in enumerate(moves):
        places.append(places[-1] + move)
        epochs.append(epochs[-1] + (number in sessions))
        # A session begins with the value of the register, as after a reset.
        begins = epochs[-1] != epochs[-2]
        truth.append(places[-1] % NARROW if begins else truth[-1] + move)
    kept = [0]
    for number in range(1, len(places)):
        following = min(number + 1, len(places) - 1)
        is_near = abs(truth[following] - truth[kept[-1]]) < NARROW // 2 and epochs[following] == epochs[kept[-1]]
        if number not in lost or not is_near:
            kept.append(number)
    laps = ColumnLaps([SIGNAL], SIGNAL.addresses)
    found: list[int] = []
    bounds = sorted({0, len(kept), *(cut for cut in cuts if cut < len(kept))})
    for first, end in itertools.pairwise(bounds):
        part = kept[first:end]
        words = np.array([[places[number] % NARROW] for number in part], np.uint64)
        found += laps.count(words, np.array([epochs[number] for number in part]))[0].tolist()
    assert found == [truth[number] for number in kept]


@given(
    start=st.integers(-(1 << 40), 1 << 40),
    moves=st.lists(st.integers(-(1 << 31) + 1, (1 << 31) - 1), max_size=20),
    scale=st.sampled_from(["wheel.position", "whole.position"]),
)
def test_values_read_one_by_one_continue_over_wraps(start: int, moves: list[int], scale: str) -> None:
    signal = SPEC.interface().signals[scale]
    laps, place = Laps(signal), start
    step = 0.001 if signal.kind.is_scaled else 1
    first = signal.kind.decode(start % ROUND)
    laps.see(first, 0, 0)
    for number, move in enumerate(moves):
        place += move
        value = laps.near(signal.kind.decode(place % ROUND), 0)
        laps.see(value, 0, number)
        assert value == pytest.approx(first + (place - start) * step, rel=1e-12)
        assert signal.kind.encode(signal.kind.wrapped(value)) == place % ROUND


@on_simulated_time
async def test_reads_and_samples_of_a_wheel_continue_beyond_its_register() -> None:
    gateway, plant = turning(1.9e9)
    async with unity_link.connect(gateway) as link:
        robot: Any = Robot(link)
        state, both = robot.groups["state"], Group(robot.wheel.position, robot.whole.index_position)
        for _ in range(4):
            # The next read is less than half a lap (2^31 counts) later.
            await asyncio.sleep(1)
            assert await robot.wheel.position.get() == pytest.approx(plant.counts / 1000, abs=2e3)
            assert await robot.whole.position.get() == pytest.approx(plant.counts, abs=2e6)
            assert type(await robot.whole.position.get()) is int
            assert await robot.whole.index_position.get() == pytest.approx(plant.counts, abs=2e6)
            values = await both.get()
            assert values[robot.wheel.position] == pytest.approx(plant.counts / 1000, abs=2e3)
            assert values[robot.whole.index_position] == pytest.approx(plant.counts, abs=2e6)
        assert plant.counts > 1.7 * ROUND
        async with state.subscribe() as samples:
            await asyncio.sleep(1)
            batch = await samples.take()
            assert batch[robot.whole.position].dtype == np.int64
            assert np.diff(batch[robot.whole.position]) == pytest.approx(1.9e7)
            assert batch[robot.whole.position] == pytest.approx(batch[robot.wheel.position] * 1000)
            assert pickle.loads(pickle.dumps(batch))["whole.position"].tolist() == batch[robot.whole.position].tolist()
            assert robot.whole.position.value == batch[robot.whole.position][-1]
            await asyncio.sleep(0.02)
            assert [sample[robot.whole.position] for sample in await samples.take()][-1] > 2 * ROUND
        assert await anext(robot.whole.position.samples()) > 2 * ROUND


@on_simulated_time
async def test_values_begin_with_the_register_after_a_reset_of_the_gateway() -> None:
    gateway, plant = turning(1.9e9)
    async with unity_link.connect(gateway) as link:
        robot: Any = Robot(link)
        async with robot.groups["state"].subscribe() as samples:
            for _ in range(2):
                await asyncio.sleep(1)
                await samples.take()
            await asyncio.sleep(1)
            batch = await samples.take()
            assert batch[robot.whole.position][-1] > ROUND
            plant.speed = plant.counts = 0.0
            gateway.reset()
            await asyncio.sleep(1)
            assert await robot.wheel.position.get() == 0
            await asyncio.sleep(0.5)
            batch = await samples.take()
            assert set(batch[robot.whole.position][batch.epoch == 1]) == {0}
        plant.counts = 3e9
        await asyncio.sleep(0.01)
        assert await robot.whole.position.get() == 3_000_000_000 - ROUND
        gateway.reset()
        with pytest.raises(GatewayResetError):
            await robot.whole.position.get()
        plant.counts = 2e9
        await asyncio.sleep(0.01)
        # In the earlier session the value would have been negative, below the register.
        assert await robot.whole.position.get() == 2_000_000_000


@on_simulated_time
async def test_a_move_across_the_end_of_the_register_is_commanded_and_read() -> None:
    gateway = simulated(SPEC.interface())
    async with unity_link.connect(gateway) as link:
        x: Any = Robot(link).x
        with pytest.raises(ArgumentError, match=r"x.position_cmd: 90000 is outside of -83886.08 to .*was not read yet"):
            await x.position_cmd.set(90000)
        for target in (80_000, 90_000, 160_000, 240_000, 170_000, 90_000, 10_000, -70_000, -150_000):
            await x.position_cmd.set(target)
            await asyncio.sleep(60)
            assert (await x.position.get(), await x.position_cmd.get()) == (target, target)
            assert x.position_cmd.value == target
        await x.move_to(-150_100)
        assert await x.position.get() == -150_100
        for far in (0, 10**9):
            with pytest.raises(ArgumentError, match=rf"x.position_cmd: {far} is half a round, 83886.08, or more away"):
                await x.position_cmd.set(far)
            with pytest.raises(ArgumentError, match=rf"x.position_cmd: {far} is half a round, 83886.08, or more away"):
                await Group(x.position_cmd, x.mode).set({x.position_cmd: far})
        await x.position_cmd.set(-80_000)
        await asyncio.sleep(60)
        with pytest.raises(ArgumentError, match=r"x.position_cmd: 4000 is half a round"):
            await x.move_to(4000)


@on_simulated_time
async def test_joint_states_and_zenoh_samples_are_continuous_over_a_wrap() -> None:
    gateway, _ = turning(1.0e9, 1.2e9)
    async with unity_link.connect(gateway) as link:
        robot: Any = Robot(link)
        (published,) = published_groups(robot)
        assert published.joints is not None
        assert {topic.name: topic.type for topic in published.topics}["whole/position"] == "Int64"
        seen: list[float] = []
        sent: list[float] = []
        async with published.group.subscribe() as samples:
            while len(seen) < 300:
                await asyncio.sleep(0.05)
                batch = await samples.take()
                seen += published.joints.columns(batch)["position"][:, 1].tolist()
                sent += json.loads(encode(batch, [proxy.path for proxy in batch.proxies]))["signals"]["whole.position"]
    assert seen[0] < 1 << 31 < seen[-1]
    assert np.diff(seen) == pytest.approx(1e7)
    assert sent == seen


def test_recordings_are_continuous_over_a_wrap(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"

    async def record() -> None:
        gateway, _ = turning(1.0e9, 1.2e9)
        async with unity_link.connect(gateway) as link, Recorder(Robot(link), path):
            await asyncio.sleep(3)

    run_simulated(record())
    for column in (Recording(path)["state"]["whole.position"], Recording(path)["state"]["wheel.position"] * 1000):
        assert column[0] < 1 << 31 < column[-1]
        assert np.diff(column) == pytest.approx(1e7)
    with path.open("rb") as file:
        messages = [json.loads(message.data) for _, _, message in make_reader(file).iter_messages()]
    written = [message["signals"]["whole"]["position"] for message in messages]
    assert written == Recording(path)["state"]["whole.position"].tolist()

"""Signals with an effect, through their proxies: each event is returned once, and no write affects a neighbour."""

from __future__ import annotations

import asyncio
import random
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import unity_link
from support.effects import ALL, SPEC, effects_gateway, events
from support.searching import examples
from support.simulated_time import on_simulated_time, run_simulated
from unity_link import ArgumentError, UnsupportedError, blocking
from unity_link.data import Group
from unity_link.data.blocking import put
from unity_link.data.writing import NOT_POSTED, write_values
from unity_link.protocol.wire.configuration import Feature
from unity_link.virtual.faults import Noise, NoisyLine

if TYPE_CHECKING:
    from unity_link.virtual import Gateway

Robot = unity_link.load(SPEC)


async def flags(robot: Any) -> tuple[bool, bool, int]:
    return await robot.alarm[0].get(), await robot.alarm[1].get(), await robot.lost.get()


@on_simulated_time
async def test_a_signal_cleared_by_reads_is_returned_once_and_others_stay() -> None:
    async with unity_link.connect(effects_gateway()) as link:
        robot = Robot(link)
        await robot.make.set(events(seen=0x81, hit=1))
        assert await robot.hit.get() is True
        assert await robot.hit.get() is False
        await robot.make.set(events(seen=0x10))
        assert await robot.seen.get() == 0x91
        assert robot.seen.value == 0x91
        assert await robot.seen.get() == 0


def noisy(seed: int) -> Gateway:
    flips = 0.004
    return NoisyLine(effects_gateway(), Noise(2 * seed, flip=flips), Noise(2 * seed + 1, loss=flips / 2, flip=flips))


@pytest.mark.parametrize("seed", range(4))
@on_simulated_time
async def test_no_event_is_lost_or_returned_twice_on_a_line_that_loses_answers(seed: int) -> None:
    chance = random.Random(seed)
    async with unity_link.connect(noisy(seed)) as link:
        robot = Robot(link)
        repeated = link.statistics.repetitions
        for _ in range(150):
            made = chance.getrandbits(8)
            await robot.make.set(events(seen=made, hit=made & 1))
            assert await robot.seen.get() == made
            assert await robot.hit.get() == bool(made & 1)
        assert link.statistics.repetitions > repeated


@on_simulated_time
async def test_a_written_1_clears_only_its_bit_without_masked_writes() -> None:
    async with unity_link.connect(effects_gateway(ALL & ~Feature.MASKED_WRITE)) as link:
        robot = Robot(link)
        await robot.make.set(events(alarm=3, lost=0xFF))
        await robot.alarm[0].set(True)
        assert await flags(robot) == (False, True, 0xFF)
        await robot.lost.set(0x0F)
        await robot.alarm[0].set(False)
        await robot.alarm[1].post(False)
        assert await flags(robot) == (False, True, 0xF0)
        await robot.shoot.set(True)
        assert await flags(robot) == (False, True, 0xF0)


@settings(max_examples=examples(30), deadline=None)
@given(
    made=st.integers(0, 0x3FF),
    cleared=st.fixed_dictionaries(
        {},
        optional={
            "alarm[0]": st.booleans(),
            "alarm[1]": st.booleans(),
            "lost": st.integers(0, 255),
            "shoot": st.booleans(),
        },
    ),
    posted=st.booleans(),
)
def test_fields_written_together_clear_the_bits_that_each_would_clear(
    made: int, cleared: dict[str, Any], posted: bool
) -> None:
    async def check() -> None:
        async with unity_link.connect(effects_gateway()) as link:
            robot = Robot(link)
            await robot.make.set(events(alarm=made & 3, lost=made >> 2))
            values = {robot[path]: value for path, value in cleared.items()}
            await write_values(values, posted_by=asyncio.current_task() if posted else NOT_POSTED)
            await link.fence()
            left = [bool(made >> bit & 1) and not cleared.get(f"alarm[{bit}]") for bit in range(2)]
            assert await flags(robot) == (*left, made >> 2 & ~cleared.get("lost", 0))
            assert await robot.shots.get() == cleared.get("shoot", False)

    run_simulated(check())


@on_simulated_time
async def test_a_pulse_and_a_plain_field_of_one_word_do_not_affect_each_other() -> None:
    async with unity_link.connect(effects_gateway()) as link:
        robot = Robot(link)
        await robot.mode.set(5)
        await robot.start.set(True)
        assert await robot.start.get() is False
        await robot.mode.set(6)
        await robot.start.set(False)
        assert (await robot.mode.get(), await robot.starts.get()) == (6, 1)


@on_simulated_time
async def test_a_value_written_to_a_signal_with_an_effect_is_not_stored() -> None:
    async with unity_link.connect(effects_gateway()) as link:
        robot = Robot(link)
        await robot.make.set(events(lost=3))
        assert await robot.lost.get() == 3
        await robot.lost.set(1)
        await robot.shoot.post(True)
        await write_values({robot.start: True})
        assert (robot.lost.value, robot.shoot.value, robot.start.value) == (3, None, None)


@on_simulated_time
async def test_a_signal_cleared_by_reads_is_in_no_group_and_no_sample() -> None:
    sentence = "seen is cleared by each read, and is read by its `get` alone"
    async with unity_link.connect(effects_gateway()) as link:
        robot = Robot(link)
        for group in (Group(robot.seen), Group(robot.mode, robot.seen)):
            with pytest.raises(ArgumentError, match=sentence):
                await group.get()
            with pytest.raises(ArgumentError, match=sentence):
                group.subscribe(trigger=True)
            with pytest.raises(ArgumentError, match=sentence):
                group.subscribe(rate_hz=10)
        with pytest.raises(ArgumentError, match=sentence):
            await Group.polled(10, [robot.seen]).subscribe().__aenter__()
        with pytest.raises(ArgumentError, match="seen"):
            await anext(robot.seen.samples())


@on_simulated_time
async def test_a_sample_of_a_signal_cleared_by_a_1_does_not_clear_it() -> None:
    async with unity_link.connect(effects_gateway()) as link:
        robot = Robot(link)
        await robot.make.set(events(alarm=2, lost=7))
        async with robot.groups["flags"].subscribe() as samples:
            for _ in range(3):
                sample = await anext(samples)
                assert [bool(sample[robot.alarm[0]]), bool(sample[robot.alarm[1]]), int(sample[robot.lost])] == [
                    False,
                    True,
                    7,
                ]


@on_simulated_time
async def test_signals_cleared_by_reads_require_queue_commands() -> None:
    async with unity_link.connect(effects_gateway(ALL & ~Feature.QUEUE_COMMANDS)) as link:
        robot = Robot(link)
        await robot.make.set(events(seen=1))
        with pytest.raises(UnsupportedError) as caught:
            await robot.seen.get()
        said = "seen is cleared by each read, which takes the queue commands that the gateway was built without"
        assert str(caught.value) == said
        assert link.statistics.errors == 0


def test_a_blocking_robot_reads_an_event_once_too() -> None:
    with blocking.connect(effects_gateway()) as link:
        robot: Any = put(Robot, link)
        robot.make.set(events(seen=9))
        assert (robot.seen.get(), robot.seen.get()) == (9, 0)

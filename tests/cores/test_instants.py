"""Instants far from the gateway's clock (a schedule has 40 bits of it, a sample 32), and timelines that fail."""

from __future__ import annotations

import asyncio
import math
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import unity_link
from support.searching import examples
from support.simulated_time import on_simulated_time
from unity_link import ArgumentError, BusError, GatewayResetError, LateError
from unity_link.cores.batches import AHEAD, BEHIND, TIME
from unity_link.cores.clock import Instant
from unity_link.spec import compile_text
from unity_link.virtual.build import simulated
from unity_link.virtual.simulated import SimulatedRobot

if TYPE_CHECKING:
    from unity_link.spec import Value

HZ = 50_000_000
SPEC = compile_text("""
group state(RATE=10, TIMESTAMPS);
public robot() {
  GATEWAY(ADDRESS_BITS=12);
  free: SCHEDULE(DEPTH=64) @(0x100);
  @lamp = 0x40: unsigned 8 READWRITE(TIMED(free));
  @place = 0x41: READ(PUBLISH(state));
}
""")
Robot = unity_link.load(SPEC)


class Plant(SimulatedRobot):
    """Records the values of the lamp, and the cycles in which they were written."""

    def start(self) -> None:
        self.seen: list[tuple[int, Value]] = []

    def written(self, path: str, value: Value) -> None:
        if path == "lamp":
            self.seen.append((self.cores.now, value))


def gateway_of() -> Any:
    return simulated(SPEC.interface(), Plant)


async def seen_until(gateway: Any, seconds: float) -> list[tuple[int, Value]]:
    """Let time pass, and return the writes to the lamp."""
    await asyncio.sleep(seconds)
    gateway.robot.pass_time(asyncio.get_running_loop().time())
    seen: list[tuple[int, Value]] = gateway.robot.seen
    return seen


EDGES = (-BEHIND, 0, AHEAD)
"""Ticks from the clock at which the outcome of a write changes; the clock is known to within a second here."""


@given(
    uptime=st.sampled_from([0, 1, 4 * 3600, 30 * 3600]),
    ahead=st.one_of(
        st.integers(-3 * TIME, 3 * TIME),
        st.integers(-AHEAD, AHEAD),
        st.sampled_from([edge + side for edge in (*EDGES, -AHEAD, TIME, -TIME) for side in (-HZ, HZ)]),
    ).filter(lambda ticks: all(abs(ticks - edge) >= HZ for edge in EDGES)),
)
@settings(max_examples=examples(30))
@on_simulated_time
async def test_a_write_acts_at_its_instant_or_not_at_all(uptime: float, ahead: int) -> None:
    gateway = gateway_of()
    async with unity_link.connect(gateway) as link:
        robot: Any = Robot(link)
        await asyncio.sleep(uptime)
        clock = await robot.free.clock()
        at = Instant(clock.now().ticks + ahead, HZ)
        if 0 < ahead < AHEAD:
            await (await robot.lamp.set(1, at=at))
            assert gateway.robot.seen == [(at.ticks, 1)]
            return
        is_near = -BEHIND < ahead < 0
        with pytest.raises(LateError if is_near else ArgumentError):
            await (await robot.lamp.set(1, at=at))
        assert await seen_until(gateway, TIME / HZ) == []


@on_simulated_time
async def test_the_error_for_an_instant_too_far_from_the_clock_has_the_distance() -> None:
    async with unity_link.connect(gateway_of()) as link:
        robot: Any = Robot(link)
        await asyncio.sleep(6 * 3600)
        clock = await robot.free.clock()
        expected = "free takes instants from 5498 s before the gateway's clock to 10995 s after it: "
        with pytest.raises(ArgumentError, match=rf"{expected}43590.* is 21991 s after it"):
            await robot.lamp.set(1, at=clock.now().after(21990.7))
        with pytest.raises(ArgumentError, match=rf"{expected}0\.0* s of the gateway's clock is 21600 s before it"):
            await robot.lamp.set(1, at=Instant(0, HZ))
        with pytest.raises(
            ArgumentError, match=r"the lead of free is a number of seconds below 10995, .*, not 1000000"
        ):
            robot.free.timeline(lead=1e6)
        async with robot.free.timeline(lead=0.1) as line:
            with pytest.raises(ArgumentError, match="free takes instants"):
                await line.set({robot.lamp: 1}, at=line.instant.after(11000))
            line.delay(11000)
            with pytest.raises(ArgumentError, match="free takes instants"):
                await line.set({robot.lamp: 1})
            line.delay(-11000)
            await line.set({robot.lamp: 2})
            assert await line.flush() == 1


@on_simulated_time
async def test_a_trajectory_with_a_pause_longer_than_the_clock_is_played() -> None:
    gateway = gateway_of()
    async with unity_link.connect(gateway) as link:
        robot: Any = Robot(link)
        times = np.array([0, 12_000, 40_000])
        assert await robot.free.play(times, {robot.lamp: [1, 2, 3]}, lead=0.1) == 3
        (first, _), *others = gateway.robot.seen
        assert others == [(first + 12_000 * HZ, 2), (first + 40_000 * HZ, 3)]


@on_simulated_time
async def test_a_timeline_that_fails_to_start_leaves_its_schedule_free() -> None:
    gateway = gateway_of()
    async with unity_link.connect(gateway) as link:
        robot: Any = Robot(link)

        async def start(lead: float = 0.01) -> None:
            async with robot.free.timeline(lead=lead) as line:
                await line.set({robot.lamp: 1})
                await line.flush()

        for lead in (math.nan, math.inf, 1e308):
            with pytest.raises(ArgumentError):
                await start(lead)
            await start()
        gateway.robot.set_fault("free.cancel")
        with pytest.raises(BusError):
            await start()
        gateway.robot.set_fault("free.cancel", on=False)
        for turns in range(60):
            starting = asyncio.create_task(start())
            for _ in range(turns):
                await asyncio.sleep(0)
            starting.cancel()
            await asyncio.wait([starting])
            # Cancelled writes end within cycles, and simulated time passes only while all tasks wait.
            await asyncio.sleep(0.001)
            await start()


@on_simulated_time
async def test_the_instant_of_an_old_sample_is_exact() -> None:
    async with unity_link.connect(gateway_of()) as link:
        robot: Any = Robot(link)
        clock = await robot.free.clock()
        async with robot.groups["state"].subscribe() as samples:
            sample = await anext(samples)
            instant = clock.sampled(sample.time)
        for seconds in (30, 60, 90, 1000, 5000):
            await asyncio.sleep(seconds)
            assert clock.sampled(sample.time) == instant


@on_simulated_time
async def test_a_sample_from_before_a_reset_has_no_instant() -> None:
    gateway = gateway_of()
    async with unity_link.connect(gateway) as link:
        robot: Any = Robot(link)
        await asyncio.sleep(100)
        clock = await robot.free.clock()
        async with link.subscribe([0x41], rate_hz=10) as samples:
            before = await anext(samples)
            gateway.reset()
            with pytest.raises(GatewayResetError):
                await robot.lamp.set(1)
            while (sample := await anext(samples)).epoch == before.epoch:
                pass
        await robot.free.clock()
        assert abs(clock.sampled(sample.time).ticks - clock.now().ticks) < HZ
        with pytest.raises(ArgumentError, match=r"the sample of .* was taken before the gateway was reset"):
            clock.sampled(before.time)

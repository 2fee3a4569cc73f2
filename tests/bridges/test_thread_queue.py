"""Samples from the event loop to a thread: each received sample is handed over."""

from __future__ import annotations

import asyncio
import contextlib
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING

import pytest

import unity_link
from support.recordings import InPlace
from support.sharing import PipedLink, sharing, until
from support.simulated_time import run_simulated
from support.valve import Valve
from unity_link import GatewayInfo
from unity_link.bridges.sampled import sampled_groups
from unity_link.bridges.thread_queue import Carrier
from unity_link.data import load
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing

if TYPE_CHECKING:
    from pathlib import Path

    from unity_link.data import Batch

SPEC = """
group fast(1, 1, TIMESTAMPS);
public both() {
  @value = 0x10: unsigned READ(PUBLISH(fast));
  @polled = 0x11: unsigned READ(POLL(100));
}
"""
GATEWAY = "sim:?base_frequency_millihertz=1000000"


def test_all_received_samples_are_handed_over_at_the_end_to_a_slow_consumer(tmp_path: Path) -> None:
    (tmp_path / "both.ul").write_text(SPEC)
    robot_type = load(tmp_path / "both.ul")
    taken: dict[int, list[int]] = {0: [], 1: []}
    busy, free = threading.Event(), threading.Event()

    def take_slowly(number: int, batch: Batch) -> None:
        busy.set()
        free.wait()
        taken[number] += batch.sequence.tolist()

    async def carry() -> Carrier:
        async with unity_link.connect(GATEWAY) as link:
            groups = [sampled.group for sampled in sampled_groups(robot_type(link))]
            carrier = Carrier(groups, take_slowly, print, buffer=1 << 16)
            running = asyncio.create_task(carrier.run(ThreadPoolExecutor(1)))
            await asyncio.to_thread(busy.wait)
            while link.statistics.samples < 100:  # noqa: ASYNC110  (no event reports samples before they are taken)
                await asyncio.sleep(0)
            running.cancel()
            free.set()
            with pytest.raises(asyncio.CancelledError):
                await running
            assert carrier.carried - len(taken[1]) == link.statistics.samples - link.statistics.samples_lost
            return carrier

    carrier = asyncio.run(carry())

    assert taken[0] == list(range(len(taken[0])))
    assert carrier.carried == sum(map(len, taken.values()))


def test_refused_polled_read_is_reported_once_and_others_continue(tmp_path: Path) -> None:
    (tmp_path / "both.ul").write_text(SPEC)
    robot_type = load(tmp_path / "both.ul")
    gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=1_000_000))
    failing = Failing(ErrorCode.BUS_TIMEOUT)
    gateway.bus.attach(failing, [0x11])
    told: list[str] = []
    taken = [0, 0]

    def take(number: int, batch: Batch) -> None:
        taken[number] += len(batch)

    async def carry() -> Carrier:
        async with unity_link.connect(gateway) as link:
            groups = [sampled.group for sampled in sampled_groups(robot_type(link))]
            carrier = Carrier(groups, take, told.append, buffer=1 << 16)
            running = asyncio.create_task(carrier.run(ThreadPoolExecutor(1)))
            while taken[0] < 200 and not running.done():  # noqa: ASYNC110  (a thread takes them)
                await asyncio.sleep(0.01)
            running.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await running
            return carrier

    carrier = asyncio.run(carry())
    assert taken[1] == 0
    assert carrier.lost > 0
    assert told == ["read of polled at 0x11: nothing on the bus answered (told once)"]


def test_polls_during_a_slow_end_are_not_lost(tmp_path: Path) -> None:
    (tmp_path / "both.ul").write_text(SPEC)
    robot_type = load(tmp_path / "both.ul")

    async def end_slowly() -> None:
        try:
            await asyncio.get_running_loop().create_future()
        finally:
            await asyncio.sleep(1)

    async def carry() -> Carrier:
        async with unity_link.connect(GATEWAY) as link:
            groups = [sampled.group for sampled in sampled_groups(robot_type(link))]
            carrier = Carrier(groups, lambda *_: None, print, buffer=1 << 16)
            running = asyncio.create_task(carrier.run(InPlace(), end_slowly()))
            await asyncio.sleep(1)
            running.cancel()
            with pytest.raises(asyncio.CancelledError):
                await running
            return carrier

    carrier = run_simulated(carry())
    assert carrier.carried > 1000
    assert carrier.lost == 0


@pytest.mark.slow
def test_a_shared_gateway_that_is_away_at_the_beginning_is_waited_for(tmp_path: Path) -> None:
    (tmp_path / "both.ul").write_text(SPEC)
    robot_type = load(tmp_path / "both.ul")
    told: list[str] = []

    async def carry() -> Carrier:
        gateway = Valve(VirtualGateway(GatewayInfo(base_frequency_millihertz=1_000_000)))
        async with sharing(gateway) as shared, PipedLink(shared) as link:
            gateway.go_away(shared)
            await until(lambda: shared.away)
            groups = [sampled.group for sampled in sampled_groups(robot_type(link))]
            carrier = Carrier(groups, lambda *_: None, told.append, buffer=1 << 16)
            running = asyncio.create_task(carrier.run(InPlace()))
            await asyncio.sleep(10)
            assert carrier.received == 0
            gateway.come_back()
            await asyncio.sleep(10)
            running.cancel()
            with pytest.raises(asyncio.CancelledError):
                await running
            return carrier

    carrier = run_simulated(carry())
    assert carrier.carried > 1000
    assert told == ["starting a group: nothing on the bus answered (told once)"]


def test_quickest_rate_counts_only_groups_that_always_publish(tmp_path: Path) -> None:
    (tmp_path / "robot.ul").write_text("""
group changed(1, 1, ON_CHANGE);
group steady(2, 100);
public robot() {
  @a = 0x10: READ(PUBLISH(changed));
  @b = 0x11: READ(PUBLISH(steady));
  @c = 0x12: READ(POLL(2));
}
""")
    robot_type = load(tmp_path / "robot.ul")

    async def rate_of(*names: str) -> float | None:
        async with unity_link.connect(VirtualGateway(GatewayInfo(base_frequency_millihertz=1_000_000))) as link:
            groups = [sampled.group for sampled in sampled_groups(robot_type(link)) if sampled.name in names]
            carrier = Carrier(groups, lambda *_: None, print, buffer=1 << 16)
            running = asyncio.create_task(carrier.run(InPlace()))
            await carrier.begun.wait()
            rate = carrier.rate_hz
            running.cancel()
            await asyncio.wait([running])
            return rate

    assert run_simulated(rate_of("changed", "steady", "poll_2_hz")) == 10
    assert run_simulated(rate_of("changed", "poll_2_hz")) == 2
    assert run_simulated(rate_of("changed")) is None

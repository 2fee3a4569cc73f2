"""Samples on their way from the event loop to a thread: none of those that came is left behind."""

from __future__ import annotations

import asyncio
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING

import pytest

import unity_link
from unity_link.bridges.carrying import Carrier
from unity_link.bridges.sampled import sampled_groups
from unity_link.data import load

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


def test_at_the_end_all_that_has_come_is_handed_over_however_slow_who_takes_it_is(tmp_path: Path) -> None:
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
            carrier = Carrier(groups, take_slowly, buffer=1 << 16)
            running = asyncio.create_task(carrier.run(ThreadPoolExecutor(1)))
            await asyncio.to_thread(busy.wait)
            while link.statistics.samples < 100:  # noqa: ASYNC110  (nothing tells of samples that nobody takes)
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

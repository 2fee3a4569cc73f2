"""A reader that wants only the newest sample gets none that was taken before a pause."""

from __future__ import annotations

import asyncio
import threading
import time
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, cast

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import unity_link
from support.searching import examples
from unity_link import GatewayInfo, Sample
from unity_link.link.gateway_clock import GatewayClock
from unity_link.link.publishing import LatestSampleReceiver, Publishing, Schedule
from unity_link.protocol.wire.messages import SAMPLE_HEAD, TIMESTAMP_DIGITS, GroupFlag
from unity_link.virtual import VirtualGateway
from unity_link.virtual.serving import serve_pty, serve_tcp

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from contextlib import AbstractAsyncContextManager

CLOCK_HZ = 50_000_000
BASE_HZ = 1000
ON_WAY = 0.001
"""Seconds that a sample takes to arrive."""


class Host:
    """The host's side of a group from which only the newest sample is wanted.

    Args:
        divisor: divisor of the group.
        stamped: if true, samples have timestamps.
        callback: receives the samples.
        flags: further flags of the group.
    """

    def __init__(
        self,
        divisor: int,
        *,
        stamped: bool = True,
        callback: Callable[[Sample], object] | None = None,
        flags: GroupFlag = GroupFlag.PERIODIC,
    ) -> None:
        info = GatewayInfo(clock_hz=CLOCK_HZ, base_frequency_millihertz=BASE_HZ * 1000)
        session = SimpleNamespace(codec=SimpleNamespace(info=info), epoch=0)
        self.now = 0.0
        runtime = SimpleNamespace(
            time=lambda: self.now, create_future=lambda: asyncio.get_running_loop().create_future()
        )
        publishing = Publishing(cast("Any", SimpleNamespace(session=session)), cast("Any", runtime), "a gateway")
        publishing._clock = GatewayClock(CLOCK_HZ)
        flags |= GroupFlag.TIMESTAMP if stamped else GroupFlag(0)
        self.receiver = LatestSampleReceiver(publishing, Schedule((0,), divisor, flags), 1, "drop_oldest", callback)
        self.receiver.holder = self
        self.receiver.words_at = SAMPLE_HEAD + (TIMESTAMP_DIGITS if stamped else 0)
        self.receiver.length = self.receiver.words_at + 8
        self.receiver.restart()
        self._period, self._stamped = divisor / BASE_HZ, stamped

    def read(self, now: float, numbers: Sequence[int]) -> None:
        """Receive the samples with these numbers, all at once."""
        self.now = now
        bodies = [self._body(number) for number in numbers]
        if len(bodies) == 1:
            self.receiver.receive(bodies[0], now)
        elif bodies:
            self.receiver.receive_rows(np.array([np.frombuffer(body, np.uint8) for body in bodies]), now)

    def given(self) -> list[int]:
        """Return the numbers of the samples that a reader would get now."""
        return [int(self.receiver.next().values[0]) for _ in range(len(self.receiver.buffer))]

    def _body(self, number: int) -> bytes:
        ticks = round(number * self._period * CLOCK_HZ) % (1 << 32)
        return b"P00%02X" % (number % 256) + (b"%08X" % ticks if self._stamped else b"") + b"%08X" % number


@given(
    divisor=st.sampled_from([1, 5, 10, 100]),
    pause=st.sampled_from([0.5, 2.0, 30.0]),
    kept=st.floats(0.0, 1.0),
    chunk=st.integers(1, 200),
    stamped=st.booleans(),
)
@settings(max_examples=examples(40), deadline=None)
def test_samples_taken_before_a_pause_are_dropped_and_later_ones_returned(
    divisor: int, pause: float, kept: float, chunk: int, stamped: bool
) -> None:
    host, period = Host(divisor, stamped=stamped), divisor / BASE_HZ
    for number in range(50):
        host.read(number * period + ON_WAY, [number])
    assert host.given() == [49]
    began = 49 * period + ON_WAY
    resumed = began + max(pause, 10 * period)
    first_after = int(resumed / period) + 1
    # The time that a sample takes to arrive is unknown: one taken shortly before the resumption counts as newer.
    waited = range(50, 50 + int((int((resumed - 2 * ON_WAY) / period) - 50) * kept))
    now, given = resumed, []
    for start in range(0, len(waited), chunk):
        host.read(now, waited[start : start + chunk])
        given += host.given()
        now += period / 100
    after = [number for number in range(first_after, first_after + 1000) if number * period > now]
    for number in after:
        host.read(number * period + ON_WAY, [number])
        given += host.given()
    # Without timestamps the losses of a whole lap of numbers are invisible: samples seem old until they come steadily.
    late = 2 if stamped else 2 + int(1.1 / period) + 16
    assert given == after[after.index(given[0]) :]
    assert after.index(given[0]) <= late
    if stamped:
        assert host.receiver.received == 50 + len(waited) + len(after)
        assert host.receiver.lost == after[-1] + 1 - 1 - len(given)


def test_lost_of_the_first_sample_after_a_pause_counts_dropped_samples() -> None:
    given: list[Sample] = []
    host = Host(10, callback=given.append)
    for number in range(10):
        host.read(number / 100 + ON_WAY, [number])
    host.read(10.0, range(10, 500))
    host.read(10.001, range(600, 700))
    host.read(10.01 + ON_WAY, [1001])
    assert [(sample.sequence, sample.lost) for sample in given[-2:]] == [(9, 0), (1001, 991)]
    assert host.receiver.lost == 991


@pytest.mark.asyncio
async def test_a_sample_taken_before_a_pause_does_not_wake_its_reader() -> None:
    host = Host(10)
    host.read(ON_WAY, [0])
    host.now = 30.0
    waiting = asyncio.create_task(host.receiver.wait())
    await asyncio.sleep(0)
    host.read(30.0, range(1, 500))
    await asyncio.sleep(0)
    assert not waiting.done()
    host.read(30.01 + ON_WAY, [3001])
    await waiting
    assert host.given() == [3001]
    assert host.receiver.lost == 3001


@pytest.mark.parametrize("stamped", [True, False])
def test_samples_are_returned_again_on_a_line_with_a_longer_delay(stamped: bool) -> None:
    host = Host(10, stamped=stamped)
    for number in range(100):
        host.read(number / 100 + ON_WAY, [number])
    host.given()
    for number in range(100, 200):
        host.read(number / 100 + 0.4, [number])
        assert bool(host.given()) == (number >= 140)


def test_the_last_sample_of_each_burst_is_returned() -> None:
    host, given = Host(1), []
    for batch in range(100):
        host.read(batch * 0.12 + 0.12 + ON_WAY, range(batch * 120, batch * 120 + 120))
        given += host.given()
    assert [number % 120 for number in given] == [119] * len(given)
    assert len(given) > 90


def test_the_last_sample_on_a_change_is_returned_even_if_it_is_old() -> None:
    host = Host(10, flags=GroupFlag.PERIODIC | GroupFlag.ON_CHANGE)
    host.read(ON_WAY, [0])
    host.given()
    host.read(30.0, [1, 2])
    assert host.given() == [2]


@pytest.mark.parametrize("serve_on", [serve_pty, serve_tcp])
def test_a_blocked_loop_gets_a_sample_that_was_taken_afterwards(
    serve_on: Callable[[VirtualGateway], AbstractAsyncContextManager[str]],
) -> None:
    gateway, changed, over = VirtualGateway(), threading.Event(), threading.Event()
    found: list[str] = []

    async def serve() -> None:
        async with serve_on(gateway) as url:
            found.append(url)
            changed.set()
            await asyncio.to_thread(over.wait)

    async def read(url: str) -> list[int]:
        async with unity_link.connect(url) as link, link.subscribe(0x10, rate_hz=2000, latest=True) as samples:
            assert (await anext(samples)).values[0] == 0
            time.sleep(1)  # noqa: ASYNC251  (it is to block the loop)
            gateway.memory[0x10] = 1
            return [int((await anext(samples)).values[0]) for _ in range(20)]

    serving = threading.Thread(target=asyncio.run, args=(serve(),))
    serving.start()
    try:
        assert changed.wait(60)
        assert asyncio.run(read(found[0])) == [1] * 20
    finally:
        over.set()
        serving.join()

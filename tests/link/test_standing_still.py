"""Samples that waited while the program was stopped are counted and dated as they were taken.

`support.taken_samples` generates the samples, so the true numbers and times are known.
"""

from __future__ import annotations

import itertools
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from support.searching import examples
from support.taken_samples import BASE_HZ, STORIES, Taken, are_decidable, arrivals_of, of_group
from unity_link import GatewayInfo, Sample
from unity_link.link.gateway_clock import GatewayClock
from unity_link.link.publishing import Publishing, SampleReceiver, Schedule
from unity_link.link.samples_together import SamplesTogether
from unity_link.protocol.host.events import SampledTogether
from unity_link.protocol.wire.messages import SAMPLE_HEAD, TIMESTAMP_DIGITS, GroupFlag


class Host:
    """The host's side of some periodic groups.

    Args:
        clock_hz: clock frequency of the gateway.
        divisors: divisors of the groups.
    """

    def __init__(self, clock_hz: int, divisors: list[int]) -> None:
        info = GatewayInfo(clock_hz=clock_hz, base_frequency_millihertz=BASE_HZ * 1000)
        session = SimpleNamespace(codec=SimpleNamespace(info=info), epoch=0)
        self.publishing = Publishing(cast("Any", SimpleNamespace(session=session)), cast("Any", None), "a gateway")
        self.publishing._clock = GatewayClock(clock_hz)
        self.publishing._together = SamplesTogether
        flags = GroupFlag.PERIODIC | GroupFlag.TIMESTAMP
        self.samples: list[list[Sample]] = [[] for _ in divisors]
        self.receivers = [
            SampleReceiver(self.publishing, Schedule((0,), divisor, flags), 1 << 30, "fail", samples.append)
            for divisor, samples in zip(divisors, self.samples, strict=True)
        ]
        for receiver in self.receivers:
            receiver.words_at = SAMPLE_HEAD + TIMESTAMP_DIGITS
            receiver.length = receiver.words_at + 8
            receiver.restart()

    def read(self, taken: list[Taken], now: float, way: str) -> None:
        """Receive the samples that have arrived, by one of the code paths that the session chooses from."""
        bodies = np.array([np.frombuffer(one.body(), np.uint8) for one in taken])
        if way == "one by one" or len(taken) < 2:
            for one in taken:
                self.receivers[one.group].receive(one.body(), now)
        elif way == "together":
            owners = [self.receivers[one.group] for one in taken]
            parts = [(np.arange(len(taken)), bodies)]
            self.publishing._receive_together(SampledTogether(cast("Any", owners), parts, now))
        else:
            at = 0
            for group, run in itertools.groupby(taken, lambda one: one.group):
                count = len(list(run))
                self.receivers[group].receive_rows(bodies[at : at + count], now)
                at += count


@given(
    **STORIES,
    divisors=st.lists(st.integers(100, 3000), min_size=1, max_size=2),
)
@settings(max_examples=examples(30), deadline=None)
def test_samples_are_counted_and_dated_as_taken_after_any_stop(
    reads: list[tuple[float, int, str]], clock_hz: int, divisors: list[int], began: int, seed: int
) -> None:
    host, arrivals = Host(clock_hz, divisors), arrivals_of(reads, clock_hz, divisors, began, seed)
    came = [of_group(arrivals, group) for group in range(len(divisors))]
    for truth, divisor in zip(came, divisors, strict=True):
        assume(are_decidable(truth, divisor, clock_hz))
    for arrival in arrivals:
        host.read(arrival.taken, arrival.now, arrival.way)
    for samples, truth in zip(host.samples, came, strict=True):
        assert [sample.sequence for sample in samples] == [one.number for one in truth]
        assert [sample.time for sample in samples] == [one.ticks / clock_hz for one in truth]
        assert sum(sample.lost for sample in samples) == truth[-1].number + 1 - len(truth)


@pytest.mark.parametrize("way", ["one by one", "together", "rows"])
@pytest.mark.parametrize("clock_hz", [50_000_000, 100_000_000])
def test_no_sample_is_counted_as_lost_after_a_minute_without_a_read(way: str, clock_hz: int) -> None:
    host, period = Host(clock_hz, [10]), 0.01
    taken = [Taken(number * period, 0, number, round(number * period * clock_hz)) for number in range(6200)]
    host.read(taken[:20], 0.2, way)
    host.read(taken[20:6020], 60.2, way)
    for number in range(6020, 6200, 2):
        host.read(taken[number : number + 2], number * period + 0.011, way)
    (samples,) = host.samples
    assert not any(sample.lost for sample in samples)
    assert [sample.time for sample in samples] == [one.ticks / clock_hz for one in taken]


@pytest.mark.parametrize("way", ["one by one", "together", "rows"])
def test_minutes_of_samples_dropped_by_a_full_buffer_are_counted(way: str) -> None:
    host, period, clock_hz = Host(100_000_000, [10]), 0.01, 100_000_000
    taken = [Taken(number * period, 0, number, round(number * period * clock_hz)) for number in range(60_100)]
    host.read(taken[:20], 0.2, way)
    host.read(taken[20:2000] + taken[58_003:60_000], 600.0, way)
    host.read(taken[60_000:], 601.0, way)
    (samples,) = host.samples
    assert [sample.lost for sample in samples if sample.lost] == [56_003]
    assert samples[-1].time == taken[-1].ticks / clock_hz

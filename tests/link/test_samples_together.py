"""Samples that arrive together are decoded in one go; the result is the same as decoding them one by one."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, NamedTuple

import pytest
from hypothesis import given
from hypothesis import strategies as st

import unity_link
from support.simulated_time import on_simulated_time, run_simulated
from support.valve import Valve, as_gateway
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from unity_link import Link, Subscription

CLOCK_HZ = 50_000_000
PERIOD = CLOCK_HZ // 1000


class Arriving(NamedTuple):
    """An arriving line: a sample `step` periods after the one before, damaged or replaced as `damage` says."""

    step: int
    damage: bytes | None


steady = st.just(Arriving(1, None))
doubled = st.just(Arriving(0, None))
missing = st.builds(Arriving, st.sampled_from([2, 200, 257, 513]) | st.integers(2, 700), st.none())
damaged = st.builds(Arriving, st.just(1), st.sampled_from([b"", b"\n", b"X", b"P0", b"P00", b"g", b"\r"]))
lines = st.lists(
    st.lists(steady, min_size=1, max_size=60) | st.lists(missing | doubled, max_size=2) | st.lists(damaged, max_size=2),
    max_size=8,
).map(lambda parts: [line for part in parts for line in part])


def frames_of(link: Link, samples: Subscription, arriving: list[Arriving], *, stamped: bool) -> list[bytes]:
    """Return the frames of samples whose values are their numbers, damaged as `arriving` says."""
    codec, group = link._session.codec, samples._group
    assert group is not None
    number, frames = -1, []
    for step, damage in arriving:
        number += step
        stamp = b"%08X" % (0xFFFF_0000 + number * PERIOD & 0xFFFF_FFFF) if stamped else b""
        body = b"P%b%02X%b%08X%08X" % (group.text, number & 0xFF, stamp, number, 0xFFFF_FFFF - number)
        frame = as_gateway(codec, body)
        if damage is not None:
            middle = len(frame) // 2
            frame = frame[:middle] + damage + frame[middle + 1 :]
        frames.append(frame)
    return frames


async def received(arriving: list[Arriving], *, stamped: bool, together: bool, buffer: int, crc_bits: int) -> object:
    """Return all that a program can observe of the samples that arrive."""
    gateway = VirtualGateway(
        GatewayInfo(clock_hz=CLOCK_HZ, base_frequency_millihertz=1_000_000, crc_bits=crc_bits, crc_polynomial=0x07)
    )
    async with (
        unity_link.connect(gateway) as link,
        link.subscribe([1, 2], rate_hz=1000, timestamps=stamped, buffer=buffer) as samples,
    ):
        frames = frames_of(link, samples, arriving, stamped=stamped)
        for piece in [b"".join(frames)] if together else frames:
            link._flow.receive(piece)
        # Lines that are decoded one by one are limited to 128 in a turn of the loop.
        for _ in range(1 + len(frames) // 128):
            await asyncio.sleep(0)
        seen = [
            (sample.sequence, sample.time, sample.values.tolist(), sample.values.dtype, sample.lost)
            for sample in (await samples.take() if samples._receiver.buffer else [])
        ]
        counted = link.statistics
        return seen, samples.received, samples.lost, counted.samples, counted.samples_lost, counted.damaged_frames


@pytest.mark.slow
@pytest.mark.parametrize("stamped", [True, False])
@pytest.mark.parametrize("crc_bits", [8, 32])
@given(arriving=lines, buffer=st.sampled_from([5, 10_000]))
def test_samples_that_arrive_together_are_the_same_as_one_by_one(
    arriving: list[Arriving], buffer: int, *, stamped: bool, crc_bits: int
) -> None:
    together, one_by_one = (
        run_simulated(received(arriving, stamped=stamped, together=together, buffer=buffer, crc_bits=crc_bits))
        for together in (True, False)
    )
    assert together == one_by_one


class DoublingLine(Valve):
    """Delivers each sample twice."""

    def advance(self, now: float, room: int | None = None) -> bytes:
        answer = super().advance(now, room)
        return 2 * answer if answer.startswith(b"P") else answer


@on_simulated_time
async def test_a_sample_that_a_line_duplicates_is_delivered_once() -> None:
    line = DoublingLine(VirtualGateway(GatewayInfo(base_frequency_millihertz=1_000_000)))
    async with unity_link.connect(line) as link, link.subscribe([1], rate_hz=1000) as subscription:
        sequences = [(await anext(subscription)).sequence for _ in range(30)]
        assert sequences == list(range(30))
        assert subscription.lost == 0

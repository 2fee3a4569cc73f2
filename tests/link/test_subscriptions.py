"""Samples that a gateway takes by itself, in every form. Time is simulated in tests that depend on it."""

from __future__ import annotations

import asyncio
import contextlib
from typing import TYPE_CHECKING, Any

import anyio
import numpy as np
import pytest

import unity_link
from support.counting_device import CountingDevice
from support.logged import told
from support.makers import CRC_32, SLOW, Maker
from support.simulated_time import on_simulated_time
from unity_link import ArgumentError, Feature, LinkLostError, Sample, SamplesLostError, UnsupportedError
from unity_link.link.gateway_clock import GatewayClock
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Noise, NoisyLine
from unity_link.virtual.gateway import Gateway

if TYPE_CHECKING:
    from unity_link import Link, Subscription


async def take(samples: Subscription, count: int) -> list[Sample]:
    return [await anext(samples) for _ in range(count)]


# On every kind of gateway


@pytest.mark.asyncio
async def test_a_subscription_returns_the_words_of_its_addresses(link: Link, gateway: Gateway) -> None:
    await link.write_block(0x10, [1, 2, 3])
    async with link.subscribe([0x12, 0x10], rate_hz=200) as samples:
        first, second = await take(samples, 2)
    assert first.values.tolist() == second.values.tolist() == [3, 1]
    assert first.values.dtype == np.uint32
    assert (first.sequence, second.sequence) == (0, 1)
    assert (first.lost, second.lost) == (0, 0)
    assert first.arrived <= second.arrived
    assert first.time is not None
    assert second.time is not None
    assert second.time - first.time == pytest.approx(1 / 200)


@pytest.mark.asyncio
async def test_a_sample_can_be_requested(link: Link) -> None:
    async with link.subscribe(0x10) as samples:
        assert samples.rate_hz is None
        for value in range(600):
            await link.write(0x10, value)
            await samples.publish()
        taken = await take(samples, 600)
    assert [sample.values.tolist() for sample in taken] == [[value] for value in range(600)]
    assert [sample.sequence for sample in taken] == list(range(600))
    assert (samples.lost, samples.received) == (0, 600)


@pytest.mark.asyncio
async def test_samples_and_batches_are_transferred_concurrently(link: Link) -> None:
    async with link.subscribe([1, 2, 3], rate_hz=5000) as samples:
        await link.write_many(range(0x80), range(0x80))
        for _ in range(5):
            assert (await link.read_many(list(range(0x80)) * 20)).tolist() == list(range(0x80)) * 20
        assert (await anext(samples)).values.size == 3


@pytest.mark.asyncio
async def test_samples_without_timestamps_have_no_time(link: Link) -> None:
    async with link.subscribe([0], timestamps=False, immediate=True) as samples:
        await samples.publish()
        assert (await anext(samples)).time is None


@pytest.mark.asyncio
async def test_a_callback_is_called_with_each_sample(link: Link) -> None:
    seen: list[Sample] = []
    async with link.subscribe([0x10], callback=seen.append) as samples:
        for _ in range(3):
            await samples.publish()
    assert [sample.sequence for sample in seen] == [0, 1, 2]


@pytest.mark.asyncio
async def test_a_callback_that_raises_is_logged_and_the_link_goes_on(
    link: Link, caplog: pytest.LogCaptureFixture
) -> None:
    def fail(sample: Sample) -> None:
        raise ZeroDivisionError(sample.sequence)

    async with link.subscribe([0x10], callback=fail) as samples:
        await samples.publish()
        await samples.publish()
    # The error is logged once for each type of exception.
    ((message, error),) = told(caplog)
    assert message == "a subscription's callback raised ZeroDivisionError (told once)"
    assert str(error) == "0"
    assert await link.read(0) == 0


@pytest.mark.asyncio
async def test_two_subscriptions_receive_their_own_samples(link: Link) -> None:
    await link.write_block(0, [10, 11])
    async with link.subscribe([0]) as one, link.subscribe([1]) as other:
        await other.publish()
        await one.publish()
        assert (await anext(one)).values.tolist() == [10]
        assert (await anext(other)).values.tolist() == [11]


@pytest.mark.asyncio
async def test_the_error_for_a_subscription_without_a_block_shows_the_code() -> None:
    async with unity_link.connect("sim:") as link:
        samples = link.subscribe([0x10], rate_hz=100)
        for ask in (samples.take, samples.__anext__, samples.publish):
            with pytest.raises(ArgumentError, match="write `async with"):
                await ask()
        async with samples:
            assert (await anext(samples)).sequence == 0


@pytest.mark.asyncio
async def test_iteration_ends_with_the_block(link: Link) -> None:
    async with link.subscribe([0]) as samples:
        await samples.publish()
    assert [sample.sequence async for sample in samples] == [0]


@pytest.mark.asyncio
async def test_the_end_of_the_block_ends_a_waiting_reader(link: Link) -> None:
    async def read(samples: Subscription) -> list[Sample]:
        return [sample async for sample in samples]

    async with link.subscribe([0]) as samples:
        reader = asyncio.create_task(read(samples))
        await samples.publish()
    assert len(await reader) == 1


@pytest.mark.asyncio
async def test_only_one_task_reads_a_subscription(link: Link) -> None:
    async with link.subscribe([0]) as samples:
        reader = asyncio.ensure_future(anext(samples))
        await asyncio.sleep(0)
        with pytest.raises(ArgumentError, match="another task is already waiting"):
            await anext(samples)
        await samples.publish()
        assert (await reader).sequence == 0


@pytest.mark.asyncio
async def test_a_reader_that_was_cancelled_loses_no_sample(link: Link) -> None:
    async with link.subscribe([0]) as samples:
        with anyio.move_on_after(0.001):
            await anext(samples)
        await samples.publish()
        assert (await anext(samples)).sequence == 0


@pytest.mark.asyncio
async def test_a_closed_subscription_publishes_nothing(link: Link) -> None:
    samples = link.subscribe([0])
    with pytest.raises(ArgumentError, match="not open"):
        await samples.publish()


@pytest.mark.asyncio
async def test_all_groups_can_be_in_use_and_are_free_again_afterwards(make_gateway: Maker) -> None:
    async with unity_link.connect(make_gateway(groups=4)) as link:
        for _ in range(4):
            async with link.subscribe([0]), link.subscribe([1]), link.subscribe([2]), link.subscribe([3]) as last:
                with pytest.raises(UnsupportedError, match="all 4 groups of the gateway are in use"):
                    await link.subscribe([4]).__aenter__()
                await last.publish()
                assert (await anext(last)).sequence == 0


@pytest.mark.asyncio
async def test_a_reused_group_starts_with_number_0(link: Link) -> None:
    async with link.subscribe([0x20]), contextlib.AsyncExitStack() as others:
        # Use all groups but one.
        for _ in range(link.gateway.groups - 2):
            await others.enter_async_context(link.subscribe([0x20]))
        for address in range(20):
            await link.write(address, address)
            async with link.subscribe([address]) as samples:
                for sequence in range(3):
                    await samples.publish()
                    sample = await anext(samples)
                    assert (sample.sequence, sample.values.tolist()) == (sequence, [address])
                assert samples.lost == 0


@pytest.mark.asyncio
@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"addresses": []}, "0 addresses .* expected 1 to {most}$"),
        ({"addresses": range(256)}, "256 addresses"),
        ({"addresses": [0x100]}, "is not from 0 to 0xff"),
        ({"addresses": [-1]}, "address -0x1 is not from 0 to 0xff"),
        ({"addresses": [0.5]}, "whole numbers"),
        ({"addresses": [[1], [2, 3]]}, "whole numbers"),
        ({"addresses": 0, "rate_hz": 0.1}, r"0\.1 Hz was asked for, expected {lowest:.3g} to {highest:g} Hz"),
        ({"addresses": 0, "rate_hz": 100_001}, "expected {lowest:.3g} to {highest:g}"),
        ({"addresses": 0, "rate_hz": float("nan")}, "a rate is a number of Hz, not nan"),
        ({"addresses": 0, "rate_hz": -5}, "-5 Hz"),
        ({"addresses": 0, "divisor": 0}, "divisor of 0"),
        ({"addresses": 0, "divisor": 65536}, "expected 1 to 65535"),
        ({"addresses": 0, "divisor": 1, "rate_hz": 100}, "a rate and a divisor"),
        ({"addresses": 0, "group": 1.0}, "a group is a whole number, not 1.0"),
        ({"addresses": 0, "group": "1"}, "a group is a whole number, not '1'"),
        ({"addresses": 0, "buffer": 0}, "at least 1"),
        ({"addresses": 0, "overflow": "explode"}, '"drop_oldest" or "fail", not \'explode\''),
    ],
    ids=lambda value: str(value)[:50],
)
async def test_a_wrong_subscription_raises_before_a_request_is_sent(
    link: Link, arguments: dict[str, Any], message: str
) -> None:
    sent, info = link.statistics.bytes_sent, link.gateway
    highest = info.base_frequency_hz
    expected = message.format(most=info.group_words, lowest=highest / 65535, highest=highest)
    with pytest.raises(ArgumentError, match=expected):
        link.subscribe(**arguments)
    assert link.statistics.bytes_sent == sent


@pytest.mark.asyncio
@pytest.mark.parametrize(
    ("features", "arguments", "name"),
    [
        (Feature(0), {}, "groups"),
        (Feature.GROUPS, {"trigger": True}, "external triggers"),
        (Feature.GROUPS, {"timestamps": True}, "timestamps"),
    ],
)
async def test_the_error_for_a_missing_feature_names_it(
    make_gateway: Maker, features: Feature, arguments: dict[str, Any], name: str
) -> None:
    async with unity_link.connect(make_gateway(features=features | Feature.FLOW_CONTROL)) as link:
        with pytest.raises(UnsupportedError, match=f"built without {name}"):
            link.subscribe([0], **arguments)


@pytest.mark.asyncio
async def test_timestamps_are_used_if_the_gateway_has_them(make_gateway: Maker) -> None:
    async with (
        unity_link.connect(make_gateway(features=Feature.GROUPS | Feature.FLOW_CONTROL)) as link,
        link.subscribe([0]) as samples,
    ):
        await samples.publish()
        assert (await anext(samples)).time is None


# On simulated time


@on_simulated_time
async def test_samples_arrive_at_the_requested_rate(make_bare: Maker) -> None:
    async with unity_link.connect(make_bare(**SLOW)) as link:
        async with link.subscribe([0], rate_hz=300) as samples:
            assert samples.rate_hz == pytest.approx(1000 / 3)
            taken = await take(samples, 100)
        times = [sample.time for sample in taken if sample.time is not None]
        assert np.diff(times) == pytest.approx(0.003)
        async with link.subscribe([0], divisor=10) as samples:
            assert samples.rate_hz == 100


@on_simulated_time
async def test_an_external_trigger_takes_samples(make_bare: Maker) -> None:
    gateway = make_bare(**SLOW)
    async with unity_link.connect(gateway) as link, link.subscribe([0], trigger=True) as samples:
        for value in range(3):
            await link.write(0, value)
            gateway.trigger(asyncio.get_running_loop().time())
            assert (await anext(samples)).values.tolist() == [value]


@pytest.mark.slow
@on_simulated_time
async def test_only_changes_arrive_with_on_change_and_none_counts_as_lost(make_bare: Maker) -> None:
    async with (
        unity_link.connect(make_bare(**SLOW)) as link,
        link.subscribe([0, 1], rate_hz=1000, on_change=True) as samples,
    ):
        seen = [(await anext(samples)).values.tolist()]
        for value in range(1, 6):
            await asyncio.sleep(10)
            await link.write(1, value)
            seen.append((await anext(samples)).values.tolist())
        await asyncio.sleep(10)
        assert seen == [[0, value] for value in range(6)]
        assert (samples.received, samples.lost) == (6, 0)


@pytest.mark.slow
@on_simulated_time
async def test_time_continues_over_wraps_of_timestamps_and_long_silence(make_bare: Maker) -> None:
    async with unity_link.connect(make_bare(clock_hz=50_000_000)) as link, link.subscribe([0]) as samples:
        times: list[float] = []
        for pause in [1, 40, 3, 43, 500, 3600, 0.5, 0]:
            await samples.publish()
            sample = await anext(samples)
            assert sample.time is not None
            times.append(sample.time)
            await asyncio.sleep(pause)
    # A requested sample takes a little time in the gateware.
    assert np.diff(times) == pytest.approx([1, 40, 3, 43, 500, 3600, 0.5], abs=1e-4)


def test_the_time_of_samples_follows_a_gateway_clock_that_is_slightly_off() -> None:
    clock, start = GatewayClock(50_000_000), 12345
    for step in range(100):
        here = step * 60.0
        ticks = start + int(here * 50_000_000 * 1.0001)
        assert clock.seconds(ticks & 0xFFFFFFFF, here) == pytest.approx(ticks / 50_000_000)


def test_a_sample_overtaken_by_another_has_an_earlier_time() -> None:
    clock = GatewayClock(1000)
    assert clock.seconds(0x10, 0.0) == 0.016
    assert clock.seconds(0x05, 0.0) == 0.005
    assert clock.seconds(0xFFFFFFFF, 0.0) == -0.001


class Dropping:
    """A gateway that does not send chosen samples."""

    open = Gateway.open

    def __init__(self, gateway: Gateway) -> None:
        self.info, self.wake = gateway.info, gateway.wake
        self.gateway = gateway
        self.dropping = False
        self._rest = b""

    def __getattr__(self, name: str) -> Any:
        return getattr(self.gateway, name)

    def _filtered(self, data: bytes) -> bytes:
        *frames, self._rest = (self._rest + data).split(b"\n")
        return b"".join(frame + b"\n" for frame in frames if not (self.dropping and frame.startswith(b"P")))

    def receive(self, data: bytes, now: float) -> bytes:
        return self._filtered(self.gateway.receive(data, now))

    def advance(self, now: float, room: int | None = None) -> bytes:
        return self._filtered(self.gateway.advance(now, room))


@pytest.mark.parametrize("lost", [1, 7, 100, 255, 256, 300, 1000])
@on_simulated_time
async def test_any_number_of_lost_samples_with_timestamps_is_counted(make_bare: Maker, lost: int) -> None:
    gateway = Dropping(make_bare(**SLOW))
    async with unity_link.connect(gateway) as link, link.subscribe([0], rate_hz=1000) as samples:
        before = (await take(samples, 10))[-1]
        gateway.dropping = True
        await asyncio.sleep(lost / 1000)
        gateway.dropping = False
        after = (await take(samples, 1))[0]
        assert after.lost == after.sequence - before.sequence - 1
        assert abs(after.lost - lost) <= 1
        assert samples.lost == after.lost == link.statistics.samples_lost
        assert (await anext(samples)).lost == 0


@pytest.mark.parametrize("lost", [1, 7, 100, 250])
@on_simulated_time
async def test_without_timestamps_up_to_255_lost_samples_are_counted(make_bare: Maker, lost: int) -> None:
    gateway = Dropping(make_bare(**SLOW))
    async with unity_link.connect(gateway) as link, link.subscribe([0], timestamps=False) as samples:
        await samples.publish()
        gateway.dropping = True
        for _ in range(lost):
            await samples.publish()
        gateway.dropping = False
        await samples.publish()
        first, after = await take(samples, 2)
        assert (first.lost, after.lost, after.sequence) == (0, lost, lost + 1)


@on_simulated_time
async def test_a_slow_reader_loses_the_oldest_samples_and_gets_their_count(make_bare: Maker) -> None:
    async with unity_link.connect(make_bare(**SLOW)) as link, link.subscribe([0], buffer=4) as samples:
        for _ in range(10):
            await samples.publish()
        taken = await take(samples, 4)
        assert [sample.sequence for sample in taken] == [6, 7, 8, 9]
        assert [sample.lost for sample in taken] == [6, 0, 0, 0]
        assert (samples.lost, samples.received, link.statistics.samples_lost) == (6, 10, 6)


@on_simulated_time
async def test_samples_lost_on_the_way_and_in_the_buffer_add_up(make_bare: Maker) -> None:
    gateway = Dropping(make_bare(**SLOW))
    async with unity_link.connect(gateway) as link, link.subscribe([0], buffer=2) as samples:
        for number in range(12):
            gateway.dropping = number % 3 == 1
            await samples.publish()
        taken = await take(samples, 2)
        assert [sample.sequence for sample in taken] == [9, 11]
        assert [sample.lost for sample in taken] == [9, 1]
        assert samples.lost == 10


@on_simulated_time
async def test_a_slow_reader_may_choose_to_fail_after_the_waiting_samples(make_bare: Maker) -> None:
    async with (
        unity_link.connect(make_bare(**SLOW)) as link,
        link.subscribe([0], buffer=3, overflow="fail") as samples,
    ):
        for _ in range(5):
            await samples.publish()
        assert [sample.sequence for sample in await take(samples, 3)] == [0, 1, 2]
        for _ in range(2):
            with pytest.raises(SamplesLostError, match="too slow: 3 samples"):
                await anext(samples)


@on_simulated_time
async def test_samples_are_right_or_counted_as_lost_on_a_bad_line(make_bare: Maker) -> None:
    gateway = make_bare(**SLOW, **CRC_32)
    gateway.attach(CountingDevice(), [0])
    line = NoisyLine(gateway, Noise(1, loss=0.003, flip=0.003), Noise(2, loss=0.003, flip=0.003))
    async with unity_link.connect(line) as link, link.subscribe([0], rate_hz=1000) as samples:
        offset = None
        for _ in range(2000):
            sample = await anext(samples)
            here = int(sample.values[0]) - sample.sequence
            offset = here if offset is None else offset
            assert here == offset
        assert 0 < samples.lost < 1000


@on_simulated_time
async def test_a_frame_that_is_no_sample_of_the_subscription_is_dropped(make_bare: Maker) -> None:
    async with unity_link.connect(make_bare(**SLOW)) as link, link.subscribe([0]) as samples:
        samples._receiver.receive(b"P0000", 0.0)
        samples._receiver.receive(b"P00000000000G00000000", 0.0)
        samples._receiver.receive(b"P00G00000000000000000", 0.0)
        assert samples.received == 0


# Groups without a subscription


async def is_silent(link: Link) -> bool:
    """Return true if the gateway publishes nothing, after a bad line has had time for some retransmissions."""
    await asyncio.sleep(5)
    before = link.statistics.bytes_received
    await asyncio.sleep(1)
    return link.statistics.bytes_received == before


@pytest.mark.slow
@on_simulated_time
async def test_a_cancelled_subscription_stops_its_group_on_a_bad_line(make_bare: Maker) -> None:
    for seed in range(50):
        # A CRC of 8 bits passes one damaged request in 256, and this line damages more than that.
        gateway = make_bare(**SLOW, groups=4, crc_bits=32, crc_polynomial=0x04C11DB7)
        noise = {"loss": 0.02}
        line = NoisyLine(gateway, Noise(seed, **noise), Noise(seed + 1, **noise))
        async with unity_link.connect(line, timeout=3600) as link:
            for _ in range(4):
                with anyio.move_on_after(0.0105):
                    async with link.subscribe([0], rate_hz=1000) as samples:
                        async for _ in samples:
                            pass
            assert await is_silent(link)
            async with link.subscribe([0]), link.subscribe([0]), link.subscribe([0]), link.subscribe([0]):
                pass


@on_simulated_time
async def test_a_subscription_cancelled_during_set_up_leaves_no_running_group(make_bare: Maker) -> None:
    for delay in range(12):
        gateway = make_bare(**SLOW, groups=4)
        async with unity_link.connect(gateway) as link:
            beginning = link.subscribe([0], rate_hz=1000)
            task = asyncio.create_task(beginning.__aenter__())
            for _ in range(delay):
                await asyncio.sleep(0)
            task.cancel()
            await asyncio.wait([task])
            if not task.cancelled():
                await beginning.__aexit__(None, None, None)
                continue
            assert await is_silent(link)
            async with link.subscribe([0]) as samples:
                await samples.publish()
                assert (await anext(samples)).sequence == 0


@on_simulated_time
async def test_a_subscription_ends_with_the_link_after_its_samples(make_bare: Maker) -> None:
    async with unity_link.connect(make_bare(**SLOW)) as link, link.subscribe([0]) as samples:
        await samples.publish()
        await link.aclose()
        assert (await anext(samples)).sequence == 0
        # No call waits for an answer, so the error has no outcome of a request.
        with pytest.raises(LinkLostError, match=r"^the link was closed$"):
            await anext(samples)


@on_simulated_time
async def test_a_subscription_may_be_entered_again_after_a_cancelled_try(make_bare: Maker) -> None:
    async with unity_link.connect(make_bare()) as link:
        samples = link.subscribe([0], rate_hz=100)
        with pytest.raises(TimeoutError):
            async with asyncio.timeout(0), samples:
                raise AssertionError
        async with samples:
            assert (await anext(samples)).sequence == 0


@on_simulated_time
async def test_a_reader_that_does_not_read_takes_bounded_memory(make_bare: Maker) -> None:
    async with (
        unity_link.connect(make_bare(**SLOW)) as link,
        link.subscribe([0], rate_hz=1000, buffer=10) as samples,
    ):
        await asyncio.sleep(3)
        assert len(samples._receiver.buffer) == 10
        assert samples.lost == samples.received - 10


@on_simulated_time
async def test_a_controller_slower_than_the_rate_reads_only_the_latest_sample() -> None:
    async with (
        unity_link.connect(VirtualGateway()) as link,
        link.subscribe(0x10, rate_hz=100, latest=True) as samples,
    ):
        for _ in range(5):
            await asyncio.sleep(0.1)
            sample = await anext(samples)
            assert sample.sequence == samples.received - 1
        assert samples.lost == samples.received - 5


@on_simulated_time
async def test_take_returns_the_requested_number_of_samples_or_fewer_at_the_end() -> None:
    link = await unity_link.connect(VirtualGateway())
    async with link.subscribe(0x10, rate_hz=100) as samples:
        assert [sample.sequence for sample in await samples.take(5)] == [0, 1, 2, 3, 4]
        assert [sample.sequence for sample in await samples.take(1)] == [5]
        with pytest.raises(ArgumentError, match="a number of samples from 1 on was expected, not 0"):
            await samples.take(0)
        ending = asyncio.ensure_future(samples.take(1000))
        await asyncio.sleep(0.1)
        await link.aclose()
        assert 0 < len(await ending) < 1000
        with pytest.raises(LinkLostError):
            await samples.take(1000)


@on_simulated_time
@pytest.mark.parametrize("buffer", [5, 100, 10_000])
@pytest.mark.parametrize("seconds", [0.001, 0.05, 0.3])
async def test_samples_of_a_cancelled_reader_reach_the_next_one_or_are_counted(buffer: int, seconds: float) -> None:
    async with (
        unity_link.connect(VirtualGateway()) as link,
        link.subscribe(0x10, rate_hz=1000, buffer=buffer) as samples,
    ):
        expected = lost = 0
        for count in (400, 1000, 3, 1):
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(seconds):
                    await samples.take(1000)
            for sample in await samples.take(count):
                assert sample.sequence == expected + sample.lost
                expected = sample.sequence + 1
                lost += sample.lost
        assert samples.received == expected - lost + samples.lost + len(samples._receiver.buffer)


@on_simulated_time
async def test_the_latest_sample_is_returned_after_a_cancelled_reader_too() -> None:
    async with (
        unity_link.connect(VirtualGateway()) as link,
        link.subscribe(0x10, rate_hz=100, latest=True) as samples,
    ):
        with pytest.raises(TimeoutError):
            async with asyncio.timeout(0.1):
                await samples.take(1000)
        sample = await anext(samples)
        assert (sample.sequence, sample.lost) == (samples.received - 1, samples.received - 1)


@on_simulated_time
async def test_samples_left_by_a_cancelled_reader_count_for_a_small_buffer() -> None:
    async with (
        unity_link.connect(VirtualGateway()) as link,
        link.subscribe(0x10, rate_hz=100, buffer=2, overflow="fail") as samples,
    ):
        with pytest.raises(TimeoutError):
            async with asyncio.timeout(0.1):
                await samples.take(1000)
        came = samples.received
        await asyncio.sleep(0.1)
        assert [sample.sequence for sample in await samples.take(came)] == list(range(came))
        with pytest.raises(SamplesLostError, match=f"the reader is too slow: {came} samples are waiting for it"):
            await samples.take(1)


@on_simulated_time
async def test_a_callback_that_raises_is_logged_once_for_each_type(caplog: pytest.LogCaptureFixture) -> None:
    def fail(_: object) -> None:
        raise ZeroDivisionError

    async with (
        unity_link.connect(VirtualGateway()) as link,
        link.subscribe(0x10, rate_hz=100, callback=fail) as samples,
    ):
        await asyncio.sleep(1)
    assert samples.received > 50
    assert [message for message, _ in told(caplog)] == [
        "a subscription's callback raised ZeroDivisionError (told once)"
    ]

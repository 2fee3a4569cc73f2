"""Samples of groups, published by the gateway or polled by the host; as values, one by one and in batches."""

from __future__ import annotations

import asyncio
import gc
import itertools
import math
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import unity_link
from support.counting_device import CountingDevice
from support.logged import told
from support.sharing import PipedLink, sharing, until
from support.simulated_time import on_simulated_time
from support.valve import Valve
from unity_link import (
    ArgumentError,
    BusError,
    BusTimeoutError,
    Feature,
    GatewayInfo,
    LinkClosedError,
    LinkLostError,
    SamplesLostError,
    UnsupportedError,
)
from unity_link.data import Batch, Group, GroupSubscription, Registration
from unity_link.data.feed import Feed, Listener
from unity_link.link.publishing import Sample
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.spec import compile_text
from unity_link.virtual import VirtualGateway
from unity_link.virtual.bus import AccessError

if TYPE_CHECKING:
    from unity_link.data import GroupSample

INFO = GatewayInfo(base_frequency_millihertz=1_000_000)
WITHOUT_GROUPS = GatewayInfo(base_frequency_millihertz=1_000_000, features=GatewayInfo().features & ~Feature.GROUPS)
ROBOT = unity_link.load(
    compile_text("""
    enum mode { off, on }
    group state(1, 10);
    group fast(RATE=2000);
    group edges(3, TRIGGER);
    public robot() {
      @count = 0x10: READ(PUBLISH(state));
      @time = 0x11: signed READWRITE(PUBLISH(state), SCALE=0.5);
      @slow = 0x12: READ(POLL(20));
      @mode = 0x13[1:0]: mode READ(POLL(20));
      @quick = 0x14: READ(PUBLISH(fast));
      @silent = 0x15: READWRITE();
      @edge = 0x16: READ(PUBLISH(edges));
    }
    """)
)


def counting(info: GatewayInfo = INFO) -> VirtualGateway:
    gateway = VirtualGateway(info)
    for address in (0x10, 0x12, 0x14):
        gateway.attach(CountingDevice(), [address])
    return gateway


def tasks_of_feeds() -> list[str]:
    return [task.get_name() for task in asyncio.all_tasks() if task.get_name().startswith("samples of")]


# One signal


@on_simulated_time
async def test_iteration_returns_each_value_that_the_group_publishes() -> None:
    gateway = counting()
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        seen = []
        async for value in robot.count:
            seen.append(value)
            if len(seen) == 50:
                break
        assert seen == list(range(1, 51))
        assert robot.count.value >= 50
        assert robot.time.value == 0, "the value of each signal of the group is stored"


@on_simulated_time
async def test_the_gateway_publishes_once_for_all_listeners_until_the_last_leaves() -> None:
    gateway = counting()
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)

        async def first(count: int) -> list[int]:
            seen = []
            async for value in robot.count:
                seen.append(value)
                if len(seen) == count:
                    return seen
            raise AssertionError

        several = await asyncio.gather(first(5), first(10), first(20))
        assert several[2][:10] == several[1]
        assert several[1][:5] == several[0]
        assert link.statistics.samples <= 25
        await asyncio.sleep(0.1)
        assert not tasks_of_feeds()
        samples = link.statistics.samples
        await asyncio.sleep(1)
        assert link.statistics.samples == samples, "no sample is published without a listener"
        assert len(await first(3)) == 3, "the next listener starts the samples again"


@on_simulated_time
async def test_ending_a_loop_and_starting_another_at_once_loses_no_listener() -> None:
    async with unity_link.connect(counting()) as link:
        robot = ROBOT(link)
        for _ in range(20):
            async for _value in robot.count:
                break


@on_simulated_time
async def test_an_unpublished_signal_cannot_be_iterated_over() -> None:
    async with unity_link.connect(counting()) as link:
        robot = ROBOT(link)
        message = "nothing says when silent is to be sampled: give PUBLISH or POLL in the spec, or a rate_hz to a group"
        with pytest.raises(ArgumentError, match=message):
            async for _ in robot.silent:
                pass
        with pytest.raises(ArgumentError, match="nothing says when count, silent"):
            Group(robot.count, robot.silent).subscribe()


@on_simulated_time
async def test_on_change_starts_the_samples_of_published_signals() -> None:
    gateway = counting()
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        counts: list[int] = []
        times: list[float] = []
        registrations = [robot.count.on_change(counts.append), robot.time.on_change(times.append)]
        await asyncio.sleep(0.205)
        await link.write(0x11, 6)
        await asyncio.sleep(0.2)
        for registration in registrations:
            registration.cancel()
        await asyncio.sleep(0.1)
        assert counts == list(range(1, len(counts) + 1))
        assert len(counts) in range(38, 42)
        assert times == [0, 3]
        assert not tasks_of_feeds()


@on_simulated_time
async def test_a_slow_loop_raises_for_lost_samples_and_does_not_affect_others() -> None:
    async with unity_link.connect(counting()) as link:
        robot = ROBOT(link)

        async def slow() -> None:
            async for _ in robot.count.samples(buffer=5):
                await asyncio.sleep(1)

        async def steady() -> list[int]:
            seen = []
            async for value in robot.count:
                seen.append(value)
                if len(seen) == 200:
                    return seen
            raise AssertionError

        results = await asyncio.gather(slow(), steady(), return_exceptions=True)
        assert isinstance(results[0], SamplesLostError)
        assert str(results[0]) == "the reader is too slow: 5 samples are waiting for it"
        assert results[1] == list(range(1, 201))

        newest = robot.count.samples(buffer=5, overflow="drop_oldest")
        first = await anext(newest)
        await asyncio.sleep(1)
        assert await anext(newest) > first + 90


@given(
    st.lists(st.tuples(st.sampled_from("AB"), st.lists(st.integers(0, 3), min_size=1, max_size=9)), max_size=12),
    st.integers(1, 12),
    st.integers(1, 4),
)
def test_samples_that_a_listener_drops_are_counted_in_lost(
    batches: list[tuple[str, list[int]]], buffer: int, every: int
) -> None:
    @on_simulated_time
    async def check() -> None:
        layouts: dict[str, Any] = {"A": object(), "B": object()}
        listener = Listener(Feed("nothing", lambda: GroupSubscription([])), None, buffer, "drop_oldest")
        counts = dict.fromkeys(layouts.values(), 0)
        taken: list[Batch] = []
        waiting = 0
        for number, (name, losses) in enumerate(batches):
            layout, samples = layouts[name], []
            for lost in losses:
                counts[layout] += lost
                samples.append(Sample(counts[layout], None, 0.0, np.zeros(1, np.uint64), lost))
                counts[layout] += 1
            listener.deliver(Batch(layout, samples))
            waiting = min(buffer, waiting + len(losses))
            if number % every == 0:
                taken.append(await listener.next())
                waiting -= len(taken[-1])
        while waiting:
            taken.append(await listener.next())
            waiting -= len(taken[-1])
            assert waiting >= 0
        for layout, count in counts.items():
            listener.deliver(Batch(layout, [Sample(count, None, 0.0, np.zeros(1, np.uint64), 0)]))
            taken.append(await listener.next())
            sequence = [int(at) for batch in taken if batch.layout is layout for at in batch.sequence]
            told = [int(lost) for batch in taken if batch.layout is layout for lost in batch.lost]
            assert told == [after - before - 1 for before, after in itertools.pairwise([-1, *sequence])]
            assert sequence[-1] == count

    check()


@on_simulated_time
async def test_a_slow_loop_with_drop_oldest_gets_the_newest_samples_and_lost() -> None:
    async with unity_link.connect(counting()) as link:
        robot = ROBOT(link)
        samples = robot.groups["state"].samples(buffer=5, overflow="drop_oldest")
        seen = []
        for _ in range(4):
            seen += [await anext(samples) for _ in range(5)]
            await asyncio.sleep(1)
        assert [after.sequence - before.sequence - 1 for before, after in itertools.pairwise(seen)] == [
            sample.lost for sample in seen[1:]
        ]
        assert sum(sample.lost for sample in seen) > 250


@on_simulated_time
async def test_a_callback_that_raises_for_one_sample_gets_the_others_of_its_batch(
    caplog: pytest.LogCaptureFixture,
) -> None:
    async with unity_link.connect(counting()) as link:
        robot = ROBOT(link)
        seen: list[int] = []

        def picky(sample: GroupSample) -> None:
            seen.append(sample.sequence)
            raise ValueError

        async def asynchronous(_: object) -> None:
            raise AssertionError

        state = robot.groups["state"]
        with state.on_sample(picky):
            await asyncio.sleep(0.2)
            # The host is busy, so many samples arrive together.
            await link.read_many([0x15] * 500)
            await asyncio.sleep(0.2)
        for listen in (state.on_sample, state.on_batch):
            with pytest.raises(ArgumentError, match=r"a callback for .* of state is an asynchronous function"):
                listen(asynchronous)
    assert seen == list(range(len(seen)))
    assert len(seen) > 30
    assert [message for message, _ in told(caplog)] == ["a callback for samples of state raised ValueError (told once)"]


@on_simulated_time
async def test_samples_taken_late_do_not_replace_a_newer_value(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    loop = asyncio.get_running_loop()
    for clock in ("time.monotonic", "time.time"):
        monkeypatch.setattr(clock, loop.time)
    async with unity_link.connect(counting()) as link:
        robot = ROBOT(link)
        changes: list[int] = []
        robot.silent.on_change(changes.append)
        async with Group(robot.count, robot.silent, robot.time).subscribe(rate_hz=100) as samples:
            await anext(samples)
            await asyncio.sleep(0.105)
            await Group(robot.silent, robot.time).set([3, 3])
            batch = await samples.take()
            assert batch[robot.time].tolist() == [0] * len(batch)
            for signal in (robot.silent, robot.time):
                assert (signal.value, signal.age) == (3, 0)
            assert robot.count.value == batch[robot.count][-1], "no newer value is known"
            await Group(robot.silent, robot.time).set([4, 4])
            await asyncio.sleep(0.1)
            batch = await samples.take()
            assert robot.time.value == batch[robot.time][-1] == 4
        assert changes == [0, 3, 4]


@on_simulated_time
async def test_no_change_is_missed_if_the_program_is_delayed_between_clock_reads(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    loop = asyncio.get_running_loop()
    held = itertools.cycle([0.0, 0.0, 0.05])
    held_up = 0.0

    def clock() -> float:
        return loop.time() + held_up

    def clock_after_a_while() -> float:
        nonlocal held_up
        held_up += next(held)
        return clock()

    monkeypatch.setattr("time.monotonic", clock)
    monkeypatch.setattr("time.time", clock_after_a_while)
    async with unity_link.connect(counting()) as link:
        robot = ROBOT(link)
        counts: list[int] = []
        with robot.count.on_change(counts.append):
            await asyncio.sleep(1)
        assert len(counts) > 90
        assert counts == list(range(1, len(counts) + 1))


@on_simulated_time
async def test_the_newer_sample_of_two_subscriptions_sets_the_value() -> None:
    async with unity_link.connect(counting()) as link:
        robot = ROBOT(link)
        group = Group(robot.count)
        async with group.subscribe(rate_hz=100) as late, group.subscribe(rate_hz=100) as soon:
            await late.take()
            await asyncio.sleep(0.1)
            newest = (await soon.take(20))[robot.count][-1]
            assert (await late.take(2))[robot.count][-1] < newest
            assert robot.count.value == newest


@on_simulated_time
@pytest.mark.parametrize("kind", ["on_sample", "on_batch"])
async def test_a_callback_cancelled_by_another_is_not_called_for_these_samples(kind: str) -> None:
    async with unity_link.connect(counting()) as link:
        state = ROBOT(link).groups["state"]
        seen: list[object] = []
        second: Registration
        first = getattr(state, kind)(lambda _: second.cancel())
        second = getattr(state, kind)(seen.append)
        await asyncio.sleep(0.1)
        first.cancel()
        assert seen == []


@on_simulated_time
async def test_a_callback_that_cancels_itself_is_not_called_again_for_a_batch() -> None:
    async with unity_link.connect(counting()) as link:
        state = ROBOT(link).groups["state"]
        seen: list[GroupSample] = []

        def once(sample: GroupSample) -> None:
            seen.append(sample)
            registration.cancel()

        async with state.subscribe() as samples:
            batch = await samples.take(5)
        registration = state.on_sample(once)
        (listener,) = state.feed._listeners
        listener.deliver(batch)
        assert len(seen) == 1


@pytest.mark.parametrize("info", [INFO, WITHOUT_GROUPS], ids=["published", "polled"])
def test_numpy_numbers_are_accepted_as_options(info: GatewayInfo) -> None:
    numbers: Any = np

    @on_simulated_time
    async def check() -> None:
        async with unity_link.connect(counting(info)) as link:
            robot = ROBOT(link)
            for rate in (numbers.float32(50), numbers.float16(50), numbers.int8(50)):
                assert Group(robot.count, rate_hz=rate).subscribe().rate_hz == 50
                async with Group(robot.count).subscribe(rate_hz=rate, buffer=numbers.uint8(200)) as samples:
                    assert samples.rate_hz == 50
                    assert len(await samples.take(numbers.int64(3))) == 3
            newest = robot.count.samples(buffer=numbers.int8(5), overflow="drop_oldest")
            await anext(newest)
            await asyncio.sleep(4)
            assert await anext(newest) > 300

    check()


@on_simulated_time
async def test_wrong_buffer_options_of_a_loop_are_refused() -> None:
    wrong: list[tuple[dict[str, Any], str]] = [
        ({"buffer": 0}, "a buffer of 0 samples was asked for, at least 1 is needed"),
        ({"buffer": 2.5}, "a buffer is a number of samples, not 2.5"),
        ({"overflow": "drop"}, 'overflow is "drop_oldest" or "fail", not \'drop\''),
    ]
    async with unity_link.connect(counting()) as link:
        robot = ROBOT(link)
        for options, message in wrong:
            for samples in (robot.count.samples, robot.groups["state"].samples):
                with pytest.raises(ArgumentError, match=message):
                    await anext(samples(**options))


@pytest.mark.parametrize("info", [INFO, WITHOUT_GROUPS], ids=["published", "polled"])
def test_wrong_options_of_a_subscription_are_refused_for_each_reader(info: GatewayInfo) -> None:
    wrong: list[tuple[dict[str, Any], str]] = [
        ({"rate_hz": "5"}, "a rate is a number of Hz, not '5'"),
        ({"rate_hz": 0}, "a rate of 0 Hz was asked for, expected"),
        ({"rate_hz": math.nan}, "a rate is a number of Hz, not nan"),
        ({"rate_hz": 10**400}, "a rate is a number of Hz, not 1000000000"),
        ({"rate_hz": 5, "divisor": 2}, "a rate and a divisor were given, expected one of them"),
        ({"divisor": "2"}, "a divisor is a whole number, not '2'"),
        ({"divisor": 0}, "a divisor of 0 was asked for, expected 1 to 65535"),
        ({"rate_hz": 5, "buffer": 0}, "a buffer of 0 samples was asked for, at least 1 is needed"),
        ({"rate_hz": 5, "overflow": "drop"}, 'overflow is "drop_oldest" or "fail", not \'drop\''),
    ]

    @on_simulated_time
    async def check() -> None:
        async with unity_link.connect(counting(info)) as link:
            group = ROBOT(link).groups["state"]
            for options, message in wrong:
                with pytest.raises(ArgumentError, match=f"^{message}"):
                    group.subscribe(**options)
            with pytest.raises(ArgumentError, match=r"^a group: a rate is a number of Hz above 0, not 1000"):
                Group(*group.proxies, rate_hz=10**400)
        with pytest.raises(ArgumentError, match="timeout is a number of seconds above 0, not 1000"):
            unity_link.connect(counting(info), timeout=10**400)

    check()


# The end of a link


@on_simulated_time
async def test_a_lost_link_ends_every_iteration_and_is_logged_for_callbacks(caplog: pytest.LogCaptureFixture) -> None:
    gateway = Valve(counting())
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        robot.slow.on_change(lambda _: None)

        async def endless(samples: Any) -> None:
            async for _ in samples:
                pass

        async def cut() -> None:
            await asyncio.sleep(0.5)
            link._lose("the cable was pulled")

        tasks = [robot.count, robot.slow, robot.groups["state"], Group(robot.silent, rate_hz=10)]
        results = await asyncio.gather(*(endless(samples) for samples in tasks), cut(), return_exceptions=True)
        assert [type(result) for result in results[:-1]] == [LinkLostError] * len(tasks)
        with pytest.raises(LinkLostError):
            await anext(aiter(robot.count))
        assert not tasks_of_feeds()
    assert [message for message, _ in told(caplog)] == [
        "the samples of the signals polled at 20 Hz, which callbacks wait for, have ended"
    ]


@on_simulated_time
async def test_closing_the_link_ends_iterations_and_callbacks_quietly(caplog: pytest.LogCaptureFixture) -> None:
    async with unity_link.connect(counting()) as link:
        robot = ROBOT(link)
        robot.count.on_change(lambda _: None)
        waiting = asyncio.ensure_future(anext(aiter(Group(robot.silent, rate_hz=0.1).samples())))
        second = asyncio.ensure_future(anext(aiter(robot.edge)))
        await asyncio.sleep(0.1)
        assert waiting.done()
    with pytest.raises(LinkClosedError):
        await second
    await asyncio.sleep(1)
    assert not tasks_of_feeds()
    assert told(caplog) == []


@on_simulated_time
async def test_samples_continue_after_a_reconnection() -> None:
    async with unity_link.connect(counting(), reconnect=True) as link:
        robot = ROBOT(link)

        async def read_on(samples: Any, count: int) -> list[int]:
            seen = []
            async for value in samples:
                seen.append(value)
                if len(seen) == count:
                    return seen
            raise AssertionError

        async def cut() -> None:
            await asyncio.sleep(0.5)
            link._lose("the cable was pulled")

        published, polled, _ = await asyncio.gather(read_on(robot.count, 200), read_on(robot.slow, 40), cut())
        assert published == sorted(set(published))
        assert polled == sorted(set(polled))
        assert link.statistics.reconnections == 1


# Groups


@on_simulated_time
async def test_a_declared_group_has_a_schedule_that_a_program_may_override() -> None:
    async with unity_link.connect(counting()) as link:
        robot = ROBOT(link)
        state = robot.groups["state"]
        for subscription, rate in (
            (state.subscribe(), 100),
            (state.subscribe(rate_hz=500), 500),
            (state.subscribe(divisor=4), 250),
        ):
            async with subscription as samples:
                assert samples.rate_hz == rate
                first, second = await anext(samples), await anext(samples)
            assert (first.sequence, second.sequence, second.lost) == (0, 1, 0)
            assert second.time is not None
            assert first.time is not None
            assert second.time - first.time == pytest.approx(1 / rate)
            assert second.values[robot.count] == first.values[robot.count] + 1
        with pytest.raises(ArgumentError, match="the group fast has a rate of 2000 Hz, and this gateway has"):
            robot.groups["fast"].subscribe()
        async with robot.groups["fast"].subscribe(rate_hz=1000) as samples:
            assert samples.rate_hz == 1000
        async with Group(robot.count, robot.time).subscribe() as samples:
            assert samples.rate_hz == 100, "both signals belong to one group"


@on_simulated_time
async def test_options_add_to_the_schedule_of_the_spec() -> None:
    async with unity_link.connect(VirtualGateway(INFO)) as link:
        robot = ROBOT(link)
        async with robot.groups["state"].subscribe(on_change=True, timestamps=False) as samples:
            assert samples.rate_hz == 100
            assert (await anext(samples)).time is None
            waiting = asyncio.ensure_future(anext(samples))
            await asyncio.sleep(1)
            assert not waiting.done()
            await robot.time.set(3)
            assert (await waiting).values[robot.time] == 3


@pytest.mark.parametrize("info", [INFO, WITHOUT_GROUPS], ids=["published", "polled"])
def test_a_sample_can_be_requested_between_others(info: GatewayInfo) -> None:
    @on_simulated_time
    async def check() -> None:
        loop = asyncio.get_running_loop()
        async with unity_link.connect(counting(info)) as link:
            robot = ROBOT(link)
            async with Group(robot.count, rate_hz=1).subscribe() as samples:
                first = await anext(samples)
                began = loop.time()
                waiting = asyncio.ensure_future(anext(samples))
                await asyncio.sleep(0.25)
                await samples.publish()
                second, now = await waiting, loop.time()
                assert now - began == pytest.approx(0.25, abs=0.01)
                third, then = await anext(samples), loop.time()
                assert then - began == pytest.approx(1, abs=0.01)
                assert [sample.values[robot.count] for sample in (first, second, third)] == [1, 2, 3]
                assert (second.lost, third.lost, third.sequence) == (0, 0, 2)

    check()


@on_simulated_time
async def test_a_batch_has_a_column_for_each_signal() -> None:
    gateway = counting()
    gateway.memory[0x11] = 0xFFFF_FFFE
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        async with Group(robot.time, robot.count).subscribe(rate_hz=1000) as samples:
            await asyncio.sleep(0.5)
            batch = await samples.take()
        assert len(batch) > 400
        assert batch[robot.count].dtype == np.uint32
        np.testing.assert_array_equal(batch[robot.count], 1 + np.arange(len(batch)))
        np.testing.assert_array_equal(batch[robot.time], np.full(len(batch), -1.0))
        np.testing.assert_array_equal(batch.sequence, np.arange(len(batch)))
        assert batch.time is not None
        np.testing.assert_allclose(np.diff(batch.time), 1e-3, atol=1e-7)
        assert batch.lost.sum() == 0
        assert batch.words.shape == (len(batch), 2)
        assert [sample.values[robot.count] for sample in batch] == batch[robot.count].tolist()
        assert robot.count.value == len(batch)


@on_simulated_time
async def test_callbacks_receive_samples_or_batches() -> None:
    async with unity_link.connect(counting()) as link:
        robot = ROBOT(link)
        samples: list[GroupSample] = []
        batches: list[Batch] = []
        state = robot.groups["state"]
        with state.on_sample(samples.append), state.on_batch(batches.append):
            await asyncio.sleep(0.5)
        assert [sample.values[robot.count] for sample in samples] == list(range(1, len(samples) + 1))
        assert sum(map(len, batches)) == len(samples) >= 49
        with pytest.raises(ArgumentError, match="nothing says when silent"):
            Group(robot.silent).on_sample(samples.append)


@on_simulated_time
@pytest.mark.parametrize("info", [INFO, WITHOUT_GROUPS], ids=["published", "polled"])
async def test_a_loop_slower_than_its_group_gets_only_the_latest_sample(info: GatewayInfo) -> None:
    gateway = VirtualGateway(info)
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        async with robot.groups["state"].subscribe(latest=True) as samples:
            await anext(samples)
            for value in range(1, 6):
                gateway.memory[0x10] = value - 1
                await asyncio.sleep(0.3)
                gateway.memory[0x10] = value
                await asyncio.sleep(0.03)
                assert (await anext(samples)).values[robot.count] == value
            # A sample that was not polled has not arrived.
            assert samples.received - (samples.lost if info is INFO else 0) == 6
            assert samples.lost > 100


@on_simulated_time
async def test_a_group_of_two_gateways_gets_samples_of_each() -> None:
    async with unity_link.connect(counting()) as left, unity_link.connect(counting(WITHOUT_GROUPS)) as right:
        a, b = ROBOT(left), ROBOT(right)
        group = Group(a.count, b.count, rate_hz=50)
        seen: dict[Any, list[int]] = {a.count: [], b.count: []}
        async with group.subscribe() as samples:
            async for sample in samples:
                ((proxy, value),) = sample.values.items()
                seen[proxy].append(value)
                if min(map(len, seen.values())) == 20:
                    break
        for values in seen.values():
            assert values == list(range(1, len(values) + 1))
            assert len(values) <= 25


# Polling


@on_simulated_time
async def test_the_host_polls_at_the_rate_of_the_spec() -> None:
    gateway = counting()
    gateway.memory[0x13] = 1
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        loop = asyncio.get_running_loop()
        began = loop.time()
        values = []
        async for value in robot.slow:
            values.append(value)
            if len(values) == 41:
                break
        assert loop.time() - began == pytest.approx(2, abs=0.06)
        assert values == list(range(1, 42))
        assert robot.mode.value is ROBOT.enumerations["mode"]["on"], "all signals of one rate are read together"


@on_simulated_time
async def test_a_gateway_without_groups_is_polled_at_their_rates() -> None:
    async with unity_link.connect(counting(WITHOUT_GROUPS)) as link:
        robot = ROBOT(link)
        async with robot.groups["state"].subscribe() as samples:
            assert samples.rate_hz == 100
            first, second = await anext(samples), await anext(samples)
            assert (first.sequence, second.sequence) == (0, 1)
            assert (first.time, second.values[robot.count]) == (None, 2)
            await asyncio.sleep(1)
            later = await anext(samples)
            assert later.lost == pytest.approx(100, abs=2)
            assert samples.lost == later.lost
            assert later.sequence == 2 + later.lost
        async with robot.groups["state"].subscribe(overflow="fail", rate_hz=100) as samples:
            await anext(samples)
            await asyncio.sleep(1)
            with pytest.raises(SamplesLostError, match="turns of 100 Hz were missed"):
                await anext(samples)
        with pytest.raises(UnsupportedError, match="without groups, and a host cannot see their triggers"):
            robot.groups["edges"].subscribe()


class Refusing(CountingDevice):
    """A device that counts its reads, and refuses them while `is_away` is set."""

    def __init__(self) -> None:
        super().__init__()
        self.is_away = False

    def read(self, offset: int, now: float) -> int:
        if self.is_away:
            raise AccessError(ErrorCode.BUS_ERROR)
        return super().read(offset, now)


@on_simulated_time
async def test_callbacks_wait_for_the_next_poll_after_a_refused_read(
    caplog: pytest.LogCaptureFixture,
) -> None:
    gateway, device = VirtualGateway(INFO), Refusing()
    gateway.attach(device, [0x12])
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        counts: list[int] = []
        samples: list[GroupSample] = []
        polled: Any = robot.publishing_group(robot.slow)
        with robot.slow.on_change(counts.append), polled.on_sample(samples.append):
            await asyncio.sleep(0.21)
            device.is_away = True
            await asyncio.sleep(0.5)
            assert len(counts) == 5
            device.is_away = False
            await asyncio.sleep(0.2)
        assert counts == [sample.values[robot.slow] for sample in samples] == list(range(1, 10))
        assert [sample.lost for sample in samples] == [0, 0, 0, 0, 0, 10, 0, 0, 0]
        assert not tasks_of_feeds()
    ((message, error),) = told(caplog)
    assert message == "a read of the signals polled at 20 Hz, which callbacks wait for, was refused (told once)"
    assert isinstance(error, BusError)


@on_simulated_time
async def test_a_loop_raises_for_a_refused_poll_and_another_loop_can_start(
    caplog: pytest.LogCaptureFixture,
) -> None:
    gateway, device = VirtualGateway(INFO), Refusing()
    gateway.attach(device, [0x12])
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        seen: list[int] = []

        async def loop() -> None:
            async for value in robot.slow:
                seen.append(value)
                device.is_away = value == 3

        for _ in range(2):
            with pytest.raises(BusError, match="read of slow at 0x12"):
                await loop()
            await asyncio.sleep(0.1)
            assert not tasks_of_feeds()
            device.is_away, device.count = False, 0
        assert seen == [1, 2, 3, 1, 2, 3]
        assert told(caplog) == []
        with robot.slow.on_change(lambda _: None):
            for _ in range(2):
                with pytest.raises(BusError, match="read of slow at 0x12"):
                    await loop()
                await asyncio.sleep(0.1)
                device.is_away, device.count = False, 0
        assert seen == [1, 2, 3] * 4
        assert len(told(caplog)) == 1


@on_simulated_time
async def test_callbacks_wait_for_an_absent_shared_gateway_and_a_loop_raises(
    caplog: pytest.LogCaptureFixture,
) -> None:
    gateway = Valve(counting())
    async with sharing(gateway) as shared, PipedLink(shared) as link:
        robot = ROBOT(link)
        counts: list[int] = []
        samples: list[GroupSample] = []
        gateway.go_away(shared)
        await until(lambda: shared.away)
        with robot.count.on_change(counts.append), robot.groups["state"].on_sample(samples.append):
            with pytest.raises(BusTimeoutError):
                await anext(aiter(robot.count))
            await asyncio.sleep(10)
            assert counts == []
            gateway.come_back()
            await asyncio.sleep(10)
            assert len(counts) > 100
            assert counts == [sample.values[robot.count] for sample in samples]
            last = counts[-1]
            assert await anext(aiter(robot.count)) > last
        await asyncio.sleep(0.1)
        assert not tasks_of_feeds()
    ((message, error),) = told(caplog)
    assert message == "the samples of state, which callbacks wait for, do not come yet (told once)"
    assert isinstance(error, BusTimeoutError)


@on_simulated_time
async def test_loops_and_callbacks_continue_after_a_reset_of_the_gateway(caplog: pytest.LogCaptureFixture) -> None:
    gateway = counting()
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        published: list[int] = []
        polled: list[int] = []
        with robot.count.on_change(published.append), robot.slow.on_change(polled.append):
            loop = aiter(robot.slow)
            await anext(loop)
            await asyncio.sleep(0.5)
            gateway.reset()
            await asyncio.sleep(0.2)
            before = len(published), len(polled)
            await asyncio.sleep(1)
            assert len(published) > before[0] + 90
            assert len(polled) > before[1] + 15
            assert [await anext(loop) for _ in polled[1:]] == polled[1:]
    assert told(caplog) == []


@on_simulated_time
async def test_a_polled_group_can_wait_for_changes() -> None:
    async with unity_link.connect(VirtualGateway(WITHOUT_GROUPS)) as link:
        robot = ROBOT(link)
        async with Group(robot.silent).subscribe(rate_hz=100, on_change=True) as samples:
            assert (await anext(samples)).values[robot.silent] == 0
            waiting = asyncio.ensure_future(anext(samples))
            await asyncio.sleep(1)
            assert not waiting.done()
            await robot.silent.set(7)
            assert (await waiting).values[robot.silent] == 7


@on_simulated_time
async def test_samples_polled_for_a_cancelled_reader_reach_the_next_one() -> None:
    async with unity_link.connect(counting(WITHOUT_GROUPS)) as link:
        robot = ROBOT(link)
        async with robot.groups["state"].subscribe(overflow="fail") as samples:
            with pytest.raises(TimeoutError):
                async with asyncio.timeout(0.1):
                    await samples.take(1000)
            came = samples.received
            assert came > 5
            batch = await samples.take(came + 5)
            assert batch.sequence.tolist() == list(range(came + 5))
            assert samples.lost == 0


@on_simulated_time
@pytest.mark.parametrize("info", [INFO, WITHOUT_GROUPS], ids=["published", "polled"])
async def test_take_after_one_sample_of_a_batch_returns_the_others_first(info: GatewayInfo) -> None:
    async with unity_link.connect(counting(info)) as link:
        robot = ROBOT(link)
        async with robot.groups["state"].subscribe() as samples:
            await asyncio.sleep(0.2)
            first = await anext(samples)
            batch = await samples.take(30)
            following = await anext(samples)
            rest = await samples.take()
        seen = [first.sequence, *batch.sequence.tolist(), following.sequence, *rest.sequence.tolist()]
        assert seen[1:32] == list(range(seen[1], seen[1] + 31))
        lost = [first.lost, *batch.lost.tolist(), following.lost, *rest.lost.tolist()]
        assert len(seen) + sum(lost) == seen[-1] + 1


@on_simulated_time
async def test_a_change_is_reported_once_by_take_after_one_sample_of_a_batch() -> None:
    gateway = counting()
    gateway.attach(CountingDevice(), [0x15])
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        changes: list[int] = []
        robot.silent.on_change(changes.append)
        async with Group(robot.silent).subscribe(rate_hz=100) as samples:
            await asyncio.sleep(0.1)
            await anext(samples)
            assert len(changes) > 5
            for count in (2, 30, None):
                await samples.take(count)
            assert robot.silent.value == changes[-1]
        assert changes == list(range(1, samples.received + 1))


@on_simulated_time
async def test_a_polled_read_that_is_cancelled_is_a_lost_sample() -> None:
    gateway = Valve(counting(WITHOUT_GROUPS))
    async with unity_link.connect(gateway) as link:
        robot = ROBOT(link)
        async with robot.groups["state"].subscribe() as samples:
            assert (await anext(samples)).sequence == 0
            gateway.requests_pass = False
            for _ in range(3):
                with pytest.raises(TimeoutError):
                    async with asyncio.timeout(0.0101):
                        await anext(samples)
            gateway.requests_pass = True
            following = await anext(samples)
            assert following.sequence == 1 + following.lost == 1 + samples.lost
            assert samples.lost >= 3


@on_simulated_time
async def test_take_after_the_end_of_a_group_of_two_gateways_leaves_no_task(
    caplog: pytest.LogCaptureFixture,
) -> None:
    async with unity_link.connect(counting()) as left, unity_link.connect(counting()) as right:
        a, b = ROBOT(left), ROBOT(right)
        async with Group(a.count, b.count).subscribe(rate_hz=50) as samples:
            await samples.take()
        for _ in range(2):
            with pytest.raises(StopAsyncIteration):
                await samples.take()
        assert asyncio.all_tasks() == {asyncio.current_task()}
        del samples
        gc.collect()
    assert told(caplog) == []


@on_simulated_time
async def test_a_callback_without_a_running_event_loop_is_refused() -> None:
    async with unity_link.connect(counting()) as link:
        robot = ROBOT(link)
        state = robot.groups["state"]
        with ThreadPoolExecutor(1) as thread:
            for listen in (robot.count.on_change, state.on_sample, state.on_batch):
                with pytest.raises(ArgumentError, match=r"^no event loop runs here: "):
                    thread.submit(listen, print).result(60)
        with state.on_sample(lambda _: None):
            await asyncio.sleep(0.1)
        await asyncio.sleep(0.1)
        assert not tasks_of_feeds()
        assert not state.feed._listeners

"""Guarantees in the docstrings of a link's calls, while something else happens at the same time."""

from __future__ import annotations

import asyncio
import threading
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import anyio
import numpy as np
import pytest

import unity_link
from support.makers import BUS_ERROR, BUS_TIMEOUT, SLOW, Maker, simulated, with_failing
from support.recorded_bus import RecordedBus
from support.scripted import Scripted
from support.simulated_time import on_simulated_time
from support.valve import Uncounting, Valve, as_gateway, cut
from unity_link import ArgumentError, BusError, BusTimeoutError, LinkLostError, UnityLinkError, UnsupportedError
from unity_link.data import Group
from unity_link.errors import first_error
from unity_link.link.connection import Reconnect
from unity_link.modules import Memory
from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.crc import Crc, seed_of
from unity_link.spec import compile_text
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable, Coroutine

    from unity_link import Link, Sample

TWO_GROUPS = {**SLOW, "groups": 2}


def now() -> float:
    return asyncio.get_running_loop().time()


async def until(condition: Callable[[], bool]) -> None:
    """Wait until a condition is true, in steps so short that few other events happen, while simulated time passes."""
    while not condition():  # noqa: ASYNC110
        await asyncio.sleep(1e-5)


# Fences


@on_simulated_time
async def test_a_fence_waits_for_earlier_batches_and_blocks(make_bare: Maker) -> None:
    bus = RecordedBus(gateway := make_bare(**SLOW))
    async with unity_link.connect(gateway) as link:
        asked = [
            asyncio.ensure_future(link.write_many([0x10] * 2000, range(2000))),
            asyncio.ensure_future(link.write_queue(0x11, range(2000))),
            asyncio.ensure_future(link.post_many([0x12] * 2000, range(2000))),
        ]
        await asyncio.sleep(0)
        await link.fence()
        assert [address for address, _ in bus.writes].count(0x10) == 2000
        assert [address for address, _ in bus.writes].count(0x11) == 2000
        assert [address for address, _ in bus.writes].count(0x12) == 2000
        await asyncio.gather(*asked)


class Away(Valve):
    """Answers each `h` with error 05, as a server without its gateway does, and loses the errors of posted writes."""

    def receive(self, data: bytes, now: float) -> bytes:
        answer = super().receive(data, now)
        if not answer.startswith((b"h", b"x")):
            return answer
        lines = b"" if data.startswith(b"ws") else answer
        return b"".join(
            frame(b"x" + line[1:4] + b"05") if line.startswith(b"h") else line
            for line in lines.splitlines(keepends=True)
        )


def frame(body: bytes) -> bytes:
    return body + Crc().text(body, seed_of(1, from_gateway=True)) + b"\n"


@on_simulated_time
async def test_each_posted_write_is_queried_after_a_refused_fence() -> None:
    gateway = VirtualGateway()
    gateway.attach(Failing(), [0xF0])
    async with unity_link.connect(Away(gateway)) as link:
        await link.post(0xF0, 1)
        with pytest.raises(BusTimeoutError, match="posted write at 0xF0"):
            await link.fence()
        await link.fence()


@on_simulated_time
async def test_calls_after_a_waiting_fence_go_on(make_bare: Maker) -> None:
    async with unity_link.connect(make_bare(**SLOW)) as link:
        batch = asyncio.ensure_future(link.read_many([1] * 20_000))
        await asyncio.sleep(0)
        fences = [asyncio.ensure_future(link.fence()) for _ in range(3)]
        await asyncio.sleep(0)
        await link.write(0x20, 5)
        assert not batch.done()
        assert not any(fence.done() for fence in fences)
        await asyncio.gather(batch, *fences)


@on_simulated_time
async def test_a_fence_returns_if_the_batch_before_it_is_cancelled(make_bare: Maker) -> None:
    async with unity_link.connect(make_bare(**SLOW)) as link:
        batch = asyncio.ensure_future(link.read_many([1] * 20_000))
        await asyncio.sleep(0)
        fence = asyncio.ensure_future(link.fence())
        await asyncio.sleep(0)
        batch.cancel()
        await fence


@on_simulated_time
async def test_a_fence_waits_for_reads_that_a_new_session_repeats(make_bare: Maker) -> None:
    gateway = Valve(make_bare(**SLOW))
    async with unity_link.connect(gateway, reconnect=True) as link:
        gateway.answers_pass = False
        batch = asyncio.ensure_future(link.read_many([1] * 1000))
        await asyncio.sleep(0)
        fence = asyncio.ensure_future(link.fence())
        await asyncio.sleep(0.01)
        gateway.answers_pass = True
        cut(link)
        await fence
        await asyncio.sleep(0)
        assert batch.done()
        assert len(await batch) == 1000


@on_simulated_time
async def test_errors_of_posted_writes_are_raised_after_a_cancelled_fence(
    make_bare: Maker,
) -> None:
    async def post_and_cancel() -> None:
        async with unity_link.connect(with_failing(make_bare(**SLOW))) as link:
            await link.post(BUS_ERROR, 1)
            fence = asyncio.ensure_future(link.fence())
            await asyncio.sleep(0)
            fence.cancel()
            await asyncio.sleep(1)

    with pytest.raises(BusError):
        await post_and_cancel()


@on_simulated_time
async def test_each_fence_raises_the_errors_of_posts_of_its_own_task(make_bare: Maker) -> None:
    both_posted = asyncio.Barrier(2)

    async def run(link: Link, address: int, error: type[UnityLinkError]) -> None:
        for _ in range(2):
            await link.post(address, 1)
        await both_posted.wait()
        with pytest.raises(error, match=f"posted write at {address:#X}".replace("0X", "0x")) as caught:
            await link.fence()
        assert caught.value.__notes__ == ["1 more posted writes failed as well"]
        await link.fence()

    async with unity_link.connect(with_failing(make_bare(**SLOW))) as link:
        await asyncio.gather(run(link, BUS_ERROR, BusError), run(link, BUS_TIMEOUT, BusTimeoutError))
        await link.fence()


async def in_a_task_group(call: Coroutine[Any, Any, None]) -> None:
    with first_error():
        async with asyncio.TaskGroup() as tasks:
            tasks.create_task(call)


WRAPPED: dict[str, Callable[[Coroutine[Any, Any, None]], Awaitable[object]]] = {
    "wait_for": lambda call: asyncio.wait_for(call, 10),
    "gather": asyncio.gather,
    "create_task": asyncio.create_task,
    "TaskGroup": in_a_task_group,
    "shield": asyncio.shield,
}
"""Ways to await a coroutine in another task than the one that created it."""


@pytest.mark.parametrize("wrap", WRAPPED.values(), ids=WRAPPED)
@on_simulated_time
async def test_a_fence_belongs_to_the_task_that_calls_it(
    make_bare: Maker, wrap: Callable[[Coroutine[Any, Any, None]], Awaitable[object]]
) -> None:
    async with unity_link.connect(with_failing(make_bare(**SLOW))) as link:
        await link.post(BUS_ERROR, 1)
        with pytest.raises(BusError):
            await wrap(link.fence())
        await link.fence()


@pytest.mark.parametrize("kind", ["post", "post_many", "a module's post", "a signal's post", "a group's post"])
@on_simulated_time
async def test_a_post_belongs_to_the_task_that_calls_it(make_bare: Maker, kind: str) -> None:
    posted, fenced = asyncio.Event(), asyncio.Event()

    async def fence(link: Link) -> None:
        await posted.wait()
        await link.fence()
        fenced.set()

    async with unity_link.connect(with_failing(make_bare(**SLOW))) as link:
        robot: Any = unity_link.load(compile_text(f"public robot() {{ @failing = {BUS_ERROR:#x}: READWRITE(); }}"))(
            link
        )
        posts: dict[str, Callable[[], Coroutine[Any, Any, None]]] = {
            "post": lambda: link.post(BUS_ERROR, 1),
            "post_many": lambda: link.post_many([BUS_ERROR], [1]),
            "a module's post": lambda: Memory(link).post(BUS_ERROR, 1),
            "a signal's post": lambda: robot["failing"].post(1),
            "a group's post": lambda: Group(robot["failing"]).post([1]),
        }
        other = asyncio.create_task(fence(link))
        # Each post runs in a task of its own, which has ended when the other task calls `fence`.
        await asyncio.gather(posts[kind](), posts[kind]())
        posted.set()
        await fenced.wait()
        with pytest.raises(BusError) as caught:
            await link.fence()
        assert caught.value.__notes__ == ["1 more posted writes failed as well"]
        await other


@on_simulated_time
async def test_a_fence_called_in_another_thread_does_not_belong_to_the_task(make_bare: Maker) -> None:
    async with unity_link.connect(with_failing(make_bare(**SLOW))) as link:
        await link.post(BUS_ERROR, 1)
        made: list[Coroutine[Any, Any, None]] = []
        thread = threading.Thread(target=lambda: made.append(link.fence()))
        thread.start()
        # The task of this test continues while the thread runs.
        thread.join()
        await made[0]
        with pytest.raises(BusError):
            await link.fence()


@on_simulated_time
async def test_methods_that_return_a_coroutine_are_refused_as_callbacks(make_bare: Maker) -> None:
    async with unity_link.connect(make_bare(**SLOW)) as link:
        robot = unity_link.load(compile_text("public robot() { @word = 0x10: READWRITE(); }"))(link)
        word: Any = robot["word"]
        for function in (link.post, link.fence, word.set, word.post, Group(word).post):
            with pytest.raises(ArgumentError, match="async"):
                word.on_change(function)
        callback: Any = link.post_many
        with pytest.raises(ArgumentError, match="async"):
            link.subscribe([1], callback=callback)


@on_simulated_time
async def test_the_end_of_the_block_raises_the_errors_of_tasks_without_a_fence(make_bare: Maker) -> None:
    posted = asyncio.Event()

    async def post_and_stay(link: Link) -> None:
        await link.post_many([BUS_ERROR] * 3, [1] * 3)
        posted.set()
        await asyncio.sleep(3600)

    async def run() -> None:
        async with unity_link.connect(with_failing(make_bare(**SLOW))) as link:
            tasks.append(asyncio.ensure_future(post_and_stay(link)))
            await posted.wait()
            await link.fence()

    tasks: list[asyncio.Future[None]] = []
    with pytest.raises(BusError) as caught:
        await run()
    assert caught.value.__notes__ == ["2 more posted writes failed as well"]
    tasks[0].cancel()


@on_simulated_time
async def test_the_errors_of_many_ended_tasks_are_one_error_of_the_next_fence(make_bare: Maker) -> None:
    async with unity_link.connect(with_failing(make_bare(**SLOW))) as link:
        await asyncio.gather(*(link.post(BUS_ERROR, value) for value in range(100)))
        await asyncio.sleep(1)
        await asyncio.gather(*(link.post(BUS_TIMEOUT, value) for value in range(100)))
        with pytest.raises(BusError, match="0xE0") as caught:
            await link.fence()
        assert caught.value.__notes__ == ["199 more posted writes failed as well"]
        await link.fence()


# Batches


@on_simulated_time
async def test_a_batch_of_reads_is_completed_and_raises_its_first_error(make_bare: Maker) -> None:
    bus = RecordedBus(gateway := make_bare(**SLOW))
    with_failing(gateway)
    async with unity_link.connect(gateway) as link:
        with pytest.raises(BusTimeoutError, match="read at 0xE8"):
            await link.read_many([1, BUS_TIMEOUT, BUS_ERROR, *[2] * 2000])
        assert bus.reads.count(2) == 2000
        assert await link.read(1) == 0


@on_simulated_time
async def test_a_batch_of_writes_is_completed_and_raises_its_first_error(
    make_bare: Maker,
) -> None:
    bus = RecordedBus(gateway := make_bare(**SLOW))
    with_failing(gateway)
    async with unity_link.connect(gateway) as link:
        with pytest.raises(BusError, match="write at 0xE0"):
            await link.write_many([BUS_ERROR, BUS_TIMEOUT, *[2] * 2000], range(2002))
        assert [value for address, value in bus.writes if address == 2] == list(range(2, 2002))


# Leaving


@pytest.mark.parametrize("when", ["before", "while it waits"])
@on_simulated_time
async def test_leaving_the_block_of_a_link_does_not_wait_for_a_lost_gateway(make_bare: Maker, when: str) -> None:
    gateway = Valve(make_bare(**SLOW))

    async def post_and_leave() -> None:
        async with unity_link.connect(gateway, reconnect=True) as link:
            gateway.answers_pass = False
            await link.post(1, 2)
            if when == "before":
                await asyncio.sleep(0)
                cut(link)
                await until(lambda: not link.connected)
            else:
                asyncio.get_running_loop().call_later(0.1, cut, link)

    start = now()
    with pytest.raises(LinkLostError):
        await post_and_leave()
    assert now() - start < 10


@on_simulated_time
async def test_leaving_without_open_requests_raises_nothing_for_a_lost_gateway(make_bare: Maker) -> None:
    gateway = Valve(make_bare(**SLOW))
    async with unity_link.connect(gateway, reconnect=True) as link:
        await link.post(1, 2)
        await asyncio.sleep(1)
        gateway.answers_pass = False
        cut(link)
        await until(lambda: not link.connected)


@pytest.mark.parametrize("cutting", [True, False])
@on_simulated_time
async def test_leaving_a_subscription_does_not_wait_for_a_lost_gateway(make_bare: Maker, *, cutting: bool) -> None:
    gateway = Valve(make_bare(**SLOW))
    async with unity_link.connect(gateway, reconnect=True) as link:
        start = now()
        async with link.subscribe([1], rate_hz=100):
            gateway.answers_pass = False
            if cutting:
                cut(link)
        assert now() - start < 10


# Reconnection


@on_simulated_time
async def test_a_group_reassigned_in_a_reconnection_belongs_to_its_last_holder(
    make_modelled: Maker,
) -> None:
    gateway = Valve(bare := make_modelled(**TWO_GROUPS))
    for address in (0x0A, 0x0B, 0x0C):
        bare.memory[address] = address
    async with unity_link.connect(gateway, reconnect=True) as link, link.subscribe([0x0A], rate_hz=100) as staying:
        async with link.subscribe([0x0B], rate_hz=100):
            gateway.heard = b""
            cut(link)
            await until(lambda: b"gs" in gateway.heard)
        async with link.subscribe([0x0C], rate_hz=100) as changed:
            await asyncio.sleep(0.5)
            assert {tuple(sample.values.tolist()) for sample in await changed.take()} == {(0x0C,)}
            assert {tuple(sample.values.tolist()) for sample in await staying.take()} == {(0x0A,)}


@pytest.mark.parametrize("reset", [True, False])
@on_simulated_time
async def test_time_continues_over_a_reconnection_and_samples_have_a_session(*, reset: bool) -> None:
    gateway = simulated(**SLOW, clock_hz=400_000_000)
    samples: list[Sample] = []
    async with (
        unity_link.connect(gateway, reconnect=True) as link,
        link.subscribe([1], rate_hz=20, callback=samples.append),
    ):
        for _ in range(6):
            await asyncio.sleep(7.3)
            if reset:
                gateway.reset()
            cut(link)
        await asyncio.sleep(5)
    assert {sample.epoch for sample in samples} == set(range(7))
    steps = np.diff(np.array([sample.time for sample in samples], float))
    assert steps.min() > 0
    assert steps.max() < 1.0
    assert steps.sum() == pytest.approx(6 * 7.3 + 5, abs=1.0)
    assert [sample.epoch for sample in samples] == sorted(sample.epoch for sample in samples)


@on_simulated_time
async def test_subscriptions_are_set_up_after_several_failed_attempts(make_direct: Maker) -> None:
    """Requests that set up the group are damaged until the link gives them up; then the line is good again."""
    gateway = Spoiled(make_direct(**SLOW))
    async with (
        unity_link.connect(gateway, reconnect=Reconnect(longest_pause=1)) as link,
        link.subscribe([1], rate_hz=100) as samples,
    ):
        gateway.spoiling = True
        cut(link)
        await asyncio.sleep(200)
        gateway.spoiling = False
        await asyncio.sleep(10)
        assert link.connected
        received = samples.received
        await asyncio.sleep(1)
        assert samples.received > received


class Spoiled(Valve):
    """A gateway that no request to set up a group reaches undamaged, although it answers the damaged ones."""

    spoiling = False

    def receive(self, data: bytes, now: float) -> bytes:
        if self.spoiling:
            data = data.replace(b"gs", b"g?")
        return super().receive(data, now)


# A link without a way to its gateway


@on_simulated_time
async def test_a_link_on_which_only_samples_get_through_is_lost_in_seconds(make_direct: Maker) -> None:
    gateway = Valve(make_direct(**SLOW))
    async with unity_link.connect(gateway) as link, link.subscribe([1], rate_hz=100) as samples:
        await asyncio.sleep(1)
        gateway.requests_pass = False
        start = now()
        with pytest.raises(LinkLostError, match="does not answer"):
            await link.read(1)
        assert 2 < now() - start < 10
        assert samples.received > 100


@on_simulated_time
async def test_requests_are_not_retransmitted_while_the_transport_is_blocked(make_bare: Maker) -> None:
    async with unity_link.connect(gateway := Valve(make_bare(**SLOW))) as link:
        assert link._flow.stream is not None
        stream = link._flow.stream
        stream.pause_writing()
        gateway.heard = b""
        reads = [asyncio.ensure_future(link.read(address)) for address in range(100)]
        await asyncio.sleep(2)
        assert gateway.heard == b""
        stream.resume_writing()
        await asyncio.gather(*reads)
        assert gateway.heard.count(b"\n") <= 200


@on_simulated_time
async def test_a_transport_that_stays_blocked_ends_the_link(make_bare: Maker) -> None:
    async with unity_link.connect(make_bare(**SLOW)) as link:
        assert link._flow.stream is not None
        link._flow.stream.pause_writing()
        start = now()
        with pytest.raises(LinkLostError):
            await link.read(1)
        assert now() - start < 10


@on_simulated_time
async def test_a_round_trip_longer_than_the_first_time_out_is_measured_right(
    make_direct: Maker,
) -> None:
    gateway = Late(make_direct(**SLOW), 0.35)
    async with unity_link.connect(gateway, timeout=60) as link:
        assert link.statistics.round_trip is not None
        assert link.statistics.round_trip == pytest.approx(0.35)
        await link.read(1)
        assert link.statistics.repetitions == 0


class Late(Scripted):
    """A gateway whose answers all arrive late."""

    def __init__(self, gateway: Any, seconds: float) -> None:
        super().__init__(gateway)
        self._seconds = seconds

    def receive(self, data: bytes, now: float) -> bytes:
        answer = super().receive(data, now)
        if answer:
            self._pieces.append((now + self._seconds, answer))
        return b""


# Arguments

NOT_WHOLE = [True, 1.0, 2.5, "5", None, [1], b"1", np.float64(1)]
WRONG: dict[str, Callable[[Link, Any], Awaitable[object]]] = {
    "read": lambda link, wrong: link.read(wrong),
    "write at": lambda link, wrong: link.write(wrong, 1),
    "write": lambda link, wrong: link.write(1, wrong),
    "write_masked": lambda link, wrong: link.write_masked(1, 1, wrong),
    "post": lambda link, wrong: link.post(1, wrong),
    "post at": lambda link, wrong: link.post(wrong, 1),
    "read_block": lambda link, wrong: link.read_block(wrong, 1),
    "read_block of": lambda link, wrong: link.read_block(1, wrong),
    "read_queue": lambda link, wrong: link.read_queue(1, wrong),
    "write_block": lambda link, wrong: link.write_block(wrong, [1]),
    "write_queue": lambda link, wrong: link.write_queue(wrong, [1]),
    "divisor": lambda link, wrong: link.subscribe([1], divisor=wrong or "").__aenter__(),  # type: ignore[arg-type]
    "buffer": lambda link, wrong: link.subscribe([1], buffer=wrong).__aenter__(),
}


@pytest.mark.parametrize("wrong", NOT_WHOLE, ids=repr)
@pytest.mark.parametrize("call", WRONG.values(), ids=WRONG)
@on_simulated_time
async def test_the_error_names_an_argument_that_is_no_integer(
    call: Callable[[Link, Any], Awaitable[object]], wrong: Any
) -> None:
    async with unity_link.connect("sim:") as link:
        sent = link.statistics.requests
        with pytest.raises(ArgumentError):
            await call(link, wrong)
        assert link.statistics.requests == sent


@on_simulated_time
async def test_integers_of_other_types_are_accepted() -> None:
    numbers: Any = np
    async with unity_link.connect("sim:") as link:
        await link.write(numbers.uint8(7), numbers.int64(9))
        assert await link.read(numbers.int32(7)) == 9
        assert (await link.read_block(numbers.uint16(7), numbers.uint8(1))).tolist() == [9]
        async with link.subscribe(np.uint8(7), rate_hz=numbers.float32(100), buffer=numbers.int8(10)) as samples:
            assert (await anext(samples)).values.tolist() == [9]
            assert len(await samples.take(numbers.int64(3))) == 3
        async with link.subscribe(7, rate_hz=numbers.float16(1000)) as samples:
            assert samples.rate_hz == 1000
    async with unity_link.connect("sim:", timeout=numbers.float32(2)) as link:
        assert await link.read(7) == 0


RATES = ["5", [1], float("nan"), Fraction(10**9), np.float64(1e9), np.complex64(1)]


@pytest.mark.parametrize("options", [{"callback": 5}, *({"rate_hz": rate} for rate in RATES)], ids=str)
@on_simulated_time
async def test_a_subscription_with_wrong_options_is_refused(options: dict[str, Any]) -> None:
    async with unity_link.connect("sim:") as link:
        with pytest.raises(ArgumentError):
            link.subscribe([1], **options)


@pytest.mark.parametrize("reconnect", [3, "yes", None, 0.5])
def test_reconnect_is_a_choice_or_its_details(reconnect: Any) -> None:
    with pytest.raises(ArgumentError, match="reconnect is True, False or a Reconnect"):
        unity_link.connect("sim:", reconnect=reconnect)


@pytest.mark.parametrize("timeout", ["5", None, 0, -1, float("nan")])
def test_a_timeout_is_a_number_of_seconds(timeout: Any) -> None:
    with pytest.raises(ArgumentError, match="timeout is a number of seconds above 0"):
        unity_link.connect("sim:", timeout=timeout)


@on_simulated_time
async def test_a_subscription_is_entered_once(make_modelled: Maker) -> None:
    async with unity_link.connect(make_modelled(**TWO_GROUPS)) as link:
        samples = link.subscribe([1], rate_hz=100)
        async with samples:
            with pytest.raises(ArgumentError, match="has been entered before"):
                await samples.__aenter__()
            assert (await anext(samples)).sequence == 0
        with pytest.raises(ArgumentError, match="has been entered before"):
            await samples.__aenter__()
        async with link.subscribe([1]), link.subscribe([2]):
            waiting = link.subscribe([3])
            with pytest.raises(UnsupportedError, match="all 2 groups"):
                await waiting.__aenter__()
        async with waiting:
            await waiting.publish()


@on_simulated_time
async def test_samples_that_a_gateway_cannot_send_at_once_are_refused() -> None:
    features = int(unity_link.GatewayInfo().features & ~Feature.SEND_IMMEDIATE)
    async with unity_link.connect(f"sim:?features={features}") as link:
        with pytest.raises(UnsupportedError, match="built without send immediate"):
            link.subscribe([1], rate_hz=100, immediate=True)


# Lost samples are counted


@on_simulated_time
async def test_samples_after_the_failure_of_a_slow_reader_are_counted_as_lost(make_bare: Maker) -> None:
    async with (
        unity_link.connect(make_bare(**SLOW)) as link,
        link.subscribe([1], rate_hz=100, buffer=10, overflow="fail") as samples,
    ):
        await asyncio.sleep(1.005)
        read = len(await samples.take())
        with pytest.raises(unity_link.SamplesLostError):
            await samples.take()
        assert read == 10
        assert samples.lost == samples.received - read
        assert (link.statistics.samples, link.statistics.samples_lost) == (samples.received, samples.lost)


@pytest.mark.parametrize("together", [True, False])
@on_simulated_time
async def test_every_sample_is_read_or_counted_as_lost(make_bare: Maker, *, together: bool) -> None:
    """Samples that a slow reader or a lossy line loses are all counted."""
    gateway = Scripted(make_bare(**SLOW))
    numbers = [number for number in range(400) if number % 50 not in (7, 8)]
    async with unity_link.connect(gateway) as link, link.subscribe([1], timestamps=False, buffer=30) as samples:
        frames = [as_gateway(link._session.codec, b"P00%02X%08X" % (number & 0xFF, number)) for number in numbers]
        with anyio.fail_after(100):
            await asyncio.sleep(gateway.say([b"".join(frames)] if together else frames))
        read = await samples.take()
        assert read[-1].values.tolist() == [399]
        assert len(read) == 30
        assert samples.lost == 400 - 30
        assert sum(sample.lost for sample in read) == 400 - 30
        assert link.statistics.samples_lost == samples.lost


@on_simulated_time
async def test_posted_writes_continue_if_each_fence_is_answered_by_an_error() -> None:
    gateway = Uncounting(unity_link.GatewayInfo(id_digits=2))
    bus = RecordedBus(gateway)
    async with unity_link.connect(gateway) as link:
        for value in range(400):
            await link.post(0x10, value)
        await link.fence()
    assert bus.writes == [(0x10, value) for value in range(400)]

"""A single outstanding request: its task resumes with the answer, not a turn of the event loop later."""

from __future__ import annotations

import asyncio
import gc
import subprocess
import sys
import weakref
from contextvars import ContextVar
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.makers import SLOW, Maker
from support.simulated_time import on_simulated_time
from support.valve import Valve, as_gateway, cut
from unity_link import LinkClosedError, LinkLostError
from unity_link.link.flow import Flow
from unity_link.link.publishing import SampleReceiver
from unity_link.link.runtimes.runtime import AsyncioRuntime, InlineFuture
from unity_link.protocol.host.receiver import ResponseReceiver
from unity_link.protocol.host.requests import Request
from unity_link.protocol.host.session import Session
from unity_link.protocol.window.window import Window
from unity_link.transport.polling import SPIN
from unity_link.transport.stream import Stream

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link import Link

PLACE: ContextVar[str] = ContextVar("PLACE", default="outside")


def watch(link: Link, look: Callable[[], object]) -> list[object]:
    """Return a list of the results of `look`, which is called after each time that arriving bytes were processed."""
    receive, seen = link._flow.receive, []

    def receive_and_look(data: bytes) -> None:
        receive(data)
        seen.append(look())

    link._flow.receive = receive_and_look  # type: ignore[method-assign]
    return seen


@on_simulated_time
async def test_a_task_resumes_with_its_answer_and_sends_its_next_request(make_bare: Maker) -> None:
    async with unity_link.connect(make_bare(**SLOW)) as link:
        words: list[int] = []
        seen = watch(link, lambda: (len(words), link.statistics.in_flight))

        async def work() -> None:
            PLACE.set("inside")
            for address in (1, 2, 3):
                words.append(await link.read(address))
                assert PLACE.get() == "inside"

        await asyncio.create_task(work())
        assert seen == [(1, 1), (2, 1), (3, 0)]
        assert PLACE.get() == "outside"


@on_simulated_time
async def test_requests_of_tasks_that_resume_together_are_sent_together(make_bare: Maker) -> None:
    valve = Valve(make_bare(**SLOW))
    async with unity_link.connect(valve) as link:
        assert link._flow.stream is not None
        sent: list[bytes] = []
        send = link._flow.stream.send

        def send_and_note(data: bytes) -> None:
            sent.append(data)
            send(data)

        link._flow.stream.send = send_and_note  # type: ignore[method-assign]

        async def work(address: int) -> None:
            for _ in range(5):
                await link.read(address)

        await asyncio.gather(*map(work, range(8)))
        assert len(sent) < 15
        assert b"".join(sent).count(b"\n") == 40


@on_simulated_time
async def test_a_medium_may_answer_while_it_takes_the_request(make_bare: Maker) -> None:
    async with unity_link.connect(make_bare(**SLOW)) as link:
        flow = link._flow
        assert flow.stream is not None

        def answer(data: bytes) -> None:
            identifier = data[1 : 1 + flow.session.codec.info.id_digits]
            flow.receive(as_gateway(flow.session.codec, b"r" + identifier + b"0000002A"))

        flow.stream.send = answer  # type: ignore[method-assign]
        async with asyncio.timeout(1):
            assert [await link.read(address) for address in (1, 2)] == [0x2A, 0x2A]


@on_simulated_time
async def test_a_task_resumes_in_the_next_turn_if_another_task_is_running() -> None:
    runtime, order = AsyncioRuntime(), []
    future = runtime.create_inline_future()

    async def wait() -> None:
        order.append(await future)

    task = asyncio.create_task(wait())
    await asyncio.sleep(0)
    future.set_result("woken")
    runtime.wake()
    order.append("still here")
    await task
    assert order == ["still here", "woken"]


class ModelledLoop:
    """The part of an event loop that spinning needs; each turn takes some time."""

    TURN = SPIN / 20

    def __init__(self) -> None:
        self.now = 1.0
        self.planned: list[Callable[[], object]] = []
        self.turns = 0

    def time(self) -> float:
        return self.now

    def call_soon(self, function: Callable[..., object], *arguments: object) -> None:
        self.planned.append(lambda: function(*arguments))

    def wait(self, seconds: float) -> None:
        """Run turns without sleeping as long as calls are planned, then sleep for the rest of the time."""
        end, self.turns = self.now + seconds, 0
        while self.planned and self.now < end:
            self.now += self.TURN
            self.turns += 1
            planned, self.planned = self.planned, []
            for function in planned:
                function()
        self.now = end


def spinning(monkeypatch: pytest.MonkeyPatch, processors: int = 2) -> tuple[AsyncioRuntime, ModelledLoop]:
    async def make() -> AsyncioRuntime:
        return AsyncioRuntime()

    monkeypatch.setattr("unity_link.transport.polling.count_processors", lambda: processors)
    monkeypatch.setattr("unity_link.link.runtimes.runtime._time_of", ModelledLoop.time)
    runtime, loop = asyncio.run(make()), ModelledLoop()
    runtime._loop = loop  # type: ignore[assignment]
    return runtime, loop


def ask(runtime: AsyncioRuntime, loop: ModelledLoop, seconds: float) -> int:
    """Return the number of turns of the loop until an answer that takes `seconds`."""
    future = runtime.create_inline_future()
    loop.wait(seconds)
    future.set_result(None)
    runtime.wake()
    return loop.turns


def test_the_loop_does_not_sleep_while_a_quick_answer_is_pending(monkeypatch: pytest.MonkeyPatch) -> None:
    runtime, loop = spinning(monkeypatch)
    for _ in range(3):
        assert ask(runtime, loop, SPIN / 2) == pytest.approx(10, abs=1)


def test_the_loop_may_sleep_after_the_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    runtime, loop = spinning(monkeypatch)
    ask(runtime, loop, SPIN / 2)
    loop.wait(SPIN)
    assert loop.turns == 1
    assert not loop.planned


def test_the_loop_sleeps_while_a_slow_answer_is_pending(monkeypatch: pytest.MonkeyPatch) -> None:
    runtime, loop = spinning(monkeypatch)
    assert ask(runtime, loop, 20 * SPIN) == pytest.approx(20, abs=1)
    for _ in range(3):
        assert ask(runtime, loop, 20 * SPIN) == 0


def test_the_loop_does_not_spin_on_a_simulated_clock(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ModelledLoop, "TURN", 0.0)
    runtime, loop = spinning(monkeypatch)
    for _ in range(3):
        assert ask(runtime, loop, SPIN / 2) == 1


def test_the_loop_sleeps_while_several_answers_are_pending(monkeypatch: pytest.MonkeyPatch) -> None:
    runtime, loop = spinning(monkeypatch)
    other = runtime.create_inline_future()
    loop.wait(20 * SPIN)
    for _ in range(3):
        assert ask(runtime, loop, SPIN / 2) == 0
    assert other.cancel()
    assert ask(runtime, loop, SPIN / 2) == pytest.approx(10, abs=1)


@pytest.mark.slow
def test_an_event_loop_is_garbage_collected_after_its_links() -> None:
    loop = asyncio.new_event_loop()

    async def connect() -> None:
        async with unity_link.connect("sim:") as link:
            await link.read(1)

    loop.run_until_complete(connect())
    loop.close()
    left = weakref.ref(loop)
    del loop
    gc.collect()
    assert left() is None


def test_the_loop_does_not_spin_on_a_single_processor(monkeypatch: pytest.MonkeyPatch) -> None:
    runtime, loop = spinning(monkeypatch, processors=1)
    for _ in range(3):
        assert ask(runtime, loop, SPIN / 2) == 0


@on_simulated_time
async def test_a_future_that_is_done_before_it_is_awaited_returns_at_once() -> None:
    runtime = AsyncioRuntime()
    future, failed = runtime.create_inline_future(), runtime.create_inline_future()
    future.set_result(5)
    failed.set_exception(LinkClosedError("over"))
    runtime.wake()
    assert await future == 5
    with pytest.raises(LinkClosedError, match="over"):
        await failed
    awaitable: Any = future
    assert asyncio.isfuture(awaitable)
    assert awaitable.get_loop() is asyncio.get_running_loop()


@on_simulated_time
async def test_a_cancelled_task_raises_its_message_and_the_link_goes_on(make_bare: Maker) -> None:
    valve = Valve(make_bare(**SLOW))
    async with unity_link.connect(valve) as link:
        valve.answers_pass = False
        task = asyncio.create_task(link.read(1))
        await asyncio.sleep(1e-4)
        assert isinstance(task._fut_waiter, InlineFuture)  # type: ignore[attr-defined]
        task.cancel("enough")
        with pytest.raises(asyncio.CancelledError, match="enough"):
            await task
        with pytest.raises(TimeoutError):
            async with asyncio.timeout(0.01):
                await link.read(1)
        valve.answers_pass = True
        assert await link.read(1) == 0
        assert task.cancelled()


@on_simulated_time
async def test_a_task_cancelled_after_its_answer_arrived_is_cancelled(make_bare: Maker) -> None:
    async with unity_link.connect(make_bare(**SLOW)) as link:
        future = link._runtime.create_inline_future()

        async def wait() -> Any:
            return await future

        task = asyncio.create_task(wait())
        await asyncio.sleep(0)
        future.set_result(1)
        assert future.cancel() is False
        task.cancel()
        link._runtime.wake()
        with pytest.raises(asyncio.CancelledError):
            await task


@on_simulated_time
async def test_the_first_task_to_resume_may_close_the_link(make_bare: Maker) -> None:
    valve = Valve(make_bare(**SLOW))
    async with unity_link.connect(valve) as link:
        got: list[int] = []

        async def first() -> None:
            got.append(await link.read(1))
            await link.aclose()

        async def second() -> None:
            got.append(await link.read(2))

        results = await asyncio.gather(first(), second(), second(), return_exceptions=True)
        assert len(got) + sum(isinstance(result, LinkClosedError) for result in results) == 3
        assert got[0] == 0


@on_simulated_time
async def test_a_task_that_resumes_with_a_lost_connection_may_close_the_link(make_bare: Maker) -> None:
    valve = Valve(make_bare(**SLOW))
    async with unity_link.connect(valve, reconnect=True) as link:
        valve.answers_pass = False

        async def work() -> None:
            with pytest.raises(LinkLostError):
                await link.write(1, 2)
            await link.aclose()

        task = asyncio.create_task(work())
        await asyncio.sleep(1e-4)
        cut(link)
        await task
        assert link._flow.stream is None
        assert not [task for task in asyncio.all_tasks() if "_reopen" in str(task)]


def test_a_program_that_exits_after_an_answer_has_its_exit_status() -> None:
    program = """
import asyncio, sys, unity_link
async def main():
    async with unity_link.connect("sim:") as link:
        async def end():
            await link.read(0)
            sys.exit(7)
        await asyncio.gather(asyncio.create_task(end()), asyncio.sleep(60))
asyncio.run(main())
"""
    ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=30, check=False)
    assert (ended.returncode, ended.stdout, ended.stderr) == (7, "", "")


@on_simulated_time
async def test_an_idle_group_does_not_delay_the_retransmission_of_a_request(make_bare: Maker) -> None:
    valve = Valve(make_bare(**SLOW))
    async with unity_link.connect(valve) as link, link.subscribe([1]):
        for _ in range(50):
            await link.read(1)
        await asyncio.sleep(0.3)
        valve.requests_pass = False
        task = asyncio.create_task(link.read(1))
        await asyncio.sleep(1e-4)
        valve.requests_pass = True
        began = asyncio.get_running_loop().time()
        assert await task == 0
        assert asyncio.get_running_loop().time() - began < 0.1


@pytest.mark.parametrize(
    "hot", [Flow, SampleReceiver, Session, ResponseReceiver, Window, Request, Stream, InlineFuture]
)
def test_classes_on_the_path_of_a_request_have_fast_attributes(hot: type) -> None:
    assert not hasattr(hot, "__getattr__")
    assert "__slots__" in vars(hot) or hot not in (Window, Request, InlineFuture)

"""Signal handlers that raise an exception at any instant never interrupt the code of a link; `finally` can still write.

Signals come from another process, as a terminal and `kill` send them, and at each instant of a call at which the
interpreter could run a handler.
"""

from __future__ import annotations

import contextlib
import dis
import gc
import itertools
import logging
import os
import random
import signal
import socket
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any, Self

import pytest
import trio
from anyio.from_thread import start_blocking_portal

import unity_link
from support.interrupts_at_random import BLOCKING, SPEC, TRIO, interrupt
from unity_link import blocking
from unity_link.bridges.serve import serve
from unity_link.data.blocking import put
from unity_link.link.interrupts import PACKAGE
from unity_link.spec import compile_text
from unity_link.transport import unix
from unity_link.virtual import VirtualGateway
from unity_link.virtual.build import simulated
from unity_link.virtual.line import SlowLine

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path
    from types import FrameType

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="there is no kill")

ROVER = compile_text(SPEC)
Rover = unity_link.load(ROVER)
PATIENCE = 60.0


class StoppedError(BaseException):
    """The exception that the handler raises."""


@pytest.fixture
def url(tmp_path: Path) -> Iterator[str]:
    """Serve a robot in the event loop of another thread; yield its URL."""
    with start_blocking_portal() as portal:
        serving = serve(simulated(ROVER.interface()), unix=tmp_path / "gateway")
        with portal.wrap_async_context_manager(serving) as server:
            yield server.urls[0]


@pytest.fixture
def handled() -> Iterator[list[int]]:
    """Let SIGUSR1 and SIGUSR2 raise an exception; yield the list of the handled signal numbers."""
    numbers: list[int] = []

    def stop(number: int, _: FrameType | None) -> None:
        numbers.append(number)
        raise StoppedError

    before = {number: signal.signal(number, stop) for number in (signal.SIGUSR1, signal.SIGUSR2)}
    try:
        yield numbers
    finally:
        for number, handler in before.items():
            assert signal.getsignal(number) is stop
            signal.signal(number, handler)


# Random instants


CASES = [
    (BLOCKING, "SIGINT", ""),
    (BLOCKING, "SIGTERM", "computing"),
    (BLOCKING, "SIGALRM", "reading"),
    (TRIO, "SIGINT", ""),
    (TRIO, "SIGTERM", "computing"),
    (TRIO, "SIGALRM", ""),
]
IDS = [f"{'blocking' if program is BLOCKING else 'trio'}-{way}" for program, way, _ in CASES]


@pytest.fixture
def served(tmp_path: Path) -> Iterator[str]:
    """Serve a robot in its own process; yield its URL."""
    (tmp_path / "rover.ul").write_text(SPEC)
    command = [sys.executable, "-m", "unity_link", "serve", "sim:rover.ul", "--unix", "gateway"]
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            assert process.stdout.readline()
            yield f"unix:{tmp_path / 'gateway'}"
        finally:
            process.kill()


@pytest.mark.slow
@pytest.mark.parametrize("rounds", [340, pytest.param(17_000, marks=pytest.mark.campaign)])
@pytest.mark.parametrize(("program", "way", "beside"), CASES, ids=IDS)
def test_signals_at_random_instants_let_every_finally_write(
    program: str, way: str, beside: str, rounds: int, served: str, tmp_path: Path
) -> None:
    said = interrupt(program, served, rounds, way=way, beside=beside, seed=rounds, folder=tmp_path)
    assert said.splitlines()[-1] == f"{rounds} rounds, 0 wrong", said[-4000:]


# Each instant


class Points:
    """Instants at which the interpreter may run a handler: at the beginning of functions, after calls, and in loops.

    Args:
        at: number of the instant at which SIGUSR1 comes; None for no signal.
        place: beginning of the file names of the code in which instants count.
        after: beginnings of the names of the instructions after which an instant counts.
    """

    def __init__(
        self,
        at: int | None,
        place: str = PACKAGE,
        after: tuple[str, ...] = ("CALL", "RESUME", "JUMP_BACKWARD", "SEND"),
    ) -> None:
        self.count = 0
        self.has_come = False
        self._at = at
        self._place = place
        self._after = after
        self._names: dict[Any, dict[int, str]] = {}

    def __enter__(self) -> Self:
        sys.settrace(self._trace)
        return self

    def __exit__(self, *_: object) -> None:
        sys.settrace(None)

    def _trace(self, frame: FrameType, event: str, _: object) -> Any:
        if not frame.f_code.co_filename.startswith(self._place):
            return None
        frame.f_trace_opcodes, frame.f_trace_lines = True, False
        if event == "opcode":
            names = self._names.get(frame.f_code)
            if names is None:
                before = [("RESUME"), *(instruction.opname for instruction in dis.get_instructions(frame.f_code))]
                offsets = [instruction.offset for instruction in dis.get_instructions(frame.f_code)]
                names = self._names[frame.f_code] = dict(zip(offsets, before, strict=False))
            if names.get(frame.f_lasti, "RESUME").startswith(self._after):
                self.count += 1
                if self.count == self._at:
                    self.has_come = True
                    signal.raise_signal(signal.SIGUSR1)
        return self._trace


def points_of(work: Callable[[], object]) -> int:
    """Return the number of instants in a call of `work` at which a handler could run."""
    work()
    with Points(None) as points:
        work()
    return points.count


AMOUNTS = {"write": 10, "post": 5, "subscribe": 2, "arm": 2, "open": 2}
"""Instants of each kind of work that `make test` tries."""


@pytest.mark.filterwarnings("ignore:.*was not closed:ResourceWarning")
@pytest.mark.parametrize(
    ("work", "amount"),
    [
        *AMOUNTS.items(),
        *(pytest.param(work, 60, marks=pytest.mark.slow) for work in AMOUNTS),
        *(pytest.param(work, 10_000, marks=[pytest.mark.slow, pytest.mark.campaign]) for work in AMOUNTS),
    ],
)
def test_handler_that_raises_at_any_instant_of_a_call_leaves_the_link_usable(
    work: str, amount: int, url: str, handled: list[int]
) -> None:
    with blocking.connect(url) as link:
        robot = put(Rover, link)

        def post() -> None:
            link.post(0x0F, 2)
            link.fence()

        def subscribe() -> None:
            with link.subscribe([0x20], rate_hz=1000) as samples:
                samples.take(1)

        def arm() -> None:
            with robot.drive.armed(timeout=5):
                robot.voltage.set(3)

        def open_another() -> None:
            with blocking.connect(url) as other:
                other.write(0x0F, 3)

        works: dict[str, Callable[[], object]] = {
            "write": lambda: link.write(0x0F, 1),
            "post": post,
            "subscribe": subscribe,
            "arm": arm,
            "open": open_another,
        }
        count = points_of(works[work])
        assert count > 100
        for at in sorted(random.Random(amount).sample(range(1, count), min(amount, count - 1))):
            handled.clear()
            deadline = time.monotonic() + PATIENCE
            points = Points(at)
            with contextlib.suppress(StoppedError):
                with points:
                    works[work]()
                # If the handler cannot run at this instant, and no safe point follows, it runs a moment later.
                while points.has_come and not handled and time.monotonic() < deadline:
                    time.sleep(0.0001)
            link.write(0x0F, 0)
            assert link.read(0x0F) == 0
            assert not robot["drive.armed"].get()
            assert handled == [signal.SIGUSR1] * points.has_come
    gc.collect()


# Safe points


def soon(number: int = signal.SIGUSR1, seconds: float = 0.05) -> None:
    """Send a signal to this process, from another thread."""

    def send() -> None:
        time.sleep(seconds)
        os.kill(os.getpid(), number)

    threading.Thread(target=send).start()


def test_call_that_waits_is_ended_by_a_handler_that_raises(handled: list[int]) -> None:
    with blocking.connect(SlowLine(VirtualGateway(), 20_000)) as link:
        soon()
        with pytest.raises(StoppedError):
            link.read_queue(0, 100_000)
        link.write(1, 5)
        assert link.read(1) == 5
    assert handled == [signal.SIGUSR1]


def test_call_that_waits_for_another_thread_is_ended_by_a_handler(handled: list[int]) -> None:
    with blocking.connect(SlowLine(VirtualGateway(), 20_000)) as link, ThreadPoolExecutor(1) as pool:
        other = pool.submit(link.read_queue, 0, 1000)
        while not link.statistics.in_flight:
            time.sleep(0.001)
        soon()
        with pytest.raises(StoppedError):
            link.read_queue(0, 100_000)
        assert len(other.result(PATIENCE)) == 1000
    assert handled == [signal.SIGUSR1]


WAITS_FOR_SAMPLES = """
import signal, sys, threading
from unity_link import blocking

def stop(*_):
    sys.exit(3)

signal.signal(signal.SIGTERM, stop)
taker = threading.Thread(target=threading.Event().wait, daemon=True)
taker.start()
signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGTERM})
# The gateway publishes nothing, because the robot has no register at 0x21.
with blocking.connect(sys.argv[1]) as link, link.subscribe([0x20, 0x21], rate_hz=1000) as samples:
    threading.Timer(0.2, signal.pthread_kill, [taker.ident, signal.SIGTERM]).start()
    next(samples)
"""


def test_signal_that_another_thread_takes_ends_a_wait_for_samples(url: str) -> None:
    # Use another process: the alarm of a test's time-out would wake the main thread.
    done = subprocess.run([sys.executable, "-c", WAITS_FOR_SAMPLES, url], timeout=PATIENCE, check=False)
    assert done.returncode == 3


def test_handler_of_a_call_that_waits_may_call_the_link() -> None:
    found: list[int] = []
    with blocking.connect(SlowLine(VirtualGateway(), 20_000)) as link:

        def write(*_: object) -> None:
            link.write(1, 7)
            found.append(link.read(1))

        before = signal.signal(signal.SIGUSR1, write)
        try:
            soon()
            assert len(link.read_queue(0, 500)) == 500
        finally:
            signal.signal(signal.SIGUSR1, before)
    assert found == [7]


def test_handler_that_raises_ends_a_call_that_waits_for_a_callback(url: str, handled: list[int]) -> None:
    begun, over = threading.Event(), threading.Event()

    def stay(_: object) -> None:
        if threading.current_thread() is not threading.main_thread():
            begun.set()
            over.wait()

    with blocking.connect(url) as link:
        with link.subscribe([0x20], rate_hz=100, callback=stay):
            assert begun.wait(PATIENCE)
            soon()
            with pytest.raises(StoppedError):
                link.read(0x0F)
            over.set()
        assert link.read(0x0F) == 0
    assert handled == [signal.SIGUSR1]


@pytest.mark.parametrize("way", ["handler", "exit"])
def test_exception_of_a_callback_ends_the_call_that_runs_it(
    way: str, url: str, handled: list[int], caplog: pytest.LogCaptureFixture
) -> None:
    begun: list[int] = []

    def stay(_: object) -> None:
        if threading.current_thread() is threading.main_thread() and not begun:
            begun.append(1)
            if way == "exit":
                sys.exit(3)
            signal.raise_signal(signal.SIGUSR1)

    def subscribe_until_it_is_called() -> None:
        # Subscribe repeatedly: if the link's thread takes the first sample of a subscription, it takes all of them.
        deadline = time.monotonic() + PATIENCE
        while time.monotonic() < deadline:
            with link.subscribe([0x20], rate_hz=500, callback=stay):
                for _ in range(100):
                    link.read(0x0F)

    with blocking.connect(url) as link:
        with pytest.raises(SystemExit if way == "exit" else StoppedError):
            subscribe_until_it_is_called()
        link.write(0x0F, 1)
        assert link.read(0x0F) == 1
    assert handled == ([] if way == "exit" else [signal.SIGUSR1])
    assert [one for one in caplog.records if one.levelno >= logging.ERROR] == []


def test_callback_that_exits_in_a_links_thread_is_logged_and_samples_go_on(
    url: str, caplog: pytest.LogCaptureFixture
) -> None:
    called = threading.Semaphore(0)

    def leave(_: object) -> None:
        called.release()
        if threading.current_thread() is not threading.main_thread():
            sys.exit(3)

    with blocking.connect(url) as link, link.subscribe([0x20], rate_hz=500, callback=leave):
        for _ in range(10):
            assert called.acquire(timeout=PATIENCE)
    assert "a callback raised SystemExit, which ends nothing here" in caplog.text


@pytest.mark.parametrize("kind", [TimeoutError, ConnectionError, unity_link.LinkLostError, StopIteration])
def test_error_of_a_handler_is_raised_unchanged(kind: type[Exception], url: str) -> None:
    own = kind("of the handler")

    def stop(*_: object) -> None:
        raise own

    before = signal.signal(signal.SIGALRM, stop)
    try:
        with socket.create_server(("127.0.0.1", 0)) as server:
            signal.setitimer(signal.ITIMER_REAL, 0.05)
            with pytest.raises(kind) as raised:
                blocking.connect(f"tcp://127.0.0.1:{server.getsockname()[1]}")
            assert raised.value is own
        with blocking.connect(url) as link, link.subscribe([0x20]) as samples:
            signal.setitimer(signal.ITIMER_REAL, 0.05)
            with pytest.raises(kind) as raised:
                samples.take()
            assert raised.value is own
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def test_port_that_opens_after_its_call_was_interrupted_is_closed(
    url: str, handled: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    may_open, opened = threading.Event(), threading.Event()
    channels: list[Any] = []
    open_channel = unix.open_channel

    def open_late(*arguments: Any) -> Any:
        may_open.wait()
        channels.append(open_channel(*arguments))
        opened.set()
        return channels[0]

    with monkeypatch.context() as patch:
        patch.setattr(unix, "open_channel", open_late)
        soon()
        with pytest.raises(StoppedError):
            blocking.connect(url)
        may_open.set()
        assert opened.wait(PATIENCE)
    deadline = time.monotonic() + PATIENCE
    while channels[0].fileno() != -1:
        assert time.monotonic() < deadline
        time.sleep(0.001)
    assert handled == [signal.SIGUSR1]


def test_signal_while_an_iteration_is_dropped_is_not_lost(handled: list[int]) -> None:
    interface = ROVER.interface()
    with blocking.connect(SlowLine(simulated(interface), 2000)) as link:
        robot = put(Rover, link)
        samples = iter(robot.position)
        next(samples)
        # On this line, ending the subscription takes 10 ms.
        soon(seconds=0.003)
        with pytest.raises(StoppedError):  # noqa: PT012  (the handler runs after the first statement)
            del samples
            time.sleep(PATIENCE)
    assert handled == [signal.SIGUSR1]


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_child_of_a_thread_has_the_handlers_of_the_program(handled: list[int]) -> None:
    codes: list[int] = []

    def fork() -> None:
        time.sleep(0.05)
        child = os.fork()
        if child == 0:
            try:
                os.kill(os.getpid(), signal.SIGUSR1)
            except StoppedError:
                os._exit(3)
            os._exit(4)
        codes.append(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))

    with blocking.connect(SlowLine(VirtualGateway(), 20_000)) as link:
        forking = threading.Thread(target=fork)
        forking.start()
        link.read_queue(0, 500)
        forking.join()
    assert (codes, handled) == ([3], [])


# trio


async def write_in_the_end(link: unity_link.Link) -> None:
    with trio.fail_after(PATIENCE, shield=True):
        await link.write(0x0F, 0)


def test_cancelled_block_writes_in_a_shielded_finally_under_trio(url: str) -> None:
    async def program() -> None:
        with trio.CancelScope() as scope:
            async with unity_link.connect(url) as link:
                try:
                    for value in itertools.count(1):
                        await link.write(0x0F, value)
                        if value == 20:
                            scope.cancel()
                finally:
                    await write_in_the_end(link)
        async with unity_link.connect(url) as link:
            assert await link.read(0x0F) == 0

    trio.run(program)


def test_cancelled_block_disarms_under_trio(url: str) -> None:
    async def program() -> None:
        robot: Any
        with trio.CancelScope() as scope:
            async with unity_link.connect(url) as link:
                robot = Rover(link)
                async with robot.drive.armed(timeout=10) as lease:
                    for turn in itertools.count(1):
                        await lease.kick()
                        await robot.voltage.set(3)
                        if turn == 5:
                            scope.cancel()
        async with unity_link.connect(url) as link:
            robot = Rover(link)
            assert (await robot["drive.reason"].get()).name == "disarmed"

    trio.run(program)


# The coroutine of the call that the signal preceded is never awaited.
@pytest.mark.filterwarnings("ignore:coroutine 'Writable._set' was never awaited:RuntimeWarning")
@pytest.mark.usefixtures("handled")
def test_signal_at_any_instant_of_a_program_leaves_nothing_armed_under_trio(url: str) -> None:
    async def move(points: Points) -> None:
        async with unity_link.connect(url) as link:
            robot: Any = Rover(link)
            try:
                with points:
                    async with robot.drive.armed(timeout=10):
                        await robot.voltage.set(3)
            finally:
                with trio.fail_after(PATIENCE, shield=True):
                    armed.append(await robot["drive.armed"].get())

    armed: list[bool] = []
    for at in itertools.count(1):
        points = Points(at, __file__, ("CALL",))
        with contextlib.suppress(StoppedError):
            trio.run(move, points)
        if not points.has_come:
            break
    assert armed == [False] * len(armed)
    assert len(armed) > 2


@pytest.mark.usefixtures("handled")
def test_signal_at_any_instant_of_start_soon_lets_the_nursery_end(url: str) -> None:
    async def child() -> None:
        started.append(points)

    async def program() -> None:
        async with unity_link.connect(url), trio.open_nursery() as nursery:
            with points:
                nursery.start_soon(child)

    started: list[Points] = []
    for at in itertools.count(1):
        points = Points(at, trio.__file__.removesuffix("__init__.py"))
        with contextlib.suppress(StoppedError):
            trio.run(program)
        if not points.has_come:
            break
    assert at > 20
    assert len(started) == at


@pytest.mark.parametrize("kind", [TimeoutError, StoppedError])
def test_exception_of_a_handler_ends_the_block_under_trio(kind: type[BaseException], url: str) -> None:
    def stop(*_: object) -> None:
        raise kind

    async def program() -> None:
        async with unity_link.connect(url) as link:
            before = signal.signal(signal.SIGUSR1, stop)
            try:
                await link.write(0x0F, 5)
                soon()
                await trio.sleep(PATIENCE)
            finally:
                await write_in_the_end(link)
                assert signal.getsignal(signal.SIGUSR1) is not stop
                signal.signal(signal.SIGUSR1, before)

    with pytest.raises(kind):
        trio.run(program)


def test_handlers_of_the_program_are_restored_after_a_block_under_trio(url: str, handled: list[int]) -> None:
    async def program() -> None:
        own = signal.getsignal(signal.SIGINT)
        async with unity_link.connect(url) as link, unity_link.connect(url) as other:
            await link.write(0x0F, await other.read(0x0F))
            assert signal.getsignal(signal.SIGINT) is not own
        assert signal.getsignal(signal.SIGINT) is own

    trio.run(program)
    assert handled == []

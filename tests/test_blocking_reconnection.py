"""A blocking link reconnects after the loss of its gateway, whichever threads notice the loss, reconnect and call.

The gateways are processes. The test kills them, and starts new ones at the same address.
"""

from __future__ import annotations

import contextlib
import itertools
import logging
import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

import pytest
from anyio.from_thread import start_blocking_portal

import unity_link
from unity_link import blocking
from unity_link.transport import unix
from unity_link.virtual import VirtualGateway
from unity_link.virtual.serving import serve_unix

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from unity_link.blocking import BlockingLink

PAUSES = unity_link.Reconnect(first_pause=0.002, longest_pause=0.02)


def _confirmed(link: BlockingLink, post: Callable[[], object]) -> None:
    post()
    link.fence()


def _take(link: BlockingLink) -> None:
    with link.subscribe([1], rate_hz=100) as samples:
        samples.publish()
        samples.take(2)


CALLS: dict[str, Callable[[BlockingLink], object]] = {
    "read": lambda link: link.read(1),
    "write": lambda link: link.write(1, 2),
    "write_masked": lambda link: link.write_masked(1, 2, 2),
    "post": lambda link: _confirmed(link, lambda: link.post(1, 2)),
    "post_many": lambda link: _confirmed(link, lambda: link.post_many([1, 2], [3, 4])),
    "fence": lambda link: link.fence(),
    "read_block": lambda link: link.read_block(0, 200),
    "write_block": lambda link: link.write_block(0, range(200)),
    "read_queue": lambda link: link.read_queue(0, 200),
    "write_queue": lambda link: link.write_queue(0, range(200)),
    "read_many": lambda link: link.read_many(range(200)),
    "write_many": lambda link: link.write_many(range(200), range(200)),
    "send_immediate": lambda link: link.send_immediate("always"),
    "subscribe": _take,
}


class Attempts(logging.Handler):
    """Counts failed attempts to reconnect, with the names of their threads."""

    def __init__(self) -> None:
        super().__init__(logging.INFO)
        self.threads: list[str] = []
        self._changed = threading.Condition()

    def emit(self, record: logging.LogRecord) -> None:
        if "not connected" in record.getMessage():
            with self._changed:
                self.threads.append(str(record.threadName))
                self._changed.notify_all()

    def wait_for(self, count: int) -> None:
        """Wait for `count` more attempts."""
        with self._changed:
            count += len(self.threads)
            assert self._changed.wait_for(lambda: len(self.threads) >= count, 60)


@pytest.fixture
def attempts() -> Iterator[Attempts]:
    handler, logger = Attempts(), logging.getLogger("unity_link.link")
    level = logger.level
    logger.setLevel(logging.INFO)
    logger.addHandler(handler)
    yield handler
    logger.removeHandler(handler)
    logger.setLevel(level)


@pytest.mark.parametrize("name", CALLS)
def test_a_call_waits_for_a_gateway_whose_retries_go_on_in_another_thread(
    name: str, tmp_path: Path, attempts: Attempts
) -> None:
    gateway, path = VirtualGateway(), tmp_path / "gateway"
    with start_blocking_portal() as portal, ThreadPoolExecutor(2) as threads:
        with portal.wrap_async_context_manager(serve_unix(gateway, path)) as url:
            link = blocking.connect(url, reconnect=PAUSES)
        # Another thread notices the loss, and ends before the link has reconnected.
        with pytest.raises(unity_link.LinkLostError):
            threads.submit(link.write, 1, 1).result(60)
        attempts.wait_for(2)
        calling = threads.submit(CALLS[name], link)
        attempts.wait_for(2)
        with portal.wrap_async_context_manager(serve_unix(gateway, path)):
            calling.result(60)
            CALLS[name](link)
            assert link.statistics.reconnections == 1
            link.close()
    assert set(attempts.threads) == {"unity_link.blocking"}


def test_every_call_that_waits_for_a_gateway_was_tried() -> None:
    waiting = {name for name in vars(blocking.BlockingLink) if not name.startswith("_")}
    assert waiting - {"close", "gateway", "statistics"} == set(CALLS)


def test_interruption_of_a_reconnecting_call_ends_only_the_call(
    tmp_path: Path, attempts: Attempts, monkeypatch: pytest.MonkeyPatch
) -> None:
    class InterruptionError(TimeoutError):
        """An error of the program that is a kind of TimeoutError, as the errors of drivers are."""

    gateway, path = VirtualGateway(), tmp_path / "gateway"
    opening = threading.Event()
    open_channel = unix.open_channel

    def open_slowly(*arguments: Any) -> Any:
        opening.set()
        time.sleep(0.05)
        return open_channel(*arguments)

    def interrupt(*_: object) -> None:
        raise InterruptionError

    def interrupt_when_opening() -> None:
        assert opening.wait(60)
        os.kill(os.getpid(), signal.SIGALRM)

    with start_blocking_portal() as portal:
        with portal.wrap_async_context_manager(serve_unix(gateway, path)) as url:
            link = blocking.connect(url, reconnect=PAUSES)
            link.write(1, 5)
        monkeypatch.setattr(unix, "open_channel", open_slowly)
        before = signal.signal(signal.SIGALRM, interrupt)
        try:
            for _ in range(5):
                opening.clear()
                threading.Thread(target=interrupt_when_opening).start()
                with pytest.raises(InterruptionError):
                    link.read(1)
        finally:
            signal.signal(signal.SIGALRM, before)
        attempts.wait_for(1)
        with portal.wrap_async_context_manager(serve_unix(gateway, path)):
            assert link.read(1) == 5
            link.close()


class Killed:
    """A gateway in its own process, which the test can kill.

    Args:
        path: of its socket.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._process: subprocess.Popen[str] | None = None

    def begin(self) -> None:
        command = [sys.executable, "-m", "unity_link", "simulate", "--unix", str(self.path)]
        self._process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        while not self.path.exists():
            assert self._process.poll() is None
            time.sleep(0.01)

    def kill(self) -> None:
        assert self._process is not None
        self._process.kill()
        self._process.communicate()
        self._process = None
        self.path.unlink(missing_ok=True)


def _in_a_thread(link: BlockingLink) -> None:
    with ThreadPoolExecutor(1) as threads, pytest.raises(unity_link.LinkLostError):
        threads.submit(link.write, 1, 0).result(60)


def _by_a_write(link: BlockingLink) -> None:
    with pytest.raises(unity_link.LinkLostError):
        link.write(1, 0)


def _by_a_read_that_is_given_up(link: BlockingLink) -> None:
    class GivenUpError(Exception):
        pass

    def give_up(*_: object) -> None:
        raise GivenUpError

    before = signal.signal(signal.SIGALRM, give_up)
    signal.setitimer(signal.ITIMER_REAL, 0.05)
    try:
        with pytest.raises(GivenUpError):
            link.read(1)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


WAYS = (_by_a_write, _in_a_thread, _by_a_read_that_is_given_up)
"""Ways in which a program may notice that its gateway has left."""


@pytest.mark.parametrize(
    "kills",
    [pytest.param(6, marks=pytest.mark.slow), pytest.param(100, marks=[pytest.mark.campaign, pytest.mark.slow])],
)
def test_link_reconnects_after_every_kill_of_its_gateway(kills: int, tmp_path: Path, attempts: Attempts) -> None:
    gateway = Killed(tmp_path / "gateway")
    gateway.begin()
    with contextlib.ExitStack() as stack:
        stack.callback(gateway.kill)
        link = stack.enter_context(blocking.connect(f"unix:{gateway.path}", reconnect=PAUSES))
        for number, notice in zip(range(1, kills + 1), itertools.cycle(WAYS)):
            gateway.kill()
            notice(link)
            attempts.wait_for(2)
            with ThreadPoolExecutor(2) as threads:
                # Two or more retries pass while other threads wait for the gateway.
                reading = [threads.submit(link.read, 2) for _ in range(2)]
                attempts.wait_for(2)
                gateway.begin()
                assert [each.result(60) for each in reading] == [0, 0]
            link.write(1, number)
            assert link.read(1) == number
        assert link.statistics.reconnections == kills

"""The same link for code that is not asynchronous: scripts, notebooks, MATLAB.

::

    from unity_link import blocking

    with blocking.connect("sim:scara") as link:
        print(link.read(0x88))
        with link.subscribe([0x88, 0x89], rate_hz=100) as samples:
            for sample in samples:
                print(sample.values)

Each link has an event loop in a thread of its own. The methods are those of
`unity_link.Link`, and any number of threads may call them. A call costs a change of threads there and back, so batches
and blocks gain even more here than there.
"""

from __future__ import annotations

import asyncio
import threading
import weakref
from collections import deque
from concurrent.futures import CancelledError, Future
from typing import TYPE_CHECKING, Any, Self, TypeVar

from unity_link.errors import ArgumentError, LinkClosedError, Outcome
from unity_link.link import link as asynchronous

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine
    from types import TracebackType

    from numpy.typing import ArrayLike

    from unity_link.link.connection import Reconnect
    from unity_link.link.subscription import Sample
    from unity_link.link.subscription import Subscription as AsyncSubscription
    from unity_link.protocol.configuration import GatewayInfo
    from unity_link.protocol.messages import Words
    from unity_link.transport import Medium

T = TypeVar("T")


def connect(target: str | Medium, *, timeout: float = 5.0, reconnect: bool | Reconnect = False) -> BlockingLink:
    """Open a link; `unity_link.connect` says what the arguments are and what is raised.

    The link is open when this returns; use it in a ``with`` block, or call `BlockingLink.close`.
    """
    return BlockingLink(target, timeout=timeout, reconnect=reconnect)


LAST_PATIENCE = 2.0
"""Seconds that the end of a program waits for a link that was not closed."""


class LoopThread:
    """An event loop in a thread of its own, which does not keep a program from ending."""

    def __init__(self) -> None:
        self._loop = asyncio.new_event_loop()
        self._lock = threading.Lock()
        self._calls: set[Future[Any]] | None = set()
        """Calls that are not over; None when there can be no more."""
        self._thread = threading.Thread(target=self._run, name="unity_link.blocking", daemon=True)
        self._thread.start()

    def call(self, function: Callable[..., Coroutine[Any, Any, T]], *arguments: Any) -> T:
        """Call a function in the thread, and wait for what it returns; what interrupts the wait cancels the call.

        Raises:
            ArgumentError: in the thread itself.
            CancelledError: where the thread ends.
        """
        if threading.current_thread() is self._thread:
            raise ArgumentError("a callback runs in the thread of its link, and must not call the link")
        with self._lock:
            if self._calls is None:
                raise CancelledError
            call = asyncio.run_coroutine_threadsafe(function(*arguments), self._loop)
            self._calls.add(call)
        try:
            return call.result()
        finally:
            call.cancel()
            with self._lock:
                if self._calls is not None:
                    self._calls.discard(call)

    def end(self, last: Callable[[], Coroutine[Any, Any, None]]) -> None:
        """Call a last function, cancel all other calls, and end the thread."""

        async def finish() -> None:
            try:
                await last()
            finally:
                # What waits learns of the end in its own words before it is cancelled.
                self._loop.call_soon(self._loop.stop)

        self._loop.call_soon_threadsafe(lambda: self._loop.create_task(finish()))
        # A link that nothing refers to any more may be found in any thread, in its own too.
        if threading.current_thread() is not self._thread:
            # At the end of a program the main thread is over, and some drivers can't close any more.
            self._thread.join(None if threading.main_thread().is_alive() else LAST_PATIENCE)

    def _run(self) -> None:
        with asyncio.Runner(loop_factory=lambda: self._loop) as runner:
            runner.get_loop().run_forever()
            with self._lock:
                calls, self._calls = self._calls or (), None
        for call in calls:
            call.cancel()


class BlockingLink:
    """A connection to one gateway; made by `connect`. `unity_link.Link` documents the methods of the same names.

    A link that is not closed is closed where nothing refers to it any more, and at the end of the program.
    """

    def __init__(self, target: str | Medium, *, timeout: float, reconnect: bool | Reconnect) -> None:
        self._thread = LoopThread()

        async def open_link() -> asynchronous.Link:
            return await asynchronous.connect(target, timeout=timeout, reconnect=reconnect)

        try:
            self._link = self._thread.call(open_link)
        except BaseException:
            self._thread.end(_nothing)
            raise
        self._end = weakref.finalize(self, self._thread.end, self._link.aclose)

    def close(self) -> None:
        """End the link and its thread at once. May be called twice.

        Posted writes that are not executed yet are given up, and their errors are not raised: call `fence` before.
        """
        self._end()

    def _call(self, function: Callable[..., Coroutine[Any, Any, T]], *arguments: Any) -> T:
        """Call a function in the thread of the link, and wait for what it gives."""
        closed = "the link was closed"
        if not self._end.alive:
            raise LinkClosedError(closed, Outcome.NOT_EXECUTED)
        try:
            return self._thread.call(function, *arguments)
        except CancelledError:
            raise LinkClosedError(closed, Outcome.UNKNOWN) from None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Close; where the block ended well, not before the posted writes are executed, and with their errors."""
        try:
            if self._end.alive:
                self._call(self._link.__aexit__, kind, error, trace)
        finally:
            self.close()

    @property
    def gateway(self) -> GatewayInfo:
        """What the gateway says of itself."""
        return self._link.gateway

    @property
    def statistics(self) -> asynchronous.Statistics:
        """What the link has seen since it was opened."""
        return self._link.statistics

    def read(self, address: int) -> int:
        """Read the word at `address`."""
        return self._call(self._link.read, address)

    def write(self, address: int, value: int) -> None:
        """Write `value` to `address`; when this returns it is on the bus."""
        self._call(self._link.write, address, value)

    def write_masked(self, address: int, value: int, mask: int) -> int:
        """Replace the bits of a word that are 1 in `mask`, atomically, and return the word as it was before."""
        return self._call(self._link.write_masked, address, value, mask)

    def post(self, address: int, value: int) -> None:
        """Send a write without waiting for its execution."""
        self._call(self._link.post, address, value)

    def post_many(self, addresses: ArrayLike, values: ArrayLike) -> None:
        """Send many writes without waiting for their execution."""
        self._call(self._link.post_many, addresses, values)

    def fence(self) -> None:
        """Wait until everything that was asked for before has been executed."""
        self._call(self._link.fence)

    def read_block(self, address: int, count: int) -> Words:
        """Read `count` consecutive words from `address` on."""
        return self._call(self._link.read_block, address, count)

    def write_block(self, address: int, values: ArrayLike) -> None:
        """Write consecutive words from `address` on."""
        self._call(self._link.write_block, address, values)

    def read_queue(self, address: int, count: int) -> Words:
        """Read the same address `count` times."""
        return self._call(self._link.read_queue, address, count)

    def write_queue(self, address: int, values: ArrayLike) -> None:
        """Write all `values` to the same address."""
        self._call(self._link.write_queue, address, values)

    def read_many(self, addresses: ArrayLike) -> Words:
        """Read many words in one pipelined batch."""
        return self._call(self._link.read_many, addresses)

    def write_many(self, addresses: ArrayLike, values: ArrayLike) -> None:
        """Write one word to each of many addresses in one pipelined batch."""
        self._call(self._link.write_many, addresses, values)

    def send_immediate(self, mode: asynchronous.SendImmediate) -> None:
        """Choose when the gateway has an FT232H send a short packet at once."""
        self._call(self._link.send_immediate, mode)

    def subscribe(self, addresses: int | ArrayLike, **options: Any) -> BlockingSubscription:
        """Have the gateway sample addresses by itself; `unity_link.Link.subscribe` documents the options.

        A ``callback`` is called in the thread of the link, and must not call the link.
        """

        async def make() -> AsyncSubscription:
            return self._link.subscribe(addresses, **options)

        return BlockingSubscription(self._call(make), self._call)


class BlockingSubscription:
    """A stream of samples; made by `BlockingLink.subscribe`, to be used in a ``with`` block and iterated over."""

    def __init__(self, subscription: AsyncSubscription, call: Callable[..., Any]) -> None:
        self._subscription = subscription
        self._call = call
        self._samples: deque[Sample] = deque()

    @property
    def rate_hz(self) -> float | None:
        """The rate that the gateway publishes at, in Hz; None for a subscription that is not periodic."""
        return self._subscription.rate_hz

    @property
    def received(self) -> int:
        """Samples that arrived so far."""
        return self._subscription.received

    @property
    def lost(self) -> int:
        """Samples lost so far."""
        return self._subscription.lost

    def publish(self) -> None:
        """Have one sample taken now."""
        self._call(self._subscription.publish)

    def __enter__(self) -> Self:
        self._call(self._subscription.__aenter__)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._call(self._subscription.__aexit__, kind, error, trace)

    def __iter__(self) -> Self:
        return self

    def __next__(self) -> Sample:
        if not self._samples:
            # All that wait at once: one change of threads for each would be slow.
            try:
                self._samples.extend(self._call(self._subscription.take))
            except StopAsyncIteration:
                raise StopIteration from None
        return self._samples.popleft()


async def _nothing() -> None:
    """Do nothing."""

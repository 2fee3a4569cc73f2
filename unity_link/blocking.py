"""Links for programs without asyncio: scripts, notebooks, MATLAB.

::

    from unity_link import blocking

    with blocking.connect("sim:scara") as link:
        print(link.read(0x88))
        with link.subscribe([0x88, 0x89], rate_hz=100) as samples:
            for sample in samples:
                print(sample.values)

The methods are those of `unity_link.Link`; any number of threads may call them. On ``serial:``, ``tcp:`` and ``unix:``
a call runs in the calling thread, without an event loop. Other media have an event loop in a thread of their own, so
each call switches threads twice. While there is a subscription, a thread receives its samples.

Between calls no other code of the link runs: the next call, `fence`, or the end of the ``with`` block retransmits lost
posted writes, and the next call detects a lost connection. A thread reopens it.
"""

from __future__ import annotations

import functools
import threading
import warnings
import weakref
from collections import deque
from contextlib import suppress
from typing import TYPE_CHECKING, Any, Self, TypeVar

from unity_link.errors import LinkClosedError, LinkLostError, Outcome, Sealed, UnityLinkError, missing, refusing
from unity_link.link.connecting import connect as connect_asynchronously
from unity_link.link.connection import CONNECT_TIMEOUT
from unity_link.link.interrupts import DEFERRED
from unity_link.link.runtimes.calling_thread import CallingThread
from unity_link.link.subscription import check_count

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable, Coroutine
    from types import TracebackType

    from numpy.typing import ArrayLike

    from unity_link.link import link as asynchronous
    from unity_link.link.connection import Reconnect
    from unity_link.link.publishing import Sample
    from unity_link.link.subscription import Subscription as AsyncSubscription
    from unity_link.protocol.wire.arrays import Words
    from unity_link.protocol.wire.configuration import GatewayInfo
    from unity_link.transport import Medium

T = TypeVar("T")
LAST_PATIENCE = 2.0
"""Seconds that the end of a program waits for the closing of a link that the program did not close."""


def connect(
    target: str | Medium, *, timeout: float = CONNECT_TIMEOUT, reconnect: bool | Reconnect = False
) -> BlockingLink:
    """Open a link; `unity_link.connect` documents the arguments and errors.

    The link is open when this returns; use it in a ``with`` block, or call `BlockingLink.close`.
    """
    return BlockingLink(target, timeout=timeout, reconnect=reconnect)


def _end(runtime: CallingThread, link: asynchronous.Link) -> None:
    """Close a link and end its threads. In a forked process do nothing: link and threads belong to the parent."""
    if runtime.is_disowned:
        return
    if runtime.is_running_here():
        # The garbage collector found the link in a callback of its own thread, which cannot wait for itself.
        runtime.create_task(_close_later(runtime, link))
        return
    # At the end of a program the main thread has ended, and some drivers cannot close any more.
    patience = None if threading.main_thread().is_alive() else LAST_PATIENCE
    try:
        runtime.run(_close, runtime, link, patience)
    finally:
        if runtime.is_closed:
            runtime.close(patience)


def _end_unclosed(runtime: CallingThread, link: asynchronous.Link) -> None:
    """Warn of a link that was not closed, and close it: at garbage collection or at the end of the program."""
    if runtime.is_disowned or runtime.is_closed:
        return
    try:
        warnings.warn(f"{link!r} was not closed: use `with`, or `close`", ResourceWarning, stacklevel=1, source=link)
    finally:
        DEFERRED.finalize(functools.partial(_end, runtime, link))


async def _close_later(runtime: CallingThread, link: asynchronous.Link) -> None:
    await link.aclose()
    runtime.end()


async def _close(runtime: CallingThread, link: asynchronous.Link, patience: float | None) -> None:
    try:
        if patience is None:
            await link.aclose()
            return
        with suppress(TimeoutError):
            async with runtime.timeout(patience):
                await link.aclose()
    finally:
        # End it within this call, which no signal handler interrupts.
        runtime.end()


def noting(entered: list[bool], enter: Callable[[], Awaitable[object]]) -> Callable[[], Coroutine[Any, Any, None]]:
    """Return a coroutine function that enters a block and then appends True to `entered`.

    A signal handler may raise after the call, so that only the list shows whether the block was entered.
    """

    async def note() -> None:
        await enter()
        entered.append(True)

    return note


class BlockingLink(Sealed):
    """A connection to one gateway; made by `connect`. `unity_link.Link` documents the methods of the same names.

    A link that is not closed is closed when no reference to it is left, and at the end of the program.
    """

    if not TYPE_CHECKING:  # A type checker reports such uses by itself.
        __aenter__ = __aexit__ = refusing("write `with` before a blocking link, or connect by `unity_link.connect`")
        __await__ = refusing("a blocking link is open at once, without `await`")

        def __getattr__(self, name: str) -> Any:
            raise missing(
                self,
                name,
                "a blocking link",
                aclose="it is closed by the end of its `with` block, or by `close`",
            )

    def _called(self) -> str:
        return "a blocking link"

    def __init__(self, target: str | Medium, *, timeout: float, reconnect: bool | Reconnect) -> None:
        connecting = connect_asynchronously(target, timeout=timeout, reconnect=reconnect)
        runtimes: list[CallingThread] = []
        opened: list[asynchronous.Link] = []

        async def open_link() -> None:
            opened.append(await connecting.open(runtimes[0]))

        try:
            DEFERRED.held(lambda: runtimes.append(CallingThread()))
            self._runtime = runtime = runtimes[0]
            runtime.run(open_link)
            self._link = opened[0]
            self._end = weakref.finalize(self, _end_unclosed, runtime, self._link)
        except BaseException:
            # A signal handler may raise although the link was opened: close it.
            for link in opened:
                _end(runtimes[0], link)
            for runtime in runtimes:
                runtime.close(None)
            raise
        # Bind these frequent calls once; the runtime of a closed link rejects them itself.
        run: Callable[..., Any] = runtime.run
        self._read: Callable[[int], int] = functools.partial(run, self._link.read)
        self._write: Callable[[int, int], None] = functools.partial(run, self._link.write)
        self._post: Callable[[int, int], None] = functools.partial(run, self._link.post)

    def close(self) -> None:
        """Close the link and end its thread at once. May be called twice.

        Posted writes that are pending are discarded without raising their errors: call `fence` before.
        """
        if self._end.alive:
            try:
                _end(self._runtime, self._link)
            finally:
                if self._runtime.is_closed:
                    self._end.detach()

    def _call(self, function: Callable[..., Coroutine[Any, Any, T]], *arguments: Any) -> T:
        """Run a coroutine function of the link and return its result."""
        if not self._end.alive:
            raise LinkClosedError("the link was closed", Outcome.NOT_EXECUTED)
        return self._runtime.run(function, *arguments)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Close the link. If the block raised no error, first wait for posted writes, and raise their errors."""
        try:
            if self._end.alive and not self._runtime.is_disowned:
                self._call(self._link.__aexit__, kind, error, trace)
        finally:
            self.close()

    def __repr__(self) -> str:
        """Return the URL of the link and whether it is connected."""
        return f"<blocking {repr(self._link)[1:]}"

    def _repr_html_(self) -> str:
        """Return URL, configuration of the gateway and statistics, as an HTML table."""
        from unity_link.link import html

        return html.link_table(self)

    @property
    def gateway(self) -> GatewayInfo:
        """Configuration of the gateway, from its answer to `Q`."""
        return self._link.gateway

    @property
    def statistics(self) -> asynchronous.Statistics:
        """Counters of the link since it was opened."""
        return self._link.statistics

    def read(self, address: int) -> int:
        """Read the word at `address`."""
        return self._read(address)

    def write(self, address: int, value: int) -> None:
        """Write `value` to `address`; return after the write was executed on the bus."""
        self._write(address, value)

    def write_masked(self, address: int, value: int, mask: int) -> int:
        """Replace the bits of a word that are 1 in `mask`, atomically, and return the word as it was before."""
        return self._call(self._link.write_masked, address, value, mask)

    def post(self, address: int, value: int) -> None:
        """Send a write without waiting for its execution."""
        self._post(address, value)

    def post_many(self, addresses: ArrayLike, values: ArrayLike) -> None:
        """Send many writes without waiting for their execution."""
        self._call(self._link.post_many, addresses, values)

    def fence(self) -> None:
        """Wait until all earlier requests have been executed."""
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
        """Set when the gateway makes an FT232H send a short packet at once."""
        self._call(self._link.send_immediate, mode)

    def subscribe(self, addresses: int | ArrayLike, **options: Any) -> BlockingSubscription:
        """Subscribe to addresses that the gateway samples by itself; `unity_link.Link.subscribe` documents the options.

        A ``callback`` is called in the thread that receives the samples, and must not call the link.
        """
        if not self._end.alive:
            raise LinkClosedError("the link was closed", Outcome.NOT_EXECUTED)
        return BlockingSubscription(self._link.subscribe(addresses, **options), self._call, self._runtime.run)


class BlockingSubscription(Sealed):
    """A stream of samples; made by `BlockingLink.subscribe`. Use it in a ``with`` block and iterate over it."""

    if not TYPE_CHECKING:  # A type checker reports such uses by itself.
        __aenter__ = __aexit__ = refusing("write `with` before a subscription of a blocking link")
        __aiter__ = refusing("write `for` over the samples of a blocking link, in a `with` block")

    def __init__(self, subscription: AsyncSubscription, call: Callable[..., Any], run: Callable[..., Any]) -> None:
        self._subscription = subscription
        self._call = call
        self._run = run
        """Like `call`, but also works on a closed link: samples that arrived before can still be read."""
        self._samples: deque[Sample] = deque()

    def _called(self) -> str:
        return "a subscription"

    def __repr__(self) -> str:
        """Return the sampled addresses and the counts of samples."""
        return repr(self._subscription)

    @property
    def rate_hz(self) -> float | None:
        """Rate in Hz at which the gateway publishes; None for a subscription that is not periodic."""
        return self._subscription.rate_hz

    @property
    def received(self) -> int:
        """Number of samples that have arrived."""
        return self._subscription.received

    @property
    def lost(self) -> int:
        """Number of samples that were lost."""
        return self._subscription.lost

    def publish(self) -> None:
        """Request one sample from the gateway now."""
        self._call(self._subscription.publish)

    def take(self, count: int | None = None) -> list[Sample]:
        """Wait for a sample and return all that have arrived; or `count` samples, fewer if the stream ends."""
        if count is not None:
            count = check_count(count)
        waiting = self._samples
        if len(waiting) < (count or 1):
            try:
                self._run(self._fill, count and count - len(waiting))
            except (StopAsyncIteration, UnityLinkError):
                if not waiting:
                    raise
        return [waiting.popleft() for _ in range(len(waiting) if count is None else min(count, len(waiting)))]

    async def _fill(self, count: int | None) -> None:
        """Read samples into `self._samples` within the call, so that a signal handler that raises loses none."""
        self._samples.extend(await self._subscription.take(count))

    def __enter__(self) -> Self:
        entered: list[bool] = []
        try:
            self._call(noting(entered, self._subscription.__aenter__))
            return self  # noqa: TRY300  (a signal handler may raise before this returns)
        except BaseException as error:
            if entered:
                self.__exit__(type(error), error, error.__traceback__)
            raise

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        # A closed link has ended the subscription, which is no error here.
        with suppress(LinkLostError):
            self._run(self._subscription.__aexit__, kind, error, trace)

    def __iter__(self) -> Self:
        return self

    def __next__(self) -> Sample:
        if not self._samples:
            # Fetch all samples that have arrived in one call: a call for each sample would be slow.
            try:
                self._run(self._fill, None)
            except StopAsyncIteration:
                raise StopIteration from None
        return self._samples.popleft()

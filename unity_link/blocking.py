"""The same link for code that is not asynchronous: scripts, notebooks, MATLAB.

::

    from unity_link import blocking

    with blocking.connect("sim:scara") as link:
        print(link.read(0x88))
        with link.subscribe([0x88, 0x89], rate_hz=100) as samples:
            for sample in samples:
                print(sample.values)

Each link has an event loop in a thread of its own (anyio's blocking portal). The methods are those of
`unity_link.Link`, and any number of threads may call them. A call costs a change of threads there and back, so batches
and blocks gain even more here than there.
"""

from __future__ import annotations

from collections import deque
from contextlib import ExitStack
from typing import TYPE_CHECKING, Any, Self, TypeVar

from anyio.from_thread import start_blocking_portal

from unity_link.errors import LinkClosedError, Outcome
from unity_link.link import link as asynchronous

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable
    from types import TracebackType

    from numpy.typing import ArrayLike

    from unity_link.link.connection import Reconnect
    from unity_link.link.subscription import Sample
    from unity_link.link.subscription import Subscription as AsyncSubscription
    from unity_link.protocol.configuration import GatewayInfo
    from unity_link.protocol.messages import Words
    from unity_link.transport import Medium

T = TypeVar("T")


def connect(target: str | Medium, *, timeout: float = 5.0, reconnect: bool | Reconnect = False) -> Link:
    """Open a link; `unity_link.connect` says what the arguments are and what is raised.

    The link is open when this returns; use it in a ``with`` block, or call `Link.close`.
    """
    return Link(target, timeout=timeout, reconnect=reconnect)


class Link:
    """A connection to one gateway; made by `connect`. `unity_link.Link` documents the methods of the same names."""

    def __init__(self, target: str | Medium, *, timeout: float, reconnect: bool | Reconnect) -> None:
        self._closed = False
        with ExitStack() as stack:
            self._portal = stack.enter_context(start_blocking_portal("asyncio"))

            async def open_link() -> asynchronous.Link:
                return await asynchronous.connect(target, timeout=timeout, reconnect=reconnect)

            self._link = self._portal.call(open_link)
            stack.callback(self._portal.call, self._link.aclose)
            self._stack = stack.pop_all()

    def close(self) -> None:
        """End the link and its thread. May be called twice."""
        self._closed = True
        self._stack.close()

    def _call(self, function: Callable[..., Awaitable[T]], *arguments: Any) -> T:
        """Call a function in the thread of the link, and wait for what it gives."""
        if self._closed:
            raise LinkClosedError("the link was closed", Outcome.NOT_EXECUTED)
        return self._portal.call(function, *arguments)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
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
        """Replace the bits of a word that are 1 in `mask`, atomically, and give the word as it was before."""
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

    def subscribe(self, addresses: int | ArrayLike, **options: Any) -> Subscription:
        """Have the gateway sample addresses by itself; `unity_link.Link.subscribe` documents the options.

        A ``callback`` is called in the thread of the link, and must not call the link.
        """

        async def make() -> AsyncSubscription:
            return self._link.subscribe(addresses, **options)

        return Subscription(self._call(make), self._call)


class Subscription:
    """A stream of samples; made by `Link.subscribe`, to be used in a ``with`` block and iterated over."""

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

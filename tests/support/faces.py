"""The blocking API and the API for trio, with the methods of a link in asyncio, for the tests of links.

`Elsewhere` has the methods of a link. It makes blocking calls in threads, and those of trio in trio's own thread.
"""

from __future__ import annotations

import asyncio
import itertools
from concurrent.futures import ThreadPoolExecutor
from contextlib import AsyncExitStack, contextmanager
from typing import TYPE_CHECKING, Any, Self

import numpy as np
import pytest
from anyio.from_thread import start_blocking_portal

import unity_link
from unity_link import blocking
from unity_link.virtual.serving import serve_unix

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Iterator
    from pathlib import Path
    from types import TracebackType


FACES = ("blocking", "trio")
POSTS = 3000
"""More posted writes than uvloop needed to ask a timer for its due time when that time had passed."""
EMPTY = {
    ("blocking", "test_requests_are_executed_in_the_order_of_the_calls"): "threads call in no order",
    ("blocking", "test_only_one_task_reads_a_subscription"): "threads call in no order",
    ("blocking", "test_a_reader_that_was_cancelled_loses_no_sample"): "a call in a thread is not cancelled",
    ("blocking", "test_posted_writes_are_confirmed_without_a_fence"): "between two calls nothing runs",
}
"""Tests of guarantees that an API does not give, and the reasons."""
_connect = unity_link.connect
_WORDS = ("read", "write", "write_masked", "post", "post_many", "fence")
_CALLS = frozenset({*_WORDS, "read_many", "write_many", "send_immediate", "aclose"}) | {
    f"{verb}_{kind}" for verb in ("read", "write") for kind in ("block", "queue")
}


class Elsewhere:
    """A link whose calls are made in another thread.

    Args:
        link: link of the other API.
        call: calls a method in the thread that the API needs, and returns the result.
    """

    def __init__(self, link: Any, call: Callable[..., Any]) -> None:
        self._link = link
        self._call = call

    def __getattr__(self, name: str) -> Any:
        if name not in _CALLS:
            return getattr(self._link, name)
        method = getattr(self._link, "close" if name == "aclose" and not hasattr(self._link, name) else name)
        return lambda *arguments: self._call(method, *arguments)

    async def _ask(self, *arguments: Any) -> None:
        if isinstance(self._link, blocking.BlockingLink):
            await self._call(self._link._call, self._link._link._ask, *arguments)
        else:
            await self._call(self._link._ask, *arguments)

    def subscribe(self, *arguments: Any, **options: Any) -> ElsewhereSubscription:
        return ElsewhereSubscription(self._link.subscribe(*arguments, **options), self._call)


class ElsewhereSubscription:
    """A subscription whose calls are made in another thread."""

    def __init__(self, subscription: Any, call: Callable[..., Any]) -> None:
        self._subscription = subscription
        self._call = call

    def __getattr__(self, name: str) -> Any:
        return getattr(self._subscription, name)

    def _method(self, name: str) -> Callable[..., Any]:
        # Use the name that this API has: the other API refuses it.
        is_blocking = isinstance(self._subscription, blocking.BlockingSubscription)
        found: Callable[..., Any] = getattr(self._subscription, name.replace("__a", "__", 1) if is_blocking else name)
        return found

    async def publish(self) -> None:
        await self._call(self._subscription.publish)

    async def __aenter__(self) -> Self:
        await self._call(self._method("__aenter__"))
        return self

    async def __aexit__(self, *error: object) -> None:
        await self._call(self._method("__aexit__"), *error)

    def __aiter__(self) -> Self:
        return self

    async def __anext__(self) -> Any:
        end = object()
        method = getattr(self._subscription, "__next__", None)
        if method is None:
            return await self._call(self._subscription.__anext__)
        sample = await self._call(next, self._subscription, end)
        if sample is end:
            raise StopAsyncIteration
        return sample


class Connecting:
    """The object that `unity_link.connect` returns: it can be awaited, and used as a context."""

    def __init__(self, opening: Callable[[AsyncExitStack], Any]) -> None:
        self._opening = opening
        self._stack = AsyncExitStack()

    def __await__(self) -> Generator[Any, None, Any]:
        waiting: Generator[Any, None, Any] = self._opening(self._stack).__await__()
        return waiting

    async def __aenter__(self) -> Any:
        await self._stack.__aenter__()
        try:
            return await self._opening(self._stack)
        except BaseException:
            await self._stack.aclose()
            raise

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self._stack.__aexit__(kind, error, trace)


@contextmanager
def face(name: str, folder: Path) -> Iterator[Callable[..., Any]]:
    """Yield a substitute for `unity_link.connect`; the gateways of a test stay in its event loop and serve a socket."""
    numbers = itertools.count()

    async def url_of(target: Any, stack: AsyncExitStack) -> Any:
        if isinstance(target, str):
            return target
        return await stack.enter_async_context(serve_unix(target, folder / f"gateway{next(numbers)}"))

    with start_blocking_portal("trio") as portal:

        async def call_blocking(function: Callable[..., Any], *arguments: Any, **options: Any) -> Any:
            # Run each call in a new thread. It has ended before the next fence, as a task of trio would have: that
            # fence raises the errors of its posted writes.
            thread = ThreadPoolExecutor(1)
            answer = thread.submit(function, *arguments, **options)
            try:
                return await asyncio.wrap_future(answer)
            finally:
                # A cancelled call goes on in its thread.
                thread.shutdown(wait=answer.done())

        async def call_trio(function: Callable[..., Any], *arguments: Any) -> Any:
            return await asyncio.wrap_future(portal.start_task_soon(function, *arguments))

        def connect(target: Any, **options: Any) -> Connecting:
            async def open_blocking(stack: AsyncExitStack) -> Elsewhere:
                link = await call_blocking(blocking.connect, await url_of(target, stack), **options)

                async def leave(*error: Any) -> None:
                    await call_blocking(link.__exit__, *error)

                stack.push_async_exit(leave)
                return Elsewhere(link, call_blocking)

            async def open_trio(stack: AsyncExitStack) -> Elsewhere:
                opened = portal.wrap_async_context_manager(_connect(await url_of(target, stack), **options))
                link = await asyncio.to_thread(opened.__enter__)

                async def leave(*error: Any) -> None:
                    await asyncio.to_thread(opened.__exit__, *error)

                stack.push_async_exit(leave)
                return Elsewhere(link, call_trio)

            return Connecting(open_blocking if name == "blocking" else open_trio)

        yield connect


async def use(connect: Callable[[str], Any], url: str) -> None:
    """Make each kind of call on a link."""
    async with connect(url) as link:
        await link.write(0x0A, 42)
        assert await link.read(0x0A) == 42
        for value in range(POSTS):
            await link.post(value % 256, value)
        await link.fence()
        expected = [max(range(address, POSTS, 256)) for address in range(256)]
        assert (await link.read_many(range(256))).tolist() == expected
        await link.post_many(np.arange(POSTS) % 256, np.arange(POSTS) + 1)
        await link.fence()
        assert (await link.read_block(0, 256)).tolist() == [value + 1 for value in expected]
        await link.write_block(0, range(256))
        await link.write_many(range(128), range(1, 129))
        assert await link.write_masked(1, 0xF0, 0xF0) == 2
        with pytest.raises(unity_link.ArgumentError, match="address"):
            await link.read(1 << 40)
        async with link.subscribe([1, 2], rate_hz=200) as samples:
            taken = [await anext(samples) for _ in range(20)]
        lost = list(itertools.accumulate(sample.lost for sample in taken))
        assert [sample.sequence for sample in taken] == [number + before for number, before in enumerate(lost)]
        # A sample is lost only if the host polls (`mmio:`) and its timer is late.
        assert not lost[-1] or url.startswith("mmio:")
        assert [sample.values.tolist() for sample in taken] == [[0xF2, 3]] * 20
        assert await link.read(2) == 3

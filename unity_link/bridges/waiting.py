"""A link, and samples, for what may be started before its gateway is there."""

from __future__ import annotations

import asyncio
from contextlib import asynccontextmanager
from typing import TYPE_CHECKING, TypeVar

from unity_link.errors import BusTimeoutError, ConnectError, GatewayResetError
from unity_link.link.connecting import connect
from unity_link.transport import parse_url, prepare

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable
    from contextlib import AbstractAsyncContextManager, AsyncExitStack

    from unity_link.link.link import Link

T = TypeVar("T")

LOOK_EVERY = 1.0
"""Seconds between looks whether the gateway is there."""


@asynccontextmanager
async def connect_when_there(url: str, report: Callable[[str], None]) -> AsyncIterator[Link]:
    """Open a link as soon as the gateway is there, and again whenever it is lost.

    Args:
        url: where the gateway is.
        report: is told in a sentence, once, that the gateway is waited for.

    Raises:
        ArgumentError: for a URL that no driver knows.
        ConnectError: where no such gateway can be reached from here, whether it is there or not.
        UnsupportedError: for a gateway of another protocol version.
    """
    await prepare(parse_url(url))
    async with await _connect(url, report) as link:
        yield link


async def _connect(url: str, report: Callable[[str], None]) -> Link:
    is_told = False
    while True:
        try:
            return await connect(url, reconnect=True)
        except ConnectError as error:
            if not is_told:
                report(f"waiting for the gateway: {error}")
            is_told = True
        await asyncio.sleep(LOOK_EVERY)


async def begin_when_there(
    subscribe: Callable[[], AbstractAsyncContextManager[T]], stack: AsyncExitStack, report: Callable[[str], None]
) -> T:
    """Begin a subscription; where a server says that its gateway is away, that is waited for.

    Args:
        subscribe: makes a subscription that has not begun.
        stack: ends it.
        report: is told in a sentence, at each look, what the server says.

    Raises:
        GatewayError: where the gateway refuses it.
        LinkLostError: where the link ends.
    """
    while True:
        try:
            return await stack.enter_async_context(subscribe())
        except (BusTimeoutError, GatewayResetError) as error:
            report(str(error))
            await asyncio.sleep(LOOK_EVERY)

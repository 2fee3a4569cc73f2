"""A link and its subscriptions, for programs that may be started before the gateway is reachable."""

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
"""Seconds between attempts to reach the gateway."""


@asynccontextmanager
async def connect_when_there(url: str, report: Callable[[str], None]) -> AsyncIterator[Link]:
    """Open a link as soon as the gateway is reachable, and again whenever the connection is lost.

    Args:
        url: URL of the gateway.
        report: called once with a sentence if the gateway is not reachable yet.

    Raises:
        ArgumentError: for a URL that no driver supports.
        ConnectError: if this computer cannot open such a URL at all, for example without a package.
        UnsupportedError: for a gateway with another protocol version.
    """
    await prepare(parse_url(url))
    async with await _connect(url, report) as link:
        yield link


async def _connect(url: str, report: Callable[[str], None]) -> Link:
    is_reported = False
    while True:
        try:
            return await connect(url, reconnect=True)
        except ConnectError as error:
            if not is_reported:
                report(f"waiting for the gateway: {error}")
            is_reported = True
        await asyncio.sleep(LOOK_EVERY)


async def begin_when_there(
    subscribe: Callable[[], AbstractAsyncContextManager[T]], stack: AsyncExitStack, report: Callable[[str], None]
) -> T:
    """Begin a subscription. If a server reports that its gateway is away, try again until it is back.

    Args:
        subscribe: makes a subscription that has not begun.
        stack: ends the subscription.
        report: called with the server's error after each attempt.

    Raises:
        GatewayError: if the gateway refuses the subscription.
        LinkLostError: if the link ends.
    """
    while True:
        try:
            return await stack.enter_async_context(subscribe())
        except (BusTimeoutError, GatewayResetError) as error:
            report(str(error))
            await asyncio.sleep(LOOK_EVERY)

"""One link for several programs: the protocol itself, served on a Unix socket or a TCP port.

    Door -> Client and its Conversation, for each client  \
            Turns: the order of requests of all clients   |- SharedLink: one window, one gateway
            Slots: the gateway's groups and their holders /

- `door`: the listener, which checks tokens
- `client`: a program that is served: its `connection` keeps the order of requests and answers, its `conversation`
  decodes the frames and answers some of them (the client protocol)
- `requests`: a client's request on its way through the link's window
- `turns`: the order of requests of all clients
- `leases`: the client that holds each lease
- `groups`: the groups of all clients, which share those of the gateway
- `shared`: the link, and its reactions when the gateway goes away or comes back
"""

from __future__ import annotations

import asyncio
import contextlib
from typing import TYPE_CHECKING

from unity_link.bridges.serve.door import LONGEST_TOKEN, Door
from unity_link.bridges.serve.shared import SharedLink
from unity_link.errors import ArgumentError
from unity_link.transport import DriverUrl, check_target, parse_url, prepare
from unity_link.transport.listening import LOOPBACK, listen_tcp, listen_unix, serving

if TYPE_CHECKING:
    import os
    from collections.abc import AsyncIterator, Callable

    from unity_link.spec.model import Interface
    from unity_link.transport import Medium


FIRST_TRY = 0.2
"""Most seconds that `Server.look` waits."""


class Server:
    """A shared link; `serve` makes it."""

    def __init__(self, shared: SharedLink) -> None:
        self.urls: list[str] = []
        """URLs that clients can connect to. A token is not part of them."""
        self._shared = shared

    @property
    def clients(self) -> int:
        """Number of clients."""
        return len(self._shared.clients)

    async def look(self) -> None:
        """Wait for the result of the first attempt to reach the gateway, at most `FIRST_TRY` seconds.

        Raises:
            ArgumentError: for a URL of a device that does not exist.
            ConnectError: as by `wait`.
        """
        with contextlib.suppress(TimeoutError):
            await asyncio.wait_for(self._shared.tried.wait(), FIRST_TRY)
        if self._shared.ended.done():
            self._shared.ended.result()

    async def wait(self) -> None:
        """Wait until the link has ended for good.

        Raises:
            ArgumentError: for a URL of a device that does not exist.
            ConnectError: with the reason: another gateway answers, or one with another protocol version.
        """
        await self._shared.ended


@serving("a link")
async def serve(
    target: str | Medium,
    *,
    unix: str | os.PathLike[str] | None = None,
    tcp: int | None = None,
    host: str = LOOPBACK,
    token: str | None = None,
    interface: Interface | None = None,
    report: Callable[[str], None] = lambda _: None,
) -> AsyncIterator[Server]:
    """Share one link between several programs, until the end of the context.

    The gateway may be away at the beginning and at any time; clients then wait for it.

    Args:
        target: URL of the gateway, or a medium in this process.
        unix: path of a Unix socket, which only this user can open.
        tcp: TCP port; 0 for any free port.
        host: address of the TCP port; by default only this machine can connect.
        token: token that clients on TCP must send, as in ``tcp://host:port?token=TOKEN``; None for none.
        interface: interface of the gateway, as `Spec.interface` returns it; None for the description that the gateway
            carries. With either, each lease belongs to the client that has armed it: other clients cannot write the
            signals that it guards, and it is disarmed when that client disconnects.
        report: called with a sentence when the gateway goes away or comes back.

    Raises:
        ArgumentError: for a URL that no driver supports, or a token that is no printable text.
        ConnectError: if a socket or port cannot be opened.
    """
    if token is not None and not (
        token.isascii() and token.isprintable() and " " not in token and 0 < len(token) <= LONGEST_TOKEN
    ):
        raise ArgumentError(f"a token of 1 to {LONGEST_TOKEN} printable characters without blanks was expected")
    check_target(target)
    url = parse_url(target) if isinstance(target, str) else target
    if isinstance(url, DriverUrl):
        await prepare(url)
    async with contextlib.AsyncExitStack() as stack:
        shared = SharedLink(url, report, interface)
        stack.push_async_callback(shared.finish)
        server = Server(shared)
        if unix is not None:
            server.urls.append(await stack.enter_async_context(listen_unix(lambda: Door(shared, None), unix)))
        if tcp is not None:
            server.urls.append(await stack.enter_async_context(listen_tcp(lambda: Door(shared, token), tcp, host)))
        shared.open_when_there()
        yield server

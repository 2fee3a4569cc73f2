"""One link, many programs: the protocol itself, served on a Unix socket or a TCP port.

    Door -> Client and its Conversation, for each \
            Turns: whose request is next          |- SharedLink: one window, one gateway
            Slots: which group has which holder    /

- `door`: who is let in
- `client`: a program that is served, by its `connection`, which keeps the order of requests and answers, and its
  `conversation`, which says what the frames mean
- `requests`: a client's request on its way through the link's window
- `turns`: whose request is next
- `leases`: which client has which lease
- `groups`: the groups of all clients on those of the gateway
- `shared`: the link, and what happens when the gateway comes and goes
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
"""Seconds that `Server.look` waits at most."""


class Server:
    """A link that is being shared; made by `serve`."""

    def __init__(self, shared: SharedLink) -> None:
        self.urls: list[str] = []
        """URLs that clients can connect to. A token is not part of them."""
        self._shared = shared

    @property
    def clients(self) -> int:
        """Number of clients."""
        return len(self._shared.clients)

    async def look(self) -> None:
        """Wait for what the first attempt to reach the gateway comes to, but not for long.

        Raises:
            ArgumentError: for a URL of something that there is not.
            ConnectError: as `wait` does.
        """
        with contextlib.suppress(TimeoutError):
            await asyncio.wait_for(self._shared.tried.wait(), FIRST_TRY)
        if self._shared.ended.done():
            self._shared.ended.result()

    async def wait(self) -> None:
        """Wait until the link has ended for good.

        Raises:
            ArgumentError: for a URL of something that there is not.
            ConnectError: it says why: another gateway answers, or one that this program can't talk to.
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

    The gateway may be away at the beginning and at any time: clients wait for it.

    Args:
        target: the URL of a gateway, or one of this process.
        unix: path of a Unix socket, which only this user may open.
        tcp: a TCP port; 0 for any free one.
        host: the address that the TCP port is opened at: this machine alone unless it is said.
        token: what clients on TCP must know, as in ``tcp://host:port?token=TOKEN``.
        interface: the map of the gateway, as `Spec.interface` gives it; None for the one that the gateway carries. With
            either each lease is that of the client that has armed it: other clients cannot move what it guards, and it
            is disarmed when that client has gone.
        report: is told in a sentence when the gateway comes and goes.

    Raises:
        ArgumentError: for a URL that no driver knows, or a token that can't stand in a line.
        ConnectError: where a socket or port can't be opened.
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

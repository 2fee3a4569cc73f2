"""A virtual gateway on standard input and output, for a program that starts it: see own_medium.py."""

from __future__ import annotations

import asyncio
import sys

from unity_link.virtual import VirtualGateway


class Requests(asyncio.Protocol):
    """Passes the input on to the gateway, until the input ends."""

    def __init__(self, gateway: asyncio.Transport) -> None:
        self._gateway = gateway
        self.over = asyncio.Event()

    def data_received(self, data: bytes) -> None:
        """Pass the input on."""
        self._gateway.write(data)

    def connection_lost(self, exc: Exception | None) -> None:  # noqa: ARG002  (the reason does not matter)
        """Note the end of the input."""
        self.over.set()


class Answers(asyncio.Protocol):
    """Writes the answers of the gateway to standard output."""

    def data_received(self, data: bytes) -> None:
        """Write bytes of the gateway, and flush them."""
        sys.stdout.buffer.write(data)
        sys.stdout.buffer.flush()


async def main() -> None:
    """Serve until the input ends."""
    requests = Requests(await VirtualGateway().open(Answers()))
    await asyncio.get_running_loop().connect_read_pipe(lambda: requests, sys.stdin)
    await requests.over.wait()


asyncio.run(main())

"""Links to gateways of this process over the medium of an example: pipes to a program that forwards the bytes."""

from __future__ import annotations

import asyncio
import contextlib
import shlex
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import examples.own_medium  # noqa: F401  (it registers its scheme)
from unity_link.transport import open_medium, parse_url
from unity_link.virtual.serving import ClientCounter, _Client

if TYPE_CHECKING:
    from unity_link.virtual import Gateway

PROGRAM = Path(__file__).with_name("hand_on.py")


class _OnlyClient(_Client):
    """The only client of a gateway: the gateway's side ends with it."""

    def __init__(self, gateway: Gateway) -> None:
        super().__init__(ClientCounter(gateway))
        self.accepted = asyncio.Event()

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        super().connection_made(transport)
        self.accepted.set()

    def connection_lost(self, exc: Exception | None) -> None:
        super().connection_lost(exc)
        self._counter.gateway.abort()


async def connect_through_pipes(gateway: Gateway, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Connect a protocol to a gateway through the pipes of a program; a substitute for `Gateway.open`."""
    client = _OnlyClient(gateway)
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / "gateway")
        # From Python 3.12 on, `async with` would wait for the end of the connection.
        with contextlib.closing(await asyncio.get_running_loop().create_unix_server(lambda: client, path)):
            # Python starts sooner without the site packages.
            command = shlex.join([sys.executable, "-I", "-S", str(PROGRAM), path])
            transport = await open_medium(parse_url(f"pipes:{command}"), protocol)
            await client.accepted.wait()
    return transport

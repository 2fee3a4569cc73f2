"""Serves a virtual gateway in a process of its own until it is killed: ``serve.py MEDIUM [PATH] [LOSS]``.

The script prints the URL in one line when clients can connect.
"""

from __future__ import annotations

import asyncio
import sys

from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Noise, NoisyLine
from unity_link.virtual.serving import serve_pty, serve_tcp, serve_udp, serve_unix


async def main(medium: str, path: str, loss: float) -> None:
    """Serve the gateway until the process is killed."""
    gateway = NoisyLine(VirtualGateway(), Noise(1, loss=loss), Noise(2, loss=loss))
    serving = {
        "serial": lambda: serve_pty(gateway),
        "tcp": lambda: serve_tcp(gateway),
        "unix": lambda: serve_unix(gateway, path),
        "udp": lambda: serve_udp(gateway),
    }
    async with serving[medium]() as url:
        sys.stdout.write(f"{url}\n")
        sys.stdout.flush()
        await asyncio.get_running_loop().create_future()


asyncio.run(main(sys.argv[1], sys.argv[2], float(sys.argv[3])))

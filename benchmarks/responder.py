"""Starts the responder, and gives what benchmarks send to it: frames, through a link or through a bare event loop."""

from __future__ import annotations

import asyncio
import os
import shutil
import subprocess
import tempfile
import tty
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from unity_link.protocol.configuration import Feature, GatewayInfo
from unity_link.protocol.messages import Codec, DecodedRequest

if TYPE_CHECKING:
    from collections.abc import Iterator

SOURCE = Path(__file__).with_name("responder.c")
GATEWAY = GatewayInfo(features=Feature.GROUPS | Feature.FLOW_CONTROL, receive_fifo_bytes=4096, transmit_fifo_bytes=4096)
"""What the responder usually is."""


def exchange(info: GatewayInfo, command: str, *values: Any, reads: Any = None) -> tuple[bytes, bytes]:
    """Return a request with ID 0 and its response."""
    codec = Codec(info)
    response = codec.response(DecodedRequest(command, 0, values), reads)
    return codec.request(command, 0, codec.fields(command, *values)), codec.framing.checked(response)


@contextmanager
def responder(info: GatewayInfo = GATEWAY) -> Iterator[str]:
    """Run the responder in another process behind a pseudo-terminal, and return the path of ours.

    Args:
        info: what it answers to ``Q``, of words of 32 bits and addresses of at most 16.

    Raises:
        FileNotFoundError: where there is no C compiler.
    """
    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if compiler is None:
        raise FileNotFoundError("the benchmarks need a C compiler for their responder: apt install gcc")
    with tempfile.TemporaryDirectory() as directory:
        program = Path(directory) / "responder"
        subprocess.run([compiler, "-O2", "-Wall", "-Wextra", "-o", program, SOURCE], check=True)
        theirs, ours = os.openpty()
        tty.setraw(ours)
        arguments = [str(program), str(theirs), info.to_hex().decode()]
        with subprocess.Popen(arguments, pass_fds=[theirs]) as process:
            os.close(theirs)
            try:
                yield os.ttyname(ours)
            finally:
                process.kill()
                os.close(ours)


class BareLoop:
    """The least that a program on an asyncio loop can do with a pseudo-terminal: no protocol, no checks, bytes counted.

    Args:
        path: of the pseudo-terminal.
    """

    def __init__(self, path: str) -> None:
        self._loop = asyncio.get_running_loop()
        self._port = os.open(path, os.O_RDWR | os.O_NONBLOCK | os.O_NOCTTY)
        self._missing = 0
        self._done: asyncio.Future[None] = self._loop.create_future()
        self._loop.add_reader(self._port, self._read)

    def close(self) -> None:
        """Let the pseudo-terminal go."""
        self._loop.remove_reader(self._port)
        os.close(self._port)

    def send(self, data: bytes) -> None:
        """Write what the pseudo-terminal takes at once: all of it, with so little under way."""
        if os.write(self._port, data) != len(data):
            raise BlockingIOError(f"the pseudo-terminal did not take {len(data)} bytes")

    async def receive(self, size: int) -> None:
        """Wait until `size` more bytes have come."""
        self._missing += size
        if self._missing > 0:
            self._done = self._loop.create_future()
            await self._done

    def _read(self) -> None:
        self._missing -= len(os.read(self._port, 65536))
        if self._missing <= 0 and not self._done.done():
            self._done.set_result(None)

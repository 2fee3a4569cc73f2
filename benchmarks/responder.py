"""Starts the responder, and has the frames that benchmarks send to it, through a link or a bare event loop."""

from __future__ import annotations

import asyncio
import os
import shutil
import socket
import subprocess
import tempfile
import tty
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.messages import Codec, DecodedRequest

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

SOURCE = Path(__file__).with_name("responder.c")
LOOPBACK = "127.0.0.1"
GATEWAY = GatewayInfo(features=Feature.GROUPS | Feature.FLOW_CONTROL, receive_fifo_bytes=4096, transmit_fifo_bytes=4096)
"""Configuration of the responder."""


def exchange(info: GatewayInfo, command: str, *values: Any, reads: Any = None) -> tuple[bytes, bytes]:
    """Return a request with ID 0 and its response."""
    codec = Codec(info)
    response = codec.response(DecodedRequest(command, 0, values), reads)
    return codec.request(command, 0, codec.fields(command, *values)), codec.framing.checked(response)


@contextmanager
def serving(source: Path, medium: str, *arguments: str) -> Iterator[str]:
    """Compile a program, run it at the end of a medium, and return the other end.

    Args:
        source: of a program in C, whose first argument is the descriptor of its end.
        medium: ``pty``: the other end is the path of a pseudo-terminal; ``tcp`` or ``udp``: it is a port.
        arguments: further arguments of the program.

    Raises:
        FileNotFoundError: if there is no C compiler.
    """
    with compiled([source]) as program, ExitStack() as stack:
        yield _run(program, stack, medium, *arguments)


@contextmanager
def compiled(sources: Sequence[Path], *options: str) -> Iterator[Path]:
    """Compile a program from C sources, and return its path for the duration of the context.

    Raises:
        FileNotFoundError: if there is no C compiler.
    """
    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if compiler is None:
        raise FileNotFoundError("the benchmarks need a C compiler: apt install gcc")
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / sources[0].stem
        command = [compiler, "-O2", "-Wall", "-Wextra", "-Werror", *options, "-o", str(program), *map(str, sources)]
        subprocess.run(command, check=True)
        yield program


def _run(program: Path, stack: ExitStack, medium: str, *arguments: str) -> str:
    theirs, name = _PLACES[medium](stack)
    process = subprocess.Popen([str(program), str(theirs), *arguments], pass_fds=[theirs])
    stack.enter_context(process)
    stack.callback(process.kill)
    return name


def _terminal(stack: ExitStack) -> tuple[int, str]:
    theirs, ours = os.openpty()
    # The program's end stays open in this process too, so that a host may connect before the program runs.
    stack.callback(os.close, theirs)
    stack.callback(os.close, ours)
    tty.setraw(ours)
    return theirs, os.ttyname(ours)


def _listener(stack: ExitStack) -> tuple[int, str]:
    server = stack.enter_context(socket.create_server((LOOPBACK, 0)))
    return server.fileno(), str(server.getsockname()[1])


def _datagrams(stack: ExitStack) -> tuple[int, str]:
    server = stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
    server.bind((LOOPBACK, 0))
    return server.fileno(), str(server.getsockname()[1])


_PLACES = {"pty": _terminal, "tcp": _listener, "udp": _datagrams}


@contextmanager
def responder(info: GatewayInfo = GATEWAY, medium: str = "pty") -> Iterator[str]:
    """Run the responder in another process, and return the other end of its medium, as `serving` does.

    Args:
        info: its answer to ``Q``, with words of 32 bits and addresses of at most 16.
        medium: ``pty``, ``tcp`` or ``udp``.

    Raises:
        FileNotFoundError: if there is no C compiler.
    """
    with serving(SOURCE, medium, info.to_hex().decode()) as end:
        yield end


@contextmanager
def responders(count: int, info: GatewayInfo = GATEWAY) -> Iterator[list[str]]:
    """Run many responders, each at a pseudo-terminal of its own, and return the paths of these.

    Raises:
        FileNotFoundError: if there is no C compiler.
    """
    with compiled([SOURCE]) as program, ExitStack() as stack:
        yield [_run(program, stack, "pty", info.to_hex().decode()) for _ in range(count)]


class BareLoop:
    """The minimum that an asyncio program does with a pseudo-terminal: it counts bytes, without protocol or checks.

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
        """Close the pseudo-terminal."""
        self._loop.remove_reader(self._port)
        os.close(self._port)

    def send(self, data: bytes) -> None:
        """Write all bytes at once; the buffer of the pseudo-terminal is large enough for the few bytes in flight."""
        if os.write(self._port, data) != len(data):
            raise BlockingIOError(f"the pseudo-terminal did not take {len(data)} bytes")

    async def receive(self, size: int) -> None:
        """Wait until `size` more bytes have arrived."""
        self._missing += size
        if self._missing > 0:
            self._done = self._loop.create_future()
            await self._done

    def _read(self) -> None:
        self._missing -= len(os.read(self._port, 65536))
        if self._missing <= 0 and not self._done.done():
            self._done.set_result(None)

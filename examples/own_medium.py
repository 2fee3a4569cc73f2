"""A medium of one's own: frames through the pipes of a program, as in "pipes:ssh robot gateway".

python examples/own_medium.py         # a virtual gateway in another process: no hardware
python examples/own_medium.py "pipes:ssh robot gateway"
"""

from __future__ import annotations

import asyncio
import shlex
import sys
from pathlib import Path
from typing import TYPE_CHECKING, cast

import unity_link
from unity_link import ArgumentError
from unity_link.transport import register

if TYPE_CHECKING:
    from unity_link.transport import DriverUrl


class Pipes(asyncio.Transport, asyncio.SubprocessProtocol):
    """The standard input and output of a program, as one transport."""

    def __init__(self, protocol: asyncio.Protocol) -> None:
        # A pipe holds no byte back. Without this the link would wait for answers as long as on a USB chip.
        super().__init__({"shortest_timeout": 0.003})
        self._protocol = protocol

    # Called by the event loop

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Begin: the program has started."""
        # No check by class: the transports of uvloop have none of asyncio's classes.
        self._program = cast("asyncio.SubprocessTransport", transport)
        self._input = cast("asyncio.WriteTransport", self._program.get_pipe_transport(0))
        self._protocol.connection_made(self)

    def pipe_data_received(self, fd: int, data: bytes | str) -> None:  # noqa: ARG002  (its output is the only pipe)
        """Pass on the output of the program."""
        self._protocol.data_received(cast("bytes", data))

    def pause_writing(self) -> None:
        """Pass on that the program does not read."""
        self._protocol.pause_writing()

    def resume_writing(self) -> None:
        """Pass on that the program reads again."""
        self._protocol.resume_writing()

    def connection_lost(self, exc: Exception | None) -> None:
        """Pass on that the program has ended."""
        self._protocol.connection_lost(exc)

    # Called by the link

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Write to the program; the event loop keeps bytes that its pipe does not take."""
        self._input.write(data)

    def is_closing(self) -> bool:
        """Return whether the program is being ended."""
        return self._program.is_closing()

    def abort(self) -> None:
        """End the program."""
        self._program.close()

    close = abort


class PipesDriver:
    """Opens ``pipes:COMMAND``."""

    OPTIONS: frozenset[str] = frozenset()

    async def connect(self, url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
        """Start the program."""
        try:
            command = shlex.split(url.path)
        except ValueError as error:
            raise ArgumentError(f"{url.text} is no command: {error}") from None
        if not command:
            raise ArgumentError(f"{url.text} names no program: pipes:COMMAND was expected")
        loop = asyncio.get_running_loop()
        _, pipes = await loop.subprocess_exec(lambda: Pipes(protocol), *command, stderr=None)
        return pipes


register("pipes", PipesDriver())


async def main(url: str) -> None:
    """Write a word, and read it."""
    async with unity_link.connect(url) as link:
        await link.write(0x0A, 42)
        print(await link.read(0x0A))


if __name__ == "__main__":
    gateway = shlex.join([sys.executable, str(Path(__file__).with_name("gateway_on_pipes.py"))])
    asyncio.run(main(sys.argv[1] if len(sys.argv) > 1 else f"pipes:{gateway}"))

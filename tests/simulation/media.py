"""The simulation's programs and oracle on real media: ``python -m simulation.media REQUESTS [MEDIUM ...]``.

The operating system carries the bytes, and time is real: sockets, pseudo-terminals, and the drivers' threads with a
virtual FT232H. Between medium and gateway, bytes are lost, damaged, duplicated and delayed, and the medium is
disconnected repeatedly. A seed determines the calls and the faults but not their times, so a run cannot be repeated.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import itertools
import socket
import sys
import tempfile
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import msgspec

from simulation.oracle import Oracle, RuleError, Tap
from simulation.plan import Draw
from simulation.programs import Program
from unity_link.transport.ft232h.eeprom_image import build_eeprom
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Noise, NoisyLine
from unity_link.virtual.ft232h.board import GatewayBoard
from unity_link.virtual.ft232h.bus import RealClock, VirtualBus, VirtualFt232h
from unity_link.virtual.ft232h.pyusb_backend import installed
from unity_link.virtual.serving import serve_pty, serve_tcp, serve_udp, serve_unix

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Iterator
    from contextlib import AbstractAsyncContextManager

    from simulation.oracle import LinkLog
    from unity_link.virtual import Gateway

    Serve = Callable[[Gateway], AbstractAsyncContextManager[str]]

CHANCES = {"loss": 2e-4, "flip": 3e-4, "double": 2e-4, "stall": 5e-5}
"""Probabilities for each byte, in both directions."""
BETWEEN_CUTS = 0.7
AWAY = 0.02
SIDE_BY_SIDE = 12
"""Number of programs that run concurrently, each with a gateway of its own."""
SETTLED_AFTER = 300.0
_CRC_32 = {"crc_bits": 32, "crc_polynomial": 0x04C11DB7}


class _LoopClock(RealClock):
    """The clock of the event loop, which the oracle uses for comparisons."""

    def now(self) -> float:
        """Return the time in seconds."""
        return time.monotonic()


class Media:
    """The media by their names, with separate places for any number of gateways.

    Args:
        directory: folder for sockets and links to terminals.
    """

    names = ("tcp", "unix", "udp", "pty", "ft232h")

    def __init__(self, directory: Path) -> None:
        self._directory = directory
        self._numbers = itertools.count()
        self._bus = VirtualBus()

    @contextlib.contextmanager
    def plugged(self) -> Iterator[None]:
        """Make the virtual bus visible to the drivers of the FT232H within the block."""
        with installed(self._bus):
            yield

    def place(self, medium: str) -> Serve:
        """Return a function that serves a gateway at a place of its own, any number of times."""
        name = f"{medium}{next(self._numbers)}"
        path = self._directory / name
        if medium == "tcp":
            port = _free_port(socket.SOCK_STREAM)
            return lambda gateway: serve_tcp(gateway, port)
        if medium == "udp":
            port = _free_port(socket.SOCK_DGRAM)
            return lambda gateway: serve_udp(gateway, port)
        if medium == "unix":
            return lambda gateway: serve_unix(gateway, path)
        if medium == "pty":
            return lambda gateway: serve_pty(gateway, path)
        return self._chip(name)

    def _chip(self, serial: str) -> Serve:
        """Return a function that connects an FT232H for the duration of a block."""
        plugged: list[VirtualFt232h] = []

        @contextlib.asynccontextmanager
        async def plug(gateway: Gateway) -> AsyncIterator[str]:
            if plugged:
                plugged[0].plug_in()
            else:
                plugged.append(
                    VirtualFt232h(GatewayBoard(gateway), image=build_eeprom("FIFO", serial), clock=_LoopClock())
                )
                self._bus.attach(plugged[0])
            try:
                yield f"ftdi-async://ftdi:232h:{serial}/1"
            finally:
                plugged[0].unplug()

        return plug


def _free_port(kind: socket.SocketKind) -> int:
    with socket.socket(socket.AF_INET, kind) as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


class Result:
    """Counts of the runs on one medium."""

    def __init__(self) -> None:
        self.requests = self.programs = self.cuts = self.reconnections = self.repetitions = self.damaged_frames = 0

    def __str__(self) -> str:
        return ", ".join(f"{value} {name}" for name, value in vars(self).items())


class _Run:
    """Programs of successive seeds on one medium."""

    def __init__(self, media: Media, medium: str, result: Result) -> None:
        self._media = media
        self._medium = medium
        self._result = result

    async def run(self, seed: int) -> None:
        """Run the first program of a seed's plan, and check it."""
        plan = Draw(seed).plan()
        model = VirtualGateway(msgspec.structs.replace(plan.gateways[0].info, **_CRC_32))
        # On a busy machine the gateway may be driven late, so its own clock may be late.
        tap = Tap(model, [], "gateway", time.monotonic)
        line = NoisyLine(cast("Gateway", tap), Noise(2 * seed, **CHANCES), Noise(2 * seed + 1, **CHANCES))
        logs: list[LinkLog] = []
        ready: asyncio.Future[str] = asyncio.get_running_loop().create_future()
        serving = asyncio.create_task(self._serve(line, tap, ready))
        try:
            begun: set[asyncio.Future[Any]] = {ready, serving}
            await asyncio.wait(begun, return_when=asyncio.FIRST_COMPLETED)
            if serving.done():
                await serving
            program = Program(f"seed {seed}", plan.programs[0], await ready, tap, logs, [])
            async with asyncio.timeout(SETTLED_AFTER):
                await program.run()
        except TimeoutError:
            raise RuleError("a program that waits without end", f"seed {seed} on {self._medium}") from None
        finally:
            serving.cancel()
            await asyncio.wait({serving})
        Oracle().judge([tap.recorder], logs)
        result = self._result
        result.programs += 1
        for link in program.links:
            result.requests += link.statistics.requests
            result.reconnections += link.statistics.reconnections
            result.repetitions += link.statistics.repetitions
            result.damaged_frames += link.statistics.damaged_frames

    async def _serve(self, line: Gateway, tap: Tap, ready: asyncio.Future[str]) -> None:
        """Serve and disconnect repeatedly; every second time the gateway is reset too."""
        serve = self._media.place(self._medium)
        for number in itertools.count():
            async with serve(line) as url:
                if not ready.done():
                    ready.set_result(url)
                await asyncio.sleep(BETWEEN_CUTS)
            self._result.cuts += 1
            if number % 2:
                tap.reset()
            await asyncio.sleep(AWAY)


async def run_medium(medium: str, requests: int, first: int = 0) -> Result:
    """Run programs on a medium until they have made `requests` requests.

    Raises:
        RuleError: if a rule is broken.
    """
    result, seeds = Result(), itertools.count(first)
    with tempfile.TemporaryDirectory() as directory:
        media = Media(Path(directory))

        async def work() -> None:
            while result.requests < requests:
                seed = next(seeds)
                try:
                    await _Run(media, medium, result).run(seed)
                except RuleError as error:
                    error.add_note(f"seed {seed} on {medium}")
                    raise

        with media.plugged():
            async with asyncio.TaskGroup() as workers:
                for _ in range(SIDE_BY_SIDE):
                    workers.create_task(work())
    return result


def main() -> int:
    """Run the media that the command line names."""
    parser = argparse.ArgumentParser(prog="python -m simulation.media", description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("requests", type=int, help="number of requests on each medium")
    parser.add_argument("media", nargs="*", choices=[[], *Media.names], help="media; all if none is named")
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    options = parser.parse_args()
    for medium in options.media or Media.names:
        began = time.monotonic()
        result = asyncio.run(run_medium(medium, options.requests, options.first))
        sys.stdout.write(f"{medium}: {result}; {time.monotonic() - began:.0f} s\n")
        sys.stdout.flush()
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""Leases of programs that share a link: real sockets, and the bus as the gateway sees it."""

from __future__ import annotations

import asyncio
import contextlib
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from unity_link.bridges.serve import serve
from unity_link.spec import compile_text
from unity_link.virtual.build import simulated
from unity_link.virtual.line import SlowLine

if TYPE_CHECKING:
    from collections.abc import AsyncIterator
    from pathlib import Path

TEXT = """
public rover() {
  GATEWAY(ADDRESS_BITS=12, DATA_BITS=16);
  drive: LEASE(TIMEOUT=20) @(0xE0);
  @speed = 0x10: signed READWRITE(SAFE(0, drive));
  @lamp = 0x11: READWRITE();
}
"""
SPEC = compile_text(TEXT)
Rover = unity_link.load(SPEC)
STRANGE = 0xDEAD


class Watched:
    """A rover, and the words that are written to it in the order of the bus."""

    def __init__(self) -> None:
        self.gateway = simulated(SPEC.interface())
        self.written: list[tuple[int, int]] = []
        robot = self.gateway.robot
        write = robot.write

        def note(offset: int, value: int, now: float) -> None:
            self.written.append((offset, value))
            write(offset, value, now)

        vars(robot)["write"] = note


@contextlib.asynccontextmanager
async def shared(gateway: Any, folder: Path, count: int = 2) -> AsyncIterator[list[Any]]:
    """Serve a gateway, and connect to it by several links; give their rovers."""
    async with contextlib.AsyncExitStack() as stack:
        server = await stack.enter_async_context(serve(gateway, unix=folder / "gateway"))
        links = [await stack.enter_async_context(unity_link.connect(server.urls[0])) for _ in range(count)]
        yield [Rover(link) for link in links]


@pytest.mark.asyncio
async def test_words_of_another_program_never_come_between_those_of_a_kick_or_an_arm(tmp_path: Path) -> None:
    watched = Watched()
    # Both always have something that waits, so that turns end anywhere.
    line = SlowLine(watched.gateway, bytes_per_second=100_000)
    async with shared(line, tmp_path) as (program, stranger):
        registers = [program.drive.arm.signal.addresses, program.drive.kick.signal.addresses]

        async def disturb() -> None:
            while True:
                for addresses in registers:
                    # All but the last one, with which a value is taken.
                    await stranger.drive.arm.link.post_many(addresses[:-1], [STRANGE] * (len(addresses) - 1))

        disturbing = asyncio.create_task(disturb())
        for _ in range(3):
            async with program.armed() as lease:
                for number in range(60):
                    await lease.kick()
                    for _ in range(number % 5):
                        await program.lamp.post(number)
        disturbing.cancel()
    strange, taken = 0, 0
    for addresses in registers:
        words = [word for word in watched.written if word[0] in addresses]
        strange += sum(value == STRANGE for _, value in words)
        ends = [index for index, (address, _) in enumerate(words) if address == addresses[-1]]
        taken += len(ends)
        for end in ends:
            assert [address for address, _ in words[end + 1 - len(addresses) : end + 1]] == list(addresses)
            assert STRANGE not in [value for _, value in words[end + 1 - len(addresses) : end + 1]]
    assert taken > 150
    assert strange > 100

"""Unity-Link in the races, over the URL of any medium."""

from __future__ import annotations

import asyncio
import statistics
import time
from typing import TYPE_CHECKING

import msgspec
import numpy as np

import unity_link
from benchmarks.expected import ADDRESS, WORD, expect
from benchmarks.measure import seconds
from benchmarks.peers.race import BLOCK, Contender, Size, median_of
from benchmarks.responder import GATEWAY, LOOPBACK, exchange, responder
from unity_link import blocking
from unity_link.protocol.wire.compact import CompactForm, Packer
from unity_link.protocol.wire.configuration import Feature

if TYPE_CHECKING:
    from contextlib import ExitStack

LONE, LONE_BLOCKING = "Unity-Link, `await link.read`", "Unity-Link, `blocking`"
TASKS, MANY, BLOCKS = "Unity-Link, 256 tasks", "Unity-Link, `read_many`", "Unity-Link, `read_block`"
COMPACT = " in compact frames"
_TASKS = 256
_WIDE = msgspec.structs.replace(GATEWAY, address_bits=16)
_FRAME = 255
"""Number of words in a full frame."""


class Ours:
    """Unity-Link on a medium, with a responder for single words and one for blocks.

    Args:
        stack: in which the responders run.
        medium: ``pty``, ``tcp`` or ``udp``.
        size: amount of work.
        compact: whether frames are in the compact form.
    """

    def __init__(self, stack: ExitStack, medium: str, size: Size, *, compact: bool = False) -> None:
        self._size = size
        self._compact = compact
        more = Feature.COMPACT if compact else Feature(0)
        infos = [msgspec.structs.replace(info, features=info.features | more) for info in (GATEWAY, _WIDE)]
        self._url, self._wide_url = (_url(medium, stack.enter_context(responder(info, medium))) for info in infos)

    def lone(self) -> list[Contender]:
        """Return the contenders that read one word after the other."""
        return [Contender(LONE, self._read_alone), Contender(LONE_BLOCKING, self._read_blocking)]

    def many(self) -> list[Contender]:
        """Return the contenders that read many words."""
        return [Contender(self._named(TASKS), self._read_by_tasks), Contender(self._named(MANY), self._read_many)]

    def block(self) -> list[Contender]:
        """Return the contender that reads a block."""
        answer = exchange(_WIDE, "RM", 0, _FRAME, reads=[0] * _FRAME)[1]
        if self._compact:
            answer = Packer(CompactForm.of(_WIDE, from_gateway=True)).pack(answer)
        return [Contender(self._named(BLOCKS), self._read_blocks, wire=len(answer) / _FRAME)]

    def _named(self, name: str) -> str:
        return name + COMPACT * self._compact

    def _read_alone(self) -> float:
        async def work() -> float:
            async with unity_link.connect(self._url) as link:
                expect(await link.read(ADDRESS))
                times = []
                for _ in range(self._size.lone):
                    start = time.perf_counter()
                    await link.read(ADDRESS)
                    times.append(time.perf_counter() - start)
                return statistics.median(times)

        return asyncio.run(work())

    def _read_blocking(self) -> float:
        with blocking.connect(self._url) as link:
            expect(link.read(ADDRESS))
            return median_of(lambda: link.read(ADDRESS), self._size.lone)

    def _read_by_tasks(self) -> float:
        each = self._size.together // _TASKS

        async def work() -> float:
            async with unity_link.connect(self._url) as link:

                async def task() -> None:
                    for _ in range(each):
                        await link.read(ADDRESS)

                return await seconds(asyncio.gather(*[task() for _ in range(_TASKS)])) / (each * _TASKS)

        return asyncio.run(work())

    def _read_many(self) -> float:
        addresses = np.arange(self._size.queue) % 256

        async def work() -> float:
            async with unity_link.connect(self._url) as link:
                return await seconds(link.read_many(addresses)) / len(addresses)

        return asyncio.run(work())

    def _read_blocks(self) -> float:
        async def work() -> float:
            async with unity_link.connect(self._wide_url) as link:
                expect((await link.read_block(ADDRESS, 1)).tolist(), [WORD])
                start = time.perf_counter()
                for _ in range(self._size.blocks):
                    await link.read_block(0, BLOCK)
                return (time.perf_counter() - start) / (self._size.blocks * BLOCK)

        return asyncio.run(work())


def _url(medium: str, end: str) -> str:
    return f"serial:{end}" if medium == "pty" else f"{medium}://{LOOPBACK}:{end}"

"""Reads and writes in real time, on a virtual chip that is simulated by a thread: only measured, without modelled time.

The figures include the time of the kernel to wake a program, and the influence of other programs on the machine.
"""

from __future__ import annotations

import asyncio
import time
from typing import TYPE_CHECKING

from benchmarks.paper.results import Spread, WallClock
from benchmarks.paper.stacks import ADDRESS, WORD, of_the_link
from unity_link.link.connecting import connect

if TYPE_CHECKING:
    from collections.abc import Iterator

    from benchmarks.paper.stacks import Access, Mode

URL = "ftdi-async://virtual?latency=1"
_ACCESSES: tuple[Access, ...] = ("read", "write")
_MODES: tuple[Mode, ...] = ("off, 1 ms", "always", "adaptive")
_WARM_UP = 10


def measure_wall_clock(times: int) -> Iterator[WallClock]:
    """Measure accesses of each kind, in each mode."""
    for mode in _MODES:
        for access, taken in zip(_ACCESSES, asyncio.run(_measure(mode, times)), strict=True):
            yield WallClock(access=access, send_immediate=mode, taken=taken)


async def _measure(mode: Mode, times: int) -> list[Spread]:
    found = []
    async with connect(URL, timeout=10) as link:
        await link.send_immediate(of_the_link(mode))
        for access in _ACCESSES:
            taken = []
            for _ in range(_WARM_UP + times):
                began = time.perf_counter()
                await (link.read(ADDRESS) if access == "read" else link.write(ADDRESS, WORD))
                taken.append((time.perf_counter() - began) * 1e6)
            found.append(Spread.of(taken[_WARM_UP:]))
    return found

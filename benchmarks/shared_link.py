"""How much of a link's rate remains if eight programs share it? Every program is a process of its own."""

from __future__ import annotations

import asyncio
import shutil
import statistics
import sys
import tempfile
from asyncio.subprocess import PIPE
from contextlib import asynccontextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from benchmarks.measure import Row
from benchmarks.responder import responder

if TYPE_CHECKING:
    from asyncio.subprocess import Process
    from collections.abc import AsyncIterator

CLIENTS = 8
SECONDS = 1.5
PAIRS = 5
LEAST = 0.8


@asynccontextmanager
async def server(port: str) -> AsyncIterator[str]:
    """Share the link to a port with `unity-link serve`, and return the URL."""
    program = shutil.which("unity-link", path=str(Path(sys.executable).parent)) or "unity-link"
    with tempfile.TemporaryDirectory() as folder:
        arguments = ["serve", f"serial:{port}", "--unix", f"{folder}/shared.sock"]
        process = await asyncio.create_subprocess_exec(program, *arguments, stdout=PIPE, stderr=PIPE)
        try:
            yield await line_of(process)
        finally:
            process.terminate()
            await process.wait()


async def line_of(process: Process) -> str:
    """Return the next line that a process prints."""
    assert process.stdout is not None
    return (await process.stdout.readline()).decode().strip()


async def rate(url: str, clients: int, way: str) -> float:
    """Read in several programs at once, in a way of `shared_client`; return the sum of their reads per second."""
    arguments = ["-m", "benchmarks.shared_client", url, str(SECONDS), way]
    programs = [
        await asyncio.create_subprocess_exec(sys.executable, *arguments, stdin=PIPE, stdout=PIPE)
        for _ in range(clients)
    ]
    for program in programs:
        await line_of(program)
    for program in programs:
        assert program.stdin is not None
        program.stdin.write(b"\n")
    rates = [float(await line_of(program)) for program in programs]
    for program in programs:
        await program.wait()
    return sum(rates)


async def compare(way: str, question: str) -> Row:
    """Compare eight programs with one, through the same server."""
    with responder() as port:
        async with server(port) as url:
            await rate(url, 1, way)
            pairs = [(await rate(url, CLIENTS, way), await rate(url, 1, way)) for _ in range(PAIRS)]
    kept = statistics.median(eight / one for eight, one in pairs)
    eight, one = (statistics.median(rates) for rates in zip(*pairs, strict=True))
    return Row(
        question,
        f"{eight:,.0f} reads/s",
        f"{one:,.0f} reads/s",
        f"{1 / kept:.2f}",
        f"at least {LEAST:.0%} of one alone",
        kept >= LEAST,
    )


async def measure() -> Row:
    """Read in 64 tasks in each program."""
    return await compare("tasks", f"Reads by {CLIENTS} programs that share a link; beside it, by one alone")

"""Measures the seconds of whole programs, for the benchmarks of imports and commands."""

from __future__ import annotations

import asyncio
import contextlib
import os
import subprocess
import sys
import tempfile
import time
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable, Iterator

ASYNCIO = "import asyncio"


@contextlib.contextmanager
def programs() -> Iterator[Callable[..., Callable[[], Awaitable[float]]]]:
    """Return a function that makes a measurement, in seconds, from a program's text and arguments.

    Bytecode is cached between runs, like that of an installed package.
    """
    with tempfile.TemporaryDirectory() as cache:
        environment = os.environ | {"PYTHONPYCACHEPREFIX": cache}
        environment.pop("PYTHONDONTWRITEBYTECODE", None)

        def program(*arguments: str) -> Callable[[], Awaitable[float]]:
            async def run() -> float:
                start = time.perf_counter()
                process = await asyncio.create_subprocess_exec(
                    sys.executable, "-c", *arguments, env=environment, stdout=subprocess.DEVNULL
                )
                if await process.wait():
                    raise SystemExit(f"{arguments[0]!r} failed")
                return time.perf_counter() - start

            return run

        yield program

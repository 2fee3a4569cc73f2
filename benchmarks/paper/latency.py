"""How long one access takes, alone."""

from __future__ import annotations

import asyncio
import statistics
from typing import TYPE_CHECKING

from benchmarks.paper.build import checked, compiled_gateway
from benchmarks.paper.results import ACCESSES, MODES, RHYTHMS, Latency, Rhythm, SendImmediate

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Iterator

    from benchmarks.paper.stacks import Access, Stack, StackName
    from benchmarks.paper.workbench import Workbench

_WARM_UP = 20
_STEP, _STEPS = 37, 125
"""Microseconds between accesses "at any time": all places in a microframe, one after the other in no order."""


def measure_latencies(bench: Workbench, stack: StackName, times: int, runs: int = 1) -> Iterator[Latency]:
    """Measure all of one stack.

    Args:
        bench: where.
        stack: through what.
        times: how many accesses the median is of; a tenth of that where each takes 16 ms.
        runs: how often with the program's time, of which the best counts.
    """
    for access in (access for access in ACCESSES if access != "post"):
        gateware = _gateware(stack, access) if bench.gateway == "rtl" else None
        for rhythm in RHYTHMS:
            measures = [_measuring(access, mode, rhythm, times // 10 if mode == "off" else times) for mode in MODES]
            for mode, (modelled, total) in zip(MODES, bench.best(stack, measures, runs, min), strict=True):
                yield Latency(
                    stack=stack,
                    access=access,
                    send_immediate=mode,
                    rhythm=rhythm,
                    gateware=gateware,
                    modelled=modelled,
                    total=total,
                )


def _measuring(
    access: Access, mode: SendImmediate, rhythm: Rhythm, times: int
) -> Callable[[Stack], Coroutine[None, None, float]]:
    async def measure(stack: Stack) -> float:
        loop = asyncio.get_running_loop()
        await stack.send_immediate(mode)
        taken = []
        for index in range(_WARM_UP + times):
            if rhythm == "at any time":
                await asyncio.sleep(index * _STEP % _STEPS * 1e-6)
            began = loop.time()
            await stack.one(access)
            taken.append(loop.time() - began)
        return statistics.median(taken[_WARM_UP:]) * 1e6

    return measure


def _gateware(stack: StackName, access: Access) -> float:
    """Count what a request and its answer take at the pins and in the gateware, in microseconds."""
    gateway = compiled_gateway()
    gateway.receive(checked(b"K000"), 0.0)
    gateway.set_pace(8e6)
    if stack == "low-level":
        body = b"R0A" if access == "read" else b"W0A00000012"
    else:
        body = b"r0000A" if access == "read" else b"w0000A00000012"
    passage = gateway.pass_pins(checked(body), 10_000, 1024)
    return passage.cycles / gateway.info.clock_hz * 1e6

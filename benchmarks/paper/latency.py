"""Duration of a single access until its answer and until its effect, and the delay of a sample."""

from __future__ import annotations

import asyncio
import statistics
from typing import TYPE_CHECKING

from benchmarks.paper.build import OPENING, checked, compiled_gateway
from benchmarks.paper.results import RHYTHMS, Arrival, Effect, Latency, Rhythm, Spread
from benchmarks.paper.stacks import BLOCK_WORDS, MODES, PROBE

if TYPE_CHECKING:
    from collections.abc import Iterator

    from benchmarks.paper.stacks import Access, Mode, Stack, StackName
    from benchmarks.paper.workbench import Measure, Workbench

_ANSWERED: tuple[Access, ...] = ("read", "block", "write")
_EFFECTIVE: tuple[Access, ...] = ("write", "post")
_WARM_UP = 20
_STEP, _STEPS = 37, 125
"""Step and number of steps, in us, of the time between accesses "at any time": all places in a microframe, shuffled."""
BURST = 30
"""Number of writes at once, as in the paper."""
_PERIODS: dict[Mode, int] = {"off": 17_037}
_PERIOD = 2_037
"""Time in us from sample to sample: more than any timer, and not a multiple of a microframe."""


def measure_latencies(bench: Workbench, stack: StackName, times: int, runs: int = 1) -> Iterator[Latency]:
    """Measure all latencies of one stack.

    Args:
        bench: runs the measurements.
        stack: the stack to measure.
        times: number of accesses; a tenth of it if each takes 16 ms.
        runs: number of runs with the program's time, of which the best counts.
    """
    for access in _ANSWERED:
        gateware = _gateware(stack, access) if bench.gateway == "rtl" else None
        for rhythm in RHYTHMS:
            measures = [(mode, _measuring(access, rhythm, _as_many(times, mode))) for mode in MODES]
            found = bench.best(stack, measures, runs, lambda pair: pair[0].median)
            for mode, ((modelled, sizes), (total, _)) in zip(MODES, found, strict=True):
                yield Latency(
                    stack=stack,
                    access=access,
                    send_immediate=mode,
                    rhythm=rhythm,
                    request_bytes=sizes[0],
                    answer_bytes=sizes[1],
                    gateware=gateware,
                    modelled=modelled,
                    total=total,
                )


def measure_effects(bench: Workbench, stack: StackName, times: int, runs: int = 1) -> Iterator[Effect]:
    """Measure the time from a write to its effect on the bus; arguments as in `measure_latencies`."""
    for access in _EFFECTIVE:
        measures = [(mode, _measuring_effects(access, _as_many(times, mode))) for mode in MODES]
        found = bench.best(stack, measures, runs, lambda triple: triple[0].median)
        for mode, ((modelled, burst, size), (total, burst_total, _)) in zip(MODES, found, strict=True):
            yield Effect(
                stack=stack,
                access=access,
                send_immediate=mode,
                request_bytes=size,
                modelled=modelled,
                total=total,
                burst_modelled=burst,
                burst_total=burst_total,
            )


def measure_arrivals(bench: Workbench, stack: StackName, times: int, runs: int = 1) -> Iterator[Arrival]:
    """Measure the delay of samples of one word in a stack; arguments as in `measure_latencies`."""
    measures = [(mode, _measuring_arrivals(mode, _as_many(times, mode))) for mode in MODES]
    found = bench.best(stack, measures, runs, lambda spread: spread.median)
    for mode, (modelled, total) in zip(MODES, found, strict=True):
        yield Arrival(stack=stack, send_immediate=mode, modelled=modelled, total=total)


def _as_many(times: int, mode: Mode) -> int:
    return max(4, times // 10) if mode == "off" else times


def _measuring(access: Access, rhythm: Rhythm, times: int) -> Measure[tuple[Spread, tuple[int, int]]]:
    async def measure(stack: Stack) -> tuple[Spread, tuple[int, int]]:
        loop = asyncio.get_running_loop()
        taken = []
        for index in range(_WARM_UP + times):
            if rhythm == "at any time":
                await asyncio.sleep(index * _STEP % _STEPS * 1e-6)
            began = loop.time()
            await stack.one(access)
            taken.append((loop.time() - began) * 1e6)
        return Spread.of(taken[_WARM_UP:]), stack.sizes[access]

    return measure


def _measuring_effects(access: Access, times: int) -> Measure[tuple[Spread, float, int]]:
    async def measure(stack: Stack) -> tuple[Spread, float, int]:
        loop, effects = asyncio.get_running_loop(), stack.probe.effects
        taken = []
        for index in range(_WARM_UP + times):
            # The answer shows that earlier posted writes have had their effect.
            await stack.one("read")
            await asyncio.sleep(index * _STEP % _STEPS * 1e-6)
            effects.clear()
            began = loop.time()
            await stack.one(access, PROBE)
            if access == "post":
                await stack.one("read")
            taken.append((effects[0] - began) * 1e6)
        periods = []
        for _ in range(4):
            effects.clear()
            await stack.burst(access, BURST, PROBE)
            assert len(effects) == BURST
            periods.append((effects[-1] - effects[0]) / (BURST - 1) * 1e6)
        # The first burst includes work that is done only once.
        return Spread.of(taken[_WARM_UP:]), round(statistics.median(periods[1:]), 4), stack.sizes[access][0]

    return measure


def _measuring_arrivals(mode: Mode, times: int) -> Measure[Spread]:
    async def measure(stack: Stack) -> Spread:
        loop = asyncio.get_running_loop()
        taken = []
        immediate = mode in ("always", "adaptive")
        async with stack.publishing([PROBE], _PERIODS.get(mode, _PERIOD), immediate=immediate) as samples:
            for _ in range(2 + times):
                sample = await anext(samples)
                taken.append((loop.time() - stack.probe.time_of(stack.clock_of(sample))) * 1e6)
        assert not samples.lost
        return Spread.of(taken[2:])

    return measure


def _gateware(stack: StackName, access: Access) -> float:
    """Return the clock-exact time of a request and its answer at the pins and in the gateware, in us."""
    gateway = compiled_gateway()
    gateway.receive(OPENING, 0.0)
    gateway.set_pace(8e6)
    fields = {"read": b"0A", "block": b"0A%02X" % BLOCK_WORDS, "write": b"0A00000012"}[access]
    letters = {"read": b"R", "block": b"RM", "write": b"W"}[access]
    body = letters + fields if stack == "low-level" else letters.lower() + b"000" + fields
    passage = gateway.pass_pins(checked(body), 10_000, 1024)
    return round(passage.cycles / gateway.info.clock_hz * 1e6, 4)

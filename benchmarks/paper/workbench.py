"""A gateway, a chip and a loop, fresh for each measurement."""

from __future__ import annotations

import asyncio
import gc
from contextlib import asynccontextmanager
from typing import TYPE_CHECKING, Literal, TypeVar

import msgspec

from benchmarks.paper.build import MODEL, compiled_gateway
from benchmarks.paper.stacks import FullStack, LowLevel
from unity_link.errors import ConnectError
from unity_link.virtual import VirtualGateway
from unity_link.virtual.ft232h.board import GatewayBoard
from unity_link.virtual.ft232h.bus import LoopClock, VirtualBus, VirtualFt232h
from unity_link.virtual.ft232h.rtl_board import RtlBoard
from unity_link.virtual.ft232h.timing import Timing
from unity_link.virtual.modelled_time import ModelledTimeLoop

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Coroutine, Iterable, Sequence

    from benchmarks.paper.stacks import Stack, StackName
    from unity_link.virtual.ft232h.board import Board

GatewayKind = Literal["rtl", "model"]
T = TypeVar("T")

OPENING = 60.0
"""Seconds of modelled time that opening may take: no answer is late on a virtual chip."""


def available_gateway() -> GatewayKind:
    """Return what can stand behind the chip on this machine: the RTL, where there is a C++ compiler."""
    try:
        compiled_gateway()
    except ConnectError:
        return "model"
    return "rtl"


class Workbench(msgspec.Struct, frozen=True):
    """How measurements are made."""

    gateway: GatewayKind
    timing: Timing = Timing()
    counts_host_time: bool = True
    """False to leave the program's time out everywhere: then every run gives the same."""

    def run(self, stack: StackName, measure: Callable[[Stack], Coroutine[None, None, T]], *, host_time: bool) -> T:
        """Measure on a fresh gateway, through one of the stacks.

        Args:
            stack: the way to the gateway.
            measure: works on it, and reads the time of the running loop.
            host_time: count the program's processor time besides the modelled time.
        """
        gc.collect()
        with asyncio.Runner(
            loop_factory=lambda: ModelledTimeLoop(host_time=host_time and self.counts_host_time)
        ) as runner:
            return runner.run(self._measure(stack, measure))

    def best(
        self,
        stack: StackName,
        measures: Sequence[Callable[[Stack], Coroutine[None, None, float]]],
        runs: int,
        choose: Callable[[Iterable[float]], float],
    ) -> list[tuple[float, float]]:
        """Return figures without the program's time, and the best of several runs with it.

        What else runs on the machine spoils the caches, and so can only make a figure worse. The measurements take
        turns, so that it does that to all of them alike.

        Args:
            stack: the way to the gateway.
            measures: each gives a figure.
            runs: how often with the program's time.
            choose: `min`, or `max` where more is better.
        """
        modelled = [self.run(stack, measure, host_time=False) for measure in measures]
        if not self.counts_host_time:
            return list(zip(modelled, modelled, strict=True))
        rounds = [[self.run(stack, measure, host_time=True) for measure in measures] for _ in range(runs)]
        return list(zip(modelled, map(choose, zip(*rounds, strict=True)), strict=True))

    async def _measure(self, stack: StackName, measure: Callable[[Stack], Coroutine[None, None, T]]) -> T:
        async with self._plugged_in(), (LowLevel if stack == "low-level" else FullStack).opened(OPENING) as way:
            return await measure(way)

    @asynccontextmanager
    async def _plugged_in(self) -> AsyncIterator[None]:
        from unity_link.virtual.ft232h.pyusb_backend import installed

        device = VirtualFt232h(self._board(), timing=self.timing, clock=LoopClock())
        with installed(VirtualBus(device)):
            yield

    def _board(self) -> Board:
        if self.gateway == "model":
            return GatewayBoard(VirtualGateway(MODEL))
        return RtlBoard(compiled_gateway(), self.timing.fifo_bytes_per_second)

"""A new gateway, chip and loop for each measurement."""

from __future__ import annotations

import asyncio
import gc
from contextlib import asynccontextmanager
from typing import TYPE_CHECKING, Literal, TypeAlias, TypeVar

import msgspec

from benchmarks.paper.build import MODEL, compiled_gateway
from benchmarks.paper.media import ASYNCHRONOUS, Medium
from benchmarks.paper.probe import Probe
from benchmarks.paper.stacks import PROBE, FullStack, LowLevel, url_of
from unity_link.errors import ConnectError
from unity_link.transport.ft232h.eeprom_image import build_eeprom
from unity_link.virtual import VirtualGateway
from unity_link.virtual.ft232h.board import STEP, GatewayBoard
from unity_link.virtual.ft232h.bus import DEFAULT_SERIAL, LoopClock, VirtualBus, VirtualFt232h
from unity_link.virtual.ft232h.rtl_board import RtlBoard
from unity_link.virtual.ft232h.timing import Timing
from unity_link.virtual.modelled_time import ModelledTimeLoop

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Coroutine, Sequence

    from benchmarks.paper.stacks import Mode, Stack, StackName
    from unity_link.virtual.ft232h.board import AttachedBoard
    from unity_link.virtual.gateway import BareGateway

GatewayKind = Literal["rtl", "model"]
T = TypeVar("T")
Measure: TypeAlias = "Callable[[Stack], Coroutine[None, None, T]]"

OPENING = 60.0
"""Timeout in seconds of modelled time for opening; it is long, because no answer is late on a virtual chip."""


def available_gateway() -> GatewayKind:
    """Return the gateway that this machine can run: the RTL if there is a C++ compiler, otherwise the model."""
    try:
        compiled_gateway()
    except ConnectError:
        return "model"
    return "rtl"


class Workbench(msgspec.Struct, frozen=True):
    """Equipment of the measurements."""

    gateway: GatewayKind
    timing: Timing = Timing()
    counts_host_time: bool = True
    """False to exclude the program's time everywhere, so that every run has the same results."""
    medium: Medium = ASYNCHRONOUS
    """Medium between chip and gateway; the RTL is available only with the default."""

    def run(self, stack: StackName, mode: Mode, measure: Measure[T], *, host_time: bool) -> T:
        """Measure on a new gateway, through one of the stacks.

        Args:
            stack: the way to the gateway.
            mode: of send-immediate.
            measure: uses the stack, and reads the time of the running loop.
            host_time: include the program's processor time in the modelled time.
        """
        gc.collect()
        with asyncio.Runner(
            loop_factory=lambda: ModelledTimeLoop(host_time=host_time and self.counts_host_time)
        ) as runner:
            return runner.run(self._measure(stack, mode, measure))

    def best(
        self,
        stack: StackName,
        measures: Sequence[tuple[Mode, Measure[T]]],
        runs: int,
        badness: Callable[[T], float],
    ) -> list[tuple[T, T]]:
        """Return figures without the program's time, and the best of several runs with it.

        Other programs on the machine use the caches too, and so can only make a figure worse. The measurements take
        turns, so that all are affected alike.

        Args:
            stack: the way to the gateway.
            measures: each returns a figure, in a mode.
            runs: number of runs with the program's time.
            badness: of a figure; the smallest is the best.
        """
        modelled = [self.run(stack, mode, measure, host_time=False) for mode, measure in measures]
        if not self.counts_host_time:
            return list(zip(modelled, modelled, strict=True))
        rounds = [[self.run(stack, mode, measure, host_time=True) for mode, measure in measures] for _ in range(runs)]
        best = [min(found, key=badness) for found in zip(*rounds, strict=True)]
        return list(zip(modelled, best, strict=True))

    async def _measure(self, stack: StackName, mode: Mode, measure: Measure[T]) -> T:
        url = url_of(mode, self.medium.options)
        kind = LowLevel if stack == "low-level" else FullStack
        async with self._plugged_in() as probe, kind.opened(url, mode, probe, OPENING) as way:
            return await measure(way)

    @asynccontextmanager
    async def _plugged_in(self) -> AsyncIterator[Probe]:
        from unity_link.virtual.ft232h.pyusb_backend import installed

        gateway, board = self._board()
        probe = Probe(board, MODEL.clock_hz)
        gateway.attach(probe, [PROBE])
        image = build_eeprom(self.medium.eeprom, DEFAULT_SERIAL)
        device = VirtualFt232h(board, image=image, timing=self.timing, clock=LoopClock())
        with installed(VirtualBus(device)):
            yield probe

    def _board(self) -> tuple[BareGateway, AttachedBoard]:
        info = self.medium.of(MODEL)
        if self.gateway == "model":
            # Bytes arrive one by one: a step that fills a FIFO would look like an overflow.
            step = min(STEP, self.medium.fifo_bytes // 2)
            model = VirtualGateway(info)
            return model, GatewayBoard(model, self.medium.mode, step=step)
        gateware = compiled_gateway(info.features)
        return gateware, RtlBoard(gateware, self.timing.fifo_bytes_per_second)

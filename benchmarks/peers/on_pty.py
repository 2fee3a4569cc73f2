"""Races on a pseudo-terminal: LiteX' `CommUART`, pyserial by hand, and pymodbus with RTU frames."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from benchmarks.expected import ADDRESS, expect
from benchmarks.peers.by_hand import ByHand
from benchmarks.peers.modbus import Modbus
from benchmarks.peers.ours import BLOCKS, LONE, LONE_BLOCKING, TASKS, Ours
from benchmarks.peers.race import BLOCK, RESPONDERS, Contender, Race, Size, median_of, seconds_of
from benchmarks.responder import responder, serving

if TYPE_CHECKING:
    from collections.abc import Callable
    from contextlib import ExitStack

MEDIUM = "pty"
BY_HAND = "pyserial and a lock"
BURST = 255
"""Number of words in LiteX' longest read."""


def races(stack: ExitStack, size: Size) -> list[Race]:
    """Return the races on this medium."""
    ours = Ours(stack, "pty", size)
    litex = _Litex(stack.enter_context(serving(RESPONDERS, "pty", "litex")), size)
    by_hand = ByHand(stack.enter_context(responder()))
    lone_by_hand = Contender(BY_HAND, lambda: by_hand.seconds_of_a_read(size.lone), LONE_BLOCKING)
    many_by_hand = Contender(f"{BY_HAND}, one after the other", lambda: by_hand.seconds_of_reads(size.lone), TASKS)
    modbus = Modbus("pymodbus, RTU", stack.enter_context(serving(RESPONDERS, "pty", "modbus-rtu")), size)
    return [
        Race("a read, one after the other", MEDIUM, "", [*ours.lone(), litex.lone(), lone_by_hand, modbus.lone(LONE)]),
        Race("many reads", MEDIUM, "reads", [*ours.many(), litex.many(), many_by_hand, modbus.gathered(TASKS)]),
        Race("a block of 65,536 words", MEDIUM, "words", [*ours.block(), litex.block(), modbus.block(BLOCKS)]),
    ]


class _Litex:
    def __init__(self, path: str, size: Size) -> None:
        self._path = path
        self._size = size

    def lone(self) -> Contender:
        return Contender("LiteX, `CommUART.read`", self._with_port(self._read_alone), LONE_BLOCKING)

    def many(self) -> Contender:
        return Contender("LiteX, one after the other", self._with_port(self._read_many), TASKS)

    def block(self) -> Contender:
        return Contender("LiteX, bursts of 255", self._with_port(self._read_block), BLOCKS, wire=4)

    def _with_port(self, work: Callable[[Any], float]) -> Callable[[], float]:
        def run() -> float:
            from litex.tools.remote.comm_uart import CommUART

            bridge = CommUART(self._path)
            expect(bridge.read(4 * ADDRESS))
            try:
                return work(bridge)
            finally:
                bridge.close()

        return run

    def _read_alone(self, bridge: Any) -> float:
        return median_of(lambda: bridge.read(4 * ADDRESS), self._size.lone)

    def _read_many(self, bridge: Any) -> float:
        count = self._size.lone

        def work() -> None:
            for _ in range(count):
                bridge.read(4 * ADDRESS)

        return seconds_of(work) / count

    def _read_block(self, bridge: Any) -> float:
        def work() -> list[int]:
            words: list[int] = []
            while len(words) < BLOCK:
                words += bridge.read(4 * len(words), min(BURST, BLOCK - len(words)))
            return words

        return seconds_of(work) / BLOCK

"""Races on UDP: `uhal`, the C++ library of IPbus with its Python binding."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

from benchmarks.expected import ADDRESS, expect
from benchmarks.peers.ours import BLOCKS, LONE_BLOCKING, MANY, Ours
from benchmarks.peers.race import BLOCK, RESPONDERS, Contender, Race, Size, median_of, seconds_of
from benchmarks.responder import LOOPBACK, serving

if TYPE_CHECKING:
    from contextlib import ExitStack

MEDIUM = "UDP"
_MAP = """<node>
  <node id="word" address="{address:#x}"/>
  <node id="block" address="0x0" mode="incremental" size="{size}"/>
</node>
"""
_AT_ONCE = 256
_PACKET = (4 * (345 + 3)) / 345
"""Bytes per word of a block: a packet has up to 345 words, in two transactions."""


def races(stack: ExitStack, size: Size) -> list[Race]:
    """Return the races on this medium."""
    ours, compact = (Ours(stack, "udp", size, compact=form) for form in (False, True))
    uhal = _Uhal(stack, size)
    return [
        Race("a read, one after the other", MEDIUM, "", [*ours.lone(), uhal.lone()]),
        Race("many reads", MEDIUM, "reads", [*ours.many(), *compact.many(), *uhal.many()]),
        Race("a block of 65,536 words", MEDIUM, "words", [*ours.block(), *compact.block(), *uhal.block()]),
    ]


class _Uhal:
    def __init__(self, stack: ExitStack, size: Size) -> None:
        import uhal

        uhal.disableLogging()
        port = stack.enter_context(serving(RESPONDERS, "udp", "ipbus"))
        addresses = Path(stack.enter_context(tempfile.TemporaryDirectory())) / "map.xml"
        addresses.write_text(_MAP.format(address=ADDRESS, size=BLOCK))
        self._size = size
        self._device = uhal.getDevice("responder", f"ipbusudp-2.0://{LOOPBACK}:{port}", f"file://{addresses}")
        self._word, self._block = self._device.getNode("word"), self._device.getNode("block")
        expect(int(self._read()))

    def lone(self) -> Contender:
        return Contender("`uhal`, `read` and `dispatch`", self._read_alone, LONE_BLOCKING)

    def many(self) -> list[Contender]:
        return [
            Contender("`uhal`, 256 reads and `dispatch`", lambda: self._read_queued(_AT_ONCE), MANY),
            Contender("`uhal`, all reads and `dispatch`", lambda: self._read_queued(self._size.queue), MANY),
        ]

    def block(self) -> list[Contender]:
        return [
            Contender("`uhal`, `readBlock`", self._read_blocks, BLOCKS, _PACKET),
            Contender("`uhal`, `readBlock` as a list", self._read_lists, BLOCKS, _PACKET),
        ]

    def _read(self) -> Any:
        word = self._word.read()
        self._device.dispatch()
        return word

    def _read_alone(self) -> float:
        return median_of(self._read, self._size.lone)

    def _read_queued(self, at_once: int) -> float:
        rounds = max(1, self._size.queue // at_once)

        def work() -> None:
            for _ in range(rounds):
                words = [self._word.read() for _ in range(at_once)]
                self._device.dispatch()
                expect(int(words[-1]))

        return seconds_of(work) / (rounds * at_once)

    def _dispatch_block(self) -> Any:
        words = self._block.readBlock(BLOCK)
        self._device.dispatch()
        return words

    def _read_blocks(self) -> float:
        def work() -> None:
            for _ in range(self._size.blocks):
                self._dispatch_block()

        return seconds_of(work) / (self._size.blocks * BLOCK)

    def _read_lists(self) -> float:
        def work() -> None:
            for _ in range(self._size.blocks):
                list(self._dispatch_block())

        return seconds_of(work) / (self._size.blocks * BLOCK)

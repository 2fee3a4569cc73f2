"""Races on TCP: pymodbus."""

from __future__ import annotations

from typing import TYPE_CHECKING

from benchmarks.peers.modbus import Modbus
from benchmarks.peers.ours import BLOCKS, LONE, TASKS, Ours
from benchmarks.peers.race import RESPONDERS, Race, Size
from benchmarks.responder import serving

if TYPE_CHECKING:
    from contextlib import ExitStack

MEDIUM = "TCP"


def races(stack: ExitStack, size: Size) -> list[Race]:
    """Return the races on this medium."""
    ours = Ours(stack, "tcp", size)
    modbus = Modbus("pymodbus", int(stack.enter_context(serving(RESPONDERS, "tcp", "modbus-tcp"))), size)
    return [
        Race("a read, one after the other", MEDIUM, "", [*ours.lone(), modbus.lone(LONE)]),
        Race("many reads", MEDIUM, "reads", [*ours.many(), modbus.gathered(TASKS)]),
        Race("a block of 65,536 words", MEDIUM, "words", [*ours.block(), modbus.block(BLOCKS)]),
    ]

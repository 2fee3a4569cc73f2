"""Ports of a whole design, which a model of the plant reads and drives.

The values of ports are read and written directly in the memory of the compiled gateware, without a call. An output has
its value of the last clock cycle. A value of an input takes effect in the next cycle, or in a given later one.
"""

from __future__ import annotations

import ctypes
from typing import NamedTuple

from unity_link.errors import ArgumentError


class Counts(NamedTuple):
    """Counts of one bit of a port over clock cycles."""

    high: int
    """Number of cycles in which the bit was '1'."""
    edges: int
    """Number of cycles in which the bit differed from the cycle before."""


class Port:
    """A port at the top of a design.

    Args:
        gateway: the gateway of the port.
        library: the gateway's library.
        handle: the gateway's handle in the library.
        index: number of the port.
    """

    def __init__(self, gateway: object, library: ctypes.CDLL, handle: int, index: int) -> None:
        # Keep a reference, because the port's words are in the gateway's memory.
        self._gateway = gateway
        self._library, self._handle, self.index = library, handle, index
        self.name = str(library.ul_port_name(handle, index).decode())
        self.is_input = bool(library.ul_port_is_input(handle, index))
        self.width = int(library.ul_port_bits(handle, index))
        """Width in bits."""
        words = ctypes.c_uint32 * -(-self.width // 32)
        self._words = memoryview(words.from_address(library.ul_port_data(handle, index))).cast("B")
        self._totals: list[Counts] | None = None
        """Counts of each bit since the first call of `counts`; None before it."""
        self._own: list[Counts] = []

    def __repr__(self) -> str:
        """Return name and direction."""
        return f"<port {self.name}: {'in' if self.is_input else 'out'}, {self.width} bits>"

    @property
    def value(self) -> int:
        """The bits as an unsigned number."""
        return int.from_bytes(self._words, "little")

    def drive(self, value: int, cycle: int | None = None) -> None:
        """Set an input, which keeps its value until it is set again.

        Args:
            value: the bits as an unsigned number.
            cycle: first clock cycle with the value, as in `RtlGateway.cycles`; None or a past cycle for the next cycle.

        Raises:
            ArgumentError: if the port is an output, or the value does not fit.
        """
        if not self.is_input:
            raise ArgumentError(f"{self.name} is an output of the gateware: an input was expected")
        if not 0 <= value < 1 << self.width:
            raise ArgumentError(f"{self.name} is driven to {value:#x}: {self.width} bits were expected")
        given = value.to_bytes(len(self._words), "little")
        if cycle is None:
            self._words[:] = given
        else:
            words = (ctypes.c_uint32 * (len(given) // 4)).from_buffer_copy(given)
            self._library.ul_set_at(self._handle, max(0, cycle), self.index, words)

    def take_counts(self) -> list[Counts]:
        """Return the counts of each bit, lowest first, since the last call; the first call starts counting."""
        before, self._own = self._own, self.counts()
        if not before:
            return [Counts(0, 0)] * self.width
        return [
            Counts(now.high - then.high, now.edges - then.edges) for now, then in zip(self._own, before, strict=True)
        ]

    def steps(self, direction: Port) -> int:
        """Return the pulses of the lowest bit since the reset or the first call: those up minus those down.

        Args:
            direction: port whose lowest bit is '1' at the beginning of pulses that count down.
        """
        return int(self._library.ul_steps(self._handle, self.index, direction.index))

    def counts(self) -> list[Counts]:
        """Return the counts of each bit, lowest first, since the first call."""
        if self._totals is None:
            self._totals = [Counts(0, 0)] * self.width
            self._library.ul_count(self._handle, self.index)
        high, edges = (ctypes.c_uint64 * self.width)(), (ctypes.c_uint64 * self.width)()
        self._library.ul_take_counts(self._handle, self.index, high, edges)
        counted = zip(self._totals, high, edges, strict=True)
        self._totals = [Counts(total.high + more, total.edges + changes) for total, more, changes in counted]
        return self._totals

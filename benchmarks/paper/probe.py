"""A clock on the gateway's bus, which shows when an access has its effect."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.virtual.ft232h.rtl_board import RtlBoard

if TYPE_CHECKING:
    from unity_link.virtual.ft232h.board import AttachedBoard


class Probe:
    """A device that returns the time of a read, in cycles, and records the times of writes.

    The gateware's own cycle counter is not suitable, because cycles without activity are not simulated.

    Args:
        board: the board at the pins, whose time is that of the loop.
        clock_hz: the gateway's clock.
    """

    def __init__(self, board: AttachedBoard, clock_hz: int) -> None:
        self._rtl = board if isinstance(board, RtlBoard) else None
        self._clock_hz = clock_hz
        self.effects: list[float] = []
        """Times at which words were written, in seconds of modelled time."""

    def read(self, offset: int, now: float) -> int:  # noqa: ARG002  (as devices have it)
        """Return the time in cycles."""
        return round(self._instant(now) * self._clock_hz)

    def write(self, offset: int, value: int, now: float) -> None:  # noqa: ARG002
        """Record the time."""
        self.effects.append(self._instant(now))

    def time_of(self, word: int) -> float:
        """Return the modelled time in seconds at which a word was read."""
        return word / self._clock_hz

    def _instant(self, now: float) -> float:
        return now if self._rtl is None else self._rtl.time_of(self._rtl.gateway.cycles)

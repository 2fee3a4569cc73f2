"""The host controller and its bus: moves packets between the program's transfers and the chip, in modelled time.

A transfer that is submitted is looked at from the next microframe on. The bus carries one packet at a time; transfers
of one endpoint are served in their order, the two endpoints in turns. A bulk IN transfer ends when it is full or a
packet is short; its end is told at the end of the microframe. So everything that the program can notice happens at the
beginnings of microframes: a thread that runs this in real time need not wake up in between.
"""

from __future__ import annotations

import enum
from collections import deque
from typing import TYPE_CHECKING

from unity_link.virtual.ft232h.descriptors import PACKET_SIZE

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.virtual.ft232h.board import Board
    from unity_link.virtual.ft232h.chip import Chip

_DIRECTION_IN = 0x80


class TransferStatus(enum.Enum):
    """How a transfer ended."""

    DONE = "done"
    STALLED = "stalled"
    OVERFLOW = "overflow"
    """The chip sent more than there was room for."""
    CANCELLED = "cancelled"
    GONE = "gone"
    """The device was unplugged."""


class Transfer:
    """What a program wants to be moved.

    Args:
        endpoint: 0x81 or 0x02.
        size: bytes wanted from an IN endpoint.
        data: bytes for an OUT endpoint.
        on_end: called once, when the program is told of the end.
    """

    __slots__ = ("data", "endpoint", "ends_at", "on_end", "sent", "size", "starts_at", "status")

    def __init__(
        self, endpoint: int, *, size: int = 0, data: bytes = b"", on_end: Callable[[Transfer], None] | None = None
    ) -> None:
        self.endpoint = endpoint
        self.size = size
        self.data = bytearray() if endpoint & _DIRECTION_IN else bytearray(data)
        """What came, or is to be sent."""
        self.sent = 0
        self.on_end = on_end
        self.status: TransferStatus | None = None
        """None while it is under way."""
        self.starts_at = self.ends_at = 0.0

    @property
    def moved(self) -> int:
        """Bytes that came or were sent."""
        return len(self.data) if self.endpoint & _DIRECTION_IN else self.sent


class UsbHost:
    """A host controller with one chip on its bus, and what is at the chip's pins."""

    def __init__(self, chip: Chip, board: Board) -> None:
        self.chip = chip
        self.board = board
        self.plugged = True
        self._in: deque[Transfer] = deque()
        self._out: deque[Transfer] = deque()
        self._ended: deque[Transfer] = deque()
        """Ended, and not told yet; in the order of the ends."""
        self._on_bus: tuple[float, Transfer, bytes] | None = None
        """A packet: when it has passed, and what it belongs to."""
        self._sent_last = False
        self._now = 0.0

    # The program's side

    def submit(self, transfer: Transfer, now: float) -> None:
        """Take a transfer.

        Raises:
            ConnectionError: where the device is gone.
        """
        self.advance(now)
        if not self.plugged:
            raise ConnectionError("the device is gone")
        transfer.starts_at = self.chip.timing.boundary_after(now)
        if transfer.endpoint in self.chip.halted:
            self._end(transfer, TransferStatus.STALLED, transfer.starts_at)
            return
        (self._in if transfer.endpoint & _DIRECTION_IN else self._out).append(transfer)

    def cancel(self, transfer: Transfer, now: float) -> None:
        """End a transfer that is still under way; what it has moved it keeps."""
        self.advance(now)
        queue = self._in if transfer.endpoint & _DIRECTION_IN else self._out
        if transfer in queue:
            queue.remove(transfer)
            self._end(transfer, TransferStatus.CANCELLED, now)
            self._tell(now)

    def control_out(self, kind: int, request: int, value: int, index: int, now: float) -> float:
        """Do a control request; gives when the program is told.

        Raises:
            StallError: where the chip refuses it.
            ConnectionError: where the device is gone.
        """
        self._look(now)
        self.chip.control_out(kind, request, value, index, now)
        self.board.advance(self.chip, now)
        return self._control_end(now)

    def control_in(self, kind: int, request: int, value: int, index: int, now: float) -> tuple[bytes, float]:
        """Do a control request; gives the answer, and when the program is told.

        Raises:
            StallError: where the chip refuses it.
            ConnectionError: where the device is gone.
        """
        self._look(now)
        return self.chip.control_in(kind, request, value, index), self._control_end(now)

    def _look(self, now: float) -> None:
        self.advance(now)
        if not self.plugged:
            raise ConnectionError("the device is gone")

    def _control_end(self, now: float) -> float:
        timing = self.chip.timing
        return timing.boundary_after(now) + timing.microframe

    # The world's side

    def unplug(self, now: float) -> None:
        """Take the device away: everything under way ends."""
        self.advance(now)
        self.plugged = False
        self._on_bus = None
        for queue in (self._in, self._out):
            while queue:
                self._end(queue.popleft(), TransferStatus.GONE, now)
        for transfer in self._ended:
            # Also those that had ended before, and were to be told with the microframe's end.
            transfer.ends_at = now
        self._tell(now)

    def plug_in(self, now: float) -> None:
        """Put the device back: the chip looks at its EEPROM."""
        self.plugged = True
        self._now = now
        self.chip.power_up(now)

    def halt(self, endpoint: int, now: float) -> None:
        """Have an endpoint answer STALL until the host clears that."""
        self.advance(now)
        self.chip.halted.add(endpoint)
        queue = self._in if endpoint & _DIRECTION_IN else self._out
        while queue:
            self._end(queue.popleft(), TransferStatus.STALLED, self.chip.timing.boundary_after(now))

    # Time

    @property
    def next_due(self) -> float | None:
        """When something happens next; None where nothing will without a new transfer."""
        if not self.plugged:
            return None
        due = self.board.next_due
        if self._ended and (due is None or self._ended[0].ends_at < due):
            due = self._ended[0].ends_at
        if self._on_bus is not None:
            return self._on_bus[0] if due is None or self._on_bus[0] < due else due
        now = self._now
        if self._in:
            start = self.chip.ready_at(max(now, self._in[0].starts_at))
            if due is None or start < due:
                due = start
        if self._out:
            head = self._out[0]
            # Without room it waits for the board, which is due by itself.
            if self._has_room(head) and (due is None or head.starts_at < due):
                due = head.starts_at
        return due

    def _has_room(self, transfer: Transfer) -> bool:
        return self.chip.can_take >= min(PACKET_SIZE, len(transfer.data) - transfer.sent)

    def advance(self, now: float) -> None:
        """Let time pass. Time that is already past does nothing."""
        while (due := self.next_due) is not None and due <= now:
            self._step(max(due, self._now))
        self._now = max(self._now, now)

    def _step(self, now: float) -> None:
        self._now = now
        if self._on_bus is not None and self._on_bus[0] <= now:
            self._deliver()
        self.board.advance(self.chip, now)
        if self._on_bus is None:
            self._start_packet(now)
        self._tell(now)

    def _start_packet(self, now: float) -> None:
        """Put the next packet on the bus, if there is one."""
        can_receive = bool(self._in) and self._in[0].starts_at <= now and self.chip.ready_at(now) <= now
        can_send = bool(self._out) and self._out[0].starts_at <= now and self._has_room(self._out[0])
        passed = now + self.chip.timing.packet
        if can_receive and not (can_send and not self._sent_last):
            self._sent_last = False
            self._on_bus = (passed, self._in[0], self.chip.give(now))
        elif can_send:
            self._sent_last = True
            transfer = self._out[0]
            packet = bytes(transfer.data[transfer.sent : transfer.sent + PACKET_SIZE])
            self._on_bus = (passed, transfer, packet)

    def _deliver(self) -> None:
        """End the packet on the bus."""
        assert self._on_bus is not None
        now, transfer, packet = self._on_bus
        self._on_bus = None
        if transfer.endpoint & _DIRECTION_IN:
            if transfer.status is not None:
                return
            left = transfer.size - len(transfer.data)
            transfer.data += packet[:left]
            if len(packet) > left:
                self._finish(self._in, TransferStatus.OVERFLOW, now)
            elif len(packet) < PACKET_SIZE or len(packet) == left:
                self._finish(self._in, TransferStatus.DONE, now)
        else:
            self.chip.take(packet)
            transfer.sent += len(packet)
            if transfer.status is None and transfer.sent >= len(transfer.data):
                self._finish(self._out, TransferStatus.DONE, now)

    def _finish(self, queue: deque[Transfer], status: TransferStatus, now: float) -> None:
        self._end(queue.popleft(), status, self.chip.timing.boundary_after(now))

    def _end(self, transfer: Transfer, status: TransferStatus, when: float) -> None:
        transfer.status = status
        transfer.ends_at = when
        self._ended.append(transfer)

    def _tell(self, now: float) -> None:
        while self._ended and self._ended[0].ends_at <= now:
            transfer = self._ended.popleft()
            if transfer.on_end is not None:
                transfer.on_end(transfer)

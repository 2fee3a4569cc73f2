"""The USB host controller and its bus, which transfer packets between a program and the chip in simulated time.

A submitted transfer starts at the next microframe. The bus carries one packet at a time. Transfers of one endpoint are
served in order, and the endpoints in turn. A bulk IN transfer ends when it is full, or after a short packet; its end is
reported at the end of the microframe. All events that a program can notice are therefore at the beginnings of
microframes, and a thread that advances the model in real time need not wake up in between.
"""

from __future__ import annotations

import enum
from collections import deque
from typing import TYPE_CHECKING

from unity_link.virtual.ft232h.descriptors import PACKET_SIZE

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.virtual.ft232h.board import AttachedBoard
    from unity_link.virtual.ft232h.chip import Chip
    from unity_link.virtual.ft232h.port import ChipPort

_DIRECTION_IN = 0x80


class TransferStatus(enum.Enum):
    """Result of a transfer."""

    DONE = "done"
    STALLED = "stalled"
    OVERFLOW = "overflow"
    """The chip sent more bytes than the transfer had room for."""
    CANCELLED = "cancelled"
    GONE = "gone"
    """The device was unplugged."""


class Transfer:
    """A transfer that a program has submitted.

    Args:
        endpoint: 0x81 or 0x02 of port A, 0x83 or 0x04 of port B.
        size: number of bytes to read from an IN endpoint.
        data: bytes for an OUT endpoint.
        on_end: is called once, when the end of the transfer is reported.
    """

    __slots__ = ("data", "endpoint", "ends_at", "on_end", "sent", "size", "starts_at", "status")

    def __init__(
        self, endpoint: int, *, size: int = 0, data: bytes = b"", on_end: Callable[[Transfer], None] | None = None
    ) -> None:
        self.endpoint = endpoint
        self.size = size
        self.data = bytearray() if endpoint & _DIRECTION_IN else bytearray(data)
        """Received bytes, or bytes to send."""
        self.sent = 0
        self.on_end = on_end
        self.status: TransferStatus | None = None
        """Result; None while the transfer is pending."""
        self.starts_at = self.ends_at = 0.0

    @property
    def moved(self) -> int:
        """Number of bytes received or sent."""
        return len(self.data) if self.endpoint & _DIRECTION_IN else self.sent


class _InQueue:
    """Transfers of the IN endpoint of a port."""

    def __init__(self, port: ChipPort) -> None:
        self.port = port
        self.waiting: deque[Transfer] = deque()

    def next_due(self, now: float) -> float | None:
        """Return the time at which the next packet can be sent; None if no transfer is pending."""
        if not self.waiting:
            return None
        return self.port.ready_at(max(now, self.waiting[0].starts_at))

    def begin(self, now: float) -> bytes | None:
        """Return the packet to send now; None if there is none."""
        if not self.waiting or self.waiting[0].starts_at > now or self.port.ready_at(now) > now:
            return None
        return self.port.give(now)

    def deliver(self, transfer: Transfer, packet: bytes) -> TransferStatus | None:
        """Deliver a packet; return the status of the transfer if the packet ends it, otherwise None."""
        if transfer.status is not None:
            return None
        left = transfer.size - len(transfer.data)
        transfer.data += packet[:left]
        if len(packet) > left:
            return TransferStatus.OVERFLOW
        return TransferStatus.DONE if len(packet) < PACKET_SIZE or len(packet) == left else None


class _OutQueue:
    """Transfers of the OUT endpoint of a port."""

    def __init__(self, port: ChipPort) -> None:
        self.port = port
        self.waiting: deque[Transfer] = deque()

    def _has_room(self) -> bool:
        head = self.waiting[0]
        return self.port.can_take >= min(PACKET_SIZE, len(head.data) - head.sent)

    def next_due(self, now: float) -> float | None:
        """Return the time at which the next packet can be sent; None without a transfer, or without room.

        Room is made by the board, which has a due time of its own.
        """
        return self.waiting[0].starts_at if self.waiting and self._has_room() else None

    def begin(self, now: float) -> bytes | None:
        """Return the packet to send now; None if there is none."""
        if not self.waiting or self.waiting[0].starts_at > now or not self._has_room():
            return None
        transfer = self.waiting[0]
        return bytes(transfer.data[transfer.sent : transfer.sent + PACKET_SIZE])

    def deliver(self, transfer: Transfer, packet: bytes) -> TransferStatus | None:
        """Deliver a packet; return the status of the transfer if the packet ends it, otherwise None."""
        self.port.take(packet)
        transfer.sent += len(packet)
        return TransferStatus.DONE if transfer.status is None and transfer.sent >= len(transfer.data) else None


class UsbHost:
    """A host controller with one chip on its bus, and a board at the pins of each of the chip's ports."""

    def __init__(self, chip: Chip, *boards: AttachedBoard) -> None:
        self.chip = chip
        self._boards = list(zip(chip.ports, boards, strict=True))
        self.plugged = True
        self._queues: dict[int, _InQueue | _OutQueue] = {}
        """Queues by endpoint; the queue that was served last is last."""
        for port in reversed(chip.ports):
            self._queues[port.out_endpoint] = _OutQueue(port)
            self._queues[port.in_endpoint] = _InQueue(port)
        self._ended: deque[Transfer] = deque()
        """Ended transfers whose ends are not reported yet, in order."""
        self._on_bus: tuple[float, Transfer, bytes] | None = None
        """The packet on the bus: time of its end, its transfer, and its bytes."""
        self._now = 0.0

    # The program's side

    def submit(self, transfer: Transfer, now: float) -> None:
        """Submit a transfer.

        Raises:
            ConnectionError: if the device is unplugged.
        """
        self.advance(now)
        if not self.plugged:
            raise ConnectionError("the device is gone")
        transfer.starts_at = self.chip.timing.boundary_after(now)
        if transfer.endpoint in self.chip.halted:
            self._end(transfer, TransferStatus.STALLED, transfer.starts_at)
            return
        self._queues[transfer.endpoint].waiting.append(transfer)

    def cancel(self, transfer: Transfer, now: float) -> None:
        """Cancel a pending transfer; it keeps the bytes that it has transferred."""
        self.advance(now)
        waiting = self._queues[transfer.endpoint].waiting
        if transfer in waiting:
            waiting.remove(transfer)
            self._end(transfer, TransferStatus.CANCELLED, now)
            self._tell(now)

    def control_out(self, kind: int, request: int, value: int, index: int, now: float) -> float:
        """Execute a control request without an answer; return the time at which its end is reported.

        Raises:
            StallError: if the chip refuses the request.
            ConnectionError: if the device is unplugged.
        """
        self._look(now)
        self.chip.control_out(kind, request, value, index, now)
        self._advance_boards(now)
        return self._control_end(now)

    def control_in(self, kind: int, request: int, value: int, index: int, now: float) -> tuple[bytes, float]:
        """Execute a control request; return its answer, and the time at which its end is reported.

        Raises:
            StallError: if the chip refuses the request.
            ConnectionError: if the device is unplugged.
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

    # Faults

    def unplug(self, now: float) -> None:
        """Unplug the device; all pending transfers end."""
        self.advance(now)
        self.plugged = False
        self._on_bus = None
        for queue in self._queues.values():
            while queue.waiting:
                self._end(queue.waiting.popleft(), TransferStatus.GONE, now)
        for transfer in self._ended:
            # Report at once also the earlier ends, which were to be reported at the end of the microframe.
            transfer.ends_at = now
        self._tell(now)

    def plug_in(self, now: float) -> None:
        """Plug the device in again; the chip reads its EEPROM."""
        self.plugged = True
        self._now = now
        self.chip.power_up(now)

    def halt(self, endpoint: int, now: float) -> None:
        """Halt an endpoint, which answers STALL until the host clears the halt."""
        self.advance(now)
        self.chip.halted.add(endpoint)
        waiting = self._queues[endpoint].waiting
        while waiting:
            self._end(waiting.popleft(), TransferStatus.STALLED, self.chip.timing.boundary_after(now))

    # Time

    @property
    def next_due(self) -> float | None:
        """Time of the next event; None if there is none without a new transfer."""
        if not self.plugged:
            return None
        due: float | None = None
        for _, board in self._boards:
            due = _earlier(due, board.next_due)
        if self._ended:
            due = _earlier(due, self._ended[0].ends_at)
        if self._on_bus is not None:
            return _earlier(due, self._on_bus[0])
        for queue in self._queues.values():
            due = _earlier(due, queue.next_due(self._now))
        return due

    def advance(self, now: float) -> None:
        """Advance the model to the time `now`; do nothing if it is in the past."""
        while (due := self.next_due) is not None and due <= now:
            self._step(max(due, self._now))
        self._now = max(self._now, now)

    def _step(self, now: float) -> None:
        self._now = now
        if self._on_bus is not None and self._on_bus[0] <= now:
            self._deliver()
        self._advance_boards(now)
        if self._on_bus is None:
            self._start_packet(now)
        self._tell(now)

    def _advance_boards(self, now: float) -> None:
        for port, board in self._boards:
            board.advance(port, now)

    def _start_packet(self, now: float) -> None:
        """Put the next packet on the bus, if an endpoint has one."""
        for endpoint, queue in self._queues.items():
            packet = queue.begin(now)
            if packet is not None:
                self._on_bus = (now + self.chip.timing.packet, queue.waiting[0], packet)
                self._queues[endpoint] = self._queues.pop(endpoint)
                return

    def _deliver(self) -> None:
        """Deliver the packet on the bus."""
        assert self._on_bus is not None
        now, transfer, packet = self._on_bus
        self._on_bus = None
        queue = self._queues[transfer.endpoint]
        status = queue.deliver(transfer, packet)
        if status is not None:
            self._end(queue.waiting.popleft(), status, self.chip.timing.boundary_after(now))

    def _end(self, transfer: Transfer, status: TransferStatus, when: float) -> None:
        transfer.status = status
        transfer.ends_at = when
        self._ended.append(transfer)

    def _tell(self, now: float) -> None:
        while self._ended and self._ended[0].ends_at <= now:
            transfer = self._ended.popleft()
            if transfer.on_end is not None:
                transfer.on_end(transfer)


def _earlier(one: float | None, other: float | None) -> float | None:
    """Return the earlier of two times; None is never."""
    if one is None or (other is not None and other < one):
        return other
    return one

"""A board at the pins of a port: a gateway with its FIFOs, in simulated time.

Bytes pass the pins in steps of up to `STEP` bytes; a step ends at the time of its last byte. A single request is
therefore timed exactly, and a stream needs only one event for each step. The gateware's processing takes no time in
this model; if it matters, `rtl_board` has the compiled gateware.

With a FIFO at the pins no bytes are lost: a full receive FIFO stops RD#, the chip's TXE# stops WR#, and a full transmit
FIFO stops the gateway. A UART has no flow control: if a FIFO is full, bytes are lost on either side.
"""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Protocol, runtime_checkable

from unity_link.protocol.wire.frames import end_of_first
from unity_link.virtual.ft232h.port import Mode
from unity_link.virtual.gateway import VirtualGateway
from unity_link.virtual.simulating import SimulatedGateway

if TYPE_CHECKING:
    from unity_link.virtual.ft232h.port import ChipPort
    from unity_link.virtual.gateway import Gateway

STEP = 64
"""Largest number of bytes that pass the pins in one event: 8 us at 8 MB/s."""
_BITS_PER_BYTE = 10
"""Bits on a UART's line for each byte, including start and stop bit."""
_OFF, _ALWAYS = 0, 1


class AttachedBoard(Protocol):
    """Interface of boards at the pins of a port."""

    @property
    def next_due(self) -> float | None:
        """Time of the board's next action, if the port does not change."""

    def advance(self, port: ChipPort, now: float) -> None:
        """Do all actions that are due at `now`, or that a change of the port has made possible."""


class Unconnected:
    """Unconnected pins: the host's bytes stay in the port."""

    next_due: float | None = None

    def advance(self, port: ChipPort, now: float) -> None:
        """Do nothing."""


@runtime_checkable
class SendsImmediately(Protocol):
    """A gateway that requests pulses of SIWU#."""

    @property
    def send_immediate(self) -> int:
        """Mode of responses: 0 off, 1 always, 2 adaptive."""

    flush_wanted: bool
    """True after a sample that requests a flush was sent; the board clears it at the flush."""


class GatewayBoard:
    """A gateway at the pins of a port.

    Args:
        gateway: the gateway; its `info` has the sizes of its FIFOs.
        mode: mode of the pins that the gateware was built for; while the chip has another mode, no bytes pass.
        step: largest number of bytes that pass the pins in one event.
        siwu_wired: True if SIWU# is connected.
    """

    def __init__(self, gateway: Gateway, mode: Mode = Mode.FIFO, *, step: int = STEP, siwu_wired: bool = True) -> None:
        self.gateway = gateway
        self._siwu_wired = siwu_wired
        # Checked once, because isinstance with a Protocol is slow.
        self._sends_immediately = gateway if isinstance(gateway, SendsImmediately) else None
        self.mode = mode
        self._step = step
        self._received = bytearray()
        """The receive FIFO."""
        self._sent = bytearray()
        """The transmit FIFO, followed by bytes that the gateway has not put into it yet."""
        self._pulses: deque[tuple[int, bool]] = deque()
        """Requested pulses of SIWU#: number of bytes written before each, and True if it waits until all is idle."""
        self._written = 0
        """Number of bytes written to the port since the start."""
        self._pulse_when_idle = False
        self._reading: tuple[float, int] | None = None
        """End and number of bytes of the current step at RD#."""
        self._writing: tuple[float, bytes] | None = None
        """End and bytes of the current step at WR#."""
        self._wrote_last = False
        self._skipping = False
        """True while there is no room for samples."""
        gateway.wake = lambda: None

    # Time

    @property
    def next_due(self) -> float | None:
        """Time of the next event, if the port does not change."""
        due: float | None = None
        if self._reading is not None:
            due = self._reading[0]
        if self._writing is not None and (due is None or self._writing[0] < due):
            due = self._writing[0]
        if not self._skipping:
            publish = self.gateway.next_due
            if publish is not None and (due is None or publish < due):
                due = publish
        return due

    def advance(self, port: ChipPort, now: float) -> None:
        """End the finished steps, advance the gateway, and begin the next steps."""
        if port.mode is not self.mode:
            self._reading = self._writing = None
            self.gateway.advance(now, room=0)
            return
        requests_wait = bool(self._received)
        if self._reading is not None and self._reading[0] <= now:
            self._end_read(port)
        if self._writing is not None and self._writing[0] <= now:
            self._end_write(port)
        # Pending requests come first: the gateway alternates samples with its responses.
        self._publish(now, most=0 if requests_wait else self.gateway.info.transmit_fifo_bytes)
        if self._received:
            self._answer(now)
        if self._pulses or self._pulse_when_idle:
            self._pulse(port)
        self._begin(port, now)

    # The gateway

    @property
    def _room(self) -> int:
        """Number of free bytes in the receive FIFO."""
        return self.gateway.info.receive_fifo_bytes - len(self._received)

    def _publish(self, now: float, most: int) -> None:
        """Put due samples into the transmit FIFO; samples beyond `most` bytes, or without room, wait in the gateway."""
        gateway, size = self.gateway, self.gateway.info.transmit_fifo_bytes
        if len(self._sent) >= size:
            self._skipping = True
            return
        due = gateway.next_due
        if self._skipping:
            gateway.advance(now, room=0)
            due = now
        if due is not None and due <= now:
            room = min(most, size - len(self._sent))
            self._sent += gateway.advance(now, room)
            self._skipping = room == 0 or len(self._sent) >= size
            immediate = self._sends_immediately
            if immediate is not None and immediate.flush_wanted:
                immediate.flush_wanted = False
                self._pulses.append((self._written + len(self._sent), True))

    def _answer(self, now: float) -> None:
        """Pass requests to the gateway until a response fills the transmit FIFO."""
        gateway, received = self.gateway, self._received
        size = gateway.info.transmit_fifo_bytes
        mode = _OFF if self._sends_immediately is None else self._sends_immediately.send_immediate
        while received and len(self._sent) <= size:
            count = end_of_first(received) or len(received)
            answer = gateway.receive(bytes(received[:count]), now)
            del received[:count]
            if answer:
                self._sent += answer
                if mode != _OFF:
                    self._pulses.append((self._written + len(self._sent), mode != _ALWAYS))

    # The pins

    def _begin(self, port: ChipPort, now: float) -> None:
        """Begin a step in each direction, if possible; the bus of the synchronous FIFO alternates the directions."""
        if self.mode is Mode.UART:
            rate = port.baud / _BITS_PER_BYTE
        elif self.mode is Mode.FIFO:
            rate = port.timing.fifo_bytes_per_second
        else:
            rate = port.timing.synchronous_bytes_per_second
            if self._reading is not None or self._writing is not None:
                return
            if self._wrote_last and self._begin_read(port, now, rate):
                return
            if self._begin_write(port, now, rate):
                return
        if self._reading is None:
            self._begin_read(port, now, rate)
        if self._writing is None and self.mode is not Mode.SYNC_FIFO:
            self._begin_write(port, now, rate)

    def _begin_read(self, port: ChipPort, now: float, rate: float) -> bool:
        # A UART cannot stop the port.
        room = self._step if self.mode is Mode.UART else self._room
        count = min(self._step, port.readable, room)
        if count <= 0:
            return False
        self._reading = (now + count / rate, count)
        return True

    def _begin_write(self, port: ChipPort, now: float, rate: float) -> bool:
        limit = self._step if self.mode is Mode.UART else min(self._step, port.room)
        if self._pulses:
            limit = min(limit, self._pulses[0][0] - self._written)
        data = bytes(self._sent[:limit])
        if not data:
            return False
        self._writing = (now + len(data) / rate, data)
        return True

    def _end_read(self, port: ChipPort) -> None:
        assert self._reading is not None
        self._received += port.read(self._reading[1])
        self._reading = None
        self._wrote_last = False
        surplus = -self._room
        if surplus > 0:
            del self._received[-surplus:]
            if isinstance(self.gateway, (VirtualGateway, SimulatedGateway)):
                self.gateway.overflow()

    def _end_write(self, port: ChipPort) -> None:
        assert self._writing is not None
        data = self._writing[1]
        self._writing = None
        self._wrote_last = True
        port.write(data)
        del self._sent[: len(data)]
        self._written += len(data)

    def _pulse(self, port: ChipPort) -> None:
        """Pulse SIWU# if a pulse is due after the last written byte, or all has become idle since."""
        while self._pulses and self._pulses[0][0] == self._written:
            if self._pulses.popleft()[1]:
                self._pulse_when_idle = True
            elif self._siwu_wired:
                port.send_immediate()
        busy = self._sent or self._received or port.readable or self._reading is not None
        if self._pulse_when_idle and not busy:
            self._pulse_when_idle = False
            if self._siwu_wired:
                port.send_immediate()

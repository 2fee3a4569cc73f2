"""The board at the pins of a port: a gateway with its FIFOs, moved along in modelled time.

Bytes pass the pins in small steps (`STEP`), each done when its last byte would be: a request that comes alone is timed
to the byte, and a stream costs the computer one event for a step. What the gateware does with a byte takes no time
here; where that counts, `rtl_board` has the gateware itself in this file's place.

With a FIFO at its pins nothing is ever lost: the receive FIFO stops RD# when it is full, the chip's TXE# stops WR#, and
a full transmit FIFO stops the gateway. With a UART there is neither: what comes too fast is lost, on either side.
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
"""Bytes that pass the pins in one event: 8 us at 8 MB/s."""
_BITS_PER_BYTE = 10
"""On a UART, with start and stop bit."""
_OFF, _ALWAYS = 0, 1


class AttachedBoard(Protocol):
    """Interface of boards that can be connected to the pins."""

    @property
    def next_due(self) -> float | None:
        """Instant of its next action, if nothing changes at the port."""

    def advance(self, port: ChipPort, now: float) -> None:
        """Do what is due at `now`, or has become possible by what changed at the port."""


class Unconnected:
    """Nothing: what the host writes stays in the port."""

    next_due: float | None = None

    def advance(self, port: ChipPort, now: float) -> None:
        """Do nothing."""


@runtime_checkable
class SendsImmediately(Protocol):
    """A gateway that says when SIWU# is to be pulsed."""

    @property
    def send_immediate(self) -> int:
        """Mode of responses: 0 off, 1 always, 2 adaptive."""

    flush_wanted: bool
    """Set when a sample was sent that is to be flushed; cleared at the flush."""


class GatewayBoard:
    """A gateway at the pins.

    Args:
        gateway: what answers. The sizes of its FIFOs are in its `info`.
        mode: what its gateware was built for; where the chip's pins are something else, no byte passes.
        step: most bytes that pass the pins in one event.
        siwu_wired: whether SIWU# is connected.
    """

    def __init__(self, gateway: Gateway, mode: Mode = Mode.FIFO, *, step: int = STEP, siwu_wired: bool = True) -> None:
        self.gateway = gateway
        self._siwu_wired = siwu_wired
        # Asked once: what a protocol has is slow to look up.
        self._sends_immediately = gateway if isinstance(gateway, SendsImmediately) else None
        self.mode = mode
        self._step = step
        self._received = bytearray()
        """The receive FIFO."""
        self._sent = bytearray()
        """The transmit FIFO, and behind it what the gateway still has to put into it."""
        self._pulses: deque[tuple[int, bool]] = deque()
        """Behind how many of the bytes written since the start SIWU# is wanted, and whether only when all is idle."""
        self._written = 0
        self._pulse_when_idle = False
        self._reading: tuple[float, int] | None = None
        """Instant at which a step at RD# is done, and its number of bytes."""
        self._writing: tuple[float, bytes] | None = None
        self._wrote_last = False
        self._skipping = False
        """Samples have no room."""
        gateway.wake = lambda: None

    # Time

    @property
    def next_due(self) -> float | None:
        """Instant of the next event, if nothing changes at the port."""
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
        """End the steps that are done, let the gateway work, begin the next steps."""
        if port.mode is not self.mode:
            self._reading = self._writing = None
            self.gateway.advance(now, room=0)
            return
        requests_wait = bool(self._received)
        if self._reading is not None and self._reading[0] <= now:
            self._end_read(port)
        if self._writing is not None and self._writing[0] <= now:
            self._end_write(port)
        # Requests that waited go first: the gateway lets samples take turns with its responses.
        self._publish(now, most=0 if requests_wait else self.gateway.info.transmit_fifo_bytes)
        if self._received:
            self._answer(now)
        if self._pulses or self._pulse_when_idle:
            self._pulse(port)
        self._begin(port, now)

    # The gateway

    @property
    def _room(self) -> int:
        """Bytes that the receive FIFO takes."""
        return self.gateway.info.receive_fifo_bytes - len(self._received)

    def _publish(self, now: float, most: int) -> None:
        """Take samples that are due; those beyond `most` bytes, or without room, wait in the gateway."""
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
        """Hand on requests, until a response fills the transmit FIFO."""
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
        """Begin what can be; on the bus of the synchronous FIFO, in turns."""
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
        # A UART has nothing that would stop the port.
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
        """Pulse SIWU# where it is wanted behind the last byte written, or everything has become idle since."""
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

"""Simulated chips on a USB bus, with a clock and a lock for programs, and faults such as unplugging.

Any thread may use a chip; one thread at a time advances the model. A thread that waits for a transfer sleeps until the
next time at which a transfer can end, and wakes when another thread submits a transfer.
"""

from __future__ import annotations

import asyncio
import threading
import time
from contextlib import contextmanager, nullcontext
from typing import TYPE_CHECKING, Protocol

from unity_link.transport.ft232h.eeprom_image import build_eeprom
from unity_link.transport.ft232h.kinds import FT232H, PORT_A
from unity_link.virtual.ft232h.board import Unconnected
from unity_link.virtual.ft232h.chip import Chip
from unity_link.virtual.ft232h.host import UsbHost
from unity_link.virtual.ft232h.timing import Timing
from unity_link.virtual.modelled_time import ModelledTimeLoop

if TYPE_CHECKING:
    from collections.abc import Iterator
    from contextlib import AbstractContextManager

    from unity_link.transport.ft232h.kinds import ChipKind
    from unity_link.virtual.ft232h.board import AttachedBoard
    from unity_link.virtual.ft232h.host import Transfer

BUS_NUMBER = 7
DEFAULT_SERIAL = "UL000001"


class Clock(Protocol):
    """The time of a model, in seconds."""

    def now(self) -> float:
        """Return the time."""

    def wait(self, changed: threading.Condition, until: float) -> None:
        """Wait until a time, or until `changed` is notified; the caller holds `changed`."""

    def standing_still(self) -> AbstractContextManager[None]:
        """Stop the clock in a block, in which the model computes."""


class RealClock:
    """Real time, without the time that the model computes."""

    def __init__(self) -> None:
        self._offset = time.monotonic()

    def now(self) -> float:
        """Return the time."""
        return time.monotonic() - self._offset

    def wait(self, changed: threading.Condition, until: float) -> None:
        """Sleep until the time, or until `changed` is notified."""
        pause = until - self.now()
        if pause > 0:
            changed.wait(pause)

    @contextmanager
    def standing_still(self) -> Iterator[None]:
        """Subtract the duration of the block."""
        began = time.monotonic()
        try:
            yield
        finally:
            self._offset += time.monotonic() - began


class SimulatedClock:
    """Simulated time, which passes only in `wait`: all runs of a program with one thread are then the same."""

    def __init__(self) -> None:
        self._now = 0.0

    def now(self) -> float:
        """Return the time."""
        return self._now

    def wait(self, changed: threading.Condition, until: float) -> None:
        """Set the clock to the time."""
        self._now = max(self._now, until)

    def standing_still(self) -> AbstractContextManager[None]:
        """Do nothing: the clock does not run."""
        return nullcontext()


class LoopClock:
    """The time of an event loop with simulated time. Control requests take no time, and threads must not wait.

    Args:
        loop: the event loop; None for the running one.
    """

    def __init__(self, loop: ModelledTimeLoop | None = None) -> None:
        running = asyncio.get_running_loop() if loop is None else loop
        assert isinstance(running, ModelledTimeLoop)
        self.loop = running

    def now(self) -> float:
        """Return the time."""
        return self.loop.time()

    def wait(self, changed: threading.Condition, until: float) -> None:
        """Raise RuntimeError: waiting would block the loop, and with it the time."""
        raise RuntimeError("a chip with the clock of an event loop cannot block")

    def standing_still(self) -> AbstractContextManager[None]:
        """Stop the loop's clock in a block."""
        return self.loop.standing_still()


class VirtualFt232h:
    """One chip, with its clock.

    Args:
        board: board at the pins of port A, the only port of an FT232H.
        board_b: board at the pins of port B of an FT2232H; None for no board.
        kind: kind of chip.
        image: contents of the EEPROM; None for FIFOs at all ports.
        timing: figures of the model; None for the defaults.
        clock: clock of the chip; None for real time.
    """

    def __init__(
        self,
        board: AttachedBoard,
        board_b: AttachedBoard | None = None,
        *,
        kind: ChipKind = FT232H,
        image: bytes | None = None,
        timing: Timing | None = None,
        clock: Clock | None = None,
    ) -> None:
        if image is None:
            image = build_eeprom("FIFO", DEFAULT_SERIAL, kind=kind, ports=range(PORT_A, PORT_A + kind.ports))
        self.clock = RealClock() if clock is None else clock
        self.chip = Chip(image, Timing() if timing is None else timing, kind)
        boards = (board, board_b or Unconnected())
        self.host = UsbHost(self.chip, *boards[: kind.ports])
        self.address = 0
        """Address of the device on its bus; 0 before it is attached."""
        self.denied = False
        """True if the operating system refuses to open the device."""
        self.claims: dict[int, object] = {}
        """Object that has claimed each interface; interface 0 is that of port A."""
        self.times_plugged = 1
        """Number of times that the device was plugged in; earlier handles are invalid."""
        self.changed = threading.Condition()

    def claim(self, interface: int, holder: object) -> bool:
        """Claim an interface for `holder`; return True if `holder` has it now."""
        return self.claims.setdefault(interface, holder) is holder

    def release(self, interface: int, holder: object) -> None:
        """Release an interface, if `holder` has claimed it."""
        if self.claims.get(interface) is holder:
            del self.claims[interface]

    def now(self) -> float:
        """Advance the model to the clock's time, which is stopped meanwhile, and return the time; hold `changed`."""
        with self.clock.standing_still():
            now = self.clock.now()
            self.host.advance(now)
        return now

    # For programs that wait

    def run(self, transfer: Transfer, timeout: float | None) -> None:
        """Submit a transfer and wait for its end; cancel it after `timeout` seconds.

        Raises:
            ConnectionError: if the device is unplugged.
        """
        with self.changed:
            self.host.submit(transfer, self.now())
            self.changed.notify_all()
            deadline = None if timeout is None else self.clock.now() + timeout
            while True:
                now = self.now()
                if transfer.status is not None and transfer.ends_at <= now:
                    return
                if deadline is not None and now >= deadline:
                    self.host.cancel(transfer, now)
                    return
                self._wait(self.next_end if transfer.status is None else transfer.ends_at, deadline)

    @property
    def next_end(self) -> float | None:
        """Earliest time at which a transfer can end; None if no event is planned."""
        due = self.host.next_due
        return None if due is None else max(due, self.chip.timing.boundary_after(due))

    def _wait(self, until: float | None, deadline: float | None) -> None:
        times = [instant for instant in (until, deadline) if instant is not None]
        # If no event is planned, only another thread can end the wait.
        self.clock.wait(self.changed, min(times, default=self.clock.now() + 1.0))

    def control_out(self, kind: int, request: int, value: int, index: int) -> None:
        """Execute a control request without an answer, and wait for its end.

        Raises:
            StallError: if the chip refuses the request.
            ConnectionError: if the device is unplugged.
        """
        with self.changed:
            end = self.host.control_out(kind, request, value, index, self.now())
            self.changed.notify_all()
            self._pass(end)

    def control_in(self, kind: int, request: int, value: int, index: int) -> bytes:
        """Execute a control request, and return its answer.

        Raises:
            StallError: if the chip refuses the request.
            ConnectionError: if the device is unplugged.
        """
        with self.changed:
            answer, end = self.host.control_in(kind, request, value, index, self.now())
            self._pass(end)
            return answer

    def _pass(self, until: float) -> None:
        if isinstance(self.clock, LoopClock):
            return
        while self.clock.now() < until:
            self.clock.wait(self.changed, until)

    # Faults

    def unplug(self) -> None:
        """Unplug the chip."""
        with self.changed:
            self.host.unplug(self.now())
            self.claims.clear()
            self.changed.notify_all()

    def plug_in(self) -> None:
        """Plug the chip in again; it reads its EEPROM only then."""
        with self.changed:
            self.times_plugged += 1
            self.host.plug_in(self.clock.now())

    def halt(self, endpoint: int) -> None:
        """Halt an endpoint, which answers STALL until the host clears the halt."""
        with self.changed:
            self.host.halt(endpoint, self.now())
            self.changed.notify_all()

    def report_error(self, bits: int, port: int = PORT_A) -> None:
        """Set error bits in the status of the next packet of a port."""
        with self.changed:
            self.now()
            self.chip.ports[port - 1].report_error(bits)


class VirtualBus:
    """A USB bus with simulated chips."""

    def __init__(self, *devices: VirtualFt232h) -> None:
        self._devices: list[VirtualFt232h] = []
        for device in devices:
            self.attach(device)

    def attach(self, device: VirtualFt232h) -> None:
        """Attach a chip to the bus, and give it an address."""
        device.address = 1 + max((other.address for other in self._devices), default=0)
        self._devices.append(device)

    @property
    def devices(self) -> list[VirtualFt232h]:
        """The chips that are plugged in."""
        return [device for device in self._devices if device.host.plugged]

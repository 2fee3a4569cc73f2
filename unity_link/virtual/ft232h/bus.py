"""Virtual chips on a bus, for programs: a clock, a lock, and what can be done to a chip from outside.

Any thread may use a chip; one at a time moves the model along. A thread that waits for a transfer sleeps until the next
instant at which something can end, and is woken when another one has submitted something.
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
    """Modelled time, in seconds."""

    def now(self) -> float:
        """Return the time."""

    def wait(self, changed: threading.Condition, until: float) -> None:
        """Wait until a time, or until `changed` is notified; `changed` is held."""

    def standing_still(self) -> AbstractContextManager[None]:
        """Keep the time while the model itself computes, which is no modelled time."""


class RealClock:
    """Modelled time passes as real time does, but for what the model itself computes."""

    def __init__(self) -> None:
        self._offset = time.monotonic()

    def now(self) -> float:
        """Return the time."""
        return time.monotonic() - self._offset

    def wait(self, changed: threading.Condition, until: float) -> None:
        """Sleep."""
        pause = until - self.now()
        if pause > 0:
            changed.wait(pause)

    @contextmanager
    def standing_still(self) -> Iterator[None]:
        """Go back at the end."""
        began = time.monotonic()
        try:
            yield
        finally:
            self._offset += time.monotonic() - began


class SimulatedClock:
    """Time passes only where somebody waits: for programs of one thread, of which then every run is the same."""

    def __init__(self) -> None:
        self._now = 0.0

    def now(self) -> float:
        """Return the time."""
        return self._now

    def wait(self, changed: threading.Condition, until: float) -> None:
        """Jump."""
        self._now = max(self._now, until)

    def standing_still(self) -> AbstractContextManager[None]:
        """Do nothing."""
        return nullcontext()


class LoopClock:
    """The time of a loop on modelled time. Control requests take none of it, and no thread may wait.

    Args:
        loop: such a loop; the running one by default.
    """

    def __init__(self, loop: ModelledTimeLoop | None = None) -> None:
        running = asyncio.get_running_loop() if loop is None else loop
        assert isinstance(running, ModelledTimeLoop)
        self.loop = running

    def now(self) -> float:
        """Return the time."""
        return self.loop.time()

    def wait(self, changed: threading.Condition, until: float) -> None:
        """Refuse: it would keep the loop, and with it the time, from going on."""
        raise RuntimeError("a chip on the time of a loop can't be waited for")

    def standing_still(self) -> AbstractContextManager[None]:
        """Keep the loop's time."""
        return self.loop.standing_still()


class VirtualFt232h:
    """One chip on the bus, with its clock.

    Args:
        board: what is at the pins of port A, the only one of an FT232H.
        board_b: what is at the pins of port B, where there is one; by default nothing.
        kind: which chip it is.
        image: content of the EEPROM; by default that of a FIFO at every port.
        timing: the numbers of the model.
        clock: what time it is; real time by default.
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
        """Number on its bus, given when it is plugged in."""
        self.denied = False
        """True if the operating system refuses to open it."""
        self.claims: dict[int, object] = {}
        """Owner of each interface (0 is that of port A); another program, where it is a stranger."""
        self.times_plugged = 1
        """Handles from before it was unplugged are void."""
        self.changed = threading.Condition()

    def claim(self, interface: int, holder: object) -> bool:
        """Let `holder` have an interface; gives whether it has it now."""
        return self.claims.setdefault(interface, holder) is holder

    def release(self, interface: int, holder: object) -> None:
        """Take an interface back, if `holder` has it."""
        if self.claims.get(interface) is holder:
            del self.claims[interface]

    def now(self) -> float:
        """Let the model catch up with the clock, which stands still meanwhile; gives the time. Hold `changed`."""
        with self.clock.standing_still():
            now = self.clock.now()
            self.host.advance(now)
        return now

    # For programs that wait

    def run(self, transfer: Transfer, timeout: float | None) -> None:
        """Submit a transfer and wait for its end; after `timeout` seconds it is cancelled.

        Raises:
            ConnectionError: where the device is gone.
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
        """Earliest instant at which the next transfer can end."""
        due = self.host.next_due
        return None if due is None else max(due, self.chip.timing.boundary_after(due))

    def _wait(self, until: float | None, deadline: float | None) -> None:
        times = [instant for instant in (until, deadline) if instant is not None]
        # Where nothing will ever happen, somebody else has to do something.
        self.clock.wait(self.changed, min(times, default=self.clock.now() + 1.0))

    def control_out(self, kind: int, request: int, value: int, index: int) -> None:
        """Do a control request, and wait for its end.

        Raises:
            StallError: where the chip refuses it.
            ConnectionError: where the device is gone.
        """
        with self.changed:
            end = self.host.control_out(kind, request, value, index, self.now())
            self.changed.notify_all()
            self._pass(end)

    def control_in(self, kind: int, request: int, value: int, index: int) -> bytes:
        """Do a control request, and wait for its answer.

        Raises:
            StallError: where the chip refuses it.
            ConnectionError: where the device is gone.
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

    # What can happen to it

    def unplug(self) -> None:
        """Take it away."""
        with self.changed:
            self.host.unplug(self.now())
            self.claims.clear()
            self.changed.notify_all()

    def plug_in(self) -> None:
        """Put it back: only then does the chip look at its EEPROM."""
        with self.changed:
            self.times_plugged += 1
            self.host.plug_in(self.clock.now())

    def halt(self, endpoint: int) -> None:
        """Halt an endpoint, which answers STALL until the host clears that."""
        with self.changed:
            self.host.halt(endpoint, self.now())
            self.changed.notify_all()

    def report_error(self, bits: int, port: int = PORT_A) -> None:
        """Set error bits in the status of the next packet of a port."""
        with self.changed:
            self.now()
            self.chip.ports[port - 1].report_error(bits)


class VirtualBus:
    """Chips that a program can find."""

    def __init__(self, *devices: VirtualFt232h) -> None:
        self._devices: list[VirtualFt232h] = []
        for device in devices:
            self.attach(device)

    def attach(self, device: VirtualFt232h) -> None:
        """Connect a chip to the bus, where it has a number of its own."""
        device.address = 1 + max((other.address for other in self._devices), default=0)
        self._devices.append(device)

    @property
    def devices(self) -> list[VirtualFt232h]:
        """Those that are plugged in."""
        return [device for device in self._devices if device.host.plugged]

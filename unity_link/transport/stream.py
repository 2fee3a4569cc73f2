"""Layer 1, stream: what stands between a driver's transport and the messages.

It hands on what arrives in whole reads, and holds back what is sent while the transport takes no bytes. It never looks
into a frame.
"""

from __future__ import annotations

import asyncio
import math
from collections.abc import Awaitable
from typing import TYPE_CHECKING, Any, Protocol, cast

from unity_link.protocol.window.constants import QUICK_TIMEOUT, SHORTEST_TIMEOUT

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.protocol.wire.path import Path
    from unity_link.transport.turns import Seat


class Receiver(Protocol):
    """The reader of a stream."""

    def receive(self, data: bytes) -> None:
        """Take what has arrived, cut anywhere."""

    def disconnected(self, reason: Exception | None) -> None:
        """Record that the stream has ended; `reason` is None where the other side closed it."""


class Ended(Awaitable[Any], Protocol):
    """Awaitable of the end of a stream: an `asyncio.Future`, or what stands for it where no event loop is."""

    def done(self) -> bool:
        """Return whether it is over."""

    def set_result(self, result: None, /) -> None:
        """Resume the awaiting call."""


class Stream(asyncio.Protocol):
    """One connection of a driver.

    `receiver` may be replaced at any time; what arrives while it is None is dropped.

    Args:
        create_future: makes what `close` awaits; None: the event loop that is running.
    """

    def __init__(self, create_future: Callable[[], Ended] | None = None) -> None:
        self.receiver: Receiver | None = None
        self.on_pause: Callable[[], None] | None = None
        """Is called when `paused` has changed."""
        self.bytes_received = 0
        self.bytes_sent = 0
        self.closed = False
        self._transport: asyncio.Transport | None = None
        self._create_future = create_future or asyncio.get_running_loop().create_future
        self._closings: list[Ended] = []
        """Waiters of calls of `close`."""
        self._held_back: list[bytes] = []
        self.paused = False
        """True if the transport has asked for no more bytes: what is sent now is held back here."""

    # Called by users of the stream

    def send(self, data: bytes) -> None:
        """Send as soon as the transport takes bytes; what is sent when the connection has ended is dropped."""
        if self.paused:
            self._held_back.append(data)
        elif self._transport is not None and not self.closed:
            self.bytes_sent += len(data)
            self._transport.write(data)

    @property
    def shortest_timeout(self) -> float:
        """Seconds that the medium may hold an answer back, and some more; what is unknown is as slow as a USB chip."""
        if self._transport is None:
            return SHORTEST_TIMEOUT
        is_socket = self._transport.get_extra_info("socket") is not None
        known = self._transport.get_extra_info("shortest_timeout", QUICK_TIMEOUT if is_socket else SHORTEST_TIMEOUT)
        return float(known)

    @property
    def longest_try(self) -> float:
        """Seconds after which a question without an answer is asked again, at most; infinite where none are told."""
        known = None if self._transport is None else self._transport.get_extra_info("longest_try")
        return math.inf if known is None else float(known)

    @property
    def path(self) -> Path | None:
        """The network of a medium that sends frames in datagrams, whose bytes arrive unchanged; None for others."""
        return None if self._transport is None else self._transport.get_extra_info("path")

    @property
    def byte_time(self) -> float | None:
        """Seconds that a byte needs on the wire, None where that is not known."""
        return None if self._transport is None else self._transport.get_extra_info("byte_time")

    @property
    def seat(self) -> Seat | None:
        """The link's place on a line on which nodes take turns, None where it is alone."""
        return None if self._transport is None else self._transport.get_extra_info("seat")

    @property
    def refusal(self) -> str:
        """The reason why the bus at the other end refuses accesses; empty where the medium does not know it."""
        told = None if self._transport is None else self._transport.get_extra_info("refusal")
        return "" if told is None else told()

    def pause_reading(self) -> None:
        """Leave what arrives in the medium, as far as there is room, until `resume_reading`."""
        if self._transport is not None and not self._transport.is_closing():
            self._transport.pause_reading()

    def resume_reading(self) -> None:
        """Deliver again what arrives."""
        if self._transport is not None and not self._transport.is_closing():
            self._transport.resume_reading()

    async def close(self) -> None:
        """End the connection and wait until it has ended."""
        self.abort()
        if self._transport is not None and not self.closed:
            # One for each call: to cancel it ends no other.
            ended = self._create_future()
            self._closings.append(ended)
            await ended

    def abort(self) -> None:
        """End the connection without waiting."""
        if self._transport is not None and not self._transport.is_closing():
            self._transport.abort()

    def set_medium_again(self) -> None:
        """Make the driver set its medium as it was opened, where another program has set it otherwise since."""
        set_again = None if self._transport is None else self._transport.get_extra_info("set_again")
        if set_again is not None and not self.closed:
            set_again()

    async def choose_send_immediate(self, mode: str) -> None:
        """Set the send-immediate mode of the driver, where its medium has one."""
        choose = self._transport.get_extra_info("send_immediate") if self._transport is not None else None
        if choose is not None and not self.closed:
            await choose(mode)

    # Called by the transport

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Keep the transport."""
        # No check by class: the transports of uvloop are of none of asyncio's.
        self._transport = cast("asyncio.Transport", transport)

    def data_received(self, data: bytes) -> None:
        """Hand on a whole read."""
        self.bytes_received += len(data)
        receiver = self.receiver
        if receiver is not None:
            receiver.receive(data)

    def pause_writing(self) -> None:
        """Hold back what is sent from now on."""
        self.paused = True
        if self.on_pause is not None:
            self.on_pause()

    def resume_writing(self) -> None:
        """Send what was held back."""
        self.paused = False
        held_back = b"".join(self._held_back)
        self._held_back.clear()
        if held_back:
            self.send(held_back)
        if self.on_pause is not None:
            self.on_pause()

    def connection_lost(self, exc: Exception | None) -> None:
        """Report the end of the connection to the receiver."""
        self.closed = True
        self._held_back.clear()
        for ended in self._closings:
            if not ended.done():
                ended.set_result(None)
        if self.receiver is not None:
            self.receiver.disconnected(exc)

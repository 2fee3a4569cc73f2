"""Layer 1, the stream between a driver's transport and the session.

It passes on each read as a whole, and buffers sent bytes while the transport is paused. It does not parse frames.
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
    """Receives the bytes of a stream."""

    def receive(self, data: bytes) -> None:
        """Process received bytes; frames may be divided anywhere."""

    def disconnected(self, reason: Exception | None) -> None:
        """Process the end of the stream; `reason` is None if the other side closed it."""


class Ended(Awaitable[Any], Protocol):
    """A future for the end of a stream: an `asyncio.Future`, or its replacement without an event loop."""

    def done(self) -> bool:
        """Return True if the result is set."""

    def set_result(self, result: None, /) -> None:
        """Set the result, which resumes the awaiting call."""


class Stream(asyncio.Protocol):
    """One connection of a driver.

    `receiver` may be replaced at any time; bytes that arrive while it is None are dropped.

    Args:
        create_future: creates the futures that `close` awaits; None for those of the running event loop.
    """

    def __init__(self, create_future: Callable[[], Ended] | None = None) -> None:
        self.receiver: Receiver | None = None
        self.on_pause: Callable[[], None] | None = None
        """Is called after `paused` has changed."""
        self.bytes_received = 0
        self.bytes_sent = 0
        self.closed = False
        self._transport: asyncio.Transport | None = None
        self._create_future = create_future or asyncio.get_running_loop().create_future
        self._closings: list[Ended] = []
        """A future for each pending call of `close`."""
        self._held_back: list[bytes] = []
        self.paused = False
        """True while the transport is paused; sent bytes are buffered."""

    # Called by users of the stream

    def send(self, data: bytes) -> None:
        """Send bytes, or buffer them while the transport is paused; drop them if the connection has ended."""
        if self.paused:
            self._held_back.append(data)
        elif self._transport is not None and not self.closed:
            self.bytes_sent += len(data)
            self._transport.write(data)

    @property
    def shortest_timeout(self) -> float:
        """Lower limit of the retransmission timeout in seconds.

        This is the time that the medium may delay an answer, and a margin; that of a USB chip if the medium is unknown.
        """
        if self._transport is None:
            return SHORTEST_TIMEOUT
        is_socket = self._transport.get_extra_info("socket") is not None
        known = self._transport.get_extra_info("shortest_timeout", QUICK_TIMEOUT if is_socket else SHORTEST_TIMEOUT)
        return float(known)

    @property
    def longest_try(self) -> float:
        """Upper limit in seconds of the time between two tries of the handshake; infinite if the medium has none."""
        known = None if self._transport is None else self._transport.get_extra_info("longest_try")
        return math.inf if known is None else float(known)

    @property
    def path(self) -> Path | None:
        """Network path of a medium that sends frames in datagrams; None for others. Datagrams arrive undamaged."""
        return None if self._transport is None else self._transport.get_extra_info("path")

    @property
    def byte_time(self) -> float | None:
        """Seconds that a byte takes on the wire; None if unknown."""
        return None if self._transport is None else self._transport.get_extra_info("byte_time")

    @property
    def seat(self) -> Seat | None:
        """The link's seat on a line that it shares with other nodes; None if it does not share the line."""
        return None if self._transport is None else self._transport.get_extra_info("seat")

    @property
    def refusal(self) -> str:
        """Reason why the bus at the other end refuses accesses; empty if unknown."""
        told = None if self._transport is None else self._transport.get_extra_info("refusal")
        return "" if told is None else told()

    def pause_reading(self) -> None:
        """Leave received bytes in the medium's buffers until `resume_reading`."""
        if self._transport is not None and not self._transport.is_closing():
            self._transport.pause_reading()

    def resume_reading(self) -> None:
        """Deliver received bytes again."""
        if self._transport is not None and not self._transport.is_closing():
            self._transport.resume_reading()

    async def close(self) -> None:
        """Close the connection, and wait until it is closed."""
        self.abort()
        if self._transport is not None and not self.closed:
            # A future for each call, because cancelling one call must not cancel others.
            ended = self._create_future()
            self._closings.append(ended)
            await ended

    def abort(self) -> None:
        """Close the connection without waiting."""
        if self._transport is not None and not self._transport.is_closing():
            self._transport.abort()

    def set_medium_again(self) -> None:
        """Restore the settings of the medium through its driver if another program has changed them."""
        set_again = None if self._transport is None else self._transport.get_extra_info("set_again")
        if set_again is not None and not self.closed:
            set_again()

    async def choose_send_immediate(self, mode: str) -> None:
        """Set the send-immediate mode of the driver, if its medium has one."""
        choose = self._transport.get_extra_info("send_immediate") if self._transport is not None else None
        if choose is not None and not self.closed:
            await choose(mode)

    # Called by the transport

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Store the transport."""
        # Do not check the class: uvloop's transports are not derived from asyncio's.
        self._transport = cast("asyncio.Transport", transport)

    def data_received(self, data: bytes) -> None:
        """Pass received bytes to the receiver."""
        self.bytes_received += len(data)
        receiver = self.receiver
        if receiver is not None:
            receiver.receive(data)

    def pause_writing(self) -> None:
        """Buffer sent bytes from now on."""
        self.paused = True
        if self.on_pause is not None:
            self.on_pause()

    def resume_writing(self) -> None:
        """Send the buffered bytes."""
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

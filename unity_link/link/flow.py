"""Layer 2: the connection of a session with a stream, a clock and the futures of calls.

A session does no I/O. `Flow` passes received bytes and the time to it, sends its output, and completes the futures of
calls. The code that runs for each request is here; `connection` opens and closes connections.

`Flow` is separate from `Link` for speed: `Link` has a `__getattr__` for mistyped names, and Python 3.11 looks up the
attributes of such classes about ten times as slowly.
"""

from __future__ import annotations

import contextlib
import math
from typing import TYPE_CHECKING, Any

from unity_link.protocol.host.events import Awaited
from unity_link.protocol.host.requests import Request

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.link.runtimes.runtime import Runtime, Timer, Waiter
    from unity_link.protocol.host.batches import WordBatch
    from unity_link.protocol.host.events import Events, UnsolicitedEvent
    from unity_link.protocol.host.requests import Source
    from unity_link.protocol.host.session import Session
    from unity_link.protocol.wire.path import Path
    from unity_link.transport.stream import Stream
    from unity_link.transport.turns import Seat

_LATE = 0.05
"""Seconds that a timer may be later than the deadline, which progress can bring forward, before it is set again."""


class Flow:
    """Traffic between a session and the streams of its connections, one at a time.

    Args:
        session: session of the link.
        runtime: runtime of the link.
        happened: called with each unsolicited event.
        disconnected: called when the stream has ended, with the reason; None if the other side closed it.
    """

    def __init__(
        self,
        session: Session,
        runtime: Runtime,
        happened: Callable[[UnsolicitedEvent], None],
        disconnected: Callable[[Exception | None], None],
    ) -> None:
        self.session = session
        self.path: Path | None = None
        """Longest datagram of the latest connection; None if frames are not in datagrams."""
        self.stream: Stream | None = None
        """Stream of the connection; None without a connection."""
        self.latest: Stream | None = None
        """Stream of the latest connection, whose medium may still be closing."""
        self.seat: Seat | None = None
        """The link's place on a line that several nodes share; None on a line of its own."""
        self._happened, self._disconnected = happened, disconnected
        self._reads_on = False
        """True if `_read_on` is scheduled to process the rest of the received bytes."""
        self.now = runtime.time
        self.create_future, self._create_inline_future = runtime.create_future, runtime.create_inline_future
        self._ended = runtime.ended
        self._runtime = runtime
        self._timer: Timer | None = None
        self._timer_at = math.inf
        """Instant at which `_timer` is due; infinite without a timer."""
        self._turn_timer: Timer | None = None
        self._flushing = False
        """True if `_flush` is scheduled to send the output of the session."""
        self._bytes_before = (0, 0)
        """Bytes sent and received on earlier streams."""

    # Requests

    def submit(self, source: Source) -> None:
        """Submit the requests of a source to the session.

        Raises:
            LinkLostError: if the link has ended.
        """
        events = self.session.submit(source, self.now())
        # Otherwise the scheduled `_flush` sends the output.
        if events or not self._flushing or self.seat is not None:
            self.go_on(events)

    def ask(self, request: Request) -> Waiter:
        """Submit a request that has an answer to the session, and return the future of the answer.

        Raises:
            LinkLostError: if the link has ended.
        """
        now = self.now()
        frame = self.session.submit_alone(request, now)
        if not frame:
            request.waiter = waiter = self.create_future()
            self.submit(request)
            return waiter
        if self.stream is not None:
            # Send first, so that the gateway works while this side creates the future.
            self.stream.send(frame)
        request.waiter = waiter = self._create_inline_future()
        if self._timer_at - now > _LATE or self.session.window.send_limit.loses:
            self._set_timer()
        if request.done:
            # A simulated gateway in this process may have answered during `send`.
            request.settle()
        return waiter

    async def answer(self, request: Request | WordBatch) -> Any:
        """Execute a request or batch, and return its answer; cancel the request if the caller is cancelled."""
        if isinstance(request, Request):
            waiter = self.ask(request)
        else:
            request.waiter = waiter = self.create_future()
            self.submit(request)
        try:
            return await waiter
        except BaseException:
            request.cancel()
            raise

    def go_on(self, events: Events) -> None:
        """Handle the events of a call of the session, and send its output."""
        if events:
            self._tell(events)
            if self._ended:
                self._runtime.call_soon(self._runtime.wake)
        if self.seat is not None:
            self._take_turns()
        if self._flushing:
            return
        if self.session.output:
            self._send()
        else:
            self._set_timer()

    def _tell(self, events: Events) -> None:
        for event in events:
            if isinstance(event, Awaited):
                event.settle()
            else:
                self._happened(event)

    def _send(self) -> None:
        """Send the output of the session: at once if no request can follow in this turn, otherwise at its end."""
        session = self.session
        if session.window.has_one_request() or session.is_full:
            self._flush()
        else:
            self._flushing = True
            self._runtime.call_soon(self._flush)

    def _flush(self) -> None:
        self._flushing = False
        stream, data = self.stream, self.session.take_output()
        if stream is not None and data:
            stream.send(data)
        # Once for all frames sent together. The first posted write sets the time of a fence.
        self._set_timer()

    # Streams

    @property
    def block_words(self) -> int:
        """Most words of a block: limited by the gateway, and by the longest datagram of the network."""
        info = self.session.codec.info
        return info.block_words if self.path is None else info.block_words_in(self.path.longest_frame)

    @property
    def bytes_sent(self) -> int:
        """Bytes sent on all connections."""
        return self._bytes_before[0] + (0 if self.stream is None else self.stream.bytes_sent)

    @property
    def bytes_received(self) -> int:
        """Bytes received on all connections."""
        return self._bytes_before[1] + (0 if self.stream is None else self.stream.bytes_received)

    def attach(self, stream: Stream) -> None:
        """Begin the handshake on a connected stream."""
        self.stream = self.latest = stream
        self.path = stream.path
        stream.receiver, stream.on_pause = self, self._pause
        seat = self.seat = stream.seat
        if seat is not None:
            seat.on_turn = self._turn_has_come
        self.session.connect(
            self.now(),
            stream.shortest_timeout,
            takes_turns=seat is not None,
            byte_time=stream.byte_time,
            longest_try=stream.longest_try,
            is_transparent=self.path is not None,
            path=self.path,
        )

    def detach(self) -> None:
        """End the connection, and ignore its stream from now on."""
        stream = self.stream
        if self._turn_timer is not None:
            self._turn_timer.cancel()
            self._turn_timer = None
        if stream is not None:
            self._bytes_before = (self.bytes_sent, self.bytes_received)
            self.stream = self.seat = None
            stream.receiver = stream.on_pause = None
            stream.abort()

    def receive(self, data: bytes) -> None:
        """Process received bytes."""
        now = self.now()
        request = self.session.receive_alone(data, now) if self.seat is None else None
        if request is None:
            self._receive(data, now)
        else:
            request.settle()
            # No request is in flight, so the deadline is not earlier than an existing timer, which checks it again.
            if self._timer is None and self.session.window.send_limit.loses:
                self._set_timer()
        if self._ended:
            # Resume the awaiting tasks last, because they may submit requests at once, or close the link.
            self._runtime.wake()

    def _receive(self, data: bytes, now: float) -> None:
        session = self.session
        events = session.receive(data, now)
        self._tell(events)
        if session.is_behind and not self._reads_on and self.stream is not None:
            self._reads_on = True
            self.stream.pause_reading()
            self._runtime.call_soon(self._read_on)
        if self.seat is not None:
            self._take_turns()
            self._set_timer()
        if session.output:
            if self._flushing:
                return
            if events:
                self._send()
            else:
                # No call resumes because of these bytes, so no request follows in this turn.
                self._flush()
        elif self._timer_at - now > _LATE or session.window.send_limit.loses:
            self._set_timer()

    def _read_on(self) -> None:
        """Process more of the received bytes, in another turn of the event loop."""
        self._reads_on = False
        self.receive(b"")
        if not self._reads_on and self.stream is not None:
            self.stream.resume_reading()

    def disconnected(self, reason: Exception | None) -> None:
        """Report the end of the stream, after all bytes received on it are processed."""
        stream = self.stream
        if self._reads_on:
            self._runtime.call_soon(lambda: self.disconnected(reason) if self.stream is stream else None)
        else:
            self._disconnected(reason)

    def _pause(self) -> None:
        if self.stream is not None and self.stream.paused:
            self.session.pause_writing()
        else:
            self.go_on(self.session.resume_writing(self.now()))

    # Slots of a line that several nodes share

    def _take_turns(self) -> None:
        """Release the slot if no answer is outstanding, and request the next slot if there are frames to send."""
        session = self.session
        if self._turn_timer is not None:
            self._turn_timer.cancel()
            self._turn_timer = None
        seat = self.seat
        if seat is None or seat.is_kept:
            return
        if not session.is_owed_an_answer and (seat.has_begun or not session.wants_turn):
            seat.give_back()
        if not session.wants_turn:
            return
        if seat.ask():
            events = session.take_turn(self.now())
            seat.begin(session.longest_turn)
            self.go_on(events)
        else:
            patience = seat.patience
            if patience < math.inf:
                self._turn_timer = self._runtime.call_at(self.now() + patience, self._take_turns)

    def _turn_has_come(self) -> None:
        """Schedule the use of a slot in the thread of this link; the link's event loop may have ended."""
        with contextlib.suppress(RuntimeError):
            self._runtime.call_soon_threadsafe(self._take_turns)

    # Time

    def _set_timer(self) -> None:
        """Set the timer for the session's deadline. An earlier timer stays: `_tick` sets it again."""
        deadline = self.session.deadline
        if self._timer is not None:
            if deadline is None or self._timer_at <= deadline:
                return
            self._timer.cancel()
        if deadline is None:
            self._forget_timer()
        else:
            # Store the instant: a timer of uvloop that is due at once cannot report it.
            self._timer_at = deadline
            self._timer = self._runtime.call_at(deadline, self._tick)

    def _forget_timer(self) -> None:
        self._timer, self._timer_at = None, math.inf

    def _tick(self) -> None:
        self._forget_timer()
        now, deadline = self.now(), self.session.deadline
        if deadline is not None and deadline > now:
            # Answers have moved the deadline since the timer was set.
            self._set_timer()
            return
        sent_again = self.session.counters.repetitions
        self.go_on(self.session.expire(now))
        if self.session.counters.repetitions > sent_again and self.stream is not None:
            self.stream.set_medium_again()

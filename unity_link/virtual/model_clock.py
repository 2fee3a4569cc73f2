"""Model clock: advances a simulated gateway with the clock of an event loop.

A sample is taken for the time at which it is due, even if the event loop runs later. The clock therefore advances from
one due time to the next until it reaches the loop's time. One turn is limited to `MOST_BYTES`, `MOST_STEPS` and
`MOST_TURN`, so that the loop stays responsive; if this machine cannot compute all requested samples, the gateway runs
late. Samples that are later than `MOST_LAG`, or due while the medium is blocked, wait in the gateway while it has room;
further ones are overruns.

A gateway that skips time (compiled gateware) and is faster than real time is late only if the event loop was blocked.
Such a gateway may take `LONGEST_TURN` to catch up, so that it processes the next request, such as a kick that is too
late, only after this time has passed in the gateway.

If a turn ends after the next due time, the clock waits for `REST` seconds before the next turn. Many samples in one
turn of the loop cost little more than one sample, and a turn for each would use all of the loop's time.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Callable


MOST_BYTES = 65536
"""Largest number of published bytes in one turn."""
MOST_STEPS = 2048
"""Largest number of due times in one turn."""
MOST_TURN = 0.02
"""Longest duration of a turn in seconds."""
LONGEST_TURN = 0.5
"""Longest duration of a turn in seconds, for a gateway that skips time and is faster than real time."""
REST = 0.001
"""Seconds between two turns while the gateway is late; about the resolution of an event loop's timers."""
MOST_LAG = 1.0
"""Largest delay in seconds of the gateway's time behind the loop's time."""
LONGEST_PAUSE = 10.0
"""Largest delay in seconds, for a gateway that skips time and is faster than real time."""


class ClockedGateway(Protocol):
    """A gateway that a model clock advances."""

    wake: Callable[[], None]
    """Is called when `next_due` has become earlier other than by a call of `receive` or `advance`."""

    @property
    def next_due(self) -> float | None:
        """Time at which `advance` must be called next; None if no time is planned."""

    @property
    def waiting(self) -> int:
        """Number of received and unprocessed bytes. A medium with flow control stops while this number is large."""

    @property
    def leaves_time_out(self) -> bool:
        """True if `advance` skips time for which it is too late; the caller then need not drop samples."""
        return False

    @property
    def refusal(self) -> str:
        """Reason why the robot refuses all accesses; empty if it does not."""
        return ""

    def receive(self, data: bytes, now: float) -> bytes:
        """Process bytes received at the time `now`, in seconds from any origin, and return the bytes to send."""

    def advance(self, now: float, room: int | None = None) -> bytes:
        """Advance to the time `now`, and return the bytes to send.

        Args:
            now: the time in seconds; it never goes back.
            room: number of bytes that the medium accepts; None for no limit. Responses are never divided. Samples are
                sent until this number of bytes is reached; further samples wait, or are overruns if too many wait.
        """


class ModelClock:
    """The model clock of one gateway.

    Args:
        gateway: the gateway.
        send: sends the bytes of the gateway, and may call `block`. It is also called without bytes after time has
            passed at the gateway, which may then accept more requests.
        loop: the event loop whose clock is used.
    """

    def __init__(self, gateway: ClockedGateway, send: Callable[[bytes], None], loop: asyncio.AbstractEventLoop) -> None:
        self.gateway = gateway
        self.blocked = False
        self._send = send
        self._loop = loop
        self._timer: asyncio.TimerHandle | None = None
        self._armed_for = 0.0
        self._closed = False
        self._reached = loop.time()
        self._is_slow = False
        """True if the last turn took longer than the time by which it advanced the gateway."""
        gateway.wake = self._arm
        self._arm()

    def feed(self, data: bytes) -> None:
        """Pass received bytes to the gateway."""
        answer = self.gateway.receive(data, self._catch_up(self._loop.time()))
        if answer:
            self._send(answer)
        self._arm()

    def block(self) -> None:
        """Record that the medium accepts no more bytes; `feed` must not be called until `unblock`."""
        self.blocked = True
        self._disarm()

    def unblock(self) -> None:
        """Record that the medium accepts bytes again."""
        if not self.blocked:
            return
        late = self.gateway.advance(self._loop.time(), room=0)
        self.blocked = False
        if late:
            self._send(late)
        self._arm()

    def close(self) -> None:
        """Stop the clock; the gateway does not advance any more."""
        self._closed = True
        self._disarm()

    def _catch_up(self, now: float) -> float:
        """Advance the gateway to `now`, or as far as one turn allows; return the gateway's time after that."""
        gateway, published, steps = self.gateway, 0, 0
        reached, began = now, self._loop.time()
        may_pause = gateway.leaves_time_out and not self._is_slow
        most_lag, longest = (LONGEST_PAUSE, LONGEST_TURN) if may_pause else (MOST_LAG, MOST_TURN)
        while not self._closed and (due := gateway.next_due) is not None and due <= now:
            if self.blocked or now - due > most_lag:
                has_room = gateway.leaves_time_out and not self.blocked
                frames = gateway.advance(now, None if has_room else 0)
                # Skipped time must not count for `_is_slow`.
                due = self._reached = now
            elif published >= MOST_BYTES or steps >= MOST_STEPS or self._loop.time() - began >= longest:
                break
            else:
                frames = gateway.advance(due)
            reached = due
            published += len(frames)
            steps += 1
            if frames:
                self._send(frames)
        else:
            reached = now
        if reached > self._reached:
            self._is_slow = self._loop.time() - began > reached - self._reached
            self._reached = reached
        return reached

    def _arm(self, not_before: float = 0.0) -> None:
        """Set the timer for the next due time, but not before the time `not_before`."""
        due = self.gateway.next_due
        if due is None or self.blocked or self._closed:
            return
        at = max(due, not_before)
        if self._timer is None or at < self._armed_for:
            self._disarm()
            self._armed_for = at
            self._timer = self._loop.call_at(at, self._on_time, due)

    def _disarm(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _on_time(self, due: float) -> None:
        self._timer = None
        # An event loop may call a timer slightly early.
        now = max(self._loop.time(), due)
        has_caught_up = self._catch_up(now) == now
        self._send(b"")
        ended = self._loop.time()
        self._arm(not_before=ended + REST if has_caught_up and self._is_late(ended) else 0.0)

    def _is_late(self, now: float) -> bool:
        due = self.gateway.next_due
        return due is not None and due <= now

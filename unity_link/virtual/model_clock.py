"""The clock of a simulated gateway: it advances the gateway with the time of an event loop.

A sample belongs to the instant at which it is due, not to the one at which the loop comes to it. So the clock steps
from one due instant to the next, as far as the loop's time has come. It never does more in one go than `MOST_BYTES` or
`MOST_STEPS`, or for longer than `MOST_TURN`, so that the loop stays alive; a gateway that is asked for more samples
than this machine can make runs late. What is later than `MOST_LAG`, or becomes due while the medium is blocked, waits
in the gateway as far as there is room, and is otherwise counted as overruns.

A gateway that leaves time out (compiled gateware) but is quicker than time is late because the loop stood still. It
may take `LONGEST_TURN` to catch up: what comes to it next, such as a kick that is too late, finds that this time has
passed.

If a turn takes so long that the next instant is past when it ends, the clock rests for `REST` before it goes on: many
samples in one turn of the loop cost little more than one, and a turn for each would take all of the loop's time.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Callable


MOST_BYTES = 65536
"""Bytes that are published before the loop gets its turn."""
MOST_STEPS = 2048
"""Due instants that are passed before the loop gets its turn."""
MOST_TURN = 0.02
"""Seconds that may go by before the loop gets its turn."""
LONGEST_TURN = 0.5
"""The same of one that leaves time out, where the loop stood still and it is quicker than time."""
REST = 0.001
"""Seconds between the turns of a clock that is late: as finely as a loop sleeps anyway."""
MOST_LAG = 1.0
"""Seconds by which the gateway's time may be behind that of the loop."""
LONGEST_PAUSE = 10.0
"""The same as for `LONGEST_TURN`."""


class ClockedGateway(Protocol):
    """A gateway that a `ModelClock` advances."""

    wake: Callable[[], None]
    """Called when `next_due` has moved ahead for another reason than a call of `receive` or `advance`."""

    @property
    def next_due(self) -> float | None:
        """Instant at which `advance` must be called next; None while nothing is planned."""

    @property
    def waiting(self) -> int:
        """Bytes that were received and not looked at yet. A medium with flow control stops while this is large."""

    @property
    def leaves_time_out(self) -> bool:
        """Return whether `advance` leaves out what it is too late for: it need not be told to lose samples then."""
        return False

    @property
    def refusal(self) -> str:
        """The reason why the robot behind the bus refuses each access; empty where it does not."""
        return ""

    def receive(self, data: bytes, now: float) -> bytes:
        """Take bytes at the time `now`, in seconds of any origin, and return the bytes sent at once."""

    def advance(self, now: float, room: int | None = None) -> bytes:
        """Let time pass, and return the bytes sent.

        Args:
            now: the time in seconds; it never goes back.
            room: how many bytes the medium can take. Responses are never cut, but a sample is sent only while fewer
                bytes were sent. It waits otherwise, and where too many do, it is an overrun. None for no limit.
        """


class ModelClock:
    """Advances one gateway with the time of a loop.

    Args:
        gateway: what is driven.
        send: takes the bytes that the gateway sends, and may call `block`; it is also called, with none, when time has
            passed at the gateway, which may then have room for more requests.
        loop: whose time counts.
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
        """True if the last turn took longer than the time that has passed at the gateway in it."""
        gateway.wake = self._arm
        self._arm()

    def feed(self, data: bytes) -> None:
        """Pass bytes that arrived to the gateway."""
        answer = self.gateway.receive(data, self._catch_up(self._loop.time()))
        if answer:
            self._send(answer)
        self._arm()

    def block(self) -> None:
        """Record that the medium takes nothing more; `feed` must not be called until it does."""
        self.blocked = True
        self._disarm()

    def unblock(self) -> None:
        """Record that the medium takes bytes again."""
        if not self.blocked:
            return
        late = self.gateway.advance(self._loop.time(), room=0)
        self.blocked = False
        if late:
            self._send(late)
        self._arm()

    def close(self) -> None:
        """Let go of the gateway, which stands still from now on."""
        self._closed = True
        self._disarm()

    def _catch_up(self, now: float) -> float:
        """Go on to `now`, or as far as one turn can; gives the gateway's time then."""
        gateway, published, steps = self.gateway, 0, 0
        reached, began = now, self._loop.time()
        may_pause = gateway.leaves_time_out and not self._is_slow
        most_lag, longest = (LONGEST_PAUSE, LONGEST_TURN) if may_pause else (MOST_LAG, MOST_TURN)
        while not self._closed and (due := gateway.next_due) is not None and due <= now:
            if self.blocked or now - due > most_lag:
                has_room = gateway.leaves_time_out and not self.blocked
                frames = gateway.advance(now, None if has_room else 0)
                # What was left out did not take its time.
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
        """See to it that the loop comes back when something is due."""
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
        # A loop's timer may fire a little early.
        now = max(self._loop.time(), due)
        has_caught_up = self._catch_up(now) == now
        self._send(b"")
        ended = self._loop.time()
        self._arm(not_before=ended + REST if has_caught_up and self._is_late(ended) else 0.0)

    def _is_late(self, now: float) -> bool:
        due = self.gateway.next_due
        return due is not None and due <= now

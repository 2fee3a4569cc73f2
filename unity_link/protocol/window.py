"""Exactly once, in order: the host's side of protocol section 3, as a state machine without I/O or clocks.

Every request carries an ID, and IDs go round a ring of 16**id_digits numbers. The gateway executes only the ID that it
expects next, so the whole state of both sides fits on that ring. The host keeps three marks on it:

        answered         executed, but some        sent, and            not yet
                         answers were lost         not confirmed        sent
    ----------------|------------------------|---------------------|-------------
                  oldest                  executed                 next

- `oldest` is the oldest request that still wants something: its answer, or the news that it was executed.
- `executed` is what the gateway is known to expect at least: a response to ID k says that all before k were executed,
  and ``n i`` says the same of all before i. Posted writes have no answer; they are done when this mark passes them.
- `next` is the ID that the next request gets. It never runs more than half the ring ahead of `oldest`, for the gateway
  takes the half ring behind its own number for repetitions.

What comes in, and what the window does:

    ==============================  ==========================================================================
    response to an unanswered ID    answered; `executed` moves behind it; if `oldest` stays before `executed`
                                    then an answer was lost: go back
    response to any other ID        stale, the answer to a repetition: nothing
    ``n i``                         `executed` moves to i; go back
    ``X01`` ``X07`` ``X09``         something arrived damaged: go back
    ``X02`` ``X03``                 the same, and the third time for the same request: give that one up
    time out, something was heard   go back, with twice the time out; after too many for the same request: give that
                                    one up; after as many for the ``h`` in its place: lost
    time out, nothing was heard     go back, with twice the time out; after too many: lost
    ==============================  ==========================================================================

*Go back* means: send all unanswered requests again, in order, from `oldest`. A gap brings many signs (the damaged
frame, the out-of-sequence one behind it, the skipped answer), so the window goes back once for each `oldest`; if the
repetition is lost too, the time out finds it. While it loses, fewer requests are kept in flight, because one damaged
frame costs all those sent behind it.

A request that is given up, or that nobody waits for any more, keeps its ID, for those behind it build on it; when it is
sent again, it is sent as ``h``.

The time out is RFC 6298's, with the clock of the caller. One request at a time is timed, and none that was sent twice.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Generic, NamedTuple, TypeVar

if TYPE_CHECKING:
    from collections.abc import Iterator

MOST_SILENT_TRIES = 8
MOST_TRIES = 32
MOST_REFUSALS = 3
FEWEST_IN_FLIGHT = 8
SHORTEST_TIMEOUT = 0.025
"""An answer may stay in a USB chip until its latency timer ends: 16 ms by default, whatever the last round trip was."""
LONGEST_TIMEOUT = 2.0
FIRST_TIMEOUT = 0.25
FENCE_DELAY = 0.001
MEASUREMENT_PAUSE = 0.001
"""Seconds between two measurements of the round trip: one a window is enough, and fast reads are left alone."""


class Run:
    """One or more requests of equal size that hold consecutive IDs.

    A single request is a run of one. A run of many lets a batch be numbered, sent and answered in one step.
    """

    __slots__ = ("count", "first", "posted", "reply_size", "size")

    def __init__(self, count: int, size: int, reply_size: int) -> None:
        self.first = 0
        """The first ID, given by the window."""
        self.count = count
        """Number of requests."""
        self.size = size
        """Characters of each."""
        self.reply_size = reply_size
        """Characters of the answer to each; 0 where there is none: a posted write."""
        self.posted = reply_size == 0


R = TypeVar("R", bound=Run)


class Unanswered(NamedTuple, Generic[R]):
    """Part of a run that is not done: `size` requests from `offset` on; whether they are known to be executed."""

    run: R
    offset: int
    size: int
    executed: bool


class Window(Generic[R]):
    """The host's window over one session.

    Args:
        ring: number of IDs, 16**id_digits.
        byte_limit: most unconfirmed request bytes, or None where flow control protects the gateway's receive FIFO.
        byte_time: seconds that one byte may need on the wire, at most; round trips of many bytes show where it is less.
        round_trip: a first measurement in seconds, if there is one.
    """

    def __init__(
        self, ring: int, byte_limit: int | None = None, byte_time: float = 0.0, round_trip: float | None = None
    ) -> None:
        self._mask = ring - 1
        self._half = ring // 2
        self._byte_limit = byte_limit
        self._byte_time = self._reply_byte_time = byte_time
        self._slots: list[R | None] = [None] * ring
        self.oldest = self.executed = self.next = 0
        self._allowed = self._half
        self._bytes = 0
        self.unfenced = 0
        """Posted writes that nothing with an answer was sent behind."""
        self._unfenced_bytes = 0
        self._fence_due: float | None = None
        self._timed: tuple[int, float] | None = None
        self._timed_bytes = (1, 1)
        self._next_measurement = float("-inf")
        self.smoothed_round_trip: float | None = None
        """Smoothed round trip in seconds (SRTT of RFC 6298), None before the first."""
        self._variation = 0.0
        self._timeout = FIRST_TIMEOUT
        self._since = 0.0
        self._silent_tries = 0
        self._tries = 0
        self.heard = False
        """Something has arrived since the last time out, be it damaged: set by who reads."""
        self._gone_back = False
        self._refused = False
        self._refusals = 0
        self._gave_up = False
        self.wants_repetition = False
        """The window has gone back: `repetition` is to be sent."""
        self.lost = False
        """The gateway does not answer any more: too many time outs in silence, or not even an ``h`` comes through."""
        if round_trip is not None:
            self._measure(round_trip)

    @property
    def in_flight(self) -> int:
        """Number of IDs that were sent and are not done."""
        return self.next - self.oldest & self._mask

    # Sending

    def room(self, size: int, *, posted: bool = False) -> int:
        """Give how many more requests of `size` characters may be sent now.

        Posted writes leave room for the ``h`` that will confirm them.
        """
        ids = self._allowed - self.in_flight - posted
        if self._byte_limit is not None:
            most = (self._byte_limit - self._bytes) // size - posted
            # A request longer than the whole FIFO goes alone.
            ids = min(ids, max(most, 0 if self._bytes else 1))
        return max(ids, 0)

    def send(self, run: R, now: float) -> None:
        """Give IDs to a run that is now sent. The caller has seen that there is room (an ``h`` needs none)."""
        first, count = self.next, run.count
        run.first = first
        after = first + count & self._mask
        if count == 1:
            self._slots[first] = run
        else:
            self._fill(first, count, run)
        self._bytes += run.size * count
        if run.posted:
            if not self.unfenced:
                self._fence_due = now + FENCE_DELAY
            self.unfenced += count
            self._unfenced_bytes += run.size * count
        else:
            self.unfenced = self._unfenced_bytes = 0
            self._fence_due = None
            if self._timed is None and now >= self._next_measurement:
                self._timed = (first, now)
                self._timed_bytes = (self._bytes, run.reply_size)
        if self.oldest == first:
            self._since = now
        self.next = after

    def needs_fence(self, now: float) -> bool:
        """Say whether posted writes have waited long enough, or are many enough, to be confirmed by an ``h``."""
        if not self.unfenced:
            return False
        if self._byte_limit is not None and 4 * self._unfenced_bytes >= self._byte_limit:
            return True
        return 4 * self.unfenced >= self._allowed or (self._fence_due is not None and now >= self._fence_due)

    def repetition(self) -> Iterator[tuple[int, R, int, int]]:
        """Give what is to be sent again, in order: ID, run, offset in the run, count."""
        self.wants_repetition = False
        for part in self.unanswered():
            yield part.run.first + part.offset & self._mask, part.run, part.offset, part.size

    def unanswered(self) -> Iterator[Unanswered[R]]:
        """Give all that is not done, in order."""
        position = self.oldest
        while position != self.next:
            run = self._slots[position]
            executed = self._distance(position) < self._distance(self.executed)
            end = self.executed if executed else self.next
            count = 1
            while (position + count & self._mask) != end and self._slots[position + count & self._mask] is run:
                count += 1
            if run is not None:
                yield Unanswered(run, position - run.first & self._mask, count, executed)
            position = position + count & self._mask

    # Receiving

    def find(self, number: int) -> R | None:
        """Give the run that an answer names, or None where nothing waits for it (a stale answer)."""
        return self._slots[number]

    def unanswered_from(self, number: int, most: int) -> int:
        """Give how many IDs from `number` on, of `most`, wait for answers to the same run as `number` does."""
        run, end = self._slots[number], number + most
        slots = self._slots[number:end] + self._slots[: max(0, end - self._mask - 1)]
        if slots.count(run) == most:
            return most
        return next(index for index, other in enumerate(slots) if other is not run)

    def answered(self, number: int, count: int, now: float) -> None:
        """Take note of the answers to `count` IDs from `number` on, all of which wait for answers to one run."""
        run = self._slots[number]
        if run is None:
            raise ValueError(f"no request with ID {number} waits for an answer")
        if self._timed is not None and (self._timed[0] - number & self._mask) < count:
            round_trip = now - self._timed[1]
            self._measure(round_trip)
            self._byte_time = min(self._byte_time, round_trip / self._timed_bytes[0])
            self._reply_byte_time = min(self._reply_byte_time, round_trip / self._timed_bytes[1])
            self._timed = None
            self._next_measurement = now + MEASUREMENT_PAUSE
        if count == 1:
            self._slots[number] = None
        else:
            self._fill(number, count, None)
        if self._allowed < self._half:
            self._allowed = min(self._half, self._allowed + count)
        after = number + count & self._mask
        if number == self.oldest == self.executed:
            self._bytes -= run.size * count
            self.oldest = self.executed = after
            self._moved(now)
            return
        if self._distance(after) > self._distance(self.executed):
            if self._distance(number) > self._distance(self.executed):
                self._confirm(number)
            self._bytes -= run.size * (after - self.executed & self._mask)
            self.executed = after
        self._news(now)
        if self.oldest != self.executed:
            self._go_back(now)

    def out_of_sequence(self, expected: int, now: float) -> None:
        """Take note of ``n``: the gateway expects this ID, so a request has been lost."""
        if self._distance(expected) > self._distance(self.next):
            return
        if self._distance(expected) > self._distance(self.executed):
            self._confirm(expected)
            self._news(now)
        self._go_back(now)

    def damaged(self, now: float) -> None:
        """Take note of ``X01``, ``X07`` or ``X09``: a request arrived damaged."""
        self._go_back(now)

    def refused(self, now: float) -> R | None:
        """Take note of ``X02`` or ``X03``: give the run whose request is given up, if this was once too often."""
        given_up = None
        if self.oldest != self.next and self.oldest == self.executed and not self._refused:
            self._refused = True
            self._refusals += 1
            if self._refusals == MOST_REFUSALS:
                given_up = self._give_up()
        self._go_back(now)
        return given_up

    # Time

    @property
    def deadline(self) -> float | None:
        """When `expire` must be called, or a fence is due; None while nothing is under way."""
        if self.unfenced == self.in_flight:
            # Posted writes alone have no answer to wait for: their fence will.
            return self._fence_due
        run = self._slots[self.oldest]
        # RFC 6298 knows no messages of unlike sizes: the answer to a long one behind short ones is not late yet.
        wire_time = self._byte_time * self._bytes + self._reply_byte_time * (0 if run is None else run.reply_size)
        expiry = self._since + self._timeout + wire_time
        return expiry if self._fence_due is None else min(expiry, self._fence_due)

    def expire(self, now: float) -> R | None:
        """Take note of the time: give the run whose request is given up, if this was once too often.

        A fence that is due is the matter of `needs_fence`.
        """
        deadline = self.deadline
        if deadline is None or deadline == self._fence_due or now < deadline:
            return None
        given_up = None
        self._tries += 1
        # Also where something was heard: it may be the beginning of a long answer on a slow line.
        self._timeout = min(2 * self._timeout, LONGEST_TIMEOUT)
        if self.heard:
            self._silent_tries = 0
            if self._tries > MOST_TRIES:
                self.lost = self._gave_up
                given_up = self._give_up()
        else:
            self._silent_tries += 1
            self.lost = self._silent_tries > MOST_SILENT_TRIES
        self.heard = self._gone_back = False
        self._go_back(now)
        return given_up

    # The inside

    def _distance(self, number: int) -> int:
        return number - self.oldest & self._mask

    def _fill(self, first: int, count: int, run: R | None) -> None:
        before_wrap = min(count, self._mask + 1 - first)
        self._slots[first : first + before_wrap] = [run] * before_wrap
        self._slots[: count - before_wrap] = [run] * (count - before_wrap)

    def _confirm(self, expected: int) -> None:
        """Move `executed` up: the posted writes that it passes are done, and their bytes have left the FIFO."""
        position = self.executed
        while position != expected:
            run = self._slots[position]
            if run is not None:
                self._bytes -= run.size
                if run.posted:
                    self._slots[position] = None
            position = position + 1 & self._mask
        self.executed = expected

    def _news(self, now: float) -> None:
        """Move `oldest` up over what is done, and start the clock anew."""
        slots, position = self._slots, self.oldest
        if position != self.executed and slots[position] is None:
            while position != self.executed and slots[position] is None:
                position = position + 1 & self._mask
            self.oldest = position
            self._moved(now)
        self._tries = self._silent_tries = 0
        self._since = now

    def _moved(self, now: float) -> None:
        """Begin anew with another `oldest`."""
        self._gone_back = self._refused = self._gave_up = False
        self._refusals = self._tries = self._silent_tries = 0
        self._since = now

    def _give_up(self) -> R | None:
        given_up = self._slots[self.oldest]
        if given_up is not None:
            # What it is sent as from now on, an ``h``, has an answer.
            given_up.posted = False
        self._tries = self._refusals = 0
        self._gone_back = False
        self._gave_up = True
        return given_up

    def _go_back(self, now: float) -> None:
        if self.oldest == self.next or self._gone_back:
            return
        self._gone_back = True
        self._refused = False
        self._timed = None
        self._allowed = max(self._allowed // 2, min(FEWEST_IN_FLIGHT, self._half))
        self.wants_repetition = True
        self._since = now

    def _measure(self, round_trip: float) -> None:
        """Adapt the time out (RFC 6298, section 2)."""
        if self.smoothed_round_trip is None:
            self.smoothed_round_trip = round_trip
            self._variation = round_trip / 2
        else:
            self._variation += (abs(self.smoothed_round_trip - round_trip) - self._variation) / 4
            self.smoothed_round_trip += (round_trip - self.smoothed_round_trip) / 8
        wanted = self.smoothed_round_trip + 4 * self._variation
        self._timeout = min(max(wanted, SHORTEST_TIMEOUT), LONGEST_TIMEOUT)

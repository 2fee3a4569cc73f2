"""The host's side of docs/protocol.md, "Exactly once, in order", as a state machine without I/O or clocks.

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
    response to an unanswered ID    answered; `executed` moves behind it; what was sent before it and is not answered
                                    was lost: where the gateway has executed all that, send it again; else go back
    response to any other ID        stale, the answer to a repetition: nothing
    ``n i``                         `executed` moves to i; go back, unless it was beyond i already
    ``X01`` ``X07`` ``X09``         a request arrived damaged: go back; where it may be the repetition of one that was
                                    executed, send the oldest again, and go back if silence follows
    ``X02`` ``X03``                 the same, and the third time for the same request: give that one up
    a frame with a wrong CRC        an answer arrived damaged, perhaps: send the oldest again
    time out, something was heard   go back, with twice the time out; after too many for the same request: give that
                                    one up; after as many for the ``h`` in its place: lost
    time out, nothing was heard     go back, with twice the time out; after `LONGEST_SILENCE`: lost
    ==============================  ==========================================================================

*Go back* means: send the unanswered requests again, in order, from `oldest`. One damaged request costs all those sent
behind it. So where it goes back, fewer are kept in flight: half as many, and at most twice as many as came through
since it went back before; some that are done later it is one more, and posted writes count as they are confirmed. The
repetition, too, sends only as many at a time, and new requests follow behind its end. What is answered does not count,
so that new requests follow also where the oldest alone is sent again.

A damaged answer costs nothing but itself. Both directions keep the order, and the window knows in which order requests
were sent, repetitions among them. So a response says which others will not come any more.

A gap brings many signs (the damaged request, the out-of-sequence one behind it). So when it has gone back and sent
something again, the window takes no further sign as long as neither `oldest` nor `executed` has moved and a sign must
still be about what was sent before: for the least round trip seen, and twice as long each time; the first few, for a
usual round trip at most. A later sign says that the repetition was lost, too. An earlier one may say the same of a line
that was quicker than ever before: where nothing comes for as long again, the window goes back for that. What brings
no sign at all, the time out finds. From `MOST_SIGNS` on, a sign counts as a time out, so that what is damaged each time
is given up as well. Where no flow control protects the gateway's receive FIFO, only the time out sends the same once
more: what waits in the FIFO must have left it.

Something was *heard* if it can be about a request; samples are not. A request that is given up, or that is not wanted
any more, keeps its ID, for those behind it build on it; when it is sent again, it is sent as ``h``.

The time out is RFC 6298's (`round_trip`), but never less than twice the round trip, with the clock of the caller. The
doubling is undone by the answer to a request that was sent once, and by any progress after a sign of loss.
"""

from __future__ import annotations

import math
from itertools import chain
from typing import TYPE_CHECKING, Generic, NamedTuple, TypeVar

from unity_link.errors import Outcome
from unity_link.protocol.constants import (
    DONE_FOR_ONE_MORE,
    FENCE_DELAY,
    FEWEST_IN_FLIGHT,
    FEWEST_SILENT_TRIES,
    LONGEST_SILENCE,
    LONGEST_TIMEOUT,
    MOST_QUICK_SIGNS,
    MOST_REFUSALS,
    MOST_SIGNS,
    MOST_TRIES,
    SHORTEST_TIMEOUT,
    SLOWER_SIGNS,
)
from unity_link.protocol.round_trip import RoundTrip

if TYPE_CHECKING:
    from collections.abc import Iterator


class Run:
    """One or more requests of equal size that hold consecutive IDs.

    A single request is a run of one. A run of many lets a batch be numbered, sent and answered in one step.
    """

    __slots__ = ("count", "first", "posted", "reply_size", "sending", "size")

    def __init__(self, count: int, size: int, reply_size: int) -> None:
        self.first = 0
        """The first ID, given by the window."""
        self.sending = 0
        """Place of the first request among all that were sent, given by the window."""
        self.count = count
        """Number of requests."""
        self.size = size
        """Characters of each."""
        self.reply_size = reply_size
        """Characters of the answer to each; 0 where there is none: a posted write."""
        self.posted = reply_size == 0


R = TypeVar("R", bound=Run)
_NONE = (0, -math.inf)
"""The repetition of a request that was not sent again."""


class Unanswered(NamedTuple, Generic[R]):
    """Part of a run that is not done: `size` requests from `offset` on, and what is known of them."""

    run: R
    offset: int
    size: int
    outcome: Outcome


class EarlySign(NamedTuple):
    """A sign of loss that may be about one before: it is taken where nothing comes for some time."""

    sent: int
    """Requests that had been sent when it came."""
    pause: float
    """Seconds for which nothing must come."""
    due: float
    """Until when."""


class Window(Generic[R]):
    """The host's window over one session.

    Args:
        ring: number of IDs, 16**id_digits.
        first: the first ID of the session.
        byte_limit: most unconfirmed request bytes, or None where flow control protects the gateway's receive FIFO.
        byte_time: seconds that one byte may need on the wire, at most; round trips of many bytes show where it is less.
        round_trip: a first measurement in seconds, if there is one.
        shortest_timeout: seconds that the medium may hold an answer back, and some more.
        most: requests in flight, at most; None for half the ring.
    """

    # With more than thirty attributes, Python finds those of a class without slots the slow way.
    __slots__ = (
        "_allowed",
        "_allowed_after_loss",
        "_answered_last",
        "_asked_to",
        "_byte_limit",
        "_bytes",
        "_came",
        "_early_sign",
        "_fence_due",
        "_gap",
        "_gave_up",
        "_gone_back",
        "_half",
        "_mask",
        "_most",
        "_next_sign",
        "_refusals",
        "_refused",
        "_repeat_ambiguous_until",
        "_repeat_end",
        "_repetitions",
        "_sent",
        "_sent_at_sign",
        "_sent_once_from",
        "_sign_pause",
        "_silent_since",
        "_silent_tries",
        "_since",
        "_slots",
        "_to_repeat",
        "_tries",
        "_troubled",
        "_unfenced_bytes",
        "executed",
        "heard",
        "loses",
        "lost",
        "next",
        "oldest",
        "round_trip",
        "timed_out",
        "unfenced",
    )

    def __init__(
        self,
        ring: int,
        first: int = 0,
        byte_limit: int | None = None,
        byte_time: float = 0.0,
        round_trip: float | None = None,
        shortest_timeout: float = SHORTEST_TIMEOUT,
        most: int | None = None,
    ) -> None:
        self._mask, self._half = ring - 1, ring // 2
        self._most = self._half if most is None else most
        self._byte_limit = byte_limit
        self._slots: list[R | None] = [None] * ring
        self.oldest = self.executed = self.next = first
        self._to_repeat = self._repeat_end = first
        """The IDs that are to be sent again: from one mark on and before the other; none where they are equal."""
        self._sent = 0
        """Number of requests sent, repetitions counted as well."""
        self._repetitions: dict[int, tuple[int, float]] = {}
        """Requests that were sent again, by ID: the place of the last sending among all that were sent, and until
        when an answer may be to an earlier one; where the place is before that of the run, it is of an earlier lap."""
        self._repeat_ambiguous_until = 0.0
        """The same of what is to be sent again."""
        self._allowed = self._most
        self.loses = False
        """True if fewer are kept in flight, for the line has lost some."""
        self._allowed_after_loss = self._came = 0
        self._bytes = 0
        self.unfenced = 0
        """Posted writes that nothing with an answer was sent behind."""
        self._unfenced_bytes = 0
        self._fence_due = math.inf
        """Instant at which they are to be confirmed, if there are any."""
        shortest = shortest_timeout if byte_limit is None else max(shortest_timeout, SHORTEST_TIMEOUT)
        self.round_trip = RoundTrip(byte_time, round_trip, shortest)
        # The first IDs: behind all that were sent again, behind the last that was sent again for a damaged answer, and
        # what the gateway expected when the window last went back.
        self._sent_once_from = self._asked_to = self._gap = first
        self._since = self._silent_since = 0.0
        self._tries = self._silent_tries = self._refusals = 0
        self.heard = False
        """Something that can be about a request has arrived since the last time out, be it damaged: set by the reader.
        """
        self._gone_back = 0
        """Number of times the window has gone back to this `oldest`."""
        self.timed_out = False
        """True if the window went back last because the time had run out."""
        # From when on a sign can be about what was last sent again for one, how long that was from then, and how many
        # requests had been sent until then.
        self._next_sign, self._sign_pause, self._sent_at_sign = -math.inf, 0.0, -1
        self._answered_last = -1
        """Place of the last sending that was answered, while there are repetitions."""
        self._early_sign: EarlySign | None = None
        self._refused = self._gave_up = self._troubled = False
        # The last: whether there is something that `_moved` has to begin anew.
        self.lost = False
        """The gateway does not answer any more: too many time outs in silence, or not even an ``h`` comes through."""

    @property
    def in_flight(self) -> int:
        """Number of IDs that were sent and are not done."""
        return self.next - self.oldest & self._mask

    def is_idle(self) -> bool:
        """Return whether nothing is in flight."""
        return self.next == self.oldest

    def is_lone(self) -> bool:
        """Return whether one request alone is in flight."""
        return self.next - self.oldest & self._mask == 1

    @property
    def idle_since(self) -> float:
        """Instant at which the last request was done; it holds while none is in flight."""
        return self._since

    # Sending

    def wants_repetition(self) -> bool:
        """Return whether it has gone back, and not all was sent again yet: call `repetition` when something came."""
        return self._to_repeat != self._repeat_end

    def most_room(self, size: int) -> int:
        """Return for how many requests of `size` characters there is room while nothing is under way."""
        return self._allowed if self._byte_limit is None else min(self._allowed, max(1, self._byte_limit // size))

    def room(self, size: int, *, posted: bool = False) -> int:
        """Return how many more requests of `size` characters may be sent now.

        Posted writes leave room for the ``h`` that will confirm them.
        """
        if self._to_repeat != self._repeat_end:
            return 0
        in_flight = self.next - self.oldest & self._mask
        # What is not known to be executed, or executed and not answered, may still be lost.
        outstanding = in_flight if self.oldest == self.executed else in_flight - self._done(self.oldest, self.executed)
        ids = min(self._allowed - outstanding, self._half - in_flight)
        # A window of one has no room for both.
        ids -= posted and self._most > 1
        if self._byte_limit is not None:
            most = (self._byte_limit - self._bytes) // size - posted
            # A request longer than the whole FIFO goes alone.
            ids = min(ids, max(most, 0 if self._bytes else 1))
        return max(ids, 0)

    def has_room(self, size: int, *, posted: bool) -> bool:
        """Return whether one more request of `size` characters may be sent now."""
        in_flight = self.next - self.oldest & self._mask
        if not in_flight:
            return True
        # What is done and still in flight would give more room, which is seldom needed.
        if in_flight + 1 < self._allowed and self._byte_limit is None and self._to_repeat == self._repeat_end:
            return True
        return self.room(size, posted=posted) > 0

    def send(self, run: R, now: float) -> None:
        """Assign IDs to a run that is now sent. The caller has seen that there is room (an ``h`` needs none)."""
        first, count = self.next, run.count
        size = run.size * count
        run.first = first
        run.sending = self._sent
        self._sent += count
        self._bytes += size
        if count == 1:
            self._slots[first] = run
        else:
            self._fill(first, count, run)
        if run.posted:
            if not self.unfenced:
                self._fence_due = now + FENCE_DELAY
            self.unfenced += count
            self._unfenced_bytes += size
        else:
            if self.unfenced:
                self.unfenced = self._unfenced_bytes = 0
                self._fence_due = math.inf
            trip = self.round_trip
            if trip.timed is None and now >= trip.next_measurement:
                trip.begin(first, now, self._bytes, run.reply_size)
        if self.oldest == first:
            self._since = now
        self.next = first + count & self._mask

    def needs_fence(self, now: float) -> bool:
        """Return whether posted writes have waited long enough, or are many enough, to be confirmed by an ``h``."""
        if not self.unfenced or self._to_repeat != self._repeat_end:
            return False
        if self._byte_limit is not None and 4 * self._unfenced_bytes >= self._byte_limit:
            return True
        return 4 * self.unfenced >= self._allowed or now >= self._fence_due

    def repetition(self) -> list[tuple[int, R, int, int]]:
        """Return what is to be sent again now, in order: ID, run, offset in the run, count."""
        least = self._open(self.oldest, self._behind_next_with_answer(self.oldest))
        room = max(self._allowed, least) - self._open(self.oldest, self._to_repeat)
        mask, until, repetitions, sent = self._mask, self._repeat_ambiguous_until, self._repetitions, self._sent
        parts = self._parts(self._to_repeat, self._repeat_end, room)
        for number, _, _, count in parts:
            for place in range(number, number + count):
                repetitions[place & mask] = sent, until
                sent += 1
        self._sent = sent
        if parts:
            self._to_repeat = parts[-1][0] + parts[-1][3] & mask
        if not self._open(self._to_repeat, self._repeat_end):
            self._to_repeat = self._repeat_end
        return parts

    def unanswered(self, refused: int | None = None) -> Iterator[Unanswered[R]]:
        """Return all that is not done, in order.

        Args:
            refused: the ID of a request that met a gateway without a session (docs/protocol.md, "The host").
        """
        never = self.next if refused is None else self._never_executed_from(refused)
        executed = self._outcomes(self.oldest, self.executed, Outcome.EXECUTED)
        if self._distance(never) < self._distance(self.executed):
            never = self.executed
        unknown = self._outcomes(self.executed, never, Outcome.UNKNOWN)
        return chain(executed, unknown, self._outcomes(never, self.next, Outcome.NOT_EXECUTED))

    def _never_executed_from(self, refused: int) -> int:
        """Return the first ID in flight that was first sent when the refused request was sent last, or later."""
        run, number = self._slots[refused], refused
        if run is None or self._distance(refused) >= self.in_flight:
            return self.next
        last = self._sending(run, refused)
        while number != self.next and (run is None or self._first_sending(run, number) < last):
            number = number + 1 & self._mask
            run = self._slots[number]
        return number

    def _outcomes(self, position: int, last: int, outcome: Outcome) -> Iterator[Unanswered[R]]:
        for _, run, offset, count in self._parts(position, last):
            yield Unanswered(run, offset, count, outcome)

    @property
    def _sent_once(self) -> int:
        """The first ID in flight from which on nothing was sent again."""
        oldest, mask = self.oldest, self._mask
        return self._sent_once_from if self._sent_once_from - oldest & mask <= self.next - oldest & mask else oldest

    def _between(self, first: int, last: int) -> list[R | None]:
        """Return what waits for answers to the IDs from `first` on and before `last`, None for those that are done."""
        slots = self._slots
        return slots[first:last] if first <= last else slots[first:] + slots[:last]

    def _done(self, first: int, last: int) -> int:
        """Return how many IDs are done, from `first` on and before `last`."""
        return self._between(first, last).count(None)

    def _open(self, first: int, last: int) -> int:
        """Return how many IDs are not done, from `first` on and before `last`."""
        return (last - first & self._mask) - self._done(first, last)

    def _parts(self, position: int, last: int, most: int | None = None) -> list[tuple[int, R, int, int]]:
        """Return the parts of runs that wait for answers between two IDs, of `most` requests.

        Each is an ID, the run, the offset in that, and how many requests follow.
        """
        slots, mask, parts = self._slots, self._mask, []
        room = len(slots) if most is None else most
        while position != last and room > 0:
            run = slots[position]
            if run is None:
                position = position + 1 & mask
                continue
            first = position
            while True:
                position = position + 1 & mask
                room -= 1
                if position == last or slots[position] is not run or room <= 0:
                    break
            parts.append((first, run, first - run.first & mask, position - first & mask))
        return parts

    # Receiving

    def find(self, number: int) -> R | None:
        """Return the run that an answer names, or None where nothing waits for it (a stale answer)."""
        return self._slots[number]

    def unanswered_from(self, number: int, most: int) -> int:
        """Return how many IDs from `number` on, of `most`, wait for answers to the same run as `number` does."""
        run, end = self._slots[number], number + most
        slots = self._slots[number:end] + self._slots[: max(0, end - self._mask - 1)]
        if slots.count(run) == most:
            return most
        return next(index for index, other in enumerate(slots) if other is not run)

    def is_quiet(self) -> bool:
        """Return whether an answer to the oldest says nothing of others: none is missing, or was sent again."""
        return (
            self.oldest == self.executed
            and not self._troubled
            and not self._repetitions
            and not self.round_trip.is_doubled
        )

    def answered_alone(self, now: float) -> None:
        """Record the answer to the oldest request, while it is quiet."""
        number = self.oldest
        run = self._slots[number]
        assert run is not None
        if self.round_trip.timed == number:
            self.round_trip.end(now)
        self._slots[number] = None
        self._bytes -= run.size
        if self.loses:
            self._came_through(1)
        self.oldest = self.executed = number + 1 & self._mask
        self._since = now

    def answered(self, number: int, count: int, now: float) -> None:
        """Record the answers to `count` IDs from `number` on, all of which wait for one."""
        if self._slots[number] is None:
            raise ValueError(f"no request with ID {number} waits for an answer")
        trip = self.round_trip
        if trip.timed is not None and trip.timed - number & self._mask < count:
            trip.end(now)
        # Without repetitions, the answer to the oldest says nothing of the others.
        tells = self._repetitions or number != self.oldest
        sending = self._answered_sending(number + count - 1 & self._mask, now) if tells else 0
        after = number + count & self._mask
        # Those before `executed` have left the FIFO already.
        size = self._size(after, min(count, after - self.executed & self._mask))
        self._fill(number, count, None)
        if self.loses:
            self._came_through(count)
        if trip.is_doubled and (number - self._sent_once_from & self._mask) <= self._half:
            trip.undo_doubling()
        if number == self.oldest == self.executed:
            self._bytes -= size
            self.oldest = self.executed = after
            self._since = now
            if self._troubled:
                self._moved(now)
            if tells:
                self._find_lost(sending, now)
            return
        if self._distance(after) > self._distance(self.executed):
            if self._distance(number) > self._distance(self.executed):
                self._confirm(number)
            self._bytes -= size
            self.executed = after
        self._news(now)
        self._find_lost(sending, now)

    def out_of_sequence(self, expected: int, now: float) -> None:
        """Record ``n``: the gateway expects this ID, so a request has been lost."""
        if self._distance(expected) > self._distance(self.next):
            return
        if self._distance(expected) > self._distance(self.executed):
            self._confirm(expected)
            self._news(now)
        run = self._slots[expected]
        if expected == self.executed and run is not None:
            # Nothing behind a request that was lost is executed before that was sent again.
            sent_once = self._sending(run, expected) == self._first_sending(run, expected)
            self._go_back(now, ambiguous_until=now if sent_once else math.inf)

    def damaged(self, now: float) -> None:
        """Record ``X01``, ``X07`` or ``X09``: a request arrived damaged."""
        if not self._awaits_answer_again():
            self._go_back(now)
            return
        # Perhaps the repetition of one of which the answer was lost. Of another, ``n`` will tell, or silence.
        self.answer_damaged(now)
        self._note_early_sign(now, self.round_trip.smoothed or 0.0)

    def answer_damaged(self, now: float) -> None:
        """Record that something arrived damaged: perhaps the answer to the oldest, or to the next if it came before."""
        early = self._is_early(now)
        if self._gone_back and early:
            self._note_early_sign(now, self._sign_pause)
            return
        asked = self._distance(self._asked_to)
        if not 0 < asked <= self.in_flight:
            self._asked_to = self.oldest
        elif now >= self._next_sign:
            self._go_back(now)
            return
        start = self._asked_to
        end = self._asked_to = self._behind_next_with_answer(start)
        if start == end:
            if early:
                self._note_early_sign(now, self._sign_pause)
        elif not self._is_to_be_repeated(start):
            self._follow_sign(now, self.round_trip.least)
            self.timed_out = False
            self._repeat(start, end, now, self._next_sign)

    def refused(self, now: float) -> R | None:
        """Record ``X02`` or ``X03``: give the run whose request is given up, if this was once too often."""
        given_up = None
        if self.oldest != self.next and self.oldest == self.executed and not self._refused:
            self._refused = self._troubled = True
            self._refusals += 1
            if self._refusals == MOST_REFUSALS:
                given_up = self._give_up()
        self._go_back(now)
        return given_up

    # Time

    @property
    def deadline(self) -> float | None:
        """Instant at which `expire` must be called, or a fence is due; None while nothing is under way."""
        repeating = self._to_repeat != self._repeat_end
        if self.unfenced == self.in_flight and not repeating:
            # Posted writes alone have no answer to wait for: their fence will.
            return self._fence_due if self.unfenced else None
        run = self._slots[self.oldest]
        expiry = self._since + self.round_trip.time_out(self._bytes, 0 if run is None else run.reply_size)
        if self._early_sign is not None:
            expiry = min(expiry, self._early_sign.due)
        return expiry if repeating else min(expiry, self._fence_due)

    @property
    def longest_answer(self) -> float:
        """Seconds after which no answer can come any more to the oldest request, if it was sent just now."""
        run = self._slots[self.oldest]
        return self.round_trip.longest(self._bytes, 0 if run is None else run.reply_size)

    def resume(self, now: float) -> None:
        """Record that the turn has come in which something is sent again: the time for its answer begins."""
        self._since = now

    def expire(self, now: float) -> R | None:
        """Record the time: give the run whose request is given up, if this was once too often.

        A fence that is due is the matter of `needs_fence`.
        """
        deadline = self.deadline
        if self._early_sign is not None and now >= self._early_sign.due:
            self._early_sign = None
            if self._gone_back < MOST_SIGNS:
                self._go_back(now)
                return None
        elif deadline is None or now < deadline or (deadline == self._fence_due and not self.wants_repetition()):
            return None
        given_up = None
        self._tries += 1
        self._troubled = True
        # Also where something was heard: it may be the beginning of a long answer on a slow line.
        self.round_trip.double()
        if self.heard:
            self._silent_tries = 0
            if self._tries > MOST_TRIES:
                self.lost = self._gave_up
                given_up = self._give_up()
        else:
            if not self._silent_tries:
                self._silent_since = self._since
            self._silent_tries += 1
            self.lost = self._silent_tries >= FEWEST_SILENT_TRIES and now - self._silent_since >= LONGEST_SILENCE
        self.heard = False
        self.timed_out = True
        self._repeat_from_oldest(now)
        return given_up

    # The inside

    def _size(self, end: int, count: int) -> int:
        """Return how many characters the last requests before an ID have."""
        first = end - count & self._mask
        run = self._slots[first]
        if run is not None and self._slots[end - 1] is run:
            return run.size * count
        return sum([run.size for run in self._between(first, end) if run is not None])

    def _distance(self, number: int) -> int:
        return number - self.oldest & self._mask

    def _fill(self, first: int, count: int, run: R | None) -> None:
        beyond = first + count - self._mask - 1
        if beyond > 0:
            self._slots[:beyond] = [run] * beyond
            count -= beyond
        self._slots[first : first + count] = [run] * count

    def _confirm(self, expected: int) -> None:
        """Move `executed` up: the posted writes that it passes are done, and their bytes have left the FIFO."""
        between = self._between(self.executed, expected)
        posted = size = 0
        for run in between:
            if run is not None:
                size += run.size
                if run.posted:
                    posted += 1
        if posted + between.count(None) == len(between):
            self._fill(self.executed, len(between), None)
        else:
            for place, run in enumerate(between, self.executed):
                if run is not None and run.posted:
                    self._slots[place & self._mask] = None
        self._bytes -= size
        self.executed = expected
        if self.loses:
            self._came_through(posted)

    def _came_through(self, count: int) -> None:
        """Record how many more are done since the window went back, and let so many more be in flight."""
        self._came += count
        self._allowed = min(self._most, self._allowed_after_loss + self._came // DONE_FOR_ONE_MORE)
        self.loses = self._allowed < self._most

    def _news(self, now: float) -> None:
        """Move `oldest` up over what is done, and start the clock anew."""
        oldest = self.oldest
        if oldest != self.executed and self._slots[oldest] is None:
            between = self._between(oldest, self.executed)
            done = len(between)
            if between.count(None) != done:
                done = next(place for place, run in enumerate(between) if run is not None)
            self.oldest = oldest + done & self._mask
            self._moved(now)
        self._tries = self._silent_tries = 0
        self._since = now

    def _moved(self, now: float) -> None:
        """Begin anew with another `oldest`."""
        self._refused = self._gave_up = False
        self._gone_back = self._refusals = self._tries = self._silent_tries = 0
        self._since = now
        if not self.timed_out:
            # What the window went back for was a sign, so the answer is not a late one to what was sent before.
            self.round_trip.undo_doubling()
        if self._to_repeat != self._repeat_end and self._distance(self._to_repeat) > self.in_flight:
            self._to_repeat = self.oldest
            if self._distance(self._repeat_end) > self.in_flight:
                self._repeat_end = self.oldest
        if self._early_sign is not None:
            sent, pause, _ = self._early_sign
            run = self._slots[self.oldest]
            waits = run is not None and self._sending(run, self.oldest) < sent
            self._early_sign = EarlySign(sent, pause, now + pause) if waits else None
        self._troubled = self._to_repeat != self._repeat_end or self._early_sign is not None

    def _give_up(self) -> R | None:
        given_up = self._slots[self.oldest]
        if given_up is not None:
            # What it is sent as from now on, an ``h``, has an answer.
            given_up.posted = False
        self._tries = self._refusals = self._gone_back = 0
        self._gave_up = self._troubled = True
        return given_up

    def _go_back(self, now: float, ambiguous_until: float = math.inf) -> None:
        """Go back for a sign of loss, unless it may be one of the loss before."""
        begun = self._to_repeat != self.oldest or self._repeat_end != self.next
        known = self._gone_back and self.executed == self._gap and self._is_early(now)
        if known:
            self._note_early_sign(now, self._sign_pause)
        elif self.oldest != self.next and begun:
            if self._gone_back == MOST_SIGNS:
                # `expire` goes back for it, and counts the tries.
                self._early_sign = EarlySign(self._sent, self._sign_pause, now)
                self._troubled = True
                return
            self.timed_out = False
            self._repeat_from_oldest(now, ambiguous_until)

    def _is_early(self, now: float) -> bool:
        """Return whether a sign can be about what was lost before the last repetition.

        As long as that is not sent, a sign is about another loss: both directions keep the order.
        """
        return now < self._next_sign and self._sent != self._sent_at_sign

    def _follow_sign(self, now: float, pause: float) -> None:
        """Record that something is to be sent again for a sign; one about it comes after `pause` at the earliest."""
        self._next_sign, self._sign_pause, self._sent_at_sign = now + pause, pause, self._sent

    def _note_early_sign(self, now: float, pause: float) -> None:
        """Record a sign that is taken only if nothing comes for as long as `pause`."""
        if self._early_sign is None:
            self._early_sign = EarlySign(self._sent, pause, now + pause)
            self._troubled = True

    def _awaits_answer_again(self) -> bool:
        """Return whether a request that was executed may have been sent again, and the gateway not have come to it."""
        for number, run in enumerate(self._between(self.oldest, self.executed), self.oldest):
            if run is not None:
                place, _ = self._repetitions.get(number & self._mask, _NONE)
                if place > max(self._answered_last, self._first_sending(run, number)):
                    return True
        return False

    def _first_sending(self, run: R, number: int) -> int:
        """Return the place of the first sending of a request among all sendings."""
        return run.sending + (number - run.first & self._mask)

    def _sending(self, run: R, number: int) -> int:
        """Return the place of the last sending of a request."""
        return max(self._first_sending(run, number), self._repetitions.get(number, _NONE)[0])

    def _answered_sending(self, number: int, now: float) -> int:
        """Return the place of the sending that is answered now, or of an earlier one where that is not known."""
        run = self._slots[number]
        assert run is not None
        first, (last, ambiguous_until) = self._first_sending(run, number), self._repetitions.get(number, _NONE)
        return first if now < ambiguous_until else max(first, last)

    def _find_lost(self, sending: int, now: float) -> None:
        """Send again what was sent before a request that is answered now, and is not: it or its answer was lost.

        Where the gateway has executed it, only the answer was lost, and what is behind it is on its way.
        """
        self._answered_last = max(self._answered_last, sending)
        if self._sent_once == self.oldest:
            self._repetitions.clear()
        if not self._is_lost(self.oldest, sending):
            return
        self.timed_out = False
        if self._is_lost(self.executed, sending):
            self._repeat_from_oldest(now, now)
            return
        end = self.oldest
        while end != self.executed and (self._slots[end] is None or self._is_lost(end, sending)):
            end = end + 1 & self._mask
        self._repeat(self.oldest, end, now, now)

    def _is_lost(self, number: int, sending: int) -> bool:
        """Return whether a request waits for its answer, and was sent before another that was answered."""
        run = self._slots[number]
        return run is not None and self._sending(run, number) < sending and not self._is_to_be_repeated(number)

    def _is_to_be_repeated(self, number: int) -> bool:
        return number - self._to_repeat & self._mask < self._repeat_end - self._to_repeat & self._mask

    def _behind_next_with_answer(self, position: int) -> int:
        """Return the ID behind the next request that has an answer; that of the next where all are posted writes."""
        while position != self.next:
            run = self._slots[position]
            position = position + 1 & self._mask
            if run is not None and not run.posted:
                break
        return position

    def _repeat_from_oldest(self, now: float, ambiguous_until: float = math.inf) -> None:
        trip = self.round_trip
        if self._gone_back < MOST_QUICK_SIGNS:
            pause = min(trip.least * 2**self._gone_back, trip.smoothed or 0.0)
        else:
            pause = min(max(trip.least, SLOWER_SIGNS) * 2**self._gone_back, LONGEST_TIMEOUT)
        # What waits in a receive FIFO that can overflow must have left it before the same is sent once more.
        self._follow_sign(now, pause if self._byte_limit is None else LONGEST_TIMEOUT)
        self._early_sign = None
        self._gone_back = min(self._gone_back + 1, MOST_SIGNS)
        self._refused = False
        if self.loses:
            self._allowed = min(self._allowed, 4 * self._came)
        self._allowed = self._allowed_after_loss = max(self._allowed // 2, min(FEWEST_IN_FLIGHT, self._most))
        self.loses = self._allowed < self._most
        self._came = 0
        self._gap = self.executed
        self._repeat(self.oldest, self.next, now, ambiguous_until)

    def _repeat(self, start: int, end: int, now: float, ambiguous_until: float) -> None:
        """Repeat all requests without an answer from `start` on and before `end`, besides those already due."""
        if self._to_repeat == self._repeat_end:
            self._to_repeat, self._repeat_end = start, end
            self._repeat_ambiguous_until = ambiguous_until
        else:
            self._to_repeat = min(self._to_repeat, start, key=self._distance)
            self._repeat_end = max(self._repeat_end, end, key=self._distance)
            whole = (start, end) == (self._to_repeat, self._repeat_end)
            self._repeat_ambiguous_until = ambiguous_until if whole else math.inf
        if self._distance(end) > self._distance(self._sent_once):
            self._sent_once_from = end
        self.round_trip.timed = None
        self._troubled = True
        self._since = now

"""The host's side of docs/protocol.md, "Exactly once, in order", as a state machine without I/O or clocks.

Every request carries an ID of the sequence space (`unity_link.protocol.window.sequence_space`). At most half of the IDs
are in flight: the gateway takes the half before its own number for repetitions. The window's reaction to each event:

    ==============================  ==========================================================================
    response to an unanswered ID    answered; `executed` moves behind it; what was sent before it and is not answered
                                    was lost: where the gateway has executed all that, send it again; else go back
    response to any other ID        stale, the answer to a repetition: nothing
    response to an ``h``            the same, and the posted writes before it are told, or each is asked for
    ``n i``                         `executed` moves to i; go back; outside of the window: the session is over
    ``X01`` ``X07`` ``X09``         a request arrived damaged: go back
    ``X02`` ``X03``                 the same, and the third time for the same request: give that one up
    a frame with a wrong CRC        an answer arrived damaged, perhaps: send the oldest again, or the next if it came
                                    before; go back where all were
    time out, something was heard   go back, with twice the time out; after too many for the same request: give that
                                    one up; after as many for the ``h`` in its place: lost
    time out, nothing was heard     go back, with twice the time out; after `LONGEST_SILENCE`: lost
    ==============================  ==========================================================================

*Go back* means: ask for the session by a `K`, and send the unanswered requests again, in order, from `oldest`. It is
done once for a loss (`loss`), with fewer in flight (`send_limit`); about a sign that may be of the same loss or of the
next one, one more `K` asks, as the first may be lost. The repetition sends only as many at a time, and new
requests follow behind its end. A damaged answer costs nothing but itself: the order in which requests were sent,
repetitions and `K` among them, says of each answer which others will not come any more (`retransmission`).

Something was *heard* if it can be about a request; samples are not. A request that is given up, or that is not wanted
any more, keeps its ID, for those behind it build on it; when it is sent again, it is sent as ``h``.

The time out is RFC 6298's (`round_trip`), but never less than twice the round trip, with the clock of the caller. The
doubling is undone by the answer to a request that was sent once, and by any progress after a sign of loss.
"""

from __future__ import annotations

from itertools import chain
from typing import TYPE_CHECKING, Generic, NamedTuple

from unity_link.errors import Outcome
from unity_link.protocol.window.constants import SHORTEST_TIMEOUT
from unity_link.protocol.window.loss_detection import LossDetection
from unity_link.protocol.window.posted_writes import PostedWrites
from unity_link.protocol.window.retransmission import NEVER, Retransmission
from unity_link.protocol.window.round_trip import RoundTrip
from unity_link.protocol.window.send_limit import SendLimit
from unity_link.protocol.window.sequence_space import Part, R, SequenceSpace, parts_of

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator


class Unanswered(NamedTuple, Generic[R]):
    """Part of a run that is not done: `size` requests from `offset` on, and what is known of them."""

    run: R
    offset: int
    size: int
    outcome: Outcome


class Window(SequenceSpace[R]):
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

    __slots__ = ("_free", "_sent", "_unawaited", "loss", "posted_writes", "retransmission", "room_of_answers",
                 "round_trip", "send_limit", "since")  # fmt: skip

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
        super().__init__(ring, first)
        self.send_limit = SendLimit(ring // 2 if most is None else most, byte_limit)
        self.posted_writes: PostedWrites[R] = PostedWrites()
        self.retransmission: Retransmission[R] = Retransmission(self)
        self.loss = LossDetection()
        shortest = shortest_timeout if byte_limit is None else max(shortest_timeout, SHORTEST_TIMEOUT)
        self.round_trip = RoundTrip(byte_time, round_trip, shortest)
        self._sent = 0
        """Characters of all requests of the session."""
        self._free = 0
        """Number of requests of any size for which there is room at least, as far as it was asked."""
        self._unawaited = first
        """ID before which no answer is awaited, as far as it was asked."""
        self.room_of_answers: Callable[[], int] | None = None
        """Returns how many bytes of answers may be under way; None: any number."""
        self.since = 0.0
        """Instant of the last progress; while nothing is in flight, of the last request that was done."""

    @property
    def in_flight(self) -> int:
        """Number of IDs from the first on that was sent and is not done."""
        in_flight, posts = self.next - self.oldest & self.mask, self.posted_writes
        # Either may be before the other.
        return max(in_flight, self.next - posts.first & self.mask) if posts.executed else in_flight

    @property
    def bytes(self) -> int:
        """Characters of the requests that are not known to be executed."""
        run = self.slots[self.executed]
        if run is None or self.executed == self.next:
            return 0
        return self._sent - run.before - (self.executed - run.first & self.mask) * run.size

    def is_idle(self) -> bool:
        """Return whether nothing is in flight."""
        return self.next == self.oldest and not self.posted_writes.executed

    def is_lone(self) -> bool:
        """Return whether one request alone is in flight."""
        return self.next - self.oldest & self.mask == 1

    # Sending

    def bound_answers(self, room_of_answers: Callable[[], int]) -> None:
        """Bound the answers under way by as many bytes as a function returns."""
        self.room_of_answers = room_of_answers
        self._free = 0

    def room(self, size: int, *, posted: bool = False, reply_size: int = 0) -> int:
        """Return how many more requests of `size` characters with answers of `reply_size` may be sent now.

        Where there are posted writes, a place is left for the ``h`` that will confirm them.
        """
        if self.retransmission.is_due():
            return 0
        kept_free = posted or self.posted_writes.unfenced
        # What is not known to be executed, or executed and not answered, may still be lost.
        outstanding = self.unanswered_count
        if self.oldest != self.executed:
            outstanding -= self.between(self.oldest, self.executed).count(None)
        room = self.send_limit.room(outstanding, self.bytes, size, kept_free=kept_free)
        room = min(room, (self.mask >> 1) + 1 - self.in_flight - kept_free)
        if self.room_of_answers is not None and reply_size:
            awaited = sum(part.run.reply_size * part.length for part in self.parts(self.oldest, self.next))
            room = min(room, max((self.room_of_answers() - awaited) // reply_size, 0 if awaited else 1))
        return max(0, room)

    def most_room(self, size: int, reply_size: int) -> int:
        """Return for how many such requests there is room while nothing is under way."""
        most = self.send_limit.most_room(size)
        if self.room_of_answers is None or not reply_size:
            return most
        return min(most, max(self.room_of_answers() // reply_size, 1))

    def has_room(self, size: int, *, posted: bool, reply_size: int = 0) -> bool:
        """Return whether one more request of `size` characters may be sent now, as `room`."""
        if self._free > 0 or not self.in_flight:
            return True
        room = self.room(size, posted=posted, reply_size=reply_size)
        if self.send_limit.byte_limit is None and self.room_of_answers is None:
            # Answers make more, and what makes less forgets it; a place is left for an ``h``.
            self._free = room - 1
        return room > 0

    def send(self, run: R, now: float) -> None:
        """Assign IDs to a run that is now sent. The caller has seen that there is room (an ``h`` needs none)."""
        first, count, repetition = self.next, run.count, self.retransmission
        run.first = first
        run.sending = repetition.sent
        repetition.sent += count
        run.before = self._sent
        self._free -= count
        self._sent += run.size * count
        if count == 1:
            self.slots[first] = run
        else:
            self.fill(first, count, run)
        if self.oldest == first:
            self.since = now
        self.next = first + count & self.mask
        if run.posted:
            if not self.posted_writes.unfenced:
                self.posted_writes.begin(run, now)
            return
        if self.posted_writes.unfenced:
            self.posted_writes.sent_behind(run, self.next)
        trip = self.round_trip
        if trip.timed is None and now >= trip.next_measurement:
            trip.begin(first, now, self.bytes, run.reply_size)

    def needs_fence(self, now: float) -> bool:
        """Return whether posted writes have waited long enough, or are many enough, to be confirmed by an ``h``."""
        posts, allowance = self.posted_writes, self.send_limit
        limit = allowance.byte_limit
        return (
            posts.unfenced
            and (
                4 * (self.next - posts.start & self.mask) >= allowance.allowed
                or now >= posts.due
                or (limit is not None and 4 * (self._sent - posts.before) >= limit)
            )
            and not self.retransmission.is_due()
        )

    def repeat(self) -> list[Part[R]]:
        """Return what is to be sent again now, in order."""
        start = self.retransmission.start
        least = self.open(self.oldest, self.behind_next_with_answer(self.oldest))
        return self.retransmission.take(max(self.send_limit.allowed, least) - self.open(self.oldest, start))

    def unanswered(self, refused: int | None = None) -> Iterator[Unanswered[R]]:
        """Return all that is not done, in order.

        Args:
            refused: the ID of a request that met a gateway without a session, and was known by its residue
                (docs/protocol.md, "The host").
        """
        never = self.next if refused is None else self.retransmission.never_arrived_from(refused)
        if self.distance(never) < self.distance(self.executed):
            never = self.executed
        return chain(
            _with_outcome(parts_of(self.posted_writes.executed, self.posted_writes.first, self.mask), Outcome.EXECUTED),
            _with_outcome(self.parts(self.oldest, self.executed), Outcome.EXECUTED),
            _with_outcome(self.parts(self.executed, never), Outcome.UNKNOWN),
            _with_outcome(self.parts(never, self.next), Outcome.NOT_EXECUTED),
        )

    # Receiving

    def is_quiet(self) -> bool:
        """Return whether an answer to the oldest says nothing of others: none is missing, or was sent again."""
        repetition = self.retransmission
        return (
            self.oldest == self.executed
            and repetition.start == repetition.end
            and not repetition.awaits()
            and not self.round_trip.is_doubled
            and self.loss.place == NEVER
        )

    def answered_quietly(self, count: int, now: float) -> None:
        """Record the answers to the oldest requests, all of which wait for one, while it is quiet."""
        number, trip = self.oldest, self.round_trip
        if trip.timed is not None and trip.timed - number & self.mask < count:
            trip.end(now)
        if count == 1:
            self.slots[number] = None
        else:
            self.fill(number, count, None)
        if self.send_limit.loses:
            self.send_limit.came_through(count)
        self.oldest = self.executed = number + count & self.mask
        self.since = now

    def answered(self, number: int, count: int, now: float) -> None:
        """Record the answers to `count` IDs from `number` on, all of which wait for one."""
        last, after = number + count - 1 & self.mask, number + count & self.mask
        run, beginning = self.slots[last], self.slots[number]
        if run is None or beginning is None:
            raise ValueError(f"no request with ID {number} waits for an answer")
        if number == self.oldest and self.is_quiet():
            self.answered_quietly(count, now)
            return
        trip, repetition = self.round_trip, self.retransmission
        if trip.timed is not None and trip.timed - number & self.mask < count:
            trip.end(now)
        # Without repetitions, the answer to the oldest says nothing of the others.
        tells = repetition.awaits() or number != self.oldest
        place = self._answered_place(beginning, number, run, last) if tells or self.loss.place != NEVER else NEVER
        if trip.is_doubled and repetition.sending(run, last) == repetition.first_sending(run, last):
            trip.undo_doubling()
        self._confirm(number)
        if self.distance(after) > self.distance(self.executed):
            self.executed = after
        self.fill(number, count, None)
        if self.send_limit.loses:
            self.send_limit.came_through(count)
        self._news(now)
        if tells:
            self._find_lost(place, now)
        elif place != NEVER:
            repetition.arrived(place)
            if place >= self.loss.place:
                self.loss.place = NEVER

    def _answered_place(self, beginning: R, number: int, run: R, last: int) -> int:
        """Return the place of the sending of the last of some IDs, all of which are answered now."""
        repetition = self.retransmission
        place = repetition.answered_sending(beginning, number)
        if last != number:
            # Those of the others came behind it.
            repetition.answered = max(repetition.answered, place)
            place = repetition.answered_sending(run, last)
        return place

    def told(self, number: int, failed: int, now: float) -> bool:
        """Take the count of failed posted writes from the answer to an ``h``: return whether all before it are told.

        Otherwise each is asked for, and the ``h`` is sent once more behind them: at once, or where they were asked for
        before, when their answers show that it was sent before them.
        """
        posts, repetition = self.posted_writes, self.retransmission
        self._confirm(number)
        if self.executed == number:
            self.executed = number + 1 & self.mask
        first, executed = posts.first, posts.take_executed(number, self.mask)
        asked = []
        if self.open(self.oldest, number):
            asked = [part for part in self.parts(self.oldest, number) if part.run.is_question]
        if not executed and not asked:
            return True
        if failed == posts.failed:
            for part in asked:
                self.answered(part.number, part.length, now)
            return True
        run = self.slots[number]
        assert run is not None
        place = repetition.answered_sending(run, number)
        repetition.arrived(place)
        again = [part.number for part in asked if repetition.is_lost(part.number, place)]
        if executed:
            for part in parts_of(executed, first, self.mask):
                self.fill(part.number, part.length, part.run.question(part.offset, part.length))
            if self.distance(first) > self.mask >> 1:
                # Otherwise an earlier ``h`` has gone back further.
                self.oldest = first
            again.append(first)
        if not again:
            # The answers to what was asked for are on their way, and will show that this one came before them.
            self.since = now
            return False
        self.loss.timed_out = False
        self._repeat(min(again, key=self.distance), number + 1 & self.mask, now)
        return False

    def post_failed(self) -> None:
        """Record that the error of a posted write has come."""
        self.posted_writes.failed = self.posted_writes.failed + 1 & self.mask

    def asked(self, now: float) -> None:
        """Record the answer to a `K` that was sent ahead of a repetition: what was sent before will not be answered."""
        repetition = self.retransmission
        place = repetition.told()
        if place == NEVER or self.next == self.oldest:
            return
        if self.loss.are_left_to_the_time():
            repetition.arrived(place)
            return
        self._find_lost(place, now)
        if repetition.in_doubt and repetition.questions:
            # Where one was lost, this was the answer to a later one.
            repetition.doubt()

    def out_of_sequence(self, expected: int, now: float) -> bool:
        """Record ``n``: the gateway expects this ID, so a request has been lost.

        Returns:
            False where no gateway can expect the ID in this session: it executed what lies before `executed`, and
            nothing was sent from `next` on.
        """
        if expected - self.executed & self.mask > self.next - self.executed & self.mask:
            return False
        marks = dict.fromkeys((self.executed, expected - 1 & self.mask))
        executed = [(self.slots[number], number) for number in marks]
        if self._confirm(expected):
            for earlier, number in executed:
                if earlier is not None:
                    self.retransmission.arrived(self.retransmission.answered_sending(earlier, number))
            self._news(now)
        run = self.slots[expected]
        if expected == self.executed and run is not None:
            # Nothing behind a request that was lost is executed before that was sent again.
            self.retransmission.arrived(self.retransmission.first_sending(run, expected))
            if self.loss.takes(self.retransmission.answered):
                self._go_back(now)
        return True

    def damaged(self, now: float) -> None:
        """Record ``X01``, ``X07`` or ``X09``: a request arrived damaged."""
        self._go_back(now)

    def answer_damaged(self, now: float) -> None:
        """Record that something arrived damaged: perhaps the answer to the oldest, or to the next if it came before."""
        repetition = self.retransmission
        if not self.loss.takes(repetition.answered):
            repetition.doubt()
            return
        start = repetition.first_sent_once()
        end = self.behind_next_with_answer(start)
        if start == end:
            self._go_back(now)
        elif not repetition.includes(start):
            self.loss.timed_out = False
            self._repeat(start, end, now)
            if self.distance(start) >= self.distance(self.executed):
                # What arrived damaged may have been an error or ``n``, and then there is no answer to what is sent.
                repetition.doubt()

    def refused(self, now: float) -> R | None:
        """Record ``X02`` or ``X03``: give the run whose request is given up, if this was once too often."""
        given_up = None
        if self.oldest != self.next and self.oldest == self.executed and self.loss.takes(self.retransmission.answered):
            if self.loss.refused():
                given_up = self._give_up()
            self._go_back(now)
        return given_up

    # Time

    @property
    def deadline(self) -> float | None:
        """Instant at which `expire` must be called, or a fence is due; None while nothing is under way."""
        posts, repeating = self.posted_writes, self.retransmission.is_due()
        if posts.unfenced and not repeating and not 0 < self.distance(posts.mark) <= self.unanswered_count:
            # Posted writes alone have no answer to wait for: their fence will.
            return posts.due
        if self.next == self.oldest:
            return None
        expiry = self.since + self.round_trip.time_out(self.bytes, self._next_reply_size())
        return expiry if repeating else min(expiry, posts.due)

    @property
    def longest_answer(self) -> float:
        """Seconds after which no answer can come any more to the oldest request, if it was sent just now."""
        return self.round_trip.longest(self.bytes, self._next_reply_size())

    def resume(self, now: float) -> None:
        """Record that the turn has come in which something is sent again: the time for its answer begins."""
        self.since = now

    def expire(self, now: float) -> R | None:
        """Record the time: give the run whose request is given up, if this was once too often.

        A fence that is due is the matter of `needs_fence`.
        """
        deadline = self.deadline
        if (
            deadline is None
            or now < deadline
            or (deadline == self.posted_writes.due and not self.retransmission.is_due())
        ):
            return None
        # Also where something was heard: it may be the beginning of a long answer on a slow line.
        self.round_trip.double()
        self.retransmission.questions.clear()
        given_up = self._give_up() if self.loss.time_out(now, self.since) else None
        self._repeat_from_oldest(now)
        return given_up

    # The inside

    def _next_reply_size(self) -> int:
        """Return how many characters the next answer has, 0 where none is awaited."""
        if self.distance(self._unawaited) > self.unanswered_count:
            self._unawaited = self.oldest
        last = self.behind_next_with_answer(self._unawaited) - 1 & self.mask
        run = self.slots[last]
        self._unawaited = last
        return 0 if run is None else run.reply_size

    def _confirm(self, expected: int) -> bool:
        """Move `executed` up, if it is not so far; the posted writes that it passes are executed."""
        if self.distance(expected) <= self.distance(self.executed):
            return False
        number, runs = self.executed, self.between(self.executed, expected)
        self.executed = expected
        different = set(runs)
        others = {run for run in different if run is None or not run.posted}
        if len(others) < len(different):
            posts = [None if run in others else run for run in runs] if others else runs
            self.posted_writes.keep(number, posts, self.mask)
            self.put(number, [run if run in others else None for run in runs] if others else [None] * len(runs))
            if self.send_limit.loses:
                self.send_limit.came_through(len(posts) - posts.count(None))
        return True

    def _news(self, now: float) -> None:
        """Move `oldest` up over what is done, and start the clock anew."""
        self.loss.news()
        self.since = now
        if self.advance():
            self.loss.moved()
            if not self.loss.timed_out:
                # What the window went back for was a sign, so the answer is not a late one to what was sent before.
                self.round_trip.undo_doubling()
            self.retransmission.follow()

    def _give_up(self) -> R | None:
        given_up = self.slots[self.oldest]
        if given_up is not None:
            # What it is sent as from now on, an ``h``, has an answer.
            given_up.posted = False
        self.loss.give_up()
        return given_up

    def _go_back(self, now: float) -> None:
        """Go back for a sign of loss; where it may be one of the loss before, ask how far the line has come."""
        if self.oldest == self.next:
            return
        if self.loss.takes(self.retransmission.answered):
            self.loss.timed_out = False
            self._repeat_from_oldest(now)
        else:
            self.retransmission.doubt()

    def _find_lost(self, place: int, now: float) -> None:
        """Send again what was sent before something that has arrived, and is not answered: it or its answer was lost.

        Where the gateway has executed it, only the answer was lost, and what is behind it is on its way.
        """
        repetition = self.retransmission
        repetition.arrived(place)
        if not repetition.is_any() and not repetition.is_due():
            self.loss.place = NEVER
        if not repetition.is_lost(self.oldest, place):
            return
        self.loss.timed_out = False
        if repetition.is_lost(self.executed, place):
            self._repeat_from_oldest(now)
            return
        end = self.oldest
        while end != self.executed and (self.slots[end] is None or repetition.is_lost(end, place)):
            end = end + 1 & self.mask
        self._repeat(self.oldest, end, now)

    def _repeat_from_oldest(self, now: float) -> None:
        self.loss.go_back(self.retransmission.sent)
        self.send_limit.lose()
        self._repeat(self.oldest, self.next, now)

    def _repeat(self, start: int, end: int, now: float) -> None:
        """Repeat all requests without an answer from `start` on and before `end`, besides those already due."""
        self.retransmission.begin(start, end)
        self._free, self._unawaited = 0, self.oldest
        self.round_trip.timed = None
        self.since = now


def _with_outcome(parts: Iterable[Part[R]], outcome: Outcome) -> Iterator[Unanswered[R]]:
    for _, run, offset, count in parts:
        yield Unanswered(run, offset, count, outcome)

"""The window: exactly-once delivery in order at the host (docs/protocol.md, "The host"), without I/O or clocks.

Every request carries an ID of the sequence space (`unity_link.protocol.window.sequence_space`). At most half of the IDs
are in flight, because the gateway treats the other half as repetitions. The window reacts to an event as follows:

    ==============================  ====================================================================================
    event                           reaction
    ==============================  ====================================================================================
    response to an unanswered ID    The request is done, and all requests before it are executed. Unanswered requests
                                    that were sent before it, or their answers, are lost: retransmit only those whose
                                    execution is certain, otherwise go back.
    response to any other ID        Ignore it: it answers a retransmission of a request that is done.
    response to an ``h`` (fence)    As above. Its count confirms the posted writes before it; if some failed
                                    without an error, ask for the outcome of each.
    ``n i``                         All requests before ID i are executed: go back. If i is outside of the window, the
                                    session is over.
    ``X01`` ``X07`` ``X09``         A request arrived damaged: go back.
    ``X02`` ``X03``                 The same; after `MOST_REFUSALS` for one request, give it up.
    frame with a wrong CRC          An answer may be damaged: retransmit the oldest request, or the next one if the
                                    oldest was retransmitted already. If all were, go back.
    timeout, something was heard    Go back, with backoff. After `MOST_TRIES` for one request, give it up; after as many
                                    for its replacement, the link is lost.
    timeout in silence              Go back, with backoff. After `LONGEST_SILENCE` the link is lost.
    ==============================  ====================================================================================

1. *Go back*: send a session query (`K`), then retransmit the unanswered requests from `oldest` on, in order. New
   requests follow them.
2. The window goes back once for a loss (`loss_detection`), and then keeps fewer requests in flight (`send_limit`).
3. A later sign may belong to the same loss or to a new one. One more query decides, because the first may be lost.
4. Both directions keep the order of frames. So each answer shows which answers can no longer arrive
   (`retransmission`); a damaged answer therefore costs one retransmission.
5. Bytes were *heard* if they can belong to an answer or an error. Samples do not count.
6. A request that is given up, or cancelled, keeps its ID, because later IDs follow it. Its retransmissions are ``h``.
7. The timeout is that of RFC 6298 (`round_trip`), but at least twice the round trip. An answer to a request that was
   sent once ends the backoff, and so does progress after a sign of loss.
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
    """Requests of a run that are not done, `size` of them from `offset` on, with their outcome."""

    run: R
    offset: int
    size: int
    outcome: Outcome


class Window(SequenceSpace[R]):
    """The requests in flight of one session.

    Args:
        id_count: number of IDs, 16**id_digits.
        first: first ID of the session.
        byte_limit: most unconfirmed request bytes; None if flow control protects the gateway's receive FIFO.
        byte_time: upper limit of the seconds that one byte takes on the wire; measured round trips lower it.
        round_trip: first measured round trip in seconds, or None.
        shortest_timeout: lower limit of the timeout in seconds, above the delay that the medium may add to an answer.
        most: most requests in flight; None for half the sequence space.
    """

    __slots__ = ("_free", "_sent", "_unawaited", "loss", "posted_writes", "retransmission", "room_of_answers",
                 "round_trip", "send_limit", "since")  # fmt: skip

    def __init__(
        self,
        id_count: int,
        first: int = 0,
        byte_limit: int | None = None,
        byte_time: float = 0.0,
        round_trip: float | None = None,
        shortest_timeout: float = SHORTEST_TIMEOUT,
        most: int | None = None,
    ) -> None:
        super().__init__(id_count, first)
        self.send_limit = SendLimit(id_count // 2 if most is None else most, byte_limit)
        self.posted_writes: PostedWrites[R] = PostedWrites()
        self.retransmission: Retransmission[R] = Retransmission(self)
        self.loss = LossDetection()
        shortest = shortest_timeout if byte_limit is None else max(shortest_timeout, SHORTEST_TIMEOUT)
        self.round_trip = RoundTrip(byte_time, round_trip, shortest)
        self._sent = 0
        """Characters of all requests of the session."""
        self._free = 0
        """Lower limit of the number of requests that may be sent now, of any size; cached by `has_room`."""
        self._unawaited = first
        """ID before which no answer is expected; cached by `_next_reply_size`."""
        self.room_of_answers: Callable[[], int] | None = None
        """Returns the most bytes of answers in flight; None for no limit."""
        self.since = 0.0
        """Instant of the last progress, from which the timeout counts. If the window is idle: when it became idle."""

    @property
    def in_flight(self) -> int:
        """Number of IDs from the first request that is not done, to `next`."""
        in_flight, posted = self.next - self.oldest & self.mask, self.posted_writes
        # Executed posted writes without a fence may be before the oldest request, or after it.
        return max(in_flight, self.next - posted.first & self.mask) if posted.executed else in_flight

    @property
    def bytes(self) -> int:
        """Characters of the requests whose execution is not confirmed."""
        run = self.slots[self.executed]
        if run is None or self.executed == self.next:
            return 0
        return self._sent - run.before - (self.executed - run.first & self.mask) * run.size

    def is_idle(self) -> bool:
        """Return whether no request is in flight."""
        return self.next == self.oldest and not self.posted_writes.executed

    def has_one_request(self) -> bool:
        """Return whether exactly one request is in flight."""
        return self.next - self.oldest & self.mask == 1

    # Sending

    def bound_answers(self, room_of_answers: Callable[[], int]) -> None:
        """Limit the bytes of answers in flight to the number that a function returns."""
        self.room_of_answers = room_of_answers
        self._free = 0

    def room(self, size: int, *, posted: bool = False, reply_size: int = 0) -> int:
        """Return how many more requests of `size` characters with answers of `reply_size` may be sent now.

        If there are posted writes, one place stays reserved for the ``h`` that confirms them.
        """
        if self.retransmission.is_due():
            return 0
        kept_free = posted or self.posted_writes.unfenced
        # Requests that are unconfirmed, or executed and unanswered, may have to be retransmitted.
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
        """Return how many such requests may be sent while the window is idle."""
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
            # Cache the number: answers only increase it, and `_repeat` clears it. Reserve one place for an ``h``.
            self._free = room - 1
        return room > 0

    def send(self, run: R, now: float) -> None:
        """Assign IDs to a run that is sent now. The caller has checked `room`; an ``h`` needs none."""
        first, count, retransmission = self.next, run.count, self.retransmission
        run.first = first
        run.sending = retransmission.sent
        retransmission.sent += count
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
            self.posted_writes.sent_after(run, self.next)
        trip = self.round_trip
        if trip.timed is None and now >= trip.next_measurement:
            trip.begin(first, now, self.bytes, run.reply_size)

    def needs_fence(self, now: float) -> bool:
        """Return whether an ``h`` is due: the posted writes without one are old, or a quarter of the window or FIFO."""
        posted, send_limit = self.posted_writes, self.send_limit
        limit = send_limit.byte_limit
        return (
            posted.unfenced
            and (
                4 * (self.next - posted.start & self.mask) >= send_limit.allowed
                or now >= posted.due
                or (limit is not None and 4 * (self._sent - posted.before) >= limit)
            )
            and not self.retransmission.is_due()
        )

    def repeat(self) -> list[Part[R]]:
        """Return the requests to retransmit now, in order."""
        start = self.retransmission.start
        least = self.open(self.oldest, self.after_next_with_answer(self.oldest))
        return self.retransmission.take(max(self.send_limit.allowed, least) - self.open(self.oldest, start))

    def unanswered(self, refused: int | None = None) -> Iterator[Unanswered[R]]:
        """Return all requests that are not done, in order, with their outcomes at the end of the session.

        Args:
            refused: ID of the request that a gateway without a session has refused (error 0A with the right residue);
                requests that were first sent after its last transmission are not executed.
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

    def has_no_loss(self) -> bool:
        """Return whether no loss is suspected: no answer is missing, and no request in flight was retransmitted."""
        retransmission = self.retransmission
        return (
            self.oldest == self.executed
            and retransmission.start == retransmission.end
            and not retransmission.awaits()
            and not self.round_trip.has_backed_off
            and self.loss.place == NEVER
        )

    def acknowledge_in_order(self, count: int, now: float) -> None:
        """Record the answers to the oldest `count` requests while `has_no_loss` is true; none was answered before."""
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
        """Record the answers to the `count` unanswered IDs from `number` on.

        Raises:
            ValueError: if one of these IDs has no unanswered request.
        """
        last, after = number + count - 1 & self.mask, number + count & self.mask
        run, beginning = self.slots[last], self.slots[number]
        if run is None or beginning is None:
            raise ValueError(f"no request with ID {number} waits for an answer")
        if number == self.oldest and self.has_no_loss():
            self.acknowledge_in_order(count, now)
            return
        trip, retransmission = self.round_trip, self.retransmission
        if trip.timed is not None and trip.timed - number & self.mask < count:
            trip.end(now)
        # Without retransmissions, the answer to the oldest request shows no loss.
        may_show_loss = retransmission.awaits() or number != self.oldest
        is_needed = may_show_loss or self.loss.place != NEVER
        place = self._answered_place(beginning, number, run, last) if is_needed else NEVER
        if trip.has_backed_off and retransmission.sending(run, last) == retransmission.first_sending(run, last):
            trip.end_backoff()
        self._confirm(number)
        if self.distance(after) > self.distance(self.executed):
            self.executed = after
        self.fill(number, count, None)
        if self.send_limit.loses:
            self.send_limit.came_through(count)
        self._news(now)
        if may_show_loss:
            self._find_lost(place, now)
        elif place != NEVER:
            retransmission.arrived(place)
            if place >= self.loss.place:
                self.loss.place = NEVER

    def _answered_place(self, beginning: R, number: int, run: R, last: int) -> int:
        """Return the transmission number of the last of some IDs, all of which are answered now."""
        retransmission = self.retransmission
        place = retransmission.answered_sending(beginning, number)
        if last != number:
            # The answers to the later IDs belong to later transmissions.
            retransmission.answered = max(retransmission.answered, place)
            place = retransmission.answered_sending(run, last)
        return place

    def fence_answered(self, number: int, failed: int, now: float) -> bool:
        """Record the answer to an ``h``; return whether the outcomes of all posted writes before it are known now.

        They are if the gateway counts as many failed writes as error responses arrived. Otherwise each posted write is
        asked for by an ``h`` with its ID, and the fence is retransmitted after these questions: at once, or, if they
        were asked before, as soon as an answer shows that they are lost.

        Args:
            number: ID of the ``h``.
            failed: number of failed posted writes of the session, modulo the number of IDs.
            now: instant of arrival.
        """
        posted, retransmission = self.posted_writes, self.retransmission
        self._confirm(number)
        if self.executed == number:
            self.executed = number + 1 & self.mask
        first, executed = posted.first, posted.take_executed(number, self.mask)
        asked = []
        if self.open(self.oldest, number):
            asked = [part for part in self.parts(self.oldest, number) if part.run.is_question]
        if not executed and not asked:
            return True
        if failed == posted.failed:
            for part in asked:
                self.answered(part.number, part.length, now)
            return True
        run = self.slots[number]
        assert run is not None
        place = retransmission.answered_sending(run, number)
        retransmission.arrived(place)
        again = [part.number for part in asked if retransmission.is_lost(part.number, place)]
        if executed:
            for part in parts_of(executed, first, self.mask):
                self.fill(part.number, part.length, part.run.question(part.offset, part.length))
            if self.distance(first) > self.mask >> 1:
                # Move `oldest` back to the first question, unless an earlier ``h`` has moved it further.
                self.oldest = first
            again.append(first)
        if not again:
            # The answers to the questions are in flight, and will show that this answer precedes them.
            self.since = now
            return False
        self.loss.timed_out = False
        self._repeat(min(again, key=self.distance), number + 1 & self.mask, now)
        return False

    def post_failed(self) -> None:
        """Record that the error response to a posted write arrived."""
        self.posted_writes.failed = self.posted_writes.failed + 1 & self.mask

    def query_answered(self, now: float) -> None:
        """Record the answer to a session query. Frames that were sent before it will not be answered any more."""
        retransmission = self.retransmission
        place = retransmission.query_answered()
        if place == NEVER or self.next == self.oldest:
            return
        if self.loss.ignores_signs():
            retransmission.arrived(place)
            return
        self._find_lost(place, now)
        if retransmission.in_doubt and retransmission.queries:
            # The answers to queries are alike: if a query was lost, this one answered a later query. Send another one.
            retransmission.doubt()

    def out_of_sequence(self, expected: int, now: float) -> bool:
        """Record ``n i``: the gateway expects the ID `expected`, so a request is lost.

        Returns:
            False if no gateway expects this ID in this session, because it is before `executed` or after `next`.
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
            # The gateway executes no later request before the lost one, so the first transmission of that one is lost.
            self.retransmission.arrived(self.retransmission.first_sending(run, expected))
            if self.loss.takes(self.retransmission.answered):
                self._go_back(now)
        return True

    def damaged(self, now: float) -> None:
        """Record ``X01``, ``X07`` or ``X09``: a request arrived damaged."""
        self._go_back(now)

    def answer_damaged(self, now: float) -> None:
        """Record a damaged frame: perhaps the answer to the oldest request that was sent once."""
        retransmission = self.retransmission
        if not self.loss.takes(retransmission.answered):
            retransmission.doubt()
            return
        start = retransmission.first_sent_once()
        end = self.after_next_with_answer(start)
        if start == end:
            self._go_back(now)
        elif not retransmission.includes(start):
            self.loss.timed_out = False
            self._repeat(start, end, now)
            if self.distance(start) >= self.distance(self.executed):
                # If the damaged frame was an error or ``n``, the retransmission gets no answer: a query decides.
                retransmission.doubt()

    def refused(self, now: float) -> R | None:
        """Record ``X02`` or ``X03``; return the run of the oldest request if it is given up now, otherwise None."""
        given_up = None
        if self.oldest != self.next and self.oldest == self.executed and self.loss.takes(self.retransmission.answered):
            if self.loss.refused():
                given_up = self._give_up()
            self._go_back(now)
        return given_up

    # Time

    @property
    def deadline(self) -> float | None:
        """Instant at which `expire` must be called, or a fence is due; None while the window is idle."""
        posted, repeating = self.posted_writes, self.retransmission.is_due()
        if posted.unfenced and not repeating and not 0 < self.distance(posted.mark) <= self.unanswered_count:
            # Only posted writes are in flight, which have no answer: wait for the time of their fence.
            return posted.due
        if self.next == self.oldest:
            return None
        expiry = self.since + self.round_trip.time_out(self.bytes, self._next_reply_size())
        return expiry if repeating else min(expiry, posted.due)

    @property
    def longest_answer(self) -> float:
        """Seconds until the answer to the oldest request is late, if the request is sent now; without backoff."""
        return self.round_trip.longest(self.bytes, self._next_reply_size())

    def resume(self, now: float) -> None:
        """Restart the timeout, because the slot on a half-duplex line began in which the retransmission is sent."""
        self.since = now

    def expire(self, now: float) -> R | None:
        """Go back if the timeout has passed; return the run of the oldest request if it is given up now.

        `needs_fence` handles fences that are due.
        """
        deadline = self.deadline
        if (
            deadline is None
            or now < deadline
            or (deadline == self.posted_writes.due and not self.retransmission.is_due())
        ):
            return None
        # Back off even if bytes were heard: they may be the beginning of a long answer on a slow line.
        self.round_trip.back_off()
        self.retransmission.queries.clear()
        given_up = self._give_up() if self.loss.time_out(now, self.since) else None
        self._repeat_from_oldest(now)
        return given_up

    # The inside

    def _next_reply_size(self) -> int:
        """Return the characters of the next answer, 0 if none is expected."""
        if self.distance(self._unawaited) > self.unanswered_count:
            self._unawaited = self.oldest
        last = self.after_next_with_answer(self._unawaited) - 1 & self.mask
        run = self.slots[last]
        self._unawaited = last
        return 0 if run is None else run.reply_size

    def _confirm(self, expected: int) -> bool:
        """Move `executed` to an ID unless it is beyond it; return whether it moved. Keep the posted writes passed."""
        if self.distance(expected) <= self.distance(self.executed):
            return False
        number, runs = self.executed, self.between(self.executed, expected)
        self.executed = expected
        different = set(runs)
        others = {run for run in different if run is None or not run.posted}
        if len(others) < len(different):
            executed = [None if run in others else run for run in runs] if others else runs
            self.posted_writes.keep(number, executed, self.mask)
            self.put(number, [run if run in others else None for run in runs] if others else [None] * len(runs))
            if self.send_limit.loses:
                self.send_limit.came_through(len(executed) - executed.count(None))
        return True

    def _news(self, now: float) -> None:
        """Move `oldest` past the requests that are done, and restart the timeout."""
        self.loss.news()
        self.since = now
        if self.advance():
            self.loss.moved()
            if not self.loss.timed_out:
                # The window went back for a sign of loss, not a timeout, so this is no late answer: the timeout holds.
                self.round_trip.end_backoff()
            self.retransmission.follow()

    def _give_up(self) -> R | None:
        given_up = self.slots[self.oldest]
        if given_up is not None:
            # It is sent as an ``h`` from now on, which has an answer.
            given_up.posted = False
        self.loss.give_up()
        return given_up

    def _go_back(self, now: float) -> None:
        """Go back for a sign of loss. If the sign may belong to the previous loss, send a session query instead."""
        if self.oldest == self.next:
            return
        if self.loss.takes(self.retransmission.answered):
            self.loss.timed_out = False
            self._repeat_from_oldest(now)
        else:
            self.retransmission.doubt()

    def _find_lost(self, place: int, now: float) -> None:
        """Retransmit the unanswered requests that were sent before a frame whose answer arrived: they are lost.

        If the gateway has executed them, only their answers are lost, and the answers to later requests are in flight.

        Args:
            place: transmission number of the frame whose answer arrived.
            now: instant of arrival.
        """
        retransmission = self.retransmission
        retransmission.arrived(place)
        if not retransmission.is_any() and not retransmission.is_due():
            self.loss.place = NEVER
        if not retransmission.is_lost(self.oldest, place):
            return
        self.loss.timed_out = False
        if retransmission.is_lost(self.executed, place):
            self._repeat_from_oldest(now)
            return
        end = self.oldest
        while end != self.executed and (self.slots[end] is None or retransmission.is_lost(end, place)):
            end = end + 1 & self.mask
        self._repeat(self.oldest, end, now)

    def _repeat_from_oldest(self, now: float) -> None:
        self.loss.go_back(self.retransmission.sent)
        self.send_limit.lose()
        self._repeat(self.oldest, self.next, now)

    def _repeat(self, start: int, end: int, now: float) -> None:
        """Plan the retransmission of unanswered requests from `start` to before `end`, in addition to those planned."""
        self.retransmission.begin(start, end)
        self._free, self._unawaited = 0, self.oldest
        self.round_trip.timed = None
        self.since = now


def _with_outcome(parts: Iterable[Part[R]], outcome: Outcome) -> Iterator[Unanswered[R]]:
    for _, run, offset, count in parts:
        yield Unanswered(run, offset, count, outcome)

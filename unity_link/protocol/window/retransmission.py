"""Retransmission: which requests to send again, and the order of all transmissions.

1. Each transmission has a number, counted from 0 like the packet numbers of RFC 9002: first transmissions,
   retransmissions and session queries (`K`) share one count. In the code this number is a *place*.
2. Both directions keep the order of frames. So an answer to transmission n shows that unanswered requests whose last
   transmission is before n are lost, or their answers are.
3. An answer does not say which transmission of its request it answers. The earliest one after the last known arrival is
   assumed, which never declares too much lost.
4. The answer to a session query is unlike any other, so it shows how far the gateway has received.
"""

from __future__ import annotations

from typing import Generic

from unity_link.protocol.window.constants import MOST_QUESTIONS, MOST_SENDINGS
from unity_link.protocol.window.sequence_space import Part, R, SequenceSpace

NEVER = -1
"""Number before that of the first transmission."""


class Retransmission(Generic[R]):
    """The IDs to send again, and the numbers of their transmissions.

    Args:
        ids: the sequence space of the requests.
    """

    __slots__ = ("_after", "_again", "_ids", "answered", "end", "in_doubt", "must_query", "queries", "sent",
                 "start")  # fmt: skip

    def __init__(self, ids: SequenceSpace[R]) -> None:
        self._ids = ids
        self.start = self.end = ids.next
        """IDs to send again: from `start` to before `end`; none if they are equal."""
        self.sent = 0
        """Number of transmissions so far, which is the number of the next one."""
        self.answered = NEVER
        """Number of the last transmission that arrived for certain, while some request was sent more than once."""
        self._again: dict[int, list[int]] = {}
        """Numbers of the retransmissions of each ID, in order. Those before the first transmission of the ID's run are
        left from an earlier request with the same ID."""
        self._after = ids.next
        """ID after the last one that was sent again, or is to be."""
        self.queries: list[int] = []
        """Numbers of the session queries whose answers may still arrive."""
        self.in_doubt = False
        """True if a sign of loss arrived that may belong to the last loss or to a new one."""
        self.must_query = False
        """True if another session query is due, because the last one may be lost as well."""

    def is_due(self) -> bool:
        """Return whether there are requests to send again."""
        return self.start != self.end

    def is_any(self) -> bool:
        """Return whether a request in flight was sent again."""
        return bool(self._again)

    def awaits(self) -> bool:
        """Return whether a request in flight was sent again, or a session query is unanswered."""
        return bool(self._again or self.queries)

    def begin(self, start: int, end: int) -> None:
        """Plan to send the IDs from `start` to before `end` again, in addition to those already planned."""
        distance = self._ids.distance
        if self.start != self.end:
            start, end = min(self.start, start, key=distance), max(self.end, end, key=distance)
        self.start, self.end = start, end
        self.in_doubt = self.must_query = False
        if not self._again or distance(end) > distance(self._after):
            self._after = end

    def take(self, room: int) -> list[Part[R]]:
        """Return the requests to send again now, at most `room`, and number their transmissions."""
        parts: list[Part[R]] = []
        for part in self._ids.parts(self.start, self.end):
            number, run, offset, count = part
            if room <= 0:
                break
            count = min(count, room)
            room -= count
            parts.append(Part(number, run, offset, count))
            for place in range(count):
                again = self._again.setdefault(number + place & self._ids.mask, [])
                again.append(self.sent + place)
                del again[:-MOST_SENDINGS]
            self.sent += count
            self.start = number + count & self._ids.mask
        if not self._ids.open(self.start, self.end):
            self.start = self.end
        return parts

    def first_sent_once(self) -> int:
        """Return the first ID in flight after all IDs that were sent again."""
        ids = self._ids
        again = (self._again or self.is_due()) and ids.distance(self._after) <= ids.unanswered_count
        return self._after if again else ids.oldest

    def follow(self) -> None:
        """Remove requests that are done from the plan, after `oldest` has moved."""
        ids = self._ids
        if self.start != self.end and ids.distance(self.start) > ids.unanswered_count:
            self.start = ids.oldest
            if ids.distance(self.end) > ids.unanswered_count:
                self.end = ids.oldest

    def doubt(self) -> None:
        """Record a sign that may belong to the last loss or to a new one; another session query decides."""
        self.in_doubt = True
        self.must_query = len(self.queries) < MOST_QUESTIONS

    def query_sent(self) -> None:
        """Record the transmission of a session query."""
        self.must_query = False
        # Beyond this number of unanswered queries, an answer counts as the answer to an earlier query.
        if len(self.queries) < MOST_QUESTIONS:
            self.queries.append(self.sent)
        self.sent += 1

    def query_answered(self) -> int:
        """Return the number of the first unanswered session query and remove it; `NEVER` if there is none."""
        return self.queries.pop(0) if self.queries else NEVER

    def arrived(self, place: int) -> None:
        """Record that each transmission up to a number has arrived, or is lost.

        If no request in flight was sent again, forget the retransmissions.
        """
        self.answered = max(self.answered, place)
        while self.queries and self.queries[0] <= place:
            del self.queries[0]
        ids = self._ids
        if self._again and not 0 < ids.distance(self._after) <= ids.unanswered_count:
            self._again.clear()

    def first_sending(self, run: R, number: int) -> int:
        """Return the number of the first transmission of a request."""
        return run.sending + (number - run.first & self._ids.mask)

    def sending(self, run: R, number: int) -> int:
        """Return the number of the last transmission of a request."""
        first, again = self.first_sending(run, number), self._again.get(number)
        return max(first, again[-1]) if again else first

    def answered_sending(self, run: R, number: int) -> int:
        """Return the number of the transmission that an answer belongs to: the first after the last known arrival.

        If the answer belongs to a later transmission, it shows less than it could, but nothing wrong.
        """
        first = self.first_sending(run, number)
        if first > self.answered:
            return first
        sent_after = (place for place in self._again.get(number, ()) if place > self.answered)
        return next(sent_after, self.sending(run, number))

    def is_lost(self, number: int, place: int) -> bool:
        """Return whether a request is unanswered, its last transmission is before `place`, and it is not planned."""
        run = self._ids.slots[number]
        return run is not None and self.sending(run, number) < place and not self.includes(number)

    def includes(self, number: int) -> bool:
        """Return whether a request is planned to be sent again."""
        mask = self._ids.mask
        return number - self.start & mask < self.end - self.start & mask

    def never_arrived_from(self, refused: int) -> int:
        """Return the first ID in flight that was not sent before the last transmission of the refused request.

        A gateway without a session has received that transmission, so it has executed no request from this ID on.
        """
        ids = self._ids
        run, number = ids.slots[refused], refused
        if run is None or ids.distance(refused) >= ids.unanswered_count:
            return ids.next
        last = self.sending(run, refused)
        while number != ids.next and (run is None or self.first_sending(run, number) < last):
            number = number + 1 & ids.mask
            run = ids.slots[number]
        return number

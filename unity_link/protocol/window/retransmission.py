"""The requests that are sent again, and the order in which all were sent.

Both directions keep the order. So an answer says that what was sent before the request that it answers, and is not
answered, will not be: it or its answer was lost. Each sending has a place among all; a `K` that asks for the session
stands among them, and its answer, which is like no other, says how far the line has come.
"""

from __future__ import annotations

from typing import Generic

from unity_link.protocol.window.constants import MOST_QUESTIONS, MOST_SENDINGS
from unity_link.protocol.window.sequence_space import Part, R, SequenceSpace

NEVER = -1
"""Place before that of the first sending."""


class Retransmission(Generic[R]):
    """IDs that are to be sent again, and the places of what was sent.

    Args:
        ring: whose requests they are.
    """

    __slots__ = ("_again", "_behind", "_ring", "answered", "end", "in_doubt", "must_ask", "questions", "sent",
                 "start")  # fmt: skip

    def __init__(self, ring: SequenceSpace[R]) -> None:
        self._ring = ring
        self.start = self.end = ring.next
        """The IDs that are to be sent again: from one mark on and before the other; none where they are equal."""
        self.sent = 0
        """Number of sendings."""
        self.answered = NEVER
        """Place of the last sending that is known to have arrived, while some were sent more than once."""
        self._again: dict[int, list[int]] = {}
        """Places of the later sendings of those that were sent again, by ID, in order; of an earlier lap where they
        are before that of the run."""
        self._behind = ring.next
        """ID behind the last that was sent again, or is to be."""
        self.questions: list[int] = []
        """Places of the `K` whose answers may still come."""
        self.in_doubt = False
        """True if a sign has come that may be of the loss before or of the next one."""
        self.must_ask = False
        """True if one more `K` is to be sent, for the one before may have been lost as well."""

    def is_due(self) -> bool:
        """Return whether something is to be sent again."""
        return self.start != self.end

    def is_any(self) -> bool:
        """Return whether something in flight was sent again."""
        return bool(self._again)

    def awaits(self) -> bool:
        """Return whether something in flight was sent again, or a `K` is not answered."""
        return bool(self._again or self.questions)

    def begin(self, start: int, end: int) -> None:
        """Let all be sent again from `start` on and before `end`, besides what already is to be."""
        distance = self._ring.distance
        if self.start != self.end:
            start, end = min(self.start, start, key=distance), max(self.end, end, key=distance)
        self.start, self.end = start, end
        self.in_doubt = self.must_ask = False
        if not self._again or distance(end) > distance(self._behind):
            self._behind = end

    def take(self, room: int) -> list[Part[R]]:
        """Return what is to be sent again now, of `room` requests."""
        parts: list[Part[R]] = []
        for part in self._ring.parts(self.start, self.end):
            number, run, offset, count = part
            if room <= 0:
                break
            count = min(count, room)
            room -= count
            parts.append(Part(number, run, offset, count))
            for place in range(count):
                again = self._again.setdefault(number + place & self._ring.mask, [])
                again.append(self.sent + place)
                del again[:-MOST_SENDINGS]
            self.sent += count
            self.start = number + count & self._ring.mask
        if not self._ring.open(self.start, self.end):
            self.start = self.end
        return parts

    def first_sent_once(self) -> int:
        """Return the first ID in flight from which on nothing was sent again."""
        ring = self._ring
        again = (self._again or self.is_due()) and ring.distance(self._behind) <= ring.unanswered_count
        return self._behind if again else ring.oldest

    def follow(self) -> None:
        """Leave out what is done since."""
        ring = self._ring
        if self.start != self.end and ring.distance(self.start) > ring.unanswered_count:
            self.start = ring.oldest
            if ring.distance(self.end) > ring.unanswered_count:
                self.end = ring.oldest

    def doubt(self) -> None:
        """Record a sign that may be of the loss before or of the next one; one more `K` will tell."""
        self.in_doubt = True
        self.must_ask = len(self.questions) < MOST_QUESTIONS

    def ask(self) -> None:
        """Record that a `K` is sent."""
        self.must_ask = False
        # Where more are not answered, an answer counts as that to an earlier one.
        if len(self.questions) < MOST_QUESTIONS:
            self.questions.append(self.sent)
        self.sent += 1

    def told(self) -> int:
        """Return the place that a `K` had which is answered, or of an earlier one."""
        return self.questions.pop(0) if self.questions else NEVER

    def arrived(self, place: int) -> None:
        """Record that all up to a sending has arrived, or was lost; where nothing in flight was sent again, forget."""
        self.answered = max(self.answered, place)
        while self.questions and self.questions[0] <= place:
            del self.questions[0]
        ring = self._ring
        if self._again and not 0 < ring.distance(self._behind) <= ring.unanswered_count:
            self._again.clear()

    def first_sending(self, run: R, number: int) -> int:
        """Return the place of the first sending of a request."""
        return run.sending + (number - run.first & self._ring.mask)

    def sending(self, run: R, number: int) -> int:
        """Return the place of the last sending of a request."""
        first, again = self.first_sending(run, number), self._again.get(number)
        return max(first, again[-1]) if again else first

    def answered_sending(self, run: R, number: int) -> int:
        """Return the place of the sending that is answered now: the first behind what is known to have arrived.

        An answer to the next one may be taken for one to it, which says less of the others, and nothing wrong.
        """
        first = self.first_sending(run, number)
        if first > self.answered:
            return first
        sent_after = (place for place in self._again.get(number, ()) if place > self.answered)
        return next(sent_after, self.sending(run, number))

    def is_lost(self, number: int, place: int) -> bool:
        """Return whether a request waits for its answer, and was sent before what has arrived now."""
        run = self._ring.slots[number]
        return run is not None and self.sending(run, number) < place and not self.includes(number)

    def includes(self, number: int) -> bool:
        """Return whether a request is to be sent again."""
        mask = self._ring.mask
        return number - self.start & mask < self.end - self.start & mask

    def never_arrived_from(self, refused: int) -> int:
        """Return the first ID in flight that was first sent when the refused request was sent last, or later."""
        ring = self._ring
        run, number = ring.slots[refused], refused
        if run is None or ring.distance(refused) >= ring.unanswered_count:
            return ring.next
        last = self.sending(run, refused)
        while number != ring.next and (run is None or self.first_sending(run, number) < last):
            number = number + 1 & ring.mask
            run = ring.slots[number]
        return number

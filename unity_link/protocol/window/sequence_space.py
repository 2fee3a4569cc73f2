"""The sequence space: the IDs of a session, and the unanswered request of each.

IDs count modulo 16**id_digits. The host keeps three marks:

        answered         executed, but some        sent, and            not yet
                         answers are lost          not confirmed        sent
    ----------------|------------------------|---------------------|-------------
                  oldest                  executed                 next

- `oldest` is the ID of the oldest request that is not done: its answer or its confirmation is missing.
- `executed` is the lowest ID that the gateway may expect: a response to ID k confirms that all requests before k are
  executed, and ``n i`` confirms it for all before i.
- `next` is the ID of the next request.
"""

from __future__ import annotations

from itertools import groupby
from typing import TYPE_CHECKING, Generic, NamedTuple, Self, TypeVar

if TYPE_CHECKING:
    from collections.abc import Iterator


class Run:
    """One or more requests of equal size that hold consecutive IDs.

    A single request is a run of one. The requests of a long run are numbered, sent and answered in one step.
    """

    __slots__ = ("before", "count", "first", "posted", "reply_size", "sending", "size")
    is_fence = False
    """True for an ``h`` whose answer counts the posted writes that failed."""
    places = 0
    """Words of a destructive read, which the gateway stores for retransmissions."""
    is_question = False
    """True for an ``h`` that asks for the outcome of a posted write with the same ID."""

    def __init__(self, count: int, size: int, reply_size: int) -> None:
        self.first = 0
        """ID of the first request; the window sets it."""
        self.sending = 0
        """Transmission number of the first request, when it was first sent; the window sets it."""
        self.before = 0
        """Characters of all requests of the session before this run; the window sets it."""
        self.count = count
        """Number of requests."""
        self.size = size
        """Characters of each request."""
        self.reply_size = reply_size
        """Characters of each answer; 0 for posted writes, which have none."""
        self.posted = reply_size == 0

    def question(self, offset: int, count: int) -> Self:
        """Return the run that asks for the outcomes of `count` posted writes of this run, from `offset` on."""
        raise NotImplementedError


R = TypeVar("R", bound=Run)


class Part(NamedTuple, Generic[R]):
    """Consecutive requests of a run."""

    number: int
    """ID of the first request."""
    run: R
    offset: int
    """Position of the first request in the run."""
    length: int
    """Number of requests."""


class SequenceSpace(Generic[R]):
    """The three marks, and the unanswered run of each ID.

    Args:
        size: number of IDs.
        first: first ID of the session.
    """

    __slots__ = ("executed", "mask", "next", "oldest", "slots")

    def __init__(self, size: int, first: int) -> None:
        self.mask = size - 1
        self.slots: list[R | None] = [None] * size
        """Run of each ID with an unanswered request; None for other IDs."""
        self.oldest = self.executed = self.next = first

    @property
    def unanswered_count(self) -> int:
        """Number of IDs from `oldest` to before `next`; some of them may be answered."""
        return self.next - self.oldest & self.mask

    def distance(self, number: int) -> int:
        """Return the number of IDs from `oldest` to `number`."""
        return number - self.oldest & self.mask

    def find(self, number: int) -> R | None:
        """Return the run of an unanswered ID, or None: the answer to another ID is stale."""
        return self.slots[number]

    def between(self, first: int, last: int) -> list[R | None]:
        """Return the runs of the IDs from `first` to before `last`; None for each ID without an unanswered request."""
        slots = self.slots
        return slots[first:last] if first <= last else slots[first:] + slots[:last]

    def open(self, first: int, last: int) -> int:
        """Return the number of unanswered IDs from `first` to before `last`."""
        between = self.between(first, last)
        return len(between) - between.count(None)

    def alike(self, number: int, count: int) -> int:
        """Return how many consecutive IDs from `number` on belong to the same run, at most `count`."""
        runs = self.between(number, number + count & self.mask)
        if runs.count(runs[0]) == count:
            return count
        return next(place for place, run in enumerate(runs) if run is not runs[0])

    def fill(self, first: int, count: int, run: R | None) -> None:
        """Assign a run to `count` IDs from `first` on; None marks them as answered."""
        self.put(first, [run] * count)

    def put(self, first: int, runs: list[R | None]) -> None:
        """Assign one run to each ID from `first` on; None marks an ID as answered."""
        before_wrap = min(len(runs), self.mask + 1 - first)
        self.slots[first : first + before_wrap] = runs[:before_wrap]
        self.slots[: len(runs) - before_wrap] = runs[before_wrap:]

    def parts(self, position: int, last: int) -> Iterator[Part[R]]:
        """Return the unanswered parts of runs, from the ID `position` to before the ID `last`."""
        return parts_of(self.between(position, last), position, self.mask)

    def after_next_with_answer(self, position: int) -> int:
        """Return the ID after the next unanswered request from `position` on that is no posted write.

        It is `next` if there is none.
        """
        slots, mask, end = self.slots, self.mask, self.next
        while position != end:
            run = slots[position]
            if run is None:
                position = position + 1 & mask
            elif run.posted:
                position = run.first + run.count & mask
            else:
                return position + 1 & mask
        return end

    def advance(self) -> bool:
        """Move `oldest` past the requests that are done; return whether it moved."""
        before = self.oldest
        between = self.between(before, self.executed)
        done = len(between)
        if between.count(None) != done:
            done = next(place for place, run in enumerate(between) if run is not None)
        self.oldest = before + done & self.mask
        return done > 0


def parts_of(runs: list[R | None], number: int, mask: int) -> Iterator[Part[R]]:
    """Return the parts of runs, given the run of each ID from `number` on; None for an answered ID."""
    for run, same in groupby(runs):
        count = len(list(same))
        if run is not None:
            yield Part(number, run, number - run.first & mask, count)
        number = number + count & mask

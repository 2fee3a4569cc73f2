"""The IDs of a session on their ring, and what waits for answers to them.

IDs go round a ring of 16**id_digits numbers, on which the host keeps three marks:

        answered         executed, but some        sent, and            not yet
                         answers were lost         not confirmed        sent
    ----------------|------------------------|---------------------|-------------
                  oldest                  executed                 next

- `oldest` is the oldest request that still wants something: its answer, or the news that it was executed.
- `executed` is what the gateway is known to expect at least: a response to ID k says that all before k were executed,
  and ``n i`` says the same of all before i.
- `next` is the ID that the next request gets.
"""

from __future__ import annotations

from itertools import groupby
from typing import TYPE_CHECKING, Generic, NamedTuple, Self, TypeVar

if TYPE_CHECKING:
    from collections.abc import Iterator


class Run:
    """One or more requests of equal size that hold consecutive IDs.

    A single request is a run of one. A run of many lets a batch be numbered, sent and answered in one step.
    """

    __slots__ = ("before", "count", "first", "posted", "reply_size", "sending", "size")
    is_fence = False
    """True of an ``h``, the answer to which counts the posted writes that failed."""
    places = 0
    """Words that the gateway keeps, for they cannot be read again."""
    is_question = False
    """True of an ``h`` that asks how a posted write ended."""

    def __init__(self, count: int, size: int, reply_size: int) -> None:
        self.first = 0
        """The first ID, given by the window."""
        self.sending = 0
        """Place of the first request among all that were sent, given by the window."""
        self.before = 0
        """Characters of all requests of the session before the first, given by the window."""
        self.count = count
        """Number of requests."""
        self.size = size
        """Characters of each."""
        self.reply_size = reply_size
        """Characters of the answer to each; 0 where there is none: a posted write."""
        self.posted = reply_size == 0

    def question(self, offset: int, count: int) -> Self:
        """Return the run that asks how some posted writes of this one ended."""
        raise NotImplementedError


R = TypeVar("R", bound=Run)


class Part(NamedTuple, Generic[R]):
    """Some requests of a run that follow each other."""

    number: int
    """ID of the first."""
    run: R
    offset: int
    """Its place in the run."""
    length: int
    """The number of them."""


class SequenceSpace(Generic[R]):
    """The marks, and the run that waits for the answer to each ID.

    Args:
        size: number of IDs.
        first: the first ID of the session.
    """

    __slots__ = ("executed", "mask", "next", "oldest", "slots")

    def __init__(self, size: int, first: int) -> None:
        self.mask = size - 1
        self.slots: list[R | None] = [None] * size
        """Runs by ID; None where nothing waits."""
        self.oldest = self.executed = self.next = first

    @property
    def unanswered_count(self) -> int:
        """Number of IDs from the oldest on that were sent."""
        return self.next - self.oldest & self.mask

    def distance(self, number: int) -> int:
        """Return how far an ID is behind the oldest."""
        return number - self.oldest & self.mask

    def find(self, number: int) -> R | None:
        """Return the run that an answer names, or None where nothing waits for it (a stale answer)."""
        return self.slots[number]

    def between(self, first: int, last: int) -> list[R | None]:
        """Return what waits for answers to the IDs from `first` on and before `last`."""
        slots = self.slots
        return slots[first:last] if first <= last else slots[first:] + slots[:last]

    def open(self, first: int, last: int) -> int:
        """Return how many IDs wait for answers, from `first` on and before `last`."""
        between = self.between(first, last)
        return len(between) - between.count(None)

    def alike(self, number: int, count: int) -> int:
        """Return how many IDs from one on, of so many at most, wait for answers to the same run."""
        runs = self.between(number, number + count & self.mask)
        if runs.count(runs[0]) == count:
            return count
        return next(place for place, run in enumerate(runs) if run is not runs[0])

    def fill(self, first: int, count: int, run: R | None) -> None:
        """Let a run wait for the answers to some IDs, or nothing."""
        self.put(first, [run] * count)

    def put(self, first: int, runs: list[R | None]) -> None:
        """Let these wait for the answers to the IDs from `first` on, each to one; None is nothing."""
        before_lap = min(len(runs), self.mask + 1 - first)
        self.slots[first : first + before_lap] = runs[:before_lap]
        self.slots[: len(runs) - before_lap] = runs[before_lap:]

    def parts(self, position: int, last: int) -> Iterator[Part[R]]:
        """Return the parts of runs that wait for answers from one ID on and before another."""
        return parts_of(self.between(position, last), position, self.mask)

    def behind_next_with_answer(self, position: int) -> int:
        """Return the ID behind the next request that has an answer; that of the next where all are posted writes."""
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
        """Move the oldest mark up over what is done; return whether it moved."""
        before = self.oldest
        between = self.between(before, self.executed)
        done = len(between)
        if between.count(None) != done:
            done = next(place for place, run in enumerate(between) if run is not None)
        self.oldest = before + done & self.mask
        return done > 0


def parts_of(runs: list[R | None], number: int, mask: int) -> Iterator[Part[R]]:
    """Return the parts of the runs that stand for the IDs from `number` on, each for one; None is nothing."""
    for run, same in groupby(runs):
        count = len(list(same))
        if run is not None:
            yield Part(number, run, number - run.first & mask, count)
        number = number + count & mask

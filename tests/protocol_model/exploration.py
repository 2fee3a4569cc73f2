"""Explores every state that a small model can reach, breadth first, so that the trace to a fault is the shortest."""

from collections.abc import Callable, Hashable, Iterator
from typing import NamedTuple, TypeAlias, TypeVar

S = TypeVar("S", bound=Hashable)


class Fault(NamedTuple):
    """The end of a trace in a forbidden state."""

    what: str


Moves: TypeAlias = Callable[[S], Iterator[tuple[str, "S | Fault"]]]


class Exploration(NamedTuple):
    """Result of an exploration."""

    states: int
    fault: str | None
    """The first fault that was found, or None."""
    trace: tuple[str, ...]
    """The steps to the fault, as few as possible."""
    ends: int
    """Number of final states: every request has an outcome."""

    def __str__(self) -> str:
        if self.fault is None:
            return f"{self.states} states, {self.ends} of them ends, nothing wrong"
        steps = "\n".join(f"  {number:2} {step}" for number, step in enumerate(self.trace, 1))
        return f"{self.fault}, in {len(self.trace)} steps, after {self.states} states\n{steps}"


def explore(
    start: S, moves: Moves[S], is_end: Callable[[S], bool], *, always_ends: bool = True, sought: str = ""
) -> Exploration:
    """Explore the states that can be reached from `start`.

    Args:
        start: the first state.
        moves: yields every step that is possible in a state, each with the next state or a fault.
        is_end: returns true for a final state, in which every request has an outcome.
        always_ends: if true, a state from which no final state can be reached is a fault.
        sought: a part of the text of the fault to find; other faults are passed over.
    """
    states = [start]
    known = {start: 0}
    came_from: list[tuple[int, str]] = [(-1, "")]
    before: list[list[int]] = [[]]
    for index, state in enumerate(states):
        for step, after in moves(state):
            if isinstance(after, Fault):
                if sought not in after.what:
                    continue
                return Exploration(len(states), after.what, (*_trace(came_from, index), step), 0)
            found = known.get(after)
            if found is None:
                known[after] = found = len(states)
                states.append(after)
                came_from.append((index, step))
                before.append([])
            if always_ends:
                before[found].append(index)
    ends = [index for index, state in enumerate(states) if is_end(state)]
    if always_ends:
        stuck = _never_ends(before, ends)
        if stuck is not None:
            return Exploration(len(states), "there is no way to an end", _trace(came_from, stuck), len(ends))
    return Exploration(len(states), None, (), len(ends))


def _trace(came_from: list[tuple[int, str]], index: int) -> tuple[str, ...]:
    """Return the steps that first reached a state."""
    steps = []
    while index:
        index, step = came_from[index]
        steps.append(step)
    return tuple(reversed(steps))


def _never_ends(before: list[list[int]], ends: list[int]) -> int | None:
    """Return the index of the first state from which no final state can be reached, or None."""
    can_end = bytearray(len(before))
    pending = list(ends)
    for index in ends:
        can_end[index] = True
    while pending:
        for index in before[pending.pop()]:
            if not can_end[index]:
                can_end[index] = True
                pending.append(index)
    first = can_end.find(0)
    return None if first < 0 else first

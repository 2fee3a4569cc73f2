"""The words by which a schedule is told what to write, and when."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

TIME = 1 << 40
"""Instants are modulo this."""
AHEAD = TIME // 2
"""Ticks that are more than an instant can be ahead of the clock: the gateway takes one further ahead for a past one."""
BEHIND = TIME // 4
"""Ticks by which an instant can have passed when its words are made; they may be under way for as long again."""
FRAME = 2
"""Words of a batch beside its runs: a header, and the lower part of the instant."""
MOST_WORDS = 255
"""Words that the runs of a batch can have."""
FATES = 48
"""Batches whose end can be read."""


def batch_of(instant: int, words: Mapping[int, int]) -> list[int]:
    """Return the words of a batch.

    Args:
        instant: cycle of the clock in which the values stand in their registers.
        words: 32 bits for each place on the stage.
    """
    runs: list[int] = []
    head = previous = -1
    for place in sorted(words):
        if place != previous + 1 or head < 0:
            head = len(runs)
            runs.append(place)
        runs[head] += 1 << 16
        runs.append(words[place])
        previous = place
    instant %= TIME
    return [len(runs) << 24 | instant >> 32, instant & 0xFFFF_FFFF, *runs]


def values_of(runs: Sequence[int]) -> dict[int, int] | None:
    """Return the words of runs by their places on the stage; None where they are malformed."""
    values: dict[int, int] = {}
    rest = list(runs)
    while rest:
        count, first = rest[0] >> 16, rest[0] & 0xFFFF
        if not 0 < count < len(rest):
            return None
        values |= {(first + index) % (1 << 16): word for index, word in enumerate(rest[1 : count + 1])}
        rest = rest[count + 1 :]
    return values


def cycles_to(instant: int, now: int) -> int:
    """Return the cycles to an instant, negative for one that has passed."""
    return (instant - now + TIME // 2) % TIME - TIME // 2

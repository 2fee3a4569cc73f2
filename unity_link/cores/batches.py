"""Words of batches: they define which signals a schedule writes, and at which instant."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

TIME = 1 << 40
"""Instants are counted modulo this number of clock cycles."""
AHEAD = TIME // 2
"""Clock cycles by which an instant can never be ahead of the clock: the gateway would take it for a past one."""
BEHIND = TIME // 4
"""Cycles by which an instant may have passed when its words are made; they may be in flight for as long again."""
FRAME = 2
"""Words of a batch without its runs: a header, and the lower part of the instant."""
MOST_WORDS = 255
"""Most words in the runs of a batch."""
FATES = 48
"""Number of batches whose outcome can be read."""


def batch_of(instant: int, words: Mapping[int, int]) -> list[int]:
    """Return the words of a batch.

    Args:
        instant: clock cycle from which the values are in their registers.
        words: words of 32 bits by their places on the stage.
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
    """Return the words of runs by their places on the stage; None if the runs are malformed."""
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
    """Return the clock cycles until an instant; negative for a past one."""
    return (instant - now + TIME // 2) % TIME - TIME // 2

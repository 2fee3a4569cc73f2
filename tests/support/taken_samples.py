"""Samples as a gateway took them, with losses on the line, and as a host that was suspended at times reads them."""

from __future__ import annotations

import itertools
import random
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from hypothesis import strategies as st

from unity_link.link.gateway_clock import tolerance_of

if TYPE_CHECKING:
    from collections.abc import Sequence

TURN = 1 << 32
BASE_HZ = 1000
ROUND = 256
"""Number of samples after which sequence numbers repeat."""


class Taken(NamedTuple):
    """A sample as the gateway took it."""

    instant: float
    group: int
    number: int
    ticks: int

    def body(self) -> bytes:
        return b"P%02X%02X%08X%08X" % (self.group, self.number % 256, self.ticks % TURN, self.number % TURN)


def is_decidable(advance: int, period: float, turn: float) -> bool:
    """Return True if no smaller advance has the same sequence number and timestamp; otherwise a host cannot choose."""
    rate_hz = 1 / period
    allowed = 2 * (tolerance_of(rate_hz, turn) + 1e-6 * advance) / rate_hz
    fewer = np.arange(advance % 256 or 256, advance, 256)
    off = ((advance - fewer) * period + turn / 2) % turn - turn / 2
    return bool((abs(off) > allowed).all())


READS = st.lists(
    st.tuples(
        st.sampled_from([0.01, 0.3, 5.0, 30.0, 61.0, 150.0]),
        st.sampled_from([0, 0, 0, 1, 3, 200, 255, 256, 257, 5000]),
        st.sampled_from(["one by one", "together", "rows"]),
    ),
    min_size=2,
    max_size=6,
)
"""Reads. Each has the seconds of suspension before it, the number of samples that are lost, and how the rest is passed
on."""
CLOCKS = (50_000_000, 100_000_000, 99_999_937, 4_294_967_295)
"""In Hz."""
_LATE = 95e-6
"""Seconds by which a busy bus delays a sample."""
BEGAN = st.integers(0, TURN - 1 - round(_LATE * max(CLOCKS)))
"""First timestamps. The first sample never wraps around, even if it is late, because no host could detect that."""
STORIES = {"reads": READS, "clock_hz": st.sampled_from(CLOCKS), "began": BEGAN, "seed": st.integers(0, 1000)}
"""Strategies for the arguments of `arrivals_of`, without the divisors."""


class Arrival(NamedTuple):
    """Samples that a host reads at once."""

    now: float
    taken: list[Taken]
    way: str


def arrivals_of(
    reads: Sequence[tuple[float, int, str]], clock_hz: int, divisors: list[int], began: int, seed: int
) -> list[Arrival]:
    """Return the samples of groups that a host reads, read by read.

    Args:
        reads: one of `READS`.
        clock_hz: of the gateway.
        divisors: of the groups, one each.
        began: the gateway's first timestamp, one of `BEGAN`.
        seed: chooses the samples that are lost or late.
    """
    chance, now = random.Random(seed), 0.0
    numbers = [0] * len(divisors)
    arrivals = []
    for stands_still, lost, way in [(0.01, 0, "one by one"), *reads]:
        now += stands_still
        arriving = []
        for group, divisor in enumerate(divisors):
            period = divisor / BASE_HZ
            taken = []
            while numbers[group] * period <= now:
                # The bus may be busy when a sample is due.
                instant = numbers[group] * period + chance.choice([0, 0, 0, _LATE])
                taken.append(Taken(instant, group, numbers[group], began + round(instant * clock_hz)))
                numbers[group] += 1
            first = chance.randrange(max(1, len(taken) - lost))
            arriving += taken[:first] + taken[first + lost :] if lost < len(taken) else taken
        if arriving:
            arrivals.append(Arrival(now, sorted(arriving), way))
    return arrivals


def of_group(arrivals: list[Arrival], group: int) -> list[Taken]:
    """Return the samples of a group that arrived."""
    return [one for arrival in arrivals for one in arrival.taken if one.group == group]


def are_decidable(came: list[Taken], divisor: int, clock_hz: int) -> bool:
    """Return True if sequence numbers and timestamps of a group leave one possibility only."""
    advances = [after.number - before.number for before, after in itertools.pairwise(came)]
    return all(advance <= ROUND or is_decidable(advance, divisor / BASE_HZ, TURN / clock_hz) for advance in advances)

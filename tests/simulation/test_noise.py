"""The cost of noise on simulated time: time-outs, in which the host waits in vain, and retransmitted requests."""

from __future__ import annotations

import statistics

import pytest

import unity_link
from simulation.sendings import watched
from support.simulated_time import run_simulated

READS = 10_000
SEEDS = range(1, 5)
CONNECTIONS = 500


async def read_batch(flip: float, seed: int) -> int:
    """Read a batch on a line that damages bytes in both directions; return the number of time-outs."""
    async with unity_link.connect(f"sim:?flip={flip}&seed={seed}", timeout=60) as link:
        before = link.statistics.timeouts
        await link.read_many([1] * READS)
        return link.statistics.timeouts - before


@pytest.mark.slow
@pytest.mark.parametrize(
    ("flip", "most"),
    [
        # If one in four tries fails, as with 29 bytes in both directions, some of 10,000 requests need seven or more.
        (0.01, 13),
        (0.001, 9),
    ],
)
def test_a_batch_on_a_noisy_line_rarely_waits_and_repeats_few_requests_often(flip: float, most: int) -> None:
    with watched() as sendings:
        timeouts = [run_simulated(read_batch(flip, seed)) for seed in SEEDS]
    assert statistics.mean(timeouts) <= 0.5
    assert max(timeouts) <= 2
    assert sendings.most <= most


@pytest.mark.campaign
def test_connect_succeeds_on_a_line_that_damages_one_byte_in_twenty() -> None:
    async def connect(seed: int) -> bool:
        try:
            async with unity_link.connect(f"sim:?flip=0.05&seed={seed}"):
                return True
        except unity_link.ConnectError:
            return False

    assert sum(run_simulated(connect(seed)) for seed in range(CONNECTIONS)) >= 0.99 * CONNECTIONS

"""On a line that loses and damages bytes, each failed write is reported and each event that a read removes is seen."""

from __future__ import annotations

import asyncio
import itertools
import random

import pytest

import unity_link
from support.events_read import CLEARED, QUEUE, Cleared, Numbers
from support.makers import BUS_ERROR, BUS_TIMEOUT, COMPACT, RTL, SLOW, Maker, compiled, simulated, with_failing
from support.simulated_time import run_simulated
from unity_link import BusError, BusTimeoutError, Link
from unity_link.virtual.faults import Noise, NoisyLine

LOSS = 0.002
DAMAGE = 0.01
MAKERS = {"sim": simulated, "rtl": compiled}
ON_BOTH = pytest.mark.parametrize("kind", ["sim", RTL])
FORMS = pytest.mark.parametrize("compact", [False, True], ids=["text", "compact"])


def maker_of(kind: str, *, compact: bool) -> tuple[Maker, dict[str, int]]:
    """Return a maker of gateways, and the fields to build one with."""
    return MAKERS[kind], COMPACT if compact else SLOW


async def write_some(link: Link, draw: random.Random) -> int:
    """Write and post concurrently, and check the reported errors; return the number of failed writes and posts."""
    failing = {BUS_ERROR: BusError, BUS_TIMEOUT: BusTimeoutError}
    addresses = [draw.choice([BUS_ERROR, BUS_TIMEOUT, 1, 2]) for _ in range(draw.randrange(1, 40))]
    done = await asyncio.gather(*(link.write(address, 5) for address in addresses), return_exceptions=True)
    assert [type(error) for error in done] == [failing.get(address, type(None)) for address in addresses]
    posted = [draw.choice([BUS_ERROR, 1, 2, 3]) for _ in range(draw.randrange(1, 40))]
    for address in posted:
        await link.post(address, 6)
    reported = 0
    try:
        await link.fence()
    except BusError as error:
        notes = [int(note.split()[0]) for note in getattr(error, "__notes__", ())]
        reported = 1 + sum(notes)
    assert reported == posted.count(BUS_ERROR)
    return reported + sum(address in failing for address in addresses)


@pytest.mark.parametrize("amount", [300, pytest.param(30_000, marks=pytest.mark.campaign)])
@FORMS
@ON_BOTH
def test_no_failed_write_or_post_is_reported_as_done_if_bytes_are_lost(
    kind: str, amount: int, *, compact: bool
) -> None:
    async def run() -> None:
        make, fields = maker_of(kind, compact=compact)
        gateway, draw, failed = with_failing(make(**fields)), random.Random(3), 0
        async with unity_link.connect(NoisyLine(gateway, Noise(1, loss=LOSS), Noise(2, loss=LOSS))) as link:
            while failed < amount:
                failed += await write_some(link, draw)
            assert link.statistics.repetitions

    run_simulated(run())


@pytest.mark.parametrize("amount", [2_000, pytest.param(100_000, marks=pytest.mark.campaign)])
@FORMS
@ON_BOTH
def test_no_event_that_a_read_clears_is_lost_if_bytes_are_damaged(kind: str, amount: int, *, compact: bool) -> None:
    async def run() -> None:
        make, fields = maker_of(kind, compact=compact)
        gateway, draw, cleared = make(**fields), random.Random(4), Cleared()
        gateway.attach(Numbers(), [QUEUE])
        gateway.attach(cleared, [CLEARED])
        seen: list[int] = []
        line = NoisyLine(gateway, Noise(1, flip=DAMAGE), Noise(2, flip=DAMAGE))
        async with unity_link.connect(line) as link:
            while len(seen) < amount:
                counts = [draw.randrange(1, 9) for _ in range(draw.randrange(1, 12))]
                *words, bits = await asyncio.gather(
                    *(link.read_queue(QUEUE, count) for count in counts), link.read_queue(CLEARED, 1)
                )
                seen += itertools.chain.from_iterable(part.tolist() for part in words)
                assert bits.tolist() == [cleared.made.popleft()]
                assert not cleared.made
            assert link.statistics.repetitions
        assert seen == list(range(1, len(seen) + 1))

    run_simulated(run())

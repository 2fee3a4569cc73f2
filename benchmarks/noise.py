"""How much of a link's rate remains on a line that damages bytes, and does `connect` succeed? `make bench-noise`.

Each rate is compared with that of the undisturbed line in the same run. The gateway is the model behind `NoisyLine`, in
this process, so that only error recovery makes a difference.
"""

from __future__ import annotations

import argparse
import asyncio
import datetime as dt
import statistics
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import unity_link
from benchmarks.__main__ import machine
from benchmarks.measure import seconds
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Noise, NoisyLine

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable

    from unity_link import Link

RESULTS = Path(__file__).with_name("NOISE.md")
RUNS = 7
BATCH = 10_000
TASKS = 64
LONE_READS = 1000
CONNECTIONS = 500
TOGETHER = 5
WORST = 0.05


async def batch(link: Link) -> None:
    """Read in one batch."""
    await link.read_many([0x10] * BATCH)


async def tasks(link: Link) -> None:
    """Read in many tasks at once."""

    async def task() -> None:
        for _ in range(BATCH // TASKS):
            await link.read(0x10)

    await asyncio.gather(*[task() for _ in range(TASKS)])


async def lone(link: Link) -> None:
    """Read one after the other."""
    for _ in range(LONE_READS):
        await link.read(0x10)


class Question(NamedTuple):
    """Question about a noisy line."""

    text: str
    work: Callable[[Link], Awaitable[None]]
    damaged: float
    """Share of the bytes that are damaged, in each direction."""
    least: float
    """Share of the undisturbed rate that must remain."""


QUESTIONS = (
    Question(f"a batch of {BATCH:,} reads", batch, 0.01, 0.1),
    Question(f"{TASKS} tasks that read", tasks, 0.01, 0.4),
    Question("lone reads", lone, 0.01, 0.1),
    Question("lone reads", lone, 0.001, 0.7),
)


async def share_left(question: Question) -> tuple[float, float, float]:
    """Return the medians over the runs: seconds on the quiet line and on the noisy one, and their ratio."""
    pairs = []
    for run in range(RUNS):
        pair = []
        for damaged in (0.0, question.damaged):
            line = NoisyLine(VirtualGateway(), Noise(2 * run, flip=damaged), Noise(2 * run + 1, flip=damaged))
            # A long timeout, because only the rate after the connection is measured.
            async with unity_link.connect(line, timeout=60) as link:
                pair.append(await seconds(question.work(link)))
        pairs.append((pair[0], pair[1], pair[0] / pair[1]))
    quiet, noisy, share = (statistics.median(column) for column in zip(*pairs, strict=True))
    return quiet, noisy, share


async def connects(seed: int) -> bool:
    """Return whether `connect` succeeds within its default timeout."""
    line = NoisyLine(VirtualGateway(), Noise(2 * seed, flip=WORST), Noise(2 * seed + 1, flip=WORST))
    try:
        link = await unity_link.connect(line)
    except unity_link.ConnectError:
        return False
    await link.aclose()
    return True


async def connections() -> int:
    """Return the number of seeds for which `connect` succeeds. It mostly waits, so several run at once."""
    successes = 0
    for first in range(0, CONNECTIONS, TOGETHER):
        successes += sum(await asyncio.gather(*map(connects, range(first, min(first + TOGETHER, CONNECTIONS)))))
    return successes


async def rows() -> list[str]:
    """Measure, and return the rows of the table."""
    found = []
    for question in QUESTIONS:
        quiet, noisy, share = await share_left(question)
        found.append(
            f"| {question.text} | {question.damaged:.1%} | {1000 * quiet:,.0f} ms | {1000 * noisy:,.0f} ms "
            f"| {share:.0%} | at least {question.least:.0%} | {'yes' if share >= question.least else '**no**'} |"
        )
    successes = await connections()
    met = "yes" if successes >= 0.99 * CONNECTIONS else "**no**"
    found.append(f"| `connect` | {WORST:.1%} | | | {successes} of {CONNECTIONS} | at least 99% | {met} |")
    return found


def main() -> None:
    """Measure, and write the table."""
    argparse.ArgumentParser(prog="python -m benchmarks.noise", description=__doc__).parse_args()
    text = "\n".join(
        (
            "# Noisy lines",
            "",
            "A share of the bytes is damaged, in both directions, between the link and the model in the same process.",
            f"Medians of {RUNS} runs, each paired with an undisturbed one. `make bench-noise` runs them again.",
            "",
            f"Seen on {dt.datetime.now(dt.UTC):%Y-%m-%d}: {machine()}.",
            "",
            "| What | damaged | undisturbed | disturbed | rate left | target | met |",
            "|---|---|---|---|---|---|---|",
            *asyncio.run(rows()),
            "",
        )
    )
    RESULTS.write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()

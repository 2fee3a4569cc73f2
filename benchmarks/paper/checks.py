"""Conditions that the experiment's figures must meet."""

from __future__ import annotations

from typing import TYPE_CHECKING

from benchmarks.paper.results import RHYTHMS, Check, Results
from benchmarks.paper.stacks import ACCESSES

if TYPE_CHECKING:
    from collections.abc import Iterator

LINK_MBITS = 64.0
"""Megabits per second for 8 MB/s in one direction."""


def check(results: Results) -> list[Check]:
    """Compare the figures with their limits."""
    return [*_check_gateware(results), *_check_latencies(results), *_check_throughputs(results), *_check_rest(results)]


def _most(what: str, found: float, limit: float, unit: str, *, measured: bool = False) -> Check:
    wanted = f"at most {limit:,.2f} {unit}"
    return Check(what=what, found=f"{found:,.2f} {unit}", wanted=wanted, met=found <= limit, measured=measured)


def _least(what: str, found: float, limit: float, unit: str, *, measured: bool = False) -> Check:
    wanted = f"at least {limit:,.2f} {unit}"
    return Check(what=what, found=f"{found:,.2f} {unit}", wanted=wanted, met=found >= limit, measured=measured)


def _check_gateware(results: Results) -> Iterator[Check]:
    figures = results.gateware
    if figures is None:
        return
    yield _most("gateware, read", figures.microseconds(figures.read_cycles), 0.60, "µs")
    yield _most("gateware, write", figures.microseconds(figures.write_cycles), 0.45, "µs")
    yield _most("gateware, write to its effect", figures.microseconds(figures.effect_cycles), 0.16, "µs")
    yield _most("gateware, posted write to its effect", figures.microseconds(figures.post_effect_cycles), 0.16, "µs")
    yield _least("gateware, pipelined reads", 8e-6 * figures.bytes_per_cycle * figures.clock_hz, 390, "Mb/s")


def _check_latencies(results: Results) -> Iterator[Check]:
    for rhythm in RHYTHMS:
        off, always, adaptive = (
            results.latency("full stack", "read", mode, rhythm) for mode in ("off", "always", "adaptive")
        )
        for row in (always, adaptive):
            what = f"read through the link, {rhythm}, send-immediate {row.send_immediate}"
            yield _most(what, row.total.median, 260, "µs", measured=True)
        floors = off.total.median / off.modelled.median
        what = f"read through the link, {rhythm}, without send-immediate"
        yield _most(what, floors, 1.10, "floors", measured=True)
        ratio = adaptive.total.median / always.total.median
        yield _most(f"read, {rhythm}, adaptive to always", ratio, 1.05, "", measured=True)


def _check_throughputs(results: Results) -> Iterator[Check]:
    reads = results.throughput("full stack", "read", "adaptive")
    posts = results.throughput("full stack", "post", "adaptive")
    for what, row, share in (("read_many", reads, 0.90), ("post_many", posts, 0.95)):
        least = share * LINK_MBITS
        yield _least(f"{what}, adaptive, modelled", row.megabits(row.modelled), least, "Mb/s")
        yield _least(f"{what}, adaptive", row.megabits(row.total), least, "Mb/s", measured=True)
    for access in ACCESSES:
        off, adaptive = (results.throughput("full stack", access, mode) for mode in ("off", "adaptive"))
        yield _least(f"{access}s in bursts, adaptive to off, modelled", adaptive.modelled / off.modelled, 0.95, "")
        ratio = adaptive.total / off.total
        yield _least(f"{access}s in bursts, adaptive to off", ratio, 0.95, "", measured=True)


def _check_rest(results: Results) -> Iterator[Check]:
    sustained = results.sustained
    yield Check(
        what=f"one word, published for {sustained.seconds:.2f} s",
        found=f"{sustained.rate / 1e3:.2f} kHz, {sustained.lost} lost",
        wanted="at least 30.00 kHz, 0 lost",
        met=sustained.rate >= 30_000 and not sustained.lost,
        measured=True,
    )

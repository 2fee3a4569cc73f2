"""The paper's Table I with our figures: a row for each level and figure."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, NamedTuple

from benchmarks.paper import published
from benchmarks.paper.checks import LINK_MBITS
from benchmarks.paper.gateware import POST_BYTES, READ_BYTES, WRITE_BYTES
from benchmarks.paper.latency import BURST
from benchmarks.paper.results import STACKS, Spread
from benchmarks.paper.stacks import BLOCK_WORDS

if TYPE_CHECKING:
    from collections.abc import Iterator

    from benchmarks.paper.published import Figure, Level
    from benchmarks.paper.results import GatewareFigures, Results
    from benchmarks.paper.stacks import Access, Mode, StackName

Operation = Literal["read", "block", "write", "post", "publish"]
NOTHING = "–"  # noqa: RUF001  (a dash, as tables have it)
TITLES: dict[Operation, str] = {
    "read": "Read",
    "block": f"RM of {BLOCK_WORDS} words",
    "write": "Write, answered",
    "post": "Write, posted",
    "publish": "Publish, one word",
}
COLUMNS: dict[published.Mode, tuple[Mode, Mode]] = {"off": ("off, 1 ms", "off"), "always": ("always", "adaptive")}
"""Our columns for the paper's modes, without and with its send-immediate."""
HEADS: dict[Mode, str] = {
    "off, 1 ms": "timer of 1 ms",
    "off": "timer of 16 ms",
    "always": "always",
    "adaptive": "adaptive",
}


class Row(NamedTuple):
    """One figure of one level."""

    level: Level
    what: str
    known: Figure | None
    """The paper's figure."""
    kind: Literal["clock-exact", "modelled, measured"]
    found: tuple[str, ...]
    """Our figure: a clock-exact one, or, for each of the two columns, the modelled one and the one with the program."""


def table_1(results: Results, operation: Operation, mode: published.Mode) -> Iterator[Row]:
    """Yield the rows of a subtable: one of the paper's, or, in the same form, one that the paper does not have."""
    if results.gateware is not None:
        yield from _gateware(results.gateware, operation, mode)
    yield from _ideal(results, operation, mode)
    for stack in STACKS:
        yield from _stack(results, operation, mode, stack)


def spread(found: Spread) -> str:
    """Format mean, standard deviation and median."""
    return f"{found.mean:,.1f} µs (sd {found.deviation:,.1f}; median {found.median:,.1f})"


def _exact(level: Level, what: str, operation: Operation, mode: published.Mode, text: str) -> Row:
    return Row(level, what, _known(what, level, operation, mode), "clock-exact", (text,))


def _known(what: str, level: Level, operation: Operation, mode: published.Mode) -> Figure | None:
    return published.find(what, level, operation, mode) if operation in ("read", "write") else None


def _gateware(figures: GatewareFigures, operation: Operation, mode: published.Mode) -> Iterator[Row]:
    def time(cycles: int) -> str:
        return f"{figures.microseconds(cycles):.2f} µs"

    def rates(sizes: tuple[int, int], cycles: float) -> Iterator[Row]:
        for what, size in zip((published.REQUESTS, published.ANSWERS), sizes, strict=True):
            if size:
                yield _exact("gateware", what, operation, mode, f"{figures.megabits(size, cycles):.1f} Mb/s")

    if operation == "read":
        yield _exact("gateware", published.LATENCY, operation, mode, time(figures.read_cycles))
        yield from rates(READ_BYTES, figures.cycles_per_read)
    elif operation == "write":
        yield _exact("gateware", published.LATENCY, operation, mode, time(figures.write_cycles))
        yield _exact("gateware", published.EFFECT, operation, mode, time(figures.effect_cycles))
        yield from rates(WRITE_BYTES, figures.cycles_per_write)
    elif operation == "post":
        yield _exact("gateware", published.EFFECT, operation, mode, time(figures.post_effect_cycles))
        yield from rates(POST_BYTES, figures.cycles_per_post)
    elif operation == "block":
        for block in figures.blocks:
            words = f"{block.words} words" if block.words > 1 else "1 word"
            text = f"{time(block.first_cycles)} to the first byte, {time(block.last_cycles)} to the last"
            yield _exact("gateware", f"{published.LATENCY}, {words}", operation, mode, text)
    else:
        one = figures.publishing[0]
        yield _exact("gateware", "from the instant of the sample to its last byte", operation, mode, time(one.cycles))


def _ideal(results: Results, operation: Operation, mode: published.Mode) -> Iterator[Row]:
    if operation in ("read", "block", "write"):
        gateware = results.latency("low-level", operation, "always").gateware
        if gateware is not None:
            yield _exact("ideal link", published.LATENCY, operation, mode, f"{gateware:.2f} µs")
    what = published.LINE
    yield Row(
        "ideal link", what, _known(what, "ideal link", operation, mode), "clock-exact", (f"{LINK_MBITS:.1f} Mb/s",)
    )


def _stack(results: Results, operation: Operation, mode: published.Mode, stack: StackName) -> Iterator[Row]:
    modes = COLUMNS[mode]

    def row(what: str, *cells: tuple[str, str], of_paper: str | None = None) -> Row:
        known = _known(what if of_paper is None else of_paper, stack, operation, mode)
        return Row(stack, what, known, "modelled, measured", tuple(cell for pair in cells for cell in pair))

    if operation == "publish":
        arrivals = {row.send_immediate: row for row in results.arrivals if row.stack == stack}
        pairs = [(spread(arrivals[each].modelled), spread(arrivals[each].total)) for each in modes]
        yield row("from the instant of the sample to the program", *pairs)
        return
    access: Access = operation
    if access != "post":
        latencies = [results.latency(stack, access, each) for each in modes]
        yield row(published.LATENCY, *((spread(each.modelled), spread(each.total)) for each in latencies))
        both = [(each.synchronous(each.modelled), each.synchronous(each.total)) for each in latencies]
        yield row(published.SYNCHRONOUS, *((_kilobits(modelled), _kilobits(total)) for modelled, total in both))
    if stack == "full stack" and (clock := _wall_clock(results, access, modes)):
        yield row("the same by the clock on the wall", *clock, of_paper=NOTHING)
    if access in ("write", "post"):
        effects = [results.effect(stack, access, each) for each in modes]
        yield row(published.EFFECT, *((spread(each.modelled), spread(each.total)) for each in effects))
        periods = [(each.burst_modelled, each.burst_total) for each in effects]
        yield row(published.BURST_PERIOD, *((f"{first:.3f} µs", f"{second:.3f} µs") for first, second in periods))
        bits = 8 * effects[0].request_bytes
        rates = [(f"{bits / first:.1f} Mb/s", f"{bits / second:.1f} Mb/s") for first, second in periods]
        yield row(published.BURST_REQUESTS, *rates)
    if access == "read":
        least = round(published.value(published.MOST_REQUESTS, "low-level", "read", mode))
        bursts = [results.burst(stack, each, least) for each in modes]
        cells = [(each.megabits(each.modelled), each.megabits(each.total)) for each in bursts]
        yield row(
            f"answers of a burst of {bursts[0].count}",
            *((f"{first:.2f} Mb/s", f"{second:.2f} Mb/s") for first, second in cells),
            of_paper=published.BURST_ANSWERS,
        )
    long = [results.throughput(stack, access, each) for each in modes]
    rates = [(f"{each.megabits(each.modelled):.1f} Mb/s", f"{each.megabits(each.total):.1f} Mb/s") for each in long]
    yield row("requests of a long burst" if access in ("write", "post") else "answers of a long burst", *rates)


def _wall_clock(results: Results, access: Access, modes: tuple[Mode, Mode]) -> list[tuple[str, str]]:
    found = {row.send_immediate: spread(row.taken) for row in results.wall_clock if row.access == access}
    return [(NOTHING, found.get(mode, NOTHING)) for mode in modes] if found else []


def _kilobits(megabits: float) -> str:
    return f"{megabits * 1e3:,.1f} kb/s"


assert published.value("a burst", "low-level", "write") == BURST

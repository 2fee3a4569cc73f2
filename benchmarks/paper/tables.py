"""The experiment as Markdown: the figures beside the paper's, their kinds, and the model's parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING

from benchmarks.paper import published
from benchmarks.paper.checks import LINK_MBITS

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from benchmarks.paper.results import Check, GatewareFigures, Latency, PublishLimit, Results, Throughput

NOTHING = "–"  # noqa: RUF001  (a dash, as tables have it)
_PUBLISHED_LATENCIES = {
    ("low-level", "read", "always"): published.LOW_LEVEL_READ_US,
    ("full stack", "read", "always"): published.FULL_STACK_READ_US,
}
_PUBLISHED_THROUGHPUTS = {
    ("low-level", "read", "off"): published.LOW_LEVEL_READS_MBITS,
    ("low-level", "read", "always"): published.LOW_LEVEL_READS_IMMEDIATE_MBITS,
    ("low-level", "write", "off"): published.LOW_LEVEL_WRITES_MBITS,
    ("low-level", "write", "always"): published.LOW_LEVEL_WRITES_IMMEDIATE_MBITS,
}
_ACCESSES = {"read": "read", "write": "write, answered", "post": "write, posted"}
Row = tuple[str, ...]


def to_markdown(results: Results, pictures: Sequence[tuple[str, str]] = ()) -> str:
    """Return the whole page.

    Args:
        results: what was found.
        pictures: titles and addresses of those to show.
    """
    parts = [_head(results)]
    if results.gateware is not None:
        parts.append(_gateware(results.gateware))
    parts += [_latencies(results.latencies), _throughputs(results.throughputs), _publishing(results)]
    parts += [f"![{title}]({address})\n" for title, address in pictures]
    parts += [_checks(results), _parameters(results)]
    return "\n".join(parts)


def table(head: Row, rows: Iterable[Row]) -> str:
    """Return a Markdown table."""
    lines = [head, ("---",) * len(head), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def latency_rows(latencies: Iterable[Latency]) -> Iterator[Row]:
    """Return stack, access, rhythm, mode; the clock-exact, modelled and measured parts; the sum; the paper's figure."""
    for row in latencies:
        gateware = row.gateware or 0.0
        # Without hurry, no place in the microframe is special; back to back, the paper measured.
        known = _PUBLISHED_LATENCIES.get((row.stack, row.access, row.send_immediate))
        yield (
            row.stack,
            _ACCESSES[row.access],
            row.rhythm,
            row.send_immediate,
            NOTHING if row.gateware is None else f"{gateware:.2f}",
            f"{row.modelled - gateware:,.1f}",
            f"{row.total - row.modelled:+,.1f}",
            f"{row.total:,.1f}",
            NOTHING if known is None or row.rhythm != "back to back" else f"{known:,.1f}",
        )


def throughput_rows(throughputs: Iterable[Throughput]) -> Iterator[Row]:
    """Return stack, access, mode; the rate modelled and with the program's time, its part of 64 Mb/s; the paper's."""
    for row in throughputs:
        known = _PUBLISHED_THROUGHPUTS.get((row.stack, row.access, row.send_immediate))
        yield (
            row.stack,
            _ACCESSES[row.access],
            row.send_immediate,
            f"{row.modelled:.1f}",
            f"{row.total:.1f}",
            f"{row.total / LINK_MBITS:.0%}",
            NOTHING if known is None else f"{known:g}",
        )


def gateware_rows(figures: GatewareFigures) -> Iterator[Row]:
    """Return what, cycles, time or rate, and the paper's figure."""
    for what, cycles, known in (
        ("read: last byte in to last byte out", figures.read_cycles, published.GATEWARE_READ_US),
        ("write: last byte in to last byte out", figures.write_cycles, published.GATEWARE_WRITE_US),
        ("write: last byte in to its effect on the bus", figures.effect_cycles, published.GATEWARE_EFFECT_US),
    ):
        yield what, str(cycles), f"{figures.microseconds(cycles):.2f} µs", f"{known} µs"
    rate = 8e-6 * figures.bytes_per_cycle * figures.clock_hz
    per_byte = f"{figures.bytes_per_cycle:.3f} bytes a cycle"
    yield "pipelined reads: answers", per_byte, f"{rate:.0f} Mb/s", f"{published.GATEWARE_READS_MBITS} Mb/s"


def publish_rows(limits: Iterable[PublishLimit]) -> Iterator[Row]:
    """Return words and bytes of a message; kHz of the line, modelled and with the program's time."""
    for limit in limits:
        rates = (f"{rate / 1e3:,.2f}" for rate in (limit.line, limit.modelled, limit.total))
        yield str(limit.words), str(limit.message_bytes), *rates


def check_rows(checks: Iterable[Check]) -> Iterator[Row]:
    """Return what, found, wanted, and whether it is met."""
    for check in checks:
        yield check.what, check.found, check.wanted, "yes" if check.met else "NO"


def _head(results: Results) -> str:
    behind = "the gateware itself" if results.parameters.gateway == "rtl" else "a model of the gateware"
    quick = "**A quick run, of too few accesses to be quoted.**\n\n" if results.parameters.quick else ""
    return f"""# The paper's experiment, again

{quick}Written by `make table1` (`python -m benchmarks.paper`), unity-link {results.version}, {results.date}, on
{results.parameters.machine}.

The virtual FT232H with {behind} behind it, through `ftdi-async://`:
*low-level* is the driver's transport alone, *full stack* the whole link. *Clock-exact* is counted on the RTL,
*modelled* is the time of USB and chip, *measured* the processor time of the program on this machine, and what it makes
the program wait for the USB. How that is done, and what it leaves out: [docs/paper.md](../docs/paper.md).
{NOTHING}: the paper's figure is not known here, or it has none.
"""


def _gateware(figures: GatewareFigures) -> str:
    head = ("clock-exact (RTL)", "cycles", f"at {figures.clock_hz / 1e6:g} MHz", "paper")
    text = "## The gateware alone\n\nAt the port of its FIFOs; the bus answers in the cycle after it was asked.\n\n"
    return text + table(head, gateware_rows(figures))


def _latencies(latencies: Sequence[Latency]) -> str:
    head = (
        "stack",
        "access",
        "when",
        "send-immediate",
        "clock-exact (RTL), µs",
        "modelled (USB), µs",
        "measured (program), µs",
        "together, µs",
        "paper, µs",
    )
    return "## One access\n\nMedians, of the best of several runs.\n\n" + table(head, latency_rows(latencies))


def _throughputs(throughputs: Sequence[Throughput]) -> str:
    head = (
        "stack",
        "accesses",
        "send-immediate",
        "clock-exact and modelled, Mb/s",
        "measured as well, Mb/s",
        "of 64 Mb/s",
        "paper, Mb/s",
    )
    text = (
        "Mb/s of what fills the line: answers of reads, requests of writes. The best of several runs. The paper's "
        "bursts were of 200 and more reads, of 18 with send-immediate, and of 30 writes."
    )
    return f"## Long bursts\n\n{text}\n\n" + table(head, throughput_rows(throughputs))


def _publishing(results: Results) -> str:
    head = (
        "words",
        "bytes a message",
        "8 MB/s carry, kHz",
        "clock-exact and modelled, kHz",
        "measured as well, kHz",
    )
    sustained = results.sustained
    text = (
        f"\nOne word at {sustained.rate / 1e3:.2f} kHz for {sustained.seconds:.2f} s, taken by `async for`: "
        f"{sustained.samples:,} samples, {sustained.lost} lost.\n"
    )
    base = results.parameters.base_frequency / 1e6
    title = f"## The limit of publishing\n\nThe highest of the rates {base:g} MHz / n at which no sample is lost.\n\n"
    return title + table(head, publish_rows(results.publish_limits)) + text


def _checks(results: Results) -> str:
    return "## What must hold\n\n" + table(("what", "found", "wanted", "met"), check_rows(results.checks))


def _parameters(results: Results) -> str:
    values = results.parameters
    rows: list[Row] = [(f"`Timing.{name}`", f"{value:g}") for name, value in values.timing.items()]
    rows += [
        (
            "gateway",
            f"{values.id_digits} digits of ID, {values.data_bits} bits a word, {values.address_bits} an address",
        ),
        ("its FIFOs", f"{values.receive_fifo_bytes} bytes in, {values.transmit_fifo_bytes} out"),
        ("driver", f"{values.posted_reads} reads of {values.read_size} bytes posted"),
    ]
    text = "## Parameters\n\nSeconds and bytes; where each is from stands in `unity_link/virtual/ft232h/timing.py`.\n\n"
    return text + table(("what", "value"), rows)

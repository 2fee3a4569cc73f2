"""The experiment as Markdown: the figures beside the paper's, their kinds, and the model's parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING

from benchmarks.paper import published
from benchmarks.paper.checks import LINK_MBITS
from benchmarks.paper.publishing import BURST
from benchmarks.paper.results import STACKS
from benchmarks.paper.table_1 import COLUMNS, HEADS, NOTHING, TITLES, table_1

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from benchmarks.paper.results import (
        Burst,
        Check,
        FormFigures,
        GatewareFigures,
        Latency,
        Lines,
        MediumFigures,
        PublishLimit,
        Results,
        Stamps,
        Throughput,
    )
    from benchmarks.paper.table_1 import Operation

_ACCESSES = {"read": "read", "block": "RM", "write": "write, answered", "post": "write, posted"}
Row = tuple[str, ...]

NOT_WITHOUT_A_BOARD: tuple[tuple[str, str], ...] = (
    (
        "what the kernel and libusb take for a transfer, and until a sleeping program runs again",
        "10 to 20 µs more for a single access, and the scatter that goes with them",
    ),
    (
        "when a host controller begins a transfer that is submitted in the middle of a microframe",
        "the model waits for the next one; the paper's request to effect shows that its host did not",
    ),
    ("what the chip does that its datasheet leaves open", "a packet behind a full one, the event character"),
    ("the proprietary D2XX driver", "the synchronous FIFO is driven through libusb, and the rate is the model's"),
    ("the paper's points of figures 3 and 4", "figure 3's stand in Table I, figure 4's in the picture alone"),
    ("rates of rospy and rostopic on the paper's PC", "ours on a virtual gateway: benchmarks/BRIDGES.md"),
)  # fmt: skip
"""Figures for which a board would be needed, and what is said instead."""


def to_markdown(results: Results, pictures: Sequence[tuple[str, str]] = ()) -> str:
    """Return the whole page.

    Args:
        results: what was found.
        pictures: titles and addresses of those to show.
    """
    parts = [_head(results), _table_1(results)]
    parts += [f"![{title}]({address})\n" for title, address in pictures]
    if results.gateware is not None:
        parts.append(_gateware(results.gateware))
    parts += [_latencies(results.latencies), _throughputs(results.throughputs), _bursts(results.bursts)]
    if results.stamps:
        parts.append(_stamps(results.stamps))
    parts += [
        _publishing(results),
        _media(results.media),
        _forms(results.forms),
        _lines(results.lines),
        _not_without_a_board(),
    ]
    parts += [_checks(results), _parameters(results)]
    return "\n".join(parts)


def table(head: Row, rows: Iterable[Row]) -> str:
    """Return a Markdown table."""
    lines = [head, ("---",) * len(head), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def quote(figure: published.Figure | None) -> str:
    """Write a figure of the paper."""
    if figure is None:
        return NOTHING
    if figure.unit == "us":
        return f"{figure.value:g} µs" + ("" if figure.deviation is None else f" (sd {figure.deviation:g} µs)")
    if figure.unit == "b/s":
        mega = figure.value >= 1e6
        return f"{figure.value / (1e6 if mega else 1e3):.1f} {'Mb/s' if mega else 'kb/s'}"
    if figure.unit == "Hz":
        return f"{figure.value / 1e3:g} kHz"
    return f"{figure.value:g} {figure.unit}"


def table_1_rows(results: Results, operation: Operation, mode: published.Mode) -> Iterator[Row]:
    """Return level, figure, the paper's, and ours: modelled and measured as well for each of two modes."""
    for row in table_1(results, operation, mode):
        found = row.found if len(row.found) > 1 else (f"{row.found[0]}, {row.kind}", *(NOTHING,) * 3)
        yield (row.level, row.what, quote(row.known), *found)


def latency_rows(latencies: Iterable[Latency]) -> Iterator[Row]:
    """Return stack, access, rhythm, mode; the clock-exact, modelled and measured parts of the median; the sum."""
    for row in latencies:
        gateware = row.gateware or 0.0
        yield (
            row.stack,
            _ACCESSES[row.access],
            row.rhythm,
            row.send_immediate,
            NOTHING if row.gateware is None else f"{gateware:.2f}",
            f"{row.modelled.median - gateware:,.1f}",
            f"{row.total.median - row.modelled.median:+,.1f}",
            f"{row.total.median:,.1f}",
            f"{row.total.mean:,.1f}",
            f"{row.total.deviation:,.1f}",
        )


def throughput_rows(throughputs: Iterable[Throughput]) -> Iterator[Row]:
    """Return stack, access, mode; requests and answers modelled, and with the program's time; the part of 64 Mb/s."""
    for row in throughputs:
        sizes = row.request_bytes, row.answer_bytes
        found = [row.megabits(rate, size) for rate in (row.modelled, row.total) for size in sizes]
        yield (
            row.stack,
            _ACCESSES[row.access],
            row.send_immediate,
            *(f"{rate:.1f}" if rate else NOTHING for rate in found),
            f"{row.megabits(row.total) / LINK_MBITS:.0%}",
        )


def burst_rows(bursts: Sequence[Burst]) -> Iterator[Row]:
    """Return stack, mode, reads; milliseconds and Mb/s of the answers, modelled and with the program's time."""
    for row in bursts:
        times = (f"{time / 1e3:,.3f}" for time in (row.modelled, row.total))
        rates = (f"{row.megabits(time):.2f}" for time in (row.modelled, row.total))
        yield row.stack, row.send_immediate, f"{row.count:,}", *times, *rates


def gateware_rows(figures: GatewareFigures) -> Iterator[Row]:
    """Return what, cycles, time or rate, and the paper's figure."""
    for what, cycles, access, known in (
        ("read: last byte in to last byte out", figures.read_cycles, "read", published.LATENCY),
        ("write: last byte in to last byte out", figures.write_cycles, "write", published.LATENCY),
        ("write: last byte in to its effect on the bus", figures.effect_cycles, "write", published.EFFECT),
        ("posted write: last byte in to its effect on the bus", figures.post_effect_cycles, None, published.EFFECT),
    ):
        figure = None if access is None else published.find(known, "gateware", access, "off")  # type: ignore[arg-type]
        yield what, str(cycles), f"{figures.microseconds(cycles):.2f} µs", quote(figure)
    for block in figures.blocks:
        both = f"{block.first_cycles} to the first byte, {block.last_cycles} to the last"
        yield f"RM of {block.words}: last byte in", both, f"{figures.microseconds(block.last_cycles):.2f} µs", NOTHING
    for sample in figures.publishing:
        time = f"{figures.microseconds(sample.cycles):.2f} µs"
        yield f"sample of {sample.words}: from its instant to its last byte out", str(sample.cycles), time, NOTHING
    rate = 8e-6 * figures.bytes_per_cycle * figures.clock_hz
    per_byte = f"{figures.bytes_per_cycle:.3f} bytes a cycle"
    known_answers = published.find(published.ANSWERS, "gateware", "read", "off")
    yield "pipelined reads with IDs: answers", per_byte, f"{rate:.0f} Mb/s", quote(known_answers)


def stamp_rows(stamps: Iterable[Stamps]) -> Iterator[Row]:
    """Return mode, reads; Mb/s on average and between pauses, answers and time from pause to pause; the paper's."""
    for row in stamps:
        known = NOTHING
        if (row.count, row.send_immediate) == (200, "off, 1 ms"):
            figures = (
                published.find(what, "gateware", "read", "off")
                for what in (published.STAMPED_MEAN, published.STAMPED_RUN, published.RUN_LENGTH, published.RUN_TIME)
            )
            known = ", ".join(map(quote, figures))
        elif (row.count, row.send_immediate) == (18, "always"):
            known = quote(published.find(published.STAMPED_MEAN, "gateware", "read", "always"))
        pauses = (NOTHING, NOTHING)
        if row.pauses:
            period = f"{row.pause_microseconds:.1f} µs" if row.pause_microseconds else NOTHING
            pauses = (f"{row.run_length:.0f}", period)
        rates = (f"{row.mean_megabits:.1f}", f"{row.run_megabits:.1f}")
        yield row.send_immediate, f"{row.count:,}", *rates, *pauses, known


def publish_rows(results: Results) -> Iterator[Row]:
    """Return words and bytes of a message; kHz of gateware and line, and of each stack, burst and sustained."""
    gateware = {} if results.gateware is None else {row.words: row.rate for row in results.gateware.publishing}
    by_stack: dict[str, dict[int, PublishLimit]] = {stack: {} for stack in STACKS}
    for limit in results.publish_limits:
        by_stack[limit.stack][limit.words] = limit
    for words, low in by_stack["low-level"].items():
        full = by_stack["full stack"][words]
        rates = [low.line, low.burst_modelled, low.modelled]
        rates += [low.burst_total, low.total, full.burst_total, full.total]
        exact = f"{gateware[words] / 1e3:,.2f}" if words in gateware else NOTHING
        yield str(words), str(low.message_bytes), exact, *(f"{rate / 1e3:,.2f}" for rate in rates)


def media_rows(media: Iterable[MediumFigures]) -> Iterator[Row]:
    """Return medium, FIFOs, line; read and write; Mb/s of answers and posts; kHz of samples; repeated requests."""
    for row in media:
        yield (
            row.medium,
            f"{row.fifo_bytes}",
            f"{row.line_megabits:g}",
            f"{row.read.mean:,.1f} (sd {row.read.deviation:.1f})",
            f"{row.write.mean:,.1f} (sd {row.write.deviation:.1f})",
            f"{row.answers_megabits:.2f}",
            f"{row.posts_megabits:.2f}",
            f"{row.samples / 1e3:,.1f}",
            f"{row.repeated}",
        )


def form_rows(forms: Iterable[FormFigures]) -> Iterator[Row]:
    """Return medium, gateway, form, time; thousands a second of reads, posts, words of blocks and samples."""
    for row in forms:
        yield (
            row.medium,
            "gateware" if row.gateway == "rtl" else "model",
            "compact" if row.compact else "text",
            "measured" if row.measured else "modelled",
            *(f"{rate / 1e3:,.1f}" for rate in (row.reads, row.posts, row.block_words, row.samples)),
        )


def line_rows(lines: Lines) -> Iterator[Row]:
    """Return what someone writes, here and in the paper, and in its other solution."""
    known = {row.what: quote(row) for row in published.TEXT if row.unit == "lines"}
    spec = f"{lines.spec}, of which {lines.comments} are comments"
    yield "specification", spec, known["specification"], "serial library by hand, not counted"
    yield "configuration in VHDL", f"{lines.configuration}", known["configuration in VHDL"], NOTHING
    yield "boilerplate in VHDL", f"{lines.boilerplate}", known["boilerplate in VHDL"], NOTHING
    pins = "a .ucf file, not counted"
    yield "pins of a board (none for a board by name)", f"{lines.pins}", pins, NOTHING
    yield "communication in C", "0", NOTHING, known["communication in C, the other solution"]
    other = known["hardware control in C and assembler, the other solution"]
    yield "hardware control in C and assembler", "0", NOTHING, other
    yield "generated VHDL and its bench, by nobody", f"{lines.generated:,}", NOTHING, NOTHING


def check_rows(checks: Iterable[Check]) -> Iterator[Row]:
    """Return what, how it was found, the figure, what is wanted, and whether it is met."""
    for check in checks:
        missed = "not on this machine" if check.measured else "NO"
        how = "measured" if check.measured else "in every run"
        yield check.what, how, check.found, check.wanted, "yes" if check.met else missed


def _head(results: Results) -> str:
    behind = "the gateware itself" if results.parameters.gateway == "rtl" else "a model of the gateware"
    quick = "**A quick run, of too few accesses to be quoted.**\n\n" if results.parameters.quick else ""
    return f"""# The paper's experiment, again

{quick}Written by `make table1` (`python -m benchmarks.paper`), unity-link {results.version}, {results.date}, on
{results.parameters.machine}.

The virtual FT232H with {behind} behind it, through `ftdi-async://`:
*low-level* is the driver's transport alone, *full stack* the whole link. *Clock-exact* is counted on the RTL,
*modelled* is the time of USB and chip, the same in every run, and *measured* has in it the processor time of the
program on this machine, too, and what it makes the program wait for the USB. How that is done, and what it leaves out:
[docs/paper.md](../docs/paper.md).
{NOTHING}: there is no such figure; in the column of the paper, that it has none.
"""


def _table_1(results: Results) -> str:
    text = (
        "As in the paper, every access at once behind the one before. Times are means, with standard deviation and "
        "median. The paper does not tell its latency timer; its figures without send-immediate are those of 1 ms, "
        "while the chip itself has 16 ms after a reset. Low-level are the paper's messages, without IDs; the full "
        "stack's have IDs of three digits. By the clock on the wall: in real time, to a virtual chip that a thread "
        "moves along, on a machine that has other things to do, too.\n"
    )
    parts = [f"## Table I\n\n{text}"]
    for operation, title in TITLES.items():
        for mode in ("off", "always"):
            first, second = (HEADS[each] for each in COLUMNS[mode])
            head = (
                "level",
                "figure",
                "paper",
                f"{first}: modelled",
                "measured as well",
                f"{second}: modelled",
                "measured as well",
            )
            suffix = ", send-immediate" if mode == "always" else ""
            parts.append(f"### {title}{suffix}\n\n{table(head, table_1_rows(results, operation, mode))}")
    return "\n".join(parts)


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
        "median, µs",
        "mean, µs",
        "sd, µs",
    )
    text = "The parts are those of the median; the best of several runs."
    return f"## One access, part by part\n\n{text}\n\n" + table(head, latency_rows(latencies))


def _throughputs(throughputs: Sequence[Throughput]) -> str:
    head = (
        "stack",
        "accesses",
        "send-immediate",
        "requests, modelled, Mb/s",
        "answers, modelled, Mb/s",
        "requests, measured as well, Mb/s",
        "answers, measured as well, Mb/s",
        "of 64 Mb/s",
    )
    text = (
        "To the gateway and from it; the part of 64 Mb/s is that of the direction that it fills. The best of "
        "several runs. A rate a little above 64 Mb/s is one of packets: they come by the microframe."
    )
    return f"## Long bursts\n\n{text}\n\n" + table(head, throughput_rows(throughputs))


def _bursts(bursts: Sequence[Burst]) -> str:
    head = (
        "stack",
        "send-immediate",
        "reads",
        "modelled, ms",
        "measured as well, ms",
        "answers, modelled, Mb/s",
        "answers, measured as well, Mb/s",
    )
    without, with_it = (
        published.value(published.MOST_REQUESTS, "low-level", "read", mode) for mode in ("off", "always")
    )
    text = (
        f"Until the last answer is there. The paper's could be of {without:g} requests and more, with send-immediate"
        f" of {with_it:g} requests."
    )
    return f"## Bursts of reads\n\n{text}\n\n" + table(head, burst_rows(bursts))


def _stamps(stamps: Sequence[Stamps]) -> str:
    head = (
        "send-immediate",
        "reads",
        "answers, Mb/s",
        "between pauses, Mb/s",
        "answers from pause to pause",
        "time from pause to pause",
        "paper",
    )
    text = (
        "Low-level; modelled, with the gateware's part clock-exact. Each word that is read is the time at which it "
        "is read. A pause is more than twice the usual time from one to the next. Rates above 64 Mb/s are those of "
        "answers that wait in the FIFO."
    )
    return f"## Bursts by the gateway's clock\n\n{text}\n\n" + table(head, stamp_rows(stamps))


def _publishing(results: Results) -> str:
    head = (
        "words",
        "bytes a message",
        "gateware, clock-exact",
        "ideal link, 8 MB/s",
        "burst, modelled",
        "sustained, modelled",
        "low-level, burst, measured as well",
        "low-level, sustained, measured as well",
        "full stack, burst, measured as well",
        "full stack, sustained, measured as well",
    )
    sustained = results.sustained
    base = results.parameters.base_frequency / 1e6
    text = (
        f"kHz. The highest of the rates {base:g} MHz / n at which no sample is lost: of {BURST} samples, which may "
        "wait in the gateway until they are sent, and for ever. The gateware's own is that of all its groups "
        "together, which no tick limits. A program that takes no time gets the same from both stacks.\n\n"
    )
    after = (
        f"\nOne word at {sustained.rate / 1e3:.2f} kHz for {sustained.seconds:.2f} s, taken by `async for`: "
        f"{sustained.samples:,} samples, {sustained.lost} lost.\n"
    )
    return f"## The limit of publishing\n\n{text}" + table(head, publish_rows(results)) + after


def _media(media: Sequence[MediumFigures]) -> str:
    head = (
        "medium",
        "FIFOs, bytes",
        "line, Mb/s",
        "read, µs",
        "write, µs",
        "answers, Mb/s",
        "posted writes, Mb/s",
        "samples, kHz",
        "repeated",
    )
    text = (
        "Modelled, with the gateway's model in Python: full stack, adaptive, accesses at any time, long bursts, "
        "samples of one word. The line of a UART has ten bits a byte. That of the synchronous FIFO carries one "
        "direction at a time, and no time to turn it round is in the model. Behind a UART of three wires nothing "
        "stops the host, so requests under way have to fit in the receive FIFO: one, in 16 bytes. An FT245 stops by"
        " itself. A request whose answer is late is repeated; none was lost."
    )
    return f"## Other media, other FIFOs\n\n{text}\n\n" + table(head, media_rows(media))


def _forms(forms: Sequence[FormFigures]) -> str:
    head = (
        "medium",
        "gateway",
        "form",
        "time",
        "reads, thousands a second",
        "posted writes",
        "words of blocks of 255",
        "samples of one word",
    )
    text = (
        "Full stack, adaptive, long bursts, and samples where more are due than fit; the samples that did not fit were "
        "counted as lost. On the shared FIFO both directions together have 8 MB/s, and the check has 16 bits."
    )
    return f"## Text and compact frames\n\n{text}\n\n" + table(head, form_rows(forms))


def _lines(lines: Lines) -> str:
    head = ("the 18-DOF walker, in lines", "here", "paper", "the other solution of the paper")
    text = "What someone writes to have its 72 values on the PC; blank lines do not count."
    return f"## Complexity\n\n{text}\n\n" + table(head, line_rows(lines))


def _not_without_a_board() -> str:
    return "## Not without a board\n\n" + table(("what", "instead"), NOT_WITHOUT_A_BOARD)


def _checks(results: Results) -> str:
    return "## What must hold\n\n" + table(("what", "known", "found", "wanted", "met"), check_rows(results.checks))


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

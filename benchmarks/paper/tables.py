"""The experiment as Markdown: our figures and the paper's, their kinds, and the model's parameters."""

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
        "the time of the kernel and libusb for a transfer, and the time until a sleeping program runs again",
        "10 to 20 µs more for a single access, with more deviation",
    ),
    (
        "the start of a transfer that is submitted to a host controller in the middle of a microframe",
        "the model waits for the next one; the paper's request to effect shows that its host did not",
    ),
    ("behaviour of the chip that its datasheet does not define", "a packet after a full one, the event character"),
    ("the proprietary D2XX driver", "the synchronous FIFO is driven through libusb, and the rate is the model's"),
    ("the paper's points of figures 3 and 4", "figure 3: in Table I; figure 4: only in the picture"),
    ("rates of rospy and rostopic on the paper's PC", "ours on a virtual gateway: benchmarks/BRIDGES.md"),
)  # fmt: skip
"""Figures that need a board, and their substitutes here."""


def to_markdown(results: Results, pictures: Sequence[tuple[str, str]] = ()) -> str:
    """Return the whole page.

    Args:
        results: of the experiment.
        pictures: titles and addresses of the pictures to show.
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
    """Format a figure of the paper."""
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
    """Yield level, figure, the paper's figure, and ours: modelled and measured for each of two modes."""
    for row in table_1(results, operation, mode):
        found = row.found if len(row.found) > 1 else (f"{row.found[0]}, {row.kind}", *(NOTHING,) * 3)
        yield (row.level, row.what, quote(row.known), *found)


def latency_rows(latencies: Iterable[Latency]) -> Iterator[Row]:
    """Yield stack, access, rhythm, mode; the clock-exact, modelled and measured parts of the median; the sum."""
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
    """Yield stack, access, mode; requests and answers, modelled and with the program's time; the share of 64 Mb/s."""
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
    """Yield stack, mode, reads; milliseconds and Mb/s of the answers, modelled and with the program's time."""
    for row in bursts:
        times = (f"{time / 1e3:,.3f}" for time in (row.modelled, row.total))
        rates = (f"{row.megabits(time):.2f}" for time in (row.modelled, row.total))
        yield row.stack, row.send_immediate, f"{row.count:,}", *times, *rates


def gateware_rows(figures: GatewareFigures) -> Iterator[Row]:
    """Yield the quantity, cycles, time or rate, and the paper's figure."""
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
    """Yield mode, reads; Mb/s on average and between pauses; answers and time from pause to pause; the paper's."""
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
    """Yield words and bytes of a message; kHz of gateware and line, and of each stack, burst and sustained."""
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
    """Yield medium, FIFOs, line; read and write; Mb/s of answers and posts; kHz of samples; retransmitted requests."""
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
    """Yield medium, gateway, form, time; thousands per second of reads, posts, words of blocks and samples."""
    for row in forms:
        yield (
            row.medium,
            "gateware" if row.gateway == "rtl" else "model",
            "compact" if row.compact else "text",
            "measured" if row.measured else "modelled",
            *(f"{rate / 1e3:,.1f}" for rate in (row.reads, row.posts, row.block_words, row.samples)),
        )


def line_rows(lines: Lines) -> Iterator[Row]:
    """Yield the part that a user writes, its lines here, in the paper, and in the paper's other solution."""
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
    """Yield the quantity, its kind, the figure, its limit, and whether the limit is met."""
    for check in checks:
        missed = "not on this machine" if check.measured else "NO"
        how = "measured" if check.measured else "in every run"
        yield check.what, how, check.found, check.wanted, "yes" if check.met else missed


def _head(results: Results) -> str:
    behind = "the compiled gateware" if results.parameters.gateway == "rtl" else "a model of the gateware"
    quick = "**A quick run, of too few accesses to be quoted.**\n\n" if results.parameters.quick else ""
    return f"""# The paper's experiment, again

{quick}Written by `make table1` (`python -m benchmarks.paper`), unity-link {results.version}, {results.date}, on
{results.parameters.machine}.

The virtual FT232H with {behind}, through `ftdi-async://`:
*low-level* is the driver's transport alone, *full stack* the whole link. *Clock-exact* is counted on the RTL,
*modelled* is the time of USB and chip, the same in every run, and *measured* also includes the processor time of the
program on this machine, and the waits for USB that it causes. The method and its limits:
[docs/paper.md](../docs/paper.md).
{NOTHING}: there is no such figure, here or in the paper.
"""


def _table_1(results: Results) -> str:
    text = (
        "As in the paper, every access immediately follows the one before. Times are means, with standard deviation "
        "and median. The paper does not state its latency timer; its figures without send-immediate are those of "
        "1 ms, while the chip has 16 ms after a reset. Low-level messages are those of the paper, without IDs; those "
        "of the full stack have IDs of three digits. By the clock on the wall: in real time, with a virtual chip that "
        "a thread simulates, on a machine with other work.\n"
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
    text = "## The gateware alone\n\nAt the port of its FIFOs; the bus answers in the cycle after a request.\n\n"
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
        "To the gateway and from it; the share of 64 Mb/s is that of the fuller direction. The best of several runs. "
        "A rate slightly above 64 Mb/s results from packets, which arrive in microframes."
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
        f"Time until the last answer is received. The paper's bursts had at most {without:g} requests or more, with "
        f"send-immediate {with_it:g} requests."
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
        "Low-level; modelled, with the gateware's part clock-exact. Each word is the time of its read. A pause is a "
        "gap of more than twice the usual time between two answers. Rates above 64 Mb/s occur while answers wait in "
        "the FIFO."
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
        f"kHz. The highest of the rates {base:g} MHz / n at which no sample is lost: in a burst of {BURST} samples, "
        "which the gateway may buffer, and sustained. The rate of the gateware alone is that of all its groups "
        "together, which the base tick does not limit. For a program that takes no time, both stacks have the same "
        "rates.\n\n"
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
        "samples of one word. The line of a UART has ten bits per byte. That of the synchronous FIFO carries one "
        "direction at a time; the model has no turnaround time. A UART of three wires has no flow control, so the "
        "requests in flight must fit into the receive FIFO: one, in 16 bytes. An FT245 has flow control. A request "
        "whose answer is late is retransmitted; none was lost."
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
        "Full stack, adaptive, long bursts, and samples with more due than the line transfers; the others were counted "
        "as lost. On the shared FIFO both directions together have 8 MB/s, and the CRC has 16 bits."
    )
    return f"## Text and compact frames\n\n{text}\n\n" + table(head, form_rows(forms))


def _lines(lines: Lines) -> str:
    head = ("the 18-DOF walker, in lines", "here", "paper", "the other solution of the paper")
    text = "Lines that a user writes to have its 72 values on the PC, without blank lines."
    return f"## Complexity\n\n{text}\n\n" + table(head, line_rows(lines))


def _not_without_a_board() -> str:
    return "## Not without a board\n\n" + table(("what", "instead"), NOT_WITHOUT_A_BOARD)


def _checks(results: Results) -> str:
    return "## Limits\n\n" + table(("what", "known", "found", "wanted", "met"), check_rows(results.checks))


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
    text = "## Parameters\n\nIn seconds and bytes; `unity_link/virtual/ft232h/timing.py` has the sources.\n\n"
    return text + table(("what", "value"), rows)

"""The results of the experiment as data; `python -m benchmarks.paper --json` prints them as JSON."""

from __future__ import annotations

import statistics
from typing import TYPE_CHECKING, Literal

import msgspec

from benchmarks.paper.media import MediumName  # noqa: TC001  (msgspec reads them)
from benchmarks.paper.stacks import Access, Mode, StackName  # noqa: TC001
from benchmarks.paper.workbench import GatewayKind  # noqa: TC001

if TYPE_CHECKING:
    from collections.abc import Sequence

STACKS: tuple[StackName, ...] = ("low-level", "full stack")
Rhythm = Literal["back to back", "at any time"]
"""Each access immediately after the one before, as in the paper; or at a time without relation to USB's."""
RHYTHMS: tuple[Rhythm, ...] = ("back to back", "at any time")


class Spread(msgspec.Struct, frozen=True, kw_only=True):
    """Statistics of several times, in microseconds."""

    median: float
    mean: float
    deviation: float
    """Standard deviation."""

    @classmethod
    def of(cls, microseconds: Sequence[float]) -> Spread:
        """Return the statistics of times, rounded to nanoseconds because of the clock's resolution."""
        kinds = (statistics.median, statistics.fmean, statistics.pstdev)
        median, mean, deviation = (round(kind(microseconds), 3) for kind in kinds)
        return cls(median=median, mean=mean, deviation=deviation)


class Publishing(msgspec.Struct, frozen=True, kw_only=True):
    """Clock-exact: samples of a number of words at the port of the FIFOs."""

    words: int
    message_bytes: int
    cycles: int
    """Cycles from the read of the first word to the last byte out."""
    rate: float
    """Samples per second if more are due than can be sent, from as many groups as necessary."""


class Block(msgspec.Struct, frozen=True, kw_only=True):
    """Clock-exact: an RM."""

    words: int
    first_cycles: int
    """Cycles from the last byte of the request in, to the first byte of the answer out."""
    last_cycles: int
    """Cycles from the last byte of the request in, to the last byte of the answer out."""


class GatewareFigures(msgspec.Struct, frozen=True, kw_only=True):
    """Clock-exact: cycles from the last byte of a request in."""

    clock_hz: int
    read_cycles: int
    """Cycles to the last byte of the answer out."""
    write_cycles: int
    """Cycles to the last byte of a write's answer out."""
    effect_cycles: int
    """Cycles to a write's effect on the bus."""
    post_effect_cycles: int
    """Cycles to a posted write's effect on the bus."""
    cycles_per_read: float
    """Cycles from one pipelined read to the next."""
    cycles_per_write: float
    cycles_per_post: float
    bytes_per_cycle: float
    """Output bytes per cycle of pipelined reads with IDs."""
    blocks: list[Block]
    publishing: list[Publishing]

    def microseconds(self, cycles: float) -> float:
        """Return the time of a number of cycles."""
        return cycles / self.clock_hz * 1e6

    def megabits(self, size: int, cycles: float) -> float:
        """Return the rate in Mb/s of `size` bytes in a number of cycles."""
        return 8e-6 * size * self.clock_hz / cycles


class Latency(msgspec.Struct, frozen=True, kw_only=True):
    """Duration of one access, from call to answer."""

    stack: StackName
    access: Access
    send_immediate: Mode
    rhythm: Rhythm
    request_bytes: int
    answer_bytes: int
    gateware: float | None
    """Clock-exact, in microseconds: request and answer through the pins and the gateware; None without the RTL."""
    modelled: Spread
    """Modelled time with that of the gateware, for a program that takes no time."""
    total: Spread
    """With the program's processor time, and the waits for USB that it may cause; the best of several runs."""

    def synchronous(self, time: Spread) -> float:
        """Return the rate of requests and answers together, one after the other, in Mb/s."""
        return 8 * (self.request_bytes + self.answer_bytes) / time.mean


class Effect(msgspec.Struct, frozen=True, kw_only=True):
    """Time from the call to the bus, of one write and of a burst of 30."""

    stack: StackName
    access: Access
    send_immediate: Mode
    request_bytes: int
    modelled: Spread
    total: Spread
    burst_modelled: float
    """Microseconds from effect to effect in the burst, on average."""
    burst_total: float


class Arrival(msgspec.Struct, frozen=True, kw_only=True):
    """Time from the sample strobe of one word to the program."""

    stack: StackName
    send_immediate: Mode
    """The samples request send-immediate themselves (``immediate=True``) in all modes except the first two."""
    modelled: Spread
    total: Spread


class Throughput(msgspec.Struct, frozen=True, kw_only=True):
    """Long bursts, in accesses per second; see `throughput.measure_throughputs`."""

    stack: StackName
    access: Access
    send_immediate: Mode
    request_bytes: int
    answer_bytes: int
    modelled: float
    total: float
    """With the program's processor time; the best of several runs."""

    @property
    def filling(self) -> int:
        """Bytes of an access in its fuller direction."""
        return max(self.request_bytes, self.answer_bytes)

    def megabits(self, rate: float, size: int | None = None) -> float:
        """Return the rate of accesses in Mb/s, in their fuller direction, or for `size` bytes each."""
        return 8e-6 * rate * (self.filling if size is None else size)


class Burst(msgspec.Struct, frozen=True, kw_only=True):
    """Reads at once, and the microseconds until the last answer is received."""

    stack: StackName
    send_immediate: Mode
    count: int
    answer_bytes: int
    modelled: float
    total: float
    """With the program's processor time; the best of several runs."""

    def megabits(self, microseconds: float) -> float:
        """Return the answers' rate in Mb/s."""
        return 8 * self.answer_bytes * self.count / microseconds


class Stamps(msgspec.Struct, frozen=True, kw_only=True):
    """A burst of reads by the gateway's own clock: each word is the cycle of its read. Modelled."""

    send_immediate: Mode
    count: int
    mean_megabits: float
    """Rate of the answers from first to last."""
    run_megabits: float
    """Rate of the answers between two pauses."""
    run_length: float
    """Answers from pause to pause, on average; all answers without a pause."""
    pauses: int
    """Number of pauses: gaps longer than twice the usual distance of two answers."""
    pause_microseconds: float
    """Time from pause to pause, on average; 0 without pauses."""


class PublishLimit(msgspec.Struct, frozen=True, kw_only=True):
    """The highest rates of the gateway in Hz at which no sample is lost."""

    stack: StackName
    words: int
    message_bytes: int
    line: float
    """Rate that 8 MB/s would transfer."""
    burst_modelled: float
    """For a burst of `publishing.BURST` samples."""
    burst_total: float
    modelled: float
    """Sustained."""
    total: float
    """Sustained, with a program that reads each sample by ``async for``."""


class Sustained(msgspec.Struct, frozen=True, kw_only=True):
    """One word, published for some seconds."""

    rate: float
    """In Hz."""
    seconds: float
    samples: int
    lost: int


class WallClock(msgspec.Struct, frozen=True, kw_only=True):
    """One access through the full stack to a virtual chip in real time, with threads, sockets and the kernel."""

    access: Access
    send_immediate: Mode
    taken: Spread


class MediumFigures(msgspec.Struct, frozen=True, kw_only=True):
    """One connection from chip to gateway, modelled, with the gateway's Python model, through the full stack."""

    medium: MediumName
    fifo_bytes: int
    """Bytes of each FIFO of the gateway."""
    line_megabits: float
    """Megabits per second of the medium in each direction, or in both together if it carries one at a time."""
    read: Spread
    write: Spread
    answers_megabits: float
    """Megabits per second of the answers to a long burst of reads."""
    posts_megabits: float
    """Megabits per second of the requests of a long burst of posted writes."""
    samples: float
    """Received samples of one word per second, if more are due."""
    repeated: int
    """Number of requests that the link retransmitted after a loss."""


class FormFigures(msgspec.Struct, frozen=True, kw_only=True):
    """One form of frames on a medium, through the full stack: rates of long bursts, per second."""

    medium: MediumName
    gateway: GatewayKind
    """The compiled gateware, or its Python model."""
    compact: bool
    """True if frames of the session are in compact form, False for text."""
    measured: bool
    """True if the program's time is included."""
    reads: float
    posts: float
    block_words: float
    """Words of blocks of 255."""
    samples: float
    """Received samples of one word, if more are due."""


class Lines(msgspec.Struct, frozen=True, kw_only=True):
    """The interface of the 18-DOF walker, in lines that a user writes, without blank lines."""

    spec: int
    comments: int
    """Number of comments of the spec."""
    configuration: int
    boilerplate: int
    pins: int
    """Constraints of a board, by hand."""
    generated: int
    """Lines of all files that `generate vhdl` writes."""


class Check(msgspec.Struct, frozen=True, kw_only=True):
    """A figure that must meet a limit."""

    what: str
    found: str
    wanted: str
    met: bool
    measured: bool
    """True if it includes this machine's processor time, so that another run may have another result."""


class Parameters(msgspec.Struct, frozen=True, kw_only=True):
    """Conditions of the experiment."""

    gateway: GatewayKind
    id_digits: int
    address_bits: int
    data_bits: int
    receive_fifo_bytes: int
    transmit_fifo_bytes: int
    base_frequency: float
    """Base frequency of publishing, in Hz."""
    timing: dict[str, float]
    """Numbers of the model: fields of `unity_link.virtual.ft232h.Timing`."""
    posted_reads: int
    read_size: int
    """Bytes of each read of the driver; `posted_reads` of them are pending at the chip."""
    machine: str
    quick: bool
    """True for fewer accesses than usual: a test run whose figures must not be quoted."""


class Results(msgspec.Struct, frozen=True, kw_only=True):
    """All results."""

    version: str
    date: str
    parameters: Parameters
    gateware: GatewareFigures | None
    latencies: list[Latency]
    effects: list[Effect]
    arrivals: list[Arrival]
    throughputs: list[Throughput]
    bursts: list[Burst]
    stamps: list[Stamps]
    publish_limits: list[PublishLimit]
    sustained: Sustained
    wall_clock: list[WallClock]
    media: list[MediumFigures]
    forms: list[FormFigures]
    lines: Lines
    checks: list[Check]

    def to_json(self, indent: int = 2) -> bytes:
        """Return the results as one JSON object; in one line if `indent` is -1."""
        return msgspec.json.format(msgspec.json.encode(self), indent=indent)

    def latency(self, stack: StackName, access: Access, mode: Mode, rhythm: Rhythm = "back to back") -> Latency:
        """Return one of the latencies."""
        wanted = (stack, access, mode, rhythm)
        return next(row for row in self.latencies if (row.stack, row.access, row.send_immediate, row.rhythm) == wanted)

    def throughput(self, stack: StackName, access: Access, mode: Mode) -> Throughput:
        """Return one of the throughputs."""
        wanted = (stack, access, mode)
        return next(row for row in self.throughputs if (row.stack, row.access, row.send_immediate) == wanted)

    def effect(self, stack: StackName, access: Access, mode: Mode) -> Effect:
        """Return one of the times to the effect."""
        wanted = (stack, access, mode)
        return next(row for row in self.effects if (row.stack, row.access, row.send_immediate) == wanted)

    def burst(self, stack: StackName, mode: Mode, least: int) -> Burst:
        """Return the shortest burst of at least `least` reads."""
        rows = [row for row in self.bursts if (row.stack, row.send_immediate) == (stack, mode)]
        return min((row for row in rows if row.count >= least), key=lambda row: row.count, default=rows[-1])

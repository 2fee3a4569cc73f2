"""What the experiment gives, as data; as JSON, this is what `python -m benchmarks.paper --json` prints."""

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
"""Each access at once behind the one before, as in the paper; or at an instant that has no relation to the USB's."""
RHYTHMS: tuple[Rhythm, ...] = ("back to back", "at any time")


class Spread(msgspec.Struct, frozen=True, kw_only=True):
    """Statistics of several times, in microseconds."""

    median: float
    mean: float
    deviation: float
    """Standard deviation."""

    @classmethod
    def of(cls, microseconds: Sequence[float]) -> Spread:
        """Return that of some times, to a nanosecond: what is beyond is rounding of the clock."""
        kinds = (statistics.median, statistics.fmean, statistics.pstdev)
        median, mean, deviation = (round(kind(microseconds), 3) for kind in kinds)
        return cls(median=median, mean=mean, deviation=deviation)


class Publishing(msgspec.Struct, frozen=True, kw_only=True):
    """Clock-exact: what samples of so many words take at the port of the FIFOs."""

    words: int
    message_bytes: int
    cycles: int
    """From the instant at which the first word is read to the last byte out."""
    rate: float
    """Samples a second that leave where more are due than can: of as many groups as it takes."""


class Block(msgspec.Struct, frozen=True, kw_only=True):
    """Clock-exact: an RM."""

    words: int
    first_cycles: int
    """From the last byte of the request in, to the first byte of the answer out."""
    last_cycles: int
    """The same to the last byte out."""


class GatewareFigures(msgspec.Struct, frozen=True, kw_only=True):
    """Clock-exact: cycles from the last byte of a request in."""

    clock_hz: int
    read_cycles: int
    """To the last byte of the answer out."""
    write_cycles: int
    """The same of a write."""
    effect_cycles: int
    """To a write's effect on the bus."""
    post_effect_cycles: int
    """The same of a posted write."""
    cycles_per_read: float
    """Cycles of a read, of pipelined reads: from one to the next."""
    cycles_per_write: float
    cycles_per_post: float
    bytes_per_cycle: float
    """Out, of pipelined reads that have IDs."""
    blocks: list[Block]
    publishing: list[Publishing]

    def microseconds(self, cycles: float) -> float:
        """Return the time of so many cycles."""
        return cycles / self.clock_hz * 1e6

    def megabits(self, size: int, cycles: float) -> float:
        """Return the Mb/s of so many bytes in so many cycles."""
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
    """Clock-exact, in microseconds: request and answer through the pins and the gateware; None where no RTL was
    there."""
    modelled: Spread
    """The modelled time, what the gateware takes included, for a program that takes no time."""
    total: Spread
    """With the processor time of the program, and with the wait for the USB that this may cost; the best of several
    runs."""

    def synchronous(self, time: Spread) -> float:
        """Return what requests and answers make together, one after the other, in Mb/s."""
        return 8 * (self.request_bytes + self.answer_bytes) / time.mean


class Effect(msgspec.Struct, frozen=True, kw_only=True):
    """From the call to the bus: of one write, and of a burst of 30."""

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
    """From the instant of a sample of one word to the program that takes it."""

    stack: StackName
    send_immediate: Mode
    """Samples are flushed themselves (``immediate=True``) in all modes but the first two."""
    modelled: Spread
    total: Spread


class Throughput(msgspec.Struct, frozen=True, kw_only=True):
    """Long bursts, in accesses a second; see `throughput.measure_throughputs`."""

    stack: StackName
    access: Access
    send_immediate: Mode
    request_bytes: int
    answer_bytes: int
    modelled: float
    total: float
    """With the processor time of the program; the best of several runs."""

    @property
    def filling(self) -> int:
        """Bytes of an access in the direction that it fills."""
        return max(self.request_bytes, self.answer_bytes)

    def megabits(self, rate: float, size: int | None = None) -> float:
        """Return what so many accesses a second make, in Mb/s: in the direction that they fill, or of so many bytes."""
        return 8e-6 * rate * (self.filling if size is None else size)


class Burst(msgspec.Struct, frozen=True, kw_only=True):
    """Reads at once, and the microseconds until the last answer is there."""

    stack: StackName
    send_immediate: Mode
    count: int
    answer_bytes: int
    modelled: float
    total: float
    """With the processor time of the program; the best of several runs."""

    def megabits(self, microseconds: float) -> float:
        """Return the answers' Mb/s."""
        return 8 * self.answer_bytes * self.count / microseconds


class Stamps(msgspec.Struct, frozen=True, kw_only=True):
    """A burst of reads by the gateway's own clock: each read's word is the cycle in which it was read. Modelled."""

    send_immediate: Mode
    count: int
    mean_megabits: float
    """Answers, from first to last."""
    run_megabits: float
    """Answers between two pauses."""
    run_length: float
    """Answers from pause to pause, on average; all, where there is none."""
    pauses: int
    """Longer than twice the usual distance of two answers."""
    pause_microseconds: float
    """From pause to pause, on average; 0 where there are none."""


class PublishLimit(msgspec.Struct, frozen=True, kw_only=True):
    """The highest rates, of those that the gateway has, at which no sample is lost, in Hz."""

    stack: StackName
    words: int
    message_bytes: int
    line: float
    """Rate that 8 MB/s would carry."""
    burst_modelled: float
    """For as many samples as `publishing.BURST`."""
    burst_total: float
    modelled: float
    """For ever."""
    total: float
    """With a program that takes each sample by ``async for``."""


class Sustained(msgspec.Struct, frozen=True, kw_only=True):
    """One word, published for a while."""

    rate: float
    """Hz."""
    seconds: float
    samples: int
    lost: int


class WallClock(msgspec.Struct, frozen=True, kw_only=True):
    """One access through the full stack to a virtual chip in real time, with threads, sockets and the kernel."""

    access: Access
    send_immediate: Mode
    taken: Spread


class MediumFigures(msgspec.Struct, frozen=True, kw_only=True):
    """One way from chip to gateway, modelled, with the gateway's model in Python, through the full stack."""

    medium: MediumName
    fifo_bytes: int
    """Bytes of each FIFO of the gateway."""
    line_megabits: float
    """Megabits a second that the medium carries in each direction; in both together, where it has one at a time."""
    read: Spread
    write: Spread
    answers_megabits: float
    """Megabits a second of a long burst of reads."""
    posts_megabits: float
    """Requests of a long burst of posted writes."""
    samples: float
    """Hz: of one word, that come where more are due."""
    repeated: int
    """Requests that the link sent again, as something was lost."""


class FormFigures(msgspec.Struct, frozen=True, kw_only=True):
    """One form of frames on a medium, through the full stack: rates of long bursts, a second."""

    medium: MediumName
    gateway: GatewayKind
    """The gateware itself, or its model in Python."""
    compact: bool
    """True if frames of the session are in compact form, False for text."""
    measured: bool
    """True if the program's time counts, too."""
    reads: float
    posts: float
    block_words: float
    """Words of blocks of 255."""
    samples: float
    """Samples of one word that come where more are due."""


class Lines(msgspec.Struct, frozen=True, kw_only=True):
    """The interface of the 18-DOF walker, in lines that someone writes; those that are blank do not count."""

    spec: int
    comments: int
    """Number of comments of the spec."""
    configuration: int
    boilerplate: int
    pins: int
    """Constraints of a board by hand."""
    generated: int
    """Generated: all that `generate vhdl` makes."""


class Check(msgspec.Struct, frozen=True, kw_only=True):
    """A figure that must hold."""

    what: str
    found: str
    wanted: str
    met: bool
    measured: bool
    """True if this machine's processor time is in it, so that another run can find another."""


class Parameters(msgspec.Struct, frozen=True, kw_only=True):
    """Under which all of it was found."""

    gateway: GatewayKind
    id_digits: int
    address_bits: int
    data_bits: int
    receive_fifo_bytes: int
    transmit_fifo_bytes: int
    base_frequency: float
    """Base frequency of publishing, Hz."""
    timing: dict[str, float]
    """The model's numbers: fields of `unity_link.virtual.ft232h.Timing`."""
    posted_reads: int
    read_size: int
    """Size of the driver's reads: transfers that wait for the chip, and bytes of each."""
    machine: str
    quick: bool
    """Fewer accesses than usual: to see that it works, not to be quoted."""


class Results(msgspec.Struct, frozen=True, kw_only=True):
    """All of it."""

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
        """Return all as one JSON object; in one line, if `indent` is -1."""
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
        """Return the shortest burst of so many reads or more."""
        rows = [row for row in self.bursts if (row.stack, row.send_immediate) == (stack, mode)]
        return min((row for row in rows if row.count >= least), key=lambda row: row.count, default=rows[-1])

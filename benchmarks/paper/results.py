"""What the experiment gives, as data; as JSON, this is what `python -m benchmarks.paper --json` prints."""

from __future__ import annotations

from typing import Literal

import msgspec

from benchmarks.paper.stacks import Access, StackName  # noqa: TC001  (msgspec reads them)
from benchmarks.paper.workbench import GatewayKind  # noqa: TC001

SendImmediate = Literal["off", "always", "adaptive"]
STACKS: tuple[StackName, ...] = ("low-level", "full stack")
MODES: tuple[SendImmediate, ...] = ("off", "always", "adaptive")
ACCESSES: tuple[Access, ...] = ("read", "write", "post")
Rhythm = Literal["back to back", "at any time"]
"""Each access at once behind the one before, as in the paper; or at an instant that has no relation to the USB's."""
RHYTHMS: tuple[Rhythm, ...] = ("back to back", "at any time")


class GatewareFigures(msgspec.Struct, frozen=True, kw_only=True):
    """Clock-exact: cycles from the last byte of a request in."""

    clock_hz: int
    read_cycles: int
    """To the last byte of the answer out."""
    write_cycles: int
    """The same of a write."""
    effect_cycles: int
    """To a write's effect on the bus."""
    bytes_per_cycle: float
    """Out, of pipelined reads."""

    def microseconds(self, cycles: int) -> float:
        """Return the time of so many cycles."""
        return cycles / self.clock_hz * 1e6


class Latency(msgspec.Struct, frozen=True, kw_only=True):
    """What one access takes, in microseconds."""

    stack: StackName
    access: Access
    send_immediate: SendImmediate
    rhythm: Rhythm
    gateware: float | None
    """Clock-exact: request and answer through the pins and the gateware; None where no RTL was there."""
    modelled: float
    """The median of the modelled time, what the gateware takes included, for a program that takes no time."""
    total: float
    """The median with the processor time of the program, and with the wait for the USB that this may cost; the best of
    several runs."""


class Throughput(msgspec.Struct, frozen=True, kw_only=True):
    """What a long burst moves in the direction that it fills, in Mb/s; see `throughput.measure_throughputs`."""

    stack: StackName
    access: Access
    send_immediate: SendImmediate
    modelled: float
    total: float
    """With the processor time of the program; the best of several runs."""


class Burst(msgspec.Struct, frozen=True, kw_only=True):
    """Reads at once, and the time until the last answer is there, with the processor time of the program."""

    stack: StackName
    send_immediate: SendImmediate
    count: int
    microseconds: float
    megabits: float
    """Answers, Mb/s."""


class PublishLimit(msgspec.Struct, frozen=True, kw_only=True):
    """The highest rates, of those that the gateway has, at which no sample is lost, in Hz."""

    words: int
    message_bytes: int
    line: float
    """What 8 MB/s would carry."""
    modelled: float
    total: float
    """With a program that takes each sample by ``async for``."""


class Sustained(msgspec.Struct, frozen=True, kw_only=True):
    """One word, published for a while."""

    rate: float
    """Hz."""
    seconds: float
    samples: int
    lost: int


class Check(msgspec.Struct, frozen=True, kw_only=True):
    """A figure that must hold."""

    what: str
    found: str
    wanted: str
    met: bool


class Parameters(msgspec.Struct, frozen=True, kw_only=True):
    """Under which all of it was found."""

    gateway: GatewayKind
    id_digits: int
    address_bits: int
    data_bits: int
    receive_fifo_bytes: int
    transmit_fifo_bytes: int
    base_frequency: float
    """Of publishing, Hz."""
    timing: dict[str, float]
    """The model's numbers: fields of `unity_link.virtual.ft232h.Timing`."""
    posted_reads: int
    read_size: int
    """Of the driver: transfers that wait for the chip, and bytes of each."""
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
    throughputs: list[Throughput]
    bursts: list[Burst]
    publish_limits: list[PublishLimit]
    sustained: Sustained
    checks: list[Check]

    def to_json(self, indent: int = 2) -> bytes:
        """Return all as one JSON object; in one line, if `indent` is -1."""
        return msgspec.json.format(msgspec.json.encode(self), indent=indent)

    def latency(self, stack: StackName, access: Access, mode: SendImmediate, rhythm: Rhythm) -> Latency:
        """Return one of the latencies."""
        wanted = (stack, access, mode, rhythm)
        return next(row for row in self.latencies if (row.stack, row.access, row.send_immediate, row.rhythm) == wanted)

    def throughput(self, stack: StackName, access: Access, mode: SendImmediate) -> Throughput:
        """Return one of the throughputs."""
        wanted = (stack, access, mode)
        return next(row for row in self.throughputs if (row.stack, row.access, row.send_immediate) == wanted)

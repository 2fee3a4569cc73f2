"""The whole experiment in order, and the checks of its figures."""

from __future__ import annotations

import datetime as dt
import os
import platform
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import msgspec

import unity_link
from benchmarks.paper.build import MODEL
from benchmarks.paper.checks import check
from benchmarks.paper.forms import measure_forms
from benchmarks.paper.gateware import measure_gateware
from benchmarks.paper.latency import measure_arrivals, measure_effects, measure_latencies
from benchmarks.paper.lines import count_lines
from benchmarks.paper.publishing import measure_limits, measure_sustained
from benchmarks.paper.results import (
    STACKS,
    Arrival,
    Burst,
    Effect,
    Latency,
    Parameters,
    PublishLimit,
    Results,
    Stamps,
    Throughput,
)
from benchmarks.paper.throughput import measure_bursts, measure_stamps, measure_throughputs
from benchmarks.paper.variants import measure_media
from benchmarks.paper.wall_clock import measure_wall_clock
from benchmarks.paper.workbench import GatewayKind, Workbench, available_gateway
from unity_link.transport.ft232h import with_libusb

if TYPE_CHECKING:
    from collections.abc import Callable


class _Plan(NamedTuple):
    """Amounts of measurements."""

    accesses: int
    """Number of accesses whose mean is a latency."""
    latency_runs: int
    """Number of runs of which the best counts, here and below."""
    arrivals: int
    """Number of samples whose mean is a delay."""
    burst: int
    """Accesses of the shorter burst for a rate."""
    runs: int
    burst_sizes: tuple[int, ...]
    stamp_sizes: tuple[int, ...]
    publish_sizes: tuple[int, ...]
    publish_runs: int
    publish_rate: float
    """Rate in Hz at which one word is published."""
    publish_seconds: float
    media_accesses: int
    media_burst: int


_FULL = _Plan(
    accesses=100,
    latency_runs=5,
    arrivals=20,
    burst=3000,
    runs=2,
    burst_sizes=(1, 4, 18, 64, 200, 256, 1024, 4096),
    stamp_sizes=(18, 200, 1000),
    publish_sizes=(1, 2, 4, 8, 16, 64, 255),
    publish_runs=1,
    publish_rate=31_250,
    publish_seconds=0.5,
    media_accesses=100,
    media_burst=1000,
)
_QUICK = _Plan(
    accesses=20,
    latency_runs=1,
    arrivals=10,
    burst=400,
    runs=1,
    burst_sizes=(1, 18, 200, 512),
    stamp_sizes=(18, 200),
    publish_sizes=(1, 16),
    publish_runs=1,
    publish_rate=31_250,
    publish_seconds=0.02,
    media_accesses=10,
    media_burst=100,
)


def run_experiment(
    *,
    gateway: GatewayKind | None = None,
    quick: bool = False,
    host_time: bool = True,
    tell: Callable[[str], object] = lambda _: None,
) -> Results:
    """Run the whole experiment, in about ten minutes, or half a minute if `quick`, and return its results.

    No event loop may be running in this thread.

    Args:
        gateway: the gateway at the chip: ``"rtl"``, the compiled gateware, or ``"model"``, its Python model. By
            default the gateware if there is a C++ compiler, otherwise the model.
        quick: measure less, as a test; the figures must not be quoted.
        host_time: False to exclude the program's time, so that every run has the same results.
        tell: called with the name of each part when it begins.

    Raises:
        ConnectError: if pyftdi is not installed, or a C++ compiler is missing for ``"rtl"``.
    """
    kind = available_gateway() if gateway is None else gateway
    plan = _QUICK if quick else _FULL
    bench = Workbench(kind, counts_host_time=host_time)
    tell("the gateware alone")
    figures = measure_gateware(plan.publish_sizes) if kind == "rtl" else None
    latencies: list[Latency] = []
    effects: list[Effect] = []
    arrivals: list[Arrival] = []
    throughputs: list[Throughput] = []
    bursts: list[Burst] = []
    limits: list[PublishLimit] = []
    for stack in STACKS:
        tell(f"{stack}: single accesses")
        latencies += measure_latencies(bench, stack, plan.accesses, plan.latency_runs)
        tell(f"{stack}: writes to their effect")
        effects += measure_effects(bench, stack, plan.accesses, plan.latency_runs)
        tell(f"{stack}: samples to the program")
        arrivals += measure_arrivals(bench, stack, plan.arrivals)
        tell(f"{stack}: long bursts")
        throughputs += measure_throughputs(bench, stack, plan.burst, plan.runs)
        tell(f"{stack}: bursts of reads of all lengths")
        bursts += measure_bursts(bench, stack, plan.burst_sizes, plan.runs)
        tell(f"{stack}: limits of publishing")
        limits += measure_limits(bench, stack, plan.publish_sizes, plan.publish_runs)
    tell("bursts by the gateway's clock")
    # Not on the model, because its answers take no time.
    stamps: list[Stamps] = list(measure_stamps(bench, plan.stamp_sizes)) if kind == "rtl" else []
    tell("one word for a while")
    sustained = measure_sustained(bench, plan.publish_rate, plan.publish_seconds)
    tell("reads and writes by the clock on the wall")
    wall_clock = list(measure_wall_clock(plan.accesses)) if host_time else []
    tell("other media")
    media = list(measure_media(plan.media_accesses, plan.media_burst))
    tell("text and compact frames")
    forms = list(measure_forms(bench, plan.burst, plan.runs))
    results = Results(
        version=unity_link.__version__,
        date=f"{dt.datetime.now(dt.UTC):%Y-%m-%d}",
        parameters=_parameters(bench, quick=quick),
        gateware=figures,
        latencies=latencies,
        effects=effects,
        arrivals=arrivals,
        throughputs=throughputs,
        bursts=bursts,
        stamps=stamps,
        publish_limits=limits,
        sustained=sustained,
        wall_clock=wall_clock,
        media=media,
        forms=forms,
        lines=count_lines(),
        checks=[],
    )
    return msgspec.structs.replace(results, checks=check(results))


def describe_machine() -> str:
    """Return the processor's name, the operating system and the Python version."""
    model = platform.processor() or platform.machine()
    cpuinfo = Path("/proc/cpuinfo")
    for line in cpuinfo.read_text().splitlines() if cpuinfo.exists() else ():
        if line.startswith("model name"):
            model = line.partition(": ")[2]
            break
    return f"{model}, {os.cpu_count()} cores, {platform.system()}, Python {platform.python_version()}"


def _parameters(bench: Workbench, *, quick: bool) -> Parameters:
    return Parameters(
        gateway=bench.gateway,
        id_digits=MODEL.id_digits,
        address_bits=MODEL.address_bits,
        data_bits=MODEL.data_bits,
        receive_fifo_bytes=MODEL.receive_fifo_bytes,
        transmit_fifo_bytes=MODEL.transmit_fifo_bytes,
        base_frequency=MODEL.base_frequency_hz,
        timing={name: float(getattr(bench.timing, name)) for name in bench.timing.__struct_fields__},
        posted_reads=with_libusb.POSTED_READS,
        read_size=with_libusb.READ_SIZE,
        machine=describe_machine(),
        quick=quick,
    )

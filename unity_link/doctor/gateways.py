"""Checks on an open link: the gateway's version and map, FIFOs, round trip, throughput and noise.

The checks send ``h``, which has no effect on the bus. If the fingerprint of the gateway is not that of the spec, they
also read the gateway's description of itself.
"""

from __future__ import annotations

import asyncio
import statistics
import time
from typing import TYPE_CHECKING, NamedTuple
from urllib.parse import urlencode

from unity_link.data.describing import read_spec, shown_differences
from unity_link.doctor.findings import FaultName, Finding
from unity_link.errors import UnsupportedError
from unity_link.link.connecting import connect
from unity_link.protocol.wire.configuration import PROTOCOL_VERSION, Feature
from unity_link.protocol.wire.frames import COMPACT_END, LF
from unity_link.spec.comparing import compare
from unity_link.transport.ft232h.chip import SCHEMES, asked_baud, made_of

if TYPE_CHECKING:
    from collections.abc import AsyncIterator

    from unity_link.link.link import Link
    from unity_link.protocol.wire.configuration import GatewayInfo
    from unity_link.spec.model import Interface
    from unity_link.transport import DriverUrl

ROUND_TRIPS = 25
BURST = 100
"""Most requests in flight at a time."""
REQUESTS = 2_000
LONGEST_BURST = 1.5
"""Seconds after which no further burst is started."""
_FIFO_BYTES_PER_SECOND = 8e6
"""Bytes per second through an asynchronous FT245 FIFO."""
_BITS_PER_BYTE = 10
_LONGEST_ANSWER = 2.0
"""Seconds after which a gateway that has not answered counts as stalled."""
_REQUEST_BYTES = 13
"""Approximate size of the answer to an ``h``, in bytes; the request is shorter."""
_SLACK = 5e-3
"""Seconds that a busy computer may add to a round trip."""
_FEWEST_IN_FIFO = 4
"""Number of writes that a receive FIFO should hold, so that the host can send without waiting for answers."""
_LONG_LATENCY = 64
"""Latency timer in ms, far above any round trip: answers that arrive earlier were sent at once because of SIWU#."""


_OTHER_SPEC = "give the spec that the gateway was built from, or build the gateway from this one"


class Measured(NamedTuple):
    """Counts of a measurement with many requests."""

    requests: int
    seconds: float
    bytes_received: int
    damaged: int
    repetitions: int
    timeouts: int


async def check_gateway(url: DriverUrl, link: Link, interface: Interface | None) -> AsyncIterator[Finding]:
    """Yield the findings about a gateway on an open link. An error that ends the link is raised."""
    info = link.gateway
    yield Finding(
        "gateway",
        f"protocol version {info.protocol_version:02X}, as this host's {PROTOCOL_VERSION:02X}; "
        f"words of {info.data_bits} bits, addresses of {info.address_bits}; "
        f"{info.features.words or 'no features'}",
    )
    yield await _check_map(link, interface)
    rate = bytes_per_second(url)
    yield _check_fifo(info, url)
    round_trip = await _round_trip(link, ROUND_TRIPS)
    yield _judge_round_trip(round_trip, rate, info)
    measured = await _measure(link, rate)
    yield _judge_noise(measured)
    yield _judge_throughput(measured, rate)


def bytes_per_second(url: DriverUrl) -> float | None:
    """Return the bytes per second that a medium carries in each direction; None if that is not known."""
    if url.scheme == "serial":
        return url.integer("baud", 115_200) / _BITS_PER_BYTE
    if url.scheme not in SCHEMES:
        return None
    baud = asked_baud(url)
    return _FIFO_BYTES_PER_SECOND if baud is None else made_of(baud) / _BITS_PER_BYTE


async def _check_map(link: Link, interface: Interface | None) -> Finding:
    info = link.gateway
    named = Feature.FINGERPRINT in info.features
    if interface is None:
        return Finding(
            "map", f"{info.build_id:08X}, not compared: no SPEC was given" if named else "the gateway names none"
        )
    if named and info.build_id == interface.fingerprint:
        return Finding("map", f"{info.build_id:08X}, that of {interface.name}")
    if Feature.DESCRIPTION in info.features:
        return await _compare(link, interface)
    if not named:
        return Finding("map", f"the gateway has no fingerprint, so {interface.name} cannot be compared with it")
    return Finding(
        "map",
        f"the gateway was built for the map {info.build_id:08X}, and the spec of {interface.name} describes the map "
        f"{interface.fingerprint:08X}",
        FaultName.SPEC,
        _OTHER_SPEC,
    )


async def _compare(link: Link, interface: Interface) -> Finding:
    """Read the board's description of itself, and compare a spec with it."""
    try:
        differences = compare(interface, (await read_spec(link)).interface())
    except UnsupportedError as error:
        return Finding("map", str(error), FaultName.SPEC, _OTHER_SPEC)
    if not differences:
        return Finding("map", f"by its description, the gateway has all of {interface.name} alike")
    return Finding("map", shown_differences(differences), FaultName.SPEC, _OTHER_SPEC)


def _check_fifo(info: GatewayInfo, url: DriverUrl) -> Finding:
    size, flow = info.receive_fifo_bytes, Feature.FLOW_CONTROL in info.features
    held = f"the gateway's receive FIFO holds {size} bytes"
    if flow:
        return Finding("FIFO", f"{held}, and the line waits while it is full")
    # A write has one letter, the ID, an address, a word, the CRC and a line end.
    longest = 1 + info.id_digits + info.address_digits + info.data_digits + info.crc_bits // 4 + 1
    if size >= _FEWEST_IN_FIFO * longest:
        return Finding("FIFO", f"{held}: {size // longest} writes, without flow control")
    advice = "build the gateway with receive_fifo_bytes of 256 or more"
    if url.scheme == "serial":
        advice += ", or with flow control by RTS and CTS, and write rtscts=1 in the URL"
    return Finding(
        "FIFO",
        f"{held} without flow control: no more than {max(size // longest, 1)} of the writes can be under way, "
        "and the line is idle in between",
        FaultName.FIFO,
        advice,
    )


async def _round_trip(link: Link, count: int) -> float:
    """Return the median round trip of a single outstanding request, in seconds."""
    times = []
    for _ in range(count):
        began = time.perf_counter()
        async with asyncio.timeout(_LONGEST_ANSWER):
            await link.fence()
        times.append(time.perf_counter() - began)
    return statistics.median(times)


def _judge_round_trip(round_trip: float, rate: float | None, info: GatewayInfo) -> Finding:
    text = f"{_time(round_trip)}, median of {ROUND_TRIPS}"
    # Bytes of the request and the answer; the answer has one more field of an ID's size, the count of failed writes.
    size = 2 * (1 + info.id_digits + info.crc_bits // 4 + 1) + info.id_digits
    allowed = 0.0 if rate is None else size / rate
    if rate is not None:
        text += f"; the bytes take {_time(allowed)} of it"
    if round_trip <= 3 * allowed + _SLACK:
        return Finding("round trip", text)
    return Finding(
        "round trip",
        text + ": much more than the medium needs",
        FaultName.SLOW_LINK,
        "look at the latency timer of a USB adapter, at SIWU#, at a slow network, and at the load of this computer",
    )


async def check_send_immediate(url: DriverUrl, info: GatewayInfo) -> Finding:
    """Test if SIWU# makes a chip send at once: set a latency timer far longer than a round trip, and measure.

    Args:
        url: of a chip in a FIFO mode, which no program has open.
        info: configuration of the gateway.
    """
    last = COMPACT_END if url.compact and Feature.COMPACT in info.features else LF
    advice = f"write event_char={last[0]} in the URL: each frame's end then sends the packet; or wire SIWU# (ACBUS4)"
    if Feature.SEND_IMMEDIATE not in info.features:
        text = "the gateway was built without SIWU#: a lone answer waits for the latency timer"
        if "event_char" in url.options:
            return Finding("send at once", "by the event character: the gateway was built without SIWU#")
        return Finding("send at once", text, FaultName.SEND_IMMEDIATE, advice)
    options = {name: value for name, value in url.options.items() if name != "event_char"}
    options["latency"] = str(_LONG_LATENCY)
    async with connect(f"{url.scheme}://{url.host}{url.path}?{urlencode(options)}") as link:
        round_trip = await _round_trip(link, 5)
    if round_trip < _LONG_LATENCY / 2 * 1e-3:
        return Finding("send at once", "SIWU# works")
    if "event_char" in url.options:
        return Finding("send at once", "by the event character: SIWU# does not work")
    text = f"SIWU# does not work: with a latency timer of {_LONG_LATENCY} ms a lone answer took {_time(round_trip)}"
    return Finding("send at once", text, FaultName.SEND_IMMEDIATE, advice)


async def _measure(link: Link, rate: float | None) -> Measured:
    """Send many requests in bursts that suit a rate, and return the counts.

    Args:
        link: to the gateway.
        rate: bytes per second that the medium carries; None if that is not known.
    """
    before, began = link.statistics, time.perf_counter()
    burst = BURST if rate is None else min(BURST, max(1, int(rate * LONGEST_BURST / 4 / _REQUEST_BYTES)))
    done = 0
    while done < REQUESTS and time.perf_counter() - began < LONGEST_BURST:
        async with asyncio.timeout(_LONGEST_ANSWER):
            await asyncio.gather(*(link.fence() for _ in range(burst)))
        done += burst
    after = link.statistics
    return Measured(
        done,
        time.perf_counter() - began,
        after.bytes_received - before.bytes_received,
        after.damaged_frames - before.damaged_frames,
        after.repetitions - before.repetitions,
        after.timeouts - before.timeouts,
    )


def _judge_noise(measured: Measured) -> Finding:
    text = f"{measured.damaged} of {measured.requests:,} answers damaged, {measured.repetitions} requests sent again"
    if measured.damaged < 2:
        return Finding("noise", text)
    share = measured.damaged / max(measured.bytes_received, 1)
    return Finding(
        "noise",
        f"{text}: about one byte in {round(1 / share):,} is damaged or lost on the way",
        FaultName.NOISE,
        "shorten the cable, join the grounds, lower the speed, or, without flow control, look for lost bytes; the link "
        "retransmits lost requests, and is slower for it",
    )


def _judge_throughput(measured: Measured, rate: float | None) -> Finding:
    achieved = measured.bytes_received / measured.seconds
    text = f"{measured.requests / measured.seconds:,.0f} requests a second, {_rate(achieved)} of answers"
    if rate is None:
        return Finding("throughput", text)
    share = achieved / rate
    text += f": {share:.0%} of the {_rate(rate)} that the medium carries"
    if share >= 0.5:
        return Finding("throughput", f"{text}; the line is the limit")
    return Finding("throughput", f"{text}; blocks and batches bring more")


def _time(seconds: float) -> str:
    return f"{seconds * 1e3:.1f} ms" if seconds >= 1e-3 else f"{seconds * 1e6:.0f} µs"


def _rate(value: float) -> str:
    return f"{value / 1e6:.1f} MB/s" if value >= 1e6 else f"{value / 1e3:.1f} kB/s"

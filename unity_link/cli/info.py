"""`unity-link info`: shows the configuration of a gateway."""

from __future__ import annotations

import statistics
import time
from typing import TYPE_CHECKING

from unity_link.cli.arguments import DEFAULT_TIMEOUT, Json, Timeout, Url
from unity_link.cli.output import print_json, print_parts
from unity_link.cli.running import run

if TYPE_CHECKING:
    import typer

    from unity_link.link.link import Link
    from unity_link.protocol.wire.configuration import GatewayInfo

ROUND_TRIPS = 25
"""Number of fences that are measured: enough for a median, and quick on a slow serial line."""
_OF_FRAMES = frozenset({"protocol", "message IDs", "CRC", "blocks", "clock", "FIFOs", "build"})
"""Rows of `info` that do not apply to a bus mapped into memory."""


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(info)


def info(url: Url, *, json: Json = False, timeout: Timeout = DEFAULT_TIMEOUT) -> None:
    """Show the widths, clock and features of a gateway, and how quickly it answers."""
    run(_info(url, json=json, timeout=timeout))


async def _info(url: str, *, json: bool, timeout: float) -> None:
    from unity_link.link.connecting import connect
    from unity_link.transport import has_bus, parse_url
    from unity_link.transport.ft232h.chip import asked_baud, describe_baud, made_of

    async with connect(url, timeout=timeout) as link:
        round_trip = await _round_trip(link)
    baud = asked_baud(parse_url(url))
    if json:
        speed = {} if baud is None else {"baud": made_of(baud)}
        print_json({"url": url, **_fields(link.gateway), **speed, "round_trip_s": round_trip})
    else:
        rows = describe(link.gateway)
        if has_bus(parse_url(url)):
            rows = [(name, text) for name, text in rows if name not in _OF_FRAMES]
        if baud is not None:
            rows.append(("speed", describe_baud(baud)))
        _print(url, rows, round_trip)


async def _round_trip(link: Link) -> float:
    """Return the median round trip of single requests, in seconds."""
    times = []
    for _ in range(ROUND_TRIPS):
        start = time.perf_counter()
        await link.fence()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def _fields(gateway: GatewayInfo) -> dict[str, object]:
    fields = {name: getattr(gateway, name) for name in gateway.__struct_fields__}
    return fields | {"features": [feature.words for feature in gateway.features]}


def _print(url: str, rows: list[tuple[str, str]], round_trip: float) -> None:
    rows = [*rows, ("round trip", f"{1e6 * round_trip:.0f} µs, median of {ROUND_TRIPS}")]
    width = max(len(name) for name, _ in rows)
    print_parts((url, "bold"))
    for name, text in rows:
        print_parts((f"{name:<{width}}", "cyan"), "  ", text)


def describe(gateway: GatewayInfo) -> list[tuple[str, str]]:
    """Return the configuration of a gateway as pairs of a name and a text with units."""
    from unity_link.protocol.wire.configuration import Feature

    base = gateway.base_frequency_hz
    return [
        ("protocol", f"version {gateway.protocol_version:02X}"),
        ("words", f"{gateway.data_bits} bits"),
        ("addresses", f"{gateway.address_bits} bits, 0x{0:0{gateway.address_digits}X} to 0x{_highest(gateway):X}"),
        ("message IDs", f"{gateway.id_digits} hex digits, {16**gateway.id_digits // 2} requests in flight"),
        ("CRC", f"{gateway.crc_bits} bits, polynomial 0x{gateway.crc_polynomial:0{gateway.crc_bits // 4}X}"),
        ("blocks", f"up to {gateway.block_words} words in one bus transaction"),
        ("publishing", f"{gateway.groups} groups of up to {gateway.group_words} words, {base:,.10g} Hz / 1 to 65535"),
        ("clock", f"{gateway.clock_hz:,} Hz"),
        ("FIFOs", f"{gateway.receive_fifo_bytes} bytes in, {gateway.transmit_fifo_bytes} bytes out"),
        ("features", gateway.features.words or "none"),
        ("map" if Feature.FINGERPRINT in gateway.features else "build", f"0x{gateway.build_id:08X}"),
    ]


def _highest(gateway: GatewayInfo) -> int:
    return (1 << gateway.address_bits) - 1

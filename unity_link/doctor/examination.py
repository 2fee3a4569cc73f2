"""All checks, in the order in which they depend on each other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.doctor import computer
from unity_link.doctor.answers import explain_silence, find_echo, has_speed
from unity_link.doctor.findings import FaultName, Finding
from unity_link.doctor.gateways import check_gateway, check_send_immediate
from unity_link.doctor.media import check_medium, explain_failure
from unity_link.errors import ConnectError, UnansweredError, UnsupportedError
from unity_link.link.connecting import connect
from unity_link.transport import has_bus, parse_url
from unity_link.transport.ft232h.chip import SCHEMES, asked_baud

if TYPE_CHECKING:
    from collections.abc import AsyncIterator

    from unity_link.protocol.wire.configuration import GatewayInfo
    from unity_link.spec.model import Interface
    from unity_link.transport import DriverUrl

_BEARABLE = (None, FaultName.LATENCY, FaultName.LOSS, FaultName.DOUBLE, FaultName.BAUD)
"""Findings about a medium after which a link can still be opened."""
TIMEOUT = 2.5
"""Seconds until a gateway must have answered."""


async def examine(
    url: str | None = None,
    interface: Interface | None = None,
    *,
    timeout: float = TIMEOUT,
    duration: float = computer.DURATION,
) -> AsyncIterator[Finding]:
    """Run all checks in order. After a fault that makes later checks impossible, stop.

    Args:
        url: of the gateway; None to check only this computer.
        interface: the interface that the gateway should have.
        timeout: seconds until the gateway must have answered.
        duration: seconds for which delays of this computer are measured.

    Raises:
        ArgumentError: if the URL is malformed.
    """
    yield computer.describe_python()
    yield computer.describe_extras()
    for finding in await computer.check_speed(duration):
        yield finding
    if url is None:
        for finding in computer.list_ports():
            yield finding
        return
    try:
        parsed = parse_url(url)
    except ConnectError as error:
        yield explain_failure("driver", error)
        return
    unusable = False
    for finding in await check_medium(parsed):
        unusable = unusable or finding.fault not in _BEARABLE
        yield finding
    if not unusable and not has_bus(parsed):
        async for finding in _check_link(url, parsed, interface, timeout):
            yield finding


async def _check_link(
    url: str,
    parsed: DriverUrl,
    interface: Interface | None,
    timeout: float,
) -> AsyncIterator[Finding]:
    info: GatewayInfo | None = None
    try:
        async with connect(url, timeout=timeout) as link:
            info = link.gateway
            async for finding in check_gateway(parsed, link, interface):
                yield finding
    except UnsupportedError as error:
        yield Finding("gateway", str(error), FaultName.VERSION, "")
    except ConnectError as error:
        async for finding in explain_silence(parsed, error):
            yield finding
    except (UnansweredError, TimeoutError) as error:
        yield _explain_loss(error)
    else:
        if has_speed(parsed) and (echo := await find_echo(parsed)) is not None:
            yield echo
        if parsed.scheme in SCHEMES and asked_baud(parsed) is None:
            yield await check_send_immediate(parsed, info)


def _explain_loss(error: UnansweredError | TimeoutError) -> Finding:
    found = explain_failure("link", error)
    if found.fault is not FaultName.FAILED:
        return found
    reason = error.reason if isinstance(error, UnansweredError) else "the gateway does not answer any more"
    return Finding(
        "link",
        f"the gateway answered at first, then stopped answering: {reason}",
        FaultName.STALLED,
        "look at the clock, the power and the reset of the gateway, and at the program that serves it",
    )

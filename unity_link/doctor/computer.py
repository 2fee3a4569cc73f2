"""This computer: Python, the packages of each extra, the ports, and how late it runs tasks that are due."""

from __future__ import annotations

import asyncio
import importlib.metadata
import os
import platform
import re
import time
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from unity_link.doctor.findings import FaultName, Finding
from unity_link.errors import ConnectError
from unity_link.quoting import one_line

if TYPE_CHECKING:
    from collections.abc import Iterator

PACKAGE = "unity-link"
_EXTRA = re.compile(r"extra == ['\"]([^'\"]+)['\"]")
_NAME = re.compile(r"[A-Za-z0-9._-]+")
DURATION = 1.0
"""Seconds for which wake-ups are measured, if the user does not choose."""
SLEEP = 0.001
"""Seconds between wake-ups, if the computer is never late."""
LATEST = 0.005
"""Longest acceptable average delay of a wake-up, in seconds."""


def describe_python() -> Finding:
    """Return the versions of Python and of this package."""
    import unity_link

    return Finding("python", f"{platform.python_version()} on {platform.system()}, unity-link {unity_link.__version__}")


def describe_extras() -> Finding:
    """Return the installed extras. A missing one is no fault: a medium that needs it reports that."""
    packages: dict[str, list[str]] = {}
    try:
        requirements = importlib.metadata.requires(PACKAGE) or []
    except importlib.metadata.PackageNotFoundError:
        return Finding("extras", "unity-link is not installed, but run from its sources")
    for requirement in requirements:
        extra, name = _EXTRA.search(requirement), _NAME.match(requirement)
        if extra and name:
            packages.setdefault(extra[1], []).append(name[0])
    there = {extra: all(map(_is_installed, names)) for extra, names in packages.items()}
    texts = [
        f"{text} {', '.join(sorted(extra for extra in there if there[extra] is installed))}"
        for text, installed in (("installed:", True), ("not installed:", False))
        if installed in there.values()
    ]
    return Finding("extras", "; ".join(texts))


def _is_installed(package: str) -> bool:
    try:
        importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        return False
    return True


class Wakes(NamedTuple):
    """Delays of an event loop that ran one task, which slept for `SLEEP` seconds again and again."""

    number: int
    seconds: float
    """Time measured."""
    longest: float
    """Longest delay of one wake-up, in seconds."""

    @property
    def average(self) -> float:
        """Average delay of a wake-up, in seconds."""
        return max(0.0, self.seconds / self.number - SLEEP)


async def check_speed(duration: float = DURATION) -> list[Finding]:
    """Return how late this computer runs a task that is due: the average and the longest delay.

    The average is a fault if it exceeds `LATEST` in two measurements. The longest delay is never a fault; it is a lower
    limit for the time-out of a lease.

    Args:
        duration: seconds of each measurement.
    """
    wakes = again = await measure_wakes(duration)
    if wakes.average > LATEST:
        again = await measure_wakes(duration)
    late = min(wakes.average, again.average)
    if late <= LATEST:
        speed = Finding("computer", f"runs tasks that are due within {_time(late)}, on average")
    else:
        load = f", at a load of {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores" if hasattr(os, "getloadavg") else ""
        speed = Finding(
            "computer",
            f"this computer is slow to run tasks that are due: {_time(late)} late on average{load}",
            FaultName.SLOW_HOST,
            "end other programs, leave power saving, or give the program a higher priority (nice, chrt)",
        )
    worst = max(wakes, again, key=lambda measured: measured.longest)
    text = f"{_time(worst.longest)} at most, of {worst.number:,} wake-ups in {worst.seconds:.1f} s"
    return [speed, Finding("pause", f"{text}; the time-out of a lease must be longer")]


async def measure_wakes(duration: float) -> Wakes:
    """Sleep for `SLEEP` seconds again and again, for `duration` seconds in total. Return the delays of the wake-ups."""
    began = last = time.perf_counter()
    count, longest = 0, 0.0
    while count == 0 or last - began < duration:
        await asyncio.sleep(SLEEP)
        now = time.perf_counter()
        count, longest, last = count + 1, max(longest, now - last - SLEEP), now
    return Wakes(count, last - began, longest)


def _time(seconds: float) -> str:
    return f"{seconds * 1e3:.1f} ms"


def list_ports() -> Iterator[Finding]:
    """Yield the ports to which a gateway may be connected: serial ports and FTDI chips."""
    from serial.tools.list_ports import comports

    from unity_link.doctor.media import check_permission

    ports = sorted(comports(), key=lambda port: port.device)
    for port in ports:
        if Path(port.device).exists() and (denied := check_permission(port.device)):
            yield denied
        else:
            yield Finding("port", f"serial:{port.device}  {one_line(port.description)}")
    chips = list(_list_chips())
    yield from chips
    if not ports and not chips:
        yield Finding("port", "no serial port, no FT232H and no FT2232H is plugged in")


def _list_chips() -> Iterator[Finding]:
    from unity_link.transport.ft232h.chip import list_chips

    try:
        for url, description in list_chips():
            yield Finding("port", f"{url}  {description}")
    except ConnectError as error:
        # This is no fault: many computers need no FTDI chips.
        yield Finding("port", f"FTDI chips cannot be looked for: {error}")

"""Checks of the port or chip that a URL names, before a link is opened: existence, permission and settings."""

from __future__ import annotations

import asyncio
import errno
import os
from pathlib import Path
from typing import TYPE_CHECKING

from unity_link.doctor.findings import FaultName, Finding
from unity_link.doctor.network import check_network
from unity_link.errors import ConnectError
from unity_link.transport import has_bus, open_bus
from unity_link.transport.ft232h.chip import SCHEMES as CHIP_SCHEMES
from unity_link.transport.ft232h.chip import UDEV_LINE, UDEV_RULE, describe_baud, find_errno, made_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.transport import DriverUrl

LONGEST_LATENCY = 4
"""Longest acceptable latency timer, in ms; a longer one determines the round trip."""
MOST_BAUD_ERROR = 0.01
"""Relative error of a rate above which a UART may fail. The errors of both ends together may be 2 to 4 %."""
_CHIP_CLOCK = 12_000_000
_SYSTEM = Path("/sys")
_PROCESSES = Path("/proc")
_SHARE = "close that program, or share the link: unity-link serve"
_FAULTS = {
    errno.EACCES: (FaultName.PERMISSION, ""),
    errno.EPERM: (FaultName.PERMISSION, ""),
    errno.EBUSY: (FaultName.BUSY, _SHARE),
    errno.EAGAIN: (FaultName.BUSY, _SHARE),
    errno.ENOENT: (FaultName.UNPLUGGED, "plug it in, and look at its name: unity-link doctor lists what is there"),
    errno.ENODEV: (FaultName.UNPLUGGED, "plug it in again, and look at the cable and the hub"),
    errno.ENXIO: (FaultName.UNPLUGGED, "plug it in again, and look at the cable and the hub"),
    errno.EIO: (FaultName.UNPLUGGED, "plug it in again, and look at the cable and the hub"),
    errno.ECONNREFUSED: (FaultName.ABSENT, "start what serves the gateway, or correct the address"),
    errno.ETIME: (
        FaultName.STALLED,
        "look at the clock and the reset of the gateware, the wiring, and the mode of the FIFO",
    ),
}


def explain_failure(check: str, error: BaseException) -> Finding:
    """Return a finding, with advice, for the error with which a medium could not be opened or was lost."""
    text = str(error)
    fault, advice = _FAULTS.get(find_errno(error) or 0, (FaultName.FAILED, ""))
    if isinstance(error.__cause__, ImportError) or "is not installed" in text:
        fault = FaultName.MISSING
    elif "no such FTDI chip" in text:
        fault, advice = _FAULTS[errno.ENODEV]
    elif text.endswith(("is it listening?", "is it served?")):
        fault, advice = _FAULTS[errno.ECONNREFUSED]
    elif "no permission for the FTDI chip" in text:
        fault = FaultName.PERMISSION
    if fault is FaultName.PERMISSION and "FTDI chip" in text:
        advice = f"write this line into {UDEV_RULE}, then unplug it and plug it in again: {UDEV_LINE}"
    return Finding(check, text, fault, advice)


async def check_medium(url: DriverUrl) -> list[Finding]:
    """Return the findings about a port, a chip, a network or a mapped memory.

    Only a network check sends requests, and these have no effect.
    """
    if url.scheme == "serial":
        return list(_check_port(url))
    if url.scheme == "udp":
        return await check_network(url)
    if url.scheme in CHIP_SCHEMES:
        return await asyncio.get_running_loop().run_in_executor(None, lambda: list(_check_chip(url)))
    return [_check_memory(url)] if has_bus(url) else []


def _check_memory(url: DriverUrl) -> Finding:
    try:
        bus = open_bus(url)
    except ConnectError as error:
        return Finding("memory", str(error), FaultName.FAILED)
    words = len(bus.words)
    bus.close()
    return Finding("memory", f"{words:,} words of {bus.info.data_bits} bits are mapped, without a gateway in between")


# Serial ports


def _check_port(url: DriverUrl) -> Iterator[Finding]:
    path = url.path
    if not Path(path).exists():
        missing = FileNotFoundError(errno.ENOENT, f"there is no port {path}; is the adapter plugged in?")
        yield Finding("port", str(missing.strerror), *_FAULTS[errno.ENOENT])
        return
    if denied := check_permission(path):
        yield denied
        return
    holders = list(_holders(Path(path)))
    yield Finding("port", f"{path} is there" + (f", and open in {', '.join(holders)}" if holders else ""))
    latency = adapter_latency(path)
    if latency is not None:
        yield _judge_latency("port", latency, f"run: echo 1 | sudo tee {_latency_file(path, _SYSTEM)}")


def check_permission(path: str) -> Finding | None:
    """Return a finding with advice if this user may not open a port; otherwise None."""
    if os.access(path, os.R_OK | os.W_OK):
        return None
    group = Path(path).group()
    return Finding(
        "port",
        f"no permission for {path}, which belongs to the group {group}",
        FaultName.PERMISSION,
        f"run: sudo usermod -aG {group} $USER, and log in again; or write a udev rule: "
        f'KERNEL=="{Path(path).name}", MODE="0660", TAG+="uaccess"',
    )


def adapter_latency(path: str, system: Path = _SYSTEM) -> int | None:
    """Return the latency timer of a serial adapter in ms, as the kernel reports it; None if it has no such timer."""
    try:
        return int(_latency_file(path, system).read_text())
    except (OSError, ValueError):
        return None


def _latency_file(path: str, system: Path) -> Path:
    return system / "class" / "tty" / Path(path).resolve().name / "device" / "latency_timer"


def _judge_latency(check: str, latency: int, advice: str) -> Finding:
    if latency <= LONGEST_LATENCY:
        return Finding(check, f"the latency timer is {latency} ms")
    text = f"the latency timer is {latency} ms: a lone answer may wait that long in the adapter"
    return Finding(check, text, FaultName.LATENCY, advice)


def _holders(path: Path) -> Iterator[str]:
    """Yield the other programs of this user that have a file open. Programs of other users cannot be seen."""
    target = path.resolve()
    for process in _PROCESSES.glob("[0-9]*"):
        if process.name == str(os.getpid()):
            continue
        try:
            if any(opened.resolve() == target for opened in (process / "fd").iterdir()):
                yield f"{(process / 'comm').read_text().strip()} (process {process.name})"
        except OSError:
            continue


# FTDI chips


def _check_chip(url: DriverUrl) -> Iterator[Finding]:
    from unity_link.transport.ft232h.chip import base_url, open_chip, settings_of
    from unity_link.transport.ft232h.eeprom import read_info

    try:
        chip = open_chip(url, check=False)
        try:
            content = read_info(chip)
            wanted = "UART" if settings_of(url).mode == "uart" else "FIFO"
            if content.channel_type != wanted:
                advice = (
                    f"run: unity-link ft232h configure {base_url(url)} --mode {wanted.lower()}, "
                    f"then unplug the {content.chip} and plug it in again"
                )
                text = f"{content.description}, but mode={settings_of(url).mode} needs {wanted}"
                yield Finding("chip", text, FaultName.EEPROM, advice)
                return
            yield Finding(
                "chip", f"{content.description} ({content.product}, serial number {content.serial or 'none'})"
            )
            if wanted == "UART":
                yield _judge_baud(chip.settings.baud)
            chip.configure()
            latency = chip.ftdi.get_latency_timer()
        finally:
            chip.close()
    except (ConnectError, OSError) as error:
        yield explain_failure("chip", error)
        return
    yield _judge_latency("chip", latency, "leave latency= out of the URL: the driver then sets 1 ms")


def _judge_baud(baud: int) -> Finding:
    """Return a finding about a rate in bits/s; a fault if the chip can only make one that is too far off for a UART."""
    text = describe_baud(baud)
    if abs(made_of(baud) / baud - 1) <= MOST_BAUD_ERROR:
        return Finding("speed", text)
    exact = _CHIP_CLOCK // -(-_CHIP_CLOCK // baud)
    advice = f"write a rate that the chip makes, such as baud={exact}, and build the gateware for that"
    return Finding("speed", f"{text}: a UART needs both ends within about 2 %", FaultName.BAUD, advice)

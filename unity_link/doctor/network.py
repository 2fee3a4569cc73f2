"""Checks of the path to a gateway on the network: does the station exist, do datagrams arrive, and how many are lost.

The checks send plain requests ``H``, which have no effect and begin no session.
"""

from __future__ import annotations

import asyncio
import contextlib
import errno
import ipaddress
import select
import socket
import struct
import sys
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from unity_link.doctor.findings import FaultName, Finding
from unity_link.errors import ConnectError
from unity_link.transport.finding import find
from unity_link.transport.tcp import address
from unity_link.transport.udp import Settings, refused

if TYPE_CHECKING:
    from unity_link.transport import DriverUrl

QUESTIONS = 100
"""Number of datagrams that are sent, each after the answer to the last."""
FIRST_PATIENCE = 0.6
"""Seconds to wait for each answer before the first has arrived: the system must find the station's MAC address."""
FIRST_QUESTIONS = 5
"""Number of unanswered datagrams, without any answer, after which the check ends."""
PATIENCE = 0.1
FIND_PATIENCE = 0.4
"""Seconds in which boards answer a discovery request."""
MOST_LOST = 20
"""Number of unanswered datagrams, with some answers, after which the check ends."""
_QUESTION = b"H\r"
_NEIGHBOURS = Path("/proc/net/arp")
_COMPLETE = 0x2
"""Linux: flag of a neighbour whose MAC address is known (ATF_COM)."""
_IP_RECVERR = 11
_MSG_ERRQUEUE = 0x2000
_ERROR = struct.Struct("@I4B")
"""Linux: first fields of `struct sock_extended_err`: errno, origin, type, code."""
_FROM_ICMP = 2
_UNREACHABLE = 3
_PROHIBITED = frozenset({9, 10, 13})
"""ICMP codes with which a firewall rejects a datagram."""
_ABSENT_ADVICE = "start what serves the gateway, or correct the port in the URL"
_FIREWALL_ADVICE = (
    "let UDP from and to that port pass, at this computer and on the way: sudo nft list ruleset shows its rules"
)


class Questioned(NamedTuple):
    """Results of the requests."""

    asked: int
    answered: int
    refusal: str
    """Error message of the system or the network; empty if there was none."""
    fault: FaultName | None


async def check_network(url: DriverUrl) -> list[Finding]:
    """Return the findings about the path to a gateway: the station, lost datagrams, and duplicate addresses."""
    findings = await asyncio.get_running_loop().run_in_executor(None, _check, url)
    if all(finding.fault in (None, FaultName.LOSS) for finding in findings):
        findings += await _doubles(url)
    return findings


async def _doubles(url: DriverUrl) -> list[Finding]:
    """Return a finding if several boards have the address of a URL. All boards answer a broadcast with their MAC."""
    host, port = address(url)
    with contextlib.suppress(ConnectError, OSError):
        there = await asyncio.get_running_loop().getaddrinfo(host, port, family=socket.AF_INET, type=socket.SOCK_DGRAM)
        boards = [board for board in await find([], port, patience=FIND_PATIENCE) if board.address == there[0][4][0]]
        names = [f"{board.mac} ({board.found.name})" if board.found.name else board.mac for board in boards]
        if len({board.mac for board in boards}) > 1:
            return [
                Finding(
                    "address",
                    f"{host} is the address of {' and '.join(names)}: which of them answers changes",
                    FaultName.DOUBLE,
                    "give each another one: unity-link find --assign MAC=ADDRESS, or build --ip",
                )
            ]
        if any(board.doubled for board in boards):
            return [
                Finding(
                    "address",
                    f"two boards have the MAC address {boards[0].mac}, and the address {host}",
                    FaultName.DOUBLE,
                    "build one of them with another: unity-link build --mac",
                )
            ]
    return []


def _check(url: DriverUrl) -> list[Finding]:
    host, port = address(url)
    try:
        with refused(host, port):
            opened = Settings.of(url).connected(socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM))
    except ConnectError as error:
        fault = _by_number(error.__cause__)[1] if isinstance(error.__cause__, OSError) else None
        advice = _FIREWALL_ADVICE if fault else "look at `ip route`, and at the cable"
        return [Finding("network", str(error), fault or FaultName.FAILED, advice)]
    with opened:
        own, there = opened.getsockname()[0], opened.getpeername()[0]
        heard = _ask(opened)
    where = f"{there} from {own}"
    if heard.answered:
        mac = neighbour(there)
        return [Finding("network", where + (f"; the station is {mac}" if mac else "")), judge_loss(heard)]
    if heard.fault is FaultName.ABSENT:
        return [Finding("network", f"{there} reports that port {port} is closed", heard.fault, _ABSENT_ADVICE)]
    if heard.fault is FaultName.FIREWALL:
        return [
            Finding(
                "network",
                f"{heard.refusal}: a firewall drops datagrams to port {port} of {there}",
                heard.fault,
                _FIREWALL_ADVICE,
            )
        ]
    return [_explain_silence(own, there, port, where)]


def _explain_silence(own: str, there: str, port: int, where: str) -> Finding:
    if ipaddress.ip_address(there.partition("%")[0]).is_loopback:
        return Finding("network", where)
    mac = neighbour(there)
    if mac:
        return Finding(
            "network",
            f"the station {mac} has the address {there}, and answers no datagram at port {port}",
            FaultName.FIREWALL,
            "a firewall drops them, at this computer or there, or the port is another one; " + _FIREWALL_ADVICE,
        )
    if mac == "":
        return Finding(
            "network",
            f"no station has the address {there} in the network that {own} is in",
            FaultName.NOBODY,
            "look at the power, the cable and the lights of the port; unity-link find lists the boards that are there",
        )
    return Finding(
        "network",
        f"{there} is in no network of this computer, and does not answer",
        FaultName.NOBODY,
        f"give this computer an address in the board's network as well as {own}, or give the board one in this "
        "network: unity-link find --assign MAC=ADDRESS",
    )


def neighbour(there: str) -> str | None:
    """Return the MAC address of a neighbour; empty if the system looked for it in vain, None if it did not look."""
    with contextlib.suppress(OSError):
        for line in _NEIGHBOURS.read_text().splitlines()[1:]:
            fields = line.split()
            if fields[0] == there:
                return fields[3] if int(fields[2], 16) & _COMPLETE else ""
    return None


def _ask(opened: socket.socket) -> Questioned:
    """Send the request repeatedly, each time after the answer has arrived or is overdue."""
    has_error_queue = sys.platform == "linux"
    if has_error_queue:
        opened.setsockopt(socket.IPPROTO_IP, _IP_RECVERR, 1)
    asked = answered = 0
    refusal, fault = "", None
    while asked < QUESTIONS and asked - answered < (MOST_LOST if answered else FIRST_QUESTIONS):
        asked += 1
        try:
            opened.send(_QUESTION)
            if select.select([opened], [], [], PATIENCE if answered else FIRST_PATIENCE)[0]:
                opened.recv(2048)
                answered += 1
        except OSError as error:
            refusal, fault = _refusal(opened, error) if has_error_queue else _by_number(error)
            if fault is not None:
                break
    return Questioned(asked, answered, refusal, fault)


def _refusal(opened: socket.socket, error: OSError) -> tuple[str, FaultName | None]:
    """Return the meaning of a socket error, and its fault. An ICMP message in the error queue takes precedence."""
    with contextlib.suppress(OSError):
        _, ancillary, _, _ = opened.recvmsg(0, 512, _MSG_ERRQUEUE)
        for _, _, data in ancillary:
            _, origin, kind, code, _ = _ERROR.unpack_from(data)
            if origin == _FROM_ICMP and kind == _UNREACHABLE and code in _PROHIBITED:
                return f"ICMP says that it is administratively prohibited (code {code})", FaultName.FIREWALL
    return _by_number(error)


def _by_number(error: OSError) -> tuple[str, FaultName | None]:
    message = error.strerror or str(error)
    if error.errno in (errno.EPERM, errno.EACCES):
        return f"the system refuses to send ({message})", FaultName.FIREWALL
    return message, FaultName.ABSENT if error.errno == errno.ECONNREFUSED else None


def judge_loss(heard: Questioned) -> Finding:
    """Return a finding about the unanswered datagrams; two or more are a fault."""
    lost = heard.asked - heard.answered
    text = f"{lost} of {heard.asked} datagrams not answered"
    if lost < 2:
        return Finding("loss", text)
    return Finding(
        "loss",
        f"{text}: about one in {round(heard.asked / lost)} is lost on the way there or back",
        FaultName.LOSS,
        "look at the cable, at the errors that `ip -s link` counts, at a port with half duplex, and at what else is on "
        "the network; the link retransmits lost requests, and is slower for it",
    )

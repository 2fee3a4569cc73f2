"""Diagnosis of a medium where no gateway answers: the own bytes, another speed, another protocol, or nothing."""

from __future__ import annotations

import asyncio
import contextlib
import re
from typing import TYPE_CHECKING, NamedTuple

import msgspec

from unity_link.doctor import garbage
from unity_link.doctor.findings import FaultName, Finding
from unity_link.doctor.media import explain_failure
from unity_link.errors import ConnectError
from unity_link.protocol.host.handshake import LINE_ENDS
from unity_link.protocol.wire.crc import Crc
from unity_link.protocol.wire.frames import LF, Framing
from unity_link.transport import load_driver, open_medium
from unity_link.transport.ft232h.chip import asked_baud

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable

    from unity_link.transport import DriverUrl

PATIENCE = 0.5
"""Seconds to wait for an answer of any device."""
PATIENCE_FOR_A_SPEED = 0.15
SPEEDS = (115_200, 1_000_000, 921_600, 3_000_000, 12_000_000, 2_000_000, 460_800, 230_400, 57_600, 9_600)
"""Bits a second that are tried, the usual ones first."""
_ANSWER = re.compile(rb"Q[0-9A-F]{64}")
_LINE_ENDS = re.compile(rb"[\r\n]+")
_HTTP_REQUEST = b"GET / HTTP/1.0\r\n\r\n"
_PROTOCOLS = (
    (b"HTTP/", "HTTP"),
    (b"<!DOCTYPE", "HTTP"),
    (b"<html", "HTTP"),
    (b"SSH-", "SSH"),
    (b"220 ", "FTP or SMTP"),
    (b"220-", "FTP or SMTP"),
    (b"\x15\x03", "TLS"),
    (b"-ERR", "Redis"),
    (b"+OK", "POP3"),
    (b"RFB ", "VNC"),
    (b"\xff\xfb", "Telnet"),
    (b"\xff\xfd", "Telnet"),
    (b"login:", "a login"),
)
_TAKEN = b"this gateway serves another client"
_LONGEST_QUOTE = 60


class Heard(NamedTuple):
    """Bytes heard after a question."""

    sent: bytes
    data: bytes
    ended: bool
    """True if the other end closed the connection."""


class _Listener(asyncio.Protocol):
    """Collects what comes until it is enough."""

    def __init__(self, enough: Callable[[bytes], object]) -> None:
        self.data = b""
        self.ended = False
        self.done = asyncio.Event()
        self._enough = enough

    def data_received(self, data: bytes) -> None:
        self.data += data
        if self._enough(self.data):
            self.done.set()

    def connection_lost(self, exc: Exception | None) -> None:  # noqa: ARG002  (what it is shows when it is opened)
        self.ended = True
        self.done.set()


async def listen(
    url: DriverUrl, sent: bytes, seconds: float, enough: Callable[[bytes], object] = _ANSWER.search
) -> Heard:
    """Open a medium, send bytes, and return what came until it was enough or the time was over.

    Raises:
        ConnectError: where it cannot be opened.
    """
    listener = _Listener(enough)
    transport = await open_medium(_unshared(url), listener)
    try:
        transport.write(sent)
        with contextlib.suppress(TimeoutError):
            async with asyncio.timeout(seconds):
                await listener.done.wait()
        heard = Heard(sent, listener.data, listener.ended)
    finally:
        transport.abort()
        # A port is free for the next attempt in a later turn of the loop.
        await asyncio.sleep(0.01)
    return heard


def _unshared(url: DriverUrl) -> DriverUrl:
    """Return the URL of a port that is not shared with links to other nodes: on a shared port only a link may send."""
    if not getattr(load_driver(url.scheme), "NODES_SHARE", False):
        return url
    options = {name: value for name, value in url.options.items() if name != "node"}
    return msgspec.structs.replace(url, options=options)


async def explain_silence(url: DriverUrl, error: ConnectError) -> AsyncIterator[Finding]:
    """Yield the reasons found for the silence of a gateway at a medium.

    Args:
        url: of the medium.
        error: why a link could not be opened.
    """
    if LINE_ENDS in str(error):
        advice = "make it raw: a terminal server (ser2net: raw, not telnet), or the port, if another program has set it"
        yield Finding("answer", LINE_ENDS, FaultName.LINE_ENDS, advice)
        return
    question = _question(url)
    try:
        heard = await listen(url, question, PATIENCE)
    except ConnectError as failure:
        yield explain_failure("port", failure)
        return
    found = _recognise(heard)
    if found is None and has_speed(url):
        found = await _try_speeds(url, question, heard)
    if found is None and url.scheme == "tcp":
        found = _recognise(await listen(url, _HTTP_REQUEST, PATIENCE, len))
    yield found or _unrecognised(heard, error)


async def find_echo(url: DriverUrl) -> Finding | None:
    """Return what is wrong at a medium on which a gateway answers, and what is sent comes back as well; else None."""
    found = _recognise(await listen(url, _question(url), PATIENCE))
    return found if found is not None and found.fault is FaultName.LOOPBACK else None


def _question(url: DriverUrl) -> bytes:
    return LF + Framing(Crc(), url.node).plain_request(b"Q")


def has_speed(url: DriverUrl) -> bool:
    """Return whether the host's end of a medium has a speed that can be wrong."""
    return url.scheme == "serial" or asked_baud(url) is not None


def _recognise(heard: Heard) -> Finding | None:
    """Return what is known for sure by what came."""
    data = heard.data
    # An echo is a frame of its own: the answer to `Q` begins with the same letter.
    if heard.sent.strip() in _LINE_ENDS.split(data):
        if _ANSWER.search(data):
            text = "what is sent comes back before the answer: the adapter, or the transceiver, echoes"
            advice = (
                "switch its echo off, or its receiver while it sends (/RE to DE): links pass it over, and it takes "
                "the line from the answers"
            )
        else:
            text = "what is sent comes back as it is: TX is connected to RX (loopback)"
            advice = "connect TX to the gateway's rx and RX to its tx, and no jumper; switch off an adapter's echo"
        return Finding("answer", text, FaultName.LOOPBACK, advice)
    if data.startswith(_TAKEN):
        return Finding(
            "answer",
            "the gateway serves another program, and one at a time",
            FaultName.BUSY,
            "close that program, or share the link: unity-link serve",
        )
    for beginning, name in _PROTOCOLS:
        if data.lstrip().lower().startswith(beginning.lower()):
            text = f"{name} answers there, and not a gateway: {_quote(data)}"
            return Finding("answer", text, FaultName.PROTOCOL, "correct the port in the URL")
    return None


async def _try_speeds(url: DriverUrl, question: bytes, heard: Heard) -> Finding | None:
    """Return at which other speed a gateway answers; where none does, what the pattern of the garbage says."""
    tried = url.integer("baud", 115_200)
    for speed in SPEEDS:
        if speed == tried:
            continue
        other = msgspec.structs.replace(url, options={**url.options, "baud": str(speed)})
        try:
            answer = await listen(other, question, PATIENCE_FOR_A_SPEED)
        except ConnectError:
            continue
        if _ANSWER.search(answer.data):
            text = f"the gateway answers at {speed} baud, and the URL says {tried}"
            if heard.data and not garbage.is_text(heard.data):
                text += f" ({garbage.describe(heard.data)})"
            return Finding("answer", text, FaultName.BAUD, f"write baud={speed} in the URL")
    if heard.data and not garbage.is_text(heard.data):
        text = f"what comes is no text: {heard.data[:16].hex(' ')}; {garbage.describe(heard.data)}"
        advice = f"write in the URL, as baud=, the speed that the gateware was built for: it is not {tried}"
        return Finding("answer", text, FaultName.BAUD, advice)
    return None


def _unrecognised(heard: Heard, error: ConnectError) -> Finding:
    if _ANSWER.search(heard.data):
        return Finding(
            "answer",
            f"a gateway is there, and no session begins with it ({error})",
            FaultName.NOISE,
            "look at the line: cable, ground, speed, or something else that sends on it",
        )
    if heard.data:
        text = f"what answers is no gateway: {_quote(heard.data)}"
        return Finding("answer", text, FaultName.PROTOCOL, "correct the URL, or look at what is connected there")
    if heard.ended:
        text = "the other end takes the connection and closes it without a word"
        return Finding("answer", text, FaultName.PROTOCOL, "correct the port in the URL; a shared link may want token=")
    return Finding(
        "answer",
        "the medium is open and takes bytes, and nothing comes back",
        FaultName.STALLED,
        "look whether the gateway is powered, configured and out of reset, and whether the wires are crossed; "
        "what serves it may stand still",
    )


def _quote(data: bytes) -> str:
    line = data.strip().split(b"\n")[0][:_LONGEST_QUOTE].decode("ascii", "replace").strip()
    return repr(line)

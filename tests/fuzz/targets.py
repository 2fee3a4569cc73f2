"""Readers of untrusted bytes, each as a function of one input: it returns, or our own error refuses the input.

A function must not raise for any input: an exception that it does not catch is a defect. `test_corpus.py` replays known
inputs; ``python -m fuzz TARGET SECONDS`` searches for others by coverage.
"""

from __future__ import annotations

import contextlib
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

from fuzz import serving
from fuzz.choices import Choices
from unity_link.bridges.live.writing import Hello, Stop, Write
from unity_link.bridges.recording.reader import Recording
from unity_link.bridges.recording.replay import replay
from unity_link.capture.transcript import Transcript
from unity_link.errors import UnityLinkError
from unity_link.protocol.host.requests import Request
from unity_link.protocol.host.session import Session
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.crc import Crc
from unity_link.protocol.wire.frames import FrameError, Framing
from unity_link.spec import compile_text, format_text
from unity_link.transport import snoop
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.protocol.host.host_codec import HostCodec

LONGEST_ANSWER = 1 << 20
"""Largest number of bytes that a gateway may answer to an input; blocks and samples have the requested size."""
_FRAMINGS = [
    Framing(Crc(bits, polynomial), node)
    for bits, polynomial in ((8, 0x07), (16, 0x1021), (32, 0x04C11DB7))
    for node in (None, 5)
]
_COMPACT = GatewayInfo(features=GatewayInfo().features | Feature.COMPACT)
_FOLDER = Path(tempfile.mkdtemp(prefix="unity-link-fuzz."))


def frames(data: bytes) -> None:
    """Open lines with each CRC, and decode both directions into words."""
    for line in data.split(b"\n"):
        for framing in _FRAMINGS:
            with contextlib.suppress(FrameError):
                framing.open(line)
    transcript = Transcript()
    for sent in (True, False):
        list(transcript.take(data, 0.0, sent=sent))
    list(transcript.end(1.0))


def configuration(data: bytes) -> None:
    """Decode a text as a gateway's configuration; if it is accepted, encoding it gives the same configuration."""
    with contextlib.suppress(UnityLinkError, ValueError):
        info = GatewayInfo.from_hex(data)
        assert GatewayInfo.from_hex(info.to_hex()) == info


def gateway(data: bytes) -> None:
    """Send bytes in two pieces to gateways with and without the compact form, while time passes."""
    cut = data[0] * len(data) // 256 if data else 0
    for heard in (VirtualGateway(), VirtualGateway(_COMPACT)):
        answered = 0
        for now, part in ((0.0, data[1:cut]), (0.1, data[cut:])):
            answered += len(heard.receive(part, now))
        due = heard.next_due
        if due is not None:
            answered += len(heard.advance(due))
        assert answered < LONGEST_ANSWER


class _Line:
    """A session with a gateway, over a line that the input disturbs."""

    def __init__(self, choices: Choices) -> None:
        self._choices, self._far = choices, VirtualGateway()
        self._near = Session(None, lambda: 0x5A, resumes=bool(choices.number() & 1))
        self._now, self._back, self.asked = 0.0, bytearray(), list[Request]()
        self._near.connect(self._now, 0.003)
        self._steps = (
            self._hear,
            self._answer,
            self._say,
            self._ask,
            self._wait,
            self._damage,
            self._lose,
            self._reset,
        )

    def step(self) -> None:
        """Perform the action of the next byte."""
        self._steps[self._choices.number() % len(self._steps)]()

    def end(self) -> None:
        """End the connection."""
        self._near.disconnect("the input has ended")

    def _hear(self) -> None:
        self._back += self._far.receive(self._near.take_output(), self._now)

    def _answer(self) -> None:
        self._near.receive(bytes(self._back), self._now)
        self._back.clear()

    def _say(self) -> None:
        self._near.receive(self._choices.take(self._choices.number() % 64), self._now)

    def _ask(self) -> None:
        if self._near.is_open:
            request = _request(self._near.codec, self._choices)
            self._near.submit(request, self._now)
            self.asked.append(request)

    def _wait(self) -> None:
        self._now += self._choices.number() / 64
        if self._near.deadline is not None and self._near.deadline <= self._now:
            self._near.expire(self._now)

    def _damage(self) -> None:
        if self._back:
            self._back[self._choices.number() % len(self._back)] ^= 1 << self._choices.number() % 8

    def _lose(self) -> None:
        if self._back:
            del self._back[: self._choices.number() % len(self._back)]

    def _reset(self) -> None:
        self._far.reset()


def session(data: bytes) -> None:
    """Run a session over a line that the input disturbs; no request has both an answer and an error."""
    choices = Choices(data)
    line = _Line(choices)
    while choices:
        line.step()
    line.end()
    assert not any(request.answer is not None and request.error is not None for request in line.asked)


def _request(codec: HostCodec, choices: Choices) -> Request:
    address = choices.number()
    command, fields, reply = (
        ("R", codec.fields("R", address), codec.data_digits),
        ("W", codec.fields("W", address, choices.number()), 0),
        ("WS", codec.fields("WS", address, choices.number()), None),
        ("RM", codec.fields("RM", address, 3), 3 * codec.data_digits),
    )[choices.number() % 4]
    request = Request(codec, command, fields, reply)
    request.poster = None
    return request


def spec(data: bytes) -> None:
    """Compile and format a text as UL-spec; the formatted text compiles to the same map."""
    text = data.decode(errors="replace")
    with contextlib.suppress(UnityLinkError):
        compiled = compile_text(text)
        again = compile_text(format_text(text))
        assert [one.fingerprint for one in again.interfaces] == [one.fingerprint for one in compiled.interfaces]


def recording(data: bytes) -> None:
    """Read a file as a recording, in both orders, as tables and as a gateway."""
    path = _FOLDER / "input.mcap"
    path.write_bytes(data)
    with contextlib.suppress(UnityLinkError):
        read = Recording(path)
        for _ in read.samples():
            pass
        for _ in read.in_order():
            pass
        for group in read.groups:
            read[group.name].to_numpy()
        gateway, _ = replay(read, loop=True)
        for now in (0.0, 0.5):
            gateway.receive(b"RM00FF\r", now)


def snooped(data: bytes) -> None:
    """Read a file as a snoop."""
    path = _FOLDER / "input.pcapng"
    path.write_bytes(data)
    damages: list[str] = []
    with contextlib.suppress(UnityLinkError):
        for _ in snoop.read(path, damages.append):
            pass


def page(data: bytes) -> None:
    """Decode a message of a browser to `live`."""
    with contextlib.suppress(msgspec.DecodeError, RecursionError, UnicodeError):
        msgspec.json.Decoder(Hello | Write | Stop).decode(data)


def serve(data: bytes) -> None:
    """Run a server of a shared link with hostile clients and a hostile gateway."""
    serving.serve(Choices(data))


TARGETS: dict[str, Callable[[bytes], None]] = {
    function.__name__: function
    for function in (configuration, frames, gateway, page, recording, serve, session, snooped, spec)
}

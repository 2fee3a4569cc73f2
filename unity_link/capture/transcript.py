"""The bytes of one connection, in both directions, as frames with their meanings.

The widths of all fields follow from the gateway's answer to `Q`. Before that answer the widths of the default build are
assumed.
"""

from __future__ import annotations

import contextlib
import re
from typing import TYPE_CHECKING, NamedTuple

from unity_link.capture.decoder import Decoder, FrameKind, Meaning
from unity_link.errors import UnsupportedError
from unity_link.protocol.wire.compact import text_of
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.frames import LONGEST_FRAME
from unity_link.protocol.wire.messages import Codec

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

_SENT = re.compile(rb"[^\r\n]*[\r\n]")
_RECEIVED = re.compile(rb"[^\n]*\n")
_UNKNOWN = GatewayInfo(features=GatewayInfo().features | Feature.COMPACT)
QUESTION = re.compile(rb"(?:Z([0-9A-Fa-f]{2}))?Q\r")
"""Pattern of the request `Q`; group 1 is the number of the node, if there is one."""
CONFIGURATION = re.compile(rb"(?:Z[0-9A-F]{2})?Q([0-9A-F]+)\r\n")
"""Pattern of the answer to `Q`; group 1 is the configuration."""


class TimedFrame(NamedTuple):
    """A frame with its time and its meaning."""

    time: float
    """Instant at which the last byte passed, in seconds of the caller's clock."""
    sent: bool
    """True for a frame from the host, False for a frame from the gateway."""
    frame: bytes
    """The frame as text, with its line end."""
    meaning: Meaning
    again: bool = False
    """True for a retransmission: a request that was sent before with the same ID."""
    round_trip: float | None = None
    """Seconds from the request to this answer; None if the request has no ID, or was retransmitted."""


class FrameCutter:
    """Cuts the bytes of one direction into frames.

    Args:
        sent: True for the bytes of the host, whose frames end in LF or CR; the frames of a gateway end in LF.
    """

    def __init__(self, *, sent: bool) -> None:
        self._sent = sent
        self._form = _SENT if sent else _RECEIVED
        self._text_of: Callable[[bytes], bytes] = bytes
        self.rest = b""
        """The beginning of a frame whose line end has not arrived."""

    def use(self, info: GatewayInfo) -> None:
        """Convert frames in compact form to text from now on, if the gateway has the compact form."""
        self._text_of = text_of(info, from_gateway=not self._sent)

    def cut(self, data: bytes) -> list[bytes]:
        """Add bytes, and return the completed frames as text with their line ends; empty lines are left out."""
        data = self.rest + self._text_of(data)
        frames = self._form.findall(data)
        rest = data[sum(map(len, frames)) :]
        if len(rest) > LONGEST_FRAME:
            # No frame is this long: return the bytes as they are, so that noise does not fill the memory.
            frames.append(rest)
            rest = b""
        self.rest = rest
        return [frame for frame in frames if frame.strip(b"\r\n")]


class Transcript:
    """Frames of one connection with their meanings."""

    def __init__(self) -> None:
        self.codec = Codec(_UNKNOWN)
        self._node: int | None = None
        self._decoder = Decoder(self.codec)
        self._cutters = {True: FrameCutter(sent=True), False: FrameCutter(sent=False)}
        self._use_forms()
        self._next: int | None = None
        """ID that the host gives to its next new request; None before an observed session began."""
        self._numbered = 0
        """Number of IDs that the host has used in this session."""
        self._sent_at: dict[int, float | None] = {}
        """Instant of each request without an answer, by ID; None if it was retransmitted."""

    def take(self, data: bytes, time: float, *, sent: bool) -> Iterator[TimedFrame]:
        """Add bytes of one direction, and return the completed frames.

        Args:
            data: the bytes.
            time: instant of the bytes, in seconds of any clock.
            sent: True for bytes from the host, False for bytes from the gateway.
        """
        for frame in self._cutters[sent].cut(data):
            yield self._sent(frame, time) if sent else self._received(frame, time)

    def end(self, time: float) -> Iterator[TimedFrame]:
        """Return the incomplete frames of both directions at the end of the connection, as damaged ones."""
        for sent, cutter in self._cutters.items():
            if cutter.rest:
                yield TimedFrame(time, sent, cutter.rest, Meaning(FrameKind.DAMAGED, "cut: its end has not come"))

    def _sent(self, frame: bytes, time: float) -> TimedFrame:
        if match := QUESTION.fullmatch(frame):
            self._node = None if match[1] is None else int(match[1], 16)
            if self._node is not None and not self.codec.framing.prefix:
                self._use(self.codec.info)
        meaning = self._decoder.explain_request(frame.removesuffix(b"\n"))
        return TimedFrame(time, sent=True, frame=frame, meaning=meaning, again=self._is_again(meaning, time, frame))

    def _is_again(self, meaning: Meaning, time: float, frame: bytes) -> bool:
        """Return whether a request is a retransmission, and record its ID and time."""
        number, ids = meaning.id, self.codec.id_count
        if meaning.command == "K" and frame[len(self.codec.framing.prefix) + 1 :].strip(b"\r\n"):
            self._next = self.codec.id_number.get(
                frame[len(self.codec.framing.prefix) + 1 :][: self.codec.info.id_digits]
            )
            self._sent_at.clear()
            self._numbered = 0
        if number is None or self._next is None:
            return False
        is_earlier = (number - self._next) % ids >= ids // 2
        # The test of the compact form uses IDs before the first one of the session, which are no retransmissions.
        again = is_earlier and (self._next - number) % ids <= self._numbered
        if not is_earlier:
            after = (number + 1) % ids
            self._numbered += (after - self._next) % ids
            self._next = after
        self._sent_at[number] = None if again else time
        return again

    def _received(self, frame: bytes, time: float) -> TimedFrame:
        if match := CONFIGURATION.fullmatch(frame):
            with contextlib.suppress(UnsupportedError, ValueError):
                self._use(GatewayInfo.from_hex(match[1]))
        meaning = self._decoder.explain(frame.removesuffix(b"\n"))
        sent_at = None
        if meaning.id is not None and meaning.command != "N":
            sent_at = self._sent_at.pop(meaning.id, None)
        round_trip = None if sent_at is None else time - sent_at
        return TimedFrame(time, sent=False, frame=frame, meaning=meaning, round_trip=round_trip)

    def _use(self, info: GatewayInfo) -> None:
        codec = Codec(info, self._node)
        if (info, codec.framing.prefix) != (self.codec.info, self.codec.framing.prefix):
            self.codec = codec
            self._decoder = Decoder(codec)
            self._use_forms()

    def _use_forms(self) -> None:
        for cutter in self._cutters.values():
            cutter.use(self.codec.info)

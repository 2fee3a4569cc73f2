"""The bytes of one connection, in both directions, as frames with their meanings.

The widths follow from what the gateway answers to `Q`. Until then those of the default build are assumed.
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
"""A `Q`; its group is the number of the node, if it is addressed."""
CONFIGURATION = re.compile(rb"(?:Z[0-9A-F]{2})?Q([0-9A-F]+)\r\n")
"""The answer; its group is the configuration."""


class TimedFrame(NamedTuple):
    """A frame, when it passed and what it means."""

    time: float
    """Instant of the frame, in seconds."""
    sent: bool
    """True if the host has sent it."""
    frame: bytes
    """With its end."""
    meaning: Meaning
    again: bool = False
    """A request that was sent before under the same ID."""
    round_trip: float | None = None
    """Seconds since the request, for an answer to one with an ID that was sent once."""


class FrameCutter:
    """Cuts the bytes of one direction into frames.

    Args:
        sent: of the host, whose frames end in LF or CR; those of a gateway end in LF.
    """

    def __init__(self, *, sent: bool) -> None:
        self._sent = sent
        self._form = _SENT if sent else _RECEIVED
        self._text_of: Callable[[bytes], bytes] = bytes
        self.rest = b""
        """The beginning of a frame whose end has not come."""

    def use(self, info: GatewayInfo) -> None:
        """Make text of frames in compact form, if a gateway has that."""
        self._text_of = text_of(info, from_gateway=not self._sent)

    def cut(self, data: bytes) -> list[bytes]:
        """Take bytes, and return the frames that are whole now, as text with its ends; empty ones are left out."""
        data = self.rest + self._text_of(data)
        frames = self._form.findall(data)
        rest = data[sum(map(len, frames)) :]
        if len(rest) > LONGEST_FRAME:
            # Noise without a line end.
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
        self._numbered = 0
        """IDs of the session before the next one."""
        self._sent_at: dict[int, float | None] = {}

    def take(self, data: bytes, time: float, *, sent: bool) -> Iterator[TimedFrame]:
        """Take bytes of one direction at a time in seconds, and return the frames that are whole now."""
        for frame in self._cutters[sent].cut(data):
            yield self._sent(frame, time) if sent else self._received(frame, time)

    def end(self, time: float) -> Iterator[TimedFrame]:
        """Return what is left without an end."""
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
        """Return whether a request was sent before; record the IDs and times that tell."""
        number, ring = meaning.id, self.codec.id_count
        if meaning.command == "K" and frame[len(self.codec.framing.prefix) + 1 :].strip(b"\r\n"):
            self._next = self.codec.id_number.get(
                frame[len(self.codec.framing.prefix) + 1 :][: self.codec.info.id_digits]
            )
            self._sent_at.clear()
            self._numbered = 0
        if number is None or self._next is None:
            return False
        is_behind = (number - self._next) % ring >= ring // 2
        # The IDs of a trial of the compact form are behind the first one of the session.
        again = is_behind and (self._next - number) % ring <= self._numbered
        if not is_behind:
            after = (number + 1) % ring
            self._numbered += (after - self._next) % ring
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

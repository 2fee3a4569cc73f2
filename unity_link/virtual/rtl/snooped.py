"""Reads the traffic of one gateway from a snoop: sent frames, their answers, and the samples of groups.

A response is matched to its request by command and ID, as in a host; if it was lost or damaged, the request has no
answer. The rules of the session determine which requests the gateway executed, and thereby which words the bus
returned. If the gateway reports that a frame was damaged or missing, the frame is assumed to have arrived so, and later
frames are evaluated again.
"""

from __future__ import annotations

import re
from collections import deque
from typing import TYPE_CHECKING, Any, NamedTuple

import msgspec

from unity_link.capture.observed_session import ObservedSession
from unity_link.capture.transcript import CONFIGURATION, QUESTION, FrameCutter
from unity_link.errors import ArgumentError, UnsupportedError
from unity_link.protocol.gateway.session import Answer, GatewaySession
from unity_link.protocol.wire.compact import text_of
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.frames import CR, LF
from unity_link.protocol.wire.messages import (
    TIMESTAMP_DIGITS,
    Codec,
    DecodedRequest,
    DecodedResponse,
    ErrorCode,
    GroupFlag,
    parse_numbers,
)
from unity_link.transport.snoop import Connected, Passed

if TYPE_CHECKING:
    from collections.abc import Iterable

    from unity_link.transport.snoop import Disconnected

GROUP_COMMANDS = frozenset({"GS", "GN", "GX", "GP", "K"})
"""Commands whose answers divide samples: samples taken before the command are sent before its answer."""
_SENT = re.compile(rb"[\r\n]*[^\r\n]+[\r\n]")
_OF_BUS = (ErrorCode.BUS_ERROR, ErrorCode.BUS_TIMEOUT, ErrorCode.OUT_OF_RANGE)
"""Errors of executed requests, which may also answer a posted write."""
_TO_ALL = b"ZFF"
_PREFIX_SIZE = 3
_SEQUENCES = 256


class SnoopedAccess(NamedTuple):
    """A bus access of a request."""

    write: bool
    address: int
    outcome: int | ErrorCode | None = None
    """The word of a read, or the error of a read or write; None for a successful write, or if unknown."""


class SnoopedFrame(msgspec.Struct):
    """A frame of the host, with its effect and its answer."""

    time: float
    """Time in nanoseconds since the first record of the file, like all times here."""
    frame: bytes
    request: DecodedRequest | None = None
    """The request, if the gateway executes it."""
    owes: bool = False
    """True if the gateway answers the frame."""
    answer: bytes | None = None
    """The recorded answer; None if unknown."""
    refusal: bytes = b""
    """The answer that the gateway must give if it does not execute the frame."""
    before: tuple[int, bool] = (-1, False)
    """The ID that the gateway expected before this frame, and whether it had reported a gap."""
    accesses: list[SnoopedAccess] = []
    samples_before: dict[int, int] = {}
    """For a command of `GROUP_COMMANDS`: number of each group's last sample before the command; -1 for none.

    Samples are numbered from the group's settings on.
    """

    @property
    def divides_samples(self) -> bool:
        """True if all samples taken before the command are sent before its answer."""
        return self.request is not None and self.request.command in GROUP_COMMANDS


class SnoopedSample(NamedTuple):
    """A recorded sample."""

    time: float
    frame: bytes
    body: bytes
    """Body of the frame without the timestamp."""
    words: list[int]


class SnoopedGroup(msgspec.Struct):
    """Settings of a group from one `GS` to the next, with its samples by number.

    Numbers count on where the 8-bit sequence numbers of samples wrap around.
    """

    flags: GroupFlag
    divisor: int
    samples: dict[int, SnoopedSample] = {}
    last: int = -1

    def number(self, sequence: int) -> int:
        """Return the number of the next sample from its sequence number."""
        return number_after(self.last, sequence)


def number_after(last: int, sequence: int) -> int:
    """Return the number of a sample from its sequence number and the number of the sample before it."""
    return last + ((sequence - last - 1) % _SEQUENCES) + 1


class Snooped(NamedTuple):
    """One gateway in a snoop."""

    info: GatewayInfo
    node: int | None
    steps: list[SnoopedFrame]
    groups: dict[int, list[SnoopedGroup]]
    """Successive settings of each group."""
    last: float
    """Time of the last byte."""
    astray: int
    """Number of the gateway's frames that are damaged, or that match no request."""


def read_snooped(
    events: Iterable[Connected | Passed | Disconnected], connection: int | None, end: float | None = None
) -> Snooped:
    """Return the traffic of a gateway in a snoop.

    Args:
        events: events of the snoop.
        connection: number of the connection to read; None for all, which must then have the same name.
        end: time in seconds since the first record at which reading stops; None for all.

    Raises:
        ArgumentError: if there is no such connection, there are several gateways, or the snoop has no answer to `Q`.
    """
    found = list(events)
    names = {event.connection: event.name for event in found if isinstance(event, Connected)}
    if connection is not None and connection not in names:
        raise ArgumentError(f"there is no connection {connection}: the file has {', '.join(map(str, names)) or 'none'}")
    if connection is None and len(set(names.values())) > 1:
        raise ArgumentError(
            f"the file has connections to {', '.join(dict.fromkeys(names.values()))}: choose one by --connection "
            f"(explain numbers them, 0 to {max(names)})"
        )
    all_passed = [event for event in found if isinstance(event, Passed)]
    origin = all_passed[0].time_ns if all_passed else 0
    passed = [
        event
        for event in all_passed
        if connection in (None, event.connection) and (end is None or event.time_ns - origin <= end * 1e9)
    ]
    codec = _codec_of(passed)
    reader = _Reader(codec)
    current = None
    for event in passed:
        if event.connection != current:
            current = event.connection
            reader.begin()
        reader.take(event.data, float(event.time_ns - origin), sent=event.sent)
    last = float(passed[-1].time_ns - origin)
    return Snooped(codec.info, reader.node, reader.steps, reader.groups, last, reader.astray)


def _codec_of(passed: list[Passed]) -> Codec:
    """Return the codec for the gateway's messages, from its first answer to `Q`."""
    both = {way: b"".join(event.data for event in passed if event.sent == way) for way in (True, False)}
    question = QUESTION.search(both[True])
    for match in CONFIGURATION.finditer(both[False]):
        try:
            info = GatewayInfo.from_hex(match[1])
        except (UnsupportedError, ValueError):
            continue
        return Codec(info, int(question[1], 16) if question and question[1] else None)
    raise ArgumentError("the snoop has no answer to Q, so it is not known which gateway it is of")


class _Reader:
    """Combines the bytes of both directions into frames with answers.

    Args:
        codec: codec for the gateway's messages.
    """

    def __init__(self, codec: Codec) -> None:
        self.steps: list[SnoopedFrame] = []
        self.groups: dict[int, list[SnoopedGroup]] = {}
        self.astray = 0
        self._codec = codec
        self._prefix = codec.framing.prefix
        self.node = int(self._prefix[1:], 16) if self._prefix else None
        self._session = GatewaySession(codec)
        self._overheard = ObservedSession(codec.framing)
        self.begin()

    def begin(self) -> None:
        """Begin a connection; pending frames of the earlier one are lost."""
        self._rest = b""
        self._received = FrameCutter(sent=False)
        self._received.use(self._codec.info)
        self._text_of = text_of(self._codec.info, from_gateway=False)
        self._unanswered: deque[SnoopedFrame] = deque()

    def take(self, data: bytes, time: float, *, sent: bool) -> None:
        """Process bytes of one direction."""
        if not sent:
            for frame in self._received.cut(data):
                self._take_received(frame, time)
            return
        data = self._rest + self._text_of(data)
        end = 0
        for match in _SENT.finditer(data):
            self._take_sent(match[0], time)
            end = match.end()
        self._rest = data[end:]

    # Frames of the host

    def _take_sent(self, frame: bytes, time: float) -> None:
        step = SnoopedFrame(time, frame, samples_before=self._numbers())
        if self._judge(step):
            self._unanswered.append(step)
        self.steps.append(step)

    def _judge(self, step: SnoopedFrame) -> bool:
        """Determine the effect of a frame in the gateway; return True if the gateway may answer it."""
        sequence = self._session.sequence
        step.before = sequence.expected, sequence.gap_reported
        step.request, step.owes, step.refusal, step.accesses = None, False, b"", []
        line, prefix = step.frame.strip(CR + LF), b""
        if self._prefix:
            prefix, line = line[:_PREFIX_SIZE].upper(), line[_PREFIX_SIZE:]
        if not line or prefix not in (self._prefix, _TO_ALL):
            return False
        taken = self._session.take(line, plain=step.frame.endswith(CR), prefix=prefix)
        to_all = prefix == _TO_ALL
        if isinstance(taken, Answer):
            step.refusal = taken.body
            step.owes = bool(taken.body) and not to_all
        else:
            step.request, step.owes = taken, taken.command != "WS" and not to_all
            step.accesses = _accesses(taken, None, self._codec.info)
        return not to_all

    def _judge_otherwise(self, step: SnoopedFrame, frame: bytes) -> None:
        """Record that a frame arrived damaged or not at all, and evaluate it and later frames again."""
        sequence = self._session.sequence
        sequence.expected, sequence.gap_reported = step.before
        step.frame = frame
        waiting = list(self._unanswered)
        for later in waiting[waiting.index(step) :]:
            self._judge(later)

    # Frames of the gateway

    def _take_received(self, frame: bytes, time: float) -> None:
        self._overheard.number = self._session.state.number
        try:
            body = self._overheard.open(frame.removesuffix(LF), from_gateway=True)
            response = self._codec.decode_response(body)
        except ValueError:
            self.astray += 1
            return
        if response.command == "P":
            self._take_sample(frame, response, time)
        else:
            self._take_answer(frame, response)

    def _take_answer(self, frame: bytes, response: DecodedResponse) -> None:
        waiting = self._unanswered
        self._hear_of_damage(response)
        place = next((place for place, step in enumerate(waiting) if self._fits(step, response)), None)
        if place is None:
            self.astray += 1
            return
        for _ in range(place):
            waiting.popleft()
        step = waiting.popleft()
        step.answer, step.owes = frame, True
        if step.request is None:
            return
        step.accesses = _accesses(step.request, response, self._codec.info)
        if step.divides_samples:
            step.samples_before = self._numbers()
        if step.request.command == response.command == "GS":
            group, flags, divisor = step.request.values[:3]
            self.groups.setdefault(group, []).append(SnoopedGroup(GroupFlag(flags), divisor))
        if step.request.command == response.command == "GP":
            # The sample of `GP` itself is also sent before the answer.
            group = step.request.values[0]
            step.samples_before[group] = step.samples_before.get(group, -1) - 1

    def _hear_of_damage(self, response: DecodedResponse) -> None:
        """Process an answer that reports a damaged or missing frame."""
        waiting = self._unanswered
        if response.command == "N" and not any(self._is_told_of_gap(step, response) for step in waiting):
            missing = next((step for step in waiting if self._id_of(step) == response.id), None)
            if missing is not None:
                self._judge_otherwise(missing, b"")
        if response.command == "X" and response.id is None and response.fields["e"] == ErrorCode.CRC:
            first = next((step for step in waiting if step.owes or step.request is not None), None)
            damaged = self._codec.error(ErrorCode.CRC)
            if first is not None and first.refusal != damaged and first.frame.endswith(LF):
                self._judge_otherwise(first, _damaged(first.frame))

    def _is_told_of_gap(self, step: SnoopedFrame, response: DecodedResponse) -> bool:
        return response.id is not None and step.refusal == self._codec.out_of_sequence(response.id)

    def _fits(self, step: SnoopedFrame, response: DecodedResponse) -> bool:
        """Return True if a response may be the answer to a frame."""
        if step.request is None and not step.owes:
            return False
        number = None if step.request is None else step.request.id
        line = step.frame.strip(CR + LF)[len(self._prefix) :]
        with_id = line[:1].islower()
        if response.command == "N":
            return self._is_told_of_gap(step, response)
        if response.command == "X":
            if response.id is None:
                return step.owes or (not with_id and response.fields["e"] in _OF_BUS)
            refusal = self._codec.error(response.fields["e"], response.id)
            executed = step.request is not None and response.fields["e"] in _OF_BUS
            return self._id_of(step) == response.id and (executed or step.refusal.startswith(refusal))
        if step.request is not None:
            return response.command == step.request.command and response.id == number
        return with_id and response.id is not None and self._id_of(step) == response.id

    def _id_of(self, step: SnoopedFrame) -> int | None:
        digits = re.match(rb"[g-z]+([0-9A-Fa-f]+)", step.frame.strip(CR + LF)[len(self._prefix) :])
        return None if digits is None else self._codec.id_number.get(digits[1][: self._codec.info.id_digits].upper())

    def _take_sample(self, frame: bytes, response: DecodedResponse, time: float) -> None:
        group, sequence, text = response.fields["g"], response.fields["p"], response.fields["text"]
        if group not in self.groups:
            # The group was set up before the snoop began.
            self.astray += 1
            return
        settings = self.groups[group][-1]
        body = sample_body(self._codec, frame, settings.flags, self._session.state.seeds[1])
        text = text[TIMESTAMP_DIGITS:] if settings.flags & GroupFlag.TIMESTAMP else text
        try:
            words = parse_numbers(text, self._codec.info.data_digits)
        except ValueError:
            self.astray += 1
            return
        settings.last = settings.number(sequence)
        settings.samples[settings.last] = SnoopedSample(time, frame, body, words)

    def _numbers(self) -> dict[int, int]:
        """Return the number of the last sample of each group."""
        return {group: settings[-1].last for group, settings in self.groups.items()}


def _damaged(frame: bytes) -> bytes:
    """Return a checked frame with another CRC."""
    return frame[:-2] + (b"1" if frame[-2:-1] == b"0" else b"0") + LF


def sample_body(codec: Codec, frame: bytes, flags: GroupFlag, seed: int) -> bytes:
    """Return the body of a sample without its timestamp, which depends on the clock of the gateway.

    Args:
        codec: codec for the gateway's messages.
        frame: the frame of the sample, with its end.
        flags: flags of the group.
        seed: initial value of the session's CRC.

    Raises:
        FrameError: if the frame is damaged.
    """
    body = codec.framing.open(frame.removesuffix(LF), seed)
    head = len("P0000")
    return body[:head] + body[head + TIMESTAMP_DIGITS :] if flags & GroupFlag.TIMESTAMP else body


def _accesses(request: DecodedRequest, response: DecodedResponse | None, info: GatewayInfo) -> list[SnoopedAccess]:
    """Return the bus accesses of a request, with their outcomes as far as the response has them."""
    failure: ErrorCode | None = None
    words: list[Any] = []
    if response is not None:
        if response.command == "X":
            if response.fields["e"] not in _OF_BUS[:2]:
                return []
            failure = ErrorCode(response.fields["e"])
        elif "D" in response.fields:
            words = response.fields["D"]
        elif "d" in response.fields:
            words = [response.fields["d"]]
    accesses = _places(request, info)
    if failure is not None:
        # The answer does not show which access failed: assume the first one.
        return [access._replace(outcome=failure) for access in accesses[:1]]
    reads = iter(words)
    return [access if access.write else access._replace(outcome=next(reads, None)) for access in accesses]


def _places(request: DecodedRequest, info: GatewayInfo) -> list[SnoopedAccess]:
    values = request.values
    match request.command:
        case "R":
            return [SnoopedAccess(write=False, address=values[0])]
        case "W" | "WS":
            return [SnoopedAccess(write=True, address=values[0])]
        case "WK":
            return [SnoopedAccess(write, values[0]) for write in (False, True)]
        case "RM" | "RQ" | "WM" | "WQ":
            write = request.command.startswith("W")
            count = len(values[1]) if write else values[1]
            step = request.command.endswith("M")
            last = (1 << info.address_bits) - 1
            return [SnoopedAccess(write, values[0] + step * index & last) for index in range(count)]
    return []

"""The traffic of one gateway in a snoop: frames sent, the answer to each, and the samples of its groups.

A response is found again by its command and ID, as a host finds it; one that was lost or damaged has left its request
without an answer. Which requests were executed follows from the rules of the session, so it is known which words the
bus must have given. Where the gateway says that a frame reached it damaged, or that one is missing, that is what it is
taken to have received, and what follows is judged anew.
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
"""Their answers divide samples: those that were taken before come before them."""
_SENT = re.compile(rb"[\r\n]*[^\r\n]+[\r\n]")
_OF_BUS = (ErrorCode.BUS_ERROR, ErrorCode.BUS_TIMEOUT, ErrorCode.OUT_OF_RANGE)
"""Errors of the bus, by which a posted write may be answered, too."""
_TO_ALL = b"ZFF"
_PREFIX_SIZE = 3
_SEQUENCES = 256


class SnoopedAccess(NamedTuple):
    """An access of the bus for a request."""

    write: bool
    address: int
    outcome: int | ErrorCode | None = None
    """Word of a read, None where it is not known; of a read or write, the error that ended it."""


class SnoopedFrame(msgspec.Struct):
    """A frame that the host sent, and what became of it."""

    time: float
    """Nanoseconds from the first record of the file on, as all times here."""
    frame: bytes
    request: DecodedRequest | None = None
    """Request that was executed."""
    owes: bool = False
    """True if it has an answer."""
    answer: bytes | None = None
    """Answer that was recorded, None where it is not known."""
    refusal: bytes = b""
    """Answer that it must have where nothing was executed."""
    before: tuple[int, bool] = (-1, False)
    """The ID that the gateway expected before it, and whether it had told of a gap."""
    accesses: list[SnoopedAccess] = []
    samples_before: dict[int, int] = {}
    """Last sample that was taken before a command of `GROUP_COMMANDS`, by group, counted from the group's settings on;
    -1 for none."""

    @property
    def divides_samples(self) -> bool:
        """Return whether no sample that was taken before may come after its answer."""
        return self.request is not None and self.request.command in GROUP_COMMANDS


class SnoopedSample(NamedTuple):
    """A sample that was recorded."""

    time: float
    frame: bytes
    body: bytes
    """Without the timestamp."""
    words: list[int]


class SnoopedGroup(msgspec.Struct):
    """A group from one `GS` to the next, with its samples by number; unlike s, that does not begin again at 256."""

    flags: GroupFlag
    divisor: int
    samples: dict[int, SnoopedSample] = {}
    last: int = -1

    def number(self, sequence: int) -> int:
        """Return the number of the next sample from its s."""
        return number_after(self.last, sequence)


def number_after(last: int, sequence: int) -> int:
    """Return the number of a sample from its s and the number of the one before it."""
    return last + ((sequence - last - 1) % _SEQUENCES) + 1


class Snooped(NamedTuple):
    """One gateway in a snoop."""

    info: GatewayInfo
    node: int | None
    steps: list[SnoopedFrame]
    groups: dict[int, list[SnoopedGroup]]
    """Settings by group, one after the other."""
    last: float
    """Instant at which the last byte passed."""
    astray: int
    """Frames of the gateway that are damaged, or of which it is not known what they answer."""


def read_snooped(
    events: Iterable[Connected | Passed | Disconnected], connection: int | None, end: float | None = None
) -> Snooped:
    """Return what a snoop says of a gateway.

    Args:
        events: of the file.
        connection: the one to read, None for all, which then must be of one name.
        end: seconds from the first record on, at which to stop.

    Raises:
        ArgumentError: where there is no such connection, several gateways, or none that has said what it is.
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
    """Return the messages of the gateway, from its first answer to `Q`."""
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
    """Puts the bytes of both directions together again.

    Args:
        codec: the messages of the gateway.
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
        """Begin a connection: what was under way on the one before is lost."""
        self._rest = b""
        self._received = FrameCutter(sent=False)
        self._received.use(self._codec.info)
        self._text_of = text_of(self._codec.info, from_gateway=False)
        self._unanswered: deque[SnoopedFrame] = deque()

    def take(self, data: bytes, time: float, *, sent: bool) -> None:
        """Take what passed."""
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

    # What the host sent

    def _take_sent(self, frame: bytes, time: float) -> None:
        step = SnoopedFrame(time, frame, samples_before=self._numbers())
        if self._judge(step):
            self._unanswered.append(step)
        self.steps.append(step)

    def _judge(self, step: SnoopedFrame) -> bool:
        """Decide what the gateway makes of a frame; return whether it may answer."""
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
        """Record that a frame reached the gateway as another one, or not at all, and judge anew those behind it."""
        sequence = self._session.sequence
        sequence.expected, sequence.gap_reported = step.before
        step.frame = frame
        waiting = list(self._unanswered)
        for later in waiting[waiting.index(step) :]:
            self._judge(later)

    # What the gateway sent

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
            # Its own sample is before its answer as well.
            group = step.request.values[0]
            step.samples_before[group] = step.samples_before.get(group, -1) - 1

    def _hear_of_damage(self, response: DecodedResponse) -> None:
        """Take it from an answer where a frame reached the gateway damaged, or not at all."""
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
        """Return whether a response may be to a frame."""
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
            # It was set up before the snoop began.
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
    """Return what a sample says without its timestamp, which is of a clock of its own in each gateway.

    Args:
        codec: the messages of the gateway.
        frame: with its end.
        flags: of its group.
        seed: of its session.

    Raises:
        FrameError: where it is damaged.
    """
    body = codec.framing.open(frame.removesuffix(LF), seed)
    head = len("P0000")
    return body[:head] + body[head + TIMESTAMP_DIGITS :] if flags & GroupFlag.TIMESTAMP else body


def _accesses(request: DecodedRequest, response: DecodedResponse | None, info: GatewayInfo) -> list[SnoopedAccess]:
    """Return what a request did on the bus, as far as its response tells."""
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
        # The answer is the error alone, wherever it was.
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

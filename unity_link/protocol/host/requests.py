"""The requests of a host: their frames, their answers, and their outcomes.

A session takes messages from *sources*:

- `Request` is a single message, and its own source.
- `RequestBlock` is a source of several requests, if one would be longer than the gateway allows.
- `WordBatch` (in `batches`) has many messages for single words. It is a source of `BatchRun`, whose messages are
  encoded and decoded together by numpy.

A request whose answer or error is known is appended to a list of events, which the session returns. A posted write is
appended when it is sent.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

from unity_link.errors import (
    BusError,
    BusTimeoutError,
    GatewayError,
    OutOfRangeError,
    UnansweredError,
    UnityLinkError,
    UnsupportedError,
)
from unity_link.protocol import wire
from unity_link.protocol.host.events import Awaited, PostedFailure
from unity_link.protocol.window.sequence_space import Run
from unity_link.protocol.wire.frames import LF

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from unity_link.protocol.host.events import Events
    from unity_link.protocol.host.host_codec import HostCodec

REPEATABLE = frozenset({"R", "RM", "H"})
"""Commands that change nothing, so that the next session may send them again."""
_MANY_WORDS = frozenset({"RM", "RQ"})
_ERRORS: dict[int, tuple[type[GatewayError], str]] = {
    4: (BusError, "the bus refused the access"),
    5: (BusTimeoutError, "nothing on the bus answered"),
    6: (OutOfRangeError, "the gateway says that a value is out of its range"),
}
_NAMES = {
    "R": "read",
    "RM": "block read",
    "RQ": "queue read",
    "W": "write",
    "WM": "block write",
    "WQ": "queue write",
    "WK": "masked write",
    "WS": "posted write",
    "GS": "setting up a group",
    "GN": "starting a group",
    "GX": "stopping a group",
    "GP": "publishing a group",
    "I": "setting send-immediate",
    "H": "fence",
}


def gateway_error(code: int, what: str, refusal: Callable[[], str]) -> GatewayError:
    """Return the exception for an error code of the gateway.

    Args:
        code: code of the error response.
        what: name of the request, as the beginning of the text.
        refusal: returns the reason why the bus refuses accesses; empty if it is unknown.
    """
    kind, text = _ERRORS.get(code, (GatewayError, f"the gateway answered error {code:02X}"))
    reason = refusal() if kind is BusError else ""
    return kind(f"{what}: {text}" + (f", for {reason}" if reason else ""), code)


class Source(Protocol):
    """A request, or several, from which the session takes runs of messages to send."""

    @property
    def size(self) -> int:
        """Characters of the next message."""

    @property
    def reply_size(self) -> int:
        """Characters of the answer to the next message; 0 for a posted write, which has none."""

    @property
    def posted(self) -> bool:
        """True if the next message is a posted write."""

    @property
    def places(self) -> int:
        """Words that the gateway stores for the next message, if it is a destructive read; otherwise 0."""

    @property
    def least(self) -> int:
        """Fewest messages for which the source waits for room, while other requests are in flight."""

    @property
    def of_session(self) -> bool:
        """True if the source ends with the session in which it was submitted."""

    def take(self, room: int, events: Events) -> Message:
        """Return the next run, of at most `room` messages."""

    def exhausted(self) -> bool:
        """Return whether all messages have been taken."""

    @property
    def outlives_session(self) -> bool:
        """True if the next session may send the messages that this one does not."""

    def unwanted(self) -> bool:
        """Return whether the source was cancelled, or has failed."""

    def fail(self, error: UnityLinkError, events: Events) -> None:
        """End the messages that have not been taken with an error."""


class Message(Run):
    """A run of the window with its messages.

    Args:
        codec: message codec of the gateway.
        command: the command, in upper case.
        fields_size: characters of the fields of each message.
        reply_digits: hex digits after the ID of each answer, None for posted writes.
        count: number of messages.
    """

    __slots__ = ("codec", "command", "frames", "given_up")

    def __init__(self, codec: HostCodec, command: str, fields_size: int, reply_digits: int | None, count: int) -> None:
        head = codec.head_sizes[command]
        super().__init__(count, head + fields_size, 0 if reply_digits is None else head + reply_digits)
        self.codec = codec
        self.command = command
        self.given_up = False
        """True if its answer is not wanted any more, so that retransmissions are sent as ``h``."""
        self.frames = b""
        """Frames of all messages, as they were first sent."""

    def encode(self) -> bytes:
        """Return the frames, with the IDs that the window has assigned."""
        raise NotImplementedError

    def frames_of(self, offset: int, count: int) -> bytes:
        """Return the frames of `count` messages from `offset` on, to send them again."""
        return self.frames[offset * self.size : (offset + count) * self.size]

    def data_of(self, frame: bytes, opening: bytes) -> bytes | None:
        """Return the characters after the ID of a response; None if the frame is damaged or not the expected one.

        Args:
            frame: the frame with its LF.
            opening: expected beginning of the frame, up to the ID.
        """
        codec = self.codec
        framing = codec.framing
        covered = frame[: -framing.ending_size]
        if (
            len(frame) == self.reply_size
            and covered.startswith(opening)
            and frame.endswith(framing.ending(covered, codec.begun_back))
            and LF not in covered
        ):
            return covered[len(opening) :]
        return None

    def accept(self, offset: int, body: bytes, position: int, events: Events) -> bool:
        """Take the body of the response to one message; return whether it is a valid one.

        Args:
            offset: position of the message in the run.
            body: body of the response.
            position: offset of the data after the ID in the body.
            events: events are appended to it.
        """
        raise NotImplementedError

    def unwanted(self) -> bool:
        """Return whether the answer is not wanted any more."""
        return self.given_up

    def fail_part(self, offset: int, count: int, error: UnityLinkError, events: Events) -> None:
        """End `count` messages from `offset` on with an error."""
        raise NotImplementedError

    def give_up(self, number: int, kind: type[UnansweredError | UnsupportedError], reason: str, events: Events) -> None:
        """End the messages from the ID `number` on with an error; their retransmissions are sent as ``h``."""
        self.given_up = True
        offset = number - self.first & self.codec.id_count - 1
        self.fail_part(offset, self.count - offset, kind(f"{self.describe(offset)}: {reason}"), events)

    def describe(self, offset: int) -> str:
        """Return the name of one message for an error."""
        address = self.address_at(offset)
        if address is None:
            return _NAMES[self.command]
        name = self.codec.names.get(address)
        where = f"0x{address:0{self.codec.info.address_digits}X}"
        return f"{_NAMES[self.command]}{f' of {name}' if name else ''} at {where}"

    def address_at(self, offset: int) -> int | None:
        """Return the address of one message, or the first address of a block; None for a message without one."""
        if self.command[0] not in "RW":
            return None
        return int(self.fields_at(offset)[: self.codec.info.address_digits], 16)

    def fields_at(self, offset: int) -> bytes:
        """Return the hex digits of the fields of one message."""
        raise NotImplementedError

    def again(self, offset: int, count: int) -> Source | None:
        """Return the source of these messages for the next session, or None if they might be executed twice."""
        raise NotImplementedError

    def question(self, offset: int, count: int) -> Message:
        """Return the run that asks for the outcomes of `count` posted writes of this run, from `offset` on."""
        return Question(self, offset, count)


class Question(Message):
    """``h`` with the IDs of executed posted writes: the answer to each reports the outcome of its write.

    Args:
        asked: the run of the posted writes.
        offset: position of the first one in it.
        count: number of posted writes.
    """

    __slots__ = ("_asked", "_offset")
    is_question = True

    def __init__(self, asked: Message, offset: int, count: int) -> None:
        super().__init__(asked.codec, "H", 0, asked.codec.info.id_digits, count)
        self.first = asked.first + offset & asked.codec.id_count - 1
        self.sending = asked.sending + offset
        self._asked, self._offset = asked, offset

    def frames_of(self, offset: int, count: int) -> bytes:
        """Return the frames of `count` questions from `offset` on."""
        return self.codec.confirmations(self.first + offset, count)

    def accept(self, offset: int, body: bytes, position: int, events: Events) -> bool:  # noqa: ARG002
        """Take the answer to one question, which reports that the write did not fail."""
        return body.startswith(b"h") and len(body) + self.codec.framing.overhead == self.reply_size

    def fail_part(self, offset: int, count: int, error: UnityLinkError, events: Events) -> None:
        """Report the failure of the posted writes."""
        self._asked.fail_part(self._offset + offset, count, error, events)

    def fields_at(self, offset: int) -> bytes:
        """Return the hex digits of the fields of the posted write."""
        return self._asked.fields_at(self._offset + offset)

    def describe(self, offset: int) -> str:
        """Return the name of the posted write."""
        return self._asked.describe(self._offset + offset)

    def address_at(self, offset: int) -> int | None:
        """Return the address of the posted write."""
        return self._asked.address_at(self._offset + offset)

    def again(self, offset: int, count: int) -> Source | None:  # noqa: ARG002
        """Return None: the posted writes were executed, and the next session sends nothing for them."""
        return None


class Request(Message, Awaited):
    """A single message and its outcome; its own source.

    Args:
        codec: message codec of the gateway.
        command: the command, in upper case.
        fields: its fields as hex digits.
        reply_digits: hex digits after the ID of the answer, None for a posted write.
        of_session: True if the request ends with the session in which it was submitted.
    """

    __slots__ = ("answer", "done", "error", "fields", "of_session", "opening", "poster", "sent", "waiter")
    poster: object
    """Task or thread that has posted it; set for posted writes only, to save the time in reads."""
    least = 1

    def __init__(
        self, codec: HostCodec, command: str, fields: bytes, reply_digits: int | None, *, of_session: bool = False
    ) -> None:
        # The same as in `Message.__init__`, inlined because every read runs it.
        head = codec.head_sizes[command]
        self.first = 0
        self.count = 1
        self.size = head + len(fields)
        self.posted = reply_digits is None
        self.reply_size = 0 if reply_digits is None else head + reply_digits
        self.codec = codec
        self.command = command
        self.given_up = False
        self.fields = fields
        self.of_session = of_session
        self.opening = b""
        """Beginning of the frame and of the expected answer: node prefix, command and ID; set by `encode`."""
        self.sent = False
        """True if the window has assigned an ID."""
        self.done = False
        """True if `answer` or `error` is set."""
        self.answer: Any = None
        """The word or words read; None for an acknowledgement."""
        self.error: UnityLinkError | None = None
        self.waiter: Any = None

    def encode(self) -> bytes:
        """Return the frame, with the ID that the window has assigned."""
        codec = self.codec
        self.opening = codec.openings[self.command] + codec.id_text[self.first]
        covered = self.opening + self.fields
        self.frames = frame = covered + codec.framing.ending(covered, codec.begun)
        return frame

    def take_frame(self, offset: int, frame: bytes, events: Events) -> bool:  # noqa: ARG002
        """Take the frame of the response if it is exactly the expected one; return whether it is."""
        data = self.data_of(frame, self.opening)
        return data is not None and self.take_data(data, events)

    def accept(self, offset: int, body: bytes, position: int, events: Events) -> bool:  # noqa: ARG002
        """Take the body of the response; return whether it is a valid one."""
        codec = self.codec
        if not body.startswith(codec.lower[self.command]) or len(body) + codec.framing.overhead != self.reply_size:
            return False
        return self.take_data(body[position:], events)

    def take_data(self, data: bytes, events: Events) -> bool:
        """Take the characters after the ID of the response; return whether they are valid."""
        try:
            answer = self.decode(data)
        except ValueError:
            return False
        if not self.done:
            self.done = True
            self.answer = answer
            events.append(self)
        return True

    def decode(self, data: bytes) -> Any:
        """Return the word or words of the response; None if it has none."""
        if not data:
            return None
        if self.command in _MANY_WORDS:
            return wire.arrays.parse_words(data, self.codec.data_digits)
        return int(data, 16)

    def cancel(self) -> None:
        """Record that no call awaits the request: it is not sent; or if it was, its answer is ignored."""
        if not (self.posted and self.sent):
            self.given_up = True

    def fail(self, error: UnityLinkError, events: Events) -> None:
        """End the request with an error; the error of a posted write that was sent becomes a `PostedFailure`."""
        if self.posted and self.sent:
            events.append(PostedFailure(error, 1, self.poster))
        elif not self.done:
            self.done = True
            self.error = error
            events.append(self)

    def fail_part(self, offset: int, count: int, error: UnityLinkError, events: Events) -> None:  # noqa: ARG002
        """End the request with an error."""
        self.fail(error, events)

    def fields_at(self, offset: int) -> bytes:  # noqa: ARG002
        """Return the hex digits of the fields."""
        return self.fields

    def again(self, offset: int, count: int) -> Source | None:  # noqa: ARG002
        """Return the request itself if the next session may send it, otherwise None."""
        return self if self.outlives_session else None

    # A source of itself

    @property
    def outlives_session(self) -> bool:
        """True if the next session may send the request, because it changes nothing."""
        return not self.of_session and self.command in REPEATABLE

    def take(self, room: int, events: Events) -> Message:  # noqa: ARG002
        """Return the request itself; report a posted write as sent."""
        self.sent = True
        if self.posted:
            events.append(self)
        return self

    def exhausted(self) -> bool:
        """Return True, because `take` returns the only message."""
        return True


class DestructiveRead(Request):
    """A queue read or masked write. The gateway stores the words read, because reading them again would differ.

    Args:
        codec: message codec of the gateway.
        command: the command, in upper case.
        fields: its fields as hex digits.
        words: number of words read.
    """

    __slots__ = ("places",)

    def __init__(self, codec: HostCodec, command: str, fields: bytes, words: int) -> None:
        super().__init__(codec, command, fields, words * codec.data_digits)
        self.places = words


class SessionRequest(Request):
    """A request that the session itself makes, to set up groups.

    Args:
        codec: message codec of the gateway.
        command: the command, in upper case.
        fields: its fields as hex digits.
        follow: called with the error, or None, and the list of events, when the request has ended.
    """

    __slots__ = ("_follow",)

    def __init__(
        self, codec: HostCodec, command: str, fields: bytes, follow: Callable[[UnityLinkError | None, Events], None]
    ) -> None:
        super().__init__(codec, command, fields, 0, of_session=True)
        self._follow = follow

    def accept(self, offset: int, body: bytes, position: int, events: Events) -> bool:
        """Take the body of the response, and call `follow`."""
        ended: Events = []
        accepted = super().accept(offset, body, position, ended)
        if ended:
            self._follow(None, events)
        return accepted

    def fail(self, error: UnityLinkError, events: Events) -> None:
        """End the request with an error, and call `follow`."""
        ended: Events = []
        super().fail(error, ended)
        if ended:
            self._follow(error, events)


class Confirmation(Request):
    """An ``h``, whose answer counts the posted writes of the session that failed.

    Args:
        codec: message codec of the gateway.
        of_session: True if it ends with its session; otherwise the next session may send it.
    """

    __slots__ = ()
    is_fence = True

    def __init__(self, codec: HostCodec, *, of_session: bool = False) -> None:
        super().__init__(codec, "H", b"", codec.info.id_digits, of_session=of_session)

    def decode(self, data: bytes) -> Any:
        """Return None, because the receiver reports the count to the window; raise `ValueError` if it is not hex."""
        int(data, 16)


class Fence(Confirmation):
    """A confirmation that is sent after all requests that were submitted before it.

    Args:
        codec: message codec of the gateway.
        of_session: True if it ends with its session; otherwise the next session may send it.
    """

    __slots__ = ("earlier",)

    def __init__(self, codec: HostCodec, *, of_session: bool = False) -> None:
        super().__init__(codec, of_session=of_session)
        self.earlier: list[Source] = []
        """Sources that were queued before, and may need several turns."""

    def follow(self, waiting: Iterable[Source]) -> None:
        """Wait until the messages of these queued sources are sent."""
        self.earlier += [source for source in waiting if not source.exhausted()]

    def fail_part(self, offset: int, count: int, error: UnityLinkError, events: Events) -> None:
        """End the fence with an error.

        An error response to the fence is no error of the call: the window has asked for each posted write's outcome.
        """
        if isinstance(error, GatewayError):
            self.take_data(b"0", events)
        else:
            super().fail_part(offset, count, error, events)

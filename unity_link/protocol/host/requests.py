"""The requests of a host to a gateway: messages that know how they are sent and what their answers mean.

A session takes them from *sources*. A `Request` is one message and a source of itself. A `RequestBlock` is a source of
several requests, because the gateway limits their length. A `WordBatch` has many messages for single words and is a
source of `BatchRun`, which numpy encodes and decodes together.

What ends, and what a program that waits is to be told, is put into a list of events, for the session to return: a
request or batch whose answer or error is known, or which is on its way where that is all that is waited for.
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
"""Commands that change nothing: a new session may send them again."""
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
        code: of the error.
        what: names the request.
        refusal: returns the reason why the bus refuses accesses, empty where none is known.
    """
    kind, text = _ERRORS.get(code, (GatewayError, f"the gateway answered error {code:02X}"))
    reason = refusal() if kind is BusError else ""
    return kind(f"{what}: {text}" + (f", for {reason}" if reason else ""), code)


class Source(Protocol):
    """Something that has messages to send."""

    @property
    def size(self) -> int:
        """Characters of the next message."""

    @property
    def reply_size(self) -> int:
        """Characters of the answer to the next message, 0 if it has none."""

    @property
    def posted(self) -> bool:
        """Return whether the next message is a posted write."""

    @property
    def places(self) -> int:
        """Words of the next message that the gateway keeps, for they cannot be read again."""

    @property
    def least(self) -> int:
        """Number of messages for which room is wanted before the next turn."""

    @property
    def of_session(self) -> bool:
        """Return whether no other session sends it than the one in which it was asked for."""

    def take(self, room: int, events: Events) -> Message:
        """Return the next run, of at most `room` messages."""

    def exhausted(self) -> bool:
        """Return whether all has been taken."""

    @property
    def outlives_session(self) -> bool:
        """Return whether the next session may send it, if this one ends before."""

    def unwanted(self) -> bool:
        """Return whether it is not awaited any more."""

    def fail(self, error: UnityLinkError, events: Events) -> None:
        """End what has not been taken yet."""


class Message(Run):
    """A run that knows its messages.

    Args:
        codec: the messages of the gateway.
        command: in upper case.
        fields_size: characters of the fields of each message.
        reply_digits: hex digits behind the ID of each answer, None for a posted write.
        count: number of messages.
    """

    __slots__ = ("codec", "command", "frames", "given_up")

    def __init__(self, codec: HostCodec, command: str, fields_size: int, reply_digits: int | None, count: int) -> None:
        head = codec.head_sizes[command]
        super().__init__(count, head + fields_size, 0 if reply_digits is None else head + reply_digits)
        self.codec = codec
        self.command = command
        self.given_up = False
        """True if it will never be answered, and is sent as ``h`` from now on."""
        self.frames = b""
        """Frames of all its messages, as they were sent first."""

    def encode(self) -> bytes:
        """Return the frames, under the IDs that the window has given."""
        raise NotImplementedError

    def frames_of(self, offset: int, count: int) -> bytes:
        """Return the frames of some messages once more."""
        return self.frames[offset * self.size : (offset + count) * self.size]

    def data_of(self, frame: bytes, opening: bytes) -> bytes | None:
        """Return what stands behind the ID in a response that begins so; None where it is anything else, or damaged."""
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
        """Take the response to one message, with its data from `position` on; False where it is no response to it."""
        raise NotImplementedError

    def unwanted(self) -> bool:
        """Return whether the answer is not awaited any more."""
        return self.given_up

    def fail_part(self, offset: int, count: int, error: UnityLinkError, events: Events) -> None:
        """Record that there will be no answer to these messages of the run."""
        raise NotImplementedError

    def give_up(self, number: int, kind: type[UnansweredError | UnsupportedError], reason: str, events: Events) -> None:
        """End what waits for answers that will never come, from an ID on; it is sent as ``h`` from now on."""
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
        """Return the address of one message, of a block the first one; None for a message without an address."""
        if self.command[0] not in "RW":
            return None
        return int(self.fields_at(offset)[: self.codec.info.address_digits], 16)

    def fields_at(self, offset: int) -> bytes:
        """Return the fields of one message."""
        raise NotImplementedError

    def again(self, offset: int, count: int) -> Source | None:
        """Return what a new session has to send for this part of the run, None where that could execute it twice."""
        raise NotImplementedError

    def question(self, offset: int, count: int) -> Message:
        """Return the run that asks how some posted writes of this one ended."""
        return Question(self, offset, count)


class Question(Message):
    """``h`` with the IDs of posted writes that were executed: asks how each of them ended.

    Args:
        asked: the run of the posted writes.
        offset: place of the first in it.
        count: how many are asked for.
    """

    __slots__ = ("_asked", "_offset")
    is_question = True

    def __init__(self, asked: Message, offset: int, count: int) -> None:
        super().__init__(asked.codec, "H", 0, asked.codec.info.id_digits, count)
        self.first = asked.first + offset & asked.codec.id_count - 1
        self.sending = asked.sending + offset
        self._asked, self._offset = asked, offset

    def frames_of(self, offset: int, count: int) -> bytes:
        """Return the frames of some of them."""
        return self.codec.confirmations(self.first + offset, count)

    def accept(self, offset: int, body: bytes, position: int, events: Events) -> bool:  # noqa: ARG002
        """Take the answer that says that it ended well."""
        return body.startswith(b"h") and len(body) + self.codec.framing.overhead == self.reply_size

    def fail_part(self, offset: int, count: int, error: UnityLinkError, events: Events) -> None:
        """Pass on that they failed."""
        self._asked.fail_part(self._offset + offset, count, error, events)

    def fields_at(self, offset: int) -> bytes:
        """Return the fields of the write that is asked for."""
        return self._asked.fields_at(self._offset + offset)

    def describe(self, offset: int) -> str:
        """Return the name of the write that is asked for."""
        return self._asked.describe(self._offset + offset)

    def address_at(self, offset: int) -> int | None:
        """Return the address of the write that is asked for."""
        return self._asked.address_at(self._offset + offset)

    def again(self, offset: int, count: int) -> Source | None:  # noqa: ARG002
        """Return None: the write was executed."""
        return None


class Request(Message, Awaited):
    """One message, and what became of it: a source of itself.

    Args:
        codec: the messages of the gateway.
        command: in upper case.
        fields: hex digits.
        reply_digits: hex digits behind the ID of the answer, None for a posted write.
        of_session: whether no other session may send it than the one in which it was asked for.
    """

    __slots__ = ("answer", "done", "error", "fields", "of_session", "opening", "poster", "sent", "waiter")
    poster: object
    """Task or thread that has posted it; of posted writes alone, which reads need not pay for."""
    least = 1

    def __init__(
        self, codec: HostCodec, command: str, fields: bytes, reply_digits: int | None, *, of_session: bool = False
    ) -> None:
        # As `Message` would: this is on the way of every read.
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
        """Beginning of the frame, and of that of the answer: the command and the ID that the window gave."""
        self.sent = False
        """True if it was given an ID."""
        self.done = False
        """True if `answer` or `error` is known."""
        self.answer: Any = None
        """The word or words read; None for an acknowledgement."""
        self.error: UnityLinkError | None = None
        self.waiter: Any = None

    def encode(self) -> bytes:
        """Return the frame, under the ID that the window has given."""
        codec = self.codec
        self.opening = codec.openings[self.command] + codec.id_text[self.first]
        covered = self.opening + self.fields
        self.frames = frame = covered + codec.framing.ending(covered, codec.begun)
        return frame

    def take_frame(self, offset: int, frame: bytes, events: Events) -> bool:  # noqa: ARG002
        """Take the frame of the response; False where it is anything else, or not as it usually is."""
        data = self.data_of(frame, self.opening)
        return data is not None and self.take_data(data, events)

    def accept(self, offset: int, body: bytes, position: int, events: Events) -> bool:  # noqa: ARG002
        """Take the response."""
        codec = self.codec
        if not body.startswith(codec.lower[self.command]) or len(body) + codec.framing.overhead != self.reply_size:
            return False
        return self.take_data(body[position:], events)

    def take_data(self, data: bytes, events: Events) -> bool:
        """Take what stands behind the ID in the response; False where it is no answer."""
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
        """Return what the response says."""
        if not data:
            return None
        if self.command in _MANY_WORDS:
            return wire.arrays.parse_words(data, self.codec.data_digits)
        return int(data, 16)

    def cancel(self) -> None:
        """Record that no call waits for it any more: it is not sent, or the gateway does as it was asked unheard."""
        if not (self.posted and self.sent):
            self.given_up = True

    def fail(self, error: UnityLinkError, events: Events) -> None:
        """End it with an error; that of a posted write which was sent is told by a `PostedFailure`."""
        if self.posted and self.sent:
            events.append(PostedFailure(error, 1, self.poster))
        elif not self.done:
            self.done = True
            self.error = error
            events.append(self)

    def fail_part(self, offset: int, count: int, error: UnityLinkError, events: Events) -> None:  # noqa: ARG002
        """End it with an error."""
        self.fail(error, events)

    def fields_at(self, offset: int) -> bytes:  # noqa: ARG002
        """Return the fields."""
        return self.fields

    def again(self, offset: int, count: int) -> Source | None:  # noqa: ARG002
        """Return the request itself where it changes nothing."""
        return self if self.outlives_session else None

    # A source of itself

    @property
    def outlives_session(self) -> bool:
        """Return whether the next session may send it, because it changes nothing."""
        return not self.of_session and self.command in REPEATABLE

    def take(self, room: int, events: Events) -> Message:  # noqa: ARG002
        """Return the request itself; a posted write that has waited for room is told as sent."""
        self.sent = True
        if self.posted:
            events.append(self)
        return self

    def exhausted(self) -> bool:
        """Return True: one turn is enough."""
        return True


class DestructiveRead(Request):
    """A request whose words the gateway keeps, for they cannot be read again.

    Args:
        codec: the messages of the gateway.
        command: in upper case.
        fields: hex digits.
        words: that it reads.
    """

    __slots__ = ("places",)

    def __init__(self, codec: HostCodec, command: str, fields: bytes, words: int) -> None:
        super().__init__(codec, command, fields, words * codec.data_digits)
        self.places = words


class SessionRequest(Request):
    """A request of the session itself.

    Args:
        codec: the messages of the gateway.
        command: in upper case.
        fields: hex digits.
        follow: is called when it has ended, with its error or None.
    """

    __slots__ = ("_follow",)

    def __init__(
        self, codec: HostCodec, command: str, fields: bytes, follow: Callable[[UnityLinkError | None, Events], None]
    ) -> None:
        super().__init__(codec, command, fields, 0, of_session=True)
        self._follow = follow

    def accept(self, offset: int, body: bytes, position: int, events: Events) -> bool:
        """Take the response, and go on."""
        ended: Events = []
        accepted = super().accept(offset, body, position, ended)
        if ended:
            self._follow(None, events)
        return accepted

    def fail(self, error: UnityLinkError, events: Events) -> None:
        """End it, and go on with its error."""
        ended: Events = []
        super().fail(error, ended)
        if ended:
            self._follow(error, events)


class Confirmation(Request):
    """An ``h``: its answer counts the posted writes that failed.

    Args:
        codec: the messages of the gateway.
        of_session: whether it ends with its session, where a new one would send it again.
    """

    __slots__ = ()
    is_fence = True

    def __init__(self, codec: HostCodec, *, of_session: bool = False) -> None:
        super().__init__(codec, "H", b"", codec.info.id_digits, of_session=of_session)

    def decode(self, data: bytes) -> Any:
        """Return None: what the response counts is told to the window."""
        int(data, 16)


class Fence(Confirmation):
    """A confirmation that is not sent before all that was asked for earlier.

    Args:
        codec: the messages of the gateway.
        of_session: whether it ends with its session, where a new one would send it again.
    """

    __slots__ = ("earlier",)

    def __init__(self, codec: HostCodec, *, of_session: bool = False) -> None:
        super().__init__(codec, of_session=of_session)
        self.earlier: list[Source] = []
        """Sources of several turns that were asked for before."""

    def follow(self, waiting: Iterable[Source]) -> None:
        """Wait for what waits now and takes several turns."""
        self.earlier += [source for source in waiting if not source.exhausted()]

    def fail_part(self, offset: int, count: int, error: UnityLinkError, events: Events) -> None:
        """End it with an error; where the gateway answers one, each posted write before it has been asked for."""
        if isinstance(error, GatewayError):
            self.take_data(b"0", events)
        else:
            super().fail_part(offset, count, error, events)

"""A client's requests on their way to the gateway and back.

A `Relayed` is a request in the exchange of the one link, under the ID that the link's window gives it. It remembers the
ID and the form that its client used, so that the answer can be put under that ID again.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from unity_link.errors import GatewayError, Outcome, UnansweredError, UnityLinkError, UnsupportedError
from unity_link.link.requests import REPEATABLE, Message, Rows
from unity_link.protocol.messages import COMMANDS, Codec, ErrorCode, Repetition

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import NDArray

    from unity_link.link.requests import Source

SMALLEST_RUN = 64
"""Requests for which room is waited for while others are under way: half the window of a gateway with short IDs."""


class Asker(Protocol):
    """Who is answered."""

    def answer(self, request: Relayed, body: bytes) -> None:
        """Take the body of the answer to a request; nothing, where it has none."""

    def posted(self, request: Relayed) -> None:
        """Record that a posted write is on its way."""


def answer_digits(codec: Codec, command: str, count: int) -> int | None:
    """Return the hex digits behind the ID of the answer to a request of so many words; None where none comes."""
    if command == "WS":
        return None
    return codec.info.data_digits * {"": 0, "d": 1, "D": count}[COMMANDS[command].reads]


class RowsAsker(Protocol):
    """Who is answered many at a time."""

    def answer_rows(self, rows: RelayedRows) -> None:
        """Record that some of the answers to many requests are there."""


class Relayed(Message):
    """One request of a client.

    Args:
        codec: the messages of the gateway, and of the client.
        command: in upper case.
        fields: hex digits, as the gateway is to see them.
        digits: hex digits of the answer's data, None where nothing answers.
        asker: who is answered.
        head: what the answer has before its data: command, and ID or echo.
        number: the client's ID, None where it gave none.
        plain: whether the request was a plain frame, and so is its answer.
    """

    __slots__ = (
        "_asker",
        "_frame",
        "after",
        "awaited",
        "cost",
        "executed",
        "fields",
        "head",
        "number",
        "order",
        "plain",
        "reply",
        "sent",
        "silent",
    )

    def __init__(
        self,
        codec: Codec,
        command: str,
        fields: bytes,
        digits: int | None,
        asker: Asker,
        head: bytes,
        number: int | None = None,
        *,
        plain: bool = False,
    ) -> None:
        super().__init__(codec, command, len(fields), digits)
        self.fields = fields
        self.head = head
        self.number = number
        self.plain = plain
        self.silent = False
        """Whether the client did not ask for this, and is not answered."""
        self.cost = self.size + self.reply_size
        """Bytes that it takes of the gateway's line."""
        self.order = 0
        """Its place among all that the client has asked for."""
        self.sent = False
        """Whether it is on its way to the gateway, and an answer is to come."""
        self.reply: bytes | None = None
        """The frame for the client, once there is one."""
        self.awaited: bytearray | None = None
        """Where its client notes the IDs that are under way."""
        self.executed = False
        """Whether the gateway has executed it without an error."""
        self.after: Callable[[bool], None] | None = None
        """Called when it is over, with `executed`."""
        self._asker = asker
        self._frame = b""

    def encode(self, offset: int, count: int) -> bytes:  # noqa: ARG002  (a request is a run of one)
        """Return the frame."""
        if not self._frame:
            self._frame = self.codec.request(self.command, self.first, self.fields)
        return self._frame

    def accept(self, offset: int, body: bytes, position: int) -> bool:  # noqa: ARG002
        """Hand on the answer."""
        command = self.codec.lower[self.command]
        if not body.startswith(command) or len(body) + self.codec.framing.overhead != self.reply_size:
            return False
        self.executed = True
        self._asker.answer(self, self.head + body[position:])
        return True

    def unwanted(self) -> bool:
        """Return whether it is not awaited any more."""
        return self.given_up

    def fail(self, error: UnityLinkError) -> None:
        """Tell the client what the protocol has words for."""
        code = _code_of(error, self.command)
        if code is ErrorCode.NO_SESSION and self.number is None:
            code = ErrorCode.BUS_TIMEOUT
        self.executed = code is None
        self._asker.answer(self, self.head if code is None else self.codec.error(code, self.number))

    def refuse(self, unsent: ErrorCode) -> None:
        """End it without an answer of the gateway: nothing on the bus answered.

        Args:
            unsent: the error that is answered where it has an ID and was not sent.
        """
        self.given_up = True
        code = ErrorCode.BUS_TIMEOUT if self.sent or self.number is None else unsent
        self._asker.answer(self, self.codec.error(code, self.number))

    @property
    def of_no_session(self) -> bool:
        """Whether it can be executed in any session: it was not sent, has no ID, and names no group."""
        return not self.sent and self.after is None and self.head[:1].isupper()

    def fields_at(self, offset: int) -> bytes:  # noqa: ARG002
        """Return the fields."""
        return self.fields

    def again(self, offset: int, count: int) -> Source | None:  # noqa: ARG002
        """Return the request itself where it changes nothing."""
        if self.command not in REPEATABLE:
            return None
        self._frame = b""
        return self

    # A request is a source of itself, when a new session takes it again.

    def least(self) -> int:
        """Return one."""
        return 1

    def take(self, room: int) -> Message:  # noqa: ARG002
        """Return the request itself."""
        if self.posted:
            self._asker.posted(self)
        else:
            self.sent = True
        return self

    def exhausted(self) -> bool:
        """Say that one turn is enough."""
        return True


class RelayedRows:
    """Many requests of one client for single words: a source of runs, and one place in the order of the answers.

    Args:
        codec: the messages of the gateway, and of the client.
        command: ``R`` or ``W``.
        fields: hex digits, shape (n, width).
        digits: hex digits of the data of each answer.
        asker: who is answered.
        number: the client's ID of the first.
    """

    posted = False
    of_no_session = False

    def __init__(
        self, codec: Codec, command: str, fields: NDArray[np.uint8], digits: int, asker: RowsAsker, number: int
    ) -> None:
        self.codec = codec
        self.command = command
        self.fields = fields
        self.digits = digits
        self.asker = asker
        self.number = number
        self.count = len(fields)
        self.size: int = codec.head_sizes[command] + fields.shape[1]
        self.cost = self.size + codec.head_sizes[command] + digits
        """Bytes that each takes of the gateway's line."""
        self.given_up = False
        self.order = 0
        """Its place among all that the client has asked for."""
        self.awaited: bytearray
        self.answered = 0
        """How many have been answered to the client."""
        self._sent = 0
        self._early: dict[int, tuple[int, bytes]] = {}

    def take(self, room: int) -> Message:
        """Return the next run, of at most `room` requests."""
        run = RelayedRun(self, self._sent, min(room, self.count - self._sent))
        self._sent += run.count
        return run

    def exhausted(self) -> bool:
        """Return whether all has been taken."""
        return self._sent == self.count

    def least(self) -> int:
        """Return a number that is worth a turn."""
        return min(SMALLEST_RUN, self.count - self._sent)

    def answer(self, offset: int, count: int, frames: bytes) -> None:
        """Take the frames that answer some of the requests, and hand on those that are next in the order."""
        self._early.setdefault(offset, (count, frames))
        self.asker.answer_rows(self)

    def ready(self) -> tuple[int, int, bytes]:
        """Return how many more can be answered in order, how many of these were sent, and the frames."""
        frames = []
        before = self.answered
        while (part := self._early.pop(self.answered, None)) is not None:
            self.answered += part[0]
            frames.append(part[1])
        return self.answered - before, max(0, min(self.answered, self._sent) - before), b"".join(frames)

    def refuse(self, unsent: ErrorCode) -> None:
        """End all that is not answered: nothing on the bus answered.

        Args:
            unsent: the error that is answered to those that were not sent.
        """
        self.given_up = True
        known = {offset + index for offset, (count, _) in self._early.items() for index in range(count)}
        for offset in range(self.answered, self.count):
            if offset not in known:
                self._early[offset] = (1, self.error(offset, ErrorCode.BUS_TIMEOUT if offset < self._sent else unsent))
        self.asker.answer_rows(self)

    def error(self, offset: int, code: ErrorCode) -> bytes:
        """Return the frame of an error for the client."""
        return self.codec.framing.checked(self.codec.error(code, self._number(offset)))

    def reply(self, offset: int, data: bytes) -> bytes:
        """Return the frame of an answer for the client."""
        codec = self.codec
        return codec.framing.checked(codec.lower[self.command] + codec.id_text[self._number(offset)] + data)

    def replies(self, offset: int, data: NDArray[np.uint8]) -> bytes:
        """Return the frames of many answers for the client."""
        return self.codec.request_rows(self.command, self._number(offset), data)

    def _number(self, offset: int) -> int:
        number: int = self.number + offset & self.codec.ring - 1
        return number


class RelayedRun(Rows):
    """Some of the requests, under the IDs that the link's window has given them.

    Args:
        rows: all of them.
        start: the first that is meant.
        count: how many.
    """

    __slots__ = ("_frames", "_rows", "_start")

    def __init__(self, rows: RelayedRows, start: int, count: int) -> None:
        super().__init__(rows.codec, rows.command, rows.fields.shape[1], rows.digits, count)
        self._rows = rows
        self._start = start
        self._frames = b""

    def encode(self, offset: int, count: int) -> bytes:
        """Return the frames of `count` requests from `offset` on."""
        if not self._frames:
            fields = self._rows.fields[self._start : self._start + self.count]
            self._frames = self.codec.request_rows(self.command, self.first, fields)
        return self._frames[offset * self.size : (offset + count) * self.size]

    def accept(self, offset: int, body: bytes, position: int) -> bool:
        """Hand on the answer to one request."""
        command = self.codec.lower[self.command]
        if not body.startswith(command) or len(body) + self.codec.framing.overhead != self.reply_size:
            return False
        self._rows.answer(self._start + offset, 1, self._rows.reply(self._start + offset, body[position:]))
        return True

    def accept_rows(self, offset: int, frames: bytes) -> int:
        """Hand on the answers to requests from `offset` on, as far as the frames are that."""
        number = self.first + offset & self.codec.ring - 1
        data = self.codec.matching_rows(self.command, number, frames, self._rows.digits)
        if len(data):
            self._rows.answer(self._start + offset, len(data), self._rows.replies(self._start + offset, data))
        return len(data)

    def unwanted(self) -> bool:
        """Return whether it is not awaited any more."""
        return self.given_up or self._rows.given_up

    def fail(self, error: UnityLinkError) -> None:
        """Tell the client what the protocol has words for, of all that is not answered."""
        self.fail_part(0, self.count, error)

    def fail_part(self, offset: int, count: int, error: UnityLinkError) -> None:
        """Tell the same of some."""
        rows, code = self._rows, _code_of(error, self.command)
        for position in range(self._start + offset, self._start + offset + count):
            rows.answer(position, 1, rows.reply(position, b"") if code is None else rows.error(position, code))

    def fields_at(self, offset: int) -> bytes:
        """Return the fields of one request."""
        fields: bytes = self._rows.fields[self._start + offset].tobytes()
        return fields

    def again(self, offset: int, count: int) -> Source | None:
        """Return some of the requests where they change nothing."""
        if self.command not in REPEATABLE:
            return None
        return Again(self._rows, self._start + offset, count)


class Again:
    """Requests of a lost session that a new one takes again."""

    posted = False

    def __init__(self, rows: RelayedRows, start: int, count: int) -> None:
        self._rows, self._start, self._count = rows, start, count
        self.size = rows.size

    def least(self) -> int:
        """Return a number that is worth a turn."""
        return min(SMALLEST_RUN, self._count)

    def take(self, room: int) -> Message:
        """Return the next run, of at most `room` requests."""
        run = RelayedRun(self._rows, self._start, min(room, self._count))
        self._start += run.count
        self._count -= run.count
        return run

    def exhausted(self) -> bool:
        """Return whether all has been taken."""
        return not self._count

    def unwanted(self) -> bool:
        """Return whether it is not awaited any more."""
        return self._rows.given_up

    def fail(self, error: UnityLinkError) -> None:
        """Tell the client."""
        RelayedRun(self._rows, self._start, self._count).fail(error)


def _code_of(error: UnityLinkError, command: str) -> ErrorCode | None:
    """Return the error that a client is told, None where it is told that its request was executed.

    A link that ends may leave open whether a request was executed. The nearest that the protocol has is 05: nothing on
    the bus answered. What is known not to be executed although it was sent was refused by a gateway that was reset.
    """
    if isinstance(error, GatewayError):
        return ErrorCode(error.code) if error.code in set(ErrorCode) else ErrorCode.BUS_ERROR
    if isinstance(error, UnsupportedError):
        return ErrorCode.OUT_OF_RANGE
    if isinstance(error, UnansweredError) and error.outcome is Outcome.EXECUTED:
        refused = COMMANDS[command].repetition is Repetition.REFUSE
        return ErrorCode.ALREADY_EXECUTED if refused else None
    if isinstance(error, UnansweredError) and error.outcome is Outcome.NOT_EXECUTED:
        return ErrorCode.NO_SESSION
    return ErrorCode.BUS_TIMEOUT


class Said:
    """An answer that needs nothing of the gateway, in line behind those that do."""

    __slots__ = ("order", "reply")
    of_no_session = False

    def __init__(self, reply: bytes, order: int) -> None:
        self.reply = reply
        self.order = order

"""A client's requests on their way to the gateway and back.

A `Relayed` is a request in the session of the one link, under the ID that the link's window gives it. It remembers the
ID and the form that its client used, so that the answer can be put under that ID again.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from unity_link.errors import GatewayError, Outcome, UnansweredError, UnityLinkError, UnsupportedError
from unity_link.protocol.host.batches import BatchRun, WordBatch
from unity_link.protocol.host.events import Awaited
from unity_link.protocol.host.requests import Request
from unity_link.protocol.wire.arrays import matching_rows, request_rows
from unity_link.protocol.wire.messages import COMMANDS, Codec, ErrorCode, Repeat, parse_numbers

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import NDArray

    from unity_link.protocol.gateway.session import SessionState
    from unity_link.protocol.host.events import Events
    from unity_link.protocol.host.host_codec import HostCodec

FATES = {ErrorCode.BUS_ERROR, ErrorCode.BUS_TIMEOUT, ErrorCode.OUT_OF_RANGE}
"""Errors of a request that was executed."""


class Asker(Protocol):
    """A receiver of answers."""

    def answer(self, request: Relayed, body: bytes) -> None:
        """Take the body of the answer to a request; nothing, where it has none."""

    def posted(self, request: Relayed) -> None:
        """Record that a posted write is on its way."""


def no_session(to_client: Codec, state: SessionState, number: int, characters: int) -> bytes:
    """Return the body of error 0A about a request that came whole in a session, of so many characters."""
    return to_client.no_session(
        number, to_client.framing.crc.of(bytes(characters), state.seeds[0] if characters else 0)
    )


def answer_digits(codec: Codec, command: str, count: int) -> int | None:
    """Return the hex digits behind the ID of the answer to a request of so many words; None where none comes."""
    if command == "WS":
        return None
    return codec.info.data_digits * {"": 0, "d": 1, "D": count}[COMMANDS[command].reads]


class RowsAsker(Protocol):
    """A receiver of many answers at a time."""

    def answer_rows(self, rows: RelayedRows) -> None:
        """Record that some of the answers to many requests are there."""


class Relayed(Request):
    """One request of a client.

    Args:
        codec: the messages of the gateway.
        command: in upper case.
        fields: hex digits, as the gateway is to see them.
        digits: hex digits of the answer's data, None where nothing answers.
        asker: who is answered.
        head: what the answer has before its data: command, and ID or echo; empty where only errors are answered.
        number: the client's ID, None where it gave none.
        plain: whether the request was a plain frame, and so is its answer.
    """

    __slots__ = (
        "_asker",
        "after",
        "awaited",
        "characters",
        "cost",
        "executed",
        "head",
        "is_fence",
        "number",
        "order",
        "places",
        "plain",
        "repeated",
        "reply",
        "room",
        "silent",
        "state",
        "stateless",
        "stored",
    )

    def __init__(
        self,
        codec: HostCodec,
        command: str,
        fields: bytes,
        digits: int | None,
        asker: Asker,
        head: bytes,
        number: int | None = None,
        *,
        plain: bool = False,
    ) -> None:
        super().__init__(codec, command, fields, codec.info.id_digits if command == "H" else digits)
        self.is_fence = command == "H"
        self.places = (digits or 0) // codec.data_digits if COMMANDS[command].repetition is Repeat.KEPT else 0
        self.head = head
        self.number = number
        self.plain = plain
        self.silent = False
        """True if the client did not ask for this, and is not answered."""
        self.cost = self.size + self.reply_size
        """Bytes that it takes of the gateway's line."""
        self.room = 0
        """Bytes of what its client may have under way that are free again when it is over."""
        self.order = 0
        """Its place among all that the client has asked for."""
        self.reply: bytes | None = None
        """The frame for the client, once there is one."""
        self.state: SessionState | None = None
        """Session of the client in which it was asked for; None once it is refused as that is over."""
        self.stateless = command == "WS"
        """True of a posted write, also where the gateway is to answer it."""
        self.repeated = False
        """True of a read that is repeated: how it ends now changes nothing of how it ended first."""
        self.characters = len(command) + codec.info.id_digits + len(fields)
        """Characters of the client's request before its check."""
        self.executed = False
        """True if the gateway has executed it, as far as is known without an error."""
        self.after: Callable[[bool], None] | None = None
        """Called when it is over, with `executed`."""
        self.stored: Callable[[], None] | None = None
        """Called when it was executed, before anything that came behind its answer is looked at."""
        self._asker = asker

    def accept(self, offset: int, body: bytes, position: int, events: Events) -> bool:
        """Take the response."""
        accepted = super().accept(offset, body, position, events)
        if accepted and self.stored is not None:
            self.stored()
        return accepted

    def decode(self, data: bytes) -> bytes:
        """Return the data as they stand in the response."""
        return data

    def fail(self, error: UnityLinkError, events: Events) -> None:
        """End it with an error; so is a posted write that was sent, of which nothing else is heard."""
        if not self.done:
            self.done = True
            self.error = error
            events.append(self)

    def settle(self) -> None:
        """Answer the client with the outcome, in the frames that the protocol has for it."""
        if not self.done:
            self._asker.posted(self)
        elif self.error is None:
            self.executed = True
            self._asker.answer(self, self.head + self._told())
        else:
            code = _code_of(self.error)
            if code is ErrorCode.NO_SESSION and self.number is None:
                code = ErrorCode.BUS_TIMEOUT
            self.executed = isinstance(self.error, UnansweredError) and self.error.outcome is Outcome.EXECUTED
            self._asker.answer(self, self._refusal(code))

    def _told(self) -> bytes:
        """Return what the client's answer has behind its ID or echo, and keep it if it cannot be read again."""
        answer: bytes = self.answer
        if self.command == "H":
            # What the gateway counts are posted writes of all clients. Behind any other answer an `h` only makes sure.
            counts = self.number is not None and self.head == b"h" + self.codec.id_text[self.number]
            return self.codec.id_text[self.state.failed] if counts and self.state is not None else b""
        if self.number is None or self.state is None:
            return answer
        if COMMANDS[self.command].repetition is Repeat.KEPT:
            self.state.keep(self.number, parse_numbers(answer, self.codec.info.data_digits))
        return answer

    def _refusal(self, code: ErrorCode) -> bytes:
        """Return the body of an error for the client, and note that the request ended so."""
        if self.number is None or self.state is None:
            return self.codec.error(code, self.number)
        if code is ErrorCode.NO_SESSION:
            state, self.state = self.state, None
            return no_session(self.codec, state, self.number, 0 if self.plain else self.characters)
        if code in FATES and not self.repeated:
            self.state.fail(self.number, code, posted=self.stateless)
        return self.codec.error(code, self.number)

    def refuse(self, unsent: ErrorCode) -> None:
        """End it without an answer of the gateway: nothing on the bus answered.

        Args:
            unsent: the error that is answered where it has an ID and was not sent.
        """
        self.given_up = True
        code = ErrorCode.BUS_TIMEOUT if self.sent or self.number is None else unsent
        self._asker.answer(self, self._refusal(code))

    @property
    def of_no_session(self) -> bool:
        """Return whether it can be executed in any session: it was not sent, has no ID, and names no group."""
        return not self.sent and self.after is None and self.number is None and not self.silent


class RelayedRows(WordBatch):
    """Many requests of one client for single words: a source of runs, and one place in the order of the answers.

    Args:
        codec: the messages of the gateway.
        to_client: the messages of the client.
        command: ``R`` or ``W``.
        fields: hex digits, shape (n, width).
        asker: who is answered.
        number: the client's ID of the first.
    """

    smallest_turn = 64
    of_no_session = False

    def __init__(
        self, codec: HostCodec, to_client: Codec, command: str, fields: NDArray[np.uint8], asker: RowsAsker, number: int
    ) -> None:
        super().__init__(codec, command, [(fields, fields.shape[1])])
        self._to_client = to_client
        self.number = number
        self.cost = self.size + codec.head_sizes[command] + (self.reply_digits or 0)
        """Bytes that each takes of the gateway's line."""
        self.room = 0
        """Bytes of posted writes before them that are free again when the first is answered."""
        self.order = 0
        """Its place among all that the client has asked for."""
        self.state: SessionState
        """Session of the client in which they were asked for."""
        self.answered = 0
        """Number of requests answered to the client."""
        self._fields = fields
        self._asker = asker
        self._early: dict[int, tuple[int, bytes]] = {}

    def fields(self, start: int, count: int) -> NDArray[np.uint8]:
        """Return the hex digits of the fields of some requests."""
        return self._fields[start : start + count]

    def run(self, start: int, count: int) -> RelayedRun:
        """Return some of the requests."""
        return RelayedRun(self, start, count)

    def take_frames(self, offset: int, count: int, frames: bytes) -> None:
        """Take the frames that answer some of the requests, and tell the client what is answered in order."""
        self._early.setdefault(offset, (count, frames))
        self._asker.answer_rows(self)

    def ready(self) -> tuple[int, int, bytes]:
        """Return how many more can be answered in order, how many of these were sent, and the frames."""
        frames = []
        before = self.answered
        while (part := self._early.pop(self.answered, None)) is not None:
            self.answered += part[0]
            frames.append(part[1])
        return self.answered - before, max(0, min(self.answered, self.sent) - before), b"".join(frames)

    def refuse(self, unsent: ErrorCode) -> None:
        """End all that is not answered: nothing on the bus answered.

        Args:
            unsent: the error that is answered to those that were not sent.
        """
        self.given_up = True
        known = {offset + index for offset, (count, _) in self._early.items() for index in range(count)}
        for offset in range(self.answered, self.count):
            if offset not in known:
                code = ErrorCode.BUS_TIMEOUT if offset < self.sent else unsent
                self._early[offset] = (1, self.error_frame(offset, code))
        self._asker.answer_rows(self)

    def error_frame(self, offset: int, code: ErrorCode) -> bytes:
        """Return the frame of an error for the client, and note that the request ended so."""
        number, to_client = self._number(offset), self._to_client
        if code is ErrorCode.NO_SESSION:
            characters = len(self.command) + to_client.info.id_digits + self._fields.shape[1]
            return to_client.framing.checked(no_session(to_client, self.state, number, characters))
        if code in FATES:
            self.state.fail(number, code, posted=False)
        return to_client.framing.checked(to_client.error(code, number), self.state.seeds[1])

    def reply(self, offset: int, data: bytes) -> bytes:
        """Return the frame of an answer for the client."""
        codec = self._to_client
        body = codec.lower[self.command] + codec.id_text[self._number(offset)] + data
        return codec.framing.checked(body, self.state.seeds[1])

    def replies(self, offset: int, data: NDArray[np.uint8]) -> bytes:
        """Return the frames of many answers for the client."""
        return request_rows(self._to_client, self.command, self._number(offset), data, self.state.seeds[1])

    def _number(self, offset: int) -> int:
        return self.number + offset & self.codec.id_count - 1


class RowsAnswered(Awaited):
    """Event: some of a client's requests for single words are answered.

    Args:
        rows: the requests.
        offset: place of the first of them.
        size: how many they are.
        frames: answers for the client.
    """

    __slots__ = ("_frames", "_offset", "_rows", "_size")

    def __init__(self, rows: RelayedRows, offset: int, size: int, frames: bytes) -> None:
        self._rows, self._offset, self._size, self._frames = rows, offset, size, frames

    def settle(self) -> None:
        """Answer the client, behind the answers of earlier events."""
        self._rows.take_frames(self._offset, self._size, self._frames)


class RelayedRun(BatchRun):
    """Some of the requests, under the IDs that the link's window has given them.

    Args:
        rows: all of them.
        start: the first that is meant.
        count: how many.
    """

    __slots__ = ("_rows",)

    def __init__(self, rows: RelayedRows, start: int, count: int) -> None:
        super().__init__(rows, start, count)
        self._rows = rows

    def _take(self, place: int, data: bytes, events: Events) -> bool:
        """Hand on the answer to one request."""
        events.append(RowsAnswered(self._rows, place, 1, self._rows.reply(place, data)))
        return True

    def accept_rows(self, offset: int, frames: bytes, events: Events) -> int:
        """Hand on the answers to requests from `offset` on, as far as the frames are that."""
        number, place = self.first + offset & self.codec.id_count - 1, self._start + offset
        codec, digits = self.codec, self._rows.reply_digits or 0
        data = matching_rows(codec, self.command, number, frames, digits, codec.seed_back)
        if len(data):
            events.append(RowsAnswered(self._rows, place, len(data), self._rows.replies(place, data)))
        return len(data)

    def fail_part(self, offset: int, count: int, error: UnityLinkError, events: Events) -> None:
        """Answer the client for some requests that ended with an error."""
        rows, code = self._rows, _code_of(error)
        for place in range(self._start + offset, self._start + offset + count):
            events.append(RowsAnswered(rows, place, 1, rows.error_frame(place, code)))


def _code_of(error: UnityLinkError) -> ErrorCode:
    """Return the error that a client is told.

    A link that ends may leave open whether a request was executed, or how it ended. The nearest that the protocol has
    is 05: nothing on the bus answered. What is known not to be executed although it was sent was refused by a gateway
    that was reset.
    """
    if isinstance(error, GatewayError):
        return ErrorCode(error.code) if error.code in set(ErrorCode) else ErrorCode.BUS_ERROR
    if isinstance(error, UnsupportedError):
        return ErrorCode.OUT_OF_RANGE
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

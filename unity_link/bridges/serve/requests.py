"""A client's requests on their way to the gateway, and the answers.

A `Relayed` is a request in the session of the shared link, with an ID of that link's window. It stores the ID and the
form that its client used, so that the answer can be converted back.
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

EXECUTED = {ErrorCode.BUS_ERROR, ErrorCode.BUS_TIMEOUT, ErrorCode.OUT_OF_RANGE}
"""Errors of requests that were executed."""


class Asker(Protocol):
    """A receiver of answers."""

    def answer(self, request: Relayed, body: bytes) -> None:
        """Process the body of the answer to a request; empty for a request without an answer."""

    def posted(self, request: Relayed) -> None:
        """Note that a posted write was sent."""


def no_session(to_client: Codec, state: SessionState, number: int, characters: int) -> bytes:
    """Return the body of error 0A for a request of `characters` characters that arrived intact in a session."""
    return to_client.no_session(
        number, to_client.framing.crc.of(bytes(characters), state.seeds[0] if characters else 0)
    )


def answer_digits(codec: Codec, command: str, count: int) -> int | None:
    """Return the number of hex digits after the ID in the answer to a request of `count` words; None for no answer."""
    if command == "WS":
        return None
    return codec.info.data_digits * {"": 0, "d": 1, "D": count}[COMMANDS[command].reads]


class RowsAsker(Protocol):
    """A receiver of many answers at a time."""

    def answer_rows(self, rows: RelayedRows) -> None:
        """Process answers to many requests, of which some have arrived."""


class Relayed(Request):
    """One request of a client.

    Args:
        codec: codec for the gateway.
        command: command in upper case.
        fields: fields in hex digits, as sent to the gateway.
        digits: number of hex digits of data in the answer; None for a request without an answer.
        asker: receiver of the answer.
        head: beginning of the answer, before its data: command, and ID or echo; empty if only errors are answered.
        number: the client's ID; None without one.
        plain: whether the request was a plain frame; then the answer is one, too.
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
        """True for a request that the server makes for a client, without an answer to the client."""
        self.cost = self.size + self.reply_size
        """Bytes of the request and its answer on the gateway's line."""
        self.room = 0
        """Bytes of the client's limit that are free again when the request is over."""
        self.order = 0
        """Number of the request in the order of all requests of the client."""
        self.reply: bytes | None = None
        """Frame for the client, after the request was answered."""
        self.state: SessionState | None = None
        """Session of the client in which the request was made; None after a refusal because that session is over."""
        self.stateless = command == "WS"
        """True for a posted write, even if the gateway answers it."""
        self.repeated = False
        """True for a repeated read: its result does not replace that of the first one."""
        self.characters = len(command) + codec.info.id_digits + len(fields)
        """Characters of the client's request before its CRC."""
        self.executed = False
        """True if the gateway is known to have executed the request."""
        self.after: Callable[[bool], None] | None = None
        """Called with `executed` when the request is over."""
        self.stored: Callable[[], None] | None = None
        """Called when the request was executed, before frames after its answer are processed."""
        self._asker = asker

    def accept(self, offset: int, body: bytes, position: int, events: Events) -> bool:
        """Process the response."""
        accepted = super().accept(offset, body, position, events)
        if accepted and self.stored is not None:
            self.stored()
        return accepted

    def decode(self, data: bytes) -> bytes:
        """Return the data digits of the response unchanged."""
        return data

    def fail(self, error: UnityLinkError, events: Events) -> None:
        """End the request with an error, also a posted write that was sent and has no answer."""
        if not self.done:
            self.done = True
            self.error = error
            events.append(self)

    def settle(self) -> None:
        """Answer the client according to the outcome, in the frames that the protocol has for it."""
        if not self.done:
            self._asker.posted(self)
        elif self.error is None:
            self.executed = True
            self._asker.answer(self, self.head + self._data())
        else:
            code = _code_of(self.error)
            if code is ErrorCode.NO_SESSION and self.number is None:
                code = ErrorCode.BUS_TIMEOUT
            self.executed = isinstance(self.error, UnansweredError) and self.error.outcome is Outcome.EXECUTED
            self._asker.answer(self, self._refusal(code))

    def _data(self) -> bytes:
        """Return the data of the client's answer, and store it in the session if it cannot be read again."""
        answer: bytes = self.answer
        if self.command == "H":
            # The gateway counts failed posted writes of all clients, so use the client's own count. An `h` that the
            # server has sent for another answer only confirms earlier requests, and has no count.
            counts = self.number is not None and self.head == b"h" + self.codec.id_text[self.number]
            return self.codec.id_text[self.state.failed] if counts and self.state is not None else b""
        if self.number is None or self.state is None:
            return answer
        if COMMANDS[self.command].repetition is Repeat.KEPT:
            self.state.keep(self.number, parse_numbers(answer, self.codec.info.data_digits))
        return answer

    def _refusal(self, code: ErrorCode) -> bytes:
        """Return the body of an error for the client, and store the error as the outcome of the request."""
        if self.number is None or self.state is None:
            return self.codec.error(code, self.number)
        if code is ErrorCode.NO_SESSION:
            state, self.state = self.state, None
            return no_session(self.codec, state, self.number, 0 if self.plain else self.characters)
        if code in EXECUTED and not self.repeated:
            self.state.fail(self.number, code, posted=self.stateless)
        return self.codec.error(code, self.number)

    def refuse(self, unsent: ErrorCode) -> None:
        """End the request without an answer of the gateway, with the error that nothing on the bus answered.

        Args:
            unsent: error for a request with an ID that was not sent.
        """
        self.given_up = True
        code = ErrorCode.BUS_TIMEOUT if self.sent or self.number is None else unsent
        self._asker.answer(self, self._refusal(code))

    @property
    def of_no_session(self) -> bool:
        """Return whether any session can execute the request: it was not sent, has no ID, and names no group."""
        return not self.sent and self.after is None and self.number is None and not self.silent


class RelayedRows(WordBatch):
    """Many requests of one client for single words: one source of runs, and one entry in the order of answers.

    Args:
        codec: codec for the gateway.
        to_client: codec for the client.
        command: ``R`` or ``W``.
        fields: hex digits, shape (n, width).
        asker: receiver of the answers.
        number: the client's ID of the first request.
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
        """Bytes of each request and its answer on the gateway's line."""
        self.room = 0
        """Bytes of earlier posted writes that are free again when the first request is answered."""
        self.order = 0
        """Number of the entry in the order of all requests of the client."""
        self.state: SessionState
        """Session of the client in which the requests were made."""
        self.answered = 0
        """Number of requests whose answers were sent to the client."""
        self._fields = fields
        self._asker = asker
        self._early: dict[int, tuple[int, bytes]] = {}

    def fields(self, start: int, count: int) -> NDArray[np.uint8]:
        """Return the hex digits of the fields of some requests, shape (count, width)."""
        return self._fields[start : start + count]

    def run(self, start: int, count: int) -> RelayedRun:
        """Return a run of some of the requests."""
        return RelayedRun(self, start, count)

    def take_frames(self, offset: int, count: int, frames: bytes) -> None:
        """Store the frames that answer some of the requests, and send the client those that are next in order."""
        self._early.setdefault(offset, (count, frames))
        self._asker.answer_rows(self)

    def ready(self) -> tuple[int, int, bytes]:
        """Return the number of requests that can be answered now, how many of these were sent, and the frames."""
        frames = []
        before = self.answered
        while (part := self._early.pop(self.answered, None)) is not None:
            self.answered += part[0]
            frames.append(part[1])
        return self.answered - before, max(0, min(self.answered, self.sent) - before), b"".join(frames)

    def refuse(self, unsent: ErrorCode) -> None:
        """End all unanswered requests, with the error that nothing on the bus answered.

        Args:
            unsent: error for requests that were not sent.
        """
        self.given_up = True
        known = {offset + index for offset, (count, _) in self._early.items() for index in range(count)}
        for offset in range(self.answered, self.count):
            if offset not in known:
                code = ErrorCode.BUS_TIMEOUT if offset < self.sent else unsent
                self._early[offset] = (1, self.error_frame(offset, code))
        self._asker.answer_rows(self)

    def error_frame(self, offset: int, code: ErrorCode) -> bytes:
        """Return the frame of an error for the client, and store the error as the outcome of the request."""
        number, to_client = self._number(offset), self._to_client
        if code is ErrorCode.NO_SESSION:
            characters = len(self.command) + to_client.info.id_digits + self._fields.shape[1]
            return to_client.framing.checked(no_session(to_client, self.state, number, characters))
        if code in EXECUTED:
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
    """Event: some of a client's requests for single words have answers.

    Args:
        rows: the requests.
        offset: place of the first of them.
        size: number of answered requests.
        frames: answers for the client.
    """

    __slots__ = ("_frames", "_offset", "_rows", "_size")

    def __init__(self, rows: RelayedRows, offset: int, size: int, frames: bytes) -> None:
        self._rows, self._offset, self._size, self._frames = rows, offset, size, frames

    def settle(self) -> None:
        """Answer the client, after the answers of earlier events."""
        self._rows.take_frames(self._offset, self._size, self._frames)


class RelayedRun(BatchRun):
    """Some of the requests of a `RelayedRows`, with the IDs of the link's window.

    Args:
        rows: all requests.
        start: place of the first request of the run.
        count: number of requests in the run.
    """

    __slots__ = ("_rows",)

    def __init__(self, rows: RelayedRows, start: int, count: int) -> None:
        super().__init__(rows, start, count)
        self._rows = rows

    def _take(self, place: int, data: bytes, events: Events) -> bool:
        """Pass on the answer to one request."""
        events.append(RowsAnswered(self._rows, place, 1, self._rows.reply(place, data)))
        return True

    def accept_rows(self, offset: int, frames: bytes, events: Events) -> int:
        """Pass on the answers to requests from `offset` on, as far as the frames are such; return their number."""
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
    """Return the code with which an error is reported to a client.

    If a link ends, it may be unknown whether a request was executed, or with what result. The nearest error of the
    protocol is 05, nothing on the bus answered. A request that was sent and is known not to be executed was refused by
    a gateway that was reset.
    """
    if isinstance(error, GatewayError):
        return ErrorCode(error.code) if error.code in set(ErrorCode) else ErrorCode.BUS_ERROR
    if isinstance(error, UnsupportedError):
        return ErrorCode.OUT_OF_RANGE
    if isinstance(error, UnansweredError) and error.outcome is Outcome.NOT_EXECUTED:
        return ErrorCode.NO_SESSION
    return ErrorCode.BUS_TIMEOUT


class LocalAnswer:
    """An answer of the server's own that waits for the answers to earlier requests."""

    __slots__ = ("order", "reply")
    of_no_session = False

    def __init__(self, reply: bytes, order: int) -> None:
        self.reply = reply
        self.order = order

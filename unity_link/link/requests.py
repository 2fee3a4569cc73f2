"""What a link asks of a gateway: requests that know how they are sent and what their answer means.

The exchange takes them from *sources*. Most requests are a source of their own; a block is a source of several
requests, because the gateway limits their length; a batch is a source of runs of many, which are encoded and decoded by
numpy.
"""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from unity_link.errors import (
    AnswerLostError,
    BusError,
    BusTimeoutError,
    GatewayError,
    Outcome,
    OutOfRangeError,
    UnansweredError,
    UnityLinkError,
)
from unity_link.protocol.messages import Codec, Words, hex_rows, parse_words
from unity_link.protocol.window import Run

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Callable, Iterable

    from numpy.typing import NDArray

SMALLEST_BATCH = 32
"""Requests of a batch that are worth a turn of numpy: room for so many is waited for while others are under way."""
_POSTED_RUNS = 8
"""One run of posted writes takes this part of the ring: a quarter of the window, behind which a fence is due."""
REPEATABLE = frozenset({"R", "RM", "H"})
"""Commands that change nothing: a new session may send them again."""
_ERRORS: dict[int, tuple[type[GatewayError], str]] = {
    4: (BusError, "the bus refused the access"),
    5: (BusTimeoutError, "nothing on the bus answered"),
    6: (OutOfRangeError, "the gateway says that a value is out of its range"),
    8: (AnswerLostError, "the request was executed once, but its answer was lost"),
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


def gateway_error(code: int, what: str) -> GatewayError:
    """Return the exception for an error code of the gateway; `what` names the request."""
    kind, text = _ERRORS.get(code, (GatewayError, f"the gateway answered error {code:02X}"))
    return kind(f"{what}: {text}", code)


class Source(Protocol):
    """Something that has requests to send."""

    @property
    def size(self) -> int:
        """Characters of the next request."""

    @property
    def posted(self) -> bool:
        """Whether the next request is a posted write."""

    def least(self) -> int:
        """Return for how many requests room is wanted before the next turn; 0 for no turn before an answer has come."""

    def take(self, room: int) -> Message:
        """Return the next run, of at most `room` requests."""

    def exhausted(self) -> bool:
        """Return whether all has been taken."""

    def unwanted(self) -> bool:
        """Return whether it is not awaited any more."""

    def fail(self, error: UnityLinkError) -> None:
        """End what has not been taken yet."""


class Message(Run):
    """A run that knows its messages.

    Args:
        codec: the messages of the gateway.
        command: in upper case.
        fields_size: characters of the fields of each request.
        reply_digits: hex digits behind the ID of each answer, None for a posted write.
        count: number of requests.
    """

    __slots__ = ("codec", "command", "given_up")

    def __init__(self, codec: Codec, command: str, fields_size: int, reply_digits: int | None, count: int = 1) -> None:
        head = codec.head_sizes[command]
        super().__init__(count, head + fields_size, 0 if reply_digits is None else head + reply_digits)
        self.codec = codec
        self.command = command
        self.given_up = False

    def encode(self, offset: int, count: int) -> bytes:
        """Return the frames of `count` requests from `offset` on, under the IDs that the window gave."""
        raise NotImplementedError

    def accept(self, offset: int, body: bytes, position: int) -> bool:
        """Take the response to one request, with its data from `position` on; False where it is no response to it."""
        raise NotImplementedError

    def unwanted(self) -> bool:
        """Return whether the answer is not awaited any more."""
        return self.given_up

    def fail(self, error: UnityLinkError) -> None:
        """Tell the waiting call that there will be no answer."""
        raise NotImplementedError

    def fail_part(self, offset: int, count: int, error: UnityLinkError) -> None:  # noqa: ARG002
        """Tell the waiting call that there will be no answer to these requests of the run."""
        self.fail(error)

    def describe(self, offset: int) -> str:
        """Name one request for an error message."""
        fields = self.fields_at(offset).decode()
        if self.command[0] not in "RW":
            return _NAMES[self.command]
        return f"{_NAMES[self.command]} at 0x{fields[: self.codec.info.address_digits]}"

    def fields_at(self, offset: int) -> bytes:
        """Return the fields of one request."""
        raise NotImplementedError

    def again(self, offset: int, count: int) -> Source | None:
        """Return what a new session has to send for this part of the run, None where that could execute it twice."""
        raise NotImplementedError


class Rows(Message):
    """A run of many requests whose answers are taken many at a time."""

    __slots__ = ()

    def accept_rows(self, offset: int, frames: bytes) -> int:
        """Take the responses to requests from `offset` on; return how many of the frames were such responses."""
        raise NotImplementedError


class Request(Message):
    """One request, and the future of its answer."""

    __slots__ = ("_command", "fields", "frame", "future")

    def __init__(
        self, codec: Codec, command: str, fields: bytes, reply_digits: int | None, loop: asyncio.AbstractEventLoop
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
        self._command = codec.lower[command]
        self.fields = fields
        self.frame = b""
        self.future: asyncio.Future[Any] = loop.create_future()

    def encode(self, offset: int, count: int) -> bytes:  # noqa: ARG002  (a request is a run of one)
        """Return the frame."""
        if not self.frame:
            codec = self.codec
            self.frame = codec.framing.checked(self._command + codec.id_text[self.first] + self.fields)
        return self.frame

    def accept(self, offset: int, body: bytes, position: int) -> bool:  # noqa: ARG002
        """Take the response."""
        if not body.startswith(self._command) or len(body) + self.codec.framing.overhead != self.reply_size:
            return False
        try:
            answer = self.decode(body, position)
        except ValueError:
            return False
        if not self.future.done():
            self.future.set_result(answer)
        return True

    def fields_at(self, offset: int) -> bytes:  # noqa: ARG002
        """Return the fields."""
        return self.fields

    def decode(self, body: bytes, position: int) -> Any:  # noqa: ARG002
        """Return what the response says; nothing, for an acknowledgement."""
        return None

    def unwanted(self) -> bool:
        """Return whether the answer is not awaited any more."""
        return self.given_up or self.future.cancelled()

    def fail(self, error: UnityLinkError) -> None:
        """Raise `error` in the waiting call."""
        if not self.future.done():
            self.future.set_exception(error)

    @property
    def of_session(self) -> bool:
        """Whether it ends with its session, sent or not."""
        return False

    def again(self, offset: int, count: int) -> Source | None:  # noqa: ARG002
        """Return the request itself where it changes nothing."""
        if self.of_session or self.command not in REPEATABLE:
            return None
        self.frame = b""
        return self

    # A request is a source of itself.

    def least(self) -> int:
        """Return one."""
        return 1

    def take(self, room: int) -> Message:  # noqa: ARG002
        """Return the request itself."""
        return self

    def exhausted(self) -> bool:
        """Say that one turn is enough."""
        return True


class WordRequest(Request):
    """A request that is answered by one word."""

    __slots__ = ()

    def decode(self, body: bytes, position: int) -> int:
        """Return the word."""
        return int(body[position:], 16)


class WordsRequest(Request):
    """A request that is answered by several words."""

    __slots__ = ()

    def decode(self, body: bytes, position: int) -> Words:
        """Return the words as an array."""
        return parse_words(body[position:], self.codec.info.data_digits)


class Posted(Request):
    """A stateless write: no answer, and no waiting call."""

    __slots__ = ("report",)

    def __init__(self, codec: Codec, fields: bytes, loop: asyncio.AbstractEventLoop, report: Any) -> None:
        super().__init__(codec, "WS", fields, None, loop)
        self.report = report

    def take(self, room: int) -> Message:  # noqa: ARG002
        """Return the request itself, and let go on who waited for room."""
        if not self.future.done():
            self.future.set_result(None)
        return self

    def fail(self, error: UnityLinkError) -> None:
        """Keep the error for the next fence, or raise it in who still waits for room."""
        if self.future.done():
            self.report(error)
        else:
            self.future.set_exception(error)


class OfSession(Request):
    """A request that has a meaning in the session alone in which it was made."""

    __slots__ = ()

    @property
    def of_session(self) -> bool:
        """Return True."""
        return True


class Fence(Request):
    """An ``h`` that is not sent before all that was asked for earlier.

    Args:
        codec: the messages of the gateway.
        loop: the loop of the future.
        leaving: whether it ends with its session, where a new one would send it again.
    """

    __slots__ = ("_leaving", "earlier")

    def __init__(self, codec: Codec, loop: asyncio.AbstractEventLoop, *, leaving: bool = False) -> None:
        super().__init__(codec, "H", b"", 0, loop)
        self._leaving = leaving
        self.earlier: list[Source] = []
        """Sources of several turns that were asked for before."""

    @property
    def of_session(self) -> bool:
        """Whether it ends with its session."""
        return self._leaving


class Unawaited(Request):
    """A request of the link itself, which no call waits for and no cancellation ends."""

    __slots__ = ()

    def fail(self, error: UnityLinkError) -> None:
        """Do nothing: no call waits."""


class BlockSource:
    """A source of several requests that are sent in order and answered one by one."""

    posted = False

    def __init__(self, requests: list[Request]) -> None:
        self._requests = deque(requests)

    @property
    def size(self) -> int:
        """Characters of the next request."""
        return self._requests[0].size

    def least(self) -> int:
        """Return one."""
        return 1

    def take(self, room: int) -> Message:  # noqa: ARG002
        """Return the next request."""
        return self._requests.popleft()

    def exhausted(self) -> bool:
        """Return whether all have been taken."""
        return not self._requests

    def unwanted(self) -> bool:
        """Return whether the next request was cancelled, and with it all behind it."""
        return self._requests[0].future.cancelled()

    def fail(self, error: UnityLinkError) -> None:
        """End the requests that have not been sent."""
        for request in self._requests:
            request.fail(error)


def common_outcome(requests: Iterable[Request]) -> Outcome:
    """Return what is known of requests that were asked for together: `Outcome.UNKNOWN` where they fared differently."""
    outcomes = {_outcome(request.future) for request in requests}
    return outcomes.pop() if len(outcomes) == 1 else Outcome.UNKNOWN


def _outcome(future: asyncio.Future[Any]) -> Outcome:
    if not future.done() or future.cancelled():
        return Outcome.UNKNOWN
    error = future.exception()
    return error.outcome if isinstance(error, UnansweredError) else Outcome.EXECUTED


class Batch:
    """Many requests of one command: their answers and the future of all.

    Args:
        codec: the messages of the gateway.
        command: ``R`` or ``W``.
        fields: hex digits of each request's fields, shape (n, width).
        loop: the loop of the future.
    """

    def __init__(self, codec: Codec, command: str, fields: NDArray[np.uint8], loop: asyncio.AbstractEventLoop) -> None:
        self.codec = codec
        self.command = command
        self.fields = fields
        self.future: asyncio.Future[Words] = loop.create_future()
        self.reply_digits = codec.info.data_digits if command == "R" else 0
        self.sent = False
        """Whether any of the requests was sent."""
        self._answers = np.zeros(len(fields), codec.word_type)
        self._unanswered = len(fields)
        self._error: tuple[int, GatewayError] | None = None
        """The first request that the gateway refused, and how."""

    def put(self, offset: int, words: Words) -> None:
        """Take answers."""
        self._answers[offset : offset + len(words)] = words
        self._count(len(words))

    def refuse(self, offset: int, error: GatewayError) -> None:
        """Take the refusal of one request; the others are done all the same."""
        if self._error is None or offset < self._error[0]:
            self._error = offset, error
        self._count(1)

    def _count(self, answered: int) -> None:
        self._unanswered -= answered
        if self._unanswered or self.future.done():
            return
        if self._error is None:
            self.future.set_result(self._answers)
        else:
            self.future.set_exception(self._error[1])

    def fail(self, error: UnityLinkError) -> None:
        """Raise `error`, which is about a part of the batch, in the waiting call."""
        if self.future.done():
            return
        if isinstance(error, UnansweredError) and self.sent and len(self.fields) > 1:
            error = error.about(Outcome.UNKNOWN)
        self.future.set_exception(error)


class BatchSource:
    """The requests of a batch from `start` to before `end`, as a source of runs."""

    posted = False

    def __init__(self, batch: Batch, start: int, end: int) -> None:
        self._batch = batch
        self._start = start
        self._end = end
        self.size = batch.codec.framing.overhead + len(batch.command) + batch.codec.info.id_digits
        self.size += batch.fields.shape[1]

    def least(self) -> int:
        """Return a number that is worth a turn."""
        return min(SMALLEST_BATCH, self._end - self._start)

    def take(self, room: int) -> Message:
        """Return the next run of at most `room` requests."""
        count = min(room, self._end - self._start)
        run = BatchRun(self._batch, self._start, count)
        self._start += count
        return run

    def exhausted(self) -> bool:
        """Return whether all have been taken."""
        return self._start == self._end

    def unwanted(self) -> bool:
        """Return whether the batch is not awaited any more, or has failed."""
        return self._batch.future.done()

    def fail(self, error: UnityLinkError) -> None:
        """Raise `error` in the waiting call."""
        self._batch.fail(error)


class BatchRun(Rows):
    """The part of a batch that was sent in one turn."""

    __slots__ = ("_batch", "_frames", "_offset")

    def __init__(self, batch: Batch, offset: int, count: int) -> None:
        super().__init__(batch.codec, batch.command, batch.fields.shape[1], batch.reply_digits, count)
        batch.sent = True
        self._batch = batch
        self._offset = offset
        self._frames = b""

    def encode(self, offset: int, count: int) -> bytes:
        """Return the frames of `count` requests from `offset` on."""
        if not self._frames:
            fields = self._batch.fields[self._offset : self._offset + self.count]
            self._frames = self.codec.request_rows(self.command, self.first, fields)
        return self._frames[offset * self.size : (offset + count) * self.size]

    def accept(self, offset: int, body: bytes, position: int) -> bool:
        """Take the response to one request."""
        command = self.command.lower().encode()
        if not body.startswith(command) or len(body) + self.codec.framing.overhead != self.reply_size:
            return False
        try:
            word = int(body[position:] or b"0", 16)
        except ValueError:
            return False
        self._batch.put(self._offset + offset, np.array([word], self.codec.word_type))
        return True

    def accept_rows(self, offset: int, frames: bytes) -> int:
        """Take the responses to requests from `offset` on; return how many of the frames were such responses."""
        number = self.first + offset & self.codec.ring - 1
        words = self.codec.response_rows(self.command, number, frames, self._batch.reply_digits)
        if words is None:
            return 0
        self._batch.put(self._offset + offset, words)
        return len(words)

    def fail_part(self, offset: int, count: int, error: UnityLinkError) -> None:
        """Keep the refusal of a request until the others are done; whatever else it is, it ends the batch."""
        if isinstance(error, GatewayError):
            self._batch.refuse(self._offset + offset, error)
        else:
            super().fail_part(offset, count, error)

    def fields_at(self, offset: int) -> bytes:
        """Return the fields of one request."""
        fields: bytes = self._batch.fields[self._offset + offset].tobytes()
        return fields

    def unwanted(self) -> bool:
        """Return whether the batch is not awaited any more."""
        return self.given_up or self._batch.future.done()

    def fail(self, error: UnityLinkError) -> None:
        """Raise `error` in the call that waits for the batch."""
        self._batch.fail(error)

    def again(self, offset: int, count: int) -> Source | None:
        """Return the part of a batch of reads that is to be sent again."""
        if self.command not in REPEATABLE:
            return None
        return BatchSource(self._batch, self._offset + offset, self._offset + offset + count)


class PostedBatch:
    """Many stateless writes: a source of runs that no call waits for once they are sent.

    Args:
        codec: the messages of the gateway.
        addresses: of the words.
        values: the words; as many.
        loop: the loop of the future, which ends when all have been sent.
        report: takes the errors of those that were sent.
    """

    posted = True

    def __init__(
        self,
        codec: Codec,
        addresses: Words,
        values: Words,
        loop: asyncio.AbstractEventLoop,
        report: Callable[[UnityLinkError, int], None],
    ) -> None:
        self.codec = codec
        self.report = report
        self.future: asyncio.Future[None] = loop.create_future()
        self.size = codec.head_sizes["WS"] + codec.info.address_digits + codec.info.data_digits
        self._addresses, self._values = addresses, values
        self._start = 0

    def least(self) -> int:
        """Return a number that is worth a turn."""
        return min(SMALLEST_BATCH, len(self._values) - self._start)

    def take(self, room: int) -> Message:
        """Return the next run: part of the window, so that a fence can confirm it while the next part is sent."""
        start, info = self._start, self.codec.info
        end = self._start = start + min(room, self.codec.ring // _POSTED_RUNS, len(self._values) - start)
        if self.exhausted() and not self.future.done():
            self.future.set_result(None)
        # Only now, while those before them are on the line.
        where = hex_rows(self._addresses[start:end], info.address_digits)
        what = hex_rows(self._values[start:end], info.data_digits)
        return PostedRun(self.codec, np.concatenate((where, what), axis=1), self.report)

    def exhausted(self) -> bool:
        """Return whether all has been taken."""
        return self._start == len(self._values)

    def unwanted(self) -> bool:
        """Return whether the waiting call was cancelled: what was not sent by then never is."""
        return self.future.cancelled()

    def fail(self, error: UnityLinkError) -> None:
        """Raise `error` in the call that waits for the rest to be sent."""
        if self.future.done():
            return
        if isinstance(error, UnansweredError) and self._start:
            error = error.about(Outcome.UNKNOWN)
        self.future.set_exception(error)


class PostedRun(Message):
    """The part of a `PostedBatch` that was sent in one turn."""

    __slots__ = ("_fields", "_frames", "_report")

    def __init__(self, codec: Codec, fields: NDArray[np.uint8], report: Callable[[UnityLinkError, int], None]) -> None:
        super().__init__(codec, "WS", fields.shape[1], None, len(fields))
        self._fields = fields
        self._report = report
        self._frames = b""

    def encode(self, offset: int, count: int) -> bytes:
        """Return the frames of `count` requests from `offset` on."""
        if not self._frames:
            self._frames = self.codec.request_rows(self.command, self.first, self._fields)
        return self._frames[offset * self.size : (offset + count) * self.size]

    def accept(self, offset: int, body: bytes, position: int) -> bool:  # noqa: ARG002
        """Take nothing: a stateless write has no response."""
        return False

    def fail(self, error: UnityLinkError) -> None:
        """Keep the error for the next fence."""
        self._report(error, 1)

    def fail_part(self, offset: int, count: int, error: UnityLinkError) -> None:  # noqa: ARG002
        """Keep the error of so many requests for the next fence."""
        self._report(error, count)

    def fields_at(self, offset: int) -> bytes:
        """Return the fields of one request."""
        fields: bytes = self._fields[offset].tobytes()
        return fields

    def again(self, offset: int, count: int) -> Source | None:  # noqa: ARG002
        """Return nothing: it could be executed twice."""
        return None

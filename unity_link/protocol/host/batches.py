"""Batches: many requests of one call, as a source of single requests, or of runs that numpy encodes and decodes."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Any

from unity_link.errors import (
    GatewayError,
    Outcome,
    UnansweredError,
    UnityLinkError,
)
from unity_link.protocol import wire
from unity_link.protocol.host.events import Awaited, PostedFailure
from unity_link.protocol.host.requests import REPEATABLE, Message, Request, Source

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    import numpy as np
    from numpy.typing import NDArray

    from unity_link.protocol.host.events import Events
    from unity_link.protocol.host.host_codec import HostCodec
    from unity_link.protocol.wire.arrays import Words

SMALLEST_BATCH = 512
"""Messages for which a batch waits for room while requests are in flight, or half of a smaller window. numpy takes
about as long for few messages as for many, and the rest of the window keeps the line busy."""
_POSTED_RUNS = 8
"""A run of posted writes takes at most the sequence space divided by this: a quarter of the window, after which a fence
is due."""


class RequestBlock:
    """A source of several requests that are sent in order and answered one by one."""

    posted = False
    least = 1

    def __init__(self, requests: list[Request]) -> None:
        self._requests = deque(requests)

    @property
    def places(self) -> int:
        """Words that the gateway stores for the next request, if it is a destructive read; otherwise 0."""
        return self._requests[0].places

    @property
    def of_session(self) -> bool:
        """True if any of the requests ends with the session in which they were submitted."""
        return any(request.of_session for request in self._requests)

    @property
    def size(self) -> int:
        """Characters of the next request."""
        return self._requests[0].size

    @property
    def reply_size(self) -> int:
        """Characters of the answer to the next request."""
        return self._requests[0].reply_size

    @property
    def outlives_session(self) -> bool:
        """True if the next session may send all the remaining requests."""
        return all(request.outlives_session for request in self._requests)

    def take(self, room: int, events: Events) -> Message:
        """Return the next request."""
        return self._requests.popleft().take(room, events)

    def exhausted(self) -> bool:
        """Return whether all requests have been taken."""
        return not self._requests

    def unwanted(self) -> bool:
        """Return whether the next request was cancelled, and all later ones with it."""
        return self._requests[0].given_up

    def fail(self, error: UnityLinkError, events: Events) -> None:
        """End the requests that have not been sent."""
        for request in self._requests:
            request.fail(error, events)


def common_outcome(requests: Iterable[Request]) -> Outcome:
    """Return the outcome of the requests of one call: `Outcome.UNKNOWN` if their outcomes differ."""
    outcomes = {_outcome(request) for request in requests}
    return outcomes.pop() if len(outcomes) == 1 else Outcome.UNKNOWN


def _outcome(request: Request) -> Outcome:
    if not request.done:
        return Outcome.UNKNOWN
    return request.error.outcome if isinstance(request.error, UnansweredError) else Outcome.EXECUTED


class WordBatch(Awaited):
    """Many messages of one command for single words, and their outcomes; a source of runs.

    `smallest_turn` is the number of messages for which the batch waits for room while requests are in flight.

    Args:
        codec: message codec of the gateway.
        command: ``R``, ``W`` or ``WS``.
        columns: for each field, its numbers in all messages, shape (n,), and their hex digits.
    """

    smallest_turn = SMALLEST_BATCH
    places = 0
    of_session = False
    """True if the remaining messages end with the session in which the batch was submitted."""

    def __init__(self, codec: HostCodec, command: str, columns: Sequence[tuple[NDArray[Any], int]]) -> None:
        self.codec = codec
        self.command = command
        self.posted = command == "WS"
        self.count = len(columns[0][0])
        self.size = codec.head_sizes[command] + sum(digits for _, digits in columns)
        self.reply_digits = None if self.posted else codec.info.data_digits if command == "R" else 0
        self.reply_size = 0 if self.reply_digits is None else codec.head_sizes[command] + self.reply_digits
        self.sent = 0
        """Number of messages that the session has taken."""
        self.done = False
        """True if `answer` or `error` is complete; for posted writes, if all are sent."""
        self.answer: Words = wire.arrays.zeros(0 if self.posted else self.count, codec.info.data_digits)
        self.error: UnityLinkError | None = None
        self.waiter: Any = None
        self.poster: object = None
        """Task or thread that has posted it."""
        self.given_up = False
        """True if the batch was cancelled."""
        self._fields = wire.arrays.hex_columns(columns)
        self._unanswered = self.count
        self._refusal: tuple[int, GatewayError] | None = None
        """Position and error of the first message that the gateway refused."""

    # The methods of a source

    @property
    def least(self) -> int:
        """Fewest messages for which the batch waits for room, while other requests are in flight."""
        return min(self.smallest_turn, self.count - self.sent)

    @property
    def outlives_session(self) -> bool:
        """True if the next session may send the remaining messages."""
        return self.command in REPEATABLE

    def take(self, room: int, events: Events) -> Message:
        """Return the next run. A run of posted writes is short, so that its fence is in flight with the next run."""
        most = self.codec.id_count // _POSTED_RUNS if self.posted else room
        run = self.run(self.sent, min(room, most, self.count - self.sent))
        self.sent += run.count
        if self.posted and self.exhausted():
            self._end(events)
        return run

    def run(self, start: int, count: int) -> BatchRun:
        """Return `count` messages from `start` on as a run."""
        return BatchRun(self, start, count)

    def exhausted(self) -> bool:
        """Return whether all messages have been taken."""
        return self.sent == self.count

    def unwanted(self) -> bool:
        """Return whether the batch was cancelled, or has failed."""
        return self.given_up or self.error is not None

    def cancel(self) -> None:
        """Cancel the batch: its remaining messages are not sent."""
        self.given_up = not self.done

    def fail(self, error: UnityLinkError, events: Events) -> None:
        """End the batch with an error; if other messages were sent before, the outcome of the whole is unknown."""
        if isinstance(error, UnansweredError) and self.sent and self.count > 1:
            error = error.about(Outcome.UNKNOWN)
        self._end(events, error)

    def _end(self, events: Events, error: UnityLinkError | None = None) -> None:
        if not self.done:
            self.done, self.error = True, error
            events.append(self)

    # Called by the runs

    def fields(self, start: int, count: int) -> NDArray[np.uint8]:
        """Return the hex digits of the fields of `count` messages from `start` on, shape (count, width)."""
        return self._fields[start : start + count]

    def put(self, offset: int, count: int, words: Words | int, events: Events) -> None:
        """Record the words of `count` answers from `offset` on; 0 for acknowledgements."""
        self.answer[offset : offset + count] = words
        self._answered(count, events)

    def take_refusal(self, offset: int, error: GatewayError, events: Events) -> None:
        """Record that the gateway refused one message; the other messages are executed nevertheless."""
        if self._refusal is None or offset < self._refusal[0]:
            self._refusal = offset, error
        self._answered(1, events)

    def _answered(self, count: int, events: Events) -> None:
        self._unanswered -= count
        if not self._unanswered:
            self._end(events, None if self._refusal is None else self._refusal[1])


class BatchRun(Message):
    """Consecutive messages of a batch, which are sent together; numpy decodes their answers together.

    Args:
        batch: the batch.
        start: position of the first message in the batch.
        count: number of messages.
    """

    __slots__ = ("_batch", "_start")

    def __init__(self, batch: WordBatch, start: int, count: int) -> None:
        codec = batch.codec
        width = batch.size - codec.head_sizes[batch.command]
        super().__init__(codec, batch.command, width, batch.reply_digits, count)
        self._batch = batch
        self._start = start

    def encode(self) -> bytes:
        """Return the frames, with the IDs that the window has assigned."""
        fields = self._batch.fields(self._start, self.count)
        self.frames = wire.arrays.request_rows(self.codec, self.command, self.first, fields, self.codec.seed)
        return self.frames

    def take_frame(self, offset: int, frame: bytes, events: Events) -> bool:
        """Take the frame of the response to one message if it is exactly the expected one; return whether it is."""
        codec = self.codec
        opening = codec.openings[self.command] + codec.id_text[self.first + offset & codec.id_count - 1]
        data = self.data_of(frame, opening)
        return data is not None and self._take(self._start + offset, data, events)

    def accept(self, offset: int, body: bytes, position: int, events: Events) -> bool:
        """Take the body of the response to one message; return whether it is a valid one."""
        command = self.codec.lower[self.command]
        if not body.startswith(command) or len(body) + self.codec.framing.overhead != self.reply_size:
            return False
        return self._take(self._start + offset, body[position:], events)

    def _take(self, place: int, data: bytes, events: Events) -> bool:
        """Take the data of the response to one message, given its position in the batch; return if they are valid."""
        try:
            word = int(data or b"0", 16)
        except ValueError:
            return False
        self._batch.put(place, 1, word, events)
        return True

    def accept_rows(self, offset: int, frames: bytes, events: Events) -> int:
        """Take the frames of the responses to messages from `offset` on; return how many were exactly as expected."""
        number = self.first + offset & self.codec.id_count - 1
        codec, digits = self.codec, self._batch.reply_digits or 0
        words = wire.arrays.response_rows(codec, self.command, number, frames, digits, codec.seed_back)
        if words is None:
            return 0
        self._batch.put(self._start + offset, len(words), words, events)
        return len(words)

    def fail_part(self, offset: int, count: int, error: UnityLinkError, events: Events) -> None:
        """Record an error of `count` messages from `offset` on.

        The refusal of a message is kept until the other messages are done; any other error ends the batch.
        """
        if self.posted:
            events.append(PostedFailure(error, count, self._batch.poster))
        elif isinstance(error, GatewayError):
            self._batch.take_refusal(self._start + offset, error, events)
        else:
            self._batch.fail(error, events)

    def fields_at(self, offset: int) -> bytes:
        """Return the hex digits of the fields of one message."""
        return self._batch.fields(self._start + offset, 1).tobytes()

    def unwanted(self) -> bool:
        """Return whether the batch was cancelled or has failed; posted writes stay wanted."""
        return self.given_up or (not self.posted and self._batch.unwanted())

    def again(self, offset: int, count: int) -> Source | None:
        """Return a source of `count` reads from `offset` on for the next session; None for writes."""
        return BatchPart(self._batch, self._start + offset, count) if self.command in REPEATABLE else None


class BatchPart:
    """Reads of a batch that the next session sends again; a source of runs.

    Args:
        batch: the batch.
        start: position of the first read in the batch.
        count: number of reads.
    """

    posted = False
    places = 0
    of_session = False
    outlives_session = True

    def __init__(self, batch: WordBatch, start: int, count: int) -> None:
        self._batch, self._start, self._count = batch, start, count
        self.size, self.reply_size = batch.size, batch.reply_size

    @property
    def least(self) -> int:
        """Fewest reads for which the source waits for room, while other requests are in flight."""
        return min(self._batch.smallest_turn, self._count)

    def take(self, room: int, events: Events) -> Message:  # noqa: ARG002  (only posted writes have an event here)
        """Return the next run."""
        run = self._batch.run(self._start, min(room, self._count))
        self._start += run.count
        self._count -= run.count
        return run

    def exhausted(self) -> bool:
        """Return whether all reads have been taken."""
        return not self._count

    def unwanted(self) -> bool:
        """Return whether the batch was cancelled, or has failed."""
        return self._batch.unwanted()

    def fail(self, error: UnityLinkError, events: Events) -> None:
        """End the remaining reads with an error."""
        self._batch.run(self._start, self._count).fail_part(0, self._count, error, events)

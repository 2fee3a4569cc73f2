"""Batches: many requests by one call, as a source of single requests or of runs that numpy encodes and decodes."""

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
"""Messages of a batch for which room is waited for while others are under way, or for half of a smaller window: numpy
takes about as long for few as for many, and what is left of the window is enough for the line."""
_POSTED_RUNS = 8
"""One run of posted writes takes this part of the ring: a quarter of the window, behind which a fence is due."""


class RequestBlock:
    """A source of several requests that are sent in order and answered one by one."""

    posted = False
    least = 1

    def __init__(self, requests: list[Request]) -> None:
        self._requests = deque(requests)

    @property
    def places(self) -> int:
        """Words of the next request that the gateway keeps."""
        return self._requests[0].places

    @property
    def of_session(self) -> bool:
        """Return whether no other session may send one of them than the one in which they were asked for."""
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
        """Return whether the next session may send all that are left."""
        return all(request.outlives_session for request in self._requests)

    def take(self, room: int, events: Events) -> Message:
        """Return the next request."""
        return self._requests.popleft().take(room, events)

    def exhausted(self) -> bool:
        """Return whether all have been taken."""
        return not self._requests

    def unwanted(self) -> bool:
        """Return whether the next request was given up, and with it all behind it."""
        return self._requests[0].given_up

    def fail(self, error: UnityLinkError, events: Events) -> None:
        """End the requests that have not been sent."""
        for request in self._requests:
            request.fail(error, events)


def common_outcome(requests: Iterable[Request]) -> Outcome:
    """Return what is known of requests that were asked for together: `Outcome.UNKNOWN` where they fared differently."""
    outcomes = {_outcome(request) for request in requests}
    return outcomes.pop() if len(outcomes) == 1 else Outcome.UNKNOWN


def _outcome(request: Request) -> Outcome:
    if not request.done:
        return Outcome.UNKNOWN
    return request.error.outcome if isinstance(request.error, UnansweredError) else Outcome.EXECUTED


class WordBatch(Awaited):
    """Many messages of one command for single words, and what became of them: a source of runs.

    `smallest_turn` is the number of messages for which room is waited for while others are under way.

    Args:
        codec: the messages of the gateway.
        command: ``R``, ``W`` or ``WS``.
        columns: the numbers that stand in the fields, each of shape (n,), and how many hex digits each has.
    """

    smallest_turn = SMALLEST_BATCH
    places = 0
    of_session = False
    """True if no other session may send what is left than the one in which it was asked for."""

    def __init__(self, codec: HostCodec, command: str, columns: Sequence[tuple[NDArray[Any], int]]) -> None:
        self.codec = codec
        self.command = command
        self.posted = command == "WS"
        self.count = len(columns[0][0])
        self.size = codec.head_sizes[command] + sum(digits for _, digits in columns)
        self.reply_digits = None if self.posted else codec.info.data_digits if command == "R" else 0
        self.reply_size = 0 if self.reply_digits is None else codec.head_sizes[command] + self.reply_digits
        self.sent = 0
        """Number of messages that were given an ID; a new session may send some of them again."""
        self.done = False
        """True if `answer` or `error` is known; of posted writes, whether all were sent."""
        self.answer: Words = wire.arrays.zeros(0 if self.posted else self.count, codec.info.data_digits)
        self.error: UnityLinkError | None = None
        self.waiter: Any = None
        self.poster: object = None
        """Task or thread that has posted it."""
        self.given_up = False
        """True if no call waits for it any more."""
        self._fields = wire.arrays.hex_columns(columns)
        self._unanswered = self.count
        self._refusal: tuple[int, GatewayError] | None = None
        """The first message that the gateway refused, and how."""

    # A source

    @property
    def least(self) -> int:
        """A number that is worth a turn."""
        return min(self.smallest_turn, self.count - self.sent)

    @property
    def outlives_session(self) -> bool:
        """Return whether the next session may send them."""
        return self.command in REPEATABLE

    def take(self, room: int, events: Events) -> Message:
        """Return the next run; of posted writes a part of the window, so that a fence confirms it beside the next."""
        most = self.codec.id_count // _POSTED_RUNS if self.posted else room
        run = self.run(self.sent, min(room, most, self.count - self.sent))
        self.sent += run.count
        if self.posted and self.exhausted():
            self._end(events)
        return run

    def run(self, start: int, count: int) -> BatchRun:
        """Return some of the messages."""
        return BatchRun(self, start, count)

    def exhausted(self) -> bool:
        """Return whether all have been taken."""
        return self.sent == self.count

    def unwanted(self) -> bool:
        """Return whether no call waits for it any more, or it has failed."""
        return self.given_up or self.error is not None

    def cancel(self) -> None:
        """Record that no call waits for it any more: what was not sent never is."""
        self.given_up = not self.done

    def fail(self, error: UnityLinkError, events: Events) -> None:
        """End it with an error that is about a part of it."""
        if isinstance(error, UnansweredError) and self.sent and self.count > 1:
            error = error.about(Outcome.UNKNOWN)
        self._end(events, error)

    def _end(self, events: Events, error: UnityLinkError | None = None) -> None:
        if not self.done:
            self.done, self.error = True, error
            events.append(self)

    # The answers, told by the runs

    def fields(self, start: int, count: int) -> NDArray[np.uint8]:
        """Return the hex digits of the fields of some messages, shape (count, width)."""
        return self._fields[start : start + count]

    def put(self, offset: int, count: int, words: Words | int, events: Events) -> None:
        """Take the words of so many answers, in order; zeros for acknowledgements."""
        self.answer[offset : offset + count] = words
        self._answered(count, events)

    def take_refusal(self, offset: int, error: GatewayError, events: Events) -> None:
        """Take the refusal of one message; the others are done all the same."""
        if self._refusal is None or offset < self._refusal[0]:
            self._refusal = offset, error
        self._answered(1, events)

    def _answered(self, count: int, events: Events) -> None:
        self._unanswered -= count
        if not self._unanswered:
            self._end(events, None if self._refusal is None else self._refusal[1])


class BatchRun(Message):
    """The messages of a batch that are sent in one turn, and whose answers are taken many at a time.

    Args:
        batch: the whole.
        start: the first of its messages that is in the run.
        count: how many are.
    """

    __slots__ = ("_batch", "_start")

    def __init__(self, batch: WordBatch, start: int, count: int) -> None:
        codec = batch.codec
        width = batch.size - codec.head_sizes[batch.command]
        super().__init__(codec, batch.command, width, batch.reply_digits, count)
        self._batch = batch
        self._start = start

    def encode(self) -> bytes:
        """Return the frames, under the IDs that the window has given."""
        fields = self._batch.fields(self._start, self.count)
        self.frames = wire.arrays.request_rows(self.codec, self.command, self.first, fields, self.codec.seed)
        return self.frames

    def take_frame(self, offset: int, frame: bytes, events: Events) -> bool:
        """Take the frame of the response to one message; False where it is anything else, or not as it usually is."""
        codec = self.codec
        opening = codec.openings[self.command] + codec.id_text[self.first + offset & codec.id_count - 1]
        data = self.data_of(frame, opening)
        return data is not None and self._take(self._start + offset, data, events)

    def accept(self, offset: int, body: bytes, position: int, events: Events) -> bool:
        """Take the response to one message."""
        command = self.codec.lower[self.command]
        if not body.startswith(command) or len(body) + self.codec.framing.overhead != self.reply_size:
            return False
        return self._take(self._start + offset, body[position:], events)

    def _take(self, place: int, data: bytes, events: Events) -> bool:
        """Take the data of the response to the message at a place of the batch; False where they are none."""
        try:
            word = int(data or b"0", 16)
        except ValueError:
            return False
        self._batch.put(place, 1, word, events)
        return True

    def accept_rows(self, offset: int, frames: bytes, events: Events) -> int:
        """Take the responses to messages from `offset` on; return how many of the frames were such responses."""
        number = self.first + offset & self.codec.id_count - 1
        codec, digits = self.codec, self._batch.reply_digits or 0
        words = wire.arrays.response_rows(codec, self.command, number, frames, digits, codec.seed_back)
        if words is None:
            return 0
        self._batch.put(self._start + offset, len(words), words, events)
        return len(words)

    def fail_part(self, offset: int, count: int, error: UnityLinkError, events: Events) -> None:
        """Keep the refusal of a message until the others are done; whatever else it is, it ends the batch."""
        if self.posted:
            events.append(PostedFailure(error, count, self._batch.poster))
        elif isinstance(error, GatewayError):
            self._batch.take_refusal(self._start + offset, error, events)
        else:
            self._batch.fail(error, events)

    def fields_at(self, offset: int) -> bytes:
        """Return the fields of one message."""
        return self._batch.fields(self._start + offset, 1).tobytes()

    def unwanted(self) -> bool:
        """Return whether the batch is not awaited any more; what was posted always is."""
        return self.given_up or (not self.posted and self._batch.unwanted())

    def again(self, offset: int, count: int) -> Source | None:
        """Return the part of a batch of reads that is to be sent again."""
        return BatchPart(self._batch, self._start + offset, count) if self.command in REPEATABLE else None


class BatchPart:
    """Messages of a batch that a new session sends again: a source of runs.

    Args:
        batch: the whole.
        start: the first of its messages that is meant.
        count: how many are.
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
        """A number that is worth a turn."""
        return min(self._batch.smallest_turn, self._count)

    def take(self, room: int, events: Events) -> Message:  # noqa: ARG002  (what is repeated is not posted)
        """Return the next run."""
        run = self._batch.run(self._start, min(room, self._count))
        self._start += run.count
        self._count -= run.count
        return run

    def exhausted(self) -> bool:
        """Return whether all have been taken."""
        return not self._count

    def unwanted(self) -> bool:
        """Return whether the batch is not awaited any more."""
        return self._batch.unwanted()

    def fail(self, error: UnityLinkError, events: Events) -> None:
        """End them with an error."""
        self._batch.run(self._start, self._count).fail_part(0, self._count, error, events)

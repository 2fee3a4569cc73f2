"""The requests and responses between two `K`: what is asked for goes into the window, responses find their requests.

What must wait for room in the window waits in one line; a source with more to send goes to the end of the line after
its turn, so that a batch of thousands does not hold up the others. Samples that arrive among the responses are told to
belong to whatever their group is for at that point of the stream.

Two ways lead through `Exchange.receive`. A line is looked at by itself; and where the answers to a batch, or samples of
one group, stand side by side, numpy takes as many as are exactly what is expected. What it leaves, the slow way takes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from unity_link.errors import UnansweredError, UnsupportedError
from unity_link.protocol.configuration import Feature
from unity_link.protocol.constants import KEEP_ALIVE
from unity_link.protocol.frames import LF, FrameError, OtherNodeError
from unity_link.protocol.messages import ErrorCode
from unity_link.protocol.requests import BatchRun, Fence, Request, gateway_error

if TYPE_CHECKING:
    from collections import deque

    from numpy.typing import NDArray

    from unity_link.protocol.group_table import GroupTable
    from unity_link.protocol.messages import Codec
    from unity_link.protocol.requests import Events, Message, Source
    from unity_link.protocol.window import Window

FEWEST_ROWS = 8
"""Answers of a batch that are worth a turn of numpy."""
FEWEST_BYTES = 64
"""Fewer bytes than so many answers have."""
FEWEST_SAMPLES = 12
"""Samples of one group, side by side, that are worth a turn of numpy."""


class Sampled(NamedTuple):
    """Event: a sample has come."""

    owner: Any
    """What was named when the group was set up."""
    body: bytes
    arrived: float
    """On the clock of the session."""


class SampledRows(NamedTuple):
    """Event: samples of one group have come, side by side."""

    owner: Any
    bodies: NDArray[np.uint8]
    """Shape (n, length)."""
    arrived: float


class Counters:
    """What has happened since the link was opened."""

    __slots__ = ("damaged", "errors", "repetitions", "requests", "responses", "stray", "timeouts")

    def __init__(self) -> None:
        self.requests = self.responses = self.repetitions = self.timeouts = 0
        self.damaged = self.stray = self.errors = 0


class Exchange:
    """What passes in one session, from the answer to `K` on.

    Args:
        codec: the messages of the gateway.
        window: over the IDs of the session.
        waiting: what was asked for and has no ID yet, the oldest first.
        groups: the groups of the gateway.
        counters: of the link.
        out: takes the bytes to send.
        blocked: whether the medium takes no bytes at this time.
    """

    def __init__(
        self,
        codec: Codec,
        window: Window[Message],
        waiting: deque[Source],
        groups: GroupTable,
        counters: Counters,
        out: list[bytes],
        *,
        blocked: bool,
    ) -> None:
        self.codec = codec
        self.window = window
        self.blocked = blocked
        """Whether the medium takes no bytes: what was sent is still held back, so a repetition would be behind it."""
        self.refused: int | None = None
        """The ID of a request that the gateway did not take for it is in no session: it was reset."""
        self._waiting = waiting
        self._groups = groups
        self._counters = counters
        self._send = out.append
        self._id_number = codec.id_number
        self._id_digits = codec.info.id_digits
        self._open = codec.framing.open
        self._sample = codec.framing.prefix + b"P"
        """What samples begin with, which say nothing about requests."""
        # An empty frame, so that damage to the end of the last one is found; where sides take turns, that one is alone.
        self._repetition_end = b"" if Feature.HALF_DUPLEX in codec.info.features else LF
        self._batching = False
        """Whether answers to many requests may be under way."""

    # Requests

    def submit(self, source: Source, now: float, events: Events) -> None:
        """Send what `source` has as soon as there is room."""
        window = self.window
        if (
            not self._waiting
            and isinstance(source, Request)
            and (window.oldest == window.next or window.room(source.size, posted=source.posted))
        ):
            source.sent = True
            self._number(source, now)
            if source.posted:
                self._fence(now)
            return
        if isinstance(source, Fence):
            source.follow(self._waiting)
        self._waiting.append(source)
        self.admit(now, events)

    def _number(self, run: Message, now: float) -> None:
        """Assign IDs to a run, and send it."""
        self._counters.requests += run.count
        self.window.send(run, now)
        if run.count > 1:
            self._batching = True
        self._send(run.encode(0, run.count))

    def admit(self, now: float, events: Events) -> None:
        """Let sources into the window, in turn, as far as there is room."""
        waiting, window = self._waiting, self.window
        while waiting:
            source = waiting[0]
            if source.unwanted():
                waiting.popleft()
                continue
            if isinstance(source, Fence) and any(other in waiting for other in source.earlier):
                waiting.rotate(-1)
                continue
            room = window.room(source.size, posted=source.posted)
            # A window that is small because the line loses is not waited for to grow.
            if not room or room < min(source.least(), max(1, window.most_room(source.size) // 2)):
                break
            waiting.popleft()
            run = source.take(room, events)
            if not source.exhausted():
                waiting.append(source)
            self._number(run, now)
            if run.posted:
                self._fence(now)
        self._fence(now)

    def _fence(self, now: float) -> None:
        """Confirm posted writes by an ``h`` where it is time."""
        if self.window.needs_fence(now):
            self._number(Request(self.codec, "H", b"", 0), now)

    def go_on(self, now: float, events: Events) -> None:
        """Send what answers have made room for, or shown to be lost."""
        if self.window.wants_repetition:
            self._repeat()
        if self._waiting or self.window.unfenced:
            self.admit(now, events)

    def _repeat(self) -> None:
        """Send unanswered requests again; an ``h`` in place of those that are not wanted any more."""
        if self.blocked:
            return
        codec, repeated = self.codec, False
        for number, run, offset, count in self.window.repetition():
            self._counters.repetitions += count
            if run.unwanted():
                ids = (number + index & codec.ring - 1 for index in range(count))
                frames = b"".join(codec.request("H", identifier, b"") for identifier in ids)
            else:
                frames = run.encode(offset, count)
            self._send(frames)
            repeated = True
        if repeated:
            self._send(self._repetition_end)

    # Responses

    def receive(self, data: bytes, now: float, events: Events) -> int:
        """Take the whole frames of a read, and return where the first begins that was not taken.

        All are taken but those behind one that tells of a reset.
        """
        start = 0
        window = self.window
        batched = self._batching and len(data) >= FEWEST_BYTES
        sampling = bool(self._groups.begun)
        while True:
            if batched and isinstance(window.find(window.oldest), BatchRun):
                # Looked for once for what can't be taken so, not at each line.
                before, start = start, self._receive_rows(data, start, now, events)
                batched = start != before
            if sampling:
                before, start = start, self._receive_samples(data, start, now, events)
                sampling = start != before
            end = data.find(b"\n", start)
            if end < 0:
                break
            if end != start:
                self._receive_line(data[start:end], now, events)
            else:
                # A server's sign that what was repeated is still under way.
                window.heard = True
            start = end + 1
            if start == len(data) or self.refused is not None:
                break
        if start != len(data) and not data.startswith(self._sample, start):
            # Perhaps the beginning of a long answer on a slow line.
            window.heard = True
        if window.oldest == window.next:
            self._batching = False
        return start

    def _receive_rows(self, data: bytes, start: int, now: float, events: Events) -> int:
        """Take the answers to a batch as long as they stand side by side; return where they end."""
        window = self.window
        while True:
            number = window.oldest
            run = window.find(number)
            if not isinstance(run, BatchRun) or run.posted:
                return start
            offset = number - run.first & self.codec.ring - 1
            rows = min(run.count - offset, (len(data) - start) // run.reply_size)
            if rows < FEWEST_ROWS:
                return start
            # Of those sent again, some may have been answered meanwhile.
            rows = window.unanswered_from(number, rows)
            taken = run.accept_rows(offset, data[start : start + rows * run.reply_size], events)
            if not taken:
                return start
            self._counters.responses += taken
            window.answered(number, taken, now)
            start += taken * run.reply_size

    def _receive_samples(self, data: bytes, start: int, now: float, events: Events) -> int:
        """Take the samples of a group as long as they stand side by side; return where they end."""
        framing = self.codec.framing
        head = data[start : start + len(framing.prefix) + 3]
        group = self._groups.begun.get(head[-2:])
        if group is None or head != self._sample + group.text:
            return start
        size = group.length + framing.overhead
        count = (len(data) - start) // size if size > framing.overhead else 0
        if count < FEWEST_SAMPLES:
            return start
        rows = np.frombuffer(data, np.uint8, count * size, start).reshape(count, size)
        bodies = framing.open_rows(rows, head)
        if len(bodies) < FEWEST_SAMPLES:
            return start
        events.append(SampledRows(group.owner, bodies, now))
        return start + len(bodies) * size

    def _receive_line(self, line: bytes, now: float, events: Events) -> None:
        try:
            body = self._open(line)
        except OtherNodeError:
            self._counters.stray += 1
            return
        except FrameError:
            self._counters.damaged += 1
            if not line.startswith(self._sample):
                self.window.heard = True
                self.window.answer_damaged(now)
            return
        if len(body) < 2:
            self._counters.stray += 1
        elif body[0] >= _LOWER_G:
            self._receive_answer(body, now, events)
        elif body[0] == _P:
            group = self._groups.begun.get(body[1:3])
            if group is not None:
                events.append(Sampled(group.owner, body, now))
        elif body[0] == _X:
            self._receive_error(body, now, events)

    def _receive_answer(self, body: bytes, now: float, events: Events) -> None:
        """Take a message with an ID."""
        window = self.window
        window.heard = True
        head = 1 if body[1] < _UPPER_G else 2
        after = head + self._id_digits
        number = self._id_number.get(body[head:after])
        if number is None:
            self._counters.stray += 1
            return
        if head == 1 and body[0] == _LOWER_N:
            window.out_of_sequence(number, now)
            return
        if head == 1 and body[0] == _LOWER_X and body[after:] == _NO_SESSION:
            self.refused = number
            return
        run = window.find(number)
        if run is None:
            self._counters.stray += 1
            return
        offset = number - run.first & self.codec.ring - 1
        if head == 1 and body[0] == _LOWER_X:
            self._counters.errors += 1
            run.fail_part(offset, 1, gateway_error(_number_of(body[after:]), run.describe(offset)), events)
        elif not run.accept(offset, body, after, events) and not (run.unwanted() and body[0] == _LOWER_H):
            self._counters.stray += 1
            return
        self._counters.responses += 1
        window.answered(number, 1, now)

    def _receive_error(self, body: bytes, now: float, events: Events) -> None:
        """Take an error without an ID."""
        self.window.heard = True
        code = _number_of(body[1:])
        if code in (ErrorCode.CRC, ErrorCode.TOO_LONG, ErrorCode.RECEIVE_OVERFLOW):
            self.window.damaged(now)
        elif code in (ErrorCode.UNKNOWN_COMMAND, ErrorCode.MALFORMED):
            run = self.window.refused(now)
            if run is not None:
                reason = f"{run.describe(self._place(run))}: the gateway refuses the request with error {code:02X}"
                self._give_up(run, UnsupportedError(reason), events)

    # Time

    @property
    def deadline(self) -> float | None:
        """When `expire` must be called; None while nothing is under way and no group is set up."""
        deadline = self.window.deadline
        return self._keep_alive_due if deadline is None else deadline

    @property
    def _keep_alive_due(self) -> float | None:
        """When the gateway is to be asked whether it still hears its host; None while that is of no concern.

        Samples say neither that it does nor that it was not reset since.
        """
        if self.window.oldest != self.window.next or not self._groups.begun:
            return None
        return self.window.idle_since + KEEP_ALIVE

    def expire(self, now: float, events: Events) -> None:
        """Let time pass: send again what was not answered in time, and confirm what was posted."""
        window = self.window
        before = self._counters.repetitions
        run = window.expire(now)
        if run is not None:
            reason = f"{run.describe(self._place(run))}: every try was damaged on the way"
            self._give_up(run, UnansweredError(reason), events)
        if window.lost:
            return
        if window.wants_repetition:
            self._repeat()
            self._counters.timeouts += self._counters.repetitions > before
        self._fence(now)
        keep_alive_due = self._keep_alive_due
        if keep_alive_due is not None and now >= keep_alive_due:
            self._number(Request(self.codec, "H", b"", 0), now)

    def _place(self, run: Message) -> int:
        """Return the place in its run of the oldest message that waits for an answer."""
        return self.window.oldest - run.first & self.codec.ring - 1

    def _give_up(self, run: Message, error: UnansweredError | UnsupportedError, events: Events) -> None:
        """End what waits for answers that will never come; it is sent as ``h`` from now on."""
        run.given_up = True
        place = self._place(run)
        run.fail_part(place, run.count - place, error, events)


_LOWER_G, _UPPER_G = ord("g"), ord("G")
_LOWER_H, _LOWER_N, _LOWER_X = b"hnx"
_P, _X = b"PX"
_NO_SESSION = b"%02X" % ErrorCode.NO_SESSION


def _number_of(text: bytes) -> int:
    try:
        return int(text, 16)
    except ValueError:
        return 0

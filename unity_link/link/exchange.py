"""Layer 2, the engine of a link: requests go into the window and onto the stream, responses find their requests.

There is no task, lock or queue in here. A call puts its request in, the stream calls `receive` with whole reads, and
one timer of the event loop serves all time outs. What must wait for room in the window waits in one line; a source with
more to send goes to the end of the line after its turn, so that a batch of thousands does not hold up the others.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from unity_link.errors import LinkLostError, Outcome, UnansweredError, UnityLinkError, UnsupportedError
from unity_link.link.requests import Fence, Message, Request, Rows, Source, Unawaited, gateway_error
from unity_link.protocol.frames import FrameError, OtherNodeError
from unity_link.protocol.window import Window

if TYPE_CHECKING:
    from unity_link.protocol.messages import Codec
    from unity_link.transport.stream import Stream

FEWEST_ROWS = 8
"""Answers of a batch that are worth a turn of numpy."""
FEWEST_BYTES = 64
"""Fewer bytes than so many answers have."""
FEWEST_PUBLISHES = 12
"""Publishes of one group, side by side, that are worth a turn of numpy."""
Publish = Callable[[bytes, float], None]
"""Takes the body of a publish and the time of its arrival on the loop's clock, in seconds."""


class PublishRows(NamedTuple):
    """The consumer of many publishes of a group at once, and how long each is."""

    size: int
    """Characters of a body."""
    take: Callable[[np.ndarray[Any, np.dtype[np.uint8]], float], int]
    """Takes bodies, shape (n, size), and the time of their arrival; gives how many of the first ones it took."""


class Counters:
    """What has happened since the link was opened."""

    __slots__ = ("damaged", "errors", "repetitions", "requests", "responses", "stray", "timeouts")

    def __init__(self) -> None:
        self.requests = self.responses = self.repetitions = self.timeouts = 0
        self.damaged = self.stray = self.errors = 0


class Exchange:
    """The requests and responses of one link.

    Args:
        on_lost: called once when the gateway does not answer any more or the stream has ended.
    """

    def __init__(self, on_lost: Callable[[str], None]) -> None:
        self.counters = Counters()
        self.publishes: dict[bytes, Publish] = {}
        """The consumer of the publishes of each group, by its two digits."""
        self.publish_rows: dict[bytes, PublishRows] = {}
        """Who of them can take many at once, by what the bodies begin with, ``P`` and the two digits."""
        self._on_lost = on_lost
        self._loop = asyncio.get_running_loop()
        self._now = self._loop.time
        self._waiting: deque[Source] = deque()
        self._timer: asyncio.TimerHandle | None = None
        self._timer_at = 0.0
        self._stream: Stream | None = None
        self._codec: Codec
        self._window: Window[Message] = Window(2)
        self._closed: LinkLostError | None = None
        self._batching = False
        """Whether answers to many requests may be under way."""

    # Sessions

    def start(self, stream: Stream, codec: Codec, window: Window[Message]) -> None:
        """Begin a session on a stream whose gateway expects ID 0 next."""
        self._stream = stream
        self._codec = codec
        self._window = window
        self._id_number = codec.id_number
        self._id_digits = codec.info.id_digits
        self._open = codec.framing.open
        self._sample = codec.framing.prefix + b"P"
        """What samples begin with, which say nothing about requests."""
        stream.receiver = self
        stream.on_writable = self._go_on
        self._admit()

    def suspend(self, reason: str) -> None:
        """End a session, keeping what is known not to be executed for the next one; all else raises."""
        self._stop()
        again = self._end_sent(LinkLostError(reason), keep=True)
        self._waiting.extendleft(reversed(again))
        for request in [source for source in self._waiting if isinstance(source, Request) and source.of_session]:
            # What sets a new session up waits for it, and no other begins before that has ended.
            self._waiting.remove(request)
            request.fail(LinkLostError(reason, Outcome.NOT_EXECUTED))
        earlier: list[Source] = []
        for source in self._waiting:
            if isinstance(source, Fence):
                source.earlier += earlier
            elif not source.exhausted():
                earlier.append(source)

    def end(self, error: LinkLostError) -> None:
        """End for good: every call that waits raises."""
        self._stop()
        self._closed = error
        self._end_sent(error, keep=False)
        while self._waiting:
            self._waiting.popleft().fail(error.about(Outcome.NOT_EXECUTED))

    def _stop(self) -> None:
        if self._stream is not None:
            self._stream.receiver = self._stream.on_writable = None
            self._stream = None
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _end_sent(self, error: LinkLostError, *, keep: bool) -> list[Source]:
        """End the requests that were sent; return what a new session can send again."""
        again = []
        for part in self._window.unanswered():
            source = part.run.again(part.offset, part.size) if keep and not part.run.unwanted() else None
            if source is not None:
                again.append(source)
            else:
                outcome = Outcome.EXECUTED if part.executed else Outcome.UNKNOWN
                part.run.fail_part(part.offset, part.size, error.about(outcome))
        self._window = Window(2)
        return again

    # Requests

    def submit(self, source: Source) -> None:
        """Send what `source` has as soon as there is room.

        Raises:
            LinkLostError: where the link has ended.
        """
        if self._closed is not None:
            raise self._closed.about(Outcome.NOT_EXECUTED)
        stream = self._stream
        window = self._window
        idle = window.oldest == window.next
        if (
            stream is not None
            and not self._waiting
            and isinstance(source, Request)
            and (idle or window.room(source.size, posted=source.posted))
        ):
            frame = self._number(source.take(1))
            if idle:
                stream.send(frame)
            else:
                stream.send_soon(frame)
            if source.posted:
                self._fence()
            return
        if isinstance(source, Fence):
            source.earlier = [other for other in self._waiting if not other.exhausted()]
        self._waiting.append(source)
        if stream is not None:
            self._admit()

    @property
    def suspended(self) -> bool:
        """Whether there is no session at this time."""
        return self._stream is None

    @property
    def ended(self) -> bool:
        """Whether there will be no session any more."""
        return self._closed is not None

    @property
    def in_flight(self) -> int:
        """Number of requests that were sent and not answered."""
        return self._window.in_flight

    @property
    def round_trip(self) -> float | None:
        """Smoothed round trip in seconds, None before the first answer."""
        return self._window.smoothed_round_trip

    def _number(self, run: Message) -> bytes:
        """Assign IDs to a run, and return the frames to send."""
        self.counters.requests += run.count
        self._window.send(run, self._now())
        if run.count > 1:
            self._batching = True
        if self._timer is None or run.posted:
            self._set_timer()
        return run.encode(0, run.count)

    def _admit(self) -> None:
        """Let sources into the window, in turn, as far as there is room."""
        waiting, window, stream = self._waiting, self._window, self._stream
        while waiting and stream is not None:
            source = waiting[0]
            if source.unwanted():
                waiting.popleft()
                continue
            if isinstance(source, Fence) and any(other in waiting for other in source.earlier):
                waiting.rotate(-1)
                continue
            room = window.room(source.size, posted=source.posted)
            least = source.least()
            # A window that is small because the line loses is not waited for to grow.
            if not room or not least or room < min(least, max(1, window.most_room(source.size) // 2)):
                break
            waiting.popleft()
            run = source.take(room)
            if not source.exhausted():
                waiting.append(source)
            stream.send_soon(self._number(run))
            if run.posted:
                self._fence()
        self._fence()

    def _fence(self) -> None:
        """Confirm posted writes by an ``h`` where it is time."""
        if self._stream is not None and self._window.needs_fence(self._now()):
            self._stream.send_soon(self._number(Unawaited(self._codec, "H", b"", 0, self._loop)))

    def _repeat(self) -> None:
        """Send unanswered requests again; an ``h`` in place of those that are not wanted any more."""
        if self._stream is None or self._stream.paused:
            # What was sent before is still held back: a copy of it would only be behind it.
            return
        codec = self._codec
        for number, run, offset, count in self._window.repetition():
            self.counters.repetitions += count
            if run.unwanted():
                ids = (number + index & codec.ring - 1 for index in range(count))
                frames = b"".join(codec.request("H", identifier, b"") for identifier in ids)
            else:
                frames = run.encode(offset, count)
            self._stream.send_soon(frames)

    # Responses

    def receive(self, data: bytes) -> int:
        """Take the whole frames of a read, and return where the first that is not whole begins."""
        now = self._now()
        start = 0
        window = self._window
        batched = self._batching and len(data) >= FEWEST_BYTES
        publishing = bool(self.publish_rows)
        while True:
            if batched and isinstance(window.find(window.oldest), Rows):
                # Looked for once for what can't be taken so, not at each line.
                before, start = start, self._receive_rows(data, start, now)
                batched = start != before
            if publishing:
                before, start = start, self._receive_publishes(data, start, now)
                publishing = start != before
            end = data.find(b"\n", start)
            if end < 0:
                break
            if end != start:
                self._receive_line(data[start:end], now)
            else:
                # A server's sign that what was repeated is still under way.
                window.heard = True
            start = end + 1
            if start == len(data):
                break
        if start != len(data) and not data.startswith(self._sample, start):
            # Perhaps the beginning of a long answer on a slow line.
            window.heard = True
        if window.oldest == window.next:
            self._batching = False
        self._go_on()
        return start

    def _go_on(self) -> None:
        """Send what answers have made room for, or shown to be lost."""
        if self._stream is not None:
            if self._window.wants_repetition:
                self._repeat()
            if self._waiting or self._window.unfenced:
                self._admit()

    def _receive_rows(self, data: bytes, start: int, now: float) -> int:
        """Take the answers to a batch as long as they stand side by side; return where they end."""
        window = self._window
        while True:
            number = window.oldest
            run = window.find(number)
            if not isinstance(run, Rows):
                return start
            offset = number - run.first & self._codec.ring - 1
            rows = min(run.count - offset, (len(data) - start) // run.reply_size)
            if rows < FEWEST_ROWS:
                return start
            # Of those sent again, some may have been answered meanwhile.
            rows = window.unanswered_from(number, rows)
            taken = run.accept_rows(offset, data[start : start + rows * run.reply_size])
            if not taken:
                return start
            self.counters.responses += taken
            window.answered(number, taken, now)
            start += taken * run.reply_size

    def _receive_publishes(self, data: bytes, start: int, now: float) -> int:
        """Take the publishes of a group as long as they stand side by side; return where they end."""
        framing = self._codec.framing
        head = data[start : start + len(framing.prefix) + 3]
        wanted = self.publish_rows.get(head[len(framing.prefix) :])
        if wanted is None or not head.startswith(framing.prefix):
            return start
        size = wanted.size + framing.overhead
        while (count := (len(data) - start) // size) >= FEWEST_PUBLISHES:
            rows = np.frombuffer(data, np.uint8, count * size, start).reshape(count, size)
            bodies = framing.open_rows(rows, head)
            taken = wanted.take(bodies, now) if len(bodies) >= FEWEST_PUBLISHES else 0
            if not taken:
                break
            start += taken * size
        return start

    def _receive_line(self, line: bytes, now: float) -> None:
        try:
            body = self._open(line)
        except OtherNodeError:
            self.counters.stray += 1
            return
        except FrameError:
            self.counters.damaged += 1
            if not line.startswith(self._sample):
                self._window.heard = True
                self._window.damaged(now)
            return
        if len(body) < 2:
            self.counters.stray += 1
        elif body[0] >= _LOWER_G:
            self._receive_answer(body, now)
        elif body[0] == _P:
            publish = self.publishes.get(body[1:3])
            if publish is not None:
                publish(body, now)
        elif body[0] == _X:
            self._receive_error(body, now)

    def _receive_answer(self, body: bytes, now: float) -> None:
        """Take a message with an ID."""
        self._window.heard = True
        head = 1 if body[1] < _UPPER_G else 2
        after = head + self._id_digits
        number = self._id_number.get(body[head:after])
        if number is None:
            self.counters.stray += 1
            return
        if head == 1 and body[0] == _LOWER_N:
            self._window.out_of_sequence(number, now)
            return
        run = self._window.find(number)
        if run is None:
            self.counters.stray += 1
            return
        offset = number - run.first & self._codec.ring - 1
        if head == 1 and body[0] == _LOWER_X:
            self._fail(run, offset, body[after:])
        elif not run.accept(offset, body, after) and not (run.unwanted() and body[0] == _LOWER_H):
            self.counters.stray += 1
            return
        self.counters.responses += 1
        self._window.answered(number, 1, now)

    def _fail(self, run: Message, offset: int, code: bytes) -> None:
        self.counters.errors += 1
        what = run.describe(offset)
        run.fail_part(offset, 1, gateway_error(_number_of(code), what))

    def _receive_error(self, body: bytes, now: float) -> None:
        """Take an error without an ID."""
        self._window.heard = True
        code = _number_of(body[1:])
        if code in (1, 7, 9):
            self._window.damaged(now)
        elif code in (2, 3):
            given_up = self._window.refused(now)
            if given_up is not None:
                what = given_up.describe(0)
                reason = f"{what}: the gateway refuses the request with error {code:02X}"
                self._give_up(given_up, UnsupportedError(reason))

    def _give_up(self, run: Message, error: UnityLinkError) -> None:
        """End a request that will never be answered; it is sent as ``h`` from now on."""
        run.given_up = True
        run.fail(error)

    # Time and ends

    def _set_timer(self) -> None:
        """Have `_tick` called by the window's deadline; a timer that comes too early sets itself again."""
        deadline = self._window.deadline
        if self._timer is not None:
            if deadline is None or self._timer_at <= deadline:
                return
            self._timer.cancel()
        if deadline is None:
            self._timer = None
        else:
            # Kept here, for a timer of uvloop that is due at once cannot tell it.
            self._timer_at = deadline
            self._timer = self._loop.call_at(deadline, self._tick)

    def _tick(self) -> None:
        self._timer = None
        now = self._now()
        before = self.counters.repetitions
        given_up = self._window.expire(now)
        if given_up is not None:
            self._give_up(given_up, UnansweredError(f"{given_up.describe(0)}: every try was damaged on the way"))
        if self._window.lost:
            self._on_lost("the gateway does not answer any more")
            return
        if self._window.wants_repetition:
            self._repeat()
            self.counters.timeouts += self.counters.repetitions > before
        self._fence()
        self._set_timer()

    def disconnected(self, reason: Exception | None) -> None:
        """Record that the stream has ended."""
        self._on_lost(f"the connection was lost ({reason})" if reason else "the other side closed the connection")


_LOWER_G, _UPPER_G = ord("g"), ord("G")
_LOWER_H, _LOWER_N, _LOWER_X = b"hnx"
_P, _X = b"PX"


def _number_of(text: bytes) -> int:
    try:
        return int(text, 16)
    except ValueError:
        return 0

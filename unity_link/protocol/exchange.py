"""The requests and responses between two `K`: what is asked for goes into the window, responses find their requests.

What must wait for room in the window waits in one line; a source with more to send goes to the end of the line after
its turn, so that a batch of thousands does not hold up the others. Samples that arrive among the responses are told to
belong to whatever their group is for at that point of the stream.

A request that is alone goes by a way of its own, the shortest, and so does an answer that comes alone. Three ways lead
through `Exchange.receive`; what one leaves, the next takes. Of many answers to a batch, or samples, numpy takes as many
as are exactly what is expected. Other answers that stand side by side are compared with what is expected in turn, and
the window is told of them together. A line that is left is looked at by itself.
"""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from unity_link import protocol
from unity_link.errors import UnansweredError, UnsupportedError
from unity_link.protocol.configuration import Feature
from unity_link.protocol.constants import FEWEST_OF_A_FLOOD, FLOOD_PATIENCE, KEEP_ALIVE, MOST_KEPT_WORDS
from unity_link.protocol.events import Sampled, SampledRows, SampledTogether
from unity_link.protocol.frames import LF, MOST_LINES, FrameError, OtherNodeError
from unity_link.protocol.messages import COMMANDS, WITHOUT_ID, ErrorCode
from unity_link.protocol.requests import BatchRun, Confirmation, Fence, Request, gateway_error

if TYPE_CHECKING:
    from collections import deque

    from unity_link.protocol.events import Events
    from unity_link.protocol.group_table import GroupTable
    from unity_link.protocol.host_codec import HostCodec
    from unity_link.protocol.requests import Message, Source
    from unity_link.protocol.window import Window

_MOST_ECHOES = 8192
"""Lines that may come back, at most."""
FEWEST_ROWS = 16
"""Answers of a batch that are worth a turn of numpy."""
FEWEST_BYTES = 64
"""Fewer bytes than so many answers have."""
FEWEST_SAMPLES = 12
"""Samples, side by side, that are worth a turn of numpy."""


class Counters:
    """Counters since the link was opened.

    `unasked` are lines that answer nothing: damaged, empty and stray ones, and errors that say a request was damaged.
    """

    __slots__ = ("damaged", "errors", "repetitions", "requests", "responses", "stray", "timeouts", "unasked")

    def __init__(self) -> None:
        self.requests = self.responses = self.repetitions = self.timeouts = 0
        self.damaged = self.stray = self.errors = self.unasked = 0


class Exchange:
    """One session, from the answer to `K` on.

    Args:
        codec: the messages of the gateway.
        window: over the IDs of the session.
        waiting: what was asked for and has no ID yet, the oldest first.
        groups: the groups of the gateway.
        counters: of the link.
        out: takes the bytes to send.
        blocked: whether the medium takes no bytes at this time.
        takes_turns: whether a turn is waited for before each frame, on a medium that nodes share.
    """

    def __init__(
        self,
        codec: HostCodec,
        window: Window[Message],
        waiting: deque[Source],
        groups: GroupTable,
        counters: Counters,
        out: list[bytes],
        *,
        blocked: bool,
        takes_turns: bool = False,
    ) -> None:
        self.codec = codec
        self.window = window
        self.blocked = blocked
        """True if the medium takes no bytes: what was sent is still held back, so a repetition would be behind it."""
        self._takes_turns = takes_turns
        self._may_send = not takes_turns
        self._asked_alone = False
        self.refused: int | None = None
        """The ID of a request that came whole, and that the gateway did not take for it is in no session: it was reset.
        """
        self.under_way = codec.session
        """The session that the gateway has, as far as it has said; 0 where it was reset."""
        self._echo: Counter[bytes] | None = None
        """Lines that were sent, and may come back; None where none do."""
        self.flood = 0
        """Lines that have come in place of answers, where they are so many that no answer is to be hoped for."""
        self._before_flood = 0.0, -1, 0, 0
        """Instant of the last answer, and the counts then: answers, lines that are none, and what was sent."""
        self._waiting = waiting
        self._groups = groups
        self._counters = counters
        self._send = out.append
        self._out = out
        self._id_number = codec.id_number
        self._id_digits = codec.info.id_digits
        self._mask = codec.ring - 1
        self._open = codec.framing.open
        self._prefix_size = len(codec.framing.prefix)
        self._sample = codec.framing.prefix + b"P"
        """First letters of samples, which carry nothing about requests."""
        self._end = b"" if Feature.HALF_DUPLEX in codec.info.features else LF
        """An empty frame, so that damage to the end of the last one is found; where sides take turns, that is alone."""
        self._batching = False
        """True if answers to many requests may be under way."""
        self._sizes = _answer_sizes(codec)
        self._error_size = self._sizes[b"X"]
        if not self._end:
            # So begins a sample whose first letter was damaged, too; where sides take turns, its end is waited for.
            del self._sizes[b"X"]

    @property
    def has_ended(self) -> bool:
        """Return whether the gateway has said that the session is over."""
        return self.refused is not None or self.under_way != self.codec.session

    # Requests

    def submit(self, source: Source, now: float, events: Events) -> None:
        """Send what `source` has as soon as there is room."""
        window = self.window
        if (
            self._may_send
            and not self._waiting
            and isinstance(source, Request)
            and window.has_room(source.size, posted=source.posted)
            and not (source.places and self._overlaps(source))
        ):
            source.sent = True
            self._counters.requests += 1
            window.send(source, now)
            self._send(source.encode())
            if source.posted and window.needs_fence(now):
                self._confirm(now)
            return
        if isinstance(source, Fence):
            source.follow(self._waiting)
        self._waiting.append(source)
        if source is self._waiting[0] or self._waiting[0].unwanted():
            self.admit(now, events)
        else:
            # What is first has no room: it would have been sent by what made some.
            self._fence(now)

    def submit_alone(self, request: Request, now: float) -> bytes:
        """Return the frame of a request that has an answer, where nothing else is under way; nothing otherwise."""
        window = self.window
        if self._waiting or not self._may_send or self._echo is not None or not window.is_idle():
            return b""
        request.sent = True
        self._counters.requests += 1
        window.send(request, now)
        return request.encode() + self._end if window.allowance.loses else request.encode()

    def _number(self, run: Message, now: float) -> None:
        """Assign IDs to a run, and send it."""
        self._counters.requests += run.count
        self.window.send(run, now)
        if run.count > 1:
            self._batching = True
        self._send(run.encode())

    def admit(self, now: float, events: Events) -> None:
        """Let sources into the window, in turn, as far as there is room."""
        waiting, window = self._waiting, self.window
        room = size = posted = 0
        while waiting and self._may_send:
            source = waiting[0]
            if source.unwanted():
                waiting.popleft()
                continue
            if isinstance(source, Fence) and any(other in waiting for other in source.earlier):
                waiting.rotate(-1)
                continue
            if size != source.size or posted != source.posted:
                size, posted = source.size, source.posted
                room = window.room(size, posted=posted)
            # A window that is small because the line loses is not waited for to grow.
            if not room or (room < source.least and room < window.allowance.most_room(size) // 2):
                break
            if source.places and self._overlaps(source):
                break
            waiting.popleft()
            run = source.take(room, events)
            if not source.exhausted():
                waiting.append(source)
            self._number(run, now)
            room -= run.count
            if posted:
                self._fence(now)
                size = 0
        self._fence(now)

    def _overlaps(self, source: Source) -> bool:
        """Return whether the words of a destructive read would take the place of some that are not answered."""
        first, window = self.window.next, self.window
        for other in window.parts(window.oldest, window.next):
            places = other.run.places
            if places and (
                (first - other.number) % MOST_KEPT_WORDS < places
                or (other.number - first) % MOST_KEPT_WORDS < source.places
            ):
                return True
        return False

    def _fence(self, now: float) -> None:
        """Confirm posted writes by an ``h`` where it is time."""
        if self.window.needs_fence(now):
            self._confirm(now)

    # Turns, where nodes share a medium

    @property
    def wants_turn(self) -> bool:
        """Return whether there is something to send that waits for a turn."""
        window = self.window
        if not self._takes_turns:
            return False
        while self._waiting and self._waiting[0].unwanted():
            self._waiting.popleft()
        if window.repetition.is_due():
            return not self.blocked
        return bool(self._waiting) and window.is_idle()

    def take_turn(self, now: float, events: Events) -> None:
        """Send one frame; with it the turn is used up."""
        self._may_send = True
        if self.window.repetition.is_due():
            self.window.resume(now)
            if not self._asks_alone():
                self._repeat()
        else:
            self.admit(now, events)
        self._may_send = False

    def _asks_alone(self) -> bool:
        """Return whether this turn goes to the question whose the session is: before the second repetition in a row."""
        signs, repetition = self.window.signs, self.window.repetition
        asks = not (self._asked_alone or self.blocked) and signs.gone_back > 1 and signs.place == repetition.sent
        self._asked_alone = asks
        if asks:
            self._ask_whose()
        return asks

    def _confirm(self, now: float) -> None:
        self._number(Confirmation(self.codec), now)

    def go_on(self, now: float, events: Events) -> None:
        """Send what answers have made room for, or shown to be lost."""
        if self.window.repetition.is_due():
            self._repeat()
        if self.window.repetition.must_ask and not self.blocked and not self._takes_turns:
            self._ask_whose()
        if self._waiting or self.window.posts.unfenced:
            self.admit(now, events)

    def _ask_whose(self) -> None:
        """Ask which session is under way: the answer says how far the line has come, too."""
        self.window.repetition.ask()
        self._send(self.codec.framing.checked(b"K"))

    def _repeat(self) -> None:
        """Send unanswered requests again; an ``h`` in place of those that are not wanted any more."""
        if self.blocked or not self._may_send:
            return
        repeated, window = False, self.window
        if window.signs.place == window.repetition.sent and not self._takes_turns:
            # Ahead of all.
            self._ask_whose()
        for number, run, offset, count in window.repeat():
            self._counters.repetitions += count
            frames = self.codec.confirmations(number, count) if run.unwanted() else run.frames_of(offset, count)
            self._send(frames)
            repeated = True
        if repeated and not window.allowance.loses:
            self._send(self._end)

    def end_output(self) -> None:
        """End what was sent together on a line that loses: nothing may follow it for long."""
        self._send(self._end)

    def expect_echo(self) -> None:
        """Pass over what comes back as it was sent: the adapter listens while it sends."""
        self._echo = Counter()
        self._send = self._send_and_note

    def _send_and_note(self, data: bytes) -> None:
        """Send bytes that will come back."""
        self._out.append(data)
        assert self._echo is not None
        if self._echo.total() > _MOST_ECHOES:
            # They were damaged on the way.
            self._echo.clear()
        self._echo.update(line for line in data.split(LF) if line)

    # Responses

    def receive_alone(self, data: bytes, now: float) -> Request | None:
        """Take the answer to the oldest request, and return that, where nothing else has come or waits for room."""
        window = self.window
        if self._waiting or window.posts.unfenced or not window.is_quiet():
            return None
        request = window.find(window.oldest)
        if type(request) is not Request or not request.take_frame(0, data, []):
            return None
        window.signs.heard = True
        self._counters.responses += 1
        window.answered_alone(now)
        return request

    def receive(self, data: bytes, now: float, events: Events) -> int:
        """Take the whole frames of a read, and return where the first begins that was not taken.

        All are taken but those behind one that tells of a reset, or behind `MOST_LINES` that were looked at one by one.
        """
        window, start, lines = self.window, 0, 0
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
            start = self._receive_answers(data, start, now, events)
            if start == len(data):
                break
            before, start = start, self._receive_next(data, start, now, events)
            lines += 1
            if start in (before, len(data)) or self.has_ended:
                break
            if lines >= MOST_LINES and data.find(LF, start) >= 0:
                # Bytes without an end are dropped by the read that brought them, however many lines stood before.
                break
        if start != len(data) and not data.startswith(self._sample, start):
            # Perhaps the beginning of a long answer on a slow line.
            window.signs.heard = True
        if window.is_idle():
            self._batching = False
        return start

    def _receive_next(self, data: bytes, start: int, now: float, events: Events) -> int:
        """Take a line; return where it ends, `start` without an end."""
        end = data.find(b"\n", start)
        if end < 0:
            return start + self._drop_endless(data[start:], now)
        if end == start:
            # A server's sign that what was repeated is still under way.
            self.window.signs.heard = True
            self._counters.unasked += 1
            return start + 1
        return start + self._receive_line(data[start:end], now, events)

    def _receive_rows(self, data: bytes, start: int, now: float, events: Events) -> int:
        """Take the answers to a batch as long as they stand side by side; return where they end."""
        window = self.window
        while True:
            number = window.oldest
            run = window.find(number)
            if not isinstance(run, BatchRun) or run.posted:
                return start
            offset = number - run.first & self._mask
            rows = min(run.count - offset, (len(data) - start) // run.reply_size)
            if rows < FEWEST_ROWS:
                return start
            # Of those sent again, some may have been answered meanwhile.
            rows = window.waiting_from(number, rows)
            taken = run.accept_rows(offset, data[start : start + rows * run.reply_size], events)
            if not taken:
                return start
            self._counters.responses += taken
            window.answered(number, taken, now)
            start += taken * run.reply_size

    def _receive_answers(self, data: bytes, start: int, now: float, events: Events) -> int:
        """Take answers that are just as they are expected as long as they stand side by side; return where they end.

        The window is told together of those whose IDs follow each other.
        """
        find, mask = self.window.find, self._mask
        while start != len(data) and (first := self._number_at(data, start)) is not None:
            number, before = first, start
            while True:
                run = find(number)
                # Others do more than to be answered.
                if not (type(run) is Request or isinstance(run, BatchRun)):
                    break
                end = start + run.reply_size
                if end > len(data) or not run.take_frame(number - run.first & mask, data[start:end], events):
                    break
                number = number + 1 & mask
                start = end
            if start == before:
                break
            self.window.signs.heard = True
            self._counters.responses += number - first & mask
            self.window.answered(first, number - first & mask, now)
        return start

    def _number_at(self, data: bytes, start: int) -> int | None:
        """Return the ID that an answer has that begins here, None where none does."""
        start += self._prefix_size
        after = start + (1 if data[start + 1 : start + 2] < b"G" else 2)
        return self._id_number.get(data[after : after + self._id_digits])

    def _receive_samples(self, data: bytes, start: int, now: float, events: Events) -> int:
        """Take samples as long as they stand side by side; return where they end."""
        framing = self.codec.framing
        head = data[start : start + len(framing.prefix) + 3]
        group = self._groups.begun.get(head[-2:])
        if group is None or not group.length or head != self._sample + group.text:
            return start
        size = group.length + framing.overhead
        count = (len(data) - start) // size
        if count < FEWEST_SAMPLES:
            return start
        if not data.startswith(head, start + size):
            return self._receive_mixture(data, start, now, events)
        # Imported since the group was asked for.
        arrays = protocol.arrays
        bodies = arrays.open_rows(framing, arrays.rows_of(data, start, count, size), head, self.codec.seed_back)
        if len(bodies) < FEWEST_SAMPLES:
            return self._receive_mixture(data, start, now, events)
        events.append(SampledRows(group.owner, bodies, now))
        return start + len(bodies) * size

    def _receive_mixture(self, data: bytes, start: int, now: float, events: Events) -> int:
        """Take samples of several groups as long as they stand side by side; return where they end."""
        codec = self.codec
        found = protocol.mixture.find_mixture(data, start, codec.framing, self._groups.begun, codec.seed_back)
        if found is None or len(found.owners) < FEWEST_SAMPLES:
            return start
        events.append(SampledTogether(found.owners, found.parts, now))
        return start + found.size

    def _receive_line(self, line: bytes, now: float, events: Events) -> int:
        """Take what stands before an LF; return where the next frame begins."""
        if self._echo is not None and self._echo[line] > 0:
            self._echo[line] -= 1
            return len(line) + 1
        try:
            body = self._open(line, self.codec.seed_back)
        except OtherNodeError:
            self._counters.stray += 1
            self._counters.unasked += 1
        except FrameError:
            if self._has_no_session(line, now):
                return len(line) + 1
            return self._cut(line, self._size_of(line), now)
        else:
            if line[-1] != _CR:
                self._receive_body(body, now, events)
                return len(line) + 1
            # All that is asked here is checked, and so are its answers: this one is another's, or damaged.
            size = self._size_of(line)
            if size is not None and len(line) >= size:
                return self._cut(line, size, now)
            if body[:1] == b"X":
                # Perhaps about a request in which damage has made a CR.
                self._receive_error(body, now, events)
            elif body[:1] == b"x" and body[1 + self._id_digits :] == _SHUT_OUT:
                # As that, with its ID.
                self.window.signs.heard = True
                self._counters.unasked += 1
                self.window.damaged(now)
            else:
                self._counters.stray += 1
                self._counters.unasked += 1
        return len(line) + 1

    def _has_no_session(self, line: bytes, now: float) -> bool:
        """Look for the error that a gateway without a session answers; return whether it is one.

        Whether it is about what this host has sent is known by what the check of the request was.
        """
        try:
            body = self._open(line)
        except FrameError:
            return False
        after = 1 + self._id_digits
        number = self._id_number.get(body[1:after])
        if number is None or body[:1] != b"x" or body[after : after + 2] != _NO_SESSION:
            return False
        self.window.signs.heard = True
        run = self.window.find(number)
        residue = _number_of(body[after + 2 :])
        sizes = () if run is None else (run.size, self.codec.head_sizes["H"])
        if residue in [self.codec.residue(size) for size in sizes]:
            self.refused = number
        else:
            self._counters.stray += 1
            self.window.damaged(now)
        return True

    def _cut(self, line: bytes, size: int | None, now: float) -> int:
        """Take a damaged frame from the beginning of a line; return where the next frame begins."""
        self._damaged(line, now)
        return len(line) + 1 if size is None else min(size, len(line) + 1)

    def _drop_endless(self, rest: bytes, now: float) -> int:
        """Drop a frame about a request without its LF where that should stand; return the length of what is dropped."""
        # No request waits for a sample: its end may come with what follows it.
        size = None if rest.startswith(self._sample) else self._size_of(rest)
        if size is None or len(rest) < size:
            return 0
        return self._cut(rest, size, now)

    def _damaged(self, frame: bytes, now: float) -> None:
        self._counters.damaged += 1
        self._counters.unasked += 1
        # What is as short as an error without an ID is one, damaged: one bit makes a P of an X.
        short = len(frame) < self._error_size
        if not short and frame.startswith(self._sample):
            return
        self.window.signs.heard = True
        if self._takes_turns:
            # Where others wait for their turn, what belongs to it may still follow: the time shows its end.
            return
        if len(frame) + 1 == self._error_size:
            self.window.damaged(now)
        else:
            self.window.answer_damaged(now)

    def _size_of(self, frame: bytes) -> int | None:
        """Return how many characters a frame has, LF included, as its beginning says; None where that does not.

        Nor where it may be an echo, which begins as the answer does.
        """
        framing = self.codec.framing
        if self._echo is not None or not frame.startswith(framing.prefix):
            return None
        head = frame[len(framing.prefix) : len(framing.prefix) + 2 + self._id_digits]
        if head.startswith(b"P"):
            group = self._groups.begun.get(head[1:3])
            return group.length + framing.overhead if group is not None and group.length else None
        letters = head[: 2 if b"g" <= head[1:2] <= b"z" else 1]
        size = self._sizes.get(letters)
        if size is None:
            number = self._id_number.get(head[len(letters) : len(letters) + self._id_digits])
            run = None if number is None else self.window.find(number)
            if run is not None and self.codec.lower[run.command] == letters:
                size = run.reply_size or None
        elif letters == b"x" and frame[size - framing.ending_size - 2 :].startswith(_NO_SESSION):
            size += framing.crc.digits
        return size

    def _receive_body(self, body: bytes, now: float, events: Events) -> None:
        if len(body) < 2:
            self._counters.stray += 1
            self._counters.unasked += 1
        elif body[0] >= _LOWER_G:
            self._receive_answer(body, now, events)
        elif body[0] == _P:
            group = self._groups.begun.get(body[1:3])
            if group is not None:
                events.append(Sampled(group.owner, body, now))
        elif body[0] == _X:
            self._receive_error(body, now, events)
        elif body[0] == _K and len(body) == 1 + self.codec.info.session_digits:
            self.window.signs.heard = True
            self.under_way = _number_of(body[1:]) & self.codec.info.last_session
            self.window.asked(now)

    def _receive_answer(self, body: bytes, now: float, events: Events) -> None:
        """Take a message with an ID."""
        window = self.window
        window.signs.heard = True
        head = 1 if body[1] < _UPPER_G else 2
        after = head + self._id_digits
        number = self._id_number.get(body[head:after])
        if number is None:
            self._counters.stray += 1
            return
        if head == 1 and body[0] == _LOWER_N:
            if len(body) == after:
                window.out_of_sequence(number, now)
            else:
                self._counters.stray += 1
            return
        run = window.find(number)
        if run is None:
            self._counters.stray += 1
            return
        offset = number - run.first & self._mask
        if head == 1 and body[0] == _LOWER_X:
            self._counters.errors += 1
            if run.is_question or not run.reply_size:
                window.post_failed()
            error = gateway_error(_number_of(body[after:]), run.describe(offset), self.codec.refusal)
            run.fail_part(offset, 1, error, events)
        elif body[0] == _LOWER_H and not run.is_question and not self._is_told(run, number, body[after:], now):
            return
        elif not run.accept(offset, body, after, events) and not (run.unwanted() and body[0] == _LOWER_H):
            self._counters.stray += 1
            return
        self._counters.responses += 1
        window.answered(number, 1, now)

    def _is_told(self, run: Message, number: int, count: bytes, now: float) -> bool:
        """Return whether the answer to an ``h`` tells of all posted writes before it; otherwise they are asked for."""
        codec = self.codec
        if not (run.is_fence or run.unwanted()) or len(count) != self._id_digits:
            return True
        return self.window.told(number, codec.id_number.get(count, -1), now)

    def _receive_error(self, body: bytes, now: float, events: Events) -> None:
        """Take an error without an ID."""
        self.window.signs.heard = True
        self._counters.unasked += 1
        code = _number_of(body[1:])
        if code in _DAMAGED:
            self.window.damaged(now)
        elif code in _REFUSED:
            run = self.window.refused(now)
            if run is not None:
                reason = f"{run.describe(self._place(run))}: the gateway refuses the request with error {code:02X}"
                self._give_up(run, UnsupportedError(reason), events)

    # Time

    @property
    def deadline(self) -> float | None:
        """Instant at which `expire` must be called; None while nothing is under way and no group is set up."""
        deadline = self.window.deadline
        return self._keep_alive_due if deadline is None else deadline

    @property
    def _keep_alive_due(self) -> float | None:
        """Instant at which the gateway is to be asked whether it still hears its host; None while that does not matter.

        Samples say neither that it does nor that it was not reset since.
        """
        if not self.window.is_idle() or not self._groups.begun:
            return None
        return self.window.since + KEEP_ALIVE

    def expire(self, now: float, events: Events) -> None:
        """Let time pass: send again what was not answered in time, and confirm what was posted."""
        window = self.window
        self._look_for_flood(now)
        before = self._counters.repetitions
        run = window.expire(now)
        if run is not None:
            reason = f"{run.describe(self._place(run))}: every try was damaged on the way"
            self._give_up(run, UnansweredError(reason), events)
        if window.signs.lost:
            return
        if window.repetition.is_due():
            self._repeat()
            self._counters.timeouts += window.signs.timed_out and self._counters.repetitions > before
        self._fence(now)
        keep_alive_due = self._keep_alive_due
        if keep_alive_due is not None and now >= keep_alive_due:
            self._waiting.append(Confirmation(self.codec, of_session=True))
            self.admit(now, events)

    def _look_for_flood(self, now: float) -> None:
        """Note whether lines come in place of answers, and more than what is sent can be the cause of."""
        counters = self._counters
        sent = self.window.repetition.sent
        if self.window.is_idle() or self._before_flood[1] != counters.responses:
            self._before_flood = now, counters.responses, counters.unasked, sent
            return
        since, _, unasked, sent_before = self._before_flood
        lines = counters.unasked - unasked
        if now - since >= FLOOD_PATIENCE and lines >= FEWEST_OF_A_FLOOD + 2 * (sent - sent_before):
            self.flood = lines

    def _place(self, run: Message) -> int:
        """Return the place in its run of the oldest message that waits for an answer."""
        return self.window.oldest - run.first & self._mask

    def _give_up(self, run: Message, error: UnansweredError | UnsupportedError, events: Events) -> None:
        """End what waits for answers that will never come; it is sent as ``h`` from now on."""
        run.given_up = True
        place = self._place(run)
        run.fail_part(place, run.count - place, error, events)


def _answer_sizes(codec: HostCodec) -> dict[bytes, int]:
    """Return the characters of all frames about requests, by their letters, of which each has as many as the other."""
    head = codec.framing.overhead + 1
    sizes = {b"X": head + 2, b"x": head + codec.info.id_digits + 2, b"n": head + codec.info.id_digits}
    for name, row in COMMANDS.items():
        if name not in WITHOUT_ID and name != "WS" and "D" not in row.reads:
            sizes[codec.lower[name]] = codec.head_sizes[name] + (codec.data_digits if row.reads else 0)
    sizes[b"h"] += codec.info.id_digits
    sizes[b"K"] = head + codec.info.session_digits
    return sizes


_LOWER_G, _UPPER_G = ord("g"), ord("G")
_LOWER_H, _LOWER_N, _LOWER_X = b"hnx"
_K, _P, _X = b"KPX"
_CR = b"\r"[0]
_NO_SESSION = b"%02X" % ErrorCode.NO_SESSION
_SHUT_OUT = b"%02X" % ErrorCode.SESSION_UNDER_WAY
_DAMAGED = frozenset({ErrorCode.CRC, ErrorCode.TOO_LONG, ErrorCode.RECEIVE_OVERFLOW})
_REFUSED = frozenset({ErrorCode.UNKNOWN_COMMAND, ErrorCode.MALFORMED})


def _number_of(text: bytes) -> int:
    try:
        return int(text, 16)
    except ValueError:
        return 0

"""Arrivals in a session: answers find their requests, and samples their groups.

A sample belongs to the owner that its group has at that point of the stream. `ResponseReceiver.receive` tries three
ways in turn; each takes what the one before has left. First numpy takes as many answers to a batch, or samples, as are
exactly the expected ones. Then other consecutive answers are compared one by one with the expected ones, and reported
to the window together. A line that is left is decoded by itself.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.errors import UnsupportedError
from unity_link.protocol import wire
from unity_link.protocol.host.batches import BatchRun
from unity_link.protocol.host.events import Sampled, SampledRows, SampledTogether
from unity_link.protocol.host.requests import Request, gateway_error
from unity_link.protocol.wire.frames import LF, MOST_LINES, FrameError, OtherNodeError
from unity_link.protocol.wire.messages import COMMANDS, WITHOUT_ID, ErrorCode

if TYPE_CHECKING:
    from collections import Counter

    from unity_link.protocol.host.events import Events
    from unity_link.protocol.host.group_table import GroupTable
    from unity_link.protocol.host.host_codec import HostCodec
    from unity_link.protocol.host.requests import Message
    from unity_link.protocol.window.window import Window

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


class ResponseReceiver:
    """Reader of what a gateway sends in one session.

    Args:
        codec: the messages of the gateway.
        window: over the IDs of the session.
        groups: the groups of the gateway.
        counters: of the link.
        echo: lines that were sent, and may come back; None where none do.
        half_duplex: whether host and gateway share a pair of wires.
    """

    def __init__(
        self,
        codec: HostCodec,
        window: Window[Message],
        groups: GroupTable,
        counters: Counters,
        echo: Counter[bytes] | None,
        *,
        half_duplex: bool,
    ) -> None:
        self.codec, self.window = codec, window
        self.refused: int | None = None
        """The ID of a request that came whole, and that the gateway did not take for it is in no session: it was reset.
        """
        self.under_way = codec.session
        """The session that the gateway has, as far as it has said; 0 where it was reset."""
        self._groups, self._counters, self._echo, self._is_half_duplex = groups, counters, echo, half_duplex
        self._mask = codec.id_count - 1
        self._sample = codec.framing.prefix + b"P"
        """First letters of samples, which carry nothing about requests."""
        self._next = self._ahead = _NOWHERE
        """While a proof is pending, the ID that `n` has in this session, and the ID of the ``h`` that asks for it."""
        self._is_proven = False
        self._error_size = codec.framing.overhead + 3
        self._sizes = _answer_sizes(codec)

    @property
    def has_ended(self) -> bool:
        """Return whether the gateway has said that the session is over."""
        return self.refused is not None or self.under_way != self.codec.session

    def prove(self, number: int) -> int:
        """Begin a proof that the gateway expects the next ID; return the ID of the ``h`` that asks for it.

        No other ID is further ahead of what the gateway expects in this session.
        """
        self._next, self._ahead = number, number + self._mask // 2 & self._mask
        self._is_proven = False
        return self._ahead

    def end_proof(self) -> bool:
        """End a proof; return whether the gateway has said that it expects the next ID."""
        self._next = self._ahead = _NOWHERE
        return self._is_proven

    def receive(self, data: bytes, now: float, events: Events) -> int:
        """Take the whole frames of a read, and return where the first begins that was not taken.

        All are taken but those behind one that tells of a reset, or behind `MOST_LINES` that were looked at one by one.
        """
        window, start, lines = self.window, 0, 0
        batched = len(data) >= FEWEST_BYTES
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
            window.loss.heard = True
        return start

    def _receive_next(self, data: bytes, start: int, now: float, events: Events) -> int:
        """Take a line; return where it ends, `start` without an end."""
        end = data.find(b"\n", start)
        if end < 0:
            return start + self._drop_endless(data[start:], now)
        if end == start:
            # A server's sign that what was repeated is still under way.
            self.window.loss.heard = True
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
            rows = window.alike(number, rows)
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
            self.window.loss.heard = True
            self._counters.responses += number - first & mask
            self.window.answered(first, number - first & mask, now)
        return start

    def _number_at(self, data: bytes, start: int) -> int | None:
        """Return the ID that an answer has that begins here, None where none does."""
        codec = self.codec
        start += codec.prefix_size
        after = start + (1 if data[start + 1 : start + 2] < b"G" else 2)
        return codec.id_number.get(data[after : after + codec.info.id_digits])

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
        arrays = wire.arrays
        bodies = arrays.open_rows(framing, arrays.rows_of(data, start, count, size), head, self.codec.seed_back)
        if len(bodies) < FEWEST_SAMPLES:
            return self._receive_mixture(data, start, now, events)
        events.append(SampledRows(group.owner, bodies, now))
        return start + len(bodies) * size

    def _receive_mixture(self, data: bytes, start: int, now: float, events: Events) -> int:
        """Take samples of several groups as long as they stand side by side; return where they end."""
        codec = self.codec
        found = wire.interleaved_samples.find_interleaved(
            data, start, codec.framing, self._groups.begun, codec.seed_back
        )
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
            body = self.codec.framing.open(line, self.codec.seed_back)
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
            if self._is_sign(body):
                # Perhaps about a request in which damage has made a CR.
                self.window.loss.heard = True
                self._counters.unasked += 1
                self.window.damaged(now)
            else:
                self._counters.stray += 1
                self._counters.unasked += 1
        return len(line) + 1

    def _is_sign(self, body: bytes) -> bool:
        """Return whether a plain error can be about a damaged request."""
        if body[:1] == b"X":
            return _number_of(body[1:]) in _DAMAGED | _REFUSED
        return body[:1] == b"x" and body[1 + self.codec.info.id_digits :] == _SHUT_OUT

    def _has_no_session(self, line: bytes, now: float) -> bool:
        """Look for the error that a gateway without a session answers; return whether it is one.

        Whether it is about what this host has sent is known by what the check of the request was.
        """
        try:
            body = self.codec.framing.open(line)
        except FrameError:
            return False
        after = 1 + self.codec.info.id_digits
        number = self.codec.id_number.get(body[1:after])
        if number is None or body[:1] != b"x" or body[after : after + 2] != _NO_SESSION:
            return False
        self.window.loss.heard = True
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
        self.window.loss.heard = True
        if self._is_half_duplex:
            # More of a damaged frame may follow: the time shows its end.
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
        head = frame[len(framing.prefix) : len(framing.prefix) + 2 + self.codec.info.id_digits]
        if head.startswith(b"P"):
            group = self._groups.begun.get(head[1:3])
            return group.length + framing.overhead if group is not None and group.length else None
        letters = head[: 2 if b"g" <= head[1:2] <= b"z" else 1]
        size = self._sizes.get(letters)
        if size is None:
            number = self.codec.id_number.get(head[len(letters) : len(letters) + self.codec.info.id_digits])
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
            self.window.loss.heard = True
            self.under_way = _number_of(body[1:]) & self.codec.info.last_session
            self.window.asked(now)

    def _receive_answer(self, body: bytes, now: float, events: Events) -> None:
        """Take a message with an ID."""
        window = self.window
        window.loss.heard = True
        head = 1 if body[1] < _UPPER_G else 2
        after = head + self.codec.info.id_digits
        number = self.codec.id_number.get(body[head:after])
        if number is None:
            self._counters.stray += 1
            return
        if head == 1 and body[0] == _LOWER_N:
            if len(body) == after:
                self._receive_gap(number, now)
            else:
                self._counters.stray += 1
            return
        run = window.find(number)
        if run is None:
            self._receive_stray(number)
            return
        offset = number - run.first & self._mask
        if head == 1 and body[0] == _LOWER_X:
            if run.is_fence and not window.told(number, _UNCOUNTED, now):
                return
            self._counters.errors += 1
            if run.is_question or not run.reply_size:
                window.post_failed()
            error = gateway_error(_number_of(body[after:]), run.describe(offset), self.codec.refusal)
            error.address = run.address_at(offset)
            run.fail_part(offset, 1, error, events)
        elif body[0] == _LOWER_H and not run.is_question and not self._is_told(run, number, body[after:], now):
            return
        elif not run.accept(offset, body, after, events) and not (run.unwanted() and body[0] == _LOWER_H):
            self._counters.stray += 1
            return
        self._counters.responses += 1
        window.answered(number, 1, now)

    def _receive_stray(self, number: int) -> None:
        """Take an answer to an ID for which no request waits."""
        self._counters.stray += 1
        if number == self._ahead:
            # A gateway that expects the next ID answers this one by `n`.
            self.under_way = _ANOTHER

    def _receive_gap(self, number: int, now: float) -> None:
        """Take the ID that the gateway expects."""
        self._is_proven = number == self._next
        if self._is_proven and not self._is_half_duplex:
            # The ``h`` with this ID is on its way.
            return
        is_of_another = self._next not in (_NOWHERE, number)
        if is_of_another or not self.window.out_of_sequence(number, now):
            self.under_way = _ANOTHER

    def _is_told(self, run: Message, number: int, count: bytes, now: float) -> bool:
        """Return whether the answer to an ``h`` tells of all posted writes before it; otherwise they are asked for."""
        codec = self.codec
        if not (run.is_fence or run.unwanted()) or len(count) != self.codec.info.id_digits:
            return True
        # What is not wanted promises nothing.
        return self.window.told(number, codec.id_number.get(count, _UNCOUNTED), now) or not run.is_fence

    def _receive_error(self, body: bytes, now: float, events: Events) -> None:
        """Take an error without an ID."""
        self.window.loss.heard = True
        self._counters.unasked += 1
        code = _number_of(body[1:])
        if code in _DAMAGED:
            self.window.damaged(now)
        elif code in _REFUSED:
            run = self.window.refused(now)
            if run is not None:
                reason = f"the gateway refuses the request with error {code:02X}"
                run.give_up(self.window.oldest, UnsupportedError, reason, events)


def _answer_sizes(codec: HostCodec) -> dict[bytes, int]:
    """Return the characters of all frames about requests, by their letters, of which each has as many as the other.

    Where sides take turns, ``X`` is none of them: a sample whose first letter was damaged begins so too, and its end is
    waited for.
    """
    head = codec.framing.overhead + 1
    sizes = {b"x": head + codec.info.id_digits + 2, b"n": head + codec.info.id_digits}
    if codec.burst_end:
        sizes[b"X"] = head + 2
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
_NOWHERE = -1
"""Is the ID of no request."""
_ANOTHER = -1
"""Stands for the session of another program, which has the same number."""
_UNCOUNTED = -1
"""Number of failed posted writes where an ``h`` is answered by an error, as by a server whose gateway is away."""
_NO_SESSION = b"%02X" % ErrorCode.NO_SESSION
_SHUT_OUT = b"%02X" % ErrorCode.SESSION_UNDER_WAY
_DAMAGED = frozenset({ErrorCode.CRC, ErrorCode.TOO_LONG, ErrorCode.RECEIVE_OVERFLOW})
_REFUSED = frozenset({ErrorCode.UNKNOWN_COMMAND, ErrorCode.MALFORMED})


def _number_of(text: bytes) -> int:
    try:
        return int(text, 16)
    except ValueError:
        return 0

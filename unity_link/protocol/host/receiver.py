"""Received frames of an open session: responses are matched to requests, and samples to groups.

`ResponseReceiver.receive` tries three methods in turn, from the fastest to the most general:

1. numpy checks consecutive answers to a batch, or consecutive samples, and takes those before the first unexpected one.
2. Consecutive answers are compared one by one with the expected frames, and reported to the window together.
3. Any other line is decoded alone. Damaged lines are cut where the beginning of the frame shows its length
   (docs/protocol.md, "The host").

A sample belongs to the owner that its group has at this point of the stream. The session is over if the gateway reports
another session number, or none (error 0A with the residue of a request of this session).
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
"""Fewest answers of a batch for which numpy is faster than a loop."""
FEWEST_BYTES = 64
"""A lower limit of the bytes of `FEWEST_ROWS` answers."""
FEWEST_SAMPLES = 12
"""Fewest consecutive samples for which numpy is faster than a loop."""


class Counters:
    """Counters since the link was opened.

    `unasked` counts lines that are no answer: damaged, empty and stray lines, and errors about damaged requests.
    """

    __slots__ = ("damaged", "errors", "repetitions", "requests", "responses", "stray", "timeouts", "unasked")

    def __init__(self) -> None:
        self.requests = self.responses = self.repetitions = self.timeouts = 0
        self.damaged = self.stray = self.errors = self.unasked = 0


class ResponseReceiver:
    """Receiver of the frames of one session.

    Args:
        codec: message codec of the session.
        window: window of the session.
        groups: the groups of the gateway.
        counters: counters of the link.
        echo: sent lines whose echoes may arrive; None if nothing echoes them.
        half_duplex: True if host and gateway share a pair of wires.
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
        """ID of an undamaged request that the gateway refused because it has no session: it was reset. None otherwise.
        """
        self.current = codec.session
        """Number of the gateway's session, as it was last reported; 0 if the gateway was reset."""
        self._groups, self._counters, self._echo, self._is_half_duplex = groups, counters, echo, half_duplex
        self._mask = codec.id_count - 1
        self._sample = codec.framing.prefix + b"P"
        """First characters of samples, which say nothing about requests."""
        self._next = self._ahead = _NOWHERE
        """While a proof is pending: the ID that ``n`` must contain in this session, and the ID of the ``h`` ahead."""
        self._is_proven = False
        self._error_size = codec.framing.overhead + 3
        self._sizes = _answer_sizes(codec)

    @property
    def has_ended(self) -> bool:
        """True if the gateway has reported that this session is over."""
        return self.refused is not None or self.current != self.codec.session

    def prove(self, number: int) -> int:
        """Begin a proof that the gateway expects the ID `number`; return the ID of the ``h`` ahead.

        That ID is the last one that counts as ahead, half the sequence space from the expected ID.
        """
        self._next, self._ahead = number, number + self._mask // 2 & self._mask
        self._is_proven = False
        return self._ahead

    def end_proof(self) -> bool:
        """End a proof; return whether the gateway has reported that it expects the next ID."""
        self._next = self._ahead = _NOWHERE
        return self._is_proven

    def receive(self, data: bytes, now: float, events: Events) -> int:
        """Take the complete frames in `data`; return the offset of the first frame that was not taken.

        Frames are left over after one that ends the session, and after `MOST_LINES` that were decoded alone.
        """
        window, start, lines = self.window, 0, 0
        batched = len(data) >= FEWEST_BYTES
        sampling = bool(self._groups.begun)
        while True:
            if batched and isinstance(window.find(window.oldest), BatchRun):
                # Do not try again after a failure, so that unusual frames do not cost an attempt for each line.
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
                # Do not stop before bytes without an LF: those are dropped in this call, after any number of lines.
                break
        if start != len(data) and not data.startswith(self._sample, start):
            # An incomplete frame may be the beginning of a long answer on a slow line.
            window.loss.heard = True
        return start

    def _receive_next(self, data: bytes, start: int, now: float, events: Events) -> int:
        """Take one line; return the offset after it, or `start` if it has no LF."""
        end = data.find(b"\n", start)
        if end < 0:
            return start + self._drop_endless(data[start:], now)
        if end == start:
            # An empty line: a server reports that a retransmitted request is still in flight.
            self.window.loss.heard = True
            self._counters.unasked += 1
            return start + 1
        return start + self._receive_line(data[start:end], now, events)

    def _receive_rows(self, data: bytes, start: int, now: float, events: Events) -> int:
        """Take consecutive answers to a batch by numpy; return the offset after them."""
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
            # Stop at an ID that was answered before: after retransmissions there may be such gaps.
            rows = window.alike(number, rows)
            taken = run.accept_rows(offset, data[start : start + rows * run.reply_size], events)
            if not taken:
                return start
            self._counters.responses += taken
            window.answered(number, taken, now)
            start += taken * run.reply_size

    def _receive_answers(self, data: bytes, start: int, now: float, events: Events) -> int:
        """Take consecutive answers that equal the expected frames; return the offset after them.

        Answers with consecutive IDs are reported to the window together.
        """
        find, mask = self.window.find, self._mask
        while start != len(data) and (first := self._number_at(data, start)) is not None:
            number, before = first, start
            while True:
                run = find(number)
                # Answers to other kinds of requests (fences, group set-up) have further effects: decode them alone.
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
        """Return the ID of the answer that begins at `start`, or None if no answer begins there."""
        codec = self.codec
        start += codec.prefix_size
        after = start + (1 if data[start + 1 : start + 2] < b"G" else 2)
        return codec.id_number.get(data[after : after + codec.info.id_digits])

    def _receive_samples(self, data: bytes, start: int, now: float, events: Events) -> int:
        """Take consecutive samples by numpy; return the offset after them."""
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
            return self._receive_interleaved(data, start, now, events)
        # numpy was imported when the group was requested.
        arrays = wire.arrays
        bodies = arrays.open_rows(framing, arrays.rows_of(data, start, count, size), head, self.codec.seed_back)
        if len(bodies) < FEWEST_SAMPLES:
            return self._receive_interleaved(data, start, now, events)
        events.append(SampledRows(group.owner, bodies, now))
        return start + len(bodies) * size

    def _receive_interleaved(self, data: bytes, start: int, now: float, events: Events) -> int:
        """Take consecutive samples of several groups by numpy; return the offset after them."""
        codec = self.codec
        found = wire.interleaved_samples.find_interleaved(
            data, start, codec.framing, self._groups.begun, codec.seed_back
        )
        if found is None or len(found.owners) < FEWEST_SAMPLES:
            return start
        events.append(SampledTogether(found.owners, found.parts, now))
        return start + found.size

    def _receive_line(self, line: bytes, now: float, events: Events) -> int:
        """Take the characters before an LF; return the offset of the next frame from the beginning of `line`."""
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
            # A plain frame. Requests of this session are checked, and so are their answers: this frame is damaged, or
            # an answer to another program.
            size = self._size_of(line)
            if size is not None and len(line) >= size:
                return self._cut(line, size, now)
            if self._is_sign(body):
                # It may answer a request of ours in which damage has made a CR.
                self.window.loss.heard = True
                self._counters.unasked += 1
                self.window.damaged(now)
            else:
                self._counters.stray += 1
                self._counters.unasked += 1
        return len(line) + 1

    def _is_sign(self, body: bytes) -> bool:
        """Return whether a plain frame is an error that the gateway may send for a damaged request."""
        if body[:1] == b"X":
            return _number_of(body[1:]) in _DAMAGED | _REFUSED
        return body[:1] == b"x" and body[1 + self.codec.info.id_digits :] == _SHUT_OUT

    def _has_no_session(self, line: bytes, now: float) -> bool:
        """Handle a line if it is error 0A, of a gateway without a session; return whether it is.

        The error contains the residue of the request's CRC. Only an undamaged request of this session has the expected
        residue, so the residue decides if this session is over.
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
        """Record a damaged frame of `size` characters; return the offset of the next frame from its beginning."""
        self._damaged(line, now)
        return len(line) + 1 if size is None else min(size, len(line) + 1)

    def _drop_endless(self, rest: bytes, now: float) -> int:
        """Drop an answer whose LF is damaged, as soon as all its characters are there; return the dropped length."""
        # Samples are not cut: no request waits for them, and their end may arrive with later bytes.
        size = None if rest.startswith(self._sample) else self._size_of(rest)
        if size is None or len(rest) < size:
            return 0
        return self._cut(rest, size, now)

    def _damaged(self, frame: bytes, now: float) -> None:
        self._counters.damaged += 1
        self._counters.unasked += 1
        # A frame as short as an error without an ID is a damaged error: one bit changes X to P.
        short = len(frame) < self._error_size
        if not short and frame.startswith(self._sample):
            return
        self.window.loss.heard = True
        if self._is_half_duplex:
            # More bytes of the damaged frame may follow, so only the timeout shows that the line is free.
            return
        if len(frame) + 1 == self._error_size:
            self.window.damaged(now)
        else:
            self.window.answer_damaged(now)

    def _size_of(self, frame: bytes) -> int | None:
        """Return the characters of a frame with its LF, if its beginning determines them; otherwise None.

        Also None on a line with an echo, because the echo of a request begins as its answer does.
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
            self.current = _number_of(body[1:]) & self.codec.info.last_session
            self.window.query_answered(now)

    def _receive_answer(self, body: bytes, now: float, events: Events) -> None:
        """Take a checked message with an ID."""
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
            if run.is_fence and not window.fence_answered(number, _UNCOUNTED, now):
                return
            self._counters.errors += 1
            if run.is_question or not run.reply_size:
                window.post_failed()
            error = gateway_error(_number_of(body[after:]), run.describe(offset), self.codec.refusal)
            error.address = run.address_at(offset)
            run.fail_part(offset, 1, error, events)
        elif body[0] == _LOWER_H and not run.is_question and not self._confirms(run, number, body[after:], now):
            return
        elif not run.accept(offset, body, after, events) and not (run.unwanted() and body[0] == _LOWER_H):
            self._counters.stray += 1
            return
        self._counters.responses += 1
        window.answered(number, 1, now)

    def _receive_stray(self, number: int) -> None:
        """Take an answer to an ID without an unanswered request."""
        self._counters.stray += 1
        if number == self._ahead:
            # In this session the gateway answers the ``h`` ahead by ``n``, so its session is another one.
            self.current = _ANOTHER

    def _receive_gap(self, number: int, now: float) -> None:
        """Take ``n`` with the ID that the gateway expects."""
        self._is_proven = number == self._next
        if self._is_proven and not self._is_half_duplex:
            # It answers the ``h`` ahead of a proof, and no request is lost: the ``h`` with this ID is in flight.
            return
        is_of_another = self._next not in (_NOWHERE, number)
        if is_of_another or not self.window.out_of_sequence(number, now):
            self.current = _ANOTHER

    def _confirms(self, run: Message, number: int, count: bytes, now: float) -> bool:
        """Return whether the answer to an ``h`` reports the outcomes of all posted writes before it.

        If not, the window asks for the outcome of each.
        """
        codec = self.codec
        if not (run.is_fence or run.unwanted()) or len(count) != self.codec.info.id_digits:
            return True
        # A cancelled request that is sent as ``h`` need not confirm any posted write.
        return self.window.fence_answered(number, codec.id_number.get(count, _UNCOUNTED), now) or not run.is_fence

    def _receive_error(self, body: bytes, now: float, events: Events) -> None:
        """Take a checked error without an ID."""
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
    """Return the characters of a frame with its LF, by its letters, for all answers and errors of fixed length.

    ``X`` is left out on a half-duplex line: it may be the damaged first letter of a longer sample, whose end must be
    awaited there.
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
"""A number that is no ID."""
_ANOTHER = -1
"""A number that is no session's: the gateway's session is another program's, with the number of ours."""
_UNCOUNTED = -1
"""Count of failed posted writes if an ``h`` is answered by an error, as by a server whose gateway is away."""
_NO_SESSION = b"%02X" % ErrorCode.NO_SESSION
_SHUT_OUT = b"%02X" % ErrorCode.SESSION_UNDER_WAY
_DAMAGED = frozenset({ErrorCode.CRC, ErrorCode.TOO_LONG, ErrorCode.RECEIVE_OVERFLOW})
_REFUSED = frozenset({ErrorCode.UNKNOWN_COMMAND, ErrorCode.MALFORMED})


def _number_of(text: bytes) -> int:
    try:
        return int(text, 16)
    except ValueError:
        return 0

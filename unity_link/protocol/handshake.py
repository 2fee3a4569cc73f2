"""The first words on a connection: what the gateway is, and the start of a session (docs/protocol.md, "The host").

`Q` is asked in plain form, because nothing is known yet, and again in the checked form that follows from the answer;
only if both agree is the answer believed. `K i s` then begins the session: each that is sent has another number, and
only the answer to the last one counts. A plain answer has no CRC, so whatever is wrong with one may be damage: it is
asked for again.

Where the same host has had a session before, it asks by `K` first: a gateway that was reset since has none, and one
that has another's is left to that. The answer to `K i s` says which session it ended, and so of a reset behind that
answer.

What comes back as it was sent is an adapter's echo, which is passed over where an answer follows.
"""

from __future__ import annotations

import contextlib
import math
from collections import deque
from typing import TYPE_CHECKING, NamedTuple

from unity_link.errors import ConnectError, LinkLostError, UnsupportedError
from unity_link.protocol.configuration import Feature, GatewayInfo
from unity_link.protocol.constants import (
    CHECKED_TRIES,
    DAMAGE_COST,
    DAMAGE_PATIENCE,
    DAMAGE_PAUSE,
    ECHO_PATIENCE,
    FIRST_TRY,
    LONGEST_TRY,
    SHORTEST_TRY,
    SURE,
)
from unity_link.protocol.crc import NO_SESSION, Crc
from unity_link.protocol.frames import COMPACT_END, LF, MOST_LINES, FrameError, Framing
from unity_link.protocol.host_codec import HostCodec

if TYPE_CHECKING:
    from collections.abc import Callable

RESET_TRIES = 3
"""Number of times a gateway is asked for the state of its session before a session is asked for all the same."""
ECHO = "what is sent comes back as it is: is TX wired to RX, or an echo switched on?"
TAKEN = (
    "another program has begun a session with the gateway, and this one's is over: let both use it through "
    "`unity-link serve`, or end the other program"
)
_DIFFERENT = 16
"""Number of sessions in a row that have different numbers."""
_NEVER_CHOSEN = frozenset({0x10, 0x1000})
"""With these, damage to the size of a first letter could pass a CRC of 8 or of 16 bits."""
_LONGEST_TEXT = 120
"""Characters of what is not understood that a message quotes."""


_OTHERS = {
    "HTTP/": "an HTTP server",
    "<!DOCTYPE": "an HTTP server",
    "SSH-": "an SSH server",
    "220 ": "a mail or FTP server",
    "login:": "a console that waits for a login",
}
"""Beginnings of the lines by which other devices answer anything, and their names."""


class _Question(NamedTuple):
    """A question that is asked again and again until it is answered."""

    frame: Callable[[], bytes]
    """Returns the frame, anew for each try."""
    is_answer: Callable[[bytes], bool]
    answered: Callable[[bytes, float], None]
    tries: float = math.inf
    unanswered: Callable[[float], None] | None = None
    """Function to call after so many tries."""


class SessionNumbers:
    """Numbers of sessions, drawn at random, of which none is one of the last.

    Args:
        choose: returns any number from 0 on.
    """

    def __init__(self, choose: Callable[[], int]) -> None:
        self.choose = choose
        self._last: deque[int] = deque(maxlen=_DIFFERENT)

    def next(self, most: int) -> int:
        """Return a number from 1 to `most`."""
        number = 1 + self.choose() % most
        while number in self._last or number in _NEVER_CHOSEN:
            number = 1 + number % most
        self._last.append(number)
        return number


class Handshake:
    """One conversation with what is at the other end of a connection.

    Args:
        node: number of the node on a shared medium, or None.
        numbers: by which the session and its first ID are chosen.
        now: the time in seconds.
        before: number of the session before, if the gateway was not reset since as far as is known; 0 for none.
        wire_time: where nodes share the medium, seconds that question and answer are on the wire, at most, 0 where that
            is not known; None where there is no other node.
        longest_try: seconds after which a question is asked again, at most, where the medium needs less than others.
        person: True for a session of somebody who types: it shuts nothing out, and its first ID is 0.
        compact: whether the compact form is asked for where the gateway has it, and no adapter gives back what is sent.
    """

    def __init__(
        self,
        node: int | None,
        numbers: SessionNumbers,
        now: float,
        *,
        before: int = NO_SESSION,
        wire_time: float | None = None,
        longest_try: float = math.inf,
        person: bool = False,
        compact: bool = False,
    ) -> None:
        self._takes_turns = wire_time is not None
        self._wire_time = wire_time or 0.0
        self._longest_try = longest_try
        self._questions = self._answers = 0
        self.echoes = 0
        """Questions that came back."""
        self._node = node
        self._numbers = numbers
        self._person, self._wants_compact = person, compact
        self._first = 0 if person else numbers.choose()
        self._before = before
        self.session = NO_SESSION
        """Number of the session that was asked for last."""
        self.compact = False
        """True if the compact form was asked for with it."""
        self._asked_for: dict[int, float] = {}
        """Instants at which sessions were asked for, by number."""
        self._out: list[bytes] = []
        self._heard = self._unread = 0
        """Bytes that were looked at, and that have arrived behind them."""
        self._text = ""
        """Text heard last that is no frame."""
        self._other = ""
        """The protocol that answers in place of a gateway's."""
        self._doubtful = b""
        """An answer that no other has confirmed."""
        self._alike = 0
        """Number of times it was heard, where no gateway can be as it says."""
        self._echoed_at = math.inf
        """Since when nothing but the question was heard."""
        self._believed = b""
        """The answer that a checked one must repeat."""
        self._codec: HostCodec | None = None
        self.complete = False
        """True if the session has begun: `codec`, `session`, `first` and `round_trip` say how."""
        self.found_reset = False
        """True if the gateway has said that it was reset since an earlier session."""
        self.round_trip = 0.0
        """Seconds to the answer to the last question."""
        self._patience = FIRST_TRY
        self._ask_plain(now)

    @property
    def codec(self) -> HostCodec:
        """The messages of the gateway, once it has said what it is."""
        assert self._codec is not None
        return self._codec

    @property
    def first(self) -> int:
        """The first ID of the session."""
        return self._first & self.codec.ring - 1

    @property
    def byte_time(self) -> float:
        """Seconds that a byte can need on the wire, at most: as the answer to the last question came."""
        return self.round_trip / len(self._sent)

    @property
    def asks(self) -> bool:
        """Return whether there is a question to send."""
        return bool(self._out)

    def take_turn(self, now: float) -> bytes:
        """Return the bytes to send, the time for whose answer begins now."""
        self._asked_at = now
        if self._asked == 1:
            self._began = now
        self.deadline = now + self._patience + self._wire_time
        return self.take_output()

    def take_output(self) -> bytes:
        """Return the bytes to send."""
        data = b"".join(self._out)
        self._out.clear()
        return data

    def describe(self) -> str:
        """Return what was heard, for the message of a time out."""
        if self._other:
            return f"{self._other} answers there, no gateway: is it the right port?"
        if self.echoes:
            return ECHO
        if self._doubtful:
            return f"what answers is no gateway: it said {self._doubtful[:80]!r}"
        if self._codec is not None:
            counts = f"{self._answers} of {self._questions} questions"
            return f"it answered {counts}: what is sent or answered is lost or damaged on the way"
        if heard := self._heard + self._unread:
            return f"{heard} bytes arrived, none of them an answer: check the speed of the port"
        return "nothing arrived: check that the gateway is powered, the port and the wiring"

    def describe_end(self, reason: Exception | None) -> str:
        """Return what can be known of an end of the connection: a line of text may have said why."""
        if self._other:
            return f"{self.describe()} (the connection ended before a gateway answered)"
        why = f'"{self._text}"' if self._text else reason or "does it serve another program, or want a token?"
        return f"the connection ended before the gateway answered: {why}"

    # The questions

    def _ask_plain(self, now: float) -> None:
        # A line end first, for what an earlier program left unfinished; LF, for CR would execute it unchecked.
        self._framing, self._plain = Framing(Crc(), self._node), True
        question = LF + self._framing.plain_request(b"Q")
        self._ask(_Question(lambda: question, self._is_configuration, self._believe), now)

    def _ask_checked(self, now: float) -> None:
        self._framing, self._plain = self.codec.framing, False
        question = self._framing.checked(b"Q")
        self._ask(_Question(lambda: question, self._is_configuration, self._compare, CHECKED_TRIES, self._doubt), now)

    def _is_configuration(self, body: bytes) -> bool:
        return body.startswith(b"Q")

    def _ask_whose(self, now: float) -> None:
        """Ask which session is under way."""
        size = 1 + self.codec.info.session_digits
        question = self._framing.checked(b"K")
        self._ask(
            _Question(
                lambda: question,
                lambda body: body.startswith(b"K") and len(body) == size,
                self._told_whose,
                RESET_TRIES,
                self._ask_session,
            ),
            now,
        )

    def _told_whose(self, body: bytes, now: float) -> None:
        session = int(body[1:], 16) & self.codec.info.last_session
        if session not in (NO_SESSION, self._before):
            raise LinkLostError(TAKEN)
        self.found_reset = session == NO_SESSION
        self._before = session
        self._ask_session(now)

    def _ask_session(self, now: float) -> None:
        self._plain = self._person

        def frame() -> bytes:
            self.session = self._numbers.next(self.codec.info.last_session)
            self._asked_for[self.session] = self._asked_at
            self.compact = self._wants_compact and Feature.COMPACT in self.codec.info.features and not self.echoes
            opening = self._opening(self.session)
            return self._framing.plain_request(opening) if self._person else self._framing.checked(opening)

        def is_answer(body: bytes) -> bool:
            return self._is_opening(body, self.session)

        self._ask(_Question(frame, is_answer, self._session_begun), now, FIRST_TRY)

    def _is_opening(self, body: bytes, session: int) -> bool:
        """Return whether a body is the answer to the opening of a session."""
        opening = self._opening(session)
        return body.startswith(opening) and len(body) == len(opening) + self.codec.info.session_digits

    def _opening(self, session: int) -> bytes:
        return self.codec.opening(self.first, session | self.compact * self.codec.info.asks_compact)

    def _is_late(self, line: bytes, body: bytes, now: float) -> bool:
        """Return whether a line answers an earlier question; where another session was asked for since, wait longer."""
        if self._believed and self._believed in line:
            return True
        late = [asked_at for session, asked_at in self._asked_for.items() if self._is_opening(body, session)]
        if late:
            self._patience = max(self._patience, 2 * (now - late[0]))
            self.deadline = max(self.deadline, self._asked_at + self._patience + self._wire_time)
        return bool(late)

    def _ask(self, question: _Question, now: float, patience: float | None = None) -> None:
        self._question = question
        # What has answered soon, be it damaged, will again.
        self._patience = min(self._patience, FIRST_TRY) if patience is None else patience
        self._tries, self._asked = question.tries, 0
        self._began = now
        self._send(now)

    def _send(self, now: float) -> None:
        self._questions += 1
        self._asked += 1
        self._asked_at = now
        self._sent = self._question.frame()
        self._out.append(self._sent)
        self._damaged = False
        self.deadline = now + self._patience + self._wire_time

    def expire(self, now: float) -> None:
        """Ask again, if the time has come."""
        if self.complete or now < self.deadline:
            return
        if self._damaged:
            self._tries -= DAMAGE_COST
        else:
            self._patience = max(self._patience, min(2 * self._patience, LONGEST_TRY, self._longest_try))
            self._tries -= 1
        if self._tries > 0:
            self._send(now)
        elif self._question.unanswered is not None:
            self._question.unanswered(now)

    def _doubt(self, now: float) -> None:
        self._doubtful = b""
        self._ask_plain(now)

    # The answers

    def receive(self, data: bytes, now: float) -> int:
        """Look for the answer in a read; return where the first line begins that was not looked at.

        That is behind the answer that completes the handshake, or behind `MOST_LINES`.
        """
        start = lines = 0
        while not self.complete and lines < MOST_LINES and (end := data.find(LF, start)) >= 0:
            self._receive_line(data[start:end], now)
            start = end + 1
            lines += 1
        self._heard += start
        self._unread = len(data) - start
        return start

    def _receive_line(self, line: bytes, now: float) -> None:
        # Samples of a session before may be in compact form, and end without a line end.
        line = line[line.rfind(COMPACT_END) + 1 :]
        if not line:
            return
        echo = self._sent.strip(LF)
        if line == echo or (self._plain and line.startswith(echo) and len(line) > len(echo) + 1):
            # What is sent comes back, perhaps with the answer behind it.
            self.echoes += 1
            line = line[len(echo) :]
            if not line:
                if not self._answers and now - self._echoed_at > ECHO_PATIENCE:
                    raise ConnectError(ECHO)
                self._echoed_at = min(self._echoed_at, now)
                return
        self._echoed_at = math.inf
        body = b""
        if line.endswith(b"\r") == self._plain:
            with contextlib.suppress(FrameError):
                body = self._framing.open(line)
        if body and self._question.is_answer(body):
            self._answers += 1
            self._question.answered(body, now)
            return
        if self._is_late(line, body, now):
            return
        text = line[:_LONGEST_TEXT].decode("ascii", "replace").strip()
        self._text = text if text.isprintable() else ""
        self._other = next((_OTHERS[start] for start in _OTHERS if text.startswith(start)), self._other)
        if not self._damaged and not self._takes_turns:
            # Perhaps a damaged answer; what answers so soon will not take much longer for the next one.
            self._damaged = True
            self._patience = min(max(DAMAGE_PATIENCE * (now - self._asked_at), SHORTEST_TRY), LONGEST_TRY)
            self.deadline = now + DAMAGE_PAUSE

    def _compare(self, answer: bytes, now: float) -> None:
        """Take the checked answer: both must say the same."""
        if answer != self._believed:
            self._doubtful = self._believed
            self._believe(answer, now)
        elif self._before:
            self._ask_whose(now)
        else:
            self._ask_session(now)

    def _believe(self, answer: bytes, now: float) -> None:
        """Read what the gateway says it is; what it says `SURE` times in the same words is no damage.

        Raises:
            UnsupportedError: for another protocol version, or impossible widths.
        """
        try:
            self._codec = HostCodec(GatewayInfo.from_hex(answer[1:]), self._node)
        except UnsupportedError:
            self._alike = self._alike + 1 if answer == self._doubtful else 1
            if self._alike == SURE:
                raise
        except ValueError:
            pass
        else:
            self._believed = answer
            self._ask_checked(now)
            return
        self._doubtful = answer
        self._ask_plain(now)

    def _session_begun(self, body: bytes, now: float) -> None:
        self.round_trip = now - self._asked_at
        ended = int(body[-self.codec.info.session_digits :], 16) & self.codec.info.last_session
        if self._before and ended not in (self._before, *self._asked_for):
            self.found_reset = True
        self.complete = True

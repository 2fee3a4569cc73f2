"""The first words on a connection: what the gateway is, and the start of a session (docs/protocol.md, "The host").

`Q` is asked in plain form, because nothing is known yet, and again in the checked form that follows from the answer;
only if both agree is the answer believed. `K i s` then begins the session: each that is sent has another number, and
only the answer to the last one counts. A plain answer has no CRC, so whatever is wrong with one may be damage: it is
asked for again.

Where the same host has had a session before, it asks by `K` first: a gateway that was reset since has none, and one
that has another's is left to that. The answer to `K i s` says which session it ended, and so of a reset behind that
answer.

If the session was asked for in compact form, the line is tried next (`unity_link.protocol.host.trial`). On a line that
does not carry the form, `K i s` begins another session, whose frames are text.

Where frames are in datagrams, `K i s` is padded to the longest datagram of the path (`unity_link.protocol.wire.path`).

What comes back as it was sent is an adapter's echo, which is passed over where an answer follows.
"""

from __future__ import annotations

import contextlib
import enum
import math
import re
from collections import deque
from typing import TYPE_CHECKING, NamedTuple

from unity_link.errors import ConnectError, LinkLostError, UnsupportedError
from unity_link.protocol.host.host_codec import HostCodec
from unity_link.protocol.host.trial import Trial, first_id
from unity_link.protocol.window.constants import (
    CHECKED_TRIES,
    DAMAGE_COST,
    DAMAGE_PATIENCE,
    DAMAGE_PAUSE,
    ECHO_PATIENCE,
    FIRST_TRY,
    LONGEST_TRY,
    SHORTEST_TRY,
    SURE,
    TRIAL_FACTOR,
    TRIALS,
)
from unity_link.protocol.wire.configuration import HEX_DIGITS, Feature, GatewayInfo
from unity_link.protocol.wire.crc import NO_SESSION
from unity_link.protocol.wire.frames import COMPACT_END, LF, MOST_LINES, FrameError

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.protocol.wire.path import Path

RESET_TRIES = 3
"""Number of times a gateway is asked for the state of its session before a session is asked for all the same."""
ECHO = "what is sent comes back as it is: is TX wired to RX, or an echo switched on?"
LINE_ENDS = "the line changes CR or LF, as a terminal or a terminal server does that is not raw: make it transparent"
_FEWEST_CHANGED = 2
"""Lines with another end after which the line is blamed: damage makes such a line now and then."""
_OTHER_END = {
    # An answer to a plain question without CR, or the checked error that answers the question without CR.
    True: re.compile(rb"(?:Z[0-9A-F]{2})?(?:Q[0-9A-F]{64}|X[0-9A-F]{2}(?:[0-9A-F]{2}|[0-9A-F]{4}|[0-9A-F]{8}))"),
    # An answer to a checked question with CR, or the plain error that answers the question with CR.
    False: re.compile(rb"(?:Z[0-9A-F]{2})?(?:Q[0-9A-F]{66,72}|X[0-9A-F]{2})\r+"),
}
"""Lines that a gateway sends if the line changes CR or LF, by whether the question is plain."""
_WITHOUT_LF = re.compile(rb"Q[0-9A-F]{64}\r[^\n]")
TAKEN = (
    "another program has begun a session with the gateway, and this one's is over: let both use it through "
    "`unity-link serve`, or end the other program"
)
UNREADABLE = "check the speed of the port, and that CR and LF arrive unchanged"
NOT_CARRIED = (
    "the gateway answers text but no compact frames: the line changes bytes, and compact=0 in the URL keeps text"
)
NEVER_CHOSEN = (0x10, 0x1000)
"""Numbers of sessions with which damage to the size of a first letter could pass a CRC of 8 or of 16 bits."""
_DIFFERENT = 16
"""Number of sessions in a row that have different numbers."""
_LONGEST_REST = 200
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


def _protocol_of(text: str) -> str:
    """Return the name of what begins a line like that, if it is another protocol."""
    return next((name for start, name in _OTHERS.items() if text.startswith(start)), "")


class State(enum.Enum):
    """States of a handshake: the question that is asked, until the last one is answered."""

    ASKED_PLAIN = enum.auto()
    ASKED_CHECKED = enum.auto()
    ASKED_WHOSE = enum.auto()
    """Asked which session is under way."""
    ASKED_SESSION = enum.auto()
    TRYING = enum.auto()
    """Trying whether the line carries the compact form."""
    COMPLETE = enum.auto()


class _Row(NamedTuple):
    """A state: a question that is asked again and again until an answer fits, which repeats it and says more."""

    question: bytes
    answered: str
    """Method that takes the answer and returns the next state."""
    tries: float = math.inf
    unanswered: State | None = None
    """The next state after so many tries."""


_TABLE = {
    State.ASKED_PLAIN: _Row(b"Q", "_believe"),
    State.ASKED_CHECKED: _Row(b"Q", "_compare", CHECKED_TRIES, State.ASKED_PLAIN),
    State.ASKED_WHOSE: _Row(b"K", "_told_whose", RESET_TRIES, State.ASKED_SESSION),
    # With a first ID and the number of a session, another one each time.
    State.ASKED_SESSION: _Row(b"K", "_session_begun"),
    # Questions and answers of its own.
    State.TRYING: _Row(b"", "", TRIALS, State.ASKED_SESSION),
}


class _Opening(NamedTuple):
    """A request for a session."""

    asked_at: float
    """Instant in seconds."""
    largest: int
    """Bytes of its datagram; 0 if frames are not in datagrams."""


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
        while number in self._last or number in NEVER_CHOSEN:
            number = 1 + number % most
        self._last.append(number)
        return number

    def has_chosen(self, number: int) -> bool:
        """Return whether a number is one of those that were chosen last."""
        return number in self._last


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
        echo: True where an adapter is known to do so: then an echo, however long it is alone, says nothing.
        is_transparent: whether the line is known to carry the compact form, so that it is not tried.
        path: has the length of the longest datagram; None if frames are not in datagrams.
    """

    def __init__(  # noqa: PLR0913  (each is a choice of its own, by keyword)
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
        echo: bool = False,
        is_transparent: bool = False,
        path: Path | None = None,
    ) -> None:
        self._path = path
        self._wire_time = wire_time
        self._longest_try = longest_try
        self._questions = self._answers = 0
        self._knows_echo = echo
        self.echoes = 0
        """Questions that came back."""
        self._node = node
        self._numbers = numbers
        self._person, self._wants_compact = person, compact
        self._tries_line = compact and not is_transparent
        self._trial: Trial | None = None
        """The trial of the line, from its beginning on."""
        self._first = 0 if person else numbers.choose()
        self._before = before
        self.session = NO_SESSION
        """Number of the session that was asked for last."""
        self.compact = False
        """True if the compact form was asked for with it."""
        self._asked_for: dict[int, _Opening] = {}
        """Requests for sessions, by number."""
        self._out = b""
        self._heard = self._unread = 0
        """Bytes that were looked at, and that have arrived behind them."""
        self._rest = b""
        """Bytes of a line without an end, at most so many as show an answer."""
        self._astray = self._changed = 0
        """Lines that answered no question, and those of them that do with another end."""
        self._text = ""
        """Text heard last that is no frame, or by which another protocol showed."""
        self._doubtful = b""
        """An answer that no other has confirmed."""
        self._alike = 0
        """Number of times it was heard, where no gateway can be as it says."""
        self._echoed_at = math.inf
        """Since when nothing but the question was heard."""
        self._believed = b""
        """The answer that a checked one must repeat."""
        self.codec = HostCodec(GatewayInfo(), node)
        """The messages of the gateway, once it has said what it is; before, those of one as it comes."""
        self.found_reset = False
        """True if the gateway was reset since an earlier session, as far as is known."""
        self.round_trip = 0.0
        """Seconds to the last answer."""
        self._patience = FIRST_TRY
        self._ask(State.ASKED_PLAIN, now)

    @property
    def complete(self) -> bool:
        """True if the session has begun: `codec`, `session`, `first` and `round_trip` say how."""
        return self.state is State.COMPLETE

    @property
    def first(self) -> int:
        """The first ID of the session."""
        if self._tries_line and Feature.COMPACT in self.codec.info.features:
            return first_id(self._first, self.codec.info)
        return self._first & self.codec.id_count - 1

    @property
    def line_changes_bytes(self) -> bool:
        """True if a trial of the line has begun and not passed."""
        return self._trial is not None and not self._trial.has_passed

    @property
    def has_echo(self) -> bool:
        """True if an adapter gives back what is sent."""
        return self._knows_echo or self.echoes > 0

    @property
    def byte_time(self) -> float:
        """Seconds that a byte can need on the wire, at most: as the answer to the last question came."""
        return self.round_trip / len(self._sent)

    @property
    def asks(self) -> bool:
        """Return whether there is a question to send."""
        return self._out != b""

    def take_turn(self, now: float) -> bytes:
        """Return the bytes to send, the time for whose answer begins now."""
        self._asked_at = now
        self.deadline = self._until()
        return self.take_output()

    def take_output(self) -> bytes:
        """Return the bytes to send."""
        data, self._out = self._out, b""
        return data

    def describe(self) -> str:
        """Return what was heard, for the message of a time out."""
        if other := _protocol_of(self._text):
            return f"{other} answers there, no gateway: is it the right port?"
        if self.echoes and not self._knows_echo:
            return ECHO
        if self._has_other_ends:
            return LINE_ENDS
        if self._doubtful:
            return f"what answers is no gateway: it said {self._doubtful[:80]!r}"
        return NOT_CARRIED if self.line_changes_bytes else self._describe_answers()

    def _describe_answers(self) -> str:
        """Describe a gateway whose answers are missing or unreadable."""
        if self._believed:
            counts = f"{self._answers} of {self._questions} questions"
            advice = "" if self._path is None else self._path.advice
            return f"it answered {counts}: what is sent or answered is lost or damaged on the way{advice}"
        if heard := self._heard + self._unread:
            return f"{heard} bytes arrived, none of them an answer: {UNREADABLE}"
        return "nothing arrived: check that the gateway is powered, the port and the wiring"

    def describe_end(self, reason: Exception | None) -> str:
        """Return what can be known of an end of the connection: a line of text may have said why."""
        if _protocol_of(self._text):
            return f"{self.describe()} (the connection ended before a gateway answered)"
        is_text = self._text and self._text.isprintable()
        why = f'"{self._text}"' if is_text else reason or "does it serve another program, or want a token?"
        return f"the connection ended before the gateway answered: {why}"

    @property
    def _has_other_ends(self) -> bool:
        """True if most of the lines that answer no question would answer it with another end."""
        most = self._changed >= _FEWEST_CHANGED and 2 * self._changed > self._astray
        return most or _WITHOUT_LF.search(self._rest) is not None

    # The questions

    @property
    def _is_plain(self) -> bool:
        """True if question and answer are in plain form."""
        return self.state is State.ASKED_PLAIN or (self._person and self.state is State.ASKED_SESSION)

    def _question(self) -> bytes:
        return self._opening(self.session) if self.state is State.ASKED_SESSION else _TABLE[self.state].question

    def _fits(self, body: bytes, question: bytes) -> bool:
        """Return whether a body answers a question: `Q` by the configuration, `K` by the number of a session."""
        number = body[len(question) :]
        is_number = len(number) == self.codec.info.session_digits and not number.strip(HEX_DIGITS)
        return body.startswith(question) and (question == b"Q" or is_number)

    def _opening(self, session: int) -> bytes:
        return self.codec.opening(self.first, session | self.compact * self.codec.info.asks_compact)

    def _is_late(self, line: bytes, body: bytes, now: float) -> bool:
        """Return whether a line answers an earlier question; where another session was asked for since, wait longer."""
        if self._believed and self._believed in line:
            return True
        for session, opening in self._asked_for.items():
            if self._fits(body, self._opening(session)):
                self._patience = max(self._patience, 2 * (now - opening.asked_at))
                if self._path is not None:
                    self._path.carried(opening.largest)
                self.deadline = max(self.deadline, self._until())
                return True
        return False

    def _until(self) -> float:
        """Return the time until which the answer to what was asked last is waited for."""
        return self._asked_at + self._patience + (self._wire_time or 0.0)

    def _ask(self, state: State, now: float) -> None:
        """Go on to a state, and ask its question."""
        self.state = state
        if state is not State.COMPLETE:
            # What has answered soon, be it damaged, will again; a session has more to do.
            self._patience = FIRST_TRY if state is State.ASKED_SESSION else min(self._patience, FIRST_TRY)
            if state is State.TRYING:
                self._trial = Trial(self.codec, self.session, takes_turns=self._wire_time is not None)
                self._patience = FIRST_TRY + TRIAL_FACTOR * self.round_trip
            self._tries = _TABLE[state].tries
            self._send(now)

    def _send(self, now: float) -> None:
        self._asked_at = now
        self._damaged = False
        if self._trial is not None and self.state is State.TRYING:
            self._out += self._trial.frames()
            self.deadline = self._until()
            return
        self._questions += 1
        if self.state is State.ASKED_SESSION:
            self.session = self._numbers.next(self.codec.info.last_session)
            self._asked_for[self.session] = _Opening(now, 0 if self._path is None else self._path.largest)
            self.compact = self._wants_compact and Feature.COMPACT in self.codec.info.features and not self.has_echo
        framing, question = self.codec.framing, self._question()
        self._sent = framing.plain_request(question) if self._is_plain else framing.checked(question)
        if self.state is State.ASKED_PLAIN or self._trial is not None:
            # A line end first, because an earlier program or a trial may have left a frame unfinished. Not CR, which
            # would execute that frame unchecked.
            self._sent = LF + self._sent
        self._out += self._sent
        if self._path is not None and self.state is State.ASKED_SESSION:
            info = self.codec.info
            most = math.inf if Feature.FLOW_CONTROL in info.features else info.receive_fifo_bytes
            self._out += self._path.padding(framing, len(self._sent), most)
        self.deadline = self._until()

    def expire(self, now: float) -> None:
        """Ask again, if the time has come."""
        if self.complete or now < self.deadline:
            return
        if self._damaged:
            self._tries -= DAMAGE_COST
        elif self.state is State.TRYING:
            self._tries -= 1
        else:
            self._patience = max(self._patience, min(2 * self._patience, LONGEST_TRY, self._longest_try))
            self._tries -= 1
            if self._path is not None and self.state is State.ASKED_SESSION:
                self._path.unanswered()
        if self._tries > 0:
            self._send(now)
        elif (instead := _TABLE[self.state].unanswered) is not None:
            self._doubtful = b""
            self._wants_compact &= self.state is not State.TRYING
            self._ask(instead, now)

    # The answers

    def receive(self, data: bytes, now: float) -> int:
        """Look for the answer in a read; return where the first line begins that was not looked at.

        That is behind the answer that completes the handshake, or behind `MOST_LINES`.
        """
        start = lines = 0
        while (
            not self.complete
            and self.state is not State.TRYING
            and lines < MOST_LINES
            and (end := data.find(LF, start)) >= 0
        ):
            self._receive_line(data[start:end], now)
            start = end + 1
            lines += 1
        if self._trial is not None and self.state is State.TRYING:
            self._trial.receive(data[start:])
            start = len(data)
            if self._trial.has_passed:
                self._ask(State.COMPLETE, now)
            elif self._trial.is_answered:
                self.deadline = min(self.deadline, now + DAMAGE_PAUSE)
        self._heard += start
        self._unread = len(data) - start
        self._rest = data[start : start + _LONGEST_REST]
        return start

    def _receive_line(self, line: bytes, now: float) -> None:
        # Samples of a session before may be in compact form, and end without a line end.
        line = line[line.rfind(COMPACT_END) + 1 :]
        if not line:
            return
        echo = self._sent.strip(LF)
        if line == echo or (self._is_plain and line.startswith(echo) and len(line) > len(echo) + 1):
            # What is sent comes back, perhaps with the answer behind it.
            self.echoes += 1
            line = line[len(echo) :]
            if not line:
                if not (self._answers or self._knows_echo) and now - self._echoed_at > ECHO_PATIENCE:
                    raise ConnectError(ECHO)
                self._echoed_at = min(self._echoed_at, now)
                return
        self._echoed_at = math.inf
        body = b""
        if line.endswith(b"\r") == self._is_plain:
            with contextlib.suppress(FrameError):
                body = self.codec.framing.open(line)
        if self._fits(body, self._question()):
            self._answers += 1
            self.round_trip = now - self._asked_at
            self._ask(getattr(self, _TABLE[self.state].answered)(body), now)
            return
        has_other_end = _OTHER_END[self._is_plain].fullmatch(line) is not None
        if not has_other_end and self._is_late(line, body, now):
            return
        self._astray += 1
        self._changed += has_other_end
        text = line[:_LONGEST_TEXT].decode("ascii", "replace").strip()
        if _protocol_of(text) or not _protocol_of(self._text):
            self._text = text
        if not self._damaged and self._wire_time is None:
            # Perhaps a damaged answer; what answers so soon will not take much longer for the next one.
            self._damaged = True
            self._patience = min(max(DAMAGE_PATIENCE * (now - self._asked_at), SHORTEST_TRY), LONGEST_TRY)
            self.deadline = now + DAMAGE_PAUSE

    def _compare(self, answer: bytes) -> State:
        """Take the checked answer: both must say the same."""
        if answer != self._believed:
            self._doubtful = self._believed
            return self._believe(answer)
        self._doubtful = b""
        return State.ASKED_WHOSE if self._before else State.ASKED_SESSION

    def _believe(self, answer: bytes) -> State:
        """Read what the gateway says it is; what it says `SURE` times in the same words is no damage.

        Raises:
            UnsupportedError: for another protocol version, or impossible widths.
        """
        try:
            self.codec = HostCodec(GatewayInfo.from_hex(answer[1:]), self._node)
        except UnsupportedError:
            self._alike = self._alike + 1 if answer == self._doubtful else 1
            if self._alike == SURE:
                raise
        except ValueError:
            pass
        else:
            self._believed = answer
            return State.ASKED_CHECKED
        self._doubtful = answer
        return State.ASKED_PLAIN

    def _told_whose(self, body: bytes) -> State:
        session = self._number_in(body)
        if session not in (NO_SESSION, self._before) and not self._numbers.has_chosen(session):
            raise LinkLostError(TAKEN)
        # If the answer to an opening of its own was lost with the connection, a reset before it cannot be excluded.
        self.found_reset = session != self._before
        self._before = session
        return State.ASKED_SESSION

    def _session_begun(self, body: bytes) -> State:
        ended = self._number_in(body)
        if self._before and ended not in (self._before, *self._asked_for):
            self.found_reset = True
        return State.TRYING if self.compact and self._tries_line else State.COMPLETE

    def _number_in(self, answer: bytes) -> int:
        """Return the number of the session that an answer to `K` tells."""
        return int(answer[-self.codec.info.session_digits :], 16) & self.codec.info.last_session

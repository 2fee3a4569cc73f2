"""The handshake of a connection: the gateway's configuration, and a new session (docs/protocol.md, "The host").

1. Send `Q` in plain form, because the width of the CRC is unknown. Any fault in its answer may be damage, because a
   plain frame has no CRC: send `Q` again.
2. Send `Q` in checked form, with the CRC of that answer. The configuration is accepted if both answers agree.
3. If this host had a session before, query the session by `K`: no session means that the gateway was reset; the session
   of another program ends this link.
4. Send `K i s`, which begins the session. Each attempt has another number s, and only the answer to the last one
   counts. The answer contains the session that ended, which reveals a reset between the steps 3 and 4.
5. If the compact form is used, test the line (`unity_link.protocol.host.trial`). If the test fails, begin a session
   with text frames by another `K i s`.

In datagrams, `K i s` is padded to the longest datagram of the path (`unity_link.protocol.wire.path`). Bytes that come
back as they were sent are the echo of an adapter; they are ignored if an answer follows.
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
"""Number of session queries without an answer, after which a session is begun nevertheless."""
ECHO = "what is sent comes back as it is: is TX wired to RX, or an echo switched on?"
LINE_ENDS = "the line changes CR or LF, as a terminal or a terminal server does that is not raw: make it transparent"
_FEWEST_CHANGED = 2
"""Fewest answers with a changed line end that mean that the line changes CR or LF; damage can cause single ones."""
_OTHER_END = {
    # The answer to a plain `Q` without its CR; or the checked error to a plain `Q` whose CR was lost.
    True: re.compile(rb"(?:Z[0-9A-F]{2})?(?:Q[0-9A-F]{64}|X[0-9A-F]{2}(?:[0-9A-F]{2}|[0-9A-F]{4}|[0-9A-F]{8}))"),
    # The answer to a checked `Q` with a CR; or the plain error to a checked `Q` that arrived with a CR.
    False: re.compile(rb"(?:Z[0-9A-F]{2})?(?:Q[0-9A-F]{66,72}|X[0-9A-F]{2})\r+"),
}
"""Patterns of frames that arrive if the line changes CR or LF; the key is True for plain requests."""
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
"""Session numbers with which a damaged case of the first letter could pass a CRC of 8 or 16 bits."""
_DIFFERENT = 16
"""Number of consecutive sessions with different numbers."""
_LONGEST_REST = 200
"""Most bytes of an incomplete line that are stored, to recognise an answer without LF."""
_LONGEST_TEXT = 120
"""Most characters of an unknown line that are stored for an error."""
_OTHERS = {
    "HTTP/": "an HTTP server",
    "<!DOCTYPE": "an HTTP server",
    "SSH-": "an SSH server",
    "220 ": "a mail or FTP server",
    "login:": "a console that waits for a login",
}
"""First characters of lines that other devices send as an answer, and the names of these devices."""


def _protocol_of(text: str) -> str:
    """Return the name of the device whose lines begin like `text`; empty if it is unknown."""
    return next((name for start, name in _OTHERS.items() if text.startswith(start)), "")


class State(enum.Enum):
    """States of a handshake, named after the last request."""

    ASKED_PLAIN = enum.auto()
    """Sent a plain `Q`."""
    ASKED_CHECKED = enum.auto()
    """Sent a checked `Q`."""
    QUERIED_SESSION = enum.auto()
    """Sent a session query, `K` without fields."""
    ASKED_SESSION = enum.auto()
    """Sent `K i s`."""
    TRYING = enum.auto()
    """Sent the requests of the trial of the line."""
    COMPLETE = enum.auto()
    """The session has begun."""


class _Row(NamedTuple):
    """Transitions of a state. Its request is repeated until an answer fits; the answer begins with the request."""

    question: bytes
    """Body of the request."""
    answered: str
    """Name of the method that takes the answer and returns the next state."""
    tries: float = math.inf
    """Number of tries without an answer, after which `unanswered` follows."""
    unanswered: State | None = None
    """Next state after `tries`."""


_TABLE = {
    State.ASKED_PLAIN: _Row(b"Q", "_believe"),
    State.ASKED_CHECKED: _Row(b"Q", "_compare", CHECKED_TRIES, State.ASKED_PLAIN),
    State.QUERIED_SESSION: _Row(b"K", "_session_reported", RESET_TRIES, State.ASKED_SESSION),
    # `_opening` adds the first ID and a new session number.
    State.ASKED_SESSION: _Row(b"K", "_session_begun"),
    # `Trial` has the requests and takes the answers.
    State.TRYING: _Row(b"", "", TRIALS, State.ASKED_SESSION),
}


class _Opening(NamedTuple):
    """A `K i s` that was sent."""

    asked_at: float
    """Instant of its transmission, in seconds."""
    largest: int
    """Bytes of its datagram; 0 if frames are not in datagrams."""


class SessionNumbers:
    """Random session numbers; none repeats one of the last `_DIFFERENT`.

    Args:
        choose: returns a random number from 0 on.
    """

    def __init__(self, choose: Callable[[], int]) -> None:
        self.choose = choose
        self._last: deque[int] = deque(maxlen=_DIFFERENT)

    def next(self, most: int) -> int:
        """Return a session number from 1 to `most`."""
        number = 1 + self.choose() % most
        while number in self._last or number in NEVER_CHOSEN:
            number = 1 + number % most
        self._last.append(number)
        return number

    def has_chosen(self, number: int) -> bool:
        """Return whether a number is one of the last `_DIFFERENT` session numbers of this host."""
        return number in self._last


class Handshake:
    """The handshake on one connection.

    Args:
        node: number of the node on a shared medium, or None.
        numbers: source of session numbers and first IDs.
        now: the time in seconds.
        before: number of this host's previous session, if the gateway may still have it; 0 for none.
        wire_time: if nodes share the line, most seconds that a request and its answer take on the wire, 0 if unknown;
            None if there is no other node.
        longest_try: most seconds until a request is sent again.
        person: True for a session of a person who types: plain requests stay allowed, and the first ID is 0.
        compact: use the compact form if the gateway has it, and no adapter echoes sent bytes.
        echo: True if an adapter is known to echo sent bytes, so that an echo alone is no error.
        is_transparent: True if the line is known to carry the compact form, so that it is not tested.
        path: longest datagram of the network; None if frames are not in datagrams.
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
        """Number of requests whose echo arrived."""
        self._node = node
        self._numbers = numbers
        self._person, self._wants_compact = person, compact
        self._tries_line = compact and not is_transparent
        self._trial: Trial | None = None
        """The trial of the line; None before it has begun."""
        self._first = 0 if person else numbers.choose()
        self._before = before
        self.session = NO_SESSION
        """Number of the session in the last `K i s`."""
        self.compact = False
        """True if the last `K i s` has requested the compact form."""
        self._asked_for: dict[int, _Opening] = {}
        """Sent `K i s`, by session number."""
        self._out = b""
        """Bytes to send."""
        self._heard = self._unread = 0
        """Number of processed bytes, and of received bytes after them."""
        self._rest = b""
        """Beginning of an incomplete line."""
        self._astray = self._changed = 0
        """Number of lines that answer no request, and of those that would with another line end."""
        self._text = ""
        """Last line that is no answer; a line of another known protocol is kept."""
        self._doubtful = b""
        """Answer to `Q` that is impossible, or that the checked answer contradicts."""
        self._alike = 0
        """Number of times that the same impossible answer arrived."""
        self._echoed_at = math.inf
        """Instant since which only echoes have arrived; infinite if another line has arrived since."""
        self._believed = b""
        """Plain answer to `Q`, which the checked answer must repeat."""
        self.codec = HostCodec(GatewayInfo(), node)
        """Message codec with the widths of the gateway; before its answer to `Q`, with the default widths."""
        self.found_reset = False
        """True if the gateway was reset since this host's previous session."""
        self.round_trip = 0.0
        """Seconds from the last answered request to its answer."""
        self._patience = FIRST_TRY
        self._ask(State.ASKED_PLAIN, now)

    @property
    def complete(self) -> bool:
        """True if the session has begun, with `codec`, `session`, `first` and `round_trip`."""
        return self.state is State.COMPLETE

    @property
    def first(self) -> int:
        """First ID of the session."""
        if self._tries_line and Feature.COMPACT in self.codec.info.features:
            return first_id(self._first, self.codec.info)
        return self._first & self.codec.id_count - 1

    @property
    def line_changes_bytes(self) -> bool:
        """True if a trial of the line has begun and not passed."""
        return self._trial is not None and not self._trial.has_passed

    @property
    def has_echo(self) -> bool:
        """True if an adapter echoes sent bytes."""
        return self._knows_echo or self.echoes > 0

    @property
    def byte_time(self) -> float:
        """Upper limit of the seconds that a byte takes on the wire, from the last round trip."""
        return self.round_trip / len(self._sent)

    @property
    def asks(self) -> bool:
        """True if there are bytes to send."""
        return self._out != b""

    def take_turn(self, now: float) -> bytes:
        """Return the bytes to send in a slot that begins now, and start the timeout of their answer."""
        self._asked_at = now
        self.deadline = self._until()
        return self.take_output()

    def take_output(self) -> bytes:
        """Return the bytes to send."""
        data, self._out = self._out, b""
        return data

    def describe(self) -> str:
        """Return a description of the received bytes, for the error after a timeout."""
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
        """Return a description of missing or damaged answers."""
        if self._believed:
            counts = f"{self._answers} of {self._questions} questions"
            advice = "" if self._path is None else self._path.advice
            why = "requests or answers are lost or damaged on the way, or this computer is too busy"
            return f"it answered {counts}: {why}{advice}"
        if heard := self._heard + self._unread:
            return f"{heard} bytes arrived, none of them an answer: {UNREADABLE}"
        return "nothing arrived: check that the gateway is powered, the port and the wiring"

    def describe_end(self, reason: Exception | None) -> str:
        """Return a description of the end of the connection, with the last line of text, which may give the reason."""
        if _protocol_of(self._text):
            return f"{self.describe()} (the connection ended before a gateway answered)"
        is_text = self._text and self._text.isprintable()
        why = f'"{self._text}"' if is_text else reason or "does it serve another program, or want a token?"
        return f"the connection ended before the gateway answered: {why}"

    @property
    def _has_other_ends(self) -> bool:
        """True if most lines that are no answer would be answers with another line end."""
        most = self._changed >= _FEWEST_CHANGED and 2 * self._changed > self._astray
        return most or _WITHOUT_LF.search(self._rest) is not None

    # Requests

    @property
    def _is_plain(self) -> bool:
        """True if the current request and its answer are in plain form."""
        return self.state is State.ASKED_PLAIN or (self._person and self.state is State.ASKED_SESSION)

    def _question(self) -> bytes:
        return self._opening(self.session) if self.state is State.ASKED_SESSION else _TABLE[self.state].question

    def _fits(self, body: bytes, question: bytes) -> bool:
        """Return whether a body answers a request: it repeats the request, and after a `K` adds a session number."""
        number = body[len(question) :]
        is_number = len(number) == self.codec.info.session_digits and not number.strip(HEX_DIGITS)
        return body.startswith(question) and (question == b"Q" or is_number)

    def _opening(self, session: int) -> bytes:
        return self.codec.opening(self.first, session | self.compact * self.codec.info.asks_compact)

    def _is_late(self, line: bytes, body: bytes, now: float) -> bool:
        """Return whether a line answers an earlier request. After a late answer to `K i s`, extend the timeout."""
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
        """Return the instant at which the answer to the last request is late."""
        return self._asked_at + self._patience + (self._wire_time or 0.0)

    def _ask(self, state: State, now: float) -> None:
        """Change to a state, and send its request."""
        self.state = state
        if state is not State.COMPLETE:
            # A gateway that answered quickly, even with a damaged frame, will do so again: keep the short retry time.
            # Opening a session takes longer.
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
            # Send LF first, because an earlier program or a trial may have left an incomplete frame. CR would execute
            # that frame without a check.
            self._sent = LF + self._sent
        self._out += self._sent
        if self._path is not None and self.state is State.ASKED_SESSION:
            info = self.codec.info
            most = math.inf if Feature.FLOW_CONTROL in info.features else info.receive_fifo_bytes
            self._out += self._path.padding(framing, len(self._sent), most)
        self.deadline = self._until()

    def expire(self, now: float) -> None:
        """Send the request again, or change to the next state, if `deadline` is reached."""
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

    # Answers

    def receive(self, data: bytes, now: float) -> int:
        """Process the complete lines of a read; return the offset of the first line that was not processed.

        Lines are left over after the answer that completes the handshake, and after `MOST_LINES`.

        Raises:
            ConnectError: if only echoes arrive.
            LinkLostError: if the gateway's session is another program's.
            UnsupportedError: for another protocol version, or an impossible configuration.
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
        # Compact samples of an earlier session may precede the answer without a line end.
        line = line[line.rfind(COMPACT_END) + 1 :]
        if not line:
            return
        echo = self._sent.strip(LF)
        if line == echo or (self._is_plain and line.startswith(echo) and len(line) > len(echo) + 1):
            # It is the echo of the request, perhaps with the answer after it.
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
            # It may be a damaged answer. Then the next answer will take about as long, so send the request again soon.
            self._damaged = True
            self._patience = min(max(DAMAGE_PATIENCE * (now - self._asked_at), SHORTEST_TRY), LONGEST_TRY)
            self.deadline = now + DAMAGE_PAUSE

    def _compare(self, answer: bytes) -> State:
        """Take the checked answer to `Q`, which must repeat the plain one."""
        if answer != self._believed:
            self._doubtful = self._believed
            return self._believe(answer)
        self._doubtful = b""
        return State.QUERIED_SESSION if self._before else State.ASKED_SESSION

    def _believe(self, answer: bytes) -> State:
        """Take an answer to `Q`; an impossible one is believed if it arrives `SURE` times.

        Raises:
            UnsupportedError: for another protocol version, or an impossible configuration.
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

    def _session_reported(self, body: bytes) -> State:
        """Take the answer to a session query."""
        session = self._number_in(body)
        if session not in (NO_SESSION, self._before) and not self._numbers.has_chosen(session):
            raise LinkLostError(TAKEN)
        # The session may be one whose `K i s` was answered on the lost connection. Then a reset before it is possible.
        self.found_reset = session != self._before
        self._before = session
        return State.ASKED_SESSION

    def _session_begun(self, body: bytes) -> State:
        """Take the answer to the last `K i s`."""
        ended = self._number_in(body)
        if self._before and ended not in (self._before, *self._asked_for):
            self.found_reset = True
        return State.TRYING if self.compact and self._tries_line else State.COMPLETE

    def _number_in(self, answer: bytes) -> int:
        """Return the session number at the end of an answer to `K`."""
        return int(answer[-self.codec.info.session_digits :], 16) & self.codec.info.last_session

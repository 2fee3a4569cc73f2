"""A session decodes consecutive answers together; the result is the same as decoding them line by line.

The session compares each answer with the bytes that it expects, and reports answers with consecutive IDs to the window
in one call. A single outstanding request is sent and answered by a shorter code path.
"""

from __future__ import annotations

from typing import Any, NamedTuple
from unittest import mock

import msgspec
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from support.open_at_once import open_at_once
from support.searching import examples
from support.valve import as_gateway
from support.window_state import window_state
from unity_link.protocol.host.batches import BatchRun, WordBatch
from unity_link.protocol.host.receiver import Counters, ResponseReceiver
from unity_link.protocol.host.requests import Fence, Request
from unity_link.protocol.host.session import Session
from unity_link.protocol.window.window import Window
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.frames import FrameError

REPLIES = {"R": 8, "W": 0, "WS": None, "RM": 24, "H": 2}
KINDS = ["whole"] * 12 + ["damaged", "lost", "double", "other ID", "error", "no session", "out of sequence", "sample"]
KINDS += ["stray residue", "failed", "whose", "whose", "another's"]
KINDS += ["line end within", "line end in front", "plain", "short", "upper case"]
INFO = GatewayInfo(id_digits=2)
SESSION = 0x1234
BATCHES = {"batch": 40, "small batch": 5}


class Slow(Session):
    """A session that decides for each request by the window's numbers if it may be sent, without shortcuts.

    Its window never reports that the line is free of losses, so no answer is taken by the shortest path.
    """

    def submit(self, source: Any, now: float) -> list[Any]:
        events = super().submit(source, now)
        self._admit(now, events)
        return events

    def _admit(self, now: float, events: list[Any]) -> None:
        waiting, window = self._waiting, self.window
        self._prove(now)
        while waiting and self._may_begin:
            source = waiting[0]
            if source.unwanted():
                waiting.popleft()
            elif isinstance(source, Fence) and any(other in waiting for other in source.earlier):
                waiting.rotate(-1)
            else:
                room = window.room(source.size, posted=source.posted)
                if room < min(source.least, max(1, window.send_limit.most_room(source.size) // 2)):
                    break
                waiting.popleft()
                run = source.take(room, events)
                if not source.exhausted():
                    waiting.append(source)
                self._number(run, now)
                if run.posted:
                    self._fence(now)
        if self._fence(now):
            self._admit(now, events)

    def receive(self, data: bytes, now: float) -> list[Any]:
        with mock.patch.object(Window, "has_no_loss", return_value=False):
            return super().receive(data, now)

    def submit_alone(self, request: Request, now: float) -> bytes:
        return b""

    def receive_alone(self, data: bytes, now: float) -> Request | None:
        return None


class Line(ResponseReceiver):
    """A reader that opens and decodes each line by itself, and reports answers with consecutive IDs together."""

    def _receive_answers(self, data: bytes, start: int, now: float, events: list[Any]) -> int:
        while (after := self._receive_group(data, start, now, events)) != start:
            start = after
        return start

    def _receive_group(self, data: bytes, start: int, now: float, events: list[Any]) -> int:
        """Take checked answers with consecutive IDs; return the offset at which they end."""
        taken: list[int] = []
        for line in data[start:].split(b"\n")[:-1]:
            try:
                body = self.codec.framing.open(line, self.codec.seed_back)
                answer = self.codec.decode_response(body)
            except (FrameError, ValueError):
                break
            number = answer.id
            if line.endswith(b"\r") or number is None or (taken and number != taken[-1] + 1 & 0xFF):
                break
            run = self.window.find(number)
            if isinstance(run, BatchRun):
                if (answer.command, list(answer.fields)) != ("R", ["d"]):
                    break
                run._batch.put(run._start + (number - run.first & 0xFF), 1, answer.fields["d"], events)
            elif type(run) is not Request or not run.accept(0, body, len(answer.command) + 2, events):
                break
            taken.append(number)
            start += len(line) + 1
        if taken:
            self.window.loss.heard = True
            self._counters.responses += len(taken)
            self.window.answered(taken[0], len(taken), now)
        return start


class Turn(NamedTuple):
    """Requests that a program submits in one turn, and what happens to their answers."""

    commands: list[str]
    kinds: list[str]
    cuts: list[int] | None
    """Offsets at which the arriving bytes are cut; None: between the answers."""
    seconds: float
    cancelled: bool


turns = st.lists(
    st.builds(
        Turn,
        st.lists(st.sampled_from([*REPLIES, "fence", *BATCHES]), max_size=12),
        st.lists(st.sampled_from(KINDS), max_size=14),
        st.lists(st.integers(0, 1 << 16), max_size=4) | st.none(),
        st.sampled_from([0.0, 0.0001, 0.01, 3.0]),
        st.booleans(),
    ),
    max_size=12,
)

LOSS = [Turn(["R"], [], [], 0.0, cancelled=False), Turn([], ["whole"], [], 3.0, cancelled=False)]
"""One request gets no answer until the host retransmits it."""


class Host:
    """One side of the comparison: a session, the bytes that it sends and the events that it returns."""

    def __init__(self, kind: type[Session], node: int | None, credit: int | None = None) -> None:
        info, session = INFO, kind(None, lambda: 0)
        if credit is not None:
            features = INFO.features & ~Feature.FLOW_CONTROL
            info = msgspec.structs.replace(INFO, features=features, receive_fifo_bytes=credit)
        open_at_once(session, info, node, SESSION, first=250, round_trip=0.002)
        self.session, self.codec = session, session.codec
        self.sent = b""
        self.events: list[Any] = []
        if kind is Slow:
            arguments = self.codec, session.window, session.groups, session.counters
            session._receiver = Line(*arguments, None, half_duplex=False)

    @property
    def window(self) -> Window[Any]:
        return self.session.window

    def ask(self, turn: Turn, now: float) -> None:
        request: Request | WordBatch | None = None
        for command in turn.commands:
            if command in BATCHES:
                request = WordBatch(self.codec, "R", [(np.full(BATCHES[command], 0x12), 2)])
            elif command == "fence":
                request = Fence(self.codec)
            else:
                request = Request(self.codec, command, b"12", REPLIES[command])
                request.poster = None
            frame = b""
            if isinstance(request, Request) and not request.posted:
                frame = self.session.submit_alone(request, now)
            if frame:
                self.sent += frame
            else:
                self.events += self.session.submit(request, now)
                if self.window.has_one_request():
                    self.flush()
        self.flush()
        if request is not None and turn.cancelled:
            request.cancel()

    def expire(self, now: float) -> None:
        self.events += self.session.expire(now)
        self.flush()

    def flush(self) -> None:
        self.sent += self.session.take_output()

    def hear(self, pieces: list[bytes], now: float) -> None:
        for piece in pieces:
            if (answered := self.session.receive_alone(piece, now)) is not None:
                self.events.append(answered)
                continue
            self.events += self.session.receive(piece, now)
            if not self.session.is_open:
                return
            self.flush()

    def state(self) -> object:
        window = window_state(self.window)
        told = [
            (event.command, str(event.answer), str(event.error))
            if isinstance(event, Request | WordBatch)
            else str(event)
            for event in self.events
        ]
        counters = [getattr(self.session.counters, name) for name in Counters.__slots__]
        return window, told, counters, self.sent, self.session._rest, self.session.deadline


def frames(host: Host, kinds: list[str]) -> list[bytes]:
    """Return the answers to the requests in flight, in order, each changed as its entry of `kinds` says."""
    codec, data = host.codec, []
    number = host.window.oldest
    for kind in kinds:
        run = host.window.find(number)
        while run is not None and run.posted and number != host.window.next:
            number = number + 1 & codec.id_count - 1
            run = host.window.find(number)
        command, identifier = (run.command if run is not None else "R"), codec.id_text[number]
        reply = as_gateway(codec, codec.lower[command] + identifier + b"%0*X" % (REPLIES[command] or 0, 0x5A))
        if not REPLIES[command]:
            reply = as_gateway(codec, codec.lower[command] + identifier)
        kinds_of_answers = {
            "whole": reply,
            "damaged": reply[:-3] + b"?" + reply[-2:],
            "lost": b"",
            "double": 2 * reply,
            "other ID": as_gateway(codec, b"r%02X0000005A" % (number + 3 & 0xFF)),
            "error": as_gateway(codec, b"x" + identifier + b"04"),
            "no session": codec.framing.checked(
                b"x" + identifier + b"0A%04X" % codec.residue(run.size if run else 0x20)
            ),
            "stray residue": codec.framing.checked(b"x" + identifier + b"0A5555"),
            "failed": as_gateway(codec, b"h" + identifier + b"01"),
            "whose": codec.framing.checked(b"K1234"),
            "another's": codec.framing.checked(b"K4321"),
            "out of sequence": as_gateway(codec, b"n" + identifier),
            "sample": as_gateway(codec, b"P010700000001"),
            # Frames with a correct CRC that are no valid answers, or valid answers in a rare form.
            "line end within": as_gateway(codec, codec.lower[command] + identifier + b"00\n00005"),
            "line end in front": as_gateway(codec, codec.lower[command] + identifier + b"\n000005A"),
            "plain": codec.framing.plain_reply(codec.lower[command] + identifier + b"0000005A"),
            "short": as_gateway(codec, codec.lower[command] + identifier + b"000005A"),
            "upper case": as_gateway(codec, codec.lower[command].upper() + identifier + b"0000005A"),
        }
        data.append(kinds_of_answers[kind])
        number = number + 1 & codec.id_count - 1
    return data


def pieces_of(answers: list[bytes], cuts: list[int] | None) -> list[bytes]:
    if cuts is None:
        return [answer for answer in answers if answer]
    data = b"".join(answers)
    ends = [*sorted({cut % (len(data) + 1) for cut in cuts} - {0}), len(data)]
    return [data[start:end] for start, end in zip([0, *ends], ends, strict=False) if start != end]


def assert_has_room_where_there_is_some(window: Window[Any]) -> None:
    for size, posted in ((8, False), (8, True), (60, False), (60, True)):
        assert window.has_room(size, posted=posted) == (window.room(size, posted=posted) > 0)


FENCED_BY_TIME = [Turn(["R", "R", "R", "fence", "fence", "WS", "R"], [], None, 0.0, cancelled=False)]
FENCED_BY_TIME += [Turn(["R"], [], None, 0.01, cancelled=True)]
"""The time-out sends the `h` after a posted write, which leaves space for the waiting read."""


@pytest.mark.parametrize("node", [None, 5], ids=["own medium", "shared medium"])
@settings(max_examples=examples(120))
@example(turns=FENCED_BY_TIME, before=[], credit=100)
@given(turns=turns, before=st.sampled_from([[], LOSS]), credit=st.sampled_from([None, None, 20, 100, 500]))
def test_consecutive_answers_have_the_result_of_line_by_line_decoding(
    node: int | None, turns: list[Turn], before: list[Turn], credit: int | None
) -> None:
    quick, slow = Host(Session, node, credit), Host(Slow, node, credit)
    now = 0.0
    for turn in before + turns:
        now += turn.seconds
        for host in (quick, slow):
            host.expire(now)
            host.ask(turn, now)
        arriving = pieces_of(frames(slow, turn.kinds), turn.cuts)
        for host in (quick, slow):
            host.hear(arriving, now)
        assert quick.state() == slow.state()
        if not slow.session.is_open or slow.window.loss.lost:
            break
        for host in (quick, slow):
            assert_has_room_where_there_is_some(host.window)


def test_consecutive_answers_have_a_code_path_of_their_own(monkeypatch: pytest.MonkeyPatch) -> None:
    """The comparison above needs two code paths: consecutive answers are taken without `_receive_line`."""
    host = Host(Session, None)
    host.ask(Turn(["R", "W", "RM", "small batch"], [], [], 0.0, cancelled=False), 0.0)
    monkeypatch.setattr(ResponseReceiver, "_receive_line", None)
    host.hear([b"".join(frames(host, ["whole"] * 8))], 0.0)
    assert [event.command for event in host.events] == ["R", "W", "RM", "R"]


def test_a_single_outstanding_request_has_code_paths_of_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    host = Host(Session, None)
    monkeypatch.setattr(Session, "submit", None)
    monkeypatch.setattr(Session, "receive", None)
    for command in ("R", "W", "RM", "H"):
        host.ask(Turn([command], [], [], 0.0, cancelled=False), 0.0)
        host.hear(frames(host, ["whole"]), 0.0)
    assert [event.command for event in host.events] == ["R", "W", "RM", "H"]


@pytest.mark.parametrize("kind", ["short", "line end within", "line end in front", "upper case", "plain", "damaged"])
@pytest.mark.parametrize("count", [1, 2])
def test_an_invalid_answer_has_the_result_of_line_by_line_decoding(kind: str, count: int) -> None:
    quick, slow = Host(Session, None), Host(Slow, None)
    for host in (quick, slow):
        host.ask(Turn(["R"] * count, [], [], 0.0, cancelled=False), 0.0)
        host.hear([b"".join(frames(host, [kind] * count))], 0.0)
    assert quick.state() == slow.state()

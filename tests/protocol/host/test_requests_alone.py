"""A single outstanding request takes a shorter code path in each direction; the result is that of the long path."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from support.searching import examples
from support.window_state import window_state
from unity_link.protocol.host.receiver import Counters
from unity_link.protocol.host.requests import Request
from unity_link.protocol.host.session import Session
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from unity_link.protocol.host.events import Events

FIELDS = {"R": (0x10,), "RM": (0x10, 3), "W": (0x10, 7), "WS": (0x10, 8), "H": ()}
WITHOUT_FLOW_CONTROL = ~Feature.FLOW_CONTROL & GatewayInfo().features
REPLY_DIGITS = {"R": 8, "RM": 24, "W": 0, "WS": None, "H": 3}


class Side:
    """A session and its gateway, with or without the shorter code paths."""

    def __init__(self, *, short: bool, info: GatewayInfo | None = None, takes_turns: bool = False) -> None:
        self.short = short
        self.session = Session(None, lambda: 0)
        self.gateway = VirtualGateway(GatewayInfo() if info is None else info)
        self.wire = self.sent = self.arriving = b""
        """Bytes to be sent next, all bytes sent, and bytes that the session has not received yet."""
        self.events: Events = []
        self.session.connect(1.0, 0.003, takes_turns=takes_turns)
        while not self.session.is_open:
            if takes_turns:
                self.session.take_turn(1.0)
            self.session.receive(self.gateway.receive(self.session.take_output(), 1.0), 1.0)

    def request(self, command: str) -> Request:
        codec = self.session.codec
        return Request(codec, command, codec.fields(command, *FIELDS[command]), REPLY_DIGITS[command])

    def ask(self, command: str, now: float) -> None:
        request = self.request(command)
        frame = self.session.submit_alone(request, now) if self.short and not request.posted else b""
        if frame:
            self.wire += frame
        else:
            self.events += self.session.submit(request, now)
            if self.session.window.has_one_request():
                # The session can submit no other request before the answer, so flush at once.
                self.wire += self.session.take_output()

    def hear(self, data: bytes, now: float) -> None:
        request = self.session.receive_alone(data, now) if self.short else None
        if request is None:
            self.events += self.session.receive(data, now)
        else:
            self.events.append(request)

    def do(self, step: Step, now: float) -> None:
        if step.what in FIELDS:
            self.ask(step.what, now)
        elif step.what == "round trip":
            for what in ("R", "send", "hear"):
                self.do(Step(what, 1, 0.0), now)
        elif step.what in {"send", "lose"}:
            data = self.wire + self.session.take_output()
            self.wire = b""
            self.sent += data
            if step.what == "send":
                self.arriving += self.gateway.receive(data, now)
        elif step.what == "damage":
            self.arriving = self.arriving[:-4] + b"?" + self.arriving[-3:] if self.arriving else b""
        elif step.what == "hear":
            # The first frame, all frames, or a number of bytes.
            size = {0: self.arriving.find(b"\n") + 1, 1: len(self.arriving)}.get(step.number, step.number)
            piece, self.arriving = self.arriving[:size], self.arriving[size:]
            if piece:
                self.hear(piece, now)
        else:
            self.events += self.session.expire(now)

    def state(self) -> object:
        window = window_state(self.session.window)
        told = [
            (event.command, str(event.answer), str(event.error)) if isinstance(event, Request) else str(event)
            for event in self.events
        ]
        counters = [getattr(self.session.counters, name) for name in Counters.__slots__]
        return window, told, counters, self.session._rest, self.session.deadline, self.sent, self.gateway.memory[0x10]


class Step(NamedTuple):
    """A request of the host, or an action of the medium."""

    what: str
    number: int
    seconds: float


steps = st.lists(
    st.builds(
        Step,
        st.sampled_from(
            [*FIELDS, "R", "R", *["send"] * 3, *["hear"] * 3, *["round trip"] * 3, "lose", "damage", "expire"]
        ),
        st.sampled_from([0, 0, 0, 1, 1, 5, 12]),
        st.sampled_from([0.0, 0.0, 0.0001, 0.002, 0.3, 1.0]),
    ),
    max_size=40,
)


LOSS = [Step("R", 0, 0.0), Step("lose", 0, 0.0), Step("expire", 0, 0.3), Step("send", 0, 0.0), Step("hear", 1, 0.0)]
"""One request is lost and retransmitted."""


@pytest.mark.slow
@settings(max_examples=examples(300))
@given(steps=steps, before=st.sampled_from([[], LOSS]))
@pytest.mark.parametrize("credit", [None, 64], ids=["flow control", "credit"])
def test_the_short_code_paths_have_the_result_of_the_long_ones(
    steps: list[Step], before: list[Step], credit: int | None
) -> None:
    info = GatewayInfo() if credit is None else GatewayInfo(receive_fifo_bytes=credit, features=WITHOUT_FLOW_CONTROL)
    short, long = Side(short=True, info=info), Side(short=False, info=info)
    now = 1.0
    for step in before + steps:
        now += step.seconds
        for side in (short, long):
            side.do(step, now)
        assert short.state() == long.state()


def test_a_request_is_not_sent_alone_if_the_output_has_frames() -> None:
    side = Side(short=True)
    side.ask("R", 1.0)
    answer = side.gateway.receive(side.wire, 1.0)
    side.hear(answer[:-3] + b"?" + answer[-2:], 1.0)
    # The retransmission is still in the output when the first answer arrives after all.
    side.hear(answer, 1.1)
    assert side.session.window.is_idle()
    assert side.session.output
    assert not side.session.submit_alone(side.request("R"), 1.1)


def test_a_request_is_not_sent_alone_if_others_wait_for_space() -> None:
    side = Side(short=True)
    side.session._waiting.append(side.request("W"))
    assert not side.session.submit_alone(side.request("R"), 1.0)


def test_a_request_is_not_sent_alone_without_a_turn() -> None:
    info = GatewayInfo(features=GatewayInfo().features | Feature.HALF_DUPLEX)
    side = Side(short=True, info=info, takes_turns=True)
    assert not side.session.submit_alone(side.request("R"), 1.0)


def test_an_empty_frame_follows_a_request_on_a_lossy_line() -> None:
    side = Side(short=True)
    for step in LOSS:
        side.do(step, 1.0 + step.seconds)
    assert side.session.window.is_idle()
    assert side.session.window.send_limit.loses
    assert side.session.submit_alone(side.request("R"), 1.9).endswith(b"\n\n")


def test_an_answer_after_an_incomplete_frame_is_not_taken_alone() -> None:
    side = Side(short=True)
    side.ask("R", 1.0)
    answer = side.gateway.receive(side.wire, 1.0)
    side.hear(answer[:4], 1.0)
    assert side.session.receive_alone(answer, 1.0) is None


def test_a_fence_follows_posted_writes_if_the_answer_before_them_is_late() -> None:
    short, long = Side(short=True), Side(short=False)
    for side in (short, long):
        for what, now in (("R", 1.0), ("WS", 1.0), ("send", 1.0), ("hear", 1.002), ("send", 1.002)):
            side.do(Step(what, 0, 0.0), now)
    assert short.state() == long.state()
    assert b"h" in short.sent.splitlines()[-1][:1]


@pytest.mark.parametrize("behind", ["R", "WS"])
def test_waiting_requests_are_sent_when_an_answer_frees_space(behind: str) -> None:
    info = GatewayInfo(receive_fifo_bytes=20, features=WITHOUT_FLOW_CONTROL)
    short, long = Side(short=True, info=info), Side(short=False, info=info)
    for side in (short, long):
        for command in ("R", behind, behind):
            side.ask(command, 1.0)
        for _ in range(4):
            side.do(Step("send", 0, 0.0), 1.0)
            side.do(Step("hear", 0, 0.0), 1.0)
    assert short.state() == long.state()
    assert not short.session._waiting

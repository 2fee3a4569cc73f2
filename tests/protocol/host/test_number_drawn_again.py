"""A host that was idle checks that the open session is its own before it sends its next request.

Another program may have opened a session with the same random number. All CRCs then match, and the gateway would
acknowledge a request of the idle host as a repetition that it need not execute.
"""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import unity_link
from support.recorded_bus import RecordedBus
from support.shared_pair import PAIR, SharedPair
from support.simulated_time import on_simulated_time
from unity_link.errors import GatewayResetError, LinkLostError, Outcome
from unity_link.protocol.host.batches import RequestBlock, WordBatch
from unity_link.protocol.host.events import Interrupted, Opened, Taken, Unusable
from unity_link.protocol.host.requests import Confirmation, Request
from unity_link.protocol.host.session import Session
from unity_link.protocol.window.constants import KEEP_ALIVE, MOST_TRIES
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.messages import GroupFlag
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from unity_link.protocol.host.events import Events
    from unity_link.protocol.host.requests import Source

RING = 256
ADDRESS = 0x10
IDLE = 10.0
"""Seconds since the last answer; longer than `KEEP_ALIVE`."""


class Line:
    """A session, its gateway and the line between them, which loses the frames with chosen numbers."""

    def __init__(self, *, resumes: bool = False) -> None:
        self.session = Session(None, lambda: 0, resumes=resumes)
        self.gateway = VirtualGateway(GatewayInfo(id_digits=2))
        self.bus = RecordedBus(self.gateway)
        self.events: Events = []
        self.sent: list[bytes] = []
        """Frames of the host, in order."""
        self.lost: set[int] = set()
        """Frames of both directions that are lost, counted from 0."""
        self._count = 0
        self.session.connect(0.0, 0.003)
        self.exchange(0.0)
        assert self.session.is_open
        self.events.clear()
        self.sent.clear()
        self._count = 0

    def exchange(self, now: float) -> None:
        """Carry frames in both directions until the host has no more output."""
        while data := self.session.take_output():
            for frame in data.splitlines(keepends=True):
                self.sent.append(frame)
                if self._arrives():
                    for answer in self.gateway.receive(frame, now).splitlines(keepends=True):
                        if self._arrives():
                            self.events += self.session.receive(answer, now)

    def _arrives(self) -> bool:
        self._count += 1
        return self._count - 1 not in self.lost

    def pass_time(self, now: float, until: float) -> None:
        """Let the session's deadlines expire until an instant."""
        while (deadline := self.session.deadline) is not None and deadline <= until:
            now = max(now, deadline)
            self.events += self.session.expire(now)
            self.exchange(now)

    def request(self, command: str, *fields: int) -> Request:
        codec = self.session.codec
        return Request(codec, command, codec.fields(command, *fields), codec.data_digits if command == "R" else 0)

    def submit(self, source: Any, now: float) -> Any:
        self.events += self.session.submit(source, now)
        self.exchange(now)
        return source

    def hold_a_group(self) -> None:
        group = self.session.groups.hold(
            self.session.codec.fields("GS", 0, int(GroupFlag.PERIODIC), 0xFFFF, 1, [ADDRESS])[2:], 12, None
        )
        self.events += self.session.start(group, 0.0)
        self.exchange(0.0)
        self.sent.clear()

    def ends(self) -> list[type]:
        """Return the types of the events about the session itself."""
        return [type(event) for event in self.events if isinstance(event, Interrupted | Taken | Opened | Unusable)]

    def draw_again(self, ahead: int) -> None:
        """Have another program open a session with the host's number; its next ID is `ahead` after the host's."""
        number = self.session.codec.session
        self.gateway.begin(number % 100 + 1, 0)
        self.gateway.begin(number, self.session.window.next + ahead & RING - 1)


def outcome_of(source: Any) -> Outcome:
    assert isinstance(source.error, LinkLostError)
    return source.error.outcome


def heads(frames: list[bytes]) -> list[bytes]:
    return [frame[:3] for frame in frames]


@pytest.mark.parametrize("has_group", [False, True])
@pytest.mark.parametrize("ahead", range(1, RING))
def test_a_write_of_an_idle_host_acts_in_no_session_of_the_same_number(ahead: int, *, has_group: bool) -> None:
    line = Line()
    if has_group:
        line.hold_a_group()
    line.draw_again(ahead)
    write = line.request("W", ADDRESS, 7)
    if has_group:
        line.pass_time(0.0, KEEP_ALIVE)
    else:
        line.submit(write, IDLE)
    assert line.ends() == [Taken]
    assert has_group or outcome_of(write) is Outcome.NOT_EXECUTED
    assert line.bus.writes == []


def test_an_idle_host_sends_its_next_request_after_one_exchange() -> None:
    line = Line()
    write = line.submit(line.request("W", ADDRESS, 7), IDLE)
    assert heads(line.sent) == [b"KF9", b"h7F", b"h00", b"w01"]
    assert (write.error, line.bus.writes) == (None, [(ADDRESS, 7)])
    counters, window = line.session.counters, line.session.window
    assert (line.ends(), counters.repetitions, counters.timeouts, window.send_limit.loses) == ([], 0, 0, False)


def test_a_host_that_was_answered_within_a_second_sends_its_request_at_once() -> None:
    line = Line()
    for now in (0.9, 1.8, 2.7):
        line.submit(line.request("W", ADDRESS, 7), now)
    assert heads(line.sent) == [b"w00", b"w01", b"w02"]


def test_a_ping_is_answered_by_the_proof_of_the_session() -> None:
    line = Line()
    ping = line.submit(Confirmation(line.session.codec, of_session=True), IDLE)
    assert ping.done
    assert heads(line.sent) == [b"KF9", b"h7F", b"h00"]


@pytest.mark.parametrize("lost", range(1 << 6))
def test_a_proof_of_the_session_survives_the_loss_of_any_of_its_frames(lost: int) -> None:
    line = Line()
    line.lost = {place for place in range(6) if lost >> place & 1}
    write = line.submit(line.request("W", ADDRESS, 7), IDLE)
    line.pass_time(IDLE, IDLE + 0.5)
    assert (line.ends(), write.done, write.error, line.bus.writes) == ([], True, None, [(ADDRESS, 7)])


def test_a_host_with_groups_proves_its_session_each_second() -> None:
    line = Line()
    line.hold_a_group()
    line.pass_time(0.0, 2.5 * KEEP_ALIVE)
    assert heads(line.sent) == [b"KF9", b"h81", b"h02", b"KF9", b"h82", b"h03"]
    assert line.ends() == []


def test_requests_made_during_a_proof_wait_for_it() -> None:
    line = Line()
    line.hold_a_group()
    line.lost = set(range(100))
    line.pass_time(0.0, KEEP_ALIVE)
    write = line.request("W", ADDRESS, 7)
    assert line.session.submit_alone(write, KEEP_ALIVE) == b""
    line.submit(write, KEEP_ALIVE)
    assert not write.sent
    line.lost.clear()
    line.pass_time(KEEP_ALIVE, 1.5 * KEEP_ALIVE)
    assert line.bus.writes == [(ADDRESS, 7)]


def test_a_host_without_an_answer_n_leaves_the_gateway_to_another_program() -> None:
    """The gateway has already reported the gap, so it does not answer requests that are ahead."""
    line = Line()
    line.draw_again(RING // 4)
    number = line.session.codec.session
    ahead = line.session.codec.request("H", RING // 4 + 9, b"", 2 * number)
    assert line.gateway.receive(ahead, 0.0).startswith(b"n40")
    write = line.submit(line.request("W", ADDRESS, 7), IDLE)
    assert line.ends() == [Taken]
    assert outcome_of(write) is Outcome.NOT_EXECUTED
    assert line.bus.writes == []
    assert heads(line.sent).count(b"KF9") == MOST_TRIES + 1


@pytest.mark.parametrize("ahead", [3, RING // 2 - 1, RING // 2 + 1, RING // 2 + 3])
def test_an_n_outside_of_the_window_ends_a_busy_host(ahead: int) -> None:
    line = Line()
    line.draw_again(ahead)
    requests = [line.request("W", ADDRESS, word) for word in range(2)]
    requests[1].given_up = False
    for request in requests:
        line.events += line.session.submit(request, 0.5)
    line.exchange(0.5)
    is_ahead = ahead > RING // 2
    assert line.ends() == ([Taken] if is_ahead else [])
    assert [request.done for request in requests] == [True, True]
    assert not is_ahead or outcome_of(requests[0]) is Outcome.UNKNOWN


def sources(line: Line) -> list[Source]:
    """Return requests of every kind: three that write, two that read."""
    codec = line.session.codec
    words = np.arange(2)
    return [
        line.request("W", ADDRESS, 1),
        RequestBlock([line.request("W", ADDRESS, 2), line.request("W", ADDRESS, 3)]),
        WordBatch(codec, "W", [(words, codec.info.address_digits), (words, codec.data_digits)]),
        line.request("R", ADDRESS),
        WordBatch(codec, "R", [(words, codec.info.address_digits)]),
    ]


@pytest.mark.parametrize("resumes", [False, True])
def test_a_reset_that_a_proof_finds_ends_the_requests_that_waited(*, resumes: bool) -> None:
    line = Line(resumes=resumes)
    waiting = sources(line)
    for source in waiting:
        line.events += line.session.submit(source, IDLE)
    line.gateway.reset()
    line.exchange(IDLE)
    assert line.ends() == [Interrupted, Opened]
    assert line.bus.writes == []
    lost = [source for source in waiting if isinstance(getattr(source, "error", None), GatewayResetError)]
    assert all(outcome_of(source) is Outcome.NOT_EXECUTED for source in lost)
    assert len(lost) == (2 if resumes else 4)
    assert [source.done for source in waiting[3:] if isinstance(source, Request | WordBatch)] == [True, True]


def test_a_write_submitted_on_a_lost_line_is_not_kept_for_the_next() -> None:
    line = Line(resumes=True)
    write = line.request("W", ADDRESS, 7)
    line.events += line.session.submit(write, IDLE)
    line.session.take_output()
    line.events += line.session.disconnect("the line was lost")
    assert outcome_of(write) is Outcome.NOT_EXECUTED
    line.session.connect(IDLE, 0.003)
    line.exchange(IDLE)
    assert line.session.is_open
    assert line.bus.writes == []


@pytest.mark.parametrize("number_is_drawn_again", [False, True])
@on_simulated_time
async def test_a_proof_takes_its_turns_on_a_half_duplex_line(*, number_is_drawn_again: bool) -> None:
    gateway = VirtualGateway(PAIR)
    bus, pair = RecordedBus(gateway), SharedPair(gateway)
    async with unity_link.connect(pair) as link:
        await link.write(1, 1)
        await asyncio.sleep(2 * KEEP_ALIVE)
        if number_is_drawn_again:
            number, expected = gateway.session, gateway.expected
            gateway.begin(number % 100 + 1, 0)
            gateway.begin(number, expected + 100)
            with pytest.raises(LinkLostError, match="another program"):
                await link.write(1, 2)
        else:
            await link.write(1, 2)
    assert bus.writes == [(1, 1)] if number_is_drawn_again else [(1, 1), (1, 2)]
    assert pair.collisions == []

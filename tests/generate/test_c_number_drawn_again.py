"""After an idle second, the generated client in C proves that the session is its own, as the Python host does."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from generate.programs import Simulated
from support.recorded_bus import RecordedBus
from support.shared_pair import PAIR
from unity_link.protocol.window.constants import MOST_TRIES
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from pathlib import Path

RING = 256
ADDRESS = 0x10
ANOTHER = "another program has begun a session"
COMPACT = GatewayInfo(id_digits=2, features=GatewayInfo().features | Feature.COMPACT)
TEXT = GatewayInfo(id_digits=2)


class Line:
    """A client on simulated time, its gateway, and the frames that the client sends."""

    def __init__(self, driver: Path, info: GatewayInfo = TEXT, *, echoes: bool = False) -> None:
        self.gateway = VirtualGateway(info)
        self.bus = RecordedBus(self.gateway)
        self.sent: list[bytes] = []
        self.lost: set[int] = set()
        """Numbers of the frames that are lost, counted from 0 over both directions."""
        self._count = 0
        self._echoes = echoes
        self.client = Simulated(driver, self._carry)
        self.client.words("connect test:0.003 5")
        self.forget()

    def _carry(self, data: bytes, now: float) -> bytes:
        back = [data] if self._echoes else []
        for frame in data.splitlines(keepends=True):
            self.sent.append(frame)
            if self._arrives():
                answers = self.gateway.receive(frame, now).splitlines(keepends=True)
                back += [answer for answer in answers if self._arrives()]
        return b"".join(back)

    def _arrives(self) -> bool:
        self._count += 1
        return self._count - 1 not in self.lost

    def forget(self) -> None:
        self.sent.clear()
        self._count = 0

    def idle(self) -> None:
        """Let two seconds pass."""
        self.client.words("poll 2")
        self.forget()

    def draw_again(self, ahead: int) -> None:
        """Begin another session with the same number, whose next ID is `ahead` of the client's."""
        number, expected = self.gateway.session, self.gateway.expected
        self.gateway.begin(number % 100 + 1, 0)
        self.gateway.begin(number, expected + ahead & RING - 1)

    def write(self, word: int = 7) -> str:
        return self.client(f"write {ADDRESS:X} {word:X}")


@pytest.mark.parametrize("info", [TEXT, COMPACT], ids=["text", "compact"])
@pytest.mark.parametrize("ahead", [1, 2, RING // 4, *range(RING // 2 - 3, RING // 2 + 3), RING - 2, RING - 1])
def test_no_write_of_an_idle_client_acts_in_a_session_of_the_same_number(
    driver: Path, ahead: int, info: GatewayInfo
) -> None:
    line = Line(driver, info)
    with line.client:
        line.idle()
        line.draw_again(ahead)
        answer = line.write()
    assert ANOTHER in answer
    assert "known not to be executed" in answer
    assert line.bus.writes == []


@pytest.mark.parametrize("echoes", [False, True])
def test_an_idle_client_sends_its_next_request_after_one_exchange(driver: Path, *, echoes: bool) -> None:
    line = Line(driver, echoes=echoes)
    with line.client:
        line.idle()
        assert line.write() == "0"
        first = int(line.sent[2][1:3], 16)
        heads = [
            b"KF9",
            b"h%02X" % (first + RING // 2 - 1 & RING - 1),
            b"h%02X" % first,
            b"w%02X" % (first + 1 & RING - 1),
        ]
        assert [frame[:3] for frame in line.sent] == heads
        line.forget()
        assert line.write(8) == "0"
        assert [frame[:1] for frame in line.sent] == [b"w"]
        *_, repetitions, timeouts, damaged, _ = line.client.words("statistics")
    assert (repetitions, timeouts, damaged) == (0, 0, 0)
    assert line.bus.writes == [(ADDRESS, 7), (ADDRESS, 8)]


@pytest.mark.parametrize("lost", range(1, 1 << 6, 3))
def test_proof_of_a_session_succeeds_whichever_of_its_frames_are_lost(driver: Path, lost: int) -> None:
    line = Line(driver)
    with line.client:
        line.idle()
        line.lost = {place for place in range(6) if lost >> place & 1}
        assert line.write() == "0"
    assert line.bus.writes == [(ADDRESS, 7)]


def test_a_client_that_holds_a_group_proves_its_session_each_second(driver: Path) -> None:
    line = Line(driver)
    with line.client:
        line.client.words(f"subscribe 0 2 - {ADDRESS:X}")
        line.forget()
        line.client.words("poll 2.5")
        assert [frame[:1] for frame in line.sent] == [b"K", b"h", b"h"] * 2
        line.draw_again(RING // 4)
        assert ANOTHER in line.client("poll 2.5")


def test_a_client_leaves_a_gateway_that_never_answers_n(driver: Path) -> None:
    line = Line(driver)
    with line.client:
        line.idle()
        line.draw_again(RING // 4)
        line.gateway._sequence.gap_reported = True
        assert ANOTHER in line.write()
    assert [frame[:1] for frame in line.sent].count(b"K") == MOST_TRIES + 1
    assert line.bus.writes == []


@pytest.mark.parametrize("number_is_drawn_again", [False, True])
def test_client_on_a_pair_of_wires_sends_one_frame_at_a_time(driver: Path, *, number_is_drawn_again: bool) -> None:
    line = Line(driver, PAIR)
    with line.client:
        line.idle()
        if number_is_drawn_again:
            line.draw_again(RING // 4)
        answer = line.write()
    kinds = [frame[:1] for frame in line.sent]
    if number_is_drawn_again:
        assert ANOTHER in answer
        assert line.bus.writes == []
        assert kinds == [b"h"]
    else:
        assert answer == "0"
        assert kinds == [b"h", b"h", b"w"]


def test_an_n_outside_of_the_window_ends_a_busy_client(driver: Path) -> None:
    line = Line(driver)
    with line.client:
        assert line.write() == "0"
        line.draw_again(RING // 2 + 1)
        assert ANOTHER in line.write()
    assert line.bus.writes == [(ADDRESS, 7)]

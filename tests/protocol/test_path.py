"""The length of the datagrams of a session: the trial at its opening, and its end if long frames are lost."""

from __future__ import annotations

import pytest

from unity_link.protocol.host.events import Unusable
from unity_link.protocol.host.requests import Request
from unity_link.protocol.host.session import Session
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.frames import LF
from unity_link.protocol.wire.path import HEADER_SIZE, HEADERS_6, LENGTHS, TRIES, Path
from unity_link.virtual import VirtualGateway

LATER = 0.001
"""Seconds until an answer arrives."""


class Opening:
    """A session during its handshake with a gateway.

    Args:
        path: the network.
        info: configuration of the gateway.
    """

    def __init__(self, path: Path, info: GatewayInfo | None = None) -> None:
        self.session = Session(None, lambda: 0x300)
        self.now = 0.0
        self._gateway = VirtualGateway(info or GatewayInfo())
        self.session.connect(self.now, 0.003, longest_try=0.2, is_transparent=True, path=path)
        while not (asked := self.session.take_output()).startswith(b"K"):
            self.answer(asked)
        self.asked = asked
        """Bytes of the last request that opens a session."""

    def answer(self, asked: bytes) -> None:
        """Deliver a request to the gateway, and its answer to the session."""
        self.now += LATER
        self.session.receive(self._gateway.receive(asked, self.now), self.now)

    def lose(self) -> None:
        """Let the time pass until the session sends its request again."""
        assert self.session.deadline is not None
        self.now = self.session.deadline
        self.session.expire(self.now)
        self.asked = self.session.take_output()


def datagram_with(frames: bytes) -> int:
    return HEADER_SIZE + len(b"0000") + len(LF) + len(frames)


def test_each_length_is_tried_twice_and_the_shortest_without_end() -> None:
    opening = Opening(Path())
    tried = []
    for _ in range(10):
        tried.append(datagram_with(opening.asked))
        assert not opening.asked.strip(LF).count(LF)
        opening.lose()
    assert tried == [*(length for length in LENGTHS for _ in range(TRIES)), *[LENGTHS[-1]] * 4]


def test_a_late_answer_shows_that_its_length_was_carried() -> None:
    path = Path()
    opening = Opening(path)
    first = opening.asked
    for _ in range(TRIES):
        opening.lose()
    assert path.largest == LENGTHS[1]
    opening.answer(first)
    assert path.largest == LENGTHS[0]
    opening.answer(opening.asked)
    assert opening.session.is_open
    assert not path.is_short


@pytest.mark.parametrize("mtu", [576, 1280, 1428, 1500])
def test_an_mtu_that_was_given_is_not_lowered(mtu: int) -> None:
    path = Path(mtu)
    path.begin(HEADERS_6, 1500)
    opening = Opening(path)
    path.lower(600)
    for _ in range(5):
        assert datagram_with(opening.asked) == min(mtu - HEADERS_6, LENGTHS[0])
        opening.lose()


def test_no_opening_is_longer_than_the_receive_fifo_of_a_gateway() -> None:
    info = GatewayInfo(features=GatewayInfo().features & ~Feature.FLOW_CONTROL, receive_fifo_bytes=200)
    assert len(Opening(Path(), info).asked) == 200


def test_an_mtu_reported_by_the_system_limits_blocks_and_answers_at_once() -> None:
    path = Path()
    opening = Opening(path)
    opening.answer(opening.asked)
    window = opening.session.window
    assert window.room(20, reply_size=500) > 1
    path.lower(600)
    assert path.mtu == 600
    assert GatewayInfo().block_words_in(path.longest_frame) == 65
    assert window.room(20, reply_size=500) == 1
    assert window.most_room(20, 100) == 4


def test_the_error_after_silence_names_the_option_for_short_packets() -> None:
    path = Path()
    opening = Opening(path)
    opening.answer(opening.asked)
    session = opening.session
    events = session.submit(Request(session.codec, "RM", session.codec.fields("RM", 0, 160), 160 * 8), opening.now)
    while not events:
        assert session.deadline is not None
        events = session.expire(session.deadline)
    (end,) = events
    assert isinstance(end, Unusable)
    assert "if the network loses long packets, mtu=576 in the URL keeps them short" in str(end.error)
    # The opening proved that long datagrams reach the gateway, so the path back may be the one that loses them.
    session.disconnect("the end")
    session.connect(10.0, 0.003, path=(following := Path()))
    assert following.largest == path.largest == LENGTHS[1]

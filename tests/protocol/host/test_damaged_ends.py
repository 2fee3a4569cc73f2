"""Damage to the end of an answer: the result does not depend on the offsets at which reads are cut."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from support.open_at_once import open_at_once
from support.valve import as_gateway
from unity_link.protocol.host.batches import WordBatch
from unity_link.protocol.host.requests import Request
from unity_link.protocol.host.session import Session
from unity_link.protocol.wire.configuration import GatewayInfo

SHORT = GatewayInfo(id_digits=2)
"""A CRC of 8 bits passes one damaged frame in 256, and some of these frames only if reads are cut in a certain way."""
LONG = GatewayInfo(data_bits=64, crc_bits=32, crc_polynomial=0x04C11DB7)
WORDS = 3
REPLIES = {"R": 1, "W": 0, "RM": WORDS, "H": 0}


class Fate(NamedTuple):
    """What happens to an answer on its way to the host."""

    kind: str
    place: int
    byte: int


class Host:
    """A session with requests in flight, and the bytes of their answers."""

    def __init__(self, info: GatewayInfo, node: int | None, commands: list[str]) -> None:
        self.session = session = Session(None, lambda: 0)
        self.reader = open_at_once(session, info, node, 0x34)
        self.window, self.counters = session.window, session.counters
        self.codec = codec = session.codec
        self.answers: list[bytes] = []
        self.events: list[Any] = []
        for number, command in enumerate(commands):
            digits = info.id_digits if command == "H" else info.data_digits * REPLIES[command]
            self.events += session.submit(Request(codec, command, b"", digits), 0.0)
            body = (
                codec.lower[command] + codec.id_text[number] + (b"%0*X" % (info.data_digits, number) * WORDS)[:digits]
            )
            self.answers.append(as_gateway(codec, body))

    def ask_many(self, count: int) -> WordBatch:
        """Submit a batch of reads whose answers are their numbers."""
        codec, first = self.codec, self.window.next
        batch = WordBatch(codec, "R", [(np.zeros(count, np.uint8), codec.info.address_digits)])
        self.events += self.session.submit(batch, 0.0)
        self.answers += [
            as_gateway(codec, b"r%b%0*X" % (codec.id_text[first + place], codec.data_digits, 1 + place))
            for place in range(count)
        ]
        return batch

    def sample(self) -> bytes:
        return as_gateway(self.codec, b"P0107" + b"5" * self.codec.data_digits)

    def hear(self, pieces: list[bytes]) -> object:
        """Pass bytes to the reader, without carrying out the events; return all visible results."""
        rest = b""
        for piece in pieces:
            data = rest + piece
            rest = data[self.reader.receive(data, 0.0, self.events) :]
        counters = self.counters
        delivered = [
            "batch"
            if isinstance(event, WordBatch)
            else (
                event.first,
                None if event.answer is None else event.answer if isinstance(event.answer, int) else "words",
            )
            if isinstance(event, Request)
            else event.body
            for event in self.events
        ]
        return delivered, counters.damaged, counters.responses, rest, self.window.retransmission.is_due()

    def spoil(self, fates: list[Fate]) -> bytes:
        arrived = b""
        for answer, fate in zip(self.answers, fates, strict=True):
            place = fate.place % len(answer)
            if fate.kind == "end":
                arrived += answer[:-1] + bytes([fate.byte])
            elif fate.kind == "byte":
                arrived += answer[:place] + bytes([fate.byte]) + answer[place + 1 :]
            elif fate.kind == "lost end":
                arrived += answer[:-1]
            elif fate.kind == "lost byte":
                arrived += answer[:place] + answer[place + 1 :]
            elif fate.kind == "sample":
                arrived += self.sample() + answer
            elif fate.kind == "endless sample":
                arrived += self.sample()[:-1] + bytes([fate.byte]) + answer
            elif fate.kind == "double":
                arrived += 2 * answer
            elif fate.kind == "whole":
                arrived += answer
        return arrived


KINDS = ["whole", "end", "byte", "lost end", "lost byte", "lost", "sample", "endless sample", "double"]
byte_values = st.integers(0, 255) | st.sampled_from([*b"rPXnx\n\r"])
answered = st.lists(
    st.tuples(st.sampled_from([*REPLIES]), st.builds(Fate, st.sampled_from(KINDS), st.integers(0, 99), byte_values)),
    min_size=1,
    max_size=12,
)


@pytest.mark.parametrize(
    ("info", "node"),
    [(GatewayInfo(), None), (GatewayInfo(), 5), (SHORT, None), (LONG, None)],
    ids=["usual", "addressed", "short", "long"],
)
@given(arriving=answered, cuts=st.lists(st.integers(0, 999), max_size=8))
def test_the_result_of_damaged_answers_does_not_depend_on_the_cuts(
    info: GatewayInfo, node: int | None, arriving: list[tuple[str, Fate]], cuts: list[int]
) -> None:
    commands, fates = [command for command, _ in arriving], [fate for _, fate in arriving]
    together, apart, byte_by_byte = (Host(info, node, commands) for _ in range(3))
    stream = together.spoil(fates)
    ends = sorted({cut % (len(stream) + 1) for cut in cuts} | {len(stream)})
    expected = together.hear([stream])
    assert apart.hear([stream[start:end] for start, end in zip([0, *ends], ends, strict=False)]) == expected
    assert byte_by_byte.hear([stream[place : place + 1] for place in range(len(stream))]) == expected


fates = st.builds(Fate, st.sampled_from(KINDS), st.integers(0, 99), byte_values)
many_fates = st.lists(
    st.lists(fates, max_size=3) | st.lists(st.just(Fate("whole", 0, 0)), max_size=30), max_size=6
).map(lambda parts: [fate for part in parts for fate in part])


@pytest.mark.parametrize("node", [None, 5], ids=["usual", "addressed"])
@given(arriving=many_fates, cuts=st.lists(st.integers(0, 3999), max_size=8))
def test_the_result_of_a_damaged_batch_does_not_depend_on_the_cuts(
    node: int | None, arriving: list[Fate], cuts: list[int]
) -> None:
    seen = []
    for way in ("together", "apart", "byte by byte"):
        host = Host(GatewayInfo(), node, ["W"])
        batch = host.ask_many(len(arriving) or 1)
        stream = host.spoil([Fate("whole", 0, 0), *(arriving or [Fate("whole", 0, 0)])])
        ends = {"together": [], "apart": cuts, "byte by byte": range(len(stream))}[way]
        places = sorted({cut % (len(stream) + 1) for cut in ends} | {len(stream)})
        told = host.hear([stream[start:end] for start, end in zip([0, *places], places, strict=False)])
        seen.append((told, batch.answer.tolist(), batch.done))
    assert seen[0] == seen[1] == seen[2]


@pytest.mark.parametrize("node", [None, 5], ids=["usual", "addressed"])
@pytest.mark.parametrize("command", [*REPLIES])
def test_an_answer_with_a_damaged_end_is_rejected_at_its_last_byte(command: str, node: int | None) -> None:
    host = Host(GatewayInfo(), node, [command])
    (answer,) = host.answers
    host.hear([answer[:-1]])
    assert (host.counters.damaged, host.window.retransmission.is_due()) == (0, False)
    host.reader.receive(answer[:-1] + b"\x0b", 0.0, host.events)
    assert (host.counters.damaged, host.window.retransmission.is_due(), host.events) == (1, True, [])


def test_an_answer_after_one_with_a_damaged_end_is_accepted() -> None:
    host = Host(GatewayInfo(), None, ["R", "RM", "W"])
    stream = b"".join(answer[:-1] + b"\x0b" for answer in host.answers[:2]) + host.answers[2]
    host.hear([stream])
    assert [event.command for event in host.events] == ["W"]
    assert host.counters.damaged == 2


def test_a_frame_too_long_for_its_request_is_damaged_even_if_plain() -> None:
    host = Host(GatewayInfo(), None, ["R", "R"])
    host.hear([host.answers[0][:-1] + b"?" + host.answers[1][:-2] + b"\r\n"])
    assert (host.events, host.counters.damaged, host.window.retransmission.is_due()) == ([], 1, True)


def test_an_answer_without_its_line_end_is_rejected() -> None:
    host = Host(GatewayInfo(), None, ["R", "R"])
    host.hear([host.answers[0][:-1], b"", host.answers[1]])
    assert [event.first for event in host.events] == []


def test_an_answer_after_a_sample_with_a_damaged_end_is_accepted() -> None:
    host = Host(GatewayInfo(), None, ["R"])
    host.hear([host.sample()[:-1] + b"\x0b" + host.answers[0]])
    assert [event.first for event in host.events] == [0]


def test_an_error_frame_damaged_into_a_sample_is_a_sign_of_loss() -> None:
    host = Host(GatewayInfo(), None, ["R"])
    host.reader.receive(b"P01D488\n", 0.0, host.events)
    assert host.window.retransmission.is_due()

"""To its clients, the server of a shared link is a gateway: it answers as the test vectors and the document state."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any
from unittest.mock import patch

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from support.searching import examples
from support.sharing import call, settle, sharing, tell_of_reset
from support.simulated_time import on_simulated_time, run_simulated
from support.worked_examples import Example, worked_examples
from unity_link.bridges.serve import connection
from unity_link.bridges.serve.connection import MOST_UNDER_WAY
from unity_link.bridges.serve.conversation import Conversation
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.messages import Codec, ErrorCode
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing

if TYPE_CHECKING:
    from unity_link.bridges.serve.shared import SharedLink

FOLDER = Path(__file__).resolve().parents[1] / "vectors"
FILES = [
    path for path in sorted(FOLDER.glob("*.ndjson")) if path.stem not in {"addressed", "compact", "compact_addressed"}
]


def in_words_of(shared: SharedLink, text: bytes) -> bytes:
    """Return an answer of the gateway with the configuration that the server reports instead."""
    assert shared.codec is not None
    inner, outer = shared.gateway.to_hex(), shared.codec.info.to_hex()
    if inner not in text:
        return text
    lines = []
    for line in text.split(b"\n"):
        if inner in line and not line.endswith(b"\r"):
            lines.append(shared.codec.framing.checked(b"Q" + outer)[:-1])
        else:
            lines.append(line.replace(inner, outer))
    return b"\n".join(lines)


def parted(answer: bytes) -> tuple[bytes, list[bytes]]:
    """Return the responses and the samples of an answer, each in their order."""
    frames = answer.splitlines(keepends=True)
    return (
        b"".join(frame for frame in frames if not frame.startswith(b"P")),
        [frame for frame in frames if frame.startswith(b"P")],
    )


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_vector_is_answered_byte_for_byte(path: Path) -> None:
    header, *steps = map(json.loads, path.read_text().splitlines())
    values = header["configuration"]
    gateway = VirtualGateway(GatewayInfo(**{**values, "features": Feature(values["features"])}))
    gateway.attach(Failing(ErrorCode.BUS_ERROR), header["bus_error"])
    gateway.attach(Failing(ErrorCode.BUS_TIMEOUT), header["bus_timeout"])

    @on_simulated_time
    async def play() -> None:
        async with sharing(gateway) as shared:
            terminal = call(shared)
            for step in steps:
                terminal.transport.write(step["send"].encode("latin-1"))
                await settle(shared)
                answers, publishes = parted(terminal.take())
                assert answers == in_words_of(shared, step["answers"].encode("latin-1")), step
                assert publishes == step.get("publishes", "").encode("latin-1").splitlines(keepends=True), step

    play()


@pytest.mark.parametrize("example", [e for e in worked_examples() if e.node is None], ids=lambda e: f"line {e.line}")
def test_every_worked_example_of_the_protocol_holds(example: Example) -> None:
    gateway = VirtualGateway()
    gateway.memory.update(example.memory)
    gateway.attach(Failing(ErrorCode.BUS_ERROR), example.bus_errors)
    gateway.attach(Failing(ErrorCode.BUS_TIMEOUT), example.bus_timeouts)

    @on_simulated_time
    async def play() -> None:
        async with sharing(gateway) as shared:
            terminal = call(shared)
            for sent, answered in example.exchange:
                terminal.transport.write(sent)
                await settle(shared)
                assert terminal.take() == in_words_of(shared, answered), sent

    play()


def damage_apart(answer: bytes) -> tuple[list[bytes], int]:
    """Return the answers to requests in their order, and the number of reports of damaged frames.

    A damaged frame has no place in the order of requests: the server reports it at once, which may be before or after
    the
    gateway has refused a posted write.
    """
    frames = answer.splitlines(keepends=True)
    requests = [frame for frame in frames if not frame.startswith(b"X")]
    return requests, len(frames) - len(requests)


CODEC = Codec(GatewayInfo())
OPERATIONS = st.tuples(
    st.sampled_from(["R", "W", "WS", "H", "K", "reset"]),
    st.sampled_from([0, 0, 0, -1, 1, -20, 20]),
    st.sampled_from([1, 1, 5, 20]),
    st.sampled_from([bytes, bytes, bytes.lower, lambda text: text[:-2] + b"0\n", lambda text: text[:-1] + b"\r"]),
)


def requests(command: str, first: int, count: int) -> list[bytes]:
    """Return requests with consecutive IDs, to addresses around the failing one."""
    fields = {"R": (), "H": None}.get(command, (1,))
    values = [() if fields is None else (number % 9, *fields) for number in range(first, first + count)]
    return [
        CODEC.request(command, number % CODEC.id_count, CODEC.fields(command, *value))
        for number, value in enumerate(values, first)
    ]


async def hold_conversation(operations: list[tuple[Any, ...]]) -> tuple[list[bytes], dict[int, int]]:
    """Return the bytes that a client receives after each operation, and the words that were written."""
    gateway = VirtualGateway()
    gateway.attach(Failing(), [7])
    heard = []
    async with sharing(gateway) as shared:
        terminal = call(shared)
        expected = 0
        for command, offset, count, spelling in operations:
            first = expected + offset
            if command == "reset":
                await tell_of_reset(shared, gateway, terminal)
            elif command == "K":
                expected = first % CODEC.id_count
                terminal.transport.write(b"K%b\r" % CODEC.id_text[expected])
            else:
                terminal.transport.write(spelling(b"".join(requests(command, first, count))))
                expected += count if offset == 0 else 0
            await settle(shared)
            heard.append(terminal.take())
    return heard, dict(gateway.memory)


@settings(max_examples=examples(60))
@given(st.lists(OPERATIONS, max_size=12))
def test_the_short_ways_of_single_words_answer_as_the_long_way(operations: list[tuple[Any, ...]]) -> None:
    begun = [("K", 0, 1, bytes), *operations]
    quick = run_simulated(hold_conversation(begun))
    with (
        patch.object(Conversation, "_take_rows", lambda self, data, start: start),
        patch.object(Conversation, "_relay_quickly", lambda self, line: False),
    ):
        slow = run_simulated(hold_conversation(begun))
    assert quick == slow


@pytest.mark.slow
@settings(max_examples=examples(60))
@given(st.lists(OPERATIONS, max_size=12), st.sampled_from([MOST_UNDER_WAY, MOST_UNDER_WAY // 3]))
def test_client_read_in_turns_gets_the_same_answers_as_one_read_at_once(
    operations: list[tuple[Any, ...]], cost: int
) -> None:
    begun = [("K", 0, 1, bytes), *operations]
    with patch.object(connection, "COST_HERE", 0):
        at_once = run_simulated(hold_conversation(begun))
    with patch.object(connection, "COST_HERE", cost):
        in_turns = run_simulated(hold_conversation(begun))
    (heard_in_turns, written_in_turns), (heard_at_once, written_at_once) = in_turns, at_once
    assert list(map(damage_apart, heard_in_turns)) == list(map(damage_apart, heard_at_once))
    assert written_in_turns == written_at_once

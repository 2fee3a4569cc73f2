"""To its client, the server of a shared link is a gateway: it answers what the vectors and the document say."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from sharing import call, settle, sharing
from simulated_time import on_simulated_time
from unity_link.protocol.configuration import Feature, GatewayInfo
from unity_link.protocol.messages import ErrorCode
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing
from worked_examples import Example, worked_examples

if TYPE_CHECKING:
    from unity_link.bridges.serve.shared import SharedLink

FOLDER = Path(__file__).resolve().parents[1] / "vectors"
FILES = [path for path in sorted(FOLDER.glob("*.ndjson")) if path.stem != "addressed"]


def in_words_of(shared: SharedLink, text: bytes) -> bytes:
    """Return what a gateway says of itself as the server says it."""
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
    """Return responses and samples, each in their order."""
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
            client = call(shared)
            for step in steps:
                client.transport.write(step["send"].encode("latin-1"))
                await settle(shared)
                answers, publishes = parted(client.take())
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
            client = call(shared)
            for sent, answered in example.exchange:
                client.transport.write(sent)
                await settle(shared)
                assert client.take() == in_words_of(shared, answered), sent

    play()

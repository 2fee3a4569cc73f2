"""To its client, the server of a shared link is a gateway: it answers what the vectors and the document say."""

from __future__ import annotations

import asyncio
import json
from contextlib import asynccontextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

import pipe
from simulated_time import on_simulated_time
from unity_link.bridges.serve.client import Client
from unity_link.bridges.serve.shared import SharedLink
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing
from unity_link.wire.gateway_info import Feature, GatewayInfo
from unity_link.wire.messages import ErrorCode

if TYPE_CHECKING:
    from collections.abc import AsyncIterator

    from unity_link.virtual import Gateway

FOLDER = Path(__file__).resolve().parents[1] / "vectors"
FILES = [path for path in sorted(FOLDER.glob("*.ndjson")) if path.stem != "addressed"]


class Terminal(asyncio.Protocol):
    """A client that says what it is told to, and keeps what it hears."""

    def __init__(self) -> None:
        self.heard = b""
        self.gone = False

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self.transport = transport

    def data_received(self, data: bytes) -> None:
        self.heard += data

    def connection_lost(self, exc: Exception | None) -> None:
        self.gone = True

    def take(self) -> bytes:
        heard, self.heard = self.heard, b""
        return heard


@asynccontextmanager
async def sharing(gateway: Gateway) -> AsyncIterator[SharedLink]:
    shared = SharedLink(gateway, lambda _: None)
    shared.open_when_there()
    while shared.away:
        await asyncio.sleep(0.001)
    try:
        yield shared
    finally:
        await shared.finish()


def call(shared: SharedLink) -> Terminal:
    terminal = Terminal()
    pipe.connect(terminal, Client(shared))
    return terminal


async def settle(shared: SharedLink) -> None:
    """Wait until all that was asked for is answered."""
    while True:
        await asyncio.sleep(0.01)
        if not shared._exchange.in_flight and not any(client._pending for client in shared.clients):
            return


def in_words_of(shared: SharedLink, text: bytes) -> bytes:
    """Give what a gateway says of itself as the server says it."""
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
    """Give responses and publishes: their order is not defined."""
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

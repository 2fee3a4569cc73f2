"""A link over Zenoh whose publications arrive again, late by laps of the IDs, as several routers may deliver them."""

from __future__ import annotations

import socket
import threading
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.recorded_bus import WRITTEN, gateway_of_short_laps
from support.sharing import ServedGateway
from unity_link.bridges.zenoh.streams import Streams
from unity_link.transport.zenoh_session import Network, close_session, open_session

if TYPE_CHECKING:
    from collections.abc import Iterator

LAP = 256


@contextmanager
def session(**network: Any) -> Iterator[Any]:
    opened = open_session(Network(**network))
    try:
        yield opened
    finally:
        close_session(opened)


class Doubling:
    """Publishes again the publications of others at a key, about a lap late."""

    def __init__(self, peer: Any, key: str) -> None:
        self.again = 0
        self._peer = peer
        self._lock = threading.Lock()
        self._seen: dict[tuple[str, bytes], None] = {}
        self._subscriber = peer.declare_subscriber(key, self._take)

    def _take(self, sample: Any) -> None:
        publication = str(sample.key_expr), sample.payload.to_bytes()
        with self._lock:
            # The session also receives its own publications.
            if publication in self._seen:
                return
            self._seen[publication] = None
            late = list(self._seen)[-LAP - 2 : -LAP + 1] if len(self._seen) > LAP + 2 else []
        for key, payload in late:
            self._peer.put(key, payload)
            self.again += 1


@pytest.mark.asyncio
async def test_duplicated_publications_are_dropped() -> None:
    gateway, bus = gateway_of_short_laps()
    with socket.create_server(("127.0.0.1", 0)) as one, socket.create_server(("127.0.0.1", 0)) as another:
        first, second = (f"tcp/127.0.0.1:{free.getsockname()[1]}" for free in (one, another))
    with session(listen=(first,)) as bridge, session(connect=(first,), listen=(second,)) as other:
        shared = ServedGateway(gateway, lambda _: None)
        shared.open_when_there()
        streams = Streams(bridge, "robot", shared)
        doubling = [Doubling(other, f"robot/@link/*/{way}") for way in ("up", "down")]
        async with unity_link.connect(f"zenoh:robot?connect={first},{second}", timeout=20) as link:
            for number in range(400):
                await link.write_queue(WRITTEN, [number])
                assert await link.read(number % 256) == number % 256
        streams.close()
        await shared.finish()
        assert all(way.again > 1000 for way in doubling)
    assert bus.writes == [(WRITTEN, number) for number in range(400)]

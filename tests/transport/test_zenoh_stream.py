"""The stream that consists of publications at two keys, without a network."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

import pytest

from unity_link.transport.zenoh_session import KeyTransport

if TYPE_CHECKING:
    from collections.abc import Callable


class Payload:
    def __init__(self, data: bytes) -> None:
        self.payload = self
        self._data = data

    def to_bytes(self) -> bytes:
        return self._data


class Session:
    """Replaces a session of Zenoh: records publications, and delivers those of the test."""

    def __init__(self) -> None:
        self.published: list[bytes] = []
        self._hear: Callable[[Payload], None]

    def declare_publisher(self, key: str, **_: Any) -> Session:
        return self

    def declare_subscriber(self, key: str, hear: Callable[[Payload], None]) -> Session:
        self._hear = hear
        return self

    def put(self, data: bytes) -> None:
        self.published.append(data)

    def undeclare(self) -> None:
        """Do nothing."""

    async def deliver(self, *publications: bytes) -> None:
        """Deliver publications, and wait until the reader has processed them."""
        for publication in publications:
            self._hear(Payload(publication))
        await asyncio.sleep(0)


class Reader(asyncio.Protocol):
    def __init__(self) -> None:
        self.read = b""

    def data_received(self, data: bytes) -> None:
        self.read += data


def opened() -> tuple[Session, Reader, KeyTransport]:
    session, reader = Session(), Reader()
    return session, reader, KeyTransport(session, "up", "down", reader)  # type: ignore[arg-type]


@pytest.mark.asyncio
async def test_publications_begin_with_their_count() -> None:
    session, _, transport = opened()
    transport.write(b"Q\r")
    transport.write(b"." * 60_001)
    assert session.published == [b"00000001Q\r", b"00000002" + b"." * 60_000, b"00000003."]


@pytest.mark.asyncio
async def test_publications_that_are_duplicated_late_or_without_count_are_dropped() -> None:
    session, reader, _ = opened()
    await session.deliver(b"00000001a\n", b"00000003c\n", b"00000002b\n", b"00000003c\n", b"Q\r", b"", b"00000004d\n")
    assert reader.read == b"a\nc\nd\n"


@pytest.mark.asyncio
async def test_publications_during_a_pause_are_read_before_later_ones() -> None:
    session, reader, transport = opened()
    transport.pause_reading()
    await session.deliver(b"00000001a\n")
    # This publication arrives in the turn of the loop in which reading resumes.
    session._hear(Payload(b"00000002b\n"))
    transport.resume_reading()
    await asyncio.sleep(0)
    await asyncio.sleep(0)
    assert reader.read == b"a\nb\n"

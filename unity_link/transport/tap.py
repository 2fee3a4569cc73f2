"""A tap between a driver and its protocol; its observers are a snoop and a log of frames.

A connection has a tap only if one of these is enabled when the connection is opened.
"""

from __future__ import annotations

import asyncio
import logging
import time
from typing import TYPE_CHECKING, Any, Protocol, cast

from unity_link.capture.decoder import FrameKind
from unity_link.capture.pcapng import Packet
from unity_link.capture.transcript import Transcript
from unity_link.transport.frame_log import RECEIVED, SAMPLES, SENT
from unity_link.transport.snoop import Snoop, now_ns

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from unity_link.capture.transcript import TimedFrame


class Observer(Protocol):
    """Observes all bytes of a connection."""

    def take(self, data: bytes, *, sent: bool) -> None:
        """Process bytes of one direction."""

    def end(self, why: str) -> None:
        """Process the end of the connection."""


def tapped(protocol: asyncio.Protocol, name: str, snoop: str, *, logged: bool) -> Tap:
    """Return a tap in front of a protocol, with the selected observers.

    Args:
        protocol: the protocol to connect to the medium.
        name: name of the medium for messages, without secrets.
        snoop: path of the snoop to write; empty for no snoop.
        logged: True to log the frames.

    Raises:
        ArgumentError: if the snoop cannot be written.
    """
    observers: list[Observer] = [SnoopedBytes(Snoop.at(snoop), name, _clock())] if snoop else []
    if logged:
        observers.append(LoggedFrames(name))
    return Tap(protocol, observers)


def _clock() -> Callable[[], float]:
    try:
        loop = asyncio.get_running_loop()
    except RuntimeError:
        return time.monotonic
    # uvloop's clock does not advance during a turn of the loop, and has a resolution of 1 ms.
    return loop.time if isinstance(loop, asyncio.BaseEventLoop) else time.monotonic


class SnoopedBytes:
    """Observer that writes one connection into a snoop."""

    def __init__(self, snoop: Snoop, name: str, clock: Callable[[], float]) -> None:
        self._snoop = snoop
        self._now_ns = now_ns(clock)
        self._connection = snoop.connection(name)

    def take(self, data: bytes, *, sent: bool) -> None:
        """Write a record with bytes."""
        self._snoop.write(Packet(self._connection, self._now_ns(), sent, data))

    def end(self, why: str) -> None:
        """Write a record of the end of the connection."""
        self._snoop.end(self._connection, self._now_ns(), why)


class LoggedFrames:
    """Observer that logs the frames of one connection and their meanings at level DEBUG."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._clock = _clock()
        self._transcript = Transcript()

    def take(self, data: bytes, *, sent: bool) -> None:
        """Log the frames that are complete now."""
        self._log(self._transcript.take(data, self._clock(), sent=sent))

    def end(self, why: str) -> None:
        """Log the incomplete frames, and the end of the connection."""
        self._log(self._transcript.end(self._clock()))
        SENT.debug("%s: the connection has ended (%s)", self._name, why)

    def _log(self, frames: Iterable[TimedFrame]) -> None:
        for timed in frames:
            log = SENT if timed.sent else SAMPLES if timed.meaning.kind is FrameKind.SAMPLE else RECEIVED
            if log.isEnabledFor(logging.DEBUG):
                log.debug(
                    "%s %s %s  %s",
                    self._name,
                    ">" if timed.sent else "<",
                    as_text(timed.frame),
                    in_words(timed),
                )


def as_text(frame: bytes) -> str:
    """Return a frame without its line end as printable characters."""
    return repr(frame.rstrip(b"\r\n"))[2:-1]


def in_words(timed: TimedFrame) -> str:
    """Return the meaning of a frame in one line."""
    return f"{timed.meaning.words}, again" if timed.again else timed.meaning.words


class Tap(asyncio.Protocol):
    """A protocol between a medium and another protocol, which passes all bytes to observers and to that protocol.

    Args:
        protocol: the other protocol.
        observers: get the bytes before the protocol does.
    """

    def __init__(self, protocol: asyncio.Protocol, observers: list[Observer]) -> None:
        self._protocol = protocol
        self._observers = observers

    def take(self, data: bytes, *, sent: bool) -> None:
        """Pass bytes to all observers."""
        for observer in self._observers:
            observer.take(data, sent=sent)

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Connect the protocol to a transport that observes the written bytes."""
        self._protocol.connection_made(_TappedTransport(cast("asyncio.Transport", transport), self))

    def data_received(self, data: bytes) -> None:
        """Pass received bytes to the observers and the protocol."""
        self.take(data, sent=False)
        self._protocol.data_received(data)

    def pause_writing(self) -> None:
        """Pass the call on."""
        self._protocol.pause_writing()

    def resume_writing(self) -> None:
        """Pass the call on."""
        self._protocol.resume_writing()

    def eof_received(self) -> bool | None:
        """Pass the call on."""
        return self._protocol.eof_received()

    def connection_lost(self, exc: Exception | None) -> None:
        """Pass the end of the connection to the observers and the protocol."""
        why = str(exc) if exc is not None else "closed"
        for observer in self._observers:
            observer.end(why)
        self._protocol.connection_lost(exc)


class _TappedTransport(asyncio.Transport):
    """A transport whose written bytes are observed."""

    def __init__(self, transport: asyncio.Transport, tap: Tap) -> None:
        super().__init__()
        self._transport = transport
        self._tap = tap

    def write(self, data: bytes | bytearray | memoryview) -> None:
        self._tap.take(bytes(data), sent=True)
        self._transport.write(data)

    def get_extra_info(self, name: str, default: object = None) -> Any:
        return self._transport.get_extra_info(name, default)

    def is_closing(self) -> bool:
        return self._transport.is_closing()

    def close(self) -> None:
        self._transport.close()

    def abort(self) -> None:
        self._transport.abort()

    def pause_reading(self) -> None:
        self._transport.pause_reading()

    def resume_reading(self) -> None:
        self._transport.resume_reading()

    def get_write_buffer_size(self) -> int:
        return self._transport.get_write_buffer_size()

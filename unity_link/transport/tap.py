"""A tap between a driver and its protocol, whose observers are a snoop and the log of the frames.

Only a connection for which one of them is wanted when it is opened has a tap.
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
    """Observer of all bytes that pass."""

    def take(self, data: bytes, *, sent: bool) -> None:
        """Take bytes of one direction."""

    def end(self, why: str) -> None:
        """Record that the connection has ended."""


def tapped(protocol: asyncio.Protocol, name: str, snoop: str, *, logged: bool) -> Tap:
    """Return a protocol that hands everything on to another one, and to what observes it.

    Args:
        protocol: is connected to the medium through it.
        name: of the medium, without secrets.
        snoop: path of the file to write, empty for none.
        logged: whether the frames are logged.

    Raises:
        ArgumentError: where the file can't be written.
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
    # That of uvloop stands still during a turn, and counts whole milliseconds.
    return loop.time if isinstance(loop, asyncio.BaseEventLoop) else time.monotonic


class SnoopedBytes:
    """One connection in a snoop."""

    def __init__(self, snoop: Snoop, name: str, clock: Callable[[], float]) -> None:
        self._snoop = snoop
        self._now_ns = now_ns(clock)
        self._connection = snoop.connection(name)

    def take(self, data: bytes, *, sent: bool) -> None:
        """Write bytes."""
        self._snoop.write(Packet(self._connection, self._now_ns(), sent, data))

    def end(self, why: str) -> None:
        """Write that the connection has ended."""
        self._snoop.end(self._connection, self._now_ns(), why)


class LoggedFrames:
    """The frames of one connection in words, at debug level."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._clock = _clock()
        self._transcript = Transcript()

    def take(self, data: bytes, *, sent: bool) -> None:
        """Log the frames that are whole."""
        self._log(self._transcript.take(data, self._clock(), sent=sent))

    def end(self, why: str) -> None:
        """Log what is left."""
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
    """Return a frame without its end as printable characters."""
    return repr(frame.rstrip(b"\r\n"))[2:-1]


def in_words(timed: TimedFrame) -> str:
    """Return what a frame means, in one line."""
    return f"{timed.meaning.words}, again" if timed.again else timed.meaning.words


class Tap(asyncio.Protocol):
    """Stands between a medium and the protocol that is connected to it.

    Args:
        protocol: has all that passes handed on.
        observers: are given it first.
    """

    def __init__(self, protocol: asyncio.Protocol, observers: list[Observer]) -> None:
        self._protocol = protocol
        self._observers = observers

    def take(self, data: bytes, *, sent: bool) -> None:
        """Pass bytes to all observers."""
        for observer in self._observers:
            observer.take(data, sent=sent)

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Hand on, with what observes the other direction in front of the transport."""
        self._protocol.connection_made(_TappedTransport(cast("asyncio.Transport", transport), self))

    def data_received(self, data: bytes) -> None:
        """Pass it to the observers and to the other side."""
        self.take(data, sent=False)
        self._protocol.data_received(data)

    def pause_writing(self) -> None:
        """Hand on."""
        self._protocol.pause_writing()

    def resume_writing(self) -> None:
        """Hand on."""
        self._protocol.resume_writing()

    def eof_received(self) -> bool | None:
        """Hand on."""
        return self._protocol.eof_received()

    def connection_lost(self, exc: Exception | None) -> None:
        """Pass it to the observers and to the other side."""
        why = str(exc) if exc is not None else "closed"
        for observer in self._observers:
            observer.end(why)
        self._protocol.connection_lost(exc)


class _TappedTransport(asyncio.Transport):
    """A transport whose writes are timed."""

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

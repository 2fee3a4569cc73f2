"""Layer 2, the life of a link: it is opened, lost, opened again and closed.

`Connection` is what a link and the bridges that hand on requests of others have in common: a driver's stream, the
handshake on it, and the exchange that moves requests over it. What is asked for, and what must be set up again in a new
session, is the matter of those who build on it.
"""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

import msgspec

from unity_link.errors import (
    ConnectError,
    GatewayError,
    LinkClosedError,
    LinkLostError,
    Outcome,
    UnansweredError,
    UnsupportedError,
)
from unity_link.link.exchange import Exchange
from unity_link.link.handshake import LAST_ANSWER, Handshake
from unity_link.protocol.configuration import Feature, GatewayInfo
from unity_link.protocol.window import Window
from unity_link.transport import DriverUrl, load_driver
from unity_link.transport.stream import Stream

if TYPE_CHECKING:
    from unity_link.protocol.messages import Codec
    from unity_link.transport import Medium


class Reconnect(msgspec.Struct, frozen=True, kw_only=True):
    """How a lost connection is opened again: with pauses that double from `first_pause` to `longest_pause` seconds."""

    first_pause: float = 0.1
    longest_pause: float = 5.0
    give_up_after: float | None = None
    """Seconds after which the link is lost for good; None: never."""


class Connection:
    """A connection to one gateway, with its sessions.

    Args:
        target: the URL of a gateway, or one of this process.
        reconnect: how a lost connection is opened again; None: it is not.
    """

    gateway: GatewayInfo
    """What the gateway says of itself."""

    def __init__(self, target: DriverUrl | Medium, reconnect: Reconnect | None) -> None:
        self._codec: Codec
        self._target = target
        self._reconnect = reconnect
        self._loop = asyncio.get_running_loop()
        self._exchange = Exchange(self._lose)
        self._stream: Stream | None = None
        self._reconnection: asyncio.Task[None] | None = None
        self._sessions = 0
        self._bytes_before = (0, 0)
        self._closed = self._closed_by_program = False

    # What builds on this says

    def _begin(self, codec: Codec) -> None:
        """Record a gateway that has said what it is, before its session starts."""

    async def _restore(self) -> None:
        """Set up again what a new session of the same link needs."""

    def _interrupted(self, reason: str) -> None:
        """Record that the connection was lost and is being opened again."""

    def _unreachable(self, error: BaseException | None) -> None:
        """Record that an attempt to open the connection failed, and that there will be another."""

    def _ended(self, error: LinkLostError) -> None:
        """Record that the link has ended for good."""

    # Life

    @property
    def connected(self) -> bool:
        """Whether there is a session now; not while the connection is being opened again, nor after the end."""
        return not self._exchange.suspended

    async def open(self, timeout: float) -> None:  # noqa: ASYNC109  (it is an argument of `connect`)
        """Connect and start a session.

        Raises:
            ConnectError: where nothing answers within `timeout` seconds; it says what was tried.
            UnsupportedError: for a gateway of another protocol version, or another one than before.
        """
        name = self._target.text if isinstance(self._target, DriverUrl) else "the given gateway"
        stream = Stream()
        handshake = None
        try:
            async with asyncio.timeout(timeout):
                await self._connect_stream(stream)
                handshake = Handshake(stream, self._target.node if isinstance(self._target, DriverUrl) else None)
                codec, round_trip = await handshake.run()
                self._start(stream, codec, round_trip)
        except BaseException as error:
            stream.receiver = None
            # A port is not free for the next attempt before it has been closed.
            await stream.close()
            if isinstance(error, TimeoutError):
                heard = "the connection was not accepted" if handshake is None else handshake.describe()
                raise ConnectError(f"no gateway answered at {name} within {timeout:g} s; {heard}") from None
            if isinstance(error, ConnectError):
                raise ConnectError(f"{name}: {error}") from error
            raise

    async def _connect_stream(self, stream: Stream) -> None:
        if isinstance(self._target, DriverUrl):
            await load_driver(self._target.scheme).connect(self._target, stream)
        else:
            await self._target.open(stream)

    def _start(self, stream: Stream, codec: Codec, round_trip: float) -> None:
        """Begin a session on a stream whose gateway has said what it is."""
        info = codec.info
        if stream.closed:
            raise ConnectError("the connection ended when the gateway had just answered")
        if self._sessions and info != self.gateway:
            raise UnsupportedError(f"another gateway answers after the reconnection: {info} instead of {self.gateway}")
        self._sessions += 1
        self._codec = codec
        self._stream = stream
        self.gateway = info
        credit = None if Feature.FLOW_CONTROL in info.features else info.receive_fifo_bytes
        self._begin(codec)
        byte_time = round_trip / LAST_ANSWER
        self._exchange.start(stream, codec, Window(codec.ring, credit, byte_time, round_trip, stream.shortest_timeout))

    def _lose(self, reason: str) -> None:
        """End the session; and the link, if it is not to reconnect."""
        self._drop_stream()
        if self._closed:
            return
        if self._reconnect is None:
            self._end(LinkLostError(reason))
            return
        self._exchange.suspend(reason)
        self._interrupted(reason)
        if self._reconnection is None:
            self._reconnection = self._loop.create_task(self._reopen(reason, self._reconnect))

    def open_when_there(self) -> None:
        """Open as soon as the gateway is there, in a task of its own, as a lost connection is opened again."""
        if self._reconnection is None and self._reconnect is not None:
            self._reconnection = self._loop.create_task(self._reopen("", self._reconnect))

    def _drop_stream(self) -> None:
        if self._stream is not None:
            sent, received = self._bytes_before
            self._bytes_before = (sent + self._stream.bytes_sent, received + self._stream.bytes_received)
            self._stream.receiver = None
            self._stream.abort()
            self._stream = None

    async def _reopen(self, reason: str, reconnect: Reconnect) -> None:
        from tenacity import AsyncRetrying, RetryError, retry_if_exception_type
        from tenacity.wait import wait_exponential, wait_random

        began, longest = self._loop.time(), reconnect.give_up_after
        attempts = AsyncRetrying(
            retry=retry_if_exception_type((ConnectError, UnansweredError)),
            wait=wait_exponential(reconnect.first_pause, reconnect.longest_pause)
            + wait_random(0, reconnect.first_pause),
            # The library's own limit looks at another clock than the loop's.
            stop=lambda _: longest is not None and self._loop.time() - began >= longest,
            before_sleep=lambda state: self._unreachable(state.outcome.exception() if state.outcome else None),
        )
        try:
            async for attempt in attempts:
                with attempt:
                    await self._open_again(reconnect.longest_pause)
        except RetryError as error:
            self._end(LinkLostError(f"{reason}, and no reconnection succeeded ({error.last_attempt.exception()})"))
        except Exception as error:  # noqa: BLE001  (whatever it is, no call may wait for a link that is gone)
            lost = LinkLostError(f"{reason}, and the reconnection failed ({error})" if reason else str(error))
            lost.__cause__ = error
            self._end(lost)
        finally:
            self._reconnection = None

    async def _open_again(self, timeout: float) -> None:  # noqa: ASYNC109  (as `open`)
        await self.open(timeout)
        try:
            await self._restore()
        except (UnansweredError, GatewayError) as error:
            # On a bad line, or where a server has no group free, this attempt has failed; the next one begins with a
            # connection of its own.
            reason = error.reason if isinstance(error, UnansweredError) else str(error)
            if self._stream is not None:
                self._lose(reason)
            raise LinkLostError(reason) from error
        if self._stream is None:
            raise LinkLostError("the connection was lost again")

    def _end(self, error: LinkLostError) -> None:
        if self._closed:
            return
        self._closed = True
        self._drop_stream()
        self._exchange.end(error)
        self._ended(error)

    async def aclose(self) -> None:
        """End the link: what still waits raises `LinkClosedError`. May be called twice."""
        self._closed_by_program = True
        stream, task = self._stream, self._reconnection
        self._end(LinkClosedError("the link was closed", Outcome.UNKNOWN))
        if task is not None:
            task.cancel()
            await asyncio.wait([task])
        if stream is not None:
            await stream.close()

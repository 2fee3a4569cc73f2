"""Layer 2: opening, losing, reopening and closing the connection to a gateway.

1. `open` connects a stream and waits for the first session; the attempt fails after a timeout.
2. A lost connection ends the link, unless `Reconnect` is given. Then it is opened again, with exponential backoff.
3. A gateway that was reset is given a new session on the same connection.
4. In a new session of the same link, `_restore` sets up the groups again before the connection counts as opened.

`Connection` is the base class of `Link` and of the server of shared links. Its `Flow` carries the bytes; subclasses
handle the events of requests and groups.
"""

from __future__ import annotations

import logging
import math
import os
import random
from typing import TYPE_CHECKING, assert_never

import msgspec

from unity_link.errors import (
    ConnectError,
    GatewayError,
    LinkClosedError,
    LinkLostError,
    Outcome,
    UnansweredError,
    UnityLinkError,
    UnsupportedError,
    reason_of,
)
from unity_link.link.flow import Flow
from unity_link.link.living import Living
from unity_link.link.runtimes.runtime import AsyncioRuntime, report
from unity_link.protocol.host.events import GroupsRestored, Interrupted, Opened, Taken, Unusable
from unity_link.protocol.host.session import Session
from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.numbers import seconds_from
from unity_link.transport import DriverUrl, has_echo, name_of, node_of, takes_compact_form
from unity_link.transport.stream import Stream

if TYPE_CHECKING:
    from unity_link.link.runtimes.runtime import Job, Runtime, Waiter
    from unity_link.protocol.host.events import SessionEvent, UnsolicitedEvent
    from unity_link.protocol.host.host_codec import HostCodec
    from unity_link.protocol.wire.configuration import GatewayInfo
    from unity_link.transport import Medium

log = logging.getLogger("unity_link.link")
CONNECT_TIMEOUT = 5.0
"""Default seconds until the handshake must be complete."""
_MOST_DOUBLINGS = 100
"""Upper limit of the exponent in `Reconnect.pause_after`; larger than any pause needs."""
_SEED_BITS = 16
"""Random bits for the choice of a session number and a first ID."""


class Reconnect(msgspec.Struct, frozen=True, kw_only=True):
    """Reopening of a lost connection, with pauses that double from `first_pause` to `longest_pause` seconds.

    The first attempt is made at once. Each attempt may take the ``timeout`` of `connect`. A connection that is opened
    again and lost before the next pause would be over counts as a failed attempt.
    """

    first_pause: float = 0.1
    """Seconds between the first failed attempt and the next one."""
    longest_pause: float = 5.0
    """Most seconds between two attempts."""
    give_up_after: float | None = None
    """Seconds without a connection after which the link ends; None: never."""

    def __post_init__(self) -> None:
        """Raise `ArgumentError` for values that are no durations."""
        for name, seconds in (("first_pause", self.first_pause), ("longest_pause", self.longest_pause)):
            seconds_from(seconds, f"{name} is a number of seconds above 0")
        if self.give_up_after is not None:
            seconds_from(self.give_up_after, "give_up_after is a number of seconds from 0 on, or None", zero=True)

    def pause_after(self, failures: int) -> float:
        """Return the seconds from the last of `failures` failed attempts (1 or more) to the next one.

        A random part separates the attempts of programs that have lost the same gateway.
        """
        doubled = self.first_pause * 2.0 ** min(failures - 1, _MOST_DOUBLINGS)
        return min(doubled, self.longest_pause) + random.uniform(0, self.first_pause)  # noqa: S311  (no secret)


def choose_seed() -> int:
    """Return a random number for the choice of a session number and a first ID."""
    return random.getrandbits(_SEED_BITS)  # no secret: it only distinguishes this session from the last one


class Connection:
    """A connection to one gateway, with its sessions.

    Args:
        target: URL of a gateway, or a gateway in this process.
        reconnect: how a lost connection is opened again; None: the link ends.
        resumes: send reads again in the next session, also after a reset on the same connection.
        runtime: runtime of the link; None: the running event loop of asyncio.
    """

    gateway: GatewayInfo
    """Description of the gateway, as it answers `Q`."""

    def __init__(
        self,
        target: DriverUrl | Medium,
        reconnect: Reconnect | None,
        *,
        resumes: bool = False,
        runtime: Runtime | None = None,
    ) -> None:
        self._target = target
        self._name = name_of(target)
        self._reconnect = reconnect
        self._runtime: Runtime = AsyncioRuntime() if runtime is None else runtime
        self._now = self._runtime.time
        self._new_waiter = self._runtime.create_future
        self.any_map = isinstance(target, DriverUrl) and target.any_map
        """True if specs with another fingerprint than the gateway's are accepted."""
        self.compatible_maps: set[int] = set()
        """Fingerprints of specs whose declarations are all in the gateway's description."""
        self._session = Session(
            node_of(target),
            choose_seed,
            resumes=resumes or reconnect is not None,
            compact=takes_compact_form(target),
            echo=has_echo(target),
        )
        self._session.on_retransmission = self._retransmitted
        self._flow = Flow(self._session, self._runtime, self._happened, self._disconnected)
        self._opened: Waiter = self._new_waiter()
        """Future of the session that is being opened; it ends with an error if that fails."""
        self._opening = False
        """True while a connection is being opened."""
        self._open_timeout = CONNECT_TIMEOUT
        """Most seconds of an attempt to open the connection again."""
        self._restored: Waiter = self._new_waiter()
        """Future that is done when all groups are set up again in a new session."""
        self._reconnection: Job | None = None
        self._resumption: Job | None = None
        _CONNECTIONS.add(self)
        self.interruptions = 0
        """Number of sessions that were lost and followed by another one; the gateway may have been reset."""
        self.resets = 0
        """Number of resets of the gateway that this link has detected."""
        self.interrupted_by = ""
        """Reason for the last interruption."""
        self._opened_again_at = -math.inf
        """Instant of the last successful reconnection."""
        self._lost_at_once = 0
        """Number of consecutive reconnections that were lost again before the next pause would have been over."""
        self._closed = self._closed_by_program = False

    # Methods that subclasses override

    def _happened(self, event: UnsolicitedEvent) -> None:
        """Handle an unsolicited event; `_take_change` handles those of sessions."""
        raise NotImplementedError

    def _begin(self, codec: HostCodec) -> None:
        """Handle the beginning of a session."""

    async def _restore(self) -> None:
        """Set up the groups of the link again in a new session, or wait until they are set up."""
        await self._restored

    def _interrupted(self, reason: str) -> None:
        """Handle the loss of a session that is followed by another one."""

    def _unreachable(self, error: BaseException | None) -> None:
        """Handle a failed attempt to open the connection that is followed by another one."""

    def _ended(self, error: LinkLostError) -> None:
        """Handle the end of the link."""

    # The session

    @property
    def name(self) -> str:
        """Name of the gateway in errors and logs: its URL."""
        return self._name

    @property
    def epoch(self) -> int:
        """Number of the session, as in `Sample.epoch`: 0, and one more after each reconnection or reset."""
        return self._session.epoch

    @property
    def connected(self) -> bool:
        """True if a session is open; False while the connection is being opened again, and after the end."""
        return self._session.is_open

    def _disconnected(self, reason: Exception | None) -> None:
        """Handle the end of the stream."""
        if not self._opened.done():
            self._opened.set_exception(self._session.connection_error(reason))
        elif not self._opening:
            self._lose(f"the connection was lost ({reason})" if reason else "the other side closed the connection")

    def _retransmitted(self, count: int) -> None:
        """Log a retransmission."""
        why = "no answer came in time" if self._session.window.loss.timed_out else "a frame was lost or damaged"
        log.debug("%s: requests retransmitted: %d, because %s", self._name, count, why)

    # Events

    def _take_change(self, event: SessionEvent) -> None:
        """Handle an event of a session."""
        match event:
            case Opened(info):
                self._session_opened(info)
            case Interrupted():
                self._gateway_was_reset(event)
            case Unusable(error):
                self._connection_failed(error)
            case Taken(error):
                # The other program keeps the line: do not connect again.
                if not self._opened.done():
                    self._opened.set_exception(error)
                if not self._opening or self._reconnection is not None:
                    self._end(error)
            case GroupsRestored(error):
                if error is not None:
                    self._fail_restoring(error)
                elif not self._restored.done():
                    self._restored.set_result(None)
            case _:
                assert_never(event)

    def _session_opened(self, info: GatewayInfo) -> None:
        self.gateway = info
        if self._flow.seat is not None and Feature.HALF_DUPLEX not in info.features:
            try:
                self._flow.seat.keep()
            except ConnectError as error:
                self._connection_failed(UnsupportedError(str(error)))
                return
        log.info("%s: session %d has begun", self._name, self._session.epoch + 1)
        if self._flow.path is not None and self._flow.path.is_short:
            log.info("%s: the network carries packets of %d bytes", self._name, self._flow.path.mtu)
        self._restored = self._new_waiter()
        self._begin(self._session.codec)
        if self._opened.done():
            self._resumption = self._runtime.create_task(self._resume())
        else:
            self._opened.set_result(None)

    def _gateway_was_reset(self, event: Interrupted) -> None:
        log.warning("%s: %s", self._name, event.error.reason)
        self.resets += 1
        self._session_ended(event.error)

    def _session_ended(self, error: LinkLostError) -> None:
        self.interruptions += 1
        self.interrupted_by = error.reason
        self._fail_restoring(error)
        self._interrupted(error.reason)

    def _fail_restoring(self, error: UnityLinkError) -> None:
        if not self._restored.done():
            self._restored.set_exception(error)
            # Retrieve the error, because asyncio logs it if no call awaits the future.
            self._restored.exception()

    def _connection_failed(self, error: UnityLinkError) -> None:
        if not self._opened.done():
            self._opened.set_exception(error)
        elif not self._opening:
            self._lose(reason_of(error))

    async def _resume(self) -> None:
        """Set up the groups again after a reset of the gateway, in a new session on the same connection."""
        try:
            await self._restore()
        except (UnansweredError, GatewayError) as error:
            if self._session.is_open:
                self._lose(reason_of(error))

    # Opening and closing

    async def open(self, timeout: float) -> None:
        """Connect, and open a session.

        Raises:
            ConnectError: if no session is open after `timeout` seconds; the text contains the received bytes.
            UnsupportedError: for another protocol version, or another gateway than before.
        """
        self._open_timeout = timeout
        await self._open(timeout)

    async def _open(self, timeout: float) -> None:
        name = self._name
        stream = Stream(self._new_waiter)
        self._opening = True
        try:
            async with self._runtime.timeout(timeout):
                if self._flow.latest is not None:
                    # Wait until the lost port is closed: it cannot be opened before.
                    await self._flow.latest.close()
                await self._connect_stream(stream)
                log.info("%s: connected", name)
                await self._open_session(stream)
        except BaseException as error:
            heard = self._session.describe_silence()
            self._leave(stream)
            # Wait until the port is closed: the next attempt cannot open it before.
            await stream.close()
            if isinstance(error, TimeoutError):
                raise ConnectError(f"no gateway answered at {name} within {timeout:g} s; {heard}") from None
            if isinstance(error, ConnectError):
                raise ConnectError(f"{name}: {error}") from error
            raise
        finally:
            self._opening = False

    async def _connect_stream(self, stream: Stream) -> None:
        await self._runtime.open_medium(self._target, stream)

    async def _open_session(self, stream: Stream) -> None:
        self._opened = self._new_waiter()
        self._flow.attach(stream)
        if not stream.closed:
            self._flow.go_on([])
            await self._opened
        if stream.closed:
            raise self._session.connection_error(None)

    def _leave(self, stream: Stream) -> None:
        """Abandon a stream on which no session was opened."""
        stream.receiver = stream.on_pause = None
        if self._opened.done() and not self._opened.cancelled():
            self._opened.exception()
        if self._flow.stream is stream:
            self._flow.detach()
            self._flow.go_on(self._session.disconnect("the connection could not be opened"))

    def _lose(self, reason: str) -> None:
        """End the session and its connection, and reconnect; without `Reconnect`, end the link."""
        self._flow.detach()
        if self._closed:
            return
        if self._reconnect is None:
            self._end(LinkLostError(reason))
            return
        log.warning("%s: %s; connecting again", self._name, reason)
        self._flow.go_on(self._session.disconnect(reason))
        self._session_ended(LinkLostError(reason))
        if self._reconnection is None:
            self._reconnection = self._runtime.create_task(self._reopen(reason, self._reconnect))

    def open_when_there(self) -> None:
        """Open the connection in a task of its own, with the attempts of a reconnection, until the gateway answers."""
        if self._reconnection is None and self._reconnect is not None:
            self._reconnection = self._runtime.create_task(self._reopen("", self._reconnect))

    async def _reopen(self, reason: str, reconnect: Reconnect) -> None:
        """Try to open the connection until it succeeds; end the link after `give_up_after`, or a final error."""
        longest = reconnect.give_up_after
        end = math.inf if longest is None else self._now() + longest
        failures = self._lost_at_once = self._count_lost_at_once(reconnect)
        try:
            while True:
                if failures:
                    # Pause for at most half of the remaining time, so that the last attempt has the other half.
                    await self._runtime.sleep(max(0.0, min(reconnect.pause_after(failures), (end - self._now()) / 2)))
                error = await self._attempt(max(min(self._open_timeout, end - self._now()), reconnect.first_pause))
                if error is None:
                    self._opened_again_at = self._now()
                    return
                if self._closed:
                    # The link ended during the attempt: another program uses the line.
                    return
                if end - self._now() <= reconnect.first_pause:
                    self._end(LinkLostError(f"{reason}, and no reconnection succeeded ({error})"))
                    return
                failures += 1
                log.info("%s: not connected (%s); trying again", self._name, error)
                self._unreachable(error)
        except UnityLinkError as error:
            lost = LinkLostError(f"{reason}, and the reconnection failed ({error})" if reason else str(error))
            lost.__cause__ = error
            self._end(lost)
        finally:
            self._reconnection = None

    def _count_lost_at_once(self, reconnect: Reconnect) -> int:
        count = self._lost_at_once + 1
        return count if self._now() - self._opened_again_at < reconnect.pause_after(count) else 0

    async def _attempt(self, timeout: float) -> Exception | None:
        """Open the connection again. Return None, or the error if another attempt may succeed.

        Raises:
            UnityLinkError: if no other attempt can succeed.
        """
        try:
            await self._open_again(timeout)
        except (ConnectError, UnansweredError) as error:
            return error
        except UnityLinkError:
            raise
        except Exception as error:  # noqa: BLE001  (a medium of the user's own may raise anything)
            report(f"{self._name}: an attempt to connect again has failed; there will be another", error)
            if self._flow.stream is not None:
                self._lose(str(error))
            return error
        return None

    async def _open_again(self, timeout: float) -> None:
        await self._open(timeout)
        try:
            await self._restore()
        except (UnansweredError, GatewayError) as error:
            # The line is bad, or a server has no free group: the attempt failed. Close this connection, because the
            # next attempt opens its own.
            reason = reason_of(error)
            if self._flow.stream is not None:
                self._lose(reason)
            raise LinkLostError(reason) from error
        if self._flow.stream is None:
            raise LinkLostError("the connection was lost again")

    def _end(self, error: LinkLostError) -> None:
        if self._closed:
            return
        self._closed = True
        log.info("%s: %s", self._name, error.reason)
        self._flow.detach()
        self._flow.go_on(self._session.close(error))
        self._fail_restoring(error)
        self._ended(error)

    def disown(self) -> None:
        """Detach from the connection, which belongs to the process from which this one was forked."""
        self._closed = self._closed_by_program = True
        self._flow.stream = self._flow.latest = self._flow.seat = self._reconnection = None
        self._session.close(forked())

    async def aclose(self) -> None:
        """End the link: calls that still wait raise `LinkClosedError`. A second call has no effect.

        When it returns, the medium is closed, so that its port can be opened again.
        """
        self._closed_by_program = True
        task = self._reconnection
        self._end(LinkClosedError("the link was closed", Outcome.UNKNOWN))
        if task is not None:
            await self._runtime.finish(task)
        if self._flow.latest is not None:
            await self._flow.latest.close()


_CONNECTIONS: Living[Connection] = Living()


def forked() -> LinkLostError:
    """Return the error of a link in a process that was forked from the one that opened it."""
    return LinkLostError(
        "this process was forked from the one that opened the link: open another link here", Outcome.NOT_EXECUTED
    )


def _disown_all() -> None:
    for connection in _CONNECTIONS:
        connection.disown()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_disown_all)

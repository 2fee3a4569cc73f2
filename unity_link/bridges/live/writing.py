"""Values that come from a page, and its wish to stop.

Where writes are not allowed there is no `Writing`, and nothing that could write but `Stopping`, by which any page may
disarm.

A write that has begun goes on when its page has gone; it ends, and is never sent, when the link goes away before.
"""

from __future__ import annotations

import asyncio
import hmac
from typing import TYPE_CHECKING, Annotated, Any

import msgspec

from unity_link.bridges.live.description import is_written
from unity_link.cores.lease import LeasedRobot, leases_of
from unity_link.errors import UnityLinkError

if TYPE_CHECKING:
    from collections.abc import Callable, Collection, Coroutine

    from unity_link.data import Proxy, Robot, Writable
    from unity_link.link.link import Link

LOOK_EVERY = 0.1
"""Seconds between looks whether the link is still there while a value is written."""
_LARGEST_NUMBER = 2**53
"""Up to here JavaScript counts exactly."""
_AWAY = "the link is away: nothing was written"
_WENT_AWAY = "the link went away: it is not known whether this was written"


class Hello(msgspec.Struct, tag_field="type", tag="hello", forbid_unknown_fields=True):
    """A page tells the token that its URL had."""

    token: str


class Write(msgspec.Struct, tag_field="type", tag="write", forbid_unknown_fields=True):
    """A page wants a value written."""

    number: Annotated[int, msgspec.Meta(ge=0, le=_LARGEST_NUMBER)]
    """Number that its answer repeats."""
    signal: str
    value: bool | int | float | str
    """Value in the signal's unit; of an enumeration a number or a name."""


class Stop(msgspec.Struct, tag_field="type", tag="stop", forbid_unknown_fields=True):
    """A page wants a lease disarmed."""

    number: Annotated[int, msgspec.Meta(ge=0, le=_LARGEST_NUMBER)]
    """Number that its answer repeats."""
    lease: str
    """Path of the lease."""


class Written(msgspec.Struct, tag_field="type", tag="written"):
    """The value is on the bus."""

    number: int


class Refused(msgspec.Struct, tag_field="type", tag="refused"):
    """The value was not written, or it is not known whether it was; the reason says which."""

    number: int
    reason: str


class Writing:
    """Writes what pages that know the token ask for.

    Args:
        robot: whose signals.
        token: what a page must know.
        sampled: signals whose values the page shows anyway.
    """

    def __init__(self, robot: Robot, token: str, sampled: Collection[Proxy[Any]] = ()) -> None:
        self.written = 0
        """Values that were written."""
        self._link = robot.link
        self._sampled = sampled
        self._known: dict[str, tuple[Writable[Any], int]] = {}
        """Signals that were written, and how often the link had been opened again by then, by path."""
        self._token = token.encode(errors="surrogatepass")
        self._errands = _Errands(robot.link)
        self._signals: dict[str, Writable[Any]] = {
            proxy.path: proxy  # type: ignore[misc]
            for proxy in robot.signals
            if is_written(proxy)
        }

    @property
    def values(self) -> dict[str, object]:
        """The last values that were written to signals that nothing samples, by path.

        A signal is left out if its value may be another one by now: after a reconnection, because the gateway may have
        been reset; if a lease guards it; and if a write has an effect.
        """
        now = self._link.statistics.reconnections
        return {path: proxy.value for path, (proxy, then) in self._known.items() if then == now}

    def knows(self, token: str) -> bool:
        """Return whether a token is the right one, in a time that does not tell how much of it was."""
        return hmac.compare_digest(token.encode(errors="surrogatepass"), self._token)

    async def write(self, wish: Write) -> Written | Refused:
        """Write a value that is within its limits. While the link is away nothing is: it would come as a surprise."""
        proxy = self._signals.get(wish.signal)
        if proxy is None:
            return Refused(wish.number, f"there is no signal {wish.signal!r} that can be written")

        async def write() -> None:
            await proxy.set(wish.value)
            self.written += 1
            if proxy not in self._sampled and proxy.signal.safe is None and proxy.signal.effect is None:
                self._known[proxy.path] = proxy, self._link.statistics.reconnections

        return await self._errands.run(wish.number, write)


class Stopping:
    """Disarms the leases of a robot, for any page: who may look may stop.

    Args:
        robot: with the leases, if it has any.
    """

    def __init__(self, robot: Robot) -> None:
        self._leases = leases_of(robot) if isinstance(robot, LeasedRobot) else {}
        self._errands = _Errands(robot.link)

    async def stop(self, wish: Stop) -> Written | Refused:
        """Disarm a lease. While the link is away nothing is, and it runs out by itself."""
        lease = self._leases.get(wish.lease)
        if lease is None:
            return Refused(wish.number, f"there is no lease {wish.lease!r}")
        return await self._errands.run(wish.number, lease.stop)


class _Errands:
    """The errands of pages at the gateway, each done to its end, or until the link goes away.

    Args:
        link: to the gateway.
    """

    def __init__(self, link: Link) -> None:
        self._link = link
        self._under_way: set[asyncio.Task[Written | Refused]] = set()

    async def run(self, number: int, call: Callable[[], Coroutine[Any, Any, object]]) -> Written | Refused:
        """Make a call, and return the answer to the page; a page that goes leaves it under way."""
        if not self._link.connected:
            return Refused(number, _AWAY)
        writing = asyncio.create_task(self._run(number, call))
        self._under_way.add(writing)
        writing.add_done_callback(self._under_way.discard)
        return await asyncio.shield(writing)

    async def _run(self, number: int, call: Callable[[], Coroutine[Any, Any, object]]) -> Written | Refused:
        setting = asyncio.ensure_future(call())
        try:
            while not (await asyncio.wait([setting], timeout=LOOK_EVERY))[0]:
                if not self._link.connected:
                    return Refused(number, _WENT_AWAY)
            setting.result()
        except UnityLinkError as error:
            return Refused(number, str(error))
        finally:
            setting.cancel()
        return Written(number)

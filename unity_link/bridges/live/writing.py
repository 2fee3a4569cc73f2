"""Values that pages write, and their requests to stop.

If writes are not allowed there is no `Writing`, and only `Stopping` writes: any page may disarm a lease.

A write that has begun continues after its page has disconnected. If the link goes away first, the write ends and is
never sent.
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
"""Seconds between checks whether the link is still connected while a value is written."""
_LARGEST_NUMBER = 2**53
"""Largest whole number that JavaScript represents exactly."""
_AWAY = "the link is away: nothing was written"
_WENT_AWAY = "the link went away: it is not known whether this was written"


class Hello(msgspec.Struct, tag_field="type", tag="hello", forbid_unknown_fields=True):
    """First message of a page: the token in its URL."""

    token: str


class Write(msgspec.Struct, tag_field="type", tag="write", forbid_unknown_fields=True):
    """Request of a page to write a value."""

    number: Annotated[int, msgspec.Meta(ge=0, le=_LARGEST_NUMBER)]
    """Number of the request, which the answer repeats."""
    signal: str
    value: bool | int | float | str
    """Value in the signal's unit; for an enumeration a number or a name."""


class Stop(msgspec.Struct, tag_field="type", tag="stop", forbid_unknown_fields=True):
    """Request of a page to disarm a lease."""

    number: Annotated[int, msgspec.Meta(ge=0, le=_LARGEST_NUMBER)]
    """Number of the request, which the answer repeats."""
    lease: str
    """Path of the lease."""


class Written(msgspec.Struct, tag_field="type", tag="written"):
    """Answer: the value was written."""

    number: int


class Refused(msgspec.Struct, tag_field="type", tag="refused"):
    """Answer: the value was not written, or it is not known whether it was; the reason states which."""

    number: int
    reason: str


class Writing:
    """Writes values for pages that have sent the token.

    Args:
        robot: robot with the signals.
        token: token that a page must send.
        sampled: signals with samples, whose values the page shows anyway.
    """

    def __init__(self, robot: Robot, token: str, sampled: Collection[Proxy[Any]] = ()) -> None:
        self.written = 0
        """Number of values written."""
        self._link = robot.link
        self._sampled = sampled
        self._known: dict[str, tuple[Writable[Any], int]] = {}
        """Signals that were written, and the number of reconnections of the link at that time, by path."""
        self._token = token.encode(errors="surrogatepass")
        self._calls = _Calls(robot.link)
        self._signals: dict[str, Writable[Any]] = {
            proxy.path: proxy  # type: ignore[misc]
            for proxy in robot.signals
            if is_written(proxy)
        }

    @property
    def values(self) -> dict[str, object]:
        """The last values that were written to signals without samples, by path.

        A signal is left out if its value may have changed: after a reconnection, because the gateway may have been
        reset; if a lease guards it; and if a write has an effect.
        """
        now = self._link.statistics.reconnections
        return {path: proxy.value for path, (proxy, then) in self._known.items() if then == now}

    def knows(self, token: str) -> bool:
        """Return whether a token is the right one, in a time that does not depend on its content."""
        return hmac.compare_digest(token.encode(errors="surrogatepass"), self._token)

    async def write(self, wish: Write) -> Written | Refused:
        """Write a value within its limits. Refuse it while the link is away: a late write would surprise the user."""
        proxy = self._signals.get(wish.signal)
        if proxy is None:
            return Refused(wish.number, f"there is no signal {wish.signal!r} that can be written")

        async def write() -> None:
            await proxy.set(wish.value)
            self.written += 1
            if proxy not in self._sampled and proxy.signal.safe is None and proxy.signal.effect is None:
                self._known[proxy.path] = proxy, self._link.statistics.reconnections

        return await self._calls.run(wish.number, write)


class Stopping:
    """Disarms leases of a robot, for any page, also without a token.

    Args:
        robot: robot with any number of leases.
    """

    def __init__(self, robot: Robot) -> None:
        self._leases = leases_of(robot) if isinstance(robot, LeasedRobot) else {}
        self._calls = _Calls(robot.link)

    async def stop(self, wish: Stop) -> Written | Refused:
        """Disarm a lease. Refuse that while the link is away; the lease then runs out by itself."""
        lease = self._leases.get(wish.lease)
        if lease is None:
            return Refused(wish.number, f"there is no lease {wish.lease!r}")
        return await self._calls.run(wish.number, lease.stop)


class _Calls:
    """Requests of pages to the gateway, each executed to its end, or until the link goes away.

    Args:
        link: link to the gateway.
    """

    def __init__(self, link: Link) -> None:
        self._link = link
        self._under_way: set[asyncio.Task[Written | Refused]] = set()

    async def run(self, number: int, call: Callable[[], Coroutine[Any, Any, object]]) -> Written | Refused:
        """Call a function, and return the answer for the page. If the page disconnects, the call continues."""
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

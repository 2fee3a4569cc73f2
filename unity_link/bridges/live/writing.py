"""Values that come from a page. Where writes are not allowed there is no `Writing`, and nothing that could write.

A write that has begun goes on when its page has gone; it ends, and is never sent, when the link goes away before.
"""

from __future__ import annotations

import asyncio
import hmac
from typing import TYPE_CHECKING, Annotated, Any

import msgspec

from unity_link.bridges.live.description import is_written
from unity_link.errors import UnityLinkError

if TYPE_CHECKING:
    from unity_link.data import Robot, Writable

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
    """

    def __init__(self, robot: Robot, token: str) -> None:
        self.written = 0
        """Values that were written."""
        self._link = robot.link
        self._token = token.encode(errors="surrogatepass")
        self._under_way: set[asyncio.Task[Written | Refused]] = set()
        self._signals: dict[str, Writable[Any]] = {
            proxy.path: proxy  # type: ignore[misc]
            for proxy in robot.signals
            if is_written(proxy)
        }

    def knows(self, token: str) -> bool:
        """Return whether a token is the right one, in a time that does not tell how much of it was."""
        return hmac.compare_digest(token.encode(errors="surrogatepass"), self._token)

    async def write(self, wish: Write) -> Written | Refused:
        """Write a value that is within its limits. While the link is away nothing is: it would come as a surprise."""
        proxy = self._signals.get(wish.signal)
        if proxy is None:
            return Refused(wish.number, f"there is no signal {wish.signal!r} that can be written")
        if not self._link.connected:
            return Refused(wish.number, _AWAY)
        writing = asyncio.create_task(self._write(proxy, wish))
        self._under_way.add(writing)
        writing.add_done_callback(self._under_way.discard)
        return await asyncio.shield(writing)

    async def _write(self, proxy: Writable[Any], wish: Write) -> Written | Refused:
        setting = asyncio.ensure_future(proxy.set(wish.value))
        try:
            while not (await asyncio.wait([setting], timeout=LOOK_EVERY))[0]:
                if not self._link.connected:
                    return Refused(wish.number, _WENT_AWAY)
            setting.result()
        except UnityLinkError as error:
            return Refused(wish.number, str(error))
        finally:
            setting.cancel()
        self.written += 1
        return Written(wish.number)

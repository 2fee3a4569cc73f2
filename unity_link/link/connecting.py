"""Opening of a link: `connect`, and the object that it returns."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from unity_link.errors import ArgumentError, refusing
from unity_link.link.connection import CONNECT_TIMEOUT, Reconnect
from unity_link.link.interrupts import whole_exit
from unity_link.link.link import NOT_CONNECTED, Link
from unity_link.link.runtimes.runtime import AsyncioRuntime
from unity_link.protocol.wire.numbers import seconds_from
from unity_link.transport import DriverUrl, check_target, has_bus, parse_url

if TYPE_CHECKING:
    from collections.abc import Generator
    from types import TracebackType

    from unity_link.link.runtimes.runtime import Runtime
    from unity_link.link.runtimes.trio_runtime import Structured
    from unity_link.transport import Medium


class Connecting:
    """Result of `connect`: await it for a `Link`, or use it as an async context manager."""

    def __init__(self, target: str | Medium, timeout: float, reconnect: Reconnect | None) -> None:
        self._target = target
        self._timeout = timeout
        self._reconnect = reconnect
        self._link: Link | None = None
        self._structured: Structured | None = None

    if not TYPE_CHECKING:  # A type checker refuses them by itself.
        __enter__ = __exit__ = refusing("write `async with unity_link.connect(...)`, or use `unity_link.blocking`")

        def __getattr__(self, name: str) -> Any:
            raise AttributeError(f"{name}: the link is not open yet: {NOT_CONNECTED}")

    def __await__(self) -> Generator[Any, None, Link]:
        if _is_under_trio():
            raise ArgumentError(
                "under trio a link lives in a block: write `async with unity_link.connect(...) as link`"
            )
        return self.open(AsyncioRuntime()).__await__()

    async def open(self, runtime: Runtime) -> Link:
        """Open a link on a runtime, and return it."""
        target = parse_url(self._target) if isinstance(self._target, str) else self._target
        if isinstance(target, DriverUrl):
            await runtime.prepare(target)
        link = self._link_to(target, runtime)
        await link.open(self._timeout)
        return link

    def _link_to(self, target: DriverUrl | Medium, runtime: Runtime) -> Link:
        if not has_bus(target):
            return Link(target, self._reconnect, runtime=runtime)
        from unity_link.link.mapped import MappedLink

        return MappedLink(target, runtime)

    async def __aenter__(self) -> Link:
        if _is_under_trio():
            self._link = await self._open_structured()
        else:
            self._link = await self.open(AsyncioRuntime())
        return self._link

    @whole_exit
    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        assert self._link is not None
        try:
            await self._link.__aexit__(kind, error, trace)
        finally:
            if self._structured is not None:
                await self._structured.aclose()

    async def _open_structured(self) -> Link:
        from unity_link.link.runtimes.trio_runtime import Structured

        self._structured = Structured()
        try:
            await self._structured.begin()
            return await self.open(self._structured)
        except BaseException:
            await self._structured.aclose()
            raise


def _is_under_trio() -> bool:
    trio = sys.modules.get("trio")
    return trio is not None and bool(trio.lowlevel.in_trio_run())


def connect(
    target: str | Medium, *, timeout: float = CONNECT_TIMEOUT, reconnect: bool | Reconnect = False
) -> Connecting:
    """Open a link to a gateway.

    ::

        async with unity_link.connect("serial:/dev/ttyUSB0?baud=12000000") as link:
            print(await link.read(0x0A))

    Args:
        target: URL of a gateway, or a simulated gateway in this process.
        timeout: most seconds until the session is open, also in each attempt to reconnect.
        reconnect: open a lost connection again; a `Reconnect` sets the pauses. Subscriptions are set up again. Reads,
            and requests that were not sent, are sent in the new session; other requests in flight raise
            `LinkLostError`.

    Raises:
        ArgumentError: for a URL with an unknown scheme, or an argument of another type.
        ConnectError: if no session is open after `timeout` seconds; the text describes the received bytes.
        UnsupportedError: for a gateway of another protocol version.
    """
    if not isinstance(reconnect, bool | Reconnect):
        raise ArgumentError(f"reconnect is True, False or a Reconnect, not {reconnect!r:.80}")
    check_target(target)
    seconds = seconds_from(timeout, "timeout is a number of seconds above 0")
    if isinstance(reconnect, bool):
        return Connecting(target, seconds, Reconnect() if reconnect else None)
    return Connecting(target, seconds, reconnect)

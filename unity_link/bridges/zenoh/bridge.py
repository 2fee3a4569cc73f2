"""The bridge: it shares one gateway with all programs in a Zenoh network."""

from __future__ import annotations

import asyncio
import contextlib
import secrets
from typing import TYPE_CHECKING

from unity_link.bridges.sampled import sampled_groups
from unity_link.bridges.serve.shared import SharedLink
from unity_link.bridges.zenoh.own_link import OwnLink
from unity_link.bridges.zenoh.samples import Samples
from unity_link.bridges.zenoh.signals import ZenohSignals
from unity_link.bridges.zenoh.streams import Streams
from unity_link.data.describing import robot_behind
from unity_link.errors import ConnectError, LinkLostError, first_error
from unity_link.protocol.wire.numbers import seconds_from
from unity_link.transport import DriverUrl, parse_url, prepare
from unity_link.transport.zenoh_session import (
    Declaration,
    Network,
    UnreachableError,
    check_prefix,
    close_session,
    open_session,
)

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable

    import zenoh

    from unity_link.data import Robot
    from unity_link.transport import Medium

NEVER = 1e9
"""Seconds to wait for the gateway, which may be away at the start."""
LOOK = 1.0
"""Seconds between attempts to reach a router, and for which another bridge with the same prefix must answer."""


class ZenohBridge:
    """Shares a gateway with a Zenoh network.

    Args:
        robot_type: class of the robot, as `unity_link.load` returns it.
        target: URL of the gateway, or a medium in this process.
        prefix: prefix of all keys, such as ``robot/1``.
        network: settings of the Zenoh session; None for the defaults.
        poll_hz: rate at which readable registers that nothing samples are polled and published; None not to do so.
        every: least number of seconds between two publications of samples of a group.
        report: called with sentences for the user.

    Raises:
        ArgumentError: for a prefix that Zenoh does not accept.
        ConnectError: if Zenoh is not installed.
    """

    def __init__(
        self,
        robot_type: type[Robot],
        target: str | Medium,
        prefix: str,
        *,
        network: Network | None = None,
        poll_hz: float | None = None,
        every: float = 0.0,
        report: Callable[[str], None] = lambda _: None,
    ) -> None:
        self._robot_type = robot_type
        self._target = parse_url(target) if isinstance(target, str) else target
        self._prefix = check_prefix(prefix)
        self._network = network or Network()
        self._poll_hz = poll_hz
        self._every = seconds_from(every, "every is a number of seconds from 0 on", zero=True)
        self._report = report
        self._samples: list[Samples] = []
        self._signals: ZenohSignals | None = None

    @property
    def published(self) -> int:
        """Number of samples published; samples without subscribers do not count."""
        return sum(samples.published for samples in self._samples)

    @property
    def messages(self) -> int:
        """Number of publications of samples."""
        return sum(samples.messages for samples in self._samples)

    @property
    def lost(self) -> int:
        """Number of samples that the gateway took and that did not reach a publication."""
        return sum(samples.carrier.lost for samples in self._samples)

    @property
    def written(self) -> int:
        """Number of values that clients have written by keys."""
        return 0 if self._signals is None else self._signals.written

    async def run(self) -> None:
        """Run the bridge until this is cancelled.

        Raises:
            ArgumentError: for an endpoint that Zenoh does not accept.
            ConnectError: if another bridge has the prefix, no session can be opened, or the link ends for good.
        """
        if isinstance(self._target, DriverUrl):
            await prepare(self._target)
        async with _session(self._network, self._report) as session:
            token = await asyncio.to_thread(_take_prefix, session, self._prefix)
            shared = SharedLink(self._target, self._report)
            try:
                shared.open_when_there()
                await self._serve(session, self._prefix, shared)
            except LinkLostError:
                if shared.ended.done():
                    # The result has the reason: it raises the error that ended the shared link.
                    shared.ended.result()
                raise
            finally:
                await shared.finish()
                token.undeclare()

    async def _serve(self, session: zenoh.Session, prefix: str, shared: SharedLink) -> None:
        link = OwnLink(shared, self._target)
        try:
            await _open(link, shared)
            robot = await robot_behind(link, self._robot_type)
            groups = sampled_groups(robot, self._poll_hz, is_needed=False)
            self._samples = [Samples(session, prefix, sampled, self._every, self._report) for sampled in groups]
            self._signals = ZenohSignals(session, prefix, robot, shared, self._report)
            streams = Streams(session, prefix, shared)
            try:
                with first_error():
                    async with asyncio.TaskGroup() as tasks:
                        for samples in self._samples:
                            tasks.create_task(samples.run())
                        tasks.create_task(self._signals.run())
                        names, signals = ", ".join(sampled.name for sampled in groups) or "nothing", len(robot.signals)
                        self._report(f"{robot.interface.name} at {prefix}: {names} published, {signals} signals")
            finally:
                streams.close()
        finally:
            await link.aclose()


async def _open(link: OwnLink, shared: SharedLink) -> None:
    """Wait for the gateway, or for an error that ends the shared link for good."""
    opening = asyncio.ensure_future(link.open(NEVER))
    try:
        await asyncio.wait([opening, shared.ended], return_when=asyncio.FIRST_COMPLETED)
        if shared.ended.done():
            shared.ended.result()
        await opening
    finally:
        opening.cancel()


@contextlib.asynccontextmanager
async def _session(network: Network, report: Callable[[str], None]) -> AsyncIterator[zenoh.Session]:
    session, is_reported = None, False
    while session is None:
        try:
            session = await asyncio.to_thread(open_session, network, meeting=True)
        except UnreachableError as error:
            if not is_reported:
                report(f"waiting for the router: {error}")
            is_reported = True
            await asyncio.sleep(LOOK)
    try:
        yield session
    finally:
        await asyncio.to_thread(close_session, session)


def _take_prefix(session: zenoh.Session, prefix: str) -> Declaration:
    """Declare that a bridge has this prefix; raise ConnectError if another bridge has it. Blocks."""
    place = f"{prefix}/@bridge"
    own = f"{place}/{secrets.token_hex(8)}"
    token: Declaration = session.liveliness().declare_token(own)
    others = [
        str(reply.ok.key_expr)
        for reply in session.liveliness().get(f"{place}/*", timeout=LOOK)
        if reply.ok is not None and str(reply.ok.key_expr) != own
    ]
    if others:
        token.undeclare()
        raise ConnectError(f"another bridge has the prefix {prefix}: end that one, or choose another --prefix")
    return token

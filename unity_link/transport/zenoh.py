"""``zenoh:robot/1``: a gateway on another machine, through the bridge ``unity-link zenoh --prefix robot/1``.

Each client has two keys for the protocol's bytes, ``robot/1/@link/CLIENT/up`` and ``/down``. Publications have a count,
by which duplicate and late ones are dropped; the window retransmits lost requests. Each side detects the end of the
other by a liveliness token. By default bridges are searched on this machine only. ``connect=tcp/HOST:PORT`` (several
with commas), ``listen=``, ``mode=client`` and ``config=FILE`` have the meanings of Zenoh's configuration.
"""

from __future__ import annotations

import asyncio
import secrets
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError, ConnectError
from unity_link.transport.zenoh_session import (
    OPEN,
    KeyTransport,
    Network,
    check_prefix,
    close_session,
    find_zenoh,
    open_session,
)

if TYPE_CHECKING:
    import zenoh

    from unity_link.transport import DriverUrl

OPTIONS = frozenset({"connect", "listen", "mode", "config"})
PATIENCE = 2.0
"""Seconds for which a bridge is searched; newly started programs find each other within one second."""
PAUSE = 0.05
LONGEST_ANSWER = 1.0
"""Time limit in seconds for one question; a bridge answers at once."""


async def prepare(url: DriverUrl) -> None:  # noqa: ARG001  (the signature of all drivers)
    """Check that Zenoh is installed.

    Raises:
        ConnectError: if Zenoh is not installed.
    """
    find_zenoh()


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Find the bridge and open a stream to it."""
    if url.host or not url.path:
        raise ArgumentError(f"{url.text} names no prefix: zenoh:robot/1 was expected")
    network = Network(
        connect=tuple(url.options.get("connect", "").split(",")) if url.options.get("connect") else (),
        listen=tuple(url.options.get("listen", "").split(",")) if url.options.get("listen") else (),
        mode=url.options.get("mode"),
        config=url.options.get("config"),
    )
    opening = asyncio.ensure_future(asyncio.to_thread(open_session, network))
    try:
        session = await asyncio.shield(opening)
    except asyncio.CancelledError:
        opening.add_done_callback(_close_late)
        raise
    caller = Caller(session, protocol)
    try:
        await caller.call(check_prefix(url.path))
    except BaseException:
        caller.transport_over()
        raise
    return caller.transport


def _close_late(opening: asyncio.Future[zenoh.Session]) -> None:
    if not opening.cancelled() and opening.exception() is None:
        close_session(opening.result())


class Caller:
    """Opens one stream to a bridge, and closes the Zenoh session with the stream.

    Args:
        session: a Zenoh session that only this stream uses.
        protocol: receives the bytes.
    """

    transport: KeyTransport

    def __init__(self, session: zenoh.Session, protocol: asyncio.Protocol) -> None:
        self._session = session
        self._protocol = protocol
        self._loop = asyncio.get_running_loop()
        self._name = secrets.token_hex(8)

    async def call(self, prefix: str) -> None:
        """Ask the bridge for a stream.

        Raises:
            ConnectError: if no bridge answers, or the bridge refuses.
        """
        import zenoh

        place = f"{prefix}/@link/{self._name}"
        # Keep a reference: Zenoh ends a declaration when its Python object is deleted.
        self._token = self._session.liveliness().declare_token(f"{place}/client")

        def watch(sample: zenoh.Sample) -> None:
            if sample.kind == zenoh.SampleKind.DELETE:
                self._loop.call_soon_threadsafe(self._lost)

        self.transport = KeyTransport(
            self._session, f"{place}/up", f"{place}/down", self._protocol, over=self.transport_over
        )
        self._watch = self._session.liveliness().declare_subscriber(f"{place}/bridge", watch, history=True)
        deadline = self._loop.time() + PATIENCE
        while not (answers := await asyncio.to_thread(self._ask, f"{prefix}/{OPEN}")):
            if self._loop.time() > deadline:
                raise ConnectError(
                    f"no bridge answers at {prefix}: is `unity-link zenoh --prefix {prefix}` running, and do the two "
                    "find each other (connect=tcp/HOST:7447 here, --listen there, or a router for both)?"
                )
            await asyncio.sleep(PAUSE)
        refusal = next((reply.err for reply in answers if reply.err is not None), None)
        if refusal is not None:
            raise ConnectError(f"the bridge at {prefix} refuses: {refusal.payload.to_string()}")
        self._protocol.connection_made(self.transport)

    def _ask(self, key: str) -> list[zenoh.Reply]:
        return list(self._session.get(key, payload=self._name, timeout=LONGEST_ANSWER))

    def _lost(self) -> None:
        self.transport.end(ConnectError("the bridge has gone, or the network to it"))

    def transport_over(self) -> None:
        """Close the Zenoh session in a thread, because closing may block."""
        session, self._session = self._session, None  # type: ignore[assignment]
        if session is not None:
            self._loop.run_in_executor(None, close_session, session)

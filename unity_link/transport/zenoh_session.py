"""Zenoh sessions for links and bridges, and byte streams over two keys.

By default other machines cannot connect: a session listens on the loopback address only, and does not scout by
multicast, because Zenoh would open a port on all addresses for that. Programs on one machine find each other by the
port `MEETING`, Zenoh's default, so that they also find a router on this machine. One of several bridges listens on that
port; if it ends, another one takes the port over.

Zenoh's threads pass samples to the event loop through an `Inbox`.
"""

from __future__ import annotations

import atexit
import contextlib
import importlib.util
import re
import threading
from typing import TYPE_CHECKING, Protocol

import msgspec

from unity_link.errors import ArgumentError, ConnectError
from unity_link.protocol.wire.datagrams import Counts
from unity_link.transport.buffered import BufferedTransport
from unity_link.transport.inbox import Inbox

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Callable

    import zenoh

MEETING = "tcp/127.0.0.1:7447"
ANY_PORT = "tcp/127.0.0.1:0"
PATIENCE = 1.0
"""Seconds to wait for the end of a session."""
OPEN = "@link/open"
"""Key below a prefix at which a client requests a stream. Wildcards of other programs do not match keys with ``@``."""
MOST_PUT = 60_000
"""Largest publication of a stream in bytes: Zenoh would divide longer ones into fragments, and lose all with one."""
MOST_KEPT = 1 << 20
"""Limit in bytes of the buffer while reading is paused; the session retransmits requests that are lost beyond it."""
MOST_QUEUED = 16
"""Length of Zenoh's queue for a slow network, in batches of 64 KiB; the maximum that Zenoh allows."""
_COUNT_DIGITS = 8
_SOURCE_LINE = re.compile(r" at \S+\.rs:\d+\.?| - Caused by")
_PARSING = re.compile(r'msg: "(.*)", location: ')
_UNREACHABLE = "Unable to connect"
_NO_ROUTER_NAMED = "No peer specified"
_RETRY = {"period_init_ms": 100, "period_max_ms": 1000, "period_increase_factor": 2}


class Declaration(Protocol):
    """A publisher, subscriber or token that a session has declared."""

    def undeclare(self) -> object:
        """End the declaration."""


class UnreachableError(ConnectError):
    """A session in client mode finds no peer; a later attempt may succeed."""


class Network(msgspec.Struct, frozen=True, kw_only=True):
    """Settings for finding other sessions."""

    connect: tuple[str, ...] = ()
    """Endpoints to connect to, such as ``tcp/192.168.1.5:7447``."""
    listen: tuple[str, ...] = ()
    """Endpoints to listen on."""
    mode: str | None = None
    """``peer`` or ``client``; a client sends everything through one router."""
    config: str | None = None
    """A configuration file of Zenoh; this module's defaults replace settings that have Zenoh's defaults in the file."""


def open_session(network: Network, *, meeting: bool = False) -> zenoh.Session:
    """Open a session. Blocks for up to half a second if there is no peer.

    Args:
        network: settings for finding other sessions.
        meeting: True if other programs on this machine must be able to find the session.

    Raises:
        ArgumentError: if Zenoh refuses an endpoint, the mode or the file, or a client has no router to connect to.
        ConnectError: if the session cannot listen; `UnreachableError` if a client finds no peer.
    """
    find_zenoh()
    import zenoh

    config = _configuration(network, meeting=meeting)
    try:
        session = zenoh.open(config)
    except zenoh.ZError as error:
        text = explain(error)
        if text.startswith(_NO_ROUTER_NAMED):
            raise ArgumentError("a client of Zenoh needs a router: connect to one, such as tcp/router:7447") from error
        kind = UnreachableError if text.startswith(_UNREACHABLE) else ConnectError
        raise kind(f"no Zenoh session could be opened: {text}") from error
    # Close the session at the latest when Python exits: an open session would crash the process then.
    atexit.register(session.close)
    return session


def close_session(session: zenoh.Session) -> None:
    """Close a session. Blocks for at most `PATIENCE` seconds.

    Zenoh takes ten seconds if the session still tries to listen on an occupied port, so a thread closes the session.
    """
    import zenoh

    def close() -> None:
        with contextlib.suppress(zenoh.ZError):
            session.close()

    atexit.unregister(session.close)
    closing = threading.Thread(target=close, name="zenoh-close", daemon=True)
    closing.start()
    closing.join(PATIENCE)


def explain(error: Exception) -> str:
    """Return the text of an error of Zenoh, without places in Zenoh's sources."""
    text = _SOURCE_LINE.sub("", str(error)).strip()
    parsing = _PARSING.search(text)
    return text if parsing is None else parsing[1]


def check_prefix(prefix: str) -> str:
    """Return a prefix of keys in canonical form.

    Raises:
        ArgumentError: if Zenoh does not allow the prefix.
        ConnectError: if Zenoh is not installed.
    """
    find_zenoh()
    import zenoh

    text = prefix.strip("/")
    with contextlib.suppress(zenoh.ZError):
        if text and not set("*$?#") & set(text) and "/@" not in f"/{text}":
            return str(zenoh.KeyExpr(text))
    expected = "names with / between them were expected, as in robot/1"
    raise ArgumentError(f"{prefix!r} is no prefix of keys: {expected}; no wildcard includes a name that begins with @")


def find_zenoh() -> None:
    """Check that Zenoh is installed.

    Raises:
        ConnectError: if Zenoh is not installed.
    """
    if importlib.util.find_spec("zenoh") is None:
        raise ConnectError("Zenoh is not installed here: pip install 'unity-link[zenoh]'")


def _configuration(network: Network, *, meeting: bool) -> zenoh.Config:
    import zenoh

    untouched = zenoh.Config()
    try:
        config = untouched if network.config is None else zenoh.Config.from_file(network.config)
    except zenoh.ZError as error:
        raise ArgumentError(f"{network.config} is no configuration of Zenoh: {explain(error)}") from error
    values: dict[str, object] = {
        "scouting/multicast/enabled": False,
        "listen/endpoints": [],
        "transport/link/tx/queue/congestion_control/drop/wait_before_drop": 0,
        "transport/link/tx/queue/size/interactive_high": MOST_QUEUED,
    }
    alone = not (network.connect or network.listen or network.mode)
    if alone and _same(config, zenoh.Config(), "connect/endpoints", "listen/endpoints", "mode"):
        values |= {"connect/endpoints": [MEETING], "listen/endpoints": [MEETING, ANY_PORT] if meeting else []}
        values |= {"listen/exit_on_failure": False, "listen/timeout_ms": -1, "listen/retry": _RETRY}
    values = {key: value for key, value in values.items() if _same(config, zenoh.Config(), key)}
    values |= {"connect/retry": _RETRY} if _same(config, zenoh.Config(), "connect/retry") else {}
    given = {"mode": network.mode, "connect/endpoints": network.connect, "listen/endpoints": network.listen}
    values |= {key: value for key, value in given.items() if value}
    for key, value in values.items():
        try:
            config.insert_json5(key, msgspec.json.encode(value).decode())
        except zenoh.ZError as error:
            raise ArgumentError(
                f"Zenoh does not take {msgspec.json.encode(value).decode()} for {key}: {explain(error)}"
            ) from error
    return config


def _same(one: zenoh.Config, other: zenoh.Config, *keys: str) -> bool:
    return all(one.get_json(key) == other.get_json(key) for key in keys)


class KeyTransport(BufferedTransport):
    """A byte stream over two keys: written bytes are published on one key, and received ones come from the other.

    Publications are lost if the network is slower than the stream, because the event loop must not block; the session
    retransmits lost requests. Several routers may deliver a publication twice or late. Each publication therefore
    begins with a count, like a datagram (docs/protocol.md, "Datagrams"), and is dropped if a newer one has arrived.

    Args:
        session: an open session.
        there: key to publish on.
        back: key to subscribe to.
        protocol: receives the bytes.
        over: is called when the stream ends.
    """

    def __init__(
        self,
        session: zenoh.Session,
        there: str,
        back: str,
        protocol: asyncio.Protocol,
        over: Callable[[], None] = lambda: None,
    ) -> None:
        import zenoh

        super().__init__(protocol)
        self._over = over
        self._kept: list[bytes] = []
        self._kept_bytes = 0
        self._counts = Counts()
        self._inbox: Inbox[bytes] = Inbox(self._receive)
        give = self._inbox.give
        publisher = session.declare_publisher(
            there,
            congestion_control=zenoh.CongestionControl.DROP,
            priority=zenoh.Priority.INTERACTIVE_HIGH,
        )
        subscriber = session.declare_subscriber(back, lambda sample: give(sample.payload.to_bytes()))
        self._put = publisher.put
        self._declared: tuple[Declaration, ...] = (subscriber, publisher)

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Publish bytes."""
        import zenoh

        if self._closing:
            return
        for start in range(0, len(data), MOST_PUT):
            try:
                self._put(b"%0*X" % (_COUNT_DIGITS, self._counts.next()) + data[start : start + MOST_PUT])
            except zenoh.ZError as error:
                self.end(ConnectError(f"the Zenoh session has ended: {explain(error)}"))

    def _receive(self, pieces: list[bytes]) -> None:
        data = b"".join(piece[_COUNT_DIGITS:] for piece in pieces if self._is_newer(piece))
        if self._closing or not data:
            return
        # Buffered bytes are delivered first.
        if self._reading and not self._kept:
            self._protocol.data_received(data)
        elif self._kept_bytes + len(data) <= MOST_KEPT:
            self._kept.append(data)
            self._kept_bytes += len(data)

    def _is_newer(self, piece: bytes) -> bool:
        try:
            return self._counts.takes(int(piece[:_COUNT_DIGITS], 16))
        except ValueError:
            return False

    def resume_reading(self) -> None:
        """Deliver received bytes again."""
        self._reading = True
        self._loop.call_soon(self._read_kept)

    def _read_kept(self) -> None:
        if self._reading and self._kept and not self._closing:
            kept, self._kept, self._kept_bytes = self._kept, [], 0
            self._protocol.data_received(b"".join(kept))

    def set_write_buffer_limits(self, high: int | None = None, low: int | None = None) -> None:
        """Do nothing: written bytes are not buffered."""

    def get_write_buffer_size(self) -> int:
        """Return 0: written bytes are not buffered."""
        return 0

    def close(self) -> None:
        """Close the stream."""
        self.end(None)

    def abort(self) -> None:
        """Close the stream."""
        self.end(None)

    def end(self, reason: Exception | None) -> None:
        """Close the stream, and report the reason to the protocol. Further calls do nothing."""
        if self._closing:
            return
        self._closing = True
        self._inbox.close()
        for declared in self._declared:
            declared.undeclare()
        self._over()
        self._loop.call_soon(self._protocol.connection_lost, reason)

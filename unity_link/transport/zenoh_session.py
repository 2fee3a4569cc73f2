"""Sessions of Zenoh as links need them: who finds whom, and a stream of bytes over two keys.

By default nothing can be reached from other machines: a session listens on the loopback address alone, and does not
scout by multicast, for which Zenoh opens a port on all addresses. Programs of one machine find each other by one port
of it, `MEETING`: it is Zenoh's own, so a router there is found as well. Of several bridges one has that port, and
another takes it over when that one ends.

The threads of Zenoh and the event loop meet in an `Inbox`.
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
"""Seconds that the end of a session is waited for."""
OPEN = "@link/open"
"""Below a prefix: where a client asks for a stream. What stands below ``@link`` is in no ``*`` or ``**`` of others."""
MOST_PUT = 60_000
"""Bytes of one publication of a stream: more would go in fragments, which are lost together."""
MOST_KEPT = 1 << 20
"""Bytes that wait for a protocol that does not read; the protocol makes up for what is lost beyond."""
MOST_QUEUED = 16
"""Batches of 64 KiB that wait for a slow network, of a stream: as many as Zenoh takes."""
_COUNT_DIGITS = 8
_SOURCE_LINE = re.compile(r" at \S+\.rs:\d+\.?| - Caused by")
_PARSING = re.compile(r'msg: "(.*)", location: ')
_UNREACHABLE = "Unable to connect"
_NO_ROUTER_NAMED = "No peer specified"
_RETRY = {"period_init_ms": 100, "period_max_ms": 1000, "period_increase_factor": 2}


class Declaration(Protocol):
    """A declaration of a session."""

    def undeclare(self) -> object:
        """End it."""


class UnreachableError(ConnectError):
    """Raised where a session that is a client finds no peer; one may come yet."""


class Network(msgspec.Struct, frozen=True, kw_only=True):
    """Settings by which a session finds others."""

    connect: tuple[str, ...] = ()
    """Endpoints to connect to, such as ``tcp/192.168.1.5:7447``."""
    listen: tuple[str, ...] = ()
    """Endpoints to listen at."""
    mode: str | None = None
    """``peer`` or ``client``; a client has all go through one router."""
    config: str | None = None
    """A configuration file of Zenoh; what it leaves at Zenoh's defaults is at those of this module."""


def open_session(network: Network, *, meeting: bool = False) -> zenoh.Session:
    """Open a session. Blocks, up to half a second where no peer is there.

    Args:
        network: how it finds others.
        meeting: whether others of this machine are to find it.

    Raises:
        ArgumentError: for an endpoint, a mode or a file that Zenoh does not take, or a client that names no router.
        ConnectError: where it can't listen; `UnreachableError` where as a client it finds no peer.
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
    # One that is left open when Python ends takes the process with it.
    atexit.register(session.close)
    return session


def close_session(session: zenoh.Session) -> None:
    """Close a session. Blocks, for `PATIENCE` at most.

    Zenoh waits ten seconds for a session that still tries to listen at a port that another has; it does so in a thread.
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
    """Return what Zenoh says of an error, without the lines of its sources."""
    text = _SOURCE_LINE.sub("", str(error)).strip()
    parsing = _PARSING.search(text)
    return text if parsing is None else parsing[1]


def check_prefix(prefix: str) -> str:
    """Return a prefix that keys can begin with.

    Raises:
        ArgumentError: for one that Zenoh does not take.
        ConnectError: where Zenoh is not installed.
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
    """See that Zenoh is installed.

    Raises:
        ConnectError: where it is not.
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
    """A stream over two keys: what is written is published at one, and what is published at the other is read.

    Publications may be lost where the network is slower than the stream, and the loop never waits for it: the protocol
    on top repeats what it misses. They may come twice or late where several routers hand them on. So each begins with
    its count, as datagrams have it (docs/protocol.md, "Datagrams"), and what is not newer than all before is dropped.

    Args:
        session: an open session.
        there: the key to publish at.
        back: the key to subscribe to.
        protocol: who writes and reads.
        over: is called when it ends.
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
        # What was kept is delivered first.
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
        """Read again."""
        self._reading = True
        self._loop.call_soon(self._read_kept)

    def _read_kept(self) -> None:
        if self._reading and self._kept and not self._closing:
            kept, self._kept, self._kept_bytes = self._kept, [], 0
            self._protocol.data_received(b"".join(kept))

    def set_write_buffer_limits(self, high: int | None = None, low: int | None = None) -> None:
        """Do nothing: what is written is not kept."""

    def get_write_buffer_size(self) -> int:
        """Return 0: what is written is not kept."""
        return 0

    def close(self) -> None:
        """End."""
        self.end(None)

    def abort(self) -> None:
        """End."""
        self.end(None)

    def end(self, reason: Exception | None) -> None:
        """End, and tell the protocol why. May be called again."""
        if self._closing:
            return
        self._closing = True
        self._inbox.close()
        for declared in self._declared:
            declared.undeclare()
        self._over()
        self._loop.call_soon(self._protocol.connection_lost, reason)

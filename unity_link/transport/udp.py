"""``udp://host:port``: a gateway on the network. A datagram holds whole frames; the window makes up for lost ones.

Each connection has a socket of its own, and so a port of its own, and one session with the gateway. ``?interface=eth1``
has it send and hear by that interface alone, and ``?ttl=1`` pass so many routers less one. ``?mtu=576`` keeps its
packets, and those of the gateway, so short; otherwise the link finds the longest that the network carries.
"""

from __future__ import annotations

import asyncio
import contextlib
import errno
import socket
import sys
from typing import TYPE_CHECKING, Any, NamedTuple, cast

from unity_link.errors import ArgumentError, ConnectError
from unity_link.protocol.host.datagrams import HostDatagrams
from unity_link.protocol.window.constants import QUICK_TIMEOUT
from unity_link.protocol.wire.path import HEADERS, HEADERS_6, LONGEST_MTU, SHORTEST_MTU, Path
from unity_link.transport.channel import refused_as
from unity_link.transport.tcp import NAMELESS, address

if TYPE_CHECKING:
    from collections.abc import Iterator
    from contextlib import AbstractContextManager

    from unity_link.transport import DriverUrl
    from unity_link.transport.channel import Channel

OPTIONS = frozenset({"interface", "mtu", "ttl"})
MOST_TTL = 255
_IP_MTU, _IPV6_MTU = 14, 24
"""Linux: options of a connected socket, the MTU of its path as far as the system knows it (ip(7), ipv6(7))."""
RECEIVE_BUFFER = 1 << 22
"""Bytes that wait in the system, as far as it allows so many: those of the blocks that are asked for at a time."""
LARGE = 512
"""Bytes of a datagram behind which there are probably others."""
LARGEST = 65_536
LONGEST_TRY = 0.2
"""Seconds after which a question is asked again, at most: a datagram that is lost leaves no sign, and one more is no
load to the network."""
MOST_KEPT = 1 << 18
"""Bytes of frames that are kept while nothing is read; what comes beyond them is lost, as on the way."""
MOST_TOGETHER = 64
"""Datagrams that are read on in one turn of the loop."""


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Open a socket that speaks with one gateway only."""
    host, port = address(url)
    settings, loop = Settings.of(url), asyncio.get_running_loop()

    path = path_of(url)

    def adapter() -> DatagramAdapter:
        return DatagramAdapter(protocol, url.node, path)

    with refused(host, port):
        if settings == Settings(None, None):
            # The event loop makes the socket, since one that simulates a network has none of the system.
            return (await loop.create_datagram_endpoint(adapter, remote_addr=(host, port)))[1]
        opened = settings.connected(await loop.getaddrinfo(host, port, type=socket.SOCK_DGRAM))
        try:
            return (await loop.create_datagram_endpoint(adapter, sock=opened))[1]
        except BaseException:
            opened.close()
            raise


def open_channel(url: DriverUrl, timeout: float | None) -> Channel:  # noqa: ARG001  (nothing is waited for)
    """Open a socket that speaks with one gateway only, without an event loop."""
    host, port = address(url)
    settings, path = Settings.of(url), path_of(url)
    with refused(host, port):
        opened = settings.connected(socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM))
    return DatagramChannel(opened, HostDatagrams(url.node, path), path)


def path_of(url: DriverUrl) -> Path:
    """Return the network to the gateway of a URL.

    Raises:
        ArgumentError: for an MTU that no network has.
    """
    if "mtu" not in url.options:
        return Path()
    mtu = url.integer("mtu", 0)
    if not SHORTEST_MTU <= mtu <= LONGEST_MTU:
        raise ArgumentError(f"mtu={mtu} in {url.text} is not from {SHORTEST_MTU} to {LONGEST_MTU}")
    return Path(mtu)


def _known_mtu(opened: socket.socket) -> int:
    """Return the MTU of a connected socket's path as far as the system knows it."""
    if sys.platform != "linux":
        return LONGEST_MTU
    is_6 = opened.family == socket.AF_INET6
    try:
        return opened.getsockopt(socket.IPPROTO_IPV6 if is_6 else socket.IPPROTO_IP, _IPV6_MTU if is_6 else _IP_MTU)
    except OSError:
        # A simulated or closed socket has none.
        return LONGEST_MTU


def _learn(error: OSError, path: Path, opened: socket.socket) -> None:
    """Take the MTU that a router has told to the system; `error` is what the system then returns, once."""
    if error.errno == errno.EMSGSIZE:
        path.lower(_known_mtu(opened))


class Settings(NamedTuple):
    """The options of a URL for its socket."""

    interface: str | None
    ttl: int | None

    @classmethod
    def of(cls, url: DriverUrl) -> Settings:
        """Return those of a URL.

        Raises:
            ArgumentError: for a TTL that cannot be, or an interface without a name.
        """
        interface = url.options.get("interface")
        if interface == "":
            raise ArgumentError(f"interface= in {url.text} names no network interface, as eth1 is one")
        if "ttl" not in url.options:
            return cls(interface, None)
        ttl = url.integer("ttl", 0)
        if not 1 <= ttl <= MOST_TTL:
            raise ArgumentError(f"ttl={ttl} in {url.text} is not from 1 to {MOST_TTL}")
        return cls(interface, ttl)

    def connected(self, known: list[tuple[Any, Any, int, str, Any]]) -> socket.socket:
        """Return a socket for the first of some addresses that one can be connected to.

        Raises:
            ConnectError: for an interface that is not there, or a system that has no choice of it.
            OSError: where none can.
        """
        refusal: OSError | None = None
        for family, kind, protocol, _, remote in known:
            opened = socket.socket(family, kind, protocol)
            try:
                opened.settimeout(0)
                self._set(opened, family)
                opened.connect(remote)
            except OSError as error:
                opened.close()
                refusal = error
            except BaseException:
                opened.close()
                raise
            else:
                return opened
        raise refusal or OSError("it has no address")

    def _set(self, opened: socket.socket, family: int) -> None:
        """Set what must be set before the system chooses a route."""
        if self.interface is not None:
            _bind_to(opened, self.interface)
        if self.ttl is not None and family == socket.AF_INET6:
            opened.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_UNICAST_HOPS, self.ttl)
        elif self.ttl is not None:
            opened.setsockopt(socket.IPPROTO_IP, socket.IP_TTL, self.ttl)


def _bind_to(opened: socket.socket, interface: str) -> None:
    option = getattr(socket, "SO_BINDTODEVICE", None)
    if option is None:
        raise ConnectError(f"interface={interface} is only had on Linux; leave it out, and set a route instead")
    try:
        opened.setsockopt(socket.SOL_SOCKET, option, interface.encode())
    except OSError as error:
        if error.errno != errno.ENODEV:
            raise
        names = ", ".join(name for _, name in socket.if_nameindex())
        raise ConnectError(f"there is no network interface {interface}; there are {names}") from error


def refused(host: str, port: int) -> AbstractContextManager[None]:
    """Raise ConnectError for what the system refuses in the block, for a port of a host."""
    return refused_as(
        f"no socket for port {port} of {host}",
        lambda error: "is the name right?" if isinstance(error, NAMELESS) else "",
    )


class DatagramChannel:
    """Looks like a stream, and sends datagrams.

    Args:
        opened: is connected to the gateway, and the channel's from now on.
        datagrams: of the session.
        path: the network to the gateway.
    """

    shortest_timeout = QUICK_TIMEOUT
    longest_try = LONGEST_TRY

    def __init__(self, opened: socket.socket, datagrams: HostDatagrams, path: Path) -> None:
        _prepare(opened, path)
        self.path = path
        self._socket = opened
        self._datagrams = datagrams
        self._heard = False
        self.fileno = opened.fileno
        self.close = opened.close

    def read(self) -> bytes:
        """Return the frames of datagrams that are neither late nor doubled; raises ConnectError at the end."""
        if not self._heard:
            try:
                first = self._socket.recv(LARGEST)
            except ConnectionRefusedError:
                raise _nobody() from None
            self._heard = True
            return self._datagrams.take(first)
        return b"".join(map(self._datagrams.take, _read_on(self._socket, self.path)))

    def write(self, data: bytes | bytearray | memoryview) -> int:
        """Send whole frames; a datagram that the system does not take is as good as lost."""
        for datagram in self._datagrams.put(bytes(data)):
            try:
                self._socket.send(datagram)
            except ConnectionRefusedError:
                if not self._heard:
                    raise _nobody() from None
            except OSError as error:
                _learn(error, self.path, self._socket)
        return len(data)


def _prepare(opened: socket.socket, path: Path) -> None:
    path.begin(HEADERS_6 if opened.family == socket.AF_INET6 else HEADERS, _known_mtu(opened))
    opened.settimeout(0)
    # Some systems refuse what is beyond their limit, others take the limit.
    with contextlib.suppress(OSError):
        opened.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, RECEIVE_BUFFER)


class DatagramAdapter(asyncio.Transport, asyncio.DatagramProtocol):
    """Looks like a stream to `protocol`, and sends datagrams.

    Args:
        protocol: reads and writes.
        node: number of the gateway on a shared medium, or None.
        path: the network to the gateway.
    """

    def __init__(self, protocol: asyncio.Protocol, node: int | None, path: Path) -> None:
        super().__init__({"shortest_timeout": QUICK_TIMEOUT, "longest_try": LONGEST_TRY, "path": path})
        self._protocol = protocol
        self._path = path
        self._datagrams = HostDatagrams(node, path)
        self._socket: socket.socket | None = None
        self._over: ConnectError | None = None
        self._heard = False
        self._reading = True
        self._kept = b""
        """Frames that arrived while nothing was read."""
        self._endpoint: asyncio.DatagramTransport | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Begin."""
        self._endpoint = cast("asyncio.DatagramTransport", transport)
        known = transport.get_extra_info("socket")
        if known is not None:
            # What an event loop tells of its socket can't be read from.
            self._socket = socket.fromfd(known.fileno(), known.family, known.type)
            _prepare(self._socket, self._path)
        self._protocol.connection_made(self)

    def datagram_received(self, data: bytes, _: object) -> None:
        """Hand on the frames of datagrams that are neither late nor doubled; end where the session is over."""
        self._heard = True
        frames = self._take(data)
        if len(data) >= LARGE and self._socket is not None:
            frames += b"".join(map(self._take, _read_on(self._socket, self._path)))
        if frames and self._reading:
            self._protocol.data_received(frames)
        elif len(self._kept) < MOST_KEPT:
            self._kept += frames

    def pause_reading(self) -> None:
        """Hand nothing on until `resume_reading`."""
        self._reading = False

    def resume_reading(self) -> None:
        """Hand on what has arrived meanwhile, and what arrives."""
        self._reading = True
        kept, self._kept = self._kept, b""
        if kept:
            self._protocol.data_received(kept)

    def _take(self, datagram: bytes) -> bytes:
        try:
            return self._datagrams.take(datagram)
        except ConnectError as error:
            self._over = error
            self.abort()
            return b""

    def error_received(self, exc: Exception) -> None:
        """End where nothing listens; later, a datagram that was refused is as good as lost."""
        if isinstance(exc, OSError) and self._socket is not None:
            _learn(exc, self._path, self._socket)
        if isinstance(exc, ConnectionRefusedError) and not self._heard:
            self._over = _nobody()
            self.abort()

    def connection_lost(self, exc: Exception | None) -> None:
        """Hand on the end."""
        if self._socket is not None:
            self._socket.close()
        self._protocol.connection_lost(exc or self._over)

    def pause_writing(self) -> None:
        """Hand on."""
        self._protocol.pause_writing()

    def resume_writing(self) -> None:
        """Hand on."""
        self._protocol.resume_writing()

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Send whole frames."""
        if self._endpoint is not None:
            for datagram in self._datagrams.put(bytes(data)):
                self._endpoint.sendto(datagram)

    def is_closing(self) -> bool:
        """Return whether the socket is closing."""
        return self._endpoint is None or self._endpoint.is_closing()

    def close(self) -> None:
        """Close the socket."""
        if self._endpoint is not None:
            self._endpoint.close()

    def abort(self) -> None:
        """Close the socket at once."""
        if self._endpoint is not None:
            self._endpoint.abort()


def _nobody() -> ConnectError:
    return ConnectError("nothing listens at that port; is the gateway served, and the port right?")


def _read_on(opened: socket.socket, path: Path) -> Iterator[bytes]:
    """Read what has come: turns of an event loop cost more than datagrams. Behind a small one there is rarely more."""
    try:
        for _ in range(MOST_TOGETHER):
            datagram = opened.recv(LARGEST)
            yield datagram
            if len(datagram) < LARGE:
                return
    except OSError as error:
        _learn(error, path, opened)

"""``udp://host:port``: a gateway on the network.

A datagram holds complete frames; lost datagrams are retransmitted by the window. Each connection has its own socket and
port, and one session with the gateway. ``?interface=eth1`` restricts it to one network interface, and ``?ttl=1`` sets
the time to live of its packets. ``?mtu=576`` limits the packets of both sides to 576 bytes; otherwise the link finds
the longest packets that the network carries.
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
"""Socket options IP_MTU and IPV6_MTU of Linux: the path MTU of a connected socket, as known so far (ip(7), ipv6(7))."""
RECEIVE_BUFFER = 1 << 22
"""Requested size of the system's receive buffer in bytes: enough for all block reads in flight."""
LARGE = 512
"""Size of a datagram in bytes from which on more datagrams are probably pending."""
LARGEST = 65_536
LONGEST_TRY = 0.2
"""Upper limit in seconds of the time between two tries of the handshake: lost datagrams are not reported."""
MOST_KEPT = 1 << 18
"""Limit in bytes of the frames that are buffered while reading is paused; frames beyond it are dropped."""
MOST_TOGETHER = 64
"""Largest number of pending datagrams that are read in one turn of the event loop."""


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Open a socket that is connected to one gateway."""
    host, port = address(url)
    settings, loop = Settings.of(url), asyncio.get_running_loop()

    path = path_of(url)

    def adapter() -> DatagramAdapter:
        return DatagramAdapter(protocol, url.node, path)

    with refused(host, port):
        if settings == Settings(None, None):
            # Let the event loop create the socket: an event loop with a simulated network has no system sockets.
            return (await loop.create_datagram_endpoint(adapter, remote_addr=(host, port)))[1]
        opened = settings.connected(await loop.getaddrinfo(host, port, type=socket.SOCK_DGRAM))
        try:
            return (await loop.create_datagram_endpoint(adapter, sock=opened))[1]
        except BaseException:
            opened.close()
            raise


def open_channel(url: DriverUrl, timeout: float | None) -> Channel:  # noqa: ARG001  (opening never waits)
    """Open a socket that is connected to one gateway, without an event loop."""
    host, port = address(url)
    settings, path = Settings.of(url), path_of(url)
    with refused(host, port):
        opened = settings.connected(socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM))
    return DatagramChannel(opened, HostDatagrams(url.node, path), path)


def path_of(url: DriverUrl) -> Path:
    """Return the network path to the gateway of a URL.

    Raises:
        ArgumentError: if the MTU is out of range.
    """
    if "mtu" not in url.options:
        return Path()
    mtu = url.integer("mtu", 0)
    if not SHORTEST_MTU <= mtu <= LONGEST_MTU:
        raise ArgumentError(f"mtu={mtu} in {url.text} is not from {SHORTEST_MTU} to {LONGEST_MTU}")
    return Path(mtu)


def _known_mtu(opened: socket.socket) -> int:
    """Return the path MTU of a connected socket in bytes, as the system knows it; LONGEST_MTU if it is unknown."""
    if sys.platform != "linux":
        return LONGEST_MTU
    is_6 = opened.family == socket.AF_INET6
    try:
        return opened.getsockopt(socket.IPPROTO_IPV6 if is_6 else socket.IPPROTO_IP, _IPV6_MTU if is_6 else _IP_MTU)
    except OSError:
        # Simulated and closed sockets do not have this option.
        return LONGEST_MTU


def _lower_mtu(error: OSError, path: Path, opened: socket.socket) -> None:
    """Lower the MTU of a path if `error` is EMSGSIZE: the system returns it once after a router reports a lower MTU."""
    if error.errno == errno.EMSGSIZE:
        path.lower(_known_mtu(opened))


class Settings(NamedTuple):
    """Socket options in a URL."""

    interface: str | None
    ttl: int | None

    @classmethod
    def of(cls, url: DriverUrl) -> Settings:
        """Return the socket options of a URL.

        Raises:
            ArgumentError: if the TTL is out of range, or the name of the interface is empty.
        """
        interface = url.options.get("interface")
        if interface == "":
            raise ArgumentError(
                f"interface= in {url.text} names no network interface: a name such as eth1 was expected"
            )
        if "ttl" not in url.options:
            return cls(interface, None)
        ttl = url.integer("ttl", 0)
        if not 1 <= ttl <= MOST_TTL:
            raise ArgumentError(f"ttl={ttl} in {url.text} is not from 1 to {MOST_TTL}")
        return cls(interface, ttl)

    def connected(self, known: list[tuple[Any, Any, int, str, Any]]) -> socket.socket:
        """Return a socket that is connected to the first usable one of some addresses.

        Args:
            known: results of `socket.getaddrinfo`.

        Raises:
            ConnectError: if the interface does not exist, or the system cannot select an interface.
            OSError: if no address is usable.
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
        """Set the options, before the system chooses a route."""
        if self.interface is not None:
            _bind_to(opened, self.interface)
        if self.ttl is not None and family == socket.AF_INET6:
            opened.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_UNICAST_HOPS, self.ttl)
        elif self.ttl is not None:
            opened.setsockopt(socket.IPPROTO_IP, socket.IP_TTL, self.ttl)


def _bind_to(opened: socket.socket, interface: str) -> None:
    option = getattr(socket, "SO_BINDTODEVICE", None)
    if option is None:
        raise ConnectError(f"interface={interface} works on Linux only; remove it, and set a route instead")
    try:
        opened.setsockopt(socket.SOL_SOCKET, option, interface.encode())
    except OSError as error:
        if error.errno != errno.ENODEV:
            raise
        names = ", ".join(name for _, name in socket.if_nameindex())
        raise ConnectError(f"there is no network interface {interface}; there are {names}") from error


def refused(host: str, port: int) -> AbstractContextManager[None]:
    """Convert an OSError or UnicodeError in the block to a ConnectError about a port of a host."""
    return refused_as(
        f"no socket for port {port} of {host}",
        lambda error: "is the name right?" if isinstance(error, NAMELESS) else "",
    )


class DatagramChannel:
    """A channel that sends and receives its bytes in datagrams.

    Args:
        opened: a socket that is connected to the gateway; the channel closes it.
        datagrams: packs and unpacks the datagrams of the session.
        path: network path to the gateway.
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
        """Return the frames of received datagrams, without late and duplicate ones.

        Raises:
            ConnectError: if no program listens on the port, or the gateway has ended the session.
        """
        if not self._heard:
            try:
                first = self._socket.recv(LARGEST)
            except ConnectionRefusedError:
                raise _nobody() from None
            self._heard = True
            return self._datagrams.take(first)
        return b"".join(map(self._datagrams.take, _read_on(self._socket, self.path)))

    def write(self, data: bytes | bytearray | memoryview) -> int:
        """Send complete frames; datagrams that the system refuses count as lost."""
        for datagram in self._datagrams.put(bytes(data)):
            try:
                self._socket.send(datagram)
            except ConnectionRefusedError:
                if not self._heard:
                    raise _nobody() from None
            except OSError as error:
                _lower_mtu(error, self.path, self._socket)
        return len(data)


def _prepare(opened: socket.socket, path: Path) -> None:
    path.begin(HEADERS_6 if opened.family == socket.AF_INET6 else HEADERS, _known_mtu(opened))
    opened.settimeout(0)
    # Above their limit, some systems refuse the value, and others use the limit.
    with contextlib.suppress(OSError):
        opened.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, RECEIVE_BUFFER)


class DatagramAdapter(asyncio.Transport, asyncio.DatagramProtocol):
    """A transport that sends and receives the bytes of a stream in datagrams.

    Args:
        protocol: receives the bytes.
        node: node number of the gateway on a shared medium; None if the medium is not shared.
        path: network path to the gateway.
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
        """Frames that arrived while reading was paused."""
        self._endpoint: asyncio.DatagramTransport | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Prepare the socket, and connect the protocol."""
        self._endpoint = cast("asyncio.DatagramTransport", transport)
        known = transport.get_extra_info("socket")
        if known is not None:
            # The event loop's socket object does not allow reading, so make another one for the same descriptor.
            self._socket = socket.fromfd(known.fileno(), known.family, known.type)
            _prepare(self._socket, self._path)
        self._protocol.connection_made(self)

    def datagram_received(self, data: bytes, _: object) -> None:
        """Pass on the frames of received datagrams, without late and duplicate ones; close after the session's end."""
        self._heard = True
        frames = self._take(data)
        if len(data) >= LARGE and self._socket is not None:
            frames += b"".join(map(self._take, _read_on(self._socket, self._path)))
        if frames and self._reading:
            self._protocol.data_received(frames)
        elif len(self._kept) < MOST_KEPT:
            self._kept += frames

    def pause_reading(self) -> None:
        """Buffer received frames until `resume_reading`, up to a limit."""
        self._reading = False

    def resume_reading(self) -> None:
        """Pass on the buffered frames, and later ones as they arrive."""
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
        """Close if no program listens on the port; after the first answer, refused datagrams count as lost."""
        if isinstance(exc, OSError) and self._socket is not None:
            _lower_mtu(exc, self._path, self._socket)
        if isinstance(exc, ConnectionRefusedError) and not self._heard:
            self._over = _nobody()
            self.abort()

    def connection_lost(self, exc: Exception | None) -> None:
        """Pass on the end of the connection."""
        if self._socket is not None:
            self._socket.close()
        self._protocol.connection_lost(exc or self._over)

    def pause_writing(self) -> None:
        """Pass the call on."""
        self._protocol.pause_writing()

    def resume_writing(self) -> None:
        """Pass the call on."""
        self._protocol.resume_writing()

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Send complete frames."""
        if self._endpoint is not None:
            for datagram in self._datagrams.put(bytes(data)):
                self._endpoint.sendto(datagram)

    def is_closing(self) -> bool:
        """Return True if the socket is closing or closed."""
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
    """Yield pending datagrams without another turn of the event loop; stop after a small one, usually the last."""
    try:
        for _ in range(MOST_TOGETHER):
            datagram = opened.recv(LARGEST)
            yield datagram
            if len(datagram) < LARGE:
                return
    except OSError as error:
        _lower_mtu(error, path, opened)

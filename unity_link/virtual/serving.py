"""Gateways for other programs: over a pty, TCP, a Unix socket or UDP.

`serve_pty`, `serve_tcp`, `serve_unix` and `serve_udp` are asynchronous context managers that give the URL to use.
A served gateway lives on between its clients, as a board does: what it publishes while none is there is lost. It has
one client at a time. On TCP and Unix sockets a second one is told so in a line of text and hung up on, so that nobody
takes a running robot away from its controller by accident; on UDP a second one that opens a session takes the gateway,
and the first is told (docs/protocol.md, "Datagrams").

Everything passes through a `GatewayTransport`. When the client does not read, that one is told to pause, and when that
one is full, the client is not read from; nothing in between grows.
"""

from __future__ import annotations

import array
import asyncio
import contextlib
import io
import os
import secrets
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from unity_link.errors import ConnectError
from unity_link.protocol.gateway.datagrams import GatewayDatagrams
from unity_link.protocol.wire import discovery
from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.datagrams import NO_SESSION
from unity_link.protocol.wire.frames import end_of_last
from unity_link.protocol.wire.messages import Codec
from unity_link.transport.listening import LOOPBACK, checked_host, listen_tcp, listen_unix, port_error, serving, url_of
from unity_link.virtual.transport import GatewayTransport
from unity_link.virtual.uart import UartLine

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Iterator

    from unity_link.virtual.gateway import Gateway

BUSY = b"this gateway serves another client; try again when that has gone\r\n"
GRACE = 0.1
"""Seconds that a new client waits for the one before to go: hanging up may be heard later than calling again."""
_LONGEST_REST = 65536
_VIRTUAL = bytes.fromhex("02554D")
"""First half of the MAC address of a virtual gateway, of which the rest is random."""
_TCGETS2, _TERMIOS2_SIZE, _OUTPUT_SPEED = 0x802C542A, 64, 10
"""Linux: how a terminal tells a speed that is none of the old ones; size and place are of `struct termios2`."""


class ClientCounter(asyncio.Protocol):
    """Connection between a gateway and its client of the moment."""

    def __init__(self, gateway: Gateway) -> None:
        self.gateway = GatewayTransport(gateway, self, at_once=True)
        self.sender: asyncio.WriteTransport | None = None
        """Transport for bytes to the client."""
        self.reader: asyncio.ReadTransport | None = None
        """Transport for bytes of the client."""
        self.connected: set[asyncio.Transport] = set()
        """All connections: that of the client, and those that are still to be served or refused."""
        self._over = False

    @property
    def taken(self) -> bool:
        """Return whether there is a client."""
        return self.reader is not None

    def leave(self) -> None:
        """Record that the client has gone."""
        self.sender = self.reader = None
        self.gateway.resume_reading()

    def admit(self, transport: asyncio.Transport) -> bool:
        """Record a connection; return False for one that was made when all had been hung up on."""
        if self._over:
            transport.abort()
        else:
            self.connected.add(transport)
        return not self._over

    def hang_up(self) -> None:
        """End all connections, and admit none any more."""
        self._over = True
        for transport in tuple(self.connected):
            transport.abort()

    # Called by the gateway's side

    def data_received(self, data: bytes) -> None:
        """Hand on what the gateway sends; without a client it is lost."""
        if self.sender is not None:
            self.sender.write(data)

    def pause_writing(self) -> None:
        """Stop listening to the client."""
        if self.reader is not None:
            self.reader.pause_reading()

    def resume_writing(self) -> None:
        """Listen again."""
        if self.reader is not None:
            self.reader.resume_reading()


class _Client(asyncio.Protocol):
    """The client's side of a stream."""

    def __init__(self, counter: ClientCounter) -> None:
        self._counter = counter
        self._served = False
        self._transport: asyncio.Transport

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        # No check by class: the transports of uvloop are of none of asyncio's.
        self._transport = client = cast("asyncio.Transport", transport)
        if not self._counter.admit(client):
            return
        if self._counter.taken:
            client.pause_reading()
            asyncio.get_running_loop().call_later(GRACE, self._serve_or_refuse, client)
        else:
            self._serve(client)

    def _serve(self, transport: asyncio.Transport) -> None:
        self._served = True
        self._counter.sender = self._counter.reader = transport

    def _serve_or_refuse(self, transport: asyncio.Transport) -> None:
        if transport.is_closing():
            return
        if self._counter.taken:
            self._refuse(transport)
        else:
            self._serve(transport)
            transport.resume_reading()

    def _refuse(self, transport: asyncio.Transport) -> None:
        transport.write(BUSY)
        # It may have reset the connection meanwhile.
        with contextlib.suppress(OSError):
            transport.write_eof()
        # To close with something unread would reset the connection, and the client would not see what was written.
        transport.resume_reading()
        asyncio.get_running_loop().call_later(GRACE, transport.close)

    def data_received(self, data: bytes) -> None:
        if self._served:
            self._counter.gateway.write(data)

    def pause_writing(self) -> None:
        if self._served:
            self._counter.gateway.pause_reading()

    def resume_writing(self) -> None:
        if self._served:
            self._counter.gateway.resume_reading()

    def connection_lost(self, _: Exception | None) -> None:
        self._counter.connected.discard(self._transport)
        if self._served:
            self._counter.leave()


@contextlib.asynccontextmanager
async def _counter(gateway: Gateway) -> AsyncIterator[ClientCounter]:
    counter = ClientCounter(gateway)
    try:
        yield counter
    finally:
        counter.gateway.abort()


@contextlib.contextmanager
def _hanging_up(counter: ClientCounter) -> Iterator[None]:
    """Hang up on all clients at the end."""
    try:
        yield
    finally:
        counter.hang_up()


@serving("a gateway")
async def serve_tcp(gateway: Gateway, port: int = 0, host: str = LOOPBACK) -> AsyncIterator[str]:
    """Serve a gateway on a TCP port; 0 chooses a free one. Gives its URL.

    Raises:
        ConnectError: where the port can't be opened.
    """
    async with _counter(gateway) as counter, listen_tcp(lambda: _Client(counter), port, host) as url:
        with _hanging_up(counter):
            yield url


@serving("a gateway")
async def serve_unix(gateway: Gateway, path: str | os.PathLike[str]) -> AsyncIterator[str]:
    """Serve a gateway on a Unix socket that only this user may open, and that is removed at the end. Gives its URL.

    Raises:
        ConnectError: where something else is at the path, or it can't be used.
    """
    async with _counter(gateway) as counter, listen_unix(lambda: _Client(counter), path) as url:
        with _hanging_up(counter):
            yield url


class _DatagramClients(asyncio.DatagramProtocol, asyncio.Transport):
    """The clients' side of a datagram socket: a stream towards the gateway, datagrams towards its clients."""

    def __init__(self, counter: ClientCounter, codec: Codec, name: str) -> None:
        super().__init__()
        self._socket: asyncio.DatagramTransport
        self._info = codec.info
        self._name = name
        self._mac = _VIRTUAL + secrets.token_bytes(3)
        self._datagrams: GatewayDatagrams[Any] = GatewayDatagrams(codec, counter.gateway.write, self._send)
        self._counter = counter
        self._rest = b""
        self._reading = True
        counter.sender = counter.reader = self

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self._socket = cast("asyncio.DatagramTransport", transport)

    def datagram_received(self, data: bytes, addr: Any) -> None:
        if discovery.asked(data, self._mac):
            self._send(discovery.answer(self._found()), addr)
        elif self._reading:
            self._datagrams.take(data, addr)

    def _found(self) -> discovery.Found:
        info = self._info
        return discovery.Found(
            self._mac,
            # A socket is reached under the addresses of its machine, and takes no other.
            discovery.NOWHERE,
            info.build_id,
            Feature.FINGERPRINT in info.features,
            self._datagrams.session != NO_SESSION,
            self._name,
        )

    def error_received(self, exc: Exception) -> None:
        """Ignore that the host does not listen any more: a board would not hear of it."""

    def pause_writing(self) -> None:
        self._counter.gateway.pause_reading()

    def resume_writing(self) -> None:
        self._counter.gateway.resume_reading()

    # Called by the gateway's side

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Send whole frames; the beginning of one waits for its end."""
        data = self._rest + data
        end = end_of_last(data)
        self._rest = data[end:] if len(data) - end <= _LONGEST_REST else b""
        self._datagrams.put(data[:end])

    def pause_reading(self) -> None:
        """Lose the datagrams that come from now on, as a board does that has no room for them."""
        self._reading = False

    def resume_reading(self) -> None:
        """Take datagrams again."""
        self._reading = True

    def _send(self, datagram: bytes, address: Any) -> None:
        self._socket.sendto(datagram, address)


@serving("a gateway")
async def serve_udp(
    gateway: Gateway, port: int = 0, host: str = LOOPBACK, *, node: int | None = None, name: str = ""
) -> AsyncIterator[str]:
    """Serve a gateway on a UDP port; 0 chooses a free one. Gives its URL. `unity-link find` finds it.

    Args:
        gateway: what is served.
        port: of this machine.
        host: the network address to listen at.
        node: the gateway's number on a shared medium, or None.
        name: what it is called where it is found.

    Raises:
        ConnectError: where the port can't be opened.
    """
    async with _counter(gateway) as counter:
        loop = asyncio.get_running_loop()
        try:
            codec = Codec(gateway.info, node)
            transport, _ = await loop.create_datagram_endpoint(
                lambda: _DatagramClients(counter, codec, name), local_addr=(checked_host(host), port)
            )
        except (OSError, OverflowError, UnicodeError) as error:
            raise port_error("UDP", host, port, error) from error
        try:
            yield url_of("udp", host, transport.get_extra_info("sockname")[1])
        finally:
            transport.close()
            # The port is free in the next turn of the loop.
            await asyncio.sleep(0)


class _PtySide(_Client):
    """One direction of a pty, which asyncio treats as two pipes."""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self._transport = cast("asyncio.Transport", transport)
        self._served = True
        # The transport of a write pipe calls itself a read transport, too.
        if isinstance(transport, asyncio.WriteTransport):
            self._counter.sender = transport
        elif isinstance(transport, asyncio.ReadTransport):
            self._counter.reader = transport


@serving("a gateway")
async def serve_pty(
    gateway: Gateway, link: str | os.PathLike[str] | None = None, *, baud: float | None = None
) -> AsyncIterator[str]:
    """Serve a gateway on a pseudo terminal, which looks like a serial port. Gives its URL.

    The port may be closed and opened again; what the gateway sends meanwhile waits in the terminal until that is full.

    Args:
        gateway: what is served.
        link: path of a symbolic link to the terminal, under which it can be found again; removed at the end.
        baud: speed of the gateway's UART, bits a second: a client whose port has another hears garbage, and so does
            the gateway. None for a terminal whose speed is of no effect, as usual.

    Raises:
        ConnectError: where there is something at the path already, or no terminal is left.
    """
    async with contextlib.AsyncExitStack() as stack:
        try:
            master, port = os.openpty()
        except OSError as error:
            raise ConnectError(f"no pseudo terminal can be opened ({error.strerror or error})") from error
        if baud is not None:
            gateway = UartLine(gateway, baud, lambda: _speed(master))
        counter = await stack.enter_async_context(_counter(gateway))
        # As long as the port's side is open here, a client may come and go.
        stack.callback(os.close, port)
        # Not there on Windows, where nothing above is either.
        import tty

        tty.setraw(port)
        name = os.ttyname(port)
        reading = stack.enter_context(io.FileIO(master, "r"))
        writing = stack.enter_context(io.FileIO(os.dup(master), "w"))
        if link is not None:
            name = str(_linked(_absolute(link), name, stack))
        loop = asyncio.get_running_loop()
        reader, _ = await loop.connect_read_pipe(lambda: _PtySide(counter), reading)
        stack.callback(reader.close)
        sender, _ = await loop.connect_write_pipe(lambda: _PtySide(counter), writing)
        stack.callback(sender.abort)
        yield f"serial:{name}"


def _speed(master: int) -> float:
    """Return the speed that the other side of a pseudo terminal has set."""
    # Not there on Windows, where there are no pseudo terminals either.
    import fcntl

    settings = array.array("i", bytes(_TERMIOS2_SIZE))
    fcntl.ioctl(master, _TCGETS2, settings)
    return settings[_OUTPUT_SPEED]


def _absolute(path: str | os.PathLike[str]) -> Path:
    return Path(path).absolute()


def _linked(link: Path, name: str, stack: contextlib.AsyncExitStack) -> Path:
    """Make a symbolic link to a terminal; one that leads nowhere any more is replaced."""
    try:
        if link.is_symlink() and not link.exists():
            link.unlink()
        link.symlink_to(name)
    except OSError as error:
        raise ConnectError(
            f"{link} can't be made a link ({error.strerror}): remove it, or choose another path"
        ) from error
    stack.callback(link.unlink, missing_ok=True)
    return link

"""Serves gateways to other programs: over a pty, TCP, a Unix socket or UDP.

`serve_pty`, `serve_tcp`, `serve_unix` and `serve_udp` are asynchronous context managers that yield the URL. A served
gateway keeps its state between clients, as a board does; samples without a client are lost. It has one client at a
time. On TCP and Unix sockets a second client gets a line of text, and its connection is closed, so that it cannot take
a running robot from its controller by accident. On UDP a second client that opens a session gets the gateway, and the
first one is notified (docs/protocol.md, "Datagrams").

All bytes pass through a `GatewayTransport`, with flow control: it is paused while the client does not read, and the
client is paused while the transport is full.
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
"""Seconds that a new client waits for the end of the earlier one, whose disconnection may be noticed later."""
_LONGEST_REST = 65536
_VIRTUAL = bytes.fromhex("02554D")
"""First half of the MAC address of a virtual gateway; the second half is random."""
_TCGETS2, _TERMIOS2_SIZE, _OUTPUT_SPEED = 0x802C542A, 64, 10
"""Linux: ioctl that reads any baud rate of a terminal; size of `struct termios2`, and index of the rate in it."""


class ClientCounter(asyncio.Protocol):
    """The connections of a served gateway, of which at most one is the client."""

    def __init__(self, gateway: Gateway) -> None:
        self.gateway = GatewayTransport(gateway, self, at_once=True)
        self.sender: asyncio.WriteTransport | None = None
        """Transport to the client; None without a client."""
        self.reader: asyncio.ReadTransport | None = None
        """Transport from the client; None without a client."""
        self.connected: set[asyncio.Transport] = set()
        """All connections: that of the client, and those that wait to be served or refused."""
        self._over = False

    @property
    def taken(self) -> bool:
        """True if there is a client."""
        return self.reader is not None

    def leave(self) -> None:
        """Record that the client has disconnected."""
        self.sender = self.reader = None
        self.gateway.resume_reading()

    def admit(self, transport: asyncio.Transport) -> bool:
        """Record a connection and return True; after `hang_up` close it and return False."""
        if self._over:
            transport.abort()
        else:
            self.connected.add(transport)
        return not self._over

    def hang_up(self) -> None:
        """Close all connections, and accept no more."""
        self._over = True
        for transport in tuple(self.connected):
            transport.abort()

    # Called by the gateway's side

    def data_received(self, data: bytes) -> None:
        """Pass bytes of the gateway to the client; without a client they are lost."""
        if self.sender is not None:
            self.sender.write(data)

    def pause_writing(self) -> None:
        """Pause reading from the client."""
        if self.reader is not None:
            self.reader.pause_reading()

    def resume_writing(self) -> None:
        """Resume reading from the client."""
        if self.reader is not None:
            self.reader.resume_reading()


class _Client(asyncio.Protocol):
    """A connection of a client or of a further program, over a stream."""

    def __init__(self, counter: ClientCounter) -> None:
        self._counter = counter
        self._served = False
        self._transport: asyncio.Transport

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        # Do not check the class: uvloop's transports are not derived from asyncio's.
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
        # The other side may have reset the connection already.
        with contextlib.suppress(OSError):
            transport.write_eof()
        # Closing with unread bytes would reset the connection, and the program would not get the text.
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
    """Close all connections at the end of the block."""
    try:
        yield
    finally:
        counter.hang_up()


@serving("a gateway")
async def serve_tcp(gateway: Gateway, port: int = 0, host: str = LOOPBACK) -> AsyncIterator[str]:
    """Serve a gateway on a TCP port, and yield its URL; port 0 chooses a free port.

    Raises:
        ConnectError: if the port cannot be opened.
    """
    async with _counter(gateway) as counter, listen_tcp(lambda: _Client(counter), port, host) as url:
        with _hanging_up(counter):
            yield url


@serving("a gateway")
async def serve_unix(gateway: Gateway, path: str | os.PathLike[str]) -> AsyncIterator[str]:
    """Serve a gateway on a Unix socket that only this user can open, and yield its URL; remove the socket at the end.

    Raises:
        ConnectError: if the path belongs to another file or a running server, or cannot be used.
    """
    async with _counter(gateway) as counter, listen_unix(lambda: _Client(counter), path) as url:
        with _hanging_up(counter):
            yield url


class _DatagramClients(asyncio.DatagramProtocol, asyncio.Transport):
    """The clients of a gateway on a UDP socket: converts between their datagrams and the gateway's stream."""

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
            # The IP address is that of this machine, and a host cannot assign another one.
            discovery.NOWHERE,
            info.build_id,
            Feature.FINGERPRINT in info.features,
            self._datagrams.session != NO_SESSION,
            self._name,
        )

    def error_received(self, exc: Exception) -> None:
        """Ignore the error that the client's port is closed: a board would not notice it."""

    def pause_writing(self) -> None:
        self._counter.gateway.pause_reading()

    def resume_writing(self) -> None:
        self._counter.gateway.resume_reading()

    # Called by the gateway's side

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Send complete frames; keep the beginning of an incomplete one until its end follows."""
        data = self._rest + data
        end = end_of_last(data)
        self._rest = data[end:] if len(data) - end <= _LONGEST_REST else b""
        self._datagrams.put(data[:end])

    def pause_reading(self) -> None:
        """Drop received datagrams from now on, as a board with full buffers does."""
        self._reading = False

    def resume_reading(self) -> None:
        """Process received datagrams again."""
        self._reading = True

    def _send(self, datagram: bytes, address: Any) -> None:
        self._socket.sendto(datagram, address)


@serving("a gateway")
async def serve_udp(
    gateway: Gateway, port: int = 0, host: str = LOOPBACK, *, node: int | None = None, name: str = ""
) -> AsyncIterator[str]:
    """Serve a gateway on a UDP port, and yield its URL; `unity-link find` finds the gateway.

    Args:
        gateway: the gateway.
        port: UDP port; 0 chooses a free port.
        host: network address to listen on.
        node: node number of the gateway on a shared medium; None if the medium is not shared.
        name: name of the gateway in the results of a search.

    Raises:
        ConnectError: if the port cannot be opened.
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
            # The event loop closes the socket in its next turn.
            await asyncio.sleep(0)


class _PtySide(_Client):
    """One direction of a pty, which is two pipes for asyncio."""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self._transport = cast("asyncio.Transport", transport)
        self._served = True
        # Check for a write transport first: that of a write pipe is an instance of both classes.
        if isinstance(transport, asyncio.WriteTransport):
            self._counter.sender = transport
        elif isinstance(transport, asyncio.ReadTransport):
            self._counter.reader = transport


@serving("a gateway")
async def serve_pty(
    gateway: Gateway, link: str | os.PathLike[str] | None = None, *, baud: float | None = None
) -> AsyncIterator[str]:
    """Serve a gateway on a pseudo-terminal, which looks like a serial port, and yield its URL.

    The port may be closed and opened again; meanwhile the gateway's bytes wait in the terminal until it is full.

    Args:
        gateway: the gateway.
        link: path of a symbolic link to the terminal, which is removed at the end; None for no link.
        baud: baud rate of the gateway's UART; if the client's port has another rate, both sides receive wrong bytes.
            None if the rate has no effect, as usual for a pseudo-terminal.

    Raises:
        ConnectError: if a file exists at the path of the link, or the system has no free terminal.
    """
    async with contextlib.AsyncExitStack() as stack:
        try:
            master, port = os.openpty()
        except OSError as error:
            raise ConnectError(f"no pseudo terminal can be opened ({error.strerror or error})") from error
        if baud is not None:
            gateway = UartLine(gateway, baud, lambda: _speed(master))
        counter = await stack.enter_async_context(_counter(gateway))
        # Keep the port's side open: otherwise the terminal would end with the first client.
        stack.callback(os.close, port)
        # Windows does not have this module, nor pseudo-terminals.
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
    """Return the baud rate that the other side of a pseudo-terminal has set."""
    # Windows does not have this module, nor pseudo-terminals.
    import fcntl

    settings = array.array("i", bytes(_TERMIOS2_SIZE))
    fcntl.ioctl(master, _TCGETS2, settings)
    return settings[_OUTPUT_SPEED]


def _absolute(path: str | os.PathLike[str]) -> Path:
    return Path(path).absolute()


def _linked(link: Path, name: str, stack: contextlib.AsyncExitStack) -> Path:
    """Make a symbolic link to a terminal, in the place of a dangling link if there is one."""
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

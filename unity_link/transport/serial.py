"""``serial:/dev/ttyUSB0?baud=12000000``: a serial port, USB adapter or pseudo-terminal.

The transport is that of pyserial-asyncio-fast, the maintained fork of pyserial-asyncio. The fork writes at once instead
of waiting until the port is writable, which saves one turn of the event loop for each request.
``library=pyserial-asyncio`` selects the original. `SerialPort` adapts pyserial's port to fast links, for both
libraries:

- a write is one system call, which may write a part of the bytes (pyserial blocks the event loop while a port is full);
- a read is one system call of up to 64 KiB (pyserial makes two calls, and the libraries read 1 KiB);
- closing does not wait until all bytes are sent: the operating system sends the rest (pyserial blocks the loop);
- an unplugged port ends the connection, and is not reported to the loop's exception handler.
"""

from __future__ import annotations

import asyncio
import errno
import functools
import importlib
import logging
import os
import sys
from typing import TYPE_CHECKING, Any

import serial

from unity_link.errors import ArgumentError, ConnectError
from unity_link.protocol.window.constants import QUICK_TIMEOUT, SHORTEST_TIMEOUT
from unity_link.transport.channel import LARGEST_READ, has_ended

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.transport import DriverUrl
    from unity_link.transport.channel import Channel

if sys.platform != "win32":
    import termios

log = logging.getLogger("unity_link.transport")
OPTIONS = frozenset({"baud", "rtscts", "library"})
DEFAULT_BAUD = 115_200
NODES_SHARE = True
DEFAULTS = {"baud": str(DEFAULT_BAUD), "rtscts": "0"}
"""Default values of the port's options."""
_MOST_BAUD = (1 << 31) - 1
"""Largest baud rate that the system can represent."""
_BITS = 10
"""Bits on the line for each byte, including start and stop bit."""
DEFAULT_LIBRARY = "pyserial-asyncio-fast"
LIBRARIES = {DEFAULT_LIBRARY: "serial_asyncio_fast", "pyserial-asyncio": "serial_asyncio"}
"""Module of each package that connects pyserial to asyncio."""
_PSEUDO_TERMINALS = range(136, 144)
"""Major device numbers of pseudo-terminals on Linux."""


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Open a serial port exclusively."""
    make_transport = _transport_class(_library(url))
    port = _open(url)
    loop = asyncio.get_running_loop()
    transport: asyncio.Transport = make_transport(loop, protocol, port)
    port.on_failure = functools.partial(loop.call_soon, _give_up, transport)
    if _library(url) == DEFAULT_LIBRARY:
        # The fork (0.16) keeps its writer registered after all bytes are written, and then fails in each turn of the
        # loop. Its public method `flush` removes the writer.
        port.on_drained = transport.flush  # type: ignore[attr-defined]  # asyncio's has none
    # The library calls `connection_made` in the next turn of the loop; the port accepts writes only after that.
    await asyncio.sleep(0)
    return transport


def open_channel(url: DriverUrl, timeout: float | None) -> Channel:  # noqa: ARG001  (a port opens at once)
    """Open a serial port exclusively, without an event loop."""
    _library(url)
    return PortChannel(_open(url))


if sys.platform == "win32":
    # On Windows a thread cannot wait for a port and other events at the same time, so an event loop must open it.
    del open_channel


def _library(url: DriverUrl) -> str:
    library = url.options.get("library", DEFAULT_LIBRARY)
    if library not in LIBRARIES:
        raise ArgumentError(f"library={library} in {url.text} is neither {' nor '.join(LIBRARIES)}")
    return library


def _open(url: DriverUrl) -> SerialPort:
    if url.host:
        raise ArgumentError(f"{url.text} names a host, {url.host}: did you mean {url.without_host}?")
    if not url.path:
        raise ArgumentError(f"{url.text} names no port: serial:/dev/ttyUSB0?baud=115200 was expected")
    baud = url.integer("baud", DEFAULT_BAUD)
    if not 0 < baud <= _MOST_BAUD:
        raise ArgumentError(f"baud={baud} in {url.text} is not from 1 to {_MOST_BAUD}")
    rtscts = url.flag("rtscts")
    try:
        port = SerialPort(url.path, baudrate=baud, rtscts=rtscts, timeout=0, write_timeout=0, exclusive=True)
    except (serial.SerialException, OSError, ValueError) as error:
        raise ConnectError(_explain(url.path, error)) from error
    port.keep_settings()
    return port


def _give_up(transport: asyncio.Transport) -> None:
    if not transport.is_closing():
        transport.abort()


@functools.cache
def _transport_class(library: str) -> Any:
    try:
        module = importlib.import_module(LIBRARIES[library])
    except ImportError:
        raise ConnectError(f"{library} is not installed here: pip install 'unity-link[{library}]'") from None

    class PortTransport(module.SerialTransport):  # type: ignore[misc, name-defined]  # it is not known before
        """The library's transport, with `set_again` and, for a pseudo-terminal, `shortest_timeout` as extra info."""

        def __init__(self, loop: asyncio.AbstractEventLoop, protocol: asyncio.Protocol, port: SerialPort) -> None:
            super().__init__(loop, protocol, port)
            self._told: dict[str, object] = {"set_again": port.set_again}
            if port.is_pseudo_terminal:
                self._told["shortest_timeout"] = QUICK_TIMEOUT

        def get_extra_info(self, name: str, default: object = None) -> Any:
            """Return information about the port."""
            return self._told.get(name, super().get_extra_info(name, default))

    return PortTransport


def _explain(path: str, error: Exception) -> str:
    number = getattr(error, "errno", None)
    if number == errno.ENOENT:
        return f"there is no port {path}; is the adapter plugged in?"
    if number == errno.EACCES:
        return f"no permission for {path}: join the group of the port (ls -l {path}; usually dialout) and log in again"
    if number in (errno.EAGAIN, errno.EBUSY) or "exclusively lock" in str(error):
        return f"{path} is in use by another program: close that, or share the link"
    return f"{path} is no usable serial port ({error})"


def _settings_of(port: serial.Serial) -> list[Any]:
    """Return the settings of a terminal; an empty list if the system has no terminals or the port is lost."""
    if sys.platform == "win32" or port.fd is None:
        return []
    try:
        return termios.tcgetattr(port.fd)
    except termios.error:
        return []


class SerialPort(serial.Serial):
    """A port whose reads and writes never block."""

    on_drained: Callable[[], None] | None = None
    """Is called by the first complete write after an incomplete one."""
    on_failure: Callable[[], object] | None = None
    """Is called if a write fails."""
    _short = False

    def keep_settings(self) -> None:
        """Store the settings of the port for `set_again`."""
        self._settings = _settings_of(self)

    def set_again(self) -> None:
        """Restore the settings of the port if another program has changed them, as ``stty sane`` does."""
        if _settings_of(self) in ([], self._settings):
            return
        log.warning("%s: another program has changed the settings of the port; they are set again", self.port)
        try:
            termios.tcsetattr(self, termios.TCSANOW, self._settings)
            # Assigning the rate sets it again: termios has no constants for some rates.
            self.baudrate = self.baudrate
            termios.tcflush(self, termios.TCIFLUSH)
        except (OSError, termios.error, serial.SerialException) as error:
            log.warning("%s: the settings of the port could not be set again (%s)", self.port, error)

    @property
    def is_pseudo_terminal(self) -> bool:
        """Return True if the port is a pseudo-terminal, whose other end is another program."""
        return os.major(os.fstat(self.fileno()).st_rdev) in _PSEUDO_TERMINALS

    def read(self, size: int = 1, /) -> bytes:  # noqa: ARG002  (more than the libraries ask for is welcome to them)
        """Return all received bytes.

        Raises:
            SerialException: if the port is lost.
        """
        assert self.fd is not None
        try:
            data = os.read(self.fd, LARGEST_READ)
        except BlockingIOError:
            return b""
        except OSError as error:
            raise serial.SerialException(error.errno, error.strerror) from error
        if not data and has_ended(self.fd):
            raise serial.SerialException("the port is gone")
        return data

    def write(self, data: Any, /) -> int:
        """Write as many bytes as the port accepts, and return their number; BlockingIOError if it accepts none."""
        assert self.fd is not None
        try:
            written = os.write(self.fd, data)
        except BlockingIOError:
            self._short = True
            raise
        except OSError:
            # Do not raise the error: the library would report it to the loop's exception handler.
            if self.on_failure is not None:
                self.on_failure()
            return len(data)
        if written < len(data):
            self._short = True
        elif self._short:
            self._short = False
            if self.on_drained is not None:
                self.on_drained()
        return written

    def flush(self) -> None:
        """Do nothing: the operating system sends the bytes that it has buffered."""


class PortChannel:
    """A serial port as a channel."""

    def __init__(self, port: SerialPort) -> None:
        self.shortest_timeout = QUICK_TIMEOUT if port.is_pseudo_terminal else SHORTEST_TIMEOUT
        self.byte_time = _BITS / port.baudrate
        self.set_again = port.set_again
        self.close = port.close
        self._descriptor: int = port.fileno()

    def fileno(self) -> int:
        """Return the file descriptor."""
        return self._descriptor

    def read(self) -> bytes:
        """Return the received bytes."""
        data = os.read(self._descriptor, LARGEST_READ)
        if not data and has_ended(self._descriptor):
            raise EOFError
        return data

    def write(self, data: bytes | bytearray | memoryview) -> int:
        """Write as many bytes as the port accepts, and return their number."""
        return os.write(self._descriptor, data)

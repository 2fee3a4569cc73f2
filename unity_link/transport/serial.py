"""``serial:/dev/ttyUSB0?baud=12000000``: a serial port, USB adapter or pseudo-terminal.

Built on pyserial-asyncio-fast, the kept fork of pyserial-asyncio: it tries each write at once instead of waiting for
the port to become writable, which is one turn of the event loop less on every request. ``library=pyserial-asyncio``
chooses the original. What a fast link needs and a terminal does not is put into the port that either is given, and not
into its transport:

- a write is one system call that takes what fits (pyserial's tries for ever while a port is full, and
  the loop with it);
- a read is one system call of up to 64 KiB (pyserial's are two calls, and the libraries ask for 1 KiB);
- closing leaves it to the operating system to send what it has taken (the original would have the loop wait for it);
- a port that was unplugged is a lost connection, not a report to the loop's exception handler.
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
"""Values of the port's options where none are given."""
_MOST_BAUD = (1 << 31) - 1
"""Largest baud rate that the system can hold."""
_BITS = 10
"""Bits of a byte, with start and stop bit."""
DEFAULT_LIBRARY = "pyserial-asyncio-fast"
LIBRARIES = {DEFAULT_LIBRARY: "serial_asyncio_fast", "pyserial-asyncio": "serial_asyncio"}
"""The module of each package that joins pyserial to asyncio."""
_PSEUDO_TERMINALS = range(136, 144)
"""Major numbers of their device files on Linux."""


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Open a serial port for this program alone."""
    make_transport = _transport_class(_library(url))
    port = _open(url)
    loop = asyncio.get_running_loop()
    transport: asyncio.Transport = make_transport(loop, protocol, port)
    port.on_failure = functools.partial(loop.call_soon, _give_up, transport)
    if _library(url) == DEFAULT_LIBRARY:
        # The fork (0.16) goes on watching for writability when all is written, and then fails in every turn of the
        # loop. Its public `flush` ends the watching.
        port.on_drained = transport.flush  # type: ignore[attr-defined]  # asyncio's has none
    # It tells the protocol in the next turn of the loop only, and until then there is nothing to write to.
    await asyncio.sleep(0)
    return transport


def open_channel(url: DriverUrl, timeout: float | None) -> Channel:  # noqa: ARG001  (a port opens at once)
    """Open a serial port for this program alone, without an event loop."""
    _library(url)
    return PortChannel(_open(url))


if sys.platform == "win32":
    # A port is nothing there that a thread can wait for beside others: an event loop has it.
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
        """The library's transport, which also tells how soon a pseudo-terminal answers, and sets the port again."""

        def __init__(self, loop: asyncio.AbstractEventLoop, protocol: asyncio.Protocol, port: SerialPort) -> None:
            super().__init__(loop, protocol, port)
            self._told: dict[str, object] = {"set_again": port.set_again}
            if port.is_pseudo_terminal:
                self._told["shortest_timeout"] = QUICK_TIMEOUT

        def get_extra_info(self, name: str, default: object = None) -> Any:
            """Return what is known of the port."""
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
    """Return what a terminal is set to; nothing where the system has no terminals, or the port is gone."""
    if sys.platform == "win32" or port.fd is None:
        return []
    try:
        return termios.tcgetattr(port.fd)
    except termios.error:
        return []


class SerialPort(serial.Serial):
    """A port that takes and gives at once what it can."""

    on_drained: Callable[[], None] | None = None
    """Is called where a write took everything after one that did not."""
    on_failure: Callable[[], object] | None = None
    """Is called where a write has failed."""
    _short = False

    def keep_settings(self) -> None:
        """Remember the settings of the port, for `set_again`."""
        self._settings = _settings_of(self)

    def set_again(self) -> None:
        """Set the port as it was opened where another program has set it otherwise since, as ``stty sane`` does."""
        if _settings_of(self) in ([], self._settings):
            return
        log.warning("%s: another program has changed the settings of the port; they are set again", self.port)
        try:
            termios.tcsetattr(self, termios.TCSANOW, self._settings)
            # Sets a speed that termios has no number for.
            self.baudrate = self.baudrate
            termios.tcflush(self, termios.TCIFLUSH)
        except (OSError, termios.error, serial.SerialException) as error:
            log.warning("%s: the settings of the port could not be set again (%s)", self.port, error)

    @property
    def is_pseudo_terminal(self) -> bool:
        """Return whether another program is the other end."""
        return os.major(os.fstat(self.fileno()).st_rdev) in _PSEUDO_TERMINALS

    def read(self, size: int = 1, /) -> bytes:  # noqa: ARG002  (more than the libraries ask for is welcome to them)
        """Return all that has come.

        Raises:
            SerialException: where the port is gone.
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
        """Write what fits; raises BlockingIOError where nothing does."""
        assert self.fd is not None
        try:
            written = os.write(self.fd, data)
        except BlockingIOError:
            self._short = True
            raise
        except OSError:
            # To raise it would have the library report it to the loop.
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
        """Leave what the operating system has taken to it."""


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
        """Return what has come."""
        data = os.read(self._descriptor, LARGEST_READ)
        if not data and has_ended(self._descriptor):
            raise EOFError
        return data

    def write(self, data: bytes | bytearray | memoryview) -> int:
        """Write what fits."""
        return os.write(self._descriptor, data)

"""``serial:/dev/ttyUSB0?baud=12000000``: a serial port, USB adapter or pseudo-terminal.

Built on pyserial-asyncio-fast, the kept fork of pyserial-asyncio: it tries each write at once instead of waiting for
the port to become writable, which is one turn of the event loop less on every request. Its transport is taken over with
four changes, for what a fast link needs and a terminal does not:

- a write is one system call that takes what fits (pyserial's tries for ever while a port is full, and
  the loop with it);
- whole reads of up to 64 KiB, by one system call as well (its own are of 1 KiB, by two);
- an end to watching for writability when all is written (it never stops, and then fails in every turn of the loop);
- a port that was unplugged is a lost connection, not a report to the loop's exception handler.
"""

from __future__ import annotations

import asyncio
import errno
import os
from typing import TYPE_CHECKING, Any

import serial
from serial_asyncio_fast import SerialTransport

from unity_link.errors import ArgumentError, ConnectError
from unity_link.protocol.constants import QUICK_TIMEOUT

if TYPE_CHECKING:
    from unity_link.transport import DriverUrl

OPTIONS = frozenset({"baud", "rtscts"})
DEFAULT_BAUD = 115_200
LARGEST_READ = 65_536
_PSEUDO_TERMINALS = range(136, 144)
"""Major numbers of their device files on Linux."""


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Open a serial port for this program alone."""
    if not url.path:
        raise ArgumentError(f"{url.text} names no port: serial:/dev/ttyUSB0?baud=115200 was expected")
    baud = url.integer("baud", DEFAULT_BAUD)
    if baud <= 0:
        raise ArgumentError(f"baud={baud} in {url.text} is not positive")
    rtscts = url.flag("rtscts")
    try:
        port = SerialPort(url.path, baudrate=baud, rtscts=rtscts, timeout=0, write_timeout=0, exclusive=True)
    except (serial.SerialException, OSError, ValueError) as error:
        raise ConnectError(_explain(url.path, error)) from error
    transport = PortTransport(asyncio.get_running_loop(), protocol, port)
    # It tells the protocol in the next turn of the loop only, and until then there is nothing to write to.
    await asyncio.sleep(0)
    return transport


def _explain(path: str, error: Exception) -> str:
    number = getattr(error, "errno", None)
    if number == errno.ENOENT:
        return f"there is no port {path}; is the adapter plugged in?"
    if number == errno.EACCES:
        return f"no permission for {path}: join the group of the port (ls -l {path}; usually dialout) and log in again"
    if number in (errno.EAGAIN, errno.EBUSY) or "exclusively lock" in str(error):
        return f"{path} is in use by another program: close that, or share the link"
    return f"{path} is no usable serial port ({error})"


class SerialPort(serial.Serial):
    """A port that says at once how much it took."""

    def write(self, data: Any, /) -> int:
        """Write what fits; raises BlockingIOError where nothing does."""
        assert self.fd is not None
        return os.write(self.fd, data)


class PortTransport(SerialTransport):
    """The library's transport, with the changes that this module's docstring gives."""

    def __init__(self, loop: asyncio.AbstractEventLoop, protocol: asyncio.Protocol, port: serial.Serial) -> None:
        super().__init__(loop, protocol, port)
        self._descriptor = port.fileno()
        if os.major(os.fstat(self._descriptor).st_rdev) in _PSEUDO_TERMINALS:
            self._extra["shortest_timeout"] = QUICK_TIMEOUT  # type: ignore[attr-defined]  # asyncio tells it by this

    def _read_ready(self) -> None:
        try:
            data = os.read(self._descriptor, LARGEST_READ)
        except (BlockingIOError, InterruptedError):
            return
        except OSError as error:
            self._abort(error)
            return
        if data:
            self._protocol.data_received(data)
        else:
            self._abort(None)

    def _write_ready(self) -> None:
        if self._write_buffer:
            super()._write_ready()
        if not self._write_buffer:
            self._remove_writer()

    def _fatal_error(self, exc: BaseException, message: str = "") -> None:  # noqa: ARG002  (the library's signature)
        self._abort(exc)

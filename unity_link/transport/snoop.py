"""Writes and reads snoops: files with all bytes of connections and their times.

Each record is written by one system call, so that earlier records are complete even if the program is killed. Only one
program at a time writes a snoop. A snoop may hold several connections; a program that opens an existing snoop appends.
"""

from __future__ import annotations

import logging
import mmap
import os
import stat
import threading
import time
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from unity_link.capture import pcapng
from unity_link.capture.pcapng import DamagedFileError, Packet
from unity_link.errors import ArgumentError, UnityLinkError
from unity_link.transport.locking import lock_file

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

log = logging.getLogger("unity_link.snoop")


class Snoop:
    """A snoop that is being written.

    Args:
        path: path of the file.

    Raises:
        ArgumentError: if the file cannot be created, is not a snoop, or is being written by another program.
    """

    _open: dict[Path, Snoop] = {}  # noqa: RUF012  (shared: all snoops of this process)
    _opening = threading.Lock()

    def __init__(self, path: Path) -> None:
        self._path = path
        self._interfaces = 0
        self._lock = threading.Lock()
        try:
            self._file: int | None = _open(path)
        except FileExistsError:
            raise ArgumentError(f"the snoop {path} is a link that leads nowhere: choose another name") from None
        except OSError as error:
            raise ArgumentError(f"the snoop {path} can't be made ({error.strerror or error})") from error
        try:
            self._begin(self._file)
        except BaseException:
            os.close(self._file)
            raise

    @classmethod
    def at(cls, name: str) -> Snoop:
        """Return the snoop of a path; open it if this process does not have it open.

        Raises:
            ArgumentError: as for the class.
        """
        path = Path(name).absolute()
        with cls._opening:
            known = cls._open.get(path)
            if known is None or not known.is_there:
                if known is not None:
                    known.close()
                known = cls._open[path] = cls(path)
            return known

    @property
    def is_there(self) -> bool:
        """True if the snoop is open and its path still refers to the same file."""
        if self._file is None:
            return False
        try:
            return os.path.samestat(self._path.stat(), os.fstat(self._file))
        except OSError:
            return False

    def connection(self, name: str) -> int:
        """Append the beginning of a connection, and return the connection's number."""
        with self._lock:
            self._write(pcapng.interface(name))
            self._interfaces += 1
            return self._interfaces - 1

    def write(self, packet: Packet) -> None:
        """Append bytes that were sent or received."""
        self._write(pcapng.packet(packet))

    def end(self, connection: int, time_ns: int, why: str) -> None:
        """Append the end of a connection."""
        self._write(pcapng.ending(connection, time_ns, why))

    def close(self) -> None:
        """Close the file; later records are ignored."""
        file, self._file = self._file, None
        if file is not None:
            os.close(file)

    def _begin(self, file: int) -> None:
        state = os.fstat(file)
        if not stat.S_ISREG(state.st_mode):
            raise ArgumentError(f"the snoop {self._path} is no file: choose another name")
        try:
            lock_file(file)
        except OSError:
            raise ArgumentError(f"another program writes the snoop {self._path}: choose another name") from None
        if state.st_size:
            _mend(file, self._path)
        self._write(pcapng.section())

    def _write(self, block: bytes) -> None:
        """Append a block; after an error close the snoop with a warning, because the link must go on."""
        if self._file is None:
            return
        try:
            if os.write(self._file, block) != len(block):
                raise OSError("the disk is full")  # noqa: TRY301
        except OSError as error:
            log.warning("the snoop %s ends here: %s", self._path, error.strerror or error)
            self.close()


def _open(path: Path) -> int:
    """Open a file for appending, and create it if it does not exist, but not through a dangling symbolic link."""
    # Nonblocking: otherwise opening a pipe would wait for a reader.
    flags = os.O_RDWR | os.O_APPEND | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_NONBLOCK", 0)
    try:
        return os.open(path, flags)
    except FileNotFoundError:
        # Another program may create the file at the same time.
        return os.open(path, flags | os.O_CREAT | (os.O_EXCL if path.is_symlink() else 0), 0o666)


def _mend(file: int, path: Path) -> None:
    """Check that a file is a snoop, and truncate it after its last complete block.

    Raises:
        ArgumentError: if the file is not a snoop, or other data follow its last complete block; the file is unchanged.
    """
    with mmap.mmap(file, 0, access=mmap.ACCESS_READ) as data:
        try:
            pcapng.check_beginning(data)
            size = len(data)
            whole = size if pcapng.ends_whole(data) else pcapng.length_of_whole(data)
            if not pcapng.is_begun(data[whole : whole + pcapng.LARGEST_BLOCK + 1]):
                raise DamagedFileError(whole, "these bytes are not a record of a snoop")
        except ValueError as error:
            raise ArgumentError(f"{path} exists, and is no snoop to append to ({error}): choose another name") from None
    if whole < size:
        log.warning("the last record of the snoop %s was cut, and is left out", path)
        os.ftruncate(file, whole)


# Reading.


class Connected(NamedTuple):
    """Event: a connection began."""

    connection: int
    """Number of the connection in the file, from 0."""
    name: str


class Passed(NamedTuple):
    """Event: bytes were sent or received."""

    connection: int
    time_ns: int
    sent: bool
    data: bytes


class Disconnected(NamedTuple):
    """Event: a connection ended."""

    connection: int
    time_ns: int
    why: str


def read(path: Path, damage: Callable[[str], object]) -> Iterator[Connected | Passed | Disconnected]:
    """Yield the events of a snoop in order.

    Args:
        path: path of the file.
        damage: is called with a sentence at a damaged record; reading ends there.

    Raises:
        ArgumentError: if the file is not a snoop.
        UnityLinkError: if the file cannot be read.
    """
    try:
        with path.open("rb") as file:
            if not file.read(len(pcapng.SECTION_START)) == pcapng.SECTION_START:
                raise ArgumentError(
                    f"{path} is no snoop: a file written by ?snoop=FILE or UNITY_LINK_SNOOP was expected"
                )
            with mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
                yield from _events(path, data)
    except OSError as error:
        raise UnityLinkError(f"{path} cannot be read: {error.strerror or error}") from error
    except DamagedFileError as error:
        damage(f"{path}: {error}; all records before it were read")


def _events(path: Path, data: mmap.mmap) -> Iterator[Connected | Passed | Disconnected]:
    first, connections, offset = 0, 0, 0
    for block in pcapng.blocks(data):
        try:
            if block.kind == pcapng.SECTION:
                first = connections
                try:
                    pcapng.check_section(block.body, data, offset + len(block.body) + pcapng.SMALLEST)
                except ValueError as error:
                    if not offset:
                        raise ArgumentError(f"{path} is {error}") from None
                    raise
            elif block.kind == pcapng.INTERFACE:
                connections += 1
                yield Connected(connections - 1, pcapng.read_interface(block.body))
            elif block.kind == pcapng.PACKET:
                number, time_ns, sent, passed = pcapng.read_packet(block.body)
                yield Passed(_known(first + number, connections), time_ns, sent, passed)
            elif block.kind == pcapng.STATISTICS:
                number, time_ns, why = pcapng.read_ending(block.body)
                yield Disconnected(_known(first + number, connections), time_ns, why)
        except ArgumentError:
            raise
        except ValueError as error:
            raise DamagedFileError(offset, str(error)) from None
        offset += len(block.body) + pcapng.SMALLEST


def _known(connection: int, connections: int) -> int:
    """Return the number of a connection; raise ValueError if the connection did not begin before."""
    if connection >= connections:
        raise ValueError("a record of a connection that never began")
    return connection


def now_ns(seconds: Callable[[], float]) -> Callable[[], int]:
    """Return a clock in ns since 1970 that never goes back.

    Args:
        seconds: a monotonic clock in seconds, which drives the returned one.
    """
    began, origin = time.time_ns(), seconds()
    return lambda: began + round((seconds() - origin) * 1e9)

"""Writing a recording.

The file is an MCAP of chunks. A chunk is ended and brought to the disk at least every second (`RecordingFile.sync`),
so a program that is killed, or a machine that loses power, costs what came after that. A disk that is full costs no
more: the file is cut back to its last whole chunk.
"""

from __future__ import annotations

import contextlib
import datetime as dt
import io
import os
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
import numpy as np

from unity_link.bridges.messages import Encoder
from unity_link.errors import ArgumentError, UnityLinkError
from unity_link.transport.locking import lock_file

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    from unity_link.bridges.sampled import SampledGroup
    from unity_link.data import Batch
    from unity_link.protocol.wire.configuration import GatewayInfo
    from unity_link.spec import Interface

FORMATS = ("parquet", "csv")
"""Formats of the tables that `export` makes of recordings."""
INTERFACE, GATEWAY = "interface.json", "gateway.json"
"""Names of the attachments."""
INTERRUPTION = "interruption"
"""Name of the metadata that say when the gateway was away, `from` and `to`, in UTC as ISO 8601."""
_BUFFERED = 1 << 20
_OF_OTHERS = frozenset(
    {".arrow", ".bag", ".csv", ".db3", ".feather", ".h5", ".hdf5", ".json", ".jsonl", ".mat", ".npy", ".npz"}
    | {".parquet", ".pcapng", ".tsv", ".txt", ".vcd", ".xlsx"}
)
"""Suffixes of forms that a recording does not have."""


class RecordingError(UnityLinkError):
    """A recording cannot be written on or read; what it has up to there stays."""


def check_extra() -> None:
    """Check that what reads and writes MCAP is installed.

    Raises:
        RecordingError: where it is not.
    """
    try:
        import mcap.records  # noqa: F401
        import zstandard  # noqa: F401
    except ImportError:
        raise RecordingError("recordings need mcap, which is not installed: pip install 'unity-link[record]'") from None


def check_name(path: Path) -> None:
    """Check that a name does not promise another form than that of a recording.

    Raises:
        ArgumentError: where its suffix does.
    """
    form = path.suffix.lower()
    if form in _OF_OTHERS:
        name = path.with_suffix(".mcap")
        table = f", and unity-link export {name} --{form[1:]} makes tables of it" if form[1:] in FORMATS else ""
        raise ArgumentError(f"{path} names another form than MCAP, which recordings have: record {name}{table}")


class RecordingFile:
    """A recording that is being written. Its methods block while the disk does; one thread at a time."""

    def __init__(
        self,
        path: Path,
        interface: Interface,
        gateway: GatewayInfo,
        groups: Sequence[SampledGroup],
        *,
        overwrite: bool = False,
    ) -> None:
        """Begin a file.

        Raises:
            ArgumentError: where there is one of that name, unless `overwrite`; where the name is that of another form;
                where another recorder writes it, or it
                cannot be written.
            RecordingError: where the disk is full, or mcap is not installed.
        """
        check_name(path)
        check_extra()
        from unity_link import __version__
        from unity_link.bridges.recording.chunks import ChunkWriter

        self.path = path
        self.messages = 0
        """Written so far."""
        if path.is_dir():
            raise ArgumentError(f"{path} is a directory: the name of a file was expected")
        self._raw = _open(path, overwrite=overwrite)
        self._stream = io.BufferedWriter(self._raw, _BUFFERED)
        self._writer = ChunkWriter(self._stream, f"unity-link {__version__}")
        self._whole = self._whole_messages = 0
        self._bits = interface.data_bits
        self._encoders = [Encoder([proxy.signal for proxy in group.group.proxies]) for group in groups]
        self._channels: list[int] = []
        try:
            self._attempt(lambda: self._begin(interface, gateway, groups))
        except RecordingError:
            self.discard()
            raise

    @property
    def size(self) -> int:
        """Bytes that are in the file for good."""
        return self._whole

    def write(self, group: int, batch: Batch, instants: NDArray[np.float64]) -> None:
        """Write the samples of a batch, to the group of that number.

        Args:
            group: its number.
            batch: the samples.
            instants: when they were taken, in seconds since 1970, shape (samples,).

        Raises:
            RecordingError: where the disk does not take it.
        """
        at = np.rint(instants * 1e9).astype(np.int64)
        messages = self._encoders[group].encode(batch, self._bits)
        self._attempt(lambda: self._add(group, at, batch.sequence, messages))

    def note_interruption(self, began: float, ended: float) -> None:
        """Note that the gateway was away, from and to instants in seconds since 1970.

        Raises:
            RecordingError: where the disk does not take it.
        """
        times = {
            name: dt.datetime.fromtimestamp(at, dt.UTC).isoformat(timespec="milliseconds")
            for name, at in (("from", began), ("to", ended))
        }
        self._attempt(lambda: self._writer.note(INTERRUPTION, times))

    def sync(self) -> None:
        """Bring all that was written to the disk.

        Raises:
            RecordingError: where the disk does not take it.
        """
        self._attempt(self._sync)

    def close(self) -> None:
        """Finish the file, with its index.

        Raises:
            RecordingError: where the disk does not take it.
        """
        self._attempt(self._finish)

    def discard(self) -> None:
        """Remove the file, if it is none of a device."""
        if self.path.is_file():
            self.path.unlink(missing_ok=True)
        with contextlib.suppress(OSError, ValueError):
            self._raw.close()

    # The inside

    def _begin(self, interface: Interface, gateway: GatewayInfo, groups: Sequence[SampledGroup]) -> None:
        for name, data in ((INTERFACE, interface), (GATEWAY, gateway)):
            self._writer.attach(name, "application/json", msgspec.json.encode(data))
        for encoder, (name, group) in zip(self._encoders, groups, strict=True):
            schema = msgspec.json.encode(encoder.schema)
            metadata = {"signals": "\n".join(proxy.path for proxy in group.proxies)}
            channel = self._writer.open_channel(
                f"/{interface.name}/{name}", f"{interface.name}.{name}", schema, metadata
            )
            self._channels.append(channel)
        self._sync()

    def _add(self, group: int, at: NDArray[np.int64], sequence: NDArray[np.int64], messages: Sequence[bytes]) -> None:
        self._writer.write(self._channels[group], at, sequence, messages)
        self.messages += len(messages)

    def _sync(self) -> None:
        self._writer.end_chunk()
        self._stream.flush()
        os.fsync(self._raw.fileno())
        self._whole, self._whole_messages = self._stream.tell(), self.messages

    def _finish(self) -> None:
        # A disk that is full may have no room for the index, but for the samples.
        self._sync()
        self._writer.finish()
        self._sync()
        self._stream.close()

    def _attempt(self, action: Callable[[], None]) -> None:
        if self._raw.closed:
            # It failed before, and that was told.
            return
        try:
            action()
        except OSError as error:
            self._cut()
            raise RecordingError(
                f"{self.path} cannot be written on: {error.strerror or error}; what was recorded before is in it"
            ) from None

    def _cut(self) -> None:
        """Leave the whole chunks alone in the file."""
        with contextlib.suppress(OSError):
            os.ftruncate(self._raw.fileno(), self._whole)
        self.messages = self._whole_messages
        with contextlib.suppress(OSError, ValueError):
            self._raw.close()


def path_of(given: Path | str) -> Path:
    """Return a path that was given in either form.

    Raises:
        ArgumentError: where it is none.
    """
    if isinstance(given, (str, os.PathLike)):
        return Path(given)
    raise ArgumentError(f"the path of a recording was expected, not {given!r:.80}")


def _open(path: Path, *, overwrite: bool) -> io.FileIO:
    """Open an empty file, and lock it against other recorders."""
    try:
        # What another recorder writes must not be cut before the lock tells; and a pipe is not waited for.
        file = io.FileIO(
            path,
            "wb" if overwrite else "xb",
            opener=lambda name, flags: os.open(name, flags & ~os.O_TRUNC | getattr(os, "O_NONBLOCK", 0), 0o666),
        )
    except FileExistsError:
        raise ArgumentError(f"{path} is there already: choose another name, or --overwrite") from None
    except OSError as error:
        raise ArgumentError(f"{path} cannot be written: {error.strerror or error}") from None
    try:
        lock_file(file.fileno())
    except BlockingIOError:
        file.close()
        raise ArgumentError(f"{path} is being written by another recorder: choose another name") from None
    except OSError:
        # A file system without locks.
        pass
    # Devices are empty, and refuse to be cut.
    if os.fstat(file.fileno()).st_size:
        file.truncate(0)
    return file

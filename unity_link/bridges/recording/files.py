"""Writing of recordings.

The file is in MCAP format. A chunk is ended and written to the disk at least every second (`RecordingFile.sync`), so
if the program is killed or the computer loses power, only later samples are lost. If the disk is full, the file is cut
to its last whole chunk.
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
"""Name of the metadata with the times `from` and `to` at which the gateway was away, in UTC as ISO 8601."""
_BUFFERED = 1 << 20
_OF_OTHERS = frozenset(
    {".arrow", ".bag", ".csv", ".db3", ".feather", ".h5", ".hdf5", ".json", ".jsonl", ".mat", ".npy", ".npz"}
    | {".parquet", ".pcapng", ".tsv", ".txt", ".vcd", ".xlsx"}
)
"""Suffixes of formats that a recording cannot have."""


class RecordingError(UnityLinkError):
    """A recording cannot be written or read; the samples that were written before remain in it."""


def check_extra() -> None:
    """Check that the packages for MCAP are installed.

    Raises:
        RecordingError: if one is missing.
    """
    try:
        import mcap.records  # noqa: F401
        import zstandard  # noqa: F401
    except ImportError:
        raise RecordingError("recordings need mcap, which is not installed: pip install 'unity-link[record]'") from None


def check_name(path: Path) -> None:
    """Check that the suffix of a name is not that of another format.

    Raises:
        ArgumentError: if it is.
    """
    form = path.suffix.lower()
    if form in _OF_OTHERS:
        name = path.with_suffix(".mcap")
        table = f", and unity-link export {name} --{form[1:]} makes tables of it" if form[1:] in FORMATS else ""
        raise ArgumentError(f"{path} names another form than MCAP, which recordings have: record {name}{table}")


class RecordingFile:
    """A recording that is being written. Its methods block while the disk does; only one thread may call them."""

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
            ArgumentError: if the file exists, unless `overwrite`; if the name is that of another format; if another
                recorder writes the file, or it cannot be written.
            RecordingError: if the disk is full, or mcap is not installed.
        """
        check_name(path)
        check_extra()
        from unity_link import __version__
        from unity_link.bridges.recording.chunks import ChunkWriter

        self.path = path
        self.messages = 0
        """Number of messages written so far."""
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
        """Number of bytes that are certainly on the disk."""
        return self._whole

    def write(self, group: int, batch: Batch, instants: NDArray[np.float64]) -> None:
        """Write the samples of a batch to a group.

        Args:
            group: number of the group.
            batch: the samples.
            instants: instants of the samples, in seconds since 1970, shape (samples,).

        Raises:
            RecordingError: if the disk fails or is full.
        """
        at = np.rint(instants * 1e9).astype(np.int64)
        messages = self._encoders[group].encode(batch, self._bits)
        self._attempt(lambda: self._add(group, at, batch.sequence, messages))

    def note_interruption(self, began: float, ended: float) -> None:
        """Write that the gateway was away between two instants, in seconds since 1970.

        Raises:
            RecordingError: if the disk fails or is full.
        """
        times = {
            name: dt.datetime.fromtimestamp(at, dt.UTC).isoformat(timespec="milliseconds")
            for name, at in (("from", began), ("to", ended))
        }
        self._attempt(lambda: self._writer.note(INTERRUPTION, times))

    def sync(self) -> None:
        """Write all pending samples to the disk.

        Raises:
            RecordingError: if the disk fails or is full.
        """
        self._attempt(self._sync)

    def close(self) -> None:
        """Finish the file with its index.

        Raises:
            RecordingError: if the disk fails or is full.
        """
        self._attempt(self._finish)

    def discard(self) -> None:
        """Remove the file, unless it is a device."""
        if self.path.is_file():
            self.path.unlink(missing_ok=True)
        with contextlib.suppress(OSError, ValueError):
            self._raw.close()

    # Internals

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
        # First the samples: a full disk may have room for them, but not for the index.
        self._sync()
        self._writer.finish()
        self._sync()
        self._stream.close()

    def _attempt(self, action: Callable[[], None]) -> None:
        if self._raw.closed:
            # The file has failed before, and that was reported.
            return
        try:
            action()
        except OSError as error:
            self._cut()
            raise RecordingError(
                f"{self.path} cannot be written on: {error.strerror or error}; earlier samples are in it"
            ) from None

    def _cut(self) -> None:
        """Cut the file to its whole chunks, and close it."""
        with contextlib.suppress(OSError):
            os.ftruncate(self._raw.fileno(), self._whole)
        self.messages = self._whole_messages
        with contextlib.suppress(OSError, ValueError):
            self._raw.close()


def path_of(given: Path | str) -> Path:
    """Return a path given as `Path` or text.

    Raises:
        ArgumentError: if it is neither.
    """
    if isinstance(given, (str, os.PathLike)):
        return Path(given)
    raise ArgumentError(f"the path of a recording was expected, not {given!r:.80}")


def _open(path: Path, *, overwrite: bool) -> io.FileIO:
    """Open an empty file, and lock it against other recorders."""
    try:
        # Do not truncate: another recorder may hold the lock. O_NONBLOCK: do not wait for the reader of a pipe.
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
        # The file system has no locks.
        pass
    # A device has no size, and cannot be truncated.
    if os.fstat(file.fileno()).st_size:
        file.truncate(0)
    return file

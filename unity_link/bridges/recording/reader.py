"""Reading of recordings, also of those that were cut: from the front, chunk by chunk."""

from __future__ import annotations

import dataclasses
import heapq
import itertools
import math
import os
import struct
from typing import TYPE_CHECKING, Any, BinaryIO, NamedTuple

import msgspec
import numpy as np

from unity_link.bridges.messages import RecordedMessage, hex_to_words
from unity_link.bridges.recording.files import GATEWAY, INTERFACE, RecordingError, check_extra, path_of
from unity_link.data import Table
from unity_link.data.laps import ColumnLaps
from unity_link.errors import ArgumentError, UnknownNameError, UnsupportedError, did_you_mean
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.spec import Interface
from unity_link.spec.columns import Columns
from unity_link.spec.ranges import check_ranges

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from pathlib import Path

    from mcap.records import Chunk, McapRecord
    from numpy.typing import NDArray

    from unity_link.protocol.wire.arrays import Words
    from unity_link.spec import Signal

MOST_UNPACKED = 64 << 20
"""Largest uncompressed size of a chunk in bytes; those of `ChunkWriter` have an eighth. A larger one is damaged."""
MOST_WORDS = 8 << 20
"""Most words of samples that `Recording.in_order` holds, besides those of one chunk."""
_AT_ONCE = 4096
_LONGEST_NAME = 200
_RECORD = struct.Struct("<BQ")
"""Beginning of each record: its opcode, and the length of the rest."""


class RecordedGroup(NamedTuple):
    """A group in a recording."""

    name: str
    signals: tuple[Signal, ...]
    addresses: tuple[int, ...]
    """Addresses of the words of a sample."""


class RecordedSamples(NamedTuple):
    """Consecutive samples of one group."""

    group: RecordedGroup
    at: NDArray[np.int64]
    """Instants of sampling in nanoseconds since 1970, as the recorder estimated them; shape (samples,)."""
    time: NDArray[np.float64]
    """The same instants in seconds of the gateway's clock; NaN without timestamps."""
    sequence: NDArray[np.int64]
    lost: NDArray[np.int64]
    words: Words
    """Shape (samples, addresses)."""
    epoch: NDArray[np.int64]
    """Numbers of the sessions in which the samples arrived."""


class RecordedColumns:
    """Decodes the values of a group's samples, whose rounds are counted from call to call."""

    def __init__(self, group: RecordedGroup) -> None:
        self._columns = Columns(group.signals, group.addresses)
        self._laps = ColumnLaps(group.signals, group.addresses)

    def columns(self, words: Words, epoch: NDArray[np.int64]) -> list[NDArray[Any]]:
        """Return the values of each signal in the order of the group, each of shape (samples,).

        Args:
            words: shape (samples, addresses).
            epoch: sessions of the samples, shape (samples,).
        """
        counted = self._laps.count(words, epoch)
        return [counted.get(place, column) for place, column in enumerate(self._columns.columns(words))]


class RecordedRow(NamedTuple):
    """One sample of a group."""

    at: int
    """Instant of the sample in nanoseconds since 1970."""
    group: RecordedGroup
    words: Words
    """Shape (addresses,)."""


class Recording:
    """A recording on a disk.

    Raises:
        RecordingError: if the file is no recording of this package.
    """

    def __init__(self, path: Path | str) -> None:
        self.path = path_of(path)
        self.was_cut = False
        """True if the end of the file was missing in the last read, as after a crash."""
        self.was_damaged = False
        """True if a chunk was damaged in the last read; the others were read."""
        self.interface: Interface
        """Interface of the robot, as the spec declared it."""
        self.gateway: GatewayInfo
        self._channels: dict[int, RecordedGroup] = {}
        check_extra()
        self._read_head()

    @property
    def groups(self) -> tuple[RecordedGroup, ...]:
        """The recorded groups, in the order of the spec."""
        return tuple(self._channels.values())

    @property
    def size(self) -> int:
        """Size of the file in bytes."""
        return self.path.stat().st_size

    def __getitem__(self, name: str) -> Table:
        """Return all samples of a group, for numpy, pandas and polars: ``recording["state"].to_pandas()``.

        All samples are loaded into memory; `export` writes files of any size. The column ``time`` has seconds of the
        gateway's clock if the samples have timestamps, otherwise seconds since 1970 (UTC).

        Raises:
            UnknownNameError: for a group that was not recorded.
            RecordingError: if the recording cannot be read.
        """
        group = next((group for group in self.groups if group.name == name), None)
        if group is None:
            names = [known.name for known in self.groups]
            hint = did_you_mean(name, names) or f"there are {', '.join(names) or 'none'}"
            raise UnknownNameError(f"{self.path} has no group {name!r:.80}: {hint}")
        found = [samples for samples, _ in self.samples() if samples.group is group] or [_no_samples(group)]
        parts = zip(*(samples[1:] for samples in found), strict=True)
        at, time, sequence, lost, words, epoch = (np.concatenate(part) for part in parts)
        return Table(
            group.signals,
            RecordedColumns(group).columns(words, epoch),
            seconds=at / 1e9 if np.isnan(time).any() else time,
            instants=at,
            counts={"sequence": sequence, "lost": lost},
        )

    def samples(self) -> Iterator[tuple[RecordedSamples, int]]:
        """Yield all samples, those of each group in the order of the file, with the number of bytes read so far.

        The groups alternate every few thousand samples; `in_order` keeps the order among groups.
        """
        waiting: dict[int, list[tuple[int, bytes]]] = {}
        with self._open() as file:
            for record in self._records(file):
                if self._put(record, waiting) >= _AT_ONCE:
                    # Take the waiting samples of all groups, so that the groups stay near each other in time.
                    yield from ((samples, file.tell()) for samples in self._take(waiting))
            yield from ((samples, file.tell()) for samples in self._take(waiting))

    def in_order(self) -> Iterator[RecordedRow]:
        """Yield all samples of all groups one by one, in the order of their instants.

        A chunk is read when its first instant is reached, so that only chunks that overlap are in memory together. If
        these have more than `MOST_WORDS`, which no recorder writes, samples may be out of order.
        """
        waiting = _Waiting()
        with self._open() as file:
            for start, place in sorted(_places(file)):
                yield from waiting.take_before(start)
                for samples in self._samples_at(file, place):
                    waiting.add(samples)
        yield from waiting.take_before(math.inf)

    # Internals

    def _open(self) -> BinaryIO:
        try:
            if self.path.exists() and not self.path.is_file():
                raise RecordingError(f"{self.path} is no file: the name of a recording was expected")
            return self.path.open("rb")
        except OSError as error:
            raise RecordingError(f"{self.path} cannot be read: {error.strerror or error}") from None

    def _records(self, file: BinaryIO) -> Iterator[McapRecord]:
        from mcap.exceptions import InvalidMagic
        from mcap.records import Chunk, DataEnd
        from mcap.stream_reader import CRCValidationError, StreamReader

        unreadable = _unreadable()
        self.was_cut, self.was_damaged, broken = True, False, False
        try:
            for record in StreamReader(file, validate_crcs=True, emit_chunks=True).records:
                # If this chunk is broken and no record follows, the file was cut there: it is not damaged.
                self.was_damaged = self.was_damaged or broken
                if isinstance(record, DataEnd):
                    self.was_cut = False
                    return
                if not isinstance(record, Chunk):
                    yield record
                    continue
                try:
                    inside = _unpack(record)
                except unreadable:
                    inside, broken = [], True
                yield from inside
        except CRCValidationError:
            # The CRC of the whole file, at its end, is wrong.
            self.was_cut, self.was_damaged = False, True
        except InvalidMagic:
            if file.tell() <= 8:
                raise RecordingError(f"{self.path} is no MCAP file") from None
        except unreadable:
            return

    def _read_head(self) -> None:
        from mcap.records import Attachment, Channel
        from mcap.records import Message as McapMessage

        found: dict[str, bytes] = {}
        channels: dict[int, Channel] = {}
        with self._open() as file:
            for record in self._records(file):
                if isinstance(record, Attachment):
                    found[record.name] = record.data
                elif isinstance(record, Channel):
                    channels[record.id] = record
                elif isinstance(record, McapMessage):
                    break
        try:
            self.interface = msgspec.json.decode(found[INTERFACE], type=Interface)
            self.gateway = msgspec.json.decode(found[GATEWAY], type=GatewayInfo)
            check_ranges(self.interface)
            self.gateway.check()
        except (KeyError, msgspec.DecodeError, UnicodeDecodeError, RecursionError):
            raise RecordingError(
                f"{self.path} is no recording of unity-link record: it has no sound {INTERFACE}"
            ) from None
        except (ArgumentError, UnsupportedError) as error:
            raise RecordingError(f"{self.path} is damaged: {error}") from None
        for number, channel in channels.items():
            name = channel.topic.rpartition("/")[2]
            # Exported files are named after the channel.
            if not name.isprintable() or len(name) > _LONGEST_NAME:
                raise RecordingError(
                    f"{self.path} is damaged: it has a channel {name[:20]!a}, expected that of a group"
                )
            paths = channel.metadata.get("signals", "").split("\n")
            signals = tuple(self.interface.signals[path] for path in paths if path in self.interface.signals)
            addresses = tuple(dict.fromkeys(address for signal in signals for address in signal.addresses))
            self._channels[number] = RecordedGroup(name, signals, addresses)

    def _samples_at(self, file: BinaryIO, place: int) -> list[RecordedSamples]:
        """Read the chunk or message at an offset of the file; return an empty list if it is damaged."""
        from mcap.records import Chunk
        from mcap.stream_reader import StreamReader

        waiting: dict[int, list[tuple[int, bytes]]] = {}
        file.seek(place)
        try:
            record = next(StreamReader(file, skip_magic=True, emit_chunks=True).records)
            inside = _unpack(record) if isinstance(record, Chunk) else [record]
        except _unreadable():
            return []
        for record in inside:
            self._put(record, waiting)
        return self._take(waiting)

    def _put(self, record: McapRecord, waiting: dict[int, list[tuple[int, bytes]]]) -> int:
        """Keep a message of a recorded group, and return the number of kept messages of that group."""
        from mcap.records import Message as McapMessage

        if not isinstance(record, McapMessage) or record.channel_id not in self._channels:
            return 0
        rows = waiting.setdefault(record.channel_id, [])
        rows.append((record.log_time, record.data))
        return len(rows)

    def _take(self, waiting: dict[int, list[tuple[int, bytes]]]) -> list[RecordedSamples]:
        taken = [self._decode(self._channels[number], rows) for number, rows in waiting.items() if rows]
        waiting.clear()
        return taken

    def _decode(self, group: RecordedGroup, rows: list[tuple[int, bytes]]) -> RecordedSamples:
        decode = msgspec.json.Decoder(RecordedMessage).decode
        try:
            messages = [decode(data) for _, data in rows]
            texts = [message.words for message in messages]
            words = hex_to_words(texts, len(group.addresses), self.interface.data_bits)
            return RecordedSamples(
                group,
                np.array([at for at, _ in rows], np.int64),
                np.array([np.nan if message.time is None else message.time for message in messages]),
                np.array([message.sequence for message in messages], np.int64),
                np.array([message.lost for message in messages], np.int64),
                words,
                np.array([message.epoch for message in messages], np.int64),
            )
        except (msgspec.DecodeError, ValueError, OverflowError, RecursionError) as error:
            raise RecordingError(f"{self.path} has a message of {group.name} that is not ours: {error}") from None


def _no_samples(group: RecordedGroup) -> RecordedSamples:
    none = np.empty(0, np.int64)
    return RecordedSamples(group, none, np.empty(0), none, none, np.empty((0, len(group.addresses)), np.uint64), none)


class _Waiting:
    """Samples that `in_order` has not yielded yet, in runs of one group and one chunk each."""

    def __init__(self) -> None:
        self._runs: list[tuple[int, int, Iterator[RecordedRow], RecordedRow, int]] = []
        """A heap of tuples: next instant, unique number of the run, later rows, next row, number of words."""
        self._numbers = itertools.count()
        self._words = 0

    def add(self, samples: RecordedSamples) -> None:
        """Add a run."""
        order = np.argsort(samples.at, kind="stable")
        rows = map(RecordedRow, samples.at[order].tolist(), itertools.repeat(samples.group), samples.words[order])
        first = next(rows)
        heapq.heappush(self._runs, (first.at, next(self._numbers), rows, first, samples.words.size))
        self._words += samples.words.size

    def take_before(self, instant: float) -> Iterator[RecordedRow]:
        """Yield the rows before an instant, in order; also later rows, if too many are waiting."""
        runs = self._runs
        while runs and (runs[0][0] < instant or self._words > MOST_WORDS):
            _, number, rows, row, words = runs[0]
            yield row
            following = next(rows, None)
            if following is None:
                heapq.heappop(runs)
                self._words -= words
            else:
                heapq.heapreplace(runs, (following.at, number, rows, following, words))


def _places(file: BinaryIO) -> Iterator[tuple[int, int]]:
    """Yield the first instant and the offset of each chunk of a file, and of each message outside of chunks."""
    from mcap.opcode import Opcode
    from mcap.writer import MCAP0_MAGIC

    # Offset of the first instant after the head of the record.
    instants = {Opcode.CHUNK: 0, Opcode.MESSAGE: 6}
    size, place = os.fstat(file.fileno()).st_size, len(MCAP0_MAGIC)
    while place + _RECORD.size <= size:
        file.seek(place)
        opcode, length = _RECORD.unpack(file.read(_RECORD.size))
        if opcode == Opcode.DATA_END:
            return
        if opcode in instants:
            file.seek(instants[opcode], os.SEEK_CUR)
            yield int.from_bytes(file.read(8), "little"), place
        place += _RECORD.size + length


def _unpack(chunk: Chunk) -> Iterable[McapRecord]:
    """Return the records of a chunk.

    Raises:
        Exception: one of `_unreadable`, if the chunk is damaged, or too large.
    """
    from lz4.frame import LZ4FrameDecompressor
    from mcap.stream_reader import breakup_chunk
    from zstandard import ZstdDecompressor

    size = chunk.uncompressed_size
    if size > MOST_UNPACKED:
        raise ValueError(f"a chunk of {size} bytes")
    data = chunk.data
    # Read one byte more than stated, to detect chunks that are longer.
    if chunk.compression == "zstd":
        data = ZstdDecompressor().stream_reader(data).read(size + 1)
    elif chunk.compression == "lz4":
        data = LZ4FrameDecompressor().decompress(data, max_length=size + 1)
    if len(data) != size:
        raise ValueError(f"a chunk that is not of {size} bytes")
    return breakup_chunk(dataclasses.replace(chunk, compression="", data=data), validate_crc=True)


def _unreadable() -> tuple[type[Exception], ...]:
    """Return the types of exceptions that damaged records cause."""
    from mcap.exceptions import McapError
    from zstandard import ZstdError

    # The last two are raised for absurd lengths.
    return (McapError, ValueError, struct.error, ZstdError, RuntimeError, MemoryError, OverflowError)

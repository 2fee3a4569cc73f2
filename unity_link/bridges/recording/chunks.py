"""Writes MCAP files (https://mcap.dev/spec) by whole chunks, because samples arrive in arrays.

`mcap.writer.Writer` writes one message at a time, and makes an index entry for each, in 3 to 6 us of Python. All other
work for a sample takes 1 to 2 us, and at 50,000 samples per second there are 20 us for all. So this module writes two
kinds of records itself, messages and their index, many at a time from one numpy array. `mcap.records` writes all
others.

Schemas and channels come before the chunks, so that a file that was cut still describes all its channels.
"""

from __future__ import annotations

import itertools
import struct
import zlib
from collections import defaultdict
from typing import TYPE_CHECKING, BinaryIO

import numpy as np
from mcap.data_stream import RecordBuilder
from mcap.opcode import Opcode
from mcap.records import (
    Attachment,
    AttachmentIndex,
    Channel,
    Chunk,
    ChunkIndex,
    DataEnd,
    Footer,
    Header,
    Metadata,
    MetadataIndex,
    Schema,
    Statistics,
    SummaryOffset,
)
from mcap.writer import MCAP0_MAGIC
from zstandard import ZstdCompressor

if TYPE_CHECKING:
    from collections.abc import Sequence

    from mcap.records import McapRecord
    from numpy.typing import NDArray

CHUNK = 4 << 20
"""Uncompressed size in bytes at which a chunk ends; it can exceed this by the last message."""
_LEVEL = 1
"""Level of zstd: the size is a quarter, as at its default level 3, in half the time."""
_RECORD = struct.Struct("<BQ")
_MESSAGE = np.dtype(
    [
        ("opcode", "u1"),
        ("length", "<u8"),
        ("channel", "<u2"),
        ("sequence", "<u4"),
        ("log_time", "<u8"),
        ("publish_time", "<u8"),
    ]
)
"""Fields of a message record before its data."""
_INDEX = struct.Struct("<HI")
_ENTRY = np.dtype([("log_time", "<u8"), ("offset", "<u8")])
"""Fields of the index for each message: its instant, and its offset in the chunk."""
_SUMMARY = (Opcode.SCHEMA, Opcode.CHANNEL, Opcode.CHUNK_INDEX, Opcode.ATTACHMENT_INDEX, Opcode.METADATA_INDEX)
"""Records that are collected for the end of the file; `Opcode.STATISTICS` is added there."""


class ChunkWriter:
    """Writes an MCAP file to a stream, from its beginning.

    After each method except `write` the stream has only whole records. If a method fails, for example because the disk
    is full, the caller must cut the file to its size after the last method that succeeded.

    Args:
        stream: an empty file.
        library: name of the writing program in the file.
    """

    def __init__(self, stream: BinaryIO, library: str) -> None:
        self._stream = stream
        self._compressor = ZstdCompressor(level=_LEVEL)
        self._offset = 0
        self._crc = 0
        # Keep these records as bytes: objects would take much memory, as a night has a hundred thousand chunks.
        self._summary = {opcode: RecordBuilder() for opcode in _SUMMARY}
        self._statistics = Statistics(
            attachment_count=0,
            channel_count=0,
            channel_message_counts=defaultdict(int),
            chunk_count=0,
            message_count=0,
            message_end_time=0,
            message_start_time=0,
            metadata_count=0,
            schema_count=0,
        )
        self._begin_chunk()
        self._put(MCAP0_MAGIC)
        self._put(_bytes(Header(profile="", library=library)))

    def attach(self, name: str, media_type: str, data: bytes) -> None:
        """Write an attachment."""
        self.end_chunk()
        offset = self._offset
        length = self._put(_bytes(Attachment(create_time=0, log_time=0, name=name, media_type=media_type, data=data)))
        AttachmentIndex(
            offset=offset,
            length=length,
            log_time=0,
            create_time=0,
            data_size=len(data),
            name=name,
            media_type=media_type,
        ).write(self._summary[Opcode.ATTACHMENT_INDEX])
        self._statistics.attachment_count += 1

    def note(self, name: str, values: dict[str, str]) -> None:
        """Write metadata: texts by their names."""
        self.end_chunk()
        offset = self._offset
        length = self._put(_bytes(Metadata(name=name, metadata=values)))
        MetadataIndex(offset=offset, length=length, name=name).write(self._summary[Opcode.METADATA_INDEX])
        self._statistics.metadata_count += 1

    def open_channel(self, topic: str, schema_name: str, schema: bytes, metadata: dict[str, str]) -> int:
        """Begin a channel of JSON messages with a JSON schema; return its number."""
        self.end_chunk()
        number = self._statistics.channel_count + 1
        described = Schema(id=number, name=schema_name, encoding="jsonschema", data=schema)
        channel = Channel(id=number, topic=topic, message_encoding="json", schema_id=number, metadata=metadata)
        self._put(_bytes(described, channel))
        described.write(self._summary[Opcode.SCHEMA])
        channel.write(self._summary[Opcode.CHANNEL])
        self._statistics.schema_count += 1
        self._statistics.channel_count += 1
        return number

    def write(
        self, channel: int, at: NDArray[np.int64], sequence: NDArray[np.int64], messages: Sequence[bytes]
    ) -> None:
        """Write messages of a channel.

        Args:
            channel: number of the channel.
            at: instants in nanoseconds since 1970, shape (messages,).
            sequence: sequence numbers, of which the file stores 32 bits, shape (messages,).
            messages: texts of the messages.
        """
        lengths = np.fromiter(map(len, messages), np.int64, len(messages)) + _MESSAGE.itemsize
        full = np.flatnonzero(np.diff((self._size + np.cumsum(lengths)) // CHUNK)) + 1
        for first, end in itertools.pairwise([0, *full.tolist(), len(messages)]):
            part = slice(first, end)
            self._write(channel, at[part], sequence[part], messages[part], lengths[part])

    def end_chunk(self) -> None:
        """Write the pending messages to the stream as a chunk, if there are any."""
        if not self._records:
            return
        data = b"".join(self._records)
        entries = {channel: np.concatenate(parts) for channel, parts in self._entries.items()}
        first = min(int(part["log_time"].min()) for part in entries.values())
        last = max(int(part["log_time"].max()) for part in entries.values())
        compressed = self._compressor.compress(data)

        offset = self._offset
        chunk = Chunk(
            compression="zstd",
            data=compressed,
            message_end_time=last,
            message_start_time=first,
            uncompressed_crc=zlib.crc32(data),
            uncompressed_size=len(data),
        )
        length = self._put(_bytes(chunk))
        places = {}
        for channel, part in entries.items():
            places[channel] = self._offset
            self._put(_index(channel, part))
        ChunkIndex(
            chunk_length=length,
            chunk_start_offset=offset,
            compression="zstd",
            compressed_size=len(compressed),
            message_end_time=last,
            message_index_length=self._offset - offset - length,
            message_index_offsets=places,
            message_start_time=first,
            uncompressed_size=len(data),
        ).write(self._summary[Opcode.CHUNK_INDEX])
        self._count(first, last, {channel: len(part) for channel, part in entries.items()})
        self._begin_chunk()

    def finish(self) -> None:
        """End the file with the records that readers look for first: channels, statistics and offsets of chunks."""
        self.end_chunk()
        self._put(_bytes(DataEnd(self._crc)))
        start = self._offset
        self._statistics.write(self._summary.setdefault(Opcode.STATISTICS, RecordBuilder()))
        summary, offsets = b"", RecordBuilder()
        for opcode, builder in self._summary.items():
            group = _end(builder)
            if group:
                SummaryOffset(group_opcode=opcode, group_start=start + len(summary), group_length=len(group)).write(
                    offsets
                )
            summary += group
        footer = Footer(summary_start=start, summary_offset_start=start + len(summary), summary_crc=0)
        summary += _end(offsets)
        # The CRC covers the footer up to the CRC itself.
        footer.summary_crc = zlib.crc32(summary + _bytes(footer)[:-4])
        self._put(summary + _bytes(footer) + MCAP0_MAGIC)

    # Internals

    def _write(
        self,
        channel: int,
        at: NDArray[np.int64],
        sequence: NDArray[np.int64],
        messages: Sequence[bytes],
        lengths: NDArray[np.int64],
    ) -> None:
        heads = np.empty(len(messages), _MESSAGE)
        heads["opcode"] = Opcode.MESSAGE
        heads["length"] = lengths - _RECORD.size
        heads["channel"] = channel
        heads["sequence"] = sequence & 0xFFFF_FFFF
        heads["log_time"] = heads["publish_time"] = at
        pieces = [b""] * (2 * len(messages))
        pieces[::2] = heads.view(f"V{_MESSAGE.itemsize}").tolist()
        pieces[1::2] = messages
        records = b"".join(pieces)

        entries = np.empty(len(messages), _ENTRY)
        entries["log_time"] = at
        entries["offset"] = self._size + np.cumsum(lengths) - lengths
        self._records.append(records)
        self._entries[channel].append(entries)
        self._size += len(records)
        if self._size >= CHUNK:
            self.end_chunk()

    def _begin_chunk(self) -> None:
        self._records: list[bytes] = []
        self._entries: defaultdict[int, list[NDArray[np.void]]] = defaultdict(list)
        self._size = 0

    def _put(self, data: bytes) -> int:
        self._stream.write(data)
        self._offset += len(data)
        self._crc = zlib.crc32(data, self._crc)
        return len(data)

    def _count(self, first: int, last: int, messages: dict[int, int]) -> None:
        statistics = self._statistics
        statistics.message_start_time = min(first, statistics.message_start_time) if statistics.chunk_count else first
        statistics.message_end_time = max(last, statistics.message_end_time)
        statistics.chunk_count += 1
        statistics.message_count += sum(messages.values())
        for channel, count in messages.items():
            statistics.channel_message_counts[channel] += count


def _bytes(*records: McapRecord) -> bytes:
    builder = RecordBuilder()
    for record in records:
        record.write(builder)
    return _end(builder)


def _end(builder: RecordBuilder) -> bytes:
    data: bytes = builder.end()
    return data


def _index(channel: int, entries: NDArray[np.void]) -> bytes:
    head = _INDEX.pack(channel, entries.nbytes)
    return _RECORD.pack(Opcode.MESSAGE_INDEX, len(head) + entries.nbytes) + head + entries.tobytes()

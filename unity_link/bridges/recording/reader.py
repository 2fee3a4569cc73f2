"""Reading a recording, a finished one or one that was cut: from the front, chunk by chunk."""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, BinaryIO, NamedTuple

import msgspec
import numpy as np

from unity_link.bridges.messages import Message, hex_to_words
from unity_link.bridges.recording.files import GATEWAY, INTERFACE, RecordingError, check_extra
from unity_link.protocol.configuration import GatewayInfo
from unity_link.spec import Interface

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from mcap.records import McapRecord
    from numpy.typing import NDArray

    from unity_link.protocol.messages import Words
    from unity_link.spec import Signal

_AT_ONCE = 4096


class RecordedGroup(NamedTuple):
    """A group in a recording."""

    name: str
    signals: tuple[Signal, ...]
    addresses: tuple[int, ...]
    """Of the words of a sample."""


class RecordedSamples(NamedTuple):
    """Samples of one group that follow one another."""

    group: RecordedGroup
    at: NDArray[np.int64]
    """Instants of sampling in nanoseconds since 1970, as far as the recorder knew; shape (samples,)."""
    time: NDArray[np.float64]
    """The same in seconds of the gateway's clock; NaN where it told none."""
    sequence: NDArray[np.int64]
    lost: NDArray[np.int64]
    words: Words
    """Shape (samples, addresses)."""


class Recording:
    """A recording on a disk.

    Raises:
        RecordingError: where it is none, or not one of ours.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.was_cut = False
        """Whether the last reading found the end missing, as it is after a crash."""
        self.was_damaged = False
        """Whether the last reading found a chunk that is not as it was written; the others were read."""
        self.interface: Interface
        """What the spec said of the robot."""
        self.gateway: GatewayInfo
        self._channels: dict[int, RecordedGroup] = {}
        check_extra()
        self._read_head()

    @property
    def groups(self) -> tuple[RecordedGroup, ...]:
        """What was recorded, in the order of the spec."""
        return tuple(self._channels.values())

    @property
    def size(self) -> int:
        """Bytes."""
        return self.path.stat().st_size

    def samples(self) -> Iterator[tuple[RecordedSamples, int]]:
        """Read all samples in the order of the file; with each, how many bytes of the file were read."""
        from mcap.records import Message as McapMessage

        waiting: dict[int, list[tuple[int, bytes]]] = {}
        with self._open() as file:
            for record in self._records(file):
                if not isinstance(record, McapMessage) or record.channel_id not in self._channels:
                    continue
                rows = waiting.setdefault(record.channel_id, [])
                rows.append((record.log_time, record.data))
                if len(rows) >= _AT_ONCE:
                    # All together: what the groups recorded side by side stays side by side.
                    yield from ((samples, file.tell()) for samples in self._take(waiting))
            yield from ((samples, file.tell()) for samples in self._take(waiting))

    # The inside

    def _open(self) -> BinaryIO:
        try:
            return self.path.open("rb")
        except OSError as error:
            raise RecordingError(f"{self.path} cannot be read: {error.strerror or error}") from None

    def _records(self, file: BinaryIO) -> Iterator[McapRecord]:
        from mcap.exceptions import InvalidMagic, McapError
        from mcap.records import Chunk, DataEnd
        from mcap.stream_reader import CRCValidationError, StreamReader, breakup_chunk
        from zstandard import ZstdError

        # The last two are for lengths that are nonsense.
        unreadable = (McapError, ValueError, struct.error, ZstdError, MemoryError, OverflowError)
        self.was_cut, self.was_damaged, broken = True, False, False
        try:
            for record in StreamReader(file, validate_crcs=True, emit_chunks=True).records:
                # A broken chunk at the end of what there is was cut.
                self.was_damaged = self.was_damaged or broken
                if isinstance(record, DataEnd):
                    self.was_cut = False
                    return
                if not isinstance(record, Chunk):
                    yield record
                    continue
                try:
                    inside = breakup_chunk(record, validate_crc=True)
                except unreadable:
                    inside, broken = [], True
                yield from inside
        except CRCValidationError:
            # Of the whole file, at its end.
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
        except (KeyError, msgspec.DecodeError, UnicodeDecodeError):
            raise RecordingError(
                f"{self.path} is no recording of unity-link record: it has no sound {INTERFACE}"
            ) from None
        for number, channel in channels.items():
            paths = channel.metadata.get("signals", "").split("\n")
            signals = tuple(self.interface.signals[path] for path in paths if path in self.interface.signals)
            addresses = tuple(dict.fromkeys(address for signal in signals for address in signal.addresses))
            self._channels[number] = RecordedGroup(channel.topic.rpartition("/")[2], signals, addresses)

    def _take(self, waiting: dict[int, list[tuple[int, bytes]]]) -> list[RecordedSamples]:
        taken = [self._decode(self._channels[number], rows) for number, rows in waiting.items() if rows]
        waiting.clear()
        return taken

    def _decode(self, group: RecordedGroup, rows: list[tuple[int, bytes]]) -> RecordedSamples:
        decode = msgspec.json.Decoder(Message).decode
        try:
            messages = [decode(data) for _, data in rows]
            texts = [message.words for message in messages]
            words = hex_to_words(texts, len(group.addresses), self.interface.data_bits)
        except (msgspec.DecodeError, ValueError) as error:
            raise RecordingError(f"{self.path} has a message of {group.name} that is not ours: {error}") from None
        return RecordedSamples(
            group,
            np.array([at for at, _ in rows], np.int64),
            np.array([np.nan if message.time is None else message.time for message in messages]),
            np.array([message.sequence for message in messages], np.int64),
            np.array([message.lost for message in messages], np.int64),
            words,
        )

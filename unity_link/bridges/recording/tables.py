"""Recordings as tables: a file for each group, a row for each sample, a column for each signal."""

from __future__ import annotations

import contextlib
import os
from typing import TYPE_CHECKING, Any

from unity_link.bridges.recording.files import RecordingError
from unity_link.data.tables import column_names
from unity_link.errors import ArgumentError
from unity_link.spec.columns import Columns

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from unity_link.bridges.recording.reader import RecordedGroup, RecordedSamples, Recording

FORMATS = ("parquet", "csv")


def export(
    recording: Recording, form: str, directory: Path, progress: Callable[[int], None] = lambda _: None
) -> list[Path]:
    """Write a recording as tables ``NAME.GROUP.parquet`` or ``.csv``; files of these names are replaced, by whole ones.

    The columns are ``time`` (UTC, instant of sampling), ``gateway_time`` (seconds of the gateway's clock),
    ``sequence``, ``lost`` and the paths of the signals, with ``_`` behind one that is taken; enumerations are numbers.
    Parquet has the units and descriptions as metadata.

    Args:
        recording: what is exported.
        form: one of `FORMATS`.
        directory: where to; it is made.
        progress: called with the bytes of the recording that are done.

    Raises:
        ArgumentError: for another form, or a directory that cannot be made.
        RecordingError: where the recording cannot be read or the table cannot be written.
    """
    if form not in FORMATS:
        raise ArgumentError(f"there is no table format {form!r}: one of {', '.join(FORMATS)} was expected")
    tables: dict[str, _Table] = {}
    try:
        directory.mkdir(parents=True, exist_ok=True)
        for group in recording.groups:
            tables[group.name] = _Table(group, directory / f"{recording.path.stem}.{group.name}.{form}", form)
        try:
            for samples, done in recording.samples():
                tables[samples.group.name].write(samples)
                progress(done)
            for table in tables.values():
                table.finish()
        finally:
            for table in tables.values():
                table.discard()
    except OSError as error:
        # A whole table takes the place of another by its second name.
        where = error.filename2 or error.filename or directory
        raise RecordingError(f"{where} cannot be written: {error.strerror or error}") from None
    return [table.path for table in tables.values()]


class _Table:
    def __init__(self, group: RecordedGroup, path: Path, form: str) -> None:
        import pyarrow as pa
        from pyarrow import csv, parquet

        self.path = path
        self._group = group
        self._columns = Columns(group.signals, group.addresses)
        self._schema = pa.schema(list(self._fields()))
        writer: Any = parquet.ParquetWriter if form == "parquet" else csv.CSVWriter
        self._part = path.with_name(f"{path.name}.part")
        # By its bytes, as pyarrow takes no name that is no UTF-8.
        self._file = pa.OSFile(os.fsencode(self._part), "wb")
        self._writer = writer(self._file, self._schema)

    def write(self, samples: RecordedSamples) -> None:
        import pyarrow as pa

        values = self._columns.decode(samples.words)
        columns = [
            pa.array(samples.at, pa.timestamp("ns", tz="UTC")),
            pa.array(samples.time, from_pandas=True),
            pa.array(samples.sequence),
            pa.array(samples.lost),
            *(pa.array(values[signal.path]) for signal in self._group.signals),
        ]
        self._writer.write_table(pa.Table.from_arrays(columns, schema=self._schema))

    def finish(self) -> None:
        self._close()
        self._part.replace(self.path)

    def discard(self) -> None:
        """Remove what was not finished."""
        with contextlib.suppress(OSError):
            self._close()
        self._part.unlink(missing_ok=True)

    def _close(self) -> None:
        self._writer.close()
        self._file.close()

    def _fields(self) -> Iterator[Any]:
        import pyarrow as pa

        known = [
            pa.field("time", pa.timestamp("ns", tz="UTC")),
            pa.field("gateway_time", pa.float64(), metadata={"unit": "s"}),
            pa.field("sequence", pa.int64()),
            pa.field("lost", pa.int64()),
        ]
        yield from known
        signals = self._group.signals
        names = column_names([signal.path for signal in signals], [field.name for field in known])
        for name, signal in zip(names, signals, strict=True):
            values = signal.kind.enumeration.values if signal.kind.enumeration else ()
            metadata = {
                "id": signal.id,
                "unit": signal.unit,
                "description": signal.doc,
                "values": ", ".join(f"{value.value}: {value.name}" for value in values),
            }
            told = {key: text for key, text in metadata.items() if text}
            yield pa.field(name, pa.from_numpy_dtype(signal.kind.dtype), metadata=told)

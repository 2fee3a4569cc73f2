"""Export of recordings as tables: a file for each group, a row for each sample, a column for each signal."""

from __future__ import annotations

import contextlib
from contextlib import ExitStack
from typing import TYPE_CHECKING, Any, BinaryIO, Self

import unity_link
from unity_link.bridges.recording.files import FORMATS, RecordingError
from unity_link.bridges.recording.reader import RecordedColumns
from unity_link.data.tables import column_names
from unity_link.errors import ArgumentError
from unity_link.files import Writing, check_folder, head_of

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from unity_link.bridges.recording.reader import RecordedGroup, RecordedSamples, Recording
    from unity_link.files import Overwrite

_COLUMNS = ("time", "gateway_time", "sequence", "lost")
"""First columns of each table."""
_WRITER = b"unity-link"
"""Key in the metadata of a Parquet file; its value is the version of this package that wrote the file."""


def export(
    recording: Recording,
    form: str,
    directory: Path,
    progress: Callable[[int], None] = lambda _: None,
    *,
    overwrite: Overwrite = False,
) -> list[Path]:
    """Write a recording as tables ``NAME.GROUP.parquet`` or ``.csv``. Existing tables are replaced when all are done.

    The columns are ``time`` (UTC, instant of sampling), ``gateway_time`` (seconds of the gateway's clock),
    ``sequence``, ``lost`` and the paths of the signals, with ``_`` appended to a name in use. Values of enumerations
    are numbers. Parquet files have the units and descriptions as metadata.

    Args:
        recording: recording to export.
        form: one of `FORMATS`.
        directory: folder for the tables; it is made if necessary.
        progress: called with the number of bytes of the recording that are done.
        overwrite: whether existing files that are no such tables are replaced.

    Raises:
        ArgumentError: for another form, or an existing file that is no such table.
        RecordingError: if the recording cannot be read, or a table cannot be written.
    """
    if form not in FORMATS:
        raise ArgumentError(f"there is no table format {form!r}: one of {', '.join(FORMATS)} was expected")
    paths = {group.name: directory / f"{recording.path.stem}.{group.name}.{form}" for group in recording.groups}
    check_folder(directory, paths.values())
    try:
        directory.mkdir(parents=True, exist_ok=True)
        with Writing(overwrite=overwrite) as writing, ExitStack() as opened:
            writing.claim(paths.values(), _is_parquet_of_ours if form == "parquet" else _is_csv_of_ours)
            tables = {
                group.name: opened.enter_context(_Table(group, writing.open(paths[group.name]), form))
                for group in recording.groups
            }
            for samples, done in recording.samples():
                tables[samples.group.name].write(samples)
                progress(done)
    except OSError as error:
        raise RecordingError(f"{error.filename or directory} cannot be written: {error.strerror or error}") from None
    return list(paths.values())


def _is_csv_of_ours(path: Path) -> bool:
    """Return whether a CSV file begins with the columns of our tables, in quotes, which spreadsheets do not write."""
    return head_of(path).startswith(",".join(f'"{name}"' for name in _COLUMNS).encode())


def _is_parquet_of_ours(path: Path) -> bool:
    import pyarrow as pa
    from pyarrow import parquet

    try:
        with path.open("rb") as file:
            return _WRITER in (parquet.read_schema(file).metadata or {})
    except pa.ArrowException:
        return False


class _Table:
    def __init__(self, group: RecordedGroup, file: BinaryIO, form: str) -> None:
        import pyarrow as pa
        from pyarrow import csv, parquet

        self._group = group
        self._columns = RecordedColumns(group)
        self._schema = pa.schema(list(self._fields()), {_WRITER: unity_link.__version__})
        writer: Any = parquet.ParquetWriter if form == "parquet" else csv.CSVWriter
        self._file = file
        self._writer = writer(file, self._schema)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: object, *_: object) -> None:
        # After an error the unfinished table is removed, so a further error of closing it does not matter.
        with contextlib.suppress(*(() if kind is None else (OSError,))):
            self._writer.close()
            self._file.close()

    def write(self, samples: RecordedSamples) -> None:
        import pyarrow as pa

        values = self._columns.columns(samples.words, samples.epoch)
        columns = [
            pa.array(samples.at, pa.timestamp("ns", tz="UTC")),
            pa.array(samples.time, from_pandas=True),
            pa.array(samples.sequence),
            pa.array(samples.lost),
            *map(pa.array, values),
        ]
        self._writer.write_table(pa.Table.from_arrays(columns, schema=self._schema))

    def _fields(self) -> Iterator[Any]:
        import pyarrow as pa

        time, gateway_time, sequence, lost = _COLUMNS
        yield pa.field(time, pa.timestamp("ns", tz="UTC"))
        yield pa.field(gateway_time, pa.float64(), metadata={"unit": "s"})
        yield pa.field(sequence, pa.int64())
        yield pa.field(lost, pa.int64())
        signals = self._group.signals
        names = column_names([signal.path for signal in signals], list(_COLUMNS))
        for name, signal in zip(names, signals, strict=True):
            values = signal.kind.enumeration.values if signal.kind.enumeration else ()
            metadata = {
                "id": signal.id,
                "unit": signal.unit,
                "description": signal.doc,
                "values": ", ".join(f"{value.value}: {value.name}" for value in values),
            }
            given = {key: text for key, text in metadata.items() if text}
            yield pa.field(name, pa.from_numpy_dtype(signal.kind.dtype), metadata=given)

"""Samples of a group as tables for numpy, pandas and polars.

A `Table` has a column for each signal, named by its path, and one for the time. `Batch` makes tables of samples that
have just arrived, `unity_link.bridges.recording.Recording` of recorded samples.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from unity_link.errors import ArgumentError, Sealed, UnknownNameError, UnsupportedError, did_you_mean
from unity_link.link import html

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    import pandas as pd
    import polars as pl
    from numpy.typing import NDArray

    from unity_link.spec.model import Signal

Clock = Literal["seconds", "utc"]
MOST_ROWS, MOST_COLUMNS = 10, 12
"""Most rows and columns that a notebook shows."""
TIME = "time"
"""Name of the column with the instants of the samples."""


class Table(Sealed):
    """Samples of one group, with a column for each signal.

    ``table["j1.cpos"]`` is the column of a signal, ``table.units["j1.cpos"]`` its unit.
    """

    def __init__(
        self,
        signals: Sequence[Signal],
        columns: Sequence[NDArray[Any]],
        seconds: NDArray[np.float64],
        instants: NDArray[np.int64],
        counts: Mapping[str, NDArray[np.int64]],
    ) -> None:
        """Make a table of columns.

        Args:
            signals: signal of each column.
            columns: values of each signal, shape (samples,).
            seconds: instants of the samples, in seconds of a clock that never goes back.
            instants: the same instants in nanoseconds since 1970, UTC.
            counts: other columns, by their names: sequence number, lost samples, epoch.

        Raises:
            ArgumentError: if two signals have the same path.
        """
        paths = [signal.path for signal in signals]
        if len({*paths}) != len(paths):
            twice = next(path for path in paths if paths.count(path) > 1)
            raise ArgumentError(f"several signals are called {twice!r}: a table needs groups of one robot each")
        self.signals = tuple(signals)
        self._seconds = seconds
        self._instants = instants
        self._counts = dict(counts)
        taken = (TIME, *counts)
        self._columns = dict(zip(column_names(paths, taken), columns, strict=True))

    def _called(self) -> str:
        return "a table"

    def _data(self) -> tuple[object, ...]:
        return self.signals, [*self._columns.values()], self._seconds, self._instants, self._counts

    def __len__(self) -> int:
        """Return the number of samples."""
        return len(self._seconds)

    def __repr__(self) -> str:
        """Return the number of samples, and the paths of the signals."""
        return f"<table of {len(self)} samples of {', '.join(signal.path for signal in self.signals)}>"

    def _repr_html_(self) -> str:
        """Return the first and last samples of the first signals as a table."""
        shown = list(self._columns.items())[:MOST_COLUMNS]
        more = ["…"] if len(self._columns) > len(shown) else []
        units = self.units
        head = [f"{TIME} [s]", *(f"{name} [{units[name]}]" if name in units else name for name, _ in shown), *more]

        def row(place: int) -> list[str]:
            values = (html.value_text(column[place].item()) for _, column in shown)
            return [f"{self._seconds[place]:.6f}", *values, *more]

        return html.long_table(repr(self)[1:-1], len(self), row, head, most=MOST_ROWS)

    def __getitem__(self, name: str) -> NDArray[Any]:
        """Return a column by its name; shape (samples,)."""
        if name not in self._columns:
            hint = did_you_mean(name, self._columns) or f"it has {', '.join([*self._columns][:8])}"
            raise UnknownNameError(f"the table has no column {name!r:.80}: {hint}")
        return self._columns[name]

    @property
    def units(self) -> dict[str, str]:
        """The units of the columns, by column name, without those that have none. The time is in seconds."""
        pairs = zip(self._columns, self.signals, strict=True)
        return {name: signal.unit for name, signal in pairs if signal.unit}

    @property
    def names(self) -> dict[str, dict[int, str]]:
        """The names of the numbers in columns of enumerations, by the names of the columns."""
        pairs = zip(self._columns, self.signals, strict=True)
        return {
            name: {value.value: value.name for value in signal.kind.enumeration.values}
            for name, signal in pairs
            if signal.kind.enumeration is not None
        }

    def to_numpy(self, *, time: Clock = "seconds", counts: bool = False) -> NDArray[np.void]:
        """Return a structured array: ``array["time"]``, ``array["j1.cpos"]``, ``array[array["time"] > 2]``.

        Args:
            time: ``"seconds"`` of a clock that never goes back: the gateway's if samples have timestamps, otherwise
                this machine's; or ``"utc"`` for instants in UTC.
            counts: add the columns ``sequence`` and ``lost``, and ``epoch`` if it is known.
        """
        columns = self._chosen(time, counts=counts)
        made = np.empty(len(self), [(name, column.dtype) for name, column in columns.items()])
        for name, column in columns.items():
            made[name] = column
        return made

    def to_pandas(self, *, time: Clock = "seconds", counts: bool = False) -> pd.DataFrame:
        """Return a DataFrame of pandas with the time as its index; it needs the extra ``pandas``.

        ``frame.attrs["units"]`` has the units by columns, ``frame.attrs["names"]`` the names of enumerations.

        Args:
            time: as for `to_numpy`; with ``"utc"`` the index is a `DatetimeIndex`.
            counts: as for `to_numpy`.

        Raises:
            UnsupportedError: if pandas is not installed.
        """
        pandas = _library("pandas")
        columns = self._chosen(time, counts=counts)
        when = columns.pop(TIME)
        index = pandas.Index(when, name=TIME) if time == "seconds" else pandas.DatetimeIndex(when, name=TIME, tz="UTC")
        # Copy the columns, so that changes of the frame do not change the batch.
        frame = pandas.DataFrame(columns, index=index, copy=True)
        frame.attrs |= {"units": self.units, "names": self.names}
        return frame

    def to_polars(self, *, time: Clock = "seconds", counts: bool = False) -> pl.DataFrame:
        """Return a DataFrame of polars with the time as its first column; it needs the extra ``polars``.

        A frame of polars cannot hold units: use `units`.

        Args:
            time: as for `to_numpy`; with ``"utc"`` the column is a ``Datetime`` in nanoseconds, UTC.
            counts: as for `to_numpy`.

        Raises:
            UnsupportedError: if polars is not installed.
        """
        polars = _library("polars")
        frame: pl.DataFrame = polars.DataFrame(self._chosen(time, counts=counts))
        if time == "utc":
            frame = frame.with_columns(polars.col(TIME).dt.replace_time_zone("UTC"))
        return frame

    def _chosen(self, time: Clock, *, counts: bool) -> dict[str, NDArray[Any]]:
        """Return the requested columns, the time first."""
        if time not in ("seconds", "utc"):
            raise ArgumentError(f'time is "seconds" or "utc", not {time!r:.80}')
        when = self._seconds if time == "seconds" else self._instants.view("datetime64[ns]")
        return {TIME: when, **(self._counts if counts else {}), **self._columns}


def column_names(paths: Iterable[str], taken: Iterable[str]) -> list[str]:
    """Return column names for signals, in the same order: their paths, with ``_`` appended to a name in use."""
    given, used = list(paths), set(taken)
    names = []
    for path in given:
        name = path
        while name in used or (name != path and name in given):
            name += "_"
        used.add(name)
        names.append(name)
    return names


def _library(name: str) -> Any:
    """Import the library that the extra of the same name installs.

    Raises:
        UnsupportedError: if it is not installed.
    """
    try:
        return importlib.import_module(name)
    except ImportError:
        raise UnsupportedError(
            f"to_{name} needs {name}, which is not installed: pip install 'unity-link[{name}]'"
        ) from None

"""Samples of a group: values by their proxies, one sample at a time or many as arrays.

A `Batch` stores the received words, and decodes all columns at once when values are first requested: bridges and
recorders process tens of thousands of samples per second in this way. A `GroupSample` is one of its rows.
"""

from __future__ import annotations

import functools
import re
import time
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, Never, TypeVar, overload

import msgspec
import numpy as np

from unity_link.data.tables import Table
from unity_link.errors import Sealed, UnknownNameError, did_you_mean, missing_attribute, unassignable_attribute

if TYPE_CHECKING:
    from collections.abc import Sequence

    import pandas as pd
    import polars as pl
    from numpy.typing import NDArray

    from unity_link.data.laps import ColumnLaps
    from unity_link.data.layout import GroupLayout
    from unity_link.data.proxies import Proxy
    from unity_link.data.tables import Clock
    from unity_link.link.publishing import Sample
    from unity_link.protocol.wire.arrays import Words

T = TypeVar("T")
_TOGETHER = 1e-4
"""Longest time between the readings of two clocks, in seconds."""


def find(by_proxy: Mapping[Proxy[Any], T], proxy: Proxy[Any] | str) -> T:
    """Return the entry of a mapping for a signal, or for its path.

    Raises:
        UnknownNameError: if there is none, or if several signals have the path.
    """
    try:
        return by_proxy[proxy]  # type: ignore[index]  # a path is looked for below
    except (KeyError, TypeError):
        pass
    named: list[T] = []
    if isinstance(proxy, str):
        named = [found for known, found in by_proxy.items() if proxy in (known.path, known.id)]
    elif hasattr(proxy, "signal"):
        named = [found for known, found in by_proxy.items() if known.is_alone() and known.signal == proxy.signal]
    if len(named) == 1:
        return named[0]
    path = getattr(proxy, "path", proxy)
    paths = [known.path for known in by_proxy]
    if named:
        raise UnknownNameError(f"several signals are called {path!r}: get one by the proxy of its robot")
    raise UnknownNameError(
        f"{path} is not in the group: {did_you_mean(path, paths) or 'it has ' + ', '.join(paths[:8])}"
    )


class Values(Mapping["Proxy[Any]", Any]):
    """Values by their proxies, ``values[robot.j1.cpos]``, or by their paths, ``values["j1.cpos"]``."""

    __slots__ = ("_places", "_row")

    def __init__(self, places: Mapping[Proxy[Any], int], row: Sequence[Any]) -> None:
        self._places = places
        self._row = row

    @overload
    def __getitem__(self, proxy: Proxy[T]) -> T: ...
    @overload
    def __getitem__(self, proxy: str) -> Any: ...
    def __getitem__(self, proxy: Proxy[Any] | str) -> Any:
        """Return the value of a signal."""
        return self._row[find(self._places, proxy)]

    if not TYPE_CHECKING:  # A type checker reports unknown attributes by itself.
        __getattr__ = missing_attribute("the values")

    def __iter__(self) -> Iterator[Proxy[Any]]:
        """Return the proxies, in the order of their group."""
        return iter(self._places)

    def __len__(self) -> int:
        """Return the number of signals."""
        return len(self._places)

    def __repr__(self) -> str:
        """Return the values by their paths."""
        return f"{{{', '.join(f'{proxy.path}: {value!r}' for proxy, value in self.items())}}}"

    def _repr_html_(self) -> str:
        """Return the values by their paths as a table."""
        from unity_link.link import html

        rows = [(proxy.path, html.value_text(value), proxy.unit) for proxy, value in self.items()]
        return html.table("values", rows, ("signal", "value", "unit"))


class GroupSample(msgspec.Struct, frozen=True):
    """The values of a group at one instant: ``sample[robot.j1.cpos]``, or ``sample["j1.cpos"]``."""

    sequence: int
    """Number of the sample since the subscription began; lost samples are counted."""
    time: float | None
    """Instant of sampling in seconds of the gateway's clock; None without timestamps, and for polled samples."""
    arrived: float
    """Instant of arrival in seconds of this machine's clock (`time.time`)."""
    values: Values
    """The values, in the order of the group."""
    lost: int
    """Number of samples lost between the previous sample and this one."""

    @overload
    def __getitem__(self, proxy: Proxy[T]) -> T: ...
    @overload
    def __getitem__(self, proxy: str) -> Any: ...
    def __getitem__(self, proxy: Proxy[Any] | str) -> Any:
        """Return the value of a signal, by its proxy or path."""
        return self.values[proxy]

    if not TYPE_CHECKING:  # A type checker reports unknown attributes by itself.

        def __getattr__(self, name: str) -> Never:
            paths = [proxy.path for proxy in self.values if re.match(rf"{re.escape(name)}(?![A-Za-z0-9_])", proxy.path)]
            instead = {name: f"write sample[{paths[0]!r}]"} if paths else {}
            missing_attribute("a sample", **instead)(self, name)


if not TYPE_CHECKING:  # The method of a frozen struct raises an error without a useful text.
    GroupSample.__setattr__ = unassignable_attribute("a sample")


class Batch(Sealed):
    """Samples of one gateway that arrived together, at least one, in the order of their sampling.

    ``batch[robot.j1.cpos]`` is the column of a signal. Iteration yields the samples one by one.
    """

    def __init__(
        self, layout: GroupLayout, samples: Sequence[Sample], counted: Mapping[int, NDArray[Any]] | None = None
    ) -> None:
        self.layout = layout
        """Signals of the samples, and their places in the words."""
        self.at = _monotonic(samples[-1].arrived)
        """Instant of `time.monotonic` at which the last sample arrived."""
        self.samples = samples
        """Samples as they were received."""
        self.counted: Mapping[int, NDArray[Any]] = {} if counted is None else counted
        """Values of signals with WRAPS, with their rounds counted, by the signals' places; each of shape (samples,)."""

    def _called(self) -> str:
        return "a batch of samples"

    def _data(self) -> tuple[object, ...]:
        return self.layout, self.samples, self.counted

    def __len__(self) -> int:
        """Return the number of samples."""
        return len(self.samples)

    def __repr__(self) -> str:
        """Return the number of samples and the paths of the signals."""
        return f"<{len(self)} samples of {', '.join(proxy.path for proxy in self.proxies)}>"

    def _repr_html_(self) -> str:
        """Return the first and last samples as a table."""
        return self.table._repr_html_()

    def __getitem__(self, proxy: Proxy[Any] | str) -> NDArray[Any]:
        """Return the values of a signal; shape (samples,). Values of an enumeration are numbers."""
        return find(self.columns, proxy)

    def __iter__(self) -> Iterator[GroupSample]:
        """Return the samples one by one."""
        proxies = self.layout.places
        rows = zip(*(proxy.scalars(column) for proxy, column in self.columns.items()), strict=True)
        for sample, row in zip(self.samples, rows, strict=True):
            yield GroupSample(sample.sequence, sample.time, sample.arrived, Values(proxies, row), sample.lost)

    def with_rounds(self, laps: ColumnLaps) -> Batch:
        """Return the same samples with the rounds of signals with WRAPS counted on from those that `laps` has seen."""
        made = Batch(self.layout, self.samples, laps.count(self.words, self.epoch, self.at))
        vars(made)["words"] = self.words
        return made

    def behind(self, count: int, lost: int = 0) -> Batch:
        """Return the samples after the first `count`. The first of them counts these, and `lost` more, as lost."""
        if not count + lost:
            return self
        lost += count + int(self.lost[: count + 1].sum())
        first, *others = self.samples[count:]
        counted = {place: column[count:] for place, column in self.counted.items()}
        return Batch(self.layout, [msgspec.structs.replace(first, lost=lost), *others], counted)

    def see(self, asked: float) -> None:
        """Store the batch as its signals' last values; if a signal has change handlers, call them with all values.

        Args:
            asked: instant of `time.monotonic` since which the reader has waited for the batch. If the batch arrived
                earlier, signals of which a newer value was seen in the meantime skip it.
        """
        at = self.at
        # A reader that waited gets the newest value: an answer received with the batch is older, though seen later.
        has_waited = at < asked
        for proxy, last in self.layout.lasts:
            if has_waited and last.at > at:
                continue
            if last.callbacks:
                for value in proxy.scalars(self[proxy]):
                    proxy.see(value, at)
            else:
                last.batch = self
                last.at = at

    # As tables

    @functools.cached_property
    def table(self) -> Table:
        """The samples with a column for each signal, named by its path, and with the units.

        Times are of the gateway's clock if the samples have timestamps; otherwise, of `time.monotonic` at their
        arrival. For times in UTC, the sample with the shortest delay determines when the gateway's clock was 0.
        """
        arrived = self.arrived
        if self.time is None:
            seconds, instants = _never_back(self.at + (arrived - arrived[-1]), self.at), arrived
        else:
            seconds, instants = self.time, self.time + float((arrived - self.time).min())
        return Table(
            [proxy.signal for proxy in self.proxies],
            [self.columns[proxy] for proxy in self.proxies],
            seconds=seconds,
            instants=np.rint(instants * 1e9).astype(np.int64),
            counts={"sequence": self.sequence, "lost": self.lost, "epoch": self.epoch},
        )

    def to_numpy(self, *, time: Clock = "seconds", counts: bool = False) -> NDArray[np.void]:
        """Return a structured array with a column for each signal; see `Table.to_numpy`."""
        return self.table.to_numpy(time=time, counts=counts)

    def to_pandas(self, *, time: Clock = "seconds", counts: bool = False) -> pd.DataFrame:
        """Return a DataFrame of pandas; see `Table.to_pandas`."""
        return self.table.to_pandas(time=time, counts=counts)

    def to_polars(self, *, time: Clock = "seconds", counts: bool = False) -> pl.DataFrame:
        """Return a DataFrame of polars; see `Table.to_polars`."""
        return self.table.to_polars(time=time, counts=counts)

    # Columns

    @property
    def proxies(self) -> tuple[Proxy[Any], ...]:
        """The signals."""
        return self.layout.proxies

    @functools.cached_property
    def columns(self) -> dict[Proxy[Any], NDArray[Any]]:
        """The values of all signals, each of shape (samples,), in the numpy type of the signal's kind."""
        columns = self.layout.columns(self.words)
        return columns | {self.proxies[place]: column for place, column in self.counted.items()}

    @functools.cached_property
    def words(self) -> Words:
        """The received words; shape (samples, addresses), in the order of the addresses of `layout`."""
        # The same as `numpy.stack`, in a third of its time.
        return np.concatenate([sample.values for sample in self.samples]).reshape(len(self.samples), -1)

    @functools.cached_property
    def sequence(self) -> NDArray[np.int64]:
        """Numbers of the samples since the subscription began, shape (samples,); lost samples are counted."""
        return np.array([sample.sequence for sample in self.samples], np.int64)

    @functools.cached_property
    def time(self) -> NDArray[np.float64] | None:
        """Instants of sampling in seconds of the gateway's clock, shape (samples,); None without timestamps."""
        if self.samples[0].time is None:
            return None
        return np.array([sample.time for sample in self.samples], np.float64)

    @functools.cached_property
    def arrived(self) -> NDArray[np.float64]:
        """Instants of arrival in seconds of this machine's clock, shape (samples,)."""
        return np.array([sample.arrived for sample in self.samples], np.float64)

    @functools.cached_property
    def lost(self) -> NDArray[np.int64]:
        """Number of samples lost before each sample, shape (samples,)."""
        return np.array([sample.lost for sample in self.samples], np.int64)

    @functools.cached_property
    def epoch(self) -> NDArray[np.int64]:
        """Numbers of the sessions in which the samples arrived, shape (samples,)."""
        return np.array([sample.epoch for sample in self.samples], np.int64)


def _monotonic(instant: float) -> float:
    """Return the instant of `time.monotonic` for a past instant of `time.time`."""
    while True:
        before, now = time.monotonic(), time.time()
        # Read both again if the program was suspended in between: the instant would come out too early.
        if time.monotonic() - before < _TOGETHER:
            return before - (now - instant) if now > instant else before


def _never_back(instants: NDArray[np.float64], latest: float) -> NDArray[np.float64]:
    """Return instants limited to `latest`, each raised to at least the one before it."""
    return np.maximum.accumulate(np.minimum(instants, latest))

"""The display of `watch` on a terminal: one row for each address or signal, with a curve of its last seconds."""

from __future__ import annotations

import math
import time
from collections import deque
from typing import TYPE_CHECKING, Any

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from unity_link.bridges.presence import Presence
from unity_link.cli.plots import DOTS_ACROSS, Curve, Rgb, draw

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.console import ConsoleDimensions

    from unity_link.cli.watched import Stream, Taken, Watched
    from unity_link.link.link import Link

WINDOW = 10.0
"""Length of a curve in seconds."""
COLORS: tuple[Rgb, ...] = ((86, 182, 232), (240, 160, 80), (126, 200, 120), (220, 130, 190), (230, 210, 90))
_HEADINGS = ("value", "min", "max")
_GAP = 2
"""Columns of the terminal between two columns of the table."""
_MOST_BINS = 400
_NARROWEST_PLOT = 10
_WIDEST_PLOT = 60


class Trace:
    """The values of one row over time: minimum, maximum, and a curve of bounded size.

    The curve is stored in bins of equal duration, each with its minimum and maximum, so that peaks between two redraws
    remain visible at any sample rate.
    """

    def __init__(self) -> None:
        self.lowest: float = 0
        self.highest: float = 0
        self._empty = True
        self._bins: deque[tuple[int, float, float]] = deque(maxlen=_MOST_BINS)

    def take(self, value: float, at: float) -> None:
        """Add the value at a time in seconds."""
        # A NaN counts as minimum and maximum only until another value arrives.
        if self._empty or math.isnan(self.lowest):
            self._empty = False
            self.lowest = self.highest = value
        self.lowest = min(self.lowest, value)
        self.highest = max(self.highest, value)
        if not math.isfinite(value):
            return
        place = int(at / WINDOW * _MOST_BINS)
        if self._bins and self._bins[-1][0] == place:
            _, low, high = self._bins.pop()
            self._bins.append((place, min(low, value), max(high, value)))
        else:
            self._bins.append((place, value, value))

    def curve(self, at: float, most: int, color: Rgb) -> Curve:
        """Return the finite values of the last seconds before `at` as a curve of about `most` points."""
        newest = int(at / WINDOW * _MOST_BINS)
        merged: dict[int, list[float]] = {}
        for place, low, high in self._bins:
            if place > newest - _MOST_BINS:
                merged.setdefault((place - newest) * most // (2 * _MOST_BINS), []).extend((low, high))
        xs, ys = [], []
        for place, values in merged.items():
            low, high = min(values), max(values)
            for value in (low,) if low == high else (low, high):
                xs.append(2 * place / most)
                ys.append(value)
        return Curve(xs, ys, color)


class WatchView:
    """The table with the values of the samples that it receives."""

    def __init__(self, url: str, link: Link, samples: Stream, watched: Watched) -> None:
        self._url = url
        self._samples = samples
        self._names = watched.names
        self._watched = watched
        self._traces = [Trace() for _ in watched.names]
        self._values: Sequence[Any] = [0] * len(watched.names)
        """The values of the newest sample."""
        self._began = time.monotonic()
        self._presence = Presence(link, self._began)

    def take(self, sample: Taken) -> None:
        """Add a sample."""
        at = time.monotonic()
        self._values = self._watched.values(sample)
        for trace, value in zip(self._traces, self._values, strict=True):
            trace.take(self._watched.number(value), at)

    def render(self, size: ConsoleDimensions) -> RenderableType:
        """Return the table for a terminal of `size`; rows that do not fit are only counted."""
        frame = 6
        shown = max(1, min(len(self._names), size.height - frame))
        height = 2 if 2 * shown <= size.height - frame else 1
        rows = zip(self._values, self._traces[:shown], strict=False)
        texts = [[self._watched.text(one) for one in (value, t.lowest, t.highest)] for value, t in rows]
        widths = [
            max(map(len, (self._watched.heading, *self._names[:shown]))),
            *(max(5, *map(len, column)) for column in zip(*texts, strict=True)),
        ]
        # If the columns do not fit, show only the value.
        columns = len(_HEADINGS) if sum(widths) + _GAP * len(widths) <= size.width else 1
        rest = size.width - sum(widths[: columns + 1]) - _GAP * (columns + 2)
        plot_width = min(rest, _WIDEST_PLOT)
        table = Table(box=None, header_style="dim", padding=(0, 1), show_edge=False)
        table.add_column(self._watched.heading, style="cyan", no_wrap=True, min_width=widths[0])
        for heading in _HEADINGS[:columns]:
            table.add_column(heading, justify="right", no_wrap=True, style="bold" if heading == "value" else "")
        if plot_width >= _NARROWEST_PLOT:
            table.add_column(f"last {WINDOW:g} s", no_wrap=True)
        for number, (name, row) in enumerate(zip(self._names, texts, strict=False)):
            cells: list[RenderableType] = [name, *row[:columns]]
            if plot_width >= _NARROWEST_PLOT:
                cells.append(self._plot(number, plot_width, height))
            table.add_row(*cells)
        hidden = len(self._names) - shown
        note = Text(f" and {hidden} more that this terminal has no room for", "dim") if hidden else Text()
        return Group(self._title(), Text(), table, note, self._state())

    def _plot(self, number: int, width: int, height: int) -> Text:
        trace = self._traces[number]
        curve = trace.curve(time.monotonic(), DOTS_ACROSS * width, COLORS[number % len(COLORS)])
        low, high = (min(curve.ys), max(curve.ys)) if len(curve.ys) else (0, 0)
        return draw(width, height, [curve], (-1, 0), (low, high))

    def _title(self) -> Text:
        return _one_line((" unity-link watch ", "bold"), (self._url, "cyan"))

    def _state(self) -> Text:
        seconds = time.monotonic() - self._began
        received, lost = self._samples.received, self._samples.lost
        self._presence.look(time.monotonic(), received, self._samples.rate_hz)
        rate = f"{received / seconds:,.1f} Hz of {self._samples.rate_hz:,.5g}" if seconds > 1 else "..."
        return _one_line(
            (f" {seconds:.0f} s   {received:,} samples   {rate}   ", "dim"),
            (f"{lost:,} lost", "bold red" if lost else "green"),
            ("", "") if self._presence.away_since is None else ("   the gateway is away", "bold red"),
            ("   q ends", "dim"),
        )


def _one_line(*parts: tuple[str, str]) -> Text:
    return Text.assemble(*parts, no_wrap=True, overflow="ellipsis")

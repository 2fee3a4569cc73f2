"""HTML tables of links and robots for notebooks. No request is sent for them."""

from __future__ import annotations

import enum
from html import escape
from typing import TYPE_CHECKING, Any, ClassVar, Protocol

from unity_link.capture.decoder import summary

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from unity_link.protocol.wire.configuration import GatewayInfo

LONGEST = 200
"""Most characters of a cell; longer texts are cut."""
_CELL = 'style="text-align: left"'


class ShownStatistics(Protocol):
    """The part of `unity_link.Statistics` that this module uses."""

    __struct_fields__: ClassVar[tuple[str, ...]]

    @property
    def round_trip(self) -> float | None:
        """Smoothed round trip in seconds."""


class ShownLink(Protocol):
    """The part of an asynchronous or blocking link that this module uses."""

    @property
    def gateway(self) -> GatewayInfo:
        """Configuration of its gateway."""

    @property
    def statistics(self) -> ShownStatistics:
        """Counters since the link was opened."""


def table(title: str, rows: Iterable[Sequence[object]], head: Sequence[object] = ()) -> str:
    """Return a table in HTML.

    Args:
        title: text above the table.
        rows: cells of each row; they are converted to text and escaped.
        head: names of the columns.
    """
    parts = [f"<p>{_text(title)}</p>", "<table>"]
    if head:
        parts.append(f"<thead><tr>{''.join(f'<th {_CELL}>{_text(cell)}</th>' for cell in head)}</tr></thead>")
    lines = (f"<tr>{''.join(f'<td {_CELL}>{_text(cell)}</td>' for cell in row)}</tr>" for row in rows)
    return "".join([*parts, "<tbody>", *lines, "</tbody></table>"])


def link_table(link: ShownLink) -> str:
    """Return a table with the URL of a link, its gateway and its statistics."""
    rows = [("gateway", summary(link.gateway)), *statistics_rows(link.statistics)]
    return table(repr(link)[1:-1], rows)


def statistics_rows(statistics: ShownStatistics) -> list[tuple[str, str]]:
    """Return the statistics of a link as rows of a table."""
    counts = [name for name in statistics.__struct_fields__ if name != "round_trip"]
    rows = [(name.replace("_", " "), f"{getattr(statistics, name):,}") for name in counts]
    return [*rows, ("round trip", duration_text(statistics.round_trip))]


def long_table(
    title: str, count: int, row: Callable[[int], Sequence[object]], head: Sequence[object], *, most: int
) -> str:
    """Return a table of `count` rows; if they are more than `most`, of the first and the last ones.

    Args:
        title: text above the table.
        count: number of rows.
        row: returns the cells of the row with a number from 0 on; called only for rows that are shown.
        head: names of the columns.
        most: most rows of the table.
    """
    if count <= most:
        return table(title, map(row, range(count)), head)
    first, last = map(row, range(most // 2)), map(row, range(count - most // 2, count))
    return table(title, [*first, ["…"] * len(head), *last], head)


def value_text(value: Any) -> str:
    """Format the value of a signal for display."""
    if value is None:
        return "-"
    if isinstance(value, enum.Enum):
        return value.name
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def duration_text(seconds: float | None) -> str:
    """Format a duration in seconds for display, with a unit."""
    if seconds is None:
        return "-"
    for factor, unit in ((1e6, "µs"), (1e3, "ms")):
        if seconds * factor < 999.5:
            return f"{seconds * factor:.3g} {unit}"
    return f"{seconds:.3g} s"


def _text(cell: object) -> str:
    text = str(cell)
    return escape(text if len(text) <= LONGEST else f"{text[: LONGEST - 1]}…")

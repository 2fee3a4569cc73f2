"""The HTML that notebooks show in place of a `repr`: small tables. Nothing is asked of a gateway for them."""

from __future__ import annotations

import enum
from html import escape
from typing import TYPE_CHECKING, Any, ClassVar, Protocol

from unity_link.capture.decoder import summary

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from unity_link.protocol.wire.configuration import GatewayInfo

LONGEST = 200
"""Characters of a cell that are shown."""
_CELL = 'style="text-align: left"'


class ShownStatistics(Protocol):
    """Counters of a link: `unity_link.Statistics`."""

    __struct_fields__: ClassVar[tuple[str, ...]]

    @property
    def round_trip(self) -> float | None:
        """Smoothed round trip in seconds."""


class ShownLink(Protocol):
    """A link of any face."""

    @property
    def gateway(self) -> GatewayInfo:
        """Description of its gateway."""

    @property
    def statistics(self) -> ShownStatistics:
        """Counters since it was opened."""


def table(title: str, rows: Iterable[Sequence[object]], head: Sequence[object] = ()) -> str:
    """Return a table in HTML.

    Args:
        title: stands above it.
        rows: the cells; whatever is in them is shown as text.
        head: names of the columns.
    """
    parts = [f"<p>{_text(title)}</p>", "<table>"]
    if head:
        parts.append(f"<thead><tr>{''.join(f'<th {_CELL}>{_text(cell)}</th>' for cell in head)}</tr></thead>")
    lines = (f"<tr>{''.join(f'<td {_CELL}>{_text(cell)}</td>' for cell in row)}</tr>" for row in rows)
    return "".join([*parts, "<tbody>", *lines, "</tbody></table>"])


def link_table(link: ShownLink) -> str:
    """Return where a link leads, what its gateway is, and what it has seen."""
    rows = [("gateway", summary(link.gateway)), *statistics_rows(link.statistics)]
    return table(repr(link)[1:-1], rows)


def statistics_rows(statistics: ShownStatistics) -> list[tuple[str, str]]:
    """Return what a link has seen, as rows of a table."""
    counts = [name for name in statistics.__struct_fields__ if name != "round_trip"]
    rows = [(name.replace("_", " "), f"{getattr(statistics, name):,}") for name in counts]
    return [*rows, ("round trip", duration_text(statistics.round_trip))]


def long_table(
    title: str, count: int, row: Callable[[int], Sequence[object]], head: Sequence[object], *, most: int
) -> str:
    """Return a table of `count` rows, or of some at the beginning and some at the end where there are more than `most`.

    Args:
        title: stands above it.
        count: of the rows.
        row: returns the cells of one by its number; it is asked for those that are shown.
        head: names of the columns.
        most: rows that are shown.
    """
    if count <= most:
        return table(title, map(row, range(count)), head)
    first, last = map(row, range(most // 2)), map(row, range(count - most // 2, count))
    return table(title, [*first, ["…"] * len(head), *last], head)


def value_text(value: Any) -> str:
    """Return a value of a signal as people read it."""
    if value is None:
        return "-"
    if isinstance(value, enum.Enum):
        return value.name
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def duration_text(seconds: float | None) -> str:
    """Return a duration as people read it."""
    if seconds is None:
        return "-"
    for factor, unit in ((1e6, "µs"), (1e3, "ms")):
        if seconds * factor < 999.5:
            return f"{seconds * factor:.3g} {unit}"
    return f"{seconds:.3g} s"


def _text(cell: object) -> str:
    text = str(cell)
    return escape(text if len(text) <= LONGEST else f"{text[: LONGEST - 1]}…")

"""Draws a part of a simulation's waveform (VCD) as SVG: clock, bits, words, and the numbers of the cycles.

Libraries for timing diagrams draw hand-written cells of one clock; this module draws the times of a simulation, with
two clocks or none. A picture has its own background, so that it is readable on light and dark pages.
"""

from __future__ import annotations

import bisect
import dataclasses
import itertools
from html import escape
from typing import TYPE_CHECKING

from vcd.reader import TokenKind, tokenize

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from pathlib import Path

_LABELS, _WIDTH, _MARGIN = 118, 760, 10
_TOP, _ROW, _HEIGHT = 26, 25, 15
_SLANT = 2.0
_LETTER = 6.2
"""Width of a letter of a value, in pixels."""
_LEAST_TICK, _LEAST_NUMBER = 7, 20
_STEPS = (1, 2, 5, 10, 20, 50, 100, 200, 500)
"""Possible numbers of cycles between grid lines, and between cycle numbers."""
_DEFINED = frozenset("01")
_PICOSECONDS = {"fs": 0.001, "ps": 1, "ns": 1000}
_STYLE = """\
.p{fill:#fff}.w{fill:none;stroke:#14507a}.b{fill:#e3eef7;stroke:#14507a}.x{fill:#d4d4d4;stroke:#8a8a8a}
.c{fill:none;stroke:#7a7a7a}.g{stroke:#c4ccd2;stroke-dasharray:2 2}text{fill:#1c2329}.n{fill:#5d6b76;font-size:10px}
@media(prefers-color-scheme:dark){.p{fill:#17191c}.w{stroke:#7cc0f0}.b{fill:#20364a;stroke:#7cc0f0}
.x{fill:#3d3f42;stroke:#8a8a8a}.c{stroke:#9a9a9a}.g{stroke:#3c444b}text{fill:#e4e8eb}.n{fill:#9aa7b1}}"""


@dataclasses.dataclass(frozen=True)
class Row:
    """A signal of a picture."""

    signal: str
    """Name of the signal in the simulated entity."""
    label: str = ""
    """Label instead of the name."""
    when: str = ""
    """The value is shown only while this signal is 1."""
    as_text: bool = False
    """The value is shown as a character."""
    each: str = ""
    """Clock at each rising edge of which a new value is drawn, even if it is unchanged."""


@dataclasses.dataclass(frozen=True)
class Window:
    """An interval of time, in ps."""

    begin: int
    end: int
    zero: int
    """The edge at this time has the number 0."""


class Waveform:
    """Values of the signals of an entity, from a file that the simulator wrote.

    Args:
        path: of the file.
        wanted: names of signals of the outermost entity.

    Raises:
        KeyError: if the file has no signal of a wanted name.
    """

    def __init__(self, path: Path, wanted: Sequence[str]) -> None:
        self._changes: dict[str, list[tuple[int, str]]] = {name: [] for name in wanted}
        self._bits: dict[str, int] = {}
        self._names: dict[str, list[str]] = {}
        scope: list[str] = []
        now, unit = 0, 1.0
        with path.open("rb") as file:
            for token in tokenize(file):
                if token.kind is TokenKind.TIMESCALE:
                    unit = _PICOSECONDS[token.timescale.unit.value] * int(token.timescale.magnitude)
                elif token.kind is TokenKind.SCOPE:
                    scope.append(token.scope.ident)
                elif token.kind is TokenKind.UPSCOPE:
                    scope.pop()
                elif token.kind is TokenKind.VAR:
                    self._declare(".".join((*scope[1:], token.var.reference)), token.var.id_code, token.var.size)
                elif token.kind is TokenKind.CHANGE_TIME:
                    now = round(token.time_change * unit)
                elif token.kind in (TokenKind.CHANGE_SCALAR, TokenKind.CHANGE_VECTOR):
                    self._note(token.data.id_code, now, token.data.value)
        missing = set(wanted) - set(self._bits)
        if missing:
            raise KeyError(f"{path} has no {', '.join(sorted(missing))}")

    def _declare(self, name: str, code: str, bits: int) -> None:
        if name in self._changes:
            self._names.setdefault(code, []).append(name)
            self._bits[name] = bits

    def _note(self, code: str, now: int, value: int | str) -> None:
        for name in self._names.get(code, ()):
            changes = self._changes[name]
            text = f"{value:0{self._bits[name]}b}" if isinstance(value, int) else value.lower()
            if changes and changes[-1][0] == now:
                changes[-1] = now, text
            elif not changes or changes[-1][1] != text:
                changes.append((now, text))

    def at(self, name: str, time: int) -> str:
        """Return the value of a signal from a time on, as binary digits or letters."""
        changes = self._changes[name]
        index = bisect.bisect_right(changes, time, key=lambda change: change[0])
        return changes[index - 1][1] if index else "u"

    def edges(self, name: str, window: Window) -> list[int]:
        """Return the times in a window at which a clock rises."""
        return [at for at, value in self._changes[name] if value == "1" and window.begin <= at <= window.end]

    def pieces(self, row: Row, window: Window) -> Iterator[tuple[int, int, str | None]]:
        """Yield begin, end and value of each interval of a signal in a window; the value is None if it is not shown."""
        names = [row.signal, *([row.when] if row.when else [])]
        instants = {at for name in names for at, _ in self._changes[name] if window.begin < at < window.end}
        steps = {at for at in self.edges(row.each, window) if at > window.begin} if row.each else set()
        instants |= steps - {window.end}
        bounds = [window.begin, *sorted(instants), window.end]
        values = [self.at(row.signal, at) if not row.when or self.at(row.when, at) == "1" else None for at in bounds]
        begin = bounds[0]
        for (value, following), (_, at) in zip(itertools.pairwise(values), itertools.pairwise(bounds), strict=True):
            if following != value or at == window.end or (value is not None and at in steps):
                yield begin, at, value
                begin = at


def draw(waveform: Waveform, title: str, rows: Sequence[Row], clock: str, window: Window) -> str:
    """Return the picture of some signals in a window.

    Args:
        waveform: of the simulation.
        title: text alternative of the picture.
        rows: the signals, from the top.
        clock: the clock whose cycles are numbered.
        window: the interval to show.
    """
    height = _TOP + _ROW * len(rows) + _MARGIN
    whole = _LABELS + _WIDTH + _MARGIN
    scale = _Scale(window)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {whole} {height}" width="{whole}" height="{height}"',
        '  role="img" font-family="ui-monospace,Menlo,Consolas,monospace" font-size="11">',
        f"<title>{escape(title)}</title>",
        f"<style>{_STYLE}</style>",
        f'<rect class="p" width="{whole}" height="{height}" rx="4"/>',
        *_grid(waveform.edges(clock, window), window, scale, height),
    ]
    for index, row in enumerate(rows):
        top = _TOP + _ROW * index + (_ROW - _HEIGHT) / 2
        name = escape(row.label or row.signal)
        parts.append(f'<text x="{_LABELS - 8}" y="{_n(top + 11.5)}" text-anchor="end">{name}</text>')
        pieces = list(waveform.pieces(row, window))
        is_clock = row.signal.endswith(("clk", "clkout"))
        is_bit = all(value is None or len(value) == 1 for _, _, value in pieces) and not row.as_text
        parts += _bits(pieces, scale, top, "c" if is_clock else "w") if is_bit else _words(pieces, scale, top, row)
    return "\n".join([*parts, "</svg>"]) + "\n"


class _Scale:
    def __init__(self, window: Window) -> None:
        self._begin = window.begin
        self._pixels = _WIDTH / (window.end - window.begin)

    def __call__(self, time: int) -> float:
        return _LABELS + (time - self._begin) * self._pixels


def _grid(edges: list[int], window: Window, scale: _Scale, height: float) -> Iterator[str]:
    """Yield a line for each edge, and its number, if there is enough space."""
    if len(edges) < 2:
        return
    pitch = scale(edges[1]) - scale(edges[0])
    every, line = (next(step for step in _STEPS if step * pitch >= least) for least in (_LEAST_NUMBER, _LEAST_TICK))
    first = -bisect.bisect_left(edges, window.zero)
    lines = []
    for number, edge in enumerate(edges, first):
        x = scale(edge)
        if number % line == 0:
            lines.append(f"M{_n(x)} {_TOP - 6}V{_n(height - _MARGIN)}")
        if number % every == 0:
            yield f'<text class="n" x="{_n(x)}" y="{_TOP - 10}" text-anchor="middle">{number}</text>'
    yield f'<path class="g" d="{"".join(lines)}"/>'


def _bits(pieces: list[tuple[int, int, str | None]], scale: _Scale, top: float, style: str) -> Iterator[str]:
    path, last = "", None
    for begin, end, value in pieces:
        left, right = scale(begin), scale(end)
        if value is not None and value not in _DEFINED and value != "z":
            yield _box(left, right, top, "x")
            last = None
            continue
        level = top + {"1": 0, "0": _HEIGHT}.get(value or "", _HEIGHT / 2)
        path += f"M{_n(left)} {_n(level)}" if last is None else f"V{_n(level)}"
        path += f"H{_n(right)}"
        last = value
    if path:
        yield f'<path class="{style}" d="{path}"/>'


def _words(pieces: list[tuple[int, int, str | None]], scale: _Scale, top: float, row: Row) -> Iterator[str]:
    for begin, end, value in pieces:
        left, right = scale(begin), scale(end)
        if value is None or set(value) <= {"z"}:
            yield f'<path class="c" d="M{_n(left)} {_n(top + _HEIGHT / 2)}H{_n(right)}"/>'
        elif not set(value) <= _DEFINED:
            yield _box(left, right, top, "x")
        else:
            yield _box(left, right, top, "b")
            text = _text(value, row)
            if len(text) * _LETTER > right - left - 2:
                text = text.lstrip("0") or "0"
            if len(text) * _LETTER <= right - left - 2:
                middle = _n((left + right) / 2)
                yield f'<text x="{middle}" y="{_n(top + 11.5)}" text-anchor="middle">{escape(text)}</text>'


def _text(value: str, row: Row) -> str:
    number = int(value, 2)
    if row.as_text:
        return {10: "\u21b5"}.get(number, chr(number))
    return f"{number:0{-(-len(value) // 4)}X}"


def _box(left: float, right: float, top: float, style: str) -> str:
    slant = min(_SLANT, (right - left) / 2)
    return (
        f'<path class="{style}" d="M{_n(left)} {_n(top + _HEIGHT / 2)}L{_n(left + slant)} {_n(top)}'
        f"H{_n(right - slant)}L{_n(right)} {_n(top + _HEIGHT / 2)}L{_n(right - slant)} {_n(top + _HEIGHT)}"
        f'H{_n(left + slant)}Z"/>'
    )


def _n(value: float) -> str:
    return f"{value:.1f}".removesuffix(".0")

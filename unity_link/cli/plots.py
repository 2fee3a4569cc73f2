"""Draws curves in Braille dots: plotext draws, rich shows.

A cell of a terminal has 2 by 4 dots. plotext has one figure for the whole process; it is cleared before each use. Its
axes are left out, because the commands print their own.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rich.text import Text

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

FARTHEST = 1e300
"""Largest number that plotext can draw; if the difference of two limits exceeds the range of a double, it ends the
process.
"""
DOTS_ACROSS = 2
DOTS_DOWN = 4
Rgb = tuple[int, int, int]
Limits = tuple[float, float]


class Curve:
    """Points joined by lines, in the order given; the colour has red, green and blue from 0 to 255."""

    def __init__(self, xs: Sequence[float], ys: Sequence[float], color: Rgb) -> None:
        self.xs = xs
        self.ys = ys
        self.color = color


def draw(width: int, height: int, curves: Iterable[Curve], x_limits: Limits, y_limits: Limits) -> Text:
    """Draw curves, later ones over earlier ones.

    Args:
        width: columns of the terminal.
        height: rows of the terminal.
        curves: curves of finite numbers; one without points is skipped.
        x_limits: values at the left and the right edge.
        y_limits: values at the lower and the upper edge.
    """
    import plotext

    if max(map(abs, y_limits)) > FARTHEST:
        curves = [Curve(curve.xs, [y / 4 for y in curve.ys], curve.color) for curve in curves]
        y_limits = y_limits[0] / 4, y_limits[1] / 4
    figure = plotext.figure
    figure.clear()
    figure.plot_size(width, height)
    figure.canvas("default")
    figure.axes(active=False)
    for axis, limits in (("x", x_limits), ("y", y_limits)):
        figure.ruler(axis).ticks([])
        figure.ruler(axis).lim(*_apart(limits))
    for curve in curves:
        if len(curve.xs):
            figure.draw(_signal(figure, plotext.marker("braille", pixel=curve.color), curve))
    return Text.from_ansi(figure.build().string().rstrip("\n"), no_wrap=True)


def _signal(figure: Any, marker: Any, curve: Curve) -> Any:
    signal = figure.signal(list(curve.xs), list(curve.ys), marker=marker)
    signal.lines(True)
    return signal


def _apart(limits: Limits) -> Limits:
    """Return limits that differ, so that a flat curve is drawn in the middle."""
    low, high = limits
    return limits if low < high else (low - 1, high + 1)

"""The picture of `demo`: the calls with their results, the robot from above, and its four positions over time."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from rich.align import Align
from rich.console import Group, RenderableType
from rich.panel import Panel
from rich.progress_bar import ProgressBar
from rich.table import Table
from rich.text import Text

from unity_link.capture.decoder import summary as describe_gateway
from unity_link.cli.demo_run import HISTORY, Demo, Summary
from unity_link.cli.plots import DOTS_ACROSS, Curve, Rgb, draw
from unity_link.virtual.scara import JOINTS

if TYPE_CHECKING:
    from rich.console import ConsoleDimensions

COLORS: tuple[Rgb, ...] = ((86, 182, 232), (240, 160, 80), (126, 200, 120), (220, 130, 190))
"""One colour for each joint; they differ also for people with red-green blindness."""
TARGET: Rgb = (110, 110, 125)
TRAIL: Rgb = (95, 110, 140)
UPPER_ARM, FOREARM = 0.55, 0.45
"""Lengths of the two drawn arms; their sum is 1."""
_TRAIL_SAMPLES = 150
_CODE_WIDTH = 46
_WIDEST, _TALLEST_PLOT, _SHORTEST_PLOT = 110, 5, 2
_NARROWEST = 70
"""Columns from which the robot is shown beside the plots, and the results beside the calls."""
_AROUND_PLOTS = 13
"""Rows of everything but the plots, including the summary below."""
_FRAME, _STEPS = 3, 5
"""Rows of the frame with the progress bar, and of the calls."""


def render(show: Demo, size: ConsoleDimensions) -> RenderableType:
    """Return the picture for a terminal of `size`."""
    width = min(size.width, _WIDEST)
    joints = len(JOINTS)
    height = min(max((size.height - _AROUND_PLOTS) // joints - 1, _SHORTEST_PLOT), _TALLEST_PLOT)
    # On a low terminal, leave out the calls, then the plots, and keep the numbers.
    height = min(height, max((size.height - _FRAME - _STEPS) // joints - 1, 0))
    rows = joints * (height + 1)
    above: list[RenderableType] = []
    if rows + _FRAME + _STEPS <= size.height:
        above = [_steps(show, width), Text()]
    arm_width = min(2 * rows, width // 2 - 8) if width >= _NARROWEST and height else 0
    plots = Table.grid(padding=(0, 1))
    if arm_width:
        plots.add_row(_arm(show, arm_width, rows), _joints(show, width - arm_width - 7, height))
    else:
        plots.add_row(_joints(show, width - 5, height))
    panel = Panel(
        Group(*above, plots, _progress(show, width - 4)),
        title=Text.assemble((" Unity-Link ", "bold")),
        subtitle=Text(f" {show.url}: {describe_gateway(show.gateway)} ", "dim", overflow="ellipsis", no_wrap=True),
        border_style="dim",
        width=width,
        padding=(0, 1),
    )
    return Align.left(panel)


def render_summary(summary: Summary) -> RenderableType:
    """Return the summary as a table."""
    table = Table.grid(padding=(0, 2))
    table.add_column(style="bold green", no_wrap=True)
    for name, text in summary.describe():
        table.add_row(f" {name}", text)
    return table


def _steps(show: Demo, width: int) -> Table:
    rest = width - 6
    code_width = min(_CODE_WIDTH, rest)
    table = Table.grid(padding=(0, 1))
    table.add_column(width=1)
    table.add_column(style="cyan", overflow="ellipsis", no_wrap=True, width=code_width)
    if width >= _NARROWEST:
        table.add_column(overflow="ellipsis", no_wrap=True, width=rest - code_width - 1)
    for step in show.steps:
        mark = Text("✓", "bold green") if step.result else Text("·", "dim")
        cells: list[RenderableType] = [mark, step.code, Text(step.result)]
        table.add_row(*cells[: len(table.columns)])
    return table


def _color(rgb: Rgb) -> str:
    return "rgb({},{},{})".format(*rgb)


def _joints(show: Demo, width: int, height: int) -> Table:
    """Draw position and set point of each joint over time."""
    now = show.elapsed
    limits = (now - HISTORY, now)
    table = Table.grid()
    table.add_column(width=width)
    for number, (joint, color) in enumerate(zip(JOINTS, COLORS, strict=True)):
        unit = "°" if joint.unit == "degree" else f" {joint.unit}"
        position = show.history[-1][1][number] / joint.counts_per_unit if show.history else 0.0
        target = show.targets[-1][1][number] if show.targets else 0.0
        title = Table.grid(padding=(0, 1), expand=True)
        title.add_column(no_wrap=True)
        title.add_column(no_wrap=True, justify="right")
        title.add_row(
            Text.assemble((f"{joint.name:<9}", f"bold {_color(color)}"), (f"{position:+8.1f}{unit}", "bold")),
            Text(f"set point {target:+.0f}{unit}", "dim"),
        )
        span = (joint.lowest / joint.counts_per_unit, joint.highest / joint.counts_per_unit)
        margin = 0.02 * (span[1] - span[0])
        curves = [_set_points(show, number, now), _positions(show, number, color, 2 * DOTS_ACROSS * width)]
        table.add_row(title)
        if height:
            table.add_row(draw(width, height, curves, limits, (span[0] - margin, span[1] + margin)))
    return table


def _set_points(show: Demo, number: int, now: float) -> Curve:
    """Return the set point of a joint over time, as steps."""
    xs, ys = [], []
    ends = [*(start for start, _ in show.targets[1:]), now]
    for (start, pose), end in zip(show.targets, ends, strict=False):
        if end > now - HISTORY:
            xs += [max(start, now - HISTORY), end]
            ys += [pose[number], pose[number]]
    return Curve(xs, ys, TARGET)


def _positions(show: Demo, number: int, color: Rgb, most: int) -> Curve:
    samples = list(show.history)
    chosen = samples[:: max(1, len(samples) // most)]
    scale = JOINTS[number].counts_per_unit
    return Curve([at for at, _ in chosen], [counts[number] / scale for _, counts in chosen], color)


def _arm(show: Demo, width: int, height: int) -> Text:
    """Draw the robot from above, with the path of its tool."""
    samples = list(show.history)[-_TRAIL_SAMPLES:]
    ways = [_elbow_and_tool(counts) for _, counts in samples[::2]]
    elbow, tool = _elbow_and_tool(samples[-1][1]) if samples else ((0.0, UPPER_ARM), (0.0, 1.0))
    curves = [
        Curve([x for _, (x, _) in ways], [y for _, (_, y) in ways], TRAIL),
        _circle((0.0, 0.0), 0.06, COLORS[0]),
        Curve([0.0, elbow[0]], [0.0, elbow[1]], COLORS[0]),
        Curve([elbow[0], tool[0]], [elbow[1], tool[1]], COLORS[1]),
        _circle(elbow, 0.04, COLORS[1]),
        _circle(tool, 0.05, COLORS[3]),
    ]
    # A dot is as high as it is wide, so use the same scale for both axes.
    reach = 1.1
    across = reach * width * DOTS_ACROSS / (height * 4)
    return draw(width, height, curves, (-across, across), (-reach, reach))


def _elbow_and_tool(counts: list[int]) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the positions of elbow and tool; for angles of 0 both arms point up."""
    shoulder, elbow = (math.radians(counts[number] / JOINTS[number].counts_per_unit) for number in (0, 1))
    x, y = UPPER_ARM * math.sin(shoulder), UPPER_ARM * math.cos(shoulder)
    return (x, y), (x + FOREARM * math.sin(shoulder + elbow), y + FOREARM * math.cos(shoulder + elbow))


def _circle(middle: tuple[float, float], radius: float, color: Rgb) -> Curve:
    angles = [math.tau * step / 16 for step in range(17)]
    return Curve(
        [middle[0] + radius * math.cos(angle) for angle in angles],
        [middle[1] + radius * math.sin(angle) for angle in angles],
        color,
    )


def _progress(show: Demo, width: int) -> RenderableType:
    requests, samples, lost, median = show.counts
    asked, sampled = f"{requests:,} requests", f"{samples:,} samples"
    missing = Text(f"{lost:,} lost", "bold red" if lost else "green")
    taken = f"{1e6 * median:.0f} µs round trip" if median is not None else ""
    if width < _NARROWEST:
        return Text("   ", no_wrap=True, overflow="ellipsis", end="").join(
            [missing, *map(Text, (sampled, taken, asked))]
        )
    table = Table.grid(padding=(0, 3), expand=True)
    table.add_column(ratio=1)
    for _ in range(4):
        table.add_column(no_wrap=True, justify="right")
    bar = ProgressBar(total=show.duration, completed=min(show.elapsed, show.duration), width=max(4, width - 70))
    table.add_row(bar, asked, sampled, missing, taken)
    return table

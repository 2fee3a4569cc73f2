"""The experiment's two pictures, by matplotlib (extra ``plot``)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from benchmarks.paper import published
from benchmarks.paper.results import MODES
from unity_link.errors import UnsupportedError

if TYPE_CHECKING:
    from pathlib import Path

    from benchmarks.paper.results import Results, SendImmediate
    from benchmarks.paper.stacks import StackName

BURSTS, PUBLISHING = "figure3.png", "figure4.png"
DOTS_PER_INCH = 150
# Okabe and Ito's colours, which people with any colour vision can tell apart.
_COLOURS: dict[SendImmediate, str] = {"off": "#0072B2", "always": "#D55E00", "adaptive": "#009E73"}
_PAPER, _LINE, _GREY = "#CC79A7", "#444444", "#888888"
_STYLES: dict[StackName, dict[str, Any]] = {
    "full stack": {"linestyle": "-", "marker": "o", "markersize": 4.5},
    "low-level": {"linestyle": (0, (4, 2)), "marker": "s", "markersize": 3.5, "alpha": 0.85},
}
STYLE: dict[Any, Any] = {
    "font.family": "sans-serif",
    "font.size": 10,
    "axes.titlesize": 12,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#E4E4E4",
    "grid.linewidth": 0.8,
    "axes.axisbelow": True,
    "legend.frameon": False,
    "lines.linewidth": 1.8,
}


def draw(results: Results, folder: Path) -> list[Path]:
    """Draw both pictures into a folder, and give their files.

    Raises:
        UnsupportedError: where matplotlib is not installed.
    """
    try:
        import matplotlib as mpl
        from matplotlib.figure import Figure
    except ImportError as error:
        raise UnsupportedError(
            "plots need matplotlib, which is not installed: pip install 'unity-link[plot]'"
        ) from error
    files = []
    with mpl.rc_context(STYLE):
        for name, picture in ((BURSTS, _draw_bursts), (PUBLISHING, _draw_publishing)):
            figure = Figure(figsize=(11, 5) if picture is _draw_bursts else (8, 5.2), layout="constrained")
            picture(figure, results)
            files.append(folder / name)
            # No date and no version: the same figures give the same file.
            figure.savefig(files[-1], dpi=DOTS_PER_INCH, metadata={"Software": None})
    return files


def _draw_bursts(figure: Any, results: Results) -> None:
    times, rates = figure.subplots(1, 2)
    for stack, style in _STYLES.items():
        for mode in MODES:
            bursts = [burst for burst in results.bursts if (burst.stack, burst.send_immediate) == (stack, mode)]
            counts = [burst.count for burst in bursts]
            look = {**style, "color": _COLOURS[mode], "label": f"{stack}, {mode}"}
            times.plot(counts, [burst.microseconds / 1e3 for burst in bursts], **look)
            rates.plot(counts, [burst.megabits for burst in bursts], **look)
    for axes in (times, rates):
        axes.set_xscale("log", base=2)
        axes.set_yscale("log")
        axes.set_xlabel("reads in one burst")
        axes.xaxis.set_major_formatter(_plain)
        axes.yaxis.set_major_formatter(_plain)
    times.set_title("Time of a burst of reads")
    times.set_ylabel("until the last answer, ms")
    times.set_ylim(bottom=0.1)
    times.plot(1, published.FULL_STACK_READ_US / 1e3, marker="*", markersize=13, color=_PAPER, linestyle="none")
    times.plot(1, published.LOW_LEVEL_READ_US / 1e3, marker="*", markersize=13, color=_PAPER, linestyle="none")
    _note(times, "paper, full stack", 1, published.FULL_STACK_READ_US / 1e3)
    _note(times, "paper, low-level", 1, published.LOW_LEVEL_READ_US / 1e3, below=True)
    rates.set_title("Throughput of a burst of reads")
    rates.set_ylabel("answers, Mb/s")
    rates.axhline(64, color=_LINE, linewidth=1, linestyle=":")
    rates.annotate(
        "8 MB/s: what the FIFO carries", (1, 64), (2, 4), textcoords="offset points", color=_LINE, fontsize=9
    )
    rates.axhline(published.LOW_LEVEL_READS_MBITS, color=_PAPER, linewidth=1, linestyle=":")
    rates.annotate(
        f"paper, low-level, off: {published.LOW_LEVEL_READS_MBITS} Mb/s",
        (max(burst.count for burst in results.bursts), published.LOW_LEVEL_READS_MBITS),
        (0, -12),
        textcoords="offset points",
        ha="right",
        color=_PAPER,
        fontsize=9,
    )
    handles, labels = times.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=6, fontsize=9, handlelength=3.2)


def _draw_publishing(figure: Any, results: Results) -> None:
    axes = figure.subplots()
    limits = results.publish_limits
    words = [limit.words for limit in limits]
    axes.plot(
        words,
        [limit.line / 1e3 for limit in limits],
        color=_LINE,
        linestyle=":",
        linewidth=1.2,
        label="what 8 MB/s carry",
    )
    axes.plot(
        words,
        [limit.modelled / 1e3 for limit in limits],
        color=_COLOURS["off"],
        marker="s",
        markersize=4,
        linestyle=(0, (4, 2)),
        label="gateware and USB: a program that takes no time",
    )
    axes.plot(
        words,
        [limit.total / 1e3 for limit in limits],
        color=_COLOURS["adaptive"],
        marker="o",
        label="with this program, each sample by async for",
    )
    axes.set_xscale("log", base=2)
    axes.set_yscale("log")
    axes.xaxis.set_major_formatter(_plain)
    axes.yaxis.set_major_formatter(_plain)
    axes.set_xticks(words)
    axes.set_xlabel("words in one message")
    axes.set_ylabel("kHz")
    axes.set_title("Highest rate of publishing with none lost")
    axes.legend(loc="upper right", fontsize=9, handlelength=3.2)


def _note(axes: Any, text: str, x: float, y: float, *, below: bool = False) -> None:
    offset = (9, -20 if below else 4)
    axes.annotate(text, (x, y), offset, textcoords="offset points", color=_PAPER, fontsize=9)


def _plain(value: float, _position: int) -> str:
    return f"{value:,.10g}"

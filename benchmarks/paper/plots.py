"""The experiment's pictures, drawn with matplotlib (extra ``plot``): the paper's figures 3 and 4, and bursts."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from benchmarks.paper import published
from benchmarks.paper.results import STACKS
from benchmarks.paper.stacks import MODES
from unity_link.errors import UnsupportedError

if TYPE_CHECKING:
    from pathlib import Path

    from benchmarks.paper.published import Level
    from benchmarks.paper.results import Results
    from benchmarks.paper.stacks import Mode, StackName

AVERAGES, PUBLISHING, BURSTS = "figure3.png", "figure4.png", "bursts.png"
DOTS_PER_INCH = 150
# Okabe and Ito's colours, which are distinct for people with any colour vision.
_COLOURS: dict[Mode, str] = {"off": "#0072B2", "off, 1 ms": "#56B4E9", "always": "#D55E00", "adaptive": "#009E73"}
_PAPER, _LINE, _GREY = "#CC79A7", "#444444", "#888888"
_STYLES: dict[StackName, dict[str, Any]] = {
    "full stack": {"linestyle": "-", "marker": "o", "markersize": 4.5},
    "low-level": {"linestyle": (0, (4, 2)), "marker": "s", "markersize": 3.5, "alpha": 0.85},
}
_LEVELS: tuple[tuple[Level, str], ...] = (
    ("gateware", "gateware\nalone"),
    ("ideal link", "ideal\nlink"),
    ("low-level", "low-level\nPython"),
    ("full stack", "full\nstack"),
)
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
    """Draw the pictures into a folder, and return their files.

    Raises:
        UnsupportedError: if matplotlib is not installed.
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
        for name, picture, size in (
            (AVERAGES, _draw_averages, (11, 7.6)),
            (PUBLISHING, _draw_publishing, (8.5, 6)),
            (BURSTS, _draw_bursts, (11, 5.2)),
        ):
            figure = Figure(figsize=size, layout="constrained")
            picture(figure, results)
            files.append(folder / name)
            # Without date and version, so that the same figures give the same file.
            figure.savefig(files[-1], dpi=DOTS_PER_INCH, metadata={"Software": None})
    return files


def _draw_averages(figure: Any, results: Results) -> None:
    """Draw the paper's figure 3: average latencies and their standard deviations, by level."""
    places = figure.subplots(2, 2, sharey=True)
    for row, access in zip(places, ("read", "write"), strict=True):
        for axes, mode in zip(row, ("off", "always"), strict=True):
            ours: Mode = "off, 1 ms" if mode == "off" else "adaptive"
            what = "without send-immediate, timer of 1 ms" if mode == "off" else "with send-immediate (here: adaptive)"
            axes.set_title(f"{access.capitalize()}, {what}", fontsize=11)
            for offset, colour, values in (
                (-0.2, _PAPER, [_of_paper(level, access, mode) for level, _ in _LEVELS]),
                (0.2, _COLOURS[ours], [_of_ours(results, level, access, ours) for level, _ in _LEVELS]),
            ):
                shown = [(index + offset, *value) for index, value in enumerate(values) if value is not None]
                axes.bar(
                    [x for x, _, _ in shown],
                    [mean for _, mean, _ in shown],
                    0.36,
                    yerr=[[min(sd, 0.9 * mean) for _, mean, sd in shown], [sd for _, _, sd in shown]],
                    color=colour,
                    capsize=3,
                    ecolor=_LINE,
                )
                for x, mean, sd in shown:
                    axes.annotate(
                        f"{mean:,.4g}" if mean < 1000 else f"{mean:,.0f}",
                        (x, mean + sd),
                        (0, 3),
                        textcoords="offset points",
                        ha="center",
                        fontsize=8.5,
                    )
            axes.set_yscale("log")
            axes.set_ylim(0.2, 4000)
            axes.yaxis.set_major_formatter(_plain)
            axes.set_xticks(range(len(_LEVELS)), [name for _, name in _LEVELS])
            axes.grid(visible=False, axis="x")
        row[0].set_ylabel("request to answer, µs: mean, sd")
    from matplotlib.patches import Patch

    handles = [
        Patch(color=_PAPER, label="paper (its ideal link: reads alone)"),
        Patch(color=_COLOURS["off, 1 ms"], label="here, off"),
        Patch(color=_COLOURS["adaptive"], label="here, adaptive"),
    ]
    figure.legend(handles=handles, loc="outside lower center", ncols=3, fontsize=9)


def _of_paper(level: Level, access: Any, mode: Any) -> tuple[float, float] | None:
    figure = published.find(published.LATENCY, level, access, mode)
    return None if figure is None else (figure.value, figure.deviation or 0.0)


def _of_ours(results: Results, level: Level, access: Any, mode: Mode) -> tuple[float, float] | None:
    if level == "gateware":
        if results.gateware is None:
            return None
        figures = results.gateware
        return figures.microseconds(figures.read_cycles if access == "read" else figures.write_cycles), 0.0
    latency = results.latency("full stack" if level == "full stack" else "low-level", access, mode)
    if level == "ideal link":
        return None if latency.gateware is None else (latency.gateware, 0.0)
    return latency.total.mean, latency.total.deviation


def _draw_bursts(figure: Any, results: Results) -> None:
    times, rates = figure.subplots(1, 2)
    for stack, style in _STYLES.items():
        for mode in MODES:
            bursts = [burst for burst in results.bursts if (burst.stack, burst.send_immediate) == (stack, mode)]
            counts = [burst.count for burst in bursts]
            look = {**style, "color": _COLOURS[mode], "label": f"{stack}, {mode}"}
            times.plot(counts, [burst.total / 1e3 for burst in bursts], **look)
            rates.plot(counts, [burst.megabits(burst.total) for burst in bursts], **look)
    for axes in (times, rates):
        axes.set_xscale("log", base=2)
        axes.set_yscale("log")
        axes.set_xlabel("reads in one burst")
        axes.xaxis.set_major_formatter(_plain)
        axes.yaxis.set_major_formatter(_plain)
    times.set_title("Time of a burst of reads")
    times.set_ylabel("until the last answer, ms")
    times.set_ylim(bottom=0.1)
    for level, mode, below in (
        ("full stack", "off", False),
        ("low-level", "off", True),
        ("full stack", "always", False),
        ("low-level", "always", True),
    ):
        value = published.value(published.LATENCY, level, "read", mode) / 1e3  # type: ignore[arg-type]
        times.plot(1, value, marker="*", markersize=11, color=_PAPER, linestyle="none")
        if mode == "always":
            _note(times, f"paper, {level}, SI", 1, value, below=below)
        elif not below:
            _note(times, "paper, both, no SI", 1, value)
    rates.set_title("Throughput of a burst of reads")
    rates.set_ylabel("answers, Mb/s")
    rates.axhline(64, color=_LINE, linewidth=1, linestyle=":")
    rates.annotate(
        "8 MB/s: what the FIFO carries", (1, 64), (2, 4), textcoords="offset points", color=_LINE, fontsize=9
    )
    for mode, text in (("off", "paper, low-level, no SI"), ("always", "paper, low-level, SI")):
        most = published.value(published.MOST_REQUESTS, "low-level", "read", mode)  # type: ignore[arg-type]
        value = published.value(published.BURST_ANSWERS, "low-level", "read", mode) / 1e6  # type: ignore[arg-type]
        rates.plot(most, value, marker="*", markersize=11, color=_PAPER, linestyle="none")
        _note(rates, text, most, value, below=mode == "always")
    handles, labels = times.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=4, fontsize=9, handlelength=3.2)


def _draw_publishing(figure: Any, results: Results) -> None:
    """Draw the paper's figure 4: the limit of publishing over the size of the message."""
    axes = figure.subplots()
    if results.gateware is not None:
        rows = results.gateware.publishing
        points = [row.words for row in rows], [row.rate / 1e3 for row in rows]
        axes.plot(*points, color=_GREY, marker="D", markersize=3.5, label="gateware alone, all groups, 50 MHz")
    words = [limit.words for limit in results.publish_limits if limit.stack == STACKS[0]]
    line = [limit.line / 1e3 for limit in results.publish_limits if limit.stack == STACKS[0]]
    axes.plot(words, line, color=_LINE, linestyle=":", linewidth=1.4, label="ideal link, 8 MB/s")
    for stack, colour in (("low-level", _COLOURS["off"]), ("full stack", _COLOURS["adaptive"])):
        limits = [limit for limit in results.publish_limits if limit.stack == stack]
        burst, sustained = [limit.burst_total / 1e3 for limit in limits], [limit.total / 1e3 for limit in limits]
        sizes = [limit.words for limit in limits]
        # If both lines coincide, the wide one is visible on both sides of the other.
        look = {
            "color": colour,
            "linewidth": 4.5 if stack == "low-level" else 1.8,
            "alpha": 0.6 if stack == "low-level" else 1,
        }
        axes.plot(sizes, burst, linestyle=(0, (4, 2)), marker="^", markersize=5, label=f"{stack}, burst", **look)
        axes.plot(sizes, sustained, marker="o", markersize=4.5, label=f"{stack}, sustained", **look)
    axes.set_xscale("log", base=2)
    axes.set_yscale("log")
    axes.xaxis.set_major_formatter(_plain)
    axes.yaxis.set_major_formatter(_plain)
    axes.set_xticks(words)
    axes.set_xlabel("words in one message")
    axes.set_ylabel("kHz")
    axes.set_title("Highest rate of publishing with none lost")
    axes.legend(loc="upper right", fontsize=9, handlelength=3.2)
    base = results.parameters.base_frequency / 1e6
    axes.annotate(
        f"one group: at most {base:g} MHz here. The paper's points stand in its picture alone.",
        (0, 0),
        (0, -38),
        xycoords="axes fraction",
        textcoords="offset points",
        color=_GREY,
        fontsize=8.5,
        annotation_clip=False,
    )


def _note(axes: Any, text: str, x: float, y: float, *, below: bool = False) -> None:
    offset = (9, -14 if below else 4)
    axes.annotate(text, (x, y), offset, textcoords="offset points", color=_PAPER, fontsize=9)


def _plain(value: float, _position: int) -> str:
    return f"{value:,.10g}"

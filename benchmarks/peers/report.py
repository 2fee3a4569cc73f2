"""The results of the races: a list of quicker peers, a table and a picture."""

from __future__ import annotations

import datetime as dt
from typing import TYPE_CHECKING, Any

import unity_link
from benchmarks.paper.plots import DOTS_PER_INCH, STYLE

if TYPE_CHECKING:
    from pathlib import Path

    from benchmarks.peers.race import Finish

BEGIN, END = "<!-- Written by `make bench-peers`: begin -->", "<!-- end -->"
_LEVEL = 1.05
"""Ratio to ours below which a peer counts as equally quick."""
_QUICKER, _SLOWER = "#B3261E", "#2E6DA4"


def text(finishes: list[Finish], machine: str, rounds: int, picture: str) -> str:
    """Return the section of the page.

    Args:
        finishes: of all races, in order.
        machine: on which they were run.
        rounds: how often each contender has run.
        picture: path of the picture, relative to the page.
    """
    seen = (
        f"Seen on {dt.datetime.now(dt.UTC):%Y-%m-%d} by unity-link {unity_link.__version__}: {machine}. Medians of "
        f"{rounds} rounds, in each of which all run in turn; the ratios are medians of those within a round. "
        "The share of a processor is that of the process that reads; a lone read of Unity-Link looks for its answer "
        "again and again, if answers come quickly, instead of sleeping."
    )
    lines = [
        BEGIN,
        "",
        "## Quicker elsewhere",
        "",
        *(_quicker(finishes) or ["Nothing was in this run."]),
        "",
        "## All of it",
        "",
        seen,
        "",
        f"![How many times as quick as Unity-Link each peer is]({picture})",
        "",
        "| what | on | by | | processor | beside it |",
        "|---|---|---|---|---|---|",
        *(_line(finish) for finish in finishes),
        "",
        END,
    ]
    return "\n".join(lines)


def replaced(page: str, section: str) -> str:
    """Return a page with its section replaced."""
    before, _, rest = page.partition(BEGIN)
    _, _, after = rest.partition(END)
    return before + section + after


def _quicker(finishes: list[Finish]) -> list[str]:
    quicker = sorted((finish for finish in finishes if _ratio(finish) >= _LEVEL), key=_ratio, reverse=True)
    return [
        f"- {finish.contender}, {finish.question} on {finish.medium}: {finish.figure}, "
        f"**{_ratio(finish):.1f} times** as quick as {finish.beside}."
        for finish in quicker
    ]


def _line(finish: Finish) -> str:
    told = beside(finish) if finish.beside else ""
    return (
        f"| {finish.question} | {finish.medium} | {finish.contender} | {finish.figure} | {finish.load:.0%} | {told} |"
    )


def beside(finish: Finish) -> str:
    """Return the ratio of a peer to ours as text."""
    wire = f"; {finish.wire:.2f} times its bytes of the wire" if finish.wire else ""
    return f"{_ratio(finish):.2f} times {finish.beside}{wire}"


def _ratio(finish: Finish) -> float:
    return finish.ratio or 0.0


def draw(finishes: list[Finish], file: Path) -> None:
    """Draw the ratio of each peer's speed to ours, with a panel for each question."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    peers: dict[str, list[Finish]] = {}
    for finish in finishes:
        if finish.ratio is not None:
            peers.setdefault(finish.question, []).append(finish)
    sizes = [len(panel) for panel in peers.values()]
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(9, 1 + 0.5 * sum(sizes)), layout="constrained")
        all_axes = figure.subplots(len(peers), 1, sharex=True, squeeze=False, height_ratios=sizes)[:, 0]
        for axes, (question, panel) in zip(all_axes, peers.items(), strict=True):
            _draw_panel(axes, question, panel)
        ratios = [1.0, *(_ratio(finish) for panel in peers.values() for finish in panel)]
        axes.set_xlim(min(ratios) / 2, max(ratios) * 2)
        axes.set_xlabel("times as quick as Unity-Link: left of the line slower, right of it quicker")
        # Without date and version, so that the same figures give the same file.
        figure.savefig(file, dpi=DOTS_PER_INCH, metadata={"Software": None})


def _draw_panel(axes: Any, question: str, peers: list[Finish]) -> None:
    places = range(len(peers), 0, -1)
    for place, peer in zip(places, peers, strict=True):
        ratio = _ratio(peer)
        side = 1 if ratio > 1 else -1
        axes.barh(place, ratio - 1, left=1, height=0.62, color=_QUICKER if ratio > 1 else _SLOWER)
        axes.annotate(
            f"{ratio:.2g}",
            (ratio, place),
            (4 * side, 0),
            textcoords="offset points",
            ha="left" if ratio > 1 else "right",
            va="center",
            fontsize=9,
        )
    axes.set_yticks(list(places), [f"{peer.contender.replace('`', '')} ({peer.medium})" for peer in peers], fontsize=9)
    axes.set_xscale("log")
    axes.xaxis.set_major_formatter("{x:g}")
    axes.axvline(1, color="#333333", linewidth=1)
    axes.grid(visible=False, axis="y")
    axes.set_title(question[0].upper() + question[1:])

"""The page about peers: measurements in which a peer is quicker come first, and text written by hand is kept."""

from __future__ import annotations

from typing import TYPE_CHECKING

from benchmarks.peers.race import Contender, Finish, Race, run_race
from benchmarks.peers.report import BEGIN, END, draw, replaced, text

if TYPE_CHECKING:
    from pathlib import Path


FINISHES = [
    Finish("a read", "UDP", "ours", "20.0 µs", "", None, 0.25),
    Finish("a read", "UDP", "slow", "40.0 µs", "ours", 0.5, 0.25),
    Finish("a read", "UDP", "quick", "10.0 µs", "ours", 2.0, 0.25),
    Finish("a read", "UDP", "level", "19.5 µs", "ours", 1.03, 0.25),
    Finish("a block", "UDP", "quickest", "9 words/s", "ours", 3.0, 0.25),
]


def test_report_begins_with_the_peers_that_are_quicker_the_quickest_first() -> None:
    first, _, table = text(FINISHES, "a machine", 7, "peers.png").partition("## All of it")
    assert [line for line in first.splitlines() if line.startswith("- ")] == [
        "- quickest, a block on UDP: 9 words/s, **3.0 times** as quick as ours.",
        "- quick, a read on UDP: 10.0 µs, **2.0 times** as quick as ours.",
    ]
    assert table.count("\n| a ") == len(FINISHES)
    assert "| a read | UDP | slow | 40.0 µs | 25% | 0.50 times ours |" in table


def test_report_states_if_no_peer_was_quicker() -> None:
    assert "Nothing was in this run." in text(FINISHES[:2], "a machine", 7, "peers.png")


def test_only_the_section_of_the_page_is_replaced() -> None:
    page = f"before\n{BEGIN}\nold\n{END}\nafter\n"
    once = replaced(page, text(FINISHES, "a machine", 7, "peers.png"))
    assert once.startswith(f"before\n{BEGIN}\n")
    assert once.endswith(f"{END}\nafter\n")
    assert "old" not in once
    assert replaced(once, f"{BEGIN}\n{END}") == f"before\n{BEGIN}\n{END}\nafter\n"


def test_the_picture_is_the_same_for_the_same_figures(tmp_path: Path) -> None:
    draw(FINISHES, tmp_path / "one.png")
    draw(FINISHES, tmp_path / "other.png")
    assert (tmp_path / "one.png").read_bytes() == (tmp_path / "other.png").read_bytes() != b""


def test_the_ratio_is_the_median_of_those_within_a_round() -> None:
    times = iter([9.0, 9.0, 4.0, 2.0, 8.0, 1.0, 2.0, 2.0])
    ways = [Contender("ours", lambda: next(times)), Contender("peer", lambda: next(times), "ours")]
    ours, peer = run_race(Race("a read", "UDP", "reads", ways), 3)
    assert (ours.figure, ours.ratio) == ("0 reads/s", None)
    assert (peer.figure, peer.ratio) == ("0 reads/s", 2.0)


def test_bytes_on_the_wire_are_compared_if_both_sides_report_them() -> None:
    ways = [
        Contender("ours", lambda: 1.0, wire=8.0),
        Contender("terse", lambda: 0.5, "ours", wire=4.0),
        Contender("silent", lambda: 0.5, "ours"),
    ]
    _, terse, silent = run_race(Race("a block", "UDP", "words", ways), 1)
    assert (terse.ratio, terse.wire, silent.wire) == (2.0, 1.0, None)
    page = text([terse, silent], "a machine", 1, "peers.png")
    assert "2.00 times ours; 1.00 times its bytes of the wire |" in page
    assert "2.00 times ours |" in page

"""Walkthroughs work as their readers follow them, from an empty folder."""

from __future__ import annotations

from pathlib import Path

import pytest

from docs.walkthrough import WALKTHROUGHS, follow

ROOT = Path(__file__).parent.parent
ROVER = ROOT / "docs" / "tutorials" / "rover.md"


@pytest.mark.slow
@pytest.mark.timeout(300)
@pytest.mark.parametrize("page", WALKTHROUGHS)
def test_a_page_is_right_from_an_empty_folder_to_its_end(page: str, tmp_path: Path) -> None:
    follow(ROOT / page, tmp_path)
    assert not list(tmp_path.glob("*.sock"))


def test_rover_tutorial_reaches_a_plot_and_a_test_within_135_lines() -> None:
    lines = ROVER.read_text(encoding="utf-8").splitlines()
    assert len(lines) <= 135
    assert max(map(len, lines)) <= 130


@pytest.mark.parametrize(
    ("block", "words"),
    [
        ("$ cat hello.txt\nhello, you", "`cat hello.txt` prints\nhello\n"),
        ("$ cat goodbye.txt", "`cat goodbye.txt` exits with 1: cat: goodbye.txt: No such file"),
    ],
)
def test_wrong_page_is_reported(block: str, words: str, tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(f"**`hello.txt`**\n```text\nhello\n```\n\n```console\n{block}\n```\n")
    with pytest.raises(AssertionError, match=words):
        follow(page, tmp_path)


def test_missing_output_in_the_other_terminal_is_reported(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("**Terminal 2**\n```console\n$ cat goodbye.txt\nready\n```\n")
    with pytest.raises(AssertionError, match=r"prints\n\nwhere the page says\nready"):
        follow(page, tmp_path)

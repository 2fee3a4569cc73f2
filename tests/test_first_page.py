"""The first page shows a description, a picture, the installation and a program of ten lines, without scrolling."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from playwright.sync_api import sync_playwright

DOCS = Path(__file__).parents[1] / "docs"
SHOWN = ("h1", "section > p", "article img", "pre >> nth=0", "pre >> nth=1")
MISSING = "suppress_warnings=toc.not_readable,toc.excluded,myst.xref_missing"


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the first page as HTML, from a book without other pages."""
    source, made = tmp_path_factory.mktemp("source"), tmp_path_factory.mktemp("made")
    shutil.copy(DOCS / "index.md", source)
    shutil.copy(DOCS / "conf.py", source)
    shutil.copytree(DOCS / "images", source / "images")
    command = [sys.executable, "-m", "sphinx", "-q", "-D", MISSING, str(source), str(made)]
    subprocess.run(command, cwd=DOCS.parent, check=True)
    return made / "index.html"


def test_the_picture_moves_without_a_script() -> None:
    picture = (DOCS / "images" / "demo.svg").read_text(encoding="utf-8")
    frames = [frame for frame in picture.split('<g class="frame"')[1:] if "unity-link" in frame]
    assert len(set(frames)) >= 10
    assert "@keyframes show" in picture
    assert "<script" not in picture


@pytest.mark.slow
def test_first_screen_has_everything_that_a_newcomer_needs(page: Path) -> None:
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
        window = browser.new_page(viewport={"width": 1280, "height": 800})
        window.goto(page.as_uri())
        boxes = [window.locator(one).first.bounding_box() for one in SHOWN]
        text = window.locator("pre >> nth=1").inner_text()
        window.set_viewport_size({"width": 400, "height": 800})
        widest = window.evaluate("document.documentElement.scrollWidth")
        browser.close()
    assert all(box is not None and box["height"] > 10 and box["y"] + box["height"] <= 800 for box in boxes), boxes
    assert 10 <= len([line for line in text.splitlines() if line.strip()]) <= 12
    assert widest <= 400

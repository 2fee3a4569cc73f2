"""The browser in which tests open pages, and the tests that need rclpy."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest
from playwright.sync_api import expect, sync_playwright

from support.bridge_programs import PATIENCE
from support.live_page import CHROMIUM
from support.rclpy_peers import PYTHONS

if TYPE_CHECKING:
    from collections.abc import Iterator

    from playwright.sync_api import Browser, Page


# rclpy is installed only in the environments of `make ros-venvs`, which need Python 3.12.
collect_ignore_glob = [] if PYTHONS else ["test_rclpy*.py"]


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with sync_playwright() as playwright:
        opened = playwright.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        yield opened
        opened.close()


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    """Open a page; at the end, fail if the page has reported an error."""
    context = browser.new_context(viewport={"width": 1280, "height": 900})
    context.set_default_timeout(1000 * PATIENCE)
    expect.set_options(timeout=1000 * PATIENCE)
    opened = context.new_page()
    complaints: list[str] = []
    opened.on("pageerror", lambda error: complaints.append(str(error)))
    # Ignore the browser's own messages about a server that has gone, also in the middle of a response.
    opened.on(
        "console",
        lambda said: (
            complaints.append(said.text)
            if said.type in {"error", "warning"} and not re.search("net::ERR_CON(NECTION|TENT_LENGTH)_", said.text)
            else None
        ),
    )
    yield opened
    context.close()
    assert complaints == []

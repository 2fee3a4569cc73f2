"""The browser in which tests look at pages, and which tests need rclpy."""

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


# Without the environments of `make ros-venvs`, which need Python 3.12, there is no rclpy to be heard by.
collect_ignore_glob = [] if PYTHONS else ["test_rclpy*.py"]


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with sync_playwright() as playwright:
        opened = playwright.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        yield opened
        opened.close()


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    """A page that may not complain."""
    context = browser.new_context(viewport={"width": 1280, "height": 900})
    context.set_default_timeout(1000 * PATIENCE)
    expect.set_options(timeout=1000 * PATIENCE)
    opened = context.new_page()
    complaints: list[str] = []
    opened.on("pageerror", lambda error: complaints.append(str(error)))
    # A server that has gone, also in the middle of an answer, is a complaint of the browser's own.
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

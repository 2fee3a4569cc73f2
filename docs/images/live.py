"""Draws `unity-link live`: runs the page in Chromium, moves the virtual robot by its sliders, and takes the picture."""

import shutil
import subprocess
import sys
from pathlib import Path

from playwright.sync_api import Page, sync_playwright

PROGRAM = str(Path(sys.executable).parent / "unity-link")
SPEC = str(Path(__file__).parents[2] / "examples" / "scara.ul")
MOVES = (
    {"j1": 60, "j2": -80, "j3": 90, "j4": 200},
    {"j1": -40, "j2": 30, "j3": 20, "j4": -90},
    {"j1": 15, "j2": 75, "j3": 120, "j4": 45},
)
PAUSE = 2800
"""Milliseconds from one move to the next."""


def draw_live(picture: Path, *, on_phone: bool = False) -> None:
    """Take a picture of the page in light colours, or on a phone in dark colours."""
    command = [PROGRAM, "live", "sim:scara", SPEC, "--allow-writes", "--no-browser", "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process, sync_playwright() as playwright:  # noqa: S603
        assert process.stdout is not None
        url = process.stdout.readline().strip()
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
        page = browser.new_page(
            viewport={"width": 390, "height": 844} if on_phone else {"width": 1280, "height": 1280},
            color_scheme="dark" if on_phone else "light",
            device_scale_factor=1,
        )
        page.goto(url)
        page.wait_for_timeout(1500)
        _move(page)
        page.evaluate("document.activeElement.blur(); scrollTo(0, 0)")
        page.wait_for_timeout(500)
        page.screenshot(path=picture)
        browser.close()
        process.terminate()


def _move(page: Page) -> None:
    """Type set points, one after the other."""
    for pose in MOVES:
        for joint, value in pose.items():
            page.locator(f"#write-{joint}\\.pos_sp").fill(str(value))
            page.keyboard.press("Enter")
        page.wait_for_timeout(PAUSE)

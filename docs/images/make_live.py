"""Makes `live.png` and `live-phone.png`, the pictures of `unity-link live`: ``python docs/images/make_live.py``.

It runs the page in Chromium, moves the virtual robot by its sliders, and takes the pictures then.
"""

import shutil
import subprocess
import sys
from pathlib import Path

from playwright.sync_api import Browser, Page, sync_playwright

PROGRAM = str(Path(sys.executable).parent / "unity-link")
SPEC = str(Path(__file__).parents[2] / "examples" / "scara.ul")
MOVES = (
    {"j1": 60, "j2": -80, "j3": 90, "j4": 200},
    {"j1": -40, "j2": 30, "j3": 20, "j4": -90},
    {"j1": 15, "j2": 75, "j3": 120, "j4": 45},
)
PAUSE = 2800
"""Milliseconds from one move to the next."""


def move(page: Page) -> None:
    """Type set points, one after the other."""
    for pose in MOVES:
        for joint, value in pose.items():
            page.locator(f"#write-{joint}\\.pos_sp").fill(str(value))
            page.keyboard.press("Enter")
        page.wait_for_timeout(PAUSE)


def draw(browser: Browser, url: str, name: str, width: int, height: int, *, dark: bool, whole: bool) -> None:
    """Take one picture."""
    context = browser.new_context(
        viewport={"width": width, "height": height}, color_scheme="dark" if dark else "light", device_scale_factor=1
    )
    page = context.new_page()
    page.goto(url)
    page.wait_for_timeout(1500)
    move(page)
    page.evaluate("document.activeElement.blur(); scrollTo(0, 0)")
    page.wait_for_timeout(500)
    page.screenshot(path=Path(__file__).with_name(name), full_page=whole)
    context.close()


def main() -> None:
    """Run the program and take the pictures."""
    command = [PROGRAM, "live", "sim:scara", SPEC, "--allow-writes", "--no-browser", "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process, sync_playwright() as playwright:  # noqa: S603
        assert process.stdout is not None
        url = process.stdout.readline().strip()
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
        draw(browser, url, "live.png", 1280, 1280, dark=False, whole=False)
        draw(browser, url, "live-phone.png", 390, 844, dark=True, whole=False)
        browser.close()
        process.terminate()


if __name__ == "__main__":
    main()

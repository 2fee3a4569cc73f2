"""How much does a frame of the live page cost, and how many a second are drawn? `make bench-live` writes LIVE.md.

The page is opened in headless Chromium, which draws in software: with a graphics card, drawing is cheaper. Times are
processor times of the page's main thread, as Chromium counts them, and so independent of other work on the machine. The
number of frames per second shows only how many the page can draw on an idle machine.
"""

from __future__ import annotations

import argparse
import datetime as dt
import shutil
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from playwright.sync_api import Browser, Page, sync_playwright

from benchmarks.__main__ import machine

if TYPE_CHECKING:
    from collections.abc import Iterator

SECONDS = 10.0
ROBOTS = ("scara", "walker")
EXAMPLES = Path(__file__).parents[1] / "examples"
PROGRAM = str(Path(sys.executable).parent / "unity-link")
RESULTS = Path(__file__).with_name("LIVE.md")


class Screen(NamedTuple):
    """Size and kind of the screen on which the page is shown."""

    name: str
    width: int
    height: int
    ratio: float
    """Pixels of the screen for one pixel of the page."""


SCREENS = (Screen("desktop", 1280, 900, 1), Screen("phone", 390, 844, 3))


class Row(NamedTuple):
    """Figures of one robot on one screen; times are for one frame, in ms."""

    robot: str
    screen: str
    plots: float
    """Plots drawn in each frame."""
    script: float
    thread: float
    """Time of the page's main thread: script, layout, and drawing of the curves."""
    beside: float
    """Time of all other threads of Chromium."""
    slowest: float
    """Time from frame to frame that 99 % of the frames do not exceed."""
    pictures: float
    """Frames per second."""


@contextmanager
def showing(robot: str) -> Iterator[str]:
    """Run `unity-link live` on a virtual robot, and return the page's address."""
    command = [PROGRAM, "live", f"sim:{robot}", str(EXAMPLES / f"{robot}.ul"), "--allow-writes"]
    with subprocess.Popen(
        [*command, "--no-browser", "--port", "0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    ) as process:
        assert process.stdout is not None
        try:
            yield process.stdout.readline().strip()
        finally:
            process.terminate()


def look(browser: Browser, robot: str, screen: Screen, seconds: float) -> Row:
    """Show a robot for some seconds while it moves, and measure."""
    context = browser.new_context(
        viewport={"width": screen.width, "height": screen.height}, device_scale_factor=screen.ratio
    )
    page = context.new_page()
    with showing(robot) as url:
        page.goto(url)
        move(page)
        # After 11 s the plots have all their points: their window is ten seconds.
        page.wait_for_timeout(11_000)
        row = measure(browser, page, robot, screen, seconds)
        context.close()
    return row


def move(page: Page) -> None:
    """Move all position set points back and forth."""
    page.locator("input[type=range]:enabled").first.wait_for()
    page.evaluate(
        """() => {
          const sliders = [...document.querySelectorAll('input[type=range][aria-label*="pos_sp"]')];
          let step = 0;
          setInterval(() => {
            const slider = sliders[step++ % sliders.length];
            const way = Math.sin(performance.now() / 700 + step) * 0.4 + 0.5;
            slider.value = Number(slider.min) + way * (slider.max - slider.min);
            slider.dispatchEvent(new Event("input"));
          }, 100);
        }"""
    )


def measure(browser: Browser, page: Page, robot: str, screen: Screen, seconds: float) -> Row:
    """Measure for some seconds."""
    of_page, of_browser = page.context.new_cdp_session(page), browser.new_browser_cdp_session()
    of_page.send("Performance.enable", {"timeDomain": "threadTicks"})

    def spent() -> tuple[dict[str, float], float]:
        named = {one["name"]: one["value"] for one in of_page.send("Performance.getMetrics")["metrics"]}
        processes = of_browser.send("SystemInfo.getProcessInfo")["processInfo"]
        return named, sum(process["cpuTime"] for process in processes)

    plots_then = page.evaluate("unityLink.plots")
    before, all_before = spent()
    began = time.monotonic()
    intervals = page.evaluate(
        """async seconds => {
          const intervals = [];
          let then = await new Promise(requestAnimationFrame);
          const end = then + 1000 * seconds;
          while (then < end) {
            const now = await new Promise(requestAnimationFrame);
            intervals.push(now - then);
            then = now;
          }
          return intervals;
        }""",
        seconds,
    )
    elapsed = time.monotonic() - began
    after, all_after = spent()
    frames = len(intervals)
    thread = after["TaskDuration"] - before["TaskDuration"]
    return Row(
        robot,
        screen.name,
        plots=(page.evaluate("unityLink.plots") - plots_then) / frames,
        script=1000 * (after["ScriptDuration"] - before["ScriptDuration"]) / frames,
        thread=1000 * thread / frames,
        beside=1000 * (all_after - all_before - thread) / frames,
        slowest=sorted(intervals)[int(0.99 * frames)],
        pictures=frames / elapsed,
    )


def rows(seconds: float) -> list[Row]:
    """Measure each robot on each screen."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
        found = [look(browser, robot, screen, seconds) for robot in ROBOTS for screen in SCREENS]
        browser.close()
    return found


def document(found: list[Row], seconds: float) -> str:
    """Return the text of LIVE.md."""
    lines = [
        "# The live page",
        "",
        f"Measured for {seconds:g} s in headless Chromium, which draws in software, while the robot moves and every",
        "plot has ten seconds of samples. Times are processor times of one frame; sixty frames per second leave",
        "16.7 ms for each. `make bench-live` runs it again.",
        "",
        f"Seen on {dt.datetime.now(dt.UTC):%Y-%m-%d}: {machine()}.",
        "",
        "| Robot | screen | plots in view | script | main thread | other threads | 99 % within | pictures/s |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for row in found:
        times = " | ".join(f"{one:.1f} ms" for one in (row.script, row.thread, row.beside, row.slowest))
        lines.append(f"| {row.robot} | {row.screen} | {row.plots:.1f} | {times} | {row.pictures:.1f} |")
    return "\n".join(lines) + "\n"


def main() -> None:
    """Measure, and write the table."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.live_page", description=__doc__)
    parser.add_argument("--seconds", type=float, default=SECONDS, help="how long each robot is looked at")
    given = parser.parse_args()
    text = document(rows(given.seconds), given.seconds)
    RESULTS.write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()

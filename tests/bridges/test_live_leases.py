"""Leases on the live page: pages show their state, and any page may stop them."""

from __future__ import annotations

import json
from contextlib import ExitStack
from typing import TYPE_CHECKING

import pytest
from playwright.sync_api import expect

import unity_link
from support.bridge_programs import wait_until
from support.live_page import gateway, hear, live, looking, needs_chromium
from unity_link import blocking
from unity_link.data.blocking import put

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from playwright.sync_api import Page

    from support.live_page import Live

SPEC = """
public rover() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE(TIMEOUT=20) @(0xE0);
  lift: LEASE(TIMEOUT=20) @(0x100);
  @speed = 0x10: signed READWRITE(SAFE(0, drive), UNIT="rpm");
}
"""


@pytest.fixture
def spec(tmp_path: Path) -> Path:
    path = tmp_path / "rover.ul"
    path.write_text(SPEC)
    return path


@pytest.fixture
def served(spec: Path, tmp_path: Path) -> Iterator[str]:
    with gateway(tmp_path / "gateway", "serve", f"sim:{spec}") as url:
        yield url


@pytest.fixture
def shown(served: str, spec: Path) -> Iterator[Live]:
    with live(served, str(spec), begins="0 samples") as running:
        yield running


def end(running: Live) -> None:
    """End the program, and drop its output on stderr."""
    running.process.terminate()
    assert running.process.stderr is not None
    running.process.stderr.close()


@pytest.mark.slow
@needs_chromium
def test_a_page_shows_each_lease_and_its_button_disarms(page: Page, served: str, spec: Path, shown: Live) -> None:
    with blocking.connect(served) as link:
        page.goto(shown.url)
        drive, lift = page.locator("[data-lease=drive]"), page.locator("[data-lease=lift]")
        expect(drive.locator("output")).to_have_text("disarmed")
        robot = put(unity_link.load(spec), link)
        with robot.drive.armed(timeout=15):
            robot.speed.set(100)
            expect(drive.locator("output")).to_have_text("armed")
            expect(lift.locator("output")).to_have_text("disarmed")
            page.get_by_role("button", name="Stop drive").click()
            expect(drive.locator("output")).to_have_text("disarmed")
            assert robot.speed.get() == 0
        with robot.lift.armed(timeout=0.5):
            expect(lift.locator("output")).to_have_text("fault: silence")
        page.goto("about:blank")
    end(shown)


def test_a_page_without_a_token_stops_and_does_not_write(served: str, spec: Path, shown: Live) -> None:
    with looking(shown) as page, blocking.connect(served) as link:
        about = hear(page, "about")
        assert (about["leases"], about["writes"]) == (["drive", "lift"], False)
        robot = put(unity_link.load(spec), link)
        with robot.drive.armed(timeout=15):
            page.send(json.dumps({"type": "write", "number": 1, "signal": "speed", "value": 5}))
            assert "writes are off" in hear(page, "refused")["reason"]
            page.send(json.dumps({"type": "stop", "number": 2, "lease": "drive"}))
            assert hear(page, "written")["number"] == 2
            assert not robot.drive.armed_.get()
        page.send(json.dumps({"type": "stop", "number": 3, "lease": "speed"}))
        assert hear(page, "refused") == {"type": "refused", "number": 3, "reason": "there is no lease 'speed'"}
    end(shown)


def test_stop_on_a_page_without_its_gateway_reports_that_it_failed(spec: Path, tmp_path: Path) -> None:
    with gateway(tmp_path / "gateway", "serve", f"sim:{spec}") as url:
        running = live(url, str(spec))
        shown = running.__enter__()
    with looking(shown) as page:
        wait_until(lambda: not hear(page, "status")["connected"])
        page.send(json.dumps({"type": "stop", "number": 1, "lease": "drive"}))
        assert "the link is away" in hear(page, "refused")["reason"]
    end(shown)
    running.__exit__(None, None, None)


@needs_chromium
@pytest.mark.slow
def test_a_page_shows_a_lease_and_signals_on_change_before_any_change(page: Page, tmp_path: Path) -> None:
    spec = tmp_path / "rover.ul"
    spec.write_text("""
        group safety(RATE=100, ON_CHANGE, TIMESTAMPS);
        public rover() {
          drive: LEASE(TIMEOUT=20, GROUP=safety) @(0xE0, enable=none, estop=none);
          @gain = 0x10: unsigned 8 READWRITE(PUBLISH(safety));
        }
    """)
    with ExitStack() as stack:
        with gateway(tmp_path / "gateway", "simulate", str(spec)) as url:
            running = stack.enter_context(live(url, str(spec), "--allow-writes", "--poll", "0", begins="0 samples"))
            page.goto(running.url)
            state, gain = page.locator("[data-lease=drive] output"), page.locator("#write-gain")
            expect(state).to_have_text("disarmed")
            expect(page.locator("[data-signal=gain] output")).to_have_text("0")
            expect(gain).to_be_enabled()
            expect(gain).to_have_value("0")
            gain.fill("7")
            gain.press("Enter")
            expect(page.locator("[data-signal=gain] output")).to_have_text("7")
        # All words of the next gateway are 0, and none of them changes.
        with gateway(tmp_path / "gateway", "simulate", str(spec)):
            expect(page.locator("[data-signal=gain] output")).to_have_text("0")
        page.goto("about:blank")
        end(running)


@needs_chromium
@pytest.mark.slow
def test_a_page_of_a_lease_that_nothing_samples_shows_no_state(page: Page, tmp_path: Path) -> None:
    spec = tmp_path / "rover.ul"
    spec.write_text("""
        group quick(RATE=10);
        public rover() {
          drive: LEASE(TIMEOUT=20) @(0xE0, enable=none, estop=none);
          @gain = 0x10: unsigned 8 READ(PUBLISH(quick));
        }
    """)
    with live(f"sim:{spec}", str(spec), "--poll", "0", begins="0 samples") as running:
        page.goto(running.url)
        expect(page.locator("#state")).to_have_text("connected")
        expect(page.locator("[data-lease=drive] output")).to_have_text("\u2013")
        expect(page.locator("[data-signal=gain] output")).to_have_text("0")
        page.get_by_role("button", name="Stop drive").click()
        page.goto("about:blank")
        end(running)

"""`demo` and `watch` on a terminal, as a user sees them."""

from __future__ import annotations

import functools
import re
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from anyio.from_thread import start_blocking_portal

from support.counting_device import CountingDevice
from support.terminal_window import GIVEN_BACK, Window, needs_tmux
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.virtual import VirtualGateway
from unity_link.virtual.build import build_gateway
from unity_link.virtual.serving import serve_unix

if TYPE_CHECKING:
    from collections.abc import Iterator

    from anyio.from_thread import BlockingPortal

    from unity_link.virtual import Gateway

pytestmark = needs_tmux
BEFORE = "what stood there before"


@pytest.fixture
def terminal(terminal: Window) -> Window:
    terminal.enter(f"echo {BEFORE}")
    terminal.wait_for(f"^{BEFORE}$")
    return terminal


@contextmanager
def served(gateway: Gateway, folder: Path) -> Iterator[BlockingPortal]:
    """Serve a gateway at the URL unix:gateway of the terminal; yield the portal to its event loop."""
    with (
        start_blocking_portal() as portal,
        portal.wrap_async_context_manager(serve_unix(gateway, folder / "gateway")),
    ):
        yield portal


def counting_gateway() -> VirtualGateway:
    """Return a gateway on which each sample of 0x10 is one more than the sample before."""
    gateway = VirtualGateway(GatewayInfo())
    gateway.bus.attach(CountingDevice(), [0x10])
    return gateway


def number(pattern: str, screen: str) -> float:
    found = re.search(pattern, screen, re.MULTILINE)
    return float(found[1]) if found else 0.0


def shoulder(screen: str) -> float:
    return number(r"shoulder +([-+.\d]+)", screen)


def value(screen: str) -> float:
    return number(r"^ 0x10 +(\d+)", screen)


def assert_restored(terminal: Window, code: int) -> str:
    """Wait for the exit code of a command; assert that the terminal is restored; return all text on it."""
    terminal.wait_for(rf"^code {code}$", r"^\$ *$")
    assert terminal.state == GIVEN_BACK
    terminal.enter("echo typed $((6 * 7))")
    terminal.wait_for(r"^\$ echo typed", "^typed 42$")
    left = terminal.all()
    assert f"\n{BEFORE}\n" in left
    assert "Traceback" not in left
    return left


def test_demo_moves_without_lost_samples_and_ctrl_c_restores_the_terminal(terminal: Window) -> None:
    terminal.enter("unity-link demo --duration 600; echo code $?")
    first = shoulder(terminal.wait_until(lambda screen: shoulder(screen) > 1))
    screen = terminal.wait_until(lambda screen: shoulder(screen) > first + 1)
    assert " 0 lost" in screen
    assert BEFORE not in screen
    terminal.press("C-c")
    left = assert_restored(terminal, 130)
    assert left.count("shoulder") == 2
    assert re.search(r"samples +[\d,]+ at 100 Hz, 0 lost", left)
    assert "round trip  median" in left


def is_the_whole_demo(width: int, screen: str) -> bool:
    return (
        screen.count("Unity-Link") == 1
        and " 0 lost" in screen
        and all(name in screen for name in ("shoulder", "elbow", "z ", "wrist"))
        and len(screen.splitlines()[0]) == width
    )


def test_demo_fits_a_window_of_any_size(terminal: Window) -> None:
    # Some shells export COLUMNS and LINES, which do not change with the size of the window.
    terminal.enter("COLUMNS=80 LINES=24 unity-link demo --duration 600; echo code $?")
    for width, height in [(100, 30), (60, 15), (40, 8), (220, 50), (70, 20)]:
        terminal.resize(width, height)
        terminal.wait_until(functools.partial(is_the_whole_demo, min(width, 110)))
    terminal.press("C-c")
    terminal.wait_for("^code 130$")


def test_q_ends_the_demo_and_typed_keys_do_not_reach_the_shell(terminal: Window) -> None:
    terminal.enter("unity-link demo --duration 600; echo code $?")
    terminal.wait_until(lambda screen: shoulder(screen) > 1)
    terminal.enter("nonsense")
    terminal.press("q")
    assert "nonsense" not in assert_restored(terminal, 0)


def test_a_gateway_that_goes_away_ends_the_demo_in_one_sentence(terminal: Window, tmp_path: Path) -> None:
    with served(build_gateway("scara"), tmp_path):
        terminal.enter("unity-link demo unix:gateway; echo code $?")
        terminal.wait_until(lambda screen: shoulder(screen) > 1)
    assert assert_restored(terminal, 1).count("\nerror: ") == 1


def test_the_demo_on_a_terminal_that_can_draw_nothing_prints_lines(terminal: Window) -> None:
    for environment in ("TERM=dumb", "PYTHONIOENCODING=ascii"):
        terminal.clear()
        terminal.enter(f"{environment} unity-link demo --duration 1; echo code $?")
        screen = terminal.wait_for("^await link.read.*counts$", r"^samples: \d+ at 100 Hz, 0 lost$", "^code 0$")
        assert "╭" not in screen


def is_one_watch_beyond(last: float, screen: str) -> bool:
    return value(screen) > last and screen.count("unity-link watch") == 1


def test_watch_shows_values_as_they_change_through_resizes(terminal: Window, tmp_path: Path) -> None:
    with served(counting_gateway(), tmp_path):
        terminal.enter("unity-link watch unix:gateway 0x10 0x11 0x12; echo code $?")
        last = 0.0
        for width, height in [(100, 30), (50, 8), (30, 5), (200, 40)]:
            terminal.resize(width, height)
            last = value(terminal.wait_until(functools.partial(is_one_watch_beyond, last)))
        terminal.wait_for("^ 0x12 +0 ", r"\b0 lost\b", "[⠁-⣿]")
        terminal.press("C-c")
        assert re.search(r"^\d+ samples in .* 0 lost$", assert_restored(terminal, 130), re.MULTILINE)


def test_watch_shows_names_of_any_lengths_and_their_plots_whole(terminal: Window) -> None:
    rover = Path(__file__).parents[2] / "examples" / "rover.ul"
    terminal.enter(f"unity-link watch sim:{rover} {rover} lamps left.position; echo code $?")
    screen = terminal.wait_for(r"^ lamps +0 +0 +0$", r"^ left.position +0 +0 +0$", "0 lost")
    assert "…" not in screen
    terminal.press("q")
    assert_restored(terminal, 0)


def test_watch_counts_the_addresses_that_do_not_fit_a_small_window(terminal: Window) -> None:
    terminal.resize(60, 10)
    terminal.enter("unity-link watch sim: $(seq 16 25) --format bin; echo code $?")
    terminal.wait_for(r"^ 0x10 +0b0{32}\b", "and 6 more that this terminal has no room for", r"\b0 lost\b")
    terminal.press("q")
    terminal.wait_for("^code 0$")


def test_watch_shows_an_absent_gateway_and_continues_when_it_returns(terminal: Window, tmp_path: Path) -> None:
    with served(counting_gateway(), tmp_path):
        terminal.enter("unity-link watch unix:gateway 0x10; echo code $?")
        terminal.wait_until(lambda screen: value(screen) > 3)
    screen = terminal.wait_for("the gateway is away")
    with served(counting_gateway(), tmp_path):
        last = value(screen)
        terminal.wait_until(lambda screen: 0 < value(screen) != last and "is away" not in screen)
    terminal.wait_for("the gateway is away")
    terminal.press("q")
    assert_restored(terminal, 0)


@pytest.mark.slow
def test_watch_continues_after_a_gateway_reset_on_an_open_line(terminal: Window, tmp_path: Path) -> None:
    gateway = counting_gateway()
    with served(gateway, tmp_path) as portal:
        terminal.enter("unity-link watch unix:gateway 0x10; echo code $?")
        terminal.wait_until(lambda screen: value(screen) > 3)
        portal.call(gateway.reset)
        last = value(terminal.screen())
        terminal.wait_until(lambda screen: value(screen) > last + 20)
        terminal.press("q")
        terminal.wait_for("^code 0$")


def test_watch_into_a_file_reports_a_gateway_that_leaves_and_returns(terminal: Window, tmp_path: Path) -> None:
    with served(counting_gateway(), tmp_path):
        terminal.enter("unity-link watch unix:gateway 0x10 --count 1000 >samples; echo code $?")
        terminal.wait_until(lambda _: (tmp_path / "samples").exists() and len((tmp_path / "samples").read_text()) > 50)
    terminal.wait_for("^the gateway has disconnected")
    with served(counting_gateway(), tmp_path):
        terminal.wait_for("^the gateway is back")
        terminal.press("C-c")
        terminal.wait_for("^code 130$")


def test_ctrl_z_returns_the_terminal_to_the_shell_and_fg_shows_the_picture(terminal: Window) -> None:
    terminal.enter("unity-link watch sim: 0x10")
    terminal.wait_for("^ 0x10 +0 ")
    terminal.press("C-z")
    screen = terminal.wait_for("Stopped", r"^\$ *$")
    assert BEFORE in screen
    assert terminal.state == GIVEN_BACK
    terminal.enter("fg")
    terminal.wait_for("^ 0x10 +0 ")
    assert terminal.state != GIVEN_BACK
    terminal.press("C-d")
    terminal.wait_for("^[0-9]+ samples in ", r"^\$ *$")
    assert terminal.state == GIVEN_BACK

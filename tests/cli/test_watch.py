"""`unity-link watch` while a server keeps the connection although its gateway is away, on simulated time."""

from __future__ import annotations

import asyncio
import math
from contextlib import asynccontextmanager, nullcontext
from types import SimpleNamespace
from typing import TYPE_CHECKING

import pytest
from rich.console import Console, ConsoleDimensions

from support.sharing import PipedLink, sharing, until
from support.simulated_time import on_simulated_time
from support.valve import Valve
from unity_link.cli import plots, watch, watch_view
from unity_link.cli.watched import WatchedSignals, Words
from unity_link.data.loading import load
from unity_link.protocol.wire.numbers import Format
from unity_link.spec import compile_text
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from collections.abc import AsyncIterator

    from unity_link import Link
    from unity_link.bridges.serve.shared import SharedLink

SILENCE_OF_A_SERVER = "starting a group: nothing on the bus answered (told once)"


class Served:
    """A link to a server whose gateway leaves and returns."""

    def __init__(self, link: Link, shared: SharedLink, gateway: Valve) -> None:
        self.link = link
        self._shared = shared
        self._gateway = gateway

    async def go(self) -> None:
        self._gateway.go_away(self._shared)
        await until(lambda: self._shared.away)

    def come_back(self) -> None:
        self._gateway.come_back()


@asynccontextmanager
async def served(monkeypatch: pytest.MonkeyPatch) -> AsyncIterator[Served]:
    """Share a gateway, give `watch` a link to it, and let `watch` use simulated time."""
    clock = SimpleNamespace(monotonic=asyncio.get_running_loop().time)
    monkeypatch.setattr(watch, "time", clock)
    monkeypatch.setattr(watch_view, "time", clock)
    gateway = Valve(VirtualGateway())
    async with sharing(gateway) as shared, PipedLink(shared) as link:
        monkeypatch.setattr("unity_link.link.connecting.connect", lambda *_, **__: nullcontext(link))
        yield Served(link, shared, gateway)


async def watch_lines(*, count: int | None = None, duration: float | None = None) -> None:
    await watch._watch("shared", Words([0x10], Format.SIGNED), 20.0, count, duration, json=False, timeout=5)


@on_simulated_time
async def test_watch_waits_for_a_shared_gateway_that_leaves_just_before_the_start(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    async with served(monkeypatch) as gateway:
        await gateway.go()
        watching = asyncio.create_task(watch_lines(count=3))
        await asyncio.sleep(10)
        assert not watching.done()
        gateway.come_back()
        await watching
    told = capsys.readouterr()
    assert len(told.out.splitlines()) == 1 + 3
    assert told.err.splitlines()[0] == SILENCE_OF_A_SERVER
    assert told.err.splitlines()[1].startswith("3 samples in 0.")


@on_simulated_time
async def test_watch_of_a_gateway_that_does_not_come_back_ends_with_its_duration(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    async with served(monkeypatch) as gateway:
        await gateway.go()
        await watch_lines(duration=5)
    assert capsys.readouterr().err.splitlines() == [SILENCE_OF_A_SERVER, "0 samples in 5.0 s, 0 lost"]


@on_simulated_time
async def test_watch_into_a_file_reports_a_served_gateway_that_leaves_and_returns(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    async with served(monkeypatch) as gateway:
        watching = asyncio.create_task(watch_lines(duration=30))
        await asyncio.sleep(5)
        await gateway.go()
        await asyncio.sleep(5)
        away = capsys.readouterr().err
        gateway.come_back()
        await watching
    assert away == "the gateway has disconnected: waiting until it is back\n"
    assert capsys.readouterr().err.splitlines()[0] == "the gateway is back"


@on_simulated_time
async def test_watch_picture_reports_an_absent_gateway_behind_a_server(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with served(monkeypatch) as gateway:
        watched = Words([0x10], Format.SIGNED)
        async with watched.subscribe(gateway.link, 20.0) as samples:
            view, console = watch_view.WatchView("shared", gateway.link, samples, watched), Console(width=100)

            async def says_away(seconds: float) -> bool:
                """Draw for some seconds; return True if the last picture reports that the gateway is away."""
                text = ""
                for _ in range(round(seconds * watch.FRAMES_PER_SECOND)):
                    await asyncio.sleep(1 / watch.FRAMES_PER_SECOND)
                    with console.capture() as drawn:
                        console.print(view.render(ConsoleDimensions(100, 20)))
                    text = drawn.get()
                return "the gateway is away" in text

            assert not await says_away(3)
            await gateway.go()
            assert await says_away(3)
            gateway.come_back()
            assert not await says_away(15)


@on_simulated_time
async def test_the_picture_of_watch_has_values_in_the_words_of_their_kinds() -> None:
    robot_type = load(
        compile_text("public x() { @m = 1: mode READ(); @b = 2: bool READ(); } enum mode { off = 0, fast = 7 }")
    )
    gateway = VirtualGateway()
    gateway.memory.update({1: 7, 2: 1})
    watched = WatchedSignals(robot_type, [])
    async with sharing(gateway) as shared, PipedLink(shared) as link, watched.subscribe(link, 20.0) as samples:
        view, console = watch_view.WatchView("shared", link, samples, watched), Console(width=100)
        view.take(await anext(samples))
        with console.capture() as drawn:
            console.print(view.render(ConsoleDimensions(100, 20)))
    rows = {line.split()[0]: line.split()[1] for line in drawn.get().splitlines() if line.split()[:1] in (["m"], ["b"])}
    assert rows == {"m": "fast", "b": watched.text(True)}


NAN, HUGE = math.nan, 1.7e308


@pytest.mark.parametrize(
    ("numbers", "lowest", "highest"),
    [
        ([1.0, NAN, 3.0, 2.0], 1.0, 3.0),
        ([NAN, 1.0, 2.0], 1.0, 2.0),
        ([1.0, math.inf, 2.0], 1.0, math.inf),
        ([-HUGE, HUGE, 0.0], -HUGE, HUGE),
    ],
)
def test_watch_picture_shows_the_extremes_and_a_curve_of_the_finite_values(
    numbers: list[float], lowest: float, highest: float
) -> None:
    trace = watch_view.Trace()
    for place, number in enumerate(numbers):
        trace.take(number, float(place))
    curve = trace.curve(float(len(numbers)), 120, (0, 0, 0))
    drawn = plots.draw(60, 2, [curve], (-1, 0), (min(curve.ys), max(curve.ys))).plain
    assert (trace.lowest, trace.highest) == (lowest, highest)
    assert list(curve.ys) == [number for number in numbers if math.isfinite(number)]
    assert any(dot not in " \n" for dot in drawn)

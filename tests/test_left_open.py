"""Objects that a program leaves open cause a warning that names the remedy; closed ones do not."""

from __future__ import annotations

import asyncio
import gc
import warnings
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.recordings import SPEC
from support.simulated_time import run_simulated
from unity_link import UnsupportedError, blocking
from unity_link.bridges.serve import serve
from unity_link.data.blocking import put
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Straying
from unity_link.virtual.serving import serve_pty, serve_tcp, serve_udp, serve_unix
from unity_link.virtual.udp_relay import relay_udp

if TYPE_CHECKING:
    from collections.abc import Callable
    from contextlib import AbstractAsyncContextManager
    from pathlib import Path

SERVERS: dict[str, Callable[[Path], AbstractAsyncContextManager[Any]]] = {
    "a gateway, tcp": lambda _: serve_tcp(VirtualGateway()),
    "a gateway, udp": lambda _: serve_udp(VirtualGateway()),
    "a gateway, unix": lambda folder: serve_unix(VirtualGateway(), folder / "socket"),
    "a gateway, pty": lambda _: serve_pty(VirtualGateway()),
    "a link, unix": lambda folder: serve("sim:", unix=folder / "socket"),
}


def assert_quiet(function: Callable[[], object]) -> None:
    """Check that a function causes no warning, neither at once nor at the next garbage collection."""
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        function()
        gc.collect()
    assert [str(warning.message) for warning in told] == []


# Subscriptions


async def subscribe_and_leave(*, left_open: bool) -> None:
    async with unity_link.connect("sim:scara") as link:
        samples = link.subscribe(0x88, rate_hz=100)
        await samples.__aenter__()
        await samples.take()
        if not left_open:
            await samples.__aexit__(None, None, None)


def test_a_subscription_that_was_not_closed_warns() -> None:
    said = r"<subscription of 1 addresses, over: \d+ samples, 0 lost> was not closed: use `async with`"
    with pytest.warns(ResourceWarning, match=said):  # noqa: PT031  (the garbage is collected within the block)
        run_simulated(subscribe_and_leave(left_open=True))
        gc.collect()


def test_one_that_was_closed_does_not() -> None:
    assert_quiet(lambda: run_simulated(subscribe_and_leave(left_open=False)))


def test_unclosed_blocking_subscription_warns_and_ends_with_its_link() -> None:
    with pytest.warns(ResourceWarning, match="was not closed"):  # noqa: PT031
        with blocking.connect("sim:scara") as link:
            link.subscribe(0x88, rate_hz=100).__enter__().take()
        del link
        gc.collect()


def test_a_group_of_a_robot_that_was_not_closed_warns() -> None:
    async def leave() -> None:
        async with unity_link.connect("sim:scara") as link:
            samples = unity_link.load(SPEC)(link).groups["state"].subscribe()
            await samples.__aenter__()
            await samples.take()

    with pytest.warns(ResourceWarning, match="<subscription of 8 addresses, .* was not closed"):  # noqa: PT031
        run_simulated(leave())
        gc.collect()


def test_callback_that_can_never_run_causes_a_warning() -> None:
    async def forget() -> None:
        async with unity_link.connect("sim:scara") as link:
            link.subscribe(0x88, rate_hz=100, callback=print)
            gc.collect()

    said = "no callback was called: the subscription is not open: write `async with"
    with pytest.warns(RuntimeWarning, match=said):
        run_simulated(forget())


def test_a_subscription_that_was_refused_or_never_asked_for_samples_is_quiet() -> None:
    async def attempt() -> None:
        async with unity_link.connect("sim:scara?groups=1") as link:
            assert link.subscribe(0x88, rate_hz=100).rate_hz == 100
            async with link.subscribe(0x88, rate_hz=100, callback=lambda _: None):
                with pytest.raises(UnsupportedError):
                    await link.subscribe(0x88, rate_hz=100, callback=lambda _: None).__aenter__()

    assert_quiet(lambda: run_simulated(attempt()))


@pytest.mark.slow
def test_loops_over_samples_that_are_left_early_are_quiet() -> None:
    async def leave() -> None:
        async with unity_link.connect("sim:scara") as link:
            robot = unity_link.load(SPEC)(link)
            async for _ in robot.groups["state"]:
                break
            async for _ in robot.j1.cpos:
                break
            robot.j1.cpos.on_change(lambda _: None)
            await asyncio.sleep(0.1)

    def blocking_loops() -> None:
        with blocking.connect("sim:scara") as link:
            robot = put(unity_link.load(SPEC), link)
            for _ in robot.groups["state"]:
                break

    assert_quiet(lambda: asyncio.run(leave()))
    assert_quiet(blocking_loops)


# Servers


async def serve_and_leave(server: AbstractAsyncContextManager[Any], *, left_open: bool) -> None:
    await server.__aenter__()
    if not left_open:
        await server.__aexit__(None, None, None)


@pytest.mark.slow
@pytest.mark.parametrize("name", SERVERS)
def test_unclosed_server_warns(name: str, tmp_path: Path) -> None:
    what = name.partition(",")[0]
    with pytest.warns(ResourceWarning) as told:  # noqa: PT031
        asyncio.run(serve_and_leave(SERVERS[name](tmp_path), left_open=True))
        gc.collect()
    assert f"{what} is still served: use `async with`" in {str(warning.message) for warning in told}


@pytest.mark.slow
@pytest.mark.parametrize("name", SERVERS)
def test_server_closed_by_its_block_is_quiet(name: str, tmp_path: Path) -> None:
    assert_quiet(lambda: asyncio.run(serve_and_leave(SERVERS[name](tmp_path), left_open=False)))
    assert list(tmp_path.iterdir()) == []


def test_networks_that_are_served_in_a_block_are_quiet() -> None:
    async def serve_both() -> None:
        steady: Any = Straying(0)
        async with serve_udp(VirtualGateway()) as url, relay_udp(url, steady, steady) as relayed:
            assert relayed.startswith("udp:")

    assert_quiet(lambda: asyncio.run(serve_both()))


def test_server_without_async_with_is_an_error() -> None:
    server: Any = serve_tcp(VirtualGateway())
    said = r"^nothing is served yet: write `async with serve\.\.\.\(\.\.\.\) as url:`$"
    with pytest.raises(unity_link.ArgumentError, match=said):
        server.__enter__()

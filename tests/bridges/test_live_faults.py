"""Faults of live pictures: pages that stop reading, are killed or too many; gateways that leave and return."""

from __future__ import annotations

import asyncio
import signal
import socket
import struct
import subprocess
import time
from contextlib import ExitStack, suppress
from typing import TYPE_CHECKING

import pytest
from websockets.exceptions import ConnectionClosed

import unity_link
from support.bridge_programs import PATIENCE, PROGRAM, wait_until
from support.live_page import (
    FAST,
    SPEC,
    Live,
    Sleeper,
    connections_of,
    gateway,
    hear,
    live,
    looking,
    memory_of,
    take,
)
from support.valve import Valve, cut
from unity_link.bridges.live import LivePage, bind
from unity_link.bridges.live.page import MOST_VIEWERS
from unity_link.bridges.sampled import sampled_groups
from unity_link.virtual import VirtualGateway
from unity_link.virtual.build import build_gateway

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable
    from pathlib import Path

    from unity_link import Link


# Pages


@pytest.mark.slow
def test_browser_that_stops_reading_delays_no_other_and_costs_no_memory() -> None:
    with live(FAST, SPEC) as running, looking(running) as reader:
        others = connections_of(running.process.pid)
        sleeper, dead = Sleeper(running), Sleeper(running)
        about = hear(reader, "about")
        seen, dropped, before, slept, late = 0, 0, 0, False, 0.0
        while seen < 400_000:
            samples = take(reader, about)
            seen += sum(table.shape[1] for table in samples.tables[0])
            # The reader may lose samples only if it was late itself: a busy machine delays it.
            assert samples.dropped == dropped or late > 1
            dropped, late = samples.dropped, time.time() - samples.sent
            if seen < 100_000:
                before = memory_of(running.process.pid)
            elif not slept:
                # The sleeper reads again, and gets the number of samples that it has missed.
                slept = True
                with sleeper.socket:
                    while not sleeper.next_dropped():
                        pass
        assert memory_of(running.process.pid) - before < 32e6

        # The server drops a page that never reads again.
        wait_until(lambda: take(reader, about).tables and connections_of(running.process.pid) == others)
        dead.socket.close()


@pytest.mark.slow
def test_page_beyond_the_limit_is_refused_until_another_leaves() -> None:
    with live("sim:scara", SPEC) as running, ExitStack() as stack:
        first, last = (stack.enter_context(looking(running)) for _ in range(2))
        hear(first, "about")
        about = hear(last, "about")
        for _ in range(MOST_VIEWERS - 2):
            stack.enter_context(Sleeper(running).socket)
        for _ in range(3):
            with looking(running) as late, pytest.raises(ConnectionClosed, match="32 pages are open already"):
                hear(late, "about")
        first.close()

        def has_a_place() -> bool:
            with looking(running) as late:
                try:
                    return bool(hear(late, "about"))
                except ConnectionClosed:
                    return False

        wait_until(has_a_place)
        assert take(last, about).tables


@pytest.mark.slow
def test_pages_that_end_in_any_way_leave_no_connection_and_no_memory() -> None:
    with live("sim:scara", SPEC) as running, looking(running) as stays:
        about = hear(stays, "about")
        connections, memory = connections_of(running.process.pid), 0
        for number in range(200):
            if number == 80:
                memory = memory_of(running.process.pid)
            page = Sleeper(running)
            if number % 4 == 0:
                page.next_dropped()
            if number % 2:
                # End the connection by a reset.
                page.socket.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            page.socket.close()
        wait_until(lambda: connections_of(running.process.pid) == connections)
        assert memory_of(running.process.pid) - memory < 8e6
        with ExitStack() as stack:
            for _ in range(MOST_VIEWERS - 1):
                hear(stack.enter_context(looking(running)), "about")
        assert take(stays, about).tables


# Gateways


def test_missing_gateway_at_the_start_is_reported_in_one_sentence(tmp_path: Path) -> None:
    result = subprocess.run(
        [PROGRAM, "live", f"unix:{tmp_path / 'nothing'}", SPEC, "--no-browser", "--port", "0"],
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=False,
    )
    assert result.returncode == 1
    assert result.stdout == ""
    assert result.stderr.startswith("error: ")
    assert "Traceback" not in result.stderr


@pytest.mark.slow
def test_samples_resume_with_the_gateway_and_pages_get_both_changes_of_state(tmp_path: Path) -> None:
    place = tmp_path / "gateway"
    simulate = ("simulate", "--robot", "scara")
    with ExitStack() as stack:
        with gateway(place, *simulate) as url:
            page = stack.enter_context(looking(stack.enter_context(live(url, SPEC))))
            about = hear(page, "about")
            take(page, about)
        for connected in (False, True):
            if connected:
                stack.enter_context(gateway(place, *simulate))
            while hear(page, "status")["connected"] != connected:
                pass
        assert take(page, about).tables[0]


@pytest.mark.slow
def test_shared_gateway_that_leaves_is_reported_once_and_awaited(tmp_path: Path) -> None:
    refused = "read of j"
    with ExitStack() as stack:
        simulate = ("simulate", "--robot", "scara")
        with gateway(tmp_path / "gateway", *simulate) as behind:
            url = stack.enter_context(gateway(tmp_path / "shared", "serve", behind))
            running = stack.enter_context(live(url, SPEC, begins=refused))
            page = stack.enter_context(looking(running))
            about = hear(page, "about")
            take(page, about)
        assert running.process.stderr is not None
        told = running.process.stderr.readline()
        assert told.startswith(refused)
        assert told.endswith(": nothing on the bus answered (told once)\n")
        stack.enter_context(gateway(tmp_path / "gateway", *simulate))
        streams = [False, False]
        while not all(streams):
            for stream, tables in take(page, about).tables.items():
                streams[stream] |= bool(tables)


def run_on(gateway: Valve, work: Callable[[Link, LivePage], Awaitable[None]]) -> None:
    """Show a gateway of this process while `work` runs."""

    async def show() -> None:
        async with unity_link.connect(gateway, reconnect=True) as link:
            robot = unity_link.load(SPEC)(link)
            page = LivePage(robot, sampled_groups(robot, 10), gateway="")
            running = asyncio.create_task(page.run(bind(0)))
            try:
                await work(link, page)
            finally:
                running.cancel()
                with suppress(asyncio.CancelledError):
                    await running

    asyncio.run(show())


async def until(condition: Callable[[], bool]) -> None:
    deadline = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < deadline
        await asyncio.sleep(0.01)


@pytest.mark.parametrize("turns", [0, 1, 2, 4])
def test_a_gateway_that_goes_away_before_the_first_sample_is_waited_for(turns: int) -> None:
    gateway = Valve(build_gateway("scara"))

    async def go_away_at_once(link: Link, page: LivePage) -> None:
        for _ in range(turns):
            await asyncio.sleep(0)
        gateway.requests_pass = False
        cut(link)
        await until(lambda: not link.connected)
        before = page.samples
        gateway.requests_pass = True
        await until(lambda: page.samples > before + 100)

    run_on(gateway, go_away_at_once)


@pytest.mark.slow
def test_gateway_reset_on_an_open_line_is_detected() -> None:
    model = build_gateway("scara")
    assert isinstance(model, VirtualGateway)

    async def reset_in_the_middle(link: Link, page: LivePage) -> None:
        await until(lambda: page.samples > 100)
        model.reset()
        await until(lambda: link.statistics.reconnections == 1)
        before = page.samples
        await until(lambda: page.samples > before + 100)

    run_on(Valve(model), reset_in_the_middle)


# The end


@pytest.mark.slow
@pytest.mark.parametrize("what", ["sleeper", "half a request", "nothing"])
def test_ctrl_c_ends_it_with_one_line_whatever_is_connected(what: str) -> None:
    with live(FAST, SPEC) as running, ExitStack() as stack:
        if what == "sleeper":
            stack.enter_context(Sleeper(running).socket)
            reader = stack.enter_context(looking(running))
            about = hear(reader, "about")
            seen = 0
            while seen < 100_000:
                seen += sum(table.shape[1] for table in take(reader, about).tables[0])
        else:
            host, _, port = running.host.partition(":")
            caller = stack.enter_context(socket.create_connection((host, int(port))))
            caller.sendall(b"GET / HTTP/1.1\r\nHo" if what == "half a request" else b"")
        assert_ends_at_ctrl_c(running)


@pytest.mark.slow
def test_ctrl_c_ends_live_with_one_line_while_a_write_waits_for_the_gateway(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("UNITY_LINK_TOKEN", "token")
    with ExitStack() as stack:
        place = tmp_path / "gateway"
        process = stack.enter_context(
            subprocess.Popen([PROGRAM, "simulate", "--robot", "scara", "--unix", str(place)], stdout=subprocess.PIPE)
        )
        stack.callback(process.kill)
        assert process.stdout is not None
        url = process.stdout.readline().decode().strip()
        running = stack.enter_context(live(url, SPEC, "--allow-writes"))
        page = stack.enter_context(looking(running, token="token"))
        hear(page, "welcome")
        # The gateway is stopped, but its connection stays open.
        process.send_signal(signal.SIGSTOP)
        page.send('{"type":"write","number":1,"signal":"j1.pos_sp","value":1}')
        time.sleep(0.3)
        assert_ends_at_ctrl_c(running)


def assert_ends_at_ctrl_c(running: Live) -> None:
    running.process.send_signal(signal.SIGINT)
    _, said = running.process.communicate(timeout=PATIENCE)
    assert running.process.returncode == 128 + signal.SIGINT
    assert len(said.splitlines()) == 1
    assert " samples in " in said

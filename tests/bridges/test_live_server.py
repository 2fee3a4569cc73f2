"""The server of live pictures: access control, writes, and that no browser delays another one."""

from __future__ import annotations

import asyncio
import contextlib
import signal
import socket
import subprocess
from contextlib import AsyncExitStack
from pathlib import Path
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any
from urllib.error import HTTPError
from urllib.request import Request, urlopen

import numpy as np
import pytest
from websockets.exceptions import InvalidStatus

import unity_link
from support.bridge_programs import PATIENCE, PROGRAM, wait_until
from support.live_page import (
    COUNTS_PER_DEGREE,
    POSITION_SET_POINT,
    SPEC,
    TOKEN,
    gateway,
    hear,
    live,
    looking,
    take,
    write,
)
from support.recorded_bus import RecordedBus
from support.sharing import PipedLink, sharing
from support.simulated_time import on_simulated_time, run_simulated
from support.valve import Valve
from unity_link import BusTimeoutError, blocking
from unity_link.bridges.live.outbox import BATCH_HEAD, HEAD, Chunk, Outbox, Tabulator
from unity_link.bridges.live.round_trips import RoundTrips
from unity_link.bridges.sampled import sampled_groups
from unity_link.data import Batch
from unity_link.data.layout import GroupLayout
from unity_link.link.publishing import Sample
from unity_link.spec import compile_text
from unity_link.virtual import VirtualGateway
from unity_link.virtual.build import build_gateway

if TYPE_CHECKING:
    from unity_link import Link
    from unity_link.link.connection import Connection


@pytest.fixture
def token(monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.setenv("UNITY_LINK_TOKEN", TOKEN)
    return TOKEN


def test_the_summary_comes_with_ctrl_c_also_while_a_page_is_open() -> None:
    with live("sim:scara", SPEC) as running:
        with looking(running) as connection:
            take(connection, hear(connection, "about"))
            running.process.send_signal(signal.SIGINT)
            _, said = running.process.communicate(timeout=PATIENCE)
        assert running.process.returncode == 128 + signal.SIGINT
        assert "samples in" in said
        assert "lost" in said
        assert len(said.splitlines()) == 1


def test_the_page_is_opened_in_the_browser_with_its_token(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    browser, opened = tmp_path / "browser", tmp_path / "opened"
    browser.write_text(f'#!/bin/sh\necho "$1" > {opened}.part && mv {opened}.part {opened}\n')
    browser.chmod(0o755)
    monkeypatch.setenv("BROWSER", str(browser))
    monkeypatch.setenv("DISPLAY", ":0")
    monkeypatch.setenv("UNITY_LINK_TOKEN", "a token & more")
    with live("sim:scara", SPEC, "--allow-writes", "--browser") as running:
        wait_until(opened.exists)
        assert opened.read_text().strip() == running.url
        assert running.url.endswith("/#token=a%20token%20%26%20more")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "sentence", "code"),
    [
        ((), "the gateway of sim:scara carries no description of its own: give a spec, such as robot.ul", 2),
        ((SPEC, "--watch", "1"), "a SPEC was expected, or words by --watch ADDRESS, not both", 2),
        (("--watch", "0x100"), "address 0x100 is not from 0 to 0xff", 2),
        (("--watch", "1", "--watch", "0x1"), "address 0x1 was given twice", 2),
        (("--watch", "x"), "x", 2),
        (("--watch", "1", "--rate", "0"), "--rate 0: more than 0 Hz was expected", 2),
        (("--watch", "1", "--rate", "nan"), "--rate nan: more than 0 Hz was expected", 2),
        (("--watch", "1", "--rate", "1e9"), "1e+09 Hz", 2),
        ((SPEC, "--poll", "-1"), "--poll -1: 0 or more Hz was expected", 2),
        ((SPEC, "--poll", "inf"), "--poll inf: 0 or more Hz was expected", 2),
        (("no/such.ul",), "no/such.ul cannot be read", 1),
        ((SPEC, "--interface", "other"), "other", 2),
        ((SPEC, "--port", "70000"), "--port is '70000': a whole number from 0 to 65535 was expected", 2),
        ((SPEC, "--port", "PORT"), "is in use: choose another", 1),
        ((SPEC, "--foxglove", "--foxglove-port", "PORT"), "can't be opened", 1),
        (
            (SPEC, "--foxglove", "--foxglove-port", "0"),
            "--foxglove-port is '0': a whole number from 1 to 65535 was expected",
            2,
        ),
        ((SPEC, "--foxglove-port", "8765"), "--foxglove-port is of --foxglove: give both", 2),
    ],
)
def test_impossible_options_are_reported_in_one_sentence(arguments: tuple[str, ...], sentence: str, code: int) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        given = [str(taken.getsockname()[1]) if argument == "PORT" else argument for argument in arguments]
        ports = () if "--port" in given else ("--port", "0")
        result = subprocess.run(
            [PROGRAM, "live", "sim:scara", *given, "--no-browser", *ports],
            capture_output=True,
            text=True,
            timeout=PATIENCE,
            check=False,
        )
    assert result.returncode == code
    assert sentence in " ".join(result.stderr.split())
    assert "Traceback" not in result.stderr


@pytest.mark.slow
def test_other_pages_and_other_names_are_refused() -> None:
    with live("sim:scara", SPEC, "--allow-writes") as running:
        for origin in ("http://evil.example", "null", running.address.replace("http", "https").rstrip("/"), None):
            with pytest.raises(InvalidStatus) as refused, looking(running, origin=origin):
                pass
            assert refused.value.response.status_code == 403
        for name, value in (("Host", "evil.example"), ("Origin", "http://evil.example")):
            with pytest.raises(HTTPError) as answer:
                urlopen(Request(running.address, headers={name: value}), timeout=PATIENCE)
            assert answer.value.code == 403
            answer.value.close()
        with urlopen(running.address.replace("127.0.0.1", "localhost"), timeout=PATIENCE) as response:
            assert response.status == 200
        with urlopen(running.address, timeout=PATIENCE) as response:
            assert "default-src 'self'" in response.headers["Content-Security-Policy"]
        with pytest.raises(HTTPError) as answer:
            urlopen(running.address + "..%2Fpage.py", timeout=PATIENCE)
        assert answer.value.code == 404
        answer.value.close()


def test_only_loopback_is_listened_at() -> None:
    with live("sim:scara", SPEC) as running:
        port = int(running.host.partition(":")[2])
        listening = Path("/proc/net/tcp").read_text().splitlines()[1:]
        places = {line.split()[1] for line in listening if line.split()[3] == "0A"}
        assert {place for place in places if place.endswith(f":{port:04X}")} == {f"0100007F:{port:04X}"}


@pytest.mark.slow
@pytest.mark.parametrize("token", [None, "", "wrong", TOKEN[:-1], TOKEN + "x", "ä"])
def test_a_write_without_the_token_is_refused(
    token: str | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("UNITY_LINK_TOKEN", TOKEN)
    with gateway(tmp_path / "shared", "serve", "sim:scara") as url, live(url, SPEC, "--allow-writes") as running:
        with looking(running, token=token) as connection:
            answer = write(connection, "j1.pos_sp", 3)
        assert answer["type"] == "refused"
        assert "token" in answer["reason"]
        with blocking.connect(url) as link:
            assert link.read(POSITION_SET_POINT) == 0


def test_write_is_refused_if_writes_are_off_even_with_a_token(token: str) -> None:
    with live("sim:scara", SPEC) as running, looking(running, token=token) as connection:
        assert hear(connection, "welcome") == {"type": "welcome", "may_write": False}
        answer = write(connection, "j1.pos_sp", 3)
        assert answer["type"] == "refused"
        assert "writes are off" in answer["reason"]


def test_only_values_that_a_signal_takes_are_written(token: str, tmp_path: Path) -> None:
    with (
        gateway(tmp_path / "shared", "serve", "sim:scara") as url,
        live(url, SPEC, "--allow-writes") as running,
        looking(running, token=token) as connection,
    ):
        for path, value in (
            ("j1.pos_sp", 130.1),
            ("j1.pos_sp", "a"),
            ("j1.pos_sp", 10**30),
            ("j1.cpos", 1),
            ("j9.pos_sp", 1),
            ("__class__", 1),
        ):
            answer = write(connection, path, value)
            assert answer["type"] == "refused", (path, value)
            assert path in answer["reason"]
        with blocking.connect(url) as link:
            assert link.read(POSITION_SET_POINT) == 0
            assert write(connection, "j1.pos_sp", 36) == {"type": "written", "number": 7}
            assert link.read(POSITION_SET_POINT) == round(36 * COUNTS_PER_DEGREE)


@pytest.mark.slow
def test_samples_come_whole_and_in_order() -> None:
    with live("sim:scara", SPEC) as running, looking(running) as connection:
        about = hear(connection, "about")
        assert [stream["name"] for stream in about["streams"]] == ["state", "rest"]
        assert about["streams"][0]["rate_hz"] == 1000
        tables: list[np.ndarray[Any, Any]] = []
        while sum(table.shape[1] for table in tables) < 2000:
            tables += take(connection, about).tables[0]
        whole = np.concatenate(tables, axis=1)
        # 1 ms by the gateway's clock for each sample that was taken, received or not.
        assert np.median(np.diff(whole[0])) == pytest.approx(1e-3, rel=1e-3)
        taken = whole.shape[1] - 1 + whole[1, 1:].sum()
        assert whole[0, -1] - whole[0, 0] == pytest.approx(1e-3 * taken, abs=0.1)
        status = hear(connection, "status")
        assert status["connected"] is True
        assert status["round_trips"]["median"] > 0
        assert sum(status["round_trips"]["counts"]) > 0


# Parts


def chunk(stream: int, samples: int, value: float) -> Chunk:
    return Chunk(stream, np.full((3, samples), value, float))


def test_an_outbox_that_is_full_drops_the_oldest_and_counts_them() -> None:
    outbox = Outbox(most_bytes=150)
    for number in range(20):
        outbox.put(chunk(0, 3, number))
        assert outbox.bytes <= 150
    message = outbox.take(1.5)
    assert message is not None
    assert HEAD.unpack_from(message) == (1.5, 18 * 3)
    table = np.hstack([chunk(0, 3, 18).table, chunk(0, 3, 19).table])
    assert message[HEAD.size :] == BATCH_HEAD.pack(0, 6) + table.tobytes()
    assert outbox.take(2.0) is None


def test_an_outbox_takes_a_batch_that_is_larger_than_itself() -> None:
    outbox = Outbox(most_bytes=10)
    outbox.put(chunk(4, 50, 1))
    message = outbox.take(0.0)
    assert message == HEAD.pack(0.0, 0) + BATCH_HEAD.pack(4, 50) + chunk(4, 50, 1).table.tobytes()


def test_a_message_has_one_table_for_each_stream() -> None:
    outbox = Outbox()
    for stream, value in ((1, 1), (0, 2), (1, 3)):
        outbox.put(chunk(stream, 1, value))
    message = outbox.take(0.0)
    first, second = np.array([[1.0, 3.0]] * 3).tobytes(), np.array([[2.0]] * 3).tobytes()
    assert message == HEAD.pack(0.0, 0) + BATCH_HEAD.pack(1, 2) + first + BATCH_HEAD.pack(0, 1) + second


def test_round_trips_are_counted_in_bins_of_equal_ratio() -> None:
    trips = RoundTrips([SimpleNamespace(link=None, signal=SimpleNamespace(fifo=False))])  # type: ignore[list-item]
    assert trips.histogram().median is None
    for seconds in (0.0, 1.01e-6, 1.01e-3, 1.02e-3, 5.0, 100.0):
        trips.take(seconds)
    histogram = trips.histogram()
    assert {place: count for place, count in enumerate(histogram.counts) if count} == {0: 2, 30: 2, 66: 1, 69: 1}
    assert histogram.median == pytest.approx(1.015e-3)
    assert histogram.within == 100.0


def test_round_trips_are_measured_on_the_signals_bus_and_errors_count() -> None:
    asked: list[int] = []

    class Behind:
        """The bus of a module, between the signal and the link."""

        async def read(self, address: int) -> int:
            asked.append(address)
            await asyncio.sleep(0.002)
            if len(asked) % 2:
                raise BusTimeoutError("nothing on the bus answered")
            return 0

    async def measure() -> RoundTrips:
        link = SimpleNamespace(statistics=SimpleNamespace(reconnections=0))
        signal = SimpleNamespace(address=5, fifo=False)
        trips = RoundTrips([SimpleNamespace(link=link, bus=Behind(), signal=signal)])  # type: ignore[list-item]
        with contextlib.suppress(TimeoutError):
            async with asyncio.timeout(10):
                await trips.run()
        return trips

    assert sum(run_simulated(measure()).histogram().counts) >= 90
    assert set(asked) == {5}


QUEUES = """
group log(1, TRIGGER);
public robot() {
  @log = 0x10: unsigned READ(FIFO, PUBLISH(log));
  %s
}
"""


@on_simulated_time
@pytest.mark.parametrize(
    ("others", "asked"), [("", set()), ("@a = 0x20: READ(POLL(10));", {0x20})], ids=["a queue alone", "others, too"]
)
async def test_round_trips_take_nothing_out_of_a_queue(others: str, asked: set[int]) -> None:
    gateway = VirtualGateway()
    bus = RecordedBus(gateway)
    async with unity_link.connect(gateway) as link:
        robot = unity_link.load(compile_text(QUEUES % others))(link)
        trips = RoundTrips([proxy for sampled in sampled_groups(robot) for proxy in sampled.group.proxies])
        with contextlib.suppress(TimeoutError):
            async with asyncio.timeout(2):
                await trips.run()
    assert set(bus.reads) == asked


@on_simulated_time
@pytest.mark.parametrize("served", [False, True], ids=["its own link", "a shared link"])
async def test_curve_is_interrupted_only_by_an_absence_of_the_gateway(served: bool) -> None:
    gateway = Valve(build_gateway("scara"))
    async with AsyncExitStack() as stack:
        link: Link
        nearest: Connection
        if served:
            nearest = shared = await stack.enter_async_context(sharing(gateway))
            link = await stack.enter_async_context(PipedLink(shared))
        else:
            nearest = link = await stack.enter_async_context(unity_link.connect(gateway, reconnect=True))
        robot = unity_link.load(SPEC)(link)
        group = robot.groups["state"]
        tabulator = Tabulator(0, group, 100.0)
        samples = await stack.enter_async_context(group.subscribe(rate_hz=100))
        tables = []
        for away in (False, True, False):
            if away:
                gateway.go_away(nearest)
                await asyncio.sleep(3)
                gateway.come_back()
            for _ in range(5):
                batch = await samples.take(50)
                assert batch.time is not None
                tables.append(tabulator.tabulate(batch, batch.time).table)
    at, missing = np.hstack(tables)[:2]
    assert missing[np.diff(at, prepend=at[0]) > 1].tolist() == [1]
    assert missing.sum() == 1


STREAMS = compile_text("""
group steady(1, 100, TIMESTAMPS);
group changed(2, 100, ON_CHANGE, TIMESTAMPS);
public robot() {
  @a = 0x10: READ(PUBLISH(steady));
  @b = 0x11: READ(PUBLISH(changed));
}
""")


@pytest.mark.parametrize(
    ("group", "times", "epochs", "lost", "missing"),
    [
        ("steady", [0, 0.1, 0.2, 0.3], [0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 0]),
        ("steady", [0, 0.1, 0.2, 0.3], [0, 0, 0, 0], [7, 0, 5, 0], [1, 0, 1, 0]),
        ("steady", [0, 0.1, 0.2, 0.3], [4, 4, 5, 5], [0, 0, 0, 0], [0, 0, 1, 0]),
        ("steady", [0, 0.1, 2.1, 2.2], [0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 1, 0]),
        ("changed", [0, 0.1, 20.1, 90], [0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 0]),
    ],
    ids=["none is missing", "some were lost", "it began anew", "none came for long", "none changed for long"],
)
@pytest.mark.parametrize("size", [1, 2, 3])
def test_curve_is_interrupted_before_a_sample_after_missing_ones(
    group: str, times: list[float], epochs: list[int], lost: list[int], missing: list[int], size: int
) -> None:
    async def tabulate() -> list[float]:
        async with unity_link.connect(VirtualGateway()) as link:
            sampled = unity_link.load(STREAMS)(link).groups[group]
            tabulator, layout = Tabulator(0, sampled, 10.0), GroupLayout(sampled.proxies)
            samples = [
                Sample(0, at, at, np.zeros(1, np.uint64), gone, epoch)
                for at, gone, epoch in zip(times, lost, epochs, strict=True)
            ]
            found: list[float] = []
            for place in range(0, len(samples), size):
                batch = Batch(layout, samples[place : place + size])
                found += tabulator.tabulate(batch, np.array(times[place : place + size])).table[1].tolist()
            return found

    assert run_simulated(tabulate()) == missing

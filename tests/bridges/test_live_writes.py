"""Values that pages write: each once, in order, within its limits, and none while the gateway is away."""

from __future__ import annotations

import asyncio
import json
import subprocess
import sys
from contextlib import ExitStack
from typing import TYPE_CHECKING, Any

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

import unity_link
from support.bridge_programs import PATIENCE, WRITES_NAMES, WRITES_SPEC, Noted, wait_until
from support.live_page import Live, hear, live, looking
from support.recorded_bus import RecordedBus
from support.simulated_time import run_simulated
from support.valve import Valve, cut
from unity_link.bridges.live.writing import Refused, Write, Writing, Written
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from websockets.sync.client import ClientConnection

TOKEN = "a-token"


@pytest.fixture(autouse=True)
def token(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("UNITY_LINK_TOKEN", TOKEN)


def wish(number: int, value: Any) -> str:
    return json.dumps({"type": "write", "number": number, "signal": "target", "value": value})


def answers(page: ClientConnection, count: int) -> Iterator[Any]:
    """Yield the next answers in the order of arrival."""
    while count:
        data = page.recv(timeout=PATIENCE)
        if isinstance(data, str) and (message := json.loads(data))["type"] in ("written", "refused"):
            count -= 1
            yield message


@pytest.fixture
def noted(tmp_path: Path) -> Noted:
    return Noted(tmp_path)


def test_every_value_is_written_once_and_in_order_however_many_wait(noted: Noted) -> None:
    with noted.running(), live(noted.url, noted.spec, "--allow-writes") as running:
        with looking(running, token=TOKEN) as page:
            hear(page, "welcome")
            for value in range(500):
                page.send(wish(value, value))
            assert list(answers(page, 500)) == [{"type": "written", "number": value} for value in range(500)]
        assert noted.values == list(range(500))


def test_value_beyond_its_limits_is_refused_and_its_neighbours_are_written(noted: Noted) -> None:
    with noted.running(), live(noted.url, noted.spec, "--allow-writes") as running:
        with looking(running, token=TOKEN) as page:
            hear(page, "welcome")
            for number, value in enumerate([1, 1_000_001, 2, -1, 3]):
                page.send(wish(number, value))
            kinds = [answer["type"] for answer in answers(page, 5)]
        assert kinds == ["written", "refused", "written", "refused", "written"]
        assert noted.values == [1, 2, 3]


@pytest.mark.slow
def test_each_value_is_written_once_or_known_not_to_be_if_the_gateway_leaves(noted: Noted) -> None:
    outcome: dict[int, str] = {}
    with ExitStack() as stack:
        value = 0

        def write_some(page: ClientConnection, count: int) -> None:
            nonlocal value
            for number in range(value, value + count):
                page.send(wish(number, number))
            value += count

        def learn(page: ClientConnection, count: int) -> None:
            for answer in answers(page, count):
                outcome[answer["number"]] = answer.get("reason", "written")

        with noted.running():
            running = stack.enter_context(live(noted.url, noted.spec, "--allow-writes"))
            page = stack.enter_context(looking(running, token=TOKEN))
            hear(page, "welcome")
        for _ in range(3):
            while hear(page, "status")["connected"]:
                pass
            write_some(page, 10)
            learn(page, 10)
            with noted.running():
                while not hear(page, "status")["connected"]:
                    pass
                write_some(page, 500)
                noted.wait_for_more(50)
            learn(page, 500)
    values = noted.values
    written = {number for number, what in outcome.items() if what == "written"}
    not_written = {number for number, what in outcome.items() if what == "the link is away: nothing was written"}
    assert values == sorted(set(values))
    assert written <= set(values)
    assert not_written & set(values) == set()
    assert set(range(10)) <= not_written
    # At most one value has an unknown outcome for each of the three absences.
    assert len(outcome) - len(written | not_written) <= 3


def test_page_killed_during_writes_has_written_once_and_others_continue(
    noted: Noted,
) -> None:
    with (
        noted.running(),
        live(noted.url, noted.spec, "--allow-writes") as running,
        looking(running, token=TOKEN) as other,
    ):
        hear(other, "welcome")
        for start in (0, 100_000, 200_000):
            writer = subprocess.Popen([sys.executable, "-c", _WRITER, running.host, TOKEN, str(start)])
            noted.wait_for_more()
            writer.kill()
            writer.wait()
            other.send(wish(1, start + 99_999))
            assert list(answers(other, 1)) == [{"type": "written", "number": 1}]
        wait_until(lambda: answered(running))
    values = noted.values
    assert len(values) == len(set(values))
    for start in (0, 100_000, 200_000):
        ours = [value for value in values if start <= value < start + 99_999]
        assert ours == list(range(start, start + len(ours)))


_WRITER = """
import json, sys
from websockets.sync.client import connect
host, token, start = sys.argv[1:]
with connect(f"ws://{host}/samples", origin=f"http://{host}", max_size=None) as page:
    page.send(json.dumps({"type": "hello", "token": token}))
    for value in range(int(start), int(start) + 99_000):
        page.send(json.dumps({"type": "write", "number": value, "signal": "target", "value": value}))
"""


def answered(running: Live) -> bool:
    with looking(running) as page:
        return bool(hear(page, "about"))


# Parts, on simulated time

SCALARS = st.booleans() | st.integers(-(2**70), 2**70) | st.just(10**400) | st.floats() | st.text(max_size=5)


@pytest.fixture(scope="module")
def robot_type(tmp_path_factory: pytest.TempPathFactory) -> Any:
    spec = tmp_path_factory.mktemp("spec") / "all.ul"
    spec.write_text(WRITES_SPEC)
    return unity_link.load(spec)


def test_a_value_that_was_not_sent_when_the_link_goes_away_never_is(robot_type: Any) -> None:
    model = VirtualGateway()
    bus, gateway = RecordedBus(model), Valve(model)

    async def lose_it() -> None:
        async with unity_link.connect(gateway, reconnect=True) as link:
            writing = Writing(robot_type(link), TOKEN)
            gateway.requests_pass = False
            # The write waits for its turn: more reads are queued than may be in flight.
            reads = [asyncio.ensure_future(link.read(0)) for _ in range(3000)]
            await asyncio.sleep(0)
            asked = asyncio.ensure_future(writing.write(Write(1, "word", 5)))
            await asyncio.sleep(0.2)
            cut(link)
            answer = await asked
            assert answer == Refused(1, "the link went away: it is not known whether this was written")
            assert await writing.write(Write(2, "word", 6)) == Refused(2, "the link is away: nothing was written")
            gateway.requests_pass = True
            await asyncio.gather(*reads, return_exceptions=True)
            assert bus.writes == []
            assert await writing.write(Write(3, "word", 7)) == Written(3)
            assert bus.writes == [(0x10, 7)]

    run_simulated(lose_it())


def test_value_of_a_page_that_closes_meanwhile_is_written_once(robot_type: Any) -> None:
    model = VirtualGateway()
    bus = RecordedBus(model)

    async def leave() -> None:
        async with unity_link.connect(model) as link:
            writing = Writing(robot_type(link), TOKEN)
            asked = asyncio.ensure_future(writing.write(Write(1, "word", 5)))
            await asyncio.sleep(0)
            asked.cancel()
            await asyncio.wait([asked])
            await asyncio.sleep(1)
            assert writing.written == 1

    run_simulated(leave())
    assert bus.writes == [(0x10, 5)]


def test_written_values_are_known_until_the_link_is_opened_again(robot_type: Any) -> None:
    gateway = Valve(VirtualGateway())

    async def write() -> None:
        async with unity_link.connect(gateway, reconnect=True) as link:
            robot = robot_type(link)
            writing = Writing(robot, TOKEN, {robot.flag})
            wishes: dict[str, Any] = {"word": 5, "mode": "run", "flag": True, "scaled": 0.3}
            for path, value in wishes.items():
                await writing.write(Write(1, path, value))
            assert writing.values == {"word": 5, "mode": 1, "scaled": 0.5}
            cut(link)
            await link.read(0)
            assert writing.values == {}
            await writing.write(Write(2, "word", 6))
            assert writing.values == {"word": 6}

    run_simulated(write())


@given(value=SCALARS, path=st.sampled_from(WRITES_NAMES))
def test_any_requested_value_is_written_or_refused_in_a_sentence(robot_type: Any, value: Any, path: str) -> None:
    async def write() -> None:
        async with unity_link.connect("sim:") as link:
            answer = await Writing(robot_type(link), TOKEN).write(Write(1, path, value))
            assert isinstance(answer, Written | Refused)
            msgspec.json.encode(answer)

    asyncio.run(write())

"""The generated client in C reports the cause of garbage, echoes and losses on its line, and never hangs."""

from __future__ import annotations

import itertools
import random
import subprocess
from typing import TYPE_CHECKING

import pytest

from generate.peers import simulate
from generate.programs import HERE, PATIENCE, SANITIZED, C, Driven, Simulated, SimulatedLine, output
from support.changed_lines import CHANGED_ENDS, OF_LINE_ENDS, ChangedLine
from support.changed_ports import make_sane
from support.events_read import CLEARED, QUEUE, Cleared, Numbers
from support.floods import FLOODS
from support.makers import COMPACT, SLOW, simulated
from unity_link.protocol.host.handshake import ECHO, LINE_ENDS
from unity_link.protocol.host.session import FLOODED
from unity_link.protocol.window.constants import ECHO_PATIENCE
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Noise, NoisyLine, Straying

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

LOST, NO_CONNECTION = "32 ", "36 "


class Replaced:
    """A gateway whose answers are replaced by other bytes from some instant on.

    Args:
        heard: the bytes that arrive each time the client waits.
    """

    def __init__(self, heard: bytes) -> None:
        self._gateway, self._heard = VirtualGateway(), heard
        self.is_replaced = False

    def __call__(self, data: bytes, now: float) -> bytes:
        """Return the bytes that arrive."""
        return self._heard if self.is_replaced else self._gateway.receive(data, now)


# Garbage


@pytest.mark.slow
def test_a_port_that_another_program_has_changed_is_set_again_and_counted(client: Driven) -> None:
    with simulate("pty") as url:
        client.words(f"connect {url} 5")
        client.words("write A 2A")
        assert client.words("ports") == [0]
        for times in (1, 2):
            make_sane(url)
            assert client.words("read A") == [42]
            client.words("write A 2A")
            assert client.words("ports") == [times]
        client.words("close")


@pytest.mark.parametrize(
    ("kind", "request_"),
    [*((kind, "read 10") for kind in FLOODS), ("empty lines", "write 10 1"), ("damaged lines", "fence")],
)
def test_line_full_of_garbage_is_reported_within_two_seconds(driver: Path, kind: str, request_: str) -> None:
    gateway = Replaced(FLOODS[kind])
    with Simulated(driver, gateway, latency=0.01) as client:
        client.words("connect test: 5")
        if request_ == "fence":
            client.words("post 10 1")
        gateway.is_replaced, began = True, client.now
        told = client(request_)
        assert told.startswith(LOST)
        assert FLOODED.partition(" (")[0] in told
        assert FLOODED.partition("): ")[2] in told
        assert client.now - began < 2
        client("close")


def test_noise_on_an_idle_line_ends_no_link(driver: Path) -> None:
    gateway = VirtualGateway()

    def noisy(data: bytes, now: float) -> bytes:
        return gateway.receive(data, now) or b"a\n" * 100

    with Simulated(driver, noisy) as client:
        client.words("connect test: 5")
        client.words("poll 10")
        assert client.words("read 10") == [0]
        client.words("close")


# Floods


MOST_TAKEN = 16 * 2 * 4160
"""Most bytes between two checks of the clock: the largest number of reads, each of a full buffer."""
ENDLESS = {"empty lines": b"\n", "carriage returns": b"\r", "empty plain lines": b"\r\n", "letters": b"PrXn"}


@pytest.fixture(scope="module")
def endless(runtime: list[Path]) -> Path:
    """Return a program whose medium always has more bytes, however many the program reads."""
    folder = runtime[0].parent
    options = [*SANITIZED, "-O1", f"-I{folder}", "-Wno-unused-function"]
    subprocess.run([*C, *options, HERE / "endless.c", "-o", folder / "endless"], check=True, timeout=PATIENCE)
    return folder / "endless"


@pytest.mark.slow
@pytest.mark.parametrize("kind", ENDLESS)
def test_flood_of_bytes_delays_no_call_beyond_its_time_out(endless: Path, kind: str) -> None:
    calls = [line.split() for line in output(endless, ENDLESS[kind].hex().upper()).splitlines()]
    status = {name: int(number) for name, number, _, _ in calls}
    assert status == {"open": 36, "stuck": 36, "poll": 0, "next": 39, "await": 39, "read": 32, "close": 0}
    waited = {name: int(number) for name, _, number, _ in calls}
    assert all(waited[name] <= 6 for name in ("open", "stuck", "poll", "next", "await"))
    assert waited["read"] < 100
    assert max(int(number) for *_, number in calls) <= MOST_TAKEN


# Echoes


def echoing(gateway: Callable[[bytes, float], bytes]) -> Callable[[bytes, float], bytes]:
    """Return a gateway on an adapter that receives its own bytes."""
    return lambda data, now: data + gateway(data, now)


def test_an_adapter_that_echoes_is_passed_over(driver: Path) -> None:
    gateway = VirtualGateway()
    with Simulated(driver, echoing(gateway.receive)) as client:
        client.words("connect test: 5")
        for value in range(20):
            client.words(f"write 10 {value:X}")
        for value in range(20):
            client.words(f"post {value:X} 5")
        client.words("fence")
        assert client.words("rblock 0 14") == [5] * 20
        assert client.words("rmany " + "10 " * 200) == [5] * 200
        assert client.words("statistics")[2:] == [0, 0, 0, 0]
        client.words("close")


def test_silent_gateway_on_an_echoing_line_is_lost_in_the_usual_time(driver: Path) -> None:
    gateway, is_silent = VirtualGateway(), False

    def silent(data: bytes, now: float) -> bytes:
        answers = gateway.receive(data, now)
        return b"" if is_silent else answers

    with Simulated(driver, echoing(silent)) as client:
        client.words("connect test: 5")
        is_silent, began = True, client.now
        assert client("write 10 1").startswith(LOST)
        assert client.now - began < 12
        client("close")


def test_port_with_tx_wired_to_rx_is_reported_if_no_answer_follows_the_echo(driver: Path) -> None:
    with Simulated(driver, lambda data, now: data) as client:
        assert client("connect test: 5") == f"{NO_CONNECTION}{ECHO}"
        assert ECHO_PATIENCE < client.now < 2 * ECHO_PATIENCE


def test_query_that_returned_once_is_no_echo(driver: Path) -> None:
    gateway, times = VirtualGateway(), itertools.count()

    def once(data: bytes, now: float) -> bytes:
        answers = gateway.receive(data, now)
        return data + answers if data and next(times) == 0 else answers

    with Simulated(driver, once) as client:
        client.words("connect test: 5")
        assert client.words("read 10") == [0]
        client.words("close")


@pytest.mark.parametrize(("name", "direction"), CHANGED_ENDS)
def test_a_line_that_changes_cr_or_lf_is_named(driver: Path, name: str, direction: str) -> None:
    line = ChangedLine(VirtualGateway(), OF_LINE_ENDS[name], direction)
    with Simulated(driver, line.receive) as client:
        assert client("connect test: 2") == f"{NO_CONNECTION}{LINE_ENDS}"


# Losses


def test_losses_and_not_the_speed_are_reported_if_some_queries_were_answered(driver: Path) -> None:
    gateway, answered = VirtualGateway(), itertools.count()

    def silent_from_the_second_on(data: bytes, now: float) -> bytes:
        answers = gateway.receive(data, now)
        return answers if answers and next(answered) == 0 else b""

    with Simulated(driver, silent_from_the_second_on) as client:
        told = client("connect test: 1")
    assert told.startswith(f"{NO_CONNECTION}the gateway answered 1 of ")
    assert told.endswith(" questions: requests or answers are lost or damaged on the way, or this computer is too busy")


def test_session_that_does_not_begin_is_reported_with_earlier_answers(driver: Path) -> None:
    gateway = VirtualGateway()
    with Simulated(driver, lambda data, now: b"" if b"K" in data else gateway.receive(data, now)) as client:
        told = client("connect test: 1")
    assert told.startswith(f"{NO_CONNECTION}the gateway answered 2 of ")


@pytest.mark.parametrize("seed", range(20))
def test_link_opens_within_five_seconds_if_one_frame_in_five_is_lost(driver: Path, seed: int) -> None:
    gateway = VirtualGateway()
    towards, back = (Straying[bytes](seed + place, loss=0.2) for place in (0, 100))

    def losing(data: bytes, now: float) -> bytes:
        heard = b"".join(towards.carry(data)) if data else b""
        answers = gateway.receive(heard, now)
        return b"".join(back.carry(answers)) if answers else b""

    with Simulated(driver, losing) as client:
        client.words("connect test:0.003 5")
        client("close")


@pytest.mark.parametrize("amount", [2_000, pytest.param(100_000, marks=pytest.mark.campaign)])
@pytest.mark.parametrize("compact", [False, True], ids=["text", "compact"])
def test_damaged_bytes_lose_no_event_of_a_queue_or_a_clear_on_read_register(
    driver: Path, amount: int, *, compact: bool
) -> None:
    gateway, draw, cleared = simulated(**(COMPACT if compact else SLOW)), random.Random(4), Cleared()
    gateway.attach(Numbers(), [QUEUE])
    gateway.attach(cleared, [CLEARED])
    seen: list[int] = []
    line = NoisyLine(gateway, Noise(1, flip=0.01), Noise(2, flip=0.01))
    with SimulatedLine(driver, line) as client:
        client.words("connect test: 5")
        while len(seen) < amount:
            seen += client.words(f"rqueue {QUEUE:X} {draw.randrange(1, 9):X}")
            assert client.words(f"rqueue {CLEARED:X} 1") == [cleared.made.popleft()]
            assert not cleared.made
        repeated, *_ = client.words("statistics")[2:]
        client.words("close")
    assert repeated
    assert seen == list(range(1, len(seen) + 1))

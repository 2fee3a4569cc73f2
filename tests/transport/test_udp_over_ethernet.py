"""Links by `udp:` to the compiled gateware, behind RMII or a W5500, through the kernel's network stack."""

from __future__ import annotations

import asyncio
import contextlib
import functools
import itertools
import random
import re
import socket
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest
import trio
import uvloop

import unity_link
from gateware.bench.network.tap import GATEWAY, INTERFACE, URL, plugged
from gateware.bench.network.wire import GATEWAY_PORT, Wire
from generate.programs import CPP, HERE, C, Driven, compiled, generated, linked
from support.behaviours import (
    BEHAVIOURS,
    REFUSING,
    SILENT,
    a_lost_line_ends_the_calls,
    a_reset_is_told_and_nothing_is_executed_by_a_gateway_without_a_session,
    blocks_are_consecutive_and_queues_one_address,
    each_write_is_executed_exactly_once_and_in_order_on_a_noisy_line,
    errors_say_by_their_kind_what_was_wrong_and_leave_others_alone,
    what_a_gateway_was_built_without_is_refused,
    words_are_read_and_written,
)
from support.driven_link import DrivenLink
from support.faces import face
from support.spec_examples import FIGURE_1
from unity_link import LinkLostError
from unity_link.errors import Outcome
from unity_link.spec import compile_text
from unity_link.virtual.faults import Straying
from unity_link.virtual.udp_relay import relay_udp

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from gateware.bench.network.tap import Plugged
    from support.behaviours import Behaviour

pytest_plugins = ["gateware.bench.network.fixtures"]
pytestmark = pytest.mark.slow
FACES = ("asyncio", "uvloop", "trio", "blocking", "C", "C++")
PROGRAMS = {"C": (C, "driver.c"), "C++": (CPP, "driver.cc")}
"""Compiler and source of the APIs that are tested by compiled programs."""
LOST = {"loss": 0.02, "late": 0.03, "double": 0.05}
"""Probabilities of a fault of each frame on a bad line."""
EMPTY = {
    a_lost_line_ends_the_calls: "datagrams have no line; silence ends a link after five seconds",
    what_a_gateway_was_built_without_is_refused: "it has every feature; those without are built by other benches",
}
"""Behaviours that are not tested here, and why."""
IN_MAKE_TEST = {
    ("blocking", words_are_read_and_written),
    ("uvloop", words_are_read_and_written),
    ("trio", errors_say_by_their_kind_what_was_wrong_and_leave_others_alone),
    ("blocking", each_write_is_executed_exactly_once_and_in_order_on_a_noisy_line),
    ("C", words_are_read_and_written),
    ("C", blocks_are_consecutive_and_queues_one_address),
    ("C", a_reset_is_told_and_nothing_is_executed_by_a_gateway_without_a_session),
    ("C", each_write_is_executed_exactly_once_and_in_order_on_a_noisy_line),
}
"""Combinations, besides those of asyncio, that run without `campaign`."""
IN_MAKE_TEST_BEHIND_A_W5500 = {
    ("asyncio", words_are_read_and_written),
    ("asyncio", blocks_are_consecutive_and_queues_one_address),
    ("C", each_write_is_executed_exactly_once_and_in_order_on_a_noisy_line),
}
"""Combinations with a W5500 that run without `campaign`."""


class Served:
    """A gateway at the cable, with the interface that the behaviours use."""

    def __init__(self, plugged: Plugged) -> None:
        self._plugged = plugged
        self.url = URL
        self.gateway = self
        self.reset = lambda: plugged.call("reset")

    @property
    def bus_log(self) -> Any:
        """Return the writes that have reached the bus."""
        return SimpleNamespace(writes=self._plugged.written())

    @property
    def most_at_once(self) -> int:
        """Return the largest number of requests with an ID in one datagram."""
        return max(len(re.findall(rb"\n[g-z]", frame)) for frame in self._plugged.heard)


class Line:
    """The connection to the gateways of one test: a network namespace.

    Args:
        physical: their Ethernet interface, as `unity_link` names it.
    """

    def __init__(self, physical: str) -> None:
        self._physical = physical

    @contextlib.contextmanager
    def gateway(self, noise: float = 0.0, **_: Any) -> Iterator[Served]:
        """Connect a gateway with failing addresses, behind a line that loses, duplicates and delays frames."""
        towards, back = (Straying[bytes](seed, latest=20, **LOST if noise else {}) for seed in (1, 2))
        with plugged(Wire({"physical": self._physical}), towards=towards, back=back) as gateway:
            gateway.call("refuse", REFUSING)
            gateway.call("refuse", SILENT, silent=True)
            yield Served(gateway)


@pytest.fixture(scope="module")
def compiled_driver(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """Return a function that compiles the driver of an API, once for the module."""

    @functools.cache
    def make(name: str) -> Path:
        folder = tmp_path_factory.mktemp("driver")
        generated("cpp", compile_text(FIGURE_1), folder)
        compiler, source = PROGRAMS[name]
        objects = compiled(C, [folder / "unity_link.c", folder / "unity_link_posix.c"], folder)
        return linked(compiler, [*objects, *compiled(compiler, [HERE / source], folder)], folder / "driver")

    return make


def _cells() -> Iterator[Any]:
    for physical, name, behaviour in itertools.product(("rmii", "w5500"), FACES, BEHAVIOURS):
        if behaviour in EMPTY:
            continue
        if physical == "rmii":
            short = name == "asyncio" or (name, behaviour) in IN_MAKE_TEST
        else:
            short = (name, behaviour) in IN_MAKE_TEST_BEHIND_A_W5500
        marks = [] if short else [pytest.mark.campaign]
        yield pytest.param(physical, name, behaviour, id=f"{physical}-{name}-{behaviour.__name__}", marks=marks)


@pytest.mark.parametrize(("physical", "name", "behaviour"), [*_cells()])
def test_every_api_has_the_behaviours_of_a_link_on_the_gateware(
    physical: str,
    name: str,
    behaviour: Behaviour,
    network: None,
    tmp_path: Path,
    compiled_driver: Callable[[str], Path],
) -> None:
    line: Any = Line(physical)
    connect: Any = unity_link.connect
    if name in PROGRAMS:
        # The program is started in the network namespace.
        with Driven(compiled_driver(name)) as program:
            asyncio.run(behaviour(lambda url: DrivenLink(program, url), line))
    elif name == "trio":
        trio.run(behaviour, connect, line)
    elif name == "blocking":
        with face("blocking", tmp_path) as connect:
            asyncio.run(behaviour(connect, line))
    else:
        with asyncio.Runner(loop_factory=uvloop.new_event_loop if name == "uvloop" else None) as runner:
            runner.run(behaviour(connect, line))


async def write_all(link: unity_link.Link, numbers: range, address: int = 0x80) -> None:
    for number in numbers:
        await link.post(address, number)
    await link.fence()


@pytest.mark.asyncio
@pytest.mark.parametrize("rounds", [20, pytest.param(600, marks=pytest.mark.campaign)])
async def test_requests_over_a_bad_network_are_executed_once_and_in_order(gateway: Plugged, rounds: int) -> None:
    for address in range(64):
        gateway.call("poke", address, address)
    towards, back = (Straying[Any](seed, latest=600, loss=0.02, late=0.03, double=0.1) for seed in (1, 2))
    numbers = itertools.count()
    async with relay_udp(URL, towards, back) as relayed, unity_link.connect(relayed, timeout=60) as link:
        for start in range(rounds):
            writes = [link.write(0x80, next(numbers)) for _ in range(2)]
            reads = [link.read((start + place) % 64) for place in range(4)]
            answers = await asyncio.gather(*writes, *reads)
            assert answers[2:] == [(start + place) % 64 for place in range(4)]
    assert gateway.written() == [(0x80, number) for number in range(2 * rounds)]


@pytest.mark.asyncio
async def test_a_second_host_takes_the_gateway_and_the_first_link_ends(gateway: Plugged) -> None:
    async with unity_link.connect(URL) as first:
        await first.write(1, 6)
        async with unity_link.connect(URL) as second:
            with pytest.raises(LinkLostError):
                await first.write(1, 7)
            assert await second.read(1) == 6
    assert gateway.written() == [(1, 6)]


@pytest.mark.asyncio
async def test_a_first_host_that_reconnects_leaves_the_gateway_to_the_second(
    gateway: Plugged, monkeypatch: pytest.MonkeyPatch
) -> None:
    # With predictable session numbers the second host opens its session at once, and the first host finds it.
    monkeypatch.setattr("unity_link.link.connection.choose_seed", itertools.count().__next__)
    async with unity_link.connect(URL, reconnect=True) as first:
        await first.write(1, 7)
        async with unity_link.connect(URL) as second:
            with contextlib.suppress(LinkLostError):
                await first.read(1)
            with pytest.raises(LinkLostError, match="unity-link serve"):
                await first.read(1)
            assert await second.read(1) == 7
            assert second.statistics.reconnections == 0


@pytest.mark.asyncio
async def test_a_reset_during_a_session_ends_the_link_without_a_second_execution(gateway: Plugged) -> None:
    async with unity_link.connect(URL) as link:
        await write_all(link, range(10))
        gateway.call("reset")
        with pytest.raises(LinkLostError) as caught:
            await link.write_queue(0x80, [10])
        assert caught.value.outcome is not Outcome.EXECUTED
    async with unity_link.connect(URL) as again:
        await again.write_queue(0x80, [11])
    assert [word for _, word in gateway.written()] == [*range(10), 11]


@pytest.mark.asyncio
async def test_a_stopped_gateway_raises_in_every_waiting_call(gateway: Plugged) -> None:
    async with unity_link.connect(URL) as link:
        await link.write(0, 1)
        gateway.pause()
        calls = [link.read(0), link.write(0, 1), link.read_many(range(64)), link.write_block(0, range(64))]
        errors = await asyncio.gather(*calls, return_exceptions=True)
        assert [type(error) for error in errors] == [LinkLostError] * len(calls)


@pytest.mark.asyncio
async def test_a_flood_of_invalid_datagrams_disturbs_no_link(gateway: Plugged) -> None:
    generator = random.Random(1)
    async with unity_link.connect(URL) as link:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
            stranger.connect((GATEWAY, GATEWAY_PORT))
            for number in range(40):
                noise = generator.randbytes(generator.randrange(60))
                stranger.send(generator.choice([noise, b"U" + noise, b"U0000000100000001\r" + noise]))
                await link.write(1, number)
                assert await link.read(1) == number


@pytest.mark.asyncio
@pytest.mark.parametrize("options", ["", f"?interface={INTERFACE}&ttl=3"])
async def test_blocks_are_sent_unfragmented_by_the_interface_and_ttl_of_the_url(gateway: Plugged, options: str) -> None:
    async with unity_link.connect(URL + options) as link:
        await link.write_block(0, range(224))
        assert (await link.read_block(0, 224)).tolist() == [*range(224)]
    datagrams = [frame for frame in gateway.heard if frame[12:14] == b"\x08\0"]
    assert {frame[22] for frame in datagrams} == {3 if options else 64}
    assert {frame[20] & 0x3F for frame in datagrams} == {0}
    assert 1000 < max(map(len, datagrams)) <= 14 + 20 + 8 + 1400

"""Behaviours that every API of a link must have, as functions of any object with the methods of a link.

`tests/generate/test_every_face.py` runs them. Each gets a function that connects to a URL, and the `Line` of its test.
"""

from __future__ import annotations

from contextlib import ExitStack, contextmanager
from typing import TYPE_CHECKING, Any, Protocol

import pytest

from generate.peers import ObservedGateway
from unity_link import (
    ArgumentError,
    BusError,
    BusTimeoutError,
    LinkLostError,
    Outcome,
    UnsupportedError,
)
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual.faults import Failing, Noise, NoisyLine

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Iterator
    from contextlib import AbstractAsyncContextManager, AbstractContextManager

    from unity_link.virtual import Gateway

    Connect = Callable[[str], AbstractAsyncContextManager[Any]]
    Behaviour = Callable[[Connect, "Line"], Coroutine[Any, Any, None]]

REFUSING, SILENT, QUEUE = 0xF0, 0xF1, 0xF2
WIDE_CRC = {"crc_bits": 32, "crc_polynomial": 0x04C11DB7}
"""CRC of 32 bits, so that no damaged frame passes by chance."""


class Server(Protocol):
    """Serves gateways in its own thread."""

    def serve(self, gateway: Gateway) -> AbstractContextManager[str]:
        """Serve a gateway; yield its URL."""

    def call(self, function: Callable[[], object]) -> object:
        """Call a function in the thread that serves the gateways; return its result."""


class Line:
    """Serves the gateways of one test."""

    def __init__(self, server: Server) -> None:
        self._server = server

    @contextmanager
    def gateway(self, noise: float = 0.0, **built: Any) -> Iterator[Served]:
        """Serve a gateway with failing addresses and a queue; `noise` is the chance of each byte to be lost or damaged.

        Args:
            noise: from 0 to 1; with 0 the line is perfect.
            built: fields of the gateway's `GatewayInfo`.
        """
        gateway = ObservedGateway(GatewayInfo(**built))
        gateway.detach([REFUSING, SILENT])
        gateway.attach(Failing(ErrorCode.BUS_ERROR), [REFUSING])
        gateway.attach(Failing(ErrorCode.BUS_TIMEOUT), [SILENT])
        chances = {"loss": noise, "flip": noise}
        line = NoisyLine(gateway, Noise(1, **chances), Noise(2, **chances)) if noise else gateway
        with ExitStack() as stack:
            url = stack.enter_context(self._server.serve(line))
            yield Served(gateway, url, stack, self._server)


class Served:
    """A gateway that is being served."""

    def __init__(self, gateway: ObservedGateway, url: str, serving: ExitStack, server: Server) -> None:
        self.gateway, self.url = gateway, url
        self._serving, self._server = serving, server

    def reset(self) -> None:
        """Reset the gateway without closing the line."""
        self._server.call(self.gateway.reset)

    def hang_up(self) -> None:
        """Close the line."""
        self._serving.close()


def plain(words: Any) -> list[int]:
    """Return the words of any array as a list."""
    return [int(word) for word in words]


async def words_are_read_and_written(connect: Connect, line: Line) -> None:
    with line.gateway() as served:
        async with connect(served.url) as link:
            await link.write(0x10, 42)
            assert await link.read(0x10) == 42
            assert await link.write_masked(0x10, 0xF0, 0xF0) == 42
            assert await link.read(0x10) == 0xFA
        assert served.gateway.bus_log.writes == [(0x10, 42), (0x10, 0xFA)]


async def posts_are_executed_in_order_and_a_fence_waits_for_them(connect: Connect, line: Line) -> None:
    with line.gateway() as served:
        async with connect(served.url) as link:
            for value in range(200):
                await link.post(0x20, value)
            await link.fence()
            assert served.gateway.bus_log.writes == [(0x20, value) for value in range(200)]
            await link.post(REFUSING, 1)
            await link.post(0x21, 1)
            with pytest.raises(BusError):
                await link.fence()
            await link.fence()
            assert await link.read(0x21) == 1


async def blocks_are_consecutive_and_queues_one_address(connect: Connect, line: Line) -> None:
    with line.gateway(block_words=7) as served:
        async with connect(served.url) as link:
            await link.write_block(0x20, range(100))
            assert plain(await link.read_block(0x20, 100)) == [*range(100)]
            await link.write_queue(0x10, [7, 8, 9])
            assert plain(await link.read_queue(0x10, 2)) == [9, 9]


async def batches_have_all_requests_under_way_at_once(connect: Connect, line: Line) -> None:
    with line.gateway() as served:
        async with connect(served.url) as link:
            await link.write_many(range(200), range(1, 201))
            assert plain(await link.read_many(range(199, -1, -1))) == [*range(200, 0, -1)]
        assert served.gateway.most_at_once > 1


async def groups_are_sampled_by_the_gateway_in_order(connect: Connect, line: Line) -> None:
    with line.gateway() as served:
        async with connect(served.url) as link:
            await link.write_block(0x10, [5, 6])
            async with link.subscribe([0x10, 0x11], rate_hz=1000) as samples:
                taken = [await anext(samples) for _ in range(10)]
            place = -1
            for sample in taken:
                place += 1 + sample.lost
                assert sample.sequence == place
                assert plain(sample.values) == [5, 6]
            async with link.subscribe([0x11]) as samples:
                await samples.publish()
                assert plain((await anext(samples)).values) == [6]


async def errors_say_by_their_kind_what_was_wrong_and_leave_others_alone(connect: Connect, line: Line) -> None:
    with line.gateway() as served:
        async with connect(served.url) as link:
            with pytest.raises(BusError):
                await link.write(REFUSING, 1)
            with pytest.raises(BusTimeoutError):
                await link.read(SILENT)
            with pytest.raises(BusError):
                await link.write_many([0x10, REFUSING, 0x11], [1, 2, 3])
            with pytest.raises(ArgumentError):
                await link.read(0x100)
            with pytest.raises(ArgumentError):
                await link.write(0x10, 1 << 32)
            assert plain(await link.read_many([0x10, 0x11])) == [1, 3]


async def what_a_gateway_was_built_without_is_refused(connect: Connect, line: Line) -> None:
    with line.gateway(features=Feature.FLOW_CONTROL) as served:
        async with connect(served.url) as link:
            with pytest.raises(UnsupportedError):
                await link.write_masked(0x10, 1, 1)


async def a_reset_is_told_and_nothing_is_executed_by_a_gateway_without_a_session(connect: Connect, line: Line) -> None:
    with line.gateway() as served:
        async with connect(served.url) as link:
            await link.write(0x10, 1)
            served.reset()
            with pytest.raises(LinkLostError) as told:
                await link.write(0x10, 2)
            # On a slow machine the write was retransmitted before the reset was detected, so its outcome is unknown.
            assert told.value.outcome is not Outcome.EXECUTED
            assert served.gateway.bus_log.writes == [(0x10, 1)]
        async with connect(served.url) as link:
            await link.write(0x10, 3)
            assert await link.read(0x10) == 3


async def a_lost_line_ends_the_calls(connect: Connect, line: Line) -> None:
    async def write_on(url: str) -> None:
        async with connect(url) as link:
            await link.write(0x10, 1)
            served.hang_up()
            for _ in range(3):
                await link.write(0x10, 2)

    with line.gateway() as served, pytest.raises(LinkLostError):
        await write_on(served.url)


async def each_write_is_executed_exactly_once_and_in_order_on_a_noisy_line(connect: Connect, line: Line) -> None:
    with line.gateway(noise=0.001, **WIDE_CRC) as served:
        async with connect(served.url) as link:
            for first in range(0, 240, 60):
                for value in range(first, first + 20):
                    await link.post(0x20, value)
                await link.write_many([0x20] * 20, range(first + 20, first + 40))
                for value in range(first + 40, first + 60):
                    await link.write(0x20, value)
            await link.fence()
            assert plain(await link.read_many([0x20] * 50)) == [239] * 50
        assert served.gateway.bus_log.writes == [(0x20, value) for value in range(240)]


BEHAVIOURS: tuple[Behaviour, ...] = (
    words_are_read_and_written,
    posts_are_executed_in_order_and_a_fence_waits_for_them,
    blocks_are_consecutive_and_queues_one_address,
    batches_have_all_requests_under_way_at_once,
    groups_are_sampled_by_the_gateway_in_order,
    errors_say_by_their_kind_what_was_wrong_and_leave_others_alone,
    what_a_gateway_was_built_without_is_refused,
    a_reset_is_told_and_nothing_is_executed_by_a_gateway_without_a_session,
    a_lost_line_ends_the_calls,
    each_write_is_executed_exactly_once_and_in_order_on_a_noisy_line,
)

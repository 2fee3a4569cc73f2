"""The gateway behind a server is reset: its clients get true outcomes, and no session continues."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

import numpy as np
import pytest

from support.recorded_bus import RecordedBus
from support.sharing import SEED, SEED_BACK, PipedLink, Terminal, call, settle, sharing, tell_of_reset, until
from support.simulated_time import on_simulated_time
from support.valve import Valve, cut
from unity_link import Reconnect
from unity_link.errors import GatewayResetError
from unity_link.protocol.host.events import Interrupted
from unity_link.protocol.window.constants import KEEP_ALIVE
from unity_link.protocol.wire.arrays import hex_rows, request_rows
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.messages import Codec
from unity_link.virtual import VirtualGateway
from unity_link.virtual.line import SlowLine

if TYPE_CHECKING:
    from unity_link.bridges.serve.shared import SharedLink

KILOHERTZ = 1_000_000
"""A base frequency with few ticks, so that simulated time passes quickly."""
CODEC = Codec(GatewayInfo())


def lose(shared: SharedLink) -> None:
    """End the server's connection to the gateway, with all requests in flight."""
    cut(shared)


def opened(codec: Codec, frame: bytes) -> bytes:
    """Return the body of an answer to a client in session 1, or of error 0A, which belongs to no session."""
    return codec.framing.open(frame, 0 if len(frame) > 10 else SEED_BACK)


def refusal(request: bytes) -> bytes:
    """Return the frame of error 0A for a checked request `w` or `ws`, without line end."""
    text, check = request[:-4], request[-4:]
    number = int(text.lstrip(b"ws")[:3], 16)
    return CODEC.framing.checked(CODEC.no_session(number, CODEC.framing.crc.of(text) ^ int(check, 16)))[:-1]


async def say(client: Terminal, shared: SharedLink, text: bytes) -> list[bytes]:
    """Send a client's requests; return the answers, without samples."""
    client.transport.write(text)
    await settle(shared)
    return [frame for frame in client.take().split() if not frame.startswith(b"P")]


@on_simulated_time
async def test_reset_leaves_sent_requests_unknown_and_refuses_queued_session_ones() -> None:
    gateway = VirtualGateway()
    valve = Valve(gateway)
    async with sharing(valve) as shared:
        client = call(shared)
        await say(client, shared, b"K0000001\rGS00010001010A\rGN00\rGX00\r")
        valve.answers_pass = False
        client.transport.write(b"w0000A00000001\rws0010A00000002\rr0020A\r")
        await asyncio.sleep(0.001)
        lose(shared)
        client.transport.write(b"w0030B00000003\rws0040B00000004\rR0A\rGX00\r")
        await asyncio.sleep(0.001)
        gateway.reset()
        shared._gateway_was_reset(Interrupted(GatewayResetError("the gateway was reset")))
        valve.answers_pass = True
        await until(lambda: client.heard.count(b"\n") == 7)
        answers = b"x00005 x00105 x00205 x0030A0000 x0040A0000 R0A00000002 X05"
        assert client.take().split() == answers.split()
        assert valve.memory[0x0B] == 0


@on_simulated_time
async def test_server_whose_session_number_is_reused_ends_without_acknowledging() -> None:
    gateway = VirtualGateway()
    async with sharing(gateway) as shared:
        client = call(shared)
        assert await say(client, shared, b"K0000001\rw0000A00000001\r") == [b"K00000010000", b"w000"]
        await asyncio.sleep(2 * KEEP_ALIVE)
        number, expected = gateway.session, gateway.expected
        gateway.begin(number % 100 + 1, 0)
        gateway.begin(number, expected + 100)
        client.transport.write(b"w0010A00000002\r")
        await until(shared.ended.done)
        assert "another program" in str(shared.ended.exception())
        assert client.take() == b""
    assert gateway.memory[0x0A] == 1


@on_simulated_time
async def test_nothing_with_an_id_is_executed_until_the_client_begins_a_session() -> None:
    gateway = VirtualGateway()
    async with sharing(gateway) as shared:
        client, other = call(shared), call(shared)
        await say(client, shared, b"K0050001\rw0050A00000001\r")
        await tell_of_reset(shared, gateway, client)
        writes = request_rows(CODEC, "W", 6, hex_rows(np.arange(0x0B00000007, 0x0B00000017), 10), SEED)
        refused = [refusal(write) for write in writes.splitlines()]
        client.transport.write(writes)
        await settle(shared)
        assert client.take().splitlines() == refused
        post = CODEC.request("WS", 22, b"0B00000007", SEED)
        answers = await say(client, shared, post + b"h017\rr3000A\rQ\rW0C00000005\r")
        assert answers[:3] == [refusal(post.strip()), b"x0170A0000", b"x3000A0000"]
        assert answers[3].startswith(b"Q03")
        assert answers[4] == b"W0C"
        assert (gateway.memory[0x0B], gateway.memory[0x0C]) == (0, 5)
        answers = await say(client, shared, b"K8000002\rw8000B00000009\rh7FF\rh900\r")
        assert answers == [b"K80000020000", b"w800", b"h7FF000", b"n801"]
        assert gateway.memory[0x0B] == 9
        # The sessions of the other clients have ended too.
        assert await say(other, shared, b"h000\rK0000001\rh000\r") == [b"x0000A0000", b"K00000010000", b"h000000"]


@on_simulated_time
async def test_the_groups_of_a_client_are_forgotten_and_free_for_others() -> None:
    gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=KILOHERTZ, groups=1))
    async with sharing(gateway) as shared:
        client, other = call(shared), call(shared)
        client.transport.write(b"I01\rGS0001000A0110\rGN00\r")
        await until(lambda: client.heard.count(b"P00") > 3)
        await tell_of_reset(shared, gateway, client)
        client.take()
        assert await say(client, shared, b"GN00\rGP00\rGX00\r") == [b"X06"] * 3
        assert (gateway.next_due, gateway.send_immediate) == (None, 2)
        assert await say(other, shared, b"GS0001000A0120\rGN00\r") == [b"GS00", b"GN00"]
        await asyncio.sleep(0.1)
        assert (other.take().count(b"P00") > 3, client.take()) == (True, b"")


@pytest.mark.parametrize("command", [b"GS0001000A0110\r", b"GN00\r", b"GP00\r", b"K0010001\r"])
@pytest.mark.parametrize("running", [b"GN00\r", b"GP00\r"])
@on_simulated_time
async def test_group_named_by_a_request_during_a_reset_neither_runs_nor_is_lost(command: bytes, running: bytes) -> None:
    gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=KILOHERTZ, groups=1))
    async with sharing(gateway) as shared:
        client, other = call(shared), call(shared)
        await say(client, shared, b"GS0001000A0110\r" + running)
        await tell_of_reset(shared, gateway, client, command)
        await settle(shared)
        assert gateway.next_due is None
        client.take()
        assert await say(other, shared, b"GS0001000A0120\rGN00\r") == [b"GS00", b"GN00"]
        await asyncio.sleep(0.1)
        assert (other.take().count(b"P00") > 3, client.take()) == (True, b"")


@on_simulated_time
async def test_batch_cut_by_a_reset_gets_one_true_outcome_for_each_request() -> None:
    gateway = VirtualGateway()
    bus = RecordedBus(gateway)
    async with sharing(SlowLine(gateway, 100_000)) as shared:
        client = call(shared)
        await say(client, shared, b"K0000001\r")
        # More requests than the window holds, and than the server reads at once.
        client.transport.write(
            request_rows(CODEC, "W", 0, hex_rows(np.arange(0x0A00000000, 0x0A00000000 + 3000), 10), SEED)
        )
        await asyncio.sleep(0.05)
        await tell_of_reset(shared, gateway, client)
        await settle(shared)
        bodies = [opened(CODEC, frame) for frame in client.take().splitlines()]
    kinds = {b"executed": b"", b"unknown": b"05", b"refused": b"0A%04X" % CODEC.framing.crc.of(bytes(14), SEED)}
    told = {kind: [int(body[1:4], 16) for body in bodies if body[4:] == end] for kind, end in kinds.items()}
    assert [int(body[1:4], 16) for body in bodies] == list(range(3000))
    assert [number for numbers in told.values() for number in numbers] == list(range(3000))
    assert told[b"executed"]
    assert told[b"refused"]
    words = [word for _, word in bus.writes]
    assert words == list(range(len(words)))
    assert len(told[b"executed"]) <= len(words) <= told[b"refused"][0]


@on_simulated_time
async def test_requests_beyond_the_window_at_a_reset_are_known_not_to_be_executed() -> None:
    gateway = VirtualGateway(GatewayInfo(id_digits=2))
    codec = Codec(gateway.info)
    valve = Valve(gateway)
    async with sharing(valve) as shared:
        client = call(shared)
        await say(client, shared, b"K000001\r")
        valve.answers_pass = False
        # The window holds 128 requests, so that only a part of the writes fits.
        client.transport.write(b"H\r" * 50)
        await asyncio.sleep(0.001)
        client.transport.write(
            request_rows(codec, "W", 0, hex_rows(np.arange(0x0A00000000, 0x0A00000000 + 128), 10), SEED)
        )
        await asyncio.sleep(0.001)
        valve.answers_pass = True
        await tell_of_reset(shared, gateway, client)
        await settle(shared)
        frames = client.take().splitlines()
        assert frames[:50] == [b"X05"] * 50
        codes = [opened(codec, frame)[3:5] for frame in frames[50:]]
        sent = gateway.memory[0x0A] + 1
        assert codes == [b"05"] * sent + [b"0A"] * (128 - sent)
        assert 0 < sent < 128
        assert shared.turns._under_way == 0


@on_simulated_time
async def test_client_hears_of_a_reset_after_a_posted_write_and_during_an_absence() -> None:
    gateway = VirtualGateway()
    valve = Valve(gateway)
    async with sharing(valve) as shared:
        client = call(shared)
        await say(client, shared, b"K0000001\r")
        valve.requests_pass = False
        client.transport.write(b"ws0000A00000001\r")
        await asyncio.sleep(0.001)
        lose(shared)
        shared._gateway_was_reset(Interrupted(GatewayResetError("the gateway was reset")))
        client.transport.write(b"r0010A\r")
        await asyncio.sleep(0.01)
        assert client.take() == b"x00005\r\nx0010A0000\r\n"
        valve.requests_pass = True


@on_simulated_time
async def test_gateway_reset_on_an_open_line_ends_the_sessions_of_all_clients() -> None:
    gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=KILOHERTZ))
    async with sharing(gateway) as shared:
        client, other = call(shared), call(shared)
        await say(client, shared, b"K0000001\rw0000A00000001\rGS0001000A0110\rGN00\r")
        await say(other, shared, b"K0000001\r")
        gateway.reset()
        client.take()
        first = await say(client, shared, b"w0010A00000002\r")
        assert first in ([b"x00105"], [b"x0010A0000"])
        assert await say(client, shared, b"w0020A00000003\rGN00\r") == [b"x0020A0000", b"X06"]
        assert await say(other, shared, b"h000\r") == [b"x0000A0000"]
        assert gateway.memory[0x0A] == 1
        assert gateway.next_due is None
        assert await say(client, shared, b"K1000002\rw1000A00000004\r") == [b"K10000020000", b"w100"]
        assert gateway.memory[0x0A] == 4


class ResetBefore(Valve):
    """Resets a gateway just before the next frame that begins with `beginning`.

    Args:
        gateway: the gateway at the end of the line.
    """

    def __init__(self, gateway: VirtualGateway) -> None:
        super().__init__(gateway)
        self.beginning = b""
        """No reset if it is empty."""

    def receive(self, data: bytes, now: float) -> bytes:
        if self.beginning and self.beginning in data:
            self.beginning = b""
            self.gateway.reset()  # type: ignore[attr-defined]
        return super().receive(data, now)


@pytest.mark.parametrize("reset_before", [b"", b"Q", b"h", b"KF9AF", b"K000", b"gs"])
@on_simulated_time
async def test_reset_during_an_absence_ends_client_sessions_and_absence_alone_not(
    reset_before: bytes,
) -> None:
    was_reset = bool(reset_before)
    gateway = ResetBefore(VirtualGateway(GatewayInfo(base_frequency_millihertz=KILOHERTZ)))
    async with (
        sharing(gateway) as shared,
        PipedLink(shared, reconnect=Reconnect()) as link,
        link.subscribe([1], rate_hz=100) as subscription,
    ):
        before = await anext(subscription)
        lose(shared)
        gateway.beginning = reset_before
        await until(lambda: shared.connected)
        async with asyncio.timeout(60):
            sample = await anext(subscription)
            while was_reset and sample.epoch == 0:
                sample = await anext(subscription)
        await asyncio.sleep(2 * KEEP_ALIVE)
        assert link.statistics.reconnections == was_reset
        assert sample.time is not None
        assert before.time is not None
        assert sample.time > before.time

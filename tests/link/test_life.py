"""The life of a link: its opening, the calls that wait when it ends, and its reopening. Time is simulated."""

from __future__ import annotations

import asyncio
import contextlib
import gc
import itertools
import math
import random
import re
import tracemalloc
from typing import TYPE_CHECKING, Any

import anyio
import msgspec
import numpy as np
import pytest

import unity_link
from support.changed_lines import CHANGED_ENDS, CR_LF_FOR_CR, DIRECTIONS, OF_LINE_ENDS, ChangedLine
from support.makers import SLOW, Maker, in_flight, simulated
from support.recorded_bus import RecordedBus
from support.simulated_time import on_simulated_time
from support.valve import Valve, as_gateway, cut, numbers_in
from unity_link import (
    ArgumentError,
    BusTimeoutError,
    ConnectError,
    GatewayInfo,
    LinkClosedError,
    LinkLostError,
    Outcome,
    Sample,
    UnansweredError,
    UnsupportedError,
)
from unity_link.link.connection import Reconnect
from unity_link.protocol.host.handshake import LINE_ENDS
from unity_link.protocol.window.constants import MOST_TRIES
from unity_link.protocol.wire.configuration import PROTOCOL_VERSION, Feature
from unity_link.protocol.wire.crc import USUAL_POLYNOMIALS
from unity_link.protocol.wire.messages import Codec
from unity_link.transport import parse_url
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing, Noise, NoisyLine
from unity_link.virtual.gateway import Gateway
from unity_link.virtual.line import SlowLine
from unity_link.virtual.transport import GatewayTransport

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable

    from unity_link import Link

INFO = GatewayInfo(base_frequency_millihertz=1_000_000)


def test_impossible_pauses_are_refused_before_a_connection_is_lost() -> None:
    wrong: list[tuple[dict[str, Any], str]] = [
        ({"first_pause": "1"}, "first_pause is a number of seconds above 0, not '1'"),
        ({"first_pause": 0}, "first_pause is a number of seconds above 0, not 0"),
        ({"first_pause": math.nan}, "first_pause is a number of seconds above 0, not nan"),
        ({"longest_pause": -1}, "longest_pause is a number of seconds above 0, not -1"),
        ({"longest_pause": math.inf}, "longest_pause is a number of seconds above 0, not inf"),
        ({"give_up_after": "x"}, "give_up_after is a number of seconds from 0 on, or None, not 'x'"),
        ({"give_up_after": -5}, "give_up_after is a number of seconds from 0 on, or None, not -5"),
        ({"give_up_after": math.inf}, "give_up_after is a number of seconds from 0 on, or None, not inf"),
        ({"longest_pause": 1e10}, "longest_pause is a number of seconds above 0, 1e+09 at most, not 10000000000.0"),
    ]
    for options, message in wrong:
        with pytest.raises(ArgumentError) as caught:
            Reconnect(**options)
        assert str(caught.value) == message
    assert Reconnect(first_pause=0.5, give_up_after=1e9).longest_pause == 5


def now() -> float:
    return asyncio.get_running_loop().time()


def transport_under_test() -> asyncio.Transport:
    """Return the open transport of this loop's gateway, which is otherwise internal to the driver."""
    loop = asyncio.get_running_loop()
    found = [thing for thing in gc.get_objects() if isinstance(thing, GatewayTransport) and thing._loop is loop]
    return next(thing for thing in found if not thing.is_closing())


class Answering:
    """A peer that is no gateway; a function computes its answer to each read."""

    memory: dict[int, int]
    next_due = None
    leaves_time_out = False
    waiting = 0
    info = INFO
    open = Gateway.open

    def __init__(self, answer: Callable[[bytes], bytes]) -> None:
        self.answer = answer
        self.memory = {}
        self.wake: Callable[[], None] = lambda: None

    def receive(self, data: bytes, now: float) -> bytes:
        return self.answer(data)

    def advance(self, now: float, room: int | None = None) -> bytes:
        return b""


# Connecting


@on_simulated_time
async def test_the_error_without_an_answer_says_what_to_check() -> None:
    start = now()
    with pytest.raises(
        ConnectError, match=r"no gateway answered at .* within 3 s; nothing arrived: check that"
    ) as caught:
        await unity_link.connect(Answering(lambda _: b""), timeout=3)
    assert now() - start == pytest.approx(3)
    assert caught.value.__cause__ is None


@pytest.mark.slow
@on_simulated_time
async def test_noise_is_no_answer_and_the_error_counts_its_bytes() -> None:
    source = random.Random(1)
    with pytest.raises(ConnectError, match=r"within 60 s; \d+ bytes arrived, none of them an answer: check the speed"):
        await unity_link.connect(Answering(lambda _: source.randbytes(300)), timeout=60)


@pytest.mark.parametrize(("name", "direction"), CHANGED_ENDS)
@pytest.mark.parametrize("crc_bits", [8, 16, 32])
@on_simulated_time
async def test_a_line_that_changes_cr_or_lf_is_named(name: str, direction: str, crc_bits: int) -> None:
    gateway = VirtualGateway(GatewayInfo(crc_bits=crc_bits, crc_polynomial=USUAL_POLYNOMIALS[crc_bits]))
    with pytest.raises(ConnectError, match=re.escape(LINE_ENDS)):
        await unity_link.connect(ChangedLine(gateway, OF_LINE_ENDS[name], direction), timeout=2)


@pytest.mark.parametrize("direction", DIRECTIONS)
@on_simulated_time
async def test_a_line_that_turns_cr_into_cr_lf_does_no_harm(direction: str) -> None:
    # An empty frame is ignored.
    async with unity_link.connect(ChangedLine(VirtualGateway(), CR_LF_FOR_CR, direction), timeout=2) as link:
        await link.write(0x10, 5)
        assert await link.read(0x10) == 5


@pytest.mark.parametrize(("flip", "loss"), [(0.1, 0), (0.4, 0), (0, 0.2), (0.05, 0.1)])
@pytest.mark.parametrize("seed", range(5))
@on_simulated_time
async def test_a_noisy_line_is_not_taken_for_one_that_changes_line_ends(seed: int, flip: float, loss: float) -> None:
    noisy = NoisyLine(VirtualGateway(), *(Noise(number, flip=flip, loss=loss) for number in (seed, seed + 100)))
    with pytest.raises(ConnectError) as failure:
        await unity_link.connect(noisy, timeout=1)
    assert LINE_ENDS not in str(failure.value)


@pytest.mark.slow
@on_simulated_time
async def test_minutes_of_noise_take_no_memory(make_bare: Maker) -> None:
    for noise in (bytes(range(256)) * 40, b"\xff" * 10_000):
        valve = Valve(make_bare(**SLOW))
        async with unity_link.connect(valve) as link:
            assert link._flow.stream is not None
            stream = link._flow.stream
            stream.data_received(noise)
            tracemalloc.start()
            for _ in range(1000):
                stream.data_received(noise)
            grown, _ = tracemalloc.get_traced_memory()
            tracemalloc.stop()
            assert grown < 100_000
            assert len(link._session._rest) <= 16_384
            stream.data_received(b"\n")
            await link.write(1, 2)
            assert await link.read(1) == 2


def test_an_unclosed_link_causes_a_warning() -> None:
    async def forget() -> None:
        await (await unity_link.connect("sim:")).read(0)

    with pytest.warns(ResourceWarning, match="<link to sim:, connected> was not closed: use `async with`"):  # noqa: PT031  (the garbage is collected in it)
        asyncio.run(forget())
        gc.collect()


@on_simulated_time
async def test_the_error_on_a_line_that_echoes_names_the_echo() -> None:
    async def connect_to_echo() -> None:
        echo = SlowEcho()
        await unity_link.connect(echo, timeout=2)

    with pytest.raises(ConnectError, match="what is sent comes back as it is: is TX wired to RX"):
        await connect_to_echo()


class SlowEcho(Answering):
    """A line with a short circuit between its wires: each byte returns a little later."""

    def __init__(self) -> None:
        super().__init__(lambda data: b"")
        self._held = b""
        self._due: float | None = None

    @property
    def next_due(self) -> float | None:  # type: ignore[override]
        return self._due

    def receive(self, data: bytes, now: float) -> bytes:
        self._held += data
        self._due = now + 0.001
        return b""

    def advance(self, now: float, room: int | None = None) -> bytes:
        if self._due is None or now < self._due:
            return b""
        held, self._held, self._due = self._held, b"", None
        return held


@on_simulated_time
async def test_a_later_protocol_version_is_refused_with_what_to_install() -> None:
    later = b"%02X" % (PROTOCOL_VERSION + 1) + INFO.to_hex()[2:]
    with pytest.raises(UnsupportedError, match=rf"version {PROTOCOL_VERSION + 1:02X} of the protocol .* install one"):
        await unity_link.connect(Answering(lambda _: b"Q" + later + b"\r\n"))


@pytest.mark.parametrize(
    ("field", "value"),
    [("data_bits", 65), ("address_bits", 40), ("id_digits", 5), ("crc_bits", 12), ("base_frequency_millihertz", 0)],
)
@on_simulated_time
async def test_impossible_numbers_are_refused_with_their_value(field: str, value: int) -> None:
    answer = b"Q" + msgspec.structs.replace(INFO, **{field: value}).to_hex() + b"\r\n"
    with pytest.raises(UnsupportedError, match=f"{field} = {value}|{value} bits"):
        await unity_link.connect(Answering(lambda _: answer))


@on_simulated_time
async def test_fields_that_a_later_gateway_appends_are_ignored(make_bare: Maker) -> None:
    gateway = make_bare(**SLOW)

    def longer(data: bytes) -> bytes:
        answer = gateway.receive(data, now())
        if b"Q" in data:
            body = b"Q" + gateway.info.to_hex() + b"0123"
            framing = Codec(gateway.info).framing
            return framing.plain_reply(body) if data.endswith(b"\r") else framing.checked(body)
        return answer

    async with unity_link.connect(Answering(longer)) as link:
        assert link.gateway == gateway.info


@on_simulated_time
async def test_a_plain_answer_that_differs_from_the_checked_one_is_ignored(make_bare: Maker) -> None:
    gateway, lies = make_bare(**SLOW), 3

    def sometimes_lying(data: bytes) -> bytes:
        nonlocal lies
        if data.endswith(b"Q\r") and lies:
            lies -= 1
            return b"Q" + msgspec.structs.replace(gateway.info, build_id=lies).to_hex() + b"\r\n"
        return gateway.receive(data, now())

    async with unity_link.connect(Answering(sometimes_lying), timeout=60) as link:
        assert link.gateway == gateway.info


@pytest.mark.parametrize("frames", [0, 1, 2])
@on_simulated_time
async def test_a_connection_that_ends_in_the_handshake_raises_at_once(make_bare: Maker, frames: int) -> None:
    """The connection ends before both answers, after the plain Q, or after the checked Q."""
    gateway = Valve(make_bare(**SLOW))
    connecting = asyncio.ensure_future(connected(gateway))
    await asyncio.sleep(0)
    while gateway.heard.count(b"Q") + gateway.heard.count(b"K") < frames:  # noqa: ASYNC110  (turn by turn of the loop)
        await asyncio.sleep(0)
    transport_under_test().abort()
    start = now()
    with pytest.raises(ConnectError, match="the connection ended"):
        await connecting
    assert now() - start < 2


async def connected(gateway: Any) -> Link:
    return await unity_link.connect(gateway)


@on_simulated_time
async def test_a_cancelled_connect_leaves_no_task_or_connection() -> None:
    before = asyncio.all_tasks()
    with anyio.move_on_after(0.5) as scope:
        await unity_link.connect(Answering(lambda _: b""))
    assert scope.cancelled_caught
    assert asyncio.all_tasks() == before


@on_simulated_time
async def test_an_unfinished_frame_of_an_earlier_program_does_no_harm(make_bare: Maker) -> None:
    gateway = make_bare(**SLOW)
    gateway.receive(b"W0A0000", 0.0)
    async with unity_link.connect(gateway) as link:
        assert await link.read(0x0A) == 0


@on_simulated_time
async def test_samples_of_an_earlier_program_stop_with_the_new_session(make_bare: Maker) -> None:
    gateway = make_bare(**SLOW)
    gateway.receive(b"GS0001000101" + b"0A" + b"\rGN00\r", 0.0)
    async with unity_link.connect(gateway) as link:
        received = link.statistics.bytes_received
        await asyncio.sleep(1)
        assert link.statistics.bytes_received == received


@pytest.mark.parametrize(
    "url",
    [
        *["", "foo", "foo:bar", "/dev/ttyUSB0", "tcp"],
        *["sim:?data_bits=7", "sim:?colour=red", "sim:walle", "sim://host"],
        *["rtl:?data_bits=7", "rtl:?colour=red", "rtl:walle", "rtl://host", "rtl:?data_bits=33", "rtl:?node=6"],
    ],
)
@on_simulated_time
async def test_an_impossible_url_is_refused_with_one_clear_error(url: str) -> None:
    with pytest.raises(ArgumentError):
        await unity_link.connect(url)


@pytest.mark.parametrize(
    "url", ["sim:?node=0", "sim:?node=5", "sim:?node=0xFE", pytest.param("rtl:?node=5", marks=pytest.mark.rtl)]
)
@on_simulated_time
async def test_a_node_of_a_shared_medium_is_chosen_in_the_url(url: str) -> None:
    async with unity_link.connect(url) as link:
        assert Feature.ADDRESSED in link.gateway.features
        await link.write_many(range(100), range(100))
        assert (await link.read_many(range(100))).tolist() == list(range(100))
        async with link.subscribe([5]) as samples:
            await samples.publish()
            assert (await anext(samples)).values.tolist() == [5]


@pytest.mark.parametrize("node", ["-1", "255", "x"])
def test_an_impossible_node_is_refused_with_one_clear_error(node: str) -> None:
    with pytest.raises(ArgumentError, match=f"node={node}"):
        _ = parse_url(f"sim:?node={node}").node


# Closing

CALLS: dict[str, Callable[[Link], Awaitable[object]]] = {
    "read": lambda link: link.read(1),
    "write": lambda link: link.write(1, 2),
    "masked": lambda link: link.write_masked(1, 2, 3),
    "block": lambda link: link.read_block(0, 256),
    "written block": lambda link: link.write_block(0, range(256)),
    "queue": lambda link: link.read_queue(0, 300),
    "many": lambda link: link.read_many(range(256)),
    "written many": lambda link: link.write_many(range(256), range(256)),
    "fence": lambda link: link.fence(),
    "mode": lambda link: link.send_immediate("off"),
    "subscription": lambda link: link.subscribe([1]).__aenter__(),
}


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
@on_simulated_time
async def test_closing_a_link_raises_in_every_call_that_waits(
    make_bare: Maker, call: Callable[[Link], Awaitable[object]]
) -> None:
    gateway = Valve(make_bare(**SLOW))
    async with unity_link.connect(gateway) as link:
        gateway.answers_pass = False
        waiting = [asyncio.ensure_future(call(link)) for _ in range(3)]
        await asyncio.sleep(0)
    for error in await asyncio.gather(*waiting, return_exceptions=True):
        assert isinstance(error, LinkClosedError)
    with pytest.raises(LinkClosedError, match="known not to be executed"):
        await call(link)


@on_simulated_time
async def test_a_link_closed_twice_or_by_two_tasks_ends_once(make_bare: Maker) -> None:
    link = await unity_link.connect(make_bare(**SLOW))
    await asyncio.gather(link.aclose(), link.aclose())
    await link.aclose()


@on_simulated_time
async def test_a_link_has_no_task_while_it_is_open_or_afterwards(make_bare: Maker) -> None:
    before = asyncio.all_tasks()
    async with (
        unity_link.connect(make_bare(**SLOW), reconnect=True) as link,
        link.subscribe([0], rate_hz=100) as samples,
    ):
        await link.read_many(range(100))
        await anext(samples)
        assert asyncio.all_tasks() == before
        cut(link)
        await asyncio.sleep(0)
    await asyncio.sleep(0)
    assert asyncio.all_tasks() == before


# Cancellation


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
@pytest.mark.parametrize("style", ["asyncio", "anyio", "task"])
@on_simulated_time
async def test_a_cancelled_call_does_not_disturb_the_others(
    make_bare: Maker, call: Callable[[Link], Awaitable[object]], style: str
) -> None:
    gateway = Valve(make_bare(**SLOW))
    async with unity_link.connect(gateway) as link:
        await link.write(0x70, 77)
        gateway.requests_pass = False
        before = [asyncio.ensure_future(link.read(0x70)) for _ in range(5)]
        await asyncio.sleep(0)
        victim: asyncio.Future[object] | None = None
        if style == "task":
            victim = asyncio.ensure_future(call(link))
        elif style == "asyncio":
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(0.02):
                    await call(link)
        else:
            with anyio.move_on_after(0.02):
                await call(link)
        after = [asyncio.ensure_future(link.read(0x70)) for _ in range(5)]
        await asyncio.sleep(0.02)
        if victim is not None:
            victim.cancel()
        gateway.requests_pass = True
        assert await asyncio.gather(*before, *after) == [77] * 10
        assert await link.read(0x70) == 77


@on_simulated_time
async def test_a_cancelled_write_that_was_lost_is_not_executed(
    make_bare: Maker,
) -> None:
    model = make_bare(**SLOW)
    bus, gateway = RecordedBus(model), Valve(model)
    async with unity_link.connect(gateway) as link:
        gateway.requests_pass = False
        with anyio.move_on_after(0.001):
            await link.write(1, 1)
        other = asyncio.ensure_future(link.write(2, 2))
        await asyncio.sleep(0)
        gateway.requests_pass = True
        await other
        await link.write(3, 3)
    assert bus.writes == [(2, 2), (3, 3)]


@pytest.mark.slow
@on_simulated_time
async def test_a_posted_write_cancelled_while_it_waits_for_space_is_not_sent(make_bare: Maker) -> None:
    model = make_bare(**SLOW)
    bus, gateway = RecordedBus(model), Valve(model)
    async with unity_link.connect(gateway) as link:
        gateway.requests_pass = False
        count = 2 * in_flight(link.gateway)
        posts = [asyncio.ensure_future(link.post(1, value)) for value in range(count)]
        await asyncio.sleep(0)
        waiting = [post for post in posts if not post.done()]
        assert 0 < len(waiting) < count
        for post in waiting[::2]:
            post.cancel()
        gateway.requests_pass = True
        await asyncio.gather(*posts, return_exceptions=True)
        await link.fence()
    assert [value for _, value in bus.writes] == [value for value, post in enumerate(posts) if not post.cancelled()]


@on_simulated_time
async def test_the_rest_of_a_cancelled_batch_is_not_sent(make_bare: Maker) -> None:
    model = make_bare(**SLOW)
    bus = RecordedBus(model)
    async with unity_link.connect(SlowLine(model, 10_000)) as link:
        with anyio.move_on_after(0.1):
            await link.write_many([1] * 10_000, range(10_000))
        await link.fence()
    assert 0 < len(bus.writes) < 5000
    assert bus.writes == [(1, value) for value in range(len(bus.writes))]


# A lost connection


@on_simulated_time
async def test_a_silent_gateway_ends_the_link_after_a_bounded_number_of_tries(make_bare: Maker) -> None:
    gateway = Valve(make_bare(**SLOW))
    async with unity_link.connect(gateway) as link:
        gateway.requests_pass = gateway.answers_pass = False
        with pytest.raises(LinkLostError, match=r"does not answer any more: .*; the request is perhaps executed"):
            await link.read(0)
        assert now() < 60
        with pytest.raises(LinkLostError, match="known not to be executed"):
            await link.read(0)


@on_simulated_time
async def test_a_link_that_receives_only_samples_ends_too() -> None:
    # Minutes of samples: only the model produces them quickly enough, and the link cannot distinguish it from gateware.
    gateway = Valve(simulated(**SLOW))
    async with unity_link.connect(gateway) as link, link.subscribe([0], rate_hz=100) as samples:
        gateway.requests_pass = False
        calls = [asyncio.ensure_future(link.read(address)) for address in range(3)]
        errors = await asyncio.gather(*calls, return_exceptions=True)
        assert all(isinstance(error, UnansweredError) for error in errors)
        assert isinstance(errors[-1], LinkLostError)
        with pytest.raises(LinkLostError):
            async for _ in samples:
                pass


@on_simulated_time
async def test_a_request_that_is_always_damaged_is_given_up_and_others_go_on(make_bare: Maker) -> None:
    class Hole(Valve):
        def receive(self, data: bytes, now: float) -> bytes:
            frames = data.splitlines(keepends=True)
            return super().receive(b"".join(f[:-2] + b"?\n" if f.startswith(b"w") else f for f in frames), now)

    async with unity_link.connect(Hole(make_bare(**SLOW))) as link:
        write = asyncio.ensure_future(link.write(1, 2))
        await asyncio.sleep(0)
        read = asyncio.ensure_future(link.read(1))
        with pytest.raises(UnansweredError, match="write at 0x01: every try was damaged") as caught:
            await write
        assert caught.value.outcome is Outcome.UNKNOWN
        assert await read == 0
        assert link.statistics.timeouts <= 2 * MOST_TRIES


@on_simulated_time
async def test_the_error_for_a_request_unknown_to_the_gateway_names_it(make_bare: Maker) -> None:
    class Older(Valve):
        def receive(self, data: bytes, now: float) -> bytes:
            refusal = Codec(self.info).framing.checked(b"X02")
            frames = data.splitlines(keepends=True)
            answers = [refusal if frame[:2] == b"wk" else super(Older, self).receive(frame, now) for frame in frames]
            return b"".join(answers)

    async with unity_link.connect(Older(make_bare(**SLOW))) as link:
        calls = [link.write_masked(1, 2, 3), link.read(1), link.write(1, 5)]
        masked, read, written = await asyncio.gather(*calls, return_exceptions=True)
        assert isinstance(masked, UnsupportedError)
        assert "masked write at 0x01: the gateway refuses the request with error 02" in str(masked)
        assert (read, written) == (0, None)


@on_simulated_time
async def test_the_errors_of_a_lost_connection_have_the_outcome_of_each_request(make_bare: Maker) -> None:
    model = make_bare(**SLOW)
    bus, gateway = RecordedBus(model), Valve(model)
    async with unity_link.connect(gateway) as link:
        gateway.answers_pass = False
        executed = asyncio.ensure_future(link.write(1, 1))
        await asyncio.sleep(0)
        await asyncio.sleep(0)
        # The gateway reports by `n` that it has executed the first write; the second write is lost.
        gateway.requests_pass = False
        unknown = asyncio.ensure_future(link.write(2, 2))
        await asyncio.sleep(0)
        await asyncio.sleep(0)
        assert link._flow.stream is not None
        codec = link._session.codec
        expected = numbers_in(gateway.heard, gateway.info)[0] + 1 & codec.id_count - 1
        link._flow.stream.data_received(as_gateway(codec, codec.out_of_sequence(expected)))
        waiting = [asyncio.ensure_future(link.write(3, value)) for value in range(2 * in_flight(link.gateway))]
        await asyncio.sleep(0)
        cut(link)
        errors = await asyncio.gather(executed, unknown, *waiting, return_exceptions=True)
    assert all(isinstance(error, LinkLostError) for error in errors)
    outcomes = [error.outcome for error in errors if isinstance(error, LinkLostError)]
    assert outcomes[:2] == [Outcome.EXECUTED, Outcome.UNKNOWN]
    assert outcomes[-1] is Outcome.NOT_EXECUTED
    assert bus.writes == [(1, 1)]


@pytest.mark.parametrize("answers_pass", [True, False])
@pytest.mark.parametrize(
    "call",
    [lambda link: link.write_many([1] * 5000, [1] * 5000), lambda link: link.write_queue(0, [0] * 255 * 150)],
    ids=["batch", "queue"],
)
@on_simulated_time
async def test_the_outcome_of_a_batch_cut_in_the_middle_is_unknown(
    make_bare: Maker, call: Callable[[Link], Awaitable[object]], answers_pass: bool
) -> None:
    line = Valve(SlowLine(make_bare(**SLOW), 20_000))
    async with unity_link.connect(line) as link:
        line.answers_pass = answers_pass
        waiting = asyncio.ensure_future(call(link))
        await asyncio.sleep(0.008)
        cut(link)
        with pytest.raises(LinkLostError, match="perhaps executed"):
            await waiting


@on_simulated_time
async def test_posted_writes_in_flight_raise_in_the_waiting_fence(make_bare: Maker) -> None:
    gateway = Valve(make_bare(**SLOW))
    async with unity_link.connect(gateway) as link:
        gateway.requests_pass = False
        await link.post(1, 1)
        fence = asyncio.ensure_future(link.fence())
        await asyncio.sleep(0)
        cut(link)
        with pytest.raises(LinkLostError):
            await fence
        await link.aclose()


@on_simulated_time
async def test_a_subscription_ends_after_the_samples_from_before_the_loss(make_bare: Maker) -> None:
    async with unity_link.connect(make_bare(**SLOW)) as link, link.subscribe([0], rate_hz=100) as samples:
        await asyncio.sleep(0.105)
        cut(link)
        await asyncio.sleep(0)
        seen: list[Sample] = []

        async def read() -> None:
            async for sample in samples:
                seen.append(sample)  # noqa: PERF401  (it ends with an error)

        with pytest.raises(LinkLostError, match="the other side closed the connection"):
            await read()
        assert len(seen) in (10, 11)


# Reconnection


@on_simulated_time
async def test_reads_and_unsent_requests_are_sent_after_a_reconnection(make_bare: Maker) -> None:
    model = make_bare(**SLOW)
    bus, gateway = RecordedBus(model), Valve(model)
    async with unity_link.connect(gateway, reconnect=True) as link:
        await link.write(1, 11)
        gateway.requests_pass = False
        calls: list[Awaitable[Any]] = [
            link.read(1),
            link.read_block(0, 3),
            link.read_many([1] * 100),
            link.write(2, 22),
        ]
        calls += [link.write(3, value) for value in range(in_flight(link.gateway))]
        waiting = [asyncio.ensure_future(call) for call in calls]
        await asyncio.sleep(0)
        cut(link)
        gateway.requests_pass = True
        read, block, many, *writes = await asyncio.gather(*waiting, return_exceptions=True)
        assert read == 11
        assert isinstance(block, np.ndarray)
        assert isinstance(many, np.ndarray)
        assert (block.tolist(), many.tolist()) == ([0, 11, 0], [11] * 100)
        unknown = [error.outcome for error in writes if isinstance(error, LinkLostError)]
        assert set(unknown) == {Outcome.UNKNOWN}
        assert 0 < len(unknown) < len(writes)
        sent = [value for value, error in enumerate(writes[1:]) if error is None]
        assert bus.writes == [(1, 11), *((3, value) for value in sent)]
        assert link.statistics.reconnections == 1
        assert await link.read(1) == 11


@on_simulated_time
async def test_subscriptions_are_set_up_again_and_continue_to_count(make_bare: Maker) -> None:
    async with (
        unity_link.connect(make_bare(**SLOW), reconnect=True) as link,
        link.subscribe([0], rate_hz=100) as samples,
    ):
        for _ in range(3):
            first = await anext(samples)
            cut(link)
            second = await anext(samples)
            third = await anext(samples)
            assert second.sequence > first.sequence
            assert third.sequence == second.sequence + 1
        assert link.statistics.reconnections == 3


@on_simulated_time
async def test_pauses_between_attempts_double_up_to_the_longest(make_bare: Maker) -> None:
    gateway = Valve(make_bare(**SLOW))
    times: list[float] = []

    class Refusing(Valve):
        def receive(self, data: bytes, now: float) -> bytes:
            times.append(now)
            return super().receive(data, now)

    gateway = Refusing(gateway)
    options = Reconnect(first_pause=1, longest_pause=8, give_up_after=200)
    async with unity_link.connect(gateway, reconnect=options) as link:
        gateway.requests_pass = False
        read = asyncio.ensure_future(link.read(0))
        await asyncio.sleep(0)
        times.clear()
        cut(link)
        with pytest.raises(LinkLostError, match="no reconnection succeeded"):
            await read
        assert now() == pytest.approx(200, abs=1)
        with pytest.raises(LinkLostError):
            await link.read(0)
        assert link.statistics.reconnections == 0
    assert len(times) > 10


@on_simulated_time
@pytest.mark.parametrize("seconds", [0.05, 0.5, 7.0])
async def test_reconnection_is_given_up_after_the_given_time(make_bare: Maker, seconds: float) -> None:
    gateway = Valve(make_bare(**SLOW))
    options = Reconnect(first_pause=0.02, give_up_after=seconds)
    async with unity_link.connect(gateway, reconnect=options) as link:
        gateway.requests_pass = False
        cut(link)
        began = now()
        with pytest.raises(LinkLostError, match="no reconnection succeeded"):
            await link.read(0)
        assert now() - began == pytest.approx(seconds, abs=0.03)


@on_simulated_time
async def test_a_reconnection_attempt_has_the_time_of_the_first_attempt(
    make_bare: Maker,
) -> None:
    line = SlowLine(make_bare(**SLOW), bytes_per_second=400)
    async with unity_link.connect(line, reconnect=Reconnect(first_pause=0.02, longest_pause=0.1)) as link:
        began = now()
        cut(link)
        async with asyncio.timeout(60):
            await link.read(0)
        assert 0.1 < now() - began < 2
        assert link.statistics.reconnections == 1


class Dying(Valve):
    """Accepts each connection, and loses it after a given time.

    Args:
        gateway: gateway that the connections lead to.
        lives: seconds that successive connections last; later ones last without a limit.
    """

    def __init__(self, gateway: Gateway, lives: list[float]) -> None:
        super().__init__(gateway)
        self.lives = [*lives]
        self.opened: list[float] = []

    async def open(self, protocol: asyncio.Protocol) -> asyncio.Transport:
        self.opened.append(now())
        transport = await super().open(protocol)
        if self.lives:
            asyncio.get_running_loop().call_later(self.lives.pop(0), transport.abort)
        return transport


@on_simulated_time
async def test_pauses_grow_if_new_connections_are_lost_at_once(
    make_direct: Maker,
) -> None:
    at_once, lasting = [0.01] * 8, [30.0]
    gateway = Dying(make_direct(), [1.0, *at_once, *lasting])
    async with unity_link.connect(gateway, reconnect=Reconnect(first_pause=0.1, longest_pause=2)) as link:
        await asyncio.sleep(60)
        assert await link.read(0) == 0
        assert link.statistics.reconnections == 10
        # A random pause of up to 0.1 s is added to each of these.
        pauses = [after - before for before, after in itertools.pairwise(gateway.opened)]
    assert pauses[0] == pytest.approx(1, abs=0.01)
    for pause, doubled in zip(pauses[1:9], [0.1, 0.2, 0.4, 0.8, 1.6, 2, 2, 2], strict=True):
        assert doubled < pause < doubled + 0.12
    assert pauses[9] == pytest.approx(30, abs=0.01)


@on_simulated_time
@pytest.mark.parametrize("error", [KeyError("idle_for"), RuntimeError("no such device"), asyncio.CancelledError()])
async def test_an_unexpected_error_of_an_attempt_is_logged_and_retried(
    make_direct: Maker, error: BaseException, caplog: pytest.LogCaptureFixture
) -> None:
    class Failing(Dying):
        async def open(self, protocol: asyncio.Protocol) -> asyncio.Transport:
            if len(self.opened) in (1, 2):
                self.opened.append(now())
                raise error
            return await super().open(protocol)

    gateway = Failing(make_direct(), [])
    async with unity_link.connect(gateway, reconnect=True) as link:
        cut(link)
        assert await link.read(0) == 0
        assert link.statistics.reconnections == 1
        assert len(gateway.opened) == 4
        told = [record for record in caplog.records if record.levelname == "ERROR"]
        # A CancelledError from the driver's task is an error of the driver: the link itself was not cancelled.
        is_told = isinstance(error, Exception)
        assert [record.exc_info and record.exc_info[1] for record in told] == [error] * (2 if is_told else 0)


@on_simulated_time
async def test_calls_that_are_given_up_while_the_gateway_is_away_are_not_kept(make_bare: Maker) -> None:
    gateway = Valve(make_bare(**SLOW))
    async with unity_link.connect(gateway, reconnect=True) as link:
        gateway.requests_pass = False
        cut(link)
        kept = [asyncio.ensure_future(link.read(address)) for address in range(100)]
        for _ in range(1000):
            with pytest.raises(TimeoutError):
                async with asyncio.timeout(0.01):
                    await asyncio.gather(link.read(0), link.read_many(range(20)), link.write_block(0, range(9)))
        assert len(link._session._waiting) <= 2 * len(kept) + 3
        gateway.requests_pass = True
        assert await asyncio.gather(*kept) == [0] * 100


@on_simulated_time
async def test_a_different_gateway_after_the_reconnection_ends_the_link(make_bare: Maker) -> None:
    gateway = Valve(make_bare(**SLOW))
    async with unity_link.connect(gateway, reconnect=True) as link:
        gateway.gateway = make_bare(build_id=0xCAFE)
        cut(link)
        with pytest.raises(LinkLostError, match="another gateway answers after the reconnection"):
            await link.read(0)


@on_simulated_time
async def test_a_connection_lost_repeatedly_during_set_up_recovers(
    make_bare: Maker,
) -> None:
    gateway = Valve(make_bare(**SLOW))
    async with (
        unity_link.connect(gateway, reconnect=True) as link,
        link.subscribe([0], rate_hz=100) as one,
        link.subscribe([1], rate_hz=100) as other,
    ):
        for delay in range(40):
            cut(link)
            await asyncio.sleep(0.1 * delay / 3)
            for _ in range(delay):
                await asyncio.sleep(0)
            if link._flow.stream is not None and not link._flow.stream._transport.is_closing():  # type: ignore[union-attr]
                cut(link)
            await link.read(0)
            await anext(one)
            await anext(other)


@on_simulated_time
@pytest.mark.parametrize("turns", range(12))
async def test_a_subscription_that_begins_when_the_gateway_goes_away_waits_for_it(make_bare: Maker, turns: int) -> None:
    gateway = Valve(make_bare(**SLOW))
    async with unity_link.connect(gateway, reconnect=True) as link:
        # The gateway disappears before, while and after each of the requests is in flight.
        beginning = asyncio.ensure_future(link.subscribe([0], rate_hz=100).__aenter__())
        for _ in range(turns):
            await asyncio.sleep(0)
        gateway.requests_pass = False
        cut(link)
        await asyncio.sleep(3)
        gateway.requests_pass = True
        samples = await beginning
        # The first sample may have arrived before the loss.
        _, second, third = [await anext(samples) for _ in range(3)]
        assert third.sequence == second.sequence + 1
        assert link.statistics.reconnections == 1
        await samples.__aexit__(None, None, None)


@on_simulated_time
async def test_a_subscription_that_begins_when_the_link_ends_raises(make_bare: Maker) -> None:
    gateway = Valve(make_bare(**SLOW))
    options = Reconnect(give_up_after=10)
    for reconnect in (False, options):
        gateway.requests_pass = True
        async with unity_link.connect(gateway, reconnect=reconnect) as link:
            gateway.requests_pass = False
            beginning = asyncio.ensure_future(link.subscribe([0], rate_hz=100).__aenter__())
            await asyncio.sleep(0)
            cut(link)
            with pytest.raises(LinkLostError):
                await beginning


@on_simulated_time
async def test_a_subscription_may_end_while_the_link_is_down(make_bare: Maker) -> None:
    gateway = make_bare(**SLOW, groups=4)
    async with unity_link.connect(gateway, reconnect=True) as link:
        for _ in range(3):
            async with link.subscribe([0], rate_hz=10) as samples:
                await anext(samples)
                gateway.reset()
                cut(link)
                await asyncio.sleep(0)
            await link.read(0)
            received = link.statistics.bytes_received
            await asyncio.sleep(1)
            assert link.statistics.bytes_received == received


@on_simulated_time
async def test_a_subscription_ends_even_if_the_gateway_is_silent(make_bare: Maker) -> None:
    gateway = Valve(make_bare(**SLOW))
    async with unity_link.connect(gateway, reconnect=True) as link:
        waiting = []
        async with link.subscribe([0], rate_hz=10) as samples:
            await anext(samples)
            gateway.requests_pass = False
            # More requests than may be in flight: the one that stops the group waits after them.
            waiting = [asyncio.ensure_future(link.read(0)) for _ in range(1000)]
            await asyncio.sleep(0)
        assert not link.connected
        gateway.requests_pass = True
        # The link gave up some requests before it was lost.
        outcomes = await asyncio.gather(*waiting, return_exceptions=True)
        assert outcomes.count(0) > 900
        assert await link.read(0) == 0


@on_simulated_time
async def test_closing_while_the_link_is_down_raises_in_waiting_calls(make_bare: Maker) -> None:
    gateway = Valve(make_bare(**SLOW))
    async with unity_link.connect(gateway, reconnect=True) as link:
        gateway.requests_pass = False
        cut(link)
        await asyncio.sleep(0.01)
        read = asyncio.ensure_future(link.read(0))
        await asyncio.sleep(3)
    with pytest.raises(LinkClosedError):
        await read


# A bad line


@pytest.mark.slow
@on_simulated_time
async def test_ten_thousand_requests_finish_with_one_percent_of_bytes_damaged(make_bare: Maker) -> None:
    gateway = NoisyLine(make_bare(**SLOW), Noise(20, flip=0.01), Noise(21, flip=0.01))
    async with unity_link.connect(gateway, timeout=600) as link:

        async def work(task: int) -> None:
            source, address, expected, masked = random.Random(task), 8 * task, 0, 0
            for step in range(250):
                kind = source.randrange(6)
                if kind == 0:
                    expected = step
                    await link.write(address, step)
                elif kind == 1:
                    assert await link.read(address) == expected
                elif kind == 2:
                    await link.write_block(address + 1, [step, task, 7])
                    assert (await link.read_block(address + 1, 3)).tolist() == [step, task, 7]
                elif kind == 3:
                    expected = step
                    await link.post(address, step)
                elif kind == 4:
                    assert await link.write_masked(address + 5, step, 0xFF) == masked
                    masked = step
                else:
                    assert (await link.read_queue(address + 6, 2)).tolist() == [0, 0]
            await link.fence()

        await asyncio.gather(*(work(task) for task in range(31)))
        await link.write_many([0] * 2000, range(2000))
        assert (await link.read_many([0] * 1000)).tolist() == [1999] * 1000
        assert link.statistics.requests > 10_000
        assert link.statistics.damaged_frames > 500


@pytest.mark.parametrize("bytes_per_second", [960, 11_520, 100_000])
@on_simulated_time
async def test_a_link_waits_for_long_answers_on_a_line_of_unknown_speed(
    make_bare: Maker, bytes_per_second: int
) -> None:
    async with unity_link.connect(SlowLine(make_bare(**SLOW), bytes_per_second), timeout=60) as link:
        blocks = await asyncio.gather(*(link.read_block(0, 255) for _ in range(20)))
        assert [len(block) for block in blocks] == [255] * 20
        assert link.statistics.repetitions == 0


@on_simulated_time
async def test_leaving_the_block_of_a_link_waits_for_its_posted_writes(make_bare: Maker) -> None:
    model = make_bare(**SLOW)
    bus = RecordedBus(model)
    async with unity_link.connect(model) as link:
        for value in range(500):
            await link.post(1, value)
    assert [value for _, value in bus.writes] == list(range(500))


@on_simulated_time
async def test_leaving_the_block_of_a_link_raises_the_errors_of_its_posted_writes(make_bare: Maker) -> None:
    model = make_bare(**SLOW)
    model.attach(Failing(), [1])
    with pytest.raises(BusTimeoutError, match="posted write at 0x01"):
        async with unity_link.connect(model) as link:
            await link.post(1, 2)


@on_simulated_time
async def test_bytes_are_counted_exactly(make_bare: Maker) -> None:
    async with unity_link.connect(make_bare(**SLOW)) as link:
        before = link.statistics
        await link.read_many(range(100))
        after = link.statistics
        assert after.bytes_sent == before.bytes_sent + 100 * len("riiiAAcccc\n")
        assert after.bytes_received == before.bytes_received + 100 * len("riiiDDDDDDDDcccc\n")
        assert (after.repetitions, after.stray_frames) == (0, 0)


SOUND = [
    "r{other}00000000",
    "w{other}",
    "r{short}",
    "r{wrong}00000000",
    "n{short}",
    "x{other}04",
    "Q00",
    "K{own}",
    "XX",
    "X77",
    "P9900",
    "",
    "R",
]
"""Bodies with the ID of a request in flight, with another ID, with one that is too short, and with no valid ID."""


async def connected_with_ids(gateway: Valve) -> tuple[Link, list[bytes]]:
    """Return a link, and the IDs that its next requests will have."""
    link = await unity_link.connect(gateway)
    await link.write(2, 0)
    codec = Codec(gateway.info)
    last = numbers_in(gateway.heard, gateway.info)[-1]
    return link, [codec.id_text[last + ahead & codec.id_count - 1] for ahead in range(1, codec.id_count // 2)]


@pytest.mark.parametrize("body", SOUND)
@on_simulated_time
async def test_a_valid_frame_without_a_request_does_no_harm(make_bare: Maker, body: str) -> None:
    link, ids = await connected_with_ids(Valve(make_bare(**SLOW)))
    async with link:
        assert link._flow.stream is not None
        write = asyncio.ensure_future(link.write(1, 5))
        await asyncio.sleep(0)
        texts = {"own": ids[0], "other": ids[0x50], "short": ids[0][:-1], "wrong": b"G" * len(ids[0])}
        sent = body.format_map({name: text.decode() for name, text in texts.items()})
        link._flow.stream.data_received(as_gateway(link._session.codec, sent.encode()))
        link._flow.stream.data_received(b"\n\r\n")
        await write
        assert await link.read(1) == 5


@on_simulated_time
async def test_an_unknown_error_code_is_raised_with_its_number(make_bare: Maker) -> None:
    link, ids = await connected_with_ids(Valve(make_bare(**SLOW)))
    async with link:
        assert link._flow.stream is not None
        write = asyncio.ensure_future(link.write(1, 5))
        await asyncio.sleep(0)
        link._flow.stream.data_received(as_gateway(link._session.codec, b"x" + ids[0] + b"00"))
        with pytest.raises(unity_link.GatewayError, match="answered error 00"):
            await write
        assert await link.read(1) == 5


@on_simulated_time
async def test_an_answer_of_another_length_or_command_is_ignored(make_bare: Maker) -> None:
    valve = Valve(make_bare(**SLOW))
    link, (first, second, *_) = await connected_with_ids(valve)
    async with link:
        assert link._flow.stream is not None
        valve.answers_pass = False
        read = asyncio.ensure_future(link.read(1))
        many = asyncio.ensure_future(link.read_many(range(3)))
        await asyncio.sleep(0)
        bodies = [b"r%b0000000", b"w%b", b"r%bGGGGGGGG"]
        for body in [*(body % first for body in bodies), *(body % second for body in bodies)]:
            link._flow.stream.data_received(as_gateway(link._session.codec, body))
        assert not read.done()
        valve.answers_pass = True
        assert await read == 0
        assert (await many).tolist() == [0, 0, 0]
        assert link.statistics.stray_frames == 6


@on_simulated_time
async def test_the_end_of_a_link_is_no_error_of_a_subscription_left_by_a_cancel(
    make_direct: Maker,
) -> None:
    valve = Valve(make_direct(**SLOW))
    complaints: list[str] = []
    asyncio.get_running_loop().set_exception_handler(lambda _, context: complaints.append(context["message"]))
    async with unity_link.connect(valve) as link:
        samples = link.subscribe([1], rate_hz=100)
        await samples.__aenter__()
        valve.answers_pass = False
        with pytest.raises(TimeoutError):
            async with asyncio.timeout(0.001):
                await samples.__aexit__(None, None, None)
    gc.collect()
    assert complaints == []

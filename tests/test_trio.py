"""A link under trio: the same calls and guarantees, in an ``async with`` block.

The tests of links run on it as well (tests/support/faces.py).
"""

import gc
from collections.abc import AsyncIterator, Awaitable, Callable, Iterator
from contextlib import asynccontextmanager
from pathlib import Path

import pytest
import trio
from anyio.from_thread import start_blocking_portal

import unity_link
from unity_link import UnsupportedError
from unity_link.data import Group
from unity_link.errors import first_error
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.spec import compile_text
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing
from unity_link.virtual.line import SlowLine
from unity_link.virtual.serving import serve_pty, serve_tcp, serve_udp, serve_unix

ROBOT = unity_link.load(
    compile_text("""
    group state(RATE=1000);
    public robot() {
      @word = 1: READWRITE(PUBLISH(state));
      @wide = 2: unsigned 64 READWRITE();
    }
    """)
)


def run(program: Callable[[], Awaitable[object]]) -> None:
    """Run a program under trio, for at most a minute."""

    async def limited() -> None:
        with trio.fail_after(60):
            await program()

    trio.run(limited)


@pytest.fixture(params=["unix", "tcp", "udp", "pty"])
def served(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[str]:
    """Serve a gateway in the event loop of another thread; yield its URL."""

    @asynccontextmanager
    async def serving() -> AsyncIterator[str]:
        gateway = VirtualGateway()
        ways = {"unix": lambda: serve_unix(gateway, tmp_path / "gateway"), "udp": lambda: serve_udp(gateway, port=0)}
        ways |= {"tcp": lambda: serve_tcp(gateway, port=0), "pty": lambda: serve_pty(gateway)}
        async with ways[request.param]() as url:
            yield url

    with start_blocking_portal() as portal, portal.wrap_async_context_manager(serving()) as url:
        yield url


def test_words_blocks_batches_and_samples_work_on_every_medium(served: str) -> None:
    async def program() -> None:
        async with unity_link.connect(served) as link:
            await link.write(0x0A, 0x12)
            assert await link.read(0x0A) == 0x12
            await link.write_block(0x20, range(64))
            assert (await link.read_many(range(0x20, 0x60))).tolist() == list(range(64))
            async with link.subscribe([0x0A], rate_hz=500) as samples:
                taken = [await anext(samples) for _ in range(20)]
            assert [sample.sequence for sample in taken] == list(range(20))
            await link.post(0x30, 7)
        async with unity_link.connect(served) as link:
            assert await link.read(0x30) == 7

    run(program)


def test_tasks_of_a_nursery_share_a_link(served: str) -> None:
    async def program() -> None:
        async with unity_link.connect(served) as link, trio.open_nursery() as nursery:

            async def work(address: int) -> None:
                for value in range(20):
                    await link.write(address, value)
                    assert await link.read(address) == value

            for address in range(32):
                nursery.start_soon(work, address)

    run(program)


def test_a_call_that_is_cancelled_leaves_the_others_as_they_are() -> None:
    async def program() -> None:
        async with unity_link.connect(SlowLine(VirtualGateway(), 20_000)) as link:
            with trio.move_on_after(0.02) as scope:
                await link.read_block(0, 200)
            assert scope.cancelled_caught
            await link.write(1, 5)
            assert await link.read(1) == 5

    run(program)


def test_a_group_that_is_cancelled_leaves_no_coroutine_that_never_ran(recwarn: pytest.WarningsRecorder) -> None:
    async def program() -> None:
        async with unity_link.connect(SlowLine(VirtualGateway(), 300)) as link:
            robot = ROBOT(link)
            for work in (Group(robot.word, robot.wide).get(), Group(robot.word, robot.wide).set([1, 2])):
                with trio.move_on_after(0.02) as scope:
                    await work
                assert scope.cancelled_caught

    run(program)
    gc.collect()
    assert not recwarn.list


def test_samples_over_several_gateways_are_refused_in_a_sentence() -> None:
    async def program() -> None:
        async with (
            unity_link.connect(VirtualGateway()) as left,
            unity_link.connect(VirtualGateway()) as right,
        ):
            group = Group(ROBOT(left).word, ROBOT(right).word)
            await group.set([1, 2])
            assert list((await group.get()).values()) == [1, 2]
            with pytest.raises(UnsupportedError, match=r"^samples of several gateways need asyncio"):
                async with group.subscribe(rate_hz=100):
                    pass

    run(program)


def test_callback_cancelled_at_once_does_not_affect_the_next_one() -> None:
    async def program() -> None:
        async with unity_link.connect(VirtualGateway()) as link:
            state = ROBOT(link).groups["state"]
            sequences: list[int] = []
            state.on_sample(lambda _: None).cancel()
            with state.on_sample(lambda sample: sequences.append(sample.sequence)):
                await trio.sleep(0.1)
                with state.on_sample(lambda _: None):
                    await trio.sleep(0.1)
            await trio.sleep(0.1)
            assert len(sequences) > 10
            assert sequences == list(range(len(sequences)))
            samples = link.statistics.samples
            await trio.sleep(0.1)
            assert link.statistics.samples == samples, "no sample is published without a subscriber"

    run(program)


def test_error_in_the_block_is_raised_unchanged() -> None:
    async def program() -> None:
        with pytest.raises(ZeroDivisionError):
            async with unity_link.connect("sim:"):
                raise ZeroDivisionError
        with pytest.raises(unity_link.ConnectError, match="is it listening"):
            async with unity_link.connect("tcp://127.0.0.1:1"):
                pass

    run(program)


def test_connect_without_a_block_is_an_error_that_asks_for_async_with() -> None:
    async def program() -> None:
        with pytest.raises(unity_link.ArgumentError, match="write `async with"):
            await unity_link.connect("sim:")

    run(program)


def test_a_lost_connection_is_opened_again(tmp_path: Path) -> None:
    gateway = VirtualGateway()
    path = tmp_path / "gateway"

    async def program() -> None:
        with start_blocking_portal() as portal:
            first = portal.wrap_async_context_manager(serve_unix(gateway, path))
            url = await trio.to_thread.run_sync(first.__enter__)
            async with unity_link.connect(url, reconnect=unity_link.Reconnect(first_pause=0.01)) as link:
                await link.write(1, 5)
                await trio.to_thread.run_sync(first.__exit__, None, None, None)
                second = portal.wrap_async_context_manager(serve_unix(gateway, path))
                await trio.to_thread.run_sync(second.__enter__)
                assert await link.read(1) == 5
                assert link.statistics.reconnections == 1
            await trio.to_thread.run_sync(second.__exit__, None, None, None)

    run(program)


def test_a_gateway_that_goes_away_is_a_lost_link(tmp_path: Path) -> None:
    async def program() -> None:
        with start_blocking_portal() as portal:
            serving = portal.wrap_async_context_manager(serve_unix(VirtualGateway(), tmp_path / "gateway"))
            url = await trio.to_thread.run_sync(serving.__enter__)
            async with unity_link.connect(url) as link:
                await trio.to_thread.run_sync(serving.__exit__, None, None, None)
                with pytest.raises(unity_link.LinkLostError):
                    await link.read(0)

    run(program)


def test_fence_raises_for_posted_writes_of_its_own_task_and_of_ended_tasks() -> None:
    async def post_and_stay(link: unity_link.Link, posted: trio.Event, heard: trio.Event) -> None:
        await link.post(5, 1)
        posted.set()
        await heard.wait()
        with pytest.raises(unity_link.BusError, match="0x05"):
            await link.fence()
        await link.post(5, 1)

    async def program() -> None:
        gateway = VirtualGateway()
        gateway.attach(Failing(ErrorCode.BUS_ERROR), [5])
        posted, heard = trio.Event(), trio.Event()
        async with unity_link.connect(gateway) as link:
            async with trio.open_nursery() as nursery:
                nursery.start_soon(post_and_stay, link, posted, heard)
                await posted.wait()
                await link.fence()
                heard.set()
            with pytest.raises(unity_link.BusError, match="0x05"):
                await link.fence()
            await link.fence()

    run(program)


def test_a_fence_that_a_nursery_runs_belongs_to_the_task_that_starts_it() -> None:
    async def program() -> None:
        gateway = VirtualGateway()
        gateway.attach(Failing(ErrorCode.BUS_ERROR), [5])
        async with unity_link.connect(gateway) as link:
            await link.post(5, 1)
            with pytest.raises(unity_link.BusError, match="0x05"), first_error():
                async with trio.open_nursery() as nursery:
                    nursery.start_soon(link.fence)
            await link.fence()

    run(program)

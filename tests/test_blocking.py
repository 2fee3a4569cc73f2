"""The blocking API does the same as the link, in the threads that call it and without an event loop.

The tests of links run on it as well (tests/support/faces.py).
"""

import asyncio
import contextlib
import gc
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import weakref
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from anyio.from_thread import start_blocking_portal

import unity_link
from unity_link import blocking
from unity_link.link.runtimes.calling_thread import CallingThread
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing
from unity_link.virtual.line import SlowLine
from unity_link.virtual.serving import serve_unix


def test_words_blocks_and_batches_are_read_and_written() -> None:
    with blocking.connect("sim:") as link:
        link.write(0x0A, 0x12)
        assert link.read(0x0A) == 0x12
        assert link.write_masked(0x0A, 0xF0, 0xF0) == 0x12
        link.write_block(0x20, [1, 2, 3])
        assert link.read_block(0x20, 3).tolist() == [1, 2, 3]
        link.write_many([0x30, 0x40], [5, 6])
        assert link.read_many([0x40, 0x30, 0x20]).tolist() == [6, 5, 1]
        link.write_queue(0x50, [7, 8])
        assert link.read_queue(0x50, 2).tolist() == [8, 8]
        link.post(0x60, 9)
        link.fence()
        assert link.read(0x60) == 9
        link.send_immediate("adaptive")
        assert link.gateway.data_bits == 32
        assert link.statistics.in_flight == 0


def test_samples_come_by_iteration_in_order() -> None:
    with blocking.connect("sim:") as link:
        link.write(0x10, 4)
        with link.subscribe([0x10, 0x11], rate_hz=2000) as samples:
            seen = [sample for sample, _ in zip(samples, range(100), strict=False)]
            assert samples.rate_hz == 2000
            assert samples.received >= 100
        assert samples.lost == sum(sample.lost for sample in seen)
    assert [sample.sequence for sample in seen] == sorted({sample.sequence for sample in seen})
    assert all(sample.values.tolist() == [4, 0] for sample in seen)


def test_samples_arrive_on_request() -> None:
    with blocking.connect("sim:") as link, link.subscribe(0x10) as samples:
        samples.publish()
        assert next(iter(samples)).sequence == 0


def test_closing_the_link_within_a_subscriptions_block_closes_it_too(
    recwarn: pytest.WarningsRecorder,
) -> None:
    with blocking.connect("sim:") as link:
        with link.subscribe([0x10], rate_hz=100) as samples:
            link.close()
        del samples
        gc.collect()
    assert not recwarn.list


@pytest.mark.parametrize(
    "ask", [lambda samples: [next(samples)], blocking.BlockingSubscription.take], ids=["iterated", "taken"]
)
def test_samples_received_before_the_link_was_closed_precede_its_error(
    ask: Callable[[blocking.BlockingSubscription], list[unity_link.Sample]],
) -> None:
    with blocking.connect("sim:") as link, link.subscribe([0x10]) as samples:
        for _ in range(5):
            samples.publish()
        assert next(samples).sequence == 0
        samples.publish()
        link.close()
        taken = [sample.sequence for sample in samples.take(2)]
        with pytest.raises(unity_link.LinkClosedError):  # noqa: PT012  (the error comes after some samples)
            while True:
                taken += [sample.sequence for sample in ask(samples)]
        assert taken == [1, 2, 3, 4, 5]


def test_iteration_ends_with_the_block() -> None:
    with blocking.connect("sim:") as link:
        with link.subscribe(0x10) as samples:
            pass
        assert list(samples) == []


def test_any_number_of_threads_share_a_link() -> None:
    with blocking.connect("sim:") as link, ThreadPoolExecutor(8) as threads:
        list(threads.map(lambda address: link.write(address, address + 1), range(64)))
        assert list(threads.map(link.read, range(64))) == list(range(1, 65))


def test_errors_are_those_of_the_link() -> None:
    with blocking.connect("sim:") as link:
        with pytest.raises(unity_link.ArgumentError, match="address 0x100 is not from 0 to 0xff"):
            link.read(0x100)
        with pytest.raises(unity_link.ArgumentError, match="expected"):
            link.subscribe([0x10], rate_hz=1e9)
    with pytest.raises(unity_link.ConnectError, match=r"port 1 of 127\.0\.0\.1"):
        blocking.connect("tcp://127.0.0.1:1")


def test_closed_link_raises_and_leaves_no_thread() -> None:
    before = threading.active_count()
    link = blocking.connect("sim:")
    link.close()
    link.close()
    assert threading.active_count() == before
    with pytest.raises(unity_link.LinkClosedError):
        link.read(0)


@pytest.mark.skipif(not Path("/dev/fd").is_dir(), reason="this system does not tell what is open")
def test_a_closed_link_leaves_no_descriptor_for_the_garbage_collector() -> None:
    def count_open() -> int:
        return len(list(Path("/dev/fd").iterdir()))

    gc.collect()
    gc.disable()
    try:
        before = count_open()
        for _ in range(5):
            with blocking.connect("sim:") as link:
                assert link.read(0x10) == 0
        assert count_open() == before
    finally:
        gc.enable()


def test_control_c_in_a_waiting_call_ends_the_program_and_its_link() -> None:
    program = """
import sys
from unity_link import blocking
try:
    with blocking.connect("sim:") as link, link.subscribe(0x10) as samples:
        print("waiting", flush=True)
        next(iter(samples))
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "waiting\n"
        process.send_signal(signal.SIGINT)
        assert process.stdout.readline() == "interrupted\n"
        assert process.wait() == 0


def refusing(address: int) -> VirtualGateway:
    """Return a gateway whose bus refuses every access to an address."""
    gateway = VirtualGateway()
    gateway.attach(Failing(ErrorCode.BUS_ERROR), [address])
    return gateway


def test_the_end_of_the_block_waits_for_posted_writes() -> None:
    gateway = VirtualGateway()
    with blocking.connect(SlowLine(gateway, 20_000)) as link:
        for address in range(60):
            link.post(address, 7)
    assert [gateway.memory[address] for address in range(60)] == [7] * 60


def test_the_end_of_the_block_raises_the_errors_of_posted_writes() -> None:
    link = blocking.connect(refusing(5))
    with pytest.raises(unity_link.BusError, match="0x05"), link:
        link.post(5, 1)
    with pytest.raises(unity_link.LinkClosedError):
        link.read(0)


def test_fence_of_a_thread_raises_for_its_own_posted_writes() -> None:
    posted, heard = threading.Event(), threading.Event()

    def post_and_stay(link: blocking.BlockingLink) -> None:
        link.post(5, 1)
        posted.set()
        heard.wait()
        with pytest.raises(unity_link.BusError, match="0x05"):
            link.fence()
        link.post(5, 1)

    with blocking.connect(refusing(5)) as link, ThreadPoolExecutor() as pool:
        other = pool.submit(post_and_stay, link)
        posted.wait()
        link.fence()
        heard.set()
        other.result()
        link.fence()
        pool.shutdown()
        with pytest.raises(unity_link.BusError, match="0x05"):
            link.fence()


def test_an_error_in_the_block_is_not_hidden_by_those_of_posted_writes() -> None:
    link = blocking.connect(refusing(5))
    link.post(5, 1)
    with pytest.raises(ZeroDivisionError), link:
        raise ZeroDivisionError


def run_script(text: str, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", f"import sys\nfrom unity_link import blocking\n{text}", *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("way", "posting", "raising", "medium"),
    [
        ("keeps the link", False, False, "sim"),
        ("keeps the link", False, True, "sim"),
        ("keeps the link", True, False, "unix"),
        ("keeps the link", True, True, "sim"),
        ("forgets the link", True, False, "sim"),
        ("subscribes", False, False, "unix"),
        ("subscribes", True, True, "sim"),
    ],
)
def test_a_script_that_never_closes_its_link_ends(
    way: str, posting: bool, raising: bool, medium: str, tmp_path: Path
) -> None:
    lines = ["link = blocking.connect(sys.argv[1])", "link.write(1, 42)"]
    if posting:
        lines += ["for number in range(2000):", "    link.post(number & 0xFF, number)"]
    if way == "forgets the link":
        lines += ["del link", "blocking.connect(sys.argv[1]).read(0)"]
    elif way == "subscribes":
        lines += ["samples = link.subscribe([1], rate_hz=100)", "samples.__enter__()", "next(iter(samples))"]
    lines += ["print('the end', flush=True)"]
    if raising:
        lines += ["raise ZeroDivisionError"]
    with contextlib.ExitStack() as stack:
        url = "sim:"
        if medium == "unix":
            portal = stack.enter_context(start_blocking_portal())
            url = stack.enter_context(
                portal.wrap_async_context_manager(serve_unix(VirtualGateway(), tmp_path / "gateway"))
            )
        result = run_script("\n".join(lines), url)
    assert result.stdout == "the end\n"
    assert result.returncode == (1 if raising else 0)
    assert result.stderr.splitlines()[-1:] == (["ZeroDivisionError"] if raising else [])


def test_a_link_that_is_forgotten_is_closed_and_frees_its_port(tmp_path: Path) -> None:
    with start_blocking_portal() as portal:
        gateway = serve_unix(VirtualGateway(), tmp_path / "gateway")
        with portal.wrap_async_context_manager(gateway) as url:
            for _ in range(5):
                link = blocking.connect(url)
                assert link.read(0) == 0
                with pytest.warns(ResourceWarning, match="connected> was not closed: use `with`"):
                    del link


@pytest.mark.parametrize(
    "waiting",
    [
        "with blocking.connect('sim:') as link, link.subscribe(0x10) as samples:\n    say()\n    next(samples)",
        "link = blocking.connect('sim:')\nsamples = link.subscribe(0x10)\nsamples.__enter__()\nsay()\nnext(samples)",
        # Read once before: the first call imports numpy, and the interpreter may lose a Ctrl-C during an import.
        (
            "with blocking.connect(SlowLine(VirtualGateway(), 5000)) as link:\n"
            "    link.read_queue(0, 1)\n    say()\n    link.read_queue(0, 5000)"
        ),
    ],
    ids=["in a block", "without one", "in a call"],
)
def test_control_c_once_ends_a_script(waiting: str) -> None:
    text = (
        "from unity_link import blocking\nfrom unity_link.virtual import VirtualGateway\n"
        f"from unity_link.virtual.line import SlowLine\ndef say(): print('waiting', flush=True)\n{waiting}"
    )
    with subprocess.Popen(
        [sys.executable, "-c", text], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "waiting\n"
        process.send_signal(signal.SIGINT)
        assert process.communicate(timeout=120)[1].splitlines()[-1] == "KeyboardInterrupt"


def test_calls_of_other_threads_learn_that_the_link_was_closed() -> None:
    link = blocking.connect(SlowLine(VirtualGateway(), 2000))
    with ThreadPoolExecutor(8) as threads:
        blocks = [threads.submit(link.read_block, 0, 255) for _ in range(8)]
        samples = link.subscribe(0x10, timestamps=False)
        link.close()
        for block in blocks:
            with pytest.raises(unity_link.LinkClosedError):
                block.result(60)
        with pytest.raises(unity_link.LinkClosedError):
            samples.publish()


def test_callback_that_calls_the_link_gets_an_error() -> None:
    told: list[BaseException] = []
    with blocking.connect("sim:") as link:

        def call(_: object) -> None:
            try:
                link.read(0)
            except unity_link.ArgumentError as error:
                told.append(error)

        with link.subscribe(0x10, callback=call) as samples:
            samples.publish()
            link.fence()
    assert "must not call the link" in str(told[0])


@pytest.fixture
def served(tmp_path: Path) -> Iterator[tuple[VirtualGateway, str]]:
    """Serve a gateway in the event loop of another thread; yield it with the URL of its Unix socket."""
    gateway = VirtualGateway()
    with start_blocking_portal() as portal:
        serving = serve_unix(gateway, tmp_path / "gateway")
        with portal.wrap_async_context_manager(serving) as url:
            yield gateway, url


def threads_of_links() -> list[str]:
    return [thread.name for thread in threading.enumerate() if thread.name.startswith("unity_link")]


def test_only_subscriptions_have_a_thread(served: tuple[VirtualGateway, str]) -> None:
    with blocking.connect(served[1]) as link:
        link.write(0x10, 4)
        assert threads_of_links() == []
        with link.subscribe([0x10], rate_hz=1000) as samples:
            assert threads_of_links() == ["unity_link.blocking"]
            assert next(samples).values.tolist() == [4]
        assert link.read(0x10) == 4
    assert threads_of_links() == []


def test_samples_are_taken_while_the_program_does_something_else(served: tuple[VirtualGateway, str]) -> None:
    with blocking.connect(served[1]) as link, link.subscribe(range(32), rate_hz=5000) as samples:
        deadline = time.monotonic() + 60
        while samples.received < 1000 and time.monotonic() < deadline:
            time.sleep(0.01)
        taken = [next(samples) for _ in range(1000)]
    assert [sample.sequence for sample in taken] == list(range(1000))


def test_take_returns_the_requested_number_of_samples_or_fewer_at_the_end(tmp_path: Path) -> None:
    with contextlib.ExitStack() as stack:
        portal = stack.enter_context(start_blocking_portal())
        serving = stack.enter_context(contextlib.ExitStack())
        url = serving.enter_context(
            portal.wrap_async_context_manager(serve_unix(VirtualGateway(), tmp_path / "gateway"))
        )
        link = stack.enter_context(blocking.connect(url))
        samples = stack.enter_context(link.subscribe([0x10], rate_hz=1000))
        for count in (0, -1, "5"):
            with pytest.raises(unity_link.ArgumentError, match="a number of samples from 1 on was expected, not"):
                samples.take(count)  # type: ignore[arg-type]
        deadline = time.monotonic() + 60
        while samples.received < 100 and time.monotonic() < deadline:
            time.sleep(0.01)
        # The first call takes all received samples at once; then the link ends, before the test asks for the others.
        assert next(samples).sequence == 0
        waiting = len(samples._samples)
        assert waiting
        serving.close()
        taken = samples.take(10_000)
        assert [sample.sequence for sample in taken[:waiting]] == list(range(1, waiting + 1))
        with pytest.raises(unity_link.LinkLostError):
            samples.take(1)


def test_calls_work_while_another_thread_waits_for_a_sample(served: tuple[VirtualGateway, str]) -> None:
    with (
        blocking.connect(served[1]) as link,
        link.subscribe([0x10], divisor=None) as samples,
        ThreadPoolExecutor(1) as threads,
    ):
        waiting = threads.submit(next, samples)
        for value in range(200):
            link.write(0x10, value)
            assert link.read(0x10) == value
        samples.publish()
        assert waiting.result(60).values.tolist() == [199]


def test_many_threads_and_a_subscription_share_a_socket(served: tuple[VirtualGateway, str]) -> None:
    def work(number: int) -> list[int]:
        seen = []
        for value in range(200):
            link.write(number, value)
            seen.append(link.read(number))
        return seen

    with (
        blocking.connect(served[1]) as link,
        link.subscribe([0xFF], rate_hz=1000) as samples,
        ThreadPoolExecutor(8) as threads,
    ):
        results = [threads.submit(work, number) for number in range(8)]
        first = [next(samples).sequence for _ in range(50)]
        assert [result.result(60) for result in results] == [list(range(200))] * 8
    assert first == sorted(first)


@pytest.mark.parametrize("closing", [False, True], ids=["all work is done", "closed meanwhile"])
def test_threads_that_do_everything_at_once_end(served: tuple[VirtualGateway, str], closing: bool) -> None:
    def work(link: blocking.BlockingLink, number: int) -> None:
        with contextlib.suppress(*([unity_link.LinkClosedError] if closing else [])):
            for value in range(60):
                link.write(number, value)
                link.post(number, value + 1)
                link.fence()
                assert link.read(number) == value + 1
                assert link.read_many([number] * 20).tolist() == [value + 1] * 20
                if number < 4:
                    with link.subscribe([number], rate_hz=2000) as samples:
                        assert next(samples).values.tolist() == [value + 1]

    with blocking.connect(served[1]) as link, ThreadPoolExecutor(8) as threads:
        works = [threads.submit(work, link, number) for number in range(8)]
        if closing:
            works[7].cancel()
            link.close()
        for each in works:
            if not each.cancelled():
                each.result(120)
    assert threads_of_links() == []


def test_control_c_at_any_moment_leaves_a_link_of_use() -> None:
    text = """
import os, random, signal, threading, time

def disturb():
    for _ in range(100):
        time.sleep(random.random() * 0.005)
        os.kill(os.getpid(), signal.SIGINT)

def interrupt(*_):
    global calling
    if calling:
        calling = False
        raise KeyboardInterrupt

calling = False
signal.signal(signal.SIGINT, interrupt)
with blocking.connect(sys.argv[1]) as link:
    disturbing = threading.Thread(target=disturb)
    interruptions = value = 0
    disturbing.start()
    with link.subscribe([1], rate_hz=300) as samples:
        while disturbing.is_alive():
            value += 1
            try:
                calling = True
                link.write(1, value)
                found = link.read(1)
                next(samples)
                calling = False
                if found != value: print(found, value)
            except KeyboardInterrupt:
                interruptions += 1
    print(interruptions > 20 and link.read(1) >= value - 1)
"""
    with tempfile.TemporaryDirectory() as folder, start_blocking_portal() as portal:
        serving = serve_unix(VirtualGateway(), Path(folder) / "gateway")
        with portal.wrap_async_context_manager(serving) as url:
            result = run_script(text, url)
    assert (result.stdout, result.stderr) == ("True\n", "")


def test_link_dropped_by_its_own_callback_is_closed(served: tuple[VirtualGateway, str]) -> None:
    kept: list[object] = []

    def forget(_: object) -> None:
        kept.clear()

    link = blocking.connect(served[1])
    samples = link.subscribe([0x10], rate_hz=100, callback=forget)
    samples.__enter__()
    with pytest.warns(ResourceWarning, match="was not closed"):  # noqa: PT031  (threads end within the block)
        kept += [link, samples]
        del link, samples
        deadline = time.monotonic() + 60
        while threads_of_links() and time.monotonic() < deadline:
            time.sleep(0.001)
        gc.collect()
    assert threads_of_links() == []


def test_cancelled_job_keeps_no_reference_to_the_call_that_cancelled_it() -> None:
    class Argument:
        pass

    runtime = CallingThread()

    async def wait_for_ever() -> None:
        await runtime.create_future()

    async def cancel_a_job(_: Argument) -> None:
        await runtime.finish(runtime.create_task(wait_for_ever()))

    argument = Argument()
    kept = weakref.ref(argument)
    gc.disable()
    try:
        runtime.run(cancel_a_job, argument)
        del argument
        assert kept() is None
    finally:
        gc.enable()
        runtime.close(None)


def test_the_next_call_opens_a_lost_connection_again(tmp_path: Path) -> None:
    gateway = VirtualGateway()
    with start_blocking_portal() as portal:
        serving = serve_unix(gateway, tmp_path / "gateway")
        with portal.wrap_async_context_manager(serving) as url:
            link = blocking.connect(url, reconnect=unity_link.Reconnect(first_pause=0.01))
            link.write(1, 5)
        with portal.wrap_async_context_manager(serve_unix(gateway, tmp_path / "gateway")):
            assert link.read(1) == 5
            assert link.statistics.reconnections == 1
        link.close()


def test_a_call_in_flight_learns_at_once_that_the_connection_was_lost(tmp_path: Path) -> None:
    with start_blocking_portal() as portal, ThreadPoolExecutor(1) as threads:
        serving = serve_unix(SlowLine(VirtualGateway(), 2000), tmp_path / "gateway")
        with portal.wrap_async_context_manager(serving) as url:
            link = blocking.connect(url, reconnect=True)
            writing = threads.submit(link.write_block, 0, range(200))
            while not link.statistics.in_flight:
                time.sleep(0.001)
        # The gateway does not return, so that the link keeps reconnecting.
        with pytest.raises(unity_link.LinkLostError):
            writing.result(60)
        link.close()


def test_posted_writes_are_sent_at_once_and_confirmed_by_a_fence(served: tuple[VirtualGateway, str]) -> None:
    gateway, url = served
    with blocking.connect(url) as link:
        for address in range(100):
            link.post(address, address)
        link.fence()
        assert [gateway.memory[address] for address in range(100)] == list(range(100))


def test_a_block_that_fills_every_buffer_is_written_whole(served: tuple[VirtualGateway, str]) -> None:
    words = [number & 0xFFFF_FFFF for number in range(0, 200_000 * 77, 77)]
    with blocking.connect(served[1]) as link:
        link.post_many([number & 0xFF for number in range(len(words))], words)
        link.fence()
        assert link.read_block(0, 256).tolist()[words[-1] and (len(words) - 1 & 0xFF)] == words[-1]


def test_blocking_link_works_beside_a_running_event_loop(served: tuple[VirtualGateway, str]) -> None:
    async def as_in_a_notebook() -> int:
        with blocking.connect(served[1]) as link, blocking.connect("sim:") as simulated:
            simulated.write(1, 3)
            return link.read(1) + simulated.read(1)

    assert asyncio.run(as_in_a_notebook()) == 3


def test_port_without_a_gateway_is_an_error_after_the_time_out() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
        with pytest.raises(unity_link.ConnectError, match=r"no gateway answered at tcp://.* within 0\.1 s"):
            blocking.connect(f"tcp://127.0.0.1:{port}", timeout=0.1)
    assert threads_of_links() == []


def test_snoop_of_a_blocking_link_has_its_frames(served: tuple[VirtualGateway, str], tmp_path: Path) -> None:
    snoop = tmp_path / "snoop.pcapng"
    with blocking.connect(f"{served[1]}?snoop={snoop}") as link:
        link.write(0x0A, 0x12)
    assert snoop.stat().st_size > 200


def test_subscription_without_a_block_is_an_error_that_asks_for_with() -> None:
    with blocking.connect("sim:") as link:
        samples = link.subscribe([0x10], rate_hz=100)
        with pytest.raises(unity_link.ArgumentError, match="`with` in blocking code"):
            next(samples)
        with pytest.raises(unity_link.ArgumentError, match="`with` in blocking code"):
            list(link.subscribe(0x10))
        with samples:
            assert next(samples).sequence == 0

"""The blocking face does what the link does, from any thread and without a loop of the caller's."""

import contextlib
import signal
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from anyio.from_thread import start_blocking_portal

import unity_link
from unity_link import blocking
from unity_link.protocol.messages import ErrorCode
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


def test_samples_come_when_they_are_asked_for() -> None:
    with blocking.connect("sim:") as link, link.subscribe(0x10) as samples:
        samples.publish()
        assert next(iter(samples)).sequence == 0


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


def test_a_closed_link_says_so_and_leaves_no_thread() -> None:
    before = threading.active_count()
    link = blocking.connect("sim:")
    link.close()
    link.close()
    assert threading.active_count() == before
    with pytest.raises(unity_link.LinkClosedError):
        link.read(0)


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
    """Return a gateway whose bus refuses every access of an address."""
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


def test_an_error_in_the_block_is_not_hidden_by_those_of_posted_writes() -> None:
    link = blocking.connect(refusing(5))
    link.post(5, 1)
    with pytest.raises(ZeroDivisionError), link:
        raise ZeroDivisionError


def run_script(text: str, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", f"import sys\nfrom unity_link import blocking\n{text}", *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)


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
                del link


@pytest.mark.parametrize(
    "waiting",
    [
        "with blocking.connect('sim:') as link, link.subscribe(0x10) as samples:\n    say()\n    next(samples)",
        "link = blocking.connect('sim:')\nsamples = link.subscribe(0x10)\nsamples.__enter__()\nsay()\nnext(samples)",
        "with blocking.connect(SlowLine(VirtualGateway(), 5000)) as link:\n    say()\n    link.read_queue(0, 5000)",
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


def test_a_callback_that_calls_the_link_is_told_that_it_must_not() -> None:
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


def test_a_subscription_without_its_block_says_what_to_write() -> None:
    with blocking.connect("sim:") as link:
        samples = link.subscribe([0x10], rate_hz=100)
        with pytest.raises(unity_link.ArgumentError, match="`with` in blocking code"):
            next(samples)
        with pytest.raises(unity_link.ArgumentError, match="`with` in blocking code"):
            list(link.subscribe(0x10))
        with samples:
            assert next(samples).sequence == 0

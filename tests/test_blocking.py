"""The blocking face does what the link does, from any thread and without a loop of the caller's."""

import signal
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor

import pytest

import unity_link
from unity_link import blocking


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

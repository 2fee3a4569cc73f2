"""Faults during a recording: the remaining file, and the messages."""

from __future__ import annotations

import asyncio
import contextlib
import datetime as dt
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import threading
import time
import tracemalloc
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import lz4.frame
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mcap.data_stream import RecordBuilder
from mcap.reader import make_reader
from mcap.records import Attachment, Chunk, DataEnd
from mcap.stream_reader import StreamReader
from mcap.writer import MCAP0_MAGIC
from pyarrow import csv
from zstandard import ZstdCompressor

import unity_link
from generate.every_kind import every_kind
from support.bridge_programs import PROGRAM, wait_for, wait_until
from support.recordings import GATEWAY, SPEC, record, run, sequence_in, was_cut, work_in_place
from support.sharing import PipedLink, sharing
from support.simulated_time import run_simulated
from support.unmeasured import unmeasured_environment
from support.valve import Valve
from unity_link import GatewayError, LinkLostError, UnityLinkError
from unity_link.bridges.gateway_time import SteadyClock
from unity_link.bridges.recording import Recorder, Recording, RecordingError, export, recorder, replay
from unity_link.bridges.recording.files import GATEWAY as GATEWAY_FILE
from unity_link.bridges.recording.files import INTERFACE, INTERRUPTION
from unity_link.spec import compile_text
from unity_link.virtual.build import build_gateway
from unity_link.virtual.gateway import VirtualGateway

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from unity_link import Link

SUMMARY = re.compile(r"([\d,]+) samples in .* ([\d,]+) lost")


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("recording") / "run.mcap"
    record(path, lambda recorder: recorder.samples >= 100)
    return path


@pytest.fixture(scope="module")
def recorded_kinds(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a recording with signals of every kind."""
    path = tmp_path_factory.mktemp("kinds") / "kinds.mcap"
    record(path, lambda recorder: recorder.samples >= 10, "sim:", every_kind(32), poll_hz=100)
    return path


def samples_said(text: str) -> int:
    found = SUMMARY.search(text)
    assert found is not None, text
    return int(found[1].replace(",", ""))


@contextmanager
def recording(url: str, path: Path) -> Iterator[subprocess.Popen[str]]:
    with subprocess.Popen(
        [PROGRAM, "record", url, str(SPEC), "-o", str(path)], stderr=subprocess.PIPE, text=True
    ) as process:
        try:
            yield process
        finally:
            process.kill()


def wait_for_samples(path: Path, than: int = 0) -> int:
    """Wait until a file has grown twice beyond a size, so that it has samples; return its size."""
    wait_until(lambda: path.exists() and path.stat().st_size > than)
    first = path.stat().st_size
    wait_until(lambda: path.stat().st_size > first)
    return path.stat().st_size


# A program that ends during the recording


def test_at_every_instant_the_disk_has_all_but_the_last_second(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    work_in_place(monkeypatch)
    path = tmp_path / "run.mcap"

    async def crash_again_and_again() -> list[tuple[float, Path]]:
        copies = []
        async with unity_link.connect(GATEWAY) as link:
            running = asyncio.create_task(Recorder(unity_link.load(SPEC)(link), path).run())
            begun = asyncio.get_running_loop().time()
            for number in range(12):
                await asyncio.sleep(0.37)
                copies.append((asyncio.get_running_loop().time() - begun, tmp_path / f"crash_{number}.mcap"))
                shutil.copy(path, copies[-1][1])
            running.cancel()
            await asyncio.wait([running])
        return copies

    for seconds, copy in run_simulated(crash_again_and_again()):
        sequence = sequence_in(copy)
        assert sequence == list(range(len(sequence)))
        assert len(sequence) >= 200 * (seconds - 1.0)
    assert not was_cut(path)


@pytest.mark.parametrize("share", [0.85, 0.92, 0.98])
def test_cut_file_has_the_samples_before_the_cut(recorded: Path, tmp_path: Path, share: float) -> None:
    whole = recorded.read_bytes()
    cut = tmp_path / "cut.mcap"
    cut.write_bytes(whole[: int(len(whole) * share)])

    sequence = sequence_in(cut)

    assert sequence == list(range(len(sequence)))


def test_file_cut_before_its_first_sample_still_lists_its_groups(recorded: Path, tmp_path: Path) -> None:
    whole = recorded.read_bytes()
    cut = tmp_path / "cut.mcap"
    with recorded.open("rb") as file:
        summary = make_reader(file).get_summary()
    assert summary is not None
    cut.write_bytes(whole[: summary.chunk_indexes[0].chunk_start_offset])

    assert [group.name for group in Recording(cut).groups] == ["state"]
    assert sequence_in(cut) == []


@pytest.mark.slow
def test_a_chunk_that_was_damaged_costs_no_other(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"
    done = record(path, lambda recorder: recorder.samples >= 400)
    with path.open("rb") as file:
        summary = make_reader(file).get_summary()
    assert summary is not None
    chunk = summary.chunk_indexes[1]
    damaged = bytearray(path.read_bytes())
    damaged[chunk.chunk_start_offset + chunk.chunk_length // 2] ^= 1
    path.write_bytes(damaged)

    result = run("export", path, "--csv", "-o", tmp_path)

    kept = sequence_in(path)
    assert result.returncode == 0
    assert f"{path} is damaged: its undamaged part was exported" in result.stderr
    assert kept[0] == 0
    assert kept[-1] == done.samples - 1
    assert 1 < len(kept) < done.samples


@given(st.data())
def test_damaged_file_is_read_as_far_as_possible_or_refused(recorded: Path, data: st.DataObject) -> None:
    damaged = bytearray(recorded.read_bytes())
    for place in data.draw(st.lists(st.integers(0, len(damaged) - 1), min_size=1, max_size=5)):
        damaged[place] = data.draw(st.integers(0, 255))
    path = recorded.with_name("damaged.mcap")
    path.write_bytes(damaged[: data.draw(st.integers(0, len(damaged)))])

    with contextlib.suppress(RecordingError):
        assert set(sequence_in(path)) <= set(sequence_in(recorded))
        assert sum(1 for _ in Recording(path).in_order()) <= len(sequence_in(recorded))


Place = tuple[str | int, ...]
"""Path to a value in JSON: names and indexes, from the outside in."""
NUMBERS = st.sampled_from([0, -1, 1, 3, 64, 65, 255, 1 << 16, 1 << 31, 1 << 63, 1 << 70, 0.5, 5e-324, 1e308, -1e308])


def head_of(path: Path, name: str) -> Any:
    """Return the contents of an attachment of a recording."""
    with path.open("rb") as file:
        return next(json.loads(found.data) for found in make_reader(file).iter_attachments() if found.name == name)


def with_head(recorded: Path, name: str, head: Any) -> Path:
    """Write a recording again with one attachment replaced and right checksums; return its path."""
    builder = RecordBuilder()
    with recorded.open("rb") as file:
        for record in StreamReader(file, emit_chunks=True).records:
            if isinstance(record, DataEnd):
                break
            if isinstance(record, Attachment) and record.name == name:
                record.data = json.dumps(head).encode()
            record.write(builder)
    DataEnd(0).write(builder)
    path = recorded.with_name("changed.mcap")
    path.write_bytes(MCAP0_MAGIC + builder.end())
    return path


def numbers_in(json: Any, place: Place = ()) -> Iterator[Place]:
    """Yield the paths to the numbers in JSON, except lines and columns, which are most of them."""
    if "span" in place:
        return
    if isinstance(json, (int, float)) and not isinstance(json, bool):
        yield place
    for step, inner in json.items() if isinstance(json, dict) else enumerate(json) if isinstance(json, list) else ():
        yield from numbers_in(inner, (*place, step))


def put(json: Any, place: Place, number: float) -> None:
    """Replace the number at a path in JSON."""
    for step in place[:-1]:
        json = json[step]
    json[place[-1]] = number


FIRST_SIGNAL: Place = ("root", "parts", 1, "signals", 0)


@pytest.mark.parametrize(
    ("name", "place", "number", "said"),
    [
        (INTERFACE, ("data_bits",), 1 << 31, "data_bits is 2147483648, expected 8 to 64"),
        (INTERFACE, ("address_bits",), -1, "address_bits is -1, expected 8 to 32"),
        (INTERFACE, (*FIRST_SIGNAL, "word_bits"), 0, "j2.cpos: word_bits is 0, expected 32"),
        (INTERFACE, (*FIRST_SIGNAL, "lowest_bit"), 1 << 63, "j2.cpos: lowest_bit is 9223372036854775808, expected 0"),
        (INTERFACE, (*FIRST_SIGNAL, "address"), 256, "j2.cpos: address is 256, expected 0 to 255"),
        (INTERFACE, (*FIRST_SIGNAL, "kind", "width"), 1 << 31, "j2.cpos: width is 2147483648, expected 1 to 64"),
        (INTERFACE, (*FIRST_SIGNAL, "kind", "width"), -1, "j2.cpos: width is -1, expected 1 to 64"),
        (INTERFACE, ("groups", 0, "divisor"), 0, "state: divisor is 0, expected 1 to 65535"),
        (INTERFACE, ("groups", 0, "rate_hz"), 5e-324, "state: rate_hz is 5e-324, expected 1e-06 to 1000000000.0"),
        (
            GATEWAY_FILE,
            ("base_frequency_millihertz",),
            0,
            "the gateway reports base_frequency_millihertz = 0, expected 1",
        ),
        (GATEWAY_FILE, ("clock_hz",), 0, "the gateway reports clock_hz = 0, expected 1"),
    ],
)
def test_a_recording_with_a_number_that_cannot_be_is_refused_with_it(
    recorded: Path, name: str, place: Place, number: float, said: str
) -> None:
    head = head_of(recorded, name)
    put(head, place, number)
    path = with_head(recorded, name, head)

    with pytest.raises(RecordingError, match=re.escape(f"{path} is damaged: {said}")):
        Recording(path)


def test_recording_of_a_gateway_without_groups_or_base_frequency_is_replayed(recorded: Path) -> None:
    head = head_of(recorded, GATEWAY_FILE)
    head.update(features=0, base_frequency_millihertz=0)

    gateway, _ = replay(Recording(with_head(recorded, GATEWAY_FILE, head)))

    assert gateway.receive(b"H\r", 0.0) == b"H\r\n"


@pytest.mark.slow
@given(data=st.data(), name=st.sampled_from([INTERFACE, GATEWAY_FILE]))
def test_whatever_the_numbers_of_a_recording_are_it_is_refused_or_read(
    recorded: Path, recorded_kinds: Path, data: st.DataObject, name: str
) -> None:
    whole = data.draw(st.sampled_from([recorded, recorded_kinds]))
    head = head_of(whole, name)
    for place in data.draw(st.lists(st.sampled_from([*numbers_in(head)]), min_size=1, max_size=3)):
        put(head, place, data.draw(NUMBERS))
    path = with_head(whole, name, head)

    with contextlib.suppress(UnityLinkError):
        read = Recording(path)
        export(read, "csv", path.parent)
        for group in read.groups:
            read[group.name].to_pandas()
        _, player = replay(read, loop=True)
        for second in range(3):
            player.read(0, float(second))


@pytest.mark.slow
@pytest.mark.parametrize("said", [128 << 20, 1000], ids=["says so", "says less"])
@pytest.mark.parametrize("compression", ["zstd", "lz4"])
def test_a_chunk_that_would_fill_the_memory_is_left_out(
    recorded: Path, tmp_path: Path, said: int, compression: str
) -> None:
    with recorded.open("rb") as file:
        summary = make_reader(file).get_summary()
    assert summary is not None
    data = bytes(128 << 20)
    packed = ZstdCompressor().compress(data) if compression == "zstd" else lz4.frame.compress(data)
    builder = RecordBuilder()
    Chunk(
        compression=compression,
        data=packed,
        message_end_time=0,
        message_start_time=0,
        uncompressed_crc=0,
        uncompressed_size=said,
    ).write(builder)
    path = tmp_path / "bomb.mcap"
    whole, place = recorded.read_bytes(), summary.chunk_indexes[0].chunk_start_offset
    path.write_bytes(whole[:place] + builder.end() + whole[place:])
    del data, packed

    tracemalloc.start()
    try:
        sequences = [sequence_in(path), [row.at for row in Recording(path).in_order()]]
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()

    assert sequences == [sequence_in(recorded), [row.at for row in Recording(recorded).in_order()]]
    assert most < 32 << 20
    result = run("export", path, "--csv", "-o", tmp_path)
    assert f"{path} is damaged: its undamaged part was exported" in result.stderr


@pytest.mark.slow
def test_a_pipe_is_no_recording(tmp_path: Path) -> None:
    path = tmp_path / "pipe"
    os.mkfifo(path)

    assert f"{path} is no file: the name of a recording was expected" in run("export", path, "--csv").stderr
    assert f"{path} cannot be written: No such device" in run("record", GATEWAY, SPEC, "-o", path, "--overwrite").stderr


@pytest.mark.slow
def test_a_recorder_that_is_killed_leaves_all_that_was_on_the_disk(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"
    with recording(GATEWAY, path) as process:
        wait_for_samples(path, wait_for_samples(path))
        process.send_signal(signal.SIGKILL)

    result = run("export", path, "--csv", "-o", tmp_path)

    rows = csv.read_csv(tmp_path / "run.state.csv")["sequence"].to_pylist()
    assert "was not finished" in result.stderr
    assert len(rows) > 0
    assert rows == list(range(len(rows)))


def test_ctrl_c_finishes_the_file(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"
    with recording(GATEWAY, path) as process:
        wait_for_samples(path)
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)

    assert process.returncode == 130
    assert samples_said(said) == len(sequence_in(path))
    assert not was_cut(path)


@pytest.mark.slow
@pytest.mark.parametrize("command", [["record", GATEWAY, str(SPEC), "-o", "x.mcap"], ["replay", "x.mcap", "--pty"]])
def test_missing_mcap_is_reported_with_the_package_to_install(command: list[str], tmp_path: Path) -> None:
    script = (
        f"import sys; sys.modules['mcap'] = None; sys.argv[1:] = {command}; from unity_link.cli import main; main()"
    )

    result = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, timeout=120, check=False, cwd=tmp_path
    )

    assert result.returncode == 1
    assert result.stderr == ("error: recordings need mcap, which is not installed: pip install 'unity-link[record]'\n")


# The disk


@pytest.mark.slow
def test_full_disk_ends_the_recording_with_one_sentence_and_keeps_the_file(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"
    limit = 20_000

    result = run(
        *("record", GATEWAY, SPEC, "-o", path, "--duration", "60"),
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)),
        env=unmeasured_environment(),
    )

    sequence = sequence_in(path)
    assert result.returncode == 1
    assert f"error: {path} cannot be written on: File too large; earlier samples are in it" in result.stderr
    assert result.stderr.count("\n") == 2
    assert sequence == list(range(len(sequence)))
    assert samples_said(result.stderr) == len(sequence) > 0


@pytest.mark.slow
def test_disk_full_from_the_beginning_is_reported_in_one_sentence() -> None:
    result = run("record", GATEWAY, SPEC, "-o", "/dev/full", "--overwrite")

    assert result.returncode == 1
    assert "error: /dev/full cannot be written on: No space left on device" in result.stderr
    assert result.stderr.count("\n") == 1


def test_a_disk_that_is_too_slow_costs_samples_that_are_counted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "run.mcap"
    quick, fsync = threading.Event(), os.fsync

    def fsync_slowly(file: int) -> None:
        # The event loop writes the head of the file before the first sample.
        if threading.current_thread() is not threading.main_thread():
            quick.wait()
        fsync(file)

    def has_lost(running: Recorder) -> bool:
        if running.lost >= 20:
            quick.set()
        return quick.is_set()

    monkeypatch.setattr(recorder, "BUFFER", 30)
    monkeypatch.setattr(os, "fsync", fsync_slowly)
    done = record(path, has_lost)

    batches = [samples for samples, _ in Recording(path).samples()]
    sequence = np.concatenate([samples.sequence for samples in batches])
    lost = np.concatenate([samples.lost for samples in batches])
    assert not was_cut(path)
    assert len(sequence) == done.samples
    assert done.lost >= 20
    assert np.array_equal(np.diff(sequence, prepend=-1) - 1, lost)
    assert int(lost.sum()) == done.lost


@pytest.mark.slow
def test_a_recording_is_never_replaced_unasked(recorded: Path) -> None:
    before = recorded.read_bytes()

    result = run("record", GATEWAY, SPEC, "-o", recorded, "--duration", "0.1")

    assert result.returncode == 2
    assert "is there already: choose another name, or --overwrite" in result.stderr
    assert recorded.read_bytes() == before


@pytest.mark.slow
def test_recording_is_replaced_on_request(recorded: Path, tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"
    path.write_bytes(recorded.read_bytes() * 20)

    result = run("record", GATEWAY, SPEC, "-o", path, "--duration", "0.2", "--overwrite")

    assert result.returncode == 0
    assert samples_said(result.stderr) == len(sequence_in(path))
    assert not was_cut(path)


@pytest.mark.slow
def test_a_file_that_another_recorder_writes_is_not_replaced(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"
    with recording(GATEWAY, path) as process:
        wait_for_samples(path)

        result = run("record", GATEWAY, SPEC, "-o", path, "--duration", "0.1", "--overwrite")

        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)
    assert result.returncode == 2
    assert result.stderr == f"error: {path} is being written by another recorder: choose another name\n"
    assert samples_said(said) == len(sequence_in(path)) > 0
    assert run("record", GATEWAY, SPEC, "-o", path, "--duration", "0.1", "--overwrite").returncode == 0


# The gateway


@contextmanager
def gateway(place: Path) -> Iterator[subprocess.Popen[str]]:
    with subprocess.Popen(
        [PROGRAM, "simulate", "--robot", "scara", "--unix", str(place)], stdout=subprocess.PIPE, text=True
    ) as process:
        try:
            assert process.stdout is not None
            process.stdout.readline()
            yield process
        finally:
            process.kill()


def interruptions_in(path: Path) -> int:
    with path.open("rb") as file:
        notes = list(make_reader(file).iter_metadata())
    assert all(note.name == INTERRUPTION and note.metadata["from"] <= note.metadata["to"] for note in notes)
    return len(notes)


@pytest.mark.slow
def test_a_gateway_that_goes_away_is_waited_for(tmp_path: Path) -> None:
    path, place = tmp_path / "run.mcap", tmp_path / "gateway"
    with gateway(place) as first, recording(f"unix:{place}", path) as process:
        size = wait_for_samples(path)
        first.terminate()
        wait_for(process, "the gateway has gone away: recording goes on when it is back")
        with gateway(place):
            wait_for(process, "the gateway is back after")
            wait_for_samples(path, size)
            process.send_signal(signal.SIGINT)
            _, said = process.communicate(timeout=60)

    instants = np.concatenate([samples.at for samples, _ in Recording(path).samples()])
    assert process.returncode == 130
    assert re.search(r"the gateway was away 1 time, for \d+\.\d s in all", said)
    assert samples_said(said) == len(instants)
    assert np.all(np.diff(instants) >= 0)
    assert interruptions_in(path) == 1
    assert not was_cut(path)


@pytest.mark.slow
def test_recording_continues_after_a_gateway_reset_on_an_open_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    work_in_place(monkeypatch)
    path = tmp_path / "run.mcap"
    said: list[str] = []

    async def reset_in_the_middle() -> None:
        gateway = build_gateway("scara")
        assert isinstance(gateway, VirtualGateway)
        async with unity_link.connect(gateway, reconnect=True) as link:
            running = asyncio.create_task(Recorder(unity_link.load(SPEC)(link), path, report=said.append).run())
            await asyncio.sleep(1.3)
            gateway.reset()
            # A link is lost after nine seconds of silence.
            await asyncio.sleep(13)
            running.cancel()
            await asyncio.wait([running])

    run_simulated(reset_in_the_middle())

    times = np.concatenate([samples.time for samples, _ in Recording(path).samples()])
    assert len(said) == 2
    assert len(times) > 4_000
    assert 0 < np.diff(times).min() < np.diff(times).max() < 15
    assert interruptions_in(path) == 1


@pytest.mark.slow
def test_interruption_behind_a_server_is_the_time_without_samples(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    work_in_place(monkeypatch)
    monkeypatch.setattr(SteadyClock, "now", lambda _: asyncio.get_running_loop().time())
    path = tmp_path / "run.mcap"
    said: list[str] = []

    async def be_away_in_the_middle() -> None:
        gateway = Valve(build_gateway("scara"))
        async with sharing(gateway) as shared, PipedLink(shared) as link:
            robot = unity_link.load(SPEC)(link)
            running = asyncio.create_task(Recorder(robot, path, poll_hz=5, report=said.append).run())
            await asyncio.sleep(1.5)
            gateway.go_away(shared)
            await asyncio.sleep(4)
            gateway.come_back()
            await asyncio.sleep(6)
            running.cancel()
            await asyncio.wait([running])

    run_simulated(be_away_in_the_middle())

    recorded = [samples.time for samples, _ in Recording(path).samples() if samples.group.name == "state"]
    hole = float(np.diff(np.concatenate(recorded)).max())
    with path.open("rb") as file:
        (note,) = [record.metadata for record in make_reader(file).iter_metadata()]
    began, ended = (dt.datetime.fromisoformat(note[name]) for name in ("from", "to"))
    assert hole > 4
    assert (ended - began).total_seconds() == pytest.approx(hole, abs=0.3)
    assert [line for line in said if line.startswith("the gateway")] == [
        "the gateway has gone away: recording goes on when it is back",
        f"the gateway is back after {(ended - began).total_seconds():.1f} s",
    ]


ON_CHANGE_ALONE = compile_text("""
group changed(1, 10, ON_CHANGE);
public robot() { @a = 0x10: READWRITE(PUBLISH(changed)); }
""")


@pytest.mark.slow
@pytest.mark.parametrize("others_ask", [False, True], ids=["an idle link", "a link that others use"])
def test_interruption_behind_a_server_is_recorded_without_periodic_groups(
    others_ask: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    work_in_place(monkeypatch)
    monkeypatch.setattr(SteadyClock, "now", lambda _: asyncio.get_running_loop().time())
    path = tmp_path / "run.mcap"
    said: list[str] = []

    async def ask(link: Link) -> None:
        while True:
            with contextlib.suppress(GatewayError, LinkLostError):
                await link.write(0x20, 1)
            await asyncio.sleep(0.1)

    async def be_away_in_the_middle() -> None:
        gateway = Valve(VirtualGateway())
        async with sharing(gateway) as shared, PipedLink(shared) as link, PipedLink(shared) as other:
            robot = unity_link.load(ON_CHANGE_ALONE)(link)
            running = asyncio.create_task(Recorder(robot, path, report=said.append).run())
            asking = asyncio.create_task(ask(link if others_ask else other))
            await asyncio.sleep(3)
            await other.write(0x10, 1)
            assert said == []
            gateway.go_away(shared)
            await asyncio.sleep(6)
            assert said == ["the gateway has gone away: recording goes on when it is back"]
            gateway.come_back()
            await asyncio.sleep(6)
            for task in (running, asking):
                task.cancel()
                await asyncio.wait([task])

    run_simulated(be_away_in_the_middle())

    with path.open("rb") as file:
        (note,) = [record.metadata for record in make_reader(file).iter_metadata()]
    began, ended = (dt.datetime.fromisoformat(note[name]) for name in ("from", "to"))
    assert 5.9 < (ended - began).total_seconds() < 11
    assert said[1:] == [f"the gateway is back after {(ended - began).total_seconds():.1f} s"]


POLLED_TOO = compile_text("""
group fast(1, 10, TIMESTAMPS);
public robot() {
  @a = 0x10: READ(PUBLISH(fast));
  @b = 0x11: READ(POLL(50));
}
""")


@pytest.mark.parametrize("step", [3600.0, -3600.0, 4.0, -4.0])
def test_setting_the_system_clock_does_not_change_recorded_instants(
    step: float, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    work_in_place(monkeypatch)
    path = tmp_path / "run.mcap"
    clock, began = time.time, time.time()

    async def set_it_in_the_middle() -> None:
        async with unity_link.connect("sim:?base_frequency_millihertz=2000000") as link:
            running = asyncio.create_task(Recorder(unity_link.load(POLLED_TOO)(link), path).run())
            await asyncio.sleep(1.5)
            monkeypatch.setattr(time, "time", lambda: clock() + step)
            await asyncio.sleep(1.5)
            running.cancel()
            await asyncio.wait([running])

    run_simulated(set_it_in_the_middle())

    by_group = {samples.group.name: samples for samples, _ in Recording(path).samples()}
    assert np.allclose(np.diff(by_group["fast"].at), 5_000_000, rtol=0.02)
    polled = by_group["poll_50_hz"].at / 1e9
    # Polled samples have the times of this machine's clock, which is not simulated.
    assert len(polled) > 100
    assert np.all(np.diff(polled) >= 0)
    assert began - 0.1 <= polled[0] <= polled[-1] <= clock() + 0.1


@pytest.mark.slow
def test_ctrl_c_finishes_the_file_while_the_gateway_is_away(tmp_path: Path) -> None:
    path, place = tmp_path / "run.mcap", tmp_path / "gateway"
    with gateway(place) as first, recording(f"unix:{place}", path) as process:
        wait_for_samples(path)
        first.kill()
        wait_for(process, "the gateway has gone away")
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)

    assert process.returncode == 130
    assert samples_said(said) == len(sequence_in(path))
    assert not was_cut(path)


def test_lost_link_without_reconnection_ends_the_recording_with_a_whole_file(tmp_path: Path) -> None:
    path, place = tmp_path / "run.mcap", tmp_path / "gateway"

    async def record_until_it_is_lost() -> None:
        with gateway(place) as process:
            async with unity_link.connect(f"unix:{place}") as link:
                recording = Recorder(unity_link.load(SPEC)(link), path)
                running = asyncio.create_task(recording.run())
                while recording.samples < 100:  # noqa: ASYNC110  (a thread writes)
                    await asyncio.sleep(0.01)
                process.kill()
                await running

    with pytest.raises(LinkLostError):
        asyncio.run(record_until_it_is_lost())
    assert len(sequence_in(path)) >= 100
    assert not was_cut(path)


def test_missing_gateway_at_the_start_is_an_error_and_no_file_is_made(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"

    result = run("record", f"unix:{tmp_path / 'nothing'}", SPEC, "-o", path)

    assert result.returncode == 1
    assert result.stderr.startswith("error: ")
    assert not path.exists()

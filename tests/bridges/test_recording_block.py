"""`async with Recorder(...)`: the file is complete, or removed, however the block ends."""

from __future__ import annotations

import asyncio
import gc
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

import unity_link
from support.recordings import GATEWAY, SPEC, sequence_in, was_cut, work_in_place
from support.simulated_time import run_simulated
from support.unmeasured import unmeasured_environment
from support.valve import cut
from unity_link import ArgumentError, LinkLostError
from unity_link.bridges.recording import Recorder, RecordingError

if TYPE_CHECKING:
    from pathlib import Path

    from unity_link.link.link import Link

SECONDS = 0.5


@pytest.fixture(autouse=True)
def in_place(monkeypatch: pytest.MonkeyPatch) -> None:
    work_in_place(monkeypatch)


def recorder_of(link: Link, path: Path) -> Recorder:
    return Recorder(unity_link.load(SPEC)(link), path)


async def record_for(seconds: float, path: Path) -> Recorder:
    async with unity_link.connect(GATEWAY) as link:
        async with recorder_of(link, path) as recorder:
            await asyncio.sleep(seconds)
        assert not was_cut(path), "it is finished when the block has ended"
        return recorder


def assert_is_whole(path: Path, most: int = 1000) -> None:
    sequence = sequence_in(path)
    assert sequence == list(range(len(sequence)))
    assert 0.8 * 200 * SECONDS < len(sequence) < most
    assert not was_cut(path)


def test_a_block_records_from_its_beginning_to_its_end(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"

    recorder = run_simulated(record_for(SECONDS, path))

    assert_is_whole(path)
    assert recorder.samples == len(sequence_in(path))
    assert repr(recorder) == f"<recorder of {path}: {recorder.samples} samples, 0 lost>"


def test_an_error_in_the_block_is_raised_as_it_is_and_the_file_is_finished(tmp_path: Path) -> None:
    path, cause, error = tmp_path / "run.mcap", ValueError("why"), KeyError("what")

    async def fail() -> None:
        async with unity_link.connect(GATEWAY) as link, recorder_of(link, path):
            await asyncio.sleep(SECONDS)
            raise error from cause

    with pytest.raises(KeyError) as caught:
        run_simulated(fail())
    assert caught.value is error
    assert error.__cause__ is cause
    assert_is_whole(path)


def test_a_block_that_is_cancelled_finishes_the_file(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"

    async def cancel() -> None:
        task = asyncio.create_task(record_for(1000, path))
        await asyncio.sleep(SECONDS)
        task.cancel()
        await asyncio.wait([task])
        assert task.cancelled()

    run_simulated(cancel())
    assert_is_whole(path)


def test_a_block_that_ends_before_the_first_sample_leaves_no_file(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"

    async def fail() -> None:
        async with unity_link.connect(GATEWAY) as link, recorder_of(link, path):
            raise KeyError

    with pytest.raises(KeyError):
        run_simulated(fail())
    assert list(tmp_path.iterdir()) == []


def test_a_link_that_is_lost_ends_the_block_at_once_and_the_file_is_finished(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"

    async def lose() -> None:
        async with unity_link.connect(GATEWAY) as link, recorder_of(link, path):
            await asyncio.sleep(SECONDS)
            cut(link)
            await asyncio.sleep(1000)
            raise AssertionError

    with pytest.raises(LinkLostError):
        run_simulated(lose())
    assert_is_whole(path)


def test_a_block_that_cannot_begin_leaves_no_file(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"

    async def begin() -> None:
        async with unity_link.connect(GATEWAY) as link:
            recorder = recorder_of(link, path)
            await link.aclose()
            async with recorder:
                raise AssertionError

    with pytest.raises(LinkLostError, match="the link was closed"):
        run_simulated(begin())
    assert list(tmp_path.iterdir()) == []


def test_a_task_that_is_cancelled_before_the_block_begins_leaves_no_file(tmp_path: Path) -> None:
    async def cancel() -> None:
        async with unity_link.connect(GATEWAY) as link:
            task = asyncio.create_task(enter(recorder_of(link, tmp_path / "run.mcap")))
            await asyncio.sleep(0)
            task.cancel()
            await asyncio.wait([task])
            assert task.cancelled()

    async def enter(recorder: Recorder) -> None:
        async with recorder:
            raise AssertionError

    run_simulated(cancel())
    assert list(tmp_path.iterdir()) == []


def test_a_recorder_runs_once(tmp_path: Path) -> None:
    async def run_twice() -> None:
        async with unity_link.connect(GATEWAY) as link:
            async with recorder_of(link, tmp_path / "run.mcap") as recorder:
                await asyncio.sleep(SECONDS)
            with pytest.raises(ArgumentError, match="has run before: make another one"):
                await recorder.run()
            with pytest.raises(ArgumentError, match="has run before: make another one"):
                async with recorder:
                    pass

    run_simulated(run_twice())
    assert_is_whole(tmp_path / "run.mcap")


@pytest.mark.slow
def test_a_recorder_that_never_ran_warns_and_removes_its_file(tmp_path: Path) -> None:
    async def forget() -> None:
        async with unity_link.connect(GATEWAY) as link:
            recorder_of(link, tmp_path / "run.mcap")
            gc.collect()

    with pytest.warns(ResourceWarning, match=r"the recorder of .*run\.mcap was never run: use `async with`"):
        run_simulated(forget())
    assert list(tmp_path.iterdir()) == []


DISK_FULL = """
import asyncio, resource, sys, unity_link
from unity_link.bridges.recording import Recorder

async def main():
    async with unity_link.connect("sim:scara") as link:
        robot = unity_link.load(sys.argv[1])(link)
        resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[3]), resource.RLIM_INFINITY))
        async with Recorder(robot, sys.argv[2]):
            await asyncio.sleep(60)

try:
    asyncio.run(main())
except Exception as error:
    print(type(error).__name__, error)
"""


@pytest.mark.slow
@pytest.mark.parametrize("room", [100, 60_000])
def test_a_full_disk_ends_the_block_and_leaves_whole_samples_or_no_file(tmp_path: Path, room: int) -> None:
    path = tmp_path / "run.mcap"
    command = [sys.executable, "-c", DISK_FULL, str(SPEC), str(path), str(room)]
    result = subprocess.run(
        command, capture_output=True, text=True, timeout=100, check=True, env=unmeasured_environment()
    )
    said = f"{RecordingError.__name__} {path} cannot be written on: File too large; earlier samples are in it\n"
    assert (result.stdout, result.stderr) == (said, "")
    if room == 100:
        assert list(tmp_path.iterdir()) == []
    else:
        assert sequence_in(path)

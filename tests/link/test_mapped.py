"""A link to a bus that is mapped into memory: the behaviour that the other tests of links do not cover."""

from __future__ import annotations

import asyncio
import mmap
import subprocess
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

import unity_link
from support.simulated_time import on_simulated_time
from unity_link import ArgumentError, ConnectError, LinkClosedError, LinkLostError, UnsupportedError, blocking
from unity_link.data import Group
from unity_link.spec import compile_text
from unity_link.transport.mmio import uio_place

if TYPE_CHECKING:
    from collections.abc import Iterator

EXAMPLES = Path(__file__).parents[2] / "examples"
ROBOT = Path(__file__).with_name("mapped_robot.py")
WORDS = 256


@pytest.fixture
def file(tmp_path: Path) -> Path:
    """Return the file of a bus of 256 words, all 0."""
    path = tmp_path / "bus"
    path.write_bytes(bytes(4 * WORDS))
    return path


@pytest.fixture
def robot(file: Path) -> Iterator[str]:
    """Return the URL of a bus on which another process simulates a SCARA robot."""
    with subprocess.Popen([sys.executable, str(ROBOT), str(file)], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "ready\n"
        yield f"mmio:{file}"
        process.kill()


# Words


@given(
    bits=st.sampled_from([8, 16, 32, 64]),
    offset=st.integers(0, 300),
    address=st.integers(0, 40),
    value=st.integers(0, (1 << 64) - 1),
)
def test_a_word_is_at_its_address_times_its_size(
    tmp_path_factory: pytest.TempPathFactory, bits: int, offset: int, address: int, value: int
) -> None:
    size, word = bits // 8, value % (1 << bits)
    path = tmp_path_factory.getbasetemp() / "words"
    before = bytes(index % 251 for index in range(4096))
    path.write_bytes(before)
    with blocking.connect(f"mmio:{path}?data_bits={bits}&offset={offset * size}") as link:
        place = (offset + address) * size
        assert link.read(address) == int.from_bytes(before[place : place + size], sys.byteorder)
        link.write(address, word)
        assert link.read_block(address, 2).tolist()[0] == word
    after = before[:place] + word.to_bytes(size, sys.byteorder) + before[place + size :]
    assert path.read_bytes() == after


def test_the_size_of_the_file_limits_the_addresses(file: Path) -> None:
    with blocking.connect(f"mmio:{file}?offset=16&size=40") as link:
        link.write(9, 7)
        with pytest.raises(ArgumentError, match="address 0xa is not from 0 to 0x9"):
            link.read(10)
        with pytest.raises(ArgumentError, match="would pass the last address, 0x9"):
            link.read_block(9, 2)
    assert file.read_bytes()[52:56] == (7).to_bytes(4, sys.byteorder)


@pytest.mark.asyncio
async def test_a_task_that_only_reads_lets_other_tasks_run(file: Path) -> None:
    async with unity_link.connect(f"mmio:{file}") as link:

        async def set_later() -> None:
            await asyncio.sleep(0)
            await link.write(3, 1)

        async with asyncio.TaskGroup() as tasks:
            tasks.create_task(set_later())
            # Without a turn for the other task this loop would never end.
            while not await link.read(3):
                pass


@on_simulated_time
async def test_the_block_and_a_fence_wait_for_a_write_at_an_instant(file: Path) -> None:
    spec = compile_text("""
    public robot() {
      GATEWAY(ADDRESS_BITS=12);
      plan: SCHEDULE(DEPTH=64) @(0x40);
      @lamp = 0x10: unsigned 8 READWRITE(TIMED(plan));
    }
    """)
    async with asyncio.timeout(60), unity_link.connect(f"mmio:{file}?map=any") as link:
        robot: Any = unity_link.load(spec)(link)
        room = robot["plan.room"].signal
        await link.write_block(room.address, room.encode(64))
        clock = await robot.plan.clock()
        await robot.lamp.set(1, at=clock.now().after(100))
        await link.fence()


@pytest.mark.asyncio
async def test_every_call_after_the_close_reports_that_the_link_was_closed(file: Path) -> None:
    link = await unity_link.connect(f"mmio:{file}")
    async with link.subscribe([1]) as samples:
        await link.aclose()
        with pytest.raises(LinkLostError):
            await anext(samples)
    assert not link.connected
    calls = [
        link.read(0),
        link.write(0, 1),
        link.read_many([0, 1]),
        link.post(0, 1),
        link.fence(),
        link.read_block(0, 2),
    ]
    for call in [*calls, link.write_block(0, [1]), link.write_masked(0, 1, 1), link.send_immediate("off")]:
        with pytest.raises(LinkClosedError):
            await call
    with pytest.raises(LinkClosedError):
        async with link.subscribe([1]):
            pass


# Groups


@on_simulated_time
async def test_samples_arrive_at_their_rate(tmp_path: Path) -> None:
    path = tmp_path / "bus"
    path.write_bytes(bytes(4 * WORDS))
    async with unity_link.connect(f"mmio:{path}") as link, link.subscribe([2, 1], rate_hz=100) as samples:
        assert samples.rate_hz == 100
        taken = []
        for number in range(300):
            await link.write_block(1, [number, number + 1])
            taken.append(await anext(samples))
    assert [sample.values.tolist() for sample in taken] == [[number + 1, number] for number in range(300)]
    assert [sample.sequence for sample in taken] == list(range(300))
    first = taken[0].time
    assert first is not None
    assert [sample.time for sample in taken] == pytest.approx([first + number / 100 for number in range(300)])


@on_simulated_time
@pytest.mark.parametrize("timestamps", [True, False])
async def test_many_missed_periods_are_counted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, *, timestamps: bool
) -> None:
    path = tmp_path / "bus"
    path.write_bytes(bytes(4 * WORDS))
    loop = asyncio.get_running_loop()
    time, held_up = loop.time, 0
    monkeypatch.setattr(loop, "time", lambda: time() + held_up)
    async with (
        unity_link.connect(f"mmio:{path}") as link,
        link.subscribe([1], rate_hz=1000, timestamps=timestamps) as samples,
    ):
        assert (await anext(samples)).sequence == 0
        held_up = 1
        late = await anext(samples)
    assert late.lost == pytest.approx(1000, abs=2)
    assert late.sequence == 1 + late.lost == 1 + samples.lost


@pytest.mark.asyncio
@pytest.mark.parametrize("timestamps", [True, False])
async def test_missed_periods_are_counted(file: Path, *, timestamps: bool) -> None:
    async with (
        unity_link.connect(f"mmio:{file}") as link,
        link.subscribe([1], rate_hz=1000, timestamps=timestamps) as samples,
    ):
        first = await anext(samples)
        time.sleep(0.05)  # noqa: ASYNC251  (it is to hold up the loop)
        taken = [await anext(samples)]
        # Some samples may have been waiting already.
        while taken[-1].lost < 40 and len(taken) < 1000:
            taken.append(await anext(samples))
    assert taken[-1].lost >= 40
    assert taken[-1].sequence == first.sequence + sum(1 + sample.lost for sample in taken)


@pytest.mark.asyncio
async def test_equal_words_are_not_published_with_on_change(file: Path) -> None:
    async with unity_link.connect(f"mmio:{file}") as link, link.subscribe([1], rate_hz=1000, on_change=True) as samples:
        values = []
        for value in range(5):
            await link.write(1, value)
            values.append((await anext(samples)).values.tolist())
        await asyncio.sleep(0.01)
        assert (samples.received, samples.lost) == (5, 0)
    assert values == [[0], [1], [2], [3], [4]]


# Unsupported calls


@pytest.mark.asyncio
async def test_the_error_for_a_trigger_says_that_there_are_none(file: Path) -> None:
    async with unity_link.connect(f"mmio:{file}") as link:
        with pytest.raises(UnsupportedError, match="mapped memory has no external triggers"):
            link.subscribe([1], trigger=True)


@pytest.mark.parametrize(
    ("url", "what"),
    [
        ("mmio:", "names no file"),
        ("mmio://dev/uio0", "names no file"),
        ("mmio:{folder}", "is a folder"),
        ("mmio:/dev/null", "has no size of its own: give the number of bytes"),
        ("mmio:{file}?offset=3", "offset=3 .* is no multiple of the 4 bytes of a word"),
        ("mmio:{file}?offset=-4", "is no multiple"),
        ("mmio:{file}?size=2", "size=2 .* is no multiple"),
        ("mmio:{file}?size=0", "no word is left"),
        ("mmio:{file}?size=1028", "has 1024 bytes: 1028 bytes from 0x0 on"),
        ("mmio:{file}?offset=1024", "no word is left"),
        ("mmio:{file}?data_bits=12", "data_bits=12 .* 8, 16, 32 or 64"),
        ("mmio:{file}?uio_map=1", "is for UIO devices"),
        ("mmio:{file}?node=1", "for links with frames"),
        ("mmio:{file}?snoop=x", "for links with frames"),
        ("mmio:{file}?speed=1", "unknown option 'speed'"),
        ("mmio:{file}?base_frequency_millihertz=0", "is not from 1"),
    ],
)
def test_the_error_for_an_impossible_url_is_one_sentence(url: str, what: str, file: Path) -> None:
    with pytest.raises(ArgumentError, match=what):
        blocking.connect(url.format(file=file, folder=file.parent))


@pytest.mark.parametrize("url", ["mmio:{file}.not", "mmio:/dev/null?size=4096"])
def test_the_error_for_a_file_that_cannot_be_mapped_is_one_sentence(url: str, file: Path) -> None:
    with pytest.raises(ConnectError, match=r"^mmio:\S+: it cannot be mapped \(.+\); it must be there"):
        blocking.connect(url.format(file=file))


@pytest.mark.parametrize("command", ["serve {url} --unix {folder}/socket", "terminal {url}"])
def test_commands_that_need_frames_report_that_there_are_none(command: str, file: Path) -> None:
    program = str(Path(sys.executable).parent / "unity-link")
    words = command.format(url=f"mmio:{file}", folder=file.parent).split()
    done = subprocess.run(
        [program, *words], capture_output=True, check=False, text=True, stdin=subprocess.DEVNULL, timeout=60
    )
    assert done.returncode == 2
    assert "carries no frames, so it cannot be served" in done.stderr


def test_a_mapping_of_uio_is_found_in_the_files_of_linux(tmp_path: Path) -> None:
    for number, (size, offset) in enumerate([("0x1000", "0x0"), ("0x00000100", "0x40")]):
        one = tmp_path / f"map{number}"
        one.mkdir()
        (one / "size").write_text(f"{size}\n")
        (one / "offset").write_text(f"{offset}\n")
    assert uio_place(tmp_path, 0, "/dev/uio0") == (0, 0x1000)
    assert uio_place(tmp_path, 1, "/dev/uio0") == (mmap.PAGESIZE + 0x40, 0x100)
    with pytest.raises(ArgumentError, match="/dev/uio0 has no mapping 2: there is 0, 1"):
        uio_place(tmp_path, 2, "/dev/uio0")


# Robots


@pytest.mark.asyncio
async def test_a_robot_of_another_process_moves(robot: str) -> None:
    async with unity_link.connect(robot) as link:
        scara = unity_link.load(EXAMPLES / "scara.ul")(link)
        await scara.j1.pos_sp.set(30)
        await scara.j2.pos_sp.post(-20)
        async with Group(scara.j1.cpos, scara.j2.cpos).subscribe(rate_hz=100) as samples:
            async for sample in samples:
                if sample.values[scara.j1.cpos] == pytest.approx(30, abs=0.1):
                    break
        assert await scara.j2.cpos.get() == pytest.approx(-20, abs=0.1)


def test_commands_take_the_url(robot: str) -> None:
    program = str(Path(sys.executable).parent / "unity-link")
    done = subprocess.run([program, "info", robot], capture_output=True, text=True, check=True, timeout=60)
    assert "words" in done.stdout
    assert "CRC" not in done.stdout
    subprocess.run([program, "write", robot, "0x8C", "5"], check=True, timeout=60)
    with blocking.connect(robot) as link:
        while link.read(0x88) != 5:
            pass

"""Replays of several groups: at each instant, the bus has the latest samples of all groups."""

from __future__ import annotations

import asyncio
import functools
import itertools
from bisect import bisect_right
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from mcap.reader import make_reader
from mcap.writer import CompressionType, Writer

import unity_link
from support.recordings import work_in_place
from support.simulated_time import run_simulated
from unity_link.bridges.recording import Recorder, Recording, chunks, reader, replay
from unity_link.bridges.recording.files import RecordingFile
from unity_link.bridges.sampled import sampled_groups
from unity_link.data import Batch
from unity_link.data.layout import GroupLayout
from unity_link.link.publishing import Sample
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.spec import compile_text
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from pathlib import Path

SPEC = """
group fast(1, 10, TIMESTAMPS);
group slow(2, 200, TIMESTAMPS);
public robot() {
  @a = 0x10: READ(PUBLISH(fast));
  @b = 0x11: READ(PUBLISH(fast));
  @c = 0x12: READ(PUBLISH(slow));
  @d = 0x13: READ(POLL(50));
}
"""
WITHOUT_A_PERIOD = """
group triggered(1, TRIGGER);
public robot() {
  @a = 0x10: READ(PUBLISH(triggered));
  @b = 0x11: READ(PUBLISH(triggered));
}
"""
INFO = GatewayInfo(base_frequency_millihertz=2_000_000)
Batches = list[tuple[int, list[tuple[float, tuple[int, ...]]]]]
"""Pairs of a group's number and a batch of its samples, which are pairs of instant in seconds and words."""


class Milliseconds:
    """A device that reads as the time in milliseconds, so that each word contains the instant of its sample."""

    def read(self, offset: int, now: float) -> int:
        return round(now * 1000)

    def write(self, offset: int, value: int, now: float) -> None:
        raise AssertionError


@functools.cache
def robot(spec: str) -> Any:
    async def make() -> Any:
        async with unity_link.connect(VirtualGateway(INFO)) as link:
            return unity_link.load(compile_text(spec))(link)

    return run_simulated(make())


def recorded(path: Path, batches: Batches, syncs: set[int], spec: str = SPEC) -> Recording:
    """Return a recording of batches, with a sync of the file after the batches in `syncs`."""
    groups = sampled_groups(robot(spec))
    file = RecordingFile(path, robot(spec).interface, INFO, groups, overwrite=True)
    counters = [itertools.count() for _ in groups]
    for number, (group, rows) in enumerate(batches):
        layout = GroupLayout(groups[group].group.proxies)
        samples = [Sample(next(counters[group]), None, at, np.array(words, np.uint64), 0) for at, words in rows]
        file.write(group, Batch(layout, samples), np.array([at for at, _ in rows]))
        if number in syncs:
            file.sync()
    file.close()
    return Recording(path)


ADDRESSES = ((0x10, 0x11), (0x12,), (0x13,))
EPOCH = 1_000_000.0


@st.composite
def recordings(draw: st.DrawFn) -> Batches:
    """Draw batches of three groups: those of one group are in order, and groups are mixed at random."""
    batches = []
    for group, addresses in enumerate(ADDRESSES):
        # Instants of one group differ.
        steps = draw(st.lists(st.integers(1, 400), min_size=group == 0, max_size=30))
        words = st.tuples(*(st.integers(1, 0xFFFF_FFFF) for _ in addresses))
        rows = [(EPOCH + at / 128, draw(words)) for at in itertools.accumulate(steps)]
        while rows:
            count = draw(st.integers(1, len(rows)))
            batches.append((group, rows[:count]))
            rows = rows[count:]
    order = draw(st.permutations([group for group, _ in batches]))
    queues = [iter([batch for batch in batches if batch[0] == group]) for group in range(len(ADDRESSES))]
    return [next(queues[group]) for group in order]


@pytest.mark.parametrize("spec", [SPEC, WITHOUT_A_PERIOD], ids=["of a period", "without a period"])
def test_recording_of_one_instant_repeats_its_sample(tmp_path: Path, spec: str) -> None:
    _, player = replay(recorded(tmp_path / "run.mcap", [(0, [(EPOCH, (5, 6))])], set(), spec), loop=True)
    for now in (0.0, 0.1, 5.0, 5000.0):
        assert [player.read(place, now) for place in range(2)] == [5, 6]
        assert not player.ended


@pytest.mark.slow
@given(recordings(), st.sets(st.integers(0, 90)), st.sampled_from([200, 2000, 1 << 22]), st.data())
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_at_each_instant_a_replay_has_the_last_sample_of_each_group(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    batches: Batches,
    syncs: set[int],
    chunk: int,
    data: st.DataObject,
) -> None:
    monkeypatch.setattr(chunks, "CHUNK", chunk)
    recording = recorded(tmp_path / "run.mcap", batches, syncs)
    by_group = [[row for group, rows in batches if group == number for row in rows] for number in range(3)]
    instants = sorted(at for rows in by_group for at, _ in rows)

    order = [row.at for row in recording.in_order()]
    assert order == [round(at * 1e9) for at in instants]

    _, player = replay(recording)
    player.read(0, 0.0)
    # Read halfway between possible instants of samples, counted from the first access.
    asked = sorted(data.draw(st.lists(st.integers(0, 12_000), min_size=1, max_size=30)))
    for steps in asked:
        now = (steps + 0.5) / 128
        for rows, addresses in zip(by_group, ADDRESSES, strict=True):
            past = bisect_right([at for at, _ in rows], instants[0] + now)
            expected = rows[past - 1][1] if past else (0,) * len(addresses)
            assert tuple(player.read(address - 0x10, now) for address in addresses) == expected


def test_chunks_that_all_overlap_are_played_in_bounded_memory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reader, "MOST_WORDS", 100)
    batches: Batches = [(0, [(EPOCH, (number, 0)), (EPOCH + 10 + number, (number, 1))]) for number in range(500)]
    recording = recorded(tmp_path / "run.mcap", batches, set(range(500)))
    most = 0

    class Watched(reader._Waiting):
        def add(self, samples: Any) -> None:
            nonlocal most
            super().add(samples)
            most = max(most, self._words)

    monkeypatch.setattr(reader, "_Waiting", Watched)
    words = sorted(tuple(row.words.tolist()) for row in recording.in_order())

    assert words == sorted((number, late) for number in range(500) for late in range(2))
    assert 100 < most <= 104


@pytest.mark.parametrize("compression", CompressionType)
@pytest.mark.parametrize("chunked", [True, False])
def test_a_recording_that_another_program_wrote_anew_is_played_the_same(
    tmp_path: Path, compression: CompressionType, chunked: bool
) -> None:
    batches: Batches = [(1, [(EPOCH + 1, (7,))]), (0, [(EPOCH + at / 10, (at, at)) for at in range(30)])]
    recording = recorded(tmp_path / "run.mcap", batches, set())
    again = tmp_path / "again.mcap"
    with recording.path.open("rb") as source, again.open("wb") as target:
        reader, writer = make_reader(source), Writer(target, compression=compression, use_chunking=chunked)
        writer.start()
        for attachment in reader.iter_attachments():
            writer.add_attachment(0, 0, attachment.name, attachment.media_type, attachment.data)
        summary = reader.get_summary()
        assert summary is not None
        for schema in summary.schemas.values():
            writer.register_schema(schema.name, schema.encoding, schema.data)
        for channel in summary.channels.values():
            writer.register_channel(channel.topic, "json", channel.schema_id, channel.metadata)
        for _, channel, message in reader.iter_messages(log_time_order=False):
            writer.add_message(channel.id, message.log_time, message.data, message.publish_time, message.sequence)
        writer.finish()

    rows = [[(row.at, row.group, row.words.tolist()) for row in of.in_order()] for of in (recording, Recording(again))]

    assert rows[0] == rows[1]
    assert len(rows[0]) == 31


def test_two_groups_of_different_rate_are_replayed_side_by_side(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    work_in_place(monkeypatch)
    path = tmp_path / "run.mcap"

    async def record() -> None:
        gateway = VirtualGateway(INFO)
        gateway.attach(Milliseconds(), range(0x10, 0x14))
        async with unity_link.connect(gateway) as link:
            running = asyncio.create_task(Recorder(unity_link.load(compile_text(SPEC))(link), path).run())
            await asyncio.sleep(3)
            running.cancel()
            await asyncio.wait([running])

    async def play() -> list[tuple[int, int]]:
        gateway, _ = replay(Recording(path))
        async with unity_link.connect(gateway) as link:
            seen = []
            for _ in range(250):
                fast, slow = await link.read_many([0x10, 0x12])
                seen.append((int(fast), int(slow)))
                await asyncio.sleep(0.01)
            return seen

    run_simulated(record())
    seen = run_simulated(play())

    # 200 and 10 samples a second: the slow group lags by at most its period, and the fast group never waits.
    assert len({fast for fast, _ in seen}) > 240
    assert all(0 <= fast - slow <= 110 for fast, slow in seen if slow)
    assert sum(slow == 0 for _, slow in seen) <= 11

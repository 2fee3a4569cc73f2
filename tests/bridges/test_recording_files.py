"""The file of a recording as other programs read it: the readers of mcap, its doctor, and viewers."""

from __future__ import annotations

import asyncio
import io
import json
import math
import struct
import subprocess
import sys
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import jsonschema
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mcap.exceptions import McapError
from mcap.reader import NonSeekingReader, make_reader
from mcap.records import Chunk, MessageIndex
from mcap.stream_reader import StreamReader, get_chunk_data_stream
from zstandard import ZstdError

import unity_link
from generate.every_kind import every_kind
from support.recordings import record, sequence_in
from unity_link.bridges.messages import Encoder
from unity_link.bridges.recording import Recording
from unity_link.bridges.recording.chunks import CHUNK, ChunkWriter
from unity_link.data import Batch
from unity_link.data.layout import GroupLayout
from unity_link.link.publishing import Sample
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from collections.abc import Iterator

    from mcap.records import McapRecord, Message

TOPICS = ("/robot/fast", "/robot/slow")
MESSAGES = 1000
PERIOD = 1_000_000
"""Nanoseconds between messages of the fast channel; the slow channel has a message at each tenth."""
CHUNKS = 4


def data_of(topic: str, number: int) -> bytes:
    return json.dumps({"topic": topic, "number": number, "text": "x" * (number % 50)}).encode()


@pytest.fixture(scope="module")
def written() -> bytes:
    """Return a file with two channels in four chunks, and other records between the chunks."""
    stream = io.BytesIO()
    writer = ChunkWriter(stream, "test")
    writer.attach("a.json", "application/json", b"{}")
    channels = [writer.open_channel(topic, topic[1:], b'{"type": "object"}', {"of": topic}) for topic in TOPICS]
    for part in np.split(np.arange(MESSAGES), CHUNKS):
        for channel, topic, numbers in zip(channels, TOPICS, (part, part[::10]), strict=True):
            for some in np.array_split(numbers, 3):
                writer.write(channel, some * PERIOD + PERIOD, some, [data_of(topic, int(number)) for number in some])
        writer.end_chunk()
        writer.note("a pause", {"after": str(part[-1])})
    writer.finish()
    return stream.getvalue()


def expected(topic: str) -> list[tuple[int, int, bytes]]:
    numbers = range(0, MESSAGES, 1 if topic == TOPICS[0] else 10)
    return [(number, (number + 1) * PERIOD, data_of(topic, number)) for number in numbers]


def facts(messages: Iterator[tuple[Any, Any, Message]], topic: str) -> list[tuple[int, int, bytes]]:
    return [
        (message.sequence, message.log_time, message.data) for _, channel, message in messages if channel.topic == topic
    ]


@pytest.mark.parametrize("topic", TOPICS)
def test_seeking_and_streaming_readers_find_all_messages_and_right_checksums(written: bytes, topic: str) -> None:
    seeking = make_reader(io.BytesIO(written), validate_crcs=True)
    streaming = NonSeekingReader(io.BytesIO(written), validate_crcs=True)

    assert facts(seeking.iter_messages(), topic) == expected(topic)
    assert facts(streaming.iter_messages(), topic) == expected(topic)


@pytest.mark.parametrize("place", range(100, 8000, 790))
def test_a_byte_that_was_changed_is_seen(written: bytes, place: int) -> None:
    damaged = bytearray(written)
    damaged[place] ^= 0x10

    with pytest.raises((McapError, ValueError, ZstdError, struct.error)):
        list(NonSeekingReader(io.BytesIO(damaged), validate_crcs=True).iter_messages())


@pytest.mark.parametrize("topic", TOPICS)
def test_a_reader_gets_a_time_range_of_one_topic(written: bytes, topic: str) -> None:
    reader = make_reader(io.BytesIO(written), validate_crcs=True)
    begin, end = 301 * PERIOD, 701 * PERIOD

    found = facts(reader.iter_messages(topics=[topic], starting_at=begin, ending_before=end), topic)

    assert found == [fact for fact in expected(topic) if begin <= fact[1] < end]


def test_the_index_of_messages_leads_to_each_of_them(written: bytes) -> None:
    emitted: list[McapRecord] = list(StreamReader(io.BytesIO(written), emit_chunks=True).records)
    found: dict[int, list[int]] = {1: [], 2: []}
    stream = b""
    for found_record in emitted:
        if isinstance(found_record, Chunk):
            stream = chunk_data(found_record)
        elif isinstance(found_record, MessageIndex):
            for instant, offset in found_record.records:
                assert stream[offset] == 5
                length = int.from_bytes(stream[offset + 1 : offset + 9], "little")
                channel, sequence = stream[offset + 9], int.from_bytes(stream[offset + 11 : offset + 15], "little")
                assert (channel, instant) == (found_record.channel_id, (sequence + 1) * PERIOD)
                assert stream[offset + 31 : offset + 9 + length] == data_of(TOPICS[channel - 1], sequence)
                found[channel].append(sequence)
    assert found == {1: list(range(MESSAGES)), 2: list(range(0, MESSAGES, 10))}


def chunk_data(chunk: Chunk) -> bytes:
    stream, length = get_chunk_data_stream(chunk, validate_crc=True)
    data: bytes = stream.read(length)
    return data


def test_summary_lists_the_contents_of_the_file(written: bytes) -> None:
    reader = make_reader(io.BytesIO(written), validate_crcs=True)
    summary = reader.get_summary()
    assert summary is not None
    statistics = summary.statistics
    assert statistics is not None
    assert statistics.message_count == MESSAGES + MESSAGES // 10
    assert statistics.channel_message_counts == {1: MESSAGES, 2: MESSAGES // 10}
    assert (statistics.message_start_time, statistics.message_end_time) == (PERIOD, MESSAGES * PERIOD)
    assert (statistics.chunk_count, statistics.attachment_count, statistics.metadata_count) == (CHUNKS, 1, CHUNKS)
    assert {channel.topic for channel in summary.channels.values()} == set(TOPICS)
    assert [index.message_end_time for index in summary.chunk_indexes] == [250_000_000 * n for n in range(1, 5)]
    assert all(before.message_end_time < after.message_start_time for before, after in pairwise(summary.chunk_indexes))
    assert [attachment.data for attachment in reader.iter_attachments()] == [b"{}"]
    assert [note.metadata for note in reader.iter_metadata()] == [{"after": str(n)} for n in (249, 499, 749, 999)]


def test_a_chunk_that_is_large_ends_by_itself() -> None:
    stream = io.BytesIO()
    writer = ChunkWriter(stream, "test")
    channel = writer.open_channel("/a", "a", b'{"type": "object"}', {})
    data = json.dumps("x" * (CHUNK // 4)).encode()
    for number in range(10):
        writer.write(channel, np.array([number]), np.array([number]), [data])
    writer.finish()

    summary = make_reader(io.BytesIO(stream.getvalue())).get_summary()

    assert summary is not None
    assert len(summary.chunk_indexes) == 3
    assert sum(1 for _ in make_reader(io.BytesIO(stream.getvalue()), validate_crcs=True).iter_messages()) == 10


def test_many_messages_given_at_once_go_into_several_chunks() -> None:
    stream = io.BytesIO()
    writer = ChunkWriter(stream, "test")
    channel = writer.open_channel("/a", "a", b'{"type": "object"}', {})
    numbers = np.arange(5 * CHUNK // 1000)
    writer.write(channel, numbers, numbers, [b"%01000d" % number for number in numbers])
    writer.finish()

    reader = make_reader(io.BytesIO(stream.getvalue()), validate_crcs=True)
    summary = reader.get_summary()
    messages = list(reader.iter_messages())

    assert summary is not None
    assert max(index.uncompressed_size for index in summary.chunk_indexes) < 2 * CHUNK
    assert [int(message.data) for _, _, message in messages] == numbers.tolist()


def test_a_file_without_messages_is_one() -> None:
    stream = io.BytesIO()
    writer = ChunkWriter(stream, "test")
    writer.open_channel("/a", "a", b'{"type": "object"}', {})
    writer.finish()

    summary = make_reader(io.BytesIO(stream.getvalue())).get_summary()

    assert summary is not None
    assert list(NonSeekingReader(io.BytesIO(stream.getvalue()), validate_crcs=True).iter_messages()) == []


def assert_foxglove_takes(schema: dict[str, Any], what: str) -> None:
    """Assert what Foxglove's reader of JSON schemas requires (parseJsonSchema.ts of Foxglove Studio and Lichtblick)."""
    assert schema["type"] == "object", what
    for name, part in schema["properties"].items():
        shown = part
        if part["type"] == "array":
            shown = part["items"]
            assert shown["type"] != "array", f"{what}.{name}"
        assert isinstance(shown["type"], str)
        assert shown["type"] in ("boolean", "string", "number", "integer", "object"), f"{what}.{name}"
        assert "contentEncoding" not in shown
        if shown["type"] == "object":
            assert_foxglove_takes(shown, f"{what}.{name}")


FLOATS = """
public robot() { legs[2]: leg() @(0x10 * i); @row[3] = 0x80 + i: float 32 READ(); @gap[3] = 0x90 + i: READ(); }
leg(): @(base) { @load = base: float 32 READ(); @heat = base + 1: float 32 READ(); @on = base + 2: bool READ(); }
"""
FLOAT_PATHS = ["legs[0].load", "legs[0].heat", "legs[1].load", "row[0]", "row[2]"]
WORDS = {math.nan: 0x7FC00000, math.inf: 0x7F800000, -math.inf: 0xFF800000, 0.0: 0, 1.5: 0x3FC00000}


async def _robot_of_floats() -> Any:
    async with unity_link.connect("sim:") as link:
        return unity_link.load(compile_text(FLOATS))(link)


@pytest.fixture(scope="module")
def robot_of_floats() -> Any:
    return asyncio.run(_robot_of_floats())


@given(
    rows=st.lists(st.tuples(*[st.sampled_from([*WORDS])] * len(FLOAT_PATHS)), min_size=1, max_size=5),
    time=st.none() | st.floats(0, 1e6),
)
def test_every_message_fits_its_schema_and_has_all_representable_values(
    robot_of_floats: Any, rows: list[tuple[float, ...]], time: float | None
) -> None:
    signals = [robot_of_floats[path] for path in [*FLOAT_PATHS, "legs[1].on", "gap[1]"]]
    words = [np.array([*map(WORDS.__getitem__, row), 1, 7], np.uint64) for row in rows]
    samples = [Sample(number, time, 0.0, values, 0) for number, values in enumerate(words)]
    encoder = Encoder([proxy.signal for proxy in signals])
    messages = [json.loads(message) for message in encoder.encode(Batch(GroupLayout(signals), samples), 32)]

    assert_foxglove_takes(encoder.schema, "message")
    for number, (row, message) in enumerate(zip(rows, messages, strict=True)):
        jsonschema.Draft202012Validator(encoder.schema).validate(message)
        known = [value if math.isfinite(value) else None for value in row]
        assert message.get("time") == time
        assert message["sequence"] == number
        first, second = message["signals"]["legs"]
        assert (first.get("load"), first.get("heat"), second.get("load"), second["on"]) == (*known[:3], True)
        assert message["signals"]["row"] == [known[3], None, known[4]]
        assert message["signals"]["gap"] == [None, 7]
        assert None not in [*first.values(), *second.values(), message.get("time", 0)]


LEGS = """
public robot() { legs[3]: leg() @(0x10 * i); @on = 0x80: bool READ(); }
leg(): @(base) { joints[2]: joint() @(base + 2 * i); @load = base + 8: float 32 READ(); }
joint(): @(base) { @pos = base: signed READ(); }
"""


@pytest.mark.parametrize("paths", [None, ["legs[2].joints[1].pos", "on"]], ids=["all", "some"])
@pytest.mark.parametrize("spec", [LEGS, None], ids=["arrays", "every kind"])
def test_foxglove_takes_the_schema_of_any_group(spec: str | None, paths: list[str] | None) -> None:
    interface = (compile_text(spec) if spec else every_kind(32)).interface()
    signals = [signal for path, signal in interface.signals.items() if paths is None or path in paths]

    assert_foxglove_takes(Encoder(signals or list(interface.signals.values())).schema, "message")


# Another program that reads the format


def judge(*arguments: str | Path) -> subprocess.CompletedProcess[str]:
    program = Path(sys.executable).parent / "pymcap-cli"
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=120, check=False)


@pytest.mark.slow
def test_a_recording_passes_the_check_against_the_specification_of_mcap(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"
    recorder = record(path, lambda recorder: recorder.samples >= 200, poll_hz=50)

    verdict = judge("doctor", path)

    assert verdict.returncode == 0, verdict.stdout + verdict.stderr
    assert f"{recorder.samples} messages" in " ".join((verdict.stdout + verdict.stderr).split())


@pytest.mark.slow
def test_a_file_of_many_channels_chunks_and_notes_passes_it_too(written: bytes, tmp_path: Path) -> None:
    path = tmp_path / "written.mcap"
    path.write_bytes(written)

    verdict = judge("doctor", path)

    assert verdict.returncode == 0, verdict.stdout + verdict.stderr


@pytest.mark.slow
def test_doctor_finds_damage(written: bytes, tmp_path: Path) -> None:
    path = tmp_path / "damaged.mcap"
    path.write_bytes(written[:2000] + bytes(50) + written[2050:])

    assert judge("doctor", path).returncode != 0


@pytest.mark.slow
def test_mcap_recover_repairs_a_cut_recording_for_other_tools(tmp_path: Path) -> None:
    whole, cut, recovered = (tmp_path / f"{name}.mcap" for name in ("whole", "cut", "recovered"))
    record(whole, lambda recorder: recorder.samples >= 400)
    with whole.open("rb") as file:
        summary = make_reader(file).get_summary()
    assert summary is not None
    # Cut the file in the middle of the last chunk.
    cut.write_bytes(whole.read_bytes()[: summary.chunk_indexes[-1].chunk_start_offset + 100])

    judge("recover", cut, "-o", recovered)

    assert judge("doctor", recovered).returncode == 0
    assert sequence_in(recovered) == sequence_in(cut) != []


# PlotJuggler


def series(prefix: str, value: Any) -> dict[str, Any]:
    """Return the numbers and booleans that PlotJuggler makes curves of, by its names for them."""
    if isinstance(value, dict):
        return {name: leaf for key, item in value.items() for name, leaf in series(f"{prefix}/{key}", item).items()}
    if isinstance(value, list):
        return {name: leaf for i, item in enumerate(value) for name, leaf in series(f"{prefix}[{i}]", item).items()}
    return {prefix: value} if isinstance(value, bool | int | float) else {}


def test_plotjuggler_makes_a_curve_of_each_signal(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"
    record(path, lambda recorder: recorder.samples >= 50)
    (group,) = Recording(path).groups

    with path.open("rb") as file:
        reader = make_reader(file)
        summary = reader.get_summary()
        messages = list(reader.iter_messages())

    # PlotJuggler finds the channels in the summary alone; each channel must have a schema.
    assert summary is not None
    assert set(summary.schemas) == {channel.schema_id for channel in summary.channels.values()}
    assert all(message.publish_time == message.log_time for _, _, message in messages)
    curves = [series(channel.topic, json.loads(message.data)) for _, channel, message in messages]
    for signal in group.signals:
        values = [curve["/scara/state/signals/" + signal.path.replace(".", "/")] for curve in curves]
        # The first value of a curve decides its type.
        assert {type(value) for value in values} == {float}, signal.path

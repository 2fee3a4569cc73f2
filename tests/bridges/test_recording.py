"""Recordings: the contents of the file, and their replay and export."""

from __future__ import annotations

import asyncio
import itertools
import json
import math
import os
import re
import signal
import subprocess
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mcap.reader import make_reader
from pyarrow import csv, parquet

import unity_link
from generate.every_kind import every_kind
from support.bridge_programs import PROGRAM
from support.recordings import SPEC, record, run
from support.simulated_time import run_simulated
from unity_link import ArgumentError, BusError
from unity_link.bridges.messages import hex_to_words, words_to_hex
from unity_link.bridges.recording import Recorder, Recording, RecordingError, export, replay
from unity_link.spec.columns import Columns

if TYPE_CHECKING:
    from unity_link.spec import Signal


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("recording") / "run.mcap"
    record(path, lambda recorder: recorder.samples >= 100)
    return path


@given(st.integers(8, 64), st.integers(1, 5), st.data())
def test_words_survive_being_written_as_hex(bits: int, addresses: int, data: st.DataObject) -> None:
    rows = st.lists(st.integers(0, (1 << bits) - 1), min_size=addresses, max_size=addresses)
    words = np.array(data.draw(st.lists(rows, min_size=1, max_size=4)), np.uint64)

    texts = [text.decode() for text in words_to_hex(words, bits)]

    assert np.array_equal(hex_to_words(texts, addresses, bits), words)


def value_in(tree: Any, path: str) -> Any:
    for step in path.replace("[", ".").replace("]", "").split("."):
        tree = tree[int(step)] if isinstance(tree, list) else tree[step]
    return tree


@pytest.mark.parametrize("bits", [16, 64])
def test_a_message_has_each_value_under_its_path_and_the_words_exactly(bits: int, tmp_path: Path) -> None:
    spec = every_kind(bits)
    path = tmp_path / "run.mcap"

    async def run() -> None:
        async with unity_link.connect(f"sim:?data_bits={bits}") as link:
            robot = unity_link.load(spec)(link)
            random = np.random.default_rng(bits)
            for address in range(256):
                await link.write(address, int.from_bytes(random.bytes(bits // 8)))
            recorder = Recorder(robot, path, poll_hz=100)
            running = asyncio.create_task(recorder.run())
            while recorder.samples < 3:  # noqa: ASYNC110  (a thread writes)
                await asyncio.sleep(0.01)
            running.cancel()
            await asyncio.wait([running])

    asyncio.run(run())

    recording = Recording(path)
    (samples, _), *_ = recording.samples()
    signals = {signal.path: signal for signal in samples.group.signals}
    with path.open("rb") as file:
        _, _, message = next(iter(make_reader(file).iter_messages()))
    shown = json.loads(message.data)
    values = Columns(samples.group.signals, samples.group.addresses).decode(samples.words)
    for name, known in signals.items():
        assert_same(value_in(shown["signals"], name), values[name][:1].tolist()[0], known)


def assert_same(shown: Any, value: Any, known: Signal) -> None:
    if isinstance(value, float) and not math.isfinite(value):
        assert shown is None, known.path
    else:
        assert shown == value, known.path


def test_other_programs_find_a_channel_and_a_schema_for_each_group(recorded: Path) -> None:
    with recorded.open("rb") as file:
        summary = make_reader(file).get_summary()
    assert summary is not None
    (channel,) = summary.channels.values()
    (schema,) = summary.schemas.values()
    assert (channel.topic, channel.message_encoding, schema.encoding) == ("/scara/state", "json", "jsonschema")
    properties = json.loads(schema.data)["properties"]["signals"]["properties"]
    assert properties["j1"]["properties"]["cpos"] == {"type": "number", "description": "Current position.; in deg"}


def test_a_recording_has_all_samples_in_order_and_the_robot_that_they_are_of(recorded: Path) -> None:
    recording = Recording(recorded)

    batches = [samples for samples, _ in recording.samples()]

    sequence = np.concatenate([samples.sequence for samples in batches])
    times = np.concatenate([samples.time for samples in batches])
    instants = np.concatenate([samples.at for samples in batches])
    assert recording.interface == unity_link.load(SPEC).interface
    assert np.array_equal(sequence, np.arange(len(sequence)))
    assert np.allclose(np.diff(times), 1 / 200)
    assert np.allclose(np.diff(instants), 5_000_000, rtol=0.02)
    assert not recording.was_cut


def test_unpublished_signals_are_recorded_if_a_polling_rate_is_given(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"
    record(path, lambda recorder: recorder.samples >= 50, poll_hz=20)

    groups = {group.name: [signal.path for signal in group.signals] for group in Recording(path).groups}

    assert groups["state"][:2] == ["j1.cpos", "j1.spd"]
    assert groups["rest"][:2] == ["j1.pos_sp", "j1.spd_sp"]


def test_a_spec_that_publishes_nothing_is_not_recorded_silently(tmp_path: Path) -> None:
    spec = tmp_path / "robot.ul"
    spec.write_text("public robot() { @a = 1: READ(); }")

    result = run("record", "sim:", spec, "-o", tmp_path / "run.mcap")

    assert (result.returncode, result.stdout) == (2, "")
    assert "nothing says when signals of robot are to be sampled" in result.stderr


# Replay and export


def test_a_replay_publishes_each_recorded_sample_once(recorded: Path) -> None:
    recording = Recording(recorded)
    words = np.concatenate([samples.words for samples, _ in recording.samples()])

    async def watch() -> list[Any]:
        gateway, _ = replay(recording)
        async with unity_link.connect(gateway) as link:
            addresses = recording.groups[0].addresses
            async with link.subscribe(addresses, divisor=100) as samples:
                return [(await anext(samples)).values for _ in range(len(words))]

    assert np.array_equal(np.array(run_simulated(watch())), words)


def test_replay_refuses_writes_to_recorded_signals_and_accepts_others(recorded: Path) -> None:
    async def write() -> None:
        gateway, _ = replay(Recording(recorded))
        async with unity_link.connect(gateway) as link:
            await link.write(0x8C, 1)
            with pytest.raises(BusError):
                await link.write(0x88, 1)

    run_simulated(write())


@pytest.mark.parametrize("loop", [False, True])
def test_replay_keeps_its_last_sample_or_begins_again(recorded: Path, loop: bool) -> None:
    seen: list[int] = []

    async def play() -> bool:
        gateway, player = replay(Recording(recorded), speed=2, loop=loop)
        async with unity_link.connect(gateway) as link:
            for _ in range(500):
                seen.append(await link.read(0x88))
                await asyncio.sleep(0.01)
            return player.ended

    ended = run_simulated(play())

    begins_again = any(later < earlier for earlier, later in itertools.pairwise(seen))
    assert (begins_again, ended) == (loop, not loop)


def test_a_replay_is_served_to_other_programs(recorded: Path, tmp_path: Path) -> None:
    place = tmp_path / "replay"
    with subprocess.Popen([PROGRAM, "replay", str(recorded), "--unix", str(place)], stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        url = process.stdout.readline().decode().strip()
        again = tmp_path / "again.mcap"
        result = run("record", url, SPEC, "-o", again, "--duration", "0.5")
        process.send_signal(signal.SIGINT)
    assert result.returncode == 0
    assert process.returncode == 130
    assert sum(len(samples.at) for samples, _ in Recording(again).samples()) > 0


@pytest.mark.parametrize("form", ["parquet", "csv"])
def test_a_table_has_a_row_for_each_sample_and_a_column_for_each_signal(
    recorded: Path, tmp_path: Path, form: str
) -> None:
    recording = Recording(recorded)
    ((samples, _),) = recording.samples()
    done: list[int] = []

    (path,) = export(recording, form, tmp_path, done.append)

    table = (parquet.read_table if form == "parquet" else csv.read_csv)(path)
    values = Columns(samples.group.signals, samples.group.addresses).decode(samples.words)
    assert path.name == f"run.state.{form}"
    assert table.column_names == ["time", "gateway_time", "sequence", "lost", *values]
    assert table["sequence"].to_pylist() == samples.sequence.tolist()
    for name, column in values.items():
        assert table[name].to_pylist() == pytest.approx(column.tolist())
    assert done
    if form == "parquet":
        assert table.schema.field("j1.cpos").metadata[b"unit"] == b"deg"
        assert table["time"].cast("int64").to_pylist() == samples.at.tolist()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["export", "nosuch.mcap", "--csv"], "nosuch.mcap cannot be read: No such file or directory"),
        (["export", str(SPEC), "--csv"], "is no MCAP file"),
        (["export", str(SPEC)], "one of --parquet and --csv was expected"),
        (["replay", str(SPEC), "--pty"], "is no MCAP file"),
        (["replay", str(SPEC)], "one of --pty, --tcp and --unix was expected"),
        (["record", "sim:scara", str(SPEC)], "Missing option '--output'"),
        (["record", "sim:scara", str(SPEC), "-o", "/nosuch/run.mcap"], "/nosuch/run.mcap cannot be written"),
        (["record", "sim:scara", str(SPEC), "-o", "/tmp"], "/tmp is a directory: the name of a file was expected"),
        (["record", "sim:scara", str(SPEC), "-o", "/tmp", "--overwrite"], "/tmp is a directory: the name of a file"),
        (
            ["record", "sim:scara", str(SPEC), "-o", "x.csv"],
            "record x.mcap, and unity-link export x.mcap --csv makes tables of it",
        ),
        (["record", "sim:scara", str(SPEC), "-o", "x.JSON"], "x.JSON names another form than MCAP, which recordings"),
        (["record", "sim:scara", str(SPEC), "-o", "x", "--poll", "0"], "more than 0 Hz was expected"),
    ],
    ids=lambda value: " ".join(Path(word).name for word in value) if isinstance(value, list) else "",
)
def test_wrong_use_is_reported_in_one_sentence(arguments: list[str], words: str) -> None:
    result = run(*arguments)
    assert result.returncode in {1, 2}
    assert words in result.stderr


def test_replay_at_an_impossible_speed_is_refused(recorded: Path) -> None:
    for speed in (0, 1e300, math.inf):
        words = re.escape(f"a speed of {speed:g} was asked for, expected more than 0 and at most 1e+06")
        with pytest.raises(ArgumentError, match=words):
            replay(Recording(recorded), speed=speed)


def test_a_table_is_not_taken_for_the_folder_of_tables(recorded: Path, tmp_path: Path) -> None:
    with pytest.raises(ArgumentError, match=r"x\.csv is named like a file: the name of a folder was expected"):
        export(Recording(recorded), "csv", tmp_path / "x.csv")
    with pytest.raises(ArgumentError, match=r"x\.csv names another form than MCAP"):
        record(tmp_path / "x.csv", lambda _: True)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("form", ["csv", "parquet"])
def test_an_export_that_is_interrupted_leaves_the_tables_as_they_were(
    form: str, recorded: Path, tmp_path: Path
) -> None:
    def interrupt(_: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        export(Recording(recorded), form, tmp_path / "none", interrupt)
    assert list((tmp_path / "none").iterdir()) == []

    tables = {path: path.read_bytes() for path in export(Recording(recorded), form, tmp_path / "some")}
    with pytest.raises(KeyboardInterrupt):
        export(Recording(recorded), form, tmp_path / "some", interrupt)
    assert {path: path.read_bytes() for path in (tmp_path / "some").iterdir()} == tables


@pytest.mark.parametrize("form", ["csv", "parquet"])
def test_table_with_the_name_of_a_directory_is_reported_by_that_name(form: str, recorded: Path, tmp_path: Path) -> None:
    taken = tmp_path / f"{recorded.stem}.state.{form}"
    taken.mkdir()
    with pytest.raises(RecordingError, match=f"^{re.escape(str(taken))} cannot be written: Is a directory$"):
        export(Recording(recorded), form, tmp_path)
    assert list(tmp_path.glob("*.part")) == []


def test_directory_that_cannot_be_written_is_reported(recorded: Path) -> None:
    with pytest.raises(RecordingError, match="cannot be written"):
        export(Recording(recorded), "csv", Path(os.devnull) / "x")

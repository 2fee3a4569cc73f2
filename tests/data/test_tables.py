"""Samples as tables of numpy, pandas and polars: the same columns, units and instants, live and recorded."""

from __future__ import annotations

import asyncio
import datetime as dt
import functools
import math
import subprocess
import sys
from typing import TYPE_CHECKING, Any

import numpy as np
import polars as pl
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pyarrow import parquet

import unity_link
from generate.every_kind import every_kind
from support.recordings import record
from support.searching import examples
from unity_link import ArgumentError
from unity_link.bridges.recording import Recorder, Recording, export
from unity_link.data import Batch, Group
from unity_link.data.layout import GroupLayout
from unity_link.data.tables import column_names
from unity_link.errors import UnknownNameError
from unity_link.link.publishing import Sample
from unity_link.spec import compile_text
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from pathlib import Path

    from unity_link.data import Robot

SPEC = compile_text("""
enum mode { off, on = 3 }
group state(1, 10);
public robot() {
  @time = 0x11: signed READ(PUBLISH(state), SCALE=0.5, UNIT="deg");
  @lost = 0x12: READ(PUBLISH(state));
  @mode = 0x13[1:0]: mode READ(PUBLISH(state));
  @up = 0x13[2]: bool READ(PUBLISH(state));
}
""")


@functools.cache
def robot_of(bits: int | None) -> Robot:
    """Return a robot with every kind of signal in words of `bits` bits, or that of this file; its link is closed."""

    async def open_and_close() -> Robot:
        spec = SPEC if bits is None else every_kind(bits)
        async with unity_link.connect(f"sim:?data_bits={bits or 32}") as link:
            return unity_link.load(spec)(link)

    return asyncio.run(open_and_close())


def batch_of(robot: Robot, rows: Any, times: list[float] | None = None, arrived: list[float] | None = None) -> Batch:
    layout = GroupLayout([proxy for proxy in robot.signals if proxy.signal.access.reads and not proxy.signal.fifo])
    words = [np.resize(np.array(row, np.uint64), len(layout.addresses)) for row in rows]
    return Batch(
        layout,
        [
            Sample(
                number,
                times[number] if times else None,
                arrived[number] if arrived else 100.0 + number,
                row,
                lost=number % 2,
                epoch=1,
            )
            for number, row in enumerate(words)
        ],
    )


ROWS = [[3, 7, 7], [0xFFFF_FFFF, 1, 0], [4, 2, 2]]


@pytest.mark.slow
@pytest.mark.parametrize("bits", [16, 32, 64])
@settings(max_examples=examples(30))
@given(data=st.data())
def test_tables_of_all_three_libraries_have_the_values_of_the_samples(bits: int, data: st.DataObject) -> None:
    words = st.lists(st.integers(0, (1 << bits) - 1), min_size=1, max_size=40)
    rows = data.draw(st.lists(words, min_size=1, max_size=3))
    batch = batch_of(robot_of(bits), rows, [float(number) for number in range(len(rows))])

    array, pandas, polars = batch.to_numpy(), batch.to_pandas(), batch.to_polars()

    assert array.dtype.names is not None
    assert list(array.dtype.names) == polars.columns == ["time", *pandas.columns]
    assert array["time"].tolist() == polars["time"].to_list() == pandas.index.tolist()
    for proxy in batch.proxies:
        slow: list[Any] = [sample[proxy] for sample in batch]
        for column in (array[proxy.path], pandas[proxy.path].to_numpy(), polars[proxy.path].to_numpy()):
            np.testing.assert_array_equal(column, np.array(slow, array[proxy.path].dtype))


def test_columns_are_paths_and_reserved_names_get_an_underscore() -> None:
    batch = batch_of(robot_of(None), ROWS)

    frame = batch.to_pandas(counts=True)

    assert list(frame.columns) == ["sequence", "lost", "epoch", "time_", "lost_", "mode", "up"]
    assert list(batch.to_polars().columns) == ["time", "time_", "lost_", "mode", "up"]
    assert frame["lost"].tolist() == [0, 1, 0]
    assert frame["lost_"].tolist() == [7, 1, 2]
    assert frame["time_"].tolist() == [1.5, -0.5, 2.0]
    assert frame["mode"].tolist() == [3, 0, 2]
    assert frame["up"].tolist() == [True, False, False]


@given(st.lists(st.sampled_from(["a", "a_", "a__", "b", "lost", "lost_"]), unique=True))
def test_column_names_are_unique_and_change_only_if_they_are_taken(paths: list[str]) -> None:
    names = column_names(paths, ["lost", "a"])

    assert len({*names, "lost", "a"}) == len(names) + 2
    assert all(name == path for name, path in zip(names, paths, strict=True) if path not in ("lost", "a"))


def test_tables_have_units_and_names_of_enumerations_if_the_library_can() -> None:
    batch = batch_of(robot_of(None), ROWS)

    frame = batch.to_pandas()

    assert frame.attrs == {"units": {"time_": "deg"}, "names": {"mode": {0: "off", 3: "on"}}}
    assert frame["time_"].attrs["units"]["time_"] == "deg"
    assert frame["mode"].map(frame.attrs["names"]["mode"]).tolist()[:2] == ["on", "off"]
    assert batch.table.units == {"time_": "deg"}


def test_utc_times_are_based_on_the_sample_with_the_shortest_delay() -> None:
    batch = batch_of(robot_of(None), ROWS, times=[50.0, 51.0, 52.0], arrived=[1000.5, 1001.25, 1002.5])

    assert batch.to_pandas().index.tolist() == [50.0, 51.0, 52.0]
    utc = batch.to_pandas(time="utc").index
    assert [instant.timestamp() for instant in utc] == [1000.25, 1001.25, 1002.25]
    assert batch.to_polars(time="utc")["time"].to_list()[0] == dt.datetime.fromtimestamp(1000.25, dt.UTC)
    assert batch.to_polars(time="utc").schema["time"] == pl.Datetime("ns", "UTC")
    assert batch.to_numpy(time="utc")["time"][0] == np.datetime64("1970-01-01T00:16:40.25")


def test_seconds_without_timestamps_never_go_back_if_the_clock_is_set() -> None:
    batch = batch_of(robot_of(None), ROWS, arrived=[5000.0, 5001.0, 1000.0])

    seconds = batch.to_numpy()["time"]

    assert np.all(np.diff(seconds) >= 0)
    assert seconds[-1] == batch.at


def test_another_clock_is_refused() -> None:
    with pytest.raises(ArgumentError, match=r"^time is \"seconds\" or \"utc\", not 'gmt'$"):
        batch_of(robot_of(None), ROWS).to_numpy(time="gmt")  # type: ignore[arg-type]


def test_a_frame_is_a_copy() -> None:
    batch = batch_of(robot_of(None), ROWS)

    frame = batch.to_pandas()
    frame.loc[:, "lost_"] = 0

    assert batch["lost"].tolist() == [7, 1, 2]


def test_groups_of_the_spec_and_of_the_program_have_tables() -> None:
    async def take() -> tuple[Batch, Batch]:
        async with unity_link.connect(VirtualGateway()) as link:
            robot = unity_link.load(SPEC)(link)
            async with robot.groups["state"].subscribe() as published:
                declared = await published.take(3)
            async with Group(robot["lost"], robot["up"], rate_hz=1000).subscribe() as samples:
                return declared, await samples.take(3)

    declared, own = asyncio.run(take())

    assert declared.to_pandas().shape == (3, 4)
    assert own.to_polars().columns == ["time", "lost_", "up"]
    assert np.all(np.diff(own.to_numpy()["time"]) > 0)


def test_signals_of_two_robots_with_the_same_path_cannot_be_a_table() -> None:
    async def take() -> Batch:
        async with unity_link.connect(VirtualGateway()) as link:
            first, second = (unity_link.load(SPEC)(link) for _ in range(2))
            async with Group(first["lost"], second["lost"], rate_hz=1000).subscribe() as samples:
                return await samples.take(1)

    with pytest.raises(ArgumentError, match="several signals are called 'lost'"):
        asyncio.run(take()).to_numpy()


@pytest.mark.parametrize("library", ["pandas", "polars"])
def test_the_error_for_a_missing_library_names_its_extra(library: str) -> None:
    script = f"""
import sys
sys.modules[{library!r}] = None
import numpy as np
from unity_link.data import Table
none = np.empty(0)
try:
    Table([], [], seconds=none, instants=none, counts={{}}).to_{library}()
except Exception as error:
    print(type(error).__name__, error, sep=": ")
"""
    result = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60, check=True)
    said = (
        f"UnsupportedError: to_{library} needs {library}, which is not installed: pip install 'unity-link[{library}]'"
    )
    assert result.stdout.strip() == said


def test_pandas_and_polars_are_imported_only_when_they_are_used() -> None:
    script = "import sys, unity_link.data, unity_link.bridges.recording; print({'pandas', 'polars'} & {*sys.modules})"
    result = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60, check=True)
    assert result.stdout.strip() == "set()"


# Recordings


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("recording") / "run.mcap"
    record(path, lambda recorder: recorder.samples >= 50)
    return path


def test_a_recorded_group_has_the_table_of_the_export(recorded: Path, tmp_path: Path) -> None:
    (file,) = export(Recording(recorded), "parquet", tmp_path)
    exported = parquet.read_table(file).to_pandas()

    table = Recording(recorded)["state"]
    frame = table.to_pandas(time="utc", counts=True)

    assert frame.index.tolist() == exported["time"].tolist()
    assert table.to_numpy()["time"].tolist() == exported["gateway_time"].tolist()
    assert frame.reset_index(drop=True).equals(exported.drop(columns=["time", "gateway_time"]))
    assert frame.attrs["units"]["j1.cpos"] == "deg"
    assert len(table) == len(table["j1.cpos"]) == len(frame) > 0


def test_samples_without_timestamps_have_the_seconds_of_utc(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"
    record(path, lambda recorder: recorder.samples >= 20, "sim:scara", poll_hz=50)

    table = Recording(path)["rest"]

    seconds = table.to_numpy()["time"]
    assert np.all(np.diff(seconds) >= 0)
    assert math.isclose(seconds[0], table.to_pandas(time="utc").index[0].timestamp(), abs_tol=1e-6)


def test_the_error_for_a_group_without_a_recording_suggests_the_nearest(recorded: Path) -> None:
    with pytest.raises(UnknownNameError, match=r"run\.mcap has no group 'sttae': did you mean 'state'\?$"):
        Recording(recorded)["sttae"]
    with pytest.raises(UnknownNameError, match=r"^the table has no column 'j1\.cpso': did you mean 'j1\.cpos'"):
        Recording(recorded)["state"]["j1.cpso"]


def test_an_export_has_unique_columns_if_a_signal_has_a_reserved_name(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"

    async def run() -> None:
        async with unity_link.connect(VirtualGateway()) as link:
            recorder = Recorder(unity_link.load(SPEC)(link), path)
            async with recorder:
                while recorder.samples < 3:  # noqa: ASYNC110  (a thread writes)
                    await asyncio.sleep(0.01)

    asyncio.run(run())
    (file,) = export(Recording(path), "parquet", tmp_path)

    assert parquet.read_table(file).column_names == [
        *("time", "gateway_time", "sequence", "lost"),
        *("time_", "lost_", "mode", "up"),
    ]

"""`unity-link explain`: a snoop file as readable text."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

import unity_link
from support.simulated_time import run_simulated
from unity_link.capture import pcapng

PROGRAM = str(Path(sys.executable).parent / "unity-link")


def run(*arguments: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [PROGRAM, *map(str, arguments)],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
        env=os.environ | {"TZ": "UTC"},
    )


@pytest.fixture
def snoop(tmp_path: Path) -> Path:
    """Return the snoop file of a link on simulated time."""
    path = tmp_path / "a.snoop"

    async def use() -> None:
        async with unity_link.connect(f"sim:?bytes_per_second=1000&snoop={path}") as link:
            await link.write(0x0A, 42)
            await link.read(0x0A)

    async def subscribe() -> None:
        async with unity_link.connect(f"sim:?snoop={path}") as link, link.subscribe([0x0A], rate_hz=10) as samples:
            await anext(aiter(samples))

    run_simulated(use())
    run_simulated(subscribe())
    return path


def test_explain_prints_time_direction_and_meaning_of_frames_and_a_summary(snoop: Path) -> None:
    result = run("explain", snoop)
    assert result.returncode == 0
    lines = [" ".join(line.split()) for line in result.stdout.splitlines()]
    assert lines[0] == f"0.000000 0 - connected: sim:?bytes_per_second=1000&snoop={snoop}"
    assert [line.split(" ", 1)[1] for line in lines if "0x0A" in line][:4] == [
        "0 > w0000A0000002AE020 write 0x0000002A (42) to 0x0A (ID 000)",
        "0 < w000BC6B write to 0x0A done (ID 000)",
        "0 > r0010A05BD read 0x0A (ID 001)",
        "0 < r0010000002A5930 read of 0x0A: 0x0000002A (42) (ID 001)",
    ]
    assert any(line.startswith("0.") and " 1 < P0000" in line and line.endswith(": 0x0A = 0") for line in lines)
    assert "0.000000 is " in result.stderr
    assert "1 samples; 0 damaged" in result.stderr
    assert "round trip: median" in result.stderr


def test_json_has_an_object_for_each_frame_and_the_summary(snoop: Path) -> None:
    result = run("explain", snoop, "--json")
    objects = [json.loads(line) for line in result.stdout.splitlines()]
    (read,) = [one for one in objects if one.get("command") == "R" and one["direction"] == "received"]
    assert (read["kind"], read["id"], read["connection"], read["words"]) == (
        "answer",
        1,
        0,
        "read of 0x0A: 0x0000002A (42) (ID 001)",
    )
    assert read["round_trip"] == pytest.approx(0.017, abs=1e-6)
    assert objects[0]["kind"] == "connected"
    assert objects[-1]["kind"] == "summary"
    assert objects[-1]["samples"] == 1
    assert result.stderr == ""


def test_explain_shows_a_range_of_time(snoop: Path) -> None:
    times = [json.loads(line).get("time") for line in run("explain", snoop, "--json").stdout.splitlines()]
    middle = times[len(times) // 2]
    result = run("explain", snoop, "--json", "--from", middle, "--to", middle + 1e-7)
    shown = [json.loads(line) for line in result.stdout.splitlines()]
    assert {one["time"] for one in shown[:-1]} == {middle}


def test_whole_records_of_a_cut_file_are_shown_and_the_cut_is_one_sentence(snoop: Path) -> None:
    whole = run("explain", snoop)
    snoop.write_bytes(snoop.read_bytes()[:-7])
    result = run("explain", snoop)
    assert result.returncode == 1
    assert result.stdout.splitlines() == whole.stdout.splitlines()[:-1]
    (error,) = [line for line in result.stderr.splitlines() if line.startswith("error: ")]
    assert error.startswith(f"error: {snoop}: it is cut at byte ")
    assert error.endswith("; all records before it were read")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["missing"], "missing cannot be read: No such file or directory"),
        (["."], ". cannot be read: Is a directory"),
        (["empty"], "empty is no snoop: a file written by ?snoop=FILE or UNITY_LINK_SNOOP was expected"),
        (["text"], "text is no snoop: a file written by ?snoop=FILE or UNITY_LINK_SNOOP was expected"),
        (["other"], "other is no snoop of unity-link, but of dumpcap"),
        (["later"], "later is of another version, 'Unity-Link snoop 2'"),
        (["text", "--from", "2", "--to", "1"], "--to 1 is not after --from 2"),
        (["text", "--from", "inf"], "--from inf: a number of seconds was expected"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_wrong_use_is_one_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: list[str], words: str
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "empty").touch()
    (tmp_path / "text").write_text("dear diary, today nothing happened")
    section = pcapng.section()
    (tmp_path / "later").write_bytes(section.replace(b"snoop 1", b"snoop 2"))
    (tmp_path / "other").write_bytes(section.replace(pcapng.FORM.encode(), b"dumpcap".ljust(len(pcapng.FORM))))
    result = run("explain", *arguments)
    # A missing file is a failure, and no wrong use, as in `check` and `export`.
    assert result.returncode == (1 if "cannot be read" in words else 2)
    assert result.stdout == ""
    (line,) = result.stderr.splitlines()
    assert words in line

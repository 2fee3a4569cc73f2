"""Recordings with one wrong number, text or message: each is read, or refused in one sentence, in little memory."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
import traceback
from copy import deepcopy
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from mcap.reader import make_reader
from mcap.writer import Writer

from support.recordings import record
from support.unmeasured import unmeasured_environment
from unity_link.bridges.recording import Recording, export, replay
from unity_link.errors import UnityLinkError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

MOST_MEMORY = 300_000
"""kB that the process may use to read all cases, its imports included."""
ONE_OF = 8
"""The test suite reads one of so many cases."""
MESSAGES = 200
NUMBERS = [-1, 0, 2**31, 10**15]
FRACTIONS = [0.0, -1.0, 1e308, 5e-324]
TEXTS = ["", "\x1b[2J\x1b]0;x\x07", "../../../../elsewhere", "a" * 100_000]
DEEP = b"[" * 100_000 + b"]" * 100_000
GATEWAYS: dict[str, float] = {
    "data_bits": 10**9,
    "address_bits": -1,
    "id_digits": 0,
    "crc_bits": 7,
    "crc_polynomial": -5,
    "block_words": -1,
    "groups": 10**9,
    "group_words": -1,
    "base_frequency_millihertz": 0,
    "clock_hz": 0,
    "receive_fifo_bytes": -1,
    "transmit_fifo_bytes": 0,
    "features": 2**40,
    "build_id": -1,
    "protocol_version": 99,
}
INSTANTS: dict[str, Callable[[int, int], int]] = {
    "the last instant": lambda _, at: 2**64 - 1,
    "an instant past 2262": lambda _, at: 2**63,
    "instants that go back": lambda number, at: at - number * 10**10,
    "no instants": lambda _, at: 0,
}


class Parts:
    """The parts of a recording."""

    def __init__(self, path: Path) -> None:
        with path.open("rb") as file:
            reader = make_reader(file)
            heads = {found.name: found.data for found in reader.iter_attachments()}
            summary = reader.get_summary()
            assert summary is not None
            self.channels = list(summary.channels.values())
            self.schemas = summary.schemas
            self.messages = [
                (channel.topic, message.log_time, message.data) for _, channel, message in reader.iter_messages()
            ][:MESSAGES]
        self.interface: Any = json.loads(heads["interface.json"])
        self.gateway: Any = json.loads(heads["gateway.json"])

    def write(
        self,
        path: Path,
        *,
        interface: bytes | None = None,
        gateway: bytes | None = None,
        edit: Callable[[bytes], bytes] = lambda data: data,
        at: Callable[[int, int], int] = lambda _, at: at,
        metadata: Callable[[dict[str, str]], dict[str, str]] = lambda found: found,
        topic: str | None = None,
    ) -> None:
        """Write the recording with some parts replaced."""
        with path.open("wb") as file:
            writer = Writer(file)
            writer.start()
            for name, data in (
                ("interface.json", interface or json.dumps(self.interface).encode()),
                ("gateway.json", gateway or json.dumps(self.gateway).encode()),
            ):
                writer.add_attachment(0, 0, name, "application/json", data)
            numbers = {}
            for channel in self.channels:
                schema = self.schemas[channel.schema_id]
                number = writer.register_schema(schema.name, schema.encoding, schema.data)
                said = metadata(dict(channel.metadata))
                numbers[channel.topic] = writer.register_channel(topic or channel.topic, "json", number, said)
            for place, (name, instant, data) in enumerate(self.messages):
                writer.add_message(numbers[name], at(place, instant), edit(data), instant)
            writer.finish()


def cases(parts: Parts) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield the name of each case, and the parts that it replaces."""
    for name, number in GATEWAYS.items():
        yield f"gateway: {name}={number}", {"gateway": json.dumps({**parts.gateway, name: number}).encode()}
    for place, value in leaves(parts.interface):
        for wrong in wrong_ones(value):
            changed = deepcopy(parts.interface)
            inner = changed
            for step in place[:-1]:
                inner = inner[step]
            inner[place[-1]] = wrong
            yield f"interface: {place}={str(wrong)[:30]!r}", {"interface": json.dumps(changed).encode()}
    for part in ("gateway", "interface"):
        for name, nested in (("an array", DEEP), ("a field", b'{"x":' + DEEP + b"}")):
            yield f"{part}: {name} nested deeply", {part: nested}
    several: list[dict[str, Any]] = [
        *({"sequence": number, "lost": number} for number in (10**30, -5, 1.5, "x", None)),
        *({"words": words} for words in ("zz", "é" * 16, "", "0" * 7, None)),
        *({"time": time} for time in (1e308, "now", -1)),
    ]
    for fields in several:
        yield f"message: {fields}", {"edit": with_fields(fields)}
    yield "message: no JSON", {"edit": lambda _: b"\xff\x00"}
    yield "message: nested", {"edit": lambda data: b'{"x":' + DEEP + b"," + data[1:]}
    for name, at in INSTANTS.items():
        yield name, {"at": at}
    yield "signals twice", {"metadata": lambda found: {"signals": "\n".join([found["signals"]] * 3)}}
    yield "no signals", {"metadata": lambda _: {}}
    for topic in ("", "/", "/a/..", "/a/\x1b[2J", "/a/b\0c", "/a/" + "b" * 100_000):
        yield f"topic: {topic[:9]!r}", {"topic": topic}


def with_fields(fields: dict[str, Any]) -> Callable[[bytes], bytes]:
    return lambda data: json.dumps({**json.loads(data), **fields}).encode()


def leaves(value: Any, place: tuple[str | int, ...] = ()) -> Iterator[tuple[tuple[str | int, ...], Any]]:
    """Yield the values in JSON that contain no others, with the path to each; from arrays only the first two items."""
    if isinstance(value, dict):
        for name in value:
            yield from leaves(value[name], (*place, name))
    elif isinstance(value, list):
        for index in range(min(2, len(value))):
            yield from leaves(value[index], (*place, index))
    else:
        yield place, value


def wrong_ones(value: Any) -> list[Any]:
    if isinstance(value, bool):
        return []
    return [*(NUMBERS if isinstance(value, int) else FRACTIONS if isinstance(value, float) else [])] or (
        [*TEXTS] if isinstance(value, str) else []
    )


def fault_of(path: Path) -> str:
    """Return the traceback of a fault while a recording is read, or "" if it is read or refused in one sentence."""
    try:
        recording = Recording(path)
        export(recording, "csv", path.parent / "tables", overwrite=True)
        _, player = replay(recording)
        for second in range(3):
            player.read(0, float(second))
    except UnityLinkError as error:
        said = str(error)
        return "" if said.isprintable() and len(said) < 1000 else f"said {said[:100]!r}"
    except BaseException:  # noqa: BLE001  (any fault is reported)
        return traceback.format_exc().strip().splitlines()[-1][:200]
    return ""


def main(recorded: Path, first: int, step: int) -> None:
    """Read each `step`-th case from case `first` on; print the faults as JSON, and the most memory used in kB."""
    parts, faults, count = Parts(recorded), {}, 0
    with tempfile.TemporaryDirectory() as folder:
        for number, (name, changes) in enumerate(cases(parts)):
            if number % step != first:
                continue
            path = Path(folder, "case.mcap")
            parts.write(path, **changes)
            count += 1
            if fault := fault_of(path):
                faults[name] = fault
        outside = [str(found) for found in Path(folder).iterdir() if found.name not in ("case.mcap", "tables")]
    # `getrusage` would count the memory of the process that has started this process.
    (most,) = re.findall(r"VmHWM:\s+(\d+) kB", Path("/proc/self/status").read_text())
    sys.stdout.write(json.dumps({"cases": count, "faults": faults, "outside": outside, "kB": int(most)}) + "\n")


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("recording") / "run.mcap"
    record(path, lambda recorder: recorder.samples >= MESSAGES)
    return path


def read_cases(recorded: Path, first: int, step: int) -> dict[str, Any]:
    # Use another process, so that its memory is that of the cases alone.
    command = [sys.executable, __file__, str(recorded), str(first), str(step)]
    environment = {**unmeasured_environment(), "PYTHONPATH": str(Path(__file__).parents[1])}
    done = subprocess.run(command, capture_output=True, text=True, timeout=3000, check=True, env=environment)
    return dict(json.loads(done.stdout))


def check(found: dict[str, Any], least: int) -> None:
    assert (found["faults"], found["outside"]) == ({}, [])
    assert found["kB"] < MOST_MEMORY
    assert found["cases"] >= least


@pytest.mark.slow
def test_a_recording_with_one_thing_wrong_is_read_or_refused_in_one_sentence(recorded: Path) -> None:
    check(read_cases(recorded, 3, ONE_OF), 90)


@pytest.mark.campaign
def test_recording_with_one_fault_is_read_or_refused_in_one_sentence(recorded: Path) -> None:
    check(read_cases(recorded, 0, 1), 747)


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]))

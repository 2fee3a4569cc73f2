"""Recordings of random groups, replayed and recorded again: the same samples, without losses."""

from __future__ import annotations

import asyncio
import itertools
from typing import TYPE_CHECKING, Any, NamedTuple

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import unity_link
from support.recordings import work_in_place
from support.searching import examples
from support.simulated_time import run_simulated
from unity_link.bridges.recording import Recorder, Recording, replay
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.spec import Spec, compile_text
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from pathlib import Path

INFO = GatewayInfo(base_frequency_millihertz=2_000_000)


class Instants:
    """A device whose words contain the instant of the read, and the address."""

    def read(self, offset: int, now: float) -> int:
        return (round(now * 100_000) << 4) + offset

    def write(self, offset: int, value: int, now: float) -> None:
        raise AssertionError


class Robot(NamedTuple):
    groups: list[tuple[int, int, bool]]
    """For each group: its divisor, its number of words, and True if it has timestamps."""
    polls: list[int]
    """Rates in Hz of the signals that the host polls."""

    def spec(self) -> Spec:
        lines, declared, address = [], [], 0x10
        for number, (divisor, words, stamped) in enumerate(self.groups):
            declared.append(f"group g{number}({number + 1}, {divisor}{', TIMESTAMPS' if stamped else ''});")
            for _ in range(words):
                lines.append(f"  @x{address} = {address}: READ(PUBLISH(g{number}));")
                address += 1
        lines.append("  @rest = 0x1F: READ();")
        for rate in self.polls:
            lines.append(f"  @x{address} = {address}: READ(POLL({rate}));")
            address += 1
        return compile_text("\n".join([*declared, "public robot() {", *lines, "}"]))


robots = st.builds(
    Robot,
    st.lists(st.tuples(st.sampled_from([10, 20, 50, 64, 200]), st.integers(1, 3), st.booleans()), max_size=3),
    st.lists(st.sampled_from([5, 20, 50]), unique=True, max_size=2),
).filter(lambda robot: bool(robot.groups or robot.polls))


def record(
    monkeypatch: pytest.MonkeyPatch, spec: Spec, gateway: Any, path: Path, seconds: float, poll_hz: float | None
) -> dict[str, list[list[int]]]:
    """Record for some seconds; return the words of each group."""

    async def run(patched: pytest.MonkeyPatch) -> None:
        loop = asyncio.get_running_loop()
        for clock in ("time.time", "time.monotonic"):
            patched.setattr(clock, loop.time)
        async with unity_link.connect(gateway) as link:
            recorder = Recorder(unity_link.load(spec)(link), path, overwrite=True, poll_hz=poll_hz)
            running = asyncio.create_task(recorder.run())
            await asyncio.sleep(seconds)
            running.cancel()
            await asyncio.wait([running])
            assert recorder.lost == 0

    with monkeypatch.context() as patched:
        run_simulated(run(patched))
    found: dict[str, list[list[int]]] = {}
    for samples, _ in Recording(path).samples():
        assert samples.lost.tolist() == [0] * len(samples.lost)
        found.setdefault(samples.group.name, []).extend(samples.words.tolist())
    return found


@pytest.mark.slow
@given(robots, st.integers(8, 14), st.booleans())
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=examples(12))
def test_a_recording_of_a_replay_is_that_recording(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    robot: Robot,
    tenths: int,
    rest: bool,
) -> None:
    work_in_place(monkeypatch)
    spec, poll_hz = robot.spec(), 40.0 if rest else None
    gateway = VirtualGateway(INFO)
    gateway.attach(Instants(), range(0x10, 0x20))

    first = record(monkeypatch, spec, gateway, tmp_path / "first.mcap", tenths / 10, poll_hz)
    recording = Recording(tmp_path / "first.mcap")
    order = [(row.at, row.words.tolist()) for row in recording.in_order()]
    again = record(monkeypatch, spec, replay(recording)[0], tmp_path / "again.mcap", tenths / 10 - 0.5, poll_hz)

    assert [at for at, _ in order] == sorted(at for at, _ in order)
    assert sorted(words for _, words in order) == sorted(itertools.chain.from_iterable(first.values()))
    assert first.keys() == again.keys()
    for name, words in again.items():
        assert words
        assert words == first[name][: len(words)], name

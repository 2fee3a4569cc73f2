"""The robot of a spec without await: used from the thread of a script."""

from __future__ import annotations

import gc
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from unity_link import ArgumentError, LinkClosedError, blocking
from unity_link.data.blocking import Group, View, put

if TYPE_CHECKING:
    from collections.abc import Iterator

Scara = unity_link.load(Path(__file__).parents[2] / "examples" / "scara.ul")


@pytest.fixture
def link() -> Iterator[blocking.BlockingLink]:
    with blocking.connect("sim:scara") as link:
        yield link


@pytest.fixture
def robot(link: blocking.BlockingLink) -> Any:
    return put(Scara, link)


def test_values_are_read_written_and_remembered(robot: Any) -> None:
    robot.j1.pos_sp.set(9)
    assert robot.j1.pos_sp.get() == 9
    assert (robot.j1.pos_sp.value, robot.j1.pos_sp.unit) == (9, "deg")
    assert robot["joint 1:pos_sp"] == robot.j1.pos_sp
    assert "j1.pos_sp: 9.0 deg" in repr(robot.j1)
    assert {"cpos", "pos_sp"} <= set(dir(robot.j1))
    with pytest.raises(ArgumentError, match="outside of its limits"):
        robot.j1.pos_sp.set(1000)


def test_samples_are_iterated_over_and_passed_to_callbacks(robot: Any) -> None:
    robot.j1.pos_sp.set(1)
    seen: list[float] = []
    with robot.j1.cpos.on_change(seen.append):
        for position in robot.j1.cpos:
            if position == pytest.approx(1, abs=0.001):
                break
    assert seen == sorted(seen)
    samples = iter(robot.groups["state"])
    sequence = [next(samples).sequence for _ in range(3)]
    assert sequence == [sequence[0], sequence[0] + 1, sequence[0] + 2]
    assert next(samples).values[robot.j1.cpos] == pytest.approx(1, abs=0.001)


def test_groups_write_and_read_many_values(robot: Any) -> None:
    targets = Group(robot.j1.pos_sp, robot.j2.pos_sp)
    targets.set({robot.j1.pos_sp: 9, robot.j2.pos_sp: 18})
    values = targets.get()
    assert (values[robot.j1.pos_sp], values[robot.j2.pos_sp]) == (9, 18)
    assert (len(targets), len(Group(robot))) == (2, 16)
    with targets.subscribe(rate_hz=100) as samples:
        batch = samples.take()
        assert batch[robot.j2.pos_sp][0] == 18
        assert next(iter(samples)).values[robot.j1.pos_sp] == 9


def test_a_subscription_whose_link_was_closed_causes_no_warning(
    link: blocking.BlockingLink, robot: Any, recwarn: pytest.WarningsRecorder
) -> None:
    with Group(robot.j1.cpos).subscribe(rate_hz=100) as samples:
        link.close()
    del samples
    gc.collect()
    assert not recwarn.list


def test_samples_from_before_the_close_of_a_link_are_returned_first(link: blocking.BlockingLink, robot: Any) -> None:
    group = Group(robot.j1.cpos, rate_hz=100)
    loop = iter(group)
    first = next(loop).sequence
    with group.subscribe(rate_hz=100) as samples:
        began = next(iter(samples)).sequence
        while samples.received < 20:
            link.read(0)
        link.close()
        batch = samples.take(10)
        assert batch.sequence.tolist() == list(range(began + 1, began + 11))
        assert len(samples.take()) >= 9
        with pytest.raises(LinkClosedError):
            samples.take()
    seen = [first]
    with pytest.raises(LinkClosedError):
        seen += (sample.sequence for sample in loop)
    assert len(seen) > 10
    assert seen == list(range(first, first + len(seen)))


def test_loops_left_in_many_threads_end_their_subscriptions(robot: Any) -> None:
    def leave_loops() -> None:
        for _ in range(40):
            for _ in robot.groups["state"]:
                break

    gc.disable()
    try:
        for _ in range(4):
            with ThreadPoolExecutor(6) as threads:
                for leaving in [threads.submit(leave_loops) for _ in range(6)]:
                    leaving.result(60)
            assert robot.groups["state"]._thing.feed._listeners == {}
    finally:
        gc.enable()


def test_a_loop_may_set_the_size_of_its_buffer(robot: Any) -> None:
    newest = robot.j1.cpos.samples(buffer=1, overflow="drop_oldest")
    assert len([value for value, _ in zip(newest, range(3), strict=False)]) == 3
    some = robot.groups["state"].samples(buffer=1000)
    sequences = [sample.sequence for sample, _ in zip(some, range(3), strict=False)]
    assert sequences == [sequences[0] + place for place in range(3)]


def test_a_blocking_group_has_signals_of_one_link(robot: Any) -> None:
    with blocking.connect("sim:scara") as other, pytest.raises(ArgumentError, match="members on one link"):
        Group(robot.j1.cpos, put(Scara, other).j1.cpos)


def test_an_assignment_to_a_signal_is_refused(robot: Any) -> None:
    with pytest.raises(ArgumentError, match=r"j1\.pos_sp is not assigned to: j1\.pos_sp\.set\(1\) writes it"):
        robot.j1.pos_sp = 1
    assert isinstance(robot.j1.pos_sp, View)


def test_a_closed_link_ends_the_calls_of_a_robot(link: blocking.BlockingLink, robot: Any) -> None:
    assert isinstance(robot.j1, View)
    link.close()
    with pytest.raises(LinkClosedError):
        robot.j1.cpos.get()


def test_the_error_for_a_group_without_a_block_shows_the_code(robot: Any) -> None:
    samples = Group(robot.j1.cpos).subscribe(rate_hz=100)
    for ask in (samples.take, lambda: next(iter(samples))):
        with pytest.raises(ArgumentError, match="`with` in blocking code"):
            ask()
    with samples:
        assert len(samples.take()) > 0

"""A generated bridge of ROS counts and dates samples as they were taken, also those that waited for it."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from generate.ros_on_paper import Paper
from generate.test_ros_packages import EXAMPLES, loaded, packages
from support.searching import examples
from support.spec_examples import FIGURE_1
from support.taken_samples import BASE_HZ, STORIES, TURN, are_decidable, arrivals_of, of_group
from unity_link import GatewayInfo
from unity_link.spec import compile_file, compile_text

if TYPE_CHECKING:
    from pathlib import Path
    from types import ModuleType

BEGAN_AT = 1e9
"""Instant of the first sample in ROS's time."""


@pytest.fixture(scope="module")
def bridge(tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    folder = packages(tmp_path_factory.mktemp("standing"), "ros1", compile_text(FIGURE_1))
    return loaded(folder)["bridge"]


@given(
    **STORIES,
    divisors=st.lists(st.integers(100, 3000), min_size=1, max_size=2),
)
@settings(max_examples=examples(30), deadline=None)
def test_samples_are_counted_and_dated_as_they_were_taken_however_long_the_bridge_stood_still(
    bridge: ModuleType, reads: list[tuple[float, int, str]], clock_hz: int, divisors: list[int], began: int, seed: int
) -> None:
    arrivals = arrivals_of(reads, clock_hz, divisors, began, seed)
    came = [of_group(arrivals, group) for group in range(len(divisors))]
    for truth, divisor in zip(came, divisors, strict=True):
        assume(are_decidable(truth, divisor, clock_hz))
    course, clock = bridge.Course(clock_hz), bridge.Clock(clock_hz)
    missing, stamps = [0] * len(divisors), []
    for arrival in arrivals:
        for one in arrival.taken:
            rate = BASE_HZ / divisors[one.group]
            lost, ticks, is_sure = course.follow(one.group, rate, one.number % 256, one.ticks % TURN, arrival.now)
            missing[one.group] += lost
            assert ticks == one.ticks
            stamps.append((clock.stamp(ticks, is_sure, arrival.now, BEGAN_AT + arrival.now) - BEGAN_AT, one.instant))
    assert missing == [truth[-1].number + 1 - len(truth) - truth[0].number for truth in came]
    # What the quickest was on its way is not known, nor whether the clocks of both sides go as fast.
    least = min(arrival.now - one.instant for arrival in arrivals[:1] for one in arrival.taken)
    most = least + bridge.DRIFT * arrivals[-1].now + 1e-3
    assert all(-1e-3 <= stamp - instant <= most for stamp, instant in stamps)


def test_samples_without_timestamps_are_counted_by_their_numbers(bridge: ModuleType) -> None:
    course = bridge.Course(1)
    assert [course.follow(0, 10.0, number, None, 0.0)[0] for number in (7, 8, 10, 255, 0, 0)] == [0, 0, 1, 244, 0, 255]


def test_the_clock_of_a_gateway_that_was_reset_is_followed_and_one_of_ros_that_was_set(bridge: ModuleType) -> None:
    clock = bridge.Clock(1000)
    assert clock.stamp(90_000, False, 1.0, 101.0) == pytest.approx(101.0)
    assert clock.stamp(91_000, True, 2.0, 102.0) == pytest.approx(102.0)
    assert clock.stamp(50, False, 3.0, 103.0) == pytest.approx(103.0)
    assert clock.stamp(1050, True, 4.0, 204.0) == pytest.approx(204.0)


def test_a_bridge_tells_how_many_were_lost_beyond_a_round_of_their_numbers(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    package, info = loaded(packages(tmp_path, "ros1", compile_file(EXAMPLES / "scara.ul"))), GatewayInfo()
    one = package["bridge"].Bridge(Paper("unix:/nowhere", poll_hz=0.0), package["robot"])
    one._link.configuration = package["client"].Configuration(info.to_hex().decode())
    (group,) = package["robot"].GROUPS
    rate = one._link.rate(group)
    assert rate > 1
    now = 0.0
    monkeypatch.setattr(package["bridge"], "time", SimpleNamespace(monotonic=lambda: now))
    for number in (0, 1, 2, 1000, 1001):
        now = number / rate
        one._take(group, number % 256, round(now * info.clock_hz) % TURN, [0] * len(group.addresses))
    assert one.lost == 997

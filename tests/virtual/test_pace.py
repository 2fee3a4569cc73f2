"""A compiled gateway that is slower than time says so once, with its pace and what to do."""

from __future__ import annotations

import pytest

from unity_link.virtual.rtl.pace import ClockPace


def passed(pace: ClockPace, seconds: float, *, worked: float, left_out: float, begin: float = 0.0) -> None:
    """Let time pass in turns of 10 ms, of which parts are spent on cycles and left out."""
    for turn in range(round(seconds * 100) + 1):
        kept = 1 - left_out
        pace.add(begin + turn / 100, round(24_000 * kept), worked / 100, left_out / 100)


def test_the_pace_is_told_once_with_a_clock_that_this_machine_has(caplog: pytest.LogCaptureFixture) -> None:
    pace = ClockPace("rover", 2_400_000, is_free=True)
    passed(pace, 10, worked=0.9, left_out=0.8)
    (said,) = caplog.messages
    assert "the gateware of rover is slower than time: its clock of 2,400,000 Hz runs at 0.2 of its rate" in said
    # It has worked out 480,000 cycles in 0.9 s.
    assert "clock_hz=300000 in the URL" in said


def test_a_build_whose_clock_is_given_has_no_other_to_name(caplog: pytest.LogCaptureFixture) -> None:
    passed(ClockPace("walker", 2_400_000, is_free=False), 10, worked=0.9, left_out=0.8)
    assert "URL" not in caplog.text
    assert "walker is slower than time" in caplog.text


@pytest.mark.parametrize(
    ("worked", "left_out"),
    [pytest.param(0.9, 0.0, id="all of it is done"), pytest.param(0.1, 0.8, id="the loop stood still")],
)
def test_nothing_is_said_of_a_gateway_that_is_quick_enough(
    worked: float, left_out: float, caplog: pytest.LogCaptureFixture
) -> None:
    pace = ClockPace("rover", 2_400_000, is_free=True)
    passed(pace, 10, worked=worked, left_out=left_out)
    # Another loop has another clock.
    passed(pace, 10, worked=worked, left_out=left_out, begin=-100)
    assert not caplog.messages

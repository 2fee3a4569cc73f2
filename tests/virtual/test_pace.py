"""A compiled gateway that is slower than real time logs its pace and a remedy once."""

from __future__ import annotations

import pytest

from unity_link.virtual.rtl.pace import ClockPace


def passed(pace: ClockPace, seconds: float, *, worked: float, left_out: float, begin: float = 0.0) -> None:
    """Report turns of 10 ms, of which the given fractions are spent on cycles and left out."""
    for turn in range(round(seconds * 100) + 1):
        kept = 1 - left_out
        pace.add(begin + turn / 100, round(24_000 * kept), worked / 100, left_out / 100)


def test_the_pace_is_logged_once_with_a_clock_for_this_machine(caplog: pytest.LogCaptureFixture) -> None:
    pace = ClockPace("rover", 2_400_000, is_free=True)
    passed(pace, 10, worked=0.9, left_out=0.8)
    (said,) = caplog.messages
    assert "the gateware of rover is slower than time: its clock of 2,400,000 Hz runs at 0.2 of its rate" in said
    # The gateware has simulated 480,000 cycles in 0.9 s.
    assert "clock_hz=300000 in the URL" in said


def test_a_build_with_a_given_clock_suggests_no_other_clock(caplog: pytest.LogCaptureFixture) -> None:
    passed(ClockPace("walker", 2_400_000, is_free=False), 10, worked=0.9, left_out=0.8)
    assert "URL" not in caplog.text
    assert "walker is slower than time" in caplog.text


@pytest.mark.parametrize(
    ("worked", "left_out"),
    [pytest.param(0.9, 0.0, id="all of it is done"), pytest.param(0.1, 0.8, id="the loop stood still")],
)
def test_the_pace_of_a_quick_gateway_is_not_logged(
    worked: float, left_out: float, caplog: pytest.LogCaptureFixture
) -> None:
    pace = ClockPace("rover", 2_400_000, is_free=True)
    passed(pace, 10, worked=worked, left_out=left_out)
    # Another event loop has another clock.
    passed(pace, 10, worked=worked, left_out=left_out, begin=-100)
    assert not caplog.messages

"""ul_pwm equals its model: all modes and alignments, with clocks that resolve a value and clocks that do not."""

from __future__ import annotations

import json

import pytest

from gateware.bench.runner import BenchError, run_bench

_BENCH = "gateware.cores.pwm.bench_pwm"
VARIANTS = {
    "as it is": {},
    "in the middle": {"axes": 3, "centre": True, "frequency_hz": 40_000},
    "up and down": {"axes": 3, "mode": "up_down", "width": 10, "frequency_hz": 61_000},
    "up and down, dead time": {"axes": 2, "mode": "up_down", "centre": True, "width": 8, "dead_time_ns": 333},
    "a half bridge": {"axes": 3, "mode": "offset", "centre": True, "frequency_hz": 50_000, "dead_time_ns": 500},
    "a half bridge, no dead time": {"axes": 2, "mode": "offset", "width": 16, "frequency_hz": 123_457},
    "a period of 4 cycles": {"axes": 2, "mode": "offset", "width": 24, "clock_hz": 4, "frequency_hz": 1},
    "a value of 2 bits": {"axes": 2, "width": 2, "centre": True, "clock_hz": 45, "frequency_hz": 5},
}


@pytest.mark.parametrize("generics", VARIANTS.values(), ids=VARIANTS)
@pytest.mark.parametrize("cycles", [12_500, pytest.param(125_000, marks=pytest.mark.campaign)])
def test_the_pins_are_those_of_the_model(generics: dict[str, object], cycles: int) -> None:
    env = {"CYCLES": str(cycles), "GENERICS": json.dumps(generics)}
    run_bench("ul_pwm", _BENCH, generics=generics, extra_env=env)


REFUSED = {
    "width is 1: 2 to 24 was expected": {"width": 1},
    "width is 25: 2 to 24 was expected": {"width": 25},
    "frequency_hz is 13000000: at most a quarter of a clock of 50000000 Hz was expected": {"frequency_hz": 13_000_000},
    "mode is off: sign, up_down or offset was expected": {"mode": "off"},
    "dead_time_ns is 20: 0 was expected for the mode sign": {"dead_time_ns": 20},
    "dead_time_ns is 2000000000: 0 was expected": {"mode": "offset", "dead_time_ns": 2_000_000_000},
}


@pytest.mark.parametrize(("says", "generics"), REFUSED.items(), ids=REFUSED)
def test_what_it_can_not_do_is_refused_when_it_is_elaborated(says: str, generics: dict[str, object]) -> None:
    with pytest.raises(BenchError, match=f"assertion failure.*: ul_pwm: {says}"):
        run_bench("ul_pwm", _BENCH, generics=generics)

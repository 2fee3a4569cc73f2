"""A call refuses NaN, infinities and numbers beyond its field."""

from __future__ import annotations

import inspect
import math
from decimal import Decimal
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import unity_link
from support.simulated_time import on_simulated_time
from unity_link import ArgumentError, Reconnect
from unity_link.cores.clock import Instant
from unity_link.data import Group
from unity_link.errors import shown
from unity_link.modules import Fifo, Memory
from unity_link.spec import compile_text
from unity_link.virtual.build import simulated

if TYPE_CHECKING:
    from collections.abc import Callable

SPEC = compile_text("""
enum mode { off, on }
public robot() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE(TIMEOUT=0.1) @(0xC0);
  plan: SCHEDULE(DEPTH=64) @(0x100);
  @lamp = 0x40: unsigned 8 READWRITE(TIMED(plan));
  @volts = 0x41: signed 12 READWRITE(SCALE=0.01, MIN=-12, MAX=12);
  @ratio = 0x42: fixed 8.8 READWRITE();
  @mode = 0x43: mode 4 READWRITE();
  @flag = 0x44: bool READWRITE();
  @total = 0x46: unsigned 64 READWRITE();
  @port = 0x48: unsigned 8 READWRITE(FIFO(16));
  @gain = 0x49: float 32 READWRITE();
  @limited = 0x4A: float 32 READWRITE(MIN=-1, MAX=1);
}
""")
Robot = unity_link.load(SPEC)
NO_NUMBERS: list[Any] = [math.nan, math.inf, -math.inf, np.float64("nan"), np.float32("inf"), "1", 1j, [[]]]
HUGE: list[Any] = [10**400, -(10**400), 10**5000, -(10**5000), Fraction(10**400), 1e308, np.float64(-1e308), -(2**70)]
"""Numbers beyond every field. Python cannot convert a number of 5,001 digits to text, in an error message neither."""


async def shifted(robot: Any, seconds: Any) -> None:
    async with robot.plan.timeline() as line:
        line.delay(seconds)


CALLS: dict[str, Callable[[Any, Any], Any]] = {
    "connect": lambda _, given: unity_link.connect("sim:", timeout=given),
    "first_pause": lambda _, given: Reconnect(first_pause=given),
    "longest_pause": lambda _, given: Reconnect(longest_pause=given),
    "give_up_after": lambda _, given: Reconnect(give_up_after=given),
    "an address": lambda robot, given: robot.link.read(given),
    "a word": lambda robot, given: robot.link.write(0x40, given),
    "a posted word": lambda robot, given: robot.link.post(0x40, given),
    "a mask": lambda robot, given: robot.link.write_masked(0x40, 1, given),
    "words": lambda robot, given: robot.link.write_block(0x40, [given]),
    "many addresses": lambda robot, given: robot.link.read_many([given]),
    "a number of words": lambda robot, given: robot.link.read_block(0x40, given),
    "words of a queue": lambda robot, given: robot.link.read_queue(0x48, given),
    "a rate": lambda robot, given: robot.link.subscribe([0x40], rate_hz=given),
    "a divisor": lambda robot, given: robot.link.subscribe([0x40], divisor=given),
    "a buffer": lambda robot, given: robot.link.subscribe([0x40], rate_hz=10, buffer=given),
    "an address of a subscription": lambda robot, given: robot.link.subscribe(given, rate_hz=10),
    "a sample's time": lambda robot, given: robot.link.timestamp_of(given),
    "a group's rate": lambda robot, given: Group(robot.lamp, rate_hz=given),
    "a polled rate": lambda robot, given: Group.polled(given, [robot.lamp]),
    "a group's buffer": lambda robot, given: Group(robot.lamp).subscribe(rate_hz=10, buffer=given),
    "a group's values": lambda robot, given: Group(robot.lamp, robot.volts).set([1, given]),
    "posted values": lambda robot, given: Group(robot.lamp, robot.volts).post([given, 1]),
    "an unsigned": lambda robot, given: robot.lamp.set(given),
    "a scaled": lambda robot, given: robot.volts.set(given),
    "a fixed": lambda robot, given: robot.ratio.set(given),
    "an enumeration": lambda robot, given: robot.mode.set(given),
    "a bool": lambda robot, given: robot.flag.set(given),
    "64 bits": lambda robot, given: robot.total.set(given),
    "a port": lambda robot, given: robot.port.set(given),
    "a port's values": lambda robot, given: robot.port.append([given]),
    "a port's words": lambda robot, given: robot.port.take(given),
    "a float within limits": lambda robot, given: robot.limited.set(given),
    "a base": lambda robot, given: Memory(robot.link, given).read(0),
    "a size": lambda robot, given: Memory(robot.link, 0x40, size=given),
    "an offset": lambda robot, given: Memory(robot.link, 0x40, size=4).read(given),
    "a filling": lambda robot, given: Memory(robot.link, 0x40, size=4).fill(given),
    "words of a FIFO": lambda robot, given: Fifo(robot.link, 0x48).take(given),
    "a time-out of a lease": lambda robot, given: robot.drive.armed(timeout=given),
    "ticks": lambda _, given: Instant(given, 50_000_000),
    "a frequency": lambda _, given: Instant(0, given),
    "seconds between instants": lambda _, given: Instant(0, 50_000_000).after(given),
    "a lead": lambda robot, given: robot.plan.timeline(lead=given),
    "a delay": shifted,
    "a lead of a trajectory": lambda robot, given: robot.plan.play([0, 0.01], {robot.lamp: [1, 2]}, lead=given),
    "times": lambda robot, given: robot.plan.play([0, given], {robot.lamp: [1, 2]}),
    "values of a trajectory": lambda robot, given: robot.plan.play([0, 0.01], {robot.lamp: [1, given]}),
}


async def tried(call: Callable[[Any, Any], Any], robot: Any, given: Any) -> str:
    """Return the text of the ArgumentError that a call, or the coroutine that it returns, raises."""

    async def make() -> None:
        made = call(robot, given)
        if inspect.iscoroutine(made):
            await made

    with pytest.raises(ArgumentError) as refused:
        await make()
    return str(refused.value)


@pytest.mark.parametrize("name", CALLS)
@on_simulated_time
async def test_values_that_are_no_numbers_or_fit_no_field_are_refused(name: str) -> None:
    async with unity_link.connect(simulated(SPEC.interface())) as link:
        robot = Robot(link)
        requests = link.statistics.requests
        for given in (*NO_NUMBERS, *HUGE):
            if name in {"an enumeration", "a subscription"} and isinstance(given, str):
                continue
            assert "\n" not in await tried(CALLS[name], robot, given)
        # No request is sent, except in a timeline, which refuses a delay within its block.
        assert link.statistics.requests == requests or name == "a delay"


@on_simulated_time
async def test_float_signal_accepts_each_number_of_its_format() -> None:
    async with unity_link.connect(simulated(SPEC.interface())) as link:
        robot: Any = Robot(link)
        for given in (math.inf, -math.inf, 1e38, np.float64("inf"), Decimal("Infinity")):
            await robot.gain.set(given)
            assert await robot.gain.get() == pytest.approx(float(given))
        await robot.gain.set(math.nan)
        assert math.isnan(await robot.gain.get())
        for given in (1e39, 10**400, 10**5000, Decimal("1e39")):
            with pytest.raises(ArgumentError, match=r"gain: .* is too large for float 32"):
                await robot.gain.set(given)


@on_simulated_time
async def test_a_time_of_this_machine_or_a_sample_is_a_number_of_seconds() -> None:
    async with unity_link.connect(simulated(SPEC.interface())) as link:
        robot: Any = Robot(link)
        clock = await robot.plan.clock()
        for given in (*NO_NUMBERS, *HUGE, None):
            for call in (clock.at, clock.sampled, clock.time_of, link.age_of):
                with pytest.raises(ArgumentError):
                    call(given)


@pytest.mark.parametrize(
    ("given", "text"),
    [
        (10**5000, "a number of 16610 bits"),
        (Fraction(10**5000), "a Fraction"),
        ("x" * 100, "'" + "x" * 79),
        (np.float64("nan"), "nan"),
        (None, "None"),
    ],
    ids=["a whole number", "a fraction", "a text", "NaN", "None"],
)
def test_error_shows_the_given_value_in_eighty_characters(given: object, text: str) -> None:
    assert shown(given) == text

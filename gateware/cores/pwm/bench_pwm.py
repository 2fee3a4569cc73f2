"""Bench: the pins of ul_pwm equal a model in every cycle, for any values, arming and resets.

The model has no ramp: it counts the cycles of a period and rounds once for each period.
"""

from __future__ import annotations

import dataclasses
import json
import os
import random
from fractions import Fraction
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import RisingEdge

from gateware.bench.streams import start

if TYPE_CHECKING:
    from collections.abc import Sequence

    from cocotb.handle import SimHandleBase


@dataclasses.dataclass(frozen=True)
class Settings:
    """Generics of the entity, read from the environment because the simulator cannot return a string generic."""

    axes: int = 1
    clock_hz: int = 50_000_000
    width: int = 12
    frequency_hz: int = 20_000
    centre: bool = False
    mode: str = "sign"
    dead_time_ns: int = 0

    @property
    def half(self) -> int:
        """Number of cycles of half a period."""
        return (self.clock_hz + self.frequency_hz) // (2 * self.frequency_hz)

    @property
    def dead(self) -> int:
        """Number of cycles for which both pins stay '0' before the other one becomes '1'."""
        return -(-self.dead_time_ns * self.clock_hz // 10**9)

    def high_cycles(self, value: int) -> int:
        """Return the number of cycles of a period in which the pulse of a value is '1'."""
        most = 2 ** (self.width - 1) - 1
        value = max(value, -most)
        share = Fraction(value + most, 2 * most) if self.mode == "offset" else Fraction(abs(value), most)
        return round(share * 2 * self.half)

    def pulse(self, value: int) -> range:
        """Return the cycles of a period in which the pulse of a value is '1'."""
        high = self.high_cycles(value)
        if not self.centre:
            return range(high)
        return range(self.half - (high + 1) // 2, self.half + high // 2)


class Axis:
    """One axis of the model: the levels of its two pins after each clock edge."""

    def __init__(self, settings: Settings) -> None:
        """Store the generics; the state is unknown before the first reset."""
        self._settings = settings
        self._runs = False
        self._negative = False
        self._pulse = range(0)
        self._last: str | None = None
        self._off_for = 0
        self.pwm = self.dir = 0

    def edge(self, number: int, value: int, *, armed: bool, reset: bool) -> None:
        """Simulate one clock edge; `number` is the number of the cycle in its period, 0 when a value is sampled."""
        settings = self._settings
        high = (number - 1) % (2 * settings.half) in self._pulse
        pwm, dir_ = {
            "sign": (high, self._negative),
            "up_down": (high and not self._negative, high and self._negative),
            "offset": (high, not high),
        }[settings.mode]
        on = self._runs and armed and not reset
        rested = self._off_for >= settings.dead
        self.pwm = int(on and pwm and (rested or self._last == "pwm"))
        self.dir = int(on and dir_ and (rested or self._last == "dir"))
        self._last = "pwm" if self.pwm else "dir" if self.dir else self._last
        self._off_for = 0 if self.pwm or self.dir or reset else self._off_for + 1
        if settings.dead == 0:
            self._off_for = 0
        if number == 0:
            self._runs = True
            self._negative = value < 0
            self._pulse = settings.pulse(value)
        self._runs &= armed and not reset


class Model:
    """All axes, and their common time base."""

    def __init__(self, settings: Settings) -> None:
        """Create the axes."""
        self._period = 2 * settings.half
        self._number = 0
        self._axes = [Axis(settings) for _ in range(settings.axes)]

    def edge(self, values: Sequence[int], armed: int, *, reset: bool) -> tuple[int, int]:
        """Simulate one clock edge and return `pwm` and `dir` after it."""
        pwm = dir_ = 0
        for index, (axis, value) in enumerate(zip(self._axes, values, strict=True)):
            axis.edge(self._number, value, armed=bool(armed >> index & 1), reset=reset)
            pwm |= axis.pwm << index
            dir_ |= axis.dir << index
        self._number = self._period - 1 if reset else (self._number + 1) % self._period
        return pwm, dir_


class Stimulus:
    """Random inputs: values, many of them extreme, arming and resets, which change in any cycle."""

    def __init__(self, settings: Settings, rng: random.Random) -> None:
        """Store the generics and the random generator."""
        self._settings, self._rng = settings, rng
        self._most = 2 ** (settings.width - 1) - 1
        self.values = [0] * settings.axes
        self.armed = 0
        self.reset = True
        self._period = 2 * settings.half

    def next(self) -> bool:
        """Choose the inputs of the next cycle and return whether any has changed."""
        rng, settings = self._rng, self._settings
        changed = False
        if rng.random() < 0.7 / self._period:
            most = self._most
            near = [-most - 1, -most, 1 - most, -1, 0, 1, most - 1, most]
            self.values = [rng.choice([*near, *(rng.randint(-most, most) for _ in near)]) for _ in self.values]
            changed = True
        if rng.random() < 0.3 / self._period or (self.armed + 1 < 1 << settings.axes and rng.random() < 0.2):
            self.armed = rng.getrandbits(settings.axes) | rng.getrandbits(settings.axes)
            changed = True
        reset = rng.random() < (0.5 if self.reset else 0.02 / self._period)
        changed |= reset is not self.reset
        self.reset = reset
        return changed

    def packed(self) -> int:
        """Return the values in the format of the entity's port."""
        bits = self._settings.width
        return sum((value & 2**bits - 1) << index * bits for index, value in enumerate(self.values))


@cocotb.test
async def the_pins_are_those_of_the_model_in_every_cycle(dut: SimHandleBase) -> None:
    settings = Settings(**json.loads(os.environ["GENERICS"]))
    stimulus = Stimulus(settings, random.Random(int(os.environ["CYCLES"])))
    dut.value.value, dut.armed.value, dut.value_written.value = 0, 0, 0
    await start(dut.clk, dut.rst)
    model = Model(settings)
    clk, pwm, dir_, rst = dut.clk, dut.pwm, dut.dir, dut.rst
    rst.value = 1
    await RisingEdge(clk)
    expected = model.edge(stimulus.values, 0, reset=True)
    pulses = 0
    for cycle in range(int(os.environ["CYCLES"])):
        if stimulus.next():
            dut.value.value, dut.armed.value, rst.value = stimulus.packed(), stimulus.armed, int(stimulus.reset)
        await RisingEdge(clk)
        seen = int(pwm.value), int(dir_.value)
        assert seen == expected, f"cycle {cycle}: pwm and dir are {seen}, {expected} was expected"
        pulses += bool(seen[0]) + bool(seen[1])
        expected = model.edge(stimulus.values, stimulus.armed, reset=stimulus.reset)
    assert pulses > 0.2 * cycle

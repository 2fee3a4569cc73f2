"""Inside the simulator: encoders beside a model that is true to the bit, and beside the motion that they see."""

from __future__ import annotations

import math
import os
import random
from typing import TYPE_CHECKING, NamedTuple

import cocotb
from cocotb.triggers import RisingEdge

from gateware.bench.streams import start

if TYPE_CHECKING:
    from collections.abc import Iterator

    from cocotb.handle import SimHandleBase

CYCLES = int(os.environ.get("CYCLES", "20000"))
TICK = int(os.environ.get("TICK", "150"))
"""Cycles between two base ticks; 0: there are none."""
_OUTPUTS = {"position": 32, "velocity": 32, "index_position": 32, "index_count": 16, "errors": 16}
_PHASES = (0b00, 0b01, 0b11, 0b10)
"""Levels of b and a by the position, while that goes up."""


class Edge(NamedTuple):
    """A count: the place of its edge, and the cycle."""

    place: int
    cycle: int


class Axis:
    """The pins of an axis and what is counted of them, as registers are after each cycle."""

    def __init__(self, filtered: int, *, by_edges: bool) -> None:
        self._filter, self._by_edges = filtered, by_edges
        self._row = [0, 0]
        self._levels, self._old, self._seen = [0, 0, 0], [0, 0, 0], [0, 0, 0]
        self.position = self.index_position = self.index_count = self.errors = 0
        self.edge = Edge(0, 0)
        self.moved = False

    def pass_cycle(self, pins: int, now: int, *, settled: bool, taken: bool) -> None:
        """Pass a clock edge; `pins` has a, b and z from its lowest bit on."""
        self._count(now, settled=settled, taken=taken)
        self._old = self._levels.copy()
        for pin in range(3):
            level = self._row[1] >> pin & 1
            if level == self._levels[pin]:
                self._seen[pin] = 0
                continue
            self._seen[pin] += 1
            if self._seen[pin] == self._filter or (not settled and self._filter > 1):
                self._levels[pin], self._seen[pin] = level, 0
        self._row = [pins, self._row[0]]

    def _count(self, now: int, *, settled: bool, taken: bool) -> None:
        (a, b, z), (old_a, old_b, old_z) = self._levels, self._old
        step = 0
        if settled and self._by_edges:
            step = (-1 if b else 1) * (a and not old_a)
        elif settled and a != old_a and b != old_b:
            self.errors = (self.errors + 1) % 2**16
        elif settled:
            turn = _PHASES.index(b << 1 | a) - _PHASES.index(old_b << 1 | old_a)
            step = (turn + 1) % 4 - 1
        if taken:
            self.moved = False
        if step:
            self.moved = True
            self.edge = Edge(max(self.position, self.position + step), now)
        self.position += step
        if settled and z and not old_z:
            self.index_count = (self.index_count + 1) % 2**16
            self.index_position = self.position


class Velocity:
    """State of an axis in the divider."""

    def __init__(self) -> None:
        self.value = 0
        self.last: Edge | None = None
        """The edge of the round before."""
        self.used: tuple[Edge, Edge] | None = None
        """The edges that the value comes from, unless it is a bound."""


class Model:
    """The entity, cycle for cycle."""

    def __init__(self, axes: int, clock_hz: int, filtered: int, *, by_edges: bool) -> None:
        self.axes = [Axis(filtered, by_edges=by_edges) for _ in range(axes)]
        self.velocities = [Velocity() for _ in range(axes)]
        self._clock_hz = clock_hz
        self.standstill = 2 ** math.ceil(math.log2((clock_hz + 1) // 2))
        self._takes = 2 * (math.ceil(math.log2(clock_hz)) + 9)
        self._cycle = self._settling = 0
        self._waiting = False
        self._round = self._rounds()

    def pass_cycle(self, pins: list[int], *, tick: bool) -> None:
        """Pass a clock edge, with the pins of all axes."""
        taken = next(self._round)
        settled = self._settling == 8
        for number, (axis, its_pins) in enumerate(zip(self.axes, pins, strict=True)):
            axis.pass_cycle(its_pins, self._cycle, settled=settled, taken=taken == number)
        rare = self._cycle > 0 and self._cycle % self.standstill == 0
        self._waiting |= tick or rare
        self._settling += not settled
        self._cycle += 1

    def _rounds(self) -> Iterator[int]:
        """Yield in each cycle which axis is looked at, or -1."""
        while True:
            if not self._waiting:
                yield -1
                continue
            self._waiting = False
            yield -1
            for number, (axis, velocity) in enumerate(zip(self.axes, self.velocities, strict=True)):
                moved, edge, now = axis.moved, axis.edge, self._cycle
                yield number
                for _ in range(4 + self._takes):
                    yield -1
                self._divide(velocity, edge, now, moved=moved)
                yield -1

    def _divide(self, velocity: Velocity, edge: Edge, now: int, *, moved: bool) -> None:
        if velocity.last is None:
            velocity.last = edge if moved else None
            return
        way = edge.place - velocity.last.place if moved else 1
        span = edge.cycle - velocity.last.cycle if moved else now - edge.cycle
        speed = min(abs(way) * 256 * self._clock_hz // span, 2**31 - 1)
        if moved:
            velocity.value = speed if way > 0 else -speed
            velocity.used, velocity.last = (velocity.last, edge), edge
        elif span >= self.standstill:
            velocity.value, velocity.last, velocity.used = 0, None, None
        elif speed < abs(velocity.value):
            velocity.value, velocity.used = math.copysign(speed, velocity.value), None
            velocity.value = int(velocity.value)

    def outputs(self) -> dict[str, list[int]]:
        """Return what the outputs show of each axis."""
        return {
            "position": [axis.position for axis in self.axes],
            "velocity": [velocity.value for velocity in self.velocities],
            "index_position": [axis.index_position for axis in self.axes],
            "index_count": [axis.index_count for axis in self.axes],
            "errors": [axis.errors for axis in self.axes],
        }


class Bench:
    """The entity and its model, which pass each cycle together."""

    def __init__(self, dut: SimHandleBase) -> None:
        self.dut = dut
        self.axes = int(dut.axes.value)
        self.clock_hz = int(dut.clock_hz.value)
        self.by_edges = bool(dut.counter.value)
        self.filtered = int(dut.filter.value)
        self._handles = [(getattr(dut, name), name, bits) for name, bits in _OUTPUTS.items()]
        self.cycle = 0
        self._given: dict[str, int] = {}
        self._shown: dict[str, list[int]] = {}

    async def begin(self, pins: list[int]) -> None:
        """Reset, with the pins at these levels."""
        self.dut.tick.value = 0
        self._set(pins, tick=False)
        await start(self.dut.clk, self.dut.rst)
        self.model = Model(self.axes, self.clock_hz, self.filtered, by_edges=self.by_edges)
        self.model.pass_cycle(pins, tick=False)
        self.cycle = 1

    def _set(self, pins: list[int], *, tick: bool) -> None:
        levels = {
            name: sum((own >> bit & 1) << axis for axis, own in enumerate(pins)) for bit, name in enumerate("abz")
        }
        for name, value in {**levels, "tick": int(tick)}.items():
            if self._given.get(name) != value:
                self._given[name] = value
                getattr(self.dut, name).value = value

    async def pass_cycle(self, pins: list[int]) -> None:
        """Pass a clock edge with these pins, and compare what is there before it."""
        tick = bool(TICK) and self.cycle % TICK == 0
        self._set(pins, tick=tick)
        await RisingEdge(self.dut.clk)
        wanted = self.model.outputs()
        for number, (handle, name, bits) in enumerate(self._handles):
            # What is to stand still is looked at in turn: looking takes most of the time.
            if wanted[name] != self._shown.get(name) or self.cycle % len(self._handles) == number:
                packed = sum((value % 2**bits) << axis * bits for axis, value in enumerate(wanted[name]))
                assert int(handle.value) == packed, f"{name} in cycle {self.cycle}: {wanted[name]}"
        self._shown = wanted
        self.model.pass_cycle(pins, tick=tick)
        self.cycle += 1


def _random_pins(rng: random.Random, filtered: int) -> Iterator[int]:
    """Yield pins that turn at changing rates in both directions, with glitches, errors, and rests."""
    place, z = rng.randrange(4), 0
    while True:
        period = rng.choice((1, 2, filtered, filtered + 1, filtered + 2, 3 * filtered + 5, 200, 900))
        way = rng.choice((-1, 1))
        for _ in range(rng.randrange(1, max(3, 600 // period))):
            place += rng.choices((way, -way, 2), (30, 2, 1))[0]
            z ^= rng.random() < 0.1
            for _ in range(period):
                glitch = rng.choice((1, 2, 4)) if rng.random() < 0.02 else 0
                yield (_PHASES[place % 4] | z << 2) ^ glitch
        for _ in range(rng.choice((0, 0, 0, 50, 1500))):
            yield _PHASES[place % 4] | z << 2


@cocotb.test
async def all_outputs_are_those_of_the_model_in_every_cycle(dut: SimHandleBase) -> None:
    bench = Bench(dut)
    sources = [_random_pins(random.Random(axis), bench.filtered) for axis in range(bench.axes)]
    await bench.begin([next(source) for source in sources])
    for _ in range(CYCLES):
        await bench.pass_cycle([next(source) for source in sources])
    model = bench.model
    assert all(axis.index_count and axis.edge.cycle for axis in model.axes)
    assert bench.by_edges or all(axis.errors for axis in model.axes)


@cocotb.test
async def the_first_levels_of_the_pins_are_no_movement(dut: SimHandleBase) -> None:
    bench = Bench(dut)
    await bench.begin([0b111] * bench.axes)
    for _ in range(100):
        await bench.pass_cycle([0b111] * bench.axes)
    for name in _OUTPUTS:
        assert int(getattr(dut, name).value) == 0


@cocotb.test
async def the_velocity_is_a_mean_of_the_real_one_between_two_edges_to_a_cycle(dut: SimHandleBase) -> None:
    """Each value lies between the least and the greatest real velocity since the first of its edges, to the bound."""
    bench = Bench(dut)
    fastest = 0.8 / (bench.filtered + 2)
    place, history = 0.5, [0.0]
    await bench.begin([0] * bench.axes)
    delay, seen = bench.filtered + 4, 0
    # Some turns of a slow swing, in counts per cycle.
    for cycle in range(CYCLES // 2):
        speed = fastest * math.sin(cycle / 3000) * math.sin(cycle / 700) ** 2
        place += speed
        history.append(speed)
        whole = math.floor(place)
        await bench.pass_cycle([_PHASES[whole % 4]] * bench.axes)
        velocity = bench.model.velocities[0]
        value = velocity.value / 256 / bench.clock_hz
        if velocity.used is None:
            continue
        first, last = velocity.used
        real = history[max(0, first.cycle - delay) : last.cycle + 1]
        bound = abs(value) / (last.cycle - first.cycle) + 1 / 256 / bench.clock_hz
        assert min(real) - bound <= value <= max(real) + bound
        seen += 1
    assert seen > CYCLES // 8


@cocotb.test
async def the_velocity_of_a_stopped_axis_falls_as_one_count_by_the_time_and_then_is_zero(dut: SimHandleBase) -> None:
    bench = Bench(dut)
    period = 4 * (bench.filtered + 2)
    standstill = 2 ** math.ceil(math.log2((bench.clock_hz + 1) // 2))
    await bench.begin([0] * bench.axes)
    place = 0
    for cycle in range(20 * period + 3 * (TICK or standstill)):
        place -= cycle % period == 0
        await bench.pass_cycle([_PHASES[place % 4]] * bench.axes)
    velocity, axis = bench.model.velocities[0], bench.model.axes[0]
    assert abs(velocity.value / 256 + bench.clock_hz / period) <= bench.clock_hz / period / period
    # One round finds the edge, and the next one that there was none since.
    late = 2 * (TICK or standstill) + 2 * bench.axes * (2 * (math.ceil(math.log2(bench.clock_hz)) + 9) + 6)
    while bench.cycle < axis.edge.cycle + standstill + late:
        await bench.pass_cycle([_PHASES[place % 4]] * bench.axes)
        age = bench.cycle - axis.edge.cycle - late
        if age > 0:
            assert 0 <= -velocity.value / 256 <= bench.clock_hz / age
    assert velocity.value == 0

"""Inside the simulator: step generators beside a model that is true to the bit.

The model keeps no account of the way that an axis needs to stop: it works that out for each round, by a formula.
"""

from __future__ import annotations

import dataclasses
import json
import os
import random
from typing import TYPE_CHECKING, NamedTuple

import cocotb
from cocotb.triggers import RisingEdge

from gateware.bench.streams import start

if TYPE_CHECKING:
    from collections.abc import Sequence

    from cocotb.handle import SimHandleBase

_CYCLES_OF_AXIS = 7
_OUTPUTS = {"position": 32, "velocity": 29, "in_position": 1, "holding": 1, "step": 1, "dir": 1}
_COMMANDS = {"position_cmd": 32, "velocity_cmd": 29, "mode": 1, "maxvel": 28, "maxaccel": 28}


@dataclasses.dataclass(frozen=True)
class Settings:
    """Generics of the entity, and what follows from them."""

    axes: int = 1
    clock_hz: int = 50_000_000
    steplen_ns: int = 2000
    stepspace_ns: int = 2000
    dirsetup_ns: int = 5000
    dirhold_ns: int = 5000
    reverse: bool = False

    @property
    def rate_bits(self) -> int:
        """Rounds a second, as a power of two."""
        return max(bits for bits in range(8, 21) if self.clock_hz >> bits >= _CYCLES_OF_AXIS * self.axes)

    def rounds(self, duration_ns: int) -> int:
        """Return the rounds of a duration, each as short as one can be."""
        cycles = -(-duration_ns * self.clock_hz // 10**9)
        return max(-(-cycles // (self.clock_hz >> self.rate_bits)), 1)

    @property
    def length(self) -> int:
        """Rounds of a pulse."""
        return self.rounds(self.steplen_ns)

    @property
    def space(self) -> int:
        """Rounds between two pulses."""
        return self.rounds(self.stepspace_ns)

    @property
    def hold(self) -> int:
        """Rounds of a direction behind a pulse."""
        return self.rounds(self.dirhold_ns)

    @property
    def setup(self) -> int:
        """Rounds of a direction before a pulse."""
        return max(self.rounds(self.dirsetup_ns), self.space)

    @property
    def fastest(self) -> int:
        """The highest speed, in steps/s * 2 ** -8."""
        return 2 ** (self.rate_bits + 8) // (self.length + self.space)


class Commands(NamedTuple):
    """Commands of an axis, in units of the registers; `mode` is 1 for a velocity."""

    position_cmd: int = 0
    velocity_cmd: int = 0
    mode: int = 0
    maxvel: int = 0
    maxaccel: int = 0


class Axis:
    """One axis: its motion, in units of a round, and its pins."""

    def __init__(self, settings: Settings) -> None:
        """Stand at 0."""
        self._settings = settings
        self._fraction = 2 * settings.rate_bits
        self.place = self.speed = 0
        self.accel = 0
        """The acceleration that acts."""
        self.down, self.known = False, True
        self.step = self.points_down = False
        self.arrived = False
        self._turned, self._age = True, 1

    @property
    def steps(self) -> int:
        """Nearest step; a half is the one above."""
        return (self.place >> self._fraction - 1) + 1 >> 1

    @property
    def position(self) -> int:
        """The place in units of the register."""
        return self.place >> self._fraction - 8

    @property
    def velocity(self) -> int:
        """The velocity in units of the register, by the direction of the last round."""
        size = self.speed >> self._settings.rate_bits - 8
        return -size if self._was_down else size

    _was_down = False

    def needed(self, accel: int) -> int:
        """Return the way of one more round at this speed, and of those that slow it down; 0 without a limit."""
        if not accel:
            return 0
        rounds = self.speed // accel
        return self.speed * (1 + rounds) - accel * rounds * (rounds + 1) // 2

    def pass_round(self, commands: Commands, *, follows: bool) -> None:
        """Pass a round. A new `maxaccel` acts if the axis stands, or follows nothing."""
        old, down, stands = self.place, self.down, not self.speed
        if stands or not follows:
            self.accel = commands.maxaccel
        self._accelerate(commands._replace(maxaccel=self.accel), follows=follows)
        self.known = not self.speed or (self.known and follows and not commands.mode)
        self._was_down = down
        steps = self.steps
        self.place = self._wrapped(old - self.speed if down else old + self.speed)
        if not self._pulse(crosses=steps != self.steps, down=down, stands=stands):
            self.place = old

    def _accelerate(self, commands: Commands, *, follows: bool) -> None:
        unit = self._settings.rate_bits - 8
        accel, limit = commands.maxaccel, min(commands.maxvel, self._settings.fastest) << unit
        slower = max(0, self.speed - accel) if accel else 0
        base = self.speed if accel else 0
        faster = base + min(accel or limit, limit)
        self.arrived, stands = False, not self.speed
        if commands.mode:
            bound = most = min(abs(commands.velocity_cmd) << unit, limit)
            wrong = self.down != (commands.velocity_cmd < 0)
        else:
            away = self._wrapped((commands.position_cmd << self._fraction - 8) - self.place)
            if self.down:
                away = self._wrapped(-away)
            bound, most = away - self.needed(accel), limit
            wrong = self.known and bound < 0
        if stands and follows and wrong:
            self.down = not self.down
        if not follows or wrong or base > most or not (self.known or commands.mode):
            self.speed = slower
        elif bound <= faster and (stands or commands.mode or not accel):
            self.arrived = not bound and not commands.mode
            self.speed = bound
        elif bound > faster and faster <= limit:
            self.speed = faster

    def _wrapped(self, place: int) -> int:
        half = 1 << self._fraction + 23
        return (place + half) % (2 * half) - half

    def _pulse(self, *, crosses: bool, down: bool, stands: bool) -> bool:
        """Pass a round at the pins; returns whether the axis may move: it makes no step, or that begins."""
        settings = self._settings
        rested = not self.step and self._age >= (settings.setup if self._turned else settings.space)
        begins = crosses and rested and self.points_down == down
        ends = self.step and self._age >= settings.length
        turns = self.points_down != down and not stands and not self.step and self._age >= settings.hold
        self.step = begins or (self.step and not ends)
        self.points_down ^= turns
        self._turned = (self._turned or turns) and not begins
        most = max(settings.length, settings.space, settings.hold, settings.setup)
        self._age = 1 if begins or ends or turns else min(self._age + 1, most)
        return begins or not crosses


class Model:
    """The entity, cycle for cycle."""

    def __init__(self, settings: Settings) -> None:
        """Begin as behind a reset."""
        self._settings = settings
        self._rounds = 1 << settings.rate_bits
        self.axes = [Axis(settings) for _ in range(settings.axes)]
        self._time_left = self._rounds - settings.clock_hz
        self._begins = self._writes = self._busy = False
        self._clearing = True
        self._stage = self._axis = self._write_axis = 0
        self._fresh, self._dirty, self._there = ([False] * settings.axes for _ in range(3))
        self._taken = (Commands(), False)
        self._shown = [(0, 0, False, settings.reverse)] * settings.axes
        """Position, velocity, step and direction of each axis."""
        self.changed = True
        """Outputs may be others than before the last edge."""

    def edge(self, commands: Sequence[Commands], written: Sequence[Commands], armed: int) -> None:
        """Pass a clock edge; `written` has what pulses, and `armed` a bit for each axis."""
        obeys = self._obeys(commands, armed)
        takes = self._busy and self._stage == 0
        writes, write_axis, axis = self._writes, self._write_axis, self._axis
        self.changed = writes
        if takes:
            self._taken = (commands[axis], obeys[axis])
        if writes:
            self._write(write_axis)
        self._count()
        for index, pulses in enumerate(written):
            if takes and index == axis:
                self._dirty[index] = False
            if pulses.position_cmd or pulses.mode:
                self._dirty[index], self._there[index] = True, False
                self.changed = True
            self._fresh[index] = (self._fresh[index] or bool(pulses.position_cmd)) and bool(armed >> index & 1)

    def _write(self, index: int) -> None:
        axis = self.axes[index]
        self._shown[index] = (axis.position, axis.velocity, axis.step, axis.points_down ^ self._settings.reverse)
        self._there[index] = axis.arrived and not self._dirty[index]
        self._clearing &= index != self._settings.axes - 1

    def _count(self) -> None:
        settings = self._settings
        begun, self._begins = self._begins, self._time_left >= 0
        self._time_left += self._rounds - (settings.clock_hz if self._begins else 0)
        self._writes, self._write_axis = False, self._axis
        if self._busy:
            self._stage += 1
            if self._stage == _CYCLES_OF_AXIS:
                if not self._clearing:
                    commands, follows = self._taken
                    self.axes[self._axis].pass_round(commands, follows=follows)
                self._stage, self._writes = 0, True
                self._axis = (self._axis + 1) % settings.axes
                self._busy = self._axis != 0
        self._busy |= begun

    def _obeys(self, commands: Sequence[Commands], armed: int) -> list[bool]:
        return [
            bool(armed >> index & 1) and (self._fresh[index] or bool(own.mode)) for index, own in enumerate(commands)
        ]

    def outputs(self, commands: Sequence[Commands], armed: int) -> dict[str, list[int]]:
        """Return what the outputs show of each axis."""
        obeys = self._obeys(commands, armed)
        position, velocity, step, direction = zip(*self._shown, strict=True)
        return {
            "position": list(position),
            "velocity": list(velocity),
            "in_position": [int(there and own) for there, own in zip(self._there, obeys, strict=True)],
            "holding": [int(not own) for own in obeys],
            "step": list(map(int, step)),
            "dir": list(map(int, direction)),
        }


class Stimulus:
    """Random commands, of which many are extreme, and arming; they change in any cycle."""

    def __init__(self, settings: Settings, rng: random.Random) -> None:
        """Take the generics and what chooses."""
        self._settings, self._rng = settings, rng
        # The highest speed is reached within some dozens of rounds, if an acceleration can do that.
        rate = 1 << settings.rate_bits
        self._speed = settings.fastest
        self._accel = min(self._speed * rate // 256 // 20, 2**28 - 1)
        self._span = 40 * self._speed // rate
        self._round = settings.clock_hz / rate
        self._rarely = [0.0] * settings.axes
        """Chance of a command of each axis, in a cycle."""
        accels = (self._accel, 0) if settings.rate_bits < 16 else (0,)
        self.commands = [Commands(maxvel=self._speed, maxaccel=rng.choice(accels)) for _ in self._rarely]
        self.written = [Commands()] * settings.axes
        self.armed = 0

    def next(self) -> bool:
        """Choose the inputs of the next cycle; returns whether some have changed."""
        rng, was = self._rng, (self.armed, any(map(any, self.written)))
        self.written = [Commands()] * self._settings.axes
        for index, rarely in enumerate(self._rarely):
            if rng.random() < rarely:
                self._write(index)
            if rng.random() < 0.01 / self._round:
                self._rarely[index] = rng.choice((0, 0.005, 0.02, 0.1)) / self._round
        if rng.random() < 0.001 / self._round:
            self.armed ^= 1 << rng.randrange(self._settings.axes)
        elif self.armed + 1 < 1 << self._settings.axes and rng.random() < 0.02 / self._round:
            self.armed = (1 << self._settings.axes) - 1
        return (self.armed, any(map(any, self.written))) != (was[0], False) or was[1]

    def _write(self, index: int) -> None:
        rng, own = self._rng, self.commands[index]
        name = rng.choices(list(_COMMANDS), (20, 5, 3, 2, 2))[0]
        speed = rng.choice((self._speed, rng.randrange(self._speed + 1), rng.randrange(self._speed // 8 + 2)))
        match name:
            case "position_cmd":
                value = rng.choice((rng.randrange(-self._span, self._span), own.position_cmd + rng.randrange(-9, 9)))
                # The shortest way leads round the end.
                value = value if rng.random() < 0.97 else rng.choice((2**31 - 1, -(2**31)))
                value = (value + 2**31) % 2**32 - 2**31
            case "velocity_cmd":
                value = rng.choice((rng.choice((-1, 1, 0)) * speed, rng.choice((-1, 1)) * (2**28 - 1), -(2**28)))
            case "mode":
                value = 1 - own.mode
            case "maxvel":
                value = rng.choice((speed, self._speed, self._speed, self._speed, 2**28 - 1, 0))
            case _:
                value = rng.choice(
                    (rng.randrange(self._accel // 2, self._accel), self._accel, self._accel, 2**28 - 1, 0)
                )
        self.commands[index] = own._replace(**{name: value})
        self.written[index] = Commands()._replace(**{name: 1})


def packed(values: Sequence[int], bits: int) -> int:
    """Return the values of all axes as the entity has them."""
    return sum((value % 2**bits) << index * bits for index, value in enumerate(values))


def _set(dut: SimHandleBase, stimulus: Stimulus) -> None:
    dut.armed.value = stimulus.armed
    for number, (name, bits) in enumerate(_COMMANDS.items()):
        getattr(dut, name).value = packed([own[number] for own in stimulus.commands], bits)
        getattr(dut, f"{name}_written").value = packed([own[number] for own in stimulus.written], 1)


class Counter:
    """Steps at the pins of an axis."""

    def __init__(self) -> None:
        """Begin with none."""
        self.steps = self.total = 0
        self._was_high = False

    def see(self, *, step: bool, down: bool) -> None:
        """Take the levels of a cycle."""
        if step and not self._was_high:
            self.steps += -1 if down else 1
            self.total += 1
        self._was_high = step


@cocotb.test
async def all_outputs_are_those_of_the_model_in_every_cycle(dut: SimHandleBase) -> None:
    settings = Settings(**json.loads(os.environ["GENERICS"]))
    cycles = int(os.environ["CYCLES"])
    stimulus = Stimulus(settings, random.Random(cycles))
    _set(dut, stimulus)
    await start(dut.clk, dut.rst)
    model = Model(settings)
    counters = [Counter() for _ in model.axes]
    handles = [(getattr(dut, name), name, bits) for name, bits in _OUTPUTS.items()]
    arrived, shown = 0, model.outputs(stimulus.commands, stimulus.armed)
    model.edge(stimulus.commands, stimulus.written, stimulus.armed)
    for cycle in range(cycles):
        changed = stimulus.next()
        if changed:
            _set(dut, stimulus)
        await RisingEdge(dut.clk)
        was = shown
        if changed or model.changed:
            shown = model.outputs(stimulus.commands, stimulus.armed)
        for number, (handle, name, bits) in enumerate(handles):
            # What is to stand still is looked at in turn: looking takes most of the time.
            if shown[name] != was[name] or cycle % len(handles) == number:
                wanted = packed(shown[name], bits)
                assert int(handle.value) == wanted, f"{name} in cycle {cycle} is {int(handle.value):x}, not {wanted:x}"
        for axis, counter in enumerate(counters):
            counter.see(step=bool(shown["step"][axis]), down=bool(shown["dir"][axis]) != settings.reverse)
            assert (counter.steps - ((shown["position"][axis] + 128) >> 8)) % 2**24 == 0
            # A new command is seen one cycle later.
            if shown["in_position"][axis] and not stimulus.written[axis].position_cmd:
                assert shown["position"][axis] == stimulus.commands[axis].position_cmd
        arrived += any(shown["in_position"]) and not any(was["in_position"])
        model.edge(stimulus.commands, stimulus.written, stimulus.armed)
    assert arrived
    assert sum(counter.total for counter in counters) > 3

"""Bench: ul_lease equals a model in every cycle, for any words of owners and others, e-stops and resets.

The model uses absolute times and no countdown: a lease lasts until its end.
"""

from __future__ import annotations

import collections
import dataclasses
import json
import os
import random
from typing import TYPE_CHECKING, NamedTuple

import cocotb
from cocotb.triggers import RisingEdge

from gateware.bench.streams import start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

TIME = 1 << 40
"""Times of ends are modulo this number of cycles."""
DISARMED, ARMED, FAULT, FINISHING = range(4)
NONE, BY_DISARM, SILENCE, ESTOP = range(4)
WANTS_FINISH = 1 << 23
"""Bit of a token with which its owner wants pending entries to continue after the end."""
OUTPUTS = {
    "armed": 1,
    "state": 2,
    "finishing": 1,
    "reason": 3,
    "arms": 16,
    "estop_open": 1,
    "enable": 1,
    "fault_time": 64,
}
"""Bits of each output for one axis."""


@dataclasses.dataclass(frozen=True)
class Settings:
    """Generics of the entity."""

    axes: int = 1
    clock_hz: int = 50_000_000
    most_us: int = 100_000
    finish_us: int = 0
    estop_used: bool = True

    @property
    def most(self) -> int:
        """Maximum number of cycles to the end."""
        return -(-self.most_us * self.clock_hz // 10**6)

    @property
    def more(self) -> int:
        """Maximum number of cycles for which a lease continues after its end."""
        return -(-self.finish_us * self.clock_hz // 10**6)


class Word(NamedTuple):
    """Value written to `arm` or `kick`."""

    token: int = 0
    end: int = 0

    def packed(self) -> int:
        """Return the word in the format of the entity's ports."""
        return self.token * TIME + self.end


class Inputs(NamedTuple):
    """Inputs of an axis in a cycle; None for a word that is not written."""

    arm: Word | None = None
    kick: Word | None = None
    disarm: bool = False
    estop: bool = False
    empty: bool = True


class Axis:
    """One axis of the model: its state after each clock edge."""

    def __init__(self, settings: Settings) -> None:
        """Store the generics."""
        self._settings = settings
        # The valid word written in the cycle before, and if it was an arm.
        self._asked: tuple[Word, bool] | None = None
        self._lease = Word()
        self._pin_before, self._open = True, True
        self.state, self.reason, self.fault_time, self.arms = DISARMED, NONE, 0, 0
        self.happened: collections.Counter[str] = collections.Counter()

    def clock(self, inputs: Inputs, now: int, *, reset: bool) -> dict[str, int]:
        """Simulate one clock edge and return the outputs after it."""
        stops = self._open and self._settings.estop_used
        if reset:
            self.state, self.reason, self.fault_time, self.arms = DISARMED, NONE, 0, 0
        elif stops:
            self._fall(FAULT, ESTOP, now)
        elif inputs.disarm:
            self._fall(DISARMED, BY_DISARM, now)
        elif self._takes(now):
            assert self._asked
            self.happened["arm" if self.state != ARMED else "kick"] += 1
            self.arms = (self.arms + (self.state != ARMED)) % 2**16
            self.state, self._lease = ARMED, self._asked[0]
        elif self.state == ARMED and (self._lease.end - now) % TIME == 1 and not inputs.empty and self._may_finish:
            self.happened["goes on"] += 1
            self.state, self._lease = FINISHING, Word(0, (self._lease.end + self._settings.more) % TIME)
        elif (self._lease.end - now) % TIME == 1:
            self.happened["goes on to the last"] += self.state == FINISHING
            self._fall(FAULT, SILENCE, now)
        elif self.state == FINISHING and inputs.empty:
            self.happened["goes on until it is empty"] += 1
            self._fall(FAULT, SILENCE, now)
        self._asked = None if reset or inputs.disarm else self._written(inputs, now)
        self._open, self._pin_before = reset or self._pin_before, reset or not inputs.estop
        return self._outputs()

    @property
    def _may_finish(self) -> bool:
        return self._settings.more > 0 and bool(self._lease.token & WANTS_FINISH)

    def _outputs(self) -> dict[str, int]:
        armed = int(self.state in {ARMED, FINISHING})
        return {
            "armed": armed,
            "state": self.state,
            "finishing": int(self.state == FINISHING),
            "reason": self.reason,
            "arms": self.arms,
            "estop_open": int(self._open and self._settings.estop_used),
            "enable": armed,
            "fault_time": self.fault_time,
        }

    def _written(self, inputs: Inputs, now: int) -> tuple[Word, bool] | None:
        """Return the word of a cycle, unless its end is past or too far ahead, or it wants an unsupported finish."""
        word = inputs.arm or inputs.kick
        if word is None or not 0 < (word.end - now) % TIME <= self._settings.most:
            return None
        if word.token & WANTS_FINISH and not self._settings.more:
            return None
        return word, inputs.arm is not None

    def _takes(self, now: int) -> bool:
        """Return whether the word of the cycle before begins a lease or moves its end."""
        if self._asked is None or self.state == FINISHING:
            return False
        word, is_arm = self._asked
        # Counted from now: an end that has passed since is far ahead.
        ahead = (word.end - now) % TIME
        if self.state == ARMED:
            return word.token == self._lease.token and (self._lease.end - now) % TIME < ahead < TIME // 2
        return is_arm and 1 < ahead < TIME // 2

    def _fall(self, state: int, reason: int, now: int) -> None:
        if self.state in {ARMED, FINISHING}:
            self.happened[f"fall {reason}"] += 1
            self.state, self.reason = state, reason
            self.fault_time = now if state == FAULT else self.fault_time


class Stimulus:
    """Random inputs of an axis: ends around every limit, nearly equal tokens, and all other inputs at any time."""

    def __init__(self, settings: Settings, rng: random.Random) -> None:
        """Store the generics and the random generator."""
        self._most, self._rng = settings.most, rng
        self._tokens = [rng.getrandbits(23) | (WANTS_FINISH if settings.more else 0)] * 6
        self._tokens += [self._tokens[0] ^ 1 << rng.randrange(24), rng.getrandbits(24)]
        self._last = Inputs(estop=True)
        self._longest = settings.more + 1
        self._end = 0

    def next(self, now: int) -> Inputs:
        """Return the inputs of the next cycle."""
        rng = self._rng
        chance = rng.random()
        estop = rng.random() < (0.99 if self._last.estop else 0.3)
        word = self._word(now) if chance < 0.2 else None
        self._last = Inputs(
            arm=word if chance < 0.08 else None,
            kick=self._word(now) if chance < 0.01 else word if chance >= 0.08 else None,
            disarm=rng.random() < (0.3 if chance < 0.01 else 0.01),
            estop=estop,
            empty=rng.random() < (1 / self._longest if not self._last.empty else 0.2),
        )
        return self._last

    def _word(self, now: int) -> Word:
        rng, most = self._rng, self._most
        ahead = rng.choice(
            [
                *(rng.randint(-3, 5), most + rng.randint(-3, 3)),
                *(rng.randint(1, min(most, 60)), rng.randint(1, most)),
                *(TIME // 2 + rng.randint(-1, 1), rng.getrandbits(40)),
            ]
        )
        end = rng.choice([now + ahead, now + ahead, self._end + rng.randint(-1, 1)])
        self._end = end
        return Word(rng.choice(self._tokens), end % TIME)


def _joined(parts: list[int], bits: int) -> int:
    return sum(part << index * bits for index, part in enumerate(parts))


class Driver:
    """Sets the inputs of the entity for all axes."""

    def __init__(self, dut: SimHandleBase, axes: int) -> None:
        """Set all inputs to their initial values."""
        self._dut = dut
        self._values: dict[str, int] = {}
        self._words = {name: [0] * axes for name in ("arm", "kick")}
        self.drive([Inputs()] * axes, 0, reset=True)

    def drive(self, inputs: list[Inputs], now: int, *, reset: bool) -> None:
        """Set the inputs of the next cycle."""
        values = {"now": now, "rst": int(reset)}
        for name, words in self._words.items():
            given = [getattr(one, name) for one in inputs]
            self._words[name] = [word.packed() if word else old for word, old in zip(given, words, strict=True)]
            values[name] = _joined(self._words[name], 64)
            values[f"{name}_written"] = _joined([word is not None for word in given], 1)
        values["disarm"] = values["disarm_written"] = _joined([one.disarm for one in inputs], 1)
        for name in ("estop", "empty"):
            values[name] = _joined([getattr(one, name) for one in inputs], 1)
        for name, value in values.items():
            if self._values.get(name) != value:
                getattr(self._dut, name).value = value
        self._values = values


@cocotb.test
async def it_is_as_the_model_in_every_cycle(dut: SimHandleBase) -> None:
    settings = Settings(**json.loads(os.environ["GENERICS"]))
    cycles, rng = int(os.environ["CYCLES"]), random.Random(os.environ["CYCLES"])
    driver = Driver(dut, settings.axes)
    await start(dut.clk, dut.rst)
    dut.rst.value = 1
    axes = [Axis(settings) for _ in range(settings.axes)]
    stimuli = [Stimulus(settings, rng) for _ in axes]
    handles = {name: getattr(dut, name) for name in OUTPUTS}
    expected: dict[str, int] = {}
    now, reset = 0, True
    for cycle in range(cycles):
        # A reset restarts the time; here also just before an overflow that would take days.
        starts = (0, TIME - 300, 2**64 - 300, rng.getrandbits(64))
        now = rng.choice(starts) if reset else (now + 1) % 2**64
        reset = cycle < 3 or rng.random() < (0.5 if reset else 0.001)
        inputs = [stimulus.next(now) for stimulus in stimuli]
        driver.drive(inputs, now, reset=reset)
        await RisingEdge(dut.clk)
        for name, value in expected.items():
            seen = int(handles[name].value)
            assert seen == value, f"cycle {cycle}: {name} is {seen:#x}, {value:#x} was expected"
        assert int(dut.clock.value) == _joined([now] * settings.axes, 64)
        after = [axis.clock(one, now, reset=reset) for axis, one in zip(axes, inputs, strict=True)]
        expected = {name: _joined([one[name] for one in after], bits) for name, bits in OUTPUTS.items()}
    for axis in axes:
        kinds = ["arm", f"fall {SILENCE}"]
        # The shortest lease lasts for one cycle, too short for a kick, a disarm or an e-stop.
        if settings.most > 3:
            kinds += ["kick", f"fall {BY_DISARM}", *([f"fall {ESTOP}"] * settings.estop_used)]
        if settings.more:
            kinds += ["goes on", "goes on until it is empty", "goes on to the last"]
        assert all(axis.happened[kind] > cycles / 5000 for kind in kinds), axis.happened

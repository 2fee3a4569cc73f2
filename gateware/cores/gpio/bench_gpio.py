"""Bench: ul_gpio equals a model in every cycle, however its pins bounce."""

from __future__ import annotations

import os
import random
from typing import TYPE_CHECKING, NamedTuple

import cocotb
from cocotb.triggers import RisingEdge

from gateware.bench.streams import start

if TYPE_CHECKING:
    from collections.abc import Sequence

    from cocotb.handle import SimHandleBase


class Inputs(NamedTuple):
    """Inputs of the entity, one bit for each axis."""

    pin_in: int = 0
    output: int = 0
    drive: int = 0
    armed: int = 0
    now: int = 0
    rst: int = 1


class Axis:
    """One axis of the model: its state after each clock edge."""

    def __init__(self, stands: int) -> None:
        """Store the number of cycles for which a new level must be stable; a reset must come first."""
        self._stands = stands
        self._pins = [0, 0]
        self._differed_for = 0
        self.level = self.edges = self.last = self.edge = 0

    def clock(self, pin: int, now: int, *, reset: bool) -> None:
        """Simulate one clock edge."""
        settled = self._pins.pop(0)
        self._pins.append(pin)
        self._differed_for = self._differed_for + 1 if settled != self.level else 0
        self.edge = int(self._differed_for == self._stands)
        if self.edge:
            self.level, self.last, self._differed_for = settled, now & 0xFFFFFFFF, 0
            self.edges = (self.edges + 1) & 0xFFFF
        if reset:
            self.level, self.edges, self.last, self.edge, self._differed_for = settled, 0, 0, 0, 0


class Model:
    """All axes."""

    def __init__(self, axes: int, stands: int) -> None:
        """Create the axes, with the number of cycles for which a new level must be stable."""
        self._axes = [Axis(stands) for _ in range(axes)]

    def clock(self, inputs: Inputs) -> dict[str, int]:
        """Simulate one clock edge and return each output after it by its name."""
        for index, axis in enumerate(self._axes):
            axis.clock(inputs.pin_in >> index & 1, inputs.now, reset=bool(inputs.rst))
        return {
            **{
                name: self._joined(name, bits)
                for name, bits in {"level": 1, "edges": 16, "last": 32, "edge": 1}.items()
            },
            "pin_out": 0 if inputs.rst else inputs.output,
            "pin_oe": 0 if inputs.rst else inputs.drive & inputs.armed,
        }

    def _joined(self, name: str, bits: int) -> int:
        return sum(getattr(axis, name) << index * bits for index, axis in enumerate(self._axes))


class Stimulus:
    """Random inputs: pins that bounce and settle, and all other inputs at any time."""

    def __init__(self, axes: int, stands: int, rng: random.Random) -> None:
        """Store the generics and the random generator."""
        self._axes, self._stands, self._rng = axes, stands, rng
        self._changes_in = [0] * axes
        self._inputs = Inputs()

    def next(self) -> Inputs:
        """Return the inputs of the next cycle."""
        rng, last = self._rng, self._inputs
        pins = last.pin_in
        for axis in range(self._axes):
            if self._changes_in[axis] == 0:
                pins ^= 1 << axis
                # For less than the debouncing time, for just that time, and for longer.
                self._changes_in[axis] = rng.choice([rng.randint(0, self._stands), self._stands - 1, self._stands + 3])
            else:
                self._changes_in[axis] -= 1
        inputs = last._replace(pin_in=pins, rst=int(rng.random() < (0.5 if last.rst else 0.001)))
        if rng.random() < 0.2:
            bits = [rng.getrandbits(self._axes) for _ in range(4)]
            inputs = inputs._replace(output=bits[0], drive=bits[1], armed=bits[2] | bits[3], now=rng.getrandbits(64))
        self._inputs = inputs
        return inputs


def _stands(dut: SimHandleBase) -> int:
    """Return the number of cycles for which a new level must be stable."""
    return max(-(-int(dut.debounce_us.value) * int(dut.clock_hz.value) // 10**6), 1)


def _drive(dut: SimHandleBase, before: Inputs, inputs: Inputs) -> None:
    for name in _changed(before, inputs):
        getattr(dut, name).value = getattr(inputs, name)


def _changed(before: Inputs, inputs: Inputs) -> Sequence[str]:
    return [name for name, old, new in zip(Inputs._fields, before, inputs, strict=True) if old != new]


@cocotb.test
async def it_is_as_the_model_in_every_cycle(dut: SimHandleBase) -> None:
    cycles, axes, stands = int(os.environ["CYCLES"]), int(dut.axes.value), _stands(dut)
    for name in Inputs._fields:
        getattr(dut, name).value = getattr(Inputs(), name)
    dut.output_written.value, dut.drive_written.value = 0, 0
    await start(dut.clk, dut.rst)
    model, stimulus, inputs = Model(axes, stands), Stimulus(axes, stands, random.Random(cycles)), Inputs()
    dut.rst.value = 1
    for _ in range(3):
        await RisingEdge(dut.clk)
        expected = model.clock(inputs)
    outputs = {name: getattr(dut, name) for name in expected}
    # Compared less often: these keep their values until the next edge, so an error in them remains visible.
    kept = {name: outputs.pop(name) for name in ("edges", "last")}
    clk, edges = dut.clk, 0
    for cycle in range(cycles):
        before, inputs = inputs, stimulus.next()
        _drive(dut, before, inputs)
        await RisingEdge(clk)
        looked_at = {**outputs, **kept} if inputs.rst or expected["edge"] or cycle % 16 == 0 else outputs
        for name, output in looked_at.items():
            seen = int(output.value)
            assert seen == expected[name], f"cycle {cycle}: {name} is {seen:#x}, {expected[name]:#x} was expected"
        edges += expected["edge"].bit_count()
        expected = model.clock(inputs)
    assert edges > 0.1 * axes * cycles / stands

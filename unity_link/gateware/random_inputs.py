"""Random inputs for a circuit, step by step, including its clocks; values at limits and near constants are frequent.

The inputs are divided into epochs. In each epoch a vector changes often or seldom, and a bit is mostly '0', mostly '1'
or both equally often. Resets occur at the start and several times soon after; later there are none, so that slow
processes can finish.
"""

from __future__ import annotations

import random
import re
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

_EPOCH = 128
"""Number of cycles in an epoch."""
_RESETS = (0, 64, 192, 448)
"""Cycles in which resets begin; until the last of these, further resets occur at random."""
_RESET_CYCLES = 4
_RESET_CHANCE = 1 / 64
_RESET = re.compile(r"_?(?:a|sync_?|async_?|sys_?)?(?:rst|reset|clr|clear)(?P<low>_?n)?(?:_i)?", re.IGNORECASE)
_PARTS = (8, 12, 16, 32, 64)
"""Widths of the numbers that are joined into a vector."""


class Input(NamedTuple):
    """An input of a circuit."""

    name: str
    width: int
    is_clock: bool = False


class RandomInputs:
    """Random inputs for a number of cycles.

    Args:
        inputs: all inputs.
        constants: constants in the circuit; the inputs have values near them.
        seed: seed of the random values.
        both_edges: True if the circuit also uses falling clock edges.
        tame: True for small numbers that change seldom.
    """

    def __init__(
        self,
        inputs: Sequence[Input],
        constants: Sequence[int],
        seed: int,
        *,
        both_edges: bool = False,
        tame: bool = False,
    ) -> None:
        self._random = random.Random(seed)  # noqa: S311  (no secret)
        self._inputs = inputs
        self._constants = [*constants, 0, 1]
        self._tame = tame
        self._clocks = [number for number, one in enumerate(inputs) if one.is_clock]
        self._apart = both_edges or len(self._clocks) > 1
        self._values = [0] * len(inputs)
        self._rates = [1.0] * len(inputs)

    def steps(self, cycles: int) -> Iterator[tuple[int, ...]]:
        """Yield the values of all inputs, in the order of `inputs`, for each step of a number of cycles."""
        for cycle in range(cycles):
            if cycle % _EPOCH == 0:
                self._rates = [self._random.choice(self._rates_of(one)) for one in self._inputs]
            for number, one in enumerate(self._inputs):
                if not one.is_clock:
                    self._values[number] = self._next(number, one, cycle)
                elif not self._apart:
                    # Change the data with the falling edge, which no register uses.
                    self._values[number] = 0
            yield tuple(self._values)
            for clock in self._random.sample(self._clocks, len(self._clocks)):
                self._values[clock] = 1
                yield tuple(self._values)
                if self._apart:
                    self._values[clock] = 0
                    yield tuple(self._values)

    def _rates_of(self, one: Input) -> Sequence[float]:
        if one.width == 1:
            return (0.02, 0.1, 0.5, 0.9)
        return (0.02, 0.1) if self._tame else (0.02, 0.25, 1.0, 1.0)

    def _next(self, number: int, one: Input, cycle: int) -> int:
        """Return the next value of an input."""
        reset = _RESET.fullmatch(one.name)
        if reset:
            begins = any(start <= cycle < start + _RESET_CYCLES for start in _RESETS)
            is_reset = begins or (cycle < _RESETS[-1] and self._random.random() < _RESET_CHANCE)
            return int(is_reset) ^ (1 if reset["low"] else 0)
        if one.width == 1:
            return int(self._random.random() < self._rates[number])
        if self._random.random() >= self._rates[number]:
            return self._values[number]
        size = min(one.width, self._random.choice((one.width, one.width, *_PARTS)))
        value = 0
        for start in range(0, one.width, size):
            value |= self._number(min(size, one.width - start)) << start
        return value

    def _number(self, width: int) -> int:
        """Return a number of `width` bits: any, a small one, one near a limit, a constant or another input."""
        chance = self._random.random()
        mask = (1 << width) - 1
        if self._tame or chance < 0.1:
            return self._random.getrandbits(min(width, 3))
        if chance < 0.5:
            return self._random.getrandbits(width)
        if chance < 0.6:
            return self._random.getrandbits(width) >> self._random.randrange(width)
        if chance < 0.7:
            return (self._random.choice((0, mask, 1 << (width - 1), mask >> 1)) + self._random.randint(-1, 1)) & mask
        if chance < 0.9:
            sign = self._random.choice((1, 1, -1))
            return (sign * self._random.choice(self._constants) + self._random.choice((-1, 0, 0, 1))) & mask
        others = [value for one, value in zip(self._inputs, self._values, strict=True) if one.width > 1]
        return (self._random.choice(others) + self._random.choice((-1, 0, 0, 1))) & mask

"""Inside the simulator: ul_schedule is as a model in every cycle, and its batches act in their cycle, once and whole.

The model knows batches and the cycles that each takes. A second one, which knows words, instants and ends of batches
but nothing of cycles, sees that what acts is what was sent, at its instant.
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
    from collections.abc import Iterator

    from cocotb.handle import SimHandleBase

TIME = 1 << 40
"""Instants are modulo this."""
FRAME = 2
"""Words of a batch beside those that its header counts."""
DEPTH = int(json.loads(os.environ["GENERICS"])["depth"])
OUTPUTS = ("commit", "empty", "stage_write", "stage_clear", "fates", "late", "refused", "room", "slack")
NO_SLACK = 2**31 - 1


class Inputs(NamedTuple):
    """Inputs of a cycle; a word that is None is not written."""

    word: int | None = None
    cancel: bool = False
    armed: bool = True
    finishing: bool = False

    @property
    def voids(self) -> bool:
        """Nothing acts of what came before."""
        return self.cancel or not self.armed

    @property
    def takes(self) -> bool:
        """A batch may come."""
        return self.armed and not self.finishing


def time_to(instant: int, now: int) -> int:
    """Return the cycles to an instant, negative for one that has passed."""
    return (instant - now + TIME // 2) % TIME - TIME // 2


def values_of(words: list[int]) -> dict[int, int] | None:
    """Return the words of a batch's runs by the index of their shadow; None if they are malformed."""
    values: dict[int, int] = {}
    rest = list(words)
    while rest:
        count, first = rest[0] >> 16, rest[0] & 0xFFFF
        if not 0 < count < len(rest):
            return None
        values |= {(first + place) % 2**16: rest[1 + place] for place in range(count)}
        rest = rest[1 + count :]
    return values


@dataclasses.dataclass
class Batch:
    """A batch as it comes."""

    header: int
    number: int
    good: bool
    rest: list[int] = dataclasses.field(default_factory=list)

    @property
    def count(self) -> int:
        """Words behind the instant."""
        return self.header >> 24

    @property
    def instant(self) -> int:
        """Cycle in which it acts, modulo 2 ** 40."""
        return (self.header & 0xFF) << 32 | self.rest[0]

    @property
    def is_whole(self) -> bool:
        """All of its words are there."""
        return len(self.rest) == 1 + self.count

    @property
    def values(self) -> dict[int, int] | None:
        """Words by the index of their shadow; None for a batch that is malformed."""
        return values_of(self.rest[1:]) if self.count and not self.header >> 8 & 0xFFFF else None


class Model:
    """The core, a clock cycle at a time: its outputs behind each edge."""

    def __init__(self) -> None:
        """Begin as behind a reset."""
        self._batch: Batch | None = None
        self._queue: collections.deque[Batch] = collections.deque()
        self._unread = 0
        self._ended = self._finished = self._ends = self.late = self.refused = 0
        self._slack = NO_SLACK
        self._gap: int | None = None
        self._stage: tuple[int, int] | None = None
        self._clear = False
        self.room = DEPTH
        self.acts = False
        self._inputs, self._now = Inputs(), 0
        self._reader = self._read()
        self._reads = False
        self.happened: collections.Counter[str] = collections.Counter()

    def outputs(self, inputs: Inputs, *, reset: bool) -> dict[str, int]:
        """Return the outputs of a cycle; `commit` depends on its inputs."""
        index, data = self._stage or (None, None)
        staged = {} if index is None or data is None else {"stage_index": index, "stage_data": data}
        return {
            "commit": int(self.acts and not inputs.voids and not reset),
            "empty": int(self._unread == 0),
            "stage_write": int(self._stage is not None),
            "stage_clear": int(self._clear),
            "fates": self._ends << 16 | self._finished,
            "late": self.late,
            "refused": self.refused,
            "room": self.room,
            "slack": self._slack % 2**32,
            **staged,
        }

    def edge(self, inputs: Inputs, now: int) -> None:
        """Make one edge of the clock."""
        self._inputs, self._now = inputs, now
        self.room = free = DEPTH - self._unread
        self._stage, self._clear = None, False
        if self._gap is not None:
            self._slack = min(self._slack, max(self._gap, -(2**31)))
            self._gap = None
        next(self._reader)
        if inputs.voids:
            if self._reads:
                self._reader = self._read()
            self._stage, self._clear, self.acts, self._reads = None, True, False, False
            self._queue.clear()
            self._unread = 0
        self._write(free)
        if inputs.cancel:
            self._slack, self._gap = NO_SLACK, None

    def _write(self, free: int) -> None:
        """Take the word of a cycle."""
        inputs = self._inputs
        if inputs.cancel:
            if self._batch:
                self._ended = (self._ended + 1) % 2**16
                self.happened["cancelled half sent"] += 1
            self._batch = None
            return
        if self._batch:
            self._batch.good &= inputs.takes
        if inputs.word is None:
            return
        if self._batch is None:
            count = inputs.word >> 24
            fits = count + FRAME <= free
            self.happened["fits to the word"] += count + FRAME == free
            self.happened["does not fit by a word"] += count + FRAME == free + 1
            good = inputs.takes and fits and count > 0 and not inputs.word >> 8 & 0xFFFF
            self._batch = Batch(inputs.word, self._ended, good)
            return
        self._batch.rest.append(inputs.word)
        if self._batch.is_whole:
            self._end(self._batch)

    def _end(self, batch: Batch) -> None:
        self._batch = None
        self._ended = (self._ended + 1) % 2**16
        if batch.good:
            self._queue.append(batch)
            self._unread += batch.count + FRAME
            self._gap = time_to(batch.instant, self._now)

    def _finish(self, kind: str) -> None:
        self.happened[kind] += 1
        self._finished = (self._finished + 1) % 2**16
        self._ends = (self._ends << 1 | (kind != "acts")) % 2**48
        self.late += kind == "late"
        self.refused += kind in {"refused", "malformed"}

    def _read(self) -> Iterator[None]:
        """Take batches from the queue; a cycle ends with each `yield`."""
        while True:
            # The header, or none.
            batch = self._queue[0] if self._queue else None
            refused = self._finished != (batch.number if batch else self._ended)
            yield
            if refused or (batch and not self._queue):
                self._finish("refused")
                yield
            elif batch and self._inputs.voids:
                yield
            if refused or batch is None or not self._queue:
                continue
            self._unread -= 1
            self._reads = True
            yield
            yield from self._stage_all(batch)
            # The instant.
            yield
            if batch.values is not None:
                yield
                while time_to(batch.instant, self._now) > FRAME:
                    yield
                self.acts = time_to(batch.instant, self._now) == FRAME
                yield
            if not self._inputs.voids:
                self._finish("acts" if self.acts else "malformed" if batch.values is None else "late")
                self._clear = not self.acts
            self.acts = self._reads = False
            self._queue.popleft()
            self._unread -= 1
            yield

    def _stage_all(self, batch: Batch) -> Iterator[None]:
        """Take the words of a batch to the shadows, also of runs that are none."""
        left = index = 0
        for place, word in enumerate(batch.rest[1:]):
            if place == 0 or left == 0:
                left, index = word >> 16 & 0xFF or 2**8, word & 0xFFFF
            else:
                self._stage = index, word
                left, index = left - 1, (index + 1) % 2**16
            self._unread -= 1
            yield


class Promise:
    """Batches as they were sent, and registers behind the shadows as a bank has them."""

    def __init__(self) -> None:
        """Begin as behind a reset."""
        self._sent: list[Batch] = []
        self._is_whole = True
        self._shadows: dict[int, int] = {}
        self._acted: list[tuple[int, dict[int, int]]] = []
        self.happened: collections.Counter[str] = collections.Counter()
        self._seen = 0

    def edge(self, inputs: Inputs, now: int, seen: dict[str, int]) -> None:
        """Look at the inputs and outputs of a cycle."""
        for _ in range((seen["fates"] - self._seen) % 2**16):
            self._has_ended(acted=not seen["fates"] >> 16 & 1)
        self._seen = seen["fates"] % 2**16
        self._words(inputs)
        if seen["commit"]:
            assert inputs.armed
            assert not seen["empty"]
            self.happened["acts behind the end"] += inputs.finishing
            assert not seen["stage_write"]
            self._acted.append((now + 1, self._shadows))
        if seen["commit"] or seen["stage_clear"] or not inputs.armed:
            self._shadows = {}
        elif seen["stage_write"]:
            self._shadows |= {seen["stage_index"]: seen["stage_data"]}

    def _words(self, inputs: Inputs) -> None:
        if not inputs.takes and not self._is_whole:
            self._sent[-1].good = False
        if inputs.voids:
            for batch in self._sent:
                batch.good = False
        if inputs.cancel:
            self._is_whole = True
        elif inputs.word is not None and self._is_whole:
            self._sent.append(Batch(inputs.word, 0, inputs.takes))
            self._is_whole = False
        elif inputs.word is not None:
            self._sent[-1].rest.append(inputs.word)
            self._is_whole = self._sent[-1].is_whole

    def _has_ended(self, *, acted: bool) -> None:
        batch = self._sent.pop(0)
        if acted:
            (now, values), self._acted = self._acted[0], self._acted[1:]
            assert batch.good
            assert batch.is_whole
            assert batch.instant == now % TIME
            assert batch.values == values
        assert not self._acted


class Stimulus:
    """Random batches with instants around every limit, and all that ends them in any cycle."""

    def __init__(self, rng: random.Random) -> None:
        """Take what chooses."""
        self._rng = rng
        self._words: list[int] = []
        self._instant = 0
        self._pace, self._lead = 1.0, 0
        self._armed, self._finishing = True, False

    def next(self, now: int, model: Model) -> Inputs:
        """Return the inputs of the next cycle."""
        rng = self._rng
        if rng.random() < 0.2 / (DEPTH + 100):
            self._pace = rng.choice([1.0, 1.0, 0.5, 0.05])
            self._lead = rng.choice([0, 10, 100, 3 * DEPTH])
        word = None
        if rng.random() < self._pace:
            self._words = self._words or self._batch(now, model.room)
            word = self._words.pop(0)
        # What ends all, also in the very cycle in which a batch would act.
        strikes = rng.random() < (0.05 if model.acts else 0.3 / (DEPTH + 100))
        cancel = strikes and rng.random() < 0.5
        self._armed = rng.random() < 0.3 if not self._armed else not strikes or rng.random() < 0.5
        if cancel:
            self._words = []
            word = rng.choice([None, None, rng.getrandbits(32)])
        self._finishing = rng.random() < (0.05 / (DEPTH + 100) if not self._finishing else 0.98)
        return Inputs(word, cancel, self._armed, self._finishing)

    def reset(self) -> None:
        """Begin with a header."""
        self._words, self._instant = [], 0

    def _batch(self, now: int, room: int) -> list[int]:
        runs = self._runs(room)
        instant = self._when(now, len(runs))
        reserved = 1 << self._rng.randrange(16) if self._rng.random() < 0.01 else 0
        return [len(runs) << 24 | reserved << 8 | instant >> 32, instant % 2**32, *runs]

    def _runs(self, room: int) -> list[int]:
        rng, kind = self._rng, self._rng.random()
        runs: list[int] = []
        for _ in range(rng.choice([1, 1, 1, 2, 3, 8])):
            length = rng.choice([1, 1, 2, 5])
            runs += [self._run(length), *(rng.getrandbits(32) for _ in range(length))]
        if kind < 0.04:
            # One that just fits, or just does not, where the queue is not read meanwhile; the longest one.
            length = min(254, max(1, rng.choice([20, room - FRAME - 1, room - FRAME, 254])))
            runs = [self._run(length), *(rng.getrandbits(32) for _ in range(length))]
        elif kind < 0.06:
            # A run that is empty, or goes beyond the batch by one word or many.
            runs.append(rng.choice([0, 1, 2**16 - 1]) << 16)
        elif kind < 0.08:
            runs[0] += rng.choice([1, 2**8, 2**15]) << 16
        elif kind < 0.09:
            runs = []
        elif kind < 0.1:
            runs = [rng.getrandbits(32) for _ in range(rng.randint(1, 9))]
        return runs

    def _run(self, length: int) -> int:
        return length << 16 | self._rng.choice([0, 1, 2, 2**16 - 1, self._rng.getrandbits(16)])

    def _when(self, now: int, count: int) -> int:
        rng = self._rng
        if rng.random() < 0.05:
            return (now + rng.choice([rng.randint(-2, 2), -rng.getrandbits(rng.randrange(1, 39))])) % TIME
        if rng.random() < 0.1 / (DEPTH + 100):
            # What is further ahead than half the time is past; the last one that is not ends by a cancel alone.
            return (now + TIME // 2 + 2 * count + 8 + rng.randint(-3, 3)) % TIME
        # It is whole in count + 1 cycles without a pause, and takes count + 7 more; behind another one count + 6.
        left = max(2 * count + 8, time_to(self._instant, now) + count + 6)
        chosen = now + left + rng.choice([rng.randint(-2, 2), rng.randint(0, 20 + self._lead)])
        self._instant = chosen % TIME
        return self._instant


class Driver:
    """Takes inputs to the entity."""

    def __init__(self, dut: SimHandleBase) -> None:
        """Take the entity."""
        self._dut = dut
        self._values: dict[str, int] = {}

    def drive(self, inputs: Inputs, now: int, *, reset: bool) -> None:
        """Set the inputs of the next cycle."""
        values = {
            "now": now,
            "rst": int(reset),
            "armed": int(inputs.armed),
            "finishing": int(inputs.finishing),
            "entry_written": int(inputs.word is not None),
            "entry": self._values.get("entry", 0) if inputs.word is None else inputs.word,
            "cancel": int(inputs.cancel),
            "cancel_written": int(inputs.cancel),
        }
        for name, value in values.items():
            if self._values.get(name) != value:
                getattr(self._dut, name).value = value
        self._values = values


@cocotb.test
async def it_is_as_the_model_in_every_cycle_and_keeps_its_promise(dut: SimHandleBase) -> None:
    cycles, rng = int(os.environ["CYCLES"]), random.Random(os.environ["CYCLES"])
    driver, stimulus = Driver(dut), Stimulus(rng)
    driver.drive(Inputs(), 0, reset=True)
    await start(dut.clk, dut.rst)
    dut.rst.value = 1
    handles = {name: getattr(dut, name) for name in (*OUTPUTS, "stage_index", "stage_data")}
    happened: collections.Counter[str] = collections.Counter()
    now, reset = 0, True
    model, promise = Model(), Promise()
    for cycle in range(cycles):
        # A reset begins the time again; here also where it would take days.
        starts = (0, TIME - 300, 2**64 - 300, rng.getrandbits(64))
        now = rng.choice(starts) if reset else (now + 1) % 2**64
        reset = cycle < 3 or rng.random() < (0.5 if reset else 0.02 if model.acts else 0.1 / (DEPTH + 100))
        inputs = stimulus.next(now, model)
        driver.drive(inputs, now, reset=reset)
        await RisingEdge(dut.clk)
        if cycle:
            seen = {name: int(handles[name].value) for name in OUTPUTS}
            expected = model.outputs(inputs, reset=reset)
            seen |= {name: int(handles[name].value) for name in expected.keys() - seen.keys()}
            wrong = {name: (value, expected[name]) for name, value in seen.items() if value != expected[name]}
            assert not wrong, f"cycle {cycle}: seen and expected are {wrong}"
            if reset:
                assert not seen["commit"]
            else:
                promise.edge(inputs, now, seen)
        assert int(dut.clock.value) == now
        model.edge(inputs, now)
        if reset:
            happened += model.happened + promise.happened
            model, promise = Model(), Promise()
            stimulus.reset()
    happened += model.happened + promise.happened
    kinds = ["acts", "late", "refused", "malformed", "cancelled half sent"]
    assert all(happened[kind] > cycles / 20_000 for kind in kinds), happened
    assert happened["acts behind the end"] > 0, happened
    assert happened["fits to the word"] > 0, happened
    assert happened["does not fit by a word"] > 0, happened

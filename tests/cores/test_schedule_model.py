"""The quick model of a schedule equals the model of its bench in every cycle; the bench compares that to the entity."""

from __future__ import annotations

import importlib
import json
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any
from unittest import mock

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from support.searching import examples
from unity_link.cores.batches import batch_of
from unity_link.cores.schedule import ScheduleModel
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from collections.abc import Mapping

DEPTH = 16
pytest.importorskip("cocotb")
with mock.patch.dict("os.environ", GENERICS=json.dumps({"depth": DEPTH})):
    bench: Any = importlib.import_module("gateware.cores.schedule.bench_schedule")
COMPONENT = compile_text(f"public robot() {{ plan: SCHEDULE(DEPTH={DEPTH}) @(0x10); }}").interface().cores[0]
FATES = ("fates", "late", "refused", "slack")

runs = st.lists(st.tuples(st.integers(0, 9), st.lists(st.integers(0, 2**32 - 1), min_size=1, max_size=6)), max_size=2)
good = runs.map(lambda some: [word for first, words in some for word in (len(words) << 16 | first, *words)])
full = st.integers(8, DEPTH - 2).map(lambda count: [count - 1 << 16, *range(count - 1)])
"""Runs that just fit into the queue, or just do not."""
malformed = st.lists(st.integers(0, 2**18) | st.integers(0, 2**32 - 1), max_size=12)
"""Runs of a batch, which may end at any word."""
margin = st.integers(-2, 2) | st.integers(0, 60) | st.sampled_from([-(2**39), 2**39, -1000])
"""Cycles from the earliest possible instant of a batch in an empty queue to its own instant."""
events = st.lists(
    st.tuples(
        st.one_of(
            st.tuples(st.just("batch"), margin, good | full | malformed, st.sampled_from([0, 0, 0, 0, 1, 2**15])),
            st.tuples(st.sampled_from(["cancel", "disarm", "arm", "finish", "half"])),
        ),
        st.integers(0, 3) | st.integers(0, 150),
    ),
    max_size=30,
)


class Around:
    """The simulation around a model."""

    def __init__(self, now: int) -> None:
        self.now = now
        self.is_armed, self.is_finishing = True, False
        self.acted: list[tuple[int, dict[int, int]]] = []
        self.model: ScheduleModel | None = None

    def commit(self, words: Mapping[int, int]) -> None:
        self.acted.append((self.now, dict(words)))


def inputs_of(happened: list[Any], now: int) -> list[tuple[int | None, bool, bool, bool]]:
    """Return for each cycle a word or None, and if it cancels, if the lease is armed, and if it is finishing."""
    cycles: list[tuple[int | None, bool, bool, bool]] = []
    armed, finishing = True, False
    for (kind, *what), pause in happened:
        if kind == "batch":
            instant = (now + len(cycles) + 2 * len(what[1]) + 6 + what[0]) % 2**40
            words = [len(what[1]) << 24 | what[2] << 8 | instant >> 32, instant & 0xFFFF_FFFF, *what[1]]
            cycles += [(word, False, armed, finishing) for word in words]
        elif kind == "half":
            cycles.append((2 << 24, False, armed, finishing))
        elif kind == "cancel":
            cycles.append((None, True, armed, finishing))
        else:
            armed = kind == "arm" or (kind == "finish" and armed)
            finishing = armed and (finishing or kind == "finish")
        cycles += [(None, False, armed, finishing)] * pause
    rest: list[tuple[int | None, bool, bool, bool]] = [(None, False, armed, finishing)] * 150
    return [*cycles, *rest, (None, True, True, False), *[(None, False, True, False)] * 30]


def behind_one_that_waits(count: int) -> list[Any]:
    """Return a waiting batch of three words, one of them unread, followed by a batch of `count` words."""
    return [(("batch", 60, [2 << 16, 1, 2], 0), 20), (("batch", 60, [count - 1 << 16, *range(count - 1)], 0), 0)]


@example(happened=behind_one_that_waits(DEPTH - 3), now=1)
@example(happened=behind_one_that_waits(DEPTH - 2), now=1)
@settings(max_examples=examples(100), deadline=None)
@given(happened=events, now=st.sampled_from([1, 2**40 - 300, 2**63]))
def test_the_quick_model_equals_the_model_of_the_bench_in_every_cycle(happened: list[Any], now: int) -> None:
    around, part = Around(now), SimpleNamespace(**{signal.name: 0 for signal in COMPONENT.signals})
    quick, exact = ScheduleModel(COMPONENT, part, around), bench.Model()
    expected: list[tuple[int, dict[int, int]]] = []
    shadows: dict[int, int] = {}
    for word, cancels, armed, finishing in inputs_of(happened, now):
        given_inputs = bench.Inputs(word, cancels, armed, finishing)
        seen = exact.outputs(given_inputs, reset=False)
        around.now = now
        quick.step(0)
        assert quick.is_empty == seen["empty"]
        if around.is_armed and not armed:
            around.is_armed = False
            quick.disarmed()
        around.is_armed, around.is_finishing = armed, finishing
        assert {name: vars(part)[name] % 2**64 for name in FATES[:3]} == {name: seen[name] for name in FATES[:3]}
        if word is not None:
            part.entry = word
            quick.written("entry")
        if cancels:
            quick.written("cancel")
        if seen["commit"]:
            expected.append((now + 1, shadows))
        if seen["commit"] or seen["stage_clear"] or not armed:
            shadows = {}
        elif seen["stage_write"]:
            shadows = {**shadows, seen["stage_index"]: seen["stage_data"]}
        exact.edge(given_inputs, now)
        now += 1
    assert around.acted == expected
    assert part.room == DEPTH


@given(
    instant=st.integers(0, 2**63),
    words=st.dictionaries(st.integers(0, 40), st.integers(0, 2**32 - 1), min_size=1, max_size=40),
)
def test_a_batch_is_decoded_as_it_was_encoded(instant: int, words: dict[int, int]) -> None:
    header, low, *rest = batch_of(instant, words)
    assert (header & 0xFF) << 32 | low == instant % 2**40
    assert header >> 24 == len(rest)
    assert bench.values_of(rest) == words

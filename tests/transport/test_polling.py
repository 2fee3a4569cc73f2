"""What waits for file descriptors spins where answers are quick, and sleeps everywhere else."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import pytest
from hypothesis import given
from hypothesis import strategies as st

from unity_link.transport.polling import SPIN, Poller

if TYPE_CHECKING:
    from unity_link.transport.polling import SelectPoll

READY = [(3, 1)]
LOOK = SPIN / 10
"""What a look takes, which does not sleep."""
QUICK, SLOW = SPIN * 0.7, SPIN * 20


class ModelledPoll:
    """``select.poll`` on a clock of its own, with one descriptor that is ready at a time."""

    def __init__(self) -> None:
        self.now = 0.0
        self.ready_at = math.inf
        self.looks = 0
        self.sleeps = 0

    def register(self, descriptor: int, events: int) -> None: ...

    def unregister(self, descriptor: int) -> None: ...

    def poll(self, patience_ms: float | None) -> list[tuple[int, int]]:
        if patience_ms == 0:
            self.looks += 1
            self.now += LOOK
        else:
            self.sleeps += 1
            end = math.inf if patience_ms is None else self.now + patience_ms / 1000
            self.now = max(self.now, min(end, self.ready_at))
        return READY if self.ready_at <= self.now else []


def modelled(processors: int = 2) -> tuple[Poller, ModelledPoll]:
    model = ModelledPoll()
    poll: SelectPoll = model  # type: ignore[assignment]
    return Poller(poll, lambda: model.now, processors), model


def answer(poller: Poller, model: ModelledPoll, after: float, *, may_spin: bool = True) -> None:
    """Wait for what comes after some seconds, and expect it."""
    model.looks = model.sleeps = 0
    model.ready_at = model.now + after
    assert poller.wait(1.0, may_spin=may_spin) == READY


def test_a_wait_after_a_short_one_does_not_sleep() -> None:
    poller, model = modelled()
    answer(poller, model, QUICK)
    assert model.sleeps == 1
    answer(poller, model, QUICK)
    assert (model.looks, model.sleeps) == (7, 0)


def test_a_slow_answer_ends_the_spinning_at_its_limit_and_the_next_wait_sleeps_at_once() -> None:
    poller, model = modelled()
    answer(poller, model, QUICK)
    answer(poller, model, SLOW)
    assert model.looks <= SPIN / LOOK + 1
    assert model.sleeps == 1
    answer(poller, model, SLOW)
    assert (model.looks, model.sleeps) == (0, 1)


@pytest.mark.parametrize(("processors", "may_spin"), [(1, True), (2, False)], ids=["one-processor", "not-in-a-call"])
def test_nothing_spins_where_it_would_keep_others_from_running(processors: int, may_spin: bool) -> None:
    poller, model = modelled(processors)
    for _ in range(3):
        answer(poller, model, QUICK, may_spin=may_spin)
        assert (model.looks, model.sleeps) == (0, 1)


def test_a_wait_that_found_nothing_is_not_a_short_one() -> None:
    poller, model = modelled()
    assert poller.wait(SPIN / 2, may_spin=True) == []
    answer(poller, model, QUICK)
    assert model.looks == 0


@given(
    st.lists(
        st.tuples(
            st.sampled_from([0, LOOK, QUICK, SPIN, SLOW, math.inf]),
            st.sampled_from([LOOK / 2, SPIN / 2, SPIN, SPIN * 3, 1.0]),
            st.booleans(),
        ),
        max_size=8,
    )
)
def test_a_wait_finds_what_comes_in_time_and_ends_in_time_with_spinning_and_without(
    waits: list[tuple[float, float, bool]],
) -> None:
    poller, model = modelled()
    for after, patience, may_spin in waits:
        begin = model.now
        model.ready_at = begin + after
        found = poller.wait(patience, may_spin=may_spin)
        # A look may end after what it looked for, and what is left of the patience may be none.
        assert found == READY or after > patience
        assert model.ready_at <= model.now if found else model.now >= begin + patience
        assert model.now <= begin + min(after, patience) + 2 * LOOK

"""Pollers of file descriptors spin where answers are quick, and sleep everywhere else."""

from __future__ import annotations

import math
import socket
from typing import TYPE_CHECKING

import pytest
from hypothesis import given
from hypothesis import strategies as st

from unity_link.transport.polling import READABLE, SPIN, WRITABLE, Poller, PortableSelector, default_selector

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.transport.polling import Selector

DESCRIPTOR = 3
READY = [(DESCRIPTOR, READABLE)]
LOOK = SPIN / 10
"""Duration of a look, which does not sleep."""
QUICK, SLOW = SPIN * 0.7, SPIN * 20
ROUNDING = 1e-12
"""Seconds by which sums of times may differ that are the same."""
FEWEST_SLOW = 8
"""Slow answers in a row that end the spinning."""


class ModelledSelector:
    """A selector on a clock of its own, with one descriptor that is ready at a time."""

    def __init__(self) -> None:
        self.now = 0.0
        self.ready_at = math.inf
        self.looks = 0
        self.sleeps = 0

    def register(self, descriptor: int, events: int) -> None:
        raise NotImplementedError

    def unregister(self, descriptor: int) -> None:
        raise NotImplementedError

    def close(self) -> None:
        """Do nothing."""

    def select(self, timeout: float | None) -> list[tuple[int, int]]:
        if timeout == 0:
            self.looks += 1
            self.now += LOOK
        else:
            self.sleeps += 1
            end = math.inf if timeout is None else self.now + timeout
            self.now = max(self.now, min(end, self.ready_at))
        return READY if self.ready_at <= self.now else []


def modelled(processors: int = 2) -> tuple[Poller, ModelledSelector]:
    model = ModelledSelector()
    return Poller(model, lambda: model.now, processors), model


def answer(poller: Poller, model: ModelledSelector, after: float, *, may_spin: bool = True) -> None:
    """Wait for what comes after some seconds, and expect it."""
    model.looks = model.sleeps = 0
    model.ready_at = model.now + after
    assert poller.wait(1.0, may_spin=may_spin) == READY


def test_a_quick_answer_is_waited_for_without_sleeping_from_the_first_on() -> None:
    poller, model = modelled()
    for _ in range(3):
        answer(poller, model, QUICK)
        assert (model.looks, model.sleeps) == (7, 0)


def test_a_slow_answer_ends_the_spinning_at_its_limit() -> None:
    poller, model = modelled()
    answer(poller, model, SLOW)
    assert model.looks <= SPIN / LOOK + 1
    assert model.sleeps == 1


def test_where_the_first_answer_is_slow_no_other_is_waited_for_by_spinning() -> None:
    poller, model = modelled()
    answer(poller, model, SLOW)
    for _ in range(3):
        answer(poller, model, SLOW)
        assert (model.looks, model.sleeps) == (0, 1)


def test_some_slow_answers_in_a_row_end_the_spinning_and_a_quick_one_begins_it_again() -> None:
    poller, model = modelled()
    answer(poller, model, QUICK)
    for _ in range(FEWEST_SLOW):
        answer(poller, model, SLOW)
        assert model.looks
    answer(poller, model, SLOW)
    assert (model.looks, model.sleeps) == (0, 1)
    answer(poller, model, QUICK)
    assert (model.looks, model.sleeps) == (0, 1)
    answer(poller, model, QUICK)
    assert (model.looks > 0, model.sleeps) == (True, 0)


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


SELECTORS = list(dict.fromkeys([default_selector, PortableSelector]))


@pytest.mark.parametrize("selector", SELECTORS)
def test_what_is_registered_again_is_waited_for_as_was_said_last(selector: Callable[[], Selector]) -> None:
    ours, theirs = socket.socketpair()
    with ours, theirs:
        poller = Poller(selector())
        poller.register(ours.fileno(), READABLE | WRITABLE)
        assert poller.wait(0.0, may_spin=False) == [(ours.fileno(), WRITABLE)]
        poller.register(ours.fileno(), READABLE)
        assert poller.wait(0.0, may_spin=False) == []
        theirs.send(b"!")
        assert poller.wait(1.0, may_spin=False) == [(ours.fileno(), READABLE)]
        theirs.close()
        assert poller.wait(1.0, may_spin=False)[0][1] & READABLE
        assert poller.wait(1e12, may_spin=False)
        poller.unregister(ours.fileno())
        assert poller.wait(0.0, may_spin=False) == []
        poller.close()


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
        assert model.ready_at <= model.now if found else model.now >= begin + patience - ROUNDING
        assert model.now <= begin + min(after, patience) + 2 * LOOK

"""Pollers of file descriptors spin while they wait for quick answers, and sleep otherwise."""

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
"""Seconds of one poll without sleeping."""
QUICK, SLOW = SPIN * 0.7, SPIN * 20
ROUNDING = 1e-12
"""Seconds by which equal sums of times may differ."""
FEWEST_SLOW = 8
"""Number of consecutive slow answers that end the spinning."""


class ModelledSelector:
    """A selector on a clock of its own, with a single descriptor that becomes ready at `ready_at`."""

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
    """Wait for an answer that arrives after some seconds, and assert that it was found."""
    model.looks = model.sleeps = 0
    model.ready_at = model.now + after
    assert poller.wait(1.0, may_spin=may_spin) == READY


def test_the_poller_spins_for_a_quick_answer_from_the_first_on() -> None:
    poller, model = modelled()
    for _ in range(3):
        answer(poller, model, QUICK)
        assert (model.looks, model.sleeps) == (7, 0)


def test_the_poller_stops_spinning_for_a_slow_answer_at_the_limit() -> None:
    poller, model = modelled()
    answer(poller, model, SLOW)
    assert model.looks <= SPIN / LOOK + 1
    assert model.sleeps == 1


def test_the_poller_does_not_spin_after_a_slow_first_answer() -> None:
    poller, model = modelled()
    answer(poller, model, SLOW)
    for _ in range(3):
        answer(poller, model, SLOW)
        assert (model.looks, model.sleeps) == (0, 1)


def test_slow_answers_end_the_spinning_and_a_quick_one_resumes_it() -> None:
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
def test_the_poller_does_not_spin_if_it_would_block_others(processors: int, may_spin: bool) -> None:
    poller, model = modelled(processors)
    for _ in range(3):
        answer(poller, model, QUICK, may_spin=may_spin)
        assert (model.looks, model.sleeps) == (0, 1)


def test_a_wait_without_a_result_does_not_count_as_quick() -> None:
    poller, model = modelled()
    assert poller.wait(SPIN / 2, may_spin=True) == []
    answer(poller, model, QUICK)
    assert model.looks == 0


SELECTORS = list(dict.fromkeys([default_selector, PortableSelector]))


@pytest.mark.parametrize("selector", SELECTORS)
def test_a_descriptor_registered_again_has_its_last_events(selector: Callable[[], Selector]) -> None:
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
def test_a_wait_finds_an_answer_in_time_and_ends_at_its_time_out(
    waits: list[tuple[float, float, bool]],
) -> None:
    poller, model = modelled()
    for after, patience, may_spin in waits:
        begin = model.now
        model.ready_at = begin + after
        found = poller.wait(patience, may_spin=may_spin)
        # A poll may end after the answer arrived, even if no patience is left.
        assert found == READY or after > patience
        assert model.ready_at <= model.now if found else model.now >= begin + patience - ROUNDING
        assert model.now <= begin + min(after, patience) + 2 * LOOK

"""Faults are reported once for each kind; texts that differ only in numbers are one kind."""

from __future__ import annotations

import pytest

from unity_link.bridges.log_once import MOST_KINDS, Faults


@pytest.mark.parametrize(
    ("one", "other", "count"),
    [
        ("j1.pos_sp: 500.0 is outside", "j1.pos_sp: -1e+300 is outside", 1),
        ("j1.pos_sp: nan is no value", "j1.pos_sp: -inf is no value", 1),
        ("j1.pos_sp: 500.0 is outside", "j2.pos_sp: 500.0 is outside", 2),
        ("legs[1].pos: 5 is outside", "legs[2].pos: 5 is outside", 2),
        ("posted write at 0x8C: refused", "posted write at 0x9D: refused", 2),
        ("j1.pos_sp: 500 is outside", "j1.pos_sp: nan is no value", 2),
    ],
)
def test_faults_that_differ_only_in_numbers_are_one_kind_for_each_signal(one: str, other: str, count: int) -> None:
    told: list[str] = []
    faults = Faults(told.append)

    for text in (one, other, one, other):
        faults.tell(text)

    assert told == [f"{text} (told once)" for text in (one, other)][:count]


def test_number_of_reported_kinds_of_faults_is_bounded() -> None:
    told: list[str] = []
    faults = Faults(told.append)

    for number in range(10 * MOST_KINDS):
        faults.tell(f"'x{number}' is no value")

    assert len(told) == MOST_KINDS

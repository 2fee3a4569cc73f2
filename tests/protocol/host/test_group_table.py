"""The group of the gateway that a subscription gets, and the requests for a group that are refused."""

from __future__ import annotations

import pytest

from unity_link.errors import UnsupportedError
from unity_link.protocol.host.group_table import GroupTable


def table(count: int = 3) -> GroupTable:
    return GroupTable(count, lambda step, events: None)


def test_the_group_that_was_released_longest_ago_is_assigned_next() -> None:
    groups = table()
    first, second = (groups.hold(b"", 5, None) for _ in range(2))
    assert groups.release(second)
    assert groups.release(first)
    assert [groups.hold(b"", 5, None).number for _ in range(3)] == [2, 1, 0]


def test_a_group_is_released_once() -> None:
    groups = table()
    held = groups.hold(b"", 5, None)
    assert groups.release(held)
    assert not groups.release(held)


def test_a_requested_group_is_assigned_or_refused_with_a_reason() -> None:
    groups = table()
    for number in (0, 2):
        assert groups.hold(b"", 5, None, number=number).number == number
    with pytest.raises(UnsupportedError, match="group 2 of the gateway, whose trigger was asked for, is in use"):
        groups.hold(b"", 5, None, number=2)
    for wrong in (-1, 3):
        with pytest.raises(
            UnsupportedError, match=f"group {wrong} was asked for, and the gateway has those from 0 to 2"
        ):
            groups.hold(b"", 5, None, number=wrong)


def test_the_error_if_all_groups_are_in_use_says_what_to_do() -> None:
    groups = table(1)
    groups.hold(b"", 5, None)
    with pytest.raises(UnsupportedError, match="all 1 groups of the gateway are in use: end a subscription first"):
        groups.hold(b"", 5, None)

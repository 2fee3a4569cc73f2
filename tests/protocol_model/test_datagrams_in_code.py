"""The rules of datagrams hold for the classes of both sides, in every state of a small model."""

import pytest

from protocol_model import datagrams_in_code
from protocol_model.datagrams import Rules
from unity_link.protocol.wire.datagrams import Counts

campaign = pytest.mark.campaign


@pytest.mark.parametrize(
    "rules",
    [
        Rules(sessions=1, beginnings=1, datagrams=6, resets=0),
        Rules(beginnings=2, datagrams=2, requests=1),
        pytest.param(Rules(sessions=1, beginnings=1, datagrams=7, resets=0), marks=campaign),
        pytest.param(Rules(beginnings=2, datagrams=3, requests=2), marks=campaign),
    ],
)
def test_both_sides_drop_late_and_duplicated_datagrams(rules: Rules) -> None:
    found = datagrams_in_code.explored(rules)
    assert found.fault is None, str(found)
    assert found.ends


def test_without_the_counts_a_request_is_executed_twice(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Counts, "takes", lambda *_: True)
    with datagrams_in_code.nothing_remembered():
        found = datagrams_in_code.explored(Rules(sessions=1, beginnings=1, datagrams=6, resets=0))
    assert found.fault == "request 0 is executed twice", str(found)

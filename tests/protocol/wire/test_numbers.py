"""Words and features, formatted for display."""

from __future__ import annotations

import pytest

from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.numbers import as_decimal


@pytest.mark.parametrize(("word", "text"), [(0, "0"), (0x7F, "127"), (0x80, "128 or -128"), (0xFF, "255 or -1")])
def test_a_word_that_may_be_a_negative_number_is_written_as_both(word: int, text: str) -> None:
    assert as_decimal(word, 8) == text


def test_features_are_written_by_their_names() -> None:
    assert (Feature.FLOW_CONTROL | Feature.GROUPS).words == "groups, flow control"

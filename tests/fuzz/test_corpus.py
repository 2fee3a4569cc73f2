"""Every known input is taken by its target, whole and cut anywhere: what a search begins with, and what it found."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzz.targets import TARGETS

CORPUS = Path(__file__).with_name("corpus")
INPUTS = sorted(path for path in CORPUS.glob("*/*"))
PIECES = 25
"""Beginnings of an input that are tried as well."""


def test_every_target_has_inputs_to_begin_with() -> None:
    assert {path.parent.name for path in INPUTS} == TARGETS.keys()


@pytest.mark.parametrize("path", INPUTS, ids=lambda path: f"{path.parent.name}-{path.name}")
def test_a_known_input_is_taken_whole_and_cut_anywhere(path: Path) -> None:
    data = path.read_bytes()
    for piece in range(PIECES + 1):
        TARGETS[path.parent.name](data[: len(data) * piece // PIECES])


@pytest.mark.parametrize("name", TARGETS)
@given(data=st.binary(max_size=200))
def test_any_bytes_are_taken(name: str, data: bytes) -> None:
    TARGETS[name](data)

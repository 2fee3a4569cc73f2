"""Sizes of searches: the number of examples of a property, in proportion to the profile, and of seeds."""

from __future__ import annotations

import pytest
from hypothesis import settings

QUICK = 100
"""Examples of a property in the profile `quick`."""


def examples(usual: int) -> int:
    """Return the number of examples of a test in this profile; `usual` is the number in `make test-all`."""
    return max(usual, usual * settings().max_examples // QUICK)


def seeds(usual: int, most: int) -> list[object]:
    """Return the seeds below `most`, for a parametrised test; seeds from `usual` on get the mark `campaign`."""
    return [pytest.param(seed, marks=[] if seed < usual else [pytest.mark.campaign]) for seed in range(most)]

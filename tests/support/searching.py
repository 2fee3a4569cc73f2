"""Amounts of what is searched: examples of a property, of which each test has its share of the profile, and seeds."""

from __future__ import annotations

import pytest
from hypothesis import settings

QUICK = 100
"""Examples of a property in the profile `quick`."""


def examples(usual: int) -> int:
    """Return how many examples a test tries that tries `usual` ones in `make test-all`; at least so many."""
    return max(usual, usual * settings().max_examples // QUICK)


def seeds(usual: int, most: int) -> list[object]:
    """Return the seeds below `most`, for a parametrised test; those from `usual` on are for the campaign."""
    return [pytest.param(seed, marks=[] if seed < usual else [pytest.mark.campaign]) for seed in range(most)]

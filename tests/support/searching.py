"""Numbers of examples that hypothesis tries of a property: each test has its share of what the profile says."""

from __future__ import annotations

from hypothesis import settings

QUICK = 100
"""Examples of a property in the profile `quick`."""


def examples(usual: int) -> int:
    """Return how many examples a test tries that tries `usual` ones in `make test`; at least so many."""
    return max(usual, usual * settings().max_examples // QUICK)

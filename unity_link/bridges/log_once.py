"""Log messages of faults: each kind of them once, however often it comes."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

MOST_KINDS = 1000
"""Kinds that are reported; of a source of ever new ones no more is reported."""
_NUMBER = re.compile(r"(?<![\w\[.])-?(?:\d[\d.]*(?:e[-+]?\d+)?|nan|inf)\b")
"""A number that is no part of a name: ``500`` in ``j1.pos_sp: 500.0 is outside``, and nothing else."""


class Faults:
    """Tells of faults.

    Args:
        report: is told in a sentence.
    """

    def __init__(self, report: Callable[[str], None]) -> None:
        self._report = report
        self._told: set[str] = set()

    def tell(self, text: str) -> None:
        """Log a fault, unless one was logged that differs in nothing but numbers."""
        kind = _NUMBER.sub("#", text)
        if kind not in self._told and len(self._told) < MOST_KINDS:
            self._told.add(kind)
            self._report(f"{text} (told once)")

"""Reports of faults that may repeat: one for each kind of fault."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

MOST_KINDS = 1000
"""Most kinds that are reported, in case a source produces ever new ones."""
_NUMBER = re.compile(r"(?<![\w\[.])-?(?:\d[\d.]*(?:e[-+]?\d+)?|nan|inf)\b")
"""A number that is no part of a name: ``500.0`` in ``j1.pos_sp: 500.0 is outside``, but not ``1``."""


class Faults:
    """Reports each kind of fault once.

    Args:
        report: called with a sentence.
    """

    def __init__(self, report: Callable[[str], None]) -> None:
        self._report = report
        self._reported: set[str] = set()

    def tell(self, text: str) -> None:
        """Report a fault, unless one was reported that differs only in numbers."""
        kind = _NUMBER.sub("#", text)
        if kind not in self._reported and len(self._reported) < MOST_KINDS:
            self._reported.add(kind)
            self._report(f"{text} (told once)")

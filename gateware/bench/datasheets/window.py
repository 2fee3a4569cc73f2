"""Marks the part of a simulation that a picture shows."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Self

from cocotb.utils import get_sim_time

if TYPE_CHECKING:
    from types import TracebackType


class Picture:
    """The time within a block, extended by `before` and `behind` ns, is shown in a picture."""

    def __init__(self, name: str, before: float = 0, behind: float = 0) -> None:
        self._name, self._before, self._behind = name, before, behind
        self._begin = self._zero = 0

    def __enter__(self) -> Self:
        self._begin = self._zero = _now()
        return self

    def zero(self) -> None:
        """Number the cycles from the present edge."""
        self._zero = _now()

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        if error is None:
            path = Path(os.environ["WINDOWS"])
            windows = json.loads(path.read_text()) if path.exists() else {}
            begin, end = self._begin - round(1000 * self._before), _now() + round(1000 * self._behind)
            windows[self._name] = begin, end, self._zero
            path.write_text(json.dumps(windows))


def _now() -> int:
    return round(get_sim_time("ps"))

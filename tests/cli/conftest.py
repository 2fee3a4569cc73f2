"""A terminal for tests of commands that need one."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from support.terminal_window import Window, window

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path


@pytest.fixture
def terminal(tmp_path: Path) -> Iterator[Window]:
    with window(tmp_path) as terminal:
        yield terminal

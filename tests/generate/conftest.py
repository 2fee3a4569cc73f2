"""What the tests of generated code are given."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from generate.octave import Octave, why_not

if TYPE_CHECKING:
    from pathlib import Path


@pytest.fixture
def octave(tmp_path: Path) -> Octave:
    """Return an Octave in an empty folder, where there is one."""
    if why_not():
        pytest.skip(why_not())
    return Octave(tmp_path)

"""Fixtures of the tests of generated code."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from generate.octave import CAREFULLY, MEX_FILE, Octave, why_not
from support.spec_examples import FIGURE_1
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from pathlib import Path


@pytest.fixture(scope="session")
def mex_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the MEX file of the package for Octave, which is the same for every spec."""
    if why_not():
        pytest.skip(why_not())
    octave = Octave(tmp_path_factory.mktemp("mex"))
    octave.generate(compile_text(FIGURE_1))
    octave.run("unity_link.build();", CAREFULLY)
    return octave.folder / MEX_FILE


@pytest.fixture
def octave(tmp_path: Path, mex_file: Path) -> Octave:
    """Return an Octave in an empty folder, for packages that are built."""
    return Octave(tmp_path, mex_file)


@pytest.fixture
def bare_octave(tmp_path: Path) -> Octave:
    """Return an Octave in an empty folder, for packages that are not built."""
    if why_not():
        pytest.skip(why_not())
    return Octave(tmp_path)

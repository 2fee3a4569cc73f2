"""Fixtures of the tests of generated code."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from generate.octave import CAREFULLY, MEX_FILE, Octave, why_not
from generate.programs import HERE, SANITIZED, C, Driven, compiled, generated, linked
from support.spec_examples import FIGURE_1
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path


@pytest.fixture(scope="session")
def runtime(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Compile the files that are the same for every spec, with sanitizers."""
    directory = tmp_path_factory.mktemp("runtime")
    generated("c", compile_text(FIGURE_1), directory)
    return compiled(C, [directory / "unity_link.c", directory / "unity_link_posix.c"], directory, *SANITIZED)


@pytest.fixture(scope="session")
def driver(runtime: list[Path]) -> Path:
    """Return the client, built as a program that reads commands."""
    directory = runtime[0].parent
    objects = compiled(C, [HERE / "driver.c"], directory, *SANITIZED)
    return linked(C, [*runtime, *objects], directory / "driver", *SANITIZED)


@pytest.fixture
def client(driver: Path) -> Iterator[Driven]:
    with Driven(driver) as client:
        yield client


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
    """Return an Octave in an empty folder, with a built MEX file for generated packages."""
    return Octave(tmp_path, mex_file)


@pytest.fixture
def bare_octave(tmp_path: Path) -> Octave:
    """Return an Octave in an empty folder, in which generated packages are not built yet."""
    if why_not():
        pytest.skip(why_not())
    return Octave(tmp_path)

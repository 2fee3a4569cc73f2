"""Every target accepts its known inputs, whole and cut anywhere: initial inputs, and those that a search found."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzz.clients import PROGRAMS, build_replay, build_search
from fuzz.targets import TARGETS
from support.compilers import needs_c, needs_cxx

CORPUS = Path(__file__).with_name("corpus")
INPUTS = sorted(path for path in CORPUS.glob("*/*") if path.parent.name in TARGETS)
PIECES = 25
"""Number of prefixes of an input that are tried too."""


def test_every_target_has_inputs_to_begin_with() -> None:
    assert {path.name for path in CORPUS.iterdir() if any(path.iterdir())} == TARGETS.keys() | PROGRAMS.keys()


@pytest.mark.slow
@pytest.mark.parametrize("path", INPUTS, ids=lambda path: f"{path.parent.name}-{path.name}")
def test_a_known_input_is_accepted_whole_and_cut_anywhere(path: Path) -> None:
    data = path.read_bytes()
    for piece in range(PIECES + 1):
        TARGETS[path.parent.name](data[: len(data) * piece // PIECES])


@pytest.mark.slow
@pytest.mark.parametrize("name", TARGETS)
@given(data=st.binary(max_size=200))
def test_arbitrary_bytes_are_accepted_or_refused(name: str, data: bytes) -> None:
    TARGETS[name](data)


@pytest.mark.slow
@needs_c
@needs_cxx
@pytest.mark.parametrize("name", PROGRAMS)
def test_a_client_under_sanitizers_accepts_known_inputs_whole_and_cut(name: str, tmp_path: Path) -> None:
    program = build_replay(name, tmp_path)
    done = subprocess.run(
        [program, *sorted(map(str, (CORPUS / name).iterdir()))], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr[-4000:]


def test_the_error_of_a_search_without_clang_says_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(FileNotFoundError, match="clang with libFuzzer is needed"):
        build_search("client_c", tmp_path)

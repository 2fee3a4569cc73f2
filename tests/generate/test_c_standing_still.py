"""A client in C numbers and dates samples right, also samples that waited while its program was suspended."""

from __future__ import annotations

import subprocess
from typing import TYPE_CHECKING

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from generate.programs import HERE, PATIENCE, SANITIZED, C, generated
from support.searching import examples
from support.spec_examples import FIGURE_1
from support.taken_samples import BASE_HZ, STORIES, are_decidable, arrivals_of, of_group
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from pathlib import Path


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("standing")
    generated("c", compile_text(FIGURE_1), folder)
    made = folder / "standing_still"
    options = [*SANITIZED, f"-I{folder}", "-Wno-unused-function"]
    subprocess.run([*C, *options, HERE / "standing_still.c", "-lm", "-o", made], check=True, timeout=PATIENCE)
    return made


@pytest.mark.slow
@given(
    **STORIES,
    divisor=st.integers(100, 3000),
)
@settings(max_examples=examples(30), deadline=None)
def test_samples_keep_their_numbers_and_times_if_the_host_was_suspended(
    program: Path, reads: list[tuple[float, int, str]], clock_hz: int, divisor: int, began: int, seed: int
) -> None:
    arrivals = arrivals_of(reads, clock_hz, [divisor], began, seed)
    truth = of_group(arrivals, 0)
    assume(are_decidable(truth, divisor, clock_hz))
    lines = "".join(f"{arrival.now} {one.body().decode()}\n" for arrival in arrivals for one in arrival.taken)
    command = [str(program), str(clock_hz), str(BASE_HZ / divisor)]
    result = subprocess.run(command, input=lines, capture_output=True, text=True, timeout=PATIENCE, check=False)
    assert (result.returncode, result.stderr) == (0, "")
    said = [line.split() for line in result.stdout.splitlines()]
    assert [int(number) for number, _, _ in said] == [one.number for one in truth]
    assert [float(time) for _, _, time in said] == [one.ticks / clock_hz for one in truth]
    assert sum(int(lost) for _, lost, _ in said) == truth[-1].number + 1 - len(truth)

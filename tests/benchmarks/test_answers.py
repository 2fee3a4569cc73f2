"""Each benchmark of RESULTS.md with a requirement for the next release returns a result, with little work.

Speed is not judged here. Each benchmark checks the words that it has read, and raises an error if one is wrong.
"""

from __future__ import annotations

import asyncio
import re
from typing import TYPE_CHECKING

import pytest

from benchmarks import (
    batch_posts,
    blocking_read,
    c_read,
    gathered_reads,
    many_links,
    measure,
    octave_read,
    posts,
    read_beside_protocol,
    read_beside_spinning,
)
from benchmarks.__main__ import NAMED
from generate.octave import why_not
from support.compilers import needs_c

if TYPE_CHECKING:
    from types import ModuleType

needs_octave = pytest.mark.skipif(bool(why_not()), reason=why_not())
SMALL = [
    (read_beside_protocol, {"READS": 5}),
    (read_beside_spinning, {"READS": 5}),
    (blocking_read, {"READS": 5}),
    (c_read, {"READS": 5}),
    pytest.param(octave_read, {"READS": 5}, marks=[needs_octave, pytest.mark.slow]),
    (gathered_reads, {"AT_ONCE": 4, "ROUNDS": 2}),
    (many_links, {"LINKS": 3, "READS": 12}),
    # The bare loop has 128 requests in flight.
    (posts, {"POSTS": 256}),
    (batch_posts, {"POSTS": 256}),
]


@pytest.mark.slow
@needs_c
@pytest.mark.parametrize(("benchmark", "sizes"), SMALL)
def test_a_benchmark_answers_its_question(
    monkeypatch: pytest.MonkeyPatch, benchmark: ModuleType, sizes: dict[str, int]
) -> None:
    monkeypatch.setattr(measure, "RUNS", 1)
    for name, size in sizes.items():
        monkeypatch.setattr(benchmark, name, size)
    row = asyncio.run(benchmark.measure())
    assert re.match(r"[\d,.]+ (us|reads/s|writes/s)", row.ours)
    assert re.match(r"[\d,.]+ (us|reads/s|writes/s)", row.bare)
    assert float(row.ratio) >= 0
    assert re.fullmatch(r"\d+%, \d+%", row.processor)
    assert NAMED[benchmark.__name__.rpartition(".")[2]] is benchmark

"""The memory of words, small and large."""

from __future__ import annotations

import pytest

from gateware.bench.runner import run_bench


@pytest.mark.parametrize(("width", "depth"), [(32, 256), (8, 2), (64, 16)])
def test_word_memory(width: int, depth: int) -> None:
    run_bench(
        "ul_word_memory", "gateware.bench.word_memory.bench_word_memory", generics={"width": width, "depth": depth}
    )

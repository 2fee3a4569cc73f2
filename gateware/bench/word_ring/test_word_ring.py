"""The ring of words in several widths and depths."""

from __future__ import annotations

import pytest

from gateware.bench.runner import run_bench


@pytest.mark.parametrize(("width", "depth"), [(32, 16), (8, 2), (64, 256)])
def test_word_ring(width: int, depth: int) -> None:
    run_bench("ul_word_ring", "gateware.bench.word_ring.bench_word_ring", generics={"width": width, "depth": depth})

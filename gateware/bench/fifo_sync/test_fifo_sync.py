"""The synchronous FIFO in several widths and depths."""

from __future__ import annotations

import pytest

from gateware.bench.runner import run_bench


@pytest.mark.parametrize(("width", "depth"), [(8, 16), (9, 64), (1, 4), (32, 2)])
def test_fifo_sync(width: int, depth: int) -> None:
    run_bench("ul_fifo_sync", "gateware.bench.fifo_sync.bench_fifo_sync", generics={"width": width, "depth": depth})

"""The Wishbone wrapper, classic and pipelined."""

from __future__ import annotations

import pytest

from gateware.bench.runner import run_bench


@pytest.mark.parametrize("pipelined", [False, True], ids=["classic", "pipelined"])
def test_wishbone_master(*, pipelined: bool) -> None:
    module = "gateware.bench.wishbone_master.bench_wishbone_master"
    run_bench("ul_wishbone_master", module, generics={"pipelined": pipelined})

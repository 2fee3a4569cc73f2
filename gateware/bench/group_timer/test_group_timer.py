"""The timer of periodic groups, for few groups and for the maximum number."""

from __future__ import annotations

import pytest

from gateware.bench.runner import run_bench


@pytest.mark.parametrize("groups", [2, 5, 256])
def test_group_timer(groups: int) -> None:
    run_bench("ul_group_timer", "gateware.bench.group_timer.bench_group_timer", generics={"groups": groups})

"""The arbiter between requests and samples."""

from __future__ import annotations

import pytest

from gateware.bench.runner import BenchError, run_bench


def test_bus_master() -> None:
    run_bench("ul_bus_master", "gateware.bench.bus_master.bench_bus_master", generics={"timeout": 20})


@pytest.mark.parametrize(
    ("case", "words"),
    [
        ("a_request_behind_the_last_access", "a request after the last access of a block"),
        ("a_sample_behind_the_last_access", "a sample after the last access of another"),
        ("a_write_in_a_block_that_is_read", "a request of another kind in a block that is read"),
        ("writes_that_are_not_exclusive", "a transaction of writes that is not exclusive"),
    ],
)
def test_a_client_that_breaks_a_rule_ends_the_simulation(case: str, words: str) -> None:
    with pytest.raises(BenchError, match=f"ul_bus_master: {words}"):
        run_bench("ul_bus_master", "gateware.bench.bus_master.bench_rules", testcase=case, generics={"timeout": 20})

"""The MAC with each of its interfaces, with several clocks."""

from __future__ import annotations

import pytest

from gateware.bench.runner import BenchError, run_bench

_BENCH = "gateware.bench.mac.bench_mac"


@pytest.mark.parametrize(
    ("interface", "period_ns"),
    [
        ("rmii", 20),
        ("mii", 10),
        ("rgmii", 17),
        pytest.param("rmii", 40, marks=pytest.mark.campaign),
        pytest.param("rmii", 8, marks=pytest.mark.campaign),
        pytest.param("mii", 40, marks=pytest.mark.campaign),
        pytest.param("rgmii", 39, marks=pytest.mark.campaign),
    ],
)
def test_mac(interface: str, period_ns: float) -> None:
    run_bench(
        "ul_mac",
        _BENCH,
        generics={"physical": interface},
        extra_env={"INTERFACE": interface, "PERIOD_NS": str(period_ns)},
    )


def test_missing_interface_is_refused() -> None:
    with pytest.raises(BenchError, match='physical is "sgmii", expected "rmii", "mii" or "rgmii"'):
        run_bench("ul_mac", _BENCH, generics={"physical": "sgmii"}, extra_env={"INTERFACE": "mii", "PERIOD_NS": "20"})

"""The UART at ratios of clock to baud rate from 4 to 17, in a campaign to 434: with and without the filter."""

from __future__ import annotations

import pytest

from gateware.bench.runner import BenchError, run_bench

_BENCH = "gateware.bench.uart.bench_uart"


@pytest.mark.parametrize(
    ("clock_hz", "baud"),
    [
        (12_000_000, 3_000_000),  # 4.0
        (50_000_000, 12_000_000),  # 4.17
        pytest.param(50_000_000, 11_000_000, marks=pytest.mark.campaign),  # 4.55
        (48_000_000, 8_000_000),  # 6.0
        pytest.param(60_000_000, 4_000_000, marks=pytest.mark.campaign),  # 15.0
        pytest.param(48_000_000, 3_000_000, marks=pytest.mark.campaign),  # 16.0
        (100_000_000, 6_000_000),  # 16.7
        pytest.param(12_000_000, 115_200, marks=pytest.mark.campaign),  # 104.2
        pytest.param(50_000_000, 115_200, marks=pytest.mark.campaign),  # 434.0
    ],
)
def test_uart(clock_hz: int, baud: int) -> None:
    run_bench("ul_uart", _BENCH, generics={"clock_hz": clock_hz, "baud": baud})


@pytest.mark.parametrize(
    ("clock_hz", "baud"), [(48_000_000, 12_000_000), pytest.param(48_000_000, 2_000_000, marks=pytest.mark.campaign)]
)
def test_uart_with_flow_control(clock_hz: int, baud: int) -> None:
    run_bench("ul_uart", _BENCH, generics={"clock_hz": clock_hz, "baud": baud, "flow_control": True, "rx_slack": 32})


@pytest.mark.parametrize(
    ("clock_hz", "baud", "driver_lead", "driver_tail"),
    [
        (12_000_000, 3_000_000, 1, 0),
        (50_000_000, 11_000_000, 0, 0),
        pytest.param(50_000_000, 115_200, 1, 0, marks=pytest.mark.campaign),
        (48_000_000, 3_000_000, 3, 2),
    ],
)
def test_uart_with_a_transceiver_on_a_shared_pair(clock_hz: int, baud: int, driver_lead: int, driver_tail: int) -> None:
    generics = {"clock_hz": clock_hz, "baud": baud, "driver_lead": driver_lead, "driver_tail": driver_tail}
    run_bench("ul_uart", "gateware.bench.uart.bench_half_duplex", generics={**generics, "half_duplex": True})


def test_half_duplex_with_flow_control_is_refused() -> None:
    with pytest.raises(BenchError, match="half_duplex and flow_control are both true"):
        run_bench("ul_uart", _BENCH, generics={"half_duplex": True, "flow_control": True})


def test_a_baud_rate_above_a_quarter_of_the_clock_is_refused() -> None:
    with pytest.raises(BenchError, match="baud is 4000000, expected at most a quarter of clock_hz"):
        run_bench("ul_uart", _BENCH, generics={"clock_hz": 12_000_000, "baud": 4_000_000})

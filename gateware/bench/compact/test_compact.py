"""The entities of the compact form, compared with the host's functions."""

from __future__ import annotations

import pytest

from gateware.bench.runner import run_bench

WIDTHS = [{"id_digits": 3}, {"id_digits": 2}, {"id_digits": 3, "node": 0xB5}]


@pytest.mark.parametrize("widths", WIDTHS)
@pytest.mark.parametrize("address_digits", [2, 3])
def test_compact_rx(widths: dict[str, object], address_digits: int) -> None:
    run_bench(
        "ul_compact_rx",
        "gateware.bench.compact.bench_compact_rx",
        generics={**widths, "address_digits": address_digits},
    )


@pytest.mark.parametrize("widths", WIDTHS)
def test_compact_tx(widths: dict[str, object]) -> None:
    run_bench("ul_compact_tx", "gateware.bench.compact.bench_compact_tx", generics=widths)

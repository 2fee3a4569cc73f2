"""The datalink receiver, with CRCs of each width, alone and on a shared medium."""

from __future__ import annotations

import pytest

from gateware.bench.runner import run_bench


@pytest.mark.parametrize(("crc_bits", "node"), [(8, -1), (16, -1), (32, -1), (8, 0x1A), (32, 0)])
def test_datalink_rx(crc_bits: int, node: int) -> None:
    generics = {"crc_bits": crc_bits, "longest": 40, "node": node}
    run_bench("ul_datalink_rx", "gateware.bench.datalink_rx.bench_datalink_rx", generics=generics)

"""The datalink transmitter, with CRCs of each width, alone and on a shared medium."""

from __future__ import annotations

import pytest

from gateware.bench.runner import run_bench


@pytest.mark.parametrize(("crc_bits", "node"), [(8, -1), (16, -1), (32, 0xFE)])
def test_datalink_tx(crc_bits: int, node: int) -> None:
    generics = {"crc_bits": crc_bits, "node": node}
    run_bench("ul_datalink_tx", "gateware.bench.datalink_tx.bench_datalink_tx", generics=generics)

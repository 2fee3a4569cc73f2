"""The frame writer with words, addresses and IDs of several widths, multiples of a digit or not."""

from __future__ import annotations

import pytest

from gateware.bench.runner import run_bench


@pytest.mark.parametrize(("data_bits", "address_bits", "id_digits"), [(32, 8, 2), (8, 8, 3), (13, 11, 2), (64, 32, 3)])
def test_frame_writer(data_bits: int, address_bits: int, id_digits: int) -> None:
    run_bench(
        "ul_frame_writer",
        "gateware.bench.frame_writer.bench_frame_writer",
        generics={"data_bits": data_bits, "address_bits": address_bits, "id_digits": id_digits},
    )

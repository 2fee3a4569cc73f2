"""The decoder of requests in the default configuration and half-duplex; the shared vectors cover the others."""

from __future__ import annotations

import pytest

from gateware.bench.runner import run_bench


@pytest.mark.parametrize("half_duplex", [False, True])
def test_request_decoder(*, half_duplex: bool) -> None:
    bench = "gateware.bench.request_decoder.bench_request_decoder"
    run_bench("ul_request_decoder", bench, generics={"half_duplex": half_duplex})

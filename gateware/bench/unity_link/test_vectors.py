"""The shared vectors on the gateware under back pressure; without it, and those of further widths, in a campaign."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from gateware.bench.runner import GATEWARE, run_bench
from unity_link.protocol.wire.configuration import Feature
from unity_link.virtual.generics import FEATURES

pytestmark = pytest.mark.slow
HERE = Path(__file__).resolve().parent
VECTORS = GATEWARE.parent / "tests" / "vectors"


def generics_of(configuration: dict[str, Any], node: int | None) -> dict[str, object]:
    """Return the generics of a gateway with this configuration (the fields of `Q`)."""
    features = Feature(configuration["features"])
    same = ("data_bits", "address_bits", "id_digits", "crc_bits", "crc_polynomial", "block_words", "groups")
    longest_sample = max(configuration["group_words"], 1) + 2
    return {
        **{name: configuration[name] for name in same},
        "group_words": configuration["group_words"],
        "base_frequency_millihertz": configuration["base_frequency_millihertz"],
        "clock_hz": configuration["clock_hz"],
        "rx_fifo_depth": configuration["receive_fifo_bytes"],
        "tx_fifo_depth": configuration["transmit_fifo_bytes"],
        "build_id": configuration["build_id"],
        "sample_depth": 1 << (longest_sample - 1).bit_length(),
        **{generic: feature in features for generic, feature in FEATURES.items()},
        "node": -1 if node is None else node,
    }


# Longest and shortest frames, addressed ones, and gateways without features; the others take too long in GHDL.
QUICK = ("default", "short", "addressed", "bare", "compact", "compact_addressed")
RUNS = [
    pytest.param(path, pause, marks=[] if path.stem in QUICK and pause else [pytest.mark.campaign])
    for path in sorted(VECTORS.glob("*.ndjson"))
    for pause in (0.0, 0.3)
]


@pytest.mark.parametrize(("path", "pause"), RUNS, ids=lambda value: getattr(value, "stem", None))
def test_the_gateware_answers_the_shared_vectors(path: Path, pause: float) -> None:
    with path.open() as lines:
        header = json.loads(lines.readline())
    generics = generics_of(header["configuration"], header["node"])
    (error_at,), (silent_at,) = header["bus_error"], header["bus_timeout"]
    run_bench(
        "unity_link_bench",
        "gateware.bench.unity_link.bench_vectors",
        generics={**generics, "error_at": error_at, "silent_at": silent_at},
        extra_sources=[HERE / "unity_link_bench.vhd"],
        extra_env={"VECTORS": str(path), "PAUSE": str(pause)},
    )

"""Rules checked before any tool starts: they equal those that the gateware checks at elaboration."""

from __future__ import annotations

import re
import subprocess
from typing import TYPE_CHECKING

import pytest

from unity_link.errors import ArgumentError
from unity_link.gateware.cache import LIBRARY, vhdl_sources
from unity_link.gateware.ghdl import Ghdl, converting_ghdl
from unity_link.gateware.limits import check_generics

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from pathlib import Path

TOP = "unity_link"
# Elaboration ends by an assertion whose sentence names a generic, by its name or its meaning.
SENTENCE = re.compile(
    r"\(assertion failure\): \w+: .*\bexpected|which \d+ groups take|than one sample of the largest group"
)
AT_THE_LIMIT: list[dict[str, object]] = [
    {},
    {"group_words": 255, "sample_depth": 512},
    {"group_words": 62, "sample_depth": 64},
    {"groups": 256, "clock_hz": 26_400_000},
    {"groups": 0, "group_words": 0, "sample_depth": 2},
    {"groups": 0, "group_words": 255},
    {"physical": "ft245", "clock_hz": 1, "groups": 0},
    {"data_bits": 8, "address_bits": 32, "id_digits": 2, "crc_bits": 8, "crc_polynomial": 0xFF, "block_words": 1},
    {"crc_polynomial": 0xFFFF, "rx_fifo_depth": 2, "tx_fifo_depth": 0x8000},
    {"crc_bits": 32, "crc_polynomial": 1 << 31, "rx_fifo_depth": 0x8000},
    {"bus_standard": "axi4_lite", "data_bits": 64},
    {"baud": 12_500_000},
    {"baud": 1, "clock_hz": 400_000_000},
    {"physical": "rmii", "block_words": 170, "clock_hz": 25_000_000, "base_frequency_millihertz": 1_000_000},
    {"physical": "mii", "block_words": 1, "group_words": 169},
    {"physical": "rgmii", "block_words": 84, "data_bits": 64, "address_bits": 32, "groups": 0},
]
BEYOND: list[tuple[dict[str, object], str]] = [
    ({"group_words": 256}, "group_words is 256: 1 to 255 was expected"),
    ({"groups": 0, "group_words": 256}, "group_words is 256: 0 to 255 was expected"),
    ({"group_words": 0}, "group_words is 0: 1 to 255 was expected"),
    ({"group_words": 63, "sample_depth": 64}, "of a group of 63 words takes 65: at least 128 was expected"),
    ({"group_words": 255}, "sample_depth is 256, and one sample of a group of 255 words takes 257"),
    ({"groups": 256, "clock_hz": 26_300_000}, "256 groups take 264: at most 99621 Hz, or a clock of at least 26400000"),
    ({"groups": 257}, "groups is 257: 0 to 256 was expected"),
    ({"data_bits": 7}, "data_bits is 7: 8 to 64 was expected"),
    ({"address_bits": 33}, "address_bits is 33: 8 to 32 was expected"),
    ({"id_digits": 4}, "id_digits is 4: 2 to 3 was expected"),
    ({"crc_bits": 12}, "crc_bits is 12: 8, 16 or 32 was expected"),
    ({"crc_bits": 8}, "crc_polynomial is 0x1021: that of a CRC of 8 bits was expected, such as 0x7$"),
    ({"crc_polynomial": 0x10000}, "0x10000: that of a CRC of 16 bits was expected, such as 0x1021$"),
    ({"crc_bits": 32, "crc_polynomial": 0}, "0x0: that of a CRC of 32 bits was expected, such as 0x4c11db7$"),
    ({"block_words": 256}, "block_words is 256: 1 to 255 was expected"),
    ({"block_words": 1000}, "block_words is 1000: 1 to 255 was expected"),
    ({"group_words": 1000}, "group_words is 1000: 1 to 255 was expected"),
    ({"node": 255}, "node is 255: -1 to 254 was expected"),
    ({"rx_fifo_depth": 0x10000}, "rx_fifo_depth is 65536: at most 32768 was expected"),
    ({"tx_fifo_depth": 0x10000}, "tx_fifo_depth is 65536: at most 32768 was expected"),
    ({"rx_fifo_depth": 100}, "rx_fifo_depth is 100: a power of two was expected"),
    ({"bus_standard": "axi4_lite", "data_bits": 8}, "data_bits is 8: AXI4-Lite has 32 or 64"),
    ({"bus_standard": "axi4_lite", "data_bits": 33}, "data_bits is 33: AXI4-Lite has 32 or 64"),
    (
        {"physical": "rmii", "block_words": 171},
        "a frame has up to 1381 bytes, and a datagram of an Ethernet port has 1378",
    ),
    ({"physical": "mii", "block_words": 1, "group_words": 170}, "a frame has up to 1379 bytes, and a datagram of an"),
    ({"physical": "rgmii", "block_words": 85, "data_bits": 64, "address_bits": 32}, "fewer words were expected"),
    (
        {"physical": "rmii", "block_words": 9, "clock_hz": 24_999_999, "base_frequency_millihertz": 1_000_000},
        "clock_hz is 24999999: an Ethernet port needs 25000000 at least",
    ),
    ({"baud": 12_500_001}, "baud is 12500001: at most a quarter of a clock of 50000000 Hz was expected"),
]


@pytest.fixture(scope="module")
def elaborate(tmp_path_factory: pytest.TempPathFactory) -> Callable[[Mapping[str, object]], None]:
    """Return a function that elaborates the gateware with generics, and raises if GHDL rejects them."""
    work, ghdl = tmp_path_factory.mktemp("work"), converting_ghdl()
    options = ["--std=08", f"--work={LIBRARY}", f"--workdir={work}"]
    ghdl.run("import", *options, *map(str, vhdl_sources()), cwd=work)
    ghdl.run("make", *options, TOP, cwd=work)
    return lambda generics: _run(ghdl, work, options, generics)


def _run(ghdl: Ghdl, work: Path, options: list[str], generics: Mapping[str, object]) -> None:
    given = [
        f"-g{name}={value:032b}" if name == "crc_polynomial" else f"-g{name}={value}"
        for name, value in generics.items()
    ]
    ghdl.run("elab-run", *options, TOP, *given, "--stop-time=0ns", cwd=work)


@pytest.mark.parametrize("generics", AT_THE_LIMIT, ids=str)
def test_generics_within_the_limits_are_elaborated(
    generics: Mapping[str, object], elaborate: Callable[[Mapping[str, object]], None]
) -> None:
    check_generics(generics)
    elaborate(generics)


@pytest.mark.parametrize(("generics", "words"), BEYOND, ids=str)
def test_refused_generics_fail_to_elaborate_with_a_reason(
    generics: Mapping[str, object], words: str, elaborate: Callable[[Mapping[str, object]], None]
) -> None:
    with pytest.raises(ArgumentError, match=words):
        check_generics(generics)
    with pytest.raises(subprocess.CalledProcessError) as refused:
        elaborate(generics)
    assert SENTENCE.search(refused.value.stderr + refused.value.stdout)

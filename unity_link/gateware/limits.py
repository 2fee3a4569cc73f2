"""Limits of the gateware's generics, checked before any tool starts; messages name the caller's options.

The assertions in `gateware/rtl` define the limits; a test checks that these rules agree with them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.protocol.wire.crc import USUAL_POLYNOMIALS

if TYPE_CHECKING:
    from collections.abc import Mapping

_DEFAULTS = {
    "data_bits": 32,
    "address_bits": 8,
    "id_digits": 3,
    "crc_bits": 16,
    "crc_polynomial": 0x1021,
    "block_words": 255,
    "groups": 16,
    "group_words": 32,
    "sample_depth": 256,
    "clock_hz": 50_000_000,
    "base_frequency_millihertz": 100_000_000,
    "rx_fifo_depth": 256,
    "tx_fifo_depth": 256,
    # 0 is never too high: the check of the baud rate must pass if there is no UART.
    "baud": 0,
    "node": -1,
}
_RANGES = {
    "data_bits": (8, 64),
    "address_bits": (8, 32),
    "id_digits": (2, 3),
    "block_words": (1, 255),
    "groups": (0, 256),
    "node": (-1, 254),
}
_AXI4_LITE_BITS = (32, 64)
_MOST_FIFO_BYTES = 0x8000
"""Largest FIFO size that the answer to `Q` can express in its four digits."""
ETHERNET = ("rmii", "mii", "rgmii", "w5500")
"""Values of the generic `physical` for Ethernet ports."""
_LEAST_HZ_OF_ETHERNET = 25_000_000
_DATAGRAM, _LONGEST_Q = 1400, 76
_ROUND_CYCLES = 8
"""Clock cycles that a base tick needs in addition to one for each group."""


def check_generics(given: Mapping[str, object]) -> None:
    """Check that the gateware supports a configuration.

    Args:
        given: values of generics of `unity_link`; missing ones have their defaults, generics without limits are
            ignored.

    Raises:
        ArgumentError: if the gateware refuses the configuration; the message has the value and the expected range.
    """
    generics = {name: int(str(given.get(name, default))) for name, default in _DEFAULTS.items()}
    for name, (low, high) in _RANGES.items():
        if not low <= generics[name] <= high:
            raise ArgumentError(f"{name} is {generics[name]}: {low} to {high} was expected")
    _check_crc(generics)
    _check_memories(generics)
    _check_pins(generics, given.get("bus_standard"))
    _check_groups(generics)
    if given.get("physical") in ETHERNET:
        _check_ethernet(generics, given)


def _check_crc(generics: Mapping[str, int]) -> None:
    bits, polynomial = generics["crc_bits"], generics["crc_polynomial"]
    if bits not in USUAL_POLYNOMIALS:
        raise ArgumentError(f"crc_bits is {bits}: 8, 16 or 32 was expected")
    if not 0 < polynomial < 1 << bits:
        usual = USUAL_POLYNOMIALS[bits]
        raise ArgumentError(
            f"crc_polynomial is {polynomial:#x}: that of a CRC of {bits} bits was expected, such as {usual:#x}"
        )


def _check_memories(generics: Mapping[str, int]) -> None:
    for name in ("rx_fifo_depth", "tx_fifo_depth", "sample_depth"):
        if generics[name] < 2 or generics[name].bit_count() != 1:
            raise ArgumentError(f"{name} is {generics[name]}: a power of two was expected")
    for name in ("rx_fifo_depth", "tx_fifo_depth"):
        if generics[name] > _MOST_FIFO_BYTES:
            raise ArgumentError(f"{name} is {generics[name]}: at most {_MOST_FIFO_BYTES} was expected")


def _check_pins(generics: Mapping[str, int], bus_standard: object) -> None:
    bits, baud, clock = generics["data_bits"], generics["baud"], generics["clock_hz"]
    if bus_standard == "axi4_lite" and bits not in _AXI4_LITE_BITS:
        raise ArgumentError(f"data_bits is {bits}: AXI4-Lite has 32 or 64")
    if baud > clock // 4:
        raise ArgumentError(f"baud is {baud}: at most a quarter of a clock of {clock} Hz was expected")


def _check_ethernet(generics: Mapping[str, int], given: Mapping[str, object]) -> None:
    clock = generics["clock_hz"]
    if clock < _LEAST_HZ_OF_ETHERNET:
        raise ArgumentError(f"clock_hz is {clock}: an Ethernet port needs {_LEAST_HZ_OF_ETHERNET} at least")
    word, address = -(-generics["data_bits"] // 4), -(-generics["address_bits"] // 4)
    check, number, block = generics["crc_bits"] // 4, generics["id_digits"], generics["block_words"]
    longest = max(
        2 + max(number, address + 2) + word * block,
        _LONGEST_Q,
        2 + number + address + word * max(block, 2 if given.get("masked_write", True) else 0),
    )
    if generics["groups"]:
        longest = max(longest, 13 + word * generics["group_words"], 12 + number + address * generics["group_words"])
    longest += check + 2
    most = _DATAGRAM - 18 - check
    if longest > most:
        raise ArgumentError(
            f"with block_words {block}, groups {generics['groups']} and group_words {generics['group_words']} a frame "
            f"has up to {longest} bytes, and a datagram of an Ethernet port has {most}: fewer words were expected"
        )


def _check_groups(generics: Mapping[str, int]) -> None:
    words, groups = generics["group_words"], generics["groups"]
    least = 1 if groups else 0
    if not least <= words <= 255:
        raise ArgumentError(f"group_words is {words}: {least} to 255 was expected")
    if not groups:
        return
    if generics["sample_depth"] < words + 2:
        raise ArgumentError(
            f"sample_depth is {generics['sample_depth']}, and one sample of a group of {words} words takes {words + 2}"
            f": at least {1 << (words + 1).bit_length()} was expected"
        )
    base, clock = generics["base_frequency_millihertz"], generics["clock_hz"]
    if base < 1:
        raise ArgumentError(f"base_frequency_millihertz is {base}: at least 1 was expected")
    cycles = groups + _ROUND_CYCLES
    if clock * 1000 < base * cycles:
        raise ArgumentError(
            f"a base frequency of {base / 1000:g} Hz leaves {clock * 1000 / base:.3g} cycles of a clock of {clock} Hz, "
            f"and {groups} groups take {cycles}: at most {clock // cycles} Hz, or a clock of at least "
            f"{-(-base * cycles // 1000)} Hz, was expected"
        )

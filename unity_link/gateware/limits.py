"""What the gateware refuses at its elaboration, said before any tool is started, and in the words of who asked for it.

The assertions of `gateware/rtl` have the last word; a test holds these rules equal to them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    from collections.abc import Mapping

_DEFAULTS = {
    "data_bits": 32,
    "address_bits": 8,
    "id_digits": 3,
    "crc_bits": 16,
    "block_words": 255,
    "groups": 16,
    "group_words": 32,
    "sample_depth": 256,
    "clock_hz": 50_000_000,
    "base_frequency_millihertz": 100_000_000,
    "rx_fifo_depth": 256,
    "tx_fifo_depth": 256,
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
_ROUND_CYCLES = 8
"""Clock cycles of a base tick beside one for each group."""


def check_generics(given: Mapping[str, object]) -> None:
    """Refuse a configuration that the gateware refuses.

    Args:
        given: generics of `unity_link`; what is not named is as it is by itself, and what this does not know is not
            looked at.

    Raises:
        ArgumentError: with what is wrong, and what would be right.
    """
    generics = {name: int(str(given.get(name, default))) for name, default in _DEFAULTS.items()}
    for name, (low, high) in _RANGES.items():
        if not low <= generics[name] <= high:
            raise ArgumentError(f"{name} is {generics[name]}: {low} to {high} was expected")
    if generics["crc_bits"] not in (8, 16, 32):
        raise ArgumentError(f"crc_bits is {generics['crc_bits']}: 8, 16 or 32 was expected")
    for name in ("rx_fifo_depth", "tx_fifo_depth", "sample_depth"):
        if generics[name] < 2 or generics[name].bit_count() != 1:
            raise ArgumentError(f"{name} is {generics[name]}: a power of two was expected")
    if generics["groups"]:
        _check_groups(generics)


def _check_groups(generics: Mapping[str, int]) -> None:
    words, groups = generics["group_words"], generics["groups"]
    if not 1 <= words <= 255:
        raise ArgumentError(f"group_words is {words}: 1 to 255 was expected")
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

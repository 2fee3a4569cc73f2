"""The gateware as C++: `make rtl` writes it to `unity_link/virtual/rtl/generated/`, which is part of the wheel.

There is one C++ text for each configuration that users may want to run without the tools. All texts are in one archive.
An index has a hash of the sources of each (a text is made again only if the hash changes), and its answer to `Q`, so
that a configuration can be chosen before it is compiled.

    python -m gateware.tools.model            make the texts that are out of date
    python -m gateware.tools.model --check    fail if a text is out of date (for CI)
"""

from __future__ import annotations

import argparse
import sys

from unity_link.gateware.cache import GATEWARE
from unity_link.gateware.convert import ConversionError
from unity_link.gateware.ghdl import ToolMissingError
from unity_link.spec import compile_file
from unity_link.virtual.generics import OPTIONAL, generics_of, info_of
from unity_link.virtual.rtl.archive import GENERATED, Entry, read_index, read_texts, write
from unity_link.virtual.rtl.making import make, origin
from unity_link.virtual.rtl.specs import with_clock

# With the clock of most configurations, the simulation runs about as fast as real time. The configurations for tests on
# simulated time have a slower clock, so that a simulated minute takes little processor time.
_CLOCK = {"clock_hz": 500_000, "base_frequency_millihertz": 10_000_000}
_SLOW_CLOCK = {"clock_hz": 50_000, "base_frequency_millihertz": 1_000_000, "groups": 4}
_CRC_8 = {"crc_bits": 8, "crc_polynomial": 0x07}
_CRC_32 = {"crc_bits": 32, "crc_polynomial": 0x04C11DB7}
_FT232H = {
    **_CRC_8,
    "clock_hz": 50_000_000,
    "base_frequency_millihertz": 1_000_000_000,
    "group_words": 255,
    "sample_depth": 1024,
}
CONFIGURATIONS: dict[str, dict[str, int]] = {
    "default": {**_CLOCK, "sample_depth": 1024},
    # The widths of the paper's gateway.
    "short": {**_CLOCK, "id_digits": 2, **_CRC_8},
    # The experiment of the paper measures this one: an FT232H at its true clock, because its timing is modelled, with
    # the CRC of the paper, and IDs for a window that fills the medium. A fine base tick finds the limit of publishing.
    "ft232h": _FT232H,
    "ft232h_compact": {**_FT232H, "compact": True},
    # The largest value of every width.
    "wide": {
        **_CLOCK,
        **_CRC_32,
        "data_bits": 64,
        "address_bits": 32,
        "groups": 20,
        "group_words": 255,
        "sample_depth": 4096,
        "wb_pipelined": True,
    },
    # Widths that are not multiples of 4 or 8.
    "odd": {
        **_CLOCK,
        "data_bits": 9,
        "address_bits": 13,
        "id_digits": 2,
        "block_words": 10,
        "build_id": 0xCAFE,
    },
    # The smallest configuration.
    "minimal": {
        **_CLOCK,
        **dict.fromkeys(OPTIONAL, False),
        "data_bits": 8,
        "block_words": 1,
        "groups": 0,
    },
    # Groups, without the features that can be left out.
    "bare_groups": {**_CLOCK, **dict.fromkeys(OPTIONAL, False)},
    # One of several nodes on a shared medium.
    "node": {**_CLOCK, "node": 5},
    "slow": _SLOW_CLOCK,
    "compact": {**_SLOW_CLOCK, **_CRC_32, "compact": True},
    "crc_32": {**_SLOW_CLOCK, **_CRC_32},
    "short_ids": {**_SLOW_CLOCK, **_CRC_32, "id_digits": 2},
    # For a UART of three wires, without flow control.
    "uart": {**_SLOW_CLOCK, **_CRC_32, "flow_control": False, "rx_fifo_depth": 64, "tx_fifo_depth": 64},
    # The gateway of the spec of the robot with this name.
    "walker": with_clock(generics_of(compile_file(GATEWARE.parent / "examples" / "walker.ul").interface())),
}


def is_current(name: str) -> bool:
    """Return whether the C++ of a configuration was made from the present sources."""
    entry = read_index(GENERATED).get(name)
    return entry is not None and entry.origin == origin(CONFIGURATIONS[name])


def main() -> int:
    """Make or check all configurations, and return the exit status."""
    parser = argparse.ArgumentParser(description="Make the C++ of the gateware.")
    parser.add_argument("--check", action="store_true", help="fail if something is out of date, and make nothing")
    arguments = parser.parse_args()
    stale = [name for name in CONFIGURATIONS if not is_current(name)]
    if arguments.check:
        if stale:
            sys.stderr.write(f"out of date: {', '.join(stale)}; run make rtl\n")
        return int(bool(stale))
    texts, index = read_texts(GENERATED), read_index(GENERATED)
    try:
        for name in stale:
            generics = CONFIGURATIONS[name]
            texts[name], _ = make(name, generics)
            index[name] = Entry.of(origin(generics), texts[name], info_of(generics), generics.get("node"))
            sys.stdout.write(f"{name}: {len(texts[name]) // 1000} kB\n")
            sys.stdout.flush()
    except (ConversionError, ToolMissingError) as error:
        sys.stderr.write(f"{error}\n")
        return 1
    known = CONFIGURATIONS.keys()
    if stale or index.keys() != known:
        write(GENERATED, {name: index[name] for name in known}, {name: texts[name] for name in known})
    return 0


if __name__ == "__main__":
    sys.exit(main())

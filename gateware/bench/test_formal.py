"""What `gateware/formal` claims is proved, and the proofs can fail: each finds a fault that is put in for it."""

from __future__ import annotations

import re

import pytest

from gateware.tools.formal import PROOFS, Proof, prove
from gateware.tools.ghdl import ToolMissingError

pytestmark = [pytest.mark.slow]

FAULTS = {
    "a full FIFO takes more": ("fifo_sync", "push", "in_valid"),
    "a full dual-clock FIFO takes more": ("fifo_async", "push", "in_valid"),
    "a pointer crosses in binary": ("fifo_async", "write_gray", "write_at"),
    "a body does not wait for its reader": ("datalink_rx", "advance", "1'b1"),
    "a frame does not wait for its reader": ("datalink_tx", "advance", "1'b1"),
    "a request comes into a sample": ("bus_master", "grant", "request & ~(sample & ~exclusive) & (state == 0)"),
}
"""The entity, a signal of it, and what drives it in place of what should."""


def _prove(proof: Proof, fault: tuple[str, str] | None = None) -> str | None:
    def change(verilog: str) -> str:
        if fault is None:
            return verilog
        changed, count = re.subn(rf"assign {fault[0]} = [^;]+;", f"assign {fault[0]} = {fault[1]};", verilog)
        assert count == 1
        return changed

    try:
        return prove(proof, change)
    except ToolMissingError as error:
        pytest.skip(str(error))


@pytest.mark.parametrize("proof", PROOFS, ids=lambda proof: proof.entity)
def test_the_properties_are_proved(proof: Proof) -> None:
    assert _prove(proof) is None


@pytest.mark.parametrize("fault", FAULTS.values(), ids=FAULTS)
def test_a_proof_fails_where(fault: tuple[str, str, str]) -> None:
    entity, *replaced = fault
    proof = next(proof for proof in PROOFS if proof.entity == entity)
    wrong = _prove(proof, (replaced[0], replaced[1]))
    assert wrong is not None
    assert "failed assertion" in wrong

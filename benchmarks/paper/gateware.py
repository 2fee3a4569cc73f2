"""What the gateware alone takes, in cycles of its clock: counted on the RTL, at the port of its FIFOs.

The medium there takes and gives a byte in every cycle. The messages are the paper's, without IDs.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from benchmarks.paper.build import checked, compiled_gateway
from benchmarks.paper.results import GatewareFigures

if TYPE_CHECKING:
    from unity_link.virtual.rtl import RtlGateway

ADDRESS, WORD = 0x0A, 0x12
_PIPELINED = 500
_PATIENCE = 10_000
"""Cycles in which everything here is long done."""


def measure_gateware() -> GatewareFigures:
    """Count the cycles of a read, of a write and of pipelined reads."""
    gateway = compiled_gateway()
    read, _ = _count(gateway, checked(b"R%02X" % ADDRESS), answer_size=14)
    write, effect = _count(gateway, checked(b"W%02X%08X" % (ADDRESS, WORD)), answer_size=6)
    assert effect is not None
    return GatewareFigures(
        clock_hz=gateway.info.clock_hz,
        read_cycles=read,
        write_cycles=write,
        effect_cycles=effect,
        bytes_per_cycle=_pipelined(gateway),
    )


def _count(gateway: RtlGateway, request: bytes, answer_size: int) -> tuple[int, int | None]:
    """Return the cycles from the last byte in to the last byte out, and to the first change in memory, if any."""
    rest, sent, effect = request, 0, None
    last_in = 0
    for cycle in range(_PATIENCE):
        passage = gateway.pass_pins(rest, 1, answer_size)
        rest = rest[passage.taken :]
        sent += len(passage.sent)
        if passage.taken and not rest:
            last_in = cycle
        if effect is None and gateway.memory[ADDRESS] == WORD:
            effect = cycle - last_in
        if sent == answer_size:
            return cycle - last_in, effect
    raise AssertionError(f"the gateware has not answered {request!r}")


def _pipelined(gateway: RtlGateway) -> float:
    """Return the bytes that leave in a cycle while reads, which have IDs, come as fast as they are taken."""
    session = checked(b"K000")
    _count(gateway, session, len(session))
    rest = b"".join(checked(b"r%03X%02X" % (number, ADDRESS)) for number in range(_PIPELINED))
    size = 15 * _PIPELINED
    first = None
    sent = 0
    for cycle in range(2 * size):
        passage = gateway.pass_pins(rest[:64], 1, size)
        rest = rest[passage.taken :]
        if passage.sent and first is None:
            first = cycle
        sent += len(passage.sent)
        if sent == size:
            assert first is not None
            return size / (cycle - first + 1)
    raise AssertionError(f"the gateware has answered with {sent} of {size} bytes")

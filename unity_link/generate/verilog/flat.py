"""The hardware's side of an interface as ports of their own, one for each element of its records."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from unity_link.generate.vhdl.names import Scope
from unity_link.generate.vhdl.types import to_bits

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.generate.vhdl.bank import Bank, Register


class FlatPort(NamedTuple):
    """A port, and what it is joined with."""

    name: str
    width: int
    """Width of a vector; 0 for a single bit."""
    target: str
    """Target of the assignment: an element of the record of what hardware gives, or the port."""
    value: str
    is_input: bool


def flat_ports(bank: Bank) -> Iterator[FlatPort]:
    """Return the ports of all signals of a bank."""
    decoders = (enumeration.decode for enumeration in bank.enumerations.values())
    pins = (f"{port.name}_{pin}" for port in bank.ports for pin in _MASTER_PINS)
    scope = Scope(*_TAKEN, *decoders, *pins)
    for register in bank.registers:
        yield from _of(register, bank, scope)


_MASTER_PINS = ("cyc", "stb", "we", "adr", "dat_o", "dat_i", "ack", "err")
_TAKEN = (
    *("clk", "rst", "uart_rxd", "uart_txd", "uart_rts_n", "uart_cts_n", "trigger", "from_hardware", "to_hardware"),
    *(f"ft_{pin}" for pin in ("clkout", "data_in", "data_out", "data_oe", "rxf_n", "txe_n", "rd_n", "wr_n", "oe_n")),
    *("ft_siwu_n", "physical", "clock_hz", "baud", "to_bits", "work", "ieee"),
)


def _of(register: Register, bank: Bank, scope: Scope) -> Iterator[FlatPort]:
    pins, kind = register.pins, register.signal.kind
    path = register.signal.path
    width = 0 if to_bits(kind, "x") == "x" and kind.width == 1 else kind.width
    if pins.given:
        name = scope.unique(f"{path}_in" if pins.got else path)
        yield FlatPort(name, width, pins.given, bank.given(register, name), is_input=True)
    if pins.got:
        name = scope.unique(f"{path}_out" if pins.given else path)
        yield FlatPort(name, width, name, register.got_bits, is_input=False)
    for pin, ending, is_input in (
        (pins.written, "written", False),
        (pins.given_valid, "in_valid", True),
        (pins.given_ready, "in_ready", False),
        (pins.got_valid, "out_valid", False),
        (pins.got_ready, "out_ready", True),
    ):
        if pin:
            name = scope.unique(f"{path}_{ending}")
            yield FlatPort(name, 0, *((pin, name) if is_input else (name, pin)), is_input=is_input)

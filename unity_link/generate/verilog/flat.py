"""The hardware's side of an interface as separate ports, one for each element of its records."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from unity_link.generate.vhdl.bank import MASTER_PINS
from unity_link.generate.vhdl.names import Scope
from unity_link.generate.vhdl.types import to_bits
from unity_link.spec import Way

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from unity_link.generate.vhdl.bank import Bank, Register
    from unity_link.generate.vhdl.wiring import PinPort


class FlatPort(NamedTuple):
    """A port of the flat entity, and its assignment."""

    name: str
    width: int
    """Width of a vector; 0 for a std_logic."""
    target: str
    """Target of the assignment: an element of `from_hardware`, or the port."""
    value: str
    is_input: bool
    path: str
    """Path of the signal in the spec."""
    pin: str
    """Field of `Pins` to which the port belongs."""


class OtherPort(NamedTuple):
    """A port of the flat entity that is connected to the same port of the gateway."""

    name: str
    type: str
    """Direction and type, and default if there is one."""


_BIT, _BYTE = "std_logic", "std_logic_vector(7 downto 0)"
CLOCK = (OtherPort("clk", f"in {_BIT}"), OtherPort("rst", f"in {_BIT}"))
MEDIA = (
    *CLOCK,
    OtherPort("uart_rxd", f"in {_BIT} := '1'"),
    OtherPort("uart_txd", f"out {_BIT}"),
    OtherPort("uart_rts_n", f"out {_BIT}"),
    OtherPort("uart_cts_n", f"in {_BIT} := '0'"),
    OtherPort("ft_clkout", f"in {_BIT} := '0'"),
    OtherPort("ft_data_in", f"in {_BYTE} := (others => '0')"),
    OtherPort("ft_data_out", f"out {_BYTE}"),
    OtherPort("ft_data_oe", f"out {_BYTE}"),
    OtherPort("ft_rxf_n", f"in {_BIT} := '1'"),
    OtherPort("ft_txe_n", f"in {_BIT} := '1'"),
    OtherPort("ft_rd_n", f"out {_BIT}"),
    OtherPort("ft_wr_n", f"out {_BIT}"),
    OtherPort("ft_oe_n", f"out {_BIT}"),
    OtherPort("ft_siwu_n", f"out {_BIT}"),
)
"""Clock, reset, and the pins of all media."""
FIFO = (
    *CLOCK,
    OtherPort("in_data", f"in {_BYTE}"),
    OtherPort("in_lost", f"in {_BIT}"),
    OtherPort("in_valid", f"in {_BIT}"),
    OtherPort("in_ready", f"out {_BIT}"),
    OtherPort("out_data", f"out {_BYTE}"),
    OtherPort("out_valid", f"out {_BIT}"),
    OtherPort("out_ready", f"in {_BIT}"),
    OtherPort("out_flush", f"out {_BIT}"),
)
"""Clock, reset, and a FIFO as the medium."""


def triggers(groups: int) -> OtherPort:
    """Return the port for the triggers of `groups` groups."""
    return OtherPort("trigger", f"in std_logic_vector({max(groups, 1) - 1} downto 0) := (others => '0')")


def flat_ports(bank: Bank, others: Iterable[OtherPort]) -> Iterator[FlatPort]:
    """Yield the ports of all signals of a bank.

    Args:
        bank: register bank of an interface.
        others: other ports of the entity, whose names are taken.
    """
    scope = _scope(bank, others)
    for register in bank.registers:
        if not register.is_wired:
            yield from _of(register, bank, scope)


def pads(bank: Bank, others: Iterable[OtherPort]) -> list[tuple[PinPort, str]]:
    """Return the INOUT pins, each with a name for the level at its pad."""
    scope = _scope(bank, others)
    scope.take(*(port.name for port in flat_ports(bank, others)))
    return [(pin, scope.unique(f"{pin.name}_pad")) for pin in bank.wiring.pins if pin.way is Way.INOUT]


def _scope(bank: Bank, others: Iterable[OtherPort]) -> Scope:
    decoders = (enumeration.decode for enumeration in bank.enumerations.values())
    masters = (f"{port.name}_{pin}" for port in bank.ports for pin in MASTER_PINS)
    pins = (name for pin in bank.wiring.pins for name, _ in pin.ports)
    return Scope(*_TAKEN, *(port.name for port in others), *decoders, *masters, *pins)


_TAKEN = ("from_hardware", "to_hardware", "physical", "clock_hz", "baud", "to_bits", "work", "ieee")


def _of(register: Register, bank: Bank, scope: Scope) -> Iterator[FlatPort]:
    pins, kind = register.pins, register.signal.kind
    path = register.signal.path
    width = 0 if to_bits(kind, "x") == "x" and kind.width == 1 else kind.width
    if pins.given:
        name = scope.unique(f"{path}_in" if pins.got else path)
        yield FlatPort(name, width, pins.given, bank.given(register, name), is_input=True, path=path, pin="given")
    if pins.got:
        name = scope.unique(f"{path}_out" if pins.given else path)
        yield FlatPort(name, width, name, register.got_bits, is_input=False, path=path, pin="got")
    for pin, ending, is_input in (
        ("written", "written", False),
        ("given_valid", "in_valid", True),
        ("given_ready", "in_ready", False),
        ("got_valid", "out_valid", False),
        ("got_ready", "out_ready", True),
    ):
        if element := getattr(pins, pin):
            name = scope.unique(f"{path}_{ending}")
            target, value = (element, name) if is_input else (name, element)
            yield FlatPort(name, 0, target, value, is_input, path, pin)

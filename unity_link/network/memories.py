"""The networks of an interface that need a commit after each write: those of type TOSNET with CTRL in a spec."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from unity_link.network.tosnet import NODE_WORDS, NODES
from unity_link.spec.model import ParameterReference

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.spec import Interface, ModuleSpec

_WORD = "TOSNET"


class NetworkMemory(NamedTuple):
    """A double-buffered memory."""

    ctrl: int | str
    """Address of CTRL, or the name of the open parameter of the interface that sets it."""
    comm: int | str | None
    addresses: tuple[int, ...]
    """Addresses of all words that signals and named modules write, ascending."""


def networks(interface: Interface) -> list[NetworkMemory]:
    """Return the networks of an interface that have CTRL, in the order of the spec."""
    return [
        NetworkMemory(ctrl, _handle(module, "COMM"), _addresses(interface, number))
        for number, module in enumerate(interface.modules)
        if module.type == _WORD and (ctrl := _handle(module, "CTRL")) is not None
    ]


def given_parameters(interface: Interface) -> tuple[str, ...]:
    """Return the open parameters that the CTRL and COMM of an interface's networks use, in the interface's order."""
    used = {handle for network in networks(interface) for handle in (network.ctrl, network.comm)}
    return tuple(name for name in interface.open_parameters if name in used)


def shared_addresses(interface: Interface) -> frozenset[int]:
    """Return the addresses of words that only a commit sends, of the networks with a fixed CTRL (no open parameter)."""
    return frozenset(
        address for network in networks(interface) if isinstance(network.ctrl, int) for address in network.addresses
    )


def _handle(module: ModuleSpec, name: str) -> int | str | None:
    value = module.arguments.get(name)
    if isinstance(value, ParameterReference):
        return value.name
    return None if value is None else int(value)


def _addresses(interface: Interface, number: int) -> tuple[int, ...]:
    inside = {index for index in range(len(interface.modules)) if number in set(_outwards(interface, index))}
    written = {
        address
        for signal in interface.signals.values()
        if signal.module in inside and signal.access.writes and not signal.fifo
        for address in signal.addresses
    }
    for index in inside:
        module = interface.modules[index]
        if module.name is not None:
            words = NODES * NODE_WORDS if module.words is None else module.words
            written.update(range(module.base, min(module.base + words, 1 << interface.address_bits)))
    return tuple(sorted(written))


def _outwards(interface: Interface, number: int | None) -> Iterator[int]:
    while number is not None:
        yield number
        number = interface.modules[number].parent

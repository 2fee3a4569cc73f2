"""VHDL: the gateway, its register bank and the bank's bench, generated from an interface.

- `names`, `types`, `records`, `bank`, `wiring`: the interface in terms of VHDL
- `stimuli`: the accesses of the bench, and their expected results
- `layout`: the columns of the text
- the templates: a package, the register bank, gateway and bank as one entity, complete designs for boards, the bench

The bank is a Wishbone B4 slave; the comment at the top of `registers.vhd.jinja` describes its behaviour.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from unity_link.errors import UnsupportedError
from unity_link.generate import GeneratedFile
from unity_link.generate.vhdl import types
from unity_link.generate.vhdl.bank import Bank, is_bit, is_bool, slice_at
from unity_link.generate.vhdl.layout import align
from unity_link.generate.vhdl.names import identifier
from unity_link.generate.vhdl.stimuli import Stimuli
from unity_link.spec.rates import base_millihertz

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from unity_link.generate import Templates
    from unity_link.spec import Interface

DOC = "VHDL: a package, the register bank on Wishbone, gateway and bank as one entity, and a bench of the bank"
FILTERS: dict[str, Callable[..., Any]] = {
    "bits": types.bit_literal,
    "real": types.real_literal,
    "comment": types.comment,
}

_LEAST_GROUPS = 16
_LEAST_GROUP_WORDS = 32
_LEAST_SAMPLE_DEPTH = 256
"""Minimum depth of the gateway's sample FIFO: room for subscriptions of programs besides the groups of the spec."""
_MEDIA = ("uart", "ft245", "ft245_sync", "rmii", "mii", "rgmii", "w5500")
_BYTES_OF_DATAGRAM = 1378
_BYTES_BESIDE_WORDS = 32
"""Most bytes of a frame on Ethernet, and an upper limit for the part of a block's frame that is not words."""
_MOST_WORDS = 255


def files(
    interface: Interface, templates: Templates, *, clk_ready: bool = False, whole: bool = True
) -> Iterator[GeneratedFile]:
    """Yield the files of an interface. Complete designs are left out if `left_open` reports missing gateware.

    Args:
        interface: the interface.
        templates: templates of this target.
        clk_ready: whether complete designs have an input for a PLL's lock, which is not a pin.
        whole: whether complete designs are generated.

    Raises:
        UnsupportedError: if two modules have the same addresses.
    """
    bank = Bank(interface)
    name = identifier(interface.name)
    values: dict[str, object] = {
        "interface": interface,
        "prefix": name,
        "bank": bank,
        "generics": gateway_generics(interface),
        "block_words": block_words(interface),
        "is_bit": is_bit,
        "is_bool": is_bool,
        "slice_at": slice_at,
        "vhdl": types,
        "clk_ready": clk_ready,
    }
    media = _MEDIA if whole and not bank.open_ends else ()
    texts = {
        f"{name}_map": ("map", values),
        f"{name}_registers": ("registers", values),
        f"{name}_gateway": ("gateway", values),
        **{f"{name}_on_{medium}": ("board", values | {"medium": medium}) for medium in media},
        f"{name}_bench": ("bench", values | {"stimuli": Stimuli(bank)}),
    }
    for file, (template, given) in texts.items():
        yield GeneratedFile(f"{file}.vhd", align(templates.render(f"{template}.vhd", **given)))


def left_open(interface: Interface) -> str:
    """Return a sentence that names the gateware that a complete design would lack; empty if it lacks none.

    Raises:
        UnsupportedError: if two modules have the same addresses.
    """
    name, lacking = identifier(interface.name), Bank(interface).open_ends
    if not lacking:
        return ""
    return (
        f"{interface.name} is no whole design by itself: no gateware implements {', '.join(lacking)}; take "
        f"{name}_gateway of generate vhdl into a top of your own, connect its ports for them to VHDL of yours, and "
        "give the top to unity-link build by --top"
    )


def check_whole(interface: Interface) -> None:
    """Raise an error if a complete design of an interface would lack gateware.

    Raises:
        UnsupportedError: with the names of the missing parts; or if two modules have the same addresses.
    """
    if fault := left_open(interface):
        raise UnsupportedError(fault)


def block_words(interface: Interface) -> int:
    """Return the most words of a block on Ethernet, for which the frame fits into a datagram."""
    return min(_MOST_WORDS, (_BYTES_OF_DATAGRAM - _BYTES_BESIDE_WORDS) // -(-interface.data_bits // 4))


def gateway_generics(interface: Interface) -> dict[str, int | str]:
    """Return the generics of the entity `unity_link` for an interface."""
    published = [group for group in interface.groups if group.number is not None]
    words = max([_LEAST_GROUP_WORDS, *(len(group.addresses) for group in published)])
    numbers = [group.number + 1 for group in published if group.number is not None]
    return {
        "address_bits": interface.address_bits,
        "data_bits": interface.data_bits,
        "groups": max([_LEAST_GROUPS, *numbers]),
        "group_words": words,
        "sample_depth": max(_LEAST_SAMPLE_DEPTH, 1 << (2 * (words + 2) - 1).bit_length()),
        "base_frequency_millihertz": base_millihertz(published),
        "build_id": f"{interface.fingerprint:08X}",
    }

"""VHDL: the gateway, its register bank and its bench, as an interface describes them.

- `names`, `types`, `records`, `bank`: the interface in VHDL's terms
- `stimuli`: what the bench does, and what it must see
- `layout`: the columns of the text
- the templates: a package, the register bank, gateway and bank as one entity, boards without further logic, the bench

The bank is a Wishbone B4 slave; `registers.vhd.jinja` says at its top how it behaves.
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
"""Least depth of the sample FIFO of a gateway by itself: room for the subscriptions of programs beside the groups of
the spec.
"""
_MEDIA = ("uart", "ft245", "ft245_sync", "rmii", "mii", "rgmii", "w5500")
_BYTES_OF_DATAGRAM = 1378
_BYTES_BESIDE_WORDS = 32
"""Most bytes of a frame on Ethernet, and enough for what a frame of a block has beside its words."""
_MOST_WORDS = 255


def files(
    interface: Interface, templates: Templates, *, clk_ready: bool = False, whole: bool = True
) -> Iterator[GeneratedFile]:
    """Make the files of an interface; without whole designs, where `left_open` says that they would not be whole.

    Args:
        interface: of a spec.
        templates: of this target.
        clk_ready: whether the whole designs have a port for a PLL's lock; it is no pin.
        whole: whether whole designs are made at all.

    Raises:
        UnsupportedError: where addresses belong to two modules alike.
    """
    bank = Bank(interface)
    name = identifier(interface.name)
    values: dict[str, Any] = {
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
    """Return a sentence that names what a whole design of an interface would lack; empty where it lacks nothing.

    Raises:
        UnsupportedError: where addresses belong to two modules alike.
    """
    name, lacking = identifier(interface.name), Bank(interface).open_ends
    if not lacking:
        return ""
    return (
        f"{interface.name} is no whole design by itself: no gateware stands behind {', '.join(lacking)}; take "
        f"{name}_gateway of generate vhdl into a top of your own, connect its ports for them to VHDL of yours, and "
        "give the top to unity-link build by --top"
    )


def check_whole(interface: Interface) -> None:
    """Refuse an interface of which a whole design would lack something.

    Raises:
        UnsupportedError: for what it would lack, by name; or where addresses belong to two modules alike.
    """
    if fault := left_open(interface):
        raise UnsupportedError(fault)


def block_words(interface: Interface) -> int:
    """Return the most words of a block on Ethernet, where a frame has a datagram at most."""
    return min(_MOST_WORDS, (_BYTES_OF_DATAGRAM - _BYTES_BESIDE_WORDS) // -(-interface.data_bits // 4))


def gateway_generics(interface: Interface) -> dict[str, int | str]:
    """Return the generics of `unity_link` that follow from an interface."""
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

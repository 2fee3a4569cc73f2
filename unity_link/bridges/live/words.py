"""Bare addresses as a robot, for users without a spec: each word is a signal named after its address."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.bridges.sampled import SampledGroup
from unity_link.data import Group, load
from unity_link.errors import ArgumentError
from unity_link.protocol.wire.configuration import Feature
from unity_link.spec import Access, ComponentSpec, Interface, Kind, KindName, Signal, Spec

if TYPE_CHECKING:
    from collections.abc import Sequence

    from unity_link.data import Robot
    from unity_link.link.link import Link


def robot_of_words(link: Link, addresses: Sequence[int], rate_hz: float) -> tuple[Robot, list[SampledGroup]]:
    """Return a robot whose signals are signed words that can be written, and the groups that sample them.

    Args:
        link: an open link.
        addresses: addresses of the words, each once.
        rate_hz: samples per second.

    Raises:
        ArgumentError: for addresses that the gateway does not have, or one that appears twice.
    """
    info = link.gateway
    for address in addresses:
        if addresses.count(address) > 1:
            raise ArgumentError(f"address {address:#x} was given twice")
        if not 0 <= address < 1 << info.address_bits:
            raise ArgumentError(f"address {address:#x} is not from 0 to {(1 << info.address_bits) - 1:#x}")
    signals = tuple(
        Signal(
            name=f"word_{address:0{info.address_digits}X}",
            path=f"word_{address:0{info.address_digits}X}",
            id=f"0x{address:0{info.address_digits}X}",
            address=address,
            word_bits=info.data_bits,
            kind=Kind(KindName.SIGNED, info.data_bits),
            access=Access.READWRITE,
        )
        for address in addresses
    )
    root = ComponentSpec(name="words", path="", type="words", signals=signals)
    interface = Interface(name="words", address_bits=info.address_bits, data_bits=info.data_bits, root=root)
    robot = load(Spec(interfaces=(interface,), sources=()))(link)
    proxies = list(robot.signals)
    if Feature.GROUPS not in info.features:
        return robot, [SampledGroup("words", Group.polled(rate_hz, proxies))]
    most = info.group_words
    groups = [Group(*proxies[start : start + most], rate_hz=rate_hz) for start in range(0, len(proxies), most)]
    return robot, [SampledGroup(f"words_{number}", group) for number, group in enumerate(groups, start=1)]

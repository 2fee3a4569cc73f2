"""The robot behind a gateway that carries the description of its spec."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.data.loading import load
from unity_link.errors import UnsupportedError
from unity_link.protocol.configuration import Feature
from unity_link.protocol.description import PAGE_WORDS, description_of, length_of, page_address, pages_of

if TYPE_CHECKING:
    from unity_link.data.loading import LoadedRobot
    from unity_link.link.link import Link
    from unity_link.spec.model import Spec

ATTEMPTS = 5
"""Readings of a description: another program that reads it at the same time turns its pages, too."""


async def robot_behind(link: Link) -> LoadedRobot:
    """Return the robot behind a link; `unity_link.robot` says more.

    Raises:
        UnsupportedError: as by `read_spec`.
        LinkLostError: when the link has ended.
    """
    return load(await read_spec(link))(link)


async def read_spec(link: Link) -> Spec:
    """Return the spec that a gateway was built from, with one interface: from the description that it carries.

    Raises:
        UnsupportedError: where it carries none, or one that cannot be read here.
        LinkLostError: when the link has ended.
    """
    from unity_link.spec import SpecError, compile_description

    info = link.gateway
    if Feature.DESCRIPTION not in info.features:
        raise UnsupportedError("the gateway carries no description: give the spec that it was built from")
    damage = ""
    for _ in range(ATTEMPTS):
        try:
            description = description_of(await _words(link), info.data_bits)
        except ValueError as error:
            damage = str(error)
            continue
        try:
            return compile_description(description, info.address_bits, info.data_bits)
        except (ValueError, SpecError) as error:
            raise UnsupportedError(f"the gateway's description is none of this version: {error}") from None
    raise UnsupportedError(f"the gateway's description cannot be read: {damage}")


async def _words(link: Link) -> list[int]:
    words = await _page(link, 0)
    for number in range(1, pages_of(length_of(words, link.gateway.data_bits), link.gateway.data_bits)):
        words += await _page(link, number)
    return words


async def _page(link: Link, number: int) -> list[int]:
    """Return the words of a page.

    Raises:
        ValueError: where another program has turned to another page in between.
    """
    address = page_address(link.gateway.address_bits)
    await link.post(address, number)
    shown, *words = map(int, await link.read_block(address, 1 + PAGE_WORDS))
    if shown != number:
        raise ValueError(f"another program reads it: page {number} was asked for, and page {shown} shown")
    return words

"""The robot of a gateway that carries a description of its spec."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, TypeVar, overload

from unity_link.data.loading import load
from unity_link.data.robot import Robot, check_link
from unity_link.errors import SpecMismatchError, UnsupportedError
from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.description import PAGE_WORDS, description_of, length_of, page_address, pages_of
from unity_link.spec.comparing import compare, source_name

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

    from unity_link.data.loading import LoadedRobot
    from unity_link.link.link import Link
    from unity_link.protocol.wire.configuration import GatewayInfo
    from unity_link.spec.model import Interface, Spec

ATTEMPTS = 5
"""Attempts to read a description; another program that reads it may select other pages in between."""
MOST_DIFFERENCES = 5
"""Most differences that an error lists."""
_LONGEST_REASON = 300
"""Most characters of an error in a description that are shown; names in the description may be longer."""
R = TypeVar("R", bound=Robot)


class DescribedBus(Protocol):
    """The methods of a link that reading a description needs."""

    @property
    def gateway(self) -> GatewayInfo:
        """Configuration of the gateway."""

    async def post(self, address: int, value: int, /) -> None:
        """Write a word."""

    async def read_block(self, address: int, count: int, /) -> Iterable[int]:
        """Read consecutive words."""


@overload
async def robot_behind(link: Link, spec: str | Path | Spec | None = None, **parameters: int | None) -> LoadedRobot: ...
@overload
async def robot_behind(link: Link, spec: type[R], **parameters: int | None) -> R: ...
async def robot_behind(
    link: Link, spec: str | Path | Spec | type[Robot] | None = None, **parameters: int | None
) -> Robot:
    """Return the robot behind a link; see `unity_link.robot`.

    Raises:
        UnsupportedError: as for `read_spec`.
        SpecMismatchError: if the gateway was generated from another spec.
        LinkLostError: if the link has ended.
    """
    robot_type: type[Robot]
    if spec is None:
        robot_type = load(await read_spec(link))
    elif isinstance(spec, type) and issubclass(spec, Robot):
        robot_type = spec
    else:
        robot_type = load(spec)
    await check_board(robot_type.interface, link)
    return robot_type(link, **parameters)


async def check_board(interface: Interface, link: Link) -> None:
    """Compare an interface with the gateway's description of itself, if their fingerprints differ.

    If the gateway has no description, only `check_gateway` compares the configuration, when the robot is made.

    Raises:
        SpecMismatchError: if the gateway lacks a part of the interface, or has a different one.
        UnsupportedError: if its description cannot be read or used.
        LinkLostError: if the link has ended.
    """
    check_link(interface, link)
    info = link.gateway
    is_same = Feature.FINGERPRINT in info.features and info.build_id == interface.fingerprint
    if is_same or link.any_map or interface.fingerprint in link.compatible_maps:
        return
    if Feature.DESCRIPTION not in info.features:
        return
    differences = compare(interface, (await read_spec(link)).interface())
    if differences:
        raise SpecMismatchError(_refusal(differences, source_name(interface)), differences)
    link.compatible_maps.add(interface.fingerprint)


def shown_differences(differences: tuple[str, ...]) -> str:
    """Return differences as a part of a sentence; at most `MOST_DIFFERENCES` of them, and the number of the others."""
    more = len(differences) - MOST_DIFFERENCES
    return "; ".join(differences[:MOST_DIFFERENCES]) + (f"; and {more} more" if more > 0 else "")


def _refusal(differences: tuple[str, ...], name: str) -> str:
    return (
        f"the gateway was built from another spec than {name} ({shown_differences(differences)}): "
        f"load the spec that the gateway was built from, or build it from {name}, "
        "or write map=any in the URL if you know better"
    )


async def read_spec(link: DescribedBus) -> Spec:
    """Read the description that a gateway carries, and return the spec that it was built from, with one interface.

    Raises:
        UnsupportedError: if the gateway has no description, or one that cannot be read or used.
        LinkLostError: if the link has ended.
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
        except SpecError as error:
            reason = error.diagnostics[0].message[:_LONGEST_REASON]
            raise UnsupportedError(f"the gateway's description cannot be read by this version: {reason}") from None
        except ValueError as error:
            advice = "give the spec that it was built from"
            raise UnsupportedError(f"the gateway's description cannot be used ({error}): {advice}") from None
    raise UnsupportedError(f"the gateway's description cannot be read: {damage}")


async def _words(link: DescribedBus) -> list[int]:
    words = await _page(link, 0)
    for number in range(1, pages_of(length_of(words, link.gateway.data_bits), link.gateway.data_bits)):
        words += await _page(link, number)
    return words


async def _page(link: DescribedBus, number: int) -> list[int]:
    """Select a page and return its words.

    Raises:
        ValueError: if another program has selected another page in between.
    """
    address = page_address(link.gateway.address_bits)
    await link.post(address, number)
    shown, *words = map(int, await link.read_block(address, 1 + PAGE_WORDS))
    if shown != number:
        raise ValueError(f"another program reads it: page {number} was asked for, and page {shown} shown")
    return words

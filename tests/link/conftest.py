"""The gateways that the tests of the link run on, each by its id.

A new kind of gateway joins by a line in `KINDS`: a function that gives a gateway of a configuration, fresh from reset,
with memory behind it and bus errors at the addresses that it is told. Those in `SCHEMES` are reached through a virtual
FT232H, by the driver of that scheme.
"""

from __future__ import annotations

from contextlib import ExitStack
from typing import TYPE_CHECKING, Protocol

import pytest
import pytest_asyncio

import unity_link
from unity_link.drivers import load_driver, parse_url
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing
from unity_link.virtual.ft232h.board import GatewayBoard
from unity_link.virtual.ft232h.bus import VirtualBus, VirtualFt232h
from unity_link.virtual.ft232h.eeprom import build_eeprom
from unity_link.virtual.ft232h.pyusb_backend import installed
from unity_link.wire.gateway_info import GatewayInfo
from unity_link.wire.messages import ErrorCode

if TYPE_CHECKING:
    import asyncio
    from collections.abc import AsyncIterator, Iterable, Iterator

    from unity_link import Link
    from unity_link.virtual import Gateway

BUS_ERROR, BUS_TIMEOUT = 0xE0, 0xE8
"""Addresses of which every access fails, in gateways that `Maker` is asked to make with `failing`."""


class Maker(Protocol):
    """Makes gateways of one kind."""

    def __call__(self, info: GatewayInfo, *, failing: bool = False) -> Gateway: ...


def simulated(info: GatewayInfo, *, failing: bool = False) -> Gateway:
    gateway = VirtualGateway(info)
    if failing:
        gateway.attach(Failing(ErrorCode.BUS_ERROR), [BUS_ERROR])
        gateway.attach(Failing(ErrorCode.BUS_TIMEOUT), [BUS_TIMEOUT])
    return gateway


KINDS: dict[str, Maker] = {"sim": simulated, "ftdi": simulated, "ftdi-async": simulated}
SCHEMES = {"ftdi", "ftdi-async"}


@pytest.fixture(params=KINDS)
def make_gateway(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[Maker]:
    """Make gateways of each kind in turn."""
    with ExitStack() as stack:
        if request.param in SCHEMES:
            bus = stack.enter_context(installed(VirtualBus()))

            async def connect_through_chip(gateway: Gateway, protocol: asyncio.Protocol) -> asyncio.Transport:
                serial = f"S{len(bus.devices)}"
                bus.attach(VirtualFt232h(GatewayBoard(gateway), image=build_eeprom("FIFO", serial)))
                url = parse_url(f"{request.param}://ftdi:232h:{serial}/1")
                return await load_driver(url.scheme).connect(url, protocol)

            monkeypatch.setattr("unity_link.virtual.serving.connect_gateway", connect_through_chip)
        yield KINDS[request.param]


@pytest.fixture
def gateway(make_gateway: Maker) -> Gateway:
    """Give a gateway of the default configuration, with failing addresses."""
    return make_gateway(GatewayInfo(), failing=True)


@pytest_asyncio.fixture
async def link(gateway: Gateway) -> AsyncIterator[Link]:
    """Give an open link to `gateway`."""
    async with unity_link.connect(gateway) as link:
        yield link


def words(gateway: Gateway, addresses: Iterable[int]) -> list[int]:
    """Give what is in the memory behind a gateway."""
    return [gateway.memory[address] for address in addresses]

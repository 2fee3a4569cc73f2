"""The gateways that the tests of the link run on, each by its id.

`make_gateway` has every kind: `sim`, the model; `rtl`, the compiled gateware; and the model behind a virtual FT232H,
reached by the driver of a scheme in `SCHEMES`; `serve`, the model through a server that shares it; `zenoh`, the
same over a network; `pipes`, the model over a medium of the user's own; `mmio`, a bus that is mapped from a file, with
no gateway at all; and the faces, the model as blocking code and
code under trio see it. `make_bare` has those that can live on
simulated time, on which neither a thread of a driver can nor another process.
"""

from __future__ import annotations

from contextlib import ExitStack
from typing import TYPE_CHECKING

import pytest
import pytest_asyncio

import unity_link
from support import mapped_bus
from support.faces import EMPTY, FACES, face
from support.makers import RTL, Maker, compiled, simulated, with_failing
from support.over_pipes import connect_through_pipes
from support.over_zenoh import zenoh_network
from support.sharing import connect_through_server
from unity_link.transport import load_driver, parse_url
from unity_link.transport.ft232h.eeprom_image import build_eeprom
from unity_link.virtual.ft232h.board import GatewayBoard
from unity_link.virtual.ft232h.bus import VirtualBus, VirtualFt232h
from unity_link.virtual.ft232h.pyusb_backend import installed

if TYPE_CHECKING:
    import asyncio
    from collections.abc import AsyncIterator, Iterator

    from unity_link import Link
    from unity_link.virtual import BareGateway, Gateway

MAKERS: dict[str, Maker] = {"sim": simulated, "rtl": compiled}
SCHEMES = ("ftdi", "ftdi-async")
ON_SELDOM = {
    "test_a_gateway_without_the_feature_is_told_by_name",
    "test_a_long_block_is_split_at_the_gateways_limit",
    "test_every_request_works_at_every_width[rtl-9-13-2]",
    "test_every_request_works_at_every_width[rtl-64-32-3]",
    "test_so_it_is_where_the_receive_fifo_is_small_and_nothing_stops_the_host",
    "test_the_link_knows_its_gateway",
    "test_timestamps_are_used_where_the_gateway_can",
    "test_what_a_gateway_was_built_without_is_named_and_not_sent",
}
"""Tests whose compiled gateware is a build of `SELDOM`: on it they are for the campaign."""
WAY = "unity_link.virtual.gateway.Gateway.open"
"""Connection between a link and a gateway of this process."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Take the tests of a link's life from `serve`: that of the server's link is another one than its clients'.

    And from a face what that does not promise. Tests on builds that are seldom needed are for the campaign.
    """
    for item in items:
        if "rtl" in _kinds(item) and {item.name, item.name.partition("[")[0]} & ON_SELDOM:
            item.add_marker("campaign")
    items[:] = [
        item
        for item in items
        if not (item.path.name == "test_life.py" and {"serve", "zenoh"} & {*_kinds(item)})
        and not any((kind, item.name.partition("[")[0]) in EMPTY for kind in _kinds(item) if isinstance(kind, str))
        and not ("mmio" in _kinds(item) and item.name.partition("[")[0] in mapped_bus.EMPTY)
    ]


def _kinds(item: pytest.Item) -> list[object]:
    return (
        list(item.callspec.params.values()) if isinstance(item, pytest.Function) and hasattr(item, "callspec") else []
    )


@pytest.fixture(params=["sim", "serve", RTL])
def make_bare(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Maker:
    """Make gateways of each kind in turn, for simulated time."""
    if request.param == "serve":
        monkeypatch.setattr(WAY, connect_through_server)
    return MAKERS.get(request.param, simulated)


@pytest.fixture(params=["sim", "serve"])
def make_modelled(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Maker:
    """Make models, for simulated time and configurations that the gateware was not compiled with."""
    if request.param == "serve":
        monkeypatch.setattr(WAY, connect_through_server)
    return simulated


@pytest.fixture(params=["sim", RTL])
def make_direct(request: pytest.FixtureRequest) -> Maker:
    """Make gateways whose line is the link's own, for simulated time: elsewhere a server meets what happens to it."""
    return MAKERS[request.param]


@pytest.fixture(params=["sim", "serve", "zenoh", "pipes", "mmio", RTL, *SCHEMES, *FACES])
def make_gateway(
    request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Maker]:
    """Make gateways of each kind in turn, and have links to them go the way of the kind."""
    with ExitStack() as stack:
        if request.param in FACES:
            folder = tmp_path_factory.mktemp("face")
            monkeypatch.setattr(unity_link, "connect", stack.enter_context(face(request.param, folder)))
        if request.param in SCHEMES:
            bus = stack.enter_context(installed(VirtualBus()))

            async def connect_through_chip(gateway: Gateway, protocol: asyncio.Protocol) -> asyncio.Transport:
                serial = f"S{len(bus.devices)}"
                bus.attach(VirtualFt232h(GatewayBoard(gateway), image=build_eeprom("FIFO", serial)))
                url = parse_url(f"{request.param}://ftdi:232h:{serial}/1")
                return await load_driver(url.scheme).connect(url, protocol)

            monkeypatch.setattr(WAY, connect_through_chip)
        if request.param == "serve":
            monkeypatch.setattr(WAY, connect_through_server)
        if request.param == "pipes":
            monkeypatch.setattr(WAY, connect_through_pipes)
        if request.param == "zenoh":
            monkeypatch.setattr(WAY, stack.enter_context(zenoh_network()))
        if request.param == "mmio":
            make, connect = stack.enter_context(mapped_bus.mapped_files(tmp_path_factory.mktemp("mapped")))
            monkeypatch.setattr(unity_link, "connect", connect)
            yield make
            return
        yield MAKERS.get(request.param, simulated)


@pytest.fixture
def gateway(make_gateway: Maker) -> BareGateway:
    """Return a gateway of the default configuration, with failing addresses."""
    return with_failing(make_gateway())


@pytest_asyncio.fixture
async def link(gateway: Gateway) -> AsyncIterator[Link]:
    """Return an open link to `gateway`."""
    async with unity_link.connect(gateway) as link:
        yield link

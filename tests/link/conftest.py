"""The gateways that the tests of the link run on, each by its id.

`make_gateway` has every kind: `sim`, the model; `rtl`, the compiled gateware; the model behind a virtual FT232H, with
a driver for each of `SCHEMES`; `serve`, the model through a server that shares it; `zenoh`, the same over a network;
`pipes`, the model over a medium that a user wrote; `mmio`, a bus that is mapped from a file, without a gateway; and
the APIs of `FACES`, through which blocking code and code under trio use the model. `make_bare` has the kinds that run
on simulated time, which excludes threads of drivers and other processes.
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
    "test_the_error_for_a_missing_feature_names_it",
    "test_a_long_block_is_split_at_the_gateways_limit",
    "test_every_request_works_at_every_width[rtl-9-13-2]",
    "test_every_request_works_at_every_width[rtl-64-32-3]",
    "test_writes_are_executed_once_through_a_small_receive_fifo",
    "test_a_link_has_the_configuration_of_its_gateway",
    "test_timestamps_are_used_if_the_gateway_has_them",
    "test_a_request_for_a_missing_feature_raises_and_is_not_sent",
}
"""Tests whose gateway is built with `SELDOM`; on `rtl` they are marked `campaign`."""
WAY = "unity_link.virtual.gateway.Gateway.open"
"""Connection between a link and a gateway of this process."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Deselect tests that a kind of gateway cannot run, and mark tests on rarely needed builds as `campaign`.

    A link to `serve` or `zenoh` is not the link that loses and reopens the gateway's connection, so `test_life` is not
    run on them. An API or a mapped bus does not run the tests in its list `EMPTY`.
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
    """Return a maker of gateways of each kind in turn, for simulated time."""
    if request.param == "serve":
        monkeypatch.setattr(WAY, connect_through_server)
    return MAKERS.get(request.param, simulated)


@pytest.fixture(params=["sim", "serve"])
def make_modelled(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Maker:
    """Return a maker of models, for simulated time and for configurations that the gateware was not compiled with."""
    if request.param == "serve":
        monkeypatch.setattr(WAY, connect_through_server)
    return simulated


@pytest.fixture(params=["sim", RTL])
def make_direct(request: pytest.FixtureRequest) -> Maker:
    """Return a maker of gateways for simulated time, without a server: it would handle the faults of the line."""
    return MAKERS[request.param]


@pytest.fixture(params=["sim", "serve", "zenoh", "pipes", "mmio", RTL, *SCHEMES, *FACES])
def make_gateway(
    request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Maker]:
    """Return a maker of gateways of each kind in turn; links to them use the connection of that kind."""
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

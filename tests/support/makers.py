"""Factories of gateways, for tests that run on the model and on the compiled gateware.

The gateware is compiled in a few configurations only. A factory gets the fields that a test needs, and makes a gateway
that has them. `on_each_kind` is for a test with more configurations than were compiled.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

import pytest

from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Failing
from unity_link.virtual.rtl import RtlGateway, choose

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable, Sequence

    from unity_link.virtual import BareGateway

BUS_ERROR, BUS_TIMEOUT = 0xE0, 0xE8
"""Addresses at which every access fails, for a gateway that `with_failing` has changed."""
CRC_32 = {"crc_bits": 32, "crc_polynomial": 0x04C11DB7}
COMPACT = {"features": GatewayInfo().features | Feature.COMPACT, **CRC_32}
SHORT = {"id_digits": 2, "crc_bits": 8, "crc_polynomial": 0x07}
"""Fields for the shortest frames, those of the paper."""
SLOW = {"base_frequency_millihertz": 1_000_000}
"""Fields for samples at 1 kHz at most, as tests on simulated time use them."""
KINDS = ("sim", "rtl", "ftdi", "ftdi-async")
RTL = pytest.param("rtl", marks=pytest.mark.rtl)
SELDOM = {"bare_groups", "minimal", "odd", "uart", "wide"}
"""Builds for the campaign only: each takes half a minute to compile, and few tests need it."""


def build_params(names: Iterable[str]) -> list[object]:
    """Return the names of builds for a parametrised test; those in `SELDOM` get the mark `campaign`."""
    return [pytest.param(name, marks=[pytest.mark.campaign] if name in SELDOM else []) for name in names]


class Maker(Protocol):
    """Makes gateways of one kind, in the state after reset, with a bus of zeros."""

    def __call__(self, **fields: int) -> BareGateway:
        """Return a gateway whose `GatewayInfo` has these fields."""


def simulated(**fields: int) -> BareGateway:
    features = Feature(fields.pop("features", GatewayInfo().features))
    return VirtualGateway(GatewayInfo(**fields, features=features))


def compiled(**fields: int) -> BareGateway:
    return RtlGateway(choose(fields).name)


def in_flight(gateway: GatewayInfo) -> int:
    """Return how many requests with an ID may be in flight: half of the sequence space."""
    return 1 << 4 * gateway.id_digits - 1


def with_failing(gateway: BareGateway) -> BareGateway:
    """Let every access to `BUS_ERROR` and `BUS_TIMEOUT` fail; return the gateway."""
    gateway.detach([BUS_ERROR, BUS_TIMEOUT])
    gateway.attach(Failing(ErrorCode.BUS_ERROR), [BUS_ERROR])
    gateway.attach(Failing(ErrorCode.BUS_TIMEOUT), [BUS_TIMEOUT])
    return gateway


def on_each_kind(values: Sequence[dict[str, int]], compiled: Collection[int]) -> pytest.MarkDecorator:
    """Parametrise a test by `make_gateway` and `fields`.

    Args:
        values: the values of `fields`.
        compiled: indexes of those values that the gateware was compiled with.
    """
    cases = [
        pytest.param(kind, fields, marks=[pytest.mark.rtl] if kind == "rtl" else [], id=f"{kind}-{_text(fields)}")
        for kind in KINDS
        for place, fields in enumerate(values)
        if kind != "rtl" or place in compiled
    ]
    return pytest.mark.parametrize(("make_gateway", "fields"), cases, indirect=["make_gateway"])


def _text(fields: dict[str, int]) -> str:
    return "-".join(str(value) for value in fields.values())

"""Makers of gateways for tests that run on each kind of them: the model, and the compiled gateware.

The gateware has few configurations. A maker is told only the fields that a test needs, and gives a gateway that has
these; `on_each_kind` is for a test that needs more configurations than were compiled.
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
"""Addresses of which every access fails, in a gateway `with_failing`."""
CRC_32 = {"crc_bits": 32, "crc_polynomial": 0x04C11DB7}
COMPACT = {"features": GatewayInfo().features | Feature.COMPACT, **CRC_32}
SHORT = {"id_digits": 2, "crc_bits": 8, "crc_polynomial": 0x07}
"""The shortest frames, which are those of the paper."""
SLOW = {"base_frequency_millihertz": 1_000_000}
"""Samples at 1 kHz at most: what tests on simulated time run with."""
KINDS = ("sim", "rtl", "ftdi", "ftdi-async")
RTL = pytest.param("rtl", marks=pytest.mark.rtl)
SELDOM = {"bare_groups", "minimal", "odd", "uart", "wide"}
"""Builds that `make test-all` does not run: each takes half a minute to compile, and few tests need it."""


def build_params(names: Iterable[str]) -> list[object]:
    """Return the names of builds, for a parametrised test; on those of `SELDOM` it is for the campaign."""
    return [pytest.param(name, marks=[pytest.mark.campaign] if name in SELDOM else []) for name in names]


class Maker(Protocol):
    """Makes gateways of one kind, fresh from reset, with zeros in the memory behind them."""

    def __call__(self, **fields: int) -> BareGateway:
        """Make a gateway whose `GatewayInfo` has these fields."""


def simulated(**fields: int) -> BareGateway:
    features = Feature(fields.pop("features", GatewayInfo().features))
    return VirtualGateway(GatewayInfo(**fields, features=features))


def compiled(**fields: int) -> BareGateway:
    return RtlGateway(choose(fields).name)


def in_flight(gateway: GatewayInfo) -> int:
    """Return how many requests with an ID may be under way: half of all IDs."""
    return 1 << 4 * gateway.id_digits - 1


def with_failing(gateway: BareGateway) -> BareGateway:
    """Add a device by which every access of two addresses fails."""
    gateway.detach([BUS_ERROR, BUS_TIMEOUT])
    gateway.attach(Failing(ErrorCode.BUS_ERROR), [BUS_ERROR])
    gateway.attach(Failing(ErrorCode.BUS_TIMEOUT), [BUS_TIMEOUT])
    return gateway


def on_each_kind(values: Sequence[dict[str, int]], compiled: Collection[int]) -> pytest.MarkDecorator:
    """Parametrise a test by `make_gateway` and `fields`.

    Args:
        values: of `fields`.
        compiled: places in `values` of those that the gateware was compiled with.
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

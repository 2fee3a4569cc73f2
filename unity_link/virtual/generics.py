"""Converts between generics of the gateware and the configuration that a gateway reports."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from unity_link.protocol.wire.configuration import Feature, GatewayInfo

if TYPE_CHECKING:
    from collections.abc import Mapping

    from unity_link.spec import Interface

_BY_NUMBERS = Feature.GROUPS | Feature.ADDRESSED
FEATURES = {
    "triggers" if bit is Feature.EXTERNAL_TRIGGERS else name.lower(): bit
    for name, bit in Feature.__members__.items()
    if bit not in _BY_NUMBERS
}
"""Feature of each boolean generic; the generics `groups` and `node` select the other features."""
OPTIONAL = ("masked_write", "queue_commands", "timestamps", "triggers", "send_immediate")
"""Generics of optional features that are on by default and use logic."""
# These must agree with gateware/rtl/unity_link_fifo.vhd.
_DEFAULTS: dict[str, Any] = {
    **{generic: bit in GatewayInfo().features for generic, bit in FEATURES.items()},
    "groups": 16,
    "group_words": 32,
    "rx_fifo_depth": 256,
    "tx_fifo_depth": 256,
    "node": -1,
}


def generics_of(interface: Interface) -> dict[str, int]:
    """Return the generics of the gateway that `generate vhdl` makes for an interface."""
    from unity_link.generate.vhdl import gateway_generics

    given = {name: value for name, value in gateway_generics(interface).items() if isinstance(value, int)}
    identity = {"build_id": interface.fingerprint, "fingerprint": True, "description": interface.is_described}
    return {**given, **identity, "wb_pipelined": True}


def info_of(given: Mapping[str, int]) -> GatewayInfo:
    """Return the configuration that gateware with these generics reports; other generics have their defaults."""
    generics = {**_DEFAULTS, **given}
    features = Feature(0)
    for generic, feature in FEATURES.items():
        features |= feature if generics[generic] else Feature(0)
    features |= Feature.ADDRESSED if generics["node"] >= 0 else Feature(0)
    if generics["groups"]:
        features |= Feature.GROUPS
    else:
        features &= ~(Feature.EXTERNAL_TRIGGERS | Feature.TIMESTAMPS)
    fields = {field: generics[field] for field in GatewayInfo.__struct_fields__ if field in generics}
    return GatewayInfo(
        **{
            **fields,
            "features": features,
            "receive_fifo_bytes": generics["rx_fifo_depth"],
            "transmit_fifo_bytes": generics["tx_fifo_depth"],
        }
    )

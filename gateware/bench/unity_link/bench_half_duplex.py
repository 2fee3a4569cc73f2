"""Bench: a gateway on a half-duplex medium reports this, and sends only when it was asked."""

from __future__ import annotations

from typing import TYPE_CHECKING

import cocotb

from gateware.bench.unity_link.gateway import Gateway, checked
from unity_link.protocol.wire.configuration import Feature, GatewayInfo

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


@cocotb.test
async def its_configuration_has_the_bits_of_its_generics(dut: SimHandleBase) -> None:
    gateway = Gateway(dut)
    await gateway.begin()
    info = GatewayInfo.from_hex((await gateway.ask(b"Q")).removeprefix(b"Q"))
    features = {
        Feature.HALF_DUPLEX: dut.half_duplex,
        Feature.FINGERPRINT: dut.fingerprint,
        Feature.DESCRIPTION: dut.description,
    }
    assert [feature in info.features for feature in features] == [int(generic.value) for generic in features.values()]
    assert info.build_id == int(dut.build_id.value)


@cocotb.test
async def a_group_that_would_publish_by_itself_is_refused_and_a_response_is_the_last_that_is_sent(
    dut: SimHandleBase,
) -> None:
    gateway = Gateway(dut)
    await gateway.begin()
    if not int(dut.half_duplex.value):
        return
    for flags in (1, 2, 3, 0x11):
        assert await gateway.ask(b"GS00%02X0001010A" % flags) == b"X06"
    assert await gateway.ask(b"GS00100001010A") == b"GS00"
    assert await gateway.ask(b"GN00") == b"GN00"
    sample = checked(b"P000000000000")
    assert await gateway.answer(checked(b"GP00"), count=2) == sample + checked(b"GP00")
    dut.trigger.value = 1
    await gateway.quiet()
    assert gateway.take() == b""

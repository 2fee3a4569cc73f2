"""Hypothesis strategies for every configuration that a gateway may report."""

from __future__ import annotations

from hypothesis import strategies as st

from unity_link.protocol.wire.configuration import Feature, GatewayInfo


@st.composite
def gateway_infos(draw: st.DrawFn) -> GatewayInfo:
    """Return any configuration that the protocol allows."""
    crc_bits = draw(st.sampled_from([8, 16, 32]))
    features = Feature(draw(st.integers(0, 0xFFFF)))
    data_bits = draw(st.integers(8, 64))
    if -(-data_bits // 4) % 2:
        features &= ~Feature.COMPACT
    return GatewayInfo(
        data_bits=data_bits,
        address_bits=draw(st.integers(8, 32)),
        id_digits=draw(st.sampled_from([2, 3])),
        crc_bits=crc_bits,
        crc_polynomial=draw(st.integers(1, (1 << crc_bits) - 1)),
        block_words=draw(st.integers(1, 255)),
        groups=draw(st.integers(0, 256)),
        group_words=draw(st.integers(0, 255)),
        base_frequency_millihertz=draw(st.integers(int(Feature.GROUPS in features), 16**10 - 1)),
        clock_hz=draw(st.integers(1, 16**8 - 1)),
        receive_fifo_bytes=draw(st.integers(0, 0xFFFF)),
        transmit_fifo_bytes=draw(st.integers(0, 0xFFFF)),
        features=features,
        build_id=draw(st.integers(0, 0xFFFFFFFF)),
    )

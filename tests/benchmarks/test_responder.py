"""The responder of the benchmarks: a gateway in C with any field widths."""

from __future__ import annotations

import asyncio

import msgspec
import pytest

import unity_link
from benchmarks.responder import GATEWAY, LOOPBACK, exchange, responder
from support.compilers import needs_c
from unity_link.protocol.wire.configuration import Feature

pytestmark = needs_c
WIDTHS = [
    GATEWAY,
    msgspec.structs.replace(GATEWAY, id_digits=2, crc_bits=8, crc_polynomial=0x07),
    msgspec.structs.replace(GATEWAY, address_bits=13, crc_bits=32, crc_polynomial=0x04C11DB7),
]

STUFFED = 0xB5CAD30A
"""Word whose bytes the compact form must escape."""


async def work(url: str, info: unity_link.GatewayInfo) -> None:
    async with unity_link.connect(url, timeout=60) as link:
        assert link.gateway == info
        assert await link.read(0x0B) == 0x0B0B0B0B
        await link.write_block(0x10, [1, STUFFED, 3])
        assert (await link.read_many([0x11, 0x12, 0x13])).tolist() == [STUFFED, 3, 0x13131313]
        assert (await link.read_block(0, 256)).tolist()[0x12:] == [3, *(n * 0x01010101 for n in range(0x13, 256))]
        async with link.subscribe([0x10, 0x11], divisor=1, timestamps=False) as samples:
            assert (await anext(samples)).values.tolist() == [1, STUFFED]
        assert link.statistics.damaged_frames == 0


@pytest.mark.parametrize("form", [Feature(0), Feature.COMPACT], ids=["text", "compact"])
@pytest.mark.parametrize("info", WIDTHS, ids=["usual", "short", "long"])
def test_responder_answers_a_link_with_the_given_widths(info: unity_link.GatewayInfo, form: Feature) -> None:
    info = msgspec.structs.replace(info, features=info.features | form)
    with responder(info) as path:
        asyncio.run(work(f"serial:{path}", info))


@pytest.mark.parametrize("medium", ["tcp", "udp"])
def test_it_answers_one_link_after_the_other_over_a_network(medium: str) -> None:
    with responder(medium=medium) as port:
        asyncio.run(work(f"{medium}://{LOOPBACK}:{port}", GATEWAY))
        asyncio.run(read_once_more(f"{medium}://{LOOPBACK}:{port}"))


async def read_once_more(url: str) -> None:
    async with unity_link.connect(url, timeout=60) as link:
        assert await link.read(0x11) == STUFFED


@pytest.mark.parametrize("info", WIDTHS, ids=["usual", "short", "long"])
def test_bare_loop_gets_the_bytes_of_the_responder(info: unity_link.GatewayInfo) -> None:
    async def work(path: str) -> bytes:
        loop = asyncio.get_running_loop()
        reader = asyncio.StreamReader()
        with open(path, "r+b", buffering=0) as port:  # noqa: ASYNC230, PTH123  (a pseudo-terminal)
            transport, _ = await loop.connect_read_pipe(lambda: asyncio.StreamReaderProtocol(reader), port)
            port.write(request)
            found = await reader.readexactly(len(response))
            transport.close()
            return found

    request, response = exchange(info, "RM", 0x0A, 2, reads=[0x0A0A0A0A, 0x0B0B0B0B])
    with responder(info) as path:
        assert asyncio.run(work(path)) == response

"""Links over networks that silently drop packets above a length, by real sockets."""

from __future__ import annotations

import asyncio

import pytest
from anyio.from_thread import start_blocking_portal

import unity_link
from gateware.bench.network.tap import own_network, run_ip
from support.short_paths import short_path
from unity_link import ArgumentError, UnsupportedError, blocking
from unity_link.bridges.serve.shared import SharedLink
from unity_link.link.asked import Asked, most_words
from unity_link.protocol.wire.path import HEADERS, LENGTHS
from unity_link.transport import parse_url

WORDS = [*range(500)]


async def use(link: unity_link.Link) -> None:
    """Transfer blocks and single words."""
    await link.write_block(0, WORDS)
    assert (await link.read_block(0, len(WORDS))).tolist() == WORDS
    await link.write_many(WORDS, WORDS[::-1])
    assert (await link.read_many(WORDS)).tolist() == WORDS[::-1]
    words = asyncio.gather(*map(link.read, range(60)))
    blocks = await asyncio.gather(*(link.read_block(0, count) for count in range(1, 60)))
    assert [len(block) for block in blocks] == [*range(1, 60)]
    assert await words == WORDS[:-61:-1]


@pytest.mark.asyncio
@pytest.mark.parametrize(("mtu", "tried"), [(1500, 0), (1280, 2), (576, 4)])
async def test_a_link_finds_the_longest_packet_without_a_loss(mtu: int, tried: int) -> None:
    async with short_path(mtu) as (url, towards, back), unity_link.connect(url) as link:
        assert len(towards.dropped) == tried
        await use(link)
        assert len(towards.dropped) == tried
        assert not back.dropped or link.statistics.repetitions
        if not tried:
            assert max(towards.passed) == LENGTHS[0] + HEADERS


@pytest.mark.asyncio
@pytest.mark.parametrize("mtu", [576, 700, 1300])
async def test_packets_of_both_directions_keep_to_the_mtu_of_the_url(mtu: int) -> None:
    async with short_path(1500) as (url, towards, back), unity_link.connect(f"{url}?mtu={mtu}") as link:
        await use(link)
        assert max(towards.passed) == mtu
        # The answers to retransmitted requests arrive in one datagram with the first answers.
        assert mtu - 200 < max(back.passed)
        assert max(back.passed) <= mtu or link.statistics.repetitions


def test_blocking_code_finds_the_longest_packet() -> None:
    with (
        start_blocking_portal() as portal,
        portal.wrap_async_context_manager(short_path(576)) as (url, *_),
        blocking.connect(url) as link,
    ):
        link.write_block(0, WORDS)
        assert link.read_block(0, len(WORDS)).tolist() == WORDS


@pytest.mark.parametrize("mtu", ["575", "1501", "0", "-1", "long"])
def test_an_mtu_that_no_network_has_is_refused(mtu: str) -> None:
    with pytest.raises(ArgumentError, match=rf"^mtu={mtu} in udp://127.0.0.1:7001\?mtu={mtu} is not "):
        blocking.connect(f"udp://127.0.0.1:7001?mtu={mtu}")


@pytest.mark.asyncio
async def test_a_group_is_refused_if_its_samples_are_longer_than_a_packet() -> None:
    async with short_path(576) as (url, *_), unity_link.connect(f"{url}?mtu=576") as link:
        message = r"group 0 has frames of \d+ bytes, .* frames of 516 bytes at most \(mtu=576\): subscribe to fewer"
        with pytest.raises(UnsupportedError, match=message):
            async with link.subscribe(range(70), rate_hz=100):
                pass
        async with link.subscribe(range(60), rate_hz=100) as samples:
            assert len((await anext(samples)).values) == 60
            assert (await link.read_block(0, len(WORDS))).tolist() == [0] * len(WORDS)


@pytest.mark.asyncio
async def test_one_request_of_a_core_is_no_longer_than_a_packet() -> None:
    async with short_path(576) as (url, *_), unity_link.connect(url) as link:
        asked = Asked(link, 0, most_words(link)), Asked(link, 0, write=[1] * most_words(link))
        assert len(await asked[0].words()) == most_words(link) == 62
        await asked[1].words()


@pytest.mark.asyncio
async def test_a_server_reports_the_longest_block_to_its_clients() -> None:
    async with short_path(576) as (url, *_):
        shared = SharedLink(parse_url(url), lambda _: None)
        await shared.open(5)
        assert shared.codec is not None
        assert shared.codec.info.block_words == 62
        await shared.finish()


@pytest.mark.asyncio
@pytest.mark.slow
async def test_a_reconnecting_link_finds_that_the_path_back_carries_less() -> None:
    async with short_path(1500) as (url, towards, back), unity_link.connect(url, reconnect=True) as link:
        back.mtu = 1280
        with pytest.raises(UnsupportedError, match=r"1200 bytes at most \(mtu=1260\): ask for it again"):
            await link.read_block(0, 169)
        await use(link)
        back.mtu = towards.mtu = 576
        with pytest.raises(UnsupportedError, match=r"516 bytes at most \(mtu=576\): ask for it again"):
            await link.read_block(0, 140)
        await use(link)


@pytest.mark.asyncio
@pytest.mark.slow
async def test_the_error_of_a_link_whose_long_packets_are_lost_names_mtu() -> None:
    async with short_path(1500) as (url, towards, _), unity_link.connect(url) as link:
        towards.mtu = 576
        with pytest.raises(unity_link.LinkLostError, match=r"loses long packets, mtu=576 in the URL"):
            await link.write_block(0, WORDS)


def test_the_mtu_that_the_system_has_for_a_route_is_used_without_a_trial() -> None:
    async def check() -> None:
        async with short_path(1500) as (url, towards, _):
            async with unity_link.connect(url) as link:
                assert most_words(link) == 65
                await use(link)
            assert max(towards.passed) == 600

    with own_network():
        run_ip("route", "replace", "local", "127.0.0.1", "dev", "lo", "table", "local", "mtu", "600")
        asyncio.run(check())

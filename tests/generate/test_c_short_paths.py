"""The client in C on networks that carry only short packets."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

import pytest

from generate.programs import Driven
from support.short_paths import short_path

if TYPE_CHECKING:
    from pathlib import Path

WORDS = [*range(500)]


@pytest.mark.asyncio
@pytest.mark.parametrize(
    ("mtu", "options", "tried"), [(1500, "", 0), (1280, "", 2), (576, "", 4), (576, "?mtu=576", 0)]
)
async def test_the_client_in_c_finds_how_long_packets_may_be(driver: Path, mtu: int, options: str, tried: int) -> None:
    def in_words(numbers: list[int]) -> str:
        return " ".join(f"{number:X}" for number in numbers)

    def drive(url: str) -> None:
        with Driven(driver) as client:
            client.words(f"connect {url}{options} 5")
            client.words(f"wblock 0 {in_words(WORDS)}")
            assert client.words(f"rblock 0 {len(WORDS):X}") == WORDS
            assert len(towards.dropped) == tried
            # The answers to retransmissions come in one datagram with the first answers.
            assert not back.dropped or client.words("statistics")[2]
            group = client(f"subscribe 0 100 - {in_words([*range(100)])}")
            assert group == "0" if mtu > 576 else group.startswith("38 ") and "packets of the network (mtu=)" in group
            client.words(f"subscribe 1 100 - {in_words([*range(40)])}")
            assert client("next 1 5").split()[4:] == [str(word) for word in WORDS[:40]]
            client.words("close")

    async with short_path(mtu) as (url, towards, back):
        await asyncio.to_thread(drive, url)
        if options:
            assert 500 < max(towards.passed) <= 576


def test_the_client_in_c_refuses_an_mtu_that_no_network_has(driver: Path) -> None:
    with Driven(driver) as client:
        for mtu in ("575", "1501", "long"):
            answer = client(f"connect udp://127.0.0.1:7001?mtu={mtu} 1")
            assert answer.startswith(f"38 'mtu={mtu}' is no option of this URL: "), answer

"""A group is used again while the line is full: no sample of its previous use is delivered."""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING

import unity_link
from support.makers import SLOW, Maker
from support.simulated_time import on_simulated_time
from unity_link.virtual.line import SlowLine
from unity_link.virtual.rtl import RtlGateway

if TYPE_CHECKING:
    from unity_link.virtual import BareGateway, Gateway

GROUPS, WORDS = 4, 32
LIVES = 12
BYTES_PER_SECOND = 50_000
"""A fifth of the bytes per second that a group of `WORDS` words publishes at 1 kHz."""


def full_line(gateway: BareGateway) -> Gateway:
    """Put a slow line before the model; the gateware, compiled with a clock of 50 kHz, sends only a byte per cycle."""
    if isinstance(gateway, RtlGateway):
        assert gateway.info.clock_hz == BYTES_PER_SECOND
        return gateway
    return SlowLine(gateway, BYTES_PER_SECOND)


def addresses_of(life: int) -> range:
    first = life % 3 * WORDS
    return range(first, first + WORDS)


@on_simulated_time
async def test_a_reused_group_on_a_full_line_delivers_no_old_sample(make_bare: Maker) -> None:
    gateway = make_bare(**SLOW, groups=GROUPS, group_words=WORDS)
    for address in range(3 * WORDS):
        gateway.memory[address] = 0x5A00 | address
    async with unity_link.connect(full_line(gateway), timeout=60) as link, contextlib.AsyncExitStack() as others:
        for _ in range(GROUPS - 1):
            await others.enter_async_context(link.subscribe([0], rate_hz=10))
        for life in range(LIVES):
            async with link.subscribe(addresses_of(life), divisor=1, timestamps=False) as samples:
                for _ in range(20):
                    sample = await anext(samples)
                    assert sample.values.tolist() == [0x5A00 | address for address in addresses_of(life)]
                assert samples.lost > 0

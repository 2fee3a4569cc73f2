"""How soon a link gets over damage: by what arrives, and seldom by waiting. Simulated time passes in waiting alone."""

from __future__ import annotations

import asyncio

import pytest

import unity_link
from simulated_time import on_simulated_time, run_simulated


@pytest.mark.parametrize("seed", [1, 2, 3])
@on_simulated_time
async def test_a_batch_on_a_line_that_damages_one_byte_in_a_hundred_hardly_waits(seed: int) -> None:
    async with unity_link.connect(f"sim:?flip=0.01&seed={seed}", timeout=60) as link:
        start = asyncio.get_running_loop().time()
        await link.read_many(range(256))
        await link.read_many([1] * 3000)
        assert link.statistics.timeouts <= 2
        assert asyncio.get_running_loop().time() - start < 0.1


@pytest.mark.parametrize(("flip", "most"), [(0.001, 0.02), (0.01, 0.25)])
@on_simulated_time
async def test_lone_reads_wait_only_for_damage_that_gives_no_sign(flip: float, most: float) -> None:
    async with unity_link.connect(f"sim:?flip={flip}&seed=1", timeout=60) as link:
        start = asyncio.get_running_loop().time()
        for _ in range(500):
            await link.read(1)
        assert asyncio.get_running_loop().time() - start < most


def test_a_link_is_opened_on_a_line_that_damages_one_byte_in_twenty() -> None:
    async def open_link(seed: int) -> None:
        async with unity_link.connect(f"sim:?flip=0.05&seed={seed}"):
            pass

    for seed in range(20):
        run_simulated(open_link(seed))

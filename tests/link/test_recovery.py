"""Recovery of a link from damage: by what arrives, and seldom by waiting. Simulated time passes in waiting alone."""

from __future__ import annotations

import asyncio

import pytest

import unity_link
from support.simulated_time import on_simulated_time, run_simulated
from support.valve import Valve
from unity_link.virtual import Gateway, VirtualGateway
from unity_link.virtual.faults import Failing


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


class DamagingEnds(Valve):
    """Damages a byte of the next request or its end, or the end of the next answer, where that is wanted."""

    def __init__(self, gateway: Gateway) -> None:
        super().__init__(gateway)
        self.requests = self.request_ends = self.answers = False

    def receive(self, data: bytes, now: float) -> bytes:
        if self.request_ends:
            self.request_ends, data = False, data.replace(b"\n", b"\x0b", 1)
        if self.requests:
            self.requests, data = False, b"?" + data[1:]
        answer = super().receive(data, now)
        if self.answers and answer:
            self.answers, answer = False, answer[:-1] + b"\x0b"
        return answer


@pytest.mark.parametrize("wanted", ["read", "write", "block", "error", "damaged request"])
@on_simulated_time
async def test_a_lone_answer_whose_end_is_damaged_costs_no_time_out(wanted: str) -> None:
    line = DamagingEnds(gateway := VirtualGateway())
    gateway.attach(Failing(), [0xF0])
    async with unity_link.connect(line) as link:
        line.answers, line.requests = True, wanted == "damaged request"
        start = asyncio.get_running_loop().time()
        if wanted == "write":
            await link.write(1, 5)
        elif wanted == "block":
            await link.read_block(1, 20)
        elif wanted == "error":
            with pytest.raises(unity_link.BusTimeoutError):
                await link.read(0xF0)
        else:
            await link.read(1)
        assert asyncio.get_running_loop().time() == start
        assert (link.statistics.timeouts, link.statistics.damaged_frames) == (0, 1)


@on_simulated_time
async def test_a_lone_request_whose_end_is_damaged_costs_no_time_out_on_a_line_that_loses() -> None:
    line = DamagingEnds(VirtualGateway())
    async with unity_link.connect(line) as link:
        line.requests = True
        await link.read(1)
        start = asyncio.get_running_loop().time()
        line.request_ends = True
        await link.read(1)
        assert asyncio.get_running_loop().time() == start

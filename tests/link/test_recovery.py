"""A link recovers from damage by the frames that arrive, and rarely by waiting. Only waiting takes simulated time."""

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
async def test_a_batch_on_a_line_with_1_percent_damage_rarely_waits(seed: int) -> None:
    async with unity_link.connect(f"sim:?flip=0.01&seed={seed}", timeout=60) as link:
        start = asyncio.get_running_loop().time()
        await link.read_many(range(256))
        await link.read_many([1] * 3000)
        assert link.statistics.timeouts <= 2
        assert asyncio.get_running_loop().time() - start < 0.1


@pytest.mark.parametrize(("flip", "most"), [(0.001, 0.02), (0.01, 0.25)])
@on_simulated_time
async def test_single_reads_wait_only_for_damage_without_a_sign_of_loss(flip: float, most: float) -> None:
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
    """Damages a byte of the next request, the end of the next request, or the end of the next answer, as requested."""

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
async def test_a_damaged_end_of_a_single_answer_causes_no_time_out(wanted: str) -> None:
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
async def test_a_damaged_end_of_a_single_request_causes_no_time_out() -> None:
    line = DamagingEnds(VirtualGateway())
    async with unity_link.connect(line) as link:
        line.requests = True
        await link.read(1)
        start = asyncio.get_running_loop().time()
        line.request_ends = True
        await link.read(1)
        assert asyncio.get_running_loop().time() == start

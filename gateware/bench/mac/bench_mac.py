"""Bench: valid frames on the line are output with a good status, and no others."""

from __future__ import annotations

import os
import random
from typing import TYPE_CHECKING

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, RisingEdge
from cocotb.utils import get_sim_time

from gateware.bench.ethernet import Phy, Sent, with_check
from gateware.bench.streams import Source

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

_INTERFACE = os.environ["INTERFACE"]
_LANES = 2 if _INTERFACE == "rmii" else 4
_PERIOD_NS = float(os.environ["PERIOD_NS"])


class Bench:
    """The MAC between a PHY and a core that accepts all bytes at once."""

    def __init__(self, dut: SimHandleBase) -> None:
        self.frames: list[tuple[bytes, bool]] = []
        """Frames received, each with its status."""
        self._dut = dut
        self._phy: Phy | None = None

    async def begin(self) -> Phy:
        self._dut.rx_ready.value = 1
        self._dut.tx_valid.value = self._dut.tx_last.value = self._dut.tx_data.value = 0
        phy = Phy(self._dut, _INTERFACE, timed=True)
        # The PHY's clocks are slower, and their domains must be reset, too, before the checks begin.
        self._dut.rst.value = 1
        cocotb.start_soon(Clock(self._dut.clk, round(_PERIOD_NS * 1000), unit="ps").start())
        await ClockCycles(self._dut.clk, 40)
        self._dut.rst.value = 0
        # `runner` searches for this message.
        cocotb.log.info("reset ended at %d ps", get_sim_time("ps"))
        await ClockCycles(self._dut.clk, 60)
        cocotb.start_soon(self._collect())
        return phy

    async def _collect(self) -> None:
        data = bytearray()
        while True:
            await RisingEdge(self._dut.clk)
            if self._dut.rx_valid.value == 1 and self._dut.rx_ready.value == 1:
                if self._dut.rx_end.value == 1:
                    self.frames.append((bytes(data), bool(int(self._dut.rx_data.value) & 1)))
                    data.clear()
                else:
                    data.append(int(self._dut.rx_data.value))

    async def settle(self) -> list[tuple[bytes, bool]]:
        """Return the frames received since the last call, when all have arrived."""
        await ClockCycles(self._dut.clk, 200)
        found, self.frames[:] = list(self.frames), []
        return found


def _body(rng: random.Random, most: int = 200) -> bytes:
    return rng.randbytes(rng.choice((60, 61, 64, rng.randrange(60, most))))


def _damaged(frame: bytes, rng: random.Random) -> bytes:
    damaged = bytearray(frame)
    damaged[rng.randrange(len(frame))] ^= 1 << rng.randrange(8)
    return bytes(damaged)


@cocotb.test
async def frames_come_in_whatever_their_preamble_is(dut: SimHandleBase) -> None:
    bench, rng = Bench(dut), random.Random(1)
    phy = await bench.begin()
    bodies = [_body(rng, 120) for _ in range(20)]
    for body in bodies:
        data = with_check(body)
        few = rng.choice((None, rng.randrange(40)))
        await phy.send(
            Sent(data, few, rng.randrange(5) if few is None else 0, rng.choice((0, 0, 1)) if _LANES == 4 else 0)
        )
    assert await bench.settle() == [(with_check(body), True) for body in bodies]


@cocotb.test
async def the_shortest_and_the_longest_come_in_side_by_side(dut: SimHandleBase) -> None:
    bench, rng = Bench(dut), random.Random(2)
    phy = await bench.begin()
    bodies = [rng.randbytes(size) for size in (60, 1514, 60)]
    await phy.send(*bodies)
    assert await bench.settle() == [(with_check(body), True) for body in bodies]


@cocotb.test
async def what_is_wrong_is_told_so_and_the_next_frame_comes(dut: SimHandleBase) -> None:
    bench, rng = Bench(dut), random.Random(3)
    phy = await bench.begin()
    for _ in range(4):
        body = _body(rng)
        good = with_check(body)
        wrong = [
            Sent(_damaged(good, rng)),
            Sent(good[: rng.randrange(1, len(good))]),
            Sent(with_check(body)[: rng.randrange(64)]),
            Sent(good, error_at=rng.randrange(len(good) * 8 // _LANES)),
            Sent(with_check(rng.randbytes(1515 + rng.randrange(3))), gap=24),
            Sent(good, delimited=False),
        ]
        rng.shuffle(wrong)
        await phy.send(*wrong[:3], body, *wrong[3:], body)
        found = await bench.settle()
        assert [data for data, right in found if right] == [good, good]
        # Data without a delimiter in front of it may contain a delimiter.
        assert len(found) >= 6


@cocotb.test
async def a_line_that_never_ends_is_passed_over(dut: SimHandleBase) -> None:
    bench, rng = Bench(dut), random.Random(4)
    phy = await bench.begin()
    await phy.send(Sent(rng.randbytes(2000)), body := rng.randbytes(70))
    found = await bench.settle()
    assert [right for _, right in found] == [False, True]
    assert len(found[0][0]) == 1519
    assert found[1][0] == with_check(body)


@cocotb.test
async def a_frame_of_which_a_byte_is_lost_is_bad(dut: SimHandleBase) -> None:
    bench, rng = Bench(dut), random.Random(5)
    phy = await bench.begin()
    dut.rx_ready.value = 0
    await phy.send(rng.randbytes(100), rng.randbytes(100))
    dut.rx_ready.value = 1
    await bench.settle()
    await phy.send(body := rng.randbytes(100))
    assert [found for found in await bench.settle() if found[1]] == [(with_check(body), True)]


@cocotb.test
async def frames_go_out_padded_checked_and_apart(dut: SimHandleBase) -> None:
    bench, rng = Bench(dut), random.Random(6)
    phy = await bench.begin()
    source = Source(dut.clk, dut.tx_data, dut.tx_valid, dut.tx_ready)
    bodies = [rng.randbytes(size) for size in (1, 42, 59, 60, 61, 300, 1514)]
    for body in bodies:
        dut.tx_last.value = 0
        await source.send(body[:-1])
        dut.tx_last.value = 1
        await source.send(body[-1:])
    await phy.wait_for(len(bodies))
    assert phy.received == [body.ljust(60, b"\0") for body in bodies]
    assert not phy.spoilt


@cocotb.test
async def a_frame_whose_bytes_stop_is_spoilt_and_the_next_one_goes(dut: SimHandleBase) -> None:
    bench = Bench(dut)
    phy = await bench.begin()
    source = Source(dut.clk, dut.tx_data, dut.tx_valid, dut.tx_ready)
    await source.send(bytes(range(30)))
    await phy.wait_for(1)
    assert phy.spoilt
    await source.send(bytes(50))
    dut.tx_last.value = 1
    await source.send([0])
    dut.tx_last.value = 0
    await source.send(bytes(range(69)))
    dut.tx_last.value = 1
    await source.send([69])
    assert (await phy.wait_for(2))[1] == bytes(range(70))
    assert not phy.spoilt


@cocotb.test
async def a_reset_in_the_middle_of_traffic_leaves_nothing(dut: SimHandleBase) -> None:
    bench, rng = Bench(dut), random.Random(8)
    phy = await bench.begin()
    cocotb.start_soon(phy.send(*[rng.randbytes(200) for _ in range(3)]))
    await ClockCycles(dut.clk, 1000)
    dut.rst.value = 1
    await ClockCycles(dut.clk, 1)
    dut.rst.value = 0
    await phy.send(body := rng.randbytes(100))
    found = await bench.settle()
    assert found[-1] == (with_check(body), True)

"""Bench: requests, their errors, the bus, send-immediate and the reset, at the FIFO port.

The shared vectors have the answers to requests byte for byte; this bench tests what they do not contain: bus, time,
loss.
"""

from __future__ import annotations

import random
from collections import deque
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ReadOnly, RisingEdge

from gateware.bench.unity_link.gateway import SESSION, Gateway, checked, opening, with_id

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

BUS_TIMEOUT = 64
BASE_TICK = 500


async def _gateway(dut: SimHandleBase, **pauses: float) -> Gateway:
    gateway = Gateway(dut, **pauses)
    await gateway.begin()
    return gateway


async def _in_session(dut: SimHandleBase) -> Gateway:
    gateway = Gateway(dut)
    await gateway.begin(session=True)
    return gateway


class BusMonitor:
    """Records the accesses (whether each writes, its address and word), and their number while `cyc` was '1'."""

    def __init__(self, dut: SimHandleBase) -> None:
        self.accesses: list[tuple[bool, int, int]] = []
        self.transactions: list[int] = []
        """Number of accesses in each period with `cyc` = '1'."""
        self.longest_strobe = 0
        self._dut = dut
        cocotb.start_soon(self._run())

    async def _run(self) -> None:
        dut = self._dut
        open_for, strobe = 0, 0
        pipelined = dut.wb_pipelined.value == 1
        taken: deque[int] = deque()
        while True:
            await RisingEdge(dut.clk)
            if dut.wb_cyc.value == 0:
                taken.clear()
                if open_for:
                    self.transactions.append(open_for)
                open_for = 0
            strobe = strobe + 1 if dut.wb_stb.value == 1 else 0
            self.longest_strobe = max(self.longest_strobe, strobe)
            if dut.wb_ack.value == 1 or dut.wb_err.value == 1:
                open_for += 1
                writes = dut.wb_we.value == 1
                word = dut.wb_dat_o.value if writes else dut.wb_dat_i.value
                self.accesses.append((writes, taken.popleft() if pipelined else int(dut.wb_adr.value), int(word)))
            if pipelined and dut.wb_stb.value == 1 and dut.wb_stall.value == 0:
                taken.append(int(dut.wb_adr.value))


@cocotb.test
async def the_worked_examples_of_the_protocol_hold(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    await gateway.ask(b"W0A00000012")
    for sent, answered in (
        (b"R0A6DDE\n", b"R0A000000125DF0\n"),
        (b"W0A00000012D4FE\n", b"W0A862E\n"),
        (b"r0000A760E\n", b"x0000A000030A6\n"),
        (b"K00012348D19\n", b"K00012340000E3C6\n"),
        (b"r0000A5E56\n", b"r000000000122652\n"),
        (b"w0010A0000002AAE27\n", b"w0010D5F\n"),
        (b"KF9AF\n", b"K12342A1E\n"),
        (b"R0A\r", b"R0A0000002A\r\n"),
        (b"R0A0000\n", b"X01D488\n"),
    ):
        assert await gateway.answer(sent) == answered


@cocotb.test
async def no_output_is_undefined_after_a_reset(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    names = ("in_ready", "out_data", "out_valid", "out_flush", "wb_cyc", "wb_stb", "wb_we", "wb_adr", "wb_dat_o")
    gateway.send(checked(b"W0512345678") + checked(b"R05"))
    for _ in range(80):
        await ReadOnly()
        for name in names:
            if name != "out_data" or dut.out_valid.value == 1:
                assert getattr(dut, name).value.is_resolvable, name
        await RisingEdge(dut.clk)


@cocotb.test
async def empty_frames_and_double_ends_are_ignored(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    gateway.send(b"\n\r\r\n\n\nH\r\n\nH\r\r")
    await gateway.quiet()
    assert gateway.take() == b"H\r\nH\r\n"


@cocotb.test
async def a_frame_that_lost_bytes_is_answered_by_error_09(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    overflow = checked(b"X09")
    good = checked(b"R0A")
    for index in range(len(good)):
        gateway.send(good, lost_before=index)
        await gateway.quiet(100)
        assert gateway.take() == overflow, index
    gateway.send(b"R0A\r", lost_before=2)
    await gateway.quiet(100)
    assert gateway.take() == b"X09\r\n"
    # Only the end arrived.
    gateway.send(b"\n", lost_before=0)
    await gateway.quiet(100)
    assert gateway.take() == overflow
    # With priority over all other errors: the frame is too long and damaged as well.
    gateway.send(b"Z" * 2500 + b"\n", lost_before=7)
    await gateway.quiet(100)
    assert gateway.take() == overflow
    assert (await gateway.ask(b"W0A00000001")) == b"W0A"


@cocotb.test
async def a_silent_bus_gives_error_05_after_the_time_out_and_the_next_request_works(dut: SimHandleBase) -> None:
    gateway = await _in_session(dut)
    monitor = BusMonitor(dut)
    for body, answer in (
        (b"RE8", b"X05"),
        (with_id(b"r", 0, b"E8"), with_id(b"x", 0, b"05")),
        (b"WE800000001", b"X05"),
        (b"RME502", b"RME5020000000000000000"),
        (b"RME504", b"X05"),
        (b"WKE8FFFFFFFF00000001", b"X05"),
    ):
        assert await gateway.ask(body) == answer, body
        await gateway.ask(b"W0A%08X" % 77)
        assert await gateway.ask(b"R0A") == b"R0A%08X" % 77
    if dut.wb_pipelined.value == 0:
        assert monitor.longest_strobe == BUS_TIMEOUT


@cocotb.test
async def a_bus_error_gives_error_04_and_what_was_done_stays_done(dut: SimHandleBase) -> None:
    gateway = await _in_session(dut)
    assert await gateway.ask(b"WMDE%08X%08X%08X%08X" % (1, 2, 3, 4)) == b"X04"
    assert await gateway.ask(b"RMDE02") == b"RMDE02%08X%08X" % (1, 2)
    assert await gateway.ask(b"RE1") == b"RE1%08X" % 0
    assert await gateway.ask(b"RMDE03") == b"X04"
    assert await gateway.ask(b"WQE0%08X" % 1) == b"X04"
    assert await gateway.ask(with_id(b"r", 0, b"DE")) == with_id(b"r", 0, b"%08X" % 1)
    assert await gateway.ask(with_id(b"r", 1, b"E0")) == with_id(b"x", 1, b"04")
    assert await gateway.ask(with_id(b"h", 2)) == with_id(b"h", 2, b"000")


@cocotb.test
async def blocks_and_masked_writes_are_one_transaction_on_the_bus(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    monitor = BusMonitor(dut)
    for wait_states in (0, 3):
        dut.wait_states.value = wait_states
        for body, count in (
            (b"WM40%08X%08X%08X" % (1, 2, 3), 3),
            (b"RM4003", 3),
            (b"WK400000FFFF12345678", 2),
            (b"R40", 1),
        ):
            del monitor.transactions[:]
            await gateway.ask(body)
            await gateway.cycles(5)
            assert monitor.transactions == [count], body
    assert await gateway.ask(b"R40") == b"R4000005678"


@cocotb.test
async def blocks_wrap_at_the_end_of_the_address_space_and_queues_stay(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    monitor = BusMonitor(dut)
    await gateway.ask(b"WMFE%08X%08X%08X" % (1, 2, 3))
    await gateway.ask(b"WQ20%08X%08X" % (4, 5))
    await gateway.ask(b"RQ2002")
    await gateway.ask(b"RMFE03")
    assert monitor.accesses == [
        *((True, address, word) for address, word in ((0xFE, 1), (0xFF, 2), (0x00, 3), (0x20, 4), (0x20, 5))),
        *((False, address, word) for address, word in ((0x20, 5), (0x20, 5), (0xFE, 1), (0xFF, 2), (0x00, 3))),
    ]


@cocotb.test
async def nothing_is_executed_before_the_frame_was_checked(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    monitor = BusMonitor(dut)
    for body in (b"W0A00000012", b"WM20000000010000000200000003", b"WS0A00000012"):
        good = checked(body)
        assert await gateway.answer(good[:-2] + bytes([good[-2] ^ 1]) + b"\n") == checked(b"X01")
    assert monitor.accesses == []
    gateway.send(b"W0A00000012")
    await gateway.quiet(200)
    assert monitor.accesses == []


@cocotb.test
async def a_sample_that_fails_half_way_counts_and_changes_nothing(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)

    async def fail_after_the_first_word() -> None:
        # A slave without wait states accepts an access in the cycle of its strobe; a pipelined master then requests the
        # next.
        while not (dut.wb_stb.value == 1 and int(dut.wb_adr.value) == 0x10 and dut.wb_we.value == 0):
            await RisingEdge(dut.clk)
        dut.wait_states.value = 2 * BUS_TIMEOUT
        while dut.wb_cyc.value == 1:
            await RisingEdge(dut.clk)
        dut.wait_states.value = 0

    await gateway.ask(b"WM10%08X%08X" % (7, 0))
    await gateway.ask(b"GS00110001021011")
    await gateway.ask(b"GN00")
    await gateway.cycles(2 * BASE_TICK)
    assert gateway.take() == checked(b"P0000%08X%08X" % (7, 0))
    failing = cocotb.start_soon(fail_after_the_first_word())
    await gateway.ask(b"W10%08X" % 8)
    await failing
    await gateway.ask(b"W10%08X" % 7)
    await gateway.cycles(3 * BASE_TICK)
    assert gateway.take() == b""
    gateway.send(checked(b"WS10%08X" % 9))
    await gateway.cycles(2 * BASE_TICK)
    assert gateway.take() == checked(b"P0002%08X%08X" % (9, 0))


@cocotb.test
async def send_immediate_pulses_as_its_mode_says(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    length = len(checked(b"R0A00000000"))

    async def flushes_of(data: bytes) -> list[int]:
        await gateway.quiet(100)
        gateway.take()
        del gateway.flushed_after[:]
        gateway.send(data)
        await gateway.quiet(100)
        gateway.take()
        return list(gateway.flushed_after)

    read = checked(b"R0A")
    # Adaptive after a reset: one flush, after the last byte.
    assert await flushes_of(read) == [length]
    assert await flushes_of(read * 5) == [5 * length]
    assert await flushes_of(checked(b"I01")) == [len(checked(b"I01"))]
    always = await flushes_of(read * 3)
    assert len(always) == 3
    # The next answer may have begun when the pulse comes, but only a few of its bytes.
    assert all(0 <= flushed - (index + 1) * length <= 3 for index, flushed in enumerate(always))
    assert await flushes_of(checked(b"I00")) == []
    assert await flushes_of(read * 3) == []
    assert await flushes_of(checked(opening())) == [len(checked(opening() + b"0000"))]
    assert await flushes_of(read) == [length]


@cocotb.test
async def a_reset_in_any_state_recovers(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    traffic = (
        opening()
        + b"\r"
        + checked(b"WM10" + b"0000000100000002")
        + checked(b"RM1004")
        + checked(with_id(b"r", 0, b"11"), SESSION)
        + checked(with_id(b"rq", 1, b"1002"), SESSION)
        + checked(with_id(b"rq", 1, b"1002"), SESSION)
        + checked(with_id(b"h", 2), SESSION)
        + b"W0A1\r"
        + checked(b"Q")
        + checked(b"GS0001000102100F")
        + checked(b"GN00")
        + checked(b"GP00")
        + checked(b"RE8")
    )
    rng = random.Random(4)
    for _ in range(60):
        gateway.send(traffic)
        await gateway.cycles(rng.randrange(1, 520))
        await gateway.reset()
        # An end terminates the byte that was still sent.
        gateway.send(b"\n")
        await gateway.quiet(150)
        gateway.take()
        assert await gateway.ask(b"W0C00C0FFEE") == b"W0C"
        assert await gateway.ask(with_id(b"h", 0)) == with_id(b"x", 0, b"0A0000")
        assert await gateway.ask(b"K") == b"K0000"
        await gateway.open()
        assert await gateway.ask(with_id(b"h", 0)) == with_id(b"h", 0, b"000")
        assert await gateway.ask(b"GN00") == b"X06"
        assert await gateway.ask(b"R0C") == b"R0C00C0FFEE"
        await gateway.quiet(50)
        assert gateway.take() == b""

"""Bench: groups, the times and the order of their samples, and how lost samples are counted.

A base tick is 200 cycles. Address F0 reads the number of cycles since the reset, so a sample contains the time of its
read.
"""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import cocotb
from cocotb.triggers import RisingEdge

from gateware.bench.unity_link.gateway import Gateway, body_of, checked, note_figure, opening, with_id

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

TICK = 200
TX_FIFO = 256
PERIODIC, TRIGGER, IMMEDIATE, STAMP, ON_CHANGE, PLAIN = 1, 2, 4, 8, 16, 32


class Sample(NamedTuple):
    """A published sample."""

    group: int
    sequence: int
    stamp: int
    words: list[int]


def _set(group: int, flags: int, divisor: int, addresses: list[int]) -> bytes:
    return b"GS%02X%02X%04X%02X" % (group, flags, divisor, len(addresses)) + bytes(addresses).hex().upper().encode()


def _samples(data: bytes, *, stamped: bool = True, session: int = 0) -> list[Sample]:
    """Return the samples in received bytes, after checking the CRC of each."""
    samples = []
    for frame in data.splitlines(keepends=True):
        if not frame.startswith(b"P"):
            continue
        body = frame[1:-2] if frame.endswith(b"\r\n") else body_of(frame, session)[1:]
        head = 12 if stamped else 4
        words = [int(body[at : at + 8], 16) for at in range(head, len(body), 8)]
        samples.append(Sample(int(body[:2], 16), int(body[2:4], 16), int(body[4:head] or b"0", 16), words))
    return samples


async def _gateway(dut: SimHandleBase, **pauses: float) -> Gateway:
    gateway = Gateway(dut, **pauses)
    await gateway.begin()
    return gateway


def _differences(numbers: list[int]) -> list[int]:
    return [after - before for before, after in pairwise(numbers)]


@cocotb.test
async def a_periodic_group_is_published_at_every_divisor_th_tick(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    await gateway.ask(_set(3, PERIODIC | STAMP, 2, [0xF0, 0x10]))
    await gateway.ask(b"GN03")
    await gateway.cycles(20 * TICK)
    samples = _samples(gateway.take())
    assert 9 <= len(samples) <= 10
    assert [sample.sequence for sample in samples] == list(range(len(samples)))
    assert set(_differences([sample.stamp for sample in samples])) == {2 * TICK}
    assert set(_differences([sample.words[0] for sample in samples])) == {2 * TICK}
    assert {sample.group for sample in samples} == {3}


@cocotb.test
async def a_group_is_first_due_at_the_next_tick(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    await gateway.ask(_set(0, PERIODIC | STAMP, 1000, [0xF0]))
    for _ in range(5):
        await gateway.ask(b"GN00")
        answered = gateway.cycle
        await gateway.cycles(TICK + 120)
        samples = _samples(gateway.take())
        assert len(samples) == 1
        assert samples[0].stamp <= answered + TICK
        await gateway.cycles(37)


@cocotb.test
async def instants_vary_by_at_most_one_access_while_blocks_are_read(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    for wait_states in (0, 7):
        dut.wait_states.value = wait_states
        one_access = 3 + wait_states
        await gateway.ask(_set(1, PERIODIC | STAMP, 1, [0xF0, 0x11, 0x12]))
        await gateway.ask(b"GN01")
        gateway.send(checked(b"RM00FF") * 6)
        await gateway.cycles(6 * 2200)
        gateway.send(checked(b"GX01"))
        await gateway.quiet(255 * one_access + TICK)
        samples = _samples(gateway.take())
        assert len(samples) > 20
        instants = [sample.stamp - index * TICK for index, sample in enumerate(samples)]
        read_at = [sample.words[0] - index * TICK for index, sample in enumerate(samples)]
        assert [sample.sequence for sample in samples] == list(range(len(samples)))
        jitter = max(instants) - min(instants)
        note_figure(f"jitter with {wait_states} wait states", jitter)
        assert jitter <= one_access
        assert max(read_at) - min(read_at) <= one_access


@cocotb.test
async def a_sample_is_read_at_once_and_never_torn_by_a_block_write(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    await gateway.ask(_set(1, PERIODIC | STAMP, 1, [0x20, 0x21, 0x22]))
    await gateway.ask(b"GN01")
    for number in range(1, 150):
        gateway.send(checked(b"WM20%08X%08X%08X" % (number, number, number)))
    await gateway.quiet(TICK // 2)
    samples = _samples(gateway.take())
    assert len(samples) > 10
    assert all(len(set(sample.words)) == 1 for sample in samples)
    assert len({sample.words[0] for sample in samples}) > 5


@cocotb.test
async def masked_writes_are_not_torn_by_samples(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    await gateway.ask(_set(1, PERIODIC, 1, [0x20, 0x21, 0x22]))
    await gateway.ask(b"GN01")
    open_reads: list[str] = []

    async def watch() -> None:
        after_read = False
        while True:
            await RisingEdge(dut.clk)
            if dut.wb_ack.value == 1 and int(dut.wb_adr.value) == 0x40:
                after_read = dut.wb_we.value == 0
            elif dut.wb_ack.value == 1 and after_read:
                open_reads.append(str(dut.wb_adr.value))

    cocotb.start_soon(watch())
    for number in range(150):
        gateway.send(checked(b"WK40%08X%08X" % (1 << number % 32, 0xFFFFFFFF)))
    await gateway.quiet(TICK // 2)
    assert open_reads == []


@cocotb.test
async def a_rising_edge_of_its_trigger_makes_a_group_due(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    await gateway.ask(_set(2, TRIGGER | STAMP, 1, [0xF0]))
    await gateway.ask(_set(4, PERIODIC | STAMP, 1000, [0xF0]))
    await gateway.ask(b"GN04")
    await gateway.cycles(2 * TICK)
    gateway.take()

    async def pulse() -> None:
        dut.trigger.value = (1 << 2) | (1 << 4)
        await gateway.cycles(3)
        dut.trigger.value = 0
        await gateway.cycles(100)

    await pulse()
    assert gateway.take() == b""
    await gateway.ask(b"GN02")
    edges = []
    for _ in range(3):
        edges.append(gateway.cycle)
        await pulse()
    samples = _samples(gateway.take())
    assert [(sample.group, sample.sequence) for sample in samples] == [(2, 0), (2, 1), (2, 2)]
    delays = {sample.words[0] - edge for sample, edge in zip(samples, edges, strict=True)}
    assert len(delays) == 1


@cocotb.test
async def no_edges_of_triggers_keep_requests_from_their_answers_or_groups_from_their_instants(
    dut: SimHandleBase,
) -> None:
    gateway = await _gateway(dut)
    await gateway.ask(_set(15, PERIODIC | STAMP, 2, [0xF0]))
    for half, flags, groups in ((2, 0, 1), (3, PERIODIC, 1), (40, 0, 15), (2, TRIGGER, 1), (40, TRIGGER, 15)):
        for group in range(groups):
            await gateway.ask(_set(group, flags, 1000, [0x20]))
            await gateway.ask(b"GN%02X" % group)
        edges = cocotb.start_soon(_toggle(dut, half))
        gateway.send(checked(b"GN0F"))
        await gateway.cycles(10 * TICK)
        frames = gateway.take()
        assert checked(b"GN0F") in frames, (half, flags)
        if flags != TRIGGER:
            samples = [sample for sample in _samples(frames, session=gateway.session) if sample.group == 15]
            assert set(_differences([sample.stamp for sample in samples])) == {2 * TICK}
        for body in (b"H", b"GX0F", b"GP00", _set(15, PERIODIC | STAMP, 2, [0xF0])):
            gateway.send(checked(body))
            await gateway.cycles(2_500)
            assert checked(body[:4]) in gateway.take(), (half, flags, body)
        gateway.send(session := gateway.next_session())
        await gateway.cycles(2_500)
        assert session[:-1] in gateway.take(), (half, flags)
        await gateway.quiet(TICK)
        assert gateway.take() == b""
        edges.cancel()


async def _toggle(dut: SimHandleBase, half: int) -> None:
    while True:
        dut.trigger.value = int(dut.trigger.value) ^ 0x7FFF
        for _ in range(half):
            await RisingEdge(dut.clk)


@cocotb.test
async def gp_publishes_once_whether_running_or_not(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    await gateway.ask(b"W10%08X" % 0x1234)
    await gateway.ask(_set(5, ON_CHANGE, 1, [0x10]))
    for number in range(3):
        data = await gateway.answer(checked(b"GP05"), count=2)
        assert _samples(data, stamped=False) == [Sample(5, number, 0, [0x1234])]
        assert checked(b"GP05") in data
    assert await gateway.ask(b"GP06") == b"X06"


@cocotb.test
async def an_on_change_group_is_published_when_a_word_has_changed(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    await gateway.ask(b"WM10%08X%08X" % (1, 2))
    await gateway.ask(_set(0, PERIODIC | ON_CHANGE, 1, [0x10, 0x11]))
    await gateway.ask(b"GN00")
    await gateway.cycles(10 * TICK)
    assert _samples(gateway.take(), stamped=False) == [Sample(0, 0, 0, [1, 2])]
    for number in range(1, 5):
        gateway.send(checked(b"W11%08X" % (2 + number)))
        await gateway.cycles(5 * TICK)
        assert _samples(gateway.take(), stamped=False) == [Sample(0, number, 0, [1, 2 + number])]
    # The first sample after GN is always sent.
    gateway.send(checked(b"GN00"))
    await gateway.cycles(3 * TICK)
    assert _samples(gateway.take(), stamped=False) == [Sample(0, 5, 0, [1, 6])]


@cocotb.test
async def overruns_count_in_the_sequence_and_block_nothing(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    await gateway.ask(_set(0, PERIODIC | STAMP, 1, [0xF0] * 20))
    await gateway.ask(b"GN00")
    gateway.pause_out = 1.0
    await gateway.cycles(40 * TICK)
    gateway.pause_out = 0.0
    await gateway.cycles(15 * TICK)
    gateway.send(checked(b"GX00"))
    await gateway.quiet()
    samples = _samples(gateway.take())
    steps = _differences([sample.sequence for sample in samples])
    assert max(steps) > 5
    for (before, after), step in zip(pairwise(samples), steps, strict=True):
        assert after.stamp - before.stamp == step * TICK


@cocotb.test
async def more_samples_than_the_bus_can_read_are_counted(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    dut.wait_states.value = 20
    for group in range(3):
        await gateway.ask(_set(group, PERIODIC | STAMP, 1, [0xF0] * 6))
    for group in range(3):
        gateway.send(checked(b"GN%02X" % group))
    await gateway.cycles(40 * TICK)
    gateway.send(gateway.next_session())
    await gateway.quiet()
    samples = _samples(gateway.take())
    lowest = [sample for sample in samples if sample.group == 0]
    # The lowest number goes first and loses no sample.
    assert set(_differences([sample.sequence for sample in lowest])) == {1}
    for group in (1, 2):
        own = [sample for sample in samples if sample.group == group]
        for before, after in pairwise(own):
            counted = (after.sequence - before.sequence) % 256
            passed = (after.stamp - before.stamp) / TICK
            assert abs(counted - passed) < 1.5, (before, after)


@cocotb.test
async def k_stops_all_groups_and_their_sequences_go_on(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    for group in (0, 15):
        await gateway.ask(_set(group, PERIODIC | STAMP, 1, [0xF0]))
        await gateway.ask(b"GN%02X" % group)
    await gateway.cycles(3 * TICK)
    gateway.send(gateway.next_session())
    await gateway.cycles(TICK)
    last = {sample.group: sample.sequence for sample in _samples(gateway.take())}
    assert set(last) == {0, 15}
    await gateway.cycles(3 * TICK)
    assert gateway.take() == b""
    gateway.send(checked(b"GN0F"))
    await gateway.cycles(2 * TICK)
    samples = _samples(gateway.take(), session=gateway.session)
    assert samples[0].group == 15
    assert samples[0].sequence == last[15] + 1


@cocotb.test
async def no_sample_that_was_taken_before_a_group_was_stopped_or_set_comes_after_the_answer(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    await gateway.ask(_set(9, PERIODIC, 1, [0x33]))
    await gateway.ask(b"GN09")
    settings_again = _set(0, 0, 1, [0x20])
    for number, end in enumerate((b"GX00", b"K", settings_again, b"GX00", settings_again, b"K")):
        settings = _set(0, PERIODIC, 1, list(range(0x10, 0x14 + 4 * (number % 6))))
        gateway.send(checked(settings) + checked(b"GN09") + checked(b"GN00"))
        # More samples than the line can transfer: they fill the ring.
        gateway.pause_out = 0.9
        await gateway.cycles((30 + number) * TICK)
        gateway.pause_out = 0.3
        gateway.send(checked(b"RM00%02X" % (1 + 50 * (number % 4))))
        gateway.send((gateway.next_session() if end == b"K" else checked(end)) + checked(b"H") * 20)
        await gateway.quiet(TICK // 2)
        frames = gateway.take().splitlines()
        answer = max(place for place, frame in enumerate(frames) if frame.startswith(end[:4]))
        group_ends = b"P" if end == b"K" else b"P00"
        before, after = ([f for f in part if f.startswith(group_ends)] for part in (frames[:answer], frames[answer:]))
        assert len(before) > 10
        assert after == []
        # The other group continues, and so do requests.
        assert any(frame.startswith(b"P09") for frame in frames[answer:]) == (end != b"K")
        assert frames.count(checked(b"H")[:-1]) == 20


@cocotb.test
async def a_session_discards_the_samples_that_wait_but_for_one(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    await gateway.ask(_set(0, PERIODIC, 1, [0x33]))
    for plain in (True, False):
        gateway.send(gateway.checked(b"gn00000") if gateway.session and not plain else b"GN00\r")
        await gateway.cycles(2 * TICK)
        gateway.pause_out = 1.0
        await gateway.cycles(60 * TICK)
        gateway.take()
        body = opening(0, 7 if plain else 8)
        gateway.send(body + b"\r" if plain else checked(body))
        await gateway.cycles(TICK)
        gateway.pause_out = 0.0
        await gateway.quiet()
        frames = gateway.take().splitlines()
        place = next(index for index, frame in enumerate(frames) if frame.startswith(body))
        # Of more than fifty samples, only those in the FIFO of the medium, the one being sent, and one more.
        assert place <= TX_FIFO // (len(frames[0]) + 1) + 2
        assert len(frames) == place + 1


@cocotb.test
async def the_answer_to_what_is_about_groups_comes_behind_all_samples_from_before_it(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    await gateway.ask(_set(0, 0, 1, [0xF0]))
    await gateway.ask(_set(9, PERIODIC, 1, [0xF0, 0x11, 0x12, 0x13]))
    for request, answer in (
        *((b"GP00", b"GP00"), (b"GN00", b"GN00"), (b"GN09", b"GN09")),
        *((b"GX0F", b"X06"), (_set(9, 0, 0, [0x20]), b"X06"), (b"GP000", b"X03")),
        (with_id(b"gx", 0, b"00"), with_id(b"x", 0, b"0A0000")),
    ):
        # More samples than the line can transfer: they fill the ring.
        gateway.pause_out = 0.9
        await gateway.ask(b"H")
        gateway.send(checked(b"GN09"))
        await gateway.cycles(30 * TICK)
        gateway.take()
        gateway.send(checked(request))
        await gateway.sent()
        executed = int(dut.cycles.value)
        gateway.pause_out = 0.3
        gateway.send(checked(b"GX09"))
        await gateway.quiet(TICK)
        # A sample may have begun before.
        frames = gateway.take().split(b"\n", 1)[1].splitlines(keepends=True)
        place = frames.index(checked(answer))
        before, after = (_samples(b"".join(part), stamped=False) for part in (frames[:place], frames[place:]))
        assert len(before) > 10
        assert len(after) > 1
        assert all(sample.words[0] > executed for sample in after)
        assert any(sample.group == 0 for sample in before) == (request == b"GP00")


@cocotb.test
async def plain_and_immediate_groups_are_sent_so(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    await gateway.ask(b"I00")
    await gateway.ask(_set(0, PERIODIC | PLAIN | IMMEDIATE, 1, [0x33]))
    await gateway.ask(b"W33%08X" % 0xABC)
    await gateway.ask(b"GN00")
    del gateway.flushed_after[:]
    await gateway.cycles(4 * TICK)
    data = gateway.take()
    assert data.startswith(b"P000000000ABC\r\nP000100000ABC\r\n")
    assert len(gateway.flushed_after) == data.count(b"\n")


@cocotb.test
async def samples_come_between_answers(dut: SimHandleBase) -> None:
    gateway = await _gateway(dut)
    await gateway.ask(_set(0, PERIODIC | STAMP, 1, [0xF0]))
    await gateway.ask(b"GN00")
    for _ in range(20):
        gateway.send(checked(b"RM1010"))
    await gateway.quiet(TICK // 2)
    kinds = b"".join(frame[:1] for frame in gateway.take().splitlines())
    assert kinds.count(b"R") == 20
    assert b"RPR" in kinds

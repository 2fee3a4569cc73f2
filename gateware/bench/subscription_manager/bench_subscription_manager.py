"""Bench: when samples are taken, in which order, and how the samples that are not taken are counted."""

from __future__ import annotations

import os
import random
from itertools import pairwise
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles, RisingEdge

from gateware.bench.subscription_manager.around import (
    IMMEDIATE,
    ON_CHANGE,
    PERIODIC,
    PLAIN,
    STAMP,
    TRIGGER,
    Around,
    Sample,
)

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

TICK = int(os.environ["TICK"])
"""Cycles between two base ticks."""


async def _begin(dut: SimHandleBase, **options: float) -> Around:
    around = Around(dut, **options)
    await around.begin()
    return around


async def _set_and_start(around: Around, group: int, flags: int, addresses: list[int], divisor: int = 1) -> None:
    await around.set(group, flags, addresses, divisor)
    await around.operate("start", group)


@cocotb.test
async def a_published_sample_has_what_its_group_was_set_to(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    last = int(dut.groups.value) - 1
    for group, flags in ((0, 0), (last, STAMP), (1, PLAIN), (0, IMMEDIATE), (last, STAMP | PLAIN | IMMEDIATE)):
        addresses = list(range(5, 5 + 1 + group % 7))
        await around.set(group, flags, addresses)
        for sequence in range(3):
            await around.operate("publish", group)
            (sample,) = await around.take(2)
            assert (sample.group, sample.sequence, sample.words) == (group, sequence, [at + 1 for at in addresses])
            assert (sample.plain, sample.immediate) == (bool(flags & PLAIN), bool(flags & IMMEDIATE))
            assert (sample.stamp is not None) == bool(flags & STAMP)


@cocotb.test
async def a_sample_says_in_which_epoch_it_was_taken(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    await around.set(0, 0, [5])
    for epoch in (0, 1, 1, 0):
        dut.epoch.value = epoch
        await around.operate("publish", 0)
        (sample,) = await around.take(2)
        assert sample.epoch == epoch


@cocotb.test
async def the_largest_group_is_read_whole(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    last, most = int(dut.groups.value) - 1, int(dut.group_words.value)
    lists = {}
    for group in (0, last):
        lists[group] = [random.Random(group).randrange(256) for _ in range(most)]
        await around.set(group, ON_CHANGE, lists[group])
    for group, addresses in lists.items():
        await around.operate("publish", group)
        (sample,) = await around.take(2)
        assert sample.words == [address + 1 & (1 << around.bits) - 1 for address in addresses]


@cocotb.test
async def is_set_follows_the_number_of_the_group(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    await around.set(2, 0, [1])
    for group in range(min(256, int(dut.groups.value) + 4)):
        dut.group_number.value = group
        await ClockCycles(dut.clk, 2)
        assert dut.group_is_set.value == (group == 2), group


@cocotb.test
async def periodic_groups_are_sampled_every_divisor_th_tick(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    for group, divisor in ((0, 1), (1, 2), (2, 5)):
        await _set_and_start(around, group, PERIODIC | STAMP, [group] * (group + 1), divisor)
    await around.take(TICK)
    samples = await around.take(20 * TICK)
    for group, divisor in ((0, 1), (1, 2), (2, 5)):
        own = [sample for sample in samples if sample.group == group]
        assert len(own) in (20 // divisor, 20 // divisor + 1)
        for before, after in pairwise(own):
            assert after.sequence == before.sequence + 1
            # A group with a lower number that is due at the same time goes first, for some cycles.
            assert abs(after.stamp - before.stamp - divisor * TICK) <= 30
            assert after.stamp - before.stamp == after.cycle - before.cycle
    assert {after.stamp - before.stamp for before, after in pairwise(s for s in samples if s.group == 0)} == {TICK}


@cocotb.test
async def groups_that_are_due_at_once_are_sampled_lowest_number_first(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    for group in (4, 2, 0, 3, 1):
        await around.set(group, TRIGGER, [group])
        await around.operate("start", group)
    for _ in range(3):
        dut.trigger.value = 0b11111
        samples = await around.take(100)
        assert [sample.group for sample in samples] == [0, 1, 2, 3, 4]
        dut.trigger.value = 0
        assert await around.take(10) == []


@cocotb.test
async def a_trigger_is_for_its_own_group_while_that_runs_and_wants_it(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    await around.set(0, TRIGGER, [1])
    await _set_and_start(around, 1, TRIGGER, [2])
    await _set_and_start(around, 2, 0, [3])
    for _ in range(3):
        dut.trigger.value = 0b111
        await ClockCycles(dut.clk, 2)
        dut.trigger.value = 0
        assert [sample.group for sample in await around.take(60)] == [1]
    await around.operate("stop", 1)
    dut.trigger.value = 0b111
    assert await around.take(60) == []


async def _toggle(dut: SimHandleBase, mask: int, half: int) -> None:
    """Toggle the triggers of a mask every `half` cycles: a rising edge every `2 * half` cycles."""
    while True:
        dut.trigger.value = int(dut.trigger.value) ^ mask
        await ClockCycles(dut.clk, half)


@cocotb.test
async def edges_that_no_group_wants_delay_nothing_however_many_they_are(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    last = int(dut.groups.value) - 1
    for group in range(last):
        await _set_and_start(around, group, (0, PERIODIC)[group == 0], [1], 1000)
    await _set_and_start(around, last, PERIODIC | STAMP, [2])
    for half in (2, 3, 5):
        edges = cocotb.start_soon(_toggle(dut, (1 << last + 1) - 1, half))
        await around.take(TICK)
        samples = [sample for sample in await around.take(10 * TICK) if sample.group == last]
        assert {after.stamp - before.stamp for before, after in pairwise(samples)} == {TICK}
        assert len(samples) == 10
        for operation in ("stop", "start", "publish"):
            begun = around.cycle
            await around.operate(operation, 0)
            # One sample of the last group may go first, and a start waits for the timer.
            assert around.cycle - begun < 30 + last
        edges.cancel()


@cocotb.test
async def operations_take_their_turn_whatever_edges_ask_for(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    groups = min(8, int(dut.groups.value))
    edges = cocotb.start_soon(_toggle(dut, (1 << groups) - 1, 2))
    for group in range(groups):
        await _set_and_start(around, group, TRIGGER, [group] * 5)
    # The lowest due number is served first, so the edges of group 0 leave no time for others.
    assert {sample.group for sample in await around.take(500)} == {0}
    for group in range(groups):
        for operation in ("start", "publish", "stop"):
            begun = around.cycle
            await around.operate(operation, group)
            # One sample may go first, and a start waits for the timer.
            assert around.cycle - begun < 80 + int(dut.groups.value)
        assert group in {sample.group for sample in await around.take(2)}
    assert await around.take(500) == []
    edges.cancel()


@cocotb.test
async def edges_count_by_the_flags_with_which_a_group_was_started(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    last = int(dut.groups.value) - 1

    async def edge() -> list[Sample]:
        dut.trigger.value = 1 << last
        await ClockCycles(dut.clk, 2)
        dut.trigger.value = 0
        return await around.take(60)

    for flags in (0, TRIGGER, 0, TRIGGER, TRIGGER, 0):
        await around.set(last, flags, [7])
        # An edge before the start has no effect, neither at once nor later.
        assert await edge() == []
        await around.operate("start", last)
        assert await around.take(60) == []
        assert len(await edge()) == bool(flags & TRIGGER)
    # An edge while the group is set again finds it stopped, in whichever cycle it comes.
    for late in range(40):
        await _set_and_start(around, last, TRIGGER, [7])
        await around.take(60)
        cocotb.start_soon(_pulse_after(dut, late, last))
        await around.set(last, late % 2 * TRIGGER, [8])
        await around.take(60)
        await around.operate("start", last)
        assert await around.take(60) == []
        assert [sample.sequence for sample in await edge()] == [0] * (late % 2)


async def _pulse_after(dut: SimHandleBase, cycles: int, group: int) -> None:
    if cycles:
        await ClockCycles(dut.clk, cycles)
    dut.trigger.value = 1 << group
    await ClockCycles(dut.clk, 2)
    dut.trigger.value = 0


@cocotb.test
async def on_change_compares_with_the_last_sample_that_was_accepted(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    values = {1: 10, 2: 20}
    around.read = values.__getitem__
    await _set_and_start(around, 0, PERIODIC | ON_CHANGE, [1, 2])
    assert [sample.words for sample in await around.take(5 * TICK)] == [[10, 20]]
    values[2] = 21
    assert [sample.words for sample in await around.take(5 * TICK)] == [[10, 21]]
    # A sample that fails half-way is counted and leaves the stored words unchanged.
    values[1], around.failing = 11, {2}
    assert await around.take(3 * TICK) == []
    values[1], around.failing = 10, set()
    assert await around.take(3 * TICK) == []
    values[1] = 12
    (sample,) = await around.take(3 * TICK)
    assert (sample.words, sample.sequence) == ([12, 21], 5)
    # The first sample after a start, and one requested by GP, are always sent.
    await around.operate("publish")
    await around.operate("start")
    assert [sample.sequence for sample in await around.take(3 * TICK)] == [6, 7]


@cocotb.test
async def a_sample_without_room_counts_and_blocks_nothing(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    await _set_and_start(around, 0, PERIODIC | STAMP, [1, 2, 3])
    await around.take(2 * TICK + TICK // 2)
    # One word less than header, timestamp and words need.
    around.room = 4
    assert await around.take(3 * TICK) == []
    await around.operate("publish", 0)
    around.room = 5
    samples = await around.take(2 * TICK)
    assert [sample.sequence for sample in samples] == [6, 7]


@cocotb.test
async def a_failed_read_counts_and_the_next_sample_is_taken(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    await _set_and_start(around, 0, PERIODIC, [1, 2, 3])
    first = (await around.next_sample()).sequence
    around.failing = {2}
    assert await around.take(3 * TICK) == []
    around.failing = set()
    assert [sample.sequence - first for sample in await around.take(2 * TICK)] == [4, 5]


@cocotb.test
async def ticks_that_pass_while_the_bus_is_slow_are_counted(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    around.waits = TICK
    await _set_and_start(around, 0, PERIODIC | STAMP, [1, 2, 3])
    samples = await around.take(60 * TICK)
    assert len(samples) > 10
    for before, after in pairwise(samples):
        assert after.sequence - before.sequence >= 3
        assert abs(after.stamp - before.stamp - TICK * (after.sequence - before.sequence)) < TICK


@cocotb.test
async def groups_that_ask_for_more_than_the_bus_gives_can_be_stopped(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    around.waits = TICK // 2
    for group in range(5):
        await _set_and_start(around, group, PERIODIC, [1] * 5)
    await around.take(10 * TICK)
    for group in range(5):
        await around.operate("stop", group)
    await around.take(6 * TICK)
    assert await around.take(5 * TICK) == []


@cocotb.test
async def all_groups_stop_at_once_and_keep_their_settings_and_sequence(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    for group in range(5):
        await _set_and_start(around, group, PERIODIC, [group])
    sequences = {sample.group: sample.sequence for sample in await around.take(4 * TICK)}
    await around.operate("stop all")
    sequences.update({sample.group: sample.sequence for sample in await around.take(TICK)})
    assert await around.take(4 * TICK) == []
    await around.operate("start", 3)
    sample, *_ = await around.take(2 * TICK)
    assert (sample.group, sample.sequence, sample.words) == (3, sequences[3] + 1, [4])


@cocotb.test
async def sequences_wrap_and_begin_anew_when_a_group_is_set(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    await around.set(1, 0, [1])
    for _ in range(255):
        await around.operate("publish", 1)
    assert [sample.sequence for sample in await around.take(2)] == list(range(255))
    for expected in (255, 0):
        await around.operate("publish", 1)
        assert (await around.take(2))[0].sequence == expected
    await around.set(1, 0, [1])
    await around.operate("publish", 1)
    assert (await around.take(2))[0].sequence == 0


@cocotb.test
async def a_reset_in_any_state_forgets_all_groups(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    rng = random.Random(3)
    for _ in range(15):
        for group in range(3):
            await _set_and_start(around, group, PERIODIC | STAMP, [1, 2])
        await ClockCycles(dut.clk, rng.randrange(1, TICK))
        dut.rst.value = 1
        await RisingEdge(dut.clk)
        dut.rst.value = 0
        await around.take(6)
        assert await around.take(2 * TICK) == []
        await around.set(0, 0, [7])
        await around.operate("publish", 0)
        assert [(sample.sequence, sample.words) for sample in await around.take(2)] == [(0, [8])]


@cocotb.test
async def samples_are_whole_and_their_sequences_true_whatever_the_bus_does(dut: SimHandleBase) -> None:
    around = await _begin(dut, slow=0.4)
    rng = random.Random(5)
    groups = min(6, int(dut.groups.value))
    lists = {group: [rng.randrange(200) for _ in range(rng.randrange(1, 6))] for group in range(groups)}
    for group, addresses in lists.items():
        await _set_and_start(around, group, PERIODIC | STAMP, addresses, 1 + group % 3)
    samples = []
    for _ in range(120):
        around.room = rng.choice((3, 511, 511))
        around.failing = {rng.randrange(200)}
        samples += await around.take(rng.randrange(TICK))
    for group, addresses in lists.items():
        own = [sample for sample in samples if sample.group == group]
        assert len(own) > 5
        assert all(sample.words == [address + 1 for address in addresses] for sample in own)
        for before, after in pairwise(own):
            due = (after.sequence - before.sequence) % 256
            # A sample waits at most for those of the other groups.
            assert abs(after.stamp - before.stamp - due * TICK * (1 + group % 3)) < TICK

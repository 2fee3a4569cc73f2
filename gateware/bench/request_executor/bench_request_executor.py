"""Bench: requests become accesses, operations on groups and answers, exactly once and in order."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles, RisingEdge

from gateware.bench.request_executor.around import (
    COMMANDS,
    ERROR,
    OUT_OF_SEQUENCE,
    Access,
    Answer,
    Around,
    Request,
)

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

BUS, TIMEOUT, RANGE, NO_SESSION, UNDER_WAY = 4, 5, 6, 10, 11
IDS = 16**3
NONE, WHEN_IDLE, NOW = 0, 1, 2


async def _begin(dut: SimHandleBase, **options: float) -> Around:
    around = Around(dut, **options)
    await around.begin()
    return around


async def _in_session(dut: SimHandleBase, number: int = 0, **options: float) -> Around:
    """Return an executor in a session, with empty records."""
    around = await _begin(dut, **options)
    await around.execute(Request("K", number, plain=True))
    around.take()
    around.operations.clear()
    return around


def _ok(command: str, **fields: object) -> Answer:
    """Return the answer of a command; by default without ID, address and words."""
    values = {"number": None, "address": False, "pair": None, "words": 0, "plain": False, "mark": WHEN_IDLE}
    return Answer(COMMANDS.index(command), **{**values, **fields})


def _error(code: int, number: int | None = None, *, tail: str = "", plain: bool = False) -> Answer:
    return Answer(ERROR, number, address=False, pair=code, words=0, plain=plain, mark=WHEN_IDLE, tail=tail)


def _opened(number: int, session: int = 0x1234, ended: int = 0, **fields: object) -> Answer:
    return _ok("K", number=number, tail=f"{session:04X}{ended:04X}", **fields)


def _read(address: int, *, more: bool = False, exclusive: bool = False) -> Access:
    return Access(write=False, address=address, word=None, more=more, exclusive=exclusive)


def _write(address: int, word: int, *, more: bool = False) -> Access:
    return Access(write=True, address=address, word=word, more=more, exclusive=True)


@cocotb.test
async def words_are_read_and_written(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    await around.execute(Request("W", address=5, word=77))
    await around.execute(Request("R", address=5))
    await around.execute(Request("WM", address=0xFF, count=3, words=[1, 2, 3]))
    await around.execute(Request("RM", address=0xFF, count=3))
    await around.execute(Request("WQ", address=9, count=2, words=[4, 5]))
    await around.execute(Request("RQ", address=9, count=2))
    await around.execute(Request("WS", address=9, word=6))
    accesses, answers = around.take()
    assert accesses == [
        *(_write(5, 77), _read(5)),
        *(_write(0xFF, 1, more=True), _write(0, 2, more=True), _write(1, 3)),
        *(_read(0xFF, more=True), _read(0, more=True), _read(1)),
        *(_write(9, 4), _write(9, 5), _read(9), _read(9), _write(9, 6)),
    ]
    assert answers == [
        *(_ok("W", address=True), _ok("R", address=True, words=1)),
        *(_ok("WM", address=True, pair=3), _ok("RM", address=True, pair=3, words=3)),
        *(_ok("WQ", address=True, pair=2), _ok("RQ", address=True, pair=2, words=2)),
    ]
    assert around.committed == [77, 1, 2, 3, 5, 5]


@cocotb.test
async def a_masked_write_answers_the_old_word(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    around.memory[3] = 0x12345678
    await around.execute(Request("WK", address=3, word=0xFFFFFFFF, words=[0x0000FF00]))
    accesses, answers = around.take()
    assert accesses == [_read(3, more=True, exclusive=True), _write(3, 0x1234FF78)]
    assert answers == [_ok("WK", address=True, words=1)]
    assert around.committed == [0x12345678]


@cocotb.test
async def a_failed_access_ends_its_request_and_takes_its_words_back(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    around.failures = {2: BUS, 7: TIMEOUT}
    await around.execute(Request("RM", address=0, count=5))
    await around.execute(Request("WM", address=1, count=3, words=[8, 9, 10]))
    await around.execute(Request("WK", address=7, words=[1], word=1))
    await around.execute(Request("WS", address=7, word=1))
    await around.execute(Request("R", address=1))
    accesses, answers = around.take()
    assert [access.address for access in accesses] == [0, 1, 2, 1, 2, 7, 7, 1]
    assert answers == [*(_error(code) for code in (BUS, BUS, TIMEOUT, TIMEOUT)), _ok("R", address=True, words=1)]
    assert around.committed == [8]


@cocotb.test
async def ids_are_executed_once_and_in_order(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    await around.execute(Request("K", number=0x40))
    assert around.operations == [("stop all", [])]
    assert around.take() == ([], [_opened(0x40)])
    await around.execute(Request("W", number=0x40, address=1, word=5))
    await around.execute(Request("W", number=0x40, address=1, word=6))
    await around.execute(Request("R", number=0x40, address=1))
    await around.execute(Request("RQ", number=0x40, address=1, count=1))
    await around.execute(Request("WK", number=0x41 + IDS // 2, address=1, words=[1]))
    await around.execute(Request("WS", number=0x40, address=1, word=7))
    await around.execute(Request("H", number=0x42))
    await around.execute(Request("H", number=0x40 + IDS // 2))
    await around.execute(Request("WS", number=0x41, address=1, word=8))
    await around.execute(Request("H", number=0x43))
    accesses, answers = around.take()
    assert accesses == [_write(1, 5), _read(1), _write(1, 8)]
    gap = Answer(OUT_OF_SEQUENCE, 0x41, address=False, pair=None, words=0, plain=False, mark=WHEN_IDLE)
    assert [(answer.message, answer.number) for answer in answers[:2]] == [(COMMANDS.index("W"), 0x40)] * 2
    assert answers[2:5] == [
        _ok("R", number=0x40, words=1),
        _ok("RQ", number=0x40, words=1),
        _ok("WK", number=0x41 + IDS // 2, words=1),
    ]
    # One message for the gap at 41, and another one for the gap at 42.
    assert [(answer.message, answer.number) for answer in answers[5:]] == [
        (gap.message, 0x41),
        (gap.message, 0x42),
    ]


@cocotb.test
async def without_a_session_no_request_with_an_id_is_executed_and_each_is_answered_so(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    around.is_set = {3}
    requests = [command for command in COMMANDS if command not in ("Q", "K")]
    for command in requests:
        await around.execute(Request(command, 7, group=3, count=2, words=[1, 2], field=0xA5C3))
    accesses, answers = around.take()
    assert accesses == []
    assert answers == [_error(NO_SESSION, 7, tail="A5C3")] * len(requests)
    assert {operation for operation, _ in around.operations} == {"nothing"}
    # A broadcast is not executed either, and not answered; the form is checked before the session.
    await around.execute(Request("W", 7, address=1, word=5, silent=True))
    await around.execute(Request("W", 7, address=1, word=5, error=3))
    # A request without an ID is executed.
    await around.execute(Request("W", address=1, word=5))
    assert around.take() == ([_write(1, 5)], [_error(3), _ok("W", address=True)])


@cocotb.test
async def a_session_has_a_number_that_is_told_and_names_the_one_that_it_ends(dut: SimHandleBase) -> None:
    around = await _begin(dut, slow=0.3)
    await around.execute(Request("K", asks=True, field=0))
    assert around.take()[1] == [_ok("K", tail="0000")]
    assert (dut.session.value, dut.in_session.value) == (0, 0)
    for ended, session in ((0, 0x7FFF), (0x7FFF, 1), (1, 0x2345)):
        await around.execute(Request("K", 9, field=session))
        assert (dut.session.value, dut.in_session.value, dut.for_program.value) == (session, 1, 1)
        await around.execute(Request("K", asks=True, field=0x5555))
        assert around.take()[1] == [_opened(9, session, ended), _ok("K", tail=f"{session:04X}")]
    await around.execute(Request("K", 9, field=0x2345))
    await around.execute(Request("K", 9, field=0x8000, out_of_range=True))
    await around.execute(Request("K", asks=True))
    await around.execute(Request("K", 9, field=0x2346, plain=True))
    assert around.take()[1] == [
        *(_error(UNDER_WAY), _error(RANGE), _ok("K", tail="2345")),
        _opened(9, 0x2346, 0x2345, plain=True),
    ]
    assert dut.for_program.value == 0


@cocotb.test
async def a_program_s_session_shuts_out_what_changes_something_outside_of_its_order(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    around.is_set = {3}
    await around.execute(Request("K", 0))
    around.take()
    looking = ("R", "RM", "H", "Q")
    for command in (command for command in COMMANDS if command not in (*looking, "K")):
        for plain in (False, True):
            await around.execute(Request(command, group=3, count=1, words=[1], plain=plain))
            assert around.take() == ([], [_error(UNDER_WAY, plain=plain)]), command
    for command in looking:
        await around.execute(Request(command, plain=True))
        assert len(around.take()[1]) == 1
    # A plain request with an ID is rejected and takes no place in the sequence.
    await around.execute(Request("W", 0, address=1, word=5, plain=True))
    assert around.take() == ([], [_error(UNDER_WAY, 0, plain=True)])
    # Of the requests to all nodes, only a checked WS is executed.
    await around.execute(Request("WS", address=1, word=5, silent=True, plain=True))
    await around.execute(Request("WS", 0, address=1, word=5, silent=True))
    await around.execute(Request("WS", address=1, word=6, silent=True))
    await around.execute(Request("W", 0, address=2, word=7))
    assert around.take() == ([_write(1, 6), _write(2, 7)], [_ok("W", number=0)])


@cocotb.test
async def the_end_of_a_request_is_told_again_and_failed_posts_are_counted(dut: SimHandleBase) -> None:
    around = await _in_session(dut, slow=0.3)
    around.failures = {7: BUS, 8: TIMEOUT}
    ends = {0: BUS, 1: TIMEOUT, 2: RANGE, 3: 0}
    for number, (address, outside) in enumerate(((7, False), (8, False), (1, True), (1, False))):
        await around.execute(Request("WS", number, address=address, word=5, out_of_range=outside))
    assert around.take()[1] == [_error(BUS, 0), _error(TIMEOUT, 1), _error(RANGE, 2)]
    await around.execute(Request("H", 4))
    assert around.take()[1] == [_ok("H", number=4, tail="003")]
    for command in ("H", "WS", "W", "R", "RQ", "GP"):
        for number, code in ends.items():
            if code:
                await around.execute(Request(command, number, address=1))
                assert around.take() == ([], [_error(code, number)])
    await around.execute(Request("WS", 3, address=1))
    await around.execute(Request("H", 3))
    assert around.take() == ([], [_ok("H", number=3, tail="003")])
    # An outcome from half a sequence space ago is overwritten, and a session restarts the count of failures.
    await around.execute(Request("K", IDS // 2, field=0x77, plain=True))
    await around.execute(Request("W", IDS // 2, address=1))
    await around.execute(Request("W", IDS // 2, address=1))
    await around.execute(Request("H", IDS // 2 + 1))
    assert around.take()[1][1:] == [
        *(_ok("W", number=IDS // 2), _ok("W", number=IDS // 2), _ok("H", number=IDS // 2 + 1, tail="000")),
    ]


@cocotb.test
async def destructive_reads_are_repeated_from_what_was_kept(dut: SimHandleBase) -> None:
    around = await _in_session(dut, 0xFE, slow=0.3)
    around.memory = {1: 11}
    await around.execute(Request("RQ", 0xFE, address=1, count=3))
    await around.execute(Request("R", 0xFF, address=1))
    await around.execute(Request("R", 0x100, address=1))
    around.memory[1] = 12
    await around.execute(Request("WK", 0x101, address=1, word=3, words=[1]))
    around.take()
    around.committed.clear()
    await around.execute(Request("RQ", 0xFE, address=1, count=3))
    await around.execute(Request("WK", 0x101, address=1, word=3, words=[1]))
    assert around.take() == ([], [_ok("RQ", number=0xFE, words=3), _ok("WK", number=0x101, words=1)])
    assert around.committed == [11, 11, 11, 12]
    # Without an ID no word is kept.
    await around.execute(Request("RQ", address=1, count=3))
    around.committed.clear()
    await around.execute(Request("RQ", 0xFE, address=1, count=3))
    assert around.committed == [11, 11, 11]


@cocotb.test
async def what_is_not_well_formed_is_answered_without_its_id_and_not_counted(dut: SimHandleBase) -> None:
    around = await _in_session(dut)
    for code in (1, 2, 3, 7, 9):
        await around.execute(Request("W", number=0, address=1, word=5, error=code))
    await around.execute(Request("W", number=0, address=1, out_of_range=True))
    await around.execute(Request("R", number=1, address=1))
    accesses, answers = around.take()
    assert accesses == [_read(1)]
    assert answers[:6] == [*(_error(code) for code in (1, 2, 3, 7, 9)), _error(RANGE, 0)]


@cocotb.test
async def what_is_about_groups_begins_an_epoch_between_two_samples(dut: SimHandleBase) -> None:
    around = await _begin(dut, slow=0.3)
    around.is_set = {3}
    epoch = 0
    for command in ("GS", "GN", "GX", "GP", "H", "R", "GS"):
        for silent in (True, False):
            await around.execute(Request(command, group=3, count=2, words=[1, 2], silent=silent))
            epoch ^= command.startswith("G") and not silent
            assert dut.epoch.value == epoch, command
    # Rejected requests begin an epoch too, whatever their error.
    for request in (
        Request("GX", group=4),
        Request("GS", group=3, out_of_range=True),
        Request("GP", group=3, error=3),
    ):
        around.operations.clear()
        await around.execute(request)
        epoch ^= 1
        assert (dut.epoch.value, around.operations) == (epoch, [("nothing", [])])
    # A session discards the waiting samples and begins no epoch. A repetition begins one, so samples from before are
    # sent before its answer.
    await around.execute(Request("K", 0, plain=True))
    await around.execute(Request("GX", IDS - 1, group=3))
    assert dut.epoch.value == epoch


@cocotb.test
async def groups_are_set_with_their_addresses_and_asked_for_by_number(dut: SimHandleBase) -> None:
    around = await _in_session(dut)
    await around.execute(Request("GN", group=3))
    around.is_set = {3}
    await around.execute(Request("GS", group=3, count=4, words=[9, 8, 7, 6]))
    for command in ("GN", "GP", "GX"):
        await around.execute(Request(command, group=3))
    await around.execute(Request("GP", number=0, group=4))
    operations = ["nothing", "stop", "set", "start", "publish", "stop", "nothing"]
    addresses = {"set": [9, 8, 7, 6]}
    assert around.operations == [(operation, addresses.get(operation, [])) for operation in operations]
    assert around.take()[1] == [
        _error(RANGE),
        *(_ok(command, pair=3) for command in ("GS", "GN", "GP", "GX")),
        _error(RANGE, 0),
    ]


@cocotb.test
async def a_read_waits_for_room_in_the_ring_before_it_begins(dut: SimHandleBase) -> None:
    around = await _in_session(dut)
    requests = [
        (Request("R", address=1), 1),
        (Request("RM", address=1, count=9), 9),
        (Request("R", 0, address=1), 1),
        (Request("RM", 1, address=1, count=9), 9),
    ]
    # The requests with an ID a second time, as repetitions.
    for request, needed in requests + requests[2:]:
        around.room = needed - 1
        task = cocotb.start_soon(around.execute(request))
        await ClockCycles(dut.clk, 40)
        assert around.take() == ([], [])
        around.room = 256
        await task
        accesses, answers = around.take()
        assert (len(accesses), len(answers)) == (needed, 1)


@cocotb.test
async def modes_of_send_immediate_mark_the_answers_after_them(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    for mode, mark in ((1, NOW), (0, NONE), (2, WHEN_IDLE), (1, NOW)):
        await around.execute(Request("I", group=mode))
        await around.execute(Request("H"))
        assert around.take()[1] == [_ok("I", pair=mode, mark=mark), _ok("H", mark=mark)]
    await around.execute(Request("K", number=0))
    assert around.take()[1] == [_opened(0, mark=WHEN_IDLE)]


@cocotb.test
async def of_what_is_sent_to_all_a_stateless_write_is_executed_and_nothing_answered(dut: SimHandleBase) -> None:
    around = await _begin(dut)
    around.failures = {2: BUS}
    for request in (
        Request("W", address=1, word=5, silent=True),
        Request("RM", address=1, count=1, silent=True),
        Request("Q", silent=True),
        Request("K", 0, silent=True),
        Request("H", error=1, silent=True),
        Request("WS", address=1, word=5, silent=True),
        Request("WS", address=2, word=5, silent=True),
        Request("WS", address=1, word=5, silent=True, out_of_range=True),
    ):
        await around.execute(request)
    await around.execute(Request("R", address=1, plain=True))
    accesses, answers = around.take()
    assert [access.address for access in accesses] == [1, 2, 1]
    assert answers == [_ok("R", address=True, words=1, plain=True)]
    assert around.committed == [5]


@cocotb.test
async def a_reset_in_any_state_begins_anew(dut: SimHandleBase) -> None:
    around = await _in_session(dut, slow=0.3)
    rng = random.Random(4)
    for cycles in range(40):
        request = rng.choice((Request("RM", count=3), Request("WM", count=2, words=[1, 2]), Request("GS", count=2)))
        task = cocotb.start_soon(around.execute(request))
        await ClockCycles(dut.clk, 1 + cycles % 20)
        task.cancel()
        dut.request_valid.value = 0
        dut.rst.value = 1
        await RisingEdge(dut.clk)
        dut.rst.value = 0
        await ClockCycles(dut.clk, 12)
        around.take()
        # The session before has ended.
        await around.execute(Request("H", number=0))
        await around.execute(Request("K", number=0))
        await around.execute(Request("H", number=0))
        assert around.take()[1] == [
            *(_error(NO_SESSION, 0, tail="1234"), _opened(0), _ok("H", number=0, tail="000")),
        ]


@cocotb.test
async def random_requests_are_executed_as_the_rules_say_under_back_pressure(dut: SimHandleBase) -> None:
    around = await _in_session(dut, slow=0.5)
    around.failures = {13: BUS, 14: TIMEOUT}
    rng, memory, expected = random.Random(12), {}, 0
    for _ in range(250):
        command = rng.choice(("R", "RM", "W", "WM", "WK", "H"))
        count = rng.randrange(1, 6) if command in ("RM", "WM") else 1
        address, words = rng.randrange(12), [rng.getrandbits(32) for _ in range(count)]
        address = rng.choice((13, 14)) if rng.random() < 0.1 else address
        number = (expected + rng.choice((0, 0, 0, -1, -2000, 1, 2000))) % IDS
        distance = (number - expected) % IDS
        mask = words[0]
        request = Request(command, number, address, count, word=words[-1], words=words)
        await around.execute(request)
        accesses, answers = around.take()
        repeated_read = distance >= IDS // 2 and command in ("R", "RM")
        if distance and not repeated_read:
            assert accesses == [], request
            continue
        expected = (expected + (distance == 0)) % IDS
        if command == "H":
            assert (accesses, answers) == ([], [_ok("H", number=number, tail="000")])
            continue
        reached = next((place for place in range(count) if address + place in around.failures), count)
        for place in range(reached):
            old = memory.get(address + place, 0)
            if command in ("W", "WM"):
                memory[address + place] = words[place]
            elif command == "WK":
                memory[address] = old & ~mask | words[-1] & mask
        assert around.memory == memory, request
        assert len(answers) == 1
        assert (answers[0].message == ERROR) == (reached < count), request
        assert answers[0].number == number

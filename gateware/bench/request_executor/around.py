"""The surroundings of the executor: the decoder's request, the bus master, the response ring, groups, and the answer.

One task simulates them all, one cycle at a time; outputs that are combinational in the gateware change within the
cycle.
"""

from __future__ import annotations

import random
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import NextTimeStep, ReadOnly, RisingEdge

from gateware.bench.streams import start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

COMMANDS = ("R", "RM", "RQ", "WK", "W", "WM", "WQ", "WS", "GS", "GN", "GX", "GP", "I", "H", "Q", "K")
ERROR, OUT_OF_SEQUENCE = 16, 17
"""Messages that are no requests; the other messages have the numbers of their commands."""
OPERATIONS = ("set", "start", "stop", "publish", "stop all", "nothing")


@dataclass
class Request:
    """A frame as the decoder outputs it; `words` are in the request memory."""

    command: str
    number: int | None = None
    address: int = 0
    count: int = 1
    group: int = 0
    word: int = 0
    words: list[int] = field(default_factory=list)
    error: int = 0
    out_of_range: bool = False
    plain: bool = False
    silent: bool = False
    asks: bool = False
    """True for a `K` without fields."""
    field: int = 0x1234
    """Number of the session of a `K`, or the CRC residue of a request outside of a session."""


@dataclass(frozen=True)
class Access:
    """One access on the bus."""

    write: bool
    address: int
    word: int | None
    """Word written; None for a read."""
    more: bool
    exclusive: bool


@dataclass(frozen=True)
class Answer:
    """An answer that the frame writer accepted."""

    message: int
    number: int | None
    address: bool
    pair: int | None
    words: int
    plain: bool
    mark: int
    tail: str = ""


class Around:
    """Simulates the surroundings of the executor, and records its requests to them."""

    def __init__(self, dut: SimHandleBase, *, seed: int = 1, slow: float = 0.0) -> None:
        self.dut = dut
        self.accesses: list[Access] = []
        self.operations: list[tuple[str, list[int]]] = []
        """Operations on groups, with the addresses that were written to the list before each."""
        self.answers: list[Answer] = []
        self.committed: list[int] = []
        """Words in the response ring that belong to answers."""
        self.failures: dict[int, int] = {}
        """Errors of the addresses that fail."""
        self.memory: dict[int, int] = {}
        self.is_set: set[int] = set()
        self.room = 256
        self.slow = slow
        self._rng = random.Random(seed)
        self._trial: list[int] = []
        self._list: dict[int, int] = {}
        self._request = Request("H")
        self._number = 0
        self._tail_left: int | None = None

    async def begin(self) -> None:
        """Reset, and start the simulation of the surroundings."""
        self.dut.access_last.value = 1
        for name in ("request_valid", "answer_taken", "access_granted", "access_done", "access_failure", "group_done"):
            getattr(self.dut, name).value = 0
        for name in ("access_read_data", "memory_word", "group_is_set", "tail_left", "tail_taken"):
            getattr(self.dut, name).value = 0
        self._show(Request("H"))
        self.dut.ring_room.value = self.room
        await start(self.dut.clk, self.dut.rst)
        cocotb.start_soon(self._run())

    def _show(self, request: Request) -> None:
        dut = self.dut
        self._request = request
        dut.request_command.value = COMMANDS.index(request.command)
        dut.request_has_id.value = request.number is not None and request.command != "K"
        dut.request_id.value = request.number or 0
        dut.request_plain.value, dut.request_silent.value = request.plain, request.silent
        dut.request_error.value, dut.request_out_of_range.value = request.error, request.out_of_range
        dut.request_address.value, dut.request_count.value = request.address, request.count
        dut.request_group.value, dut.request_word.value = request.group, request.word
        dut.request_asks.value, dut.request_number.value = request.asks, request.field
        self._number = request.field

    async def execute(self, request: Request, most_cycles: int = 5000) -> None:
        """Send a request and wait until the executor is ready for the next one."""
        dut = self.dut
        self._show(request)
        # The ID is stable for some cycles before the end of its frame.
        for _ in range(2):
            await RisingEdge(dut.clk)
        dut.request_valid.value = 1
        for cycle in range(most_cycles):
            await ReadOnly()
            if cycle and dut.hold.value == 0:
                await RisingEdge(dut.clk)
                return
            await RisingEdge(dut.clk)
            if not cycle:
                dut.request_valid.value = 0
        raise AssertionError(f"{request} was not executed in {most_cycles} cycles")

    async def _run(self) -> None:
        dut, rng = self.dut, self._rng
        access: Access | None = None
        waits, told, index, busy = 0, False, 0, False
        while True:
            # The request memory and `is_set` follow their index one cycle later.
            dut.memory_word.value = self._request.words[index] if index < len(self._request.words) else 0xDEAD
            dut.group_is_set.value = self._request.group in self.is_set
            dut.ring_room.value = self.room - len(self._trial)
            await ReadOnly()
            granted = not busy and dut.access_request.value == 1 and rng.random() >= self.slow
            taken = dut.answer_valid.value == 1 and rng.random() >= self.slow
            done = dut.group_request.value == 1 and rng.random() >= self.slow
            told = busy and waits == 0
            if dut.tail.value == 1 and self._tail_left is None:
                self._tail_left = int(dut.tail_more.value)
            sends = self._tail_left is not None and rng.random() >= self.slow
            await NextTimeStep()
            dut.tail_left.value, dut.tail_taken.value = self._tail_left or 0, sends
            dut.access_granted.value, dut.access_done.value = granted, told
            if told:
                dut.access_failure.value = self._finish(access)
            dut.answer_taken.value, dut.group_done.value = taken, done
            await ReadOnly()
            self._note(told=told, taken=taken, done=done)
            shifts = dut.number_shift.value == 1
            if sends:
                self._send_digit()
            if granted:
                access, busy, waits = self._access(), True, 1 + (rng.randrange(6) if self.slow else 0)
            elif told:
                busy = False
            elif busy:
                waits -= 1
            index = int(dut.memory_index.value)
            await RisingEdge(dut.clk)
            dut.access_granted.value = dut.access_done.value = dut.answer_taken.value = dut.group_done.value = 0
            dut.tail_taken.value = 0
            if shifts:
                self._number = self._number << 4 & 0xFFFF | self._number >> 12
                dut.request_number.value = self._number

    def _note(self, *, told: bool, taken: bool, done: bool) -> None:
        """Record the executor's outputs in a cycle in which an access, an answer or an operation ends."""
        dut = self.dut
        if dut.list_write.value == 1:
            self._list[int(dut.list_index.value)] = int(dut.memory_word.value)
        if told and dut.ring_write.value == 1:
            self._trial.append(int(dut.access_read_data.value))
        if taken:
            self.answers.append(self._answer())
        if dut.ring_commit.value == 1:
            self.committed += self._trial
            self._trial = []
        if dut.ring_rollback.value == 1:
            self._trial = []
        if done:
            addresses = [self._list[place] for place in sorted(self._list)]
            self.operations.append((OPERATIONS[int(dut.group_operation.value)], addresses))
            self._list.clear()

    def _send_digit(self) -> None:
        assert self._tail_left is not None
        last = self.answers[-1]
        self.answers[-1] = replace(last, tail=f"{last.tail}{int(self.dut.tail_digit.value):X}")
        self._tail_left = self._tail_left - 1 if self._tail_left else None

    def _access(self) -> Access | None:
        """Return the access that is granted, or None if it does not reach the bus."""
        dut = self.dut
        if dut.access_kept.value == 1:
            return None
        write = dut.access_write.value == 1
        word = int(dut.access_data.value) if write else None
        more, exclusive = dut.access_more.value == 1, dut.access_exclusive.value == 1
        return Access(write, int(dut.access_address.value), word, more, exclusive)

    def _finish(self, access: Access | None) -> int:
        """Make an access and return its error."""
        if access is None:
            self.dut.access_read_data.value = int(self.dut.kept_word.value)
            return 0
        self.accesses.append(access)
        error = self.failures.get(access.address, 0)
        if error:
            return error
        if access.word is not None:
            self.memory[access.address] = access.word
        else:
            self.dut.access_read_data.value = self.memory.get(access.address, 0)
        return 0

    def _answer(self) -> Answer:
        dut = self.dut
        number = int(dut.answer_id.value) if dut.answer_has_id.value == 1 else None
        pair = int(dut.answer_pair.value) if dut.answer_has_pair.value == 1 else None
        has_address, words = dut.answer_has_address.value == 1, int(dut.answer_words.value)
        message, mark = int(dut.answer_message.value), int(dut.answer_mark.value)
        return Answer(message, number, has_address, pair, words, dut.answer_plain.value == 1, mark)

    def take(self) -> tuple[list[Access], list[Answer]]:
        """Return the accesses and answers since the last call."""
        accesses, answers = self.accesses, self.answers
        self.accesses, self.answers = [], []
        return accesses, answers

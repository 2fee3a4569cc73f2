"""The compiled gateware with slaves that answer late, twice or never, with err, rty and stall.

Every access has a plan: when the slave answers and how, and so the result that the gateway must report. Each reply has
a unique word, so the host's answers reveal a reply that the gateway took for another access.

On a pipelined bus several reads of a block or sample are in flight at once. Only their order distinguishes their
answers, so the slave keeps the order even if it is late.
"""

from __future__ import annotations

import random
from collections import deque
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

import pytest

from support.compilers import needs_cxx
from unity_link.virtual.rtl import RtlGateway
from unity_link.virtual.rtl.library import Reply, SlaveFunction

if TYPE_CHECKING:
    import ctypes
    from collections.abc import Iterator, Sequence

pytestmark = [pytest.mark.rtl, needs_cxx]

TIMEOUT = 1024
"""`bus_timeout` of both configurations."""
LAST_UNHEARD = 2 * TIMEOUT + 1
"""Cycles after a strobe that timed out during which the gateway still ignores answers."""
ACK, ERR, RTY = 0, 1, 3
NOTHING = ACK, -1
"""An answer and a word for no reply."""
PATTERNS = {"default": 0, "walker": 0x8041_0C12_0F00_1124}
"""Bit patterns of the cycles in which the slave of each configuration stalls; only the second one is pipelined."""
MOST_STALLS = 4
REQUESTS_AT_ONCE = 16


class _Attempt(NamedTuple):
    """A strobe that the slave must receive, and the replies to it: cycles after it, answer, word."""

    address: int
    written: int | None
    replies: list[tuple[int, int, int]]


class _Outcome(NamedTuple):
    """Result that the gateway must report of an access: the word, or an error of the protocol."""

    word: int
    error: int


class _Read(NamedTuple):
    """One of several reads that may be in flight at once: the slave's answers to its strobes."""

    answers: deque[tuple[int, int]]
    """Answer and word of each strobe."""
    is_long: bool
    """True if the read takes nearly as long as the time-out permits."""


@dataclass
class _Stream:
    """The cycles of one transaction from the slave's view."""

    single: _Attempt | None = None
    reads: dict[int, _Read] = field(default_factory=dict)
    needed: list[_Read] = field(default_factory=list)
    """Reads that must occur; if one of them fails, the gateway may have requested later ones or not."""
    late: int | None = None
    """The address from which on the answers come after the time-out."""
    is_sent_away: bool = False
    last: int = 0
    """The cycle of the last reply, or of the first strobe."""
    last_late: int = 0
    """The last cycle for late answers, if there are any."""

    def has_timed_out(self, cycle: int) -> bool:
        """Return true if a strobe in that cycle belongs to another access, because the bus access has timed out."""
        return 0 < self.last_late < cycle + TIMEOUT

    @property
    def may_end(self) -> bool:
        """Return true if the gateway may leave out the remaining strobes."""
        return self.single is None and not any(read.answers for read in self.needed)


class _Unruly:
    """A slave that follows a plan, made with each request; it records where the gateway deviates."""

    def __init__(self, gateway: RtlGateway, stalls: int, last_reply: int) -> None:
        info = gateway.info
        self.faults: list[str] = []
        self.accesses = 0
        self._rng = random.Random(13)
        self._stalls = MOST_STALLS if stalls else 0
        self._last_reply = last_reply
        self._word_bits = info.data_bits
        self._streams: deque[_Stream] = deque()
        self._gateway = gateway
        self.reads_ahead = bool(stalls)
        self._function = SlaveFunction(self._answer)
        gateway._library.ul_set_slave(gateway._handle, self._function, None)
        gateway._library.ul_set_stalls(gateway._handle, stalls)

    def word(self) -> int:
        return self._rng.getrandbits(self._word_bits)

    def plan(self, address: int, written: int | None = None) -> _Outcome:
        """Plan the next access; return its required result."""
        self.accesses += 1
        # Smallest and largest number of cycles from the first strobe to that of this attempt.
        least, most = 0, self._stalls
        while self._rng.random() < 0.05 and most < TIMEOUT // 2:
            after = self._soon()
            self._attempt(address, written, [(after, RTY)], (1,))
            least, most = least + after + 2, most + after + 2 + self._stalls
        roll = self._rng.random()
        if roll < 0.03:
            return self._late(address, written, least, most)
        if roll < 0.031 and not self._stalls:
            return self._sent_away_for_ever(address, written, least)
        after = self._soon() if self._rng.random() < 0.95 else self._rng.randrange(1, TIMEOUT - most)
        answer = ERR if self._rng.random() < 0.1 else ACK
        word = self._attempt(address, written, [(after, answer)], (1, 2))
        return _Outcome(word, 4 if answer == ERR else 0)

    def _soon(self) -> int:
        return 1 + int(self._rng.expovariate(0.8))

    def _late(self, address: int, written: int | None, least: int, most: int) -> _Outcome:
        """Plan up to two answers after the time-out, including the first and the last cycle of the quarantine."""
        first, last = TIMEOUT - least, self._last_reply - most
        replies = [
            (self._rng.choice((first, last, self._rng.randrange(first, last + 1))), self._rng.choice((ACK, ERR, RTY)))
            for _ in range(self._rng.randrange(3))
        ]
        self._attempt(address, written, replies)
        return _Outcome(0, 5)

    def _sent_away_for_ever(self, address: int, written: int | None, begun: int) -> _Outcome:
        while begun < TIMEOUT:
            after = self._soon()
            self._attempt(address, written, [(after, RTY)], (1,))
            begun += after + 2
        return _Outcome(0, 5)

    def _attempt(
        self, address: int, written: int | None, replies: list[tuple[int, int]], again: tuple[int, ...] = ()
    ) -> int:
        """Add an attempt; return the word of its first reply. The reply may be followed by a second one."""
        told = [(after, answer, self.word()) for after, answer in replies]
        if again and self._rng.random() < 0.2:
            told.append((replies[0][0] + self._rng.choice(again), self._rng.choice((ACK, ERR, RTY)), self.word()))
        self._streams.append(_Stream(_Attempt(address, written, told)))
        return told[0][2] if told else 0

    def plan_reads(self, addresses: Sequence[int]) -> tuple[list[int], int]:
        """Plan the reads of a block or sample; return their words and the error, if any."""
        if len(addresses) == 1 or not self.reads_ahead:
            return self._plan_one_by_one(addresses)
        self.accesses += len(addresses)
        # With any two of these three answers, the result does not depend on how far the gateway has read ahead.
        never = self._rng.choice((ACK, ERR, RTY))
        stream, words, error = _Stream(), [], 0
        lost = self._rng.choice(addresses) if self._rng.random() < 0.02 else None
        for address in addresses:
            read = self._read(away=never != RTY and lost is None, fails=never != ERR and lost is None)
            stream.is_sent_away |= len(read.answers) > 1
            if lost is None and never != ACK and stream.late is None and self._rng.random() < 0.03:
                stream.late = address
            if not error:
                stream.needed.append(read)
                error = 5 if address in (stream.late, lost) else 4 * (read.answers[-1][0] == ERR)
            if address == lost:
                read.answers[0] = NOTHING
            stream.reads[address] = read
            words.append(read.answers[-1][1])
        if error == 5:
            stream.needed = [stream.reads[address] for address in (stream.late, lost) if address is not None]
        self._streams.append(stream)
        return words, error

    def _plan_one_by_one(self, addresses: Sequence[int]) -> tuple[list[int], int]:
        words = []
        for address in addresses:
            outcome = self.plan(address)
            words.append(outcome.word)
            if outcome.error:
                return words, outcome.error
        return words, 0

    def _read(self, *, away: bool, fails: bool) -> _Read:
        answers: deque[tuple[int, int]] = deque()
        while away and self._rng.random() < 0.08:
            answers.append((RTY, self.word()))
        answers.append((ERR if fails and self._rng.random() < 0.05 else ACK, self.word()))
        return _Read(answers, is_long=self._rng.random() < 0.03)

    def finish(self) -> None:
        """Record planned strobes that did not come."""
        missing = sum(not stream.may_end for stream in self._streams)
        if missing:
            self.faults.append(f"strobes of {missing} transactions too few")
        self._streams.clear()

    def _answer(
        self, _context: int | None, address: int, write: int, value: int, replies: ctypes._Pointer[Reply]
    ) -> int:
        cycle = int(self._gateway._library.ul_cycles(self._gateway._handle))
        told: list[tuple[int, int, int]] = []
        while self._streams:
            stream = self._streams[0]
            read = stream.reads.get(address)
            if read and read.answers and not write and not stream.has_timed_out(cycle):
                told = self._answer_read(stream, address, read, cycle)
                break
            if stream.single:
                told = self._answer_single(stream.single, address, value if write else None)
                stream.single = None
                break
            if not stream.may_end:
                self.faults.append(f"{address:#x}, {write}, {value:#x} where {stream} was to come")
                return 0
            self._streams.popleft()
        else:
            self.faults.append(f"a strobe at {address:#x} that nobody asked for")
            return 0
        for index, (after, answer, word) in enumerate(told):
            replies[index] = Reply(word, after, answer)
        return len(told)

    def _answer_single(self, attempt: _Attempt, address: int, written: int | None) -> list[tuple[int, int, int]]:
        if (address, written) != (attempt.address, attempt.written):
            self.faults.append(f"{address:#x}, {written} where {attempt} was to come")
        return attempt.replies

    def _answer_read(self, stream: _Stream, address: int, read: _Read, cycle: int) -> list[tuple[int, int, int]]:
        """Answer one of several reads, after the ones before it, in time or late."""
        answer, word = read.answers.popleft()
        stream.last = stream.last or cycle
        if address == stream.late:
            # A read that ended with rty, and later ones that wait for it, are not passed on when they are answered.
            first, last = (9, 120) if stream.is_sent_away else (1, 3)
            stream.last_late = stream.last + 3 * TIMEOUT - last
            read.answers.clear()
            stream.last = self._rng.choice(
                (
                    stream.last + TIMEOUT + first,
                    self._rng.randrange(stream.last + TIMEOUT + first, stream.last_late + 1),
                )
            )
        elif stream.last_late:
            if stream.last == stream.last_late or self._rng.random() < 0.3:
                return []
            stream.last = self._rng.choice((stream.last + 1, stream.last_late))
        elif read.is_long and not stream.is_sent_away:
            stream.last = max(cycle, stream.last + self._rng.randrange(1, TIMEOUT - MOST_STALLS)) + 1
        else:
            stream.last = max(cycle + self._soon(), stream.last + 1)
        return [(stream.last - cycle, answer, word)] if (answer, word) != NOTHING else []


class _Requests:
    """Makes requests of every kind that uses the bus, with their required answers."""

    def __init__(self, gateway: RtlGateway, slave: _Unruly) -> None:
        self._slave = slave
        self._rng = random.Random(14)
        self._address_bits = gateway.info.address_bits
        self._digits = gateway.info.address_digits, gateway.info.data_digits
        self._sequence = 0
        self.group = (1, 0x77, 5, 9, 0xF0, 3)

    def address(self, value: int) -> str:
        return f"{value:0{self._digits[0]}X}"

    def word(self, value: int) -> str:
        return f"{value:0{self._digits[1]}X}"

    def next(self) -> tuple[str, str]:
        """Return a request, and the lines of its answer."""
        kind = self._rng.choice(("R", "R", "R", "W", "W", "WS", "RM", "RQ", "WM", "WQ", "WK", "GP"))
        address = self._rng.randrange((1 << self._address_bits) - 9)
        if kind == "GP":
            return self._publish()
        if kind == "WK":
            return self._masked(address)
        if kind in ("R", "W", "WS"):
            words = [self._slave.word()] * (kind != "R")
            outcome = self._slave.plan(address, words[0] if words else None)
            text = self.address(address)
            answer = "" if kind == "WS" else f"{kind}{text}{'' if words else self.word(outcome.word)}"
            return f"{kind}{text}{''.join(map(self.word, words))}", _or_error(answer, outcome.error)
        return self._block(kind, address)

    def _block(self, kind: str, address: int) -> tuple[str, str]:
        count, step = self._rng.randrange(1, 9), int(kind[1] == "M")
        words = [self._slave.word() for _ in range(count)] if kind[0] == "W" else []
        error = 0
        read: list[int] = []
        if kind == "RM":
            read, error = self._slave.plan_reads(range(address, address + count))
        else:
            for index in range(count):
                outcome = self._slave.plan(address + step * index, words[index] if words else None)
                read.append(outcome.word)
                if error := outcome.error:
                    break
        head = f"{kind}{self.address(address)}"
        text = "".join(map(self.word, words)) if words else f"{count:02X}"
        answer = f"{head}{count:02X}{'' if words else ''.join(map(self.word, read))}"
        return head + text, _or_error(answer, error)

    def _masked(self, address: int) -> tuple[str, str]:
        mask, word = self._slave.word(), self._slave.word()
        old = outcome = self._slave.plan(address)
        if not old.error:
            outcome = self._slave.plan(address, old.word & ~mask | word & mask)
        text = self.address(address)
        return f"WK{text}{self.word(mask)}{self.word(word)}", _or_error(f"WK{text}{self.word(old.word)}", outcome.error)

    def _publish(self) -> tuple[str, str]:
        number = self._sequence
        self._sequence = (number + 1) % 256
        words, error = self._slave.plan_reads(self.group)
        sample = "" if error else f"P00{number:02X}{''.join(map(self.word, words))}\r\n"
        return "GP00", f"{sample}GP00\r\n"


def _or_error(answer: str, error: int) -> str:
    if error:
        return f"X{error:02X}\r\n"
    return f"{answer}\r\n" if answer else ""


def _faults(configuration: str, accesses: int, last_reply: int) -> Iterator[str]:
    """Yield the errors of the gateware in a number of random accesses."""
    gateway, stalls = RtlGateway(configuration), PATTERNS[configuration]
    slave = _Unruly(gateway, stalls, last_reply)
    requests = _Requests(gateway, slave)
    listed = "".join(map(requests.address, requests.group))
    assert gateway.receive(f"GS002000010{len(requests.group)}{listed}\r".encode(), 0.0) == b"GS00\r\n"
    while slave.accesses < accesses:
        asked = [requests.next() for _ in range(REQUESTS_AT_ONCE)]
        answered = gateway.receive("".join(f"{request}\r" for request, _ in asked).encode(), 0.0).decode()
        expected = "".join(answer for _, answer in asked)
        slave.finish()
        yield from slave.faults
        slave.faults.clear()
        if answered != expected:
            yield f"{asked}: {answered!r}"


@pytest.mark.parametrize("configuration", PATTERNS)
def test_no_answer_is_taken_for_another_access_and_the_next_one_works(configuration: str) -> None:
    assert next(_faults(configuration, 10_000, LAST_UNHEARD), None) is None


@pytest.mark.campaign
@pytest.mark.parametrize("configuration", PATTERNS)
def test_no_answer_is_taken_for_another_access_in_half_a_million(configuration: str) -> None:
    assert next(_faults(configuration, 500_000, LAST_UNHEARD), None) is None


@pytest.mark.parametrize(("configuration", "beyond"), [("default", 1), ("walker", 20)])
def test_an_answer_beyond_the_limit_is_detected_as_taken_for_another_access(configuration: str, beyond: int) -> None:
    assert next(_faults(configuration, 10_000, LAST_UNHEARD + beyond), None) is not None

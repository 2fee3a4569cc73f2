"""Bench: the parts of an answer or a sample become its body, character by character."""

from __future__ import annotations

import random
from collections import deque
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import cocotb
from cocotb.triggers import ClockCycles, ReadOnly, RisingEdge

from gateware.bench.streams import Sink, start

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase

LETTERS = ("R", "RM", "RQ", "WK", "W", "WM", "WQ", "WS", "GS", "GN", "GX", "GP", "I", "H", "Q", "K", "X", "N", "P")
"""In the order of their codes; only the gateway sends the last three."""


@dataclass(frozen=True)
class Answer:
    """An answer as the executor requests it, with its words for the response ring."""

    letters: str
    number: int | None = None
    address: int | None = None
    pair: int | None = None
    words: tuple[int, ...] = ()
    plain: int = 0
    mark: int = 0
    tail: str = ""


@dataclass(frozen=True)
class Sample:
    """A sample in the layout of the sample ring."""

    group: int
    sequence: int
    words: tuple[int, ...]
    stamp: int | None = None
    plain: int = 0
    immediate: int = 0
    epoch: int = 0


@dataclass
class Widths:
    """Number of digits of the fields, from the generics."""

    dut: SimHandleBase
    data: int = field(init=False)
    address: int = field(init=False)
    number: int = field(init=False)

    def __post_init__(self) -> None:
        self.data_bits = int(self.dut.data_bits.value)
        self.address_bits = int(self.dut.address_bits.value)
        self.data, self.address = -(-self.data_bits // 4), -(-self.address_bits // 4)
        self.number = int(self.dut.id_digits.value)

    def body(self, frame: Answer | Sample) -> bytes:
        """Return the body of a frame according to the protocol."""
        if isinstance(frame, Sample):
            stamp = "" if frame.stamp is None else f"{frame.stamp:08X}"
            text = f"P{frame.group:02X}{frame.sequence:02X}{stamp}"
        elif frame.letters == "Q":
            return b"Q" + b"0" * 64
        else:
            text = frame.letters if frame.number is None or frame.letters == "K" else frame.letters.lower()
            if frame.number is not None:
                text += f"{frame.number:0{self.number}X}"
            elif frame.address is not None:
                text += f"{frame.address:0{self.address}X}"
            text += "" if frame.pair is None else f"{frame.pair:02X}"
        tail = frame.tail if isinstance(frame, Answer) else ""
        return (text + tail + "".join(f"{word:0{self.data}X}" for word in frame.words)).encode()


class Ring:
    """Read port of a `ul_word_ring`: after `pop`, the next word is valid from the second cycle on."""

    def __init__(self, dut: SimHandleBase, word: str, pop: str, available: str | None = None) -> None:
        self.words: deque[int] = deque()
        self._available = available
        cocotb.start_soon(self._run(dut, getattr(dut, word), getattr(dut, pop)))

    async def _run(self, dut: SimHandleBase, word: SimHandleBase, pop: SimHandleBase) -> None:
        at_port = filled = 0
        shown: int | None = None
        while True:
            if at_port != shown:
                shown = word.value = at_port
            # `available` reports a sample once it is complete, some cycles after its first word.
            filled = filled + 1 if self.words else 0
            if self._available:
                getattr(dut, self._available).value = filled > 3
            at_port = self.words[0] if self.words else 0
            await ReadOnly()
            popped = pop.value == 1
            await RisingEdge(dut.clk)
            if popped:
                self.words.popleft()


class Writer:
    """Passes frames to the entity and receives bodies from it."""

    def __init__(self, dut: SimHandleBase) -> None:
        self.dut = dut
        self.widths = Widths(dut)
        self.responses = Ring(dut, "response_word", "response_pop")
        self.samples = Ring(dut, "sample_word", "sample_pop", "sample_available")
        signals = (dut.out_data, dut.out_last, dut.out_plain, dut.out_mark)
        self.sink = Sink(dut.clk, signals, dut.out_valid, dut.out_ready)

    def put_sample(self, sample: Sample) -> None:
        """Write a sample to its ring."""
        top = len(self.dut.sample_word)
        flags = (sample.stamp is not None) << 2 | sample.plain << 1 | sample.immediate
        words = 1 + (sample.stamp is not None) + len(sample.words)
        header = sample.group << 24 | sample.sequence << 16 | words << 7 | flags << 4 | sample.epoch << 3
        self.samples.words.append(header << top - 32)
        if sample.stamp is not None:
            self.samples.words.append(sample.stamp << top - 32)
        self.samples.words.extend(word << top - 4 * self.widths.data for word in sample.words)

    async def answer(self, answer: Answer) -> None:
        """Offer an answer until it is accepted, then change its fields."""
        dut, rng = self.dut, random.Random(3)
        self.responses.words.extend(answer.words)
        dut.answer_message.value = LETTERS.index(answer.letters)
        dut.answer_lower.value = answer.number is not None and answer.letters != "K"
        dut.answer_plain.value, dut.answer_mark.value = answer.plain, answer.mark
        dut.answer_has_id.value, dut.answer_id.value = answer.number is not None, answer.number or 0
        dut.answer_has_address.value, dut.answer_address.value = answer.address is not None, answer.address or 0
        dut.answer_has_pair.value, dut.answer_pair.value = answer.pair is not None, answer.pair or 0
        dut.answer_words.value = len(answer.words)
        dut.answer_valid.value = 1
        while True:
            await ReadOnly()
            taken = dut.answer_taken.value == 1
            await RisingEdge(dut.clk)
            if taken:
                break
        dut.answer_valid.value = 0
        await self._send_tail(answer.tail)
        for signal in (dut.answer_message, dut.answer_pair, dut.answer_id, dut.answer_address, dut.answer_words):
            signal.value = rng.getrandbits(len(signal))

    async def _send_tail(self, tail: str) -> None:
        """Drive the digits of a tail as they are requested; the other inputs of the answer may change meanwhile."""
        dut, sent = self.dut, 0
        dut.tail.value, dut.tail_more.value = bool(tail), max(len(tail) - 1, 0)
        while sent < len(tail):
            dut.tail_digit.value = int(tail[sent], 16)
            await ReadOnly()
            if dut.tail_taken.value == 1:
                assert dut.tail_left.value == len(tail) - 1 - sent
                sent += 1
            await RisingEdge(dut.clk)
        dut.tail.value = 0

    async def bodies(self, count: int) -> list[tuple[bytes, int, int]]:
        """Wait for bodies; return each with plain and mark, which are valid with its last character."""
        whole = seen = 0
        for _ in range(30_000):
            whole += sum(entry[1] for entry in self.sink.received[seen:])
            seen = len(self.sink.received)
            if whole >= count:
                break
            await RisingEdge(self.dut.clk)
        bodies, body = [], bytearray()
        for character, last, plain, mark in self.sink.received:
            body.append(character)
            if last:
                bodies.append((bytes(body), plain, mark))
                body.clear()
        assert not body
        self.sink.received.clear()
        return bodies

    def expected(self, frame: Answer | Sample) -> tuple[bytes, int, int]:
        """Return the expected result of `bodies` for a frame."""
        mark = frame.mark if isinstance(frame, Answer) else 2 * frame.immediate
        return self.widths.body(frame), frame.plain, mark


async def _begin(dut: SimHandleBase) -> Writer:
    for name in ("message", "lower", "plain", "mark", "has_id", "has_address", "has_pair", "id", "address", "pair"):
        getattr(dut, f"answer_{name}").value = 0
    for name in (
        "tail",
        "tail_more",
        "tail_digit",
        "answer_words",
        "answer_valid",
        "response_word",
        "sample_available",
        "sample_word",
        "out_ready",
    ):
        getattr(dut, name).value = 0
    dut.epoch.value = 0
    await start(dut.clk, dut.rst)
    return Writer(dut)


def _random_answer(widths: Widths, rng: random.Random) -> Answer:
    number, address = rng.getrandbits(4 * widths.number), rng.getrandbits(widths.address_bits)
    words = tuple(rng.getrandbits(widths.data_bits) for _ in range(rng.choice((1, 1, 2, 5, 30))))
    pair, marks = rng.randrange(256), {"plain": rng.randrange(2), "mark": rng.randrange(3)}
    return rng.choice(
        (
            Answer("R", address=address, words=words[:1], **marks),
            Answer("R", number=number, words=words[:1], **marks),
            Answer("RM", address=address, pair=len(words), words=words, **marks),
            Answer("RQ", number=number, words=words, **marks),
            Answer("WK", address=address, words=words[:1], **marks),
            Answer("W", address=address, **marks),
            Answer("WM", address=address, pair=pair, **marks),
            Answer("WQ", number=number, **marks),
            Answer("GP", pair=pair, **marks),
            Answer("H", number=number, **marks),
            Answer("K", number=number, tail="12345ABC", **marks),
            Answer("K", tail="5ABC", **marks),
            Answer("H", number=number, tail="F01", **marks),
            Answer("X", number=number, pair=10, tail="1", **marks),
            Answer("X", pair=pair & 15, **marks),
            Answer("X", number=number, pair=pair & 15, **marks),
            Answer("N", number=number, **marks),
        )
    )


def _random_sample(widths: Widths, rng: random.Random) -> Sample:
    return Sample(
        rng.randrange(256),
        rng.randrange(256),
        tuple(rng.getrandbits(widths.data_bits) for _ in range(rng.choice((1, 2, 3, 40)))),
        rng.choice((None, rng.getrandbits(32))),
        rng.randrange(2),
        rng.randrange(2),
    )


@cocotb.test
async def every_message_has_its_letters_and_fields(dut: SimHandleBase) -> None:
    writer = await _begin(dut)
    # WS has no answer, and P is for samples.
    for letters in (letters for letters in LETTERS if letters not in ("WS", "P")):
        for number in (None, 0x1F):
            answer = Answer(letters, number=number)
            if letters in ("N", "K", "Q"):
                answer = replace(answer, number=None if letters == "Q" else 0xA5)
            await writer.answer(answer)
            assert await writer.bodies(1) == [writer.expected(answer)]
    await ClockCycles(dut.clk, 3)
    assert dut.busy.value == 0


@cocotb.test
async def fields_stand_in_the_order_of_the_protocol(dut: SimHandleBase) -> None:
    writer = await _begin(dut)
    rng = random.Random(5)
    for _ in range(60):
        answer = _random_answer(writer.widths, rng)
        await writer.answer(answer)
        assert await writer.bodies(1) == [writer.expected(answer)]
    assert not writer.responses.words


@cocotb.test
async def samples_are_sent_as_they_are_laid_out(dut: SimHandleBase) -> None:
    writer = await _begin(dut)
    rng = random.Random(6)
    samples = [_random_sample(writer.widths, rng) for _ in range(40)]
    for sample in samples:
        writer.put_sample(sample)
    assert await writer.bodies(40) == [writer.expected(sample) for sample in samples]
    assert not writer.samples.words


@cocotb.test
async def the_longest_block_and_the_longest_sample_are_sent_whole(dut: SimHandleBase) -> None:
    writer = await _begin(dut)
    rng = random.Random(8)
    words = tuple(rng.getrandbits(writer.widths.data_bits) for _ in range(255))
    answer, sample = Answer("RM", address=1, pair=255, words=words), Sample(255, 255, words, stamp=1)
    writer.put_sample(sample)
    await writer.answer(answer)
    assert {*await writer.bodies(2)} == {writer.expected(answer), writer.expected(sample)}


@cocotb.test
async def answers_and_samples_take_turns(dut: SimHandleBase) -> None:
    writer = await _begin(dut)
    rng = random.Random(7)
    for _ in range(10):
        writer.put_sample(_random_sample(writer.widths, rng))
    while dut.busy.value == 0:
        await RisingEdge(dut.clk)
    for _ in range(10):
        await writer.answer(Answer("H"))
    assert "".join(body[:1].decode() for body, _, _ in await writer.bodies(20)) == "PH" * 10


@cocotb.test
async def the_answer_that_ends_an_epoch_comes_behind_all_its_samples(dut: SimHandleBase) -> None:
    writer = await _begin(dut)
    rng = random.Random(10)
    for epoch in (1, 0, 1):
        before = [replace(_random_sample(writer.widths, rng), epoch=1 - epoch) for _ in range(6)]
        after = [replace(_random_sample(writer.widths, rng), epoch=epoch) for _ in range(3)]
        dut.epoch.value = 1 - epoch
        for sample in before:
            writer.put_sample(sample)
        while dut.busy.value == 0:
            await RisingEdge(dut.clk)
        dut.epoch.value = epoch
        for sample in after:
            writer.put_sample(sample)
        await writer.answer(Answer("H"))
        await writer.answer(Answer("H"))
        bodies = await writer.bodies(11)
        assert "".join(body[:1].decode() for body, _, _ in bodies) == "PPPPPPHPHPP"
        samples = [body for body in bodies if body[0][:1] == b"P"]
        assert samples == [writer.expected(sample) for sample in (*before, *after)]
        await ClockCycles(dut.clk, 3)


@cocotb.test
async def the_characters_of_a_body_follow_each_other_in_every_cycle(dut: SimHandleBase) -> None:
    writer = await _begin(dut)
    sent = gaps = 0
    writer.put_sample(Sample(1, 2, (3, 4, 5), stamp=6))
    giving = cocotb.start_soon(writer.answer(Answer("RM", address=1, pair=4, words=(1, 2, 3, 4))))
    inside = False
    while sent < 2:
        await RisingEdge(dut.clk)
        valid = dut.out_valid.value == 1
        gaps += inside and not valid
        inside = (inside or valid) and not (valid and dut.out_last.value == 1)
        sent += valid and dut.out_last.value == 1
    await giving
    assert gaps == 0


@cocotb.test
async def bodies_survive_back_pressure(dut: SimHandleBase) -> None:
    writer = await _begin(dut)
    writer.sink.pause = 0.4
    rng = random.Random(9)
    answers = [_random_answer(writer.widths, rng) for _ in range(60)]
    samples = [_random_sample(writer.widths, rng) for _ in range(30)]

    async def put_samples() -> None:
        for sample in samples:
            writer.put_sample(sample)
            await ClockCycles(dut.clk, rng.randrange(300))

    putting = cocotb.start_soon(put_samples())
    for answer in answers:
        await writer.answer(answer)
    await putting
    bodies = await writer.bodies(90)
    assert [body for body in bodies if body[0][:1] != b"P"] == [writer.expected(answer) for answer in answers]
    assert [body for body in bodies if body[0][:1] == b"P"] == [writer.expected(sample) for sample in samples]

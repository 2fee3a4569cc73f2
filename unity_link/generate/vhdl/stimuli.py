"""The bench's accesses to a register bank, and the expected results: computed from the signals, not from the bank.

`Signal.encode` gives the words of values, as in every client, so that a bank that passes agrees with the programs
generated from the same spec. Values are random, but reproducible for a spec. Each signal gets several values, all
signals at once, so that a register that answers for another one is detected; each bit is both 0 and 1 at least once.
"""

from __future__ import annotations

import random
from typing import TYPE_CHECKING, NamedTuple

from unity_link.generate.vhdl.types import bit_literal
from unity_link.spec import STAGE_BITS, KindName, Signal

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from unity_link.generate.vhdl.bank import Bank, BankWord, Register, Stage

ROUNDS = 3
_UNUSED_ADDRESSES = 8
"""Number of addresses without a signal that are accessed."""


class Section(NamedTuple):
    """Statements that check one property."""

    title: str
    statements: tuple[str, ...]


class Stimuli:
    """The statements of the bench's process, and the order of the pulses that it watches."""

    def __init__(self, bank: Bank) -> None:
        self._bank = bank
        self._address_bits = bank.interface.address_bits
        self._data_bits = bank.interface.data_bits
        self._given: dict[str, int] = {}
        self._stored: dict[str, int] = {
            register.signal.path: register.signal.reset
            for register in bank.registers
            if register.signal.access.writes or register.has_events
        }
        self._pulsed = dict.fromkeys((register.signal.path for register in bank.pulses), 0)
        """Number of cycles in which each PULSE signal was '1', by path."""
        self._staged: dict[str, int] = {}
        """Values on the stages of schedules, by the path of the signal."""
        self._gathered: dict[int, int] = {}
        """Words written to values of several words that are not complete yet, by address."""
        self._word_at = {word.address: word for word in bank.words}
        self._first_strobe: dict[int, int] = {}
        strobes: list[Register] = []
        for word in bank.words:
            self._first_strobe[word.address] = len(strobes)
            strobes += self._struck(word)
        self.strobes = tuple(strobes)
        """Registers whose `written` pulses are watched; those of one word are adjacent."""

    @property
    def sections(self) -> Iterator[Section]:
        """Yield the sections of the bench, in order."""
        parts = (
            ("After reset, each register has the value of its RESET, or 0.", self._reset()),
            *((f"Values from hardware can be read, round {one}.", self._reads(one)) for one in range(1, ROUNDS + 1)),
            *((f"Written values reach hardware, round {one}.", self._writes(one)) for one in range(1, ROUNDS + 1)),
            (
                "While a lease is not armed, guarded signals are safe and refuse writes; as while it finishes.",
                self._leases(),
            ),
            ("Values on a stage are committed at once, while the lease is armed.", self._schedules()),
            ("Fields of one word are written by reading it first.", self._fields()),
            ("Accesses in a row take a cycle each.", self._rows()),
            ("A value of several words is read from one instant.", self._instants()),
            ("A sample is read from one instant, also between the words of a block.", self._samples()),
            ("Bits that hardware sets stay until they are cleared, also bits set in that very cycle.", self._events()),
            ("A pulse lasts for one cycle, and reads as 0.", self._pulses()),
            ("A FIFO port moves each word once, and refuses words that it cannot move.", self._streams()),
            ("A module gets the accesses to its addresses, counted from its base.", self._windows()),
            ("The description is read a page at a time.", self._description()),
            ("Everything else is refused.", self._refusals()),
        )
        for title, statements in parts:
            some = tuple(statements)
            if some:
                yield Section(title, some)

    # Expected contents

    def _struck(self, word: BankWord) -> list[Register]:
        """Return the registers whose `written` pulses when a word is written."""
        return [
            register
            for register in word.written
            if register.is_register and word.address == register.signal.addresses[-1]
        ]

    def _raw_of(self, register: Register) -> int:
        path = register.signal.path
        is_stored = register.is_register or register.has_events
        return self._stored[path] if is_stored else self._given.get(path, 0)

    def _word(self, address: int) -> int:
        """Return the word that a read of an address must return."""
        registers = self._word_at[address].read
        return sum(part_of(register.signal, self._raw_of(register), address) for register in registers)

    def _readable(self) -> list[BankWord]:
        return [word for word in self._bank.words if word.read and not any(one.signal.fifo for one in word.read)]

    # Statements

    def _literal(self, register: Register, raw: int) -> str:
        kind = register.signal.kind
        if kind.name is KindName.BOOL and not register.is_wired:
            return f"'{raw}'"
        if kind.enumeration is None or register.is_wired:
            return bit_literal(raw, kind.width)
        type_ = self._bank.enumerations[kind.enumeration.name]
        names = dict(zip((one.value for one in kind.enumeration.values), type_.literals, strict=True))
        return names.get(raw, type_.unnamed).name

    def _at(self, address: int) -> str:
        return bit_literal(address, self._address_bits)

    def _data(self, word: int) -> str:
        return bit_literal(word, self._data_bits)

    def _read(self, address: int, *, keep: bool = False) -> str:
        return f"read({self._at(address)}, {self._data(self._word(address))}, {str(keep).lower()});"

    def _see(self, register: Register) -> str:
        value = self._literal(register, self._stored[register.signal.path])
        return f'check({register.pins.got} = {value}, "{register.signal.path} on the hardware\'s side");'

    def _give(self, register: Register, raw: int) -> str:
        self._given[register.signal.path] = raw
        return f"{register.pins.given} <= {self._literal(register, raw)};"

    def _write(self, word: BankWord, value: int) -> Iterator[str]:
        """Write a word, and check the values on the hardware's side."""
        struck = self._struck(word)
        first = self._first_strobe[word.address]
        self._store(word, value)
        yield f"write({self._at(word.address)}, {self._data(value)}, {first}, {len(struck)});"
        yield from (self._see(register) for register in word.written if register.is_register)
        if struck and any(register.reads_back for register in struck):
            yield self._read(word.address)

    def _store(self, word: BankWord, value: int) -> None:
        """Record a write of a word."""
        struck = self._struck(word)
        for register in struck:
            part = register.signal.mask_at(word.address) & value
            raw = _joined(register.signal, self._gathered, word.address, part)
            if register.is_pulse:
                self._pulsed[register.signal.path] += raw
                raw = 0
            self._stored[register.signal.path] = raw
        for register in word.written:
            if register.has_events:
                self._stored[register.signal.path] &= ~(value >> register.signal.lowest_bit)
        if not struck:
            self._gathered[word.address] = value

    # Sections

    def _reset(self) -> Iterator[str]:
        for lease in self._bank.leases:
            yield self._give(lease, 1)
        for finishing in self._bank.finishing.values():
            yield self._give(finishing, 0)
        for register in self._bank.registers:
            if register.is_register:
                yield self._see(register)

    def _chance(self, *what: object) -> random.Random:
        return random.Random(" ".join(map(str, (self._bank.interface.name, *what))))  # noqa: S311  (not for secrets)

    def _number(self, bits: int, round_: int, *what: object) -> int:
        """Return a random number; in round 2 it is the inverse of that of round 1."""
        if round_ == 2:
            return self._number(bits, 1, *what) ^ (1 << bits) - 1
        return self._chance(round_, *what).getrandbits(bits)

    def _raw(self, register: Register, round_: int) -> int:
        """Return a raw that hardware can supply; for an enumeration, one that has a name."""
        kind, path = register.signal.kind, register.signal.path
        if register in self._bank.leases:
            return 1
        if register in self._bank.finishing.values():
            return 0
        if kind.enumeration is not None:
            return self._chance(round_, path).choice(kind.enumeration.values).value
        return self._number(kind.width, round_, path)

    def _reads(self, round_: int) -> Iterator[str]:
        given = [register for register in self._bank.registers if register.is_sampled]
        yield from (self._give(register, self._raw(register, round_)) for register in given)
        if given or self._bank.with_events:
            yield "pass(2);"
            yield from (self._read(word.address) for word in self._readable())

    def _writes(self, round_: int) -> Iterator[str]:
        words = [word for word in self._bank.words if any(register.is_register for register in word.written)]
        for word in words:
            yield from self._write(word, self._number(self._data_bits, round_, word.address))
        for register in self._bank.registers:
            if register.is_register and len(words) > 1:
                yield self._see(register)

    def _leases(self) -> Iterator[str]:
        readable = self._readable()
        every = [word for word in self._bank.words if word.armed]
        for lease in self._bank.leases:
            path = lease.signal.path.rpartition(".")[0]
            guarded = [one for one in self._bank.guarded if one.signal.safe and one.signal.safe.lease == path]
            words = [word for word in every if word.written[0] in guarded]
            for word in every:
                yield from self._write(word, self._number(self._data_bits, 1, path, word.address))
            yield from (self._give(lease, 0), "pass(2);")
            for register in guarded:
                if register.signal.safe is not None and register.signal.safe.bits is not None:
                    self._stored[register.signal.path] = register.signal.reset
            # Signals guarded by other leases keep their values.
            yield from (self._see(register) for register in self._bank.guarded)
            for word in words:
                yield f"refuse({self._at(word.address)}, '1');"
                yield from [self._read(word.address)] * (word in readable)
            yield from (self._give(lease, 1), "pass(2);")
            yield from (self._see(register) for register in guarded)
            if path in self._bank.finishing:
                for word in words:
                    yield from self._write(word, self._number(self._data_bits, 2, path, word.address))
                yield from (self._give(self._bank.finishing[path], 1), "pass(2);")
                yield from (f"refuse({self._at(word.address)}, '1');" for word in words)
                yield from (self._see(register) for register in guarded)
                yield from (self._give(self._bank.finishing[path], 0), "pass(2);")

    def _schedules(self) -> Iterator[str]:
        for stage in self._bank.stages:
            name, every = stage.name, stage.registers
            yield from self._put_on_stage(stage, every, 1)
            yield f"{name}_stage_index <= {bit_literal(0xFFFF, 16)};"
            yield from _for_a_cycle(f"{name}_stage_write")
            yield from (self._see(register) for register in every)
            yield from self._commit(stage, every)
            yield from self._commit(stage, ())
            # If a value is staged twice, the second one counts; a cleared stage commits nothing.
            yield from self._put_on_stage(stage, every[::2], 1)
            yield from self._put_on_stage(stage, every[::2], 2)
            yield from self._commit(stage, every[::2])
            yield from self._put_on_stage(stage, every, 3)
            yield from _for_a_cycle(f"{name}_stage_clear")
            yield from self._commit(stage, ())
            yield from self._commit_beside_a_write(stage)
            yield from self._commit_without_a_lease(stage)

    def _put_on_stage(self, stage: Stage, registers: Sequence[Register], round_: int) -> Iterator[str]:
        for register in registers:
            raw = self._staged[register.signal.path] = self._number(
                register.signal.width, round_, "stage", register.signal.path
            )
            for word in register.staged:
                data = raw >> word.low & (1 << STAGE_BITS) - 1
                yield f"{stage.name}_stage_index <= {bit_literal(word.place, 16)};"
                yield f"{stage.name}_stage_data <= {bit_literal(data, STAGE_BITS)};"
                yield from _for_a_cycle(f"{stage.name}_stage_write")

    def _commit(self, stage: Stage, changed: Sequence[Register]) -> Iterator[str]:
        """Commit, and check that exactly the changed registers get their staged values and pulse."""
        for register in changed:
            self._stored[register.signal.path] = self._staged[register.signal.path]
        yield from _for_a_cycle(f"{stage.name}_commit")
        yield "pass(1);"
        pulses = "".join(str(int(register in changed)) for register in self.strobes)
        yield f'check(strobes = "{pulses}", "the set of pulses at a commit of {stage.path}");'
        yield from (self._see(register) for register in stage.registers)
        yield "pass(1);"
        yield f'check(unsigned(strobes) = 0, "a pulse after a commit of {stage.path}");'

    def _commit_beside_a_write(self, stage: Stage) -> Iterator[str]:
        """Check that a commit has priority over a write in the same cycle."""
        register = stage.registers[0]
        address = register.signal.addresses[-1]
        yield from self._put_on_stage(stage, [register], 1)
        yield f"{stage.name}_commit <= '1';"
        word = self._data(self._number(self._data_bits, 2, address))
        yield f"write({self._at(address)}, {word}, {self._first_strobe[address]}, 1);"
        yield f"{stage.name}_commit <= '0';"
        self._stored[register.signal.path] = self._staged[register.signal.path]
        yield self._see(register)

    def _commit_without_a_lease(self, stage: Stage) -> Iterator[str]:
        guarded = [register for register in stage.registers if register.armed]
        armed = {register.armed for register in guarded}
        for lease in (one for one in self._bank.leases if f"{one.pins.given}(0)" in armed):
            yield from self._put_on_stage(stage, guarded, 1)
            yield from (self._give(lease, 0), "pass(2);")
            yield from self._put_on_stage(stage, guarded, 2)
            for register in self._bank.guarded:
                safe = register.signal.safe
                if register.armed in armed and safe is not None and safe.bits is not None:
                    self._stored[register.signal.path] = safe.bits
            yield from (self._give(lease, 1), "pass(2);")
            yield from self._commit(stage, ())
            # A commit in the cycle in which the lease ends has no effect either.
            yield from self._put_on_stage(stage, guarded, 3)
            yield self._give(lease, 0)
            yield from self._commit(stage, ())
            yield from (self._give(lease, 1), "pass(2);")

    def _fields(self) -> Iterator[str]:
        for word in self._bank.words:
            fields = [register for register in word.written if register.signal.is_field]
            for field in fields:
                mask = field.signal.mask_at(word.address)
                changed = self._word(word.address) ^ mask
                yield self._read(word.address, keep=True)
                yield from self._write(word, changed)
                yield from (self._see(register) for register in fields)

    def _rows(self) -> Iterator[str]:
        words = [word for word in self._bank.words if word.written and not any(one.signal.fifo for one in word.written)]
        for word in words:
            value = self._number(self._data_bits, ROUNDS + 1, word.address)
            self._store(word, value)
            yield f"go_on({self._at(word.address)}, '1', {self._data(value)});"
        readable = self._readable()
        yield from (f"go_on({self._at(one.address)}, '0', {self._data(self._word(one.address))});" for one in readable)
        if words or readable:
            yield "end_row;"
        yield from (self._see(register) for register in self._bank.registers if register.is_register)

    def _instants(self) -> Iterator[str]:
        for register in self._bank.registers:
            if not register.is_held:
                continue
            addresses = register.signal.addresses
            kept = [self._read(address, keep=address != addresses[-1]) for address in addresses]
            yield from (kept[0], self._give(register, self._raw(register, ROUNDS + 1)), "pass(2);", *kept[1:])
            yield "pass(2);"
            yield from (self._read(address) for address in addresses)

    def _samples(self) -> Iterator[str]:
        given = [register for register in self._bank.registers if register.is_sampled]
        if not given:
            return
        block: Sequence[int] = next((register.signal.addresses for register in given if register.is_held), ())
        yield from (self._give(register, self._raw(register, 1)) for register in given)
        yield "pass(2);"
        of_block = [self._read(address, keep=address != block[-1]) for address in block]
        yield from of_block[:1]
        yield from (self._give(register, self._raw(register, 2)) for register in given)
        yield from ("pass(1);", "sample_access <= '1';")
        of_sample = [self._read(word.address, keep=True) for word in self._readable()]
        yield from (self._give(register, self._raw(register, 3)) for register in given)
        yield from of_sample
        # As after a sample without an answer, the interrupted transaction continues.
        yield from ("cyc <= '0';", "pass(2);", f"cyc <= '{int(bool(block))}';", "pass(1);", "sample_access <= '0';")
        yield from (*of_block[1:], "pass(2);")
        yield from (self._read(word.address) for word in self._readable())

    def _events(self) -> Iterator[str]:
        for word in self._bank.words:
            registers = [register for register in word.read if register.has_events]
            if not registers:
                continue
            yield from (self._set(register, 1) for register in registers)
            yield from ("pass(2);", *self._clear(word, registers, 2))
            yield from self._clear(word, registers, 3)
            if registers[0].is_frozen:
                before = self._read(word.address, keep=True)
                yield "sample_access <= '1';"
                yield from (self._set(register, 1) for register in registers)
                yield from ("pass(2);", before, "cyc <= '0';", "sample_access <= '0';")
                yield from ("pass(2);", self._read(word.address))
                every = (1 << self._data_bits) - 1
                self._store(word, every)
                # A read in the next cycle already returns the cleared bits.
                yield f"go_on({self._at(word.address)}, '1', {self._data(every)});"
                yield f"go_on({self._at(word.address)}, '0', {self._data(self._word(word.address))});"
                yield "end_row;"
            yield self._read(word.address)

    def _set(self, register: Register, round_: int) -> str:
        """Return a statement by which hardware sets bits at the next edge, for one cycle."""
        raw = self._number(register.signal.width, round_, "events", register.signal.path)
        self._stored[register.signal.path] |= raw
        some, none = (self._literal(register, bits) for bits in (raw, 0))
        return f"{register.pins.given} <= {some}, {none} after period + period / 4;"

    def _clear(self, word: BankWord, registers: Sequence[Register], round_: int) -> Iterator[str]:
        """Check set bits, and clear bits in the cycle in which hardware sets other bits or the same ones again."""
        access = self._read(word.address)
        if registers[0].is_frozen:
            yield access
            value = self._number(self._data_bits, round_, "clear", word.address)
            self._store(word, value)
            struck = len(self._struck(word))
            access = (
                f"write({self._at(word.address)}, {self._data(value)}, {self._first_strobe[word.address]}, {struck});"
            )
        else:
            self._stored |= dict.fromkeys((register.signal.path for register in registers), 0)
        yield from (self._set(register, round_) for register in registers)
        yield from (access, self._read(word.address))
        if not registers[0].is_frozen:
            self._stored |= dict.fromkeys((register.signal.path for register in registers), 0)

    def _pulses(self) -> Iterator[str]:
        for index, register in enumerate(self._bank.pulses):
            word = self._word_at[register.signal.address]
            for value in (register.signal.mask, 0):
                yield from self._write(word, value)
                cycles = self._pulsed[register.signal.path]
                yield f'check(pulsed({index}) = {cycles}, "{register.signal.path}: cycles of pulses");'

    def _streams(self) -> Iterator[str]:
        for index, register in enumerate(self._bank.streams):
            signal, pins = register.signal, register.pins
            at = self._at(signal.address)
            if signal.access.reads:
                yield f"refuse({at}, '0');"
                for round_ in range(ROUNDS):
                    yield self._give(register, self._raw(register, round_))
                    yield f"{pins.given_valid} <= {_after(round_)};"
                    yield self._read(signal.address)
                    yield f"{pins.given_valid} <= '0';"
                yield f'check(taken({index}) = {ROUNDS}, "{signal.path}: words taken");'
            if signal.access.writes:
                yield f"refuse({at}, '1');"
                chance = self._chance("streams", signal.path)
                for round_ in range(ROUNDS):
                    value = chance.getrandbits(self._data_bits)
                    raw = (value & signal.mask) >> signal.lowest_bit
                    yield f"{pins.got_ready} <= {_after(round_)};"
                    yield f"write({at}, {self._data(value)}, 0, 0);"
                    yield f"{pins.got_ready} <= '0';"
                    yield f'check(stream_{index} = {self._literal(register, raw)}, "{signal.path}: word given");'
                yield f'check(given({index}) = {ROUNDS}, "{signal.path}: words given");'

    def _windows(self) -> Iterator[str]:
        for index, window in enumerate(self._bank.windows):
            chance = self._chance("window", window.name)
            for address in self._window_addresses(window.first, window.last, index):
                relative = address - window.first
                answer = (relative + 3 * index + 1) % (1 << self._data_bits)
                value = chance.getrandbits(self._data_bits)
                yield f"read({self._at(address)}, {self._data(answer)}, false);"
                yield f"write({self._at(address)}, {self._data(value)}, 0, 0);"
                yield f'check(window_adr({index}) = {self._at(relative)}, "{window.name}: address");'
                yield f'check(window_word({index}) = {self._data(value)}, "{window.name}: word");'
                yield "window_fails <= '1';"
                yield f"refuse({self._at(address)}, '0');"
                yield "window_fails <= '0';"

    def _window_addresses(self, first: int, last: int, index: int) -> Iterable[int]:
        """Return some addresses of a window that belong to no register and no earlier window."""
        taken = {word.address for word in self._bank.words}
        before = [range(window.first, window.last + 1) for window in self._bank.windows[:index]]
        tried = dict.fromkeys((first, first + 1, (first + last) // 2, last))
        return [
            address
            for address in tried
            if first <= address <= last and address not in taken and not any(address in one for one in before)
        ]

    def _description(self) -> Iterator[str]:
        page = self._bank.page
        if page is None:
            return
        number, addresses = self._at(page.number), page.addresses
        yield f"read({number}, {self._data(0)}, false);"
        for index in reversed(range(page.pages)):
            yield f"write({number}, {self._data(index)}, 0, 0);"
            words = page.words[index * len(addresses) :][: len(addresses)]
            yield f"read({number}, {self._data(index)}, false);"
            for address, word in zip(addresses, words, strict=True):
                yield f"read({self._at(address)}, {self._data(word)}, {str(address != addresses[-1]).lower()});"
        yield from (f"refuse({self._at(address)}, '1');" for address in addresses)
        yield f"write({number}, {self._data(page.pages)}, 0, 0);"
        yield f"read({number}, {self._data(0)}, false);"

    def _refusals(self) -> Iterator[str]:
        for word in self._bank.words:
            if not word.read:
                yield f"refuse({self._at(word.address)}, '0');"
            if not word.written:
                yield f"refuse({self._at(word.address)}, '1');"
        for address in self._unused():
            yield f"refuse({self._at(address)}, '0');"
            yield f"refuse({self._at(address)}, '1');"

    def _unused(self) -> list[int]:
        """Return some unused addresses: next to used ones, and the last address."""
        taken = {word.address for word in self._bank.words}
        windows = [range(window.first, window.last + 1) for window in self._bank.windows]
        if self._bank.page is not None:
            windows.append(range(self._bank.page.number, self._bank.page.addresses[-1] + 1))
        highest = (1 << self._address_bits) - 1
        near = sorted({address + step for address in taken for step in (-1, 1)} | {0, highest})
        some = [
            address
            for address in near
            if 0 <= address <= highest and address not in taken and not any(address in one for one in windows)
        ]
        return [*some[: _UNUSED_ADDRESSES - 1], *some[_UNUSED_ADDRESSES - 1 :][-1:]]


def _for_a_cycle(signal: str) -> tuple[str, ...]:
    """Return statements that set a signal to '1' for one cycle."""
    return f"{signal} <= '1';", "pass(1);", f"{signal} <= '0';"


def _after(round_: int) -> str:
    """Return a waveform for a '1': at once in round 0, later in each further round, never at a rising edge."""
    return f"'0', '1' after {3 * round_} * period + period / 4" if round_ else "'1'"


def part_of(signal: Signal, raw: int, address: int) -> int:
    """Return the bits that a signal contributes to the word at an address."""
    return raw << signal.lowest_bit >> (address - signal.address) * signal.word_bits & (1 << signal.word_bits) - 1


def _joined(signal: Signal, gathered: dict[int, int], last: int, value: int) -> int:
    """Return the raw of a signal after the write of its last word."""
    words = [gathered[address] for address in signal.addresses[:-1]] + [value]
    assert signal.addresses[-1] == last
    whole = sum(word << (index * signal.word_bits) for index, word in enumerate(words))
    return (whole & signal.mask) >> signal.lowest_bit

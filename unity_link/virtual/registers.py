"""The registers of a spec as a bus sees them: a model of the register bank that `unity-link generate vhdl` makes.

- Reads of write-only signals, writes of read-only signals, and accesses to addresses without a signal are bus errors.
- A value of several words is latched when its first word is read, and changes when its last word is written.
- A signal with an EFFECT is cleared by a read, cleared by writing 1, or is 1 only in the moment of a write.
- A signal with SAFE cannot be written while its lease is not armed, or is finishing.
- In addition to the register bank, a write outside of MIN and MAX is a bus error; the log has the reason.
- Addresses of hardware modules are memory, and those of FIFO ports are queues.
"""

from __future__ import annotations

import logging
from collections import deque
from typing import TYPE_CHECKING, Literal, Protocol, cast, get_args

from unity_link.errors import ArgumentError
from unity_link.protocol.wire.description import PAGE_WORDS, page_address, words_of
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.spec import STAGE_BITS, Effect
from unity_link.virtual.bus import AccessError

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from unity_link.spec import Interface, ModuleSpec, Signal, Value

SignalFault = Literal["error", "timeout", "frozen"]
"""Faults of a signal: accesses end with a bus error, time out, or read the value at the start of the fault."""
SIGNAL_FAULTS: tuple[str, ...] = get_args(SignalFault)
DEFAULT_DEPTH = 1024
"""Depth in words of a queue if the spec does not declare one."""
_LOG = logging.getLogger("unity_link.virtual")


class Wire(Protocol):
    """The ports of a signal in compiled gateware, as a model uses them."""

    def look(self, cell: Cell) -> None:
        """Check that the model may read the value.

        Raises:
            ArgumentError: if a model cannot read this signal.
        """

    def drive(self, cell: Cell, raw: int) -> None:
        """Drive the port with the bits of the model's value.

        Raises:
            ArgumentError: if the signal is not an input of the gateware.
        """

    def set_fault(self, cell: Cell, fault: SignalFault | None) -> None:
        """Begin a fault; None ends it.

        Raises:
            ArgumentError: if compiled gateware cannot have the fault.
        """


class Queue:
    """A FIFO port, with the words from the model to the program and those from the program to the model.

    Args:
        signal: the port.
        loops_back: True if there is no model, and programs read the words that they wrote.
    """

    def __init__(self, signal: Signal, *, loops_back: bool) -> None:
        self._signal = signal
        self.depth = signal.fifo_words or DEFAULT_DEPTH
        self.to_program: deque[int] = deque()
        self.from_program = self.to_program if loops_back else deque[int]()
        self.changed: Callable[[], object] | None = None
        """Is called after the model has put or taken a value."""

    def __len__(self) -> int:
        """Return the number of values from the program."""
        return len(self.from_program)

    def put(self, value: Value | str) -> bool:
        """Append a value for the program; return False if the queue is full."""
        word = _encoded(self._signal, value)
        if len(self.to_program) >= self.depth:
            return False
        self.to_program.append(word)
        if self.changed is not None:
            self.changed()
        return True

    def take(self) -> Value | None:
        """Remove and return the oldest value from the program; None if the queue is empty."""
        if not self.from_program:
            return None
        taken = self._signal.kind.decode(self.from_program.popleft())
        if self.changed is not None:
            self.changed()
        return taken


class Cell:
    """A signal: its value for the model, and its bits on the bus."""

    __slots__ = (
        *("_bounds", "_gathered", "_kept", "_next_part"),
        *("fault", "frozen", "queue", "raw", "signal", "value", "wire", "written"),
    )

    def __init__(self, signal: Signal, *, loops_back: bool) -> None:
        self.signal = signal
        self.raw = signal.reset
        self.value = signal.kind.decode(self.raw)
        self.written = self.value
        """The last value that a program wrote; `value` may differ if the signal has an EFFECT."""
        self.queue = Queue(signal, loops_back=loops_back and signal.access.reads) if signal.fifo else None
        self.fault: SignalFault | None = None
        self.frozen = 0
        self.wire: Wire | None = None
        self._gathered = [0] * signal.words
        self._kept, self._next_part = 0, (0, 0.0)
        self._bounds = _bound(signal, signal.minimum), _bound(signal, signal.maximum)

    def set(self, value: Value | str) -> None:
        """Set the value from the model.

        `value` keeps a float exactly, although the register rounds it. In a signal that accesses clear, the 1 bits are
        set and the other bits stay. A value of a signal with WRAPS may exceed the range: the register wraps around, and
        the model reads the value that it has set.

        Raises:
            ArgumentError: if the signal's kind cannot represent the value, or the signal is an output of compiled
                gateware.
        """
        raw = _encoded(self.signal, value)
        if self.wire is not None:
            self.wire.drive(self, raw)
        if self.signal.has_events:
            self.take(self.raw | raw if self.wire is None else 0)
            return
        self._keep(raw, value)

    def show(self, value: Value | str) -> None:
        """Set the value that a model of the plant reads; the register itself is in compiled gateware.

        Raises:
            ArgumentError: if the signal's kind cannot represent the value.
        """
        self._keep(_encoded(self.signal, value), value)

    def _keep(self, raw: int, value: Value | str) -> None:
        kind = self.signal.kind
        self.raw, self.value = raw, kind.decode(raw)
        if kind.is_float or kind.wraps:
            self.value = float(value) if kind.is_float else int(value)

    def put(self, value: Value) -> None:
        """Set the bits that a program reads; a model of the plant still reads its own value.

        Raises:
            ArgumentError: if the signal's kind cannot represent the value.
        """
        self.raw = _encoded(self.signal, value)

    def accept(self, raw: int) -> None:
        """Apply the bits that a program wrote, with the signal's EFFECT."""
        self.written = self.signal.kind.decode(raw)
        if self.signal.effect is Effect.WRITE_1_TO_CLEAR:
            raw = self.raw & ~raw
        self.take(0 if self.signal.effect is Effect.PULSE else raw)

    def take(self, raw: int) -> None:
        """Set the bits on the bus, and the value from them."""
        self.raw = raw
        self.value = self.signal.kind.decode(raw)

    def read(self, part: int, now: float) -> int:
        """Return the bits of one of the signal's words, at their place in the word.

        Args:
            part: index of the word in the signal.
            now: the time of the access; all words of one transaction have the same time.

        Raises:
            AccessError: if the signal has a fault, or its queue is empty.
        """
        self._check_fault()
        if self.queue is not None:
            if not self.queue.to_program:
                raise AccessError(ErrorCode.BUS_ERROR)
            return self.queue.to_program.popleft()
        raw = self.frozen if self.fault == "frozen" else self.raw
        if self.signal.effect is Effect.CLEAR_ON_READ:
            self.take(0)
        if self.signal.words > 1:
            # The words after the first one, in the same transaction, come from the latched value.
            self._kept = self._kept if part and (part, now) == self._next_part else raw
            self._next_part = part + 1, now
            raw = self._kept
        return raw << self.signal.lowest_bit >> part * self.signal.word_bits & self.signal.mask_at(
            self.signal.address + part
        )

    def check_write(self, part: int, word: int) -> None:
        """Check that a word can be written.

        Raises:
            AccessError: if the signal has a fault, the value is outside of the limits, or the queue is full.
        """
        self._check_fault()
        if self.queue is not None and len(self.queue.from_program) >= self.queue.depth:
            raise AccessError(ErrorCode.BUS_ERROR)
        if part == self.signal.words - 1:
            value = self.signal.kind.decode(self._raw_with(part, word))
            low, high = self._bounds
            if not ((low is None or low <= value) and (high is None or value <= high)):
                _LOG.warning("a write of %s to %s was refused: %s", value, self.signal.path, _limits(self.signal))
                raise AccessError(ErrorCode.BUS_ERROR)

    def write(self, part: int, word: int) -> bool:
        """Write a word; return True if hardware gets a value, which is complete and does not only clear bits."""
        if self.queue is not None:
            self.queue.from_program.append(word & self.signal.mask)
            return True
        if part < self.signal.words - 1:
            self._gathered[part] = word
            return False
        self.accept(self._raw_with(part, word))
        return not self.signal.has_events

    def make_safe(self) -> None:
        """Set the safe value, except with HOLD, and drop the words of an incomplete value."""
        assert self.signal.safe is not None
        self._gathered = [0] * self.signal.words
        if self.signal.safe.bits is not None:
            self.take(self.signal.safe.bits)

    def _raw_with(self, part: int, word: int) -> int:
        words = [*self._gathered[:part], word]
        whole = sum(one << index * self.signal.word_bits for index, one in enumerate(words))
        return (whole & self.signal.mask) >> self.signal.lowest_bit

    def _check_fault(self) -> None:
        if self.fault == "error":
            raise AccessError(ErrorCode.BUS_ERROR)
        if self.fault == "timeout":
            raise AccessError(ErrorCode.BUS_TIMEOUT)


class Registers:
    """All registers of an interface.

    Args:
        interface: interface of a spec.
        loops_back: True if there is no model, and programs read the words that they wrote to a FIFO port.
    """

    def __init__(self, interface: Interface, *, loops_back: bool) -> None:
        self.cells = {path: Cell(signal, loops_back=loops_back) for path, signal in interface.signals.items()}
        self._modules = [module for module in interface.modules if module.is_hardware]
        self._module_words: dict[int, int] = {}
        self._module_queues: dict[int, deque[int]] = {
            module.base: deque(maxlen=cast("int", module.arguments.get("WORDS", DEFAULT_DEPTH)))
            for module in self._modules
            if module.type == "FIFO"
        }
        self._leases: dict[str, set[str]] = {}
        """Leases of each component's signals, and of the signals that it times, by path of the component."""
        self._staged: dict[str, dict[int, tuple[Cell, int]]] = {}
        """For each schedule's path: signal and lowest bit of each place on its stage."""
        self._page_number, self._page = page_address(interface.address_bits), 0
        self._description = words_of(interface.description, interface.data_bits) if interface.is_described else []
        self._guarded: dict[str, list[Cell]] = {}
        """Signals with a safe value, by path of their lease."""
        self._read: dict[int, list[tuple[Cell, int]]] = {}
        self._written: dict[int, list[tuple[Cell, int]]] = {}
        for cell in self.cells.values():
            signal = cell.signal
            reads_back = signal.is_field and signal.access.writes and not signal.fifo
            if signal.safe is not None:
                self._guarded.setdefault(signal.safe.lease, []).append(cell)
                for component in (signal.path.rpartition(".")[0], signal.timed):
                    self._leases.setdefault(component or "", set()).add(signal.safe.lease)
            for low, place in enumerate(interface.stages.get(signal.path, ())):
                stage = self._staged.setdefault(signal.timed or "", {})
                stage[place] = cell, low * STAGE_BITS
            for part, address in enumerate(signal.addresses):
                if signal.access.reads or reads_back:
                    self._read.setdefault(address, []).append((cell, part))
                if signal.access.writes:
                    self._written.setdefault(address, []).append((cell, part))

    def set_fault(self, path: str, fault: SignalFault | None) -> None:
        """Set the fault of a signal; None ends it.

        Raises:
            ArgumentError: if the signal or the fault does not exist.
        """
        if path not in self.cells:
            from unity_link.spec.diagnostics import did_you_mean

            hint = did_you_mean(path, self.cells)
            raise ArgumentError(f"there is no signal {path!r}" + (f": {hint}" if hint else ""))
        if fault is not None and fault not in SIGNAL_FAULTS:
            raise ArgumentError(f"{fault!r} is no fault of a signal: one of {', '.join(SIGNAL_FAULTS)} was expected")
        cell = self.cells[path]
        if cell.wire is not None:
            cell.wire.set_fault(cell, fault)
        cell.fault, cell.frozen = fault, cell.raw

    def read(self, address: int, now: float = 0.0) -> int:
        """Return the word at an address, read at the time `now`.

        Raises:
            AccessError: if the word cannot be read.
        """
        cells = self._read.get(address)
        if cells is None:
            if self._description and 0 <= address - self._page_number <= PAGE_WORDS:
                return self._read_description(address)
            return self._read_module(address)
        word = 0
        for cell, part in cells:
            word |= cell.read(part, now)
        return word

    def write(self, address: int, word: int) -> list[Cell]:
        """Write the word at an address; return the signals for which hardware got a value.

        Raises:
            AccessError: if the word cannot be written; no signal is changed then.
        """
        cells = self._written.get(address)
        if cells is None:
            if self._description and address == self._page_number:
                self._page = word if word * PAGE_WORDS < len(self._description) else 0
            else:
                self._write_module(address, word)
            return []
        for cell, part in cells:
            if cell.signal.safe is not None and not self._may_write(cell.signal.safe.lease):
                raise AccessError(ErrorCode.BUS_ERROR)
            cell.check_write(part, word)
        return [cell for cell, part in cells if cell.write(part, word)]

    def leases_of(self, component: str) -> set[str]:
        """Return the paths of the leases that guard a component's signals, or the signals that the component times."""
        return self._leases.get(component, set())

    def is_armed(self, component: str) -> bool:
        """Return True if all leases of `leases_of` are armed."""
        return all(self.cells[f"{lease}.armed"].raw for lease in self.leases_of(component))

    def is_finishing(self, component: str) -> bool:
        """Return True if one of the leases of `leases_of` is finishing."""
        return any(self._is_finishing(lease) for lease in self.leases_of(component))

    def _is_finishing(self, lease: str) -> bool:
        cell = self.cells.get(f"{lease}.finishing")
        return cell is not None and bool(cell.raw)

    def _may_write(self, lease: str) -> bool:
        return bool(self.cells[f"{lease}.armed"].raw) and not self._is_finishing(lease)

    def commit(self, schedule: str, words: Mapping[int, int]) -> list[Cell]:
        """Write words from a schedule, by their places on its stage; return the signals that got a value."""
        changed: dict[str, Cell] = {}
        for place, word in words.items():
            found = self._staged.get(schedule, {}).get(place)
            if found is None:
                continue
            cell, low = found
            mask = ((1 << STAGE_BITS) - 1) << low & (1 << cell.signal.width) - 1
            cell.accept(cell.raw & ~mask | word << low & mask)
            changed[cell.signal.path] = cell
        return list(changed.values())

    def make_safe(self, lease: str) -> None:
        """Set all signals that a lease guards to their safe values, except those with HOLD.

        Args:
            lease: path of the lease.
        """
        for cell in self._guarded.get(lease, ()):
            cell.make_safe()

    def _read_description(self, address: int) -> int:
        if address == self._page_number:
            return self._page
        return self._description[self._page * PAGE_WORDS + address - self._page_number - 1]

    # Hardware modules, which are memory here

    def _read_module(self, address: int) -> int:
        self._check_in_module(address, self._written)
        queue = self._module_queues.get(address)
        if queue is None:
            return self._module_words.get(address, 0)
        if not queue:
            raise AccessError(ErrorCode.BUS_ERROR)
        return queue.popleft()

    def _write_module(self, address: int, word: int) -> None:
        self._check_in_module(address, self._read)
        queue = self._module_queues.get(address)
        if queue is None:
            self._module_words[address] = word
        elif len(queue) == queue.maxlen:
            raise AccessError(ErrorCode.BUS_ERROR)
        else:
            queue.append(word)

    def _check_in_module(self, address: int, other_way: dict[int, list[tuple[Cell, int]]]) -> None:
        """Raise `AccessError` if an address is in no module, or belongs to a signal of the other direction."""
        if address in other_way or not any(_has(module, address) for module in self._modules):
            raise AccessError(ErrorCode.BUS_ERROR)


def _encoded(signal: Signal, value: Value | str) -> int:
    kind = signal.kind
    try:
        return kind.encode(kind.wrapped(value) if kind.wraps and not isinstance(value, bool | str) else value)
    except ArgumentError as error:
        raise ArgumentError(f"{signal.path}: {error}") from None


def _bound(signal: Signal, limit: float | None) -> Value | None:
    """Return the limit of a value on the bus for a limit in the spec."""
    # A float is rounded to the nearest value of the register, so round the limit as well.
    kind = signal.kind
    return limit if limit is None or not kind.is_float else kind.decode(kind.encode(limit))


def _limits(signal: Signal) -> str:
    low, high = signal.limits
    unit = f" {signal.unit}" if signal.unit else ""
    return f"its limits are {low:.12g} to {high:.12g}{unit}"


def _has(module: ModuleSpec, address: int) -> bool:
    return address >= module.base and (module.size is None or address < module.base + module.size)

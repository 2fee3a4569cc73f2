"""The register bank as data: what stands at each address, what waits behind it, and which addresses belong to modules.

Signals are registers of the bank, but for those in hardware modules: a module is hardware of its own, and the addresses
that it takes are handed on to it. A `MEMORY` without a name is no such hardware, only a base for the registers in it. A
module whose size the spec does not tell reaches up to the next one, or to the end of the addresses.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from unity_link.errors import UnsupportedError
from unity_link.generate.vhdl.names import Scope, identifier
from unity_link.generate.vhdl.records import Pins, Records
from unity_link.generate.vhdl.types import bit_literal, enumeration_type, from_bits, to_bits
from unity_link.generate.vhdl.wiring import STAGE_PORTS, Wiring
from unity_link.protocol.wire.description import PAGE_WORDS, page_address, words_of
from unity_link.spec import STAGE_BITS, Access, Effect, KindName

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from unity_link.spec import Interface, ModuleSpec, Signal


ELSEWHERE = "elsewhere"
MASTER_PINS = ("cyc", "stb", "we", "adr", "dat_o", "dat_i", "ack", "err")
"""Ends of the names of a Wishbone master's ports."""
_CONSTANTS = (
    "address_t",
    "address_bits",
    "data_bits",
    "groups",
    "group_words",
    "sample_depth",
    "base_frequency_millihertz",
    "build_id",
)
"""Constants of the gateway in the package, behind the name of the interface."""
_HIDDEN = (
    *("to_bits", "to_hardware", "from_hardware", "to_chain", "wb_pipelined", "sample_access"),
    *("address_t", "addresses_t", "word_t", "words_t", "counts_t", "to_bank", "from_bank", "count_words"),
    *("description", "description_t", "described", "described_page", "described_ready", "described_word"),
    *("at_description", "at_described_page"),
    *("owed_word", "owed_write", "go_on", "end_row"),
    *(f"window_{name}" for name in ("fails", "cyc", "stb", "we", "ack", "err", "adr", "dat_o", "dat_i", "word")),
)
"""Names of the designs and the bench, behind which those of the package could not be seen."""


class Slice(NamedTuple):
    """The part of a signal that stands in one word."""

    high: int
    low: int
    """Bits of the word."""
    first: int
    """The lowest of the signal's own bits that are meant."""

    @property
    def last(self) -> int:
        """The highest of them."""
        return self.first + self.high - self.low


def slice_at(signal: Signal, address: int) -> Slice:
    """Return what a signal has of the word at an address."""
    part = address - signal.address
    low = signal.lowest_bit if part == 0 else 0
    first = part * signal.word_bits
    return Slice(min(low + signal.width - first, signal.word_bits) - 1, low, first)


class StageWord(NamedTuple):
    """A word that a schedule writes: its place on the stage, and which bits of a register it is."""

    place: int
    high: int
    low: int


class Register(NamedTuple):
    """A signal of the bank."""

    signal: Signal
    name: str
    """Its path as one word, of which the names of its constants and of its register are made."""
    pins: Pins

    is_wired: bool = False
    """True where its hardware's side is a vector that a core or a pin has, and no element of a record."""
    armed: str = ""
    """Signal that is '1' while its lease is armed; empty for a register that no lease guards."""
    finishing: str = ""
    """Signal that is '1' while its lease is finishing: the bus writes nothing, and its schedule does."""
    places: range = range(0)
    """Its places on the stage of its schedule."""
    chain: str = ""
    """Its bits on the chain of shift registers of a board, as a range of VHDL."""

    @property
    def staged(self) -> tuple[StageWord, ...]:
        """Its words on the stage of its schedule."""
        lows = range(0, self.signal.width, STAGE_BITS)
        words = zip(self.places, lows, strict=False)
        return tuple(StageWord(at, min(low + STAGE_BITS, self.signal.width) - 1, low) for at, low in words)

    @property
    def writable(self) -> str:
        """Write that the bus may write it, of one that a lease guards."""
        return f"{self.armed} and not {self.finishing}" if self.finishing else self.armed

    @property
    def got_bits(self) -> str:
        """Write the bits of what hardware gets."""
        return self.pins.got if self.is_wired else to_bits(self.signal.kind, self.pins.got)

    @property
    def is_sampled(self) -> bool:
        """Return whether its readable value is kept during a sample: that of hardware's signals but FIFO ports."""
        return self.signal.access is Access.READ and not self.signal.fifo and not self.has_events

    @property
    def has_events(self) -> bool:
        """Return whether it keeps what hardware sets until that is cleared."""
        return self.signal.has_events

    @property
    def is_frozen(self) -> bool:
        """Return whether it keeps what hardware sets, and is read from the instant of a sample."""
        return self.signal.effect is Effect.WRITE_1_TO_CLEAR

    @property
    def is_pulse(self) -> bool:
        """Return whether a 1 that is written lasts for a cycle."""
        return self.signal.effect is Effect.PULSE

    @property
    def is_held(self) -> bool:
        """Return whether its readable value is kept for the rest of a transaction, as it takes several words."""
        return self.is_sampled and self.signal.words > 1

    @property
    def is_register(self) -> bool:
        """Return whether it has what is written: for good, or for the cycle of a pulse."""
        return self.signal.access.writes and not self.signal.fifo and not self.has_events

    @property
    def is_gathered(self) -> bool:
        """Return whether several words are written before it changes."""
        return self.is_register and self.signal.words > 1

    @property
    def reads_back(self) -> bool:
        """Return whether reading gives what was written: for a field, since it is written by reading first."""
        return self.is_register and (self.signal.access is Access.READWRITE or self.signal.is_field)

    @property
    def can_be_read(self) -> bool:
        """Return whether its address can be read."""
        return self.signal.access.reads or self.reads_back

    @property
    def given_bits(self) -> str:
        """Write the bits of what hardware gives."""
        return self.pins.given if self.is_wired else to_bits(self.signal.kind, self.pins.given)

    def read_at(self, address: int) -> str:
        """Write what a read of an address gives of it: a vector, or of a bool from a FIFO port a single bit."""
        if self.signal.fifo:
            return self.given_bits
        part = slice_at(self.signal, address)
        if self.is_pulse:
            return bit_literal(0, self.signal.width)
        kept = "seen" if self.is_frozen else "given" if self.is_held else "sampled" if self.is_sampled else "bits"
        return f"{self.name}_{kept}({part.last} downto {part.first})"


class Offer(NamedTuple):
    """A group of which the FIFO ports have the trigger: when they have a word each, and when one is taken."""

    group: int
    name: str
    valid: str
    ready: str


class Stage(NamedTuple):
    """The registers that a schedule writes."""

    path: str
    """Path of the schedule."""
    name: str
    """Prefix of the bank's ports for it."""
    registers: tuple[Register, ...]

    @property
    def ports(self) -> tuple[tuple[str, str], ...]:
        """Names and types of these ports."""
        return tuple((f"{self.name}_{port}", type_) for port, type_ in STAGE_PORTS.items())


class BankWord(NamedTuple):
    """One address of the bank."""

    address: int
    read: tuple[Register, ...]
    written: tuple[Register, ...]

    @property
    def allowed(self) -> str:
        """Write whether an access is allowed."""
        if self.armed:
            return f"not wb_we or ({self.writable})" if self.read else f"wb_we and {self.writable}"
        return "'1'" if self.read and self.written else "wb_we" if self.written else "not wb_we"

    @property
    def writable(self) -> str:
        """Write that the lease of the word allows writes; empty where no lease guards it."""
        return next((register.writable for register in self.written), "")

    @property
    def armed(self) -> str:
        """Signal without which a write is refused; empty where no lease guards the word."""
        return next((register.armed for register in self.written), "")

    @property
    def paths(self) -> str:
        """Paths of its signals in the spec."""
        signals = (register.signal for register in self.read + self.written)
        return ", ".join(dict.fromkeys(f"{signal.path}{self._part(signal)}" for signal in signals))

    def _part(self, signal: Signal) -> str:
        return f", word {self.address - signal.address} of {signal.words}" if signal.words > 1 else ""


class AddressWindow(NamedTuple):
    """Addresses that are handed on."""

    name: str
    """Prefix of its ports."""
    first: int
    last: int
    module: ModuleSpec | None
    """Module that has the addresses; None for those of none."""


class DescriptionPage(NamedTuple):
    """The description of the interface, which stands at the highest addresses a page at a time."""

    number: int
    """Address of the number of the page."""
    words: list[int]
    """Those of all pages."""

    @property
    def addresses(self) -> range:
        """Addresses of the words of a page."""
        return range(self.number + 1, self.number + 1 + PAGE_WORDS)

    @property
    def pages(self) -> int:
        """Number of pages."""
        return len(self.words) // PAGE_WORDS


class Bank:
    """All that the templates say of the registers of an interface.

    Raises:
        UnsupportedError: where addresses belong to two modules alike.
    """

    def __init__(self, interface: Interface) -> None:
        self.interface = interface
        name = identifier(interface.name)
        self._scope = Scope(*_HIDDEN, *(f"{name}_{constant}" for constant in _CONSTANTS))
        self.enumerations = {
            enumeration.name: enumeration_type(enumeration, self._scope) for enumeration in interface.enumerations
        }
        signals = {
            path: signal for path, signal in interface.signals.items() if _owner(interface, signal.module) is None
        }
        of_cores = {signal.path for part in interface.cores for signal in part.signals}
        wired = {path for path, signal in signals.items() if path in of_cores or signal.pin is not None}
        plain = {path: signal for path, signal in signals.items() if path not in wired}
        self.records = Records(interface, plain, self.enumerations, self._scope)
        endings = (
            "_address",
            "_low",
            "_high",
            "_words",
            "_scale",
            "_offset",
            "_depth",
            "_bits",
            "_seen",
            "_sampled",
            "_held",
            "_gathered",
            "_to_core",
            "_from_core",
            "_written",
            "_shadow",
            "_pending",
        )
        self.names = {path: self._scope.unique(path, *endings) for path in interface.signals}
        """Names of all signals, those of modules too."""
        self.group_names = {
            group.name: self._scope.unique(f"group_{group.name}", "", "_divisor") for group in interface.groups
        }
        self.registers = tuple(
            Register(
                signal,
                self.names[path],
                _wires(signal, self.names[path]) if path in wired else self.records.pins[path],
                is_wired=path in wired,
                armed=self._of_lease(signal, "armed"),
                finishing=self._of_lease(signal, "finishing"),
                places=interface.stages.get(path, range(0)),
            )
            for path, signal in signals.items()
        )
        leases = {register.signal.safe.lease for register in self.registers if register.signal.safe}
        self.leases = tuple(one for one in self.registers if one.signal.path in {f"{path}.armed" for path in leases})
        """Registers that tell whether the leases are armed that guard others."""
        self.finishing = {
            path: one for one in self.registers for path in leases if one.signal.path == f"{path}.finishing"
        }
        """Registers that tell whether these are finishing, by the paths of the leases."""
        self.stages = tuple(self._stages())
        self.words = tuple(_words(self.registers))
        self.page = (
            DescriptionPage(page_address(interface.address_bits), words_of(interface.description, interface.data_bits))
            if interface.is_described
            else None
        )
        """The description; None where the spec's own addresses leave no place for it."""
        self.windows = tuple(_windows(interface))
        wires = {register.signal.path: register.pins for register in self.registers if register.is_wired}
        masters = (f"{port.name}_{pin}" for port in self.ports for pin in MASTER_PINS)
        self.wiring = Wiring(interface, wires, {stage.path: stage.name for stage in self.stages}, self._scope, masters)

    def _of_lease(self, signal: Signal, register: str) -> str:
        """Return a bit that the lease of a signal tells; empty where it has no lease, or that no such register."""
        path = f"{signal.safe.lease}.{register}" if signal.safe is not None else ""
        told = self.interface.signals.get(path)
        return f"{_wires(told, self.names[path]).given}(0)" if told is not None else ""

    def _stages(self) -> Iterator[Stage]:
        for part in self.interface.cores:
            timed = tuple(register for register in self.registers if register.signal.timed == part.path)
            if timed:
                endings = (f"_{port}" for port in STAGE_PORTS)
                yield Stage(part.path, self._scope.unique(part.path, *endings), timed)

    @property
    def has_chain(self) -> bool:
        """Return whether something hangs on the chain of shift registers of a board."""
        return bool(self.chained_to or self.chained_from)

    @property
    def chained_to(self) -> list[Register]:
        """Registers that hardware gets, each with its place on a chain of shift registers."""
        return _chained(register for register in self.registers if register.is_register and not register.is_wired)

    @property
    def chained_from(self) -> list[Register]:
        """Registers that hardware gives, each with its place on a chain of shift registers."""
        given = (register for register in self.registers if register.is_sampled or register.has_events)
        return _chained(register for register in given if not register.is_wired)

    @property
    def wired(self) -> tuple[Register, ...]:
        """Registers of which cores or pins have the hardware's side."""
        return tuple(register for register in self.registers if register.is_wired)

    @property
    def ports(self) -> tuple[AddressWindow, ...]:
        """All Wishbone masters: those of the modules, and the one for the addresses that belong to nothing."""
        return (*self.windows, AddressWindow(ELSEWHERE, 0, (1 << self.interface.address_bits) - 1, None))

    @property
    def choices(self) -> Iterator[tuple[str, str]]:
        """Return the ports in the order in which an address is looked for, each with its condition; empty: always."""
        highest = (1 << self.interface.address_bits) - 1
        for port in self.ports:
            if port.first == port.last:
                yield f"unsigned(wb_adr) = {self._address(port.first)}", port.name
                continue
            low = f"unsigned(wb_adr) >= {self._address(port.first)}" if port.first > 0 else ""
            high = f"unsigned(wb_adr) <= {self._address(port.last)}" if port.last < highest else ""
            yield " and ".join(filter(None, (low, high))), port.name
            if not (low or high):
                return

    def _address(self, address: int) -> str:
        return f"unsigned'({bit_literal(address, self.interface.address_bits)})"

    @property
    def guarded(self) -> tuple[Register, ...]:
        """The registers that leases guard."""
        return tuple(register for register in self.registers if register.armed)

    @property
    def streams(self) -> tuple[Register, ...]:
        """The FIFO ports."""
        return tuple(register for register in self.registers if register.signal.fifo)

    @property
    def with_events(self) -> tuple[Register, ...]:
        """The registers that keep what hardware sets."""
        return tuple(register for register in self.registers if register.has_events)

    @property
    def pulses(self) -> tuple[Register, ...]:
        """The registers of which a 1 lasts for a cycle."""
        return tuple(register for register in self.registers if register.is_pulse)

    @property
    def open_ends(self) -> list[str]:
        """Name the FIFO ports, modules and pulses, behind which no generated file has hardware.

        A pulse of one cycle is over before it is on a chain of shift registers.
        """
        modules = (window.module for window in self.windows if window.module is not None)
        return [
            *(f"the FIFO port {register.signal.path}" for register in self.streams),
            *(f"the pulse {register.signal.path}" for register in self.pulses if not register.is_wired),
            *(" ".join(filter(None, (module.type, module.path))) for module in modules),
        ]

    @property
    def offers(self) -> tuple[Offer, ...]:
        """The groups that publish words of FIFO ports."""
        by_path = {register.signal.path: register for register in self.streams if register.pins.given_valid}
        found = []
        for group in self.interface.groups:
            ports = [by_path[path] for path in group.signals if path in by_path]
            if group.number is not None and group.trigger and ports:
                valid = " and ".join(port.pins.given_valid for port in ports)
                ready = " or ".join(port.pins.given_ready for port in ports)
                found.append(Offer(group.number, group.name, valid, f"({ready})" if len(ports) > 1 else ready))
        return tuple(found)

    def got(self, register: Register) -> str:
        """Write the value that hardware gets of a register."""
        if register.is_wired:
            return f"{register.name}_bits"
        return self.given(register, f"{register.name}_bits{'(0)' if is_bool(register) else ''}")

    def given(self, register: Register, bits: str) -> str:
        """Write the value of bits of which hardware gives a register."""
        return from_bits(register.signal.kind, bits, self.enumerations)

    def stream_word(self, register: Register) -> str:
        """Write the value that the FIFO port of a register gets from the bus."""
        part = slice_at(register.signal, register.signal.address)
        bits = str(part.low) if is_bool(register) else f"{part.high} downto {part.low}"
        return self.given(register, f"wb_dat_i({bits})")


def _chained(registers: Iterable[Register]) -> list[Register]:
    chained, first = [], 0
    for register in registers:
        width = register.signal.width
        # One bit of a vector is a range, too, but a bool is taken by its index.
        place = str(first) if is_bool(register) else f"{first + width - 1} downto {first}"
        chained.append(register._replace(chain=place))
        first += width
    return chained


def is_bit(register: Register) -> bool:
    """Return whether `read_at` writes a single bit."""
    return is_bool(register) and register.signal.fifo


def is_bool(register: Register) -> bool:
    """Return whether hardware's side of a register is a single bit."""
    return register.signal.kind.name is KindName.BOOL and not register.is_wired


def _wires(signal: Signal, name: str) -> Pins:
    """Return the ports of a signal of which a core or a pin has the hardware's side."""
    if not signal.is_given:
        return Pins(got=f"{name}_to_core", written=f"{name}_written")
    return Pins(given=f"{name}_from_core")


def _words(registers: Iterable[Register]) -> Iterator[BankWord]:
    reads: dict[int, list[Register]] = {}
    writes: dict[int, list[Register]] = {}
    for register in registers:
        for address in register.signal.addresses:
            if register.can_be_read:
                reads.setdefault(address, []).append(register)
            if register.signal.access.writes:
                writes.setdefault(address, []).append(register)
    for address in sorted(reads.keys() | writes.keys()):
        yield BankWord(address, tuple(reads.get(address, ())), tuple(writes.get(address, ())))


def _is_base_only(module: ModuleSpec) -> bool:
    return module.type == "MEMORY" and module.name is None


def _owner(interface: Interface, index: int | None) -> int | None:
    """Return the outermost piece of hardware that a module stands in, or is; None where it is a base only."""
    found = None
    while index is not None:
        module = interface.modules[index]
        if not _is_base_only(module):
            found = index
        index = module.parent
    return found


def _windows(interface: Interface) -> Iterator[AddressWindow]:
    modules = [module for index, module in enumerate(interface.modules) if _owner(interface, index) == index]
    bases = sorted(module.base for module in modules)
    scope = Scope(ELSEWHERE, "wb")
    open_at: dict[int, ModuleSpec] = {}
    # Those of known size come first: an open one has only what they leave.
    for module in sorted(modules, key=lambda one: (one.size is None, one.base)):
        name = scope.unique(module.path or module.type)
        if module.size is not None:
            yield AddressWindow(name, module.base, module.base + module.size - 1, module)
            continue
        other = open_at.setdefault(module.base, module)
        if other is not module:
            raise UnsupportedError(
                f"{other.type} and {module.type} both begin at address {module.base:#x}, and neither has a SIZE: "
                "give one of them its SIZE, so that its addresses are known"
            )
        end = next((base for base in bases if base > module.base), 1 << interface.address_bits)
        yield AddressWindow(name, module.base, end - 1, module)

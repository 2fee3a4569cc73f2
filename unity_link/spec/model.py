"""The checked model: what a spec means, with every expression computed, every name resolved and every rule kept.

This is what proxies, generators and bridges build on; none of them looks at the text again. All of it is immutable, and
`msgspec` writes it as JSON.

    Spec -> Interface -> Component (a tree) -> Signal
                      -> Module, Group, Enumeration, by which signals are reached, read together and named

A *path* is how a program gets to a thing from the interface, as Python writes it: ``legs[2].joints[0].cpos``. An *ID*
is the text that the author gave it. Addresses are word addresses on the gateway's bus, with the base of the module in
them.
"""

from __future__ import annotations

import enum
import functools
import hashlib
import math
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence  # noqa: TC003  (msgspec reads the annotations)

import msgspec

from unity_link.errors import ArgumentError, shown
from unity_link.protocol.wire.description import MOST_PAGES, page_address, pages_of
from unity_link.spec.diagnostics import NOWHERE, Diagnostic, Span
from unity_link.spec.kinds import Enumeration, Kind, Value  # noqa: TC001

STAGE_BITS = 32
"""Bits that a schedule writes at once."""
WHOLE = "the interface"
"""Name of an interface among its facts."""
_HANDLES = frozenset({"CTRL", "COMM"})
"""Arguments of modules that a program can give when it opens an interface with parameters."""


def _facts(**properties: str | None) -> dict[str, str]:
    """Return those properties that a thing has."""
    return {what: value for what, value in properties.items() if value is not None}


def _number(value: Value) -> str:
    """Write a number alike whether it is a float or not."""
    return str(value).lower() if isinstance(value, bool) else repr(value).removesuffix(".0")


def _value(kind: Kind, bits: int) -> str:
    value = kind.decode(bits)
    return str(getattr(value, "name", None) or _number(value))


class Access(enum.StrEnum):
    """Access to a signal."""

    READ = "READ"
    WRITE = "WRITE"
    READWRITE = "READWRITE"

    @property
    def reads(self) -> bool:
        """Return whether it can be read."""
        return self is not Access.WRITE

    @property
    def writes(self) -> bool:
        """Return whether it can be written."""
        return self is not Access.READ


class Effect(enum.StrEnum):
    """Effect of accesses on the bits of a signal, beside reading them or keeping what is written."""

    CLEAR_ON_READ = "CLEAR_ON_READ"
    """Hardware sets bits, and each read takes them: they are 0 behind it."""
    WRITE_1_TO_CLEAR = "WRITE_1_TO_CLEAR"
    """Hardware sets bits, and a write clears those that are 1 in it."""
    PULSE = "PULSE"
    """A 1 that is written lasts for one cycle of the gateway's clock; it reads as 0."""


class ParameterReference(msgspec.Struct, frozen=True, tag="parameter"):
    """An argument that is given when the interface is opened: the interface's parameter of that name."""

    name: str


ModuleArgument = int | float | str | bool | ParameterReference


class Way(enum.StrEnum):
    """Direction of a pin, as seen from the FPGA."""

    IN = "IN"
    OUT = "OUT"
    INOUT = "INOUT"


class Pin(msgspec.Struct, frozen=True, kw_only=True):
    """A pin of a core."""

    name: str
    """Port of the core's entity."""
    path: str
    """Path in the interface, as of a signal."""
    way: Way
    at: str | None = None
    """Pin of the board, by the board's name; None where the spec does not say."""
    is_used: bool = True
    """False where the spec says that it has no pin, by `none`."""
    unwired: int = 0
    """Level of an input that has no pin."""


class Trigger(msgspec.Struct, frozen=True, kw_only=True):
    """An output of a core that has a group published."""

    name: str
    """Port of the core's entity."""
    group: str | None = None
    """Name of the group; None where the trigger is not used."""


class Core(msgspec.Struct, frozen=True, kw_only=True):
    """The hardware of a component: an entity in VHDL whose ports are the component's signals, pins and triggers."""

    word: str
    """Word of the core that it comes from; empty where the entity is one of the spec's own."""
    entity: str
    library: str = "work"
    """Library of the entity in VHDL: that of the gateware for a core that is installed with it."""
    vhdl: tuple[str, ...] = ()
    """Files of its VHDL, in the folder of a core that is not installed with the gateware."""
    wants: tuple[str, ...] = ()
    """Ports beside clock, reset and signals: ``tick``, ``now``, ``armed``, those of a schedule (``stage`` and
    ``finishing``), and ``empty`` of a lease, which tells that nothing waits in the schedules of what it guards."""
    generics: dict[str, int | bool | str] = {}
    per_axis: tuple[str, ...] = ()
    """Those generics that come as a list, `integer_vector`, with the value of each placement."""
    pins: tuple[Pin, ...] = ()
    triggers: tuple[Trigger, ...] = ()
    python: str = ""
    """Its verbs and its quick model: a module to import, or the path of a file; empty where it has none."""

    @property
    def stages(self) -> bool:
        """Return whether it writes to registers of others, at an instant."""
        return "stage" in self.wants

    @property
    def facts(self) -> dict[str, str]:
        """As `Interface.facts`."""
        generics = {
            f"generic {name}": repr(value) if isinstance(value, str) else _number(value)
            for name, value in self.generics.items()
        }
        triggers = {f"TRIGGER {one.name}": one.group for one in self.triggers if one.group is not None}
        return {"ENTITY": self.entity, **generics, **triggers}


class Safe(msgspec.Struct, frozen=True):
    """The safe state of a signal."""

    bits: int | None
    """Its bits while the lease is not armed; None for HOLD: it keeps those that it has, and its core stops by a rule of
    its own."""
    lease: str
    """Path of the lease."""


class Signal(msgspec.Struct, frozen=True, kw_only=True):
    """A named value: some bits of a word, a word, or several words in a row of which the first has the lowest bits."""

    name: str
    """Name of its declaration, which the others of its row have too."""
    path: str
    id: str
    index: int | None = None
    """Its place in a row of signals; None for one that stands alone."""
    address: int
    """Address of the word, or of the first one."""
    word_bits: int
    """Width of a word of the gateway."""
    lowest_bit: int = 0
    kind: Kind
    access: Access
    fifo: bool = False
    """True if the address is the port of a queue: each read takes a word from it, each write appends one."""
    fifo_words: int | None = None
    """Depth of that queue, where the spec tells it."""
    effect: Effect | None = None
    """Effect of reading or writing it; None for one that is read as it is and keeps what is written."""
    laps_of: str | None = None
    """Path of the signal whose rounds a program counts for its values, its own or another one of its component; None
    for a signal whose values end at the range of its kind."""
    is_field: bool = False
    """True if a write of its word would change other signals, so that it needs a masked write: not where a 0 changes
    none of them."""
    unit: str = ""
    minimum: int | float | None = None
    maximum: int | float | None = None
    """Limits that a write must keep, in the unit of the value."""
    group: str | None = None
    """The group that publishes it."""
    groups: tuple[str, ...] = ()
    """All groups that it belongs to, the one that publishes it first."""
    poll_hz: float | None = None
    """Reads a second by the host."""
    reset: int = 0
    """Bits after a reset, of what is written."""
    safe: Safe | None = None
    """Its state while a lease is not armed; None for a signal that no lease guards."""
    timed: str | None = None
    """Path of the schedule that can write it at an instant; None where none can."""
    pin: str | None = None
    """Pin of the board that the signal is, by the board's name; where it has several bits, the row of pins."""
    module: int | None = None
    """Index in `Interface.modules` of the module that it stands in."""
    doc: str = ""
    span: Span = NOWHERE

    @property
    def label(self) -> str:
        """Its name in its component, with its place in a row: ``acc[1]``."""
        return self.name if self.index is None else f"{self.name}[{self.index}]"

    @property
    def read_takes(self) -> bool:
        """Return whether a read takes what it gives, for good: a word of a queue, or bits that it clears."""
        return (self.fifo and self.access.reads) or self.effect is Effect.CLEAR_ON_READ

    @property
    def access_moves(self) -> bool:
        """Return whether an access moves what is there: words of a queue, or bits that a read clears."""
        return self.fifo or self.read_takes

    @property
    def has_events(self) -> bool:
        """Return whether its bits are set by hardware, and cleared by accesses."""
        return self.effect in {Effect.CLEAR_ON_READ, Effect.WRITE_1_TO_CLEAR}

    @property
    def is_given(self) -> bool:
        """Return whether its bits come from hardware, and not from what is written."""
        return self.access is Access.READ or self.has_events

    @property
    def width(self) -> int:
        """Bits."""
        return self.kind.width

    @property
    def words(self) -> int:
        """Number of words that it takes."""
        return -(-(self.lowest_bit + self.width) // self.word_bits)

    @property
    def addresses(self) -> range:
        """The addresses of its words."""
        return range(self.address, self.address + self.words)

    @property
    def mask(self) -> int:
        """The bits of its word that are its own; of several words, those of all as one number."""
        return ((1 << self.width) - 1) << self.lowest_bit

    def mask_at(self, address: int) -> int:
        """Return the bits that are its own of the word at one of its addresses."""
        return self.mask >> (address - self.address) * self.word_bits & (1 << self.word_bits) - 1

    @property
    def limits(self) -> tuple[float, float]:
        """Smallest and largest value that a write may have."""
        low, high = self.kind.range
        return (low if self.minimum is None else self.minimum, high if self.maximum is None else self.maximum)

    def decode(self, words: int | Sequence[int]) -> Value:
        """Return the value that stands in its word, or in its words in the order of their addresses."""
        whole = words if isinstance(words, int) else self._join(words)
        return self.kind.decode((whole & self.mask) >> self.lowest_bit)

    def _join(self, words: Sequence[int]) -> int:
        if len(words) != self.words:
            raise ArgumentError(f"{self.path} has {self.words} words, and {len(words)} were given")
        return sum(int(word) << (index * self.word_bits) for index, word in enumerate(words))

    def encode(self, value: Value | str) -> tuple[int, ...]:
        """Return the words of a value, one for each address; bits that are not its own are 0.

        Raises:
            ArgumentError: for a value that the kind cannot say, or outside of the limits.
        """
        try:
            raw = self.kind.encode(value)
        except ArgumentError as error:
            # The limits first: they are what the spec says, and closer than the bits.
            is_finite = isinstance(value, int) or (isinstance(value, float) and math.isfinite(value))
            beyond = self._limit_error(value) if is_finite else None
            raise beyond or ArgumentError(f"{self.path}: {error}") from None
        beyond = self._limit_error(value)
        if beyond is not None:
            raise beyond
        whole = raw << self.lowest_bit
        word_mask = (1 << self.word_bits) - 1
        return tuple(whole >> (index * self.word_bits) & word_mask for index in range(self.words))

    def _limit_error(self, value: Value | str) -> ArgumentError | None:
        """Return the error for a value beyond the limits; None for every other one."""
        if isinstance(value, str) or (self.minimum is None and self.maximum is None):
            return None
        low, high = self.limits
        try:
            is_within = low <= value <= high
        except ArithmeticError:
            # A `decimal.Decimal` that is no number is not compared.
            is_within = False
        return None if is_within else self.beyond_limits(value)

    def beyond_limits(self, value: Value) -> ArgumentError:
        """Return the error for a value outside of the limits."""
        low, high = self.limits
        unit = f" {self.unit}" if self.unit else ""
        return ArgumentError(f"{self.path}: {shown(value)} is outside of its limits, {low:.12g} to {high:.12g}{unit}")

    def facts(self, place: int, module: str | None) -> dict[str, str]:
        """As `Interface.facts`.

        Args:
            place: its own on the stage of its schedule, if it has one: a program puts values there.
            module: name of the module that it stands in.
        """
        kind, queue = self.kind, "a queue" if self.fifo_words is None else f"{self.fifo_words} words"
        low, high = kind.range
        return {
            "address": f"{self.address:#x}",
            "lowest bit": str(self.lowest_bit),
            "type": f"enum {kind.width}" if kind.enumeration is not None else str(kind),
            "access": str(self.access),
            **_facts(
                SCALE=None if kind.scale == 1 else _number(float(kind.scale)),
                OFFSET=None if kind.offset == 0 else _number(float(kind.offset)),
                UNIT=repr(self.unit) if self.unit else None,
                # A limit that the bits have anyway is none.
                MIN=None if self.minimum is None or self.minimum <= low else _number(self.minimum),
                MAX=None if self.maximum is None or self.maximum >= high else _number(self.maximum),
                RESET=_value(kind, self.reset) if self.reset else None,
                SAFE=None if self.safe is None else self._safe_text(self.safe),
                TIMED=None if self.timed is None else f"{self.timed}, place {place}",
                PUBLISH=self.group,
                FIFO=queue if self.fifo else None,
                EFFECT=self.effect,
                values=None if kind.enumeration is None else kind.enumeration.names,
                module=module,
            ),
            # Who writes a whole word would clear what others have there.
            **({"its word": "shared with others that are written"} if self.is_field else {}),
        }

    def _safe_text(self, safe: Safe) -> str:
        return f"({'HOLD' if safe.bits is None else _value(self.kind, safe.bits)}, {safe.lease})"


class ComponentSpec(msgspec.Struct, frozen=True, kw_only=True, tag_field="part", tag="component"):
    """A part of an interface: its signals, and the parts that it is made of. The root is the interface itself."""

    name: str
    path: str
    """Empty for the root."""
    type: str
    """Name of the declaration that it is made from."""
    index: int | None = None
    """Its place in an array."""
    arguments: dict[str, int | float | str | bool] = {}
    """Arguments of its declaration, by the names of the parameters: ``{"name": "joint 1"}``."""
    signals: tuple[Signal, ...] = ()
    parts: tuple[ComponentSpec | ComponentArray, ...] = ()
    modules: tuple[int, ...] = ()
    """Indices in `Interface.modules` of the modules that stand in it under a name of their own."""
    core: Core | None = None
    """The entity behind its signals; None for a component that is only a part of the map."""
    doc: str = ""
    """Doc string of the place where it is put, else of its declaration."""
    type_doc: str = ""
    """Doc string of its declaration, where `doc` is of the place."""
    span: Span = NOWHERE

    @property
    def rows(self) -> dict[str, tuple[Signal, ...]]:
        """Its signals by their names: those of a row together, any other one by itself."""
        rows: dict[str, list[Signal]] = {}
        for signal in self.signals:
            rows.setdefault(signal.name, []).append(signal)
        return {name: tuple(signals) for name, signals in rows.items()}

    def walk(self) -> Iterator[ComponentSpec]:
        """Return this component and all in it, in the order of the spec."""
        yield self
        for part in self.parts:
            for item in part.items if isinstance(part, ComponentArray) else (part,):
                yield from item.walk()


class ComponentArray(msgspec.Struct, frozen=True, kw_only=True, tag_field="part", tag="array"):
    """Components of one declaration in a row."""

    name: str
    path: str
    items: tuple[ComponentSpec, ...]
    doc: str = ""
    span: Span = NOWHERE


class ModuleSpec(msgspec.Struct, frozen=True, kw_only=True):
    """A hardware module on the bus."""

    type: str
    """The word of the spec: ``TOSNET``, ``MEMORY``."""
    name: str | None
    path: str | None
    """None for a module that only holds what stands in it."""
    base: int
    """Address of its first word on the gateway's bus."""
    words: int | None
    """Number of addresses that it takes; None where the spec does not say."""
    parent: int | None
    """Index of the module that it stands in."""
    arguments: dict[str, ModuleArgument]
    """Arguments of its declaration, without BASE and SIZE; flags are True."""
    doc: str = ""
    span: Span = NOWHERE

    @property
    def is_hardware(self) -> bool:
        """Return whether it takes addresses: a MEMORY without a name is only a base for what stands in it."""
        return self.type != "MEMORY" or self.name is not None

    @property
    def size(self) -> int | None:
        """Number of addresses that it takes: a queue has one by itself; None where the spec does not say."""
        return 1 if self.type == "FIFO" and self.words is None else self.words

    @property
    def called(self) -> str:
        """Its path; of one without a name, its type and address."""
        return self.path or f"{self.type} at {self.base:#x}"

    def facts(self, around: str | None, open_: Container[str]) -> dict[str, str]:
        """As `Interface.facts`.

        Args:
            around: name of the module that it stands in.
            open_: arguments that a program can give.
        """
        size = None if self.size is None else str(self.size)
        arguments = {name: str(value) for name, value in self.arguments.items() if name not in open_}
        return {"type": self.type, "address": f"{self.base:#x}", **_facts(SIZE=size, module=around), **arguments}


def gathered(parts: Iterable[ComponentSpec]) -> list[list[ComponentSpec]]:
    """Return the placements that share an instance: of one entity with equal ports, and equal generics not per axis.

    Args:
        parts: components with an entity.
    """
    found: dict[object, list[ComponentSpec]] = {}
    for part in parts:
        core = part.core
        assert core is not None
        key = (
            core.word,
            core.entity,
            core.wants,
            tuple(sorted((name, value) for name, value in core.generics.items() if name not in core.per_axis)),
            tuple((signal.name, signal.width, signal.is_given) for signal in part.signals),
            tuple((pin.name, pin.way) for pin in core.pins),
            tuple(trigger.name for trigger in core.triggers),
            part.path if core.stages else "",
        )
        found.setdefault(key, []).append(part)
    return list(found.values())


class Joint(msgspec.Struct, frozen=True, kw_only=True):
    """One joint of a group that is declared as joints: paths of its signals."""

    name: str
    """Path of the component whose signals these are."""
    position: str | None = None
    velocity: str | None = None
    effort: str | None = None
    set_position: str | None = None
    """Path of the position to be written, as the two below."""
    set_velocity: str | None = None
    set_effort: str | None = None


class Sensor(msgspec.Struct, frozen=True, kw_only=True):
    """One sensor of a group: a component whose signals have the names that a word such as IMU gives."""

    word: str
    """``IMU``, ``BATTERY`` or ``RANGEFINDER``."""
    name: str
    """Path of the component."""
    signals: dict[str, tuple[str, ...]]
    """Paths of the signals of each part, such as ``ANGULAR_VELOCITY``: x, y, z, and w of an orientation."""
    field_of_view: float = 0.0
    """Width of the cone of a rangefinder, in radians; 0 if it is not known."""
    infrared: bool = False
    """True for a rangefinder of infrared light, False for ultrasound."""


class GroupSpec(msgspec.Struct, frozen=True, kw_only=True):
    """Signals that are read together; published by the gateway where `number` is not None."""

    name: str
    number: int | None = None
    """Its number in the gateway."""
    divisor: int | None = None
    """Published at the gateway's base frequency divided by this."""
    rate_hz: float | None = None
    """Published at the nearest rate that the gateway has."""
    published_hz: float | None = None
    """Samples a second of a gateway that is generated from the spec: of its rates, the one nearest to `rate_hz`."""
    trigger: bool = False
    """Published on the group's external trigger."""
    on_change: bool = False
    immediate: bool = False
    timestamps: bool = False
    signals: tuple[str, ...] = ()
    """Paths of its signals, in the order of the spec."""
    addresses: tuple[int, ...] = ()
    """The words of a sample, each address once, in the order of the signals."""
    joints: tuple[Joint, ...] = ()
    sensors: tuple[Sensor, ...] = ()
    doc: str = ""
    span: Span = NOWHERE

    @property
    def facts(self) -> dict[str, str]:
        """As `Interface.facts`."""
        return _facts(
            RATE=None if self.rate_hz is None else f"{_number(self.rate_hz)} Hz",
            divisor=None if self.divisor is None else str(self.divisor),
            # Only there does its number in the gateway matter: each has a trigger of its own.
            TRIGGER=f"that of number {self.number}" if self.trigger else None,
            ON_CHANGE="given" if self.on_change else None,
            IMMEDIATE="given" if self.immediate else None,
            TIMESTAMPS="given" if self.timestamps else None,
        )


class Parameter(msgspec.Struct, frozen=True):
    """A parameter of an interface. Without a value, it is given when the interface is opened."""

    name: str
    value: int | float | str | bool | None = None


class Interface(msgspec.Struct, frozen=True, kw_only=True, dict=True):
    """A public interface: everything behind one gateway."""

    name: str
    parameters: tuple[Parameter, ...] = ()
    address_bits: int
    data_bits: int
    root: ComponentSpec
    modules: tuple[ModuleSpec, ...] = ()
    groups: tuple[GroupSpec, ...] = ()
    enumerations: tuple[Enumeration, ...] = ()
    """Those that its signals use."""
    doc: str = ""
    span: Span = NOWHERE

    @functools.cached_property
    def describe(self) -> Callable[[], bytes]:
        """A function that computes `description`: `unity_link.spec.compile_file` knows the text."""
        return bytes

    @functools.cached_property
    def describe_open(self) -> Callable[[], bytes]:
        """As `describe`, but also for an interface whose parameters were given: in its text they are open."""
        return self.describe

    @functools.cached_property
    def limits(self) -> tuple[Callable[[int], str], ...]:
        """Functions that take a clock in Hz, and return why a parameter of a core is not allowed; empty where it is."""
        return ()

    def check_clock(self, clock_hz: int) -> None:
        """Check the parameters of cores for a clock of the gateway.

        Raises:
            ArgumentError: for one that a core cannot have.
        """
        if message := self.beyond_limits(clock_hz):
            raise ArgumentError(message)

    def beyond_limits(self, clock_hz: int) -> str:
        """Return why a parameter of a core is not allowed with a clock of the gateway; empty if all are."""
        return next(filter(None, (limit(clock_hz) for limit in self.limits)), "")

    @functools.cached_property
    def description(self) -> bytes:
        """Its text, with those of its cores, as a board carries it; empty where it was made of no text."""
        return self.describe()

    @property
    def is_described(self) -> bool:
        """Return whether a board carries its description: at addresses where neither signals nor modules stand."""
        if not self.description or pages_of(len(self.description), self.data_bits) > MOST_PAGES:
            return False
        first = page_address(self.address_bits)
        ends = [signal.addresses[-1] for signal in self.signals.values()]
        ends += [
            (1 << self.address_bits if module.size is None else module.base + module.size) - 1
            for module in self.modules
            if module.is_hardware
        ]
        return all(end < first for end in ends)

    @functools.cached_property
    def signals(self) -> dict[str, Signal]:
        """All signals by their paths, in the order of the spec."""
        return {signal.path: signal for part in self.root.walk() for signal in part.signals}

    @functools.cached_property
    def cores(self) -> tuple[ComponentSpec, ...]:
        """All components with an entity behind them, in the order of the spec."""
        return tuple(part for part in self.root.walk() if part.core is not None)

    @property
    def leases(self) -> tuple[str, ...]:
        """Paths of the leases that are as this version knows them: no core of the spec's own has this word."""
        return tuple(
            part.path
            for part in self.cores
            if part.core is not None
            and (part.core.word == "LEASE" and part.core.library != "work")
            and part.path not in self.misfits
        )

    @functools.cached_property
    def misfits(self) -> dict[str, str]:
        """Why the Python of a core cannot be used, by the paths of components from a board of another version."""
        return {}

    @property
    def vhdl(self) -> tuple[str, ...]:
        """Files of VHDL of its cores, but for those that are installed with the gateware."""
        return tuple(dict.fromkeys(path for part in self.cores if part.core is not None for path in part.core.vhdl))

    @functools.cached_property
    def stages(self) -> dict[str, range]:
        """The places of timed signals on the stage of their schedule, by their paths: one for each 32 bits of a value.

        They are counted from 0 for each schedule, in the order of the addresses.
        """
        free: dict[str, int] = {}
        found: dict[str, range] = {}
        for signal in sorted(self.signals.values(), key=lambda one: one.address):
            if signal.timed is not None:
                first = free.get(signal.timed, 0)
                free[signal.timed] = first + -(-signal.width // STAGE_BITS)
                found[signal.path] = range(first, free[signal.timed])
        return found

    def schedules_of(self, lease: str) -> tuple[str, ...]:
        """Return the paths of the schedules that write signals that a lease guards, by its path."""
        guarded = (one for one in self.signals.values() if one.safe is not None and one.safe.lease == lease)
        return tuple(dict.fromkeys(one.timed for one in guarded if one.timed is not None))

    def written_under(self, lease: str) -> frozenset[int]:
        """Return the addresses that the owner of a lease alone writes: its kick, what it guards, and its schedules."""
        guarded = [one for one in self.signals.values() if one.safe is not None and one.safe.lease == lease]
        names = [f"{path}.{register}" for path in self.schedules_of(lease) for register in ("entry", "cancel")]
        # A schedule may be one of another version, without these registers.
        signals = [self.signals[name] for name in (f"{lease}.kick", *names) if name in self.signals] + guarded
        return frozenset(address for signal in signals for address in signal.addresses)

    def refused_by(self, lease: str) -> tuple[Signal, ...]:
        """Return the registers of a lease, by its path, and the signals that its owner alone writes."""
        written = self.written_under(lease)
        return tuple(
            one
            for one in self.signals.values()
            if one.path.startswith(f"{lease}.") or (one.access.writes and not written.isdisjoint(one.addresses))
        )

    @functools.cached_property
    def written_bits(self) -> dict[int, int]:
        """The bits of each word that signals write, by its address."""
        bits: dict[int, int] = {}
        for signal in self.signals.values():
            if signal.access.writes:
                for part, address in enumerate(signal.addresses):
                    mask = signal.mask >> (part * signal.word_bits) & ((1 << signal.word_bits) - 1)
                    bits[address] = bits.get(address, 0) | mask
        return bits

    @property
    def open_parameters(self) -> tuple[str, ...]:
        """Names of the parameters without a value: addresses that are given when it is opened."""
        return tuple(parameter.name for parameter in self.parameters if parameter.value is None)

    def check_given(self, values: Mapping[str, int | None]) -> None:
        """Check values for `open_parameters`; None is for one that is not needed.

        Raises:
            ArgumentError: for a parameter that there is not, or a value that is no address of the gateway.
        """
        for name, value in values.items():
            if name not in self.open_parameters:
                expected = ", ".join(self.open_parameters) or "none"
                raise ArgumentError(f"{self.name} has no parameter {name!r} to be given: {expected} expected")
            given: object = value
            if value is not None and not (isinstance(given, int) and 0 <= value < 1 << self.address_bits):
                last = (1 << self.address_bits) - 1
                raise ArgumentError(f"{name}={value!r} was given, an address from 0 to {last:#x} expected")

    def given(self, values: Mapping[str, int]) -> Interface:
        """Return the interface with values for some of its `open_parameters`, as if they stood in the spec.

        Raises:
            ArgumentError: as by `check_given`.
        """
        self.check_given(values)
        parameters = tuple(
            Parameter(one.name, values[one.name]) if one.name in values else one for one in self.parameters
        )
        modules = tuple(
            msgspec.structs.replace(
                module,
                arguments={
                    name: values.get(value.name, value) if isinstance(value, ParameterReference) else value
                    for name, value in module.arguments.items()
                },
            )
            for module in self.modules
        )
        changed = msgspec.structs.replace(self, parameters=parameters, modules=modules)
        # No limit names an open parameter: those of cores hold as they are.
        vars(changed).update(limits=self.limits, describe_open=self.describe_open)
        return changed

    @functools.cached_property
    def fingerprint(self) -> int:
        """32 bits that name the `facts`, in whatever order the spec declares them.

        A gateway that was generated from the interface has them as its build identifier.
        """
        lines = [
            "\n".join([thing, *sorted(f"{what}={value}" for what, value in properties.items())])
            for thing, properties in self.facts.items()
        ]
        return int.from_bytes(hashlib.sha256("\n".join(sorted(lines)).encode()).digest()[:4])

    @property
    def facts(self) -> dict[str, dict[str, str]]:
        """All that a read or write by a program depends on, in the words of a spec.

        Properties by the names of signals, groups, members of these, cores and modules. Comments, places in files,
        names that only people read, pins of the board and how a host polls are no part of them. A property that a thing
        does not have is left out, so that a later word of the language changes no fingerprint of a spec without it.
        """
        modules = {number: module.called for number, module in enumerate(self.modules) if module.is_hardware}
        widths = {"data bits": str(self.data_bits), "address bits": str(self.address_bits)}
        facts = {WHOLE: {"name": self.name, **widths}}
        for path, signal in self.signals.items():
            place = self.stages[path].start if path in self.stages else 0
            facts[path] = signal.facts(place, _called(modules, signal.module))
        for group in self.groups:
            if group.signals:
                facts[f"group {group.name}"] = group.facts
                facts.update({f"{path} in group {group.name}": {} for path in group.signals})
        facts.update({part.path: part.core.facts for part in self.cores if part.core is not None})
        open_ = _HANDLES if self.parameters else frozenset[str]()
        for number, name in modules.items():
            facts[name] = self.modules[number].facts(_called(modules, self.modules[number].parent), open_)
        return facts


def _called(modules: Mapping[int, str], number: int | None) -> str | None:
    """Return the name of a module, None for one that only holds what stands in it."""
    return None if number is None else modules.get(number)


class SourceFile(msgspec.Struct, frozen=True):
    """A file that a spec was read from."""

    name: str
    sha256: str


class Spec(msgspec.Struct, frozen=True, kw_only=True):
    """A whole spec: the public interfaces of one file."""

    interfaces: tuple[Interface, ...]
    sources: tuple[SourceFile, ...]
    """The file itself, and then what it imports."""
    warnings: tuple[Diagnostic, ...] = ()

    @property
    def vhdl(self) -> tuple[str, ...]:
        """Files of VHDL of the cores that are not installed with the gateware."""
        return tuple(dict.fromkeys(path for interface in self.interfaces for path in interface.vhdl))

    def interface(self, name: str | None = None) -> Interface:
        """Return an interface by its name, or the only one there is.

        Raises:
            ArgumentError: where there is none of that name, or the name is needed.
        """
        names = ", ".join(interface.name for interface in self.interfaces)
        if not names:
            raise ArgumentError("the spec has no public interface: it begins as in `public robot() {`")
        if name is None and len(self.interfaces) != 1:
            raise ArgumentError(f"the spec has {len(self.interfaces)} public interfaces: name one of {names}")
        for interface in self.interfaces:
            if name in {None, interface.name}:
                return interface
        raise ArgumentError(f"the spec has no public interface {name!r}: {names} was expected")

    def given(self, values: Mapping[str, int], interface: str | None = None) -> Spec:
        """Return the spec with values for some open parameters of an interface.

        Raises:
            ArgumentError: as by `interface` and `Interface.check_given`.
        """
        if not values:
            return self
        changed = self.interface(interface)
        known = tuple(one.given(values) if one is changed else one for one in self.interfaces)
        return msgspec.structs.replace(self, interfaces=known)

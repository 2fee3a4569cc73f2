"""The checked model of a spec: every expression is computed, every name is resolved, and every rule holds.

Proxies, generators and bridges use only this model, never the text of the spec. All objects are immutable, and
`msgspec` writes them as JSON.

    Spec -> Interface -> Component (a tree) -> Signal
                      -> Module, Group, Enumeration: address ranges, signals that are read together, names of values

A *path* is the Python expression by which a program reaches an object from the interface: ``legs[2].joints[0].cpos``.
An *ID* is the text that the author gave it. Addresses are word addresses on the gateway's bus and include the base of
the module.
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
"""Width in bits of one place on the stage of a schedule."""
WHOLE = "the interface"
"""Key of the interface itself in `Interface.facts`."""
_HANDLES = frozenset({"CTRL", "COMM"})
"""Arguments of modules that a program can supply when it opens an interface with parameters."""


def _facts(**properties: str | None) -> dict[str, str]:
    """Return the given properties without those that are None."""
    return {what: value for what, value in properties.items() if value is not None}


def _number(value: Value) -> str:
    """Format a number; a whole number has the same text as an int and as a float."""
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
        """Return whether the signal can be read."""
        return self is not Access.WRITE

    @property
    def writes(self) -> bool:
        """Return whether the signal can be written."""
        return self is not Access.READ


class Effect(enum.StrEnum):
    """Side effect of a read or write on the bits of a signal."""

    CLEAR_ON_READ = "CLEAR_ON_READ"
    """Hardware sets bits, and each read returns them and then clears them."""
    WRITE_1_TO_CLEAR = "WRITE_1_TO_CLEAR"
    """Hardware sets bits, and a write clears the bits that are 1 in the written word."""
    PULSE = "PULSE"
    """A written 1 lasts for one cycle of the gateway's clock; the signal reads as 0."""


class ParameterReference(msgspec.Struct, frozen=True, tag="parameter"):
    """An argument whose value is the interface's parameter of this name, given when the interface is opened."""

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
    """Path in the interface, formed like the path of a signal."""
    way: Way
    at: str | None = None
    """Pin of the board, by the board's name; None if the spec does not name one."""
    is_used: bool = True
    """False if the spec declares the pin as not connected (`none`)."""
    unwired: int = 0
    """Constant level of an input that has no pin."""


class Trigger(msgspec.Struct, frozen=True, kw_only=True):
    """An output of a core that makes the gateway publish a group."""

    name: str
    """Port of the core's entity."""
    group: str | None = None
    """Name of the group; None if the trigger is not used."""


class Core(msgspec.Struct, frozen=True, kw_only=True):
    """The hardware of a component: a VHDL entity whose ports are the component's signals, pins and triggers."""

    word: str
    """Word of the core that declares the component; empty if the spec itself declares the component."""
    entity: str
    library: str = "work"
    """VHDL library of the entity: `unity_link` for a core that is installed with the gateware, otherwise `work`."""
    vhdl: tuple[str, ...] = ()
    """VHDL files in the folder of the core; empty if the core is installed with the gateware."""
    wants: tuple[str, ...] = ()
    """Ports besides clock, reset and signals: ``tick``, ``now``, ``armed``; ``stage`` and ``finishing`` of a schedule;
    and ``empty`` of a lease, which is '1' if no schedule that writes signals of this lease has queued writes."""
    generics: dict[str, int | bool | str] = {}
    per_axis: tuple[str, ...] = ()
    """Names of the generics of type `integer_vector`, with one value for each placement."""
    pins: tuple[Pin, ...] = ()
    triggers: tuple[Trigger, ...] = ()
    python: str = ""
    """Module to import, or path of a file, with the core API and the quick model; empty if the core has none."""

    @property
    def stages(self) -> bool:
        """Return whether the core is a schedule, which writes other signals at given times."""
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
    """Bits of the signal while the lease is not armed; None for HOLD: the signal keeps its bits, and its core stops by
    a rule of its own."""
    lease: str
    """Path of the lease."""


class Signal(msgspec.Struct, frozen=True, kw_only=True, dict=True):
    """A named value: bits of a word, a whole word, or several consecutive words, the lowest bits in the first one."""

    name: str
    """Name in its declaration; all signals of a row have the same name."""
    path: str
    id: str
    index: int | None = None
    """Index in a row of signals; None for a single signal."""
    address: int
    """Address of the word, or of the first of several words."""
    word_bits: int
    """Width of a word of the gateway."""
    lowest_bit: int = 0
    kind: Kind
    access: Access
    fifo: bool = False
    """True if the address is the port of a queue: each read removes a word from it, each write appends one."""
    fifo_words: int | None = None
    """Depth of the queue in words; None if the spec does not state it."""
    effect: Effect | None = None
    """Side effect of reading or writing the signal; None if there is none."""
    laps_of: str | None = None
    """Path of the signal whose overflows the host counts to extend the values of this signal beyond the range of its
    kind: itself or another signal of its component. None if the values are not extended."""
    is_field: bool = False
    """True if a write of the whole word would change other signals too, so that a masked write is needed; False if
    zeros in their bits do not change the other signals."""
    unit: str = ""
    minimum: int | float | None = None
    maximum: int | float | None = None
    """Limits that a write must keep, in the unit of the value."""
    group: str | None = None
    """Name of the group that publishes the signal."""
    groups: tuple[str, ...] = ()
    """Names of all groups that contain the signal, the one that publishes it first."""
    poll_hz: float | None = None
    """Rate in Hz at which the host reads the signal; None if it is not polled."""
    reset: int = 0
    """Bits of a writable signal after a reset."""
    safe: Safe | None = None
    """State while a lease is not armed; None if no lease guards the signal."""
    timed: str | None = None
    """Path of the schedule that can write the signal at a given time; None if none can."""
    pin: str | None = None
    """Pin of the board that the signal is connected to, by the board's name; a signal of several bits has a row of
    pins of this name."""
    module: int | None = None
    """Index in `Interface.modules` of the module that contains the signal."""
    doc: str = ""
    span: Span = NOWHERE

    @property
    def label(self) -> str:
        """Name in its component, with the index in a row: ``acc[1]``."""
        return self.name if self.index is None else f"{self.name}[{self.index}]"

    @property
    def read_takes(self) -> bool:
        """Return whether a read consumes its data: it removes a word from a queue, or clears bits."""
        return (self.fifo and self.access.reads) or self.effect is Effect.CLEAR_ON_READ

    @property
    def access_moves(self) -> bool:
        """Return whether an access changes the stored data: words of a queue, or bits that a read clears."""
        return self.fifo or self.read_takes

    @property
    def has_events(self) -> bool:
        """Return whether hardware sets the bits and accesses clear them."""
        return self.effect in {Effect.CLEAR_ON_READ, Effect.WRITE_1_TO_CLEAR}

    @property
    def is_given(self) -> bool:
        """Return whether hardware supplies the bits, not a write."""
        return self.access is Access.READ or self.has_events

    @functools.cached_property
    def width(self) -> int:
        """Width in bits."""
        return self.kind.width

    @functools.cached_property
    def words(self) -> int:
        """Number of words that the signal occupies."""
        return -(-(self.lowest_bit + self.width) // self.word_bits)

    @functools.cached_property
    def addresses(self) -> range:
        """The addresses of its words."""
        return range(self.address, self.address + self.words)

    @functools.cached_property
    def mask(self) -> int:
        """The signal's bits in its word; for several words, in the number that the words form together."""
        return ((1 << self.width) - 1) << self.lowest_bit

    def mask_at(self, address: int) -> int:
        """Return the signal's bits within the word at one of its addresses."""
        return self.mask >> (address - self.address) * self.word_bits & (1 << self.word_bits) - 1

    @functools.cached_property
    def limits(self) -> tuple[float, float]:
        """Smallest and largest value that can be written."""
        low, high = self.kind.range
        return (low if self.minimum is None else self.minimum, high if self.maximum is None else self.maximum)

    def decode(self, words: int | Sequence[int]) -> Value:
        """Return the value in a word, or in the words in the order of their addresses."""
        whole = words if isinstance(words, int) else self._join(words)
        return self.kind.decode((whole & self.mask) >> self.lowest_bit)

    def _join(self, words: Sequence[int]) -> int:
        if len(words) != self.words:
            raise ArgumentError(f"{self.path} has {self.words} words, and {len(words)} were given")
        return sum(int(word) << (index * self.word_bits) for index, word in enumerate(words))

    def encode(self, value: Value | str) -> tuple[int, ...]:
        """Return the words of a value, one for each address; bits of other signals are 0.

        Raises:
            ArgumentError: for a value that the kind cannot represent, or that is outside of the limits.
        """
        try:
            raw = self.kind.encode(value)
        except ArgumentError as error:
            # Check the limits first: the author wrote them, so that they explain more than the range of the bits.
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
        """Return the error for a value outside of the limits; None for any other value."""
        if isinstance(value, str) or (self.minimum is None and self.maximum is None):
            return None
        low, high = self.limits
        try:
            is_within = low <= value <= high
        except ArithmeticError:
            # A `decimal.Decimal` that is not a number cannot be compared.
            is_within = False
        return None if is_within else self.beyond_limits(value)

    def beyond_limits(self, value: Value) -> ArgumentError:
        """Return the error for a value outside of the limits."""
        low, high = self.limits
        unit = f" {self.unit}" if self.unit else ""
        return ArgumentError(f"{self.path}: {shown(value)} is outside of its limits, {low:.12g} to {high:.12g}{unit}")

    def facts(self, place: int, module: str | None) -> dict[str, str]:
        """Return the properties of the signal, as in `Interface.facts`.

        Args:
            place: the first place of the signal on the stage of its schedule; 0 if it has none.
            module: name of the module that contains the signal.
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
                # A limit that the range of the bits implies is left out.
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
            # Such a signal needs a masked write: a write of the whole word would clear the other signals.
            **({"its word": "shared with others that are written"} if self.is_field else {}),
        }

    def _safe_text(self, safe: Safe) -> str:
        return f"({'HOLD' if safe.bits is None else _value(self.kind, safe.bits)}, {safe.lease})"


class ComponentSpec(msgspec.Struct, frozen=True, kw_only=True, tag_field="part", tag="component"):
    """A part of an interface: its signals and the parts inside it. The root is the interface itself."""

    name: str
    path: str
    """Empty for the root."""
    type: str
    """Name of its declaration."""
    index: int | None = None
    """Index in an array."""
    arguments: dict[str, int | float | str | bool] = {}
    """Arguments of its declaration by parameter names: ``{"name": "joint 1"}``."""
    signals: tuple[Signal, ...] = ()
    parts: tuple[ComponentSpec | ComponentArray, ...] = ()
    modules: tuple[int, ...] = ()
    """Indices in `Interface.modules` of the named modules directly inside the component."""
    core: Core | None = None
    """The entity that implements the signals; None for a component that only groups registers."""
    doc: str = ""
    """Doc string of the placement; if that has none, doc string of the declaration."""
    type_doc: str = ""
    """Doc string of the declaration if `doc` is that of the placement."""
    span: Span = NOWHERE

    @property
    def rows(self) -> dict[str, tuple[Signal, ...]]:
        """Signals by name: all signals of a row, or a single signal."""
        rows: dict[str, list[Signal]] = {}
        for signal in self.signals:
            rows.setdefault(signal.name, []).append(signal)
        return {name: tuple(signals) for name, signals in rows.items()}

    def walk(self) -> Iterator[ComponentSpec]:
        """Yield this component and all components inside it, in the order of the spec."""
        yield self
        for part in self.parts:
            for item in part.items if isinstance(part, ComponentArray) else (part,):
                yield from item.walk()


class ComponentArray(msgspec.Struct, frozen=True, kw_only=True, tag_field="part", tag="array"):
    """An array of components of one declaration."""

    name: str
    path: str
    items: tuple[ComponentSpec, ...]
    doc: str = ""
    span: Span = NOWHERE


class ModuleSpec(msgspec.Struct, frozen=True, kw_only=True):
    """A hardware module on the bus."""

    type: str
    """Word of the module in the spec: ``TOSNET``, ``MEMORY``."""
    name: str | None
    path: str | None
    """None for a module that only contains other members."""
    base: int
    """Address of its first word on the gateway's bus."""
    words: int | None
    """Number of addresses; None if the spec does not state it."""
    parent: int | None
    """Index of the module that contains this one."""
    arguments: dict[str, ModuleArgument]
    """Arguments of its declaration without BASE and SIZE; the value of a flag is True."""
    doc: str = ""
    span: Span = NOWHERE

    @property
    def is_hardware(self) -> bool:
        """Return whether the module occupies addresses. A MEMORY without a name only sets the base of its members."""
        return self.type != "MEMORY" or self.name is not None

    @property
    def size(self) -> int | None:
        """Number of addresses; None if the spec does not state it. A queue has one unless SIZE is given."""
        return 1 if self.type == "FIFO" and self.words is None else self.words

    @property
    def called(self) -> str:
        """Path of the module; if it has no name, its type and address."""
        return self.path or f"{self.type} at {self.base:#x}"

    def facts(self, around: str | None, open_: Container[str]) -> dict[str, str]:
        """Return the properties of the module, as in `Interface.facts`.

        Args:
            around: name of the module that contains this one.
            open_: names of the arguments that a program can supply.
        """
        size = None if self.size is None else str(self.size)
        arguments = {name: str(value) for name, value in self.arguments.items() if name not in open_}
        return {"type": self.type, "address": f"{self.base:#x}", **_facts(SIZE=size, module=around), **arguments}


def gathered(parts: Iterable[ComponentSpec]) -> list[list[ComponentSpec]]:
    """Return the placements grouped by shared instance: same entity, equal ports, equal generics except those per axis.

    A schedule is never shared.

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
    """One joint of a group that has JOINTS: the paths of its signals."""

    name: str
    """Path of the component that contains the signals."""
    position: str | None = None
    velocity: str | None = None
    effort: str | None = None
    set_position: str | None = None
    """Path of the signal to write for a position; likewise for velocity and effort below."""
    set_velocity: str | None = None
    set_effort: str | None = None


class Sensor(msgspec.Struct, frozen=True, kw_only=True):
    """One sensor of a group: a component that contains the signals named in a clause such as IMU(...)."""

    word: str
    """``IMU``, ``BATTERY`` or ``RANGEFINDER``."""
    name: str
    """Path of the component."""
    signals: dict[str, tuple[str, ...]]
    """Paths of the signals of each part, such as ``ANGULAR_VELOCITY``: x, y, z, and w of an orientation."""
    field_of_view: float = 0.0
    """Opening angle of a rangefinder's cone in radians; 0 if unknown."""
    infrared: bool = False
    """True for an infrared rangefinder, False for an ultrasonic one."""


class GroupSpec(msgspec.Struct, frozen=True, kw_only=True):
    """Signals that are read together; the gateway publishes the group if `number` is not None."""

    name: str
    number: int | None = None
    """Number of the group in the gateway."""
    divisor: int | None = None
    """Divisor of the gateway's base frequency."""
    rate_hz: float | None = None
    """Requested rate in Hz; the group is published at the nearest rate that the gateway has."""
    published_hz: float | None = None
    """Rate in Hz of a gateway that is generated from the spec: the available rate that is nearest to `rate_hz`."""
    trigger: bool = False
    """True if the group is published on its external trigger."""
    on_change: bool = False
    immediate: bool = False
    timestamps: bool = False
    signals: tuple[str, ...] = ()
    """Paths of the signals, in the order of the spec."""
    addresses: tuple[int, ...] = ()
    """Addresses of the words of a sample, each once, in the order of the signals."""
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
            # The group's number matters only with TRIGGER: it selects the trigger input.
            TRIGGER=f"that of number {self.number}" if self.trigger else None,
            ON_CHANGE="given" if self.on_change else None,
            IMMEDIATE="given" if self.immediate else None,
            TIMESTAMPS="given" if self.timestamps else None,
        )


class Parameter(msgspec.Struct, frozen=True):
    """A parameter of an interface. If it has no value, the program supplies one when it opens the interface."""

    name: str
    value: int | float | str | bool | None = None


class Interface(msgspec.Struct, frozen=True, kw_only=True, dict=True):
    """A public interface: everything that programs reach through one gateway."""

    name: str
    parameters: tuple[Parameter, ...] = ()
    address_bits: int
    data_bits: int
    root: ComponentSpec
    modules: tuple[ModuleSpec, ...] = ()
    groups: tuple[GroupSpec, ...] = ()
    enumerations: tuple[Enumeration, ...] = ()
    """The enumerations that the signals use."""
    doc: str = ""
    span: Span = NOWHERE

    @functools.cached_property
    def describe(self) -> Callable[[], bytes]:
        """A function that computes `description`; the compiler sets it, because the model does not keep the text."""
        return bytes

    @functools.cached_property
    def describe_open(self) -> Callable[[], bytes]:
        """Like `describe`, but the description has open parameters, even if their values were given."""
        return self.describe

    @functools.cached_property
    def limits(self) -> tuple[Callable[[int], str], ...]:
        """Functions of a clock in Hz; each returns why a core's parameter is not allowed, or an empty string."""
        return ()

    def check_clock(self, clock_hz: int) -> None:
        """Check the parameters of cores for the frequency of the gateway's clock.

        Raises:
            ArgumentError: if a core does not allow a parameter at this clock.
        """
        if message := self.beyond_limits(clock_hz):
            raise ArgumentError(message)

    def beyond_limits(self, clock_hz: int) -> str:
        """Return why a core does not allow a parameter at a gateway clock in Hz; empty if all are allowed."""
        return next(filter(None, (limit(clock_hz) for limit in self.limits)), "")

    @functools.cached_property
    def description(self) -> bytes:
        """Compressed texts of the spec and its cores, as a board carries them; empty if the model has no text."""
        return self.describe()

    @property
    def is_described(self) -> bool:
        """Return whether a board carries the description: it fits, and no signal or module uses its addresses."""
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
        """All signals by path, in the order of the spec."""
        return {signal.path: signal for part in self.root.walk() for signal in part.signals}

    @functools.cached_property
    def cores(self) -> tuple[ComponentSpec, ...]:
        """All components that are implemented by an entity, in the order of the spec."""
        return tuple(part for part in self.root.walk() if part.core is not None)

    @property
    def leases(self) -> tuple[str, ...]:
        """Paths of the leases that this version supports; a core of the spec itself is never a lease."""
        return tuple(
            part.path
            for part in self.cores
            if part.core is not None
            and (part.core.word == "LEASE" and part.core.library != "work")
            and part.path not in self.misfits
        )

    @functools.cached_property
    def misfits(self) -> dict[str, str]:
        """Reasons why the API of a core cannot be used, by path, if the board has another version of the core."""
        return {}

    @property
    def vhdl(self) -> tuple[str, ...]:
        """VHDL files of the cores that are not installed with the gateware."""
        return tuple(dict.fromkeys(path for part in self.cores if part.core is not None for path in part.core.vhdl))

    @functools.cached_property
    def stages(self) -> dict[str, range]:
        """Places of timed signals on the stage of their schedule, by path: one place for each 32 bits of a value.

        Each schedule counts its places from 0, in the order of the addresses.
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
        """Return the paths of the schedules that write signals guarded by a lease, given its path."""
        guarded = (one for one in self.signals.values() if one.safe is not None and one.safe.lease == lease)
        return tuple(dict.fromkeys(one.timed for one in guarded if one.timed is not None))

    def written_under(self, lease: str) -> frozenset[int]:
        """Return the addresses that only the owner of a lease writes: kick, guarded signals and their schedules."""
        guarded = [one for one in self.signals.values() if one.safe is not None and one.safe.lease == lease]
        names = [f"{path}.{register}" for path in self.schedules_of(lease) for register in ("entry", "cancel")]
        # A schedule of another version may not have these registers.
        signals = [self.signals[name] for name in (f"{lease}.kick", *names) if name in self.signals] + guarded
        return frozenset(address for signal in signals for address in signal.addresses)

    def refused_by(self, lease: str) -> tuple[Signal, ...]:
        """Return the registers of a lease, given its path, and the signals that only its owner writes."""
        written = self.written_under(lease)
        return tuple(
            one
            for one in self.signals.values()
            if one.path.startswith(f"{lease}.") or (one.access.writes and not written.isdisjoint(one.addresses))
        )

    @functools.cached_property
    def written_bits(self) -> dict[int, int]:
        """The bits of each word that belong to writable signals, by address."""
        bits: dict[int, int] = {}
        for signal in self.signals.values():
            if signal.access.writes:
                for part, address in enumerate(signal.addresses):
                    mask = signal.mask >> (part * signal.word_bits) & ((1 << signal.word_bits) - 1)
                    bits[address] = bits.get(address, 0) | mask
        return bits

    @property
    def open_parameters(self) -> tuple[str, ...]:
        """Names of the parameters without a value: addresses that the program supplies when it opens the interface."""
        return tuple(parameter.name for parameter in self.parameters if parameter.value is None)

    def check_given(self, values: Mapping[str, int | None]) -> None:
        """Check values for `open_parameters`; None means that the parameter is not needed.

        Raises:
            ArgumentError: for an unknown parameter, or a value that is not an address of the gateway.
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
        """Return the interface with values for some of its `open_parameters`, as if the spec contained them.

        Raises:
            ArgumentError: if `check_given` rejects the values.
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
        # No limit names an open parameter, so the limits of cores do not change.
        vars(changed).update(limits=self.limits, describe_open=self.describe_open)
        return changed

    @functools.cached_property
    def fingerprint(self) -> int:
        """32-bit hash of the `facts`; the order of declarations in the spec does not matter.

        A gateway that was generated from the interface reports it as its build identifier.
        """
        lines = [
            "\n".join([thing, *sorted(f"{what}={value}" for what, value in properties.items())])
            for thing, properties in self.facts.items()
        ]
        return int.from_bytes(hashlib.sha256("\n".join(sorted(lines)).encode()).digest()[:4])

    @property
    def facts(self) -> dict[str, dict[str, str]]:
        """All properties that a read or write by a program depends on, in the words of a spec.

        Keys are the names of signals, groups, members of groups, cores and modules. Comments, places in files, names
        for display, pins of the board and polling rates are left out. A property with its default value is left out,
        so that a new word of the language does not change the fingerprint of a spec that does not use it.
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
    """Return the name of a module by its number; None if it only contains other members."""
    return None if number is None else modules.get(number)


class SourceFile(msgspec.Struct, frozen=True):
    """A file that was read to compile a spec."""

    name: str
    sha256: str


class Spec(msgspec.Struct, frozen=True, kw_only=True):
    """A whole spec: the public interfaces of one file."""

    interfaces: tuple[Interface, ...]
    sources: tuple[SourceFile, ...]
    """The file itself, then the imported files."""
    warnings: tuple[Diagnostic, ...] = ()

    @property
    def vhdl(self) -> tuple[str, ...]:
        """VHDL files of the cores that are not installed with the gateware."""
        return tuple(dict.fromkeys(path for interface in self.interfaces for path in interface.vhdl))

    def interface(self, name: str | None = None) -> Interface:
        """Return an interface by name, or the only interface.

        Raises:
            ArgumentError: if there is no interface of that name, or no name is given and there are several.
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
            ArgumentError: if `interface` or `Interface.check_given` raises one.
        """
        if not values:
            return self
        changed = self.interface(interface)
        known = tuple(one.given(values) if one is changed else one for one in self.interfaces)
        return msgspec.structs.replace(self, interfaces=known)

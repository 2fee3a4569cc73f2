"""A simulated robot of a spec: a class that computes how the values of signals change.

::

    class Rover(SimulatedRobot):
        def step(self, dt):
            self.left.speed += (6 * self.left.duty - self.left.speed) * dt / 0.1
            self.left.position += self.left.speed * dt

    gateway = simulate("rover.ul", Rover)
    async with unity_link.connect(gateway) as link:
        ...

Without a class the registers of the spec are memory. `registers` models the registers on the bus.
"""

from __future__ import annotations

import asyncio
import keyword
import logging
import math
import time
from collections import deque
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Self, cast

from unity_link.errors import ANY_ERROR, ArgumentError
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.spec import ComponentArray
from unity_link.spec.diagnostics import did_you_mean
from unity_link.virtual.bus import AccessError
from unity_link.virtual.core_models import CoreModels
from unity_link.virtual.registers import SIGNAL_FAULTS, Registers

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from unity_link.spec import ComponentSpec, Interface, Value
    from unity_link.virtual.core_models import PinsOfCore
    from unity_link.virtual.registers import Cell, SignalFault

_LOG = logging.getLogger("unity_link.virtual")
MOST_AT_ONCE = 10.0
"""Largest number of seconds by which one access advances the robot; the rest of the time is skipped."""
LONGEST_TURN = 0.25
"""Longest duration in seconds of one access to a robot that is slower than real time."""
LONGEST_UNSEEN = 0.001
"""Seconds between two steps of a robot without a step size, with compiled gateware."""
_SLACK = 1e-9


class Fault:
    """A fault of a robot, declared as an attribute of its class; its value is True while the fault is on.

    Args:
        doc: description of the fault for users.
    """

    def __init__(self, doc: str) -> None:
        self.doc = doc
        self._name = ""

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    def __get__(self, robot: SimulatedRobot | None, owner: type) -> Any:
        return self if robot is None else self._name in robot.faults

    def __set__(self, robot: SimulatedRobot, on: bool) -> None:  # noqa: FBT001  (it is an assignment)
        robot.set_fault(self._name, on=on)


class RowValues(Sequence[Any]):
    """Values of a row of signals, which are read and set by index, by slice, or all at once.

    Args:
        part: part of the robot with these signals.
        labels: names of the part's attributes for the signals.
    """

    def __init__(self, part: Part, labels: list[str]) -> None:
        self._part = part
        self._labels = labels

    def __len__(self) -> int:
        return len(self._labels)

    def __getitem__(self, place: Any) -> Any:
        """Return a value, or for a slice a list of values."""
        found = self._labels[place]
        return getattr(self._part, found) if isinstance(found, str) else [getattr(self._part, one) for one in found]

    def __setitem__(self, place: Any, value: Any) -> None:
        """Set a value, or the values of a slice.

        Raises:
            ArgumentError: if a signal cannot have its value, or the number of values is wrong.
        """
        found = self._labels[place]
        labels, values = ([found], [value]) if isinstance(found, str) else (found, [*value])
        if len(labels) != len(values):
            raise ArgumentError(
                f"{labels[0]} and the next ones are {len(labels)} signals, and {len(values)} values were given"
            )
        for label, one in zip(labels, values, strict=True):
            setattr(self._part, label, one)

    def __repr__(self) -> str:
        return repr([*self])


class Part:
    """A part of a simulated robot; its attributes are the values of its signals, and its parts."""

    _name: str
    _cells: dict[str, Cell]
    _pins: dict[str, int]
    """Levels of a core's pins by name, 0 or 1."""
    _unwired: frozenset[str]
    """Names of a core's pins that are `none` in the spec, and keep their levels."""
    _pin_set: Callable[[str], None]
    """Is called with the name of each pin that the user's model sets."""
    _started: bool

    def __getattr__(self, name: str) -> Any:
        """Return the value of a signal, the `Queue` of a FIFO port, or the level of a core's pin, 0 or 1.

        Raises:
            AttributeError: if there is no such signal or pin.
        """
        cells = self.__dict__.get("_cells", {})
        if name not in cells:
            pins = self.__dict__.get("_pins", {})
            if name in pins:
                return pins[name]
            raise self._unknown(name)
        cell = cells[name]
        if cell.wire is not None:
            cell.wire.look(cell)
        return cell.value if cell.queue is None else cell.queue

    def __setattr__(self, name: str, value: Any) -> None:
        """Set the value of a signal or the level of a pin; before the first step also create other attributes.

        Raises:
            ArgumentError: if the signal or the pin cannot have the value.
            AttributeError: if there is no such signal or attribute.
        """
        cell = self.__dict__.get("_cells", {}).get(name)
        if cell is None and name in self.__dict__.get("_pins", {}):
            if value not in {0, 1}:
                raise ArgumentError(f"{self._name}.{name} is a pin, and 0 or 1, not {value!r:.80}")
            if name in self._unwired:
                raise ArgumentError(f"{self._name}.{name} is none in the spec, and has no pin that a model can set")
            self._pins[name] = int(value)
            self._pin_set(name)
        elif isinstance(row := self.__dict__.get(name), RowValues):
            row[:] = value
        elif cell is None:
            if self.__dict__.get("_started") and name not in self.__dict__ and not hasattr(type(self), name):
                raise self._unknown(name)
            object.__setattr__(self, name, value)
        elif cell.queue is None:
            cell.set(value)
        else:
            raise ArgumentError(f"{cell.signal.path} is a FIFO port, which is not assigned to: put(value) appends one")

    def __repr__(self) -> str:
        """Return the name of the part, and the values of its signals."""
        values = ", ".join(f"{name}={cell.value!r}" for name, cell in self._cells.items() if cell.queue is None)
        return f"<{self._name}: {values}>"

    def _unknown(self, name: str) -> AttributeError:
        known = self.__dict__
        hint = did_you_mean(
            name,
            [*known.get("_cells", ()), *known.get("_pins", ()), *(key for key in known if not key.startswith("_"))],
        )
        return AttributeError(
            f"{known.get('_name', type(self).__name__)} has nothing called {name!r}"
            + (f": {hint}" if hint else ", and a model's own attributes are made in start()")
        )


class SimulatedRobot(Part):
    """Base class of models; as it is, the model of a robot whose registers are memory.

    A subclass overrides `start`, `step` and `written`. In these methods signals are attributes with the names of the
    spec, and have values in their units. A name that is a keyword of Python or an attribute of this class gets the
    suffix ``_``. In a signal that accesses clear, the model sets bits and a program clears them. A pulse is passed to
    `written` only.

    Args:
        interface: interface of a spec.

    Raises:
        ArgumentError: if an attribute of the class has the name of a part of the spec.
    """

    step_seconds: ClassVar[float | None] = 0.001
    """Step size in seconds; None for a single step up to each time at which the robot is accessed."""

    interface: Interface
    """Declaration of the robot in the spec."""
    now: float
    """Seconds since the robot's start."""
    faults: set[str]
    """Names of the faults that are on."""
    fired: deque[tuple[float, int]]
    """Triggers that the robot has fired and the gateway has not processed: time, and number of the group."""
    cores: CoreModels
    """Models of the cores of the spec."""
    _registers: Registers
    _parts: list[Part]
    _began: float | None
    """Time of the robot's start on the callers' clock; None before it."""
    _last: float
    """Time of the last access on the callers' clock."""
    _steps: int
    refusal: str
    """Reason why the robot refuses all accesses after `step` has failed; empty before."""
    is_wired: bool
    """True if compiled gateware has the registers and cores; programs then do not notice that `step` has failed."""
    _told_late: bool

    def __new__(cls, interface: Interface, *_: Any) -> Self:
        """Create a robot with the signals of a spec, before `__init__` runs."""
        robot = super().__new__(cls)
        robot.interface = interface
        robot.now = robot._last = 0.0
        robot.faults = set()
        robot.fired = deque()
        robot._registers = Registers(interface, loops_back=cls is SimulatedRobot)
        robot._parts = []
        robot.cores = CoreModels(robot._registers, robot.trigger, robot.tell_written)
        robot._began = None
        robot._steps = 0
        robot.refusal = ""
        robot.is_wired = False
        robot._told_late = False
        robot._fill(robot, interface.root)
        return robot

    def __init__(self, interface: Interface) -> None:
        """Do nothing: a model creates its own attributes in `start`."""

    def __repr__(self) -> str:
        """Return the name of the class."""
        return f"<{type(self).__name__} of {self.interface.name}>"

    # Overridden by models

    def start(self) -> None:
        """Set initial values of signals, which are otherwise 0, and create the model's own attributes."""

    def step(self, dt: float) -> None:
        """Advance the model.

        Args:
            dt: time in seconds; always `step_seconds` unless that is None.
        """

    def written(self, path: str, value: Value) -> None:
        """Handle a write of a program; the value of the signal has changed already.

        Args:
            path: path of the signal in the spec, such as ``left.duty``.
            value: the written value.
        """

    # Called by models and tests

    def trigger(self, group: str) -> None:
        """Fire the trigger of a group that is declared with TRIGGER, so that the gateway publishes the group.

        Raises:
            ArgumentError: if the group does not exist, or has no trigger.
        """
        self.fired.append(((self._began or 0.0) + self.now, self.triggered_group(group)))

    def triggered_group(self, name: str) -> int:
        """Return the number of a group with a trigger.

        Raises:
            ArgumentError: if the group does not exist, or has no trigger.
        """
        groups = {group.name: group for group in self.interface.groups}
        triggered = [group.name for group in groups.values() if group.trigger]
        group = groups.get(name)
        if group is None or not group.trigger or group.number is None:
            what = f"no group {name!r}" if group is None else f"no trigger in the group {name!r}"
            having = f"its groups with TRIGGER are {', '.join(triggered)}" if triggered else "no group has TRIGGER"
            raise ArgumentError(f"{self.interface.name} has {what}: {did_you_mean(name, triggered) or having}")
        return group.number

    def set_fault(self, name: str, how: SignalFault = "error", *, on: bool = True) -> None:
        """Switch a fault on or off.

        Args:
            name: name of a `Fault` of the class, or path of a signal.
            how: kind of a signal's fault: accesses end with a bus error (``"error"``) or time out (``"timeout"``), or
                reads return the present value (``"frozen"``).
            on: True to switch the fault on, False to switch it off.

        Raises:
            ArgumentError: if the fault or the signal does not exist.
        """
        if name in self.known_faults():
            (self.faults.add if on else self.faults.discard)(name)
            return
        if name not in self._registers.cells:
            known = [*self.known_faults(), *self._registers.cells]
            hint = did_you_mean(name, known)
            faults = ", ".join(self.known_faults())
            expected = f"one of its faults ({faults}) or the" if faults else "the"
            raise ArgumentError(
                f"{self.interface.name} has no fault and no signal {name!r}: "
                + (hint or f"{expected} path of a signal was expected, such as {next(iter(self._registers.cells), '')}")
            )
        self._registers.set_fault(name, how if on else None)

    @classmethod
    def known_faults(cls) -> dict[str, str]:
        """Return the descriptions of the class's faults, by name."""
        return {
            name: fault.doc
            for base in reversed(cls.__mro__)
            for name, fault in vars(base).items()
            if isinstance(fault, Fault)
        }

    # Called by the bus and by gateways

    @property
    def next_step(self) -> float | None:
        """Time at which `pass_time` should be called if no access occurs before; None if no call is necessary."""
        if self.refusal or self._began is None or self.step_seconds is None or not self._moves:
            return None
        return self._last + max(self.step_seconds, 0.01)

    @property
    def due(self) -> float | None:
        """Time of the next step; None if there are no steps."""
        if self.refusal or self._began is None or not self._moves:
            return None
        if self.step_seconds is None:
            return self._last + LONGEST_UNSEEN
        return self._began + (self._steps + 1) * self.step_seconds

    @property
    def cells(self) -> Mapping[str, Cell]:
        """Signals by path in the spec."""
        return self._registers.cells

    def read(self, offset: int, now: float) -> int:
        """Return the word at an address."""
        self.pass_time(now)
        return self._registers.read(offset, now)

    def write(self, offset: int, value: int, now: float) -> None:
        """Write the word at an address."""
        # All words of a block have the same time. `written` is called for each word before the next one is written.
        if now != self._last or self._began is None or self.refusal:
            self.pass_time(now)
        for cell in self._registers.write(offset, value):
            self.cores.written(cell.signal.path)
            self.tell_written(cell)

    def tell_written(self, cell: Cell) -> None:
        """Call `written` for a signal that a program wrote."""
        self.written(cell.signal.path, cell.written if cell.queue is None else self._last_of(cell))

    def wire_pins(self, pins: Mapping[str, PinsOfCore]) -> None:
        """Replace the pins of core models by those of compiled gateware.

        Args:
            pins: pins of each core, by path of its component.
        """
        self.cores.meet_pins(pins)
        for part in self._parts:
            if part._name in pins:  # noqa: SLF001  (this class creates it)
                part.__dict__["_pins"] = pins[part._name]  # noqa: SLF001
                part.__dict__["_pin_set"] = lambda _: None

    def prepare(self) -> None:
        """Call `start`; after that, new attributes cannot be created."""
        self.start()
        for part in (self, *self._parts):
            part._started = True  # noqa: SLF001  (this class creates it)

    def begin(self, now: float) -> None:
        """Start the robot's time at `now`, unless it has started already."""
        if self._began is None:
            self._began = self._last = now

    def pass_time(self, now: float, *, until_fired: bool = False) -> None:
        """Advance the robot to a time.

        Args:
            now: the time in seconds from any origin.
            until_fired: True to stop after a step that fires a trigger.

        Raises:
            AccessError: if `step` fails now, or has failed before.
        """
        if self.refusal:
            raise AccessError(ErrorCode.BUS_ERROR)
        self.begin(now)
        assert self._began is not None
        # The time goes back if the calls come from another event loop with another clock.
        self._began -= max(0.0, self._last - now)
        self._last = now
        if not self._moves:
            self.now = now - self._began
        elif self.step_seconds is None:
            passed = now - self._began - self.now
            if passed > 0:
                self.now += passed
                self._step(passed)
        else:
            self._step_up_to(now - self._began, self.step_seconds, until_fired=until_fired)
        if not (until_fired and self.fired):
            self.cores.step(now)

    @property
    def _moves(self) -> bool:
        return type(self).step is not SimulatedRobot.step

    def _step_up_to(self, until: float, size: float, *, until_fired: bool) -> None:
        wanted, first, started = math.floor(until / size + _SLACK), self._steps, _clock()
        most = first + max(1, round(MOST_AT_ONCE / size))
        while self._steps < wanted and not (until_fired and self.fired):
            taken = _clock() - started
            if self._steps >= most or (taken > LONGEST_TURN and taken > (self._steps - first) * size):
                self._leave_out((wanted - self._steps) * size)
                return
            self._steps += 1
            self.now = self._steps * size
            self._step(size)

    def _step(self, dt: float) -> None:
        instant = (self._began or 0.0) + self.now
        # Advance the cores before the model, which then sees safe values in time, and after it, for changed pins.
        self.cores.step(instant)
        try:
            self.step(dt)
        except ANY_ERROR as error:
            after = f"{self.now:.3f} s after its start"
            self.refusal = f"the model {type(self).__name__} failed {after}: {type(error).__name__}: {error}"
            follows = "nothing moves" if self.is_wired else "all accesses are bus errors"
            _LOG.exception("%r failed %s: %s from now on", self, after, follows)
            raise AccessError(ErrorCode.BUS_ERROR) from error
        self.cores.step(instant)

    def _leave_out(self, seconds: float) -> None:
        """Skip some of the callers' time, because the robot is too slow."""
        assert self._began is not None
        self._began += seconds
        if not self._told_late:
            self._told_late = True
            _LOG.warning("%r is slower than time: %.3g s were left out (told once)", self, seconds)

    @staticmethod
    def _last_of(cell: Cell) -> Value:
        assert cell.queue is not None
        return cell.signal.kind.decode(cell.queue.from_program[-1])

    # The tree

    def _fill(self, part: Part, described: ComponentSpec) -> None:
        cells = self._registers.cells
        name = described.path or self.interface.name
        part.__dict__.update(
            _name=name,
            _cells={_free_name(signal.label): cells[signal.path] for signal in described.signals},
            _started=False,
        )
        for signals in described.rows.values():
            if signals[0].index is not None:
                part.__dict__[_free_name(signals[0].name)] = RowValues(
                    part, [_free_name(signal.label) for signal in signals]
                )
        for below in described.parts:
            items = below.items if isinstance(below, ComponentArray) else (below,)
            made = tuple(self._make(item) for item in items)
            part.__dict__[_free_name(below.name)] = made if isinstance(below, ComponentArray) else made[0]
        if part is not self:
            part.__dict__["_pins"] = {pin.name: pin.unwired for pin in described.core.pins} if described.core else {}
            unwired = (pin.name for pin in described.core.pins if not pin.is_used) if described.core else ()
            part.__dict__["_unwired"] = frozenset(unwired)
            part.__dict__["_pin_set"] = self.cores.add(described, part)
            self._parts.append(part)
            return
        for attribute in map(_free_name, (*described.rows, *(below.name for below in described.parts))):
            if hasattr(type(self), attribute):
                raise ArgumentError(
                    f"{type(self).__name__}.{attribute} hides {attribute} of {name}: give it another name"
                )

    def _make(self, described: ComponentSpec) -> Part:
        part = Part()
        self._fill(part, described)
        return part


_TAKEN = frozenset({*dir(SimulatedRobot), *SimulatedRobot.__annotations__, *Part.__annotations__})


def _clock() -> float:
    """Return a time in seconds to measure a robot's speed: that of the event loop, which may have simulated time."""
    try:
        return asyncio.get_running_loop().time()
    except RuntimeError:
        return time.perf_counter()


def _free_name(name: str) -> str:
    """Return the name of the attribute for a name in a spec."""
    while keyword.iskeyword(name) or name in _TAKEN:
        name += "_"
    return name


def parse_fault(text: str) -> tuple[str, SignalFault]:
    """Return the name and the kind of a fault from a text such as ``left.speed:timeout`` or ``stuck``.

    Raises:
        ArgumentError: if the kind does not exist.
    """
    name, _, how = text.partition(":")
    if how and how not in SIGNAL_FAULTS:
        raise ArgumentError(f"fault {text!r}: one of {', '.join(SIGNAL_FAULTS)} was expected after the colon")
    return name, cast("SignalFault", how or "error")

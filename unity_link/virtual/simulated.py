"""A robot of a spec, simulated: a class that says how its values change, behind a virtual gateway.

::

    class Rover(SimulatedRobot):
        def step(self, dt):
            self.left.speed += (6 * self.left.duty - self.left.speed) * dt / 0.1
            self.left.position += self.left.speed * dt

    gateway = simulate("rover.ul", Rover)
    async with unity_link.connect(gateway) as link:
        ...

Without a class the registers of the spec are memory. `registers` says what a bus sees of them.
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
"""Seconds of the robot's time that pass in one access at most; what is more is left out."""
LONGEST_TURN = 0.25
"""Seconds that a robot which is slower than time may take for one access."""
LONGEST_UNSEEN = 0.001
"""Seconds between two steps of a robot without a step size of which hardware sees each instant."""
_SLACK = 1e-9


class Fault:
    """Something that can go wrong with a robot, as an attribute of its class; it is True while it is switched on.

    Args:
        doc: what it is, for those who switch it on.
    """

    def __init__(self, doc: str) -> None:
        self.doc = doc
        self._name = ""

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    def __get__(self, robot: SimulatedRobot | None, owner: type) -> Any:
        return self if robot is None else self._name in robot.faults

    def __set__(self, robot: SimulatedRobot, on: bool) -> None:  # noqa: FBT001  (it is assigned)
        robot.set_fault(self._name, on=on)


class RowValues(Sequence[Any]):
    """Values of a row of signals of a simulated robot. They are read and set by their places, or all at once.

    Args:
        part: that they are signals of.
        labels: names of its attributes for them.
    """

    def __init__(self, part: Part, labels: list[str]) -> None:
        self._part = part
        self._labels = labels

    def __len__(self) -> int:
        return len(self._labels)

    def __getitem__(self, place: Any) -> Any:
        """Return a value; of several places a list."""
        found = self._labels[place]
        return getattr(self._part, found) if isinstance(found, str) else [getattr(self._part, one) for one in found]

    def __setitem__(self, place: Any, value: Any) -> None:
        """Set a value, or those of several places.

        Raises:
            ArgumentError: for a value that the signal cannot have, or another number of values.
        """
        found = self._labels[place]
        labels, values = ([found], [value]) if isinstance(found, str) else (found, [*value])
        if len(labels) != len(values):
            raise ArgumentError(f"{labels[0]} and what follows are {len(labels)} signals, and {len(values)} were given")
        for label, one in zip(labels, values, strict=True):
            setattr(self._part, label, one)

    def __repr__(self) -> str:
        return repr([*self])


class Part:
    """A part of a simulated robot. Its signals are attributes, which are values; so are its parts."""

    _name: str
    _cells: dict[str, Cell]
    _pins: dict[str, int]
    """Levels of the pins of a core, 0 or 1."""
    _unwired: frozenset[str]
    """Names of the pins of a core that are `none` in the spec, which keep their levels."""
    _pin_set: Callable[[str], None]
    """Is called with the name of a pin that the user's model has set."""
    _started: bool

    def __getattr__(self, name: str) -> Any:
        """Return the value of a signal; of a FIFO port, its `Queue`; of a pin of a core, 0 or 1.

        Raises:
            AttributeError: for a signal that there is not.
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
        """Set the value of a signal or the level of a pin; before the first step also make an attribute of its own.

        Raises:
            ArgumentError: for a value that the signal or the pin cannot have.
            AttributeError: for a signal that there is not.
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
        """Return its name and its values."""
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
    """The base of models, and itself the one of a robot whose registers are memory.

    A subclass overrides `start`, `step` and `written`. In all of them signals are attributes with the names of the spec
    (one that Python or this class has taken gets ``_`` behind it), and have values in their units. Of one that accesses
    clear, a model sets bits and a program clears them; a pulse is told to `written` alone.

    Args:
        interface: of a spec.

    Raises:
        ArgumentError: where the class hides a signal of the spec.
    """

    step_seconds: ClassVar[float | None] = 0.001
    """The robot's time passes in steps of so much; None: in one step up to each instant at which it is looked at."""

    interface: Interface
    """Declaration of the robot in the spec."""
    now: float
    """Seconds since the robot began."""
    faults: set[str]
    """The names of the faults that are switched on."""
    fired: deque[tuple[float, int]]
    """Instants and groups of fired triggers that the gateway has not seen yet."""
    cores: CoreModels
    """The models of the cores of the spec."""
    _registers: Registers
    _parts: list[Part]
    _began: float | None
    """Instant at which the robot began, on the clock of its callers."""
    _last: float
    """Instant of the last look, on the same clock."""
    _steps: int
    refusal: str
    """The reason why it refuses each access, which is that `step` has failed; empty while it has not."""
    is_wired: bool
    """True if compiled gateware answers the bus: it has the cores; a program does not see that `step` has failed."""
    _told_late: bool

    def __new__(cls, interface: Interface, *_: Any) -> Self:
        """Put the signals of a spec in their places, so that `__init__` finds them there."""
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
        """Do nothing: a model's own attributes are made in `start`."""

    def __repr__(self) -> str:
        """Return the name of the class."""
        return f"<{type(self).__name__} of {self.interface.name}>"

    # What a model overrides

    def start(self) -> None:
        """Set the first values of signals, which are 0 otherwise, and make attributes of the model's own."""

    def step(self, dt: float) -> None:
        """Let time pass.

        Args:
            dt: seconds; always `step_seconds`, if that is not None.
        """

    def written(self, path: str, value: Value) -> None:
        """Do what a write of a program does beside changing the value of a signal, which it has done already.

        Args:
            path: of the signal in the spec, such as ``left.duty``.
            value: what was written.
        """

    # What a model, or who tries it, calls

    def trigger(self, group: str) -> None:
        """Fire the trigger of a group that is declared with TRIGGER, so that the gateway publishes it.

        Raises:
            ArgumentError: for a group that there is not, or that has no trigger.
        """
        self.fired.append(((self._began or 0.0) + self.now, self.triggered_group(group)))

    def triggered_group(self, name: str) -> int:
        """Return the number of a group with a trigger.

        Raises:
            ArgumentError: for a group that there is not, or that has no trigger.
        """
        groups = {group.name: group for group in self.interface.groups}
        triggered = [group.name for group in groups.values() if group.trigger]
        group = groups.get(name)
        if group is None or not group.trigger or group.number is None:
            what = f"no group {name!r}" if group is None else f"no trigger in the group {name!r}"
            having = f"those with one are {', '.join(triggered)}" if triggered else "no group is declared with TRIGGER"
            raise ArgumentError(f"{self.interface.name} has {what}: {having}")
        return group.number

    def set_fault(self, name: str, how: SignalFault = "error", *, on: bool = True) -> None:
        """Switch a fault on or off.

        Args:
            name: of a `Fault` of the class, or the path of a signal.
            how: what is wrong with a signal: ``"error"``, ``"timeout"`` (accesses end so), or ``"frozen"`` (it reads
                what it read first).
            on: whether it is wrong from now on.

        Raises:
            ArgumentError: for a fault or a signal that there is not.
        """
        if name in self.known_faults():
            (self.faults.add if on else self.faults.discard)(name)
            return
        if name not in self._registers.cells:
            known = [*self.known_faults(), *self._registers.cells]
            hint = did_you_mean(name, known)
            raise ArgumentError(
                f"{type(self).__name__} has no fault and no signal {name!r}: "
                + (hint or f"its faults are {', '.join(self.known_faults()) or 'none'}")
            )
        self._registers.set_fault(name, how if on else None)

    @classmethod
    def known_faults(cls) -> dict[str, str]:
        """Return what its class says of each fault, by name."""
        return {
            name: fault.doc
            for base in reversed(cls.__mro__)
            for name, fault in vars(base).items()
            if isinstance(fault, Fault)
        }

    # Called by the bus and by who lets time pass

    @property
    def next_step(self) -> float | None:
        """Instant up to which time should pass without a call; None where that makes no difference."""
        if self.refusal or self._began is None or self.step_seconds is None or not self._moves:
            return None
        return self._last + max(self.step_seconds, 0.01)

    @property
    def due(self) -> float | None:
        """Instant of the next step; None where no step is to come."""
        if self.refusal or self._began is None or not self._moves:
            return None
        if self.step_seconds is None:
            return self._last + LONGEST_UNSEEN
        return self._began + (self._steps + 1) * self.step_seconds

    @property
    def cells(self) -> Mapping[str, Cell]:
        """Its signals by their paths in the spec."""
        return self._registers.cells

    def read(self, offset: int, now: float) -> int:
        """Read the word at an address."""
        self.pass_time(now)
        return self._registers.read(offset, now)

    def write(self, offset: int, value: int, now: float) -> None:
        """Write the word at an address."""
        # The words of a block come at one instant. What the first ones reach is told of them at once.
        if now != self._last or self._began is None or self.refusal:
            self.pass_time(now)
        for cell in self._registers.write(offset, value):
            self.cores.written(cell.signal.path)
            self.tell_written(cell)

    def tell_written(self, cell: Cell) -> None:
        """Call `written` for a signal that has got a value of a program."""
        self.written(cell.signal.path, cell.written if cell.queue is None else self._last_of(cell))

    def wire_pins(self, pins: Mapping[str, PinsOfCore]) -> None:
        """Put the pins of compiled gateware in the place of those of the quick models.

        Args:
            pins: levels by the names of pins, by the paths of their components.
        """
        self.cores.meet_pins(pins)
        for part in self._parts:
            if part._name in pins:  # noqa: SLF001  (it is made here)
                part.__dict__["_pins"] = pins[part._name]  # noqa: SLF001
                part.__dict__["_pin_set"] = lambda _: None

    def prepare(self) -> None:
        """Call `start`; from now on no attributes can be made."""
        self.start()
        for part in (self, *self._parts):
            part._started = True  # noqa: SLF001  (it is made here)

    def begin(self, now: float) -> None:
        """Begin the robot's time at an instant, if it has not begun."""
        if self._began is None:
            self._began = self._last = now

    def pass_time(self, now: float, *, until_fired: bool = False) -> None:
        """Step up to an instant.

        Args:
            now: the instant, in seconds of any origin.
            until_fired: whether to stop behind a step that fires a trigger.

        Raises:
            AccessError: where `step` has failed, now or before.
        """
        if self.refusal:
            raise AccessError(ErrorCode.BUS_ERROR)
        self.begin(now)
        assert self._began is not None
        # It goes back where the clock is that of another event loop.
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
        # Before the model, so that it finds what is safe by then, and behind it, for what it has moved.
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
        """Let the robot's time fall behind."""
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
                raise ArgumentError(f"{type(self).__name__}.{attribute} hides {attribute} of {name}: call it otherwise")

    def _make(self, described: ComponentSpec) -> Part:
        part = Part()
        self._fill(part, described)
        return part


_TAKEN = frozenset({*dir(SimulatedRobot), *SimulatedRobot.__annotations__, *Part.__annotations__})


def _clock() -> float:
    """Return seconds in which a robot may be slower than time: of the event loop, as modelled time waits for it."""
    try:
        return asyncio.get_running_loop().time()
    except RuntimeError:
        return time.perf_counter()


def _free_name(name: str) -> str:
    """Return the attribute for a name of a spec."""
    while keyword.iskeyword(name) or name in _TAKEN:
        name += "_"
    return name


def parse_fault(text: str) -> tuple[str, SignalFault]:
    """Take ``left.speed:timeout`` or ``stuck`` apart: what is wrong, and how.

    Raises:
        ArgumentError: for a way that there is not.
    """
    name, _, how = text.partition(":")
    if how and how not in SIGNAL_FAULTS:
        raise ArgumentError(f"fault {text!r}: one of {', '.join(SIGNAL_FAULTS)} was expected behind the colon")
    return name, cast("SignalFault", how or "error")

"""The Python of cores: their core APIs, fast models for `sim:`, and adapters between plants and pins on `rtl:`.

A core may have a module: ``unity_link/cores/NAME.py`` for the cores of this package, otherwise ``NAME.py`` beside its
map. The module has at most one class of each kind, with any name:

- a subclass of `Verbs`, which becomes a base of the class of its component;
- a subclass of `RobotVerbs`, which becomes a base of the class of each robot that has such a component;
- a subclass of `Model`, of which `sim:` makes one object for each placement;
- a subclass of `AtPins`, of which `rtl:` makes one object for each placement that is connected to a model of a plant.

A module is imported when a robot is loaded, generated or simulated, and never to check or show a spec.
"""

from __future__ import annotations

import functools
import importlib
import importlib.util
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol, Self, TypeVar

from unity_link.errors import ANY_ERROR, ArgumentError, UnsupportedError

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from types import ModuleType

    from unity_link.spec.model import ComponentSpec, Core, Interface

K = TypeVar("K", bound=type)
V = TypeVar("V")


class Verbs:
    """Base of core APIs: the methods for a component of a core.

    Their public names take precedence over those of signals: such a signal gets ``_`` appended.
    """


class RobotVerbs:
    """Base of the core API for a whole robot that has a core."""


class CoreRegisters:
    """The registers of one placement of a core, in the robot of a program.

    Args:
        robot: robot with the core.
        name: path of the placement in the robot.

    Raises:
        UnsupportedError: if the robot's board has a core that differs from that of this version.
    """

    def __init__(self, robot: Any, name: str) -> None:
        if fault := robot.interface.misfits.get(name):
            raise UnsupportedError(fault)
        self.robot = robot
        self.name = name
        self.core: Core = next(one.core for one in robot.interface.cores if one.path == name)

    @classmethod
    def of(cls, component: Any) -> Self:
        """Return the registers of a component with a core API.

        Raises:
            UnsupportedError: as for the class, and if the component has no registers.
        """
        path = path_of(component)
        if not component.signals:
            raise UnsupportedError(f"{path} has no registers, so it is no core as this version of Unity-Link has it")
        return cls(component.signals[0].robot, path)

    def find(self, register: str) -> Any:
        """Return the proxy of a register by its name in the core."""
        return self.robot[f"{self.name}.{register}"]


def path_of(component: Any) -> str:
    """Return the path of a component with a core API in its robot."""
    path: str = component._model.path  # noqa: SLF001  (verbs are bases of its class)
    return path


def members_of(robot: Any, kind: type[V]) -> dict[str, V]:
    """Return the components of a robot that have a core API of a type, by their paths."""
    found: dict[str, V] = {}
    waiting = list(getattr(robot, "_members", ()))
    while waiting:
        member = waiting.pop(0)
        if isinstance(member, kind):
            found[path_of(member)] = member
        waiting += getattr(member, "_members", ())
    return found


class Surroundings(Protocol):
    """The simulation around the model of a core."""

    @property
    def clock_hz(self) -> int:
        """Frequency of the gateway's clock, in Hz."""

    @property
    def now(self) -> int:
        """Cycles of the gateway's clock since its reset, 64 bits, as in its timestamps."""

    def trigger(self, group: str) -> None:
        """Publish a group that is declared with TRIGGER."""

    @property
    def is_armed(self) -> bool:
        """True if the lease that guards the component's timed signals, or its own, is armed; True without a lease."""

    @property
    def is_finishing(self) -> bool:
        """True if that lease accepts no new requests, and is armed until the schedule is empty; False without one."""

    @property
    def is_empty(self) -> bool:
        """True if no batch is waiting in the schedules of the signals that the component guards; for leases."""

    def put(self, name: str, value: Any) -> None:
        """Set the value that programs read from a signal. A plant continues with the value that it has set."""

    def commit(self, words: Mapping[int, int]) -> None:
        """Write words of 32 bits to the signals that the component times, by their places on its stage."""

    def make_safe(self) -> None:
        """Set all signals that the component guards to their safe values, except those with HOLD; for leases."""


class Pins(Protocol):
    """The compiled gateware around the pins of one placement of a core."""

    @property
    def clock_hz(self) -> int:
        """Frequency of the gateware's clock, in Hz."""

    @property
    def now(self) -> int:
        """Number of simulated clock cycles since the reset."""

    def has(self, pin: str) -> bool:
        """Return whether the core has this pin in the spec."""

    def drive(self, pin: str, level: int, cycle: int) -> None:
        """Set an input to 0 or 1 from a clock cycle on; at once if that cycle has passed."""

    def duty(self, pin: str) -> float | None:
        """Return the share of the clock cycles since the last call in which a pin was 1; None if there were none."""

    def steps(self, pulse: str, direction: str) -> int:
        """Return the pulses of an output that began while another output was 0, minus those that began while it was 1.

        Pulses are counted from the reset, or from the first call for these pins.
        """

    def show(self, name: str, value: Any) -> None:
        """Set the value of a signal, in its unit, that a plant reads."""


class _Placement:
    """Base of the objects for one placement of a core.

    Args:
        component: declaration of the component.
        part: its signals in their units, and its pins as the numbers 0 and 1; both as attributes.
    """

    def __init__(self, component: ComponentSpec, part: Any) -> None:
        self.component = component
        self.part = part

    @property
    def generics(self) -> dict[str, int | bool | str]:
        """Generics of the entity that the spec sets."""
        assert self.component.core is not None
        return self.component.core.generics

    def reset(self) -> None:
        """Begin again, as at a reset of the gateway."""

    def step(self, dt: float) -> None:
        """Simulate up to `around.now`.

        Args:
            dt: seconds since the last call, 0 or more. The method is called before each step of the user's model and
                each access of the bus, and after each step of that model, then with 0 seconds.
        """


class Model(_Placement):
    """Base of fast models: one placement of a core on `sim:`.

    Args:
        component: declaration of the component.
        part: its signals in their units, and its pins as the numbers 0 and 1; both as attributes.
        around: the clock, and the rest of the simulation that the model uses.
    """

    def __init__(self, component: ComponentSpec, part: Any, around: Surroundings) -> None:
        super().__init__(component, part)
        self.around = around

    def is_wired(self, pin: str) -> bool:
        """Return whether the spec connects a pin (not `none`); an input that is not connected keeps its idle level."""
        assert self.component.core is not None
        return any(one.name == pin and one.is_used for one in self.component.core.pins)

    def show(self, **values: object) -> None:
        """Set the values of signals, by their names. A call without changes is cheap."""
        for name, value in values.items():
            if getattr(self.part, name) != value:
                setattr(self.part, name, value)

    @property
    def due(self) -> int | None:
        """Clock cycle of the model's next event; `step` is called for that cycle. None if there is no event."""
        return None

    @property
    def is_empty(self) -> bool:
        """True if no accepted batch is still to be executed; for schedules."""
        return True

    def disarmed(self) -> None:
        """React to the end of the lease that guards the signals that the core writes."""

    def written(self, name: str) -> None:
        """React to a value that a program has written to a signal, or a model to a pin."""


class AtPins(_Placement):
    """Base of pin adapters of cores: on `rtl:`, they convert between pins and the signals that a plant uses on `sim:`.

    A plant cannot use signals that are neither in `shows` nor in `takes`, because they are inside of the compiled core.

    Args:
        component: declaration of the component.
        part: its signals in their units, and its pins as the numbers 0 and 1; both as attributes.
        around: the clock and the pins.
    """

    shows: frozenset[str] = frozenset()
    """Names of the signals that a plant may read: `step` sets them by `around.show`."""
    takes: frozenset[str] = frozenset()
    """Names of the signals that a plant sets: `step` reads them, and drives pins."""

    def __init__(self, component: ComponentSpec, part: Any, around: Pins) -> None:
        super().__init__(component, part)
        self.around = around


def robot_verbs_of(interface: Interface) -> tuple[type[RobotVerbs], ...]:
    """Return the classes with the core APIs for a whole robot, each once."""
    found = (kind for component in interface.cores for kind in classes_of(component.core, RobotVerbs))
    return tuple(dict.fromkeys(found))


def names_of(kinds: Iterable[type]) -> frozenset[str]:
    """Return the public names of core APIs, which signals of a component or robot cannot have."""
    return frozenset(
        name
        for kind in kinds
        for base in kind.__mro__
        if base is not object
        for name in vars(base)
        if not name.startswith("_")
    )


def classes_of(core: Core | None, base: K) -> tuple[K, ...]:
    """Return the class in a core's module that has one of the bases above; empty if it has none.

    Raises:
        ArgumentError: if the module has several, or cannot be imported.
    """
    if core is None or not core.python:
        return ()
    module = _module(core.python)
    found: list[Any] = [
        value
        for value in vars(module).values()
        if isinstance(value, type) and issubclass(value, base) and value.__module__ == module.__name__
    ]
    if len(found) > 1:
        names = " and ".join(kind.__name__ for kind in found)
        raise ArgumentError(f"{core.python} has several subclasses of {base.__name__}, {names}: one was expected")
    return tuple(found)


@functools.cache
def _module(python: str) -> ModuleType:
    """Import the module of a core, by its name or its file.

    Raises:
        ArgumentError: if the import fails.
    """
    try:
        if not python.endswith(".py"):
            return importlib.import_module(python)
        spec = importlib.util.spec_from_file_location(f"core_{Path(python).stem}", python)
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    except ANY_ERROR as error:
        raise ArgumentError(f"{python} cannot be imported: {type(error).__name__}: {error}") from error
    return module

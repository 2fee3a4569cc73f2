"""The Python of cores: verbs for programs, quick models for `sim:`, and what a plant has at the pins on `rtl:`.

A core may bring a module, ``unity_link/cores/NAME.py`` for those that are installed with the package, else ``NAME.py``
beside its map. It has at most one class of each kind, called as it likes:

- a subclass of `Verbs`, which becomes a base of the class of its component;
- a subclass of `RobotVerbs`, which becomes a base of the class of each robot that has such a component;
- a subclass of `Model`, of which `sim:` makes one for each placement;
- a subclass of `AtPins`, of which `rtl:` makes one for each placement that a model of a plant is joined to.

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
    """Base of classes with what a program does with one component of a core.

    Their public names go before those of signals: such a signal gets ``_`` behind it.
    """


class RobotVerbs:
    """Base of classes with what a program does with a robot that has a core."""


class CoreRegisters:
    """The registers of one placement of a core, as a program's robot has them.

    Args:
        robot: with the core.
        name: path of the placement in it.

    Raises:
        UnsupportedError: if the robot is that of a board whose core differs from the one that this version has.
    """

    def __init__(self, robot: Any, name: str) -> None:
        if fault := robot.interface.misfits.get(name):
            raise UnsupportedError(fault)
        self.robot = robot
        self.name = name
        self.core: Core = next(one.core for one in robot.interface.cores if one.path == name)

    @classmethod
    def of(cls, component: Any) -> Self:
        """Return the registers of a component with verbs.

        Raises:
            UnsupportedError: as for the class, and if the component has no registers.
        """
        path = path_of(component)
        if not component.signals:
            raise UnsupportedError(f"{path} has no registers, so it is no core as this version of Unity-Link has it")
        return cls(component.signals[0].robot, path)

    def find(self, register: str) -> Any:
        """Return a register by its name in the core."""
        return self.robot[f"{self.name}.{register}"]


def path_of(component: Any) -> str:
    """Return the path of a component with verbs in its robot."""
    path: str = component._model.path  # noqa: SLF001  (verbs are bases of its class)
    return path


def members_of(robot: Any, kind: type[V]) -> dict[str, V]:
    """Return the components of a robot with verbs of a kind, by their paths."""
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
        """Frequency of the gateway's clock."""

    @property
    def now(self) -> int:
        """Cycles of the gateway's clock since its reset, 64 bits, as its timestamps count them."""

    def trigger(self, group: str) -> None:
        """Publish a group that is declared with TRIGGER."""

    @property
    def is_armed(self) -> bool:
        """Return whether the lease of what the component times, or of its own signals, is armed; True without one."""

    @property
    def is_finishing(self) -> bool:
        """Return whether that lease takes nothing more, and is armed for what is scheduled; False without one."""

    @property
    def is_empty(self) -> bool:
        """Return whether nothing waits in the schedules of what the component guards, as a lease does."""

    def put(self, name: str, value: Any) -> None:
        """Set what programs read of a signal; a plant goes on with the value that it has set."""

    def commit(self, words: Mapping[int, int]) -> None:
        """Write words of 32 bits to signals that the component times, by their places on its stage."""

    def make_safe(self) -> None:
        """Set all signals that the component guards, as a lease does, to their safe values; not those with HOLD."""


class Pins(Protocol):
    """The compiled gateware around the pins of one placement of a core."""

    @property
    def clock_hz(self) -> int:
        """Frequency of the gateware's clock."""

    @property
    def now(self) -> int:
        """Clock cycles up to which time has passed, since the reset."""

    def has(self, pin: str) -> bool:
        """Return whether the spec gives the core this pin."""

    def drive(self, pin: str, level: int, cycle: int) -> None:
        """Set an input to 0 or 1 from a clock cycle on; at once, where that has passed."""

    def duty(self, pin: str) -> float | None:
        """Return in which part of the clock cycles since the last call a pin was 1; None where there were none."""

    def steps(self, pulse: str, direction: str) -> int:
        """Return the pulses of an output that began while another one was 0, less those that did while it was 1.

        They are those since the reset, or since the first call for these pins.
        """

    def show(self, name: str, value: Any) -> None:
        """Set the value of a signal, in its unit, that a plant reads."""


class _Placement:
    """Common base of what belongs to one placement of a core.

    Args:
        component: its declaration.
        part: its signals, and its pins as the numbers 0 and 1, by attribute; values of signals are in their units.
    """

    def __init__(self, component: ComponentSpec, part: Any) -> None:
        self.component = component
        self.part = part

    @property
    def generics(self) -> dict[str, int | bool | str]:
        """Generics of the entity that the spec gives."""
        assert self.component.core is not None
        return self.component.core.generics

    def reset(self) -> None:
        """Begin anew, as at a reset of the gateway."""

    def step(self, dt: float) -> None:
        """Let time pass, up to `around.now`.

        Args:
            dt: seconds, 0 or more: up to the next step of the user's model, or to an access of the bus. It is called
                again behind each step of that model.
        """


class Model(_Placement):
    """Base of quick models: a core on `sim:`, of one placement.

    Args:
        component: its declaration.
        part: its signals, and its pins as the numbers 0 and 1, by attribute; values of signals are in their units.
        around: the clock, and what else the model reaches.
    """

    def __init__(self, component: ComponentSpec, part: Any, around: Surroundings) -> None:
        super().__init__(component, part)
        self.around = around

    def is_wired(self, pin: str) -> bool:
        """Return whether a pin is not `none` in the spec; an input that is stays at its level without a wire."""
        assert self.component.core is not None
        return any(one.name == pin and one.is_used for one in self.component.core.pins)

    def show(self, **values: object) -> None:
        """Set the values of signals, by their names. It costs little where a signal has that value."""
        for name, value in values.items():
            if getattr(self.part, name) != value:
                setattr(self.part, name, value)

    @property
    def due(self) -> int | None:
        """Cycle of the clock at which something happens by itself; `step` is called up to there. None for nothing."""
        return None

    @property
    def is_empty(self) -> bool:
        """Return whether nothing that was accepted is still to act; of a schedule."""
        return True

    def disarmed(self) -> None:
        """Do as the core does when the lease has ended that guards what it writes."""

    def written(self, name: str) -> None:
        """Take the value that a program has written to a signal, or a model to a pin."""


class AtPins(_Placement):
    """Base of the pin sides of cores: on `rtl:`, the values of a plant that reads and sets signals as on `sim:`.

    Signals of neither `shows` nor `takes` are refused to the plant: the compiled core has them.

    Args:
        component: its declaration.
        part: its signals, and its pins as the numbers 0 and 1, by attribute; values of signals are in their units.
        around: the clock, and the pins.
    """

    shows: frozenset[str] = frozenset()
    """Names of signals that a plant may read: `step` gives them by `around.show`."""
    takes: frozenset[str] = frozenset()
    """Names of signals that a plant sets: `step` looks at them, and drives pins."""

    def __init__(self, component: ComponentSpec, part: Any, around: Pins) -> None:
        super().__init__(component, part)
        self.around = around


def robot_verbs_of(interface: Interface) -> tuple[type[RobotVerbs], ...]:
    """Return the classes with verbs of a robot, each once."""
    found = (kind for component in interface.cores for kind in classes_of(component.core, RobotVerbs))
    return tuple(dict.fromkeys(found))


def names_of(kinds: Iterable[type]) -> frozenset[str]:
    """Return the names that verbs take from the signals of a component, or of a robot."""
    return frozenset(
        name
        for kind in kinds
        for base in kind.__mro__
        if base is not object
        for name in vars(base)
        if not name.startswith("_")
    )


def classes_of(core: Core | None, base: K) -> tuple[K, ...]:
    """Return the class of a core's module with one of the bases above; empty where it has none.

    Raises:
        ArgumentError: where the module has several, or cannot be imported.
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
        ArgumentError: where that fails.
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

"""Stand-ins for the cores of a simulated robot: quick models, or the pins of compiled gateware; and their clock."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

from unity_link.cores import AtPins, Model, classes_of
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.spec import Way

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping

    from unity_link.spec import ComponentSpec
    from unity_link.virtual.registers import Cell, Registers


class PinsOfCore(Protocol):
    """Levels of the pins of a core by their names, and more of them, as `unity_link.cores.Pins` has it."""

    def __getitem__(self, name: str) -> int: ...
    def __setitem__(self, name: str, level: int) -> None: ...
    def __contains__(self, name: object) -> bool: ...
    def __iter__(self) -> Iterator[str]: ...

    def has(self, name: str) -> bool:
        """Return whether the core has this pin."""

    def drive(self, name: str, level: int, cycle: int) -> None:
        """Drive a pin from a clock cycle on."""

    def duty(self, name: str) -> float | None:
        """Return in which part of the clock cycles since the last call a pin was 1."""

    def steps(self, pulse: str, direction: str) -> int:
        """Return the pulses of an output, those down taken away."""


class _Around:
    """The simulation around one model.

    Args:
        models: all of the robot.
        path: of the component.
    """

    def __init__(self, models: CoreModels, path: str) -> None:
        self._models = models
        self._path = path

    @property
    def clock_hz(self) -> int:
        """Frequency of the gateway's clock."""
        return self._models.clock_hz

    @property
    def now(self) -> int:
        """Cycles of the gateway's clock since its reset."""
        return self._models.now

    def trigger(self, group: str) -> None:
        """Publish a group that is declared with TRIGGER."""
        self._models.trigger(group)

    @property
    def is_armed(self) -> bool:
        """Return whether the lease of what the component times, or of its own signals, is armed; True without one."""
        return self._models.registers.is_armed(self._path)

    @property
    def is_finishing(self) -> bool:
        """Return whether that lease takes nothing more, and is armed for what is scheduled; False without one."""
        return self._models.registers.is_finishing(self._path)

    @property
    def is_empty(self) -> bool:
        """Return whether nothing waits in the schedules of what the component guards, as a lease does."""
        return self._models.is_empty(self._path)

    def put(self, name: str, value: Any) -> None:
        """Set what programs read of a signal; a plant goes on with the value that it has set."""
        self._models.registers.cells[f"{self._path}.{name}"].put(value)

    def commit(self, words: Mapping[int, int]) -> None:
        """Write words of 32 bits to signals that the component times, by their places on its stage."""
        for cell in self._models.registers.commit(self._path, words):
            self._models.written(cell.signal.path)
            self._models.tell(cell)

    def make_safe(self) -> None:
        """Set all signals that the component guards to their safe values."""
        self._models.make_safe(self._path)


class _AroundPins(_Around):
    """Compiled gateware around the pins of one core.

    Args:
        models: all of the robot.
        path: of the component.
        pins: its pins.
    """

    def __init__(self, models: CoreModels, path: str, pins: PinsOfCore) -> None:
        super().__init__(models, path)
        self.has, self.drive, self.duty, self.steps = pins.has, pins.drive, pins.duty, pins.steps

    def show(self, name: str, value: Any) -> None:
        """Set the value of a signal that a plant reads."""
        self._models.registers.cells[f"{self._path}.{name}"].show(value)


class CoreModels:
    """The models of all cores of a robot.

    Args:
        registers: of the robot.
        trigger: fires the trigger of a group.
        tell: called with a signal that a core has written.
    """

    def __init__(
        self, registers: Registers, trigger: Callable[[str], None], tell: Callable[[Cell], None] = lambda _: None
    ) -> None:
        self.registers = registers
        self.trigger = trigger
        self.tell = tell
        self.now = 0
        """Cycles of the gateway's clock up to which time has passed."""
        self.clock_hz = GatewayInfo().clock_hz
        self._ticks_at: Callable[[float], int] = lambda now: int(now * self.clock_hz)
        self.at_pins: dict[str, AtPins] = {}
        """The pin sides of cores of compiled gateware, by the paths of their components."""
        self._placed: list[tuple[ComponentSpec, Any]] = []
        self._models: list[Model] = []
        self._of_signal: dict[str, tuple[Model, str]] = {}

    def take_clock(self, clock_hz: int, ticks_at: Callable[[float], int]) -> None:
        """Take the clock of the gateway before the robot."""
        self.clock_hz, self._ticks_at = clock_hz, ticks_at

    def add(self, component: ComponentSpec, part: Any) -> Callable[[str], None]:
        """Make the model of a component, where its core has one; return a function to call for pins that are set."""
        if component.core is not None:
            self._placed.append((component, part))
        kinds = classes_of(component.core, Model)
        if not kinds:
            return lambda _: None
        model = kinds[0](component, part, _Around(self, component.path))
        # What a schedule has for the cycle in which a lease ends acts in it, and is safe behind it.
        self._models.insert(0 if component.core is not None and component.core.stages else len(self._models), model)
        self._of_signal |= {signal.path: (model, signal.label) for signal in component.signals}
        assert component.core is not None
        inputs = {pin.name for pin in component.core.pins if pin.way is not Way.OUT}
        return lambda name: model.written(name) if name in inputs else None

    def meet_pins(self, pins: Mapping[str, PinsOfCore]) -> None:
        """Leave the cores to compiled gateware, and meet them at their pins.

        Args:
            pins: by the paths of their components.
        """
        self._models.clear()
        self._of_signal.clear()
        for component, part in self._placed:
            for kind in classes_of(component.core, AtPins):
                around = _AroundPins(self, component.path, pins[component.path])
                self.at_pins[component.path] = kind(component, part, around)

    def step(self, now: float) -> None:
        """Let time pass up to an instant of the callers' clock (seconds)."""
        if not (self._models or self.at_pins):
            return
        ticks = max(self.now, self._ticks_at(now))
        while True:
            due = [cycle for model in self._models if (cycle := model.due) is not None]
            reached = min(max(min(due, default=ticks), self.now + 1), ticks)
            passed = (reached - self.now) / self.clock_hz
            self.now = reached
            for model in (*self._models, *self.at_pins.values()):
                model.step(passed)
            if reached == ticks:
                return

    def make_safe(self, lease: str) -> None:
        """Set all signals that a lease guards to their safe values, and stop what writes them."""
        self.registers.make_safe(lease)
        for model in self._models:
            if lease in self.registers.leases_of(model.component.path):
                model.disarmed()

    def is_empty(self, lease: str) -> bool:
        """Return whether nothing waits in the schedules of what a lease guards."""
        leases_of = self.registers.leases_of
        return all(model.is_empty for model in self._models if lease in leases_of(model.component.path))

    def written(self, path: str) -> None:
        """Pass the value that was written to a signal on to the model of its core."""
        found = self._of_signal.get(path)
        if found is not None:
            model, name = found
            model.written(name)

    def reset(self) -> None:
        """Begin anew: the gateway's clock does so too."""
        self.now = 0
        for model in (*self._models, *self.at_pins.values()):
            model.reset()

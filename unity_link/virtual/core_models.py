"""The cores of a simulated robot and their clock: models of the cores, or compiled gateware with simulated pins."""

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
    """Levels of a core's pins by name, with the methods of `unity_link.cores.Pins`."""

    def __getitem__(self, name: str) -> int: ...
    def __setitem__(self, name: str, level: int) -> None: ...
    def __contains__(self, name: object) -> bool: ...
    def __iter__(self) -> Iterator[str]: ...

    def has(self, name: str) -> bool:
        """Return True if the core has this pin."""

    def drive(self, name: str, level: int, cycle: int) -> None:
        """Drive a pin from a clock cycle on."""

    def duty(self, name: str) -> float | None:
        """Return the fraction of the clock cycles since the last call in which a pin was 1; None if there were none."""

    def steps(self, pulse: str, direction: str) -> int:
        """Return the number of pulses with the direction 0, minus those with the direction 1."""


class _Around:
    """The simulation as one core's model sees it.

    Args:
        models: all core models of the robot.
        path: path of the core's component.
    """

    def __init__(self, models: CoreModels, path: str) -> None:
        self._models = models
        self._path = path

    @property
    def clock_hz(self) -> int:
        """Clock frequency of the gateway in Hz."""
        return self._models.clock_hz

    @property
    def now(self) -> int:
        """Clock cycles since the gateway's reset."""
        return self._models.now

    def trigger(self, group: str) -> None:
        """Publish a group that is declared with TRIGGER."""
        self._models.trigger(group)

    @property
    def is_armed(self) -> bool:
        """True if all leases of the component's signals, and of the signals that it times, are armed or it has none."""
        return self._models.registers.is_armed(self._path)

    @property
    def is_finishing(self) -> bool:
        """True if one of these leases only finishes the scheduled batches; False without a lease."""
        return self._models.registers.is_finishing(self._path)

    @property
    def is_empty(self) -> bool:
        """True if the schedules of all signals that the component guards are empty; the component is a lease."""
        return self._models.is_empty(self._path)

    def put(self, name: str, value: Any) -> None:
        """Set the value of a signal that programs read; a model of the plant still sees its own value."""
        self._models.registers.cells[f"{self._path}.{name}"].put(value)

    def commit(self, words: Mapping[int, int]) -> None:
        """Write 32-bit words to signals that the component times, by their places on its stage."""
        for cell in self._models.registers.commit(self._path, words):
            self._models.written(cell.signal.path)
            self._models.notify(cell)

    def make_safe(self) -> None:
        """Set all signals that the component guards to their safe values."""
        self._models.make_safe(self._path)


class _AroundPins(_Around):
    """The simulation as the model of one core's pins sees it; the core itself is in compiled gateware.

    Args:
        models: all core models of the robot.
        path: path of the core's component.
        pins: pins of the core.
    """

    def __init__(self, models: CoreModels, path: str, pins: PinsOfCore) -> None:
        super().__init__(models, path)
        self.has, self.drive, self.duty, self.steps = pins.has, pins.drive, pins.duty, pins.steps

    def show(self, name: str, value: Any) -> None:
        """Set the value of a signal that a model of the plant reads."""
        self._models.registers.cells[f"{self._path}.{name}"].show(value)


class CoreModels:
    """The models of all cores of a robot.

    Args:
        registers: registers of the robot.
        trigger: fires the trigger of a group.
        notify: is called with each signal that a core has written.
    """

    def __init__(
        self, registers: Registers, trigger: Callable[[str], None], notify: Callable[[Cell], None] = lambda _: None
    ) -> None:
        self.registers = registers
        self.trigger = trigger
        self.notify = notify
        self.now = 0
        """Clock cycles of the gateway that have passed."""
        self.clock_hz = GatewayInfo().clock_hz
        self._ticks_at: Callable[[float], int] = lambda now: int(now * self.clock_hz)
        self.at_pins: dict[str, AtPins] = {}
        """Models of the pins of cores in compiled gateware, by path of the component."""
        self._placed: list[tuple[ComponentSpec, Any]] = []
        self._models: list[Model] = []
        self._of_signal: dict[str, tuple[Model, str]] = {}

    def take_clock(self, clock_hz: int, ticks_at: Callable[[float], int]) -> None:
        """Set the clock of the gateway.

        Args:
            clock_hz: frequency in Hz.
            ticks_at: returns the number of clock cycles at a time in seconds.
        """
        self.clock_hz, self._ticks_at = clock_hz, ticks_at

    def add(self, component: ComponentSpec, part: Any) -> Callable[[str], None]:
        """Create the model of a component, if its core has one.

        Return a function that must be called with the name of each pin that the user's model sets.
        """
        if component.core is not None:
            self._placed.append((component, part))
        kinds = classes_of(component.core, Model)
        if not kinds:
            return lambda _: None
        model = kinds[0](component, part, _Around(self, component.path))
        # Schedules come before leases: a batch that is due in the cycle in which a lease ends still takes effect.
        self._models.insert(0 if component.core is not None and component.core.stages else len(self._models), model)
        self._of_signal |= {signal.path: (model, signal.label) for signal in component.signals}
        assert component.core is not None
        inputs = {pin.name for pin in component.core.pins if pin.way is not Way.OUT}
        return lambda name: model.written(name) if name in inputs else None

    def meet_pins(self, pins: Mapping[str, PinsOfCore]) -> None:
        """Replace the models of the cores by compiled gateware, with models of its pins.

        Args:
            pins: pins of each core, by path of the component.
        """
        self._models.clear()
        self._of_signal.clear()
        for component, part in self._placed:
            for kind in classes_of(component.core, AtPins):
                around = _AroundPins(self, component.path, pins[component.path])
                self.at_pins[component.path] = kind(component, part, around)

    def step(self, now: float) -> None:
        """Advance all models to a time in seconds on the callers' clock."""
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
        """Set all signals that a lease guards to their safe values, and stop the cores that write them."""
        self.registers.make_safe(lease)
        for model in self._models:
            if lease in self.registers.leases_of(model.component.path):
                model.disarmed()

    def is_empty(self, lease: str) -> bool:
        """Return True if the schedules of all signals that a lease guards are empty."""
        leases_of = self.registers.leases_of
        return all(model.is_empty for model in self._models if lease in leases_of(model.component.path))

    def written(self, path: str) -> None:
        """Notify the model of a core that one of its signals was written."""
        found = self._of_signal.get(path)
        if found is not None:
            model, name = found
            model.written(name)

    def reset(self) -> None:
        """Reset all models after a reset of the gateway, whose clock starts at 0 again."""
        self.now = 0
        for model in (*self._models, *self.at_pins.values()):
            model.reset()

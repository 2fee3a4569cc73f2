"""The quick models of the cores of a simulated robot, and the clock that they share."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from unity_link.cores import Model, classes_of
from unity_link.protocol.configuration import GatewayInfo
from unity_link.spec import Way

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.spec import ComponentSpec
    from unity_link.virtual.registers import Registers


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

    def make_safe(self) -> None:
        """Set all signals that the component guards to their safe values."""
        self._models.registers.make_safe(self._path)


class CoreModels:
    """The models of all cores of a robot.

    Args:
        registers: of the robot.
        trigger: fires the trigger of a group.
    """

    def __init__(self, registers: Registers, trigger: Callable[[str], None]) -> None:
        self.registers = registers
        self.trigger = trigger
        self.now = 0
        """Cycles of the gateway's clock up to which time has passed."""
        self.clock_hz = GatewayInfo().clock_hz
        self._ticks_at: Callable[[float], int] = lambda now: int(now * self.clock_hz)
        self._models: list[Model] = []
        self._of_signal: dict[str, tuple[Model, str]] = {}

    def take_clock(self, clock_hz: int, ticks_at: Callable[[float], int]) -> None:
        """Take the clock of the gateway before the robot."""
        self.clock_hz, self._ticks_at = clock_hz, ticks_at

    def add(self, component: ComponentSpec, part: Any) -> Callable[[str], None]:
        """Make the model of a component, where its core has one; return a function to call for pins that are set."""
        kinds = classes_of(component.core, Model)
        if not kinds:
            return lambda _: None
        model = kinds[0](component, part, _Around(self, component.path))
        self._models.append(model)
        self._of_signal |= {signal.path: (model, signal.name) for signal in component.signals}
        assert component.core is not None
        inputs = {pin.name for pin in component.core.pins if pin.way is not Way.OUT}
        return lambda name: model.written(name) if name in inputs else None

    def leave(self) -> None:
        """Leave the cores to others."""
        self._models.clear()
        self._of_signal.clear()

    def step(self, now: float) -> None:
        """Let time pass up to an instant of the callers' clock (seconds)."""
        if not self._models:
            return
        ticks = max(self.now, self._ticks_at(now))
        passed = (ticks - self.now) / self.clock_hz
        self.now = ticks
        for model in self._models:
            model.step(passed)

    def written(self, path: str) -> None:
        """Pass the value that was written to a signal on to the model of its core."""
        found = self._of_signal.get(path)
        if found is not None:
            model, name = found
            model.written(name)

    def reset(self) -> None:
        """Begin anew: the gateway's clock does so too."""
        self.now = 0
        for model in self._models:
            model.reset()

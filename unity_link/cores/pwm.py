"""Pulse width modulation on `rtl:`: the value that a plant reads is measured at the pins of the compiled gateware."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from unity_link.cores import AtPins

if TYPE_CHECKING:
    from unity_link.cores import Pins
    from unity_link.spec.model import ComponentSpec


class PwmAtPins(AtPins):
    """Shows the mean value of the pins since the last step, which includes the safe level after a lease has ended."""

    shows = frozenset({"value"})

    def __init__(self, component: ComponentSpec, part: Any, around: Pins) -> None:
        super().__init__(component, part, around)
        self._limit = next(signal for signal in component.signals if signal.name == "value").limits[1]
        self._has_sign = self.generics.get("mode", "sign") == "sign"
        self._pins = [pin for pin in ("pwm", "dir") if around.has(pin)]
        if "pwm" not in self._pins:
            self.shows = frozenset()

    def step(self, dt: float) -> None:
        """Measure the duty cycles of the pins, and show the value."""
        if not self.shows:
            return
        parts = {pin: self.around.duty(pin) for pin in self._pins}
        pulse, other = parts["pwm"], parts.get("dir", 0.0)
        if pulse is not None and other is not None:
            mean = pulse * (1 - 2 * other) if self._has_sign else pulse - other
            self.around.show("value", self._limit * mean)

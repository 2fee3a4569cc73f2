"""General purpose pins in simulations: on `sim:`, a model of the plant sets a level by `robot.button.pin = 1`."""

from __future__ import annotations

from unity_link.cores import AtPins, Model


class GpioModel(Model):
    """The level of a pin, its edges and their instants. The simulated level never bounces, so no filter is modelled."""

    def reset(self) -> None:
        """Count edges from 0 again."""
        self.part.output, self.part.drive, self.part.edges, self.part.last = False, False, 0, 0
        self.step(0)

    def step(self, dt: float) -> None:
        """Update the level of the pin. If the core drives it, the plant's value has no effect."""
        part = self.part
        # An input without a pin is 0, even if the core drives its output.
        level = part.output if part.drive and self.is_wired("pin") else bool(part.pin)
        if level == part.level:
            return
        part.level = level
        part.edges = (part.edges + 1) % (1 << 16)
        part.last = self.around.now % (1 << 32)
        assert self.component.core is not None
        for trigger in self.component.core.triggers:
            if trigger.group is not None:
                self.around.trigger(trigger.group)

    def written(self, name: str) -> None:
        """Update the level after a write to a signal, or a change of the pin by the plant."""
        self.step(0)


class GpioAtPins(AtPins):
    """Shows the level of the pin to the plant; if the core drives the pin, this is the core's level."""

    shows = frozenset({"level"})

    def step(self, dt: float) -> None:
        """Show the level of the pin."""
        self.around.show("level", bool(self.part.pin))

"""A general purpose pin on `sim:`: a model of the plant sets its level by `robot.button.pin = 1`."""

from __future__ import annotations

from unity_link.cores import AtPins, Model


class GpioModel(Model):
    """The pin, its edges and their instants; it has no bounces, so none are taken out."""

    def reset(self) -> None:
        """Count edges from 0 on."""
        self.part.output, self.part.drive, self.part.edges, self.part.last = False, False, 0, 0
        self.step(0)

    def step(self, dt: float) -> None:  # noqa: ARG002  (edges have their instant by the clock)
        """See the level of the pin: of what drives it, the core goes before the plant."""
        part = self.part
        # An input without a pin is 0, also if the core drives its output.
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

    def written(self, name: str) -> None:  # noqa: ARG002  (all of them may change the level)
        """Drive the pin, or see that the plant has."""
        self.step(0)


class GpioAtPins(AtPins):
    """The level of the pin: what drives it, the core before the plant."""

    shows = frozenset({"level"})

    def step(self, dt: float) -> None:  # noqa: ARG002  (the level of now counts)
        """Look at the pin."""
        self.around.show("level", bool(self.part.pin))

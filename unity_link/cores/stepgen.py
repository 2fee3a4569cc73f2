"""Step generators: the core API, which can wait for a move, the motion on `sim:`, and steps at the pins on `rtl:`."""

from __future__ import annotations

import math
import time
from typing import TYPE_CHECKING, Any

from unity_link.cores import AtPins, CoreRegisters, Model, Verbs
from unity_link.cores.lease import LeaseRegisters
from unity_link.errors import ArgumentError, UnityLinkError
from unity_link.link.runtimes.synchronisation import gather, running

if TYPE_CHECKING:
    from unity_link.cores import Pins
    from unity_link.cores.lease import Lease
    from unity_link.data.laps import Laps
    from unity_link.spec.model import ComponentSpec

KICKS = 4
"""Least number of kicks in the time-out of a lease."""
LOOK_AGAIN = 0.005
"""Seconds between two reads of the state of an axis that moves."""
_ROUND = 1 << 24
"""Number of steps after which the position wraps around."""
_SLICE = 0.001
"""Seconds after which the shortest way is determined again, if it may have changed sides."""
_CLOSE = 1e-9
"""Relative size below which a distance or a difference of speeds counts as 0."""


class StepgenVerbs(Verbs):
    """Core API of a STEPGEN."""

    async def move_to(self, position: float, *, lease: Lease | None = None) -> None:
        """Move to a position, and return after the axis has stopped there.

        There is no time limit; set one by ``asyncio.timeout``.

        Args:
            position: in the unit of `position_cmd`; less than half a round of 2 ** 24 steps away.
            lease: lease that guards the axis; it is kicked in the meantime.

        Raises:
            NotArmedError: if its lease is not armed, or ends during the move: then the axis stops by itself.
            ArgumentError: for a position that `position_cmd` cannot have, or one that is too far away.
            UnsupportedError: if the board's STEPGEN differs from that of this version.
            UnityLinkError: if `mode` or `position_cmd` was written during the move, or the gateway was reset.
        """
        axis: Any = self
        CoreRegisters.of(self)
        kind, laps = axis.position_cmd.signal.kind, axis.position.laps

        def number(value: float) -> int:
            raw: int = kind.encode(kind.wrapped(value) if kind.wraps else value)
            return raw

        await _check_reach(axis, position)
        wanted = number(position)
        await axis.mode.set("position")
        await axis.position_cmd.set(position)
        while True:
            if lease is not None:
                await lease.kick()
            is_there, holds, mode, target = await gather(
                axis.in_position.get(), axis.holding.get(), axis.mode.get(), axis.position_cmd.get()
            )
            safe = axis.position_cmd.signal.safe
            if holds and safe is not None:
                registers = LeaseRegisters(axis.position_cmd.robot, safe.lease)
                raise await registers.fault(await registers.condition())
            if holds or mode != "position" or number(target) != wanted:
                name = axis.position_cmd.path.rpartition(".")[0]
                raise UnityLinkError(f"{name} does not go to {position:g}: it was given another command on the way")
            if is_there:
                if laps is not None:
                    laps.see(position, axis.position.link.epoch, time.monotonic())
                return
            await running().sleep(LOOK_AGAIN if lease is None else min(LOOK_AGAIN, lease.timeout / KICKS))

    async def stop(self) -> None:
        """Decelerate to a stop: write the velocity 0 and the mode `velocity`. Return without waiting for the stop.

        Raises:
            UnsupportedError: if the board's STEPGEN differs from that of this version.
            NotArmedError: if its lease is not armed, in which case the axis stops by itself.
        """
        axis: Any = self
        CoreRegisters.of(self)
        await axis.velocity_cmd.set(0)
        await axis.mode.set("velocity")


async def _check_reach(axis: Any, position: float) -> None:
    """Check that an axis can move to a position.

    Raises:
        ArgumentError: for a position that `position_cmd` cannot have, or one that is half a round or more away: the
            axis would take the shortest way to another place with the same register value.
    """
    laps: Laps | None = axis.position.laps

    def check() -> None:
        axis.position_cmd.encode(position)
        if laps is not None:
            laps.check_near(position, axis.position.link.epoch, axis.position_cmd.path)

    try:
        check()
    except ArgumentError:
        if laps is None:
            raise
        # The last position read may be an old one.
        await axis.position.get()
        check()


class StepgenModel(Model):
    """The motion of an axis in continuous time: the same trapezoid as that of the entity, without its rounding.

    The pins do not change. The axis does not stop when it changes between a velocity and a position; the entity does.
    """

    def __init__(self, component: ComponentSpec, part: Any, around: Any) -> None:
        super().__init__(component, part, around)
        self._kind = next(signal for signal in component.signals if signal.name == "position").kind
        self._motion = Motion(self._kind.span)
        self._is_fresh = False

    def disarmed(self) -> None:
        """Wait for a new position command."""
        self._is_fresh = False

    def reset(self) -> None:
        """Stop at 0."""
        self._motion = Motion(self._kind.span)
        self._is_fresh = False
        self._move(0)

    def step(self, dt: float) -> None:
        """Move for `dt` seconds."""
        if dt:
            self._move(dt)

    def _move(self, dt: float) -> None:
        part, motion = self.part, self._motion
        self._is_fresh = self._is_fresh and self.around.is_armed
        at_velocity = part.mode == "velocity"
        obeys = self.around.is_armed and (self._is_fresh or at_velocity)
        limit, accel = part.maxvel, part.maxaccel or math.inf
        if not obeys:
            motion.stop(accel, dt)
        elif at_velocity:
            motion.go_at(min(max(part.velocity_cmd, -limit), limit), accel, dt)
        else:
            motion.go_to(part.position_cmd, limit, accel, dt)
        self.show(
            position=self._kind.within(motion.place),
            velocity=motion.speed,
            holding=not obeys,
            in_position=obeys and not at_velocity and motion.stands_at(part.position_cmd),
        )

    def written(self, name: str) -> None:
        """React to a command."""
        if name == "position_cmd":
            self._is_fresh = True
        self._move(0)


class StepgenAtPins(AtPins):
    """Shows a plant the position by the steps at the pins, counted as a motor's driver counts them."""

    shows = frozenset({"position"})

    def __init__(self, component: ComponentSpec, part: Any, around: Pins) -> None:
        super().__init__(component, part, around)
        step = abs(next(signal for signal in component.signals if signal.name == "maxaccel").kind.scale)
        self._step = -step if self.generics.get("reverse", False) else step
        """One step with `dir` at 0, in the unit of the position."""
        if not (around.has("step") and around.has("dir")):
            self.shows = frozenset()

    def step(self, dt: float) -> None:
        """Show the position of the counted steps."""
        if self.shows:
            steps = self.around.steps("step", "dir")
            self.around.show("position", self._step * ((steps + _ROUND // 2) % _ROUND - _ROUND // 2))


class Motion:
    """A place and a speed that change with time. Speeds have either sign, accelerations are above 0.

    A new acceleration takes effect only at speed 0, or by `stop`.

    Args:
        span: length of a round; a target is reached at each multiple of it. The place itself does not wrap around.
    """

    def __init__(self, span: float = math.inf) -> None:
        self.place = self.speed = 0.0
        self.accel = math.inf
        """The acceleration in effect."""
        self._span = span

    def stands_at(self, target: float) -> bool:
        """Return whether the speed is 0 and the place is a target, within the accuracy of numbers."""
        return not self.speed and abs(self._way(target)) <= _CLOSE * max(abs(target), abs(self.place), 1)

    def stop(self, accel: float, seconds: float) -> None:
        """Decelerate for `seconds` with an acceleration that takes effect at once."""
        self.accel = accel
        self._go_at(0.0, seconds)

    def go_at(self, speed: float, accel: float, seconds: float) -> None:
        """Move for `seconds`, and change the speed to another one."""
        if not self.speed:
            self.accel = accel
        elif self.speed * speed < 0:
            # A change of direction has an instant at speed 0, at which the new acceleration takes effect.
            needed = abs(self.speed) / self.accel
            if needed >= seconds:
                self._go_at(0.0, seconds)
                return
            self._go_at(0.0, needed)
            self.speed, self.accel, seconds = 0.0, accel, seconds - needed
        self._go_at(speed, seconds)

    def _go_at(self, speed: float, seconds: float) -> None:
        taken = min(abs(speed - self.speed) / self.accel, seconds)
        self._pass(taken, math.copysign(self.accel, speed - self.speed) if taken else 0.0)
        if taken < seconds or math.isinf(self.accel):
            self.speed = speed
            self._pass(seconds - taken, 0.0)

    def go_to(self, target: float, limit: float, accel: float, seconds: float) -> None:
        """Move for `seconds`, on the shortest way to a place. Pass the place only if it is too near to stop at it.

        If the place is exactly opposite, both ways are equally long, and the axis does not move.
        """
        if not self.speed:
            self.accel = accel
        while not math.isinf(self.accel):
            way = self._way(target)
            if seconds <= 0 or self.stands_at(target) or (not self.speed and self._is_opposite(way)):
                return
            seconds -= self._phase(way, limit, self.accel, seconds)
            if not self.speed:
                self.accel = accel
                if self.stands_at(target):
                    self.place = self._nearest(target)
        way = self._way(target)
        self.speed = math.copysign(limit, way) if abs(way) > limit * seconds and not self._is_opposite(way) else 0.0
        if self.speed:
            self.place += self.speed * seconds
        elif limit and not self._is_opposite(way):
            self.place = self._nearest(target)

    def _nearest(self, target: float) -> float:
        """Return the target nearest to the present place."""
        return target if math.isinf(self._span) else target + self._span * round((self.place - target) / self._span)

    def _way(self, target: float) -> float:
        return self._nearest(target) - self.place

    def _is_opposite(self, way: float) -> bool:
        # The limit is a quarter of the last bit of a position.
        return math.isfinite(self._span) and abs(abs(way) - self._span / 2) < self._span * 2**-34

    def _phase(self, way: float, limit: float, accel: float, seconds: float) -> float:
        """Move in one phase of a way, for `seconds` at most; return the seconds that the phase took."""
        sign = math.copysign(1.0, self.speed or way)
        ahead, speed = -abs(way) if self._is_opposite(way) else sign * way, abs(self.speed)
        stop = speed * speed / (2 * accel)
        slack = _CLOSE * (abs(self.place) + abs(way) + stop)
        if ahead < stop - slack or speed > limit * (1 + _CLOSE):
            # The axis is too fast, or cannot stop in time. If it would stop more than half a round beyond the target,
            # the way in its present direction is the shorter one.
            slower = limit if ahead >= stop - slack else 0.0
            return self._change(
                sign * slower, accel, min(seconds, _SLICE) if stop - ahead > self._span / 2 else seconds
            )
        if ahead <= stop + slack:
            if not speed or seconds >= speed / accel:
                self.place, self.speed = self.place + way, 0.0
                return speed / accel
            return self._change(0.0, accel, seconds)
        if not limit:
            return seconds
        # Accelerate to the speed from which it must decelerate at once, or to the limit; then keep that speed.
        top = math.sqrt(accel * ahead + speed * speed / 2)
        if speed < min(top, limit) * (1 - _CLOSE):
            return self._change(sign * min(top, limit), accel, seconds)
        taken = min((ahead - stop) / speed, seconds)
        self._pass(taken, 0.0)
        return taken

    def _change(self, speed: float, accel: float, seconds: float) -> float:
        taken = min(abs(speed - self.speed) / accel, seconds)
        self._pass(taken, math.copysign(accel, speed - self.speed))
        if taken < seconds:
            self.speed = speed
        return taken

    def _pass(self, seconds: float, accel: float) -> None:
        if not seconds:
            return
        self.place += (self.speed + accel * seconds / 2) * seconds
        self.speed += accel * seconds

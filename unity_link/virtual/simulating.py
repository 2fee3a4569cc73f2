"""A simulated robot behind a virtual gateway, whose time passes whether or not anybody looks."""

from __future__ import annotations

import asyncio
import contextlib
import importlib
import importlib.util
import logging
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic

from typing_extensions import TypeVar

from unity_link.errors import ANY_ERROR, ArgumentError
from unity_link.virtual.bus import AccessError
from unity_link.virtual.gateway import BareGateway

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping, MutableMapping

    from unity_link.spec import Interface
    from unity_link.virtual.bus import Device
    from unity_link.virtual.rtl.ports import Port
    from unity_link.virtual.simulated import SimulatedRobot

R_co = TypeVar("R_co", bound="SimulatedRobot | None", default="SimulatedRobot", covariant=True)
_LOG = logging.getLogger("unity_link.virtual")


class SimulatedGateway(BareGateway, Generic[R_co]):
    """A gateway in front of a bare one that lets the time of a robot pass, and fires the triggers of groups.

    Args:
        gateway: the bare one.
        robot: what is behind its bus; None for anything that needs no time of its own.
    """

    def __init__(self, gateway: BareGateway, robot: R_co) -> None:
        self.info = gateway.info
        self.wake: Callable[[], None] = lambda: None
        self.robot = robot
        self._gateway = gateway
        self._now = 0.0
        self._rates: dict[int, tuple[float, float | None]] = {}
        """Seconds between two edges of each group whose trigger fires by itself, and the instant of the next one."""
        self._is_wired = False
        """True if the bare gateway lets the robot's time pass."""
        gateway.wake = self._pass_on_wake
        if robot is not None:
            wire = getattr(gateway, "wire", None)
            self._is_wired = wire is not None
            (gateway.attach_elsewhere if wire is None else wire)(robot)
            if wire is None:
                robot.cores.take_clock(self.info.clock_hz, gateway.ticks_at)

    def _pass_on_wake(self) -> None:
        self.wake()

    @property
    def memory(self) -> MutableMapping[int, int]:
        """The words of plain memory, by address."""
        return self._gateway.memory

    @property
    def ports(self) -> Mapping[str, Port]:
        """Ports of the compiled design, by name; none where the gateway is a model."""
        return getattr(self._gateway, "ports", {})

    # Triggers

    def fire(self, group: str | int) -> None:
        """Fire the trigger of a group now; to be called where the event loop runs that serves the gateway.

        Args:
            group: its name in the spec of the robot, or its number.

        Raises:
            ArgumentError: for a group that there is not, or that has no trigger.
        """
        number = self._number(group)
        with contextlib.suppress(RuntimeError):
            self._now = max(self._now, asyncio.get_running_loop().time())
        self.trigger(self._now, number)

    def fire_at(self, group: str | int, rate_hz: float) -> None:
        """Fire the trigger of a group by itself at a rate, from now on.

        Raises:
            ArgumentError: as `fire`, and for what is no rate.
        """
        if not 0 < rate_hz <= 1e6:
            raise ArgumentError(f"a trigger of {rate_hz:g} Hz was asked for: more than 0 to 1e6 Hz was expected")
        self._rates[self._number(group)] = (1 / rate_hz, None)
        self.wake()

    def trigger(self, now: float, group: int | None = None) -> None:
        """Apply a rising edge to the external trigger of a group, or of all; the publish comes out of the next call."""
        self._gateway.trigger(now, group)
        self.wake()

    def _number(self, group: str | int) -> int:
        if isinstance(group, str) and not group.isdecimal():
            if self.robot is None:
                raise ArgumentError(f"there is no group {group!r} without a spec: its number was expected")
            return self.robot.triggered_group(group)
        number = int(group)
        if not 0 <= number < self.info.groups:
            raise ArgumentError(f"there is no group {number}: this gateway has those from 0 to {self.info.groups - 1}")
        return number

    # As every gateway

    @property
    def waiting(self) -> int:
        """Bytes that were received and not looked at yet."""
        return self._gateway.waiting

    @property
    def refusal(self) -> str:
        """The reason why the robot refuses each access; empty where it does not."""
        return "" if self.robot is None or self._is_wired else self.robot.refusal

    @property
    def leaves_time_out(self) -> bool:
        """Return whether the gateway leaves out what it is too late for."""
        return self._gateway.leaves_time_out

    @property
    def next_due(self) -> float | None:
        """Instant at which the gateway has something to do, a trigger fires, or the robot's time is to pass."""
        times = [self._gateway.next_due, None if self.robot is None or self._is_wired else self.robot.next_step]
        times += [self._now if edge is None else edge for _, edge in self._rates.values()]
        return min((time for time in times if time is not None), default=None)

    def receive(self, data: bytes, now: float) -> bytes:
        """Take bytes at the time `now` (seconds), and return what is sent at once."""
        self._now = now
        if self.robot is not None:
            self.robot.begin(now)
        answer = self._gateway.receive(data, now)
        self._pass_on_fired()
        return answer

    def advance(self, now: float, room: int | None = None) -> bytes:
        """Let time pass up to `now` (seconds), and return what is sent."""
        self._now = now
        sent = self._gateway.advance(now, room)
        # The robot stops where it fires a trigger, so that the group is read as it was then.
        while (edge := self._next_edge(now)) is not None:
            sent += self._gateway.advance(edge, None if room is None else max(0, room - len(sent)))
        return sent + self._gateway.advance(now, None if room is None else max(0, room - len(sent)))

    def _next_edge(self, now: float) -> float | None:
        """Let time pass up to the next edge of a trigger, and apply it; None where there is none until `now`."""
        rate = min(((edge or now, group) for group, (_, edge) in self._rates.items()), default=None)
        until = now if rate is None else min(rate[0], now)
        if self.robot is not None and not self._is_wired:
            # The next access tells the program.
            with contextlib.suppress(AccessError):
                self.robot.pass_time(until, until_fired=True)
        if (edge := self._pass_on_fired()) is not None:
            return edge
        if rate is None or rate[0] > now:
            return None
        edge, group = rate
        self._rates[group] = (self._rates[group][0], edge + self._rates[group][0])
        self._gateway.trigger(edge, group)
        return edge

    def _pass_on_fired(self) -> float | None:
        """Apply the edges that the robot gave; return when the last was."""
        edge = None
        while self.robot is not None and self.robot.fired:
            edge, group = self.robot.fired.popleft()
            self._gateway.trigger(edge, group)
        return edge

    # As every bare one

    def reset(self) -> None:
        """Go back to the state after power-up, and so the cores. Other things behind the bus stay as they are."""
        self._gateway.reset()
        if self.robot is not None:
            self.robot.cores.reset()

    def ticks_at(self, now: float) -> int:
        """Return the cycles of the gateway's clock since its reset, at an instant of an access (seconds)."""
        return self._gateway.ticks_at(now)

    def attach(self, device: Device, addresses: Iterable[int]) -> None:
        """Put a device behind addresses, which have none of their own; the first is its offset 0."""
        self._gateway.attach(device, addresses)

    def attach_elsewhere(self, device: Device) -> None:
        """Put a device behind every address that has none of its own; its offsets are the addresses."""
        self._gateway.attach_elsewhere(device)

    def detach(self, addresses: Iterable[int]) -> None:
        """Take the devices of addresses away again."""
        self._gateway.detach(addresses)

    def overflow(self) -> None:
        """Lose bytes before the next one received: the frame that they belong to is answered by error 09."""
        self._gateway.overflow()

    @property
    def send_immediate(self) -> int:
        """Send-immediate mode of responses of the model: 0 off, 1 always, 2 adaptive."""
        return int(getattr(self._gateway, "send_immediate", 0))

    @property
    def flush_wanted(self) -> bool:
        """Return whether the model has sent a sample that is to be flushed; the one who flushes clears it."""
        return bool(getattr(self._gateway, "flush_wanted", False))

    @flush_wanted.setter
    def flush_wanted(self, wanted: bool) -> None:
        self._gateway.flush_wanted = wanted  # type: ignore[attr-defined]  # it was asked for before


def make_robot(interface: Interface, model: type[SimulatedRobot] | None) -> SimulatedRobot:
    """Make the robot of a spec; without a model its registers are memory.

    Raises:
        ArgumentError: where the model is none of this spec.
    """
    from unity_link.virtual.simulated import SimulatedRobot

    kind = SimulatedRobot if model is None else model
    given: object = kind
    if not (isinstance(given, type) and issubclass(given, SimulatedRobot)):
        raise ArgumentError(
            f"{given!r} is no model: a subclass of unity_link.virtual.simulated.SimulatedRobot was expected"
        )
    try:
        robot = kind(interface)
        robot.prepare()
    except ArgumentError:
        raise
    except ANY_ERROR as error:
        _LOG.exception("%s cannot be made", kind.__name__)
        raise ArgumentError(
            f"the model {kind.__name__} cannot be made for {interface.name}: {type(error).__name__}: {error}"
        ) from error
    return robot


def load_model(text: str) -> type[SimulatedRobot]:
    """Return the class that ``my.py:Rover`` or ``my_package.rover:Rover`` names.

    The class may be left out where it is the only model.

    Raises:
        ArgumentError: where there is none.
    """
    from unity_link.virtual.simulated import SimulatedRobot

    place, _, name = (text, "", "") if text.endswith(".py") else text.rpartition(":")
    if not place:
        raise ArgumentError(f"{text!r} names no model: a file and a class, such as my.py:Rover, were expected")
    module = _import(place)
    if name:
        found = getattr(module, name, None)
        if not (isinstance(found, type) and issubclass(found, SimulatedRobot)):
            what = "no class" if found is None else "no subclass of SimulatedRobot that is called"
            raise ArgumentError(f"{place} has {what} {name!r}{_models_of(module)}")
        return found
    models = _own_models(module)
    if len(models) != 1:
        raise ArgumentError(f"{place} has {len(models)} models{_models_of(module)}: name one, as in {place}:Rover")
    return models[0]


def _own_models(module: Any) -> list[type[SimulatedRobot]]:
    from unity_link.virtual.simulated import SimulatedRobot

    return [
        value
        for value in vars(module).values()
        if isinstance(value, type) and issubclass(value, SimulatedRobot) and value.__module__ == module.__name__
    ]


def _models_of(module: Any) -> str:
    names = ", ".join(model.__name__ for model in _own_models(module))
    return f" (its models are {names})" if names else " (it has no subclass of SimulatedRobot)"


def _import(place: str) -> Any:
    """Import a file anew, or a module."""
    path = Path(place)
    is_file = path.suffix == ".py"
    if is_file and not path.is_file():
        raise ArgumentError(f"there is no file {place}: the file of the model was expected, as in my.py:Rover")
    try:
        if not is_file:
            return importlib.import_module(place)
        folder = str(path.resolve().parent)
        if folder not in sys.path:
            # Where a script would find what is beside it.
            sys.path.insert(0, folder)
        spec = importlib.util.spec_from_file_location(path.stem, path)
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    except ANY_ERROR as error:
        if isinstance(error, ModuleNotFoundError) and error.name == place:
            raise ArgumentError(f"there is no module {place!r}: a file of the model ends in .py") from None
        _LOG.exception("%s cannot be imported", place)
        raise ArgumentError(f"{place} cannot be imported: {type(error).__name__}: {error}") from error
    return module

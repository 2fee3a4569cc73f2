"""A virtual gateway with a simulated robot, whose time also passes without accesses."""

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
    """A gateway around another one, which advances a robot and fires triggers of groups.

    Args:
        gateway: the other gateway.
        robot: the robot on its bus; None if there is only memory, or devices that need no time.
    """

    def __init__(self, gateway: BareGateway, robot: R_co) -> None:
        self.info = gateway.info
        self.wake: Callable[[], None] = lambda: None
        self.robot = robot
        self._gateway = gateway
        self._now = 0.0
        self._rates: dict[int, tuple[float, float | None]] = {}
        """Seconds between two edges, and time of the next edge, of each trigger that fires automatically, by group."""
        self._is_wired = False
        """True if the other gateway, as compiled gateware, advances the robot."""
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
        """Words of plain memory, by address."""
        return self._gateway.memory

    @property
    def ports(self) -> Mapping[str, Port]:
        """Ports of the compiled design, by name; empty for a model."""
        return getattr(self._gateway, "ports", {})

    # Triggers

    def fire(self, group: str | int) -> None:
        """Fire the trigger of a group now; call this in the thread of the gateway's event loop.

        Args:
            group: name of the group in the robot's spec, or its number.

        Raises:
            ArgumentError: if the group does not exist, or has no trigger.
        """
        number = self._number(group)
        with contextlib.suppress(RuntimeError):
            self._now = max(self._now, asyncio.get_running_loop().time())
        self.trigger(self._now, number)

    def fire_at(self, group: str | int, rate_hz: float) -> None:
        """Fire the trigger of a group automatically at a rate from now on.

        Raises:
            ArgumentError: as for `fire`, or if the rate is not above 0 and up to 1e6 Hz.
        """
        if not 0 < rate_hz <= 1e6:
            raise ArgumentError(f"a trigger of {rate_hz:g} Hz was asked for: more than 0 to 1e6 Hz was expected")
        self._rates[self._number(group)] = (1 / rate_hz, None)
        self.wake()

    def trigger(self, now: float, group: int | None = None) -> None:
        """Apply a rising edge to the external trigger of a group, or of all; the next call returns the samples."""
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

    # The interface of gateways

    @property
    def waiting(self) -> int:
        """Number of received and unprocessed bytes."""
        return self._gateway.waiting

    @property
    def refusal(self) -> str:
        """Reason why the robot refuses all accesses; empty if it does not."""
        return "" if self.robot is None or self._is_wired else self.robot.refusal

    @property
    def leaves_time_out(self) -> bool:
        """True if the gateway skips time for which it is too late."""
        return self._gateway.leaves_time_out

    @property
    def next_due(self) -> float | None:
        """Time at which the gateway has something to do, a trigger fires, or the robot must be advanced."""
        times = [self._gateway.next_due, None if self.robot is None or self._is_wired else self.robot.next_step]
        times += [self._now if edge is None else edge for _, edge in self._rates.values()]
        return min((time for time in times if time is not None), default=None)

    def receive(self, data: bytes, now: float) -> bytes:
        """Process bytes received at the time `now` in seconds, and return the bytes to send."""
        self._now = now
        if self.robot is not None:
            self.robot.begin(now)
        answer = self._gateway.receive(data, now)
        self._pass_on_fired()
        return answer

    def advance(self, now: float, room: int | None = None) -> bytes:
        """Advance to the time `now` in seconds, and return the bytes to send."""
        self._now = now
        sent = self._gateway.advance(now, room)
        # The robot stops at each fired trigger, so that the group is read with the values of that time.
        while (edge := self._next_edge(now)) is not None:
            sent += self._gateway.advance(edge, None if room is None else max(0, room - len(sent)))
        return sent + self._gateway.advance(now, None if room is None else max(0, room - len(sent)))

    def _next_edge(self, now: float) -> float | None:
        """Advance the robot to the next edge of a trigger, apply the edge, and return its time; None if none is due."""
        rate = min(((edge or now, group) for group, (_, edge) in self._rates.items()), default=None)
        until = now if rate is None else min(rate[0], now)
        if self.robot is not None and not self._is_wired:
            # A failure of the robot is reported by the next access.
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
        """Apply the triggers that the robot has fired; return the time of the last one, or None."""
        edge = None
        while self.robot is not None and self.robot.fired:
            edge, group = self.robot.fired.popleft()
            self._gateway.trigger(edge, group)
        return edge

    # The interface of gateways without a line

    def reset(self) -> None:
        """Restore the state after power-up, also of the cores; memory and other devices keep theirs."""
        self._gateway.reset()
        if self.robot is not None:
            self.robot.cores.reset()

    def ticks_at(self, now: float) -> int:
        """Return the number of clock cycles from the gateway's reset to the time of an access in seconds."""
        return self._gateway.ticks_at(now)

    def attach(self, device: Device, addresses: Iterable[int]) -> None:
        """Attach a device to addresses without one; the first address has offset 0."""
        self._gateway.attach(device, addresses)

    def attach_elsewhere(self, device: Device) -> None:
        """Attach a device to all addresses without one; its offsets are the addresses."""
        self._gateway.attach_elsewhere(device)

    def detach(self, addresses: Iterable[int]) -> None:
        """Detach the devices from addresses."""
        self._gateway.detach(addresses)

    def overflow(self) -> None:
        """Lose bytes before the next received byte: the gateway answers their frame with error 09."""
        self._gateway.overflow()

    @property
    def send_immediate(self) -> int:
        """Send-immediate mode of a model's responses: 0 off, 1 always, 2 adaptive."""
        return int(getattr(self._gateway, "send_immediate", 0))

    @property
    def flush_wanted(self) -> bool:
        """True after a model has sent a sample that requests a flush; the medium clears it at the flush."""
        return bool(getattr(self._gateway, "flush_wanted", False))

    @flush_wanted.setter
    def flush_wanted(self, wanted: bool) -> None:
        self._gateway.flush_wanted = wanted  # type: ignore[attr-defined]  # it was read before


def make_robot(interface: Interface, model: type[SimulatedRobot] | None) -> SimulatedRobot:
    """Return the robot of a spec; without a model its registers are memory.

    Raises:
        ArgumentError: if the model does not fit the spec.
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
    """Return the class of a text such as ``my.py:Rover`` or ``my_package.rover:Rover``.

    The class may be omitted if it is the only model of the file or module.

    Raises:
        ArgumentError: if there is no such model.
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
    """Return a module: import a file, even if it was imported before, or a module by name."""
    path = Path(place)
    is_file = path.suffix == ".py"
    if is_file and not path.is_file():
        raise ArgumentError(f"there is no file {place}: the file of the model was expected, as in my.py:Rover")
    try:
        if not is_file:
            return importlib.import_module(place)
        folder = str(path.resolve().parent)
        if folder not in sys.path:
            # The file may import its neighbours, as a script may.
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

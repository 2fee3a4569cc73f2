"""The compiled gateway of a spec with its register bank, and a simulated robot at the ports of the register bank.

The robot has the gateware's time. A step of the robot runs before the clock cycle in which it is due, so that hardware
sees the new values in that cycle; if cycles are skipped, the step runs before the clock is set forward. A trigger that
the robot fires is applied in the cycle of the step.
"""

from __future__ import annotations

import contextlib
import math
from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.generate.vhdl.bank import Bank
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.spec import Way
from unity_link.virtual.bus import AccessError
from unity_link.virtual.faults import Failing
from unity_link.virtual.rtl.gateway import RtlGateway
from unity_link.virtual.rtl.specs import ports_of
from unity_link.virtual.rtl.wiring import PinLevels, RobotPorts

if TYPE_CHECKING:
    from collections.abc import Iterable

    from unity_link.spec import Interface
    from unity_link.virtual.bus import Device
    from unity_link.virtual.rtl.configurations import Configuration
    from unity_link.virtual.rtl.ports import Port
    from unity_link.virtual.simulated import SimulatedRobot


class SpecGateway(RtlGateway):
    """The compiled gateway of a spec with its register bank.

    Args:
        configuration: build of the gateway.
        interface: interface of the spec.

    Raises:
        ConnectError: if no C++ compiler is installed.
    """

    def __init__(self, configuration: Configuration, interface: Interface) -> None:
        self._interface = interface
        self._bank = Bank(interface)
        self._robot: SimulatedRobot | None = None
        self._wiring: RobotPorts | None = None
        super().__init__(configuration)
        super().attach_elsewhere(Failing(ErrorCode.BUS_ERROR))
        self._rest_pins()
        # `keep_awake` keeps the gateway awake if there are cores, which work by themselves.
        self.keep_awake(on=False)

    def reset(self) -> None:
        """Restore the state after power-up, also that of the registers."""
        super().reset()
        if self._wiring is not None:
            self._wiring.take_all()

    def keep_awake(self, *, on: bool) -> None:
        """Compute each clock cycle from now on, or end that; with cores each cycle is always computed."""
        super().keep_awake(on=on or bool(self._interface.cores))

    def _pins(self) -> dict[str, PinLevels]:
        """Return the pins of each core, by path of the core."""
        names = {pin.path: [name for name, _ in pin.ports] for pin in self._bank.wiring.pins}
        found = {}
        for part in self._interface.cores:
            ports: dict[str, tuple[Port | None, Port | None, Port | None]] = {}
            for pin in part.core.pins if part.core is not None else ():
                wires = [self.ports[name] for name in names.get(pin.path, ())]
                driven = wires[0] if wires and pin.way is not Way.OUT else None
                out = wires[-2:] if pin.way is Way.INOUT else wires if pin.way is Way.OUT else []
                ports[pin.name] = (driven, out[0] if out else None, out[1] if len(out) > 1 else None)
            found[part.path] = PinLevels(self, ports)
        return found

    def _rest_pins(self) -> None:
        """Drive the input pins of cores to their levels without a wire."""
        levels = self._pins()
        for part in self._interface.cores:
            for pin in part.core.pins if part.core is not None else ():
                if pin.way is not Way.OUT and pin.is_used:
                    levels[part.path][pin.name] = pin.unwired

    # Devices and robots at the ports

    def attach(self, device: Device, addresses: Iterable[int]) -> None:
        """Attach a device to addresses without a signal; the first address has offset 0.

        Raises:
            ArgumentError: if an address does not fit, or has a signal or a device, or the object is not a device.
        """
        places = list(addresses)
        for word in self._bank.words:
            if word.address in places:
                raise ArgumentError(
                    f"a device is attached to {word.address:#x}, the address of {word.paths} in the register bank of "
                    f"{self._interface.name}: an address without a signal was expected"
                )
        super().attach(device, places)
        for index, port in enumerate(self._bank.ports):
            if any(port.first <= address <= port.last for address in places):
                self._library.ul_connect(self._handle, index)

    def attach_elsewhere(self, device: Device) -> None:
        """Attach a device to all addresses that have neither a signal nor a device; its offsets are the addresses."""
        super().attach_elsewhere(device)
        for index, _ in enumerate(self._bank.ports):
            self._library.ul_connect(self._handle, index)

    def wire(self, robot: SimulatedRobot) -> None:
        """Connect a robot to the ports of the signals, and its modules to their address windows.

        Raises:
            ArgumentError: if the robot has set a signal that only programs write.
        """
        offered = {path for group in self._interface.groups if group.trigger for path in group.signals}
        robot.is_wired = True
        robot.cores.take_clock(self.info.clock_hz, self.ticks_at)
        robot.wire_pins(self._pins())
        self._wiring = RobotPorts(self, robot, ports_of(self._interface), offered)
        self._robot = robot
        # The default device for all addresses; devices attached later have priority.
        super().attach_elsewhere(robot)
        for index, _ in enumerate(self._bank.windows):
            self._library.ul_connect(self._handle, index)

    # Time

    @property
    def next_due(self) -> float | None:
        """Time at which `advance` should be called next: that of the robot's next step if no cycles are computed."""
        due = super().next_due
        return self._robot.next_step if due is None and self._robot is not None else due

    def _pass_time(self, now: float) -> None:
        """Advance the gateware and the robot to the time `now`."""
        robot = self._robot
        if robot is None:
            super()._pass_time(now)
            return
        while not (self.ticking or self._is_held_up):
            # The gateware sees the robot only at the triggers that the robot fires.
            self._step_robot(max(now, self.time))
            if not robot.fired:
                break
            edge, group = robot.fired.popleft()
            super()._pass_time(min(edge, now))
            self.pulse(group)
            self._run_until_quiet()
        self._set_alarm()
        super()._pass_time(now)

    def _step_robot(self, until: float) -> None:
        assert self._robot is not None
        assert self._wiring is not None
        self._wiring.tell_of_pins()
        # A failure of the robot is logged, and the registers keep their values.
        with contextlib.suppress(AccessError):
            self._robot.pass_time(until, until_fired=True)

    def _set_alarm(self) -> None:
        assert self._robot is not None
        due = self._robot.due
        if due is not None and self._origin is not None:
            cycles = math.ceil((due - self._time()) * self.info.clock_hz)
            self.call_before(self.cycles + max(1, cycles), self._step_in_time)

    def _step_in_time(self) -> None:
        assert self._robot is not None
        self._step_robot(self._time())
        while self._robot.fired:
            self.pulse(self._robot.fired.popleft()[1])
        self._set_alarm()

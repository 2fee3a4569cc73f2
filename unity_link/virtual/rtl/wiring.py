"""Connects the signals of a simulated robot to the ports of the compiled register bank.

When the model sets a signal that hardware provides, the signal's port is driven. When a program writes a signal, the
signal gets the bits of its port, and `written` of the model is called in the clock cycle in which the port has the new
value. For a signal at pins, `written` is called in the model's first step after a change. FIFO ports are queues, which
transfer words at the same clock edges as the gateware.
"""

from __future__ import annotations

import logging
from collections.abc import MutableMapping
from typing import TYPE_CHECKING

from unity_link.errors import ANY_ERROR, ArgumentError
from unity_link.spec import Effect
from unity_link.virtual.bus import AccessError

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from unity_link.cores import AtPins
    from unity_link.virtual.registers import Cell, Queue, SignalFault
    from unity_link.virtual.rtl.gateway import RtlGateway
    from unity_link.virtual.rtl.ports import Port
    from unity_link.virtual.simulated import SimulatedRobot

_LOG = logging.getLogger("unity_link.virtual")


class Given:
    """A signal that hardware provides."""

    def look(self, cell: Cell) -> None:
        """Do nothing: the model may read the value."""

    def __init__(self, port: Port) -> None:
        self._port = port

    def drive(self, cell: Cell, raw: int) -> None:
        """Drive the port, unless it is frozen."""
        if cell.fault is None:
            self._port.drive(raw)

    def set_fault(self, cell: Cell, fault: SignalFault | None) -> None:
        """Freeze the port; None ends that.

        Raises:
            ArgumentError: if the fault is another one.
        """
        if fault is None:
            self._port.drive(cell.raw)
        elif fault != "frozen":
            raise _impossible(cell, fault)


class Events(Given):
    """A signal whose bits hardware sets, and accesses of programs clear.

    Args:
        port: port that sets bits.
        gateway: gateway with the register.
    """

    def __init__(self, port: Port, gateway: RtlGateway) -> None:
        super().__init__(port)
        self._gateway = gateway

    def look(self, cell: Cell) -> None:
        """Raise an error: a model cannot read the register.

        Raises:
            ArgumentError: always.
        """
        raise ArgumentError(
            f"{cell.signal.path} has {cell.signal.effect}, and its bits are in a register of the gateware: a model can "
            "set the bits and not read them; use sim: to read them"
        )

    def drive(self, cell: Cell, raw: int) -> None:
        """Set bits of the register, by driving the port for at least one clock cycle."""
        if cell.fault is None and raw:
            self._port.drive(self._port.value | raw)
            self._port.drive(0, self._gateway.cycles + 2)

    def set_fault(self, cell: Cell, fault: SignalFault | None) -> None:
        """Refuse a fault.

        Raises:
            ArgumentError: for one.
        """
        if fault is not None:
            raise _impossible(cell, fault)


class Got:
    """A signal that a program writes, or a FIFO port."""

    def look(self, cell: Cell) -> None:
        """Do nothing: the model may read the value."""

    def drive(self, cell: Cell, _: int) -> None:
        """Raise an error: only programs write the register.

        Raises:
            ArgumentError: always.
        """
        raise ArgumentError(
            f"{cell.signal.path} is {cell.signal.access}, and its register in the gateware changes with the writes of "
            "programs alone: a model can set READ signals only; use sim: to set others"
        )

    def set_fault(self, cell: Cell, fault: SignalFault | None) -> None:
        """Refuse a fault.

        Raises:
            ArgumentError: for one.
        """
        if fault is not None:
            raise _impossible(cell, fault)


class OfCore:
    """A signal of a core in compiled gateware; a model uses the core's pins instead.

    Args:
        pins: model of the core's pins; None if the core has none.
    """

    def __init__(self, pins: AtPins | None) -> None:
        self._pins = pins

    def look(self, cell: Cell) -> None:
        """Check that the model of the pins knows the value.

        Raises:
            ArgumentError: if the signal is not visible at the pins.
        """
        if self._pins is None or cell.signal.name not in self._pins.shows | self._pins.takes:
            raise self._refusal(cell)

    def drive(self, cell: Cell, raw: int) -> None:  # noqa: ARG002  (the step after this one drives the pins)
        """Accept a value from the model, which the model of the pins applies later.

        Raises:
            ArgumentError: if the signal does not come from the pins.
        """
        if self._pins is None or cell.signal.name not in self._pins.takes:
            raise self._refusal(cell)

    def _refusal(self, cell: Cell) -> ArgumentError:
        own = [] if self._pins is None else sorted(self._pins.shows | self._pins.takes)
        has = f", has {' and '.join(own)}," if own else ""
        return ArgumentError(
            f"{cell.signal.path} is a register of a core, which the compiled gateware has: a model looks at the pins "
            f"of the core and sets them{has} or takes sim:"
        )

    def set_fault(self, cell: Cell, fault: SignalFault | None) -> None:
        """Refuse a fault.

        Raises:
            ArgumentError: for one.
        """
        if fault is not None:
            raise _impossible(cell, fault)


class PinLevels(MutableMapping[str, int]):
    """Levels of a core's pins, at the ports of the design: inputs can be driven, and outputs read.

    A bidirectional pin has the gateware's level while the gateware drives it, and otherwise the level that was set.

    Args:
        gateway: gateway with the ports.
        ports: ports of each pin by name: the input, the output, and the output enable; None if there is none.
    """

    def __init__(self, gateway: RtlGateway, ports: Mapping[str, tuple[Port | None, Port | None, Port | None]]) -> None:
        self._gateway, self._ports = gateway, ports
        self._counted: dict[str, tuple[int, int]] = {}
        """Number of cycles in which each output was 1, and number of all cycles, at the last call of `duty`."""

    def has(self, name: str) -> bool:
        """Return True if the core has this pin."""
        return any(self._ports.get(name, ()))

    def drive(self, name: str, level: int, cycle: int) -> None:
        """Drive a pin from a clock cycle on.

        Raises:
            ArgumentError: if the pin is an output.
        """
        self._input(name).drive(level, cycle)

    def duty(self, name: str) -> float | None:
        """Return the fraction of the clock cycles since the last call in which an output was 1; None without cycles."""
        _, output, _ = self._ports[name]
        assert output is not None
        high, cycles = output.counts()[0].high, self._gateway.cycles
        before, self._counted[name] = self._counted.get(name), (high, cycles)
        if before is None or cycles <= before[1]:
            return None
        # After a reset, the number of cycles restarts at 0.
        return min((high - before[0]) / (cycles - before[1]), 1.0)

    def steps(self, pulse: str, direction: str) -> int:
        """Return the pulses since the reset or the first call: those with direction 0, minus those with direction 1."""
        outputs = [self._ports[name][1] for name in (pulse, direction)]
        assert outputs[0] is not None
        assert outputs[1] is not None
        return outputs[0].steps(outputs[1])

    def __getitem__(self, name: str) -> int:
        """Return the level of a pin."""
        driven, level, enabled = self._ports[name]
        if level is not None and (enabled is None or enabled.value):
            return level.value
        return 0 if driven is None else driven.value

    def __setitem__(self, name: str, level: int) -> None:
        """Drive a pin.

        Raises:
            ArgumentError: if the pin is an output.
        """
        self._input(name).drive(level)

    def _input(self, name: str) -> Port:
        driven, _, _ = self._ports[name]
        if driven is None:
            raise ArgumentError(f"{name} is no input of the gateware: it is an output, or has no pin")
        return driven

    def __delitem__(self, name: str) -> None:
        """Raise TypeError: pins cannot be deleted."""
        raise TypeError(name)

    def __iter__(self) -> Iterator[str]:
        """Return the names of all pins."""
        return iter(self._ports)

    def __len__(self) -> int:
        """Return the number of pins."""
        return len(self._ports)


def _impossible(cell: Cell, fault: SignalFault) -> ArgumentError:
    return ArgumentError(
        f"{cell.signal.path} cannot have the fault {fault}, as the compiled register bank answers for it: frozen, of a "
        "signal that is READ and no FIFO port, was expected, or sim:"
    )


class RobotPorts:
    """All signals of a robot, connected to their ports in the compiled register bank.

    Args:
        gateway: gateway with the ports.
        robot: the robot.
        ports: names of each signal's ports, by path of the signal and kind of port.
        offered: paths of the FIFO ports that a triggered group publishes as soon as they have a word.

    Raises:
        ArgumentError: if the robot has set a signal that only programs write.
    """

    def __init__(
        self, gateway: RtlGateway, robot: SimulatedRobot, ports: Mapping[str, Mapping[str, str]], offered: set[str]
    ) -> None:
        self._gateway, self._robot = gateway, robot
        self._told: set[type[BaseException]] = set()
        self._queues: list[Queue] = []
        self._got: list[tuple[Cell, Port]] = []
        self._at_pins: list[tuple[Cell, Port]] = []
        """Signals at pins, which have no port that shows a write."""
        for path, names in ports.items():
            cell = robot.cells[path]
            pins = {pin: gateway.ports[name] for pin, name in names.items()}
            if cell.queue is not None:
                self._join_queue(cell, cell.queue, pins)
                if path in offered:
                    self._queues.append(cell.queue)
            elif "got" in pins:
                self._join_got(cell, pins["got"], pins.get("written"))
            elif cell.signal.has_events:
                set_by_model = cell.raw & ~cell.signal.reset
                cell.take(0)
                cell.wire = Events(pins["given"], gateway)
                cell.wire.drive(cell, set_by_model)
            else:
                cell.wire = Given(pins["given"])
                cell.wire.drive(cell, cell.raw)
        for part in robot.interface.cores:
            for signal in part.signals:
                robot.cells[signal.path].wire = OfCore(robot.cores.at_pins.get(part.path))

    def take_all(self) -> None:
        """Read the values of all ports, for example after a reset, which does not pulse the ports."""
        for cell, port in self._got:
            cell.take(port.value)

    def tell_of_pins(self) -> None:
        """Call `written` of the model for signals at pins that programs have changed."""
        for cell, port in self._at_pins:
            if cell.raw != port.value:
                cell.accept(port.value)
                self._tell(cell)

    def _join_got(self, cell: Cell, got: Port, written: Port | None) -> None:
        cell.wire = Got()
        if cell.raw != cell.signal.reset:
            cell.wire.drive(cell, cell.raw)
        self._got.append((cell, got))
        if written is None and cell.signal.effect is Effect.PULSE:
            # A pulse at pins lasts one cycle, and its port is also the port that shows the write.
            written = got
        if written is None:
            self._at_pins.append((cell, got))
            return

        def take() -> None:
            cell.accept(got.value)
            self._tell(cell)

        self._gateway.watch(take, written)

    def _join_queue(self, cell: Cell, queue: Queue, pins: Mapping[str, Port]) -> None:
        cell.wire = Got()
        given, valid, ready = pins.get("given"), pins.get("given_valid"), pins.get("got_ready")

        def show() -> None:
            if given is not None and valid is not None:
                valid.drive(bool(queue.to_program))
                if queue.to_program:
                    given.drive(queue.to_program[0])
            if ready is not None:
                ready.drive(len(queue.from_program) < queue.depth)
            self._gateway.keep_awake(on=any(queue.to_program for queue in self._queues))

        def move_out() -> None:
            queue.to_program.popleft()
            show()

        def move_in() -> None:
            queue.from_program.append(pins["got"].value)
            show()
            self._tell(cell)

        if valid is not None:
            self._gateway.watch(move_out, valid, pins["given_ready"])
        if ready is not None:
            self._gateway.watch(move_in, pins["got_valid"], ready)
        queue.changed = show
        show()

    def _tell(self, cell: Cell) -> None:
        """Call `written` of the model, after the model was advanced to the time of the write."""
        try:
            self._robot.pass_time(self._gateway.time)
            self._robot.tell_written(cell)
        except AccessError:
            # The model's step has failed, which is logged already.
            return
        except ANY_ERROR as error:
            if type(error) not in self._told:
                self._told.add(type(error))
                _LOG.exception(
                    "%r failed in written(%r), which changes nothing in the gateware (told once)",
                    self._robot,
                    cell.signal.path,
                )

"""The cores of an interface, and registers at pins: everything between the register bank and the pins.

A core has no bus. Its ports are the registers of its component, its pins, and ports of the gateway that it uses.
Placements with the same entity and ports share one instance. Its ports contain the bits of all placements, the first
placement in the lowest bits.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from unity_link.errors import UnsupportedError
from unity_link.gateware.cache import LIBRARY
from unity_link.gateware.own_circuits import OwnInstance
from unity_link.generate.vhdl.names import RESERVED
from unity_link.quoting import vhdl_literal
from unity_link.spec import KindName, Way
from unity_link.spec.model import gathered

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from unity_link.generate.vhdl.names import Scope
    from unity_link.generate.vhdl.records import Pins
    from unity_link.spec import ComponentSpec, Core, Interface, Signal

EMPTY = "empty"
"""Port of the entity of a schedule, an output, and of the entity of a lease, an input."""
STAGE_PORTS = {
    "stage_write": "std_logic",
    "stage_index": "std_logic_vector(15 downto 0)",
    "stage_data": "std_logic_vector(31 downto 0)",
    "stage_clear": "std_logic",
    "commit": "std_logic",
}
"""Ports by which the entity of a schedule writes to registers, with their types."""
_DESIGN_NAMES = (
    *("clk", "rst", "clk_ready", "not_ready", "physical", "baud", "flow_control", "clock_hz", "id_digits", "groups"),
    *("checked_frames", "crc_bits", "crc_polynomial", "block_words", "group_words", "sample_depth", "node", "build_id"),
    *("base_frequency_millihertz", "rx_fifo_depth", "tx_fifo_depth", "bus_timeout", "masked_write", "queue_commands"),
    "compact",
    *("timestamps", "triggers", "send_immediate", "half_duplex", "driver_lead", "driver_tail", "stream_wait"),
    *("offer_cycles", "trigger", "triggers_now", "offered", "offered_for", "base_tick", "timestamp", "sample_strobe"),
    *("sample_access", "chain_clk", "chain_load_n", "chain_out", "chain_in", "chain_half_period", "from_chain"),
    *(f"uart_{pin}" for pin in ("rxd", "txd", "rts_n", "cts_n", "de")),
    *(f"ft_{pin}" for pin in ("clkout", "data", "data_in", "data_out", "data_oe", "rxf_n", "txe_n", "rd_n", "wr_n")),
    *("ft_oe_n", "ft_siwu_n", "mac_address", "ip_address", "udp_port", "gateway_name"),
    *(
        f"phy_{pin}"
        for pin in ("clk", "rx_clk", "rxd", "rxd_wide", "rx_dv", "rx_er", "tx_clk", "txd", "txd_wide", "tx_en")
    ),
    *("phy_txc", "phy_rst_n", "phy_clk_25", "phy_clk_25_now", "phy_dropped", "half_period", "half_left"),
    *(f"spi_{pin}" for pin in ("sck", "cs_n", "mosi", "miso", "rst_n")),
    *(f"in_{pin}" for pin in ("data", "lost", "valid", "ready")),
    *(f"out_{pin}" for pin in ("data", "valid", "ready", "flush")),
    *(f"wb_{pin}" for pin in ("cyc", "stb", "we", "adr", "to_bank", "to_gateway", "ack", "err", "stall")),
)
"""Names in the generated designs, which pins cannot have."""
_INPUTS = {"tick": "base_tick", "now": "timestamp"}
"""Ports that an entity can request, and the gateway's signals for them."""


class PinPort(NamedTuple):
    """A port of the design for a pin, or for a row of pins."""

    name: str
    path: str
    """Path in the interface."""
    way: Way
    width: int
    """Width of a vector; 0 for a single pin."""
    at: str | None
    """Name of the board's pin, or of its row of pins; None if the spec names none."""

    @property
    def type(self) -> str:
        """VHDL type of the port."""
        return f"std_logic_vector({self.width - 1} downto 0)" if self.width else "std_logic"

    @property
    def ports(self) -> tuple[tuple[str, str], ...]:
        """Names and directions of the ports without a tristate pad; an INOUT pin has three."""
        if self.way is Way.INOUT:
            return (f"{self.name}_in", "in"), (f"{self.name}_out", "out"), (f"{self.name}_oe", "out")
        return ((self.name, self.way.lower()),)


class EntityPort(NamedTuple):
    """A port of an instance, the signal connected to it, and the assignments of that signal."""

    port: str
    signal: str
    width: int
    joins: tuple[tuple[str, str], ...]
    """Pairs of target and value."""


class Instance(NamedTuple):
    """An instance of an entity, for one or several placements."""

    label: str
    library: str
    entity: str
    paths: str
    generics: tuple[tuple[str, str], ...]
    joined: tuple[tuple[str, str], ...]
    """Ports that are connected directly to signals of the design, and these signals."""
    wires: tuple[EntityPort, ...]


class Triggering(NamedTuple):
    """The expression that triggers a group, by the group's number."""

    group: int
    value: str


class Wiring:
    """The instances of cores, and the pins of an interface.

    Args:
        interface: the interface.
        wires: signals of the register bank, by the path of the spec's signal.
        stages: prefixes of the bank's ports for each schedule that writes to registers, by the path of the schedule.
        scope: names of the package.
        windows: names of the bank's master ports.

    Raises:
        UnsupportedError: if a port of a core has a reserved name.
    """

    def __init__(
        self,
        interface: Interface,
        wires: Mapping[str, Pins],
        stages: Mapping[str, str],
        scope: Scope,
        windows: Iterable[str],
    ) -> None:
        self._interface = interface
        self._wires = wires
        self._stages = stages
        self._scope = scope
        scope.take(*_DESIGN_NAMES, *windows)
        self.pins: list[PinPort] = []
        """All pins, in the order of the spec."""
        self.instances: list[Instance] = []
        self.joins: list[tuple[str, str]] = []
        """Assignments for registers at output pins: target and value."""
        self.buttons: list[tuple[PinPort, str]] = []
        """Input pins with a register, and the signal of the bank that the register reads."""
        self.triggers: dict[int, list[str]] = {}
        """Signals that trigger groups, by group number."""
        self._numbers = {group.name: group.number for group in interface.groups}
        for signal in interface.signals.values():
            if signal.pin is not None and signal.path in wires:
                self._pin_register(signal)
        self._empty: dict[str, str] = {}
        """Signals that are '1' while a schedule is empty, by the path of the schedule."""
        # Make the instances of leases last: they use the signals of schedules.
        for placements in sorted(gathered(interface.cores), key=lambda parts: EMPTY in _wants(parts)):
            self.instances.append(self._instance(placements))

    def own_instances(self, clock_hz: int) -> tuple[OwnInstance, ...]:
        """Return the instances of entities outside of the gateware, for a clock frequency in Hz."""
        return tuple(
            OwnInstance(
                f"{one.label}_inst", one.entity, tuple((dict(one.generics) | {"clock_hz": str(clock_hz)}).items())
            )
            for one in self.instances
            if one.library != LIBRARY
        )

    @property
    def wants(self) -> set[str]:
        """Signals of the design that instances use."""
        return {value for instance in self.instances for _, value in instance.joined}

    @property
    def triggerings(self) -> list[Triggering]:
        """The trigger expressions of groups, by ascending number."""
        return [Triggering(group, " or ".join(signals)) for group, signals in sorted(self.triggers.items())]

    def _pin_register(self, signal: Signal) -> None:
        single = signal.kind.name is KindName.BOOL
        way = Way.IN if signal.is_given else Way.OUT
        name = self._scope.unique(signal.path)
        port = PinPort(name, signal.path, way, 0 if single else signal.width, signal.pin)
        self.pins.append(port)
        wires = self._wires[signal.path]
        if way is Way.OUT:
            self.joins.append((name, f"{wires.got}(0)" if single else wires.got))
        else:
            self.buttons.append((port, wires.given))

    def _instance(self, placements: list[ComponentSpec]) -> Instance:
        first = placements[0]
        core = first.core
        assert core is not None
        self._check_ports(first, core)
        label = self._scope.unique(f"{core.entity}_of_{first.path}")
        wires = [
            *(wire for name in first.rows for wire in self._of_row(label, placements, name)),
            *(self._of_trigger(label, placements, index) for index in range(len(core.triggers))),
            *(wire for index in range(len(core.pins)) for wire in self._of_pin(label, placements, index)),
        ]
        generics = {"axes": str(len(placements)), "clock_hz": "clock_hz"}
        for name, value in core.generics.items():
            each = (part.core.generics[name] for part in placements if part.core is not None)
            listed = ", ".join(f"{axis} => {one}" for axis, one in enumerate(each))
            generics[name] = f"({listed})" if name in core.per_axis else vhdl_literal(value)
        joined = {"clk": "clk", "rst": "rst"} | {want: _INPUTS[want] for want in core.wants if want in _INPUTS}
        if core.stages:
            stage = self._stages.get(first.path)
            joined |= {port: "open" if stage is None else f"{stage}_{port}" for port in STAGE_PORTS}
        for want, otherwise in (("armed", "'1'"), ("finishing", "'0'")):
            if want in core.wants:
                given = [self._of_lease(part, want, otherwise) for part in placements]
                wires.append(self._wire(label, want, 0, given, drives=True))
        if core.stages:
            wires.append(self._wire(label, EMPTY, 0, [""], drives=False))
            self._empty[first.path] = f"{wires[-1].signal}(0)"
        elif EMPTY in core.wants:
            wires.append(self._wire(label, EMPTY, 0, [self._all_empty(part) for part in placements], drives=True))
        return Instance(
            label,
            core.library,
            core.entity,
            ", ".join(part.path for part in placements),
            tuple(generics.items()),
            tuple(joined.items()),
            tuple(wires),
        )

    def _check_ports(self, component: ComponentSpec, core: Core) -> None:
        """Raise an error if a port has a name that VHDL or the contract of cores reserves."""
        others = [*(pin.name for pin in core.pins), *(trigger.name for trigger in core.triggers)]
        for name in [*component.rows, *others]:
            taken = {"clk", "rst", *core.wants, *((*STAGE_PORTS, EMPTY) if core.stages else ())}
            if name.lower() in RESERVED or name.lower() in taken:
                what = "a word of VHDL" if name.lower() in RESERVED else "a port that it has for something else"
                raise UnsupportedError(
                    f"{component.path}.{name} cannot be a port of {core.entity}: {name.lower()} is {what}"
                )

    def _of_row(self, label: str, placements: list[ComponentSpec], row: str) -> Iterator[EntityPort]:
        """Yield the ports for a signal or a row: the lowest bits are those of the first placement, all of its row."""
        signals = [signal for part in placements for signal in part.rows[row]]
        name, width = row.lower(), signals[0].width
        if not signals[0].is_given:
            yield self._wire(label, name, width, [self._wires[one.path].got for one in signals], drives=True)
            written = [self._wires[one.path].written for one in signals]
            yield self._wire(label, f"{name}_written", 0, written, drives=True)
        else:
            yield self._wire(label, name, width, [self._wires[one.path].given for one in signals], drives=False)

    def _of_lease(self, part: ComponentSpec, register: str, otherwise: str) -> str:
        """Return a bit of the lease that guards a component or its timed signals; `otherwise` if there is none."""
        timed = (signal for signal in self._interface.signals.values() if signal.timed == part.path)
        leases = (signal.safe.lease for signal in (*part.signals, *timed) if signal.safe is not None)
        lease = next(leases, None)
        wires = self._wires.get(f"{lease}.{register}")
        return otherwise if wires is None else f"{wires.given}(0)"

    def _all_empty(self, lease: ComponentSpec) -> str:
        """Return an expression that is '1' while all schedules that write signals of a lease are empty."""
        return " and ".join(self._empty[path] for path in self._interface.schedules_of(lease.path)) or "'1'"

    def _of_trigger(self, label: str, placements: list[ComponentSpec], index: int) -> EntityPort:
        triggers = [part.core.triggers[index] for part in placements if part.core is not None]
        wire = self._wire(label, triggers[0].name.lower(), 0, [""] * len(triggers), drives=False)
        for axis, trigger in enumerate(triggers):
            number = self._numbers.get(trigger.group) if trigger.group is not None else None
            if number is not None:
                self.triggers.setdefault(number, []).append(f"{wire.signal}({axis})")
        return wire

    def _of_pin(self, label: str, placements: list[ComponentSpec], index: int) -> Iterator[EntityPort]:
        pins = [part.core.pins[index] for part in placements if part.core is not None]
        endings = ("_in", "_out", "_oe") if pins[0].way is Way.INOUT else ("",)
        ports = [
            PinPort(self._scope.unique(pin.path, *endings), pin.path, pin.way, 0, pin.at) if pin.is_used else None
            for pin in pins
        ]
        self.pins += filter(None, ports)
        for place, ending in enumerate(endings):
            is_input = place == 0 and pins[0].way is not Way.OUT
            nothing = f"'{pins[0].unwired}'" if is_input else ""
            names = [nothing if port is None else port.ports[place][0] for port in ports]
            yield self._wire(label, f"{pins[0].name.lower()}{ending}", 0, names, drives=is_input)

    def _wire(self, label: str, port: str, width: int, names: list[str], *, drives: bool) -> EntityPort:
        """Return a port of an instance with the signal that connects it to `names`, one for each placement.

        `drives`: the names drive the port, otherwise the port drives them. A width of 0 is a single bit each.
        """
        signal = self._scope.unique(f"{label}_{port}")
        joins = []
        for axis, name in enumerate(names):
            bits = f"{signal}({(axis + 1) * width - 1} downto {axis * width})" if width else f"{signal}({axis})"
            if name:
                joins.append((bits, name) if drives else (name, bits))
        return EntityPort(port, signal, len(names) * max(width, 1), tuple(joins))


def _wants(parts: list[ComponentSpec]) -> tuple[str, ...]:
    return parts[0].core.wants if parts[0].core is not None else ()

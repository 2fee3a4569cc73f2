"""Builds a virtual gateway from the options of a URL or a command: robot, configuration, faults.

The robot on the bus is given by one text: empty for plain memory, a name of `ROBOTS`, or the path of a spec, whose
registers are memory or the values of a model. The options in a URL are the same for all schemes.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, TypeVar, overload

import msgspec

from unity_link.errors import ArgumentError, UnsupportedError
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.crc import USUAL_POLYNOMIALS
from unity_link.virtual.faults import Noise, NoisyLine
from unity_link.virtual.gateway import BareGateway, Gateway, VirtualGateway
from unity_link.virtual.line import SlowLine
from unity_link.virtual.scara import Scara
from unity_link.virtual.shared_line import build_shared_line
from unity_link.virtual.simulating import SimulatedGateway, load_model, make_robot
from unity_link.virtual.walker import Walker

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from unity_link.spec import Interface
    from unity_link.transport import DriverUrl
    from unity_link.virtual.rtl.configurations import Configuration
    from unity_link.virtual.simulated import SimulatedRobot

M = TypeVar("M", bound="SimulatedRobot")


def _attach_tosnet(gateway: BareGateway) -> object:
    # Imported here because it imports numpy.
    from unity_link.virtual.tosnet import ScaraOnTosnet

    return ScaraOnTosnet.attach(gateway)


ROBOTS: dict[str, Callable[[BareGateway], object]] = {
    "": lambda _: None,
    "scara": Scara.attach,
    "tosnet": _attach_tosnet,
    "walker": Walker.attach,
}
"""Functions that attach the built-in robots to a gateway, by name; the empty name is plain memory."""
CHANCES = ("loss", "flip", "double")
"""Probabilities of `Noise` that a user can choose."""
CONFIGURATION = tuple(name for name in GatewayInfo.__struct_fields__ if name != "protocol_version")
"""Fields of `GatewayInfo` that a user can choose."""
ROBOT_OPTIONS = frozenset({"model", "interface", "fault", "trigger", "unchecked"})
"""Options of a URL for the robot."""


class Wanted(msgspec.Struct, frozen=True, kw_only=True):
    """Options of a virtual gateway and its robot."""

    robot: str = ""
    """Empty for plain memory, a name of `ROBOTS`, or the path of a spec."""
    model: str | None = None
    """Model of a spec's robot, such as ``my.py:Rover``; None if its registers are memory."""
    interface: str | None = None
    """Name of the public interface, if the spec has several."""
    configuration: dict[str, int] = {}
    """Fields of `GatewayInfo` that differ from the gateware's defaults, or from the spec."""
    rtl: bool = False
    """True for compiled gateware, False for the model."""
    unchecked: bool = False
    """True to use compiled gateware without comparing the VHDL of the spec's own cores with its Verilog."""
    node: int | None = None
    """Node number on a shared medium; None if the medium is not shared."""
    faults: tuple[str, ...] = ()
    """Faults of the robot that are on from the start, such as ``stuck`` or ``left.speed:timeout``."""
    triggers: dict[str, float] = {}
    """Rates in Hz of triggers that fire automatically, by name or number of the group."""

    @classmethod
    def of_url(cls, url: DriverUrl, robot: str, *, rtl: bool = False) -> Wanted:
        """Return the options in a URL.

        Raises:
            ArgumentError: if the value of an option is invalid.
        """
        return cls(
            robot=robot,
            model=url.options.get("model"),
            interface=url.options.get("interface"),
            configuration={name: url.integer(name, 0) for name in CONFIGURATION if name in url.options},
            rtl=rtl,
            unchecked=url.flag("unchecked"),
            node=url.node,
            faults=tuple(filter(None, url.options.get("fault", "").split(","))),
            triggers=dict(parse_trigger(text) for text in filter(None, url.options.get("trigger", "").split(","))),
        )

    @property
    def has_spec(self) -> bool:
        """True if the robot is that of a spec."""
        return self.robot not in ROBOTS


def parse_trigger(text: str) -> tuple[str, float]:
    """Return the group and the rate in Hz from a text such as ``state:10``.

    Raises:
        ArgumentError: if the text has another form.
    """
    group, _, rate = text.rpartition(":")
    try:
        return group, float(rate)
    except ValueError:
        raise ArgumentError(f"trigger {text!r}: a group and a rate in Hz were expected, as in state:10") from None


def build_gateway(
    wanted: Wanted | str = "",
    configuration: Mapping[str, int] | None = None,
    *,
    node: int | None = None,
    chances: Mapping[str, float] | None = None,
    seed: int = 0,
    bytes_per_second: float | None = None,
) -> Gateway:
    """Build a gateway at a line.

    Args:
        wanted: all options, or the robot alone.
        configuration: fields of `GatewayInfo`, if `wanted` is the robot alone.
        node: node number, if `wanted` is the robot alone.
        chances: probabilities of `CHANCES` for each byte, in both directions.
        seed: seed of the noise.
        bytes_per_second: rate of the line, which has the FIFOs of the configuration; None for no limit.

    Raises:
        ArgumentError: if the robot is unknown, no gateway can have one of the values, or the gateware of the
            configuration is not in this installation.
        ConnectError: if the gateware cannot be compiled on this machine.
        SpecError: if the spec has faults; the error lists all of them.
    """
    if isinstance(wanted, str):
        wanted = Wanted(robot=wanted, configuration=dict(configuration or {}), node=node)
    return put_behind_line(build_bare(wanted), chances=chances, seed=seed, bytes_per_second=bytes_per_second)


def put_behind_line(
    bare: BareGateway,
    *,
    chances: Mapping[str, float] | None = None,
    seed: int = 0,
    bytes_per_second: float | None = None,
) -> Gateway:
    """Return a gateway at a line with a limited rate, noise or both, or the gateway itself if neither is requested.

    Args:
        bare: the gateway.
        chances: as in `build_gateway`.
        seed: as in `build_gateway`.
        bytes_per_second: as in `build_gateway`.

    Raises:
        ArgumentError: if no line can have one of the values.
    """
    gateway: Gateway = bare
    if bytes_per_second is not None:
        gateway = SlowLine(bare, bytes_per_second)
    return _noisy(gateway, chances or {}, seed)


def _noisy(gateway: Gateway, chances: Mapping[str, float], seed: int) -> Gateway:
    if not chances:
        return gateway
    return NoisyLine(gateway, Noise(2 * seed, **chances), Noise(2 * seed + 1, **chances))


def build_nodes(
    nodes: list[int],
    baud: int,
    configuration: Mapping[str, int],
    *,
    chances: Mapping[str, float],
    seed: int,
    on_collision: Callable[[str], object],
    rtl: bool = False,
) -> Gateway:
    """Build an RS-485 line with a gateway for each node.

    Args:
        nodes: numbers of the nodes.
        baud: baud rate of the line.
        configuration: fields of `GatewayInfo` of each node.
        chances: probabilities of `CHANCES` for each byte on the line.
        seed: seed of the noise.
        on_collision: is called with a sentence when two drivers are on at the same time.
        rtl: True for compiled gateware, False for models.

    Raises:
        ArgumentError: if no gateway can have one of the values.
        ConnectError: if the gateware cannot be compiled on this machine.
    """
    line = build_shared_line(
        nodes, baud, _info(configuration, _compiled_default() if rtl else None), build=compiled_node if rtl else None
    )
    line.on_collision = on_collision
    return _noisy(line, chances, seed)


def build_bare(wanted: Wanted) -> BareGateway:
    """Build a gateway without a line, as `build_gateway` does; for a spec or triggers, a `SimulatedGateway`."""
    if wanted.has_spec:
        model = None if wanted.model is None else load_model(wanted.model)
        made: BareGateway = simulated(find_interface(wanted.robot, wanted.interface), model, wanted)
    else:
        for option in ("model", "interface", "faults"):
            if getattr(wanted, option):
                raise ArgumentError(
                    f"{option.removesuffix('s')} is for the robot of a spec, not for {wanted.robot or 'plain memory'}: "
                    "the path of a spec was expected, such as robot.ul"
                )
        bare = _compiled(wanted) if wanted.rtl else VirtualGateway(_info(wanted.configuration), node=wanted.node)
        ROBOTS[wanted.robot](bare)
        made = SimulatedGateway(bare, None) if wanted.triggers else bare
    if isinstance(made, SimulatedGateway):
        for group, rate in wanted.triggers.items():
            made.fire_at(group, rate)
    return made


def simulated(
    interface: Interface, model: type[SimulatedRobot] | None = None, wanted: Wanted | None = None
) -> SimulatedGateway:
    """Build the gateway of an interface, with its robot.

    Raises:
        ArgumentError: if the model does not fit the spec.
    """
    from unity_link.virtual.generics import generics_of, info_of
    from unity_link.virtual.simulated import parse_fault

    wanted = Wanted() if wanted is None else wanted
    robot = make_robot(interface, model)
    if wanted.rtl:
        bare = _compiled_of(interface, wanted)
    else:
        bare = VirtualGateway(_info(wanted.configuration, info_of(generics_of(interface))), node=wanted.node)
    gateway = SimulatedGateway(bare, robot)
    for fault in wanted.faults:
        robot.set_fault(*parse_fault(fault))
    return gateway


@overload
def simulate(
    spec: str | Path,
    model: None = None,
    *,
    interface: str | None = None,
    rtl: bool = False,
    unchecked: bool = False,
    clock_hz: int | None = None,
) -> SimulatedGateway: ...
@overload
def simulate(
    spec: str | Path,
    model: type[M],
    *,
    interface: str | None = None,
    rtl: bool = False,
    unchecked: bool = False,
    clock_hz: int | None = None,
) -> SimulatedGateway[M]: ...
def simulate(
    spec: str | Path,
    model: type[SimulatedRobot] | None = None,
    *,
    interface: str | None = None,
    rtl: bool = False,
    unchecked: bool = False,
    clock_hz: int | None = None,
) -> SimulatedGateway:
    """Return a virtual gateway with the robot of a spec; `unity_link.connect` opens it like a URL.

    Args:
        spec: path of the spec.
        model: a subclass of `SimulatedRobot`; None if the registers are memory.
        interface: name of the public interface, if the spec has several.
        rtl: True for compiled gateware, False for the model.
        unchecked: True to use compiled gateware without comparing the VHDL of the spec's own cores with its Verilog.
        clock_hz: clock frequency of the gateway in Hz; None for that of a board, or for compiled gateware one that a PC
            simulates in real time.

    Raises:
        ArgumentError: if the model does not fit the spec, or the clock is too slow for the spec.
        ConnectError: if the gateware cannot be compiled on this machine.
        SpecError: if the spec has faults; the error lists all of them.
    """
    configuration = {} if clock_hz is None else {"clock_hz": clock_hz}
    wanted = Wanted(robot=str(spec), interface=interface, rtl=rtl, unchecked=unchecked, configuration=configuration)
    return simulated(find_interface(wanted.robot, interface), model, wanted)


def find_interface(robot: str, name: str | None) -> Interface:
    """Return the interface of a spec.

    Raises:
        ArgumentError: if the file or the interface does not exist.
        SpecError: if the spec has faults; the error lists all of them.
    """
    from unity_link.spec import compile_file

    path = Path(robot)
    if path.suffix != ".ul" and not path.is_file():
        known = ", ".join(known for known in ROBOTS if known)
        hint = f": did you mean {robot}.ul?" if Path(f"{robot}.ul").is_file() else ""
        raise ArgumentError(
            f"no robot {robot!r} is known{hint or f': one of {known} was expected, or the path of a spec (robot.ul)'}"
        )
    if not path.is_file():
        raise ArgumentError(f"there is no spec {robot} in {Path.cwd()}")
    return compile_file(path).interface(name)


async def compile_gateway(wanted: Wanted) -> None:
    """Compile the gateware that `build_gateway` needs, unless it is in the cache, without blocking the event loop.

    Raises:
        ArgumentError: if the configuration does not exist.
        ConnectError: if the gateware cannot be compiled on this machine.
    """
    from unity_link.virtual.rtl.compiling import compile_beside
    from unity_link.virtual.rtl.specs import make_beside

    await compile_beside(await make_beside(_build_of(wanted)))


def _compiled(wanted: Wanted) -> BareGateway:
    from unity_link.virtual.rtl import RtlGateway
    from unity_link.virtual.rtl.specs import made

    return RtlGateway(made(_build_of(wanted)))


def _compiled_of(interface: Interface, wanted: Wanted) -> BareGateway:
    from unity_link.virtual.rtl.spec_gateway import SpecGateway
    from unity_link.virtual.rtl.specs import made

    return SpecGateway(made(_build_of_spec(interface, wanted)), interface)


def _build_of_spec(interface: Interface, wanted: Wanted) -> Configuration:
    from unity_link.virtual.rtl.specs import configuration_of

    return configuration_of(interface, wanted.configuration, wanted.node, unchecked=wanted.unchecked)


def _compiled_default() -> GatewayInfo:
    from unity_link.virtual.rtl.configurations import DEFAULT, find

    return find(DEFAULT).info


def compiled_node(info: GatewayInfo, node: int) -> BareGateway:
    """Build the compiled gateware of a node on a shared medium.

    Raises:
        ArgumentError: if no gateway can have one of the values.
        ConnectError: if the gateware cannot be compiled on this machine.
    """
    from unity_link.virtual.rtl import RtlGateway
    from unity_link.virtual.rtl.specs import configuration_of_node, made

    return RtlGateway(made(configuration_of_node(info, node)))


def _build_of(wanted: Wanted) -> Configuration:
    """Return the requested build of the gateware: that of a spec, of a built-in robot, or of some fields."""
    from unity_link.virtual.rtl.configurations import choose, configurations

    if wanted.has_spec:
        return _build_of_spec(find_interface(wanted.robot, wanted.interface), wanted)
    own = configurations().get(wanted.robot)
    if own is not None and not wanted.configuration and wanted.node is None:
        return own
    return choose(wanted.configuration, wanted.node)


def _info(configuration: Mapping[str, int], default: GatewayInfo | None = None) -> GatewayInfo:
    values = dict(configuration)
    if values.get("crc_bits") in USUAL_POLYNOMIALS:
        values.setdefault("crc_polynomial", USUAL_POLYNOMIALS[values["crc_bits"]])
    if "features" in values:
        values["features"] = Feature(values["features"])
    info = msgspec.structs.replace(default or GatewayInfo(), **values)
    try:
        info.check()
    except UnsupportedError as error:
        raise ArgumentError(f"no such gateway can be built: {error}") from None
    return info

"""Unity-Link connects a program to an FPGA.

::

    import unity_link

    async with unity_link.connect("sim:scara") as link:
        print(await link.read(0x88))

With a spec, which declares the signals of the robot, the same by names and in units::

    Scara = unity_link.load("examples/scara.ul")

    async with unity_link.connect("sim:scara") as link:
        print(await Scara(link).j1.cpos.get())
"""

import importlib
import signal
import sys
from typing import TYPE_CHECKING, TypeVar, overload

# Let Ctrl-C end a command during its imports without a traceback; `unity_link.cli.main` restores the handler.
if sys.argv[0].endswith("unity-link") and signal.getsignal(signal.SIGINT) is signal.default_int_handler:
    signal.signal(signal.SIGINT, signal.SIG_DFL)

from unity_link.errors import (
    ArgumentError,
    BusError,
    BusTimeoutError,
    ConnectError,
    GatewayError,
    GatewayResetError,
    LateError,
    LinkClosedError,
    LinkLostError,
    NotArmedError,
    Outcome,
    OutOfRangeError,
    SamplesLostError,
    SpecMismatchError,
    UnansweredError,
    UnityLinkError,
    UnsupportedError,
)
from unity_link.link.connecting import connect
from unity_link.link.connection import Reconnect
from unity_link.link.link import Link, Statistics
from unity_link.link.publishing import Sample
from unity_link.link.subscription import Subscription
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.transport import register, register_stand_in

if TYPE_CHECKING:
    from pathlib import Path

    from unity_link import blocking as blocking
    from unity_link import data as data
    from unity_link.data.loading import LoadedRobot
    from unity_link.data.robot import Robot
    from unity_link.spec import Spec

    R = TypeVar("R", bound=Robot)

__version__ = "0.1.0"

register("sim", "unity_link.virtual.schemes")
register("rtl", "unity_link.virtual.schemes")
register_stand_in("virtual", "unity_link.virtual.ft232h.stand_in")

__all__ = [
    "ArgumentError",
    "BusError",
    "BusTimeoutError",
    "ConnectError",
    "Feature",
    "GatewayError",
    "GatewayInfo",
    "GatewayResetError",
    "LateError",
    "Link",
    "LinkClosedError",
    "LinkLostError",
    "NotArmedError",
    "OutOfRangeError",
    "Outcome",
    "Reconnect",
    "Sample",
    "SamplesLostError",
    "SpecMismatchError",
    "Statistics",
    "Subscription",
    "UnansweredError",
    "UnityLinkError",
    "UnsupportedError",
    "connect",
    "load",
    "robot",
]


def load(spec: "str | Path | Spec", interface: str | None = None) -> "type[LoadedRobot]":
    """Return the class of a robot: the public interface of a spec, with its signals as attributes.

    ``Scara(link)`` is the robot of a link. Parameters of the interface that have no value are given by name, as in
    ``Scara(link, ctrl=0xF0)``, or left out if they are not needed. `unity_link.data` describes the methods of a robot.

    Args:
        spec: path of a spec, or a compiled one.
        interface: name of the public interface, if the spec has several.

    Raises:
        SpecError: with all errors of the spec; the class is in `unity_link.spec`.
        ArgumentError: for an unknown interface.
    """
    from unity_link.data.loading import load as load_class

    return load_class(spec, interface)


@overload
async def robot(link: Link, spec: "str | Path | Spec | None" = None, /, **parameters: int | None) -> "LoadedRobot": ...
@overload
async def robot(link: Link, spec: "type[R]", /, **parameters: int | None) -> "R": ...
async def robot(
    link: Link, spec: "str | Path | Spec | type[Robot] | None" = None, /, **parameters: int | None
) -> "Robot":
    """Return the robot of a link, from the spec given, which is compared with the board's, or from the board's own.

    A gateway that was generated from a spec can carry a description of it, which is read in a few round trips. Without
    `spec`, the robot is made from this description; its cores have the core APIs of this package or of other installed
    packages. With `spec`, the board must have everything that the spec declares with the same properties: addresses,
    bits, types, scales, units, limits, groups, leases, cores. It may have more. The description is read only if the
    fingerprint of the gateway differs from that of the spec. A gateway without a description is checked only by its
    fingerprint, as by ``Scara(link)``.

    Args:
        link: an open link.
        spec: path of a spec, a compiled one, or the class of a robot, loaded or generated.
        parameters: values of the interface's parameters that have none, as for the class.

    Raises:
        SpecMismatchError: if the gateway was generated from another spec; it lists the differences.
        UnsupportedError: if the gateway's description is needed, but is missing or cannot be read.
        SpecError: if `load` raises it.
        ArgumentError: if `load` raises it, or for an unknown parameter.
        LinkLostError: if the link has ended.
    """
    from unity_link.data.describing import robot_behind

    return await robot_behind(link, spec, **parameters)


if not TYPE_CHECKING:  # A type checker would accept every name of the module.

    def __getattr__(name: str) -> object:
        """Import `unity_link.blocking` or `unity_link.data` at its first use."""
        if name in {"blocking", "data"}:
            return importlib.import_module(f"unity_link.{name}")
        raise AttributeError(f"module 'unity_link' has no attribute {name!r}")

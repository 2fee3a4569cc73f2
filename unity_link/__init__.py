"""Unity-Link connects a program to an FPGA.

::

    import unity_link

    async with unity_link.connect("sim:scara") as link:
        print(await link.read(0x88))

With a spec of what stands behind the gateway, the same by names and in units::

    Scara = unity_link.load("examples/scara.ul")

    async with unity_link.connect("sim:scara") as link:
        print(await Scara(link).j1.cpos.get())
"""

import importlib
import signal
import sys
from typing import TYPE_CHECKING, TypeVar, overload

# A command that is still being loaded ends at Ctrl-C without a traceback; `unity_link.cli.main` takes the signal back.
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

    ``Scara(link)`` is the robot behind a link. Parameters of the interface that have no value are given by name, as in
    ``Scara(link, ctrl=0xF0)``, or left out where they are not needed. `unity_link.data` says what a robot can do.

    Args:
        spec: path of a spec, or a compiled one.
        interface: which public interface, where there are several.

    Raises:
        SpecError: with everything that is wrong with the spec; the class is in `unity_link.spec`.
        ArgumentError: for an interface that there is not.
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
    """Return the robot behind a link: that of a spec, compared with the board's, or of the board's own.

    A gateway that was generated from a spec can carry its description: that spec, which is read in some round trips.
    Without a spec, nothing else has to be known of the board; cores have the verbs of the package, or of another that
    is installed. With one, the board is taken where all that the spec declares is there alike: addresses, bits, types,
    scales, units, limits, groups, leases, cores. It may have more. The description is read where the fingerprint of the
    gateway is not that of the spec; a gateway without a description is compared by its fingerprint alone, as by
    ``Scara(link)``.

    Args:
        link: open.
        spec: path of a spec, a compiled one, or the class of a robot, loaded or generated.
        parameters: those of the interface that have no value, as for the class.

    Raises:
        SpecMismatchError: where the gateway was generated from another spec; it says what differs.
        UnsupportedError: where the gateway's description is needed, and it carries none, or one that cannot be read.
        SpecError: as by `load`.
        ArgumentError: as by `load`, and for a parameter that there is not.
        LinkLostError: when the link has ended.
    """
    from unity_link.data.describing import robot_behind

    return await robot_behind(link, spec, **parameters)


if not TYPE_CHECKING:  # It would have every name be known to a type checker.

    def __getattr__(name: str) -> object:
        """Import `unity_link.blocking` and `unity_link.data` when they are first asked for."""
        if name in {"blocking", "data"}:
            return importlib.import_module(f"unity_link.{name}")
        raise AttributeError(f"module 'unity_link' has no attribute {name!r}")

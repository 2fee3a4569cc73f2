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
from typing import TYPE_CHECKING

# A command that is still being loaded ends at Ctrl-C without a traceback; `unity_link.cli.main` takes the signal back.
if sys.argv[0].endswith("unity-link") and signal.getsignal(signal.SIGINT) is signal.default_int_handler:
    signal.signal(signal.SIGINT, signal.SIG_DFL)

from unity_link.errors import (
    AnswerLostError,
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
    UnansweredError,
    UnityLinkError,
    UnsupportedError,
)
from unity_link.link.connecting import connect
from unity_link.link.connection import Reconnect
from unity_link.link.link import Link, Statistics
from unity_link.link.subscription import Sample, Subscription
from unity_link.protocol.configuration import Feature, GatewayInfo
from unity_link.transport import register, register_stand_in

if TYPE_CHECKING:
    from pathlib import Path

    from unity_link import blocking as blocking
    from unity_link import data as data
    from unity_link.data.loading import LoadedRobot
    from unity_link.spec import Spec

__version__ = "0.1.0"

register("sim", "unity_link.virtual.schemes")
register("rtl", "unity_link.virtual.schemes")
register_stand_in("virtual", "unity_link.virtual.ft232h.stand_in")

__all__ = [
    "AnswerLostError",
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


async def robot(link: Link) -> "LoadedRobot":
    """Return the robot behind a link to a gateway that carries its description: nothing else has to be known of it.

    The description is the spec that the gateway was generated from, and is read in some round trips. Cores have the
    verbs of the package, or of another that is installed.

    Args:
        link: open.

    Raises:
        UnsupportedError: where the gateway carries no description, or one that cannot be read here.
        LinkLostError: when the link has ended.
    """
    from unity_link.data.describing import robot_behind

    return await robot_behind(link)


if not TYPE_CHECKING:  # It would have every name be known to a type checker.

    def __getattr__(name: str) -> object:
        """Import `unity_link.blocking` and `unity_link.data` when they are first asked for."""
        if name in {"blocking", "data"}:
            return importlib.import_module(f"unity_link.{name}")
        raise AttributeError(f"module 'unity_link' has no attribute {name!r}")

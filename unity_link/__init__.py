"""Unity-Link connects a program to an FPGA.

::

    import unity_link

    async with unity_link.connect("sim:scara") as link:
        print(await link.read(0x88))
"""

from unity_link.connection import Reconnect
from unity_link.errors import (
    AnswerLostError,
    ArgumentError,
    BusError,
    BusTimeoutError,
    ConnectError,
    GatewayError,
    LinkClosedError,
    LinkLostError,
    Outcome,
    OutOfRangeError,
    SamplesLostError,
    UnansweredError,
    UnityLinkError,
    UnsupportedError,
)
from unity_link.link import Link, Statistics, connect
from unity_link.subscription import Sample, Subscription
from unity_link.wire.gateway_info import Feature, GatewayInfo

__version__ = "0.1.0"

__all__ = [
    "AnswerLostError",
    "ArgumentError",
    "BusError",
    "BusTimeoutError",
    "ConnectError",
    "Feature",
    "GatewayError",
    "GatewayInfo",
    "Link",
    "LinkClosedError",
    "LinkLostError",
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
]

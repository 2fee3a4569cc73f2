"""The network and the domain that DDS is to use.

DDS speaks to the whole network by itself. Here it speaks to programs of this machine alone, unless it is asked for, by
the settings, by ROS's ROS_AUTOMATIC_DISCOVERY_RANGE, or by a configuration of CycloneDDS in CYCLONEDDS_URI.
"""

from __future__ import annotations

import contextlib
import os
import re
import socket
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from unity_link.errors import ArgumentError, ConnectError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from unity_link.bridges.ros_settings import BridgeSettings

TYPES = """<CycloneDDS><Domain>
  <Compatibility><IgnoreTypeInformation>1.15</IgnoreTypeInformation></Compatibility>
</Domain></CycloneDDS>"""
"""A configuration of CycloneDDS (its guide, "Configuration") that ignores the type objects of Fast DDS, vendor 1.15.

CycloneDDS 11.0.1 rejects those that Fast DDS 3 of ROS 2 Kilted sends for types with sequences, and matches no endpoint.
"""
LOOPBACK = """<CycloneDDS><Domain>
  <General>
    <Interfaces><NetworkInterface name="lo"/></Interfaces>
    <AllowMulticast>false</AllowMulticast>
  </General>
  <Discovery>
    <ParticipantIndex>auto</ParticipantIndex>
    <MaxAutoParticipantIndex>100</MaxAutoParticipantIndex>
    <Peers><Peer address="127.0.0.1"/></Peers>
  </Discovery>
</Domain></CycloneDDS>"""
"""A configuration as ROS 2's LOCALHOST range has it."""
HIGHEST_DOMAIN = 232
_FIRST_PORT, _PORTS = 7400, 250
"""First UDP port of domain 0, and ports of each domain (DDS-RTPS 9.6.1.1)."""


def find_dds() -> None:
    """See that CycloneDDS is installed.

    Raises:
        ConnectError: if it is not installed.
    """
    try:
        import cyclonedds  # noqa: F401  (it is to be there, no more)
    except ImportError:
        raise ConnectError("CycloneDDS is not installed here: pip install 'unity-link[ros2]'") from None


def open_participant(settings: BridgeSettings, mark: str = "") -> tuple[Any, Any]:
    """Join the domain; return the participant, and the domain, which ends with its last reference.

    Args:
        settings: the domain, and whether other machines can join.
        mark: USER_DATA of the participant, which all others receive, in the form of ROS 2: ``name=value;``.

    Raises:
        ArgumentError: for a domain that does not exist.
        ConnectError: if CycloneDDS cannot open its ports.
    """
    from cyclonedds.core import DDSException, Policy, Qos
    from cyclonedds.domain import Domain, DomainParticipant

    number = domain_number(settings)
    reach = os.environ.get("ROS_AUTOMATIC_DISCOVERY_RANGE", "")
    own = os.environ.get("CYCLONEDDS_URI", "")
    open_to_all = settings.network or reach.upper() == "SUBNET" or bool(own)
    # Later configurations go before earlier ones.
    configurations = [TYPES, own if open_to_all else LOOPBACK]
    try:
        domain = Domain(number, ",".join(filter(None, configurations)))
        participant = DomainParticipant(number, qos=Qos(Policy.Userdata(mark.encode())))
    except DDSException as error:
        raise ConnectError(f"DDS domain {number} cannot be joined: {error}") from None
    if not open_to_all and sys.platform == "linux":
        _hear_this_machine_alone(number)
    return participant, domain


def _hear_this_machine_alone(domain: int) -> None:
    """Bind the ports of a domain to the loopback device: CycloneDDS opens them at all addresses, however configured."""
    first = _FIRST_PORT + _PORTS * domain
    for one in _own_sockets():
        if (one.family, one.type) == (socket.AF_INET, socket.SOCK_DGRAM):
            host, port = one.getsockname()
            if host == "0.0.0.0" and first <= port < first + _PORTS:  # noqa: S104  (the address that is replaced)
                # Before Linux 5.7 only root may.
                with contextlib.suppress(PermissionError):
                    one.setsockopt(socket.SOL_SOCKET, socket.SO_BINDTODEVICE, b"lo")


def _own_sockets() -> Iterator[socket.socket]:
    """Return the sockets that this process has, each only for a moment (proc(5))."""
    for file in Path("/proc/self/fd").iterdir():
        # Some are closed meanwhile.
        with contextlib.suppress(OSError):
            if str(file.readlink()).startswith("socket:"):
                with socket.socket(fileno=os.dup(int(file.name))) as one:
                    yield one


def finder(participant: Any, mark: str) -> Callable[[], bool]:
    """Return what returns whether another participant with the same mark was found since the call before."""
    from cyclonedds.builtin import BuiltinDataReader, BuiltinTopicDcpsParticipant
    from cyclonedds.core import Policy

    reader, own = BuiltinDataReader(participant, BuiltinTopicDcpsParticipant), Policy.Userdata(mark.encode())
    return lambda: any(
        own in (getattr(other, "qos", None) or ()) and other.key != participant.guid for other in reader.take(N=100)
    )


def domain_number(settings: BridgeSettings) -> int:
    """Return the DDS domain that the settings or ROS_DOMAIN_ID choose.

    Raises:
        ArgumentError: for a domain that there is not.
    """
    text = os.environ.get("ROS_DOMAIN_ID") or "0" if settings.domain is None else str(settings.domain)
    # As rcl reads it, by strtoul with base 0: 010 is 8.
    octal = re.fullmatch("0[0-7]+", text) is not None
    try:
        number = int(text, 8 if octal else 0)
    except ValueError:
        number = -1
    if not 0 <= number <= HIGHEST_DOMAIN:
        raise ArgumentError(f"DDS domain {text}: a number from 0 to {HIGHEST_DOMAIN} was expected")
    return number

"""Which network and which domain DDS is to use.

DDS speaks to the whole network by itself. Here it speaks to programs of this machine alone, unless it is asked for, by
the settings, by ROS's ROS_AUTOMATIC_DISCOVERY_RANGE, or by a configuration of CycloneDDS in CYCLONEDDS_URI.
"""

from __future__ import annotations

import os
import time
from typing import TYPE_CHECKING, Any

from unity_link.errors import ArgumentError, ConnectError

if TYPE_CHECKING:
    from unity_link.bridges.ros2.settings import Settings

LOOPBACK = """
<CycloneDDS><Domain>
  <General>
    <Interfaces><NetworkInterface name="lo"/></Interfaces>
    <AllowMulticast>false</AllowMulticast>
  </General>
  <Discovery>
    <ParticipantIndex>auto</ParticipantIndex>
    <MaxAutoParticipantIndex>100</MaxAutoParticipantIndex>
    <Peers><Peer address="127.0.0.1"/></Peers>
  </Discovery>
</Domain></CycloneDDS>
"""
"""A configuration of CycloneDDS (its guide, "Configuration") as ROS 2's LOCALHOST range has it."""
HIGHEST_DOMAIN = 232


LOOK = 1.0
"""Seconds in which another bridge of the same namespace shows itself."""


def open_participant(settings: Settings, mark: str = "") -> tuple[Any, Any]:
    """Join the domain; give the participant, and the domain, which ends with its last reference.

    Args:
        settings: which domain, and who is to be spoken to.
        mark: what the participant tells of itself to all others (its USER_DATA), as ROS 2 writes it: ``name=value;``.

    Raises:
        ArgumentError: for a domain that there is not.
        ConnectError: where CycloneDDS cannot open its ports.
    """
    from cyclonedds.core import DDSException, Policy, Qos
    from cyclonedds.domain import Domain, DomainParticipant

    number = _domain(settings)
    reach = os.environ.get("ROS_AUTOMATIC_DISCOVERY_RANGE", "")
    open_to_all = settings.network or reach.upper() == "SUBNET" or "CYCLONEDDS_URI" in os.environ
    try:
        domain = None if open_to_all else Domain(number, LOOPBACK)
        participant = DomainParticipant(number, qos=Qos(Policy.Userdata(mark.encode())))
    except DDSException as error:
        raise ConnectError(f"DDS domain {number} cannot be joined: {error}") from None
    return participant, domain


def is_alone(participant: Any, mark: str) -> bool:
    """Say whether no other participant has the same mark. Blocks for `LOOK` seconds, unless there is one."""
    from cyclonedds.builtin import BuiltinDataReader, BuiltinTopicDcpsParticipant
    from cyclonedds.core import Policy

    reader = BuiltinDataReader(participant, BuiltinTopicDcpsParticipant)
    until = time.monotonic() + LOOK
    while time.monotonic() < until:
        for other in reader.take(N=100):
            marked = Policy.Userdata(mark.encode()) in (getattr(other, "qos", None) or ())
            if marked and other.key != participant.guid:
                return False
        time.sleep(LOOK / 50)
    return True


def _domain(settings: Settings) -> int:
    text = os.environ.get("ROS_DOMAIN_ID") or "0" if settings.domain is None else str(settings.domain)
    if not text.isdigit() or int(text) > HIGHEST_DOMAIN:
        raise ArgumentError(f"DDS domain {text}: a number from 0 to {HIGHEST_DOMAIN} was expected")
    return int(text)

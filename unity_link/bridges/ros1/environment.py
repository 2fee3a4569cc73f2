"""The environment of the node: the path of rospy, which distributions install for their own Python, and its address."""

from __future__ import annotations

import importlib.util
import os
import sys
from pathlib import Path
from urllib.parse import urlsplit

from unity_link.errors import ArgumentError, ConnectError
from unity_link.transport.listening import LOOPBACK

_PLACE = "/usr/lib/python3/dist-packages"


def find_rospy() -> None:
    """Make rospy importable.

    Raises:
        ConnectError: if rospy is not installed.
    """
    if importlib.util.find_spec("rospy") is None and Path(_PLACE, "rospy").is_dir():
        # At the end, so that the packages of this environment keep precedence.
        sys.path.append(_PLACE)
    elif importlib.util.find_spec("rospy") is None:
        raise ConnectError(
            "ROS 1 is not installed here: apt install python3-rospy python3-std-msgs python3-sensor-msgs (Debian), "
            "or source the set-up file of your ROS"
        )


def choose_address() -> None:
    """Restrict the node to this machine, unless ROS's own settings name an address: ROS_IP, ROS_HOSTNAME, ``__ip:=``.

    Raises:
        ArgumentError: if ROS_MASTER_URI names no master, or one on another machine, whose nodes could not reach this
            node.
    """
    from rosgraph import get_master_uri, network

    uri = get_master_uri()
    host = urlsplit(uri).hostname
    if host is None:
        raise ArgumentError(f"ROS_MASTER_URI={uri} names no master: one like http://localhost:11311 was expected")
    if network.get_address_override():
        return
    if not network.is_local_address(host):
        raise ArgumentError(
            f"the ROS master at {uri} is not on this machine: set ROS_IP to the address by which others reach this one"
        )
    os.environ["ROS_IP"] = LOOPBACK

"""Where rospy is: distributions install it for their own Python, not into an environment of ours."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

from unity_link.errors import ConnectError

_PLACES = ("/usr/lib/python3/dist-packages",)


def find_rospy() -> None:
    """Make rospy importable.

    Raises:
        ConnectError: where it is not installed.
    """
    for place in (None, *_PLACES):
        if place is not None and Path(place, "rospy").is_dir() and place not in sys.path:
            # At the end, so that our own packages stay what they are.
            sys.path.append(place)
        if importlib.util.find_spec("rospy") is not None:
            return
    raise ConnectError(
        "ROS 1 is not installed here: apt install python3-rospy python3-std-msgs python3-sensor-msgs (Debian), "
        "or source the set-up file of your ROS"
    )

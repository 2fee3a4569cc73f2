"""The bridge as a program of a ROS package; `unity-link generate ros1` writes one."""

from __future__ import annotations

import argparse
import asyncio
import sys
from typing import TYPE_CHECKING

from unity_link.bridges.ros1.environment import find_rospy
from unity_link.bridges.ros1.node import Ros1Bridge
from unity_link.bridges.waiting import connect_when_there
from unity_link.errors import UnityLinkError

if TYPE_CHECKING:
    from unity_link.data import Robot


def main(robot: type[Robot]) -> None:
    """Be the bridge of a robot, as the command line says; roslaunch's own words are left out."""
    try:
        find_rospy()
        asyncio.run(_run(robot, _options(robot.__doc__ or "")))
    except UnityLinkError as error:
        sys.exit(f"error: {error}")
    except KeyboardInterrupt:
        pass


def _options(description: str) -> argparse.Namespace:
    import rospy

    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--link", required=True, metavar="URL", help="where the gateway is, such as sim:scara")
    parser.add_argument("--namespace", help="before all topics; the interface's name without")
    parser.add_argument("--poll", type=float, metavar="HZ", help="also publish what nothing samples, read so often")
    parser.add_argument("--frame-id", default="", metavar="NAME", help="of the states of joints")
    return parser.parse_args(rospy.myargv()[1:])


async def _run(robot: type[Robot], options: argparse.Namespace) -> None:
    async with connect_when_there(options.link, _tell) as link:
        bridge = Ros1Bridge(
            robot(link),
            namespace=options.namespace,
            poll_hz=options.poll,
            frame_id=options.frame_id,
            report=_tell,
        )
        await bridge.run()


def _tell(text: str) -> None:
    print(text, file=sys.stderr, flush=True)  # noqa: T201  (roslaunch shows it)

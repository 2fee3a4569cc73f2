"""The bridge as a program of a ROS package; `unity-link generate ros1` writes one."""

from __future__ import annotations

import argparse
import asyncio
import sys
from typing import TYPE_CHECKING

from unity_link.bridges.ros1.environment import find_rospy
from unity_link.bridges.ros1.node import Ros1Bridge
from unity_link.bridges.waiting import connect_when_there
from unity_link.errors import ArgumentError, UnityLinkError

if TYPE_CHECKING:
    from unity_link.data import Robot


def main(robot: type[Robot]) -> None:
    """Be the bridge of a robot, as the command line says; roslaunch's own words are left out."""
    try:
        find_rospy()
        asyncio.run(_run(robot, _options(robot)))
    except UnityLinkError as error:
        sys.exit(f"error: {error}")
    except KeyboardInterrupt:
        pass


def _options(robot: type[Robot]) -> argparse.Namespace:
    import rospy

    parser = argparse.ArgumentParser(description=robot.__doc__)
    parser.add_argument("--link", required=True, metavar="URL", help="where the gateway is, such as sim:scara")
    parser.add_argument("--namespace", help="before all topics; the interface's name without")
    parser.add_argument("--poll", type=float, metavar="HZ", help="also publish what nothing samples, read so often")
    parameters = parser.add_argument_group("parameters of the interface", "addresses; empty where one is not needed")
    for name in robot.interface.open_parameters:
        parameters.add_argument(f"--give-{name}", metavar="ADDRESS", default="")
    options = parser.parse_args(rospy.myargv()[1:])
    options.given = {
        name: _address(name, text)
        for name in robot.interface.open_parameters
        if (text := vars(options)[f"give_{name}"])
    }
    return options


def _address(name: str, text: str) -> int:
    try:
        return int(text, 0)
    except ValueError:
        raise ArgumentError(f"{name} {text!r}: an address such as 0xF0 was expected") from None


async def _run(robot: type[Robot], options: argparse.Namespace) -> None:
    robot.interface.check_given(options.given)
    async with connect_when_there(options.link, _tell) as link:
        opened = robot(link, **options.given)
        bridge = Ros1Bridge(opened, namespace=options.namespace, poll_hz=options.poll, report=_tell)
        await bridge.run()


def _tell(text: str) -> None:
    print(text, file=sys.stderr, flush=True)  # noqa: T201  (roslaunch shows it)

"""`unity-link ros1`, `ros2`: a robot as a node of ROS."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from unity_link.cli.output import print_note
from unity_link.cli.running import run
from unity_link.cli.spec import Name, SpecFile, compile_or_exit
from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    from unity_link.spec import Spec

LinkUrl = Annotated[
    str, typer.Option("--link", metavar="URL", help="Where the gateway is, such as sim:scara.", show_default=False)
]
Namespace = Annotated[
    str | None, typer.Option("--namespace", metavar="NAME", help="Before all topics; the interface's name without.")
]
Poll = Annotated[
    float | None,
    typer.Option("--poll", metavar="HZ", help="Also publish what nothing samples, by reading it so often."),
]


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(ros1)


def ros1(
    spec: SpecFile, *, link: LinkUrl, namespace: Namespace = None, poll: Poll = None, interface: Name = None
) -> None:
    """Be a node of ROS 1: signals that are sampled are topics, signals that can be written are subscribed to.

    Needs rospy of the distribution; ROS_MASTER_URI says where the master is. Master and gateway may come and go.
    """
    if poll is not None and not poll > 0:
        raise ArgumentError(f"--poll {poll:g}: more than 0 Hz was expected")
    run(_ros1(compile_or_exit(spec), interface, link, namespace, poll))


async def _ros1(spec: Spec, interface: str | None, url: str, namespace: str | None, poll: float | None) -> None:
    from unity_link.bridges.ros1 import Ros1Bridge
    from unity_link.data import load
    from unity_link.link import connect

    robot_type = load(spec, interface)
    async with connect(url, reconnect=True) as link:
        bridge = Ros1Bridge(robot_type(link), namespace=namespace, poll_hz=poll, report=print_note)
        try:
            await bridge.run()
        finally:
            print_note(
                f"{bridge.published:,} samples published, {bridge.lost:,} lost, {bridge.written:,} values written"
            )
